#!/usr/bin/env python3
"""Budget of the turbulent kinetic energy across the channel, from the powers and works that the solver has summed; prints how
well it closes, and where the power of the driving gradient goes."""

import math

from campaign_data import arguments, draw_band, grids_of, judge, plt, read_campaign, save
from energy_budget import Budget
from spectra_data import read_spectra

import batches

RATE = "rate of change"
STYLES = {"production": ("tab:blue", "-"), "dissipation": ("tab:red", "-"), "turbulent transport": ("tab:green", "--"),
          "pressure transport": ("tab:purple", "--"), "viscous transport": ("tab:brown", "--"),
          "work on the wall": ("tab:orange", "-"), "elastic transport": ("tab:pink", "--"),
          RATE: ("tab:grey", ":")}
OF_ELASTIC_WALLS = ("work on the wall", "elastic transport")
BAR = 0.02  # of the production


def print_balance(case, budget):
    local, whole = budget.closure()
    judge(f"{case.label}: budget, row by row, over production", local, BAR)
    judge("  of the whole height", whole, BAR)
    driving, spent, rest = budget.bulk()
    words = ", ".join(f"{name} {value / driving:.4f}" for name, value in spent.items())
    print(f"  power of the driving gradient {driving:.6f} rho U_b^3; of it {words}, rest {rest / driving:.4f}")


def intervals_of(spectra, reynolds):
    """Half widths of the terms by name, none with too few blocks. The rate of change has none: it is no mean of blocks that say the
    same, but their sum."""
    terms_of = lambda sums: {name: rows for name, rows in Budget(spectra.y, sums, reynolds).terms().items() if name != RATE}
    widths = batches.half_width(spectra.budget, lambda sums: [*terms_of(sums).values()])
    return {} if widths is None else dict(zip(terms_of(spectra.budget), widths))


def draw(panel, case, spectra, budget):
    terms, intervals = budget.terms(), intervals_of(spectra, case.reynolds)
    for name, (colour, line) in STYLES.items():
        if case.elastic or name not in OF_ELASTIC_WALLS:
            panel.plot(budget.y, terms[name], line, color=colour, linewidth=1.1, label=name)
            draw_band(panel, budget.y, terms[name], intervals.get(name), colour)
    panel.plot(budget.y, sum(terms.values()), color="black", linewidth=0.8, label="sum of all")
    if case.elastic:
        panel.axvline(case.interface_y, color="grey", linewidth=0.5)
    local, _ = budget.closure()
    rest = "no production" if math.isnan(local) else f"sum {100 * local:.1f} % of production"
    panel.set(xlabel=r"$y/h$", xlim=(0, budget.y[-1]), title=f"{case.name}\n{rest}")


def main():
    options = arguments(__doc__)
    found = [(case, spectra, Budget(spectra.y, spectra.budget, case.reynolds)) for case in read_campaign(options)
             if (spectra := read_spectra(case)) and spectra.budget]
    if not found:
        raise SystemExit("no case has a budget of energy in its averaging window")
    columns = min(3, len(found))
    figure, panels = plt.subplots(-(-len(found) // columns), columns, layout="constrained", squeeze=False,
                                  figsize=(4.5 * columns + 2, 3.4 * -(-len(found) // columns)))
    for panel in panels.flat[len(found):]:
        panel.set_axis_off()
    for panel, (case, spectra, budget) in zip(panels.flat, found):
        print_balance(case, budget)
        draw(panel, case, spectra, budget)
    for row in panels:
        row[0].set_ylabel(r"$\rho U_b^3/h$")
    most = max(panels.flat, key=lambda panel: len(panel.lines))  # that of an elastic wall, if there is one
    panels[0, -1].legend(handles=[line for line in most.lines if line.get_label()[0] != "_"], fontsize="x-small",
                         loc="upper left", bbox_to_anchor=(1.01, 1))
    save(figure, options, __file__, f"Grid {grids_of(case for case, *_ in found)}. Fluctuations about the mean over time and plane, "
                                    "in fluid and wall; terms as the scheme has them. Bands: 95 % intervals.")


if __name__ == "__main__":
    main()
