#!/usr/bin/env python3
"""What a smeared interface does to an elastic layer in laminar flow (runs/validation/interface-drift): the growth rate of
a small wave, window by window, and the damping of the layer's swing; prints the tables that its README shows.

The swing is the lowest mode uniform in x of fluid, layer and the pressure gradient P(t) that holds the flow rate,
  u = P/s + a e^{-k y} + b e^{-k (2 - y)} in the fluid,  k = sqrt(s / nu),
  u = P/s + c cosh(q z) + d sinh(q z), z = y - 2, in the layer,  q = sqrt(s / M),  M = nu_s + G / s,
with u = 0 on both walls, u and its stress continuous at the interface, and no flow: s from the determinant.
"""

import math

from campaign_data import FLUID_HEIGHT, arguments, caption, plt, read_campaign, save
from solid_words import option_of

import numpy as np

WINDOW = 20.0  # of time, for one growth rate
STARTED = 6.0  # time after which the sudden start has become the slowest mode


def determinant(s, G, nu, nu_s, thickness):
    k, M = np.sqrt(s / nu), nu_s + G / s
    q, decay = np.sqrt(s / M), np.exp(-k * FLUID_HEIGHT)
    rows = [[1 / s, 1, decay, 0, 0],  # wall under the fluid
            [0, decay, 1, -1, 0],  # velocity at the interface
            [0, -nu * k * decay, nu * k, 0, -M * q],  # stress there
            [1 / s, 0, 0, np.cosh(q * thickness), np.sinh(q * thickness)],  # wall above the layer
            [FLUID_HEIGHT / s, (1 - decay) / k, (1 - decay) / k, 0, 0]]  # flow of the fluid
    return np.linalg.det(np.array(rows, dtype=complex))


def swing_of_theory(G, nu, nu_s, thickness):
    """Secant from the mode of a layer under a fluid without viscosity."""
    before = complex(-0.03, math.pi / 2 * math.sqrt(G) / thickness)
    now = before * 1.0001
    at_before, at_now = (determinant(s, G, nu, nu_s, thickness) for s in (before, now))
    for _ in range(100):
        if abs(now - before) <= 1e-12 * abs(now):
            break
        before, now, at_before = now, now - at_now * (now - before) / (at_now - at_before), at_now
        at_now = determinant(now, G, nu, nu_s, thickness)
    return now


def middle(case):
    return (case.start + case.end) / 2


def growth_rates(case):
    """(end of the window, slope of log rms) for each window from t = 20 on."""
    if "interface_variance" not in case.series:
        return []
    t, rms = middle(case), np.sqrt(case.series["interface_variance"])
    rates = []
    for end in np.arange(2 * WINDOW, case.end[-1] + 0.5, WINDOW):
        inside = (t > end - WINDOW) & (t < end) & (rms > 0)
        if inside.sum() > 2:
            rates.append((end, np.polyfit(t[inside], np.log(rms[inside]), 1)[0]))
    return rates


def measured_swing(case, guess):
    """The complex rate of the driving gradient's oscillation about a line, by least squares: a search around the guess
    that halves its steps where no neighbour is better. None where there are too few blocks."""
    t, gradient = middle(case), case.series["driving_gradient"]
    used = t > STARTED
    if used.sum() < 10:
        return None
    t, gradient = t[used] - STARTED, gradient[used]

    def misfit(s):
        wave = np.exp(s * t)
        basis = np.column_stack([np.ones_like(t), t, wave.real, wave.imag])
        return np.linalg.norm(gradient - basis @ np.linalg.lstsq(basis, gradient, rcond=None)[0])

    best, least, step = guess, misfit(guess), 0.1
    while step > 1e-6:
        around = [best + step * complex(a, b) for a in (-1, 0, 1) for b in (-1, 0, 1)]
        misfits = [misfit(s) for s in around]
        if min(misfits) < least:
            best, least = around[int(np.argmin(misfits))], min(misfits)
        else:
            step /= 2
    return best


def theory_for(case):
    nu, thickness = 1 / case.reynolds, case.layer_height
    return swing_of_theory(case.G, nu, nu * case.ratio, thickness)


def swings(case):
    return case.physics["initial"]["amplitude"] == 0


def print_waves(cases):
    print("| grid | solid | growth rate, windows of 20 h/U_b from t = 20 | width at the end, cells |")
    print("|---|---|---|---|")
    for case in cases:
        rates = ", ".join(f"{rate:.5f}" for _, rate in growth_rates(case))
        width = case.series.get("interface_width_cells")
        print(f"| {case.grid} | {option_of(case)} | {rates or '-'} | {'-' if width is None else f'{width[-1]:.2f}'} |")


def print_swings(cases):
    print("| grid | solid | rate | frequency | theory |")
    print("|---|---|---|---|---|")
    for case in cases:
        theory = theory_for(case)
        s = measured_swing(case, theory)
        seen = f"{s.real:+.4f} | {s.imag:.4f}" if s is not None else "- | -"
        print(f"| {case.grid} | {option_of(case)} | {seen} | {theory.real:+.4f}, {theory.imag:.4f} |")


def main():
    options = arguments(__doc__)
    cases = sorted((case for case in read_campaign(options) if case.elastic),
                   key=lambda case: (int(case.grid.split("x")[0]), len(case.grid), case.grid, option_of(case)))
    waves, swinging = [c for c in cases if not swings(c)], [c for c in cases if swings(c)]
    print_waves(waves)
    print_swings(swinging)
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 4.5), layout="constrained")
    for case in waves:
        rates = growth_rates(case)
        left.plot([end - WINDOW / 2 for end, _ in rates], [rate for _, rate in rates], "o-",
                  label=f"{option_of(case)}, {case.grid}")
    left.set(xlabel=r"$t U_b/h$", ylabel=r"growth rate, $U_b/h$")
    coarsest = swinging[0].grid if swinging else ""
    for case in swinging or waves:
        if case.grid == coarsest or not swinging:
            right.plot(middle(case), case.series["driving_gradient"], linewidth=0.8, label=f"{option_of(case)}, {case.grid}")
    right.set(xlabel=r"$t U_b/h$", ylabel="driving gradient")
    for panel in (left, right):
        panel.legend(fontsize="xx-small")
    save(figure, options, __file__, caption(cases))


if __name__ == "__main__":
    main()
