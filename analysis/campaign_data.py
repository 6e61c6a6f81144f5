"""What every figure needs: the cases of a campaign folder, their means, and the look of a plot.

Everything is in units of the half height h, the bulk velocity U_b and density 1. Fits of the log law
(d, k + Dk, DU+) are read from results.db and never repeated here: analysis/log_law.cpp has the only one.
"""

import argparse
import csv
import functools
import json
import logging
import math
import pathlib
import sqlite3
import sys
import textwrap

import packages

packages.needed("h5py", "matplotlib", "numpy")
import batches
import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend has to be chosen first)

matplotlib.rcParams["pdf.fonttype"] = 42  # fonts go into the file whole, so that text in it stays text
# What a figure is for. In a column or on the page of a journal it is seen at about half its size: serifs as in the text
# around it, and dots fine enough for print. In a talk it is seen from afar: large letters and thick lines.
STYLES = {
    "screen": {"savefig.dpi": 150},
    "journal": {"savefig.dpi": 300, "font.family": "serif", "mathtext.fontset": "dejavuserif", "font.size": 12,
                "legend.fontsize": 10, "lines.linewidth": 1.4, "axes.linewidth": 0.8},
    "talk": {"savefig.dpi": 200, "font.size": 15, "legend.fontsize": 12, "lines.linewidth": 2.5, "axes.linewidth": 1.4},
}
STYLE_HELP = "screen (default), journal: serifs and 300 dots an inch, talk: large letters and thick lines"
logging.getLogger("fontTools").setLevel(logging.ERROR)  # it wonders about the age of matplotlib's own fonts

# The paper's colours of its four moduli, as its tables print them, and those of the next powers of two. A colour goes by
# the value, so that a case keeps its own whatever else is in the campaign.
COLOUR_OF_G = {8: "navy", 4: "blue", 2: "magenta", 1: "red", 0.5: "green", 0.25: "darkorange", 0.125: "saddlebrown"}
LINES = {"below": ":", "one": "-", "above": "--"}  # the paper's, by the viscosity ratio
MARKERS = "osv^D<>PX"  # for what a sweep varies besides G and the viscosity ratio
PAPER_GRID = "1296x432+108x648"
REFERENCE = pathlib.Path(__file__).parent / "data"
LABEL_G = r"$G/(\rho U_b^2)$"


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
    begins with the first one that starts at or after `start`."""

    def __init__(self, directory, results, start=None):
        self.directory = directory
        definition = json.loads((directory / "case.json").read_text())
        physics = definition["physics"]
        self.label = definition.get("label") or directory.name
        self.reynolds = physics.get("reynolds", 2800.0)
        self.elastic = physics["flow"] == "elastic_wall"
        solid = physics.get("solid", {})
        self.G = solid.get("G", math.inf)
        self.ratio = solid.get("viscosity_ratio", 1.0)
        domain = physics.get("domain", {})
        self.layer_height = domain.get("layer_height", 0.5)
        self.box = domain.get("length_x", 6.0), domain.get("length_z", 3.0)  # periods in x and z, h
        grid = physics["grid"]
        layer = f"+{grid['ny_solid']}" if self.elastic else ""
        self.grid = f"{grid['nx']}x{grid['ny_fluid']}{layer}x{grid['nz']}"
        self.results = results.get(directory.name, {})
        self.physics = physics
        self.colour, self.style, self.varied = "black", "-", {}
        self.marker = None  # where cases differ in more than G and the viscosity ratio
        if start is None or not self.elastic and self.results.get("is_precursor"):
            start = self.results.get("window_start")
        self._read_statistics(-math.inf if start is None else start)

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
        width = batches.half_width(self, lambda case: profile(case)[1])
        if width is not None:
            axes.fill_between(x, values - width, values + width, color=self.colour, alpha=0.2, linewidth=0)

    def result(self, quantity):
        """A measured quantity or its interval, NAME_ci95; NaN when there is none."""
        value = self.results.get(quantity)
        return math.nan if value is None else value


class SeriesCase:
    """One run directory of which the series are all there is: a closed box, an interface wave."""

    def __init__(self, directory):
        self.directory = directory
        self.physics = json.loads((directory / "case.json").read_text())["physics"]
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


def _read_results(campaign):
    """Everything measured, by run directory and name, intervals as NAME_ci95; empty without a store."""
    store = campaign / "results.db"
    if not store.exists():
        return {}
    with sqlite3.connect(f"{store.resolve().as_uri()}?mode=ro", uri=True) as connection:
        rows = connection.execute(
            "SELECT c.directory, q.quantity, q.value, q.ci95, q.window_start, c.is_precursor"
            " FROM quantities q JOIN cases c USING (case_id)")
        results = {}
        for directory, quantity, value, ci95, window_start, is_precursor in rows:
            of_case = results.setdefault(pathlib.Path(directory).name, {})
            of_case[quantity], of_case[quantity + "_ci95"] = value, ci95
            of_case["window_start"], of_case["is_precursor"] = window_start, is_precursor
        return results


def case_directories(campaign):
    """The run directories of the campaign as it is now; what earlier versions of its file left behind is named."""
    directories = sorted(path for path in campaign.glob("cases/*") if path.is_dir())
    store = campaign / "results.db"
    if not store.exists():
        return directories
    with sqlite3.connect(f"{store.resolve().as_uri()}?mode=ro", uri=True) as connection:
        rows = connection.execute("SELECT directory FROM cases WHERE in_campaign = 0")
        left_over = {pathlib.Path(directory).name for (directory,) in rows}
    left_out = [path.name for path in directories if path.name in left_over and (path / "statistics.h5").exists()]
    if left_out:
        tell(f"left out, no longer part of the campaign: {', '.join(left_out)}")
    return [path for path in directories if path.name not in left_over]


def colour_of(G):
    """A function of the value alone; moduli between the named ones have a colour between violet and dark red."""
    named = next((colour for value, colour in COLOUR_OF_G.items() if math.isclose(value, G, rel_tol=1e-9)), None)
    return named or plt.get_cmap("turbo")(min(max((math.log2(G) + 6) / 12, 0.0), 1.0))


def line_of(ratio):
    """The paper's: dotted below a viscosity ratio of 1, full at 1, dashed above it."""
    return LINES["one" if ratio == 1 else "below" if ratio < 1 else "above"]


def _parameters(physics, place=""):
    """Every parameter of a case by its full name, but those that have a look of their own or are no choice."""
    known = ("flow", "solid.G", "solid.viscosity_ratio", "initial.precursor", "initial.precursor_time", "initial.type")
    found = {}
    for key, value in physics.items():
        name = f"{place}{key}"
        if isinstance(value, dict):
            found.update(_parameters(value, name + "."))
        elif name not in known and not name.startswith("statistics."):
            found[name] = value
    return found


def _in_order(parameters, names):
    """Values of these parameters so that they sort: numbers by size, before words."""
    values = (parameters.get(name) for name in names)
    return tuple((0, value, "") if isinstance(value, (int, float)) else (1, 0, str(value)) for value in values)


def name_what_varies(cases):
    """Cases of one kind (rigid, elastic) may differ in more than G and the viscosity ratio: each says in what, and bears
    a marker for it."""
    for elastic in (False, True):
        kind = [case for case in cases if case.elastic == elastic]
        all_of = [_parameters(case.physics) for case in kind]
        names = sorted({name for one in all_of for name in one})
        varying = [name for name in names if len({json.dumps(one.get(name)) for one in all_of}) > 1]
        combinations = sorted({_in_order(one, varying) for one in all_of})
        for case, one in zip(kind, all_of):
            others = [name for name in varying if name in one and not name.startswith("grid.")]
            case.varied = {name.rpartition(".")[2]: one[name] for name in others}
            if len(others) < len(varying):
                case.varied = {"on": case.grid, **case.varied}
            if varying:
                case.marker = MARKERS[combinations.index(_in_order(one, varying)) % len(MARKERS)]
                case.style += case.marker


def _choose_styles(cases):
    """Colour by G; line by viscosity ratio; marker by whatever else varies."""
    for case in cases:
        if case.elastic:
            case.colour, case.style = colour_of(case.G), line_of(case.ratio)
    name_what_varies(cases)


def read_campaign(options):
    """All cases with usable statistics, rigid first, then by viscosity ratio and falling G. `options`: what
    arguments() returned."""
    campaign = pathlib.Path(options.campaign)
    if not campaign.is_dir():
        sys.exit(f"{campaign} is not a folder; give the campaign folder, the one that holds cases/")
    results = _read_results(campaign)
    cases = []
    for directory in case_directories(campaign):
        if not (directory / "statistics.h5").exists():
            continue
        try:
            cases.append(Case(directory, results, options.start))
        except (OSError, KeyError, ValueError) as error:
            tell(f"left out {directory}: {error}")
    if not cases:
        sys.exit(f"no case in {campaign / 'cases'} has statistics yet")
    cases.sort(key=lambda case: (case.elastic, case.ratio != 1, case.ratio, -case.G))
    _choose_styles(cases)
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
    matplotlib.rcParams.update(STYLES[options.style])
    return options


def mirrored(y, values, sign=1):
    """A profile of half a symmetric channel, from the wall to the middle, over its whole height 2."""
    return np.concatenate([y, 2 - y[::-1]]), np.concatenate([values, sign * values[::-1]])


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


def levels_within(values, levels):
    """Those at which these values have contours; matplotlib warns of the others."""
    return [level for level in levels if values.min() < level < values.max()]


def judge(name, value, bar):
    """One printed line: what was measured, the bar, and whether it holds."""
    print(f"{name:58s} {value:10.5f}   bar {bar:g}   {'holds' if value <= bar else 'MISSED'}")


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
