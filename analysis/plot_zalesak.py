#!/usr/bin/env python3
"""Zalesak's disc after one turn beside the disc at the start, for both WENO weights and MTHINC, and its contour error."""

from box_data import LEVEL, read_box_campaign
from campaign_data import arguments, judge, plt, save
from solid_words import TRANSPORTS, transport_of

import numpy as np

FINE = 16  # points a cell on which areas are counted
COLOURS = {"js": "tab:blue", "z": "tab:red", "mthinc": "tab:green"}
BARS = {64: 0.010, 128: 0.004}  # of Jiang-Shu weights, by points per diameter


def inside(phi):
    """Where phi, bilinear between centers, exceeds 1/2, on a grid FINE times as fine."""
    n = phi.shape[0]
    position = (np.arange(n * FINE) + 0.5) / FINE - 0.5
    low = np.clip(np.floor(position).astype(int), 0, n - 2)
    share = position - low
    rows = phi[low] * (1 - share)[:, None] + phi[low + 1] * share[:, None]
    return rows[:, low] * (1 - share) + rows[:, low + 1] * share > LEVEL


def errors(begin, end):
    before, after = inside(begin.phi), inside(end.phi)
    between = np.count_nonzero(before != after) / np.count_nonzero(before)
    spread = np.abs(end.phi - begin.phi).sum() / begin.phi.sum()
    return between, spread, end.phi.sum() / begin.phi.sum() - 1


def main():
    options = arguments(__doc__)
    cases = read_box_campaign(options.campaign, "rotation")
    sizes = sorted({case.cells for case in cases})
    figure, panels = plt.subplots(1, len(sizes), figsize=(5 * len(sizes), 5), layout="constrained", squeeze=False)
    for case in cases:
        panel = panels[0][sizes.index(case.cells)]
        transport = transport_of(case)
        colour, name = COLOURS[transport], TRANSPORTS[transport]
        snapshots = case.snapshots()
        begin, end = snapshots[0], snapshots[-1]
        between, spread, drift = errors(begin, end)
        points = round(2 * case.physics["solid"]["disc"]["radius"] * case.cells)
        print(f"{case.cells} cells a side, {points} points per diameter, {name}, t = {end.time:g}:")
        if transport == "js" and points in BARS:
            judge("  area between the contours / area of the disc", between, BARS[points])
        else:
            print(f"  area between the contours / area of the disc {between:.5f}")
        print(f"  misplaced area (half of it) {between / 2:.5f}; sum |phi - phi_0| / sum phi_0 {spread:.5f}; "
              f"change of sum(phi) {drift:.1e}; phi from {end.phi.min():.4f} to {end.phi.max():.4f}")
        for line in begin.outline() if transport == "js" else []:
            panel.plot(*line.T, color="black", linewidth=1, label="start")
        for line in end.outline():
            panel.plot(*line.T, color=colour, linewidth=1.2, label=f"{name}: {100 * between:.2f} %")
        panel.set(aspect="equal", title=f"{points} points per diameter", xlabel="$x$", ylabel="$y$",
                  xlim=(0.33, 0.67), ylim=(0.58, 0.92))
    for panel in panels[0]:
        handles, labels = panel.get_legend_handles_labels()
        unique = dict(zip(labels, handles))
        panel.legend(unique.values(), unique.keys(), loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=2, fontsize="small")
    save(figure, options, __file__,
         "Lines phi = 1/2 at the start and after one turn; area between them over the area of the disc.")


if __name__ == "__main__":
    main()
