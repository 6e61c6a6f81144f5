#!/usr/bin/env python3
"""Correlation of each velocity component with itself along x or z, at every height from the middle of the channel to half
of the elastic wall (the paper, figures 14 and 15): from the spectra that the solver has summed in the averaging window, or
where a case has none from all snapshots there and the newest checkpoint."""

from campaign_data import arguments, grids_of, levels_within, plt, read_campaign, save
from flow_fields import autocorrelation, flow_fields
from spectra_data import read_spectra

import numpy as np
from matplotlib.artist import Artist

LEVELS = (-0.1, 0.1, 0.3, 0.5, 0.7, 0.9)  # the paper's
AXES = {"x": 2, "z": 0}  # of a field [z][y][x]


def correlation(fluctuations, axis):
    """R(y, separation) of fields [z][y][x] along an axis, averaged over the other axis and all fields, over its value at 0;
    0 where nothing moves."""
    total = sum(autocorrelation(field, axis).mean(axis=2 - axis) for field in fluctuations)
    rows = total if axis == 2 else total.T
    return rows / np.where(rows[:, :1] > 0, rows[:, :1], 1)


def moments_of(case):
    """What lies in the averaging window, or the last moment if nothing does."""
    moments = flow_fields(case)
    inside = [moment for moment in moments if moment.time >= case.start[0]]
    return inside or moments[-1:]


class FromSpectra:
    """What a panel shows of a case whose spectra have been summed."""

    def __init__(self, case, spectra):
        self.case, self.spectra = case, spectra
        self.words = f"{spectra.flow.weight.sum():.0f} $h/U_b$ sampled"

    def rows(self, name, axis):
        return self.spectra.heights(name), self.spectra.correlation(axis, name)


class FromMoments:
    """The same from single moments of the flow."""

    def __init__(self, case, moments):
        self.case, self.moments = case, moments
        self.words = f"{len(moments)} moment{'s' if len(moments) > 1 else ''}"

    def rows(self, name, axis):
        return self.case.y["center"], correlation((moment.fluctuation(name) for moment in self.moments), AXES[axis])


def source_of(case):
    """Of the correlations of a case, or None."""
    if spectra := read_spectra(case):
        return FromSpectra(case, spectra)
    moments = moments_of(case)
    return FromMoments(case, moments) if moments else None


def draw(panel, source, name, axis):
    case, (y, rows) = source.case, source.rows(name, axis)
    length = case.box["xz".index(axis)]
    separation = np.linspace(0, length / 2, rows.shape[1])
    top = case.interface_y + case.layer_height / 2 if case.elastic else case.interface_y
    shades = panel.contourf(separation, y, np.clip(rows, -0.1, 1), levels=np.linspace(-0.1, 1, 23), cmap="Greys")
    for shade in [shades] if isinstance(shades, Artist) else shades.collections:  # before matplotlib 3.8
        shade.set_rasterized(True)  # in a vector figure the lines alone are vectors
    for level in levels_within(rows, LEVELS):
        panel.contour(separation, y, rows, levels=[level], colors="tab:orange", linewidths=1.4 if level > 0 else 0.6,
                      linestyles="solid")
    panel.axhline(case.interface_y, color="tab:blue", linewidth=0.6)
    panel.set(xlim=(0, length / 2), ylim=(case.interface_y / 2, top))
    return shades


def main():
    options = arguments(__doc__, lambda parser: parser.add_argument("--axis", choices=AXES, default="x"))
    found = [source for case in read_campaign(options) if case.physics["grid"]["n" + options.axis] > 1 and (source := source_of(case))]
    if not found:
        raise SystemExit("no case has spectra, a snapshot or a checkpoint")
    figure, rows = plt.subplots(3, len(found), figsize=(2.6 * len(found) + 1.5, 7.5), layout="constrained", squeeze=False,
                                sharex=True, sharey="col")
    for column, source in zip(rows.T, found):
        for panel, name in zip(column, "uvw"):
            shades = draw(panel, source, name, options.axis)
        column[0].set_title(f"{source.case.name}\n{source.words}", fontsize="small")
        column[-1].set_xlabel(rf"${options.axis}/h$")
    for panel, name in zip(rows[:, 0], "uvw"):
        panel.set_ylabel(rf"${name}'$:  $y/h$")
    figure.colorbar(shades, ax=rows.ravel().tolist(), shrink=0.5, ticks=[0, 0.25, 0.5, 0.75, 1], label=r"$R_{ii}$")
    few = "" if all(isinstance(source, FromSpectra) for source in found) else " Few moments leave large separations uncertain."
    grids = grids_of(source.case for source in found)
    save(figure, options, __file__, f"Grid {grids}. Lines: -0.1 (thin), 0.1, 0.3, 0.5, 0.7, 0.9 (thick); blue: the mean "
                                    f"interface.{few}")


if __name__ == "__main__":
    main()
