#!/usr/bin/env python3
"""Mean elastic stress in the wall along the flow and across it (the paper, figure 11)."""

from campaign_data import arguments, caption, mark_interface, plt, read_campaign, save


def normal_stress(case):
    """sigma_11 less what a wall at rest has, so that it is 0 there: phi G (B_xx - 1) of a neo-Hookean solid."""
    y, stress = case.mean("elastic_xx")
    at_rest = case.G * (1 - 2 * case.physics["solid"]["mooney_share"])
    return y, stress - at_rest * case.mean("phi")[1]


def shear_stress(case):
    return case.mean("elastic_stress")


def main():
    options = arguments(__doc__)
    cases = [case for case in read_campaign(options)
             if case.elastic and case.has("elastic_xx", "elastic_stress", "phi")]
    if not cases:
        raise SystemExit("no elastic wall has averages of its stresses yet")
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    for panel, profile, name in zip(axes, (normal_stress, shear_stress), ("11", "12")):
        for case in cases:
            case.draw_profile(panel, profile, label=case.name)
        mark_interface(panel)
        panel.axhline(0, color="grey", linewidth=0.5)
        lowest = min(case.interface_y - 2 * max(case.mean("interface_max"), 0.05) for case in cases)
        panel.set(xlabel=r"$y/h$", ylabel=rf"$\sigma^{{sh}}_{{{name}}}/(\rho U_b^2)$",
                  xlim=(lowest, max(case.y["face"][-1] for case in cases)))
    axes[0].set_title("(a) streamwise, less that of a wall at rest")
    axes[1].set_title("(b) shear")
    axes[1].legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.01, 1))
    save(figure, options, __file__, caption(cases) + " Bands: 95 % intervals.")


if __name__ == "__main__":
    main()
