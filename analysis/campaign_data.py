"""What every figure needs: the cases of a campaign folder and their means, and the command line of its script.

Everything is in units of the half height h, the bulk velocity U_b and density 1. Fits of the log law
(d, k + Dk, DU+) are read from results.db and never repeated here: analysis/log_law.cpp has the only one.
"""

import argparse
import contextlib
import csv
import functools
import json
import math
import os
import pathlib
import sqlite3
import sys
import textwrap

import packages

packages.needed("h5py", "matplotlib", "numpy")
import batches
import h5py
import numpy as np
from case_defaults import with_defaults
from case_style import STYLE_HELP, STYLES, choose_styles, plt

PAPER_GRID = "1296x432+108x648"
REFERENCE = pathlib.Path(__file__).parent / "data"
LABEL_G = r"$G/(\rho U_b^2)$"
FLUID_HEIGHT = 2  # h, from the bottom wall to the interface at rest


@functools.cache
def tell(message):
    """To standard error, once however many figures one process draws."""
    print(message, file=sys.stderr)


def _text(attribute):
    """Text attributes of fixed length come as bytes from h5py."""
    return attribute.decode() if isinstance(attribute, bytes) else attribute


def _shown(value):
    return f"{value:g}" if isinstance(value, (int, float)) else str(value)


class Case:
    """One run directory with statistics. `mean(name)` is the time mean over the blocks of its averaging window, which
    begins with the first one that starts at or after `start`. A case that the store gives no averages, because its window
    has not begun or it has diverged, raises ValueError; with `any_state` it is averaged over all of its blocks."""

    def __init__(self, directory, results, start=None, any_state=False):
        self.directory = directory
        definition = json.loads((directory / "case.json").read_text())
        physics = with_defaults(definition["physics"])
        self.label = definition.get("label") or directory.name
        self.reynolds = physics["reynolds"]
        self.elastic = physics["flow"] == "elastic_wall"
        solid = physics.get("solid", {"G": math.inf, "viscosity_ratio": 1.0})  # a rigid wall needs none
        self.G, self.ratio = solid["G"], solid["viscosity_ratio"]
        domain = physics["domain"]
        self.layer_height = domain["layer_height"]
        self.box = domain["length_x"], domain["length_z"]  # periods in x and z, h
        grid = physics["grid"]
        layer = f"+{grid['ny_solid']}" if self.elastic else ""
        self.grid = f"{grid['nx']}x{grid['ny_fluid']}{layer}x{grid['nz']}"
        self.results = results.get(directory.name, {})
        self.physics = physics
        self.colour, self.style, self.varied = "black", "-", {}
        self.marker = None  # where cases differ in more than G and the viscosity ratio
        state, is_precursor = self.results.get("state"), not self.elastic and self.results.get("is_precursor")
        if start is None or is_precursor:
            start = self.results.get("window_start")
        self.has_averages = not self.results or start is not None and state != "diverged"  # without a store: of all blocks
        if not self.has_averages and not any_state:
            raise ValueError("it has diverged" if state == "diverged" else "no averages in its window yet")
        self._read_statistics(start if start is not None and self.has_averages else -math.inf)

    def _read_statistics(self, start):
        with h5py.File(self.directory / "statistics.h5") as file:
            self.y = {"center": file["grid/y_center"][:], "face": file["grid/y_face"][:]}
            self.interface_y = float(file.attrs["interface_y"])
            inside = file["blocks/start"][:] >= start - 1e-9 * max(1.0, abs(start))
            self.start, self.end = file["blocks/start"][inside], file["blocks/end"][inside]
            self.weight = file["blocks/weight"][inside]
            self.profiles = {
                name: (_text(data.attrs["location"]), data[inside]) for name, data in file["profiles"].items()
            }
            self.series = {name: data[inside] for name, data in file["series"].items()}
        if self.weight.sum() <= 0:
            raise ValueError("no samples in its averaging window yet")

    def mean(self, name):
        """y and time mean of a profile; mean of a series. KeyError when the statistics do not hold it."""
        if name in self.series:
            return float(np.average(self.series[name], weights=self.weight))
        location, values = self.profiles[name]
        return self.y[location], np.average(values, axis=0, weights=self.weight)

    def has(self, *names):
        return all(name in self.profiles for name in names)

    def rms(self, name):
        """y and rms of a fluctuation: u, v or w."""
        y, mean = self.mean(name)
        square = self.mean(2 * name)[1]
        return y, np.sqrt(np.maximum(square - mean**2, 0.0))

    @property
    def u_tau_w(self):
        square = self.mean("wall_shear_bottom")
        return math.sqrt(square) if square > 0 else math.nan

    @property
    def u_tau(self):
        square = self.interface_y * self.mean("driving_gradient") - self.mean("wall_shear_bottom")
        return math.sqrt(square) if square > 0 else math.nan

    def re_tau_by_block(self, series):
        """Re_tau of the upper and of the bottom wall in every block of a series of driving gradients and shears at the bottom; NaN
        where a block has not been sampled, or drags the wall upstream."""
        bottom = series["wall_shear_bottom"]
        upper = self.interface_y * series["driving_gradient"] - bottom
        return [np.sqrt(np.where(square > 0, square, np.nan)) * self.reynolds for square in (upper, bottom)]

    @property
    def name(self):
        ratio = "" if not self.elastic or self.ratio == 1 else rf", $\mu^s/\mu^f={self.ratio:g}$"
        varied = "".join(f", {key} {_shown(value)}" for key, value in self.varied.items())
        return (f"$G={self.G:g}$" if self.elastic else "rigid wall") + ratio + varied

    def draw(self, axes, x, y, **more):
        """A line in the case's colour and style, with a dozen markers where it has any."""
        axes.plot(x, y, self.style, color=self.colour, markersize=4, markevery=max(1, len(x) // 12), **more)

    def draw_profile(self, axes, profile, **more):
        """`profile(case)`, positions and values, as a line with its 95 % interval as a band."""
        x, values = profile(self)
        self.draw(axes, x, values, **more)
        draw_band(axes, x, values, batches.half_width(self, lambda case: profile(case)[1]), self.colour)

    def result(self, quantity):
        """A measured quantity or its interval, NAME_ci95; NaN when there is none."""
        value = self.results.get(quantity)
        return math.nan if value is None else value

    def result_text(self, quantity, digits):
        """A measured quantity with its interval, as in the table."""
        return batches.text(self.result(quantity), self.result(quantity + "_ci95"), digits)


class SeriesCase:
    """One run directory of which the series are all there is: a closed box, an interface wave."""

    def __init__(self, directory):
        self.directory = directory
        self.physics = with_defaults(json.loads((directory / "case.json").read_text())["physics"])
        self.cells = self.physics["grid"]["nx"]
        self.t, self.block_start, self.series = np.array([]), np.array([]), {}
        statistics = directory / "statistics.h5"
        if statistics.exists():
            with h5py.File(statistics) as file:
                self.block_start = file["blocks/start"][:]
                self.t = (self.block_start + file["blocks/end"][:]) / 2
                self.series = {name: values[:] for name, values in file["series"].items()}


def read_series_campaign(folder, flow, kind=SeriesCase):
    """All cases of this flow, coarsest first; a damaged one is left out by name."""
    cases = []
    for file in (path / "case.json" for path in case_directories(pathlib.Path(folder))):
        if not file.exists():
            continue
        try:
            cases.append(kind(file.parent))
        except (OSError, KeyError, ValueError) as error:
            tell(f"left out {file.parent}: {error}")
    return sorted((case for case in cases if case.physics["flow"] == flow), key=lambda case: case.cells)


def ask_store(campaign, question):
    """All rows of the answer; none without a store. Where the folder cannot be written SQLite cannot make the files by which
    readers and writers meet: a store without an unfinished change is then read as a file that nobody changes."""
    store = campaign / "results.db"
    if not store.exists():
        return []

    def answer(more=""):
        with contextlib.closing(sqlite3.connect(f"{store.resolve().as_uri()}?mode=ro{more}", uri=True)) as connection:
            return connection.execute(question).fetchall()

    try:
        return answer()
    except sqlite3.OperationalError:
        log = store.with_name(store.name + "-wal")
        if os.access(campaign, os.W_OK) or log.exists() and log.stat().st_size > 0:
            raise
        return answer("&immutable=1")


def _read_results(campaign):
    """Everything measured, by run directory and name, intervals as NAME_ci95, and what state the case is in; empty without a
    store."""
    results = {}
    for directory, state, is_precursor in ask_store(campaign, "SELECT directory, state, is_precursor FROM cases"):
        results[pathlib.Path(directory).name] = {"state": state, "is_precursor": is_precursor}
    measured = "SELECT directory, quantity, value, ci95, window_start FROM quantities JOIN cases USING (case_id)"
    for directory, quantity, value, ci95, window_start in ask_store(campaign, measured):
        of_case = results[pathlib.Path(directory).name]
        of_case[quantity], of_case[quantity + "_ci95"], of_case["window_start"] = value, ci95, window_start
    return results


def case_directories(campaign):
    """The run directories of the campaign as it is now; what earlier versions of its file left behind is named."""
    directories = sorted(path for path in campaign.glob("cases/[!.]*") if path.is_dir())
    rows = ask_store(campaign, "SELECT directory FROM cases WHERE in_campaign = 0")
    left_over = {pathlib.Path(directory).name for (directory,) in rows}
    left_out = [path.name for path in directories if path.name in left_over and (path / "statistics.h5").exists()]
    if left_out:
        tell(f"left out, no longer part of the campaign: {', '.join(left_out)}")
    return [path for path in directories if path.name not in left_over]


def read_campaign(options, any_state=False):
    """All cases with averages, rigid first, then by viscosity ratio and falling G; with `any_state` all that have statistics.
    `options`: what arguments() returned."""
    campaign = pathlib.Path(options.campaign)
    if not campaign.is_dir():
        sys.exit(f"{campaign} is not a folder; give the campaign folder, the one that holds cases/")
    results = _read_results(campaign)
    cases = []
    for directory in case_directories(campaign):
        if not (directory / "statistics.h5").exists():
            continue
        try:
            cases.append(Case(directory, results, options.start, any_state))
        except (OSError, KeyError, ValueError) as error:
            tell(f"left out {directory}: {error}")
    if not cases:
        sys.exit(f"no case in {campaign / 'cases'} has statistics yet")
    cases.sort(key=lambda case: (case.elastic, case.ratio != 1, case.ratio, -case.G))
    choose_styles(cases)
    return cases


def with_friction(cases):
    """Those whose upper wall the mean flow drags on; ends the script where none is: its mean is of too short a window."""
    found = [case for case in cases if not math.isnan(case.u_tau)]
    if not found:
        sys.exit("no mean flow that the elastic wall drags on: average for longer")
    return found


def case_called(name, cases):
    """The case with this label, or in the folder of this name; the program ends where there is none."""
    found = [case for case in cases if name in (case.label, case.directory.name)]
    if not found:
        sys.exit(f"no case is called {name}; there are: " + ", ".join(case.label for case in cases))
    return found[0]


def read_reference(file):
    """Columns of a reference table in analysis/data by name, with text where it is not a number."""
    lines = [line for line in (REFERENCE / file).read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))

    def number(text):
        try:
            return float(text)
        except ValueError:
            return math.nan

    return {name: np.array([number(row[name]) for row in rows]) for name in rows[0]}


def arguments(description, add_options=None):
    """Command line of every figure: the campaign folder and the file to write."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("campaign", help="campaign folder, the one that holds cases/ and results.db")
    parser.add_argument("-o", "--output", help="file to write; its ending chooses the format (default: PNG)")
    parser.add_argument("--from", dest="start", type=float, metavar="T",
                        help="begin the averages at this time, h/U_b, but those of precursors; default: as in results.db, "
                             "whose numbers and fits keep their own window")
    parser.add_argument("--no-caption", action="store_true", help="leave out the lines below the figure")
    parser.add_argument("--style", choices=STYLES, default="screen", help=STYLE_HELP)
    if add_options:
        add_options(parser)
    options = parser.parse_args()
    plt.rcParams.update(STYLES[options.style])
    return options


def mirrored(y, values, sign=1):
    """A profile of half a symmetric channel, from the wall to the middle, over its whole height."""
    return np.concatenate([y, FLUID_HEIGHT - y[::-1]]), np.concatenate([values, sign * values[::-1]])


def grids_of(cases):
    return ", ".join(sorted({case.grid for case in cases}))


def caption(cases):
    """What the averages rest on: grids, windows and numbers of blocks, as they are."""

    def spread(values, form):
        low, high = form(min(values)), form(max(values))
        return low if low == high else f"{low}\N{EN DASH}{high}"

    starts, ends = [c.start[c.weight > 0][0] for c in cases], [c.end[c.weight > 0][-1] for c in cases]
    one_decimal = "{:.1f}".format
    return (
        f"Grid {grids_of(cases)} (the paper: {PAPER_GRID}). Means from t = {spread(starts, one_decimal)} "
        f"to {spread(ends, one_decimal)} $h/U_b$, {spread([int((c.weight > 0).sum()) for c in cases], str)} blocks, "
        f"{spread([c.weight.sum() for c in cases], one_decimal)} $h/U_b$ sampled."
    )


def draw_band(axes, x, values, width, colour):
    """The 95 % interval of values; nothing where there is none."""
    if width is not None:
        axes.fill_between(x, values - width, values + width, color=colour, alpha=0.2, linewidth=0)


def levels_within(values, levels):
    """Those at which these values have contours; matplotlib warns of the others."""
    return [level for level in levels if values.min() < level < values.max()]


def mark_interface(panel):
    """Where the interface is at rest."""
    panel.axvline(FLUID_HEIGHT, color="grey", linewidth=0.5)


def verdict(holds):
    return "holds" if holds else "MISSED"


def judge(name, value, bar):
    """One printed line: what was measured, the bar, and whether it holds."""
    print(f"{name:58s} {value:10.5f}   bar {bar:g}   {verdict(value <= bar)}")


def save(figure, options, script, text):
    """Write the figure with its caption below, by default next to the campaign's store."""
    name = pathlib.Path(script).stem.removeprefix("plot_") + ".png"
    output = pathlib.Path(options.output) if options.output else pathlib.Path(options.campaign) / name
    if not options.no_caption:
        characters = int(22 * figure.get_figwidth())  # of this size
        lines = [line for part in text.splitlines() for line in textwrap.wrap(part, characters)]
        figure.text(0.5, -0.01, "\n".join(lines), ha="center", va="top", fontsize=8)
    figure.savefig(output, bbox_inches="tight")
    plt.close(figure)
    print(output)
