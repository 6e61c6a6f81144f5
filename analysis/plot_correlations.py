#!/usr/bin/env python3
"""Correlation of each velocity component with itself along x or z, at every height from the middle of the channel to half
of the elastic wall (the paper, figures 14 and 15): from the spectra that the solver has summed in the averaging window, or
where a case has none from all snapshots there and the newest checkpoint."""

from campaign_data import arguments, grids_of, levels_within, plt, read_campaign, save
from correlations import AXES, source_of

import numpy as np
from matplotlib.artist import Artist

LEVELS = (-0.1, 0.1, 0.3, 0.5, 0.7, 0.9)  # the paper's


def draw(panel, source, name, axis):
    case, (separation, y, rows) = source.case, source.rows(name, axis)
    top = case.interface_y + case.layer_height / 2 if case.elastic else case.interface_y
    shades = panel.contourf(separation, y, np.clip(rows, -0.1, 1), levels=np.linspace(-0.1, 1, 23), cmap="Greys")
    for shade in [shades] if isinstance(shades, Artist) else shades.collections:  # before matplotlib 3.8
        shade.set_rasterized(True)  # in a vector figure the lines alone are vectors
    for level in levels_within(rows, LEVELS):
        panel.contour(separation, y, rows, levels=[level], colors="tab:orange", linewidths=1.4 if level > 0 else 0.6,
                      linestyles="solid")
    panel.axhline(case.interface_y, color="tab:blue", linewidth=0.6)
    panel.set(xlim=(0, separation[-1]), ylim=(case.interface_y / 2, top))
    return shades


def main():
    options = arguments(__doc__, lambda parser: parser.add_argument("--axis", choices=AXES, default="x"))
    found = [source for case in read_campaign(options) if case.physics["grid"]["n" + options.axis] > 1 and (source := source_of(case))]
    if not found:
        raise SystemExit("no case has spectra, a snapshot or a checkpoint")
    figure, rows = plt.subplots(3, len(found), figsize=(2.6 * len(found) + 1.5, 7.5), layout="constrained", squeeze=False,
                                sharex="col", sharey="col")
    for column, source in zip(rows.T, found):
        for panel, name in zip(column, "uvw"):
            shades = draw(panel, source, name, options.axis)
        column[0].set_title(f"{source.case.name}\n{source.words}", fontsize="small")
        column[-1].set_xlabel(rf"${options.axis}/h$")
    for panel, name in zip(rows[:, 0], "uvw"):
        panel.set_ylabel(rf"${name}'$:  $y/h$")
    figure.colorbar(shades, ax=rows.ravel().tolist(), shrink=0.5, ticks=[0, 0.25, 0.5, 0.75, 1], label=r"$R_{ii}$")
    few = "" if all(source.is_of_all_samples for source in found) else " Few moments leave large separations uncertain."
    grids = grids_of(source.case for source in found)
    save(figure, options, __file__, f"Grid {grids}. Lines: -0.1 (thin), 0.1, 0.3, 0.5, 0.7, 0.9 (thick); blue: the mean "
                                    f"interface.{few}")


if __name__ == "__main__":
    main()
