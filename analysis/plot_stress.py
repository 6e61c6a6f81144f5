#!/usr/bin/env python3
"""Shear stress balance of every case: viscous, turbulent and elastic stress add up to the line u_tau_w^2 - P y."""

import math

from campaign_data import arguments, caption, mark_interface, plt, read_campaign, save

PARTS = (("viscous_stress", 1, "viscous", "tab:blue"), ("uv", -1, r"$-\overline{u'v'}$", "tab:orange"),
         ("elastic_stress", 1, "elastic", "tab:green"))


def plot_case(axes, case):
    total = 0.0
    scale = case.mean("wall_shear_bottom")
    for name, sign, label, colour in PARTS:
        if not case.has(name):
            continue
        y, stress = case.mean(name)
        total = total + sign * stress
        axes.plot(y, sign * stress / scale, color=colour, label=label)
    axes.plot(y, total / scale, color="black", label="total")
    line = 1 - case.mean("driving_gradient") * y / scale
    axes.plot(y, line, "r--", linewidth=0.9, label=r"$1-Py/(u^w_\tau)^2$")
    mark_interface(axes)
    axes.set(title=f"{case.name}", xlim=(0, y[-1]))


def main():
    options = arguments(__doc__)
    cases = [case for case in read_campaign(options) if case.has("viscous_stress", "uv")]
    if not cases:
        raise SystemExit("no case holds the profiles viscous_stress and uv")
    columns = min(len(cases), 3)
    rows = math.ceil(len(cases) / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(4 * columns, 3.2 * rows), layout="constrained", squeeze=False)
    for case, panel in zip(cases, axes.flat):
        plot_case(panel, case)
        panel.set(xlabel=r"$y/h$", ylabel=r"shear stress $/(u^w_\tau)^2$")
    for panel in axes.flat[len(cases):]:
        panel.set_axis_off()
    with_most_lines = max(axes.flat, key=lambda panel: len(panel.lines))
    with_most_lines.legend(fontsize="x-small")
    save(figure, options, __file__, caption(cases))


if __name__ == "__main__":
    main()
