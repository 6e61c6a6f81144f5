"""Cases that end before their end time, because their intervals are small enough; and those that go on after all."""

import json
import unittest

from harness import CAMPAIGN, EndToEndTest, changed

# It would take minutes to its end. Of so short and coarse a flow only the place of the maximum, which jumps from cell to
# cell, has an interval within seconds; a wide one is enough here.
FAR = dict(CAMPAIGN["run"], end_time=400)
PHYSICS = dict(CAMPAIGN["physics"], time_step={"fixed_dt": 0.004}, statistics={"interval_steps": 1, "block_length": 0.5})
PRECISE = changed(CAMPAIGN, physics=PHYSICS, run=FAR, sweep={"list": [{"G": 2}]}, until={"y_max_ci95": 2})
EARLY = "finished early: y_max within 2"


class Until(EndToEndTest):
    def assert_finished_early(self, campaign):
        cases = json.loads(campaign.call("status", "--json").stdout)["cases"]
        for case in cases[1:]:
            self.assertEqual((case["state"], case["reason"]), ("finished", EARLY))
            self.assertLess(case["time"], FAR["end_time"])
            self.assertGreater(case["time"], 4, "eight blocks are needed for an interval")
        self.assertIn(EARLY, campaign.call("status").stdout)
        plan = campaign.call("plan").stdout
        self.assertEqual(plan.count(EARLY), 1, plan)
        self.assertIn("about 0 core-hours to do", plan)
        (row,) = campaign.query("SELECT state, y_max_ci95, window_end FROM results WHERE G = 2")
        self.assertEqual(row["state"], "finished")
        self.assertLessEqual(row["y_max_ci95"], 2)
        self.assertAlmostEqual(row["window_end"], cases[1]["time"], delta=0.01)

    def test_a_case_ends_when_it_is_precise_enough(self):
        campaign = self.campaign(PRECISE)
        self.assertIn("A case ends before its end time once it has y_max within 2;", campaign.call("plan").stdout)
        answer = self.run_to_end(campaign)
        self.assertIn("G=2: " + EARLY, answer.stderr)
        self.assertIn("2 of 2 cases finished", answer.stderr)
        self.assert_finished_early(campaign)
        self.assert_sound(campaign)

        with self.subTest("and is kept"):
            attempts = "SELECT case_id, attempt, ended FROM attempts"
            before = campaign.results(), campaign.final_data(), campaign.query(attempts)
            self.run_to_end(campaign, "resume")
            self.assertEqual((campaign.results(), campaign.final_data(), campaign.query(attempts)), before)

        with self.subTest("and is known to a store made again"):
            rows = "SELECT case_id, state, state_reason FROM cases ORDER BY case_id"
            states = campaign.query(rows)
            self.assertEqual(campaign.call("rebuild").returncode, 0)
            self.assertEqual(campaign.query(rows), states)
            self.assert_finished_early(campaign)
            self.assert_sound(campaign)

        with self.subTest("and goes on from its checkpoint for a smaller interval"):
            furthest = max(case["time"] for case in json.loads(campaign.call("status", "--json").stdout)["cases"])
            campaign.write(changed(PRECISE, until={"y_max_ci95": 1e-9}, run=dict(FAR, end_time=furthest + 1)))
            self.assertEqual(campaign.states(), {"precursor": "finished", "G=2": "interrupted"})
            self.assertEqual(campaign.call("plan").stdout.count(" resume "), 1)
            self.run_to_end(campaign, "resume")
            last = campaign.query("SELECT outcome, resumed_from FROM attempt_history WHERE label = 'G=2'")[-1]
            self.assertEqual(last["outcome"], "finished")
            self.assertTrue(last["resumed_from"])
            self.assert_sound(campaign)

    def test_whoever_is_killed_the_next_one_knows(self):
        campaign = self.campaign(PRECISE)
        runner = campaign.start()
        self.addCleanup(runner.wait)
        self.addCleanup(runner.kill)
        campaign.wait_for(lambda: "asked to end" in campaign.said(), "a case to be precise enough")
        campaign.kill_all(runner)  # the solver may or may not have written its last checkpoint
        self.run_to_end(campaign, "resume")
        self.assert_finished_early(campaign)
        self.assert_sound(campaign)


if __name__ == "__main__":
    unittest.main(verbosity=2)
