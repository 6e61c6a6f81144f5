#!/usr/bin/env python3
"""Log law at the upper wall and how its origin is chosen (the paper, figure 6). Fits come from results.db."""

import math

from campaign_data import arguments, caption, case_called, plt, read_campaign, save, with_friction

import numpy as np


def upper_wall_profile(case):
    """yt+ and U+ from the upper wall down to the maximum of U, in its own wall units; yt = 2 - y."""
    y, u = case.mean("u")
    keep = (y < case.interface_y) & (np.arange(len(y)) >= np.argmax(u))
    yt = (case.interface_y - y[keep])[::-1]
    return yt * case.u_tau * case.reynolds, u[keep][::-1] / case.u_tau


def shift_plus(case):
    """d+ of the fit; 0 where there is none."""
    d = case.result("d")
    return 0.0 if math.isnan(d) else d * case.u_tau * case.reynolds


def fitted_line(case, shifted):
    """(yt + d)+ and U+ of the fitted log law, from below the range of its fit to beyond the maximum of U; None without a
    fit. `shifted`: (yt + d)+ of the profile."""
    k, shift, low = (case.result(name) for name in ("k_plus_dk", "delta_u_plus", "log_range_low_plus"))
    if math.isnan(k) or not shifted[-1] > 0:
        return None
    d = shift_plus(case)
    begin = max(15 + d, 0.4 * ((37 if math.isnan(low) else low) + d), 0.02 * shifted[-1])
    line = np.geomspace(begin, 1.3 * shifted[-1])
    return line, np.log(line) / k + 5.5 - shift


def plot_profiles(axes, cases):
    """The shift of a very soft wall may be negative: what then lies at or below the log law's origin has no place on a
    logarithmic axis and is left out."""
    for case in cases:
        yt, u = upper_wall_profile(case)
        shifted = yt + shift_plus(case)
        above = shifted > 0
        case.draw(axes, shifted[above], u[above], label=case.name)
        line = fitted_line(case, shifted)
        if line is not None:
            axes.plot(*line, "-.", color=case.colour, linewidth=0.7)
    axes.set(xscale="log", xlabel=r"$(\tilde{y}+d)^+$", ylabel=r"$\overline{u}^+$", ylim=(0, 22),
             title="(a) upper wall; thin, dash-dotted: fitted log laws")
    axes.legend(fontsize="small")


def choose_case(cases, wanted):
    if wanted:
        return case_called(wanted, cases)
    fitted = [case for case in cases if not math.isnan(case.result("d"))] or cases
    return min(fitted, key=lambda case: abs(math.log(case.G / 2)) if case.elastic else math.inf)


def plot_indicator(axes, case):
    """Xi = (yt + d)+ dU+/dyt+, which the right d makes flat."""
    yt, u = upper_wall_profile(case)
    middle, shear = 0.5 * (yt[1:] + yt[:-1]), np.diff(u) / np.diff(yt)
    d = shift_plus(case)
    length = case.u_tau * case.reynolds
    for factor, style in ((0, "-"), (1, "--"), (2, "-.")) if d else ((0, "-"),):
        axes.plot(middle, (middle + factor * d) * shear, style, color=case.colour,
                  label=rf"$d={factor * d / length:.3f}\,h$")
    k = case.result("k_plus_dk")
    if not math.isnan(k):
        axes.axhline(1 / k, color="black", linewidth=0.6, label=rf"$1/(k+\Delta k)$, $k+\Delta k={k:.3f}$")
    low, high = case.result("log_range_low_plus"), case.result("log_range_high_plus")
    if high > low:
        axes.axvspan(low, high, color="0.93", label="range of the fit")
    axes.set(xlabel=r"$\tilde{y}^+$", ylabel=r"$(\tilde{y}+d)^+\,d\overline{u}^+/d\tilde{y}^+$", xlim=(0, yt[-1]),
             ylim=(0, None), title=f"(b) {case.name}")
    axes.legend(fontsize="small")


def main():
    options = arguments(__doc__, lambda parser: parser.add_argument("--case", help="label of the case of panel (b)"))
    cases = with_friction(read_campaign(options))
    figure, (profiles, indicator) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    plot_profiles(profiles, cases)
    plot_indicator(indicator, choose_case(cases, options.case))
    fits = "" if any(case.results for case in cases) else " No results.db: no fits drawn, d = 0."
    save(figure, options, __file__, caption(cases) + fits)


if __name__ == "__main__":
    main()
