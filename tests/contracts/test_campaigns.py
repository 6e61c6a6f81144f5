"""Every committed campaign is accepted, and holds the cases that its folder promises."""

import json
import re
import tempfile
import unittest
from pathlib import Path

from repository import ROOT, committed_files, run_softwall, text_of

PAPER = {(4, 1), (2, 1), (1, 1), (0.5, 1), (1, 0.1), (1, 10)}  # (G, viscosity ratio) of tables 1 and 2


VALIDATION = {"zalesak": 6, "cavity": 3, "cavity-disc": 3, "rigid-channel": 2, "channel-box": 4, "stiff-layer": 2, "interface-study": 28,
              "elastic-layer": 5, "grid-refinement": 7, "interface-waves": 64, "interface-drift": 18,
              "growth-rates": 36, "paper-scheme": 6, "formulations": 15}  # cases of each folder in runs/validation


# Of the two campaigns of the paper's tables: seven are its tables' (a rigid channel, four moduli, two viscosity ratios).
CASES = {"runs/quickstart": 6, "runs/rosti-brandt-2017/paper-grid": 7, "runs/rosti-brandt-2017/coarse": 7,
         "runs/rosti-brandt-2017/workstation": 30}


def campaigns():
    """Those of the paper's walls."""
    return [path for path in all_campaigns() if path.parts[1] != "validation"]


def all_campaigns():
    return [path for path in committed_files() if path.parts[0] == "runs" and path.name == "campaign.json"]


class Campaigns(unittest.TestCase):
    def test_the_promised_ones_are_there(self):
        folders = {str(path.parent) for path in campaigns()}
        self.assertEqual(CASES.keys(), folders)

    def test_softwall_plans_the_papers_cases(self):
        for path in campaigns():
            with self.subTest(str(path)):
                cases = json.loads(run_softwall("plan", ROOT / path, "--json"))["cases"]
                self.assertEqual(len(cases), CASES[str(path.parent)])
                self.assertEqual(len({case["case_id"] for case in cases}), len(cases))
                self.assertTrue(all(case["steps"] >= 0 for case in cases))

    def test_softwall_plans_the_validation(self):
        planned = {}
        for path in all_campaigns():
            if path.parts[1] == "validation":
                cases = json.loads(run_softwall("plan", ROOT / path, "--json"))["cases"]
                planned[path.parts[2]] = len({case["case_id"] for case in cases})
        self.assertEqual(planned, VALIDATION)

    def test_softwall_accepts_the_examples_in_the_documents(self):
        for document, count in (("README.md", 1 + 4 * 3 - 1), ("runs/TUTORIAL.md", 1 + 3)):
            example = re.search(r"^```json\n(.*?)^```", text_of(document), re.MULTILINE | re.DOTALL).group(1)
            with self.subTest(document), tempfile.TemporaryDirectory() as folder:
                (Path(folder) / "campaign.json").write_text(example, encoding="utf-8")
                cases = json.loads(run_softwall("plan", folder, "--json"))["cases"]
                self.assertEqual(len(cases), count)

    def test_they_sweep_over_the_papers_walls(self):
        for path in campaigns():
            sweep = json.loads((ROOT / path).read_text(encoding="utf-8"))["sweep"]
            if "grid" not in sweep:
                continue
            walls = {(G, 1) for G in sweep["grid"]["G"]}
            walls |= {(case["G"], case["viscosity_ratio"]) for case in sweep["list"]}
            with self.subTest(str(path)):
                self.assertEqual(walls, PAPER)

    def test_the_workstation_has_every_wall_on_each_grid(self):
        path = ROOT / "runs/rosti-brandt-2017/workstation/campaign.json"
        walls = {}
        for case in json.loads(path.read_text(encoding="utf-8"))["sweep"]["list"]:
            walls.setdefault(case["nx"], []).append((case["G"], case["viscosity_ratio"]))
        self.assertEqual(sorted(walls), [64, 96, 144])
        self.assertEqual(walls[96], walls[144])
        self.assertLessEqual({(G, 1) for G in (2, 1, 0.5, 0.25, 0.125)}, set(walls[96]))


if __name__ == "__main__":
    unittest.main()
