#!/usr/bin/env python3
"""Friction Reynolds number of both walls against the modulus G, from results.db, beside the paper's table 1, with the
modulus below which linear theory lets waves of the interface grow on a turbulent mean flow (linear_stability.py)."""

import math

import linear_stability
import mean_profiles
from campaign_data import LABEL_G, arguments, caption, plt, read_campaign, save
from case_style import line_of
from paper_points import draw_paper

WALLS = ("re_tau", "re_tau_w")  # upper wall: full symbols; bottom wall: open ones
SIDEWAYS = 1.05  # factor on G of walls whose viscosity is not the fluid's, so that walls of equal G stand side by side
WAVELENGTHS = (0.75, 1, 1.5)  # among which the first wave to grow is found at thicknesses near 0.5, h
RIGID_LINES = ("-", "--", "-.", ":")  # of one on each grid


def marker_of(case):
    return case.marker or ("o" if case.ratio == 1 else ("v" if case.ratio < 1 else "^"))


def plot_elastic(axes, case):
    G = case.G * (1 if case.ratio == 1 else 1 / SIDEWAYS if case.ratio < 1 else SIDEWAYS)
    for quantity in WALLS:
        value, half_width = case.result(quantity), case.result(quantity + "_ci95")
        unknown = math.isnan(half_width)
        axes.errorbar(G, value, None if unknown else half_width, marker=marker_of(case), capsize=3, color=case.colour,
                      markerfacecolor=case.colour if quantity == "re_tau" else "white", linestyle="none",
                      alpha=0.4 if unknown else 1.0, label=case.name if quantity == "re_tau" else None)


def of_both_walls(case):
    """Re_tau of a rigid channel from the drag of both of its walls, which are alike."""
    return math.hypot(case.result("re_tau"), case.result("re_tau_w")) / math.sqrt(2)


def plot_campaign(axes, cases):
    rigid = 0
    for case in cases:
        if math.isnan(case.result("re_tau")):
            continue
        if case.elastic:
            plot_elastic(axes, case)
        else:
            value, line = of_both_walls(case), RIGID_LINES[rigid % len(RIGID_LINES)]
            rigid += 1
            on = f" on {case.grid}" if case.varied else ""
            axes.axhline(value, color="black", linewidth=0.7, linestyle=line, label=f"rigid channel{on}, {value:.1f}")


def plot_onset(axes, cases):
    """A line for each viscosity ratio: waves grow to the left of it. The mean flow is Cess's at the Reynolds number of
    the cases."""
    layers = sorted({(case.reynolds, case.layer_height, case.ratio) for case in cases if case.elastic})
    for reynolds, thickness, ratio in layers:
        lengths = [length * thickness / 0.5 for length in WAVELENGTHS]
        found = linear_stability.onset(mean_profiles.cess(reynolds), linear_stability.Layer(1.0, ratio, thickness), lengths)
        if found:
            style = line_of(ratio)
            words = "" if len(layers) == 1 else rf", $\mu^s/\mu^f={ratio:g}$"
            axes.axvline(found[0], color="0.5", linewidth=0.9, linestyle=style,
                         label=f"waves grow below $G={found[0]:.2f}$ (linear theory{words})")


def words_of_places(cases):
    """Where points stand that are not at their G."""
    if all(case.ratio == 1 for case in cases if case.elastic):
        return ""
    return (f"\nWalls less viscous than the fluid stand {100 * (SIDEWAYS - 1):.0f} % to the left of their G, more viscous ones as far "
            "to the right.")


def main():
    options = arguments(__doc__)
    cases = read_campaign(options)
    if not any(case.results for case in cases):
        raise SystemExit(f"no results in {options.campaign}/results.db; run `softwall run` there first")
    figure, axes = plt.subplots(figsize=(9, 5), layout="constrained")
    draw_paper(axes, ("re_tau", "x", "paper, upper wall"), ("re_tau_w", "+", "paper, bottom wall"))
    plot_campaign(axes, cases)
    plot_onset(axes, cases)
    axes.set(xscale="log", xlabel=LABEL_G, ylabel=r"$Re_\tau$, $Re_\tau^w$")
    axes.set_xticks([0.25, 0.5, 1, 2, 4], ["0.25", "0.5", "1", "2", "4"], minor=False)
    axes.minorticks_off()
    axes.legend(fontsize="x-small", loc="center left", bbox_to_anchor=(1.01, 0.5))
    save(figure, options, __file__, f"{caption(cases)}\nFull symbols: upper wall; open: bottom wall. Bars: 95 % confidence; pale "
                                    f"symbols: none can be given.{words_of_places(cases)}")


if __name__ == "__main__":
    main()
