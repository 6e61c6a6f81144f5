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
