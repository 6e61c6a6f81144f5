"""A line of cases, each from the end of the next stiffer one: the order of their runs, who waits for whom when one fails,
and what the store knows of it."""

import json
import os
import sqlite3
import unittest
from contextlib import closing
from pathlib import Path

from harness import CAMPAIGN, EndToEndTest, changed

LINE = changed(CAMPAIGN, sweep={"grid": {"G": [0.5, 1, 2]}}, start_from={"nearest": "G"},
               precursor={"run": {"end_time": 0.2, "checkpoint_steps": 20}},
               run={"end_time": 0.2, "checkpoint_steps": 20})
LABELS = ["precursor", "G=2", "G=1", "G=0.5"]
LINEAGE = "SELECT label, start, from_label, from_time, generation, line FROM started_from ORDER BY generation"
ORIGINS = [
    {"label": "precursor", "start": "perturbed_laminar", "from_label": None, "from_time": None, "generation": 0,
     "line": "precursor"},
    {"label": "G=2", "start": "precursor", "from_label": "precursor", "from_time": 0.2, "generation": 1,
     "line": "precursor > G=2"},
    {"label": "G=1", "start": "neighbour", "from_label": "G=2", "from_time": 0.2, "generation": 2,
     "line": "precursor > G=2 > G=1"},
    {"label": "G=0.5", "start": "neighbour", "from_label": "G=1", "from_time": 0.2, "generation": 3,
     "line": "precursor > G=2 > G=1 > G=0.5"},
]


def solver_that_fails_for(label, campaign):
    """The real solver for every other case."""
    real = Path(os.environ.get("SOFTWALL", "build/bin/softwall")).resolve().parent / "softwall-dns"
    script = campaign.folder / "solver.sh"
    script.write_text(f'#!/bin/sh\ncase "$*" in *{label}-*) exit 70;; esac\nexec {real} "$@"\n')
    script.chmod(0o755)
    return {**os.environ, "SOFTWALL_DNS": str(script)}


class StartFrom(EndToEndTest):
    def plan(self, campaign):
        return [(case["label"], case["outlook"], case["reason"])
                for case in json.loads(campaign.call("plan", "--json").stdout)["cases"]]

    def test_each_starts_where_the_next_stiffer_one_has_ended(self):
        campaign = self.campaign(LINE)
        self.assertEqual(self.plan(campaign), [
            ("precursor", "start", "new"), ("G=2", "waiting", "for precursor"), ("G=1", "waiting", "for G=2"),
            ("G=0.5", "waiting", "for G=1")])
        self.assertIn("Cases start one from the other, from the largest G on", campaign.call("plan").stdout)
        self.run_to_end(campaign)
        ends = campaign.query("SELECT label FROM timeline WHERE event = 'attempt ended'")
        self.assertEqual([row["label"] for row in ends], LABELS)
        log = (campaign.directory("G=0.5") / "solver.log").read_text()
        self.assertRegex(log, "starts from its neighbour's .*/G=1-.*/checkpoint-000000100.h5")
        self.assertEqual(campaign.query(LINEAGE), ORIGINS)
        self.assert_sound(campaign)

        with self.subTest("a store made again knows it too"):
            self.assertEqual(campaign.call("rebuild").returncode, 0)
            self.assertEqual(campaign.query(LINEAGE), ORIGINS)
            self.assert_sound(campaign)

        with self.subTest("a softer case joins at the end, nothing else runs again"):
            campaign.write(changed(LINE, sweep={"grid": {"G": [0.5, 1, 2, 0.25]}}))
            self.assertEqual(self.plan(campaign)[1:], [
                ("G=2", "kept", "finished"), ("G=1", "kept", "finished"), ("G=0.5", "kept", "finished"),
                ("G=0.25", "start", "new, from the end of G=0.5")])

        with self.subTest("another start is another case"):
            campaign.write({key: value for key, value in LINE.items() if key != "start_from"})
            self.assertEqual(dict((label, outlook) for label, outlook, _ in self.plan(campaign)),
                             {"precursor": "kept", "G=2": "kept", "G=1": "start", "G=0.5": "start"})

        with self.subTest("what the store says of it is verified"):
            campaign.write(LINE)
            damage = ("UPDATE cases SET precursor_id = (SELECT case_id FROM cases WHERE label = 'G=2')"
                      " WHERE label = 'G=0.5'")
            with closing(sqlite3.connect(campaign.folder / "results.db")) as store, store:
                store.execute(damage)
            verdict = campaign.call("verify")
            self.assertEqual(verdict.returncode, 3, verdict.stdout + verdict.stderr)
            self.assertIn("precursor_id", verdict.stdout + verdict.stderr)

    def test_those_behind_a_case_that_fails_say_so_and_go_on_when_it_does(self):
        campaign, undisturbed = self.campaign(LINE), self.campaign(LINE)
        answer = campaign.call("run", env=solver_that_fails_for("G=2", campaign))
        self.assertEqual(answer.returncode, 3, answer.stderr)
        self.assertIn("3 cases failed", answer.stderr)
        said = campaign.call("status", "--why").stdout
        self.assertIn("start: again from the start, no checkpoint yet, after: the solver failed", said)
        self.assertIn("waiting: for G=2", said)
        self.assertIn("softwall resume", said, "which tries again")
        cases = json.loads(campaign.call("status", "--why", "--json").stdout)["cases"]
        self.assertEqual([case["why"].partition(":")[0] for case in cases], ["kept", "start", "waiting", "waiting"])
        self.run_to_end(campaign, "resume")
        self.run_to_end(undisturbed)
        self.assert_same_outcome(campaign, undisturbed)
        self.assert_sound(campaign)


if __name__ == "__main__":
    unittest.main(verbosity=2)
