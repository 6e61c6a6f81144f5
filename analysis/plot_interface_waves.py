#!/usr/bin/env python3
"""Waves at the interface of a fluid at rest and a bonded layer: frequency and decay beside linear theory, grid by grid
(runs/validation/interface-waves); prints the table that its README shows.

The reference has a fluid 1 deep, the solver one 2 deep: its lengths and times are SCALE times the reference's, its
velocities the same.
"""

import math
import sys

from campaign_data import SeriesCase, arguments, judge, plt, read_reference, read_series_campaign, save, verdict
from solid_words import FORMULATIONS

import numpy as np

SCALE = 2
PERIODS = 2  # that a rate is fitted to, of the exact frequency
PROBES = ("wave_v_fluid", "wave_v", "wave_v_solid")
FREQUENCY_BAR, DECAY_BAR, ORDER_BAR, ORDER_FLOOR = 0.01, 0.05, 1.5, 0.001
LINES = {"reference_map": "-", "transported_B": ":"}
MARKERS = {0: "o", 1: "s"}  # by mode


def fitted_rate(t, records, guess):
    """The s for which records[n] = Re[c_n exp(s t)] in the sense of least squares, c_n free (Gauss-Newton on s alone,
    the c_n eliminated)."""
    s = guess
    for _ in range(50):
        wave = np.exp(s * t)
        basis = np.column_stack([wave.real, -wave.imag])
        coefficients = np.linalg.lstsq(basis, records.T, rcond=None)[0]
        rest = records.T - basis @ coefficients
        slope = t[:, None] * wave[:, None] * (coefficients[0] + 1j * coefficients[1])
        slopes = [part - basis @ np.linalg.lstsq(basis, part, rcond=None)[0] for part in (slope.real, -slope.imag)]
        step = np.linalg.lstsq(np.column_stack([part.ravel() for part in slopes]), rest.ravel(), rcond=None)[0]
        s += complex(*step)
        if abs(complex(*step)) < 1e-12 * abs(s):
            return s
    raise ValueError("no decaying oscillation fits")


class Wave(SeriesCase):
    """One case with the rate that was measured, in the units of the reference."""

    def __init__(self, directory):
        super().__init__(directory)
        self.rate = None
        if self.physics["flow"] != "interface_wave":
            return
        wave = self.physics["wave"]
        self.formulation = self.physics["solid"]["formulation"]
        self.given = complex(-wave["decay"], wave["frequency"])
        period = 2 * math.pi / self.given.imag
        if "time" in self.series and self.series["time"][-1] >= PERIODS * period:
            used = self.series["time"] <= PERIODS * period
            records = np.array([self.series[name][used] for name in PROBES])
            self.rate = SCALE * fitted_rate(self.series["time"][used], records, self.given)

    def is_of(self, row):
        """Whether it has the layers and the wave of a row of the reference."""
        solid, domain = self.physics["solid"], self.physics["domain"]
        mine = (self.physics["reynolds"], solid["viscosity_ratio"], solid["G"], domain["length_x"],
                domain["layer_height"], self.given.imag)
        its = (1 / (SCALE * row["nu_f"]), row["nu_s"] / row["nu_f"], row["G_over_rho"], SCALE * row["lambda"],
               SCALE * row["Hs"], row["im_s"] / SCALE)
        return np.allclose(mine, its, rtol=1e-5)


def name_of(row):
    layer = f"{row['nu_f']:g}" if row["nu_f"] == row["nu_s"] else f"{row['nu_f']:g} under {row['nu_s']:g}"
    return f"nu {layer}, G {row['G_over_rho']:g}, mode {row['mode']:.0f}"


def signed_errors(case, exact):
    """Of frequency and decay, relative."""
    return case.rate.imag / exact.imag - 1, case.rate.real / exact.real - 1


def judge_order(errors):
    """Of the complex rate, per halving of the cells, between the finest two grids that begin above the floor: below it,
    parts of the error that cancel are all that is left."""
    pairs = [(coarse, fine) for coarse, fine in zip(errors, errors[1:]) if coarse >= ORDER_FLOOR]
    if pairs:
        order = math.log2(pairs[-1][0] / pairs[-1][1])
        words = f"{order:10.2f}   bar {ORDER_BAR:g}   {verdict(order >= ORDER_BAR)}"
    else:
        words = f"{'-':>10s}   below {100 * ORDER_FLOOR:g} % on all grids"
    print(f"{'  order of the rate':58s} {words}")


def print_row(name, waves, exact):
    errors = [abs(case.rate - exact) / abs(exact) for case in waves]
    grids = [f"{case.cells}: {100 * f:+.3f}, {100 * d:+.2f}, {100 * error:.3f}"
             for case, error in zip(waves, errors) for f, d in [signed_errors(case, exact)]]
    print(f"{name}: errors of frequency, decay and complex rate in % by cells a wave: {'; '.join(grids)}")
    frequency, decay = signed_errors(waves[-1], exact)
    judge(f"  frequency, {waves[-1].cells} cells a wave", abs(frequency), FREQUENCY_BAR)
    judge("  decay", abs(decay), DECAY_BAR)
    if len(waves) > 1:
        judge_order(errors)


def draw_errors(panels, waves, exact, style):
    cells = [case.cells for case in waves]
    for panel, errors in zip(panels, zip(*(signed_errors(case, exact) for case in waves))):
        panel.plot(cells, 100 * np.abs(errors), markersize=4, **style)


def draw_height(panel, case, exact, style):
    """The interface over time beside the exact wave."""
    t, height = case.series["time"] / SCALE, case.series["wave_height"] / case.physics["wave"]["displacement"]
    shown = t <= PERIODS * 2 * math.pi / exact.imag
    panel.plot(t[shown], height[shown], **style)
    panel.plot(t[shown], np.exp(exact * t[shown]).real, color="black", linewidth=0.6, linestyle=(0, (4, 4)))


def finish(heights, errors, sizes):
    heights.set(xlabel="$t$", ylabel="height of the crest / at the start",
                title="reference map, finest grid; dashed: linear theory")
    for panel, quantity, bar in zip(errors, ("frequency", "decay"), (FREQUENCY_BAR, DECAY_BAR)):
        panel.axhline(100 * bar, color="red", linewidth=0.8)
        panel.set(xscale="log", yscale="log", xlabel="cells a wave", ylabel="error, %", title=f"error of the {quantity}")
        panel.yaxis.set_major_formatter("{x:g}")
        panel.set_xticks(sizes, [str(n) for n in sizes])
        panel.minorticks_off()
    errors[1].legend(fontsize="x-small", bbox_to_anchor=(1.02, 1), loc="upper left")


def main():
    options = arguments(__doc__)
    table = read_reference("interface_modes_linear.csv")
    rows = [dict(zip(table, values)) for values in zip(*table.values())]
    cases = [case for case in read_series_campaign(options.campaign, "interface_wave", Wave) if case.rate]
    if not cases:
        sys.exit(f"no interface wave in {options.campaign} has statistics yet; run the campaign first")
    figure, (heights, *errors) = plt.subplots(1, 3, figsize=(15, 4.6), layout="constrained")
    for formulation, line in LINES.items():
        for n, row in enumerate(rows):
            waves = [case for case in cases if case.formulation == formulation and case.is_of(row)]
            if not waves:
                continue
            exact = complex(row["re_s"], row["im_s"])
            print_row(f"{FORMULATIONS[formulation]}, {name_of(row)}", waves, exact)
            style = {"color": f"C{n // 2}", "linestyle": line, "linewidth": 1}  # one colour for the modes of a layer
            known = formulation == "reference_map"
            mode = {"marker": MARKERS[row["mode"]], "markerfacecolor": "none" if row["mode"] else style["color"]}
            draw_errors(errors, waves, exact, style | mode | {"label": name_of(row) if known else None})
            if known and row["mode"] == 0:
                draw_height(heights, waves[-1], exact, style)
    finish(heights, errors, sorted({case.cells for case in cases}))
    save(figure, options, __file__, "Errors of frequency and decay against linear theory, fitted over two periods. Full: "
         "reference map; dotted: transported B. Red: the bars, for the finest grid. Depth and wave 1, layer 0.5.")


if __name__ == "__main__":
    main()
