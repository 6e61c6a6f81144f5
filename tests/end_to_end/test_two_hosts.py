"""A case whose ranks are on two hosts: the same numbers as on one, by messages, and a host's ranks may die. By hand, as root:
SOFTWALL=build/bin/softwall python3 tests/end_to_end/test_two_hosts.py"""

import os
import signal
import sys
import unittest
from collections import Counter

from harness import CAMPAIGN, Campaign, EndToEndTest, changed
from slurm_cluster import CannotStart, begin_for
from two_hosts import TwoHosts

RANKS = 4
ALONE = {name: member for name, member in CAMPAIGN.items() if name != "precursor"}
ALONE = changed(ALONE, sweep={"grid": {"G": [1]}}, run={"end_time": 1.0, "checkpoint_steps": 20})


def on_nodes(nodes):
    options = [f"--ntasks-per-node={RANKS // nodes}"]
    slurm = {"partition": "main", "nodes": nodes, "options": options}
    return changed(ALONE, execution={"launcher": "slurm", "ranks": RANKS, "slurm": slurm})


class TwoHostsTest(EndToEndTest):
    @classmethod
    def setUpClass(cls):
        # Messages take the hosts' own network, whatever else this machine has.
        begin_for(cls, TwoHosts, OMPI_MCA_btl_tcp_if_include="eth0", OMPI_MCA_oob_tcp_if_include="eth0")
        cls.one_host = Campaign(on_nodes(1))
        cls.addClassCleanup(cls.one_host.remove)
        before_it = cls.cluster.bytes_between()
        answer = cls.one_host.call("run")
        assert answer.returncode == 0, answer.stderr
        cls.idle_bytes = cls.cluster.bytes_between() - before_it

    def ranks_by_host(self, campaign):
        ranks = [pid for pid, (name, _) in campaign.solvers().items() if name.startswith("softwall-dns")]
        return Counter(map(self.cluster.host_of, ranks))

    def started(self):
        campaign = self.campaign(on_nodes(2))
        runner = campaign.start()
        self.addCleanup(runner.wait)
        self.addCleanup(runner.kill)
        campaign.wait_for_checkpoint("G=1")
        self.assertEqual(self.ranks_by_host(campaign), dict.fromkeys(self.cluster.hosts, 2))
        return campaign, runner

    def assert_same_as_on_one_host(self, campaign, runner):
        self.assertEqual(runner.wait(400), 0, campaign.said())
        self.assert_same_outcome(campaign, self.one_host)
        self.assert_sound(campaign)

    def test_01_fields_and_results_are_those_of_one_host_bit_for_bit(self):
        before = self.cluster.bytes_between()
        campaign, runner = self.started()
        self.assert_same_as_on_one_host(campaign, runner)
        sent = self.cluster.bytes_between() - before
        print(f"bytes to the second host: {sent}, while all ranks were on the first {self.idle_bytes}", flush=True)
        self.assertGreater(sent, 100 * self.idle_bytes, "ranks of different hosts have nothing but messages")

    def test_02_the_death_of_one_hosts_ranks_ends_the_attempt_and_another_goes_on(self):
        campaign, runner = self.started()
        for pid in campaign.solvers():
            if self.cluster.host_of(pid) == self.cluster.hosts[1]:
                os.kill(pid, signal.SIGKILL)
        self.assert_same_as_on_one_host(campaign, runner)
        outcomes = [row["outcome"] for row in campaign.query("SELECT outcome FROM attempts ORDER BY attempt")]
        self.assertEqual(len(outcomes), 2, campaign.said())
        self.assertEqual(outcomes[1], "finished")


if __name__ == "__main__":
    try:
        TwoHosts().stop()
    except CannotStart as reason:
        print(f"skipped: no two hosts can be had here: {reason}")
        sys.exit(77)
    unittest.main(verbosity=2)
