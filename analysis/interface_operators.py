"""Linear operators of a fluid with a mean flow below a soft layer, for small waves exp(i k x + s t).

Fluid in 0 < y < 2, mean flow U(y), viscosity N = nu + nu_t(y) (Orr-Sommerfeld, D = d/dy, u = i v' / k):
  (s + i k U)(D^2 - k^2) v - i k U'' v = N (D^2 - k^2)^2 v + 2 N' (D^3 - k^2 D) v + N'' (D^2 + k^2) v
Neo-Hookean layer in 2 < y < 2 + thickness, at rest, sheared by the mean stress: gamma = P (1 - y) / G,
B = [[1 + gamma^2, gamma], [gamma, 1]]. With the displacement f = v / s, e = i f' / k along y and x:
  b_xx = -(gamma^2)' f + 2 [(1 + gamma^2) i k e + gamma e'],  b_xy = -gamma' f + e' + (1 + gamma^2) i k f,
  b_yy = 2 (gamma i k f + f'),
  s (u' - i k v) = G {D (i k b_xx + D b_xy) - i k (i k b_xy + D b_yy)} + nu_s (D^2 - k^2)(u' - i k v)
Walls: v = v' = 0. Interface, at y = 2 + f: v and u + U' f continuous, and both parts of the traction,
  [N (u' + i k v + U'' f)] = [G b_xy + nu_s (u' + i k v) + G gamma' f - i k G gamma^2 f],
  [-p + 2 N v'] = [-p + G b_yy + 2 nu_s v'],  p from the momentum along x of each side.
Unknowns are v of the fluid, v and f of the layer at Chebyshev points: A q = s M q, a generalized eigenvalue problem.
Units: h, U_b, density 1.
"""

import functools
from dataclasses import dataclass

import packages

packages.needed("numpy")
import numpy as np
from numpy.polynomial import Chebyshev, Polynomial

from mean_profiles import DEPTH

POINTS = (120, 56)  # in the fluid, in the layer: laminar rates to ten digits, turbulent ones to three


@dataclass(frozen=True)
class Layer:
    """`G`: modulus / (rho U_b^2); `ratio`: viscosity over that of the fluid; `thickness`, h."""

    G: float
    ratio: float = 1.0
    thickness: float = 0.5


@functools.lru_cache
def derivatives(count, low, high):
    """Chebyshev points from low to high, and the polynomials of degree < count with their derivatives of order 0 to 4 on
    them, [order][point, polynomial]. The basis is 1, x, x^2, x^3 and the fourth integrals of Chebyshev polynomials,
    which keeps the digits that matrices of differentiation lose, as count^8, in a fourth derivative."""
    points = -np.cos(np.pi * np.arange(count) / (count - 1))
    columns = [[] for _ in range(5)]
    for n in range(count):
        power = n < 4
        one = Chebyshev.cast(Polynomial.basis(n)) if power else Chebyshev.basis(n - 4).integ(4, lbnd=-1)
        if not power:
            one = one * (n - 3)**4  # for all to be of the same size
        for order in range(5):
            columns[order].append((one.deriv(order) if order else one)(points))
    half = (high - low) / 2
    return low + (points + 1) * half, [np.array(rows).T / half**order for order, rows in enumerate(columns)]


class _Rows:
    """Rows of A q = s M q; q holds the values of three fields one after another."""

    def __init__(self, sizes):
        self.ends = np.cumsum([0, *sizes])
        self.A, self.M = (np.zeros((self.ends[-1], self.ends[-1]), complex) for _ in range(2))
        self.filled = 0

    def add(self, A, M=None):
        """`A`, `M`: what multiplies each field, {field: rows}."""
        count = 0
        for matrix, blocks in ((self.A, A), (self.M, M or {})):
            for field, block in blocks.items():
                block = np.atleast_2d(block)
                count = len(block)
                matrix[self.filled:self.filled + count, self.ends[field]:self.ends[field + 1]] += block
        self.filled += count


def _column(values):
    return np.asarray(values)[:, None]


class _Fluid:
    """Operators on v of the fluid. `on`: at one point, the last one."""

    def __init__(self, flow, k, points):
        y, d = derivatives(points, 0, DEPTH)
        self.d, self.k = d, k
        self.u = [_column(flow.u(y, order)) for order in range(3)]
        N = [_column(flow.eddy_viscosity(y, order)) for order in range(3)]
        N[0] = N[0] + 1 / flow.reynolds
        laplacian, bilaplacian = d[2] - k**2 * d[0], d[4] - 2 * k**2 * d[2] + k**4 * d[0]
        self.mass = laplacian
        self.rate = (-1j * k * self.u[0] * laplacian + 1j * k * self.u[2] * d[0] + N[0] * bilaplacian
                     + 2 * N[1] * (d[3] - k**2 * d[1]) + N[2] * (d[2] + k**2 * d[0]))
        self.along = 1j / k * d[1]  # u
        strain = 1j / k * d[2] + 1j * k * d[0]
        self.shear_stress = N[0] * strain
        # i k (-p + 2 N v') = s u + U' v + i k U u - N (D^2 - k^2) u - N' (u' + i k v) + 2 i k N v'
        self.normal_stress = (self.u[1] * d[0] + 1j * k * self.u[0] * self.along + 2j * k * N[0] * d[1]
                              - N[0] * 1j / k * (d[3] - k**2 * d[1]) - N[1] * strain)
        self.bend_stress = N[0] * self.u[2]  # N U'', times f


class _Solid:
    """Operators on v and on f of the layer."""

    def __init__(self, flow, layer, k, points):
        y, d = derivatives(points, DEPTH, DEPTH + layer.thickness)
        self.d, self.k = d, k
        nu = layer.ratio / flow.reynolds
        gamma, slope = _column(flow.gradient * (1 - y) / layer.G), -flow.gradient / layer.G
        laplacian, bilaplacian = d[2] - k**2 * d[0], d[4] - 2 * k**2 * d[2] + k**4 * d[0]
        self.mass, self.viscous = laplacian, nu * bilaplacian
        along = 1j / k * d[1]
        self.along = along
        xx = -2 * slope * gamma * d[0] + 2 * ((1 + gamma**2) * 1j * k * along + gamma * 1j / k * d[2])
        xy = -slope * d[0] + 1j / k * d[2] + (1 + gamma**2) * 1j * k * d[0]
        yy = 2 * (gamma * 1j * k * d[0] + d[1])
        # Derivatives of the products, one by one: a product of matrices would lose digits.
        d_xx = (-2 * slope**2 * d[0] - 2 * slope * gamma * d[1] - 2 * (2 * gamma * slope * d[1] + (1 + gamma**2) * d[2])
                + 2j / k * (slope * d[2] + gamma * d[3]))
        d_xy = -slope * d[1] + 1j / k * d[3] + 1j * k * (2 * gamma * slope * d[0] + (1 + gamma**2) * d[1])
        dd_xy = (-slope * d[2] + 1j / k * d[4]
                 + 1j * k * (2 * slope**2 * d[0] + 4 * gamma * slope * d[1] + (1 + gamma**2) * d[2]))
        d_yy = 2 * (1j * k * (slope * d[0] + gamma * d[1]) + d[2])
        force = 1j * k * d_xx + dd_xy - 1j * k * (1j * k * xy + d_yy)
        self.elastic = -1j * k * layer.G * force  # u' - i k v = (i / k)(D^2 - k^2) v
        strain = 1j / k * d[2] + 1j * k * d[0]
        self.shear_viscous = nu * strain
        self.shear_elastic = layer.G * (xy + slope * d[0] - 1j * k * gamma**2 * d[0])
        self.normal_viscous = 2j * k * nu * d[1] - nu * 1j / k * (d[3] - k**2 * d[1])
        self.normal_elastic = layer.G * (1j * k * yy - 1j * k * xx - d_xy)


def eigenvalue_problem(flow, layer, k, points=POINTS):
    """The matrices A, M of A q = s M q, q: v at the points of the fluid, then v and the displacement at those of the
    layer, all upward. Without a layer (None) the upper wall is rigid."""
    fluid = _Fluid(flow, k, points[0])
    d = fluid.d
    sizes = [points[0]] if layer is None else [points[0], points[1], points[1]]
    rows = _Rows(sizes)
    rows.add({0: fluid.rate[2:-2]}, {0: fluid.mass[2:-2]})
    rows.add({0: d[0][0]})
    rows.add({0: d[1][0]})
    if layer is None:
        rows.add({0: d[0][-1]})
        rows.add({0: d[1][-1]})
        return rows.A, rows.M
    solid = _Solid(flow, layer, k, points[1])
    e = solid.d
    rows.add({1: solid.viscous[2:-2], 2: solid.elastic[2:-2]}, {1: solid.mass[2:-2]})
    rows.add({2: e[0][-1]})
    rows.add({2: e[1][-1]})
    rows.add({1: np.eye(points[1])}, {2: np.eye(points[1])})  # s f = v
    rows.add({0: d[0][-1], 1: -e[0][0]})
    rows.add({0: fluid.along[-1], 1: -solid.along[0], 2: fluid.u[1][-1] * e[0][0]})
    rows.add({0: fluid.shear_stress[-1], 1: -solid.shear_viscous[0],
              2: fluid.bend_stress[-1] * e[0][0] - solid.shear_elastic[0]})
    rows.add({0: fluid.normal_stress[-1], 1: -solid.normal_viscous[0], 2: -solid.normal_elastic[0]},
             {0: -fluid.along[-1], 1: solid.along[0]})
    return rows.A, rows.M
