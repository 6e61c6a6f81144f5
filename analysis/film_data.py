"""The films of a case: what its files in planes/ hold, moment by moment, in units of h, U_b and density 1."""

from campaign_data import tell

import h5py
import numpy as np

AXES = "xyz"
NAMES = {"x": ("z", "y"), "y": ("x", "z"), "z": ("x", "y")}  # axes of a picture, to the right and up, by the axis across it


class Moment:
    """One file. The constructor raises OSError or KeyError where it cannot be read."""

    def __init__(self, file):
        self.file = file
        with h5py.File(file) as data:
            self.time = float(data["moment/time"][0])
            self.faces = {axis: data[f"grid/{axis}_face"][:] for axis in AXES}
            self.places = {name: float(data[f"{name}/position"][0]) for name in data if name not in ("moment", "grid")}

    def plane(self, name, quantity):
        """Numbers of one plane, "y_0", or of the "interface", as a picture has them, [upwards][to the right]. None where the
        file has no such numbers."""
        with h5py.File(self.file) as data:
            if f"{name}/{quantity}" not in data:
                return None
            values = data[f"{name}/{quantity}"][:].astype(float)
        return values.T if self.axis(name) == "x" else values

    @staticmethod
    def axis(name):
        """The axis that a plane lies across."""
        return "y" if name == "interface" else name[0]

    def corners(self, name):
        """Faces of the cells to the right and upwards in the picture of a plane, h."""
        return [self.faces[axis] for axis in NAMES[self.axis(name)]]

    def centres(self, name):
        return [(faces[1:] + faces[:-1]) / 2 for faces in self.corners(name)]


def moments_of(case, start=None):
    """All moments of a case from the time `start` on that are on the disk, in the order of time; one that cannot be read is
    left out by name."""
    moments = []
    for file in sorted(case.directory.glob("planes/planes-*.h5")):
        try:
            moment = Moment(file)
        except (OSError, KeyError) as error:
            tell(f"left out {file}: {error}")
            continue
        if start is None or moment.time >= start - 1e-9 * max(1.0, abs(start)):
            moments.append(moment)
    return sorted(moments, key=lambda moment: moment.time)


def nearest_in_time(moments, time):
    """The last moment where no time is given."""
    return moments[-1] if time is None else min(moments, key=lambda moment: abs(moment.time - time))


def largest(moments, names, quantity):
    """Largest magnitude in any of these planes, but for the outermost thousandth of the cells: a scale for all moments."""
    planes = (moment.plane(name, quantity) for moment in moments for name in names)  # a film may be larger than the memory
    return float(max((np.quantile(abs(values), 0.999) for values in planes if values is not None), default=0.0))
