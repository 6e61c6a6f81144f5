#!/usr/bin/env python3
"""Mean velocity across the channel, and in wall units of the bottom wall (the paper, figure 5)."""

from campaign_data import arguments, caption, mark_interface, mirrored, plt, read_campaign, read_reference, save

import numpy as np


def plot_outer(axes, cases, reference):
    axes.plot(*mirrored(reference["y_over_h"], reference["U_over_Ub"]), "k+", markersize=5,
              label=r"rigid, Moser et al. (1999), $Re_\tau=178$")
    for case in cases:
        case.draw_profile(axes, lambda each: each.mean("u"), label=case.name)
    mark_interface(axes)
    axes.set(xlabel=r"$y/h$", ylabel=r"$\overline{u}/U_b$", xlim=(0, None), ylim=(0, None), title="(a)")


def plot_wall_units(axes, cases, reference):
    axes.plot(reference["y_plus"], reference["U_plus"], "k+", markersize=5)
    for case in cases:
        y, u = case.mean("u")
        below = (y > 0) & (y <= case.interface_y) & (np.arange(len(y)) <= np.argmax(u))
        case.draw(axes, y[below] * case.u_tau_w * case.reynolds, u[below] / case.u_tau_w)
    near, far = np.geomspace(0.8, 11), np.geomspace(9, 250)
    axes.plot(near, near, "k--", linewidth=0.8, label=r"$y^{w+}$")
    axes.plot(far, np.log(far) / 0.40 + 5.5, "k:", linewidth=0.8, label=r"$\ln y^{w+}/0.40+5.5$")
    axes.set(xscale="log", xlabel=r"$y^{w+}$", ylabel=r"$\overline{u}^{w+}$", xlim=(0.8, 300), ylim=(0, 22),
             title="(b) bottom wall, up to the maximum")
    axes.legend(fontsize="small")


def main():
    options = arguments(__doc__)
    cases = read_campaign(options)
    figure, (outer, wall) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    plot_outer(outer, cases, read_reference("mkm180_profiles_bulk.csv"))
    plot_wall_units(wall, cases, read_reference("mkm180_profiles.csv"))
    outer.legend(fontsize="x-small", loc="lower center")
    save(figure, options, __file__, caption(cases) + " Bands in (a): 95 % intervals.")


if __name__ == "__main__":
    main()
