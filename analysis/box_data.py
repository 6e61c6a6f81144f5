"""The cases of a campaign in a closed box (runs/validation): their series, their snapshots, contours of phi.

Lengths in the side of the box, velocities in that of the lid; a rotation turns once in a unit of time.
"""

import json
import pathlib
import sys

import h5py
import numpy as np

from campaign_data import plt

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


class BoxCase:
    def __init__(self, directory):
        self.directory = directory
        self.physics = json.loads((directory / "case.json").read_text())["physics"]
        self.cells = self.physics["grid"]["nx"]
        self.files = sorted((directory / "fields").glob("fields-*.h5"))
        self.t, self.series = np.array([]), {}
        statistics = directory / "statistics.h5"
        if statistics.exists():
            with h5py.File(statistics) as file:
                self.t = file["blocks/start"][:] + 0.5 * (file["blocks/end"][:] - file["blocks/start"][:])
                self.series = {name: values[:] for name, values in file["series"].items()}

    def snapshots(self):
        return [Snapshot(file) for file in self.files]

    def last(self):
        return Snapshot(self.files[-1])


def read_box_campaign(folder, flow):
    """All cases of this flow with at least two snapshots, coarsest first; a damaged one is left out by name."""
    cases = []
    for file in sorted(pathlib.Path(folder).glob("cases/*/case.json")):
        try:
            cases.append(BoxCase(file.parent))
        except (OSError, KeyError, ValueError) as error:
            print(f"left out {file.parent}: {error}", file=sys.stderr)
    cases = [case for case in cases if case.physics["flow"] == flow and len(case.files) >= 2]
    if not cases:
        sys.exit(f"no {flow} in {folder} has left snapshots yet; run the campaign first")
    return sorted(cases, key=lambda case: case.cells)
