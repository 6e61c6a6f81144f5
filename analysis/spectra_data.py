"""What the solver has summed of spectra, of the interface and of its waves: spectra.h5 of a case.

Spectra are [mode][row], [block][mode][row] before they are averaged; mode m along x has the wave number 2 pi m / length_x.
The sum over all modes is the mean square about the mean over the plane. Units: h, U_b, density 1.
"""

import copy

from campaign_data import read_campaign, tell

import h5py
import numpy as np

FIELDS = "uvwp"
MOST_DECADES = 8


class Means:
    """A group of arrays by block. `mean(name)` is the mean over the blocks that begin at or after `start`."""

    def __init__(self, group, start):
        inside = group["start"][:] >= start - 1e-9 * max(1.0, abs(start))
        self.start, self.end, self.weight = (group[name][:][inside] for name in ("start", "end", "weight"))
        self._by_block = {name: values[:][inside].astype(float) for name, values in group.items()
                          if name not in ("start", "end", "weight") and values.shape[0] == len(inside)}

    def __bool__(self):
        return bool(self.weight.sum() > 0)

    def mean(self, name):
        return np.average(self._by_block[name], axis=0, weights=self.weight)

    def since(self, time):
        """The same from this time on: a block that began before it counts with the part that lies behind it."""
        rest = copy.copy(self)
        rest.weight = self.weight * np.clip((self.end - time) / (self.end - self.start), 0, 1)
        return rest

    def names(self):
        return set(self._by_block)


class Spectra:
    """spectra.h5 of a case from its averaging window on. The constructor raises OSError or KeyError where it cannot be
    read. `flow`, `budget`, `interface` and `pairs` are Means; the last two are None without an elastic wall, `pairs` also
    where an earlier version of the solver has summed all there is."""

    def __init__(self, case):
        with h5py.File(case.directory / "spectra.h5") as file:
            grid = file["grid"]
            self.y = {"center": grid["y_center"][:], "face": grid["y_face"][:]}
            self.length = dict(zip("xz", grid["length"][:]))
            self.columns = dict(zip("xz", grid["columns"][:].astype(int)))
            self.flow = Means(file["spectra"], case.start[0])
            self.budget = Means(file["budget"], case.start[0]) if "budget" in file else None
            self.interface, self.pairs, self.waves = None, None, None
            if "interface" in file:
                self.interface = Means(file["interface"], case.start[0])
                self.bin_edges = file["interface/bin_edges"][:]
            if "interface_pairs" in file:
                self.pairs = Means(file["interface_pairs"], case.start[0])
                self.pair_edges = {name: file[f"interface_pairs/edges_{name}"][:] for name in ("v", "p", "eta")}
            if "interface_waves" in file:
                waves = file["interface_waves"]
                self.waves = waves["time"][:], waves["real"][:] + 1j * waves["imaginary"][:]

    def heights(self, field):
        """Of the rows of a spectrum: v stands on the faces, without the uppermost."""
        return self.y["face"][:-1] if field == "v" else self.y["center"]

    def wave_numbers(self, axis):
        return 2 * np.pi * np.arange(self.columns[axis] // 2 + 1) / self.length[axis]

    def whole_bins(self, axis):
        """The modes that stand for as much of k as their neighbours: without 0, and without the shortest wave that the grid
        holds, of which there is only half."""
        return slice(1, (self.columns[axis] + 1) // 2)

    def spectrum(self, axis, field):
        """E(k, y) such that the integral over the wave number k > 0 is the mean square: [mode][row]; `field` "eta": [mode]."""
        return self.flow.mean(f"{axis}_{field}") * self.length[axis] / (2 * np.pi)

    def correlation(self, axis, field):
        """R(y, separation), [row][separation], over its value at 0; 0 where nothing moves."""
        return correlation_of(self.flow.mean(f"{axis}_{field}").T, self.columns[axis])


def show_decades(panel, drawn):
    """Logarithmic axes for these spectra, down to their smallest value but not further than MOST_DECADES. A direction of one
    cell has none, and its panel stays empty."""
    drawn = [E for E in drawn if E.size]
    if not drawn:
        return
    largest = max(E.max() for E in drawn)
    smallest = min((E[E > 0].min() for E in drawn if (E > 0).any()), default=largest)
    panel.set(xscale="log", yscale="log", ylim=(max(smallest / 2, largest / 10**MOST_DECADES), 3 * largest))


def correlation_of(power, n):
    """Correlation at 0 .. n/2 columns from the power of the modes in the last axis, over its value at 0."""
    twice = np.full(power.shape[-1], 2.0)
    twice[0] = 1
    if n % 2 == 0:
        twice[-1] = 1
    rows = np.fft.irfft(n * power / twice, n=n)[..., :n // 2 + 1]
    return rows / np.where(rows[..., :1] > 0, rows[..., :1], 1)


def read_spectra(case):
    """None where a case has none in its averaging window; one that cannot be read is named."""
    try:
        spectra = Spectra(case)
    except FileNotFoundError:
        return None
    except (OSError, KeyError) as error:
        tell(f"left out {case.directory / 'spectra.h5'}: {error}")
        return None
    return spectra if spectra.flow else None


def read_interfaces(options):
    """(case, spectra) of every elastic wall that has sums of its interface; ends the script where none has."""
    found = [(case, spectra) for case in read_campaign(options) if case.elastic
             if (spectra := read_spectra(case)) and spectra.interface]
    if not found:
        raise SystemExit("no elastic wall has sums of its interface in its averaging window")
    return found
