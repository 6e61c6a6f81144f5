"""Ctrl-C, a second softwall, time limits: the orderly ways not to reach the end."""

import os
import signal
import subprocess
import time
import unittest

from harness import CAMPAIGN, EndToEndTest, changed

# Its precursor would take minutes: whatever ends it before was asked to.
LONG = changed(CAMPAIGN, precursor={"run": {"end_time": 200, "checkpoint_steps": 1000000, "checkpoint_seconds": 1}})


class Stop(EndToEndTest):
    def started(self, document=LONG):
        campaign = self.campaign(document)
        runner = campaign.start()
        self.addCleanup(runner.wait)
        self.addCleanup(runner.kill)
        campaign.wait_for(
            lambda: any(campaign.folder.glob("cases/*/status.json")), "the first case to make steps")
        return campaign, runner

    def test_each_signal_lets_every_case_write_a_checkpoint(self):
        for request in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(request):
                campaign, runner = self.started()
                runner.send_signal(request)
                self.assertEqual(runner.wait(60), 4, campaign.said())
                self.assertEqual(campaign.solvers(), {})
                self.assertEqual(campaign.states()["precursor"], "interrupted")
                self.assertEqual(len(campaign.checkpoints("precursor")), 1)
                self.assertIn(f"softwall resume {campaign.folder}", campaign.said())
                outcomes = campaign.query("SELECT outcome FROM attempts")
                self.assertEqual(outcomes, [{"outcome": "interrupted"}])
                self.assert_sound(campaign)

    def test_a_stopped_campaign_ends_with_the_bits_of_one_never_stopped(self):
        campaign, runner = self.started(CAMPAIGN)
        runner.send_signal(signal.SIGINT)
        self.assertIn(runner.wait(60), (0, 4))
        self.run_to_end(campaign, "resume")
        reference = self.campaign()
        self.run_to_end(reference)
        self.assert_same_outcome(campaign, reference)

    def test_a_third_request_ends_at_once_what_does_not_react(self):
        campaign, runner = self.started()
        for pid in campaign.solvers():
            os.kill(pid, signal.SIGSTOP)  # neither mpirun nor its ranks can obey now
        runner.send_signal(signal.SIGINT)
        time.sleep(0.5)
        self.assertIsNone(runner.poll(), "the first request waits for the checkpoint")
        runner.send_signal(signal.SIGINT)
        time.sleep(0.5)
        runner.send_signal(signal.SIGINT)
        self.assertEqual(runner.wait(60), 4, campaign.said())
        self.assertEqual(campaign.solvers(), {})

    def test_a_second_softwall_is_told_who_runs_the_campaign(self):
        campaign, runner = self.started()
        for command in ("run", "resume", "rebuild"):
            answer = campaign.call(command)
            self.assertEqual(answer.returncode, 5, answer.stderr)
            self.assertIn(f"process {runner.pid}", answer.stderr)
            self.assertIn(os.uname().nodename, answer.stderr)
        self.assertEqual(campaign.states()["precursor"], "running", "reading is always possible")
        self.assertEqual(campaign.call("query", "SELECT * FROM cases").returncode, 0)

    def test_results_that_nobody_brings_up_to_date_any_more_tell_so(self):
        campaign, runner = self.started()
        question = ("query", "SELECT state FROM results WHERE state = 'running'", "--csv")
        self.assertEqual(campaign.call(*question).stderr, "")
        campaign.kill_all(runner)
        answer = campaign.call(*question)
        self.assertEqual(answer.stdout.split(), ["state", "running"])
        self.assertIn("1 case was running when softwall stopped", answer.stderr)
        self.assertIn(f"softwall status {campaign.folder}", answer.stderr)

    def test_of_twenty_at_once_one_runs_and_the_others_say_who(self):
        """Every other one seen from another host name, where that can be had."""
        elsewhere = ["unshare", "--uts", "sh", "-c", 'hostname "$0" && exec "$@"']
        can = subprocess.run([*elsewhere, "elsewhere", "true"], capture_output=True, check=False).returncode == 0
        campaign = self.campaign(LONG)
        all_of_them, hosts = [], {}
        for number in range(20):
            host = f"elsewhere-{number}" if can and number % 2 else None
            command = [*elsewhere, host, *campaign.command("run")] if host else campaign.command("run")
            one = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            self.addCleanup(one.stderr.close)
            self.addCleanup(one.wait)
            self.addCleanup(one.kill)
            all_of_them.append(one)
            hosts[one.pid] = host or os.uname().nodename
        campaign.wait_for(lambda: sum(one.poll() is None for one in all_of_them) <= 1, "nineteen to leave", 60)
        (runner,) = [one for one in all_of_them if one.poll() is None]
        for one in all_of_them:
            if one is not runner:
                said = one.stderr.read()
                self.assertEqual(one.returncode, 5, said)
                self.assertIn(f"softwall on {hosts[runner.pid]}, process {runner.pid},", said)
        self.assertIn(f"process {runner.pid}", campaign.call("status").stdout + campaign.call("run").stderr)
        campaign.wait_for_checkpoint("precursor")
        runner.send_signal(signal.SIGINT)
        self.assertEqual(runner.wait(60), 4)

    def test_a_hanging_solver_is_noticed_and_replaced(self):
        campaign = self.campaign(LONG)
        runner = campaign.start("run", "--stall-minutes", "0.05")
        self.addCleanup(runner.wait)
        self.addCleanup(runner.kill)
        campaign.wait_for_checkpoint("precursor")
        ranks = [pid for pid, (name, _) in campaign.solvers().items() if name.startswith("softwall-dns")]
        os.kill(ranks[0], signal.SIGSTOP)
        campaign.wait_for(lambda: "ending this attempt" in campaign.said(), "the watchdog", 60)
        os.kill(ranks[0], signal.SIGCONT)  # it now obeys the request for a checkpoint
        campaign.wait_for(lambda: campaign.said().count("resumed from") >= 1, "the next attempt", 120)
        outcomes = campaign.query("SELECT outcome FROM attempts ORDER BY attempt")
        self.assertEqual(outcomes[0]["outcome"], "stalled")

    def test_attempts_of_limited_length_add_up_to_the_same_bits(self):
        # Long enough for several attempts however fast the solver is: what the free campaign takes is the measure.
        long = changed(CAMPAIGN, physics=dict(CAMPAIGN["physics"], time_step={"fixed_dt": 0.0002}))
        free = self.campaign(long)
        self.run_to_end(free)
        longest = free.query("SELECT max(wall_seconds) AS s FROM attempts")[0]["s"]
        execution = dict(CAMPAIGN["execution"], walltime_seconds=max(1, int(longest / 2)))
        limited = self.campaign(changed(long, execution=execution))
        self.run_to_end(limited)
        self.assertGreater(limited.query("SELECT max(attempt) AS n FROM attempts")[0]["n"], 1)
        self.assert_same_outcome(limited, free)


if __name__ == "__main__":
    unittest.main(verbosity=2)
