"""The newest checkpoint of a small elastic case, damaged at random again and again: it must be noticed, the one before it must
be used and lead to the same bits, and neither softwall nor its solver may crash. Started by damage.sh."""

import argparse
import json
import random
import shutil
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

from faults import PAGE, flip_a_bit, overwrite, truncate, zero_a_page
from harness import CAMPAIGN, HEADER_BYTES, SOFTWALL, Campaign, changed

SMALL = {"nx": 8, "ny_fluid": 16, "ny_solid": 4, "nz": 4}
DOCUMENT = {**{key: value for key, value in CAMPAIGN.items() if key != "precursor"},
            "physics": dict(CAMPAIGN["physics"], grid=SMALL), "sweep": {"list": [{"G": 1}]},
            "run": {"end_time": 0.2, "checkpoint_steps": 20}, "execution": {"ranks": 1, "cores": 1}}
LONGER = changed(DOCUMENT, run={"end_time": 0.24, "checkpoint_steps": 20})
IN_FULL = 10  # every so many times softwall itself goes on, which takes longer


def swap_two_pages(file, random):
    pages = file.stat().st_size // PAGE
    first, second = sorted(random.sample(range(pages), 2))
    contents = file.read_bytes()
    one, other = (contents[page * PAGE : (page + 1) * PAGE] for page in (first, second))
    if one == other:
        return None
    overwrite(file, first * PAGE, other)
    overwrite(file, second * PAGE, one)
    return f"pages {first} and {second} swapped"


def add_a_tail(file, random):
    size = random.choice([1, 100, PAGE, 100000])
    with open(file, "ab") as opened:
        opened.write(random.randbytes(size))
    return f"{size} bytes added"


def flip_a_bit_of_the_header(file, random):
    at = random.randrange(HEADER_BYTES)
    overwrite(file, at, bytes([file.read_bytes()[at] ^ 1 << random.randrange(8)]))
    return f"bit flipped at byte {at}"


def write_rubbish_over_a_page(file, random):
    page = random.randrange(file.stat().st_size // PAGE)
    overwrite(file, page * PAGE, random.randbytes(PAGE))
    return f"page {page} overwritten"


KINDS = [flip_a_bit, flip_a_bit_of_the_header, zero_a_page, swap_two_pages, truncate, add_a_tail, write_rubbish_over_a_page]


class Trial:
    """A case that has finished, and is now to go on: a copy of it is damaged, and runs to the later end."""

    def __init__(self):
        self.count = Counter()
        self.campaign = Campaign(DOCUMENT)
        self.expect(self.campaign.call("run"), 0)
        self.campaign.write(LONGER)
        self.case = next(self.campaign.folder.glob("cases/*"))
        self.before, self.newest = sorted((self.case / "checkpoints").glob("*.h5"))
        definition = json.loads((self.case / "case.json").read_text())
        definition["run"]["end_time"] = LONGER["run"]["end_time"]
        (self.case / "case.json").write_text(json.dumps(definition))
        self.kept = Path(f"{self.campaign.folder}.kept")
        shutil.copytree(self.campaign.folder, self.kept)
        self.expect(self.solve(), 0)
        self.final, self.results = self.campaign.final_data(), None
        self.restore()
        self.expect(self.campaign.call("run"), 0)
        self.results = self.campaign.results()

    def remove(self):
        self.campaign.remove()
        shutil.rmtree(self.kept, ignore_errors=True)

    @staticmethod
    def expect(answer, status):
        if answer.returncode != status:
            sys.exit(f"{answer.args} ends with {answer.returncode}, not {status}:\n{answer.stdout}{answer.stderr}")

    def restore(self):
        shutil.rmtree(self.campaign.folder)
        shutil.copytree(self.kept, self.campaign.folder)

    def solve(self):
        return subprocess.run([SOFTWALL.parent / "softwall-dns", self.case], capture_output=True, text=True, timeout=120)

    def wrong(self, what, done, answer):
        self.count[what] += 1
        print(f"WRONG: {what}: {done}: {answer.returncode}\n{answer.stdout}{answer.stderr}", file=sys.stderr, flush=True)

    def verify(self, done):
        answer = self.campaign.call("verify")
        if answer.returncode != 3 or f"checkpoints/{self.newest.name}: " not in answer.stdout:
            self.wrong("not_detected", done, answer)
        if answer.returncode < 0 or answer.returncode > 5:
            self.wrong("crashes", done, answer)

    def go_on(self, done, in_full):
        answer = self.campaign.call("run") if in_full else self.solve()
        if answer.returncode != 0:
            self.wrong("crashes" if answer.returncode < 0 or answer.returncode > 128 else "not_finished", done, answer)
            return
        if self.newest.name not in answer.stderr + answer.stdout:
            self.wrong("not_detected", done, answer)
        summary = json.loads((self.case / "summary.json").read_text())
        if summary["resumed_from"] != f"checkpoints/{self.before.name}":
            self.wrong("previous_not_used", done, answer)
        if self.campaign.final_data() != self.final or (in_full and self.campaign.results() != self.results):
            self.wrong("other_bits", done, answer)

    def damage(self, number, generator):
        self.restore()
        done = None
        while not done:
            kind = generator.choice(KINDS)
            done = kind(self.newest, generator)
        self.count[kind.__name__] += 1
        self.verify(done)
        self.go_on(done, number % IN_FULL == 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=random.randrange(2**32))
    parser.add_argument("--count", type=int, default=20)
    options = parser.parse_args()
    start, generator, trial = time.monotonic(), random.Random(options.seed), Trial()
    try:
        for number in range(1, options.count + 1):
            trial.damage(number, generator)
    finally:
        trial.remove()
    names = ("not_detected", "previous_not_used", "not_finished", "other_bits", "crashes")
    wrong = {name: trial.count[name] for name in names}
    verdict = {"damaged": options.count, **wrong, "seed": options.seed, "seconds": round(time.monotonic() - start),
               "kinds": {kind.__name__: trial.count[kind.__name__] for kind in KINDS}}
    print(json.dumps(verdict), flush=True)
    sys.exit(any(wrong.values()))


if __name__ == "__main__":
    main()
