"""A whole campaign from its file to its tables, and everything one can ask about it afterwards."""

import csv
import io
import json
import os
import pty
import subprocess
import unittest

from harness import CAMPAIGN, Campaign, EndToEndTest, changed


class WholeCampaign(EndToEndTest):
    @classmethod
    def setUpClass(cls):
        cls.shared = Campaign()
        cls.first = cls.shared.call("run")

    @classmethod
    def tearDownClass(cls):
        cls.shared.remove()

    def test_finishes_and_prints_its_results(self):
        self.assertEqual(self.first.returncode, 0, self.first.stderr)
        for label in ("precursor", "G=1_mu=1", "G=2_mu=1", "G=1_mu=10"):
            self.assertIn(label, self.first.stdout)
        self.assertIn(str(self.shared.folder / "results.db"), self.first.stderr)
        self.assertIn("4 of 4 cases finished", self.first.stderr)
        self.assertEqual(set(self.shared.states().values()), {"finished"})
        self.assert_sound(self.shared)

    def test_the_precursor_is_finished_before_an_elastic_case_starts(self):
        timeline = self.shared.query("SELECT event, label FROM timeline")
        events = [(row["event"], row["label"]) for row in timeline]
        self.assertLess(
            events.index(("attempt ended", "precursor")),
            min(i for i, (event, label) in enumerate(events) if label != "precursor" and "attempt" in event),
        )

    def test_every_case_has_a_result(self):
        rows = self.shared.query("SELECT label, state, re_tau_w, u_max, window_start, window_end FROM results")
        self.assertEqual(len(rows), 4)
        for row in rows:
            self.assertEqual(row["state"], "finished")
            self.assertGreater(row["re_tau_w"], 0)
            self.assertGreater(row["u_max"], 1)
            self.assertAlmostEqual(row["window_end"], 0.6, places=2)

    def test_every_small_file_is_held_against_its_schema(self):
        """test_finishes... finds the files of a real run sound; here each of them is broken in turn."""
        directory = self.shared.directory("G=1_mu=1")
        for name, member in (("case.json", "physics"), ("run.json", "started"), ("status.json", "dt_limit"),
                             ("summary.json", "provenance")):
            with self.subTest(name):
                whole = (directory / name).read_text(encoding="utf-8")
                self.addCleanup((directory / name).write_text, whole, encoding="utf-8")
                broken = json.loads(whole)
                del broken[member]
                (directory / name).write_text(json.dumps(broken), encoding="utf-8")
                verdict = self.shared.call("verify")
                (directory / name).write_text(whole, encoding="utf-8")
                self.assertEqual(verdict.returncode, 3, verdict.stdout)
                self.assertIn(f"{name}: /{member}: missing", verdict.stdout)

    def test_running_again_changes_nothing(self):
        before = self.shared.results(), self.shared.final_data()
        for command in ("run", "resume"):
            self.assertEqual(self.shared.call(command).returncode, 0)
        self.assertEqual((self.shared.results(), self.shared.final_data()), before)
        attempts = self.shared.query("SELECT max(attempt) AS most FROM attempts")
        self.assertEqual(attempts, [{"most": 1}])

    def test_plan_keeps_what_is_finished(self):
        plan = json.loads(self.shared.call("plan", "--json").stdout)
        self.assertEqual({case["outlook"] for case in plan["cases"]}, {"kept"})

    def test_plan_keeps_what_is_now_derived_instead_of_written(self):
        grid = {key: value for key, value in CAMPAIGN["physics"]["grid"].items() if key != "ny_solid"}
        derived = changed(CAMPAIGN, physics=dict(CAMPAIGN["physics"], grid=grid), derive={"ny_solid": "ny_fluid / 4"})
        self.addCleanup(self.shared.write, CAMPAIGN)
        self.shared.write(derived)
        cases = json.loads(self.shared.call("plan", "--json").stdout)["cases"]
        self.assertEqual([(case["label"], case["outlook"]) for case in cases],
                         [(label, "kept") for label in ("precursor", "G=1_mu=1", "G=2_mu=1", "G=1_mu=10")])
        self.shared.write(dict(derived, derive={"ny_solid": "ny_fluid / 4", "reynolds": "1400 * G"}))
        cases = json.loads(self.shared.call("plan", "--json").stdout)["cases"]
        self.assertEqual([(case["label"], case["outlook"]) for case in cases],
                         [("precursor_reynolds=1400", "start"), ("precursor", "kept"),
                          ("reynolds=1400_G=1_mu=1", "waiting"), ("G=2_mu=1", "kept"),
                          ("reynolds=1400_G=1_mu=10", "waiting")])

    def test_table_query_and_export_agree(self):
        self.assertEqual(self.shared.call("table").returncode, 0)
        exported = json.loads(self.shared.call("export", "--json").stdout)
        rows = list(csv.DictReader(io.StringIO(self.shared.call("export", "--csv").stdout)))
        self.assertEqual([row["label"] for row in rows], [row["label"] for row in exported])
        self.assertEqual(float(rows[0]["re_tau_w"]), exported[0]["re_tau_w"])
        file = self.shared.folder / "out.csv"
        self.assertEqual(self.shared.call("export", "--csv", "-o", str(file)).returncode, 0)
        self.assertEqual(list(csv.DictReader(io.StringIO(file.read_text()))), rows)

    def test_a_bad_query_is_refused_and_changes_nothing(self):
        for sql in ("SELEC 1", "DROP TABLE cases", "DELETE FROM cases", "SELECT 1; SELECT 2", ""):
            answer = self.shared.call("query", sql)
            self.assertEqual(answer.returncode, 2, f"{sql}: {answer.stderr}")
            self.assertEqual(answer.stdout, "")
            self.assertNotEqual(answer.stderr, "")
        self.assertEqual(len(self.shared.query("SELECT * FROM cases")), 4)

    def test_rebuild_gives_the_same_results_from_the_run_directories(self):
        before = self.shared.results()
        store = self.shared.folder / "results.db"
        for damage in (b"", b"not a database", None):
            if damage is None:
                store.unlink()
            else:
                store.write_bytes(damage)
                refused = self.shared.call("status")
                self.assertEqual(refused.returncode, 1, "a damaged store must not look like a new campaign")
                self.assertIn("rebuild", refused.stderr)
            answer = self.shared.call("rebuild")
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertEqual(self.shared.results(), before)

    def test_a_run_makes_a_damaged_store_again(self):
        store = self.shared.folder / "results.db"
        before, good = self.shared.results(), store.read_bytes()
        attempts = "SELECT case_id, attempt, outcome, resumed_from, wall_seconds FROM attempts ORDER BY case_id"
        history = self.shared.query(attempts)
        for damage in (b"", b"x", b"not a database", good[:-1], good[: len(good) // 2], good[:8192] + bytes(4096) + good[12288:]):
            store.write_bytes(damage)
            mended = self.shared.call("run")
            self.assertEqual(mended.returncode, 0, mended.stderr)
            self.assertIn("the store is made again from the run directories, the old one is now", mended.stderr)
            aside = max(self.shared.folder.glob("results.db.*Z"))
            self.assertEqual(aside.read_bytes(), damage)
            self.assertEqual(self.shared.results(), before)
            self.assertEqual(self.shared.query(attempts), history)
            self.assert_sound(self.shared)

    def test_a_run_sweeps_what_a_killed_one_left(self):
        for command in ("run", "rebuild"):
            left = [self.shared.folder / ".results.db.tmp-19968-0", self.shared.folder / ".softwall-rebuild-19968" / "results.db"]
            if command == "run":
                left += [self.shared.directory("G=1_mu=1") / f".{name}.json.tmp-19968-0" for name in ("case", "history", "run")]
            for file in left:
                file.parent.mkdir(exist_ok=True)
                file.write_text("half")
            kept = self.shared.folder / ".results.db.of-a-person"
            kept.write_text("")
            self.assertEqual(self.shared.call(command).returncode, 0)
            self.assertEqual([file for file in left if file.exists() or file.parent.name.startswith(".softwall") and
                              file.parent.exists()], [])
            self.assertTrue(kept.exists())
            kept.unlink()

    def test_output_that_nobody_reads_does_no_harm(self):
        process = subprocess.Popen(self.shared.command("run"), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.close()
        process.stderr.close()
        self.assertEqual(process.wait(60), 0)


class Terminal(EndToEndTest):
    def on_terminal(self, **settings):
        """All that a run writes to a terminal."""
        campaign = self.campaign(changed(CAMPAIGN, sweep={"list": [{"G": 1}]}))
        ours, theirs = pty.openpty()
        environment = {**os.environ, "TERM": "xterm", "COLUMNS": "80", **settings}
        process = subprocess.Popen(campaign.command("run"), stdin=theirs, stdout=theirs, stderr=theirs, env=environment)
        os.close(theirs)
        said = b""
        try:
            while piece := os.read(ours, 65536):
                said += piece
        except OSError:
            pass  # how Linux says that the other end was closed
        os.close(ours)
        self.assertEqual(process.wait(60), 0, said)
        return said.decode()

    def test_a_terminal_shows_progress_with_the_time_left(self):
        said = self.on_terminal()
        self.assertIn("\r\033[K0/2 finished", said)
        self.assertIn(" left", said)
        self.assertIn("\033[32m", said)

    def test_no_color_means_none(self):
        self.assertNotIn("\033[3", self.on_terminal(NO_COLOR="1"))


class Extension(EndToEndTest):
    def test_a_later_end_time_goes_on_where_the_case_ended(self):
        short = self.campaign(changed(CAMPAIGN, sweep={"list": [{"G": 1}]}, run={"end_time": 0.3, "checkpoint_steps": 20}))
        self.run_to_end(short)
        long = changed(CAMPAIGN, sweep={"list": [{"G": 1}]})
        short.write(long)
        self.run_to_end(short, "resume")
        attempts = short.query("SELECT label, attempt, resumed_from FROM attempt_history WHERE label <> 'precursor'")
        self.assertEqual(len(attempts), 2)
        self.assertTrue(attempts[1]["resumed_from"])
        reference = self.campaign(long)
        self.run_to_end(reference)
        self.assert_same_outcome(short, reference)

    def test_a_damaged_last_checkpoint_costs_a_finished_case_nothing(self):
        short = self.campaign(changed(CAMPAIGN, sweep={"list": [{"G": 1}]}, run={"end_time": 0.3, "checkpoint_steps": 20}))
        self.run_to_end(short)
        results, (newest, before) = short.results(), short.checkpoints("G=1")
        newest.write_bytes(newest.read_bytes()[:-1])
        told = short.call("verify")
        self.assertEqual(told.returncode, 3)
        self.assertIn("its results stand; with a later end time it goes on from another one", told.stdout)
        self.run_to_end(short)
        self.assertEqual(short.results(), results)
        long = changed(CAMPAIGN, sweep={"list": [{"G": 1}]})
        short.write(long)
        self.run_to_end(short)
        (last,) = short.query("SELECT resumed_from FROM attempts ORDER BY started DESC LIMIT 1")
        self.assertEqual(last["resumed_from"], f"checkpoints/{before.name}")
        reference = self.campaign(long)
        self.run_to_end(reference)
        self.assert_same_outcome(short, reference)
        self.assert_sound(short)

    def test_a_wider_sweep_keeps_the_cases_it_has(self):
        campaign = self.campaign(changed(CAMPAIGN, sweep={"list": [{"G": 1}]}))
        self.run_to_end(campaign)
        campaign.write(changed(CAMPAIGN, sweep={"grid": {"G": [1, 2], "viscosity_ratio": [1]}}))
        self.run_to_end(campaign)
        attempts = campaign.query("SELECT case_id, max(attempt) AS most FROM attempts GROUP BY case_id")
        self.assertEqual([row["most"] for row in attempts], [1, 1, 1], "the precursor and G = 1 are kept")


if __name__ == "__main__":
    unittest.main(verbosity=2)
