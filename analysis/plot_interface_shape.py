#!/usr/bin/env python3
"""The height of the interface: its spectra along x and z, and the probability density of its deviation from its mean, from
what the solver has summed in the averaging window."""

import math

from campaign_data import arguments, grids_of, plt, save
from spectra_data import read_interfaces, show_decades

import numpy as np

RMS_SHOWN = 5  # of the height, on either side
LEAST_BINS = 2  # of the height in an rms: from fewer no density can be seen


def spectrum(spectra, axis):
    """k > 0 and E of the height."""
    shown = spectra.whole_bins(axis)
    return spectra.wave_numbers(axis)[shown], spectra.spectrum(axis, "eta")[shown]


def rms_of(spectra):
    return math.sqrt(spectra.interface.mean("eta2"))


def shape_of(spectra):
    """Skewness and flatness, from sums that know no bins; NaN of a flat interface."""
    rms = rms_of(spectra) or math.nan
    return spectra.interface.mean("eta3") / rms**3, spectra.interface.mean("eta4") / rms**4


def is_resolved(spectra):
    return rms_of(spectra) >= LEAST_BINS * np.diff(spectra.bin_edges).max()


def density(spectra):
    """Bounds of the bins over the rms, and the density times the rms in each; NaN of a flat interface."""
    edges = spectra.bin_edges / (rms_of(spectra) or math.nan)
    return edges, spectra.interface.mean("share") / np.diff(edges)


def normal_density(edges):
    """Of a normal distribution with rms 1, the mean over each bin."""
    below = np.array([math.erf(edge / math.sqrt(2)) / 2 for edge in edges])
    return np.diff(below) / np.diff(edges)


def draw_spectra(panels, found):
    for axis, panel in zip("xz", panels):
        drawn = []
        for case, spectra in found:
            k, E = spectrum(spectra, axis)
            case.draw(panel, k, E, label=case.name)
            drawn.append(E)
        show_decades(panel, drawn)
        panel.set(xlabel=rf"$k_{axis}h$",
                  ylabel=rf"$E_{{\eta\eta}}(k_{axis})/h^3$", title=f"({'ab'['xz'.index(axis)]}) along {axis}")


def draw_density(panel, found):
    """Beside a normal distribution in the same bins. Walls that have too few bins are in the legend alone, which also names the
    lines of the other panels."""
    for case, spectra in found:
        edges, values = density(spectra)
        middle = (edges[1:] + edges[:-1]) / 2
        inside = (abs(middle) <= RMS_SHOWN) & is_resolved(spectra)
        shown = inside & (values > 0)
        panel.plot(middle[inside], normal_density(edges)[inside], color="grey", linewidth=0.8)
        case.draw(panel, middle[shown], values[shown],
                  label="{}: skewness {:.2f}, flatness {:.2f}".format(case.name, *shape_of(spectra)))
    panel.plot([], [], color="grey", linewidth=0.8, label="normal distribution in the same bins")
    panel.set(yscale="log", xlim=(-RMS_SHOWN, RMS_SHOWN), ylim=(1e-5, 1), xlabel=r"$(\eta-\overline{\eta})/\eta'$",
              ylabel=r"density $\times\,\eta'$", title="(c)")
    panel.legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.01, 1))


def words_of_bins(found):
    """What (c) leaves out."""
    names = ", ".join(case.name for case, spectra in found if not is_resolved(spectra))
    return f" Not drawn in (c), because the rms is below {LEAST_BINS} bins of the height: {names}." if names else ""


def main():
    options = arguments(__doc__)
    found = read_interfaces(options)
    figure, panels = plt.subplots(1, 3, figsize=(15, 4.5), layout="constrained")
    draw_spectra(panels[:2], found)
    draw_density(panels[2], found)
    save(figure, options, __file__, f"Grid {grids_of(case for case, _ in found)}. Height: lower end of the solid over each "
                                    f"column. Into the layer is up, positive.{words_of_bins(found)}")


if __name__ == "__main__":
    main()
