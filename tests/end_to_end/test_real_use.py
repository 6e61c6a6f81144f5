"""What a person does with a campaign over its life: changes its file, asks for tables, names things oddly."""

import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

from harness import SOFTWALL, EndToEndTest, changed

RIGID = {
    "format": 1,
    "name": "rigid",
    "physics": {
        "flow": "rigid_channel",
        "reynolds": 100,
        "grid": {"nx": 8, "ny_fluid": 8, "nz": 4},
        "time_step": {"fixed_dt": 0.1},
        "statistics": {"start_time": 0.5, "block_length": 0.25, "interval_steps": 1},
    },
    "run": {"end_time": 1, "field_interval": 0.1},
    "execution": {"ranks": 1, "cores": 1},
}

SWEEP = changed(
    RIGID,
    physics={"grid": {"nx": 16, "ny_fluid": 16, "ny_solid": 4, "nz": 8}, "domain": {"length_x": 2, "length_z": 1},
             "time_step": {"fixed_dt": 0.002}, "statistics": {"interval_steps": 5, "block_length": 0.1}},
    sweep={"grid": {"G": [1, 4]}}, run={"end_time": 0.8, "checkpoint_steps": 20}, execution={"ranks": 1, "cores": 2})

# Of each table of a store: the columns that say when the store itself learned of something, or how the launcher would
# find an attempt that is over. No folder keeps them.
OF_THE_STORE_ITSELF = {
    "campaign": ("created", "updated"),
    "cases": ("state_since", "created", "forgiven"),
    "attempts": ("intended", "handle"),
    "diagnostics": (),
    "checkpoints": ("first_seen", "seen"),
    "quantities": ("recorded",),
}


def stored(campaign):
    """{table: rows} without those columns, and without checkpoints that are gone."""
    tables = {}
    for table, columns in OF_THE_STORE_ITSELF.items():
        rows = campaign.query(f"SELECT * FROM {table}" + (" WHERE present" if table == "checkpoints" else ""))
        kept = [{name: value for name, value in row.items() if name not in columns} for row in rows]
        tables[table] = sorted(kept, key=lambda row: json.dumps(row, sort_keys=True))
    return tables


class RealUse(EndToEndTest):
    def test_steps_of_a_tenth_end_at_one(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        (case,) = json.loads(campaign.call("status", "--json").stdout)["cases"]
        self.assertEqual(case["step"], 10)
        snapshots = sorted(campaign.folder.glob("cases/*/fields/*.h5"))
        self.assertEqual(len(snapshots), 11, f"ten and the initial state, not {snapshots}")
        (directory,) = campaign.folder.glob("cases/*")
        collection = (directory / "fields/fields.xdmf").read_text()
        times = [float(time) for time in re.findall(r'<Time Value="([^"]+)"/>', collection)]
        self.assertEqual([round(time, 9) for time in times], [step / 10 for step in range(11)])

        with self.subTest("the newest checkpoint becomes a snapshot without a step"):
            snapshots[-1].unlink()
            before = (directory / "summary.json").read_text(), (directory / "status.json").read_text()
            solver = SOFTWALL.parent / "softwall-dns"
            made = subprocess.run(["mpirun", "--oversubscribe", "-n", "2", solver, directory, "--snapshot"],
                                  capture_output=True, text=True)
            self.assertEqual(made.returncode, 0, made.stderr)
            self.assertTrue(snapshots[-1].exists())
            self.assertEqual(((directory / "summary.json").read_text(), (directory / "status.json").read_text()), before)
            self.assertEqual((directory / "fields/fields.xdmf").read_text(), collection)
            self.assert_sound(campaign)
        with self.subTest("no snapshot is made of an initial state that nobody computed"):
            with tempfile.TemporaryDirectory() as elsewhere:
                shutil.copy(directory / "case.json", elsewhere)
                made = subprocess.run([solver, elsewhere, "--snapshot"], capture_output=True, text=True)
                self.assertNotEqual(made.returncode, 0)
                self.assertIn("no checkpoint of which to make a snapshot", made.stderr)
                self.assertEqual(list(Path(elsewhere).glob("fields/*.h5")), [])
        (row,) = campaign.query("SELECT window_start, window_end, end_time FROM results")
        self.assertEqual(row["window_start"], 0.5)
        self.assertLessEqual(row["window_end"], row["end_time"] * (1 + 1e-9))
        self.assertAlmostEqual(row["window_end"], 1.0, 9)

    def test_an_end_that_was_lowered_is_a_hundred_percent(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        campaign.write(changed(RIGID, run={"end_time": 0.7}))
        self.assertRegex(campaign.call("status").stdout, r"finished +1 +0\.7 +100 ")

    def test_plan_and_run_refuse_in_the_same_words(self):
        for change, words in (
            ({"execution": {"ranks": 7, "cores": 8}}, "cannot be shared among 7 ranks"),
            ({"execution": {"ranks": 100000}}, "/execution/ranks: 100000; this machine has"),
            ({"physics": dict(RIGID["physics"], grid={"nx": 100000, "ny_fluid": 100000, "nz": 1000})}, "GB of memory"),
        ):
            with self.subTest(words):
                campaign = self.campaign(changed(RIGID, **change))
                plan, run = campaign.call("plan"), campaign.call("run")
                self.assertEqual((plan.returncode, run.returncode), (0, 2))
                self.assertIn(words, run.stderr)
                free = re.compile(r"[\d.]+ .?B free")  # others write to the same disk
                self.assertEqual(free.sub("", plan.stderr), free.sub("", run.stderr))
                self.assertIn(" blocked ", plan.stdout)
                plan = campaign.call("plan", "--json")
                self.assertEqual((plan.returncode, plan.stderr), (0, ""))
                refused = json.loads(plan.stdout)["refused"]
                self.assertIn(words, "".join(f"{one['where']}: {one['given']}; {one['allowed']}\n" for one in refused))
                self.assertEqual(list(campaign.folder.glob("cases")), [])

    def test_plan_says_what_it_would_take(self):
        campaign = self.campaign(RIGID)
        plan = campaign.call("plan")
        self.assertEqual(plan.returncode, 0, plan.stderr)
        self.assertRegex(plan.stdout, r"On 1 core of this machine: about .*; memory .* of .* GB; "
                                      r"disk for checkpoints \S+ GB, 11 snapshots \S+ GB, free")
        self.run_to_end(campaign)
        self.assertEqual(len(list(campaign.folder.glob("cases/*/fields/fields-*.h5"))), 11)
        self.assertIn("disk for checkpoints 0 GB, free", campaign.call("plan").stdout)
        # What is finished needs neither a solver nor mpirun to be analysed again.
        for settings in ({"SOFTWALL_DNS": "/no/such/solver"}, {"PATH": "/no/such"}):
            again = campaign.call("run", env={**os.environ, **settings})
            self.assertEqual(again.returncode, 0, again.stderr)

    def test_what_a_change_leaves_behind_is_told_and_kept_apart(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        (old,) = campaign.query("SELECT case_id FROM results")
        changed_physics = dict(RIGID["physics"], statistics={"start_time": 0.5, "block_length": 0.25, "interval_steps": 2})
        campaign.write(changed(RIGID, physics=changed_physics))
        plan = campaign.call("plan").stdout
        self.assertIn("Left behind", plan)
        self.assertIn("but statistics.interval_steps 1 instead of 2", plan)
        self.run_to_end(campaign)
        self.assertEqual(len(campaign.query("SELECT * FROM results")), 1)
        self.assertEqual(len(campaign.query("SELECT * FROM results_all")), 2)
        export = campaign.call("export", "--csv")
        self.assertEqual(len(export.stdout.splitlines()), 2)
        self.assertIn("Left out: 1 case", export.stderr)

        hours = "SELECT case_id, round(sum(core_hours), 12) AS hours FROM attempt_history GROUP BY case_id"
        before = campaign.query(hours)
        self.assertEqual(campaign.call("rebuild").returncode, 0)
        self.assertEqual(campaign.query(hours), before)  # also of the case that left
        self.assertEqual(len(campaign.query("SELECT * FROM results_all WHERE in_campaign = 0 AND re_tau > 0")), 1)

        self.assertIn("rigid_channel", campaign.call("clean").stdout)
        self.assertEqual(len(list(campaign.folder.glob("cases/*"))), 2)
        self.assertEqual(campaign.call("clean", "--remove").returncode, 0)
        (left,) = campaign.folder.glob("cases/*")
        self.assertFalse(left.name.endswith(old["case_id"][:8]))
        self.assertEqual(len(campaign.query("SELECT * FROM results_all")), 1)
        self.assertIn("Nothing is left over", campaign.call("clean").stdout)

    def test_what_was_left_can_be_removed_before_the_next_run(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        changed_physics = dict(RIGID["physics"], statistics={"start_time": 0.5, "block_length": 0.25, "interval_steps": 2})
        campaign.write(changed(RIGID, physics=changed_physics))
        (case,) = campaign.folder.glob("cases/*")

        pilot = campaign.folder / "pilot.json"  # asks for what the campaign no longer asks for
        pilot.write_text(json.dumps(RIGID))
        self.assertIn("Kept for pilot.json, which asks for them: 1 case.", campaign.call("clean").stdout)
        self.assertNotIn("Left behind", campaign.call("plan").stdout)
        self.assertIn("0 cases removed", campaign.call("clean", "--remove").stdout)
        pilot.write_text(json.dumps(RIGID)[:-1])
        refused = campaign.call("clean", "--remove")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("pilot.json: a campaign file that cannot be read", refused.stderr)
        self.assertTrue((case / "case.json").exists())
        pilot.unlink()
        pilot.symlink_to(campaign.folder / "on-a-disk-that-is-away.json")
        self.assertEqual(campaign.call("clean", "--remove").returncode, 2)
        pilot.unlink()
        pilot = campaign.folder / "pilot.txt"
        pilot.write_text(json.dumps(RIGID))
        self.assertIn("Kept for pilot.txt", campaign.call("clean").stdout)
        pilot.unlink()

        (campaign.folder / "cases" / "notes").mkdir()
        rest = case.with_name(".removed-" + case.name)  # of a removal that was killed
        shutil.copytree(case, rest)
        listed = campaign.call("clean").stdout
        self.assertIn(f"{rest.name}: the rest of a case", listed)
        self.assertIn("cases/notes: without a case.json", listed)
        self.assertEqual(campaign.call("clean", "--remove").returncode, 0)
        self.assertEqual([each.name for each in campaign.folder.glob("cases/*")], ["notes"])
        (campaign.folder / "cases" / "notes").rmdir()
        (row,) = campaign.query("SELECT state, in_campaign FROM results_all")
        self.assertEqual((row["state"], row["in_campaign"]), ("new", 1))
        self.assertEqual(campaign.call("verify").returncode, 0)

    def test_old_checkpoints_of_a_finished_case_may_be_removed(self):
        campaign = self.campaign(changed(RIGID, run={"end_time": 1, "checkpoint_steps": 2, "keep_checkpoints": 3}))
        self.run_to_end(campaign)
        *old, _ = sorted(campaign.folder.glob("cases/*/checkpoints/*.h5"))
        self.assertTrue(old)
        for checkpoint in old:
            checkpoint.unlink()
        self.run_to_end(campaign)
        self.assertEqual(len(campaign.query("SELECT * FROM checkpoints WHERE present = 1")), 1)
        self.assertEqual(campaign.call("verify").returncode, 0)

    def test_a_store_made_again_is_the_one_that_was_lost(self):
        """After attempts that were killed and interrupted, a damaged checkpoint, and a case that was left over."""
        campaign = self.campaign(SWEEP)
        runner = campaign.start()
        campaign.wait_for_checkpoint("G=1")
        campaign.wait_for(lambda: len(campaign.checkpoints("G=1")) > 1, "another checkpoint")
        (rank,) = [pid for pid, (name, place) in campaign.solvers().items() if name.startswith("softwall-dns") and "/G=1-" in place]
        os.kill(rank, signal.SIGKILL)
        campaign.wait_for(lambda: "attempt failed" in campaign.said(), "the end of an attempt")
        runner.send_signal(signal.SIGINT)
        self.assertIn(runner.wait(60), (0, 4), campaign.said())
        self.run_to_end(campaign)
        newest = campaign.checkpoints("G=1")[0]
        newest.write_bytes(newest.read_bytes()[:-1])
        campaign.write(changed(SWEEP, sweep={"grid": {"G": [1, 2]}}, run={"end_time": 0.9, "checkpoint_steps": 20}))
        self.run_to_end(campaign, "resume")
        self.assertEqual(len(list(campaign.folder.glob("cases/*/checkpoints/*.bad"))), 1)
        before = stored(campaign)
        self.assertEqual(len(before["cases"]), 3)
        self.assertGreaterEqual(len(before["attempts"]), 4)
        self.assertEqual([row["in_campaign"] for row in before["cases"]].count(0), 1)
        for command in ("rebuild", "run"):
            for file in campaign.folder.glob("results.db*"):
                file.unlink()
            self.run_to_end(campaign, command)
            after = stored(campaign)
            for table, rows in before.items():
                self.assertEqual(after[table], rows, f"{table} after {command}")

    def test_an_output_that_cannot_be_written_is_an_error(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        for words in (["plan"], ["status"], ["table"], ["verify"], ["export", "--csv"], ["query", "SELECT 1"]):
            with self.subTest(words), open("/dev/full", "w") as full:
                answer = subprocess.run(campaign.command(words[0], *words[1:]), stdout=full, stderr=subprocess.PIPE)
                self.assertEqual(answer.returncode, 1, answer.stderr)
                self.assertIn(b"standard output", answer.stderr)
        with open("/dev/full", "w") as full:
            again = subprocess.run(campaign.command("run"), stdout=full, stderr=subprocess.PIPE)
            self.assertEqual(again.returncode, 0, "what was computed is there")
            self.assertIn(b"standard output", again.stderr)
            version = subprocess.run([Path(SOFTWALL).parent / "softwall-dns", "--version"], stdout=full, stderr=subprocess.PIPE)
            self.assertEqual(version.returncode, 1)

    def test_an_export_goes_to_what_is_named(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        link, target = campaign.folder / "link.csv", campaign.folder / "target.csv"
        link.symlink_to("target.csv")
        self.assertEqual(campaign.call("export", "--csv", "-o", str(link)).returncode, 0)
        self.assertTrue(link.is_symlink())
        self.assertIn("rigid_channel", target.read_text())
        self.assertEqual(campaign.call("export", "--csv", "-o", "/dev/null").returncode, 0)
        for own in ("results.db", "campaign.json", "cases/x.csv"):
            for words in (("export", "--csv"), ("report",), ("figures",)):
                self.assertEqual(campaign.call(*words, "-o", str(campaign.folder / own)).returncode, 2, own)
        self.assertEqual(len(campaign.query("SELECT * FROM results")), 1)

    def test_results_are_those_of_the_campaign_file_that_was_run(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        other = campaign.folder / "other.json"
        other.write_text(json.dumps(changed(RIGID, name="other")))
        for path, told in ((campaign.folder, False), (campaign.folder / "campaign.json", False), (other, True)):
            for words in (["table"], ["export", "--csv"], ["query", "SELECT 1"]):
                answer = subprocess.run([SOFTWALL, words[0], str(path), *words[1:]], capture_output=True, text=True)
                self.assertEqual(answer.returncode, 0, answer.stderr)
                self.assertEqual("as it was last run" in answer.stderr, told, answer.stderr)
        missing = subprocess.run([SOFTWALL, "table", str(campaign.folder / "none.json")], capture_output=True, text=True)
        self.assertEqual(missing.returncode, 2)
        self.assertIn("there is no such file", missing.stderr)
        relative = subprocess.run([SOFTWALL, "export", ".", "--csv", "-o", "new.csv"], cwd=campaign.folder, stderr=subprocess.DEVNULL)
        self.assertEqual(relative.returncode, 0)
        own = subprocess.run([SOFTWALL, "export", ".", "--csv", "-o", "cases/new.csv"], cwd=campaign.folder, stderr=subprocess.DEVNULL)
        self.assertEqual(own.returncode, 2)

    def test_strange_names_reach_no_terminal_and_commands_can_be_copied(self):
        campaign = self.campaign(changed(RIGID, name="a\n\x1b[31mred", run={"end_time": 0.8}))
        folder = campaign.folder / "soft walls; $(touch pwned)"
        folder.mkdir()
        file = folder / "my sweep.json"
        (campaign.folder / "campaign.json").rename(file)
        shutil.copy(file, folder / "campaign.json")  # another one beside it must not be meant
        ran = subprocess.run([SOFTWALL, "run", str(file)], capture_output=True, text=True, cwd=campaign.folder)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        for text in (ran.stdout, ran.stderr, (folder / "manager.log").read_text()):
            self.assertNotIn("\x1b", text)
        file.write_text(json.dumps(changed(json.loads(file.read_text()), run={"end_time": 0.9})))
        said = subprocess.run([SOFTWALL, "status", str(file)], capture_output=True, text=True).stdout
        self.assertNotIn("\x1b", said)
        command = said.split("To go on:")[1].strip().replace("softwall", str(SOFTWALL), 1)
        again = subprocess.run(["bash", "-c", command], capture_output=True, text=True, cwd=campaign.folder)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertFalse((campaign.folder / "pwned").exists())
        now = json.loads(subprocess.run([SOFTWALL, "status", str(file), "--json"], capture_output=True).stdout)
        self.assertEqual(now["cases"][0]["step"], 9)

    def test_advice_fits_the_trouble_of_the_store(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        store = campaign.folder / "results.db"
        good = store.read_bytes()
        newer = bytearray(good)
        newer[60:64] = (999).to_bytes(4, "big")  # user_version
        store.write_bytes(newer)
        for command in ("run", "rebuild"):
            answer = campaign.call(command)
            self.assertEqual(answer.returncode, 1)
            self.assertIn("newer softwall", answer.stderr)
            self.assertNotIn("softwall rebuild", answer.stderr)
        self.assertEqual(store.read_bytes(), bytes(newer))
        store.write_bytes(b"")
        answer = campaign.call("query", "SELECT 1")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("softwall rebuild", answer.stderr)
        self.assertEqual(campaign.call("rebuild").returncode, 0)
        self.assertEqual(len(campaign.query("SELECT * FROM results WHERE re_tau > 0")), 1)

    def test_a_lost_store_with_its_log_still_there_can_be_rebuilt(self):
        campaign = self.campaign(RIGID)
        self.run_to_end(campaign)
        (campaign.folder / "results.db").rename(campaign.folder / "results.db-wal")
        self.assertEqual(campaign.call("rebuild").returncode, 0)
        self.assertEqual(len(campaign.query("SELECT * FROM results WHERE re_tau > 0")), 1)

    def test_a_stopped_run_says_that_it_was_asked(self):
        campaign = self.campaign(changed(RIGID, run={"end_time": 1e6, "checkpoint_steps": 100}))
        runner = campaign.start()
        campaign.wait_for_checkpoint("rigid_channel")
        runner.send_signal(2)
        self.assertEqual(runner.wait(60), 4)
        self.assertIn("stopped on request", campaign.said())
        self.assertNotIn("signal 10", campaign.said())


if __name__ == "__main__":
    unittest.main()
