"""The cases of a campaign in a closed box (runs/validation): their series, their snapshots, contours of phi.

Lengths in the side of the box, velocities in that of the lid; a rotation turns once in a unit of time.
"""

import sys

from campaign_data import SeriesCase, plt, read_series_campaign

import h5py
import numpy as np

LEVEL = 0.5


class Snapshot:
    """Fields at one moment, cell centers, [y][x]."""

    def __init__(self, file):
        with h5py.File(file) as data:
            self.time = float(np.ravel(data["time"][()])[0])
            self.x, self.y = ((edges[1:] + edges[:-1]) / 2 for edges in (data["x"][:], data["y"][:]))
            self.u, self.v = data["u"][0], data["v"][0]
            self.phi = data["phi"][0] if "phi" in data else None

    def outline(self):
        """Closed lines phi = 1/2, linear between centers, each as (points, 2)."""
        figure = plt.figure()
        lines = figure.gca().contour(self.x, self.y, self.phi, [LEVEL]).allsegs[0]
        plt.close(figure)
        return lines


class BoxCase(SeriesCase):
    def __init__(self, directory):
        super().__init__(directory)
        self.files = sorted((directory / "fields").glob("fields-*.h5"))

    def snapshots(self):
        return [Snapshot(file) for file in self.files]

    def last(self):
        return Snapshot(self.files[-1])


def read_box_campaign(folder, flow):
    """All cases of this flow with at least two snapshots, coarsest first; a damaged one is left out by name."""
    cases = [case for case in read_series_campaign(folder, flow, BoxCase) if len(case.files) >= 2]
    if not cases:
        sys.exit(f"no {flow} in {folder} has left snapshots yet; run the campaign first")
    return cases
