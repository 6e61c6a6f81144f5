"""Calls for files that fail on one rank of two, or in softwall: nothing hangs, what was committed stays, and the campaign goes on
to the bits of an undisturbed one as soon as there is room."""

import time
import unittest

from failing_io import FailingIo
from harness import CAMPAIGN, EndToEndTest, changed

DOCUMENT = changed(CAMPAIGN, sweep={"list": [{"G": 1}]}, execution={"ranks": 2, "cores": 2})
SECONDS = 60  # the solver's watchdog would come after 120

# rank, call, error, file, how many such calls have gone well before
SOLVER = [
    (1, "write", "EIO", "/checkpoints/", 4),  # of metadata, when the others wait inside HDF5
    (1, "write", "SHORT", "/checkpoints/", 1),
    (0, "sync", "EIO", "/checkpoints/", 2),
    (0, "rename", "ENOSPC", "/checkpoints/", 0),
    (0, "write", "EDQUOT", "statistics.h5", 1),
]
MANAGER = [("write", "ENOSPC", "run.json", 0), ("sync", "EIO", "results.db", 2)]


class IoErrors(EndToEndTest):
    @classmethod
    def setUpClass(cls):
        cls.reference = cls.campaign(cls(), DOCUMENT)
        assert cls.reference.call("run").returncode == 0

    @classmethod
    def tearDownClass(cls):
        cls.reference.remove()

    def setUp(self):
        self.tried = self.campaign(DOCUMENT)
        self.fault = FailingIo(self.tried)
        self.addCleanup(self.fault.end)

    def resume_into(self, program, rank, call, error, path, before):
        """softwall pauses with a word about the disk, and leaves nobody at work."""
        self.fault.begin(program, rank, call, error, path, first=before + 1)
        start = time.monotonic()
        answer = self.tried.call("resume")
        took = time.monotonic() - start
        self.assertNotEqual(self.fault.end(), [], "nothing failed")
        self.assertEqual(answer.returncode, 4, answer.stderr)
        self.assertIn("paused", answer.stderr)
        self.assertLess(took, SECONDS)
        self.assertEqual(self.tried.solvers(), {})

    def assert_goes_on(self):
        self.run_to_end(self.tried, "resume")
        self.assert_same_outcome(self.tried, self.reference)
        self.assert_sound(self.tried)

    def test_one_after_the_other(self):
        for fault in MANAGER:
            with self.subTest(fault):
                self.resume_into("softwall", "-", *fault)
        for fault in SOLVER:
            with self.subTest(fault):
                self.resume_into("softwall-dns", *fault)
                self.assert_sound(self.tried)
        self.assert_goes_on()

    def test_of_the_store_while_cases_run(self):
        runner = self.tried.start("run")
        self.tried.wait_for_checkpoint("precursor")
        self.fault.begin("softwall", "-", "write", "ENOSPC", "results.db", count=1000000)
        self.assertEqual(runner.wait(SECONDS), 4, self.tried.said())
        self.assertIn("the results store cannot be written", self.tried.said())
        self.assertNotEqual(self.fault.end(), [])
        self.assertEqual(self.tried.solvers(), {})
        self.assert_goes_on()

    def test_of_what_nothing_depends_on(self):
        """A status and a line of the log are lost, and no step; later lines are there."""
        runner = self.tried.start("run")
        self.tried.wait_for(lambda: (self.tried.folder / "manager.log").exists(), "the log")
        self.fault.begin("softwall", "-", "write", "ENOSPC", "manager.log", count=1000000)
        self.tried.wait_for(lambda: self.fault.log.exists(), "a line to fail")
        self.fault.begin("softwall-dns", 0, "write", "EIO", "status.json", count=1000000)
        self.tried.wait_for(lambda: self.fault.log.exists(), "a status to fail")
        self.assertEqual(runner.wait(SECONDS), 0, self.tried.said())
        self.assertNotEqual(self.fault.end(), [])
        self.assertIn("finished", (self.tried.folder / "manager.log").read_text())
        self.assert_same_outcome(self.tried, self.reference)


if __name__ == "__main__":
    unittest.main(verbosity=2)
