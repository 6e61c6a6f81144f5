"""Where the initial transient of a case ends, as far as its block averages tell."""

import numpy as np

from campaign_data import SeriesCase

LEAST = 8  # blocks


def first_kept(values):
    """Index of the first value to keep: the truncation after which the standard error of the mean of the rest is smallest
    (marginal standard error rule: White, Simulation 69 (1997) 323), looked for in the first half. None with few values."""
    values = np.asarray(values, dtype=float)
    if len(values) < LEAST:
        return None
    errors = [np.var(values[start:]) / (len(values) - start) for start in range(len(values) // 2 + 1)]
    return int(np.argmin(errors))


def end_of_transient(case):
    """Time after which the drag of both walls and the deformation look stationary, h/U_b; None where that cannot be told.
    The last block may have just begun and is not asked."""
    whole = SeriesCase(case.directory)  # also what lies before the averaging window
    names = ["driving_gradient", "wall_shear_bottom"] + (["interface_variance"] if case.elastic else [])
    found = [first_kept(whole.series[name][:-1]) for name in names if name in whole.series]
    if not found or None in found:
        return None
    return float(whole.block_start[max(found)])
