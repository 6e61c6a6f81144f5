#!/usr/bin/env python3
"""The elastic disc in the lid-driven cavity: its shapes at six times, and its path beside Sugiyama et al. (2011)."""

from box_data import read_box_campaign
from campaign_data import arguments, judge, plt, read_reference, save

import numpy as np

TIMES = (1.17, 2.34, 3.51, 4.69, 5.86, 7.03)
END = 20.0
# Largest departures allowed: of the reference's points from our path, of the path's turning points, of the area.
MEAN_DISTANCE, LARGEST_DISTANCE, TURNING, DRIFT = 0.004, 0.010, 0.005, 0.001
TURNING_POINTS = (("x", "min", 0.289), ("y", "max", 0.868), ("x", "max", 0.702))


def path_of(case):
    """Times and centroid, the start included."""
    disc = case.physics["solid"]["disc"]
    kept = case.t <= END
    centroid = np.column_stack([case.series["centroid_x"], case.series["centroid_y"]])[kept]
    return np.insert(case.t[kept], 0, 0), np.insert(centroid, 0, (disc["x"], disc["y"]), axis=0)


def distances(points, path):
    """Distance of each point from the polyline."""
    start, along = path[:-1], np.diff(path, axis=0)
    square = np.maximum((along**2).sum(axis=1), 1e-300)

    def distance(point):
        share = np.clip(((point - start) * along).sum(axis=1) / square, 0, 1)
        return np.hypot(*(point - start - share[:, None] * along).T).min()

    return np.array([distance(point) for point in points])


def print_bars(case, reference):
    t, path = path_of(case)
    off = distances(reference, path)
    print(f"{case.cells} x {case.cells} cells, path to t = {t[-1]:.2f}:")
    judge("  mean distance of the reference's points from the path", off.mean(), MEAN_DISTANCE)
    judge("  largest", off.max(), LARGEST_DISTANCE)
    moved = path[np.argmax(path[:, 0] < 0.5):]  # x-max of the loop, not of the start
    for axis, end, wanted in TURNING_POINTS:
        found = getattr(np, end)(moved[:, "xy".index(axis)])
        judge(f"  {axis}-{end} {found:.4f}, reference {wanted}: difference", abs(found - wanted), TURNING)
    area = case.series["area"]
    judge("  largest drift of the area", np.abs(area / area[0] - 1).max(), DRIFT)
    print(f"  interface {case.series['interface_width_cells'][-1]:.2f} cells wide at the end; "
          f"largest |det B - 1| {case.series['max_det_error'].max():.3f}; "
          f"least eigenvalue of B {case.series['min_eigenvalue'].min():.3f}")


def plot_shapes(panels, case, style):
    snapshots = [snapshot for snapshot in case.snapshots() if snapshot.time > 0]
    for time, panel in zip(TIMES, panels):
        nearest = min(snapshots, key=lambda snapshot: abs(snapshot.time - time))
        if abs(nearest.time - time) > 0.05:
            continue
        for line in nearest.outline():
            panel.plot(*line.T, **style)


def main():
    options = arguments(__doc__)
    table = read_reference("cavity_disc_sugiyama_centroid_path.csv")
    reference = np.column_stack([table["x"], table["y"]])
    cases = [case for case in read_box_campaign(options.campaign, "cavity") if case.t.size and case.t[-1] > TIMES[-1]]
    figure = plt.figure(figsize=(13, 5.2), layout="constrained")
    grid = figure.add_gridspec(2, 5)
    shapes = [figure.add_subplot(grid[n // 3, n % 3]) for n in range(len(TIMES))]
    path_panel = figure.add_subplot(grid[:, 3:])
    for case, shade in zip(cases, np.linspace(0.7, 0, len(cases)) if len(cases) > 1 else [0]):
        print_bars(case, reference)
        style = {"color": str(shade), "linewidth": 1}
        plot_shapes(shapes, case, style)
        path_panel.plot(*path_of(case)[1].T, label=f"{case.cells}$^2$", **style)
    for time, panel in zip(TIMES, shapes):
        panel.set(title=f"$t = {time}$", xlim=(0, 1), ylim=(0, 1), aspect="equal", xticks=[0, 1], yticks=[0, 1])
    path_panel.plot(*reference.T, "ro", markersize=3, markerfacecolor="none", label="Sugiyama et al. (2011)")
    path_panel.set(xlabel="$x$", ylabel="$y$", aspect="equal", title="path of the centroid", ylim=(0.4, 0.9))
    path_panel.legend(fontsize="small", loc="lower left")
    save(figure, options, __file__, "Lines phi = 1/2; Re = 100, G = 0.1, equal viscosities and densities.")


if __name__ == "__main__":
    main()
