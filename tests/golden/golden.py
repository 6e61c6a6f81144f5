"""What a set of golden files says to the programs of a build: shared by the test and by what makes a new set."""

import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOFTWALL = os.environ.get("SOFTWALL", "build/bin/softwall")
GOLDEN_VALUES = os.environ.get("GOLDEN_VALUES", "build/bin/golden_values")


def sets():
    return sorted(path.parent for path in HERE.glob("set-*/known.json"))


def call(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=200, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: exit status {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


class Copy:
    """A campaign of a set in a folder of its own, where softwall may write."""

    def __init__(self, folder):
        self.outer = Path(tempfile.mkdtemp(prefix="softwall-golden-"))
        self.folder = self.outer / "campaign"
        shutil.copytree(folder, self.folder)

    def remove(self):
        shutil.rmtree(self.outer, ignore_errors=True)

    def softwall(self, name, *more):
        return call(SOFTWALL, name, self.folder, *more)


def values_of(folder):
    """What today's readers find in the run directories, the store and the campaign file of a set."""
    copy = Copy(folder)
    try:
        return {
            "run directories": json.loads(call(GOLDEN_VALUES, *sorted((copy.folder / "cases").iterdir()))),
            "results": json.loads(copy.softwall("export", "--json")),
            "attempts": json.loads(copy.softwall("query", "SELECT * FROM attempts", "--json")),
            "checkpoints": json.loads(copy.softwall("query", "SELECT * FROM checkpoints", "--json")),
            "plan": {case["label"]: case["outlook"]
                     for case in json.loads(copy.softwall("plan", "--json"))["cases"]},
        }
    finally:
        copy.remove()
