#!/usr/bin/env python3
"""The elastic walls as they stood at the last moment that is on the disk (the paper, figure 10): the surface in true
proportions, coloured by its height and by the pressure on it, and a third of it from near by."""

from campaign_data import arguments, grids_of, plt, read_campaign, save
from flow_fields import newest

import numpy as np
from matplotlib import cm, colors, ticker

CELLS = 72  # along x of a drawn surface
HEIGHT_RANGE = 0.13  # h, the paper's colour scale
PRESSURE_RANGE = 1.0  # rho U_b^2, the paper's, at most
ZOOM = 1.9  # of a flat box in a panel that is wide and low
ROW, FOOT = 2.1, 0.9  # heights of a row of panels and of the scales below them, inches


def resampled(values, shape):
    """A periodic field [z][x] on another number of points, by its Fourier series, with the first row and column again at the
    end."""
    modes = np.fft.fftshift(np.fft.fft2(values))
    for axis, (have, want) in enumerate(zip(values.shape, shape)):
        kept = min(have, want)
        modes = np.take(modes, range(have // 2 - kept // 2, have // 2 - kept // 2 + kept), axis=axis)
        before = want // 2 - kept // 2
        modes = np.pad(modes, [(before, want - kept - before) if each == axis else (0, 0) for each in (0, 1)])
    fine = np.fft.ifft2(np.fft.ifftshift(modes)).real * (shape[0] * shape[1] / values.size)
    return np.pad(fine, ((0, 1), (0, 1)), mode="wrap")


def draw_surface(panel, case, eta, colour_by, scale, parts=1):
    """The surface over one of so many parts of the box in each direction; `scale`: the largest value of the colours."""
    length_x, length_z = case.box
    shape = parts * max(2, round(CELLS * length_z / length_x)), parts * CELLS
    cut = tuple(slice(0, points // parts + 1) for points in shape)
    z, x = (np.arange(points // parts + 1) * length / points for points, length in zip(shape, (length_z, length_x)))
    height, colour_by = (resampled(values, shape)[cut] for values in (eta - case.interface_y, colour_by))
    painted = cm.RdBu_r(colors.Normalize(-scale, scale)(colour_by))[..., :3]
    slope = np.gradient(height, x[1], axis=1)
    lit = painted * np.clip(0.92 - 0.4 * slope, 0.5, 1)[..., None]  # the light comes from the right
    x, z = np.meshgrid(x, z)
    surface = panel.plot_surface(x, z, height, facecolors=lit, rstride=1, cstride=1, linewidth=0, antialiased=False, shade=False)
    surface.set_clip_on(False)  # the box of a wide surface reaches beyond the square that it is drawn in
    tallest = max(HEIGHT_RANGE, float(np.max(abs(height))))
    panel.set(xlim=(0, x.max()), ylim=(0, z.max()), zlim=(-tallest, tallest))
    panel.set_box_aspect((x.max(), z.max(), 2 * tallest), zoom=ZOOM)
    panel.view_init(elev=35, azim=-70)
    panel.set_axis_off()


def surface_of(moment):
    """eta and the pressure there less its mean, [z][x]."""
    eta = moment.interface_height()
    pressure = moment.on_surface("p", eta)
    return eta, pressure - pressure.mean()


def main():
    options = arguments(__doc__)
    cases = [case for case in read_campaign(options, any_state=True) if case.results.get("state") != "diverged"]
    moments = [(case, newest(case)) for case in cases if case.elastic]
    moments = [(case, moment) for case, moment in moments if moment is not None]
    if not moments:
        raise SystemExit("no elastic wall has a snapshot or a checkpoint")
    height = ROW * len(moments) + FOOT
    figure = plt.figure(figsize=(13, height))
    rows = figure.subplots(len(moments), 3, squeeze=False, subplot_kw={"projection": "3d"},
                           gridspec_kw={"left": 0, "right": 1, "bottom": FOOT / height, "top": 1, "wspace": 0, "hspace": 0})
    figure.add_artist(plt.Rectangle((0, 0), 1, 1, fill=False, linewidth=0))  # or the empty margin of a panel would be cut off
    surfaces = [surface_of(moment) for _, moment in moments]
    pressure_range = min(PRESSURE_RANGE, max(float(np.quantile(abs(pressure), 0.99)) for _, pressure in surfaces))
    for (case, moment), (eta, pressure), panels in zip(moments, surfaces, rows):
        draw_surface(panels[0], case, eta, eta - case.interface_y, HEIGHT_RANGE)
        draw_surface(panels[1], case, eta, pressure, pressure_range)
        draw_surface(panels[2], case, eta, eta - case.interface_y, HEIGHT_RANGE, parts=3)
        panels[0].set_title(f"{case.name}, t = {moment.time:.1f}", fontsize="small", y=0.9)
        panels[1].set_title("pressure", fontsize="small", y=0.9)
        panels[2].set_title("a third of the box", fontsize="small", y=0.9)
    for left, scale, words in ((0.07, HEIGHT_RANGE, r"$\eta-2h$, $h$"), (0.4, pressure_range, r"$p-\bar{p}$, $\rho U_b^2$")):
        shades = cm.ScalarMappable(colors.Normalize(-scale, scale), cm.RdBu_r)
        place = figure.add_axes((left, 0.6 * FOOT / height, 0.2, 0.12 / height))
        figure.colorbar(shades, cax=place, orientation="horizontal", label=words, ticks=ticker.MaxNLocator(4))
    grids = grids_of(case for case, _ in moments)
    save(figure, options, __file__, f"Grid {grids}. The flow goes to the right; the fluid lies below the surface. "
                                    "Proportions are true; the scale of the heights is the paper's.")


if __name__ == "__main__":
    main()
