"""The look of a plot: what it is for, and by what its cases are told apart."""

import json
import logging
import math

import packages

packages.needed("matplotlib")
import matplotlib

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


def choose_styles(cases):
    """Colour by G; line by viscosity ratio; marker by whatever else varies."""
    for case in cases:
        if case.elastic:
            case.colour, case.style = colour_of(case.G), line_of(case.ratio)
    name_what_varies(cases)
