"""Kill things at random moments; `softwall resume` must finish with the bits of an undisturbed campaign."""

import os
import signal
import subprocess
import time
import unittest

from harness import CAMPAIGN, Campaign, EndToEndTest, OneSolverOnly, changed, is_alive, seeded


class Crash(EndToEndTest):
    @classmethod
    def setUpClass(cls):
        cls.reference = Campaign()
        start = time.monotonic()
        answer = cls.reference.call("run")
        cls.undisturbed_seconds = time.monotonic() - start
        assert answer.returncode == 0, answer.stderr

    @classmethod
    def tearDownClass(cls):
        cls.reference.remove()

    def crash_repeatedly(self, times, crash):
        """Starts the campaign again and again, each time crashed at a random moment; then lets it finish."""
        random = seeded()
        campaign = self.campaign()
        with OneSolverOnly(campaign) as watch:
            for _ in range(times):
                runner = campaign.start("resume")
                time.sleep(random.uniform(0.05, 0.5 * self.undisturbed_seconds))
                crash(campaign, runner, random)
                runner.kill()
                runner.wait()
            self.run_to_end(campaign, "resume")
        self.assertEqual(watch.crowded, [])
        self.assert_same_outcome(campaign, self.reference)
        self.assert_sound(campaign)

    def test_everything_killed_at_ten_random_moments(self):
        self.crash_repeatedly(10, lambda campaign, runner, random: campaign.kill_all(runner))

    def test_only_the_runner_killed_and_resumed_at_once(self):
        self.crash_repeatedly(5, lambda campaign, runner, random: runner.kill())

    def test_a_random_process_killed(self):
        def crash(campaign, runner, random):
            processes = sorted(campaign.solvers())
            if processes:
                try:
                    os.kill(random.choice(processes), signal.SIGKILL)
                except ProcessLookupError:
                    pass
            time.sleep(random.uniform(0, 2))

        self.crash_repeatedly(5, crash)

    def test_killed_while_recovering(self):
        def crash(campaign, runner, random):
            runner.kill()
            for _ in range(3):
                again = campaign.start("resume")
                time.sleep(random.uniform(0.02, 0.5))
                again.kill()
                again.wait()

        self.crash_repeatedly(3, crash)

    def test_solvers_of_a_killed_runner_write_a_checkpoint_and_end(self):
        campaign = self.campaign(changed(CAMPAIGN, precursor={"run": {"end_time": 60, "checkpoint_steps": 20}}))
        runner = campaign.start()
        campaign.wait_for_checkpoint("precursor")
        solvers = list(campaign.solvers())
        runner.kill()
        runner.wait()
        campaign.wait_for(lambda: not any(map(is_alive, solvers)), "the solvers to end by themselves", 60)
        self.assertEqual(campaign.states()["precursor"], "interrupted")
        summary = next(campaign.folder.glob("cases/precursor-*/summary.json")).read_text()
        self.assertIn('"interrupted"', summary)

    def test_nothing_is_left_in_temporary_folders(self):
        def leftovers():
            found = subprocess.run(["find", "/dev/shm", "/tmp", "-maxdepth", "1", "-name", f"softwall-{os.getuid()}-*"],
                                   capture_output=True, text=True, check=False)
            return set(found.stdout.split())

        before = leftovers()
        campaign = self.campaign()
        runner = campaign.start()
        campaign.wait_for_checkpoint("precursor")
        campaign.kill_all(runner)
        self.assertGreater(len(leftovers() - before), 0, "the test needs something to be swept")
        self.run_to_end(campaign, "resume")
        self.assertEqual(leftovers() - before, set())


if __name__ == "__main__":
    unittest.main(verbosity=2)
