#!/usr/bin/env python3
"""One-dimensional spectra of velocity and pressure along x and z, 0.15 h below the upper wall (where the paper's figure 13
lies) and in the middle of the channel, from what the solver has summed in the averaging window."""

from campaign_data import arguments, grids_of, plt, read_campaign, save
from spectra_data import FIELDS, read_spectra, show_decades

import numpy as np

UNITS = {"u": "U_b^2h", "v": "U_b^2h", "w": "U_b^2h", "p": r"\rho^2U_b^4h"}
NEAR_WALL = 0.15  # h below the interface


def spectrum_at(spectra, axis, field, y):
    """k > 0 and E at the height y, between the rows on both sides."""
    heights, rows = spectra.heights(field), spectra.spectrum(axis, field)
    above = int(np.clip(np.searchsorted(heights, y), 1, len(heights) - 1))
    share = (y - heights[above - 1]) / (heights[above] - heights[above - 1])
    shown = spectra.whole_bins(axis)
    return spectra.wave_numbers(axis)[shown], ((1 - share) * rows[:, above - 1] + share * rows[:, above])[shown]


def draw(panel, found, axis, field):
    drawn = []
    for case, spectra in found:
        for y, width, label in ((case.interface_y - NEAR_WALL, 1.3, case.name), (case.interface_y / 2, 0.5, None)):
            k, E = spectrum_at(spectra, axis, field, y)
            case.draw(panel, k, E, linewidth=width, label=label)
            drawn.append(E)
    show_decades(panel, drawn)
    panel.set(xlabel=rf"$k_{axis}h$",
              ylabel=rf"$E_{{{2 * field}}}(k_{axis})/({UNITS[field]})$")


def main():
    options = arguments(__doc__)
    found = [(case, spectra) for case in read_campaign(options) if (spectra := read_spectra(case))]
    if not found:
        raise SystemExit("no case has spectra in its averaging window")
    figure, rows = plt.subplots(2, len(FIELDS), figsize=(3.3 * len(FIELDS) + 1.5, 6.5), layout="constrained")
    for axis, panels in zip("xz", rows):
        for field, panel in zip(FIELDS, panels):
            draw(panel, found, axis, field)
    rows[0, -1].legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.01, 1))
    save(figure, options, __file__, f"Grid {grids_of(case for case, _ in found)}. Thick: {NEAR_WALL:g} h below the upper wall; "
                                    "thin: middle of the channel. The integral over k is the mean square.")


if __name__ == "__main__":
    main()
