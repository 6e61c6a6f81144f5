#!/usr/bin/env python3
"""The height of the interface: its spectra along x and z, and the probability density of its deviation from its mean, from
what the solver has summed in the averaging window."""

from campaign_data import arguments, grids_of, plt, save
from spectra_data import read_interfaces, show_decades

import numpy as np

RMS_SHOWN = 5  # of the height, on either side


def spectrum(spectra, axis):
    """k > 0 and E of the height."""
    shown = spectra.whole_bins(axis)
    return spectra.wave_numbers(axis)[shown], spectra.spectrum(axis, "eta")[shown]


def density(spectra):
    """Deviation over its rms and density times the rms, in the bins; skewness and flatness. NaN of a flat interface."""
    variance, third, fourth = (spectra.interface.mean(f"eta{n}") for n in (2, 3, 4))
    rms = np.sqrt(variance) or np.nan
    edges = spectra.bin_edges / rms
    return ((edges[1:] + edges[:-1]) / 2, spectra.interface.mean("share") / np.diff(edges),
            third / rms**3, fourth / rms**4)


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
    """Beside a normal distribution."""
    x = np.linspace(-RMS_SHOWN, RMS_SHOWN, 201)
    panel.plot(x, np.exp(-x**2 / 2) / np.sqrt(2 * np.pi), color="grey", linewidth=0.8, label="normal distribution")
    for case, spectra in found:
        deviation, values, skewness, flatness = density(spectra)
        shown = (values > 0) & (abs(deviation) <= RMS_SHOWN)
        case.draw(panel, deviation[shown], values[shown],
                  label=f"{case.name}: skewness {skewness:.2f}, flatness {flatness:.2f}")
    panel.set(yscale="log", xlim=(-RMS_SHOWN, RMS_SHOWN), ylim=(1e-5, 1), xlabel=r"$(\eta-\overline{\eta})/\eta'$",
              ylabel=r"density $\times\,\eta'$", title="(c)")
    panel.legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.01, 1))


def main():
    options = arguments(__doc__)
    found = read_interfaces(options)
    figure, panels = plt.subplots(1, 3, figsize=(15, 4.5), layout="constrained")
    draw_spectra(panels[:2], found)
    draw_density(panels[2], found)
    save(figure, options, __file__, f"Grid {grids_of(case for case, _ in found)}. Height: lower end of the solid over each "
                                    "column. Into the layer is up, positive.")


if __name__ == "__main__":
    main()
