#!/usr/bin/env python3
"""Rms velocity fluctuations and Reynolds shear stress across the channel (the paper, figure 8)."""

from campaign_data import arguments, caption, mark_interface, mirrored, plt, read_campaign, read_reference, save

import numpy as np

PANELS = (("u", "uu_Ub2"), ("v", "vv_Ub2"), ("w", "ww_Ub2"))


def main():
    options = arguments(__doc__)
    cases = read_campaign(options)
    reference = read_reference("mkm180_profiles_bulk.csv")
    figure, axes = plt.subplots(2, 2, figsize=(11, 7.5), layout="constrained", sharex=True)
    for (name, column), panel in zip(PANELS, axes.flat):
        panel.plot(*mirrored(reference["y_over_h"], np.sqrt(reference[column])), "k+", markersize=4,
                   label="rigid, Moser et al. (1999)")
        for case in cases:
            if case.has(name, 2 * name):
                case.draw_profile(panel, lambda each: each.rms(name), label=case.name)
        panel.set(ylabel=rf"${name}'/U_b$", ylim=(0, None))
    panel = axes[1, 1]
    panel.plot(*mirrored(reference["y_over_h"], reference["uv_Ub2"], -1), "k+", markersize=4)
    for case in cases:
        if case.has("uv"):
            case.draw_profile(panel, lambda each: each.mean("uv"))
    panel.set(ylabel=r"$\overline{u'v'}/U_b^2$")
    for panel in axes.flat:
        mark_interface(panel)
    for panel in axes[1]:
        panel.set(xlabel=r"$y/h$", xlim=(0, None))
    axes[0, 0].legend(fontsize="x-small")
    save(figure, options, __file__, caption(cases) + " Bands: 95 % intervals.")


if __name__ == "__main__":
    main()
