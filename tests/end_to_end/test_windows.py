"""The averaging window is chosen when results are made: another one costs no simulation."""

import csv
import io
import json
import unittest

from harness import EndToEndTest, changed
from test_real_use import RIGID

LONG = changed(RIGID, run={"end_time": 2, "checkpoint_steps": 5})


def with_window(start, block_length=0.25):
    statistics = {"start_time": start, "block_length": block_length, "interval_steps": 1}
    return changed(LONG, physics=dict(RIGID["physics"], statistics=statistics))


class Windows(EndToEndTest):
    def window(self, campaign):
        (row,) = campaign.query("SELECT case_id, window_start, window_end, blocks, re_tau, attempts FROM results")
        return row

    def test_another_start_costs_nothing(self):
        campaign = self.campaign(with_window(0.5))
        self.run_to_end(campaign)
        first = self.window(campaign)
        self.assertEqual((first["window_start"], first["blocks"]), (0.5, 6))
        for start, blocks in ((1.25, 3), (0.25, 7), (0.5, 6)):
            campaign.write(with_window(start))
            plan = campaign.call("plan")
            self.assertIn(" kept ", plan.stdout)
            self.assertNotIn("Left behind", plan.stdout)
            self.run_to_end(campaign)
            now = self.window(campaign)
            self.assertEqual((now["window_start"], now["blocks"]), (start, blocks))
            self.assertEqual((now["case_id"], now["attempts"]), (first["case_id"], 1))
        self.assertEqual(self.window(campaign), first)

    def test_longer_blocks_are_made_of_those_there_are(self):
        campaign = self.campaign(with_window(0.5, 0.25))
        self.run_to_end(campaign)
        campaign.write(with_window(0.5, 0.5))
        self.assertIn(" kept ", campaign.call("plan").stdout)
        campaign.write(with_window(0.5, 0.125))
        self.assertIn(" start ", campaign.call("plan").stdout)

    def test_a_window_can_be_looked_at_without_being_kept(self):
        campaign = self.campaign(with_window(0.5))
        self.run_to_end(campaign)
        before = self.window(campaign)
        answer = campaign.call("query", "SELECT window_start, re_tau FROM results", "--json", "--from", "1.5")
        (looked_at,) = json.loads(answer.stdout)
        self.assertEqual(looked_at["window_start"], 1.5)
        self.assertNotEqual(looked_at["re_tau"], before["re_tau"])
        (exported,) = csv.DictReader(io.StringIO(campaign.call("export", "--csv", "--from", "1.5").stdout))
        self.assertEqual(float(exported["re_tau"]), looked_at["re_tau"])
        self.assertIn("mean over t = 1.5 to 2 of 2", campaign.call("table", "--from", "1.5").stdout)
        self.assertEqual(self.window(campaign), before)
        campaign.write(with_window(1.5))
        self.run_to_end(campaign)
        self.assertEqual(self.window(campaign)["re_tau"], looked_at["re_tau"])
        beyond = campaign.call("table", "--from", "7")
        self.assertEqual(beyond.returncode, 0)
        self.assertIn("No result from t = 7: rigid_channel", beyond.stderr)
        for wrong in ("nan", "-1", "soon"):
            self.assertEqual(campaign.call("table", "--from", wrong).returncode, 2, wrong)

    def test_a_case_of_an_earlier_version_goes_on(self):
        """Its id and its blocks begin with the averages that were wanted then."""
        campaign = self.campaign(with_window(0.5))
        self.run_to_end(campaign)
        (new,) = campaign.folder.glob("cases/*")
        definition = json.loads((new / "case.json").read_text())
        self.assertEqual(definition["physics"]["statistics"]["start_time"], 0)
        # What 0.1.0 named cases/rigid_channel-EARLIER: the same case with the window in its case.json.
        definition["physics"]["statistics"]["start_time"] = 0.5
        other = self.campaign(with_window(0.5))
        earlier = other.folder / "cases" / ("rigid_channel-" + EARLIER_ID[:8])
        earlier.mkdir(parents=True)
        (earlier / "case.json").write_text(json.dumps(definition))
        for start, window_start in ((0.5, 0.5), (1, 1), (0.25, 0.5)):
            other.write(with_window(start))
            self.run_to_end(other)
            row = self.window(other)
            self.assertEqual((row["case_id"], row["window_start"], row["attempts"]), (EARLIER_ID, window_start, 1))
        (note,) = other.query("SELECT note FROM results")
        self.assertIn("averages were asked for from t = 0.25, blocks were kept from 0.5", note["note"])
        self.assertEqual(len(list(other.folder.glob("cases/*"))), 1)


# Of the case above as version 0.1.0 computed it.
EARLIER_ID = "bd1e6b8aac7a628d"

if __name__ == "__main__":
    unittest.main()
