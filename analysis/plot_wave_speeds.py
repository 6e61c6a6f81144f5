#!/usr/bin/env python3
"""Spectrum of the interface in wave number and frequency: which waves there are, and how fast they travel, beside the waves
that linear theory knows on the case's own mean flow (linear_stability.py)."""

import linear_stability
import mean_profiles
from campaign_data import arguments, grids_of, plt, read_campaign, save
from spectra_data import read_spectra
from wave_spectrum import space_time_spectrum

import numpy as np
from matplotlib import colors

SEGMENT = 20.0  # h/U_b; its inverse is the width of a bin of frequency
DECADES = 4  # of shades, below the largest value of each wave number
SLOWEST, FASTEST = -1.5, 2.5  # speeds shown, U_b
WAVES = 3  # of linear theory, the least damped ones of each wave number: fewer where fewer are resolved


def spectrum_of(case, spectra):
    """Frequencies and E, or None while there is less than one segment; segments are shorter in short runs."""
    time, amplitude = spectra.waves
    length = min(SEGMENT, time[-1] - case.start[0]) if len(time) else 0
    return space_time_spectrum(time, amplitude, case.start[0], length) if length > 0 else None


def theory(case, modes):
    """Mode and rate s of the least damped waves exp(i k x + s t) of linear theory, one row each."""
    flow = mean_profiles.measured(*case.mean("u"), case.reynolds, case.mean("driving_gradient"))
    layer = linear_stability.Layer(case.G, case.ratio, case.layer_height)
    found = []
    for mode in modes:
        for count in range(WAVES, 0, -1):
            try:
                found += [(mode, s) for s in linear_stability.rates(flow, layer, case.box[0] / mode, count)]
                break
            except ValueError:
                continue
    return np.array(found).reshape(-1, 2)


def draw_theory(panel, case, modes):
    """Growing waves are full, decaying ones open."""
    waves = theory(case, modes)
    mode, rate = waves[:, 0].real, waves[:, 1]
    speed = -rate.imag * case.box[0] / (2 * np.pi * mode)
    for growing, face, label in ((True, "tab:red", "theory, growing"), (False, "none", "theory, decaying")):
        which = (rate.real > 0) == growing
        panel.plot(mode[which], speed[which], "o", color="tab:red", markerfacecolor=face, markersize=4, label=label)


def draw(panel, case, frequencies, E):
    """Each wave number in shades of its own largest value, over the speed w / k."""
    modes = np.arange(1, E.shape[1] + 1)
    k = 2 * np.pi * modes / case.box[0]
    shown = E / E.max(axis=0)
    for mode, number, values in zip(modes, k, shown.T):
        inside = (frequencies / number > SLOWEST) & (frequencies / number < FASTEST)
        half = (frequencies[1] - frequencies[0]) / 2
        edges = np.append(frequencies[inside] - half, frequencies[inside][-1] + half) / number
        shades = panel.pcolormesh([mode - 0.5, mode + 0.5], edges, values[inside][:, None], cmap="Greys",
                                  norm=colors.LogNorm(10.0**-DECADES, 1), rasterized=True)
    draw_theory(panel, case, modes)
    panel.plot(modes, frequencies[np.argmax(E, axis=0)] / k, "_", color="tab:orange", markersize=12, label="largest")
    panel.axhline(0, color="grey", linewidth=0.5)
    panel.set(xlim=(0.5, modes[-1] + 0.5), ylim=(SLOWEST, FASTEST), xlabel=r"$k_xL_x/2\pi$", title=case.name)
    return shades


def main():
    options = arguments(__doc__)
    found = []
    for case in read_campaign(options):
        spectra = read_spectra(case) if case.elastic else None
        spectrum = spectrum_of(case, spectra) if spectra and spectra.waves else None
        if spectrum:
            found.append((case, *spectrum))
    if not found:
        raise SystemExit("no elastic wall has waves of its interface in its averaging window")
    figure, panels = plt.subplots(1, len(found), figsize=(2.8 * len(found) + 2, 4.5), layout="constrained", squeeze=False,
                                  sharey=True)
    for panel, each in zip(panels[0], found):
        shades = draw(panel, *each)
    panels[0, 0].set_ylabel(r"speed $\omega/k_x$, $U_b$")
    panels[0, -1].legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.01, 1))
    figure.colorbar(shades, ax=panels.ravel().tolist(), shrink=0.6, label=r"$E(k_x,\omega)$ / its largest at $k_x$")
    save(figure, options, __file__, f"Grid {grids_of(case for case, *_ in found)}. Mean over the span; positive speeds are "
                                    "downstream. Linear theory: the least damped waves on the measured mean flow, with "
                                    "molecular viscosity.")


if __name__ == "__main__":
    main()
