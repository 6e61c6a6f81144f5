"""Small campaigns under random faults: no result may be lost or computed twice at once, nothing may hang, `softwall resume` is
all that anybody does, and the results are those of a campaign that nobody disturbed, bit for bit. Started by chaos.sh."""

import argparse
import contextlib
import json
import random
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from typing import NamedTuple

from failing_io import LIBRARY, FailingIo
from faults import FAULTS
from harness import CAMPAIGN, Campaign, OneSolverOnly, changed

LONGER = {"end_time": 1.6, "checkpoint_steps": 20}
DOCUMENT = changed(CAMPAIGN, run=LONGER, precursor={"run": LONGER})
DISK = "24m"
TRIES = 6  # resumes without a fault, after which a person would have to do something


def log(text):
    print(f"[{time.monotonic() - log.start:7.1f} s] {text}", file=sys.stderr, flush=True)


log.start = time.monotonic()


class Setting(NamedTuple):
    """What is run, and what may happen to it."""

    document: dict
    faults: list
    pauses: tuple  # seconds between two faults: shortest, longest
    patience: float  # seconds that nothing here takes: more is a hang
    cluster: object = None  # a Slurm, where attempts are its jobs


ON_THIS_MACHINE = Setting(DOCUMENT, FAULTS, (0.05, 0.9), 120)


@contextlib.contextmanager
def under_slurm(cases_per_job):
    """A solver killed without a word is waited for for a minute and a half, and that may happen to one after the other."""
    import slurm_faults  # needs nothing of Slurm's before it is asked for

    cluster = slurm_faults.TendedCluster()
    try:
        slurm = {"partition": "main", "cases_per_job": cases_per_job}
        document = changed(DOCUMENT, execution={**DOCUMENT["execution"], "launcher": "slurm", "slurm": slurm, "cores": 4})
        yield Setting(document, slurm_faults.FAULTS, (0.3, 3), 600, cluster)
    finally:
        cluster.stop()


class Trial:
    """One campaign from its start to its end, on a small disk of its own where one can be mounted."""

    def __init__(self, count, setting):
        self.count, self.setting, self.cluster = count, setting, setting.cluster
        self.campaign = Campaign(setting.document)
        mount = ["mount", "-t", "tmpfs", "-o", f"size={DISK}", "softwall-chaos", str(self.campaign.folder)]
        self.disk = subprocess.run(mount, capture_output=True, check=False).returncode == 0
        self.campaign.write(setting.document)
        self.failing = FailingIo(self.campaign) if LIBRARY.exists() else None
        self.damaged = set()  # checkpoints
        self.acknowledged = {}  # results of finished cases that the store has told of, by case id
        self.runner = None

    def remove(self):
        self.campaign.kill_all(self.runner)
        if self.failing:
            self.failing.end()
        if self.disk:
            subprocess.run(["umount", "-l", str(self.campaign.folder)], capture_output=True, check=False)
        self.campaign.remove()

    # -- what faults ask for ----------------------------------------------------------------------------------

    def resume(self, file_limit=None):
        limit = (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (file_limit, file_limit))) if file_limit else None
        self.runner = self.campaign.start("resume", preexec_fn=limit)

    def wrong(self, what):
        self.count["unsound"] += 1
        log(f"WRONG: {what}")

    def wait_for_runner(self, what):
        try:
            return self.runner.wait(self.setting.patience)
        except subprocess.TimeoutExpired:
            self.count["hangs"] += 1
            log(f"WRONG: softwall did not get {what} in {self.setting.patience} s\n{self.campaign.said()[-3000:]}")
            self.campaign.kill_all(self.runner)
            return None

    def expect_refusal(self, second, first):
        """5 as long as the other one works; otherwise the second may have done anything that one alone may do."""
        try:
            status = second.wait(self.setting.patience)
        except subprocess.TimeoutExpired:
            second.kill()
            status = second.wait()
            if first.poll() is None:
                self.count["run_twice"] += 1
                log("WRONG: two softwalls work on one campaign")
            return
        if status != 5 and first.poll() is None:
            self.count["run_twice"] += 1
            log(f"WRONG: a second softwall ended with {status}, not 5")

    # -- its life ---------------------------------------------------------------------------------------------

    def run(self, generator, faults):
        """Until it has finished; at most so many faults. How many there were."""
        done, tries = 0, 0
        self.resume()
        with OneSolverOnly(self.campaign) as watch:
            while True:
                if done < faults and self.runner.poll() is None:
                    try:
                        self.runner.wait(generator.uniform(*self.setting.pauses))
                    except subprocess.TimeoutExpired:
                        done += self.disturb(generator)
                        tries = 0
                status = self.runner.poll() if done < faults else self.wait_for_runner("to the end")
                if status is None and self.runner.poll() is None:
                    continue
                if status == 0:
                    break
                tries += 1
                if tries > TRIES:
                    self.help_out(status)
                    break
                self.resume()
        self.count["run_twice"] += len(set(watch.crowded))
        return done

    def disturb(self, generator):
        self.note_results()
        fault = generator.choice(self.setting.faults)
        told = fault(self, generator)
        if told is None:
            return 0
        self.count[fault.__name__] += 1
        log(told)
        return 1

    def note_results(self):
        try:
            rows = self.campaign.query("SELECT case_id, quantity, value, ci95 FROM quantities JOIN cases USING (case_id)"
                                       " WHERE state = 'finished'")
        except AssertionError:
            return  # there is no store yet, or it is damaged
        for row in rows:
            self.acknowledged.setdefault(row["case_id"], {})[row["quantity"]] = (row["value"], row["ci95"])

    def help_out(self, status):
        """What a person would do now."""
        self.count["manual_steps"] += 1
        log(f"WRONG: softwall resume ends with {status} {TRIES} times\n{self.campaign.said()[-3000:]}")
        self.campaign.call("rebuild")
        self.campaign.call("resume", "--start-over")

    # -- what became of it ------------------------------------------------------------------------------------

    def judge(self, reference):
        last = self.campaign.call("resume")
        if last.returncode != 0:
            self.wrong(f"a last resume ends with {last.returncode}: {last.stderr[-2000:]}")
        verdict = self.campaign.call("verify")
        if verdict.returncode != 0:
            self.wrong(verdict.stdout + verdict.stderr)
        for left in [*self.campaign.folder.rglob("*.tmp*"), *self.campaign.solvers().values()]:
            self.wrong(f"left over: {left}")
        if self.cluster and (jobs := self.cluster.jobs_of(self.campaign)):
            self.wrong(f"jobs are left: {jobs}")
        results, data = self.campaign.results(), self.campaign.final_data()
        now = {(row["case_id"], row["quantity"]): (row["value"], row["ci95"]) for row in results}
        lost = [case for case, rows in self.acknowledged.items()
                if any(now.get((case, quantity)) != value for quantity, value in rows.items())]
        self.count["results_lost"] += len(lost)
        if lost:
            log(f"WRONG: results of {lost} are lost")
        if (results, data) != (reference.results(), reference.final_data()):
            self.count["other_results"] += 1
            log(f"WRONG: other results than undisturbed; the campaign is kept in {self.keep()}")

    def keep(self):
        kept = tempfile.mkdtemp(prefix="softwall-chaos-")
        subprocess.run(["cp", "-a", f"{self.campaign.folder}/.", kept], check=False)
        return kept


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=random.randrange(2**32))
    parser.add_argument("--faults", type=int, default=20)
    parser.add_argument("--slurm", action="store_true", help="attempts are jobs of a Slurm of one node, begun for this")
    parser.add_argument("--cases-per-job", type=int, default=1, help="with --slurm: so many cases share a job")
    options = parser.parse_args()
    log(f"seed {options.seed}")
    with under_slurm(options.cases_per_job) if options.slurm else contextlib.nullcontext(ON_THIS_MACHINE) as setting:
        sys.exit(run_trials(setting, options))


def run_trials(setting, options):
    """1 when anything has gone wrong."""
    generator, count = random.Random(options.seed), Counter()
    reference = Campaign(DOCUMENT)
    answer = reference.call("run")
    if answer.returncode != 0:
        sys.exit(answer.stderr)
    faults = campaigns = 0
    while faults < options.faults:
        trial = Trial(count, setting)
        try:
            faults += trial.run(generator, options.faults - faults)
            trial.judge(reference)
        finally:
            trial.remove()
        campaigns += 1
        log(f"campaign {campaigns} is over, {faults} faults")
    reference.remove()
    wrong = {name: count[name] for name in ("results_lost", "run_twice", "manual_steps", "hangs", "unsound")}
    verdict = {"faults": faults, **wrong, "identical_results": count["other_results"] == 0, "campaigns": campaigns,
               "seed": options.seed, "seconds": round(time.monotonic() - log.start),
               "kinds": {fault.__name__: count[fault.__name__] for fault in dict.fromkeys(setting.faults)}}
    print(json.dumps(verdict), flush=True)
    return int(any(wrong.values()) or not verdict["identical_results"])


if __name__ == "__main__":
    main()
