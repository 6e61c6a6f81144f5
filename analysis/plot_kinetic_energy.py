#!/usr/bin/env python3
"""Turbulent kinetic energy across the channel in the units of each wall (the paper, figure 9)."""

from campaign_data import arguments, caption, mark_interface, mirrored, plt, read_campaign, read_reference, save


def kinetic_energy(case):
    """y and K = (u'^2 + v'^2 + w'^2) / 2, U_b^2."""
    y, uu = case.mean("uu")
    total = uu + case.mean("vv")[1] + case.mean("ww")[1]
    return y, (total - sum(case.mean(name)[1] ** 2 for name in "uvw")) / 2


def in_units_of(wall):
    """K over the square of the friction velocity u_tau or u_tau_w."""

    def profile(case):
        y, energy = kinetic_energy(case)
        return y, energy / getattr(case, wall) ** 2

    return profile


def main():
    options = arguments(__doc__)
    cases = [case for case in read_campaign(options) if case.has("uu", "vv", "ww")]
    reference = read_reference("mkm180_profiles.csv")
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    for panel, wall, unit in zip(axes, ("u_tau_w", "u_tau"), (r"(u_\tau^w)^2", r"u_\tau^2")):
        panel.plot(*mirrored(reference["y_over_h"], reference["k_plus"]), "k+", markersize=4, label="rigid, Moser et al. (1999)")
        for case in cases:
            case.draw_profile(panel, in_units_of(wall), label=case.name)
        mark_interface(panel)
        panel.set(xlabel=r"$y/h$", ylabel=rf"$\mathcal{{K}}/{unit}$", xlim=(0, None), ylim=(0, None))
    axes[0].set_title("(a) units of the bottom wall")
    axes[1].set_title("(b) units of the upper wall")
    axes[1].legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.01, 1))
    save(figure, options, __file__, caption(cases) + " Bands: 95 % intervals.")


if __name__ == "__main__":
    main()
