"""The validation campaigns in closed boxes, on few cells: each runs to its end under softwall and becomes a picture."""

import json
import subprocess
import unittest
from pathlib import Path

from harness import EndToEndTest

ROOT = Path(__file__).resolve().parents[2]


def coarsened(name, cells, end_time, field_interval):
    """A committed campaign as one case on cells x cells."""
    document = json.loads((ROOT / "runs" / "validation" / name / "campaign.json").read_text())
    document["physics"]["grid"].update(nx=cells, ny_fluid=cells)
    document["run"] = {"end_time": end_time, "field_interval": field_interval}
    document["execution"] = {"ranks": 2}
    del document["sweep"]
    return document


class ClosedBox(EndToEndTest):
    def run_and_draw(self, document, script):
        campaign = self.campaign(document)
        self.run_to_end(campaign)
        self.assert_sound(campaign)
        picture = campaign.folder / "figure.png"
        drawn = subprocess.run(
            ["/usr/bin/python3", ROOT / "analysis" / script, campaign.folder, "-o", picture],
            capture_output=True, text=True, check=False)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        (summary,) = campaign.folder.glob("cases/*/summary.json")
        return json.loads(summary.read_text())["diagnostics"], drawn.stdout

    def test_a_lid_drives_the_fluid(self):
        diagnostics, said = self.run_and_draw(coarsened("cavity", 32, 40, 20), "plot_cavity.py")
        self.assertLess(diagnostics["max_divergence"], 1e-12)
        self.assertIn("holds", said, "even 32 cells a side come close to Ghia's table")

    def test_a_lid_stretches_a_disc(self):
        diagnostics, said = self.run_and_draw(coarsened("cavity-disc", 32, 8, 1.1717), "plot_cavity_disc.py")
        self.assertLess(abs(diagnostics["solid_fraction_drift"]), 1e-12)
        self.assertGreater(diagnostics["min_eigenvalue_B"], 0)
        self.assertIn("32", said)

    def test_a_rotation_carries_a_disc(self):
        diagnostics, said = self.run_and_draw(coarsened("zalesak", 40, 1, 1), "plot_zalesak.py")
        self.assertLess(abs(diagnostics["solid_fraction_drift"]), 1e-12)
        self.assertIn("40 cells a side", said)


if __name__ == "__main__":
    unittest.main(verbosity=2)
