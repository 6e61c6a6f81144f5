"""The validation campaign of interface waves, some rows of it on few cells: it runs, and its rates are found."""

import json
import re
import subprocess
import unittest
from pathlib import Path

from harness import EndToEndTest

ROOT = Path(__file__).resolve().parents[2]


def coarsened(rows):
    """The committed campaign with these rows only, on 16 and 32 cells a wave."""
    document = json.loads((ROOT / "runs" / "validation" / "interface-waves" / "campaign.json").read_text())
    waves = document["sweep"]["list"][:rows]
    document["sweep"] = {"list": [wave | {"nx": n, "ny_fluid": n, "ny_solid": n // 2} for wave in waves for n in (16, 32)]}
    document["run"] = {"end_time": 4.5, "checkpoint_steps": 50}
    document["execution"] = {"ranks": 2}
    return document


class InterfaceWave(EndToEndTest):
    def test_its_rates_are_those_of_linear_theory(self):
        campaign = self.campaign(coarsened(2))
        self.run_to_end(campaign)
        self.assert_sound(campaign)
        picture = campaign.folder / "figure.png"
        drawn = subprocess.run(
            ["/usr/bin/python3", ROOT / "analysis" / "plot_interface_waves.py", campaign.folder, "-o", picture],
            capture_output=True, text=True, check=False)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        frequencies = [float(value) for value in re.findall(r"^  frequency, 32 cells a wave +(\S+)", drawn.stdout, re.M)]
        self.assertEqual(len(frequencies), 2, drawn.stdout)
        self.assertLess(max(frequencies), 0.02, drawn.stdout)
        table = campaign.call("table").stdout
        self.assertIn("not a channel flow: its series are in statistics.h5", " ".join(table.split()))
        self.assertNotIn("READING", table)

    def test_the_spectrum_of_its_interface_peaks_at_its_frequency(self):
        document = coarsened(1)
        document["sweep"]["list"] = document["sweep"]["list"][:1]
        document["run"] = {"end_time": 20}
        campaign = self.campaign(document)
        self.run_to_end(campaign)
        program = ("import sys, h5py, numpy as np; sys.path.insert(0, sys.argv[1]); import wave_spectrum\n"
                   "waves = h5py.File(sys.argv[2])['interface_waves']; t = waves['time'][:]\n"
                   "w, E = wave_spectrum.space_time_spectrum(t, waves['real'][:] + 1j * waves['imaginary'][:], t[0], t[-1] - t[0])\n"
                   "print(w[1] - w[0], *sorted(w[np.argsort(E[:, 0])[-2:]]), E[:, 1:].max() / E[:, 0].max())")
        (file,) = campaign.folder.glob("cases/*/spectra.h5")
        found = subprocess.run(["/usr/bin/python3", "-c", program, ROOT / "analysis", file], capture_output=True, text=True,
                               check=False)
        self.assertEqual(found.returncode, 0, found.stderr)
        width, upstream, downstream, others = map(float, found.stdout.split())
        exact = document["sweep"]["list"][0]["frequency"]
        self.assertLess(abs(downstream - exact), width)  # a standing wave is one of each
        self.assertLess(abs(upstream + exact), width)
        self.assertLess(others, 1e-3)

    def test_a_rate_of_other_layers_is_refused_before_anything_runs(self):
        document = coarsened(1)
        document["physics"]["solid"] = {"G": 2}
        for wave in document["sweep"]["list"]:
            del wave["G"]
        campaign = self.campaign(document)
        refused = campaign.call("run")
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("not the rate of a wave of these layers", refused.stderr)
        self.assertIn("the nearest one found: decay", refused.stderr)
        self.assertEqual(list(campaign.folder.glob("cases/*")), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
