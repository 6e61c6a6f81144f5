#!/usr/bin/env python3
"""Every figure that the data of a channel campaign allow, each by its own script, into one folder.

Prints the file of each figure, and why one could not be drawn."""

import argparse
import pathlib
import runpy
import sys

import packages

packages.needed("h5py", "matplotlib", "numpy")

HERE = pathlib.Path(__file__).parent
# In the order in which they are read; the scripts of the validation campaigns want campaigns of their own.
SCRIPTS = ("time_series", "friction", "mean_velocity", "log_law", "fluctuations", "stress")


def draw(name, options, output):
    """Runs one script as a user would. Returns why it drew nothing, or nothing."""
    words = [str(HERE / f"plot_{name}.py"), str(options.campaign), "-o", str(output)]
    if options.start is not None:
        words += ["--from", repr(options.start)]
    if options.no_caption:
        words.append("--no-caption")
    before, sys.argv = sys.argv, words
    try:
        runpy.run_path(words[0], run_name="__main__")
    except SystemExit as end:
        return str(end.code) if end.code else None
    finally:
        sys.argv = before
    return None


def draw_all(options):
    """Draws what can be drawn. Returns the files by the name of the figure, and the reasons of the others."""
    folder = pathlib.Path(options.output or pathlib.Path(options.campaign) / "figures")
    folder.mkdir(parents=True, exist_ok=True)
    drawn, reasons = {}, {}
    for name in SCRIPTS:
        output = folder / f"{name}.{options.format}"
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
    drawn, reasons = draw_all(parser.parse_args())
    for name, reason in reasons.items():
        print(f"not drawn, {name}: {reason}", file=sys.stderr)
    if not drawn:
        sys.exit(1)


if __name__ == "__main__":
    main()
