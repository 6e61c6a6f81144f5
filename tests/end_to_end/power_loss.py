"""Campaigns on a disk of their own, of which images are taken at random moments: what the disk holds then is what a power loss
would leave. In each image, when its file system has been mounted and so has read its journal, all must be there that was
acknowledged before, and the campaign must go on to the results of one that nobody disturbed. Started by power_loss.sh."""

import argparse
import json
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from harness import CAMPAIGN, Campaign, changed

LONGER = {"end_time": 1.6, "checkpoint_steps": 20}
DOCUMENT = changed(CAMPAIGN, run=LONGER, precursor={"run": LONGER})
MEGABYTES = 48
TABLES = {"cases": "case_id", "attempts": "case_id || '/' || attempt", "quantities": "case_id || '/' || quantity",
          "checkpoints": "case_id || '/' || path"}  # and what makes a row of each the same row


def call(*words):
    subprocess.run(words, check=True, capture_output=True)


def log(text):
    print(text, file=sys.stderr, flush=True)


def signal_all(processes, what):
    for pid in processes:
        try:
            os.kill(pid, what)
        except ProcessLookupError:
            pass  # it has just ended


class Disk:
    """An image in memory with ext4 on it, mounted."""

    def __init__(self, image=None):
        self.place = Path(tempfile.mkdtemp(prefix="softwall-disk-"))
        self.image = Path(f"/dev/shm/{self.place.name}")
        if image:
            shutil.copyfile(image, self.image)
        else:
            with open(self.image, "wb") as file:
                file.truncate(MEGABYTES << 20)
            call("mkfs.ext4", "-q", "-F", str(self.image))
        call("mount", "-o", "loop", str(self.image), str(self.place))

    def remove(self):
        call("umount", "-l", str(self.place))
        self.image.unlink()
        self.place.rmdir()

    def copy(self, target):
        """At one moment: until two copies in a row are the same. Nobody writes but the file system itself."""
        last = None
        while True:
            shutil.copyfile(self.image, target)
            now = subprocess.run(["cmp", "-s", str(self.image), str(target)], check=False).returncode
            if last == now == 0:
                return
            last = now


def on_disk(campaign, disk):
    """The same campaign, in a folder of this disk."""
    shutil.rmtree(campaign.folder, ignore_errors=True)
    campaign.folder = (disk.place / "campaign").resolve()
    campaign.folder.mkdir(exist_ok=True)
    return campaign


def rows_of(folder):
    """{table: {key: row}} of the store, or nothing where there is none yet."""
    try:
        store = sqlite3.connect(f"file:{folder}/results.db?mode=ro", uri=True)
        return {table: {row[0]: row[1:] for row in store.execute(f"SELECT {key}, * FROM {table}")}
                for table, key in TABLES.items()}
    except sqlite3.OperationalError:
        return {table: {} for table in TABLES}


def checkpoints_told(folder):
    """{case directory: step of the newest checkpoint that its solver has told of}."""
    told = {}
    for file in folder.glob("cases/*/status.json"):
        step = json.loads(file.read_text()).get("checkpoint_step")
        if step and step > 0:
            told[file.parent.name] = step
    return told


class Trial:
    def __init__(self, generator):
        self.generator, self.count, self.rows, self.told = generator, Counter(), 0, 0
        self.reference = Campaign(DOCUMENT)
        start = time.monotonic()
        answer = self.reference.call("run")
        self.seconds = time.monotonic() - start
        if answer.returncode != 0:
            sys.exit(answer.stderr)

    def wrong(self, what, text):
        self.count[what] += 1
        log(f"WRONG: {what}: {text}")

    def images_of_one_campaign(self, most):
        """Runs it to its end, stopped for a moment at random times. How many images there were."""
        disk, taken = Disk(), 0
        campaign = on_disk(Campaign(DOCUMENT), disk)
        campaign.write(DOCUMENT)
        runner = campaign.start("run")
        try:
            while taken < most:
                try:
                    runner.wait(self.generator.uniform(0.02, 0.4 * self.seconds))
                    break
                except subprocess.TimeoutExpired:
                    taken += self.image(disk, campaign, runner)
        finally:
            campaign.kill_all(runner)
            disk.remove()
        return taken

    def image(self, disk, campaign, runner):
        """With all of them stopped, what they had acknowledged is what they have told by now."""
        everybody = [runner.pid, *campaign.solvers()]
        signal_all(everybody, signal.SIGSTOP)
        copy = Path(f"{disk.image}.copy")
        try:
            rows, told = rows_of(campaign.folder), checkpoints_told(campaign.folder)
            disk.copy(copy)
        finally:
            signal_all(everybody, signal.SIGCONT)
        try:
            self.judge(copy, rows, told)
        finally:
            copy.unlink()
        return 1

    def judge(self, copy, rows, told):
        disk = Disk(copy)
        campaign = on_disk(Campaign(DOCUMENT), disk)
        try:
            self.judge_rows(rows, rows_of(campaign.folder))
            self.judge_checkpoints(campaign, told)
            answer = campaign.call("resume")
            if answer.returncode != 0:
                self.wrong("not_finished", f"{answer.returncode}: {answer.stderr}")
            elif (campaign.results(), campaign.final_data()) != (self.reference.results(), self.reference.final_data()):
                self.wrong("other_results", "")
            elif campaign.call("verify").returncode != 0:
                self.wrong("unsound", campaign.call("verify").stdout)
        finally:
            campaign.kill_all()
            disk.remove()

    def judge_rows(self, before, now):
        for table, rows in before.items():
            self.rows += len(rows)
            lost = [key for key, row in rows.items() if now[table].get(key) != row]
            if lost:
                self.wrong("rows_lost", f"{table}: {lost}")

    def judge_checkpoints(self, campaign, told):
        """Of the step that was told, or a later one, and whole."""
        if told and campaign.call("verify").returncode not in (0, 3):
            self.wrong("unsound", "softwall verify does not work")
        for name, step in told.items():
            self.told += 1
            there = sorted((campaign.folder / "cases" / name / "checkpoints").glob("checkpoint-*.h5"))
            if not there or int(there[-1].stem.split("-")[1]) < step:
                self.wrong("checkpoints_lost", f"{name}: {step}, there are {there}")
            damaged = [line for line in campaign.call("verify").stdout.splitlines() if f"{name}/checkpoints/" in line]
            if damaged:
                self.wrong("checkpoints_damaged", damaged)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=random.randrange(2**32))
    parser.add_argument("--images", type=int, default=15)
    options = parser.parse_args()
    start, trial = time.monotonic(), Trial(random.Random(options.seed))
    taken = campaigns = 0
    while taken < options.images:
        taken += trial.images_of_one_campaign(options.images - taken)
        campaigns += 1
        log(f"{taken} images of {campaigns} campaigns")
    trial.reference.remove()
    names = ("checkpoints_lost", "checkpoints_damaged", "rows_lost", "other_results", "not_finished", "unsound")
    wrong = {name: trial.count[name] for name in names}
    verdict = {"images": taken, **wrong, "checkpoints_told": trial.told, "rows_told": trial.rows, "campaigns": campaigns,
               "seed": options.seed, "seconds": round(time.monotonic() - start)}
    print(json.dumps(verdict), flush=True)
    sys.exit(any(wrong.values()))


if __name__ == "__main__":
    main()
