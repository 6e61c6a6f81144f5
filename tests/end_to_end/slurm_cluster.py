"""A Slurm of one node for the time of a test: three daemons with all their files in one temporary folder.

Nothing of a Slurm that the machine may have is used or changed, and no service manager is needed. The daemons are
children of the test and die with it, however it ends.
"""

import ctypes
import os
import pwd
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

from harness import parent_of

SBIN = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
PR_SET_PDEATHSIG = 1
UP = ("idle", "mixed", "allocated", "completing")  # states of a node that takes jobs, or will in a moment


class CannotStart(Exception):
    """Why no Slurm can be had here."""


def program(name):
    found = shutil.which(name, path=SBIN)
    if not found:
        raise CannotStart(f"{name} is not installed (Debian: apt install slurm-wlm munge)")
    return found


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def die_with_parent():
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def begin_for(cls, kind, **more):
    """A cluster of this kind for a class of tests, which softwall then finds; `more`: of the environment. Both end with the
    class. Several ranks share the cores of this machine, and none is bound to one of them."""
    before = dict(os.environ)
    cls.addClassCleanup(os.environ.update, before)
    cls.addClassCleanup(os.environ.clear)
    cls.cluster = kind()
    cls.addClassCleanup(cls.cluster.stop)
    os.environ.update(more, SLURM_CONF=cls.cluster.environment["SLURM_CONF"], OMPI_MCA_mpi_yield_when_idle="1",
                      OMPI_MCA_hwloc_base_binding_policy="none", TMPDIR=str(cls.cluster.folder))


# Why the odd lines: no groups of processes are controlled by the kernel here (linuxproc), but slurmd insists on a plugin
# for control groups, and of version 1 it takes one that touches nothing. A node is taken for lost after five seconds,
# and a job that is begun again need not wait two minutes for its credentials to expire. config_overrides allows more
# slots than there are cores.
CONFIGURATION = """\
ClusterName=softwall
SlurmctldHost={host}({address})
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=cred_expire=5,socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,sched_interval=1,bf_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
KillWait=3
SlurmctldTimeout=30
SlurmdTimeout=5
MessageTimeout=5
SlurmdParameters=config_overrides
{nodes}
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE DefaultTime=10 State=UP
"""


def command_of(pid):
    try:
        return Path(f"/proc/{pid}/comm").read_text().strip()
    except OSError:
        return ""


def node_line(name, address, slots):
    return (f"NodeName={name} NodeAddr={address} CPUs={slots} SocketsPerBoard=1 CoresPerSocket={slots} ThreadsPerCore=1"
            " State=UNKNOWN")


class SlurmCluster:
    address = "127.0.0.1"  # of the controller

    def __init__(self, slots=4):
        self.folder = Path(tempfile.mkdtemp(prefix="softwall-slurm-"))
        self.daemons = {}
        self.host = socket.gethostname().partition(".")[0]
        self.environment = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"))
        try:
            self.start(slots)
        except BaseException:
            self.stop()
            raise

    def start(self, slots):
        for name in ("sbatch", "squeue", "scancel", "scontrol"):
            program(name)
        (self.folder / "state").mkdir()
        self.folder.chmod(0o755)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=self.host, address=self.address, folder=self.folder, nodes=self.nodes(slots),
            user=pwd.getpwuid(os.geteuid()).pw_name, controller_port=free_port(), node_port=free_port()))
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.launch("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                    f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log",
                    f"--seed-file={self.folder}/munged.seed")
        self.wait(lambda: (self.folder / "munge.socket").exists(), "munged")
        self.start_controller()
        self.start_node()

    def nodes(self, slots):
        """Lines of slurm.conf."""
        return node_line(self.host, "127.0.0.1", slots)

    def launch(self, name, *arguments, within=()):
        """A daemon; within: a command that it is an argument of."""
        with open(self.folder / f"{name}.said", "ab") as said:
            self.daemons[name] = subprocess.Popen(
                [*within, program(name), *arguments], stdin=subprocess.DEVNULL, stdout=said, stderr=said, cwd="/",
                env=self.environment, preexec_fn=die_with_parent)

    def start_controller(self, *options):
        self.launch("slurmctld", "-D", "-f", str(self.folder / "slurm.conf"), *options)
        self.wait(lambda: self.call("sinfo", "--noheader").returncode == 0, "slurmctld")

    def start_node(self):
        self.launch("slurmd", "-D", "-f", str(self.folder / "slurm.conf"), "-N", self.host)
        self.wait(self.bring_node_back, "slurmd")

    def kill(self, name):
        """SIGKILL of a daemon, at once."""
        self.daemons[name].kill()
        self.daemons.pop(name).wait()

    def fail_node(self):
        """SIGKILL of the node's daemon and of those of its that watch over jobs; what jobs had started goes on."""
        self.kill("slurmd")
        ours = dict(self.processes())
        watchers = {pid for pid, name in ours.items() if name == "slurmstepd"}
        watchers |= {parent for parent in map(parent_of, ours) if command_of(parent) == "slurmstepd"}
        for pid in watchers:  # one that has renamed itself does not show its environment
            os.kill(pid, signal.SIGKILL)
        self.call("scontrol", "update", f"nodename={self.host}", "state=down", "reason=failed")

    def node_state(self):
        return self.call("sinfo", "--noheader", "--format=%T").stdout.strip()

    def bring_node_back(self):
        """An administrator's word after a failure. True when the node takes jobs."""
        if self.node_state() in UP:
            return True
        self.call("scontrol", "update", f"nodename={self.host}", "state=resume")
        return False

    def wait(self, condition, what, seconds=20):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                logs = "\n".join(log.read_text(errors="replace")[-2000:] for log in self.folder.glob("*.log"))
                raise CannotStart(f"{what} did not come up within {seconds} s\n{logs}")
            time.sleep(0.05)

    def call(self, name, *arguments):
        return subprocess.run([program(name), *arguments], env=self.environment, capture_output=True, text=True,
                              timeout=60)

    def jobs(self):
        """{name: state} of every job that Slurm remembers, the newest of each name."""
        lines = self.call("squeue", "--noheader", "--states=all", "--sort=i", "--format=%j|%T").stdout.splitlines()
        return dict(line.split("|") for line in lines)

    def number_of(self, part_of_name):
        """Of the newest job that has not ended."""
        lines = self.call("squeue", "--noheader", "--sort=i", "--format=%i|%j").stdout.splitlines()
        numbers = [line.split("|")[0] for line in lines if part_of_name in line]
        return numbers[-1] if numbers else None

    def processes(self):
        """(pid, name) of everything that belongs to this cluster: daemons, those that watch over jobs, jobs."""
        mark = str(self.folder).encode()
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit() or int(entry.name) == os.getpid():
                continue
            try:
                text = (entry / "cmdline").read_bytes() + (entry / "environ").read_bytes()
            except OSError:
                continue
            if mark in text:
                yield int(entry.name), command_of(entry.name)

    def stop(self):
        for name in ("slurmd", "slurmctld", "munged"):
            if name in self.daemons:
                self.kill(name)
        for _ in range(20):
            left = list(self.processes())
            for pid, _ in left:
                try:
                    os.kill(pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            if not left:
                break
            time.sleep(0.1)
        shutil.rmtree(self.folder, ignore_errors=True)
