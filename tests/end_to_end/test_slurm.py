"""Campaigns whose attempts are jobs of a real Slurm, of one node and for the time of the test.

Skipped, in words, where no Slurm can be started: its packages are not installed, or its daemons do not come up.
"""

import contextlib
import json
import os
import shutil
import signal
import sys
import unittest

from harness import CAMPAIGN, Campaign, EndToEndTest, OneSolverOnly, changed
from slurm_cluster import CannotStart, SlurmCluster, begin_for

# Two cases of a few seconds that start by themselves.
SMALL = {name: member for name, member in CAMPAIGN.items() if name != "precursor"}
SMALL = changed(SMALL, sweep={"grid": {"G": [1, 2]}}, run={"end_time": 1.4, "checkpoint_steps": 20},
                execution={"launcher": "slurm", "ranks": 1, "slurm": {"partition": "main"}})
LOCAL = changed(SMALL, execution={"ranks": 1, "cores": 2})
LABELS = ["G=1", "G=2"]

# A case without an end, of a minute's jobs that are told to checkpoint after some seconds. Slurm looks at its clock
# every half minute, so that this goes on beside all other tests.
LIMITED = changed(SMALL, sweep={"grid": {"G": [8]}}, run={"end_time": 10000, "checkpoint_steps": 1000000})
LIMITED["execution"]["slurm"].update(time_limit_minutes=1, signal_seconds=50)


class Slurm(EndToEndTest):
    @classmethod
    def setUpClass(cls):
        begin_for(cls, SlurmCluster)
        cls.reference = Campaign(LOCAL)
        cls.addClassCleanup(cls.reference.remove)
        assert cls.reference.call("run").returncode == 0
        cls.limited = Campaign(LIMITED)
        cls.addClassCleanup(cls.limited.remove)
        cls.limited_runner = cls.limited.start()
        cls.addClassCleanup(cls.limited_runner.wait)
        cls.addClassCleanup(cls.limited_runner.kill)

    def started(self, document=SMALL):
        self.cluster.wait(self.cluster.bring_node_back, "the node")  # a controller that was killed may have drained it
        campaign = self.campaign(document)
        return campaign, self.runner_of(campaign)

    def runner_of(self, campaign, name="run"):
        runner = campaign.start(name)
        self.addCleanup(runner.wait)
        self.addCleanup(runner.kill)
        return runner

    def hold(self, campaign, labels=LABELS):
        """Until all have computed and written something to lose, and stand still there: whatever happens to a campaign,
        however slow this machine is just now, happens while its jobs are at work. A controller that was killed before may
        drain the node late."""
        held = set()

        def all_are_held():
            self.cluster.bring_node_back()
            for label in set(labels) - held:
                if any(campaign.folder.glob(f"cases/{label}-*/checkpoints/checkpoint-*.h5")):
                    self.send(campaign, signal.SIGSTOP, label)
                    held.add(label)
            return held == set(labels)

        self.addCleanup(self.release, campaign)
        campaign.wait_for(all_are_held, "all to compute", 240)

    def release(self, campaign):
        self.send(campaign, signal.SIGCONT)

    def send(self, campaign, what, label=""):
        """To the ranks. An mpirun that stood still would be told to hang up by the kernel when what had started it dies."""
        for pid, (name, place) in campaign.solvers().items():
            if name.startswith("softwall-dns") and f"/cases/{label}" in place:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, what)

    def job_of(self, campaign, label):
        return self.cluster.number_of(f"{campaign.folder.name}.{label}-")

    def jobs_of(self, campaign):
        return [state for name, state in self.cluster.jobs().items() if f".{campaign.folder.name}." in name]

    def assert_ends_as_if_undisturbed(self, campaign, runner, seconds=400):
        """Seconds, mostly; a minute and a half more where a solver was killed without a word."""
        campaign.wait_for(lambda: self.cluster.bring_node_back() and runner.poll() is not None, "its end", seconds)
        self.assertEqual(runner.returncode, 0, campaign.said())
        self.assert_same_outcome(campaign, self.reference)
        self.assert_sound(campaign)
        self.assertEqual(list(campaign.folder.rglob("job.sh")), [])

    def outcomes(self, campaign, label):
        rows = campaign.query(
            f"SELECT outcome FROM attempts JOIN cases USING (case_id) WHERE label = '{label}' ORDER BY attempt")
        return [row["outcome"] for row in rows]

    # -- nothing goes wrong -----------------------------------------------------------------------------------

    def test_01_a_campaign_has_the_results_of_the_local_launcher(self):
        campaign = self.campaign(SMALL)
        plan = campaign.call("plan")
        self.assertEqual((plan.returncode, plan.stderr), (0, ""))
        self.assertIn("By slurm, all of them at once", plan.stdout)
        runner = self.runner_of(campaign)
        campaign.wait_for(lambda: "running" in campaign.states().values(), "a job to run")
        self.assert_ends_as_if_undisturbed(campaign, runner)
        self.assertIn("G=1: submitted to t = 1.4", campaign.said())
        self.assertIn("G=1: its job has begun", campaign.said())
        self.assertEqual(self.outcomes(campaign, "G=1"), ["finished"])

    def test_02_what_slurm_refuses_is_refused_in_its_words_before_anything_begins(self):
        wrong = changed(SMALL)
        wrong["execution"]["slurm"]["partition"] = "nowhere"
        campaign = self.campaign(wrong)
        answer = campaign.call("run")
        self.assertEqual(answer.returncode, 2)
        self.assertIn("Invalid partition name specified", answer.stderr)
        self.assertEqual(list(campaign.folder.glob("cases/*")), [])
        self.assertIn("Invalid partition name specified", campaign.call("plan").stderr)
        campaign.write(changed(SMALL, execution={**SMALL["execution"], "ranks": 8}))
        self.assertIn("its partitions have at most 4 cores", campaign.call("plan").stderr)

    def test_03_ranks_may_be_started_by_srun(self):
        document = changed(SMALL, sweep={"grid": {"G": [1]}})
        document["execution"]["slurm"].update(start_with="srun", start_options=["--mpi=pmix_v4"])
        campaign, runner = self.started(document)
        self.hold(campaign, ["G=1"])
        self.cluster.call("scancel", "--signal=USR1", self.job_of(campaign, "G=1"))
        self.release(campaign)
        self.assertEqual(runner.wait(240), 0, campaign.said())
        self.assertEqual(self.outcomes(campaign, "G=1"), ["interrupted", "finished"])

    # -- what happens to jobs ---------------------------------------------------------------------------------

    def test_04_cancelled_and_requeued_jobs_go_on_and_a_dying_sbatch_leads_to_no_second_job(self):
        folder = self.cluster.folder / "dying"
        folder.mkdir()
        (folder / "sbatch").write_text(
            f'#!/bin/sh\n{shutil.which("sbatch")} "$@" >/dev/null\n'
            'case "$*" in *--test-only*) exit 0;; esac\nkill -9 $$\n')
        (folder / "sbatch").chmod(0o755)
        os.environ["PATH"] = f"{folder}:{os.environ['PATH']}"
        self.addCleanup(os.environ.update, PATH=os.environ["PATH"].partition(":")[2])
        campaign, runner = self.started()
        self.hold(campaign)
        requeued = self.job_of(campaign, "G=2")
        self.cluster.call("scancel", self.job_of(campaign, "G=1"))
        refused = self.cluster.call("scontrol", "requeue", requeued)
        self.assertNotEqual(refused.returncode, 0, "softwall asks Slurm not to run a job again by itself")
        self.cluster.call("scontrol", "update", f"jobid={requeued}", "requeue=1")
        self.assertEqual(self.cluster.call("scontrol", "requeue", requeued).returncode, 0)
        self.release(campaign)
        self.assert_ends_as_if_undisturbed(campaign, runner)
        for label in LABELS:
            first, *more = self.outcomes(campaign, label)
            self.assertIn(first, ("interrupted", "killed"))
            self.assertEqual(more, ["finished"])
        self.assertEqual(len(self.jobs_of(campaign)), 4, "one for each attempt")

    # -- what happens to softwall -----------------------------------------------------------------------------

    def test_05_jobs_go_on_without_softwall_which_finds_them_again(self):
        campaign, runner = self.started()
        self.hold(campaign)
        runner.kill()
        runner.wait()
        runner = self.runner_of(campaign, "resume")
        campaign.wait_for(lambda: campaign.said().count("it goes on; waiting for its end") == 2, "both to be adopted", 240)
        runner.send_signal(signal.SIGINT)
        self.assertEqual(runner.wait(240), 4, campaign.said())
        self.release(campaign)
        self.assertIn("go on without softwall", campaign.said())
        self.assert_ends_as_if_undisturbed(campaign, self.runner_of(campaign, "resume"))
        for label in LABELS:
            self.assertEqual(self.outcomes(campaign, label), ["finished"], campaign.said())
        self.assertEqual(self.jobs_of(campaign), ["COMPLETED", "COMPLETED"], "no job was submitted twice")

    # -- what happens to the machine --------------------------------------------------------------------------

    def test_08_a_node_that_fails_keeps_its_processes_and_nobody_joins_them(self):
        """Slurm gives the job up, and what it had started goes on computing: the attempt ends when its last process has."""
        campaign, runner = self.started()
        with OneSolverOnly(campaign) as watch:
            self.hold(campaign)
            self.cluster.fail_node()
            campaign.wait_for(lambda: "NODE_FAIL" in self.jobs_of(campaign), "Slurm to give the jobs up", 240)
            self.assertNotEqual(campaign.solvers(), {}, "the test is about processes that go on")
            self.cluster.start_node()
            self.release(campaign)
            self.assert_ends_as_if_undisturbed(campaign, runner)
        self.assertEqual(watch.crowded, [])
        for label in LABELS:
            self.assertEqual(self.outcomes(campaign, label), ["finished"], campaign.said())

    def test_09_a_node_that_fails_with_all_its_processes_costs_an_attempt_and_no_case(self):
        campaign, runner = self.started()
        with OneSolverOnly(campaign) as watch:
            self.hold(campaign)
            self.cluster.fail_node()
            campaign.kill_all()
            campaign.wait_for(lambda: "NODE_FAIL" in self.jobs_of(campaign), "Slurm to give the jobs up", 240)
            self.cluster.start_node()
            self.assert_ends_as_if_undisturbed(campaign, runner)
        self.assertEqual(watch.crowded, [])
        for label in LABELS:
            self.assertEqual(self.outcomes(campaign, label), ["node failure", "finished"])

    # -- several cases in one job -------------------------------------------------------------------------------

    def test_10_cases_that_share_a_job_keep_their_own_attempts_and_are_stopped_together(self):
        document = changed(SMALL)
        document["execution"]["slurm"]["cases_per_job"] = 2
        campaign = self.campaign(document)
        self.assertIn("up to 2 cases a job", campaign.call("plan").stdout)
        self.cluster.wait(self.cluster.bring_node_back, "the node")
        runner = self.runner_of(campaign)
        self.hold(campaign)
        self.cluster.call("scancel", "--batch", "--signal=USR1", self.cluster.number_of("2-cases"))  # as before a time limit
        self.release(campaign)
        campaign.wait_for(lambda: campaign.said().count("stopped on request") == 2, "both to be stopped", 240)
        self.hold_again(campaign)
        self.cluster.call("scancel", self.cluster.number_of("2-cases"))
        self.assert_ends_as_if_undisturbed(campaign, runner)
        self.assertEqual(len(self.jobs_of(campaign)), 3, "one for both, each time")
        for label in LABELS:
            first, second, *rest = self.outcomes(campaign, label)
            self.assertEqual((first, rest), ("interrupted", ["finished"]))
            self.assertIn(second, ("interrupted", "killed"))

    def hold_again(self, campaign):
        """In their second attempts, once these have made steps of their own."""
        def have_got_further():
            reports = [json.loads((campaign.directory(label) / "status.json").read_text()) for label in LABELS]
            reached = [row["step"] for row in campaign.query("SELECT step FROM attempts WHERE attempt = 1")]
            return all(report["attempt"] == 2 and report["step"] > max(reached) for report in reports)

        campaign.wait_for(have_got_further, "the second attempts", 240)
        self.send(campaign, signal.SIGSTOP)

    # -- what was begun first ---------------------------------------------------------------------------------

    def test_06_before_the_time_limit_a_signal_asks_for_a_checkpoint_and_another_job_goes_on(self):
        again = "G=8: submitted, from t = "
        self.limited.wait_for(lambda: again in self.limited.said(), "the second job", 240)
        first = self.limited.query("SELECT outcome, reason, wall_seconds AS s FROM attempts WHERE attempt = 1")[0]
        self.assertEqual((first["outcome"], first["reason"]), ("interrupted", "stopped on request"))
        self.assertLess(first["s"], 60)
        self.limited_runner.kill()
        self.cluster.call("scancel", "--user=" + str(os.geteuid()))

    # -- what happens to Slurm --------------------------------------------------------------------------------

    def test_07_a_controller_that_is_killed_loses_no_case_and_runs_none_twice(self):
        campaign, runner = self.started()
        self.hold(campaign)
        self.cluster.kill("slurmctld")  # it may not have saved yet what it knows of the jobs
        campaign.wait_for(lambda: "Slurm does not answer" in campaign.said(), "the silence to be told", 240)
        self.assertIsNone(runner.poll(), "silence is no end")
        self.cluster.start_controller()
        self.release(campaign)
        self.assert_ends_as_if_undisturbed(campaign, runner)


if __name__ == "__main__":
    try:
        SlurmCluster().stop()
    except CannotStart as reason:
        print(f"skipped: no Slurm can be started here: {reason}")
        sys.exit(77)
    unittest.main(verbosity=2)
