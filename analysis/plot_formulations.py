#!/usr/bin/env python3
"""The same walls carried by both formulations of the solid: rms of the interface and friction in the course of time, a
column a modulus (runs/validation/formulations); prints the means over the averaging window side by side."""

import argparse
import math

from campaign_data import arguments, plt, read_campaign, save
from solid_words import formulation_of

import numpy as np

LINES = {"reference_map": "-", "transported_B": "--"}


def cells_along_x(grid):
    return int(grid.split("x")[0])


def print_table(cases):
    print("| cells | G | solid | Re_tau | Re_tau, rigid wall | delta | delta' | width, cells | volume |\n" + "|---" * 9 + "|")
    for case in cases:
        width, volume = (case.series.get(name, [math.nan])[-1] for name in ("interface_width_cells", "solid_volume"))
        at_rest = case.box[0] * case.box[1] * case.layer_height
        print(f"| {case.grid} | {case.G:g} | {formulation_of(case)} | {case.result_text('re_tau', 1)} | {case.result_text('re_tau_w', 1)} | "
              f"{case.result_text('delta_max', 4)} | {case.result_text('delta_rms', 4)} | {width:.1f} | {volume / at_rest - 1:+.1e} |")


def draw(column, cases, grids):
    for case in cases:
        look = {"color": f"C{grids.index(case.grid)}", "linestyle": LINES[case.physics["solid"]["formulation"]],
                "label": f"{case.grid}, {formulation_of(case)}"}
        t = (case.start + case.end) / 2
        if "interface_rms" in case.series:
            column[0].plot(t, case.series["interface_rms"], **look)
        column[1].plot(t, case.re_tau_by_block(case.series)[0], **look)
    column[0].set(title=f"$G={cases[0].G:g}$", ylabel="rms of the interface, $h$", ylim=(0, None))
    column[1].set(xlabel="$t$, $h/U_b$", ylabel=r"$Re_\tau$, elastic wall")


def main():
    options = arguments(__doc__)
    print_table(sorted((case for case in read_campaign(options) if case.elastic),
                       key=lambda case: (cells_along_x(case.grid), -case.G, formulation_of(case))))
    whole = argparse.Namespace(**{**vars(options), "start": 0.0})
    cases = [case for case in read_campaign(whole) if case.elastic]
    moduli, grids = sorted({case.G for case in cases}, reverse=True), sorted({case.grid for case in cases}, key=cells_along_x)
    figure, axes = plt.subplots(2, len(moduli), figsize=(4 + 3 * len(moduli), 7), sharex=True, layout="constrained", squeeze=False)
    for column, G in zip(axes.T, moduli):
        draw(column, [case for case in cases if case.G == G], grids)
    axes[0, 0].legend(fontsize="xx-small")
    length = np.median(np.concatenate([case.end - case.start for case in cases]))
    save(figure, options, __file__, f"Every point is the mean over a block of {length:g} $h/U_b$, from the start on.")


if __name__ == "__main__":
    main()
