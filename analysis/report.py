#!/usr/bin/env python3
"""One self-contained HTML page about a channel campaign: what was run and what it cost, what was measured beside what the
paper printed, every figure, how far the means have converged, the health of the solid, and where the numbers come from."""

import argparse
import base64
import contextlib
import datetime
import html
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

import packages

packages.needed("h5py", "matplotlib", "numpy")
import batches  # noqa: E402
import figures  # noqa: E402
from campaign_data import read_campaign  # noqa: E402
from transient import end_of_transient  # noqa: E402

STYLE = (pathlib.Path(__file__).parent / "report.css").read_text()
TITLES = {"time_series": "Friction and deformation in time", "friction": "Friction Reynolds numbers",
          "mean_velocity": "Mean velocity", "log_law": "Logarithmic law",
          "interface_velocity": "Velocity at the interface", "fluctuations": "Velocity fluctuations",
          "kinetic_energy": "Turbulent kinetic energy", "energy_budget": "Budget of the turbulent kinetic energy",
          "wall_surface": "The walls at the last moment",
          "elastic_stress": "Elastic stress", "velocity_planes": "Streamwise velocity along the upper wall",
          "correlations_x": "Correlations along the flow", "correlations_z": "Correlations across the flow",
          "spectra": "Spectra of the flow", "interface_shape": "Shape of the interface",
          "interface_pairs": "Velocity, pressure and height at the interface together",
          "wave_speeds": "Speeds of the waves at the interface", "stress": "Balance of shear stress"}
QUANTITIES = (("re_tau_w", "Re<sub>τ</sub><sup>w</sup>", 1), ("re_tau", "Re<sub>τ</sub>", 1), ("u_max", "u<sub>M</sub>", 3),
              ("y_max", "y<sub>M</sub>", 3), ("d", "d", 3), ("k_plus_dk", "k+Δk", 2), ("delta_u_plus", "ΔU<sup>+</sup>", 1),
              ("delta_max", "δ", 4), ("delta_rms", "δ′", 4))
READINGS = {"table": "G as in the paper's tables", "text": "G as in the paper's text", "half": "Half of the text's G"}
ID_DIGITS = 8  # of a case's id, in the name of its directory
WATCH_SECONDS = 60
WANTED = 0.01  # relative half width of the interval of Re_tau at which a mean counts as converged


def cell(value, digits):
    return "" if value is None else f"{value:.{digits}f}"


def measured(row, name, digits):
    """A value with its 95 % interval behind it, where there is one."""
    value, half_width = row[name], row.get(name + "_ci95")
    if value is None:
        return ""
    digits = batches.decimals(value, half_width, digits)
    return cell(value, digits) + ("" if half_width is None else f" <small>±\N{NO-BREAK SPACE}{half_width:.{digits}f}</small>")


def table(head, rows):
    """`head` and the cells of `rows` are HTML already."""
    lines = ["<div class=wide><table><thead><tr>", *(f"<th>{name}" for name in head), "</thead><tbody>"]
    for row in rows:
        lines += ["<tr>", *(f"<td>{value}" for value in row)]
    return "".join([*lines, "</tbody></table></div>"])


class Softwall:
    """What softwall says of a campaign, by its folder or its file."""

    def __init__(self, program, path):
        self.program, self.path = program, str(path)

    def ask(self, command, *words):
        done = subprocess.run([self.program, command, self.path, *words, "--json"], capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(done.stderr.strip())
        return json.loads(done.stdout)


def verdict(row):
    """Whether the mean friction has converged, and if not, how much more time it takes: an interval shrinks with the
    square root of the time averaged over."""
    value, half_width = row["re_tau"], row["re_tau_ci95"]
    if value is None:
        return "no averages yet"
    if half_width is None:
        return "too short for an interval"
    if half_width <= WANTED * value:
        return "converged to 1 %"
    more = (row["window_end"] - row["window_start"]) * ((half_width / (WANTED * value)) ** 2 - 1)
    return f"about {more:.0f} h/U<sub>b</sub> more for 1 %"


def state_of(one):
    share = min(1.0, one["time"] / one["end_time"]) if one["end_time"] > 0 else 0.0
    return f"{html.escape(one['state'])} <progress value={share:.3f}></progress> t = {one['time']:.4g} of {one['end_time']:.4g}"


def cases_section(status, results):
    by_id = {row["case_id"]: row for row in results}
    rows = []
    for one in status["cases"]:
        row = by_id.get(one["case_id"], {})
        hours = row.get("core_hours")
        is_early = one["reason"].startswith("finished early")
        remark = one["reason"] if is_early or one["state"] not in ("finished", "new") else ""
        rows.append((html.escape(one["label"]), state_of(one), cell(hours, 3), one["attempts"], html.escape(remark),
                     html.escape(row.get("note") or "")))
    return "<h2>Cases</h2>" + table(("case", "state", "core-hours", "attempts", "remark", "note on its results"), rows)


def transients(campaign):
    """When the transient of each case seems to end, by the first digits of its id, with which its directory's name ends."""
    cases = read_campaign(argparse.Namespace(campaign=campaign, start=None))
    return {case.directory.name.rpartition("-")[2]: end_of_transient(case) for case in cases}


def results_section(results, campaign):
    measured_rows = [row for row in results if row["re_tau"] is not None]
    if not measured_rows:
        return "<h2>Results</h2><p>None yet.</p>"
    ends = transients(campaign)
    head = ("case", *(name for _, name, _ in QUANTITIES), "transient until t", "averaged over t", "friction")
    rows = [(html.escape(row["label"]), *(measured(row, name, digits) for name, _, digits in QUANTITIES),
             cell(ends.get(row["case_id"][:ID_DIGITS]), 0),
             f"{cell(row['window_start'], 0)}–{cell(row['window_end'], 0)}", verdict(row)) for row in measured_rows]
    return ("<h2>Results</h2><p>Each with the half width of its 95 % confidence interval, where one can be given. Averages that "
            "begin before the transient has ended are biased.</p>" + table(head, rows))


def paper_section(compared):
    """Tables 1 and 2 of the paper: measured, and printed below it, once for each reading of its G."""
    parts = ["<h2>Beside the paper</h2><p>Rosti &amp; Brandt (J. Fluid Mech. 830, 2017) give two values of G for a row, one in "
             "their tables and half of that in their text. Measured values, and the printed ones in grey below them.</p>"]
    head = ("case", "paper's case", *(name for _, name, _ in QUANTITIES))
    for reading, title in READINGS.items():
        rows = []
        for row in compared:
            if row["reading"] != reading or row["re_tau"] is None:
                continue
            pairs = (measured(row, name, digits) + f"<br><span class=printed>{cell(row[name + '_paper'], digits)}</span>"
                     for name, _, digits in QUANTITIES)
            rows.append((html.escape(row["label"]), html.escape(row["paper_case"]), *pairs))
        parts.append(f"<h3>{title}</h3>" + (table(head, rows) if rows else "<p>No case of the paper has results.</p>"))
    return "".join(parts)


def figures_section(campaign, start):
    """Every figure inside the page: lines as vectors, pictures of the flow as pixels, which are smaller."""
    parts = ["<h2>Figures</h2>"]
    with tempfile.TemporaryDirectory() as folder:
        options = argparse.Namespace(campaign=campaign, output=folder, format="svg", start=start, no_caption=False, style="screen")
        with contextlib.redirect_stdout(io.StringIO()):  # where the figures lie for a moment concerns nobody
            drawn, reasons = figures.draw_all(options, pixels=figures.PICTURES)
        for name, file in drawn.items():
            kind = {".svg": "svg+xml", ".png": "png"}[file.suffix]
            picture = base64.b64encode(file.read_bytes()).decode()
            parts.append(f'<figure><img alt="{TITLES[name]}" src="data:image/{kind};base64,{picture}">'
                         f"<figcaption>{TITLES[name]}</figcaption></figure>")
    parts += [f"<p>{TITLES[name]}: {html.escape(reason)}</p>" for name, reason in reasons.items()]
    return "".join(parts)


def health_section(softwall):
    """The last reported state of each solid."""
    names = ("interface_width_cells", "max_det_error", "limited_share", "solid_fraction_drift", "max_divergence")
    found = {}
    for row in softwall.ask("query", "SELECT c.label, d.name, d.value FROM diagnostics d JOIN cases c USING (case_id)"
                                 " WHERE c.in_campaign ORDER BY c.rowid, d.attempt"):
        found.setdefault(row["label"], {})[row["name"]] = row["value"]
    rows = [(html.escape(label), *("" if values.get(name) is None else f"{values[name]:.3g}" for name in names))
            for label, values in found.items()]
    words = ("case", "width of the interface, cells", "largest |det B − 1|", "parts of its cells torn or limited", "drift of the solid's volume",
             "largest divergence")
    return "<h2>Health of the solutions</h2><p>As the last attempt left them.</p>" + table(words, rows)


def provenance_section(softwall):
    rows = softwall.ask("query", "SELECT c.label, a.attempt, a.host, a.ranks, a.started, a.ended, a.outcome, a.reason, a.version,"
                             " a.git_revision, a.compiler FROM attempts a JOIN cases c USING (case_id)"
                             " WHERE c.in_campaign ORDER BY a.intended")
    cells = [[html.escape("" if value is None else str(value)) for value in row.values()] for row in rows]
    head = ("case", "attempt", "host", "ranks", "started", "ended", "outcome", "reason", "version", "revision", "compiler")
    return "<details><summary><h2>Every attempt</h2></summary>" + table(head, cells) + "</details>"


def page(campaign, softwall, start):
    given = () if start is None else ("--from", repr(start))
    status = softwall.ask("status")
    compared = softwall.ask("table", *given)
    results = softwall.ask("query", "SELECT * FROM results", *given)
    definition = json.loads(softwall.ask("query", "SELECT spec FROM campaign")[0]["spec"])
    name = html.escape(status["campaign"])
    finished = sum(one["state"] == "finished" for one in status["cases"])
    hours = sum(row["core_hours"] or 0 for row in results)
    now = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    head = (f"<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content='width=device-width'>"
            f"<title>{name}</title><style>{STYLE}</style><h1>{name}</h1><p>{html.escape(definition.get('description', ''))}</p>"
            f"<p class=summary>{finished} of {len(status['cases'])} cases finished, {hours:.3g} core-hours. Written {now}.</p>")
    return "".join((head, cases_section(status, results), results_section(results, campaign), paper_section(compared),
                    figures_section(campaign, start), health_section(softwall), provenance_section(softwall),
                    f"<details><summary><h2>Campaign file</h2></summary><pre>{html.escape(json.dumps(definition, indent=1))}</pre>"
                    "</details></html>\n"))


def write_whole(output, text):
    """A reader never sees half a page. A device, a pipe or a file with several names is written to and stays what it is, and
    where a link is named, the file is written that it points to."""
    place = output.resolve()
    try:
        if place.exists() and (not place.is_file() or place.stat().st_nlink > 1):
            place.write_text(text)
            return
        whole = place.with_name(place.name + ".new")
        whole.write_text(text)
        if place.exists():
            shutil.copymode(place, whole)
        whole.replace(place)
    except OSError as error:
        sys.exit(f"{output}: cannot write: {error.strerror}")


def main():
    parser = argparse.ArgumentParser(prog="softwall report", description=__doc__)
    parser.add_argument("campaign", type=pathlib.Path, help="campaign folder, the one that holds cases/ and results.db")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="file to write; default: report.html in the campaign's folder")
    parser.add_argument("--from", dest="start", type=float, metavar="T", help="begin the averages at this time, h/U_b")
    parser.add_argument("--softwall", default="softwall", help="the program that is asked for tables and states")
    parser.add_argument("--path", help="what it is asked about, where the campaign's file is not called campaign.json")
    parser.add_argument("--watch", action="store_true", help="write it again every minute until the run has ended")
    options = parser.parse_args()
    if not (options.campaign / "results.db").exists():
        sys.exit(f"no results in {options.campaign}; run `softwall run` there first")
    output = options.output or options.campaign / "report.html"
    softwall = Softwall(options.softwall, options.path or options.campaign)
    while True:
        running = options.watch and softwall.ask("status")["runner"] is not None  # asked first: the last page has the end
        write_whole(output, page(options.campaign, softwall, options.start))
        print(output, flush=True)
        if not running:
            break
        time.sleep(WATCH_SECONDS)


if __name__ == "__main__":
    main()
