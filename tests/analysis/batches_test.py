"""The intervals of the figures: batches_test.py WRITER ROOT; WRITER is the program analysis_sample_campaign, ROOT the source
folder. Exit 77 (skipped) where h5py or numpy is not installed."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import packages_or_skip

WRITER, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
packages_or_skip.needed("numpy", "h5py")
sys.path.insert(0, str(ROOT / "analysis"))
import batches  # noqa: E402
import h5py  # noqa: E402
import numpy as np  # noqa: E402


class Blocks:
    """As much of a case as an interval needs: the weights of its blocks, and a series."""

    def __init__(self, series, weight=None):
        self.series = np.asarray(series, dtype=float)
        self.weight = np.ones(len(self.series)) if weight is None else np.asarray(weight, dtype=float)

    def mean(self):
        return np.average(self.series, axis=0, weights=self.weight)


def half_width(blocks):
    return batches.half_width(blocks, Blocks.mean)


class Intervals(unittest.TestCase):
    def test_they_are_those_of_the_table(self):
        """Of the friction velocity at the rigid wall, whose definition is one line; with and without an interval."""
        compared = 0
        with tempfile.TemporaryDirectory() as folder:
            lines = subprocess.run([WRITER, folder], check=True, capture_output=True, text=True).stdout.splitlines()
            for case in map(json.loads, lines):
                expected = case["quantities"]["re_tau_w"][1]
                with h5py.File(pathlib.Path(folder) / case["directory"] / "statistics.h5") as file:
                    blocks = Blocks(file["series/wall_shear_bottom"][:], file["blocks/weight"][:])
                found = batches.half_width(blocks, lambda each: 2800 * math.sqrt(each.mean()))
                if expected is None:
                    self.assertTrue(np.isnan(found), case["directory"])
                else:
                    self.assertAlmostEqual(found / expected, 1, delta=0.003, msg=case["directory"])
                    compared += 1
        self.assertGreater(compared, 3)

    def test_arrays_are_judged_number_by_number(self):
        series = np.random.default_rng(3).standard_normal((40, 3))
        series[:, 1] = np.arange(40)  # drifts through the window
        series[:, 2] = 7
        widths = half_width(Blocks(series))
        self.assertAlmostEqual(widths[0], half_width(Blocks(series[:, 0])), 12)
        self.assertTrue(np.isnan(widths[1]))
        self.assertAlmostEqual(widths[2], 0, delta=1e-12)

    def test_fewer_batches_are_asked_where_a_quantity_is_not_defined_without_one_of_them(self):
        """As by the table's rule. 40 and 32 batches leave out one of two blocks that belong together, 24 and fewer both."""
        blocks, pair = Blocks(np.random.default_rng(5).standard_normal(40)), slice(20, 22)
        with mock.patch.object(batches, "COUNTS", (24, 16, 12, 8)):
            expected = half_width(blocks)
        for undefined in (math.nan, math.inf):
            quantity = lambda each: undefined if each.weight[pair].any() and not each.weight[pair].all() else each.mean()
            self.assertAlmostEqual(batches.half_width(blocks, quantity), expected, 12)

    def test_what_is_never_defined_has_no_interval(self):
        series = np.random.default_rng(5).standard_normal((64, 2))
        widths = batches.half_width(Blocks(series), lambda each: np.array([each.mean()[0], math.nan]))
        self.assertAlmostEqual(widths[0], half_width(Blocks(series[:, 0])), 12)
        self.assertTrue(np.isnan(widths[1]))

    def test_ninety_five_of_a_hundred_hold_the_truth(self):
        random, rho, given, covered = np.random.default_rng(2017), 0.6, 0, 0
        for _ in range(400):
            series = random.standard_normal(64)
            for n in range(1, 64):
                series[n] = rho * series[n - 1] + math.sqrt(1 - rho * rho) * series[n]
            width = half_width(Blocks(series))
            given += not np.isnan(width)
            covered += abs(series.mean()) <= width
        self.assertGreater(given, 360)
        self.assertGreater(covered / given, 0.90)
        self.assertLess(covered / given, 0.98)

    def test_blocks_of_any_weight_and_number_do(self):
        random = np.random.default_rng(1)
        for number, least_given in ((8, 280), (20, 380), (48, 398)):
            given = covered = 0
            for _ in range(400):
                blocks = Blocks(3 + random.standard_normal(number), 1 + random.random(number))
                width = half_width(blocks)
                given += not np.isnan(width)
                covered += abs(blocks.mean() - 3) <= width
            self.assertGreaterEqual(given, least_given, number)
            self.assertTrue(0.92 <= covered / given <= 0.985, (number, covered, given))

    def test_too_few_blocks_give_none(self):
        self.assertIsNone(half_width(Blocks(np.ones(9), [1, 1, 1, 1, 1, 1, 1, 0, 0])))

    def test_a_number_without_interval_says_so(self):
        self.assertEqual(batches.text(178.52, 1.234, 1), "178.5 +- 1.2")
        self.assertEqual(batches.text(178.52, math.nan, 1), "178.5 -")
        self.assertEqual(batches.text(178.52, None, 1), "178.5 -")
        self.assertEqual(batches.text(math.nan, math.nan, 1), "-")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
