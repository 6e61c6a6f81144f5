"""The flow of a case at single moments: its snapshots in fields/ and its newest checkpoint.

Fields are [z][y][x] at the centres of the cells, in units of h, U_b and density 1.
"""

import contextlib
import weakref

from campaign_data import tell

import h5py
import numpy as np

DUST = 0.02  # a row with less of the solid fraction ends the solid that hangs from the upper wall
NEIGHBOUR = {"u": 2, "v": 1, "w": 0}  # along which axis a velocity component stands between the centres


class FlowField:
    """One file. The constructor raises OSError or KeyError where it cannot be read. A checkpoint stays open for as long as this
    lives, because a case that runs removes it when it has written newer ones."""

    def __init__(self, case, file):
        self.case, self.file = case, file
        self.is_checkpoint = file.name.startswith("checkpoint-")
        self._kept = h5py.File(file) if self.is_checkpoint else None
        if self._kept:
            weakref.finalize(self, self._kept.close)
        with self._opened() as data:
            self.time = float(np.ravel(data["time"][()])[0])
            self._names = set(data["fields"] if self.is_checkpoint else data)

    def _opened(self):
        return contextlib.nullcontext(self._kept) if self._kept else h5py.File(self.file)

    def _read(self, name, rows=slice(None)):
        with self._opened() as data:
            return data[f"fields/{name}" if self.is_checkpoint else name][:, rows].astype(float)

    def field(self, name, rows=slice(None)):
        """u, v, w or p, or phi where the file holds it, in these rows of cells; no others are read. A checkpoint has velocities
        on the faces of the cells."""
        if not self.is_checkpoint or name not in NEIGHBOUR:
            return self._read(name, rows)
        if name == "v":
            first, end, _ = rows.indices(len(self.case.y["center"]))
            values = self._read(name, slice(first, end + 1))
            return (values[:, :-1] + values[:, 1:]) / 2
        values = self._read(name, rows)
        return (values + np.roll(values, -1, axis=NEIGHBOUR[name])) / 2

    def fluctuation(self, name):
        """u, v or w less its mean over time and plane."""
        return self.field(name) - self.case.mean(name)[1][:, None]

    def plane(self, name, y):
        """[z][x]: u, v, w or p at the height y."""
        return self.on_surface(name, np.full((1, 1), y))

    def plane_of_fluctuation(self, name, y):
        return self.plane(name, y) - np.interp(y, *self.case.mean(name))

    def on_surface(self, name, height):
        """[z][x]: u, v, w or p at a height over every column."""
        centres = self.case.y["center"]
        row = np.clip(np.searchsorted(centres, height) - 1, 0, len(centres) - 2)
        share = np.clip((height - centres[row]) / (centres[row + 1] - centres[row]), 0, 1)
        first = row.min()
        values = self.field(name, slice(first, row.max() + 2))
        row = np.broadcast_to(row - first, (values.shape[0], values.shape[2]))
        at = lambda rows: np.take_along_axis(values, rows[:, None, :], axis=1)[:, 0, :]
        return (1 - share) * at(row) + share * at(row + 1)

    def interface_height(self):
        """eta[z][x], h, as the solver counts it. With a reference map: where the material is that lay at the interface. Else from
        phi: the lower end of all solid that hangs from the upper wall."""
        return self._height_of_material() if "d_y" in self._names else self._height_by_volume()

    def _height_by_volume(self):
        phi = self._read("phi")[:, ::-1]
        above = np.cumprod(phi >= DUST, axis=1)  # 1 as long as no row of dust has been met
        counts = np.concatenate([np.ones_like(above[:, :1]), above[:, :-1]], axis=1)
        thickness = np.diff(self.case.y["face"])[::-1]
        return self.case.y["face"][-1] - np.einsum("kji,j->ki", phi * counts, thickness)

    def _height_of_material(self):
        y = self.case.y["face" if self.is_checkpoint else "center"]
        origin = (y[:, None] - self._read("d_y"))  # where the material there lay at rest
        below = origin < self.case.interface_y
        row = len(y) - 1 - np.argmax(below[:, ::-1], axis=1)  # the highest place below the surface
        row = np.clip(row, 0, len(y) - 2)
        low, high = (np.take_along_axis(origin, rows[:, None, :], axis=1)[:, 0, :] for rows in (row, row + 1))
        share = np.clip((self.case.interface_y - low) / (high - low), 0, 1)
        return y[row] + share * (y[row + 1] - y[row])


def autocorrelation(values, axis):
    """Circular autocorrelation along one axis (Wiener and Khinchin), for separations up to half the period; not divided by
    its value at 0."""
    n = values.shape[axis]
    spectrum = abs(np.fft.rfft(values, axis=axis)) ** 2
    return np.take(np.fft.irfft(spectrum, n=n, axis=axis), range(n // 2 + 1), axis=axis)


def _readable(case, file):
    """One that cannot be read is left out by name."""
    try:
        return FlowField(case, file)
    except FileNotFoundError:
        raise
    except (OSError, KeyError) as error:
        tell(f"left out {file}: {error}")
        return None


def _newest_checkpoint(case):
    """The newest that can be read, or None. One may be removed between the two looks, when there is a newer one."""
    while files := sorted(case.directory.glob("checkpoints/checkpoint-*.h5"), key=lambda file: file.name, reverse=True):
        try:
            return next(filter(None, (_readable(case, file) for file in files)), None)
        except FileNotFoundError:
            continue
    return None


def flow_fields(case):
    """All moments of a case that are on the disk, in the order of time."""
    files = sorted(case.directory.glob("fields/fields-*.h5"))
    found = {}
    for field in [*(_readable(case, file) for file in files), _newest_checkpoint(case)]:
        if field is not None:
            found.setdefault(field.time, field)
    return [found[time] for time in sorted(found)]


def newest(case):
    """The last moment of a case, or None."""
    fields = flow_fields(case)
    return fields[-1] if fields else None
