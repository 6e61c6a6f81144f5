"""A Slurm of two hosts on one machine: each has a network of its own (a namespace, joined to the other by a bridge), a host
name and a slurmd, so that ranks on different ones have nothing to reach each other by but messages. Needs root."""

import os
import subprocess
import time
from pathlib import Path

from slurm_cluster import UP, CannotStart, SlurmCluster, node_line

NET = "10.231.77"  # of the bridge: .1 the controller, .2 and .3 the hosts


def ip(*words):
    answer = subprocess.run(["ip", *words], capture_output=True, text=True, check=False)
    if answer.returncode != 0:
        raise CannotStart(f"ip {' '.join(words)}: {answer.stderr.strip()}")


class TwoHosts(SlurmCluster):
    address = f"{NET}.1"

    def __init__(self, slots=4):
        mark = f"{os.getpid() % 100000}"
        self.bridge, self.hosts = f"swb{mark}", [f"sw{mark}a", f"sw{mark}b"]
        try:
            self.make_networks()
            super().__init__(slots)
        except BaseException:
            self.remove_networks()
            raise

    def make_networks(self):
        ip("link", "add", self.bridge, "type", "bridge")
        ip("addr", "add", f"{NET}.1/24", "dev", self.bridge)
        ip("link", "set", self.bridge, "up")
        for last, host in enumerate(self.hosts, 2):
            ip("netns", "add", host)
            ip("link", "add", f"{host}o", "type", "veth", "peer", "name", "eth0", "netns", host)
            ip("link", "set", f"{host}o", "master", self.bridge, "up")
            ip("-n", host, "addr", "add", f"{NET}.{last}/24", "dev", "eth0")
            ip("-n", host, "link", "set", "eth0", "up")
            ip("-n", host, "link", "set", "lo", "up")

    def remove_networks(self):
        for words in [*(["netns", "del", host] for host in self.hosts), ["link", "del", self.bridge]]:
            subprocess.run(["ip", *words], capture_output=True, check=False)

    def nodes(self, slots):
        return "\n".join(node_line(host, f"{NET}.{last}", slots) for last, host in enumerate(self.hosts, 2))

    def start_node(self):
        for host in self.hosts:
            script = f'hostname {host}; exec "$0" "$@"'
            self.launch("slurmd", "-D", "-f", str(self.folder / "slurm.conf"), "-N", host,
                        within=("ip", "netns", "exec", host, "unshare", "--uts", "sh", "-c", script))
            self.daemons[f"slurmd of {host}"] = self.daemons.pop("slurmd")
        self.wait(self.bring_node_back, "both slurmd")

    def bring_node_back(self):
        states = self.node_state().split()
        if states and all(state in UP for state in states):
            return True
        for host in self.hosts:
            self.call("scontrol", "update", f"nodename={host}", "state=resume")
        return False

    def host_of(self, pid):
        """On which of the two a process runs, by its network; None: on neither."""
        for host in self.hosts:
            try:
                if os.stat(f"/proc/{pid}/ns/net").st_ino == os.stat(f"/run/netns/{host}").st_ino:
                    return host
            except OSError:
                return None
        return None

    def bytes_between(self):
        """That went to the second host since it was made."""
        counter = Path(f"/sys/class/net/{self.hosts[1]}o/statistics/tx_bytes")
        return int(counter.read_text())

    def stop(self):
        for name in [name for name in self.daemons if name.startswith("slurmd of")]:
            self.kill(name)
        super().stop()
        time.sleep(0.1)
        self.remove_networks()
