"""What a person, or a program in a person's place, asks on the command line: help, formats, errors, a small window."""

import csv
import fcntl
import io
import json
import os
import pty
import re
import struct
import subprocess
import termios
import time
import unittest

from harness import SOFTWALL, EndToEndTest, changed
from test_real_use import RIGID

MANY = changed(RIGID, sweep={"grid": {"seed": list(range(1, 31))}}, run={"end_time": 0.8})


class Terminal:
    """A command in a window of so many lines; what it wrote last, screen by screen."""

    def __init__(self, command, lines):
        self.master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", lines, 100, 0, 0))
        self.process = subprocess.Popen(command, stdin=slave, stdout=slave, stderr=slave)
        os.close(slave)
        self.text = ""

    def read_until(self, condition, seconds=60):
        os.set_blocking(self.master, False)
        end = time.monotonic() + seconds
        while not condition(self.text) and time.monotonic() < end:
            try:
                self.text += os.read(self.master, 65536).decode()
            except BlockingIOError:
                time.sleep(0.02)
            except OSError:  # the other side is closed
                break
        return self.text

    def screens(self):
        return [part for part in self.text.split("\x1b[H\x1b[2J") if part]

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.master)


class CommandLine(EndToEndTest):
    def watch(self, campaign, lines):
        terminal = Terminal(campaign.command("status", "--watch"), lines)
        self.addCleanup(terminal.close)
        return terminal

    def test_a_watch_fits_its_window_and_waits_for_the_run(self):
        campaign = self.campaign(MANY)
        terminal = self.watch(campaign, 16)
        terminal.read_until(lambda text: "Waiting for a run" in text)
        (screen,) = terminal.screens()
        self.assertLessEqual(len(screen.splitlines()), 16)
        self.assertIn("and 22 more cases", screen)
        self.assertIsNone(terminal.process.poll())
        self.run_to_end(campaign)
        self.assertEqual(terminal.process.wait(60), 0)
        terminal.read_until(lambda text: False, 0.5)
        self.assertIn("30/30 finished", terminal.screens()[-1])
        for screen in terminal.screens():
            self.assertLessEqual(len(screen.splitlines()), 16)
        self.assertEqual(len(campaign.call("status").stdout.splitlines()), 33)  # whoever asks without a window gets all

    def test_help_is_a_command(self):
        whole = subprocess.run([SOFTWALL, "help"], capture_output=True, text=True)
        self.assertEqual((whole.returncode, whole.stderr), (0, ""))
        self.assertEqual(whole.stdout, subprocess.run([SOFTWALL, "--help"], capture_output=True, text=True).stdout)
        self.assertIn("--from", subprocess.run([SOFTWALL, "help", "table"], capture_output=True, text=True).stdout)
        wrong = subprocess.run([SOFTWALL, "help", "tabel"], capture_output=True, text=True)
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("no command tabel", wrong.stderr)

    def test_the_solver_tells_its_version(self):
        told = subprocess.run([SOFTWALL.parent / "softwall-dns", "--version"], capture_output=True, text=True)
        self.assertEqual(told.returncode, 0)
        self.assertRegex(told.stdout, r"^softwall-dns \d+\.\d+\.\d+ \(.+\)\n$")

    def test_errors_are_json_where_json_was_asked_for(self):
        campaign = self.campaign(changed(RIGID, physics=dict(RIGID["physics"], grid={"nx": 3, "ny_fluid": 8, "nz": 4})))
        for words, status in ((["plan", str(campaign.folder), "--json"], 2), (["plan", "/nowhere", "--json"], 2),
                              (["status", str(campaign.folder), "--json", "--wotch"], 2),
                              (["query", str(campaign.folder), "SELECT 1", "--json"], 2)):
            answer = subprocess.run([SOFTWALL, *words], capture_output=True, text=True)
            self.assertEqual((answer.returncode, answer.stdout), (status, ""), words)
            error = json.loads(answer.stderr)["error"]
            self.assertEqual(error["status"], status)
            self.assertTrue(error["message"])
        refused = json.loads(campaign.call("plan", "--json").stderr)["error"]["mistakes"]
        self.assertEqual(refused, [{"where": "/physics/grid/nx", "given": "3",
                                    "allowed": "must be an integer from 4 to 100000"}])
        self.assertNotIn("{", campaign.call("plan").stderr)

    def test_results_come_in_every_format(self):
        campaign = self.campaign(changed(RIGID, run={"end_time": 3}))
        ran = self.run_to_end(campaign)
        self.assertRegex(ran.stdout, r"(?m)^case +state +t \[h/U_b\] +Re_tau\^w .* u_max \[U_b\]")
        self.assertRegex(ran.stdout, r"(?m)^rigid_channel +finished +0.5-3 +\S+ (\+- \S+|\(\*\)) ")
        (row,) = json.loads(campaign.call("table", "--json").stdout)
        self.assertEqual((row["label"], row["paper_case"], row["window_start"]), ("rigid_channel", None, 0.5))
        (line,) = csv.DictReader(io.StringIO(campaign.call("table", "--csv").stdout))
        self.assertEqual(float(line["re_tau"]), row["re_tau"])
        latex = campaign.call("table", "--latex").stdout
        self.assertEqual(latex.count("\\begin{tabular}"), 2 * latex.count("% READING"))
        self.assertEqual(campaign.call("table", "--latex", "--csv").returncode, 2)
        (result,) = campaign.query("SELECT core_hours, solver_revision FROM results")
        self.assertGreater(result["core_hours"], 0)
        self.assertTrue(result["solver_revision"])

    def test_a_wrong_column_gets_a_suggestion(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        for sql, words in (("SELECT re_tua FROM results", "did you mean re_tau?"),
                           ("SELECT r.lable FROM results r", "did you mean label?"),
                           ("SELECT * FROM result", "did you mean results?"),
                           ("SELECT nothing_like_it FROM results", "FROM documentation lists all columns")):
            answer = campaign.call("query", sql)
            self.assertEqual(answer.returncode, 2)
            self.assertIn(words, answer.stderr)
            self.assertEqual(len(re.findall("no such", answer.stderr)), 1)

    def test_results_of_an_interrupted_case_are_there(self):
        campaign = self.campaign(changed(RIGID, run={"end_time": 1e6, "checkpoint_steps": 100}))
        runner = campaign.start()
        campaign.wait_for(lambda: self.windows(campaign), "results before the end")
        ((state, end),) = self.windows(campaign)
        self.assertEqual(state, "running")
        runner.send_signal(2)
        self.assertEqual(runner.wait(60), 4)
        ((state, later),) = self.windows(campaign)
        self.assertEqual(state, "interrupted")
        self.assertGreater(later, end)

    def test_a_case_short_of_its_window_can_be_looked_at_from_an_earlier_time(self):
        late = dict(RIGID["physics"], statistics=dict(RIGID["physics"]["statistics"], start_time=5e5))
        campaign = self.campaign(changed(RIGID, physics=late, run={"end_time": 1e6, "checkpoint_steps": 100}))
        runner = campaign.start()
        campaign.wait_for(lambda: list(campaign.folder.glob("cases/*/statistics.h5")), "statistics")
        runner.send_signal(2)
        self.assertEqual(runner.wait(60), 4)
        self.assertEqual(self.windows(campaign), [])
        looked_at = campaign.call("query", "SELECT window_start, re_tau FROM results", "--json", "--from", "0.5")
        (row,) = json.loads(looked_at.stdout)
        self.assertEqual(row["window_start"], 0.5)
        self.assertGreater(row["re_tau"], 0)

    def windows(self, campaign):
        answer = campaign.call("query", "SELECT state, window_end FROM results WHERE re_tau > 0", "--json")
        return [tuple(row.values()) for row in json.loads(answer.stdout)] if answer.returncode == 0 else []


if __name__ == "__main__":
    unittest.main()
