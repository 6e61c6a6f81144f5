#!/usr/bin/env python3
"""The rigid channel of runs/validation against Moser, Kim & Mansour, Phys. Fluids 11 (1999): mean velocity, rms,
shear stress and two-point correlations, with 95 % intervals; prints every number that a bar is set on.

Both halves of the channel count as one. Profiles come from statistics.h5; correlations from spectra.h5, which has them exactly,
or where a case has none from single moments of the flow.
"""

import math
import sys

from campaign_data import FLUID_HEIGHT, arguments, caption, draw_band, judge, plt, read_campaign, read_reference, save
from correlations import source_of

import batches
import numpy as np

RE_TAU_OF_MOSER, MOSERS_OWN_RE_TAU = 178.5, 178.12  # scaled to this bulk Reynolds number; of their run, which all else is from
CORRELATED_AT = (10, 98)  # y+ of the correlations shown


class Channel:
    """Profiles of one half of a rigid channel in wall units, and how they vary from batch to batch."""

    def __init__(self, case):
        self.case = case
        self.reynolds = case.reynolds
        self.y, self.y_face = (case.y[place][: (len(case.y[place]) + 1) // 2] for place in ("center", "face"))
        self.values = self._profiles(case)
        self.ci95 = {name: batches.half_width(case, lambda each: self._profiles(each)[name]) for name in self.values}

    @staticmethod
    def _half(case, name, sign=1):
        values = case.mean(name)[1]
        half = (len(values) + 1) // 2
        return (values[:half] + sign * values[::-1][:half]) / 2

    def _profiles(self, case):
        """Everything that is compared."""
        gradient = case.mean("driving_gradient")
        u_tau = math.sqrt(gradient)  # both walls: 2 u_tau^2 = 2 P
        mean = self._half(case, "u")
        rms = {name: np.sqrt(self._half(case, 2 * name) - (mean**2 if name == "u" else 0)) / u_tau for name in "uvw"}
        uv, viscous = self._half(case, "uv", -1), self._half(case, "viscous_stress", -1)
        line = gradient * (1 - self.y_face)
        return {"re_tau": u_tau * self.reynolds, "u_max": mean.max(), "u": mean / u_tau, "u'": rms["u"], "v'": rms["v"],
                "w'": rms["w"], "-uv": -uv / u_tau**2, "viscous": viscous / u_tau**2,
                "departure": (viscous - uv - line) / u_tau**2}

    @property
    def y_plus(self):
        return self.y * self.values["re_tau"]

    @property
    def y_plus_face(self):
        return self.y_face * self.values["re_tau"]


def peak(y, values):
    """Where and how high the parabola through the largest value and its neighbours is."""
    n = int(np.clip(np.argmax(values), 1, len(values) - 2))
    a, b, c = np.polyfit(y[n - 1 : n + 2], values[n - 1 : n + 2], 2)
    return -b / (2 * a), c - b * b / (4 * a)


def peak_of(channel, y_plus, name):
    """Where a profile has its peak, how high it is, and half its 95 % interval."""
    values = channel.values[name]
    return *peak(y_plus, values), channel.ci95[name][np.argmax(values)]


class Correlations:
    """R_ii(separation) / R_ii(0) along x and z in the rows nearest to given distances from the walls."""

    def __init__(self, source, y_plus_per_h):
        self.words, self.separation, self.along = source.words, {}, {"x": {}, "z": {}}
        for axis, found in self.along.items():
            for name in "uvw":
                self.separation[axis], heights, rows = source.rows(name, axis)
                for at in CORRELATED_AT:
                    found[name, at] = self._of_both_halves(heights, rows, at / y_plus_per_h)

    @staticmethod
    def _of_both_halves(heights, rows, y):
        return np.mean([rows[np.argmin(abs(heights - each))] for each in (y, FLUID_HEIGHT - y)], axis=0)


def compare(channel, reference):
    """Prints every number with a bar."""
    values, ci95 = channel.values, channel.ci95
    print(f"Re_tau {batches.text(values['re_tau'], ci95['re_tau'], 2)} "
          f"(Moser et al. scaled to this bulk Reynolds number: {RE_TAU_OF_MOSER:g})")
    judge(f"abs(Re_tau - {RE_TAU_OF_MOSER:g})", abs(values["re_tau"] - RE_TAU_OF_MOSER), 1.5)
    expected = np.interp(channel.y_plus, reference["y_plus"], reference["U_plus"])
    judge("U+, largest relative difference", max(abs(values["u"] / expected - 1)), 0.015)
    for name, column, bar in (("u'", "urms_plus", 0.03), ("v'", "vrms_plus", 0.03), ("w'", "wrms_plus", 0.03)):
        compare_peak(name, channel, channel.y_plus, (reference["y_plus"], reference[column]), bar)
    compare_peak("-uv", channel, channel.y_plus_face, (reference["y_plus"], -reference["uv_plus"]), 0.02)
    judge("total stress, largest departure from a line / u_tau^2", max(abs(values["departure"])), 0.01)
    print(f"U_c / U_b {batches.text(values['u_max'], ci95['u_max'], 4)}")


def compare_peak(name, channel, y_plus, theirs, bar):
    at, height, interval = peak_of(channel, y_plus, name)
    expected_at, expected = peak(*theirs)
    print(f"{name}+ peak {batches.text(height, interval, 3)} at y+ {at:.1f} (Moser et al.: {expected:.3f} at {expected_at:.1f})")
    judge(f"{name}+ peak, relative difference", abs(height / expected - 1), bar)


def draw_profile(panel, y, channel, name, colour, label=None):
    """A profile with its interval, labelled with its own name unless told otherwise."""
    value, interval = channel.values[name], channel.ci95[name]
    panel.plot(y, value, color=colour, label=label or (f"${name}^+$" if name != "u" else "$U^+$"))
    draw_band(panel, y, value, interval, colour)


def draw_profiles(axes, channel, reference):
    crosses = {"color": "black", "marker": "+", "linestyle": "none", "markersize": 4}
    draw_profile(axes[0], channel.y_plus, channel, "u", "blue")
    axes[0].plot(reference["y_plus"][1:], reference["U_plus"][1:], label="Moser et al. (1999)", **crosses)
    axes[0].set(xscale="log", xlim=(0.3, 200), xlabel="$y^+$", ylabel="$U^+$")
    for name, column, colour in (("u'", "urms_plus", "blue"), ("v'", "vrms_plus", "red"), ("w'", "wrms_plus", "green")):
        draw_profile(axes[1], channel.y_plus, channel, name, colour)
        axes[1].plot(reference["y_plus"], reference[column], **crosses)
    axes[1].set(xlim=(0, 180), xlabel="$y^+$", ylabel="rms of a fluctuation, $u_\\tau$")
    draw_profile(axes[2], channel.y_plus_face, channel, "-uv", "blue")
    draw_profile(axes[2], channel.y_plus_face, channel, "viscous", "red")
    axes[2].plot(reference["y_plus"], -reference["uv_plus"], **crosses)
    axes[2].plot(reference["y_plus"], reference["dUplus_dyplus"], **crosses)
    total = channel.values["-uv"] + channel.values["viscous"]
    axes[2].plot(channel.y_plus_face, total, "k-", linewidth=0.8, label="total")
    axes[2].set(xlim=(0, 180), xlabel="$y^+$", ylabel="shear stress, $u_\\tau^2$")
    for panel in axes:
        panel.legend(fontsize="x-small")


def draw_correlations(axes, correlations, axis):
    reference = read_reference(f"mkm180_corr_{axis}.csv")
    for panel, at in zip(axes, CORRELATED_AT):
        rows = reference["y_plus_file"] == at
        for name, colour in (("u", "blue"), ("v", "red"), ("w", "green")):
            panel.plot(correlations.separation[axis], correlations.along[axis][name, at], color=colour,
                       label=f"$R_{{{2 * name}}}$")
            column = reference[f"R_{2 * name}"][rows]
            panel.plot(reference["sep_over_h"][rows], column / column[0], "+", color=colour, markersize=4)
        panel.set(xlim=(0, correlations.separation[axis][-1]), xlabel=f"separation in ${axis}/h$",
                  title=f"$y^+ = {at}$")
        panel.axhline(0, color="grey", linewidth=0.5)
        panel.legend(fontsize="x-small")


def report_correlations(correlations):
    reference = read_reference("mkm180_corr_z.csv")
    for at in CORRELATED_AT:
        rows = reference["y_plus_file"] == at
        theirs = reference["R_uu"][rows] / reference["R_uu"][rows][0]
        ours = correlations.along["z"]["u", at]
        reached = reference["sep_over_h"][rows] <= correlations.separation["z"][-1]
        there = np.interp(reference["sep_over_h"][rows][reached], correlations.separation["z"], ours)
        print(f"R_uu(z) at y+ {at}: least {ours.min():.3f} at {correlations.separation['z'][ours.argmin()]:.3f} h "
              f"(Moser et al.: {theirs.min():.3f} at {reference['sep_over_h'][rows][theirs.argmin()]:.3f} h); "
              f"largest difference {max(abs(there - theirs[reached])):.3f}")


def main():
    options = arguments(__doc__)
    cases = [case for case in read_campaign(options) if not case.elastic]
    case = max(cases, key=lambda each: len(each.y["center"]))
    if len(case.weight) < batches.LEAST:
        sys.exit(f"{case.label} has {len(case.weight)} blocks; intervals need {batches.LEAST}")
    channel = Channel(case)
    reference = read_reference("mkm180_profiles.csv")
    compare(channel, reference)
    source = source_of(case)
    correlations = Correlations(source, channel.values["re_tau"]) if source else None
    figure, axes = plt.subplots(3 if correlations else 1, 3, figsize=(12, 10.5), layout="constrained", squeeze=False)
    draw_profiles(axes[0], channel, reference)
    if correlations:
        report_correlations(correlations)
        for row, axis in enumerate("xz", start=1):
            draw_correlations(axes[row], correlations, axis)
            axes[row, 2].set_axis_off()
    save(figure, options, __file__, caption([case]) + (f" Correlations: {correlations.words}." if correlations else ""))


if __name__ == "__main__":
    main()
