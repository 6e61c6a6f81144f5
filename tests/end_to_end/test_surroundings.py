"""What a process inherits or finds around it: signals, descriptors, variables, limits, links."""

import json
import os
import resource
import signal
import subprocess
import time
import unittest
from pathlib import Path

from harness import SOFTWALL, EndToEndTest, changed

SHORT = {
    "format": 1,
    "name": "surroundings",
    "physics": {
        "flow": "rigid_channel",
        "reynolds": 100,
        "grid": {"nx": 8, "ny_fluid": 8, "nz": 4},
        "statistics": {"start_time": 0.5, "block_length": 0.25, "interval_steps": 1},
    },
    "run": {"end_time": 2},
    "execution": {"ranks": 2, "cores": 2},
}
LONG = changed(
    SHORT,
    physics=dict(SHORT["physics"], grid={"nx": 32, "ny_fluid": 32, "nz": 16}, reynolds=1000),
    run={"end_time": 20000, "checkpoint_steps": 5},
    execution={"ranks": 1, "cores": 1},
)


def ignore(*signals):
    for one in signals:
        signal.signal(one, signal.SIG_IGN)


class Surroundings(EndToEndTest):
    def start(self, command, campaign, **options):
        with open(f"{campaign.folder}.err", "a") as err:
            runner = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=err, **options)
        self.addCleanup(runner.wait)
        self.addCleanup(runner.kill)
        return runner

    def test_a_signal_that_was_ignored_stays_ignored(self):
        campaign = self.campaign(LONG)
        runner = self.start(campaign.command("run"), campaign, preexec_fn=lambda: ignore(signal.SIGHUP))
        campaign.wait_for_checkpoint("rigid_channel")
        runner.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        self.assertIsNone(runner.poll())
        self.assertTrue(campaign.solvers())
        runner.send_signal(signal.SIGINT)
        self.assertEqual(runner.wait(60), 4)

    def test_a_campaign_behind_a_link_hears_of_a_stop(self):
        campaign = self.campaign(LONG)
        link = Path(f"{campaign.folder}-link")
        link.symlink_to(campaign.folder)
        self.addCleanup(link.unlink)
        runner = self.start([str(SOFTWALL), "run", str(link)], campaign)
        campaign.wait_for_checkpoint("rigid_channel")
        runner.send_signal(signal.SIGINT)
        self.assertEqual(runner.wait(60), 4, campaign.said())
        self.assertEqual(campaign.solvers(), {})
        self.assertIn("interrupted", campaign.states().values())

    def test_an_attempt_is_local_and_has_what_mpirun_needs(self):
        campaign = self.campaign(SHORT)
        hosts = campaign.folder / "hosts"
        hosts.write_text("localhost slots=1\n")
        allocation = {"SLURM_JOB_ID": "7", "SLURM_NODELIST": os.uname().nodename, "SLURM_TASKS_PER_NODE": "1",
                      "OMPI_MCA_orte_default_hostfile": str(hosts), "PMIX_NAMESPACE": "1", "TMPDIR": "relative"}
        answer = campaign.call("run", env=allocation, preexec_fn=lambda: ignore(signal.SIGCHLD))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        (log,) = campaign.folder.glob("cases/*/solver.log")
        self.assertNotIn("error", log.read_text().lower())

    def test_messages_go_into_no_file_that_is_opened_later(self):
        campaign = self.campaign(SHORT)
        closed = subprocess.run(campaign.command("run"), preexec_fn=lambda: (os.close(1), os.close(2)))
        self.assertEqual(closed.returncode, 0)
        self.assertIn("process", json.loads((campaign.folder / "campaign.lock").read_text()))

    def test_mpirun_that_cannot_start_anything_is_told_once_in_its_words(self):
        campaign = self.campaign(SHORT)
        limited = campaign.call("run", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (20, 20)))
        self.assertEqual(limited.returncode, 2, limited.stderr)
        self.assertIn("cannot start 2 ranks", limited.stderr)
        other = campaign.folder / "mpirun"
        other.write_text("#!/bin/sh\necho 'unrecognized argument use-hwthread-cpus' >&2\nexit 255\n")
        other.chmod(0o755)
        path = f"{campaign.folder}:{os.environ['PATH']}"
        for command in ("run", "plan"):
            answer = campaign.call(command, env={**os.environ, "PATH": path})
            self.assertIn("exit status 255: unrecognized argument use-hwthread-cpus", answer.stderr)
        other.write_text("#!/bin/sh\nexit 0\n")
        idle = campaign.call("run", env={**os.environ, "PATH": path})
        self.assertEqual(idle.returncode, 2, idle.stderr)
        self.assertIn("it ends at once and starts nothing", idle.stderr)
        self.assertEqual(list(campaign.folder.glob("cases")), [])

    def test_a_limit_on_the_size_of_files_is_an_error_that_is_told(self):
        campaign = self.campaign(SHORT)
        limited = campaign.call("run", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20480, 20480)))
        self.assertGreater(limited.returncode, 0, "not a signal")
        self.assertIn("softwall", limited.stderr)
        self.run_to_end(campaign)

    def test_a_relative_path_from_a_deleted_folder_is_explained(self):
        campaign = self.campaign(SHORT)
        gone = campaign.folder / "gone"
        gone.mkdir()
        answer = subprocess.run(["sh", "-c", f'cd "$0" && rmdir "$0" && exec "$@"', gone, SOFTWALL, "status", "../campaign.json"],
                                capture_output=True, text=True)
        self.assertEqual(answer.returncode, 2, answer.stderr)
        self.assertIn("the current folder is not there any more", answer.stderr)

    def test_what_an_earlier_process_of_this_number_left_is_in_nobodys_way(self):
        campaign = self.campaign(SHORT)
        answer = subprocess.run(["sh", "-c", 'touch "$1/.softwall-$$" && exec "$0" run "$1"', SOFTWALL, campaign.folder],
                                capture_output=True, text=True, env={**os.environ, "SOFTWALL_DNS": "/no/such/solver"})
        self.assertEqual(answer.returncode, 2, answer.stderr)
        self.assertIn("/no/such/solver", answer.stderr)

    def test_the_solver_alone_writes_a_checkpoint_when_its_terminal_is_closed(self):
        campaign = self.campaign(LONG)
        runner = self.start(campaign.command("run"), campaign)
        campaign.wait_for_checkpoint("rigid_channel")
        runner.send_signal(signal.SIGINT)
        self.assertEqual(runner.wait(60), 4)
        folder = campaign.directory("rigid_channel")
        before = json.loads((folder / "summary.json").read_text())["step"]
        solver = subprocess.Popen([SOFTWALL.parent / "softwall-dns", folder], stdout=subprocess.DEVNULL)
        self.addCleanup(solver.kill)
        campaign.wait_for(lambda: json.loads((folder / "status.json").read_text())["step"] > before, "a step", 30)
        solver.send_signal(signal.SIGHUP)
        self.assertEqual(solver.wait(60), 85)
        self.assertIn("SIGHUP", json.loads((folder / "summary.json").read_text())["reason"])

    def test_statistics_that_are_lost_are_made_again(self):
        campaign = self.campaign(SHORT)
        self.run_to_end(campaign)
        (file,) = campaign.folder.glob("cases/*/statistics.h5")
        results, contents = campaign.results(), file.read_bytes()
        for damage in (lambda: os.truncate(file, len(contents) - 1), file.unlink):
            damage()
            self.run_to_end(campaign, "resume")
            self.assertEqual(file.read_bytes(), contents)
            self.assertEqual(campaign.results(), results)

    def test_a_case_file_that_is_lost_is_written_again(self):
        campaign = self.campaign(SHORT)
        self.run_to_end(campaign)
        (file,) = campaign.folder.glob("cases/*/case.json")
        contents = file.read_bytes()
        for damage in (file.unlink, lambda: file.write_bytes(b"{")):
            damage()
            self.assertEqual(campaign.call("verify").returncode, 3)
            self.run_to_end(campaign, "resume")
            self.assertEqual(file.read_bytes(), contents)
            self.assert_sound(campaign)


if __name__ == "__main__":
    unittest.main(verbosity=2)
