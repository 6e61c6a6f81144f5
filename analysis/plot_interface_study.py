#!/usr/bin/env python3
"""Drag, deformation and log-law shift against G for each formulation of the solid and each of its options, grid by
grid (runs/validation/interface-study); prints the table that its README shows."""

import math

from campaign_data import LABEL_G, arguments, caption, plt, read_campaign, save
from paper_points import draw_paper
from solid_words import option_of

PANELS = (("re_tau", r"$Re_\tau$, elastic wall"), ("delta_max", r"$\delta/h$"), ("delta_u_plus", r"$\Delta U^+$"))
MARKERS = "osv^D<>"
SIDEWAYS = 1.03  # factor on G from one option to the next, so that walls of equal G stand side by side


def extreme(case, name, of):
    return f"{of(case.series[name]):.2g}" if name in case.series else "-"


def print_table(cases):
    print("| grid | G | solid | Re_tau | delta | Delta U+ | width, cells | least eigenvalue | max abs(det B - 1) | t |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for case in cases:
        print(f"| {case.grid} | {case.G:g} | {option_of(case)} | {case.result_text('re_tau', 1)} | "
              f"{case.result_text('delta_max', 3)} | {case.result_text('delta_u_plus', 1)} | "
              f"{extreme(case, 'interface_width_cells', lambda width: width[-1])} | "
              f"{extreme(case, 'min_eigenvalue', min)} | {extreme(case, 'max_det_error', max)} | {case.end[-1]:g} |")


def main():
    options = arguments(__doc__)
    cases = [case for case in read_campaign(options) if case.elastic]
    names, grids = (sorted({of(case) for case in cases}) for of in (option_of, lambda case: case.grid))
    cases.sort(key=lambda case: (case.grid, -case.G, option_of(case)))
    print_table(cases)
    figure, axes = plt.subplots(len(grids), 3, figsize=(13, 4 * len(grids)), layout="constrained", squeeze=False)
    for case in cases:
        n = names.index(option_of(case))
        for panel, (quantity, _) in zip(axes[grids.index(case.grid)], PANELS):
            interval = case.result(quantity + "_ci95")
            panel.errorbar(case.G * SIDEWAYS ** (n - len(names) // 2), case.result(quantity),
                           None if math.isnan(interval) else interval, marker=MARKERS[n % len(MARKERS)],
                           color=f"C{n}", capsize=3, linestyle="none", label=option_of(case))
    for row, grid in zip(axes, grids):
        for panel, (quantity, label) in zip(row, PANELS):
            draw_paper(panel, (quantity, "x", "paper"))
            panel.set(xscale="log", xlabel=LABEL_G, ylabel=label, title=grid, xlim=(0.2, 2.5))
            panel.set_xticks([0.25, 0.5, 1, 2], ["0.25", "0.5", "1", "2"], minor=False)
            panel.minorticks_off()
    handles, labels = axes[0, 0].get_legend_handles_labels()
    first = dict(zip(labels[::-1], handles[::-1]))
    axes[0, 0].legend(first.values(), first.keys(), fontsize="xx-small")
    save(figure, options, __file__, f"{caption(cases)} Bars: 95 % confidence. Walls of equal G stand side by side, "
                                    f"{100 * (SIDEWAYS - 1):.0f} % of it apart.")


if __name__ == "__main__":
    main()
