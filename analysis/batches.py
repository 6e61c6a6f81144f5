"""95 % intervals of whatever can be computed from the block averages of a case: the jackknife of the table (jackknife.cpp),
number by number for arrays. README.md, "Uncertainty", gives the recipe and its reason."""

import copy
import math

import numpy as np

LEAST = 8  # batches; fewer blocks give no interval
COUNTS = (64, 48, 32, 24, 16, 12, LEAST)
CORRELATION_ALLOWED, CORRELATION_CAUTION, LEAST_INDEPENDENT = 0.2, 0.3, 2.0
LEAST_DEGREES = 3.0
# Student's t, 97.5 %, against the inverse of the degrees of freedom, of which it is nearly a straight line
DEGREES = np.array((3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 30, 60, np.inf))
STUDENT_T = np.array((3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.228, 2.179, 2.131, 2.086, 2.042, 2.000, 1.960))


def _student_t(degrees):
    return np.interp(1 / degrees, 1 / DEGREES[::-1], STUDENT_T[::-1])


def _without(case, blocks):
    """The same case with these blocks left out of its means."""
    rest = copy.copy(case)
    rest.weight = case.weight.copy()
    rest.weight[blocks] = 0
    return rest


def _batches(weight, count):
    """Numbers of the blocks of each batch: neighbours together, of nearly equal weight."""
    sampled = np.flatnonzero(weight > 0)
    middle = np.cumsum(weight[sampled]) - 0.5 * weight[sampled]
    batch = np.minimum((middle / weight[sampled].sum() * count).astype(int), count - 1)
    return [sampled[batch == one] for one in range(count) if np.any(batch == one)]


def _lag_one(pseudo):
    """Correlation of neighbours along the first axis, corrected for its bias in short samples."""
    departure, number = pseudo - pseudo.mean(axis=0), len(pseudo)
    square = (departure**2).sum(axis=0)
    with np.errstate(invalid="ignore", divide="ignore"):
        raw = (departure[1:] * departure[:-1]).sum(axis=0) / square
    return np.where(square > 0, np.minimum((raw + 1 / number) / (1 - 4 / number), 0.99), 0.0)


def _widths(case, quantity, count):
    """Half widths from this number of batches, and the correlations; NaN, and infinite, where these are too correlated, or where
    a quantity is not defined when one of them is left out."""
    groups, whole = _batches(case.weight, count), np.asarray(quantity(case), dtype=float)
    total = case.weight[case.weight > 0].sum()
    share = np.array([total / case.weight[blocks].sum() for blocks in groups]).reshape(-1, *[1] * whole.ndim)
    without = np.array([quantity(_without(case, blocks)) for blocks in groups], dtype=float)
    pseudo, number = share * whole - (share - 1) * without, len(groups)
    is_defined = np.isfinite(pseudo).all(axis=0)
    pseudo = np.where(is_defined, pseudo, 0)
    variance = ((pseudo - pseudo.mean(axis=0)) ** 2 / (share - 1)).mean(axis=0)
    correlation = _lag_one(pseudo)
    left = np.clip(correlation + CORRELATION_CAUTION / np.sqrt(number), 0, 1 - 1e-9)
    inflation = (1 + left) / (1 - left)
    width = _student_t(np.maximum(number / inflation - 1, LEAST_DEGREES)) * np.sqrt(variance * inflation)
    is_refused = ~is_defined | (number < LEAST_INDEPENDENT * inflation) | (number < LEAST)
    return np.where(is_refused, np.nan, width), np.where(is_refused, np.inf, correlation)


def half_width(case, quantity):
    """Half the 95 % interval of `quantity(case)`, a number or an array, NaN where parts of the window are still too
    correlated or are needed for it to be defined; None with too few blocks."""
    blocks = int(np.count_nonzero(case.weight > 0))
    if blocks < LEAST:
        return None
    width = np.full(np.shape(quantity(case)), np.nan)
    settled = np.zeros(width.shape, dtype=bool)
    for count in sorted({min(count, blocks) for count in COUNTS}, reverse=True):
        found, correlation = _widths(case, quantity, count)
        settles = ~settled & (correlation < CORRELATION_ALLOWED)
        width = np.where(settles, found, np.where(settled, width, np.fmax(width, found)))
        settled |= settles
        if settled.all():
            break
    return width[()]


def decimals(value, width, usual):
    """Two digits of the half width or, without one, as many as usual; but what is not zero does not read as zero."""
    known = width is not None and not np.isnan(width)
    smallest = width if known else value if abs(value) < 0.5 * 10**-usual else 0
    return max(0, 1 - math.floor(math.log10(abs(smallest)))) if smallest else usual


def text(value, width, usual):
    """A number with its interval, "178.5 +- 1.2", or "178.5 -" as in the table where there is none; "-" without a number."""
    if np.isnan(value):
        return "-"
    digits = decimals(value, width, usual)
    interval = "-" if width is None or np.isnan(width) else f"+- {width:.{digits}f}"
    return f"{value:.{digits}f} {interval}"
