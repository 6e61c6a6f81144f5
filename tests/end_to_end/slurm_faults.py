"""What may happen to a campaign whose attempts are jobs: to the jobs, to Slurm's daemons, to what Slurm's commands say, and to
softwall itself. Each fault is a function of the trial and of a random generator, as in faults.py; each puts right again what
an administrator, and not a user, has to put right."""

import os
import shutil
import threading
import time

from faults import ask_to_stop, kill_everything, kill_one, kill_the_runner, second_manager, stop_one_for_a_while
from slurm_cluster import SlurmCluster

# What a command says or does instead, {real} being the real one; sbatch is asked for a check besides, and answers that.
INSTEAD = {
    "squeue": {
        "says garbage": "echo 'J@B |S|'; head -c 300 /dev/urandom",
        "fails": "echo 'slurm_load_jobs error: Unable to contact slurm controller (connect failure)' >&2; exit 1",
        "is cut off": '{real} "$@" | head -c 60',
        "knows no job": "",
        "is slow": 'sleep 3; exec {real} "$@"',
    },
    "sbatch": {
        "dies once the job is accepted": '{real} "$@" >/dev/null; kill -9 $$',
        "dies before": "kill -9 $$",
        "says garbage once the job is accepted": '{real} "$@" >/dev/null; echo surprise',
        "refuses": "echo 'sbatch: error: QOSMaxSubmitJobPerUserLimit' >&2; exit 1",
        "times out once the job is accepted":
            '{real} "$@" >/dev/null; echo "sbatch: error: Batch job submission failed: Socket timed out" >&2; exit 1',
    },
    "scancel": {"fails": "exit 1"},
}


class TendedCluster(SlurmCluster):
    """A Slurm whose commands can be made to lie, with an administrator who takes every node back that is drained or down."""

    def __init__(self):
        self.is_over = threading.Event()
        self.daemons_change = threading.Lock()
        super().__init__(slots=4)
        self.lies = self.folder / "lies"
        self.lies.mkdir()
        for name in INSTEAD:
            self.write_wrapper(name)
        os.environ.update(SLURM_CONF=self.environment["SLURM_CONF"], PATH=f"{self.lies}:{os.environ['PATH']}",
                          OMPI_MCA_mpi_yield_when_idle="1", OMPI_MCA_hwloc_base_binding_policy="none",
                          TMPDIR=str(self.folder))
        threading.Thread(target=self.tend, daemon=True).start()

    def write_wrapper(self, name):
        real, lie = shutil.which(name), self.lies / f"{name}.lie"
        wrapper = self.lies / name
        wrapper.write_text(f'#!/bin/sh\ncase "$*" in *--test-only*) ;; *) if [ -e {lie} ]; then . {lie}; exit; fi;; esac\n'
                           f'exec {real} "$@"\n')
        wrapper.chmod(0o755)

    def tell_lies(self, name, what):
        lie = self.lies / f"{name}.lie"
        lie.with_suffix(".new").write_text(INSTEAD[name][what].format(real=shutil.which(name, path="/usr/bin:/bin")) + "\n")
        lie.with_suffix(".new").rename(lie)

    def tell_the_truth(self, name):
        (self.lies / f"{name}.lie").unlink(missing_ok=True)

    def tend(self):
        while not self.is_over.wait(1):
            with self.daemons_change:
                self.bring_node_back()

    def jobs_of(self, campaign):
        """Numbers of those that wait or run, of one campaign, sorted by name."""
        lines = self.call("squeue", "--noheader", "--format=%j|%i").stdout.splitlines()
        return [line.rpartition("|")[2] for line in sorted(lines) if f".{campaign.folder.name}." in line]

    def stop(self):
        self.is_over.set()
        super().stop()


def one_job(trial, random):
    jobs = trial.cluster.jobs_of(trial.campaign)
    return random.choice(jobs) if jobs else None


# -- to jobs ----------------------------------------------------------------------------------------------------------


def cancel_a_job(trial, random):
    job = one_job(trial, random)
    if job is None:
        return None
    trial.cluster.call("scancel", job)
    return f"scancel of job {job}"


def signal_a_job(trial, random):
    """As Slurm does before a time limit."""
    job = one_job(trial, random)
    if job is None:
        return None
    trial.cluster.call("scancel", "--batch", "--signal=USR1", job)
    return f"SIGUSR1 to job {job}"


def requeue_a_job(trial, random):
    """By an administrator, since softwall asks Slurm not to."""
    job = one_job(trial, random)
    if job is None:
        return None
    trial.cluster.call("scontrol", "update", f"jobid={job}", "requeue=1")
    answer = trial.cluster.call("scontrol", "requeue", job)
    return f"job {job} requeued" if answer.returncode == 0 else None


# -- to daemons -------------------------------------------------------------------------------------------------------


def restart(cluster, daemon, seconds, start, *options):
    """Kills a daemon and begins it again some seconds later."""
    with cluster.daemons_change:
        cluster.kill(daemon)
        time.sleep(seconds)
        start(*options)
    return f"SIGKILL to {daemon}, restarted"


def kill_the_controller(trial, random):
    """It may not have saved yet what it knows of the jobs."""
    return restart(trial.cluster, "slurmctld", random.uniform(0, 3), trial.cluster.start_controller)


def make_the_controller_forget(trial, random):
    """All jobs are gone from its books, whether they wait or run; numbers begin anew."""
    return restart(trial.cluster, "slurmctld", 0, trial.cluster.start_controller, "-c") + " without its memory"


def kill_the_node_daemon(trial, random):
    return restart(trial.cluster, "slurmd", random.uniform(0, 2), trial.cluster.start_node)


def fail_the_node(trial, random):
    """Its jobs are given up and their processes go on, or die as well."""
    with trial.cluster.daemons_change:
        trial.cluster.fail_node()
        processes = random.choice(["go on", "die"])
        if processes == "die":
            trial.campaign.kill_all()
        time.sleep(random.uniform(0, 3))
        trial.cluster.start_node()
    return f"node failed, its processes {processes}; back again"


# -- to what is said --------------------------------------------------------------------------------------------------


def lie_for_a_while(trial, random):
    command = random.choice(list(INSTEAD))
    what = random.choice(list(INSTEAD[command]))
    trial.cluster.tell_lies(command, what)
    time.sleep(random.uniform(1, 5))
    trial.cluster.tell_the_truth(command)
    return f"{command} {what}, for a while"


# What is named twice strikes twice as often.
FAULTS = [
    kill_one, kill_one, kill_everything, stop_one_for_a_while, kill_the_runner, kill_the_runner, ask_to_stop, second_manager,
    cancel_a_job, cancel_a_job, signal_a_job, requeue_a_job, requeue_a_job, kill_the_controller, kill_the_controller,
    make_the_controller_forget, kill_the_node_daemon, fail_the_node, fail_the_node, lie_for_a_while, lie_for_a_while,
    lie_for_a_while, lie_for_a_while,
]
