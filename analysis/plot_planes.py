#!/usr/bin/env python3
"""The planes of a film that cases have left (`run.plane_interval` in the campaign file): the height of the interface about
its place at rest, and one quantity of the flow in every plane. One picture of the last moment, or of the one nearest to
--time; or with --film a picture of every moment, from --from on: numbered PNG files in a folder, or one GIF."""

import pathlib
import re

from campaign_data import arguments, case_called, grids_of, plt, read_campaign, save
from film_data import NAMES, largest, moments_of, nearest_in_time

import numpy as np
from matplotlib import cm, colors
from PIL import Image

LABELS = {"u": r"$u/U_b$", "v": r"$v/U_b$", "w": r"$w/U_b$", "p": r"$p/(\rho U_b^2)$", "phi": r"$\phi$"}
WIDTH, AROUND = 5.2, 0.8  # of the widest plane; above and below each that is taken by words, inches
FRAMES_PER_SECOND = 10


def add_options(parser):
    parser.add_argument("--case", metavar="LABEL", help="this case alone; default: all that have a film, side by side")
    parser.add_argument("--quantity", choices=LABELS, default="u", help="what the planes show; default: u")
    parser.add_argument("--time", type=float, metavar="T", help="the moment nearest to this time, h/U_b; default: the last")
    parser.add_argument("--film", action="store_true",
                        help="every moment: numbered PNG files in the folder -o (default: film/ in the campaign's folder), or one "
                             "animated picture where -o ends in .gif")


def colours(quantity, largest_value):
    """u and phi begin at 0, all else lies about it."""
    largest_value = max(largest_value, 1e-12)
    if quantity in ("u", "phi"):
        return cm.ScalarMappable(colors.Normalize(0, 1 if quantity == "phi" else largest_value), "viridis")
    return cm.ScalarMappable(colors.Normalize(-largest_value, largest_value), "RdBu_r")


def draw_plane(panel, moment, name, quantity, shades):
    """Nothing but the title's place where this case has no such plane."""
    if name not in moment.places:
        panel.set_axis_off()
        return
    values, phi = moment.plane(name, quantity), moment.plane(name, "phi")
    if name == "interface":
        values = moment.plane(name, "height") - moment.places[name]
    if values is not None:
        panel.pcolormesh(*moment.corners(name), values, cmap=shades.cmap, norm=shades.norm, rasterized=True)
    if phi is not None and min(phi.shape) > 1 and phi.min() < 0.5 < phi.max():
        panel.contour(*moment.centres(name), phi, levels=[0.5], colors="black", linewidths=0.8)
    right, up = NAMES[moment.axis(name)]
    panel.set(xlabel=f"${right}/h$", ylabel=f"${up}/h$", aspect="equal")


def title_of(name, moment):
    if name == "interface":
        return "height of the interface"
    return rf"${moment.axis(name)}={moment.places[name]:.3g}h$" if name in moment.places else ""


class Picture:
    """Cases side by side, their planes below each other, in colours that fit all moments that are going to be drawn."""

    def __init__(self, films, quantity):
        self.films, self.quantity = films, quantity
        drawn = [moment for _, moments in films for moment in moments]
        self.names = sorted({name for moment in drawn for name in moment.places}, key=lambda name: (name != "interface", name))
        self.extents = [next([faces[-1] - faces[0] for faces in moment.corners(name)] for moment in drawn
                             if name in moment.places) for name in self.names]
        self.scale = WIDTH / max(extent[0] for extent in self.extents)  # the same for all planes, inches per h
        scale = largest(drawn, self.names, quantity)
        departure = max((float(abs(moment.plane("interface", "height") - moment.places["interface"]).max())
                         for moment in drawn if "interface" in moment.places), default=0.0)
        self.shades = {name: colours("height", departure) if name == "interface" else colours(quantity, scale)
                       for name in self.names}

    def draw(self, moment_of):
        """A figure of one moment of every case: `moment_of(moments)`."""
        rows, columns = len(self.names), len(self.films)
        heights = [self.scale * extent[1] + AROUND for extent in self.extents]
        figure, panels = plt.subplots(rows, columns, squeeze=False, layout="constrained", height_ratios=heights,
                                      figsize=((WIDTH + 0.6) * columns + 1, sum(heights)))
        for (case, moments), column in zip(self.films, panels.T):
            moment = moment_of(moments)
            for name, panel in zip(self.names, column):
                draw_plane(panel, moment, name, self.quantity, self.shades[name])
                panel.set_title(title_of(name, moment), fontsize="small")
            column[0].set_title(f"{case.name}, t = {moment.time:.2f}\n{column[0].get_title()}", fontsize="small")
        for name, row in zip(self.names, panels):
            label = r"$(\eta-\eta_0)/h$" if name == "interface" else LABELS[self.quantity]
            figure.colorbar(self.shades[name], ax=list(row), label=label, shrink=0.8)
        return figure


def times_of(films):
    """Those of the case with most moments; the others show theirs that are nearest."""
    return [moment.time for moment in max((moments for _, moments in films), key=len)]


def figures_of(picture, times):
    """One figure of each moment after the other; it is closed when the next one is asked for."""
    for time in times:
        figure = picture.draw(lambda moments: nearest_in_time(moments, time))
        yield figure
        plt.close(figure)


def remove_numbered_from(folder, number):
    """What an earlier, longer film has left behind the last picture of this one."""
    for file in folder.glob("*.png"):
        if re.fullmatch(r"\d{5,}", file.stem) and int(file.stem) >= number:
            file.unlink()


def write_numbered(picture, times, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for number, figure in enumerate(figures_of(picture, times)):
        figure.savefig(folder / f"{number:05d}.png")
    remove_numbered_from(folder, len(times))
    print(folder)


def frames_of(picture, times):
    """The same figures as pixels; none is kept here."""
    for figure in figures_of(picture, times):
        figure.canvas.draw()
        yield Image.fromarray(np.array(figure.canvas.buffer_rgba()))


def write_animated(picture, times, file):
    """Pillow takes frame after frame, and keeps a byte a pixel of each."""
    frames = frames_of(picture, times)
    next(frames).save(file, save_all=True, append_images=frames, duration=1000 // FRAMES_PER_SECOND, loop=0)
    print(file)


def main():
    options = arguments(__doc__, add_options)
    cases = read_campaign(options)
    if options.case:
        cases = [case_called(options.case, cases)]
    films = [(case, moments_of(case, options.start)) for case in cases]
    films = [(case, moments) for case, moments in films if moments]
    if not films:
        raise SystemExit("no case has a film; run.plane_interval and run.planes in the campaign file ask for one")
    if options.film:
        picture, output = Picture(films, options.quantity), pathlib.Path(options.output or pathlib.Path(options.campaign) / "film")
        return (write_animated if output.suffix == ".gif" else write_numbered)(picture, times_of(films), output)
    picture = Picture([(case, [nearest_in_time(moments, options.time)]) for case, moments in films], options.quantity)
    figure = picture.draw(lambda moments: moments[0])
    save(figure, options, __file__, f"Grid {grids_of(case for case, _ in films)}. The flow goes along x. Lines: half solid.")


if __name__ == "__main__":
    main()
