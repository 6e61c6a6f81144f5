#!/usr/bin/env python3
"""Friction Reynolds numbers of both walls and the deformation of the interface block by block, from t = 0 on, so that the
transient and the averaging window can be judged by eye."""

from campaign_data import SeriesCase, arguments, caption, plt, read_campaign, save
from transient import end_of_transient

import numpy as np


def panels_of(case, series):
    """What stands in the four panels; nothing where a rigid wall has none."""
    variance = series.get("interface_variance")
    return [*case.re_tau_by_block(series), series.get("interface_max"), None if variance is None else np.sqrt(variance)]


def main():
    options = arguments(__doc__)
    cases = read_campaign(options, any_state=True)
    averaged = [case for case in cases if case.has_averages]
    figure, axes = plt.subplots(2, 2, figsize=(11, 6.5), sharex=True, layout="constrained")
    for case in cases:
        whole = SeriesCase(case.directory)  # also what lies before the averaging window
        for panel, values in zip(axes.flat, panels_of(case, whole.series)):
            if values is not None:
                case.draw(panel, whole.t, values, label=case.name, linewidth=1)
        end = end_of_transient(case)
        if end is not None:
            for panel in axes[1 if case.elastic else 0]:
                panel.plot(end, 0.02, "^", color=case.colour, markersize=6, transform=panel.get_xaxis_transform())
        if case.elastic and case.has_averages:
            for panel in axes.flat:
                panel.axvline(case.start[0], color="0.6", linewidth=0.6, zorder=0)
    labels = (r"$Re_\tau$, upper wall", r"$Re_\tau^w$, bottom wall", r"$\delta/h$", r"$\delta'/h$")
    for panel, label in zip(axes.flat, labels):
        panel.set_ylabel(label)
        if not panel.lines:
            panel.text(0.5, 0.5, "no elastic wall", ha="center", va="center", transform=panel.transAxes)
    for panel in axes[1]:
        panel.set_xlabel(r"$t\,U_b/h$")
        panel.set_ylim(bottom=0)
    axes[0, 1].legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.01, 1))
    save(figure, options, __file__, (caption(averaged) if averaged else "No averages yet.") +
         "\nGrey: where the averages of the elastic walls begin. Each point is the mean of a block.\n"
         "Triangles at the bottom: where the transient of a case seems to end.")


if __name__ == "__main__":
    main()
