"""Mean flows between a rigid wall at y = 0 and an interface at y = 2, for linear theory: laminar, Cess's turbulent
profile, or one that was measured. Lengths in h, velocities in U_b, density 1; only numpy is needed, and h5py for a
statistics.h5.
"""

import csv
import math
from dataclasses import dataclass
from typing import Callable

import packages

packages.needed("numpy")
import numpy as np
from numpy.polynomial import Chebyshev

DEPTH = 2.0


@dataclass(frozen=True)
class MeanFlow:
    """`u(y, order)`: the mean velocity, U_b, or its derivative of order 0, 1 or 2 on 0 <= y <= 2, zero at both ends.
    `eddy_viscosity(y, order)`: likewise, U_b h; zero for a flow that has none. `gradient`: driving gradient P, U_b^2/h,
    which acts over the whole height, so that the mean shear stress in the layer is P (1 - y)."""

    name: str
    reynolds: float
    gradient: float
    u: Callable
    eddy_viscosity: Callable

    @property
    def re_tau(self):
        """The friction Reynolds number. The momentum balance of both walls together gives u_tau^2 = P."""
        return math.sqrt(self.gradient) * self.reynolds


def _none(y, _order):
    return np.zeros_like(y)


def _in_fluid(series):
    """A Chebyshev series over 0 <= y <= 2 with its derivatives, as MeanFlow wants them."""
    derivatives = [series.deriv(order) if order else series for order in range(3)]
    return lambda y, order: derivatives[order](y)


def laminar(reynolds, part=1.0):
    """Plane Poiseuille flow, or the given part of it."""
    parabola = Chebyshev.fit([0, 1, 2], [0, 1.5 * part, 0], 2, domain=[0, DEPTH])
    return MeanFlow("laminar", reynolds, 3 * part / reynolds, _in_fluid(parabola), _none)


def cess(reynolds, eddy=True, karman=0.426, damping=25.4):
    """Turbulent channel after Cess (1958) with the constants of Reynolds & Hussain, J. Fluid Mech. 54 (1972):
      nu_t / nu = 1/2 sqrt(1 + [K Re_tau / 3 (2 y - y^2) (3 - 4 y + 2 y^2) (1 - exp(-Y Re_tau / A))]^2) - 1/2,
      U' = u_tau^2 (1 - y) / (nu + nu_t),   Y: distance from a wall, the factor once for each,
    Re_tau such that the bulk velocity is 1. `eddy`: whether waves feel nu_t as well."""
    nu = 1 / reynolds
    nodes = Chebyshev.basis(128, domain=[0, DEPTH]).roots()

    def ratio(y, re_tau):
        rise = karman * re_tau / 3 * (2 * y - y**2) * (3 - 4 * y + 2 * y**2)
        for wall in (y, DEPTH - y):  # both at once, so that nothing has a kink in the middle
            rise = rise * (1 - np.exp(-wall * re_tau / damping))
        return 0.5 * np.sqrt(1 + rise**2) - 0.5

    def velocity(re_tau):
        slope = (re_tau * nu)**2 * (1 - nodes) / (nu * (1 + ratio(nodes, re_tau)))
        return Chebyshev.fit(nodes, slope, 127, domain=[0, DEPTH]).integ(lbnd=0)

    def bulk(u):
        return u.integ(lbnd=0)(DEPTH) / DEPTH

    low, high = math.sqrt(3 * reynolds), reynolds  # laminar; more than any channel has
    while high - low > 1e-10 * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if bulk(velocity(middle)) < 1 else (low, middle)
    viscosity = Chebyshev.fit(nodes, nu * ratio(nodes, low), 127, domain=[0, DEPTH])
    return MeanFlow("Cess" + ("" if eddy else " without eddy viscosity"), reynolds, (low * nu)**2,
                    _in_fluid(velocity(low)), _in_fluid(viscosity) if eddy else _none)


def measured(y, u, reynolds, gradient, degree=24):
    """A smooth profile through mean velocities `u` at heights `y` (those in the fluid are used): y (2 - y) times the
    polynomial of least squares that bends as the data ask for; waves feel the molecular viscosity alone. The degree
    is cut to twice the root of the number of heights, beyond which it would follow every one of them."""
    y, u = np.asarray(y, float), np.asarray(u, float)
    inside = (y > 0) & (y < DEPTH)
    y, u = y[inside], u[inside]
    if len(y) < 8:
        raise ValueError(f"a mean profile needs at least 8 heights between 0 and {DEPTH:g}, not {len(y)}")
    degree = min(degree, int(2 * math.sqrt(len(y))))
    wall = y * (DEPTH - y)
    bend = Chebyshev.fit(y, u / wall, degree, domain=[0, DEPTH], w=wall)
    return MeanFlow("measured", reynolds, gradient,
                    _in_fluid(bend * Chebyshev.fit([0, 1, 2], [0, 1, 0], 2, domain=[0, DEPTH])), _none)


def read_measured(file, reynolds=None, start=0.0):
    """The mean of a statistics.h5; or of a table with columns y and u whose first line names them, for which the
    driving gradient follows from the shear at both walls. `start`: the mean of a statistics.h5 begins with the first
    block that starts at or after it, h/U_b."""
    if str(file).endswith(".h5"):
        import h5py
        with h5py.File(file) as data:
            weight = np.where(data["blocks/start"][:] >= start * (1 - 1e-9), data["blocks/weight"][:], 0)
            if not weight.sum() > 0:
                raise ValueError(f"{file} holds no block that starts at or after t = {start:g}")
            mean = lambda values: np.average(values, axis=0, weights=weight)
            return measured(data["grid/y_center"][:], mean(data["profiles/u"][:]), float(data.attrs["reynolds"]),
                            float(mean(data["series/driving_gradient"][:])))
    if reynolds is None:
        raise ValueError("a table of a mean profile needs its Reynolds number")
    with open(file) as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    y, u = ([float(row[name]) for row in rows] for name in ("y", "u"))
    flow = measured(y, u, reynolds, 0)
    ends = np.array([0, DEPTH])
    shear = flow.u(ends, 1)
    return measured(y, u, reynolds, (shear[0] - shear[1]) / DEPTH / reynolds)
