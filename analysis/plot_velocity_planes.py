#!/usr/bin/env python3
"""Streamwise velocity fluctuation at the last moment that is on the disk, in two planes along the upper wall: at
(yt + d)+ = 10 and at yt = 0.15 (the paper, figures 12 and 13)."""

import math

from campaign_data import arguments, grids_of, levels_within, plt, read_campaign, save, with_friction
from flow_fields import newest

import numpy as np

RANGE = 0.35  # U_b, the paper's colour scale
LEVELS = (-4, 4)  # of u'+, black lines
NEAR_PLUS, FAR = 10, 0.15  # (yt + d)+; yt, h


def near_plane(case):
    """yt at which (yt + d)+ = 10; d = 0 where no log law was fitted."""
    d = case.result("d")
    return NEAR_PLUS / (case.u_tau * case.reynolds) - (0.0 if math.isnan(d) else d)


def draw_plane(panel, case, moment, yt):
    y = case.interface_y - yt
    fluctuation = moment.plane_of_fluctuation("u", y)
    length_x, length_z = case.box
    shades = panel.imshow(fluctuation, origin="lower", extent=(0, length_x, 0, length_z), cmap="RdBu_r", vmin=-RANGE,
                          vmax=RANGE, interpolation="bilinear")
    x, z = ((np.arange(n) + 0.5) / n * length for n, length in zip(fluctuation.shape[::-1], (length_x, length_z)))
    plus = fluctuation / case.u_tau
    for level in levels_within(plus, LEVELS):
        panel.contour(x, z, plus, levels=[level], colors="black", linewidths=0.6)
    panel.set(xlabel=r"$x/h$", ylabel=r"$z/h$")
    return shades


def main():
    options = arguments(__doc__)
    cases = with_friction(read_campaign(options))
    moments = [(case, moment) for case in cases if (moment := newest(case)) is not None]
    if not moments:
        raise SystemExit("no case has a snapshot or a checkpoint")
    figure, rows = plt.subplots(len(moments), 2, figsize=(11, 2.8 * len(moments) + 0.6), layout="constrained", squeeze=False)
    for (case, moment), panels in zip(moments, rows):
        for panel, yt in zip(panels, (near_plane(case), FAR)):
            shades = draw_plane(panel, case, moment, yt)
            panel.set_title(f"{case.name}, " + (r"$(\tilde{y}+d)^+=10$, " if panel is panels[0] else "")
                            + rf"$\tilde{{y}}={yt:.3g}h$, t = {moment.time:.1f}", fontsize="small")
    figure.colorbar(shades, ax=rows.ravel().tolist(), location="bottom", shrink=0.4, aspect=40, label=r"$u'/U_b$")
    grids = grids_of(case for case, _ in moments)
    save(figure, options, __file__, f"Grid {grids}. The flow goes along x. Lines: $u'^+=\\pm4$ in units of the upper wall.")


if __name__ == "__main__":
    main()
