"""95 % intervals of whatever can be computed from the block averages of a case: the jackknife over batches of blocks."""

import copy

import numpy as np

MOST, LEAST = 16, 8  # batches; fewer blocks than LEAST give no interval
# Student's t, 97.5 %, by the number of batches (one more than the degrees of freedom)
STUDENT_T = dict(zip(range(LEAST, MOST + 1), (2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131)))


def _without(case, blocks):
    """The same case with these blocks left out of its means."""
    rest = copy.copy(case)
    rest.weight = case.weight.copy()
    rest.weight[blocks] = 0
    return rest


def half_width(case, quantity):
    """Half the 95 % interval of `quantity(case)`, a number or an array, or None with too few blocks. The blocks are merged
    into batches of neighbours, each of which is left out in turn (delete-a-group jackknife)."""
    sampled = np.flatnonzero(case.weight > 0)
    number = min(MOST, len(sampled))
    if number < LEAST:
        return None
    estimates = np.array([quantity(_without(case, blocks)) for blocks in np.array_split(sampled, number)])
    spread = ((estimates - estimates.mean(axis=0)) ** 2).sum(axis=0)
    return STUDENT_T[number] * np.sqrt((number - 1) / number * spread)
