"""What is wrong must be said clearly, with the right exit status, and nothing may be lost or half done."""

import os
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

from harness import CAMPAIGN, HEADER_BYTES, SOFTWALL, EndToEndTest, changed


def without_grid():
    document = changed(CAMPAIGN)
    del document["physics"]["grid"]
    return document


BAD_FILES = {
    "unknown key": (changed(CAMPAIGN, sweeep={}), "sweeep"),
    "unknown parameter": (changed(CAMPAIGN, sweep={"grid": {"GG": [1]}}), "GG"),
    "wrong type": (changed(CAMPAIGN, run={"end_time": "long"}), "/run/end_time"),
    "negative G": (changed(CAMPAIGN, sweep={"list": [{"G": -1}]}), "-1"),
    "missing key": (without_grid(), "grid"),
    "newer format": (changed(CAMPAIGN, format=2), "/format"),
    "not JSON": ("{", "line 1"),
    "empty": ("", "campaign.json"),
}


class BadInput(EndToEndTest):
    def assert_refused(self, answer, *words):
        self.assertEqual(answer.returncode, 2, answer.stderr)
        self.assertEqual(answer.stdout, "")
        for word in words:
            self.assertIn(word, answer.stderr)
        self.assertLess(len(answer.stderr.splitlines()), 12, answer.stderr)
        self.assertNotIn("terminate called", answer.stderr)

    def test_bad_campaign_files(self):
        for what, (document, word) in BAD_FILES.items():
            with self.subTest(what):
                campaign = self.campaign(document)
                for command in ("run", "plan", "status"):
                    self.assert_refused(campaign.call(command), word)
                self.assertEqual([path.name for path in campaign.folder.iterdir()], ["campaign.json"])

    def test_a_file_that_is_not_there(self):
        for command in ("run", "resume", "plan", "status", "verify", "rebuild", "table"):
            answer = subprocess.run([SOFTWALL, command, "/no/such/campaign"], capture_output=True, text=True)
            self.assert_refused(answer, "/no/such/campaign")

    def test_a_folder_without_a_campaign(self):
        campaign = self.campaign()
        (campaign.folder / "campaign.json").unlink()
        self.assert_refused(campaign.call("run"), str(campaign.folder), "campaign.json")

    def test_mistyped_commands_and_options(self):
        for words, hint in ((["stauts", "."], "status"), (["rnu", "."], "run"), ([], "run"), (["run"], "PATH"),
                            (["plan", "--jsno", "."], "--json"), (["query", "."], "SQL")):
            answer = subprocess.run([SOFTWALL, *words], capture_output=True, text=True)
            self.assertEqual(answer.returncode, 2, answer.stderr)
            self.assertIn(hint, answer.stderr, words)
        self.assertEqual(subprocess.run([SOFTWALL, "--help"], capture_output=True).returncode, 0)

    def test_a_missing_solver_or_mpirun_is_said_before_anything_changes(self):
        campaign = self.campaign()
        for settings, word in (({"SOFTWALL_DNS": "/no/such/solver"}, "/no/such/solver"),
                               ({"SOFTWALL_DNS": "/etc/passwd"}, "/etc/passwd"), ({"PATH": "/no/such"}, "mpirun")):
            answer = campaign.call("run", env={**os.environ, **settings})
            self.assert_refused(answer, word)
            self.assertFalse((campaign.folder / "results.db").exists())
            self.assertFalse((campaign.folder / "cases").exists())

    def test_a_missing_solver_of_the_other_precision_too(self):
        campaign = self.campaign(changed(CAMPAIGN, physics=dict(CAMPAIGN["physics"], precision="single")))
        alone = campaign.folder / "softwall-dns"
        shutil.copy(Path(SOFTWALL).parent / "softwall-dns", alone)
        answer = campaign.call("run", env={**os.environ, "SOFTWALL_DNS": str(alone)})
        self.assert_refused(answer, "/physics/precision: single", str(alone) + "-single")
        self.assertFalse((campaign.folder / "cases").exists())

    def test_a_solver_that_cannot_run_fails_each_case_and_is_retried_after_repair(self):
        campaign = self.campaign(changed(CAMPAIGN, sweep={"grid": {"G": list(range(1, 13))}}))
        broken = campaign.folder / "broken-dns"
        broken.write_text("this is no program")
        broken.chmod(0o755)
        answer = campaign.call("run", env={**os.environ, "SOFTWALL_DNS": str(broken)})
        self.assertEqual(answer.returncode, 3, answer.stderr)
        self.assertIn("13 cases failed", answer.stderr)
        self.assertIn("G=9: ", answer.stderr)  # the precursor and nine others are named
        self.assertNotIn("G=10: ", answer.stderr)
        self.assertIn("and 3 more:  ", answer.stderr)
        campaign.write(changed(CAMPAIGN, sweep={"list": [{"G": 1}]}))
        self.run_to_end(campaign, "resume")

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("setpriv"), "needs root to become somebody else")
    def test_a_folder_that_cannot_be_written(self):
        campaign = self.campaign()
        campaign.folder.chmod(0o755)
        somebody = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        if subprocess.run([*somebody, SOFTWALL, "--version"], capture_output=True).returncode != 0:
            self.skipTest("others may not execute the build")
        answer = subprocess.run([*somebody, *campaign.command("run")], capture_output=True, text=True)
        self.assert_refused(answer, str(campaign.folder), "cannot be written")
        self.assertEqual([path.name for path in campaign.folder.iterdir()], ["campaign.json"])
        plan = subprocess.run([*somebody, *campaign.command("plan")], capture_output=True, text=True)
        self.assertEqual(plan.returncode, 0, plan.stderr)

    def test_too_little_disk_is_said_before_anything_starts(self):
        grid = {"nx": 40000, "ny_fluid": 16000, "ny_solid": 4000, "nz": 20000}
        campaign = self.campaign(changed(CAMPAIGN, physics=dict(CAMPAIGN["physics"], grid=grid)))
        self.assert_refused(campaign.call("run"), "disk: ", " GB free; this campaign has yet to write checkpoints ")

    def test_a_diverging_case_is_told_and_the_others_finish(self):
        # the softest wall follows this step, the stiffest cannot
        document = changed(CAMPAIGN, sweep={"list": [{"G": 1}, {"G": 1e6}]})
        campaign = self.campaign(document)
        answer = campaign.call("run")
        self.assertEqual(answer.returncode, 3, answer.stderr)
        self.assertIn("diverged", answer.stderr)
        states = campaign.states()
        self.assertEqual(sorted(states.values()), ["diverged", "finished", "finished"])
        again = campaign.call("run")
        self.assertEqual(again.returncode, 3)
        attempts = campaign.query("SELECT attempt FROM attempt_history WHERE outcome = 'diverged'")
        self.assertEqual(attempts, [{"attempt": 1}], "never run again unchanged")


class DamagedCheckpoint(EndToEndTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.document = changed(CAMPAIGN, sweep={"list": [{"G": 1}]}, run={"end_time": 0.6, "checkpoint_steps": 20,
                                                                          "keep_checkpoints": 4})

    def interrupted(self):
        """Stopped while the elastic case is under way, with several checkpoints."""
        campaign = self.campaign(self.document)
        runner = campaign.start()
        campaign.wait_for(lambda: len(list(campaign.folder.glob("cases/G=*/checkpoints/checkpoint-*.h5"))) >= 3,
                          "three checkpoints")
        campaign.kill_all(runner)
        return campaign

    def finish_and_compare(self, campaign, *options):
        answer = campaign.call("resume", *options)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        reference = self.campaign(self.document)
        self.run_to_end(reference)
        self.assert_same_outcome(campaign, reference)
        return answer.stderr

    def test_a_damaged_one_is_set_aside_and_the_next_older_used(self):
        campaign = self.interrupted()
        newest, older = campaign.checkpoints("G=1")[:2]
        contents = bytearray(newest.read_bytes())
        contents[len(contents) // 2] ^= 1
        newest.write_bytes(contents)
        before = older.read_bytes()
        verdict = campaign.call("verify")
        self.assertEqual(verdict.returncode, 3)
        self.assertIn(newest.name, verdict.stdout)
        self.assertEqual(older.read_bytes(), before)
        said = self.finish_and_compare(campaign)
        self.assertIn(f"{newest.name}.bad set aside", said)
        self.assertEqual(newest.with_name(newest.name + ".bad").read_bytes(), contents)
        (record,) = campaign.query("SELECT path, reason FROM checkpoints WHERE NOT valid")
        self.assertIn(newest.name, record["path"])

    def test_all_kinds_of_damage_at_once_mean_a_start_from_the_precursor_when_a_person_says_so(self):
        campaign = self.interrupted()
        ladder = campaign.checkpoints("G=1")
        os.truncate(ladder[0], 0)
        os.truncate(ladder[1], ladder[1].stat().st_size - 1)
        for damaged in ladder[2:]:
            damaged.write_bytes(b"{}" + damaged.read_bytes()[2:])
        answer = campaign.call("resume")
        self.assertEqual(answer.returncode, 4, answer.stderr)
        self.assertIn("--start-over", answer.stderr)
        self.assertEqual(answer.stderr.count("set aside"), len(ladder))
        self.assertEqual(campaign.call("resume", "--start-over").returncode, 0)
        self.finish_and_compare(campaign)

    def test_a_checkpoint_of_another_case_or_grid_is_refused(self):
        campaign = self.interrupted()
        other = self.campaign(changed(self.document, physics=dict(
            CAMPAIGN["physics"], grid={"nx": 8, "ny_fluid": 16, "ny_solid": 4, "nz": 8})))
        self.run_to_end(other)
        newest = campaign.checkpoints("G=1")[0]
        foreign = newest.with_name("checkpoint-000099999.h5")
        shutil.copy(other.checkpoints("G=1")[0], foreign)
        said = self.finish_and_compare(campaign)
        self.assertIn("checkpoint-000099999.h5.bad set aside", said)

    def test_the_precursors_last_one_is_computed_again(self):
        campaign = self.interrupted()
        shutil.rmtree(campaign.directory("G=1"))
        newest = campaign.checkpoints("precursor")[0]
        os.truncate(newest, HEADER_BYTES + 100)
        self.finish_and_compare(campaign, "--start-over")

    def test_a_damaged_case_file_or_summary_is_no_obstacle(self):
        campaign = self.interrupted()
        directory = campaign.directory("G=1")
        for name in ("case.json", "run.json", "summary.json", "status.json"):
            (directory / name).write_text("{ damaged")
        self.finish_and_compare(campaign)


@unittest.skipUnless(os.geteuid() == 0, "needs root to mount a small disk")
class FullDisk(EndToEndTest):
    def test_a_full_disk_pauses_the_campaign_and_loses_nothing(self):
        campaign = self.campaign(changed(CAMPAIGN, sweep={"list": [{"G": 1}]}))
        mount = ["mount", "-t", "tmpfs", "-o", "size=12m", "softwall-test", str(campaign.folder)]
        if subprocess.run(mount, capture_output=True).returncode != 0:
            self.skipTest("cannot mount here")
        self.addCleanup(subprocess.run, ["umount", "-l", str(campaign.folder)], capture_output=True)
        campaign.write(changed(CAMPAIGN, sweep={"list": [{"G": 1}]}))
        runner = campaign.start()
        campaign.wait_for_checkpoint("precursor")
        for pid in campaign.solvers():
            os.kill(pid, signal.SIGSTOP)
        ballast = campaign.folder / "ballast"
        try:
            ballast.write_bytes(bytes(64 << 20))
        except OSError:
            pass  # the disk is full now, which is the point
        for pid in campaign.solvers():
            os.kill(pid, signal.SIGCONT)
        self.assertIn(runner.wait(120), (1, 4), campaign.said())
        self.assertEqual(campaign.solvers(), {})
        ballast.unlink()
        self.run_to_end(campaign, "resume")
        reference = self.campaign(changed(CAMPAIGN, sweep={"list": [{"G": 1}]}))
        self.run_to_end(reference)
        self.assert_same_outcome(campaign, reference)


if __name__ == "__main__":
    unittest.main(verbosity=2)
