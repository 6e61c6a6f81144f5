#!/usr/bin/env python3
"""Every figure that the data of a channel campaign allow, each by its own script, into one folder.

Prints the file of each figure, and why one could not be drawn."""

import argparse
import contextlib
import io
import pathlib
import runpy
import sys

import packages

packages.needed("h5py", "matplotlib", "numpy")
from campaign_data import plt  # noqa: E402  (the packages come first)

HERE = pathlib.Path(__file__).parent
# By the name of the file, in the order in which they are read: the script and what else it is told. The scripts of the
# validation campaigns want campaigns of their own.
FIGURES = {
    "time_series": ("plot_time_series.py",),
    "friction": ("plot_friction.py",),
    "mean_velocity": ("plot_mean_velocity.py",),
    "log_law": ("plot_log_law.py",),
    "interface_velocity": ("plot_interface_velocity.py",),
    "fluctuations": ("plot_fluctuations.py",),
    "kinetic_energy": ("plot_kinetic_energy.py",),
    "energy_budget": ("plot_energy_budget.py",),
    "wall_surface": ("plot_wall_surface.py",),
    "elastic_stress": ("plot_elastic_stress.py",),
    "velocity_planes": ("plot_velocity_planes.py",),
    "correlations_x": ("plot_correlations.py", "--axis", "x"),
    "correlations_z": ("plot_correlations.py", "--axis", "z"),
    "spectra": ("plot_spectra.py",),
    "interface_shape": ("plot_interface_shape.py",),
    "interface_pairs": ("plot_interface_pairs.py",),
    "wave_speeds": ("plot_wave_speeds.py",),
    "stress": ("plot_stress.py",),
}
PICTURES = ("wall_surface", "velocity_planes", "correlations_x", "correlations_z")  # of the flow, more than lines


def draw(name, options, output):
    """Runs the script of one figure as a user would. Returns why it drew nothing, or nothing. Whatever one script stumbles
    over, the other figures are drawn."""
    script, *more = FIGURES[name]
    words = [str(HERE / script), str(options.campaign), *more, "-o", str(output)]
    if options.start is not None:
        words += ["--from", repr(options.start)]
    if options.no_caption:
        words.append("--no-caption")
    words += ["--style", options.style]
    before, sys.argv = sys.argv, words
    try:
        with contextlib.redirect_stdout(io.StringIO()):  # numbers that a script prints for who calls it by itself
            runpy.run_path(words[0], run_name="__main__")
    except SystemExit as end:
        if end.code:
            return str(end.code)
    except Exception as error:  # of any kind: scripts meet data that nobody thought of
        return f"{type(error).__name__}: {error}"
    finally:
        sys.argv = before
        plt.close("all")
    print(output)
    return None


def draw_all(options, pixels=()):
    """Draws what can be drawn, those named in `pixels` as PNG. Returns the files by the name of the figure, and the reasons
    of the others."""
    folder = pathlib.Path(options.output or pathlib.Path(options.campaign) / "figures")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        sys.exit(f"{folder}: cannot be a folder for the figures: {error.strerror}")
    drawn, reasons = {}, {}
    for name in FIGURES:
        output = folder / f"{name}.{'png' if name in pixels else options.format}"
        reason = draw(name, options, output)
        if reason:
            reasons[name] = reason
        else:
            drawn[name] = output
    return drawn, reasons


def main():
    parser = argparse.ArgumentParser(prog="softwall figures", description=__doc__)
    parser.add_argument("campaign", help="campaign folder, the one that holds cases/ and results.db")
    parser.add_argument("-o", "--output", help="folder to write to; default: figures/ in the campaign's folder")
    parser.add_argument("--format", choices=("png", "pdf", "svg"), default="png")
    parser.add_argument("--from", dest="start", type=float, metavar="T", help="begin the averages at this time, h/U_b")
    parser.add_argument("--no-caption", action="store_true", help="leave out the lines below each figure")
    parser.add_argument("--style", choices=("screen", "journal", "talk"), default="screen",
                        help="what they are for: journal has serifs and 300 dots an inch, talk large letters and thick lines")
    drawn, reasons = draw_all(parser.parse_args())
    for name, reason in reasons.items():
        print(f"not drawn, {name}: {reason}", file=sys.stderr)
    if not drawn:
        sys.exit(1)


if __name__ == "__main__":
    main()
