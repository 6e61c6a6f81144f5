#!/usr/bin/env python3
"""Growth rates of small waves under laminar flow beside linear theory, grid by grid (runs/validation/growth-rates); prints
the table that its README shows.

A wave starts as the mode of the layers at rest, so that others are there at first: four exponentials are fitted to v at
three heights and to the interface from START on, and the one nearest to theory is the wave's.
"""

import sys

import linear_stability
import mean_profiles
from campaign_data import SeriesCase, arguments, plt, read_series_campaign, save, verdict
from growth_fit import fitted_rates
from solid_words import FORMULATIONS

import numpy as np

START, LEAST_TIME, MODES = 6.0, 10.0, 4
PROBES = ("wave_v_fluid", "wave_v", "wave_v_solid", "wave_height")
GROWTH_BAR, FREQUENCY_BAR, ORDER_BAR, CELLS_OF_BAR = 0.0015, 0.002, 1.5, 96
LOOKS = {"reference_map": ("-", "o"), "transported_B": (":", "s")}


class GrowingWave(SeriesCase):
    """One case; what was measured and what theory says, U_b/h, once it has run long enough."""

    def __init__(self, directory):
        super().__init__(directory)
        self.exact = self.rate = self.rest = None
        if self.physics.get("wave", {}).get("mean_flow") != "laminar" or "time" not in self.series:
            return
        solid, domain = self.physics["solid"], self.physics["domain"]
        self.formulation, self.G, self.wavelength = solid["formulation"], solid["G"], domain["length_x"]
        t = self.series["time"]
        used = t >= START
        if not used.any() or t[-1] < START + LEAST_TIME:
            return
        layer = linear_stability.Layer(self.G, solid["viscosity_ratio"], domain["layer_height"])
        theory = linear_stability.rates(mean_profiles.laminar(self.physics["reynolds"]), layer, self.wavelength, MODES)
        self.exact = theory[0]
        records = np.array([self.series[name] - 1j * self.series[name + "_sin"] for name in PROBES]).T[used]
        found, self.rest = fitted_rates(t[used], records / np.abs(records).max(axis=0), theory)
        self.rate = found[np.argmin(np.abs(found - self.exact))]

    @property
    def row(self):
        return -self.G, self.wavelength

    @property
    def growth_error(self):
        return self.rate.real - self.exact.real

    @property
    def frequency_error(self):
        return self.rate.imag / self.exact.imag - 1

    @property
    def error(self):
        return abs(self.rate - self.exact)


def print_row(waves):
    """Of one wave and formulation, the coarsest grid first."""
    one = waves[0]
    print(f"{FORMULATIONS[one.formulation]}, G {one.G:g}, wave length {one.wavelength:g}: "
          f"theory {one.exact.real:.5f} {one.exact.imag:.4f}")
    for case in waves:
        bars = ""
        if case.cells >= CELLS_OF_BAR:
            held = abs(case.growth_error) <= GROWTH_BAR and abs(case.frequency_error) <= FREQUENCY_BAR
            bars = f"   bars {GROWTH_BAR:g}, {100 * FREQUENCY_BAR:g} % {verdict(held)}"
        print(f"  {case.cells:4d} cells {case.rate.real:10.5f} {case.rate.imag:10.4f}   growth {case.growth_error:+.5f}, "
              f"frequency {100 * case.frequency_error:+.3f} %{bars}")
    if len(waves) > 1:
        errors = [case.error for case in waves]
        falls = all(finer < coarser for coarser, finer in zip(errors, errors[1:]))
        order = np.log(errors[-2] / errors[-1]) / np.log(waves[-1].cells / waves[-2].cells)
        print(f"  errors {'fall' if falls else 'DO NOT fall'}, order between the finest two {order:.2f}   "
              f"bar {ORDER_BAR:g} {verdict(falls and order >= ORDER_BAR)}")


def draw(panels, waves, colour):
    line, marker = LOOKS[waves[0].formulation]
    cells = [case.cells for case in waves]
    label = f"{FORMULATIONS[waves[0].formulation]}, $G={waves[0].G:g}$, length {waves[0].wavelength:g}"
    for panel, errors in zip(panels, ([abs(case.growth_error) for case in waves],
                                      [100 * abs(case.frequency_error) for case in waves])):
        panel.plot(cells, errors, color=colour, linestyle=line, marker=marker, markersize=4, linewidth=1, label=label)


def main():
    options = arguments(__doc__)
    waves = [case for case in read_series_campaign(options.campaign, "interface_wave", GrowingWave) if case.rate]
    if not waves:
        sys.exit(f"no wave under laminar flow in {options.campaign} has statistics yet; run the campaign first")
    figure, panels = plt.subplots(1, 2, figsize=(12, 4.6), layout="constrained")
    for number, row in enumerate(sorted({case.row for case in waves})):
        for formulation in LOOKS:
            of_row = [case for case in waves if case.row == row and case.formulation == formulation]
            if of_row:
                print_row(of_row)
                draw(panels, of_row, f"C{number}")
    sizes = sorted({case.cells for case in waves})
    for panel, quantity, bar in zip(panels, ("growth, $U_b/h$", "frequency, %"), (GROWTH_BAR, 100 * FREQUENCY_BAR)):
        panel.axhline(bar, color="red", linewidth=0.8)
        panel.set(xscale="log", yscale="log", xlabel="cells a wave", ylabel=f"error of the {quantity}")
        panel.set_xticks(sizes, [str(n) for n in sizes])
        panel.minorticks_off()
    panels[1].legend(fontsize="x-small", bbox_to_anchor=(1.02, 1), loc="upper left")
    save(figure, options, __file__, "Small waves under laminar flow, Re 2800, layer 0.5: errors against linear theory. "
         f"Red: the bars, for {CELLS_OF_BAR} cells a wave.")


if __name__ == "__main__":
    main()
