"""Correlations of each velocity component with itself along x or z, at every height: from the spectra that the solver has summed,
or where a case has none from single moments of the flow."""

from flow_fields import autocorrelation, flow_fields
from spectra_data import read_spectra

import numpy as np

AXES = {"x": 2, "z": 0}  # of a field [z][y][x]


def correlation(fluctuations, axis):
    """R(y, separation) of fields [z][y][x] along an axis, averaged over the other axis and all fields, over its value at 0;
    0 where nothing moves."""
    total = sum(autocorrelation(field, axis).mean(axis=2 - axis) for field in fluctuations)
    rows = total if axis == 2 else total.T
    return rows / np.where(rows[:, :1] > 0, rows[:, :1], 1)


def _separations(length, cells):
    """h, up to half the period."""
    return length / cells * np.arange(cells // 2 + 1)


class FromSpectra:
    """`rows(name, axis)`: separations, heights, and R of them, [height][separation]."""

    is_of_all_samples = True

    def __init__(self, case, spectra):
        self.case, self.spectra = case, spectra
        self.words = f"{spectra.flow.weight.sum():.0f} $h/U_b$ sampled"

    def rows(self, name, axis):
        separations = _separations(self.spectra.length[axis], self.spectra.columns[axis])
        return separations, self.spectra.heights(name), self.spectra.correlation(axis, name)


class FromMoments:
    """The same from single moments of the flow."""

    is_of_all_samples = False

    def __init__(self, case, moments):
        self.case, self.moments = case, moments
        self.words = f"{len(moments)} moment{'s' if len(moments) > 1 else ''}"

    def rows(self, name, axis):
        cells = self.moments[0].field(name, slice(0, 1)).shape[AXES[axis]]
        separations = _separations(self.case.box["xz".index(axis)], cells)
        R = correlation((moment.fluctuation(name) for moment in self.moments), AXES[axis])
        return separations, self.case.y["center"], R


def moments_of(case):
    """What lies in the averaging window, or the last moment if nothing does."""
    moments = flow_fields(case)
    inside = [moment for moment in moments if moment.time >= case.start[0]]
    return inside or moments[-1:]


def source_of(case):
    """What is known best of the correlations of a case, or None."""
    if spectra := read_spectra(case):
        return FromSpectra(case, spectra)
    moments = moments_of(case)
    return FromMoments(case, moments) if moments else None
