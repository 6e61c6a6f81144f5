"""Drives the real softwall, softwall-dns and mpirun for the end-to-end tests. Nothing is mocked."""

import json
import os
import random
import shutil
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

SOFTWALL = Path(os.environ.get("SOFTWALL", "build/bin/softwall")).resolve()
MARK = b"SOFTWALL_RUN_DIRECTORY="  # in the environment of mpirun and of every rank
HEADER_BYTES = 4096  # of a checkpoint: one JSON object, then the data
WAIT = 300  # seconds; far beyond what anything here takes, so that a hang is a failure
# A shell that runs a test in the background lets it ignore Ctrl-C, and softwall, started so, would ignore it as well.
signal.signal(signal.SIGINT, signal.default_int_handler)

# Small enough for a second or two a case, with everything in it that a campaign has.
CAMPAIGN = {
    "format": 1,
    "name": "small",
    "physics": {
        "domain": {"length_x": 2, "length_z": 1},
        "grid": {"nx": 16, "ny_fluid": 16, "ny_solid": 4, "nz": 8},
        "time_step": {"fixed_dt": 0.002},
        "statistics": {"interval_steps": 5, "block_length": 0.1},
    },
    "precursor": {"run": {"end_time": 0.6, "checkpoint_steps": 20}},
    "sweep": {
        "grid": {"G": [1, 2], "viscosity_ratio": [1]},
        "list": [{"G": 1, "viscosity_ratio": 10}],
    },
    "run": {"end_time": 0.6, "checkpoint_steps": 20},
    "execution": {"ranks": 1, "precursor_ranks": 2, "cores": 2},
}


def changed(document, **members):
    """A deep copy of a campaign with some members replaced."""
    copy = json.loads(json.dumps(document))
    copy.update(members)
    return copy


def stat_of(pid):
    """Fields of /proc/PID/stat from the third on: state, parent, ...; None when there is no such process."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return None


def is_alive(pid):
    """Neither gone nor a zombie."""
    stat = stat_of(pid)
    return stat is not None and stat[0] not in "ZX"


def parent_of(pid):
    stat = stat_of(pid)
    return int(stat[1]) if stat else 0


class Campaign:
    """A campaign in a folder of its own."""

    def __init__(self, document=CAMPAIGN):
        self.environment = None  # of every softwall: that of the test
        self.folder = Path(tempfile.mkdtemp(prefix="softwall-e2e-")).resolve()
        self.write(document)

    def write(self, document):
        text = document if isinstance(document, str) else json.dumps(document, indent=1)
        (self.folder / "campaign.json").write_text(text)

    def remove(self):
        self.kill_all()
        shutil.rmtree(self.folder, ignore_errors=True)

    # -- softwall ---------------------------------------------------------------------------------------------

    def command(self, name, *more):
        return [str(SOFTWALL), name, str(self.folder), *more]

    def call(self, name, *more, **options):
        options = {"env": self.environment, **options}
        return subprocess.run(self.command(name, *more), capture_output=True, text=True, timeout=WAIT, **options)

    def start(self, name="run", *more, **options):
        """softwall in the background; what it says goes to runner.err beside the campaign."""
        options = {"env": self.environment, **options}
        with open(f"{self.folder}.err", "a") as err:
            return subprocess.Popen(
                self.command(name, *more), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=err, **options
            )

    def said(self):
        return Path(f"{self.folder}.err").read_text()

    def query(self, sql):
        answer = self.call("query", sql, "--json")
        if answer.returncode != 0:
            raise AssertionError(answer.stderr)
        return json.loads(answer.stdout)

    def states(self):
        cases = json.loads(self.call("status", "--json").stdout)["cases"]
        return {case["label"]: case["state"] for case in cases}

    # -- its processes ----------------------------------------------------------------------------------------

    def solvers(self):
        """{pid: (command name, run directory)} of every mpirun and rank of this campaign."""
        found = {}
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                settings = (entry / "environ").read_bytes().split(b"\0")
                name = (entry / "comm").read_text().strip()
            except OSError:
                continue
            for setting in settings:
                if setting.startswith(MARK + str(self.folder).encode() + b"/"):
                    found[int(entry.name)] = (name, setting[len(MARK) :].decode())
        return found

    def kill_all(self, runner=None):
        """SIGKILL for the runner, mpirun and all ranks, the runner first so that it cannot react."""
        if runner is not None:
            runner.kill()
        for pid in self.solvers():
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        if runner is not None:
            runner.wait(WAIT)

    def wait_for(self, condition, what, seconds=WAIT):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                raise AssertionError(f"waited {seconds} s for {what}\n{self.said()}")
            time.sleep(0.02)

    def wait_for_checkpoint(self, label):
        """Until the case with this label has written one and goes on."""
        self.wait_for(lambda: any(self.folder.glob(f"cases/{label}-*/checkpoints/checkpoint-*.h5")), f"{label} to run")

    # -- what it left -----------------------------------------------------------------------------------------

    def directory(self, label):
        (found,) = self.folder.glob(f"cases/{label}-????????")
        return found

    def checkpoints(self, label):
        """Newest first."""
        return sorted(self.directory(label).glob("checkpoints/checkpoint-*.h5"), reverse=True)

    def results(self):
        """Every derived number of every case."""
        return self.query("SELECT case_id, quantity, value, ci95 FROM quantities ORDER BY case_id, quantity")

    def final_data(self):
        """{case directory: (name, header's digest, all bytes behind the header) of its last checkpoint}."""
        data = {}
        for directory in sorted(self.folder.glob("cases/*")):
            newest = sorted(directory.glob("checkpoints/checkpoint-*.h5"))[-1]
            contents = newest.read_bytes()
            digest = json.loads(contents[:HEADER_BYTES])["xxh3"]
            data[directory.name] = (newest.name, digest, contents[HEADER_BYTES:])
        return data


class OneSolverOnly(threading.Thread):
    """Watches that never two mpirun work in one run directory."""

    def __init__(self, campaign):
        super().__init__(daemon=True)
        self.campaign, self.over, self.crowded = campaign, threading.Event(), []

    def run(self):
        while not self.over.wait(0.05):
            found = self.campaign.solvers()
            # an mpirun that is about to start a rank is there twice for a moment: count only those without parent
            leaders = [place for pid, (name, place) in found.items()
                       if name == "mpirun" and parent_of(pid) not in found]
            self.crowded += [place for place in leaders if leaders.count(place) > 1]

    def __exit__(self, *_):
        self.over.set()
        self.join()

    def __enter__(self):
        self.start()
        return self


class EndToEndTest(unittest.TestCase):
    def campaign(self, document=CAMPAIGN):
        campaign = Campaign(document)
        self.addCleanup(campaign.remove)
        self.addCleanup(lambda: Path(f"{campaign.folder}.err").unlink(missing_ok=True))
        return campaign

    def run_to_end(self, campaign, name="run"):
        answer = campaign.call(name)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return answer

    def assert_same_outcome(self, campaign, reference):
        """Bit for bit: the last checkpoint of every case, and every result."""
        ours, theirs = campaign.final_data(), reference.final_data()
        self.assertEqual(list(ours), list(theirs))
        for name, (file, digest, data) in theirs.items():
            self.assertEqual(ours[name][0], file, f"another last step in {name}")
            self.assertEqual(ours[name][1], digest, f"other data in {name}")
            self.assertTrue(ours[name][2] == data, f"other bytes in {name}")
        self.assertEqual(campaign.results(), reference.results())
        self.assertGreater(len(reference.results()), 0)

    def assert_sound(self, campaign):
        """Nothing runs, nothing is damaged, nothing is left over."""
        self.assertEqual(campaign.solvers(), {})
        verdict = campaign.call("verify")
        self.assertEqual(verdict.returncode, 0, verdict.stdout + verdict.stderr)
        self.assertEqual(list(campaign.folder.rglob("*.tmp*")), [])


def seeded():
    """A random generator whose seed is told, so that a failure can be repeated."""
    seed = int(os.environ.get("SEED", random.randrange(2**32)))
    print(f"SEED={seed}", flush=True)
    return random.Random(seed)
