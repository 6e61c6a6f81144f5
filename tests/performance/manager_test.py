"""manager_test.py SOFTWALL STUB_SOLVER [CASES]: what the manager itself costs, in seconds of its own processor time (so
that a busy machine does not matter): a case of which the solver does nothing, and CASES cases that have all finished.

The bounds here are several times what a quiet machine needs: they find blunders, such as a list that is searched for every
case. The measured values are printed.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

SOFTWALL, STUB = (str(pathlib.Path(path).resolve()) for path in sys.argv[1:3])
CASES = int(sys.argv[3]) if len(sys.argv) > 3 else 2000
NO_OP_CASES = 500
NO_OP_BOUND = 20e-3  # of the manager, a case
STATUS_BOUND, NOTHING_TO_DO_BOUND = 1.5, 4.0  # of 10,000 cases


def campaign(cases):
    return {
        "format": 1, "name": "many", "run": {"end_time": 200},
        "physics": {"flow": "rigid_channel", "reynolds": 100, "grid": {"nx": 8, "ny_fluid": 8, "nz": 4},
                    "statistics": {"start_time": 100}},
        "sweep": {"grid": {"seed": list(range(1, cases + 1))}},
        "execution": {"ranks": 1, "cores": 2},
    }


def write_campaign(folder, cases):
    (folder / "campaign.json").write_text(json.dumps(campaign(cases)))


def write_mpirun(folder):
    """Starts its program and nothing else: Open MPI takes a third of a second of its own."""
    folder.mkdir()
    script = folder / "mpirun"
    script.write_text('#!/bin/sh\nwhile [ "$1" != -n ]; do shift; done\nshift 2\nexec "$@"\n')
    script.chmod(0o755)


def environment(folder):
    return dict(os.environ, PATH=f"{folder / 'bin'}:{os.environ['PATH']}", SOFTWALL_DNS=STUB)


def own_seconds(process):
    """Of this process without its children, until it ends; None once it has."""
    try:
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return None
    return None if fields[0] == "Z" else (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def seconds_of(command, folder):
    """Its own processor time: asked for until it ends, so a hundredth of a second may be missing."""
    with open(folder / "said", "w") as said:
        process = subprocess.Popen(command, env=environment(folder), stdout=subprocess.DEVNULL, stderr=said)
        used = 0.0
        while process.poll() is None:
            used = own_seconds(process) or used
            time.sleep(0.005)
    assert process.returncode == 0, (command, process.returncode, (folder / "said").read_text()[-2000:])
    return used


def no_op_cases(folder):
    write_campaign(folder, NO_OP_CASES)
    write_mpirun(folder / "bin")
    return seconds_of([SOFTWALL, "run", str(folder)], folder) / NO_OP_CASES


def finished_cases(folder):
    """Seconds of `status` and of a run with nothing to do, both for 10,000 cases."""
    write_campaign(folder, CASES)
    write_mpirun(folder / "bin")
    plan = json.loads(subprocess.run([SOFTWALL, "plan", str(folder), "--json"], env=environment(folder), check=True,
                                     capture_output=True, text=True).stdout)
    lines = "".join(f"{case['case_id']} 200 {folder / case['directory']}\n" for case in plan["cases"])
    subprocess.run([STUB, "--many"], input=lines, text=True, check=True)
    subprocess.run([SOFTWALL, "run", str(folder)], env=environment(folder), check=True, capture_output=True)
    status, nothing = ([SOFTWALL, command, str(folder)] for command in ("status", "run"))
    return [10_000 / CASES * min(seconds_of(command, folder) for _ in range(3)) for command in (status, nothing)]


with tempfile.TemporaryDirectory(prefix="softwall-manager-") as scratch:
    folders = [pathlib.Path(scratch).resolve() / name for name in ("no-op", "finished")]
    for each in folders:
        each.mkdir()
    of_a_case = no_op_cases(folders[0])
    print(f"{NO_OP_CASES} cases of which the solver does nothing: {1e3 * of_a_case:.2f} ms of the manager each")
    status, nothing = finished_cases(folders[1])
    print(f"10,000 finished cases (from {CASES}): status {status:.2f} s, a run with nothing to do {nothing:.2f} s")
    assert of_a_case < NO_OP_BOUND
    assert status < STATUS_BOUND
    assert nothing < NOTHING_TO_DO_BOUND
