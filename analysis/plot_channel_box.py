#!/usr/bin/env python3
"""Rigid channels in boxes of two sizes (runs/validation/channel-box) against Moser, Kim & Mansour, Phys. Fluids 11
(1999): rms of the fluctuations, with 95 % intervals; prints Re_tau and the peaks.
"""

import sys

from campaign_data import arguments, caption, plt, read_campaign, read_reference, save
import batches
from plot_rigid_channel import MOSERS_OWN_RE_TAU, RE_TAU_OF_MOSER, Channel, draw_profile, peak, peak_of

COLUMNS = {"u'": "urms_plus", "v'": "vrms_plus", "w'": "wrms_plus"}


def box_text(case):
    return "{:.3g} x 2 x {:.3g}".format(*case.box)


def row(channel):
    """One line of the table: the box, the cells, Re_tau and the peaks."""
    cells = [box_text(channel.case), channel.case.grid]
    cells.append(batches.text(channel.values["re_tau"], channel.ci95["re_tau"], 1))
    for name in COLUMNS:
        _, height, interval = peak_of(channel, channel.y_plus, name)
        cells.append(batches.text(height, interval, 3))
    return "| " + " | ".join(cells) + " |"


def report(channels, reference):
    print("| box | cells | Re_tau | u'+ peak | v'+ peak | w'+ peak |\n|---|---|---|---|---|---|")
    for channel in channels:
        print(row(channel))
    theirs = [f"{peak(reference['y_plus'], reference[column])[1]:.3f}" for column in COLUMNS.values()]
    cells = ["12.6 x 2 x 4.19", f"Moser et al., peaks at Re_tau {MOSERS_OWN_RE_TAU:g}", f"{RE_TAU_OF_MOSER:g} at this bulk Reynolds number"]
    print("| " + " | ".join(cells + theirs) + " |")


def draw(axes, channels, reference):
    for panel, (name, column) in zip(axes, COLUMNS.items()):
        for number, channel in enumerate(channels):
            draw_profile(panel, channel.y_plus, channel, name, f"C{number}", f"{box_text(channel.case)}, {channel.case.grid}")
        panel.plot(reference["y_plus"], reference[column], "k+", markersize=4, label="Moser et al. (1999)")
        panel.set(xlim=(0, 180), xlabel="$y^+$", ylabel=f"${name}^+$")
    axes[-1].legend(fontsize="x-small")


def main():
    options = arguments(__doc__)
    cases = [case for case in read_campaign(options) if not case.elastic and len(case.weight) >= batches.LEAST]
    if not cases:
        sys.exit(f"no rigid channel has the {batches.LEAST} blocks that intervals need")
    channels = sorted((Channel(case) for case in cases), key=lambda each: (len(each.y), each.case.box))
    reference = read_reference("mkm180_profiles.csv")
    report(channels, reference)
    figure, axes = plt.subplots(1, len(COLUMNS), figsize=(12, 4), layout="constrained")
    draw(axes, channels, reference)
    save(figure, options, __file__, caption(cases))


if __name__ == "__main__":
    main()
