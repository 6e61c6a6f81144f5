#!/usr/bin/env python3
"""Lid-driven cavity at Re = 100: u along the vertical centreline beside Ghia, Ghia and Shin (1982)."""

from box_data import read_box_campaign
from campaign_data import arguments, judge, plt, read_reference, save

import numpy as np

# Against the table's grid, 129 x 129; some of its entries are off by this much against later, finer solutions.
BAR = 0.005


def centreline(snapshot):
    """y and u(1/2, y), walls included. Centers lie beside the line when the number of cells is even."""
    n = len(snapshot.x)
    u = snapshot.u[:, n // 2] if n % 2 else (snapshot.u[:, n // 2 - 1] + snapshot.u[:, n // 2]) / 2
    return np.concatenate([[0], snapshot.y, [1]]), np.concatenate([[0], u, [1]])


def main():
    options = arguments(__doc__)
    ghia = read_reference("ghia1982_re100_u_vertical_centreline.csv")
    cases = read_box_campaign(options.campaign, "cavity")
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4.2), layout="constrained")
    for case, shade in zip(cases, np.linspace(0.7, 0, len(cases))):
        end, before = case.last(), case.snapshots()[-2]
        y, u = centreline(end)
        difference = np.interp(ghia["y"], y, u) - ghia["u"]
        change = np.abs(end.u - before.u).max()
        print(f"{case.cells} x {case.cells} cells, t = {end.time:.2f} (changed by {change:.1e} since {before.time:.1f}):")
        judge("  largest difference from the table", np.abs(difference).max(), BAR)
        print(f"  rms {np.sqrt(np.mean(difference**2)):.5f}; least u {u.min():.5f}")
        left.plot(u, y, color=str(shade), label=f"{case.cells}$^2$")
        right.plot(difference, ghia["y"], "o-", color=str(shade), markersize=3, linewidth=0.8)
    left.plot(ghia["u"], ghia["y"], "rs", markerfacecolor="none", label="Ghia et al. (1982)")
    left.set(xlabel="$u$ at $x = 1/2$", ylabel="$y$")
    left.legend(fontsize="small")
    right.set(xlabel="difference from the table", ylabel="$y$")
    right.axvline(0, color="red", linewidth=0.6)
    right.locator_params(axis="x", nbins=5)
    save(figure, options, __file__, "Steady state from rest; Crank-Nicolson viscosity.")


if __name__ == "__main__":
    main()
