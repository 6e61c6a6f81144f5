#!/usr/bin/env python3
"""Which events the interface and the flow share: joint probability densities of v', p' and the height at the mean interface,
with their correlation coefficients, from what the solver has summed in the averaging window."""

import copy

from campaign_data import arguments, grids_of, plt, save
from spectra_data import read_interfaces

import numpy as np
from matplotlib import colors

PAIRS = (("v", "eta"), ("p", "eta"), ("v", "p"))
LABEL = {"v": "$v'$ / its rms", "p": "$p'$ / its rms", "eta": r"$(\eta-\overline{\eta})$ / its rms"}
SQUARE = {"v": "vv", "p": "pp", "eta": "eta2"}
MOMENT = {("v", "eta"): "v_eta", ("p", "eta"): "p_eta", ("v", "p"): "vp"}
RMS_SHOWN = 4  # of each quantity, on either side
DECADES = 3  # of shades


def of_one_time(spectra):
    """The same spectra, but with means over the time of which there are both sums of the interface and joint distributions, which
    an earlier version of the solver did not have."""
    if not spectra.pairs:
        return spectra
    begin = max(spectra.interface.start[0], spectra.pairs.start[0])
    rest = copy.copy(spectra)
    rest.interface, rest.pairs = spectra.interface.since(begin), spectra.pairs.since(begin)
    return rest


def rms(spectra, name):
    return np.sqrt(spectra.interface.mean(SQUARE[name]))


def correlation(spectra, pair):
    """Of the exact moments, which all cases with sums of their interface have; NaN where nothing moves."""
    product = rms(spectra, pair[0]) * rms(spectra, pair[1])
    return spectra.interface.mean(MOMENT[pair]) / product if product > 0 else np.nan


def density(spectra, pair):
    """Edges of the bins over the rms, of the first and of the second of a pair, and the density times both rms,
    [bin of the first][bin of the second]."""
    first, second = (spectra.pair_edges[name] / rms(spectra, name) for name in pair)
    share = spectra.pairs.mean(f"share_{pair[0]}_{pair[1]}")
    return first, second, share / np.outer(np.diff(first), np.diff(second))


def share_beyond(spectra, pair):
    """What lies in the outermost bins of either, which hold all beyond."""
    share = spectra.pairs.mean(f"share_{pair[0]}_{pair[1]}")
    return share.sum() - share[1:-1, 1:-1].sum()


def draw_normal(panel, coefficient):
    """Lines of a normal distribution with this correlation, within which its density is above exp(-1/2) and exp(-2) of the
    largest."""
    angle = np.linspace(0, 2 * np.pi, 181)
    for radius in (1, 2):
        x = radius * np.cos(angle)
        y = coefficient * x + np.sqrt(1 - coefficient**2) * radius * np.sin(angle)
        panel.plot(x, y, color="tab:orange", linewidth=0.8)


def draw(panel, spectra, pair):
    """Shades, or None where there are none to draw. The second of the pair lies along x."""
    coefficient = correlation(spectra, pair)
    panel.set(xlim=(-RMS_SHOWN, RMS_SHOWN), ylim=(-RMS_SHOWN, RMS_SHOWN), title=f"correlation {coefficient:.2f}",
              xlabel=LABEL[pair[1]], ylabel=LABEL[pair[0]])
    if not spectra.pairs or np.isnan(coefficient):
        panel.text(0.5, 0.5, "no joint distribution\nin the averaging window", ha="center", va="center",
                   transform=panel.transAxes)
        return None
    first, second, values = density(spectra, pair)
    shades = panel.pcolormesh(second[1:-1], first[1:-1], np.maximum(values[1:-1, 1:-1], 10.0**-DECADES), cmap="Greys",
                              rasterized=True, norm=colors.LogNorm(10.0**-DECADES, 1))
    draw_normal(panel, coefficient)
    return shades


def words_of_bins(found):
    """How far the bins reach, and what lies beyond them."""
    found = [spectra for _, spectra in found if spectra.pairs]
    if not found:
        return ""
    ends = {name: min(spectra.pair_edges[name][-2] for spectra in found) for name in LABEL}
    beyond = max(share_beyond(spectra, pair) for spectra in found for pair in PAIRS)
    return (f" The bins end at {ends['v']:.2g} $U_b$ ($v'$), {ends['p']:.2g} $\\rho U_b^2$ ($p'$) and {ends['eta']:.2g} $h$; at most "
            f"{100 * beyond:.2g} % of the interface lie beyond.")


def main():
    options = arguments(__doc__)
    found = [(case, of_one_time(spectra)) for case, spectra in read_interfaces(options)]
    figure, panels = plt.subplots(len(PAIRS), len(found), figsize=(2.8 * len(found) + 1.5, 9), layout="constrained",
                                  squeeze=False)
    shades = [draw(panel, spectra, pair) for column, (_, spectra) in zip(panels.T, found)
              for panel, pair in zip(column, PAIRS)]
    for panel, (case, _) in zip(panels[0], found):
        panel.set_title(f"{case.name}\n{panel.get_title()}")
    if drawn := next((each for each in shades if each), None):
        figure.colorbar(drawn, ax=panels.ravel().tolist(), shrink=0.5, label="density, times the rms of both")
    save(figure, options, __file__, f"Grid {grids_of(case for case, _ in found)}. Fluctuations about the mean over the plane, at "
                                    "the mean interface; into the layer is up, positive. Lines: a normal distribution with "
                                    f"this correlation, one and two rms.{words_of_bins(found)}")


if __name__ == "__main__":
    main()
