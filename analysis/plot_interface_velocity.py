#!/usr/bin/env python3
"""Velocity fluctuations at the mean interface against the softness of the wall, and how the shift of the log law goes with
them (the paper, figure 7). Fits of the log law come from results.db."""

import math

from campaign_data import arguments, caption, plt, read_campaign, save

import batches
import numpy as np

COMPONENTS = (("u", "-", "o"), ("v", "--", "s"), ("w", "-.", "^"))  # the paper's lines
K_RIGID = 0.40  # slope of the log law over a rigid wall, from which the paper counts Dk


def at_interface(case, name):
    """rms of a fluctuation at y = 2: in the first row of the wall above it, of v on the face that lies there. (Between the
    rows on both sides the fluid's shear would count.)"""
    mean, square = ("v_face", "vv_face") if name == "v" else (name, 2 * name)
    y, of_mean = case.mean(mean)
    row = np.searchsorted(y, case.interface_y - 1e-9)
    return math.sqrt(max(case.mean(square)[1][row] - of_mean[row] ** 2, 0.0))


def error_bar(panel, x, y, case, *, x_width=None, y_width=None, marker="o", label=None):
    finite = lambda width: None if width is None or math.isnan(width) else width
    panel.errorbar(x, y, xerr=finite(x_width), yerr=finite(y_width), color=case.colour, marker=marker, capsize=3,
                   markersize=5, markerfacecolor=case.colour if case.ratio == 1 else "none", label=label)


def plot_softness(panel, cases):
    """The lines join the walls whose viscosity is the fluid's, those that differ in G alone."""
    families = [case.varied for case in cases if case.ratio == 1]
    families = [varied for n, varied in enumerate(families) if varied not in families[:n]]
    for name, line, marker in COMPONENTS:
        for n, varied in enumerate(families):
            joined = [(1 / case.G, at_interface(case, name)) for case in cases if case.ratio == 1 and case.varied == varied]
            panel.plot(*np.array(sorted(joined)).reshape(-1, 2).T, line, color="black", linewidth=0.9 / (1 + n),
                       label=f"${name}'$" if n == 0 else None)
        for case in cases:
            error_bar(panel, 1 / case.G, at_interface(case, name), case, marker=marker,
                      y_width=batches.half_width(case, lambda each: at_interface(each, name)))
    panel.set(xlabel=r"$\rho U_b^2/G$", ylabel=r"rms at $y=2h$, $U_b$", xlim=(0, None), ylim=(0, None),
              title=r"(a) open symbols: $\mu^s/\mu^f\neq1$")
    panel.legend(fontsize="small")


def plot_shift(panel, cases):
    """Only walls with a fit whose slope differs from the rigid wall's by more than its interval."""
    largest = 1.0
    for case in cases:
        shift, change = case.result("delta_u_plus"), abs(case.result("k_plus_dk") - K_RIGID)
        width = case.result("k_plus_dk_ci95")  # NaN where no interval could be given: nobody knows whether it differs
        if math.isnan(shift) or math.isnan(width) or change <= width:
            continue
        scaled = at_interface(case, "v") / case.u_tau / change
        largest = max(largest, scaled, shift)
        error_bar(panel, scaled, shift, case, y_width=case.result("delta_u_plus_ci95"),
                  x_width=scaled * width / change, label=case.name)
    if panel.containers:
        panel.plot([0, largest], [0, largest], "k-", linewidth=0.8)
        panel.legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.01, 1))
    else:
        panel.text(0.5, 0.5, "no wall whose log law has a slope\nother than the rigid wall's", ha="center", va="center",
                   transform=panel.transAxes)
    panel.set(xlabel=r"$v'^+/|\Delta k|$", ylabel=r"$\Delta U^+$",
              title=r"(b) line: $\Delta U^+=v'^+/|\Delta k|$, the paper's relation")


def main():
    options = arguments(__doc__)
    cases = [case for case in read_campaign(options) if case.elastic and case.has("vv_face", "uu", "ww")]
    if not cases:
        raise SystemExit("no elastic wall has averages yet")
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    plot_softness(axes[0], cases)
    plot_shift(axes[1], cases)
    save(figure, options, __file__, caption(cases) + " Bars: 95 % intervals.")


if __name__ == "__main__":
    main()
