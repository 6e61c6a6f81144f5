#!/usr/bin/env python3
"""Growth rates of small waves exp(i k x + s t) at the interface of a fluid with a mean flow and a soft layer.

  python3 analysis/linear_stability.py --G 0.25 --wavelength 2            one wave: its rates, the fastest first
  python3 analysis/linear_stability.py --profile cess --onset             the modulus at which waves begin to grow

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
Unknowns are v of the fluid, v and f of the layer at Chebyshev points: A q = s M q, a generalized eigenvalue problem,
solved by eigenvalues of (A - shift M)^-1 M. Units: h, U_b, density 1.
"""

import argparse
import functools
import math
import sys
from dataclasses import dataclass, replace

import packages

packages.needed("numpy")
import numpy as np
from numpy.polynomial import Chebyshev, Polynomial

import mean_profiles
from mean_profiles import DEPTH

POINTS = (120, 56)  # in the fluid, in the layer: laminar rates to ten digits, turbulent ones to three
TOLERANCE = 0.02  # between two numbers of points, for a rate to count, U_b/h


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


def nearest_rate(problem, guess):
    """The rate nearest to a guess, and its q, by inverse iteration; the shift follows once q has settled."""
    A, M = problem
    shift, q = guess, np.random.default_rng(1).standard_normal(len(A)) + 0j
    for iteration in range(25):
        try:
            new = np.linalg.solve(A - shift * M, M @ q)
        except np.linalg.LinAlgError:  # the shift is the rate to the last digit
            break
        step = np.vdot(new, q) / np.vdot(new, new)
        q = new / np.linalg.norm(new)
        if iteration >= 4:
            shift += step
            if abs(step) < 1e-11 * abs(shift):
                break
    return shift, q


def rates(flow, layer, wavelength, count=3, points=POINTS):
    """The `count` rates of largest growth, U_b/h, of waves that the points resolve: those which fewer points find too.
    Waves that move several times faster than fluid and shear waves are not looked at: they are not resolved."""
    k = 2 * math.pi / wavelength
    fine, coarse = (eigenvalue_problem(flow, layer, k, tuple(int(part * n) for n in points)) for part in (1, 0.8))
    shift = 0.5 - 0.5j * k  # grows, moves downstream
    inverse = np.linalg.eigvals(np.linalg.solve(coarse[0] - shift * coarse[1], coarse[1]))
    candidates = shift + 1 / inverse[np.abs(inverse) > 1e-3]
    fast = 3 * k * (np.max(flow.u(np.linspace(0, DEPTH, 50), 0)) + (math.sqrt(layer.G) if layer else 0))
    candidates = candidates[np.abs(candidates) < max(fast, 10)]
    found = []
    for guess in candidates[np.argsort(-candidates.real)]:
        s, _ = nearest_rate(fine, guess)
        if abs(s - guess) < TOLERANCE and not any(abs(s - other) < 1e-6 for other in found):
            found.append(s)
        if len(found) == count:
            return np.array(found)
    raise ValueError(f"{points} points resolve {len(found)} waves of length {wavelength:g}, not {count}: take more")


def followed_rate(layer, wavelength, flow_at, start, steps=8, points=POINTS):
    """The rate of the wave that has the rate `start` in flow_at(0), followed while the flow becomes flow_at(1). Where
    the wave is lost between two steps, more of them help."""
    known = [start]
    for part in np.linspace(0, 1, steps + 1)[1:]:
        guess = known[-1] if len(known) == 1 else 2 * known[-1] - known[-2]
        known.append(nearest_rate(eigenvalue_problem(flow_at(part), layer, 2 * math.pi / wavelength, points), guess)[0])
    return known[-1]


def interface_rate(layer, wavelength, reynolds, points=POINTS):
    """The rate in laminar flow of the wave that is the layer's slowest downstream one when all is at rest."""
    def flow_at(part):
        return mean_profiles.laminar(reynolds, part)
    at_rest = rates(flow_at(0), layer, wavelength, 12, points)
    start = max((s for s in at_rest if s.imag < -0.1 * math.sqrt(layer.G)), key=lambda s: s.imag)
    return followed_rate(layer, wavelength, flow_at, start, points=points)


def fastest(flow, layer, wavelengths, points=POINTS):
    """Rate and wave length of the fastest growing wave."""
    found = [(rates(flow, layer, wavelength, 1, points)[0], wavelength) for wavelength in wavelengths]
    return max(found, key=lambda pair: pair[0].real)


def onset(flow, layer, wavelengths, high=2.0, low=0.05, tolerance=0.01, points=(100, 44)):
    """The modulus below which some of these waves grow, to the relative tolerance, with the length of the one that does;
    None where it does not lie between low and high. layer.G is not read."""
    def growth(G, waves):
        s, wavelength = fastest(flow, replace(layer, G=G), waves, points)
        return s.real, wavelength
    if growth(high, wavelengths)[0] > 0:
        return None
    step = 1.3
    while True:  # down from above: in very soft layers it is other waves that grow
        low_end = high / step
        if low_end < low:
            return None
        rate, wavelength = growth(low_end, wavelengths)
        if rate > 0:
            break
        high = low_end
    while high > low_end * (1 + tolerance):
        middle = math.sqrt(low_end * high)
        rate, fastest_one = growth(middle, wavelengths)
        if rate > 0:
            low_end, wavelength = middle, fastest_one
        else:
            high = middle
    return math.sqrt(low_end * high), wavelength


def _flow(options):
    if options.profile == "laminar":
        return mean_profiles.laminar(options.reynolds)
    if options.profile in ("cess", "cess-molecular"):
        return mean_profiles.cess(options.reynolds, eddy=options.profile == "cess")
    return mean_profiles.read_measured(options.profile, options.reynolds, options.start)


def _options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--profile", default="laminar",
                        help="laminar; cess (waves feel its eddy viscosity); cess-molecular (they do not); or a file: "
                             "statistics.h5, or a table with columns y and u")
    parser.add_argument("--from", dest="start", type=float, default=0, metavar="T",
                        help="begin the mean of a statistics.h5 at this time, h/U_b")
    parser.add_argument("--reynolds", type=float, default=2800, help="U_b h / nu; of a statistics.h5 its own is taken")
    parser.add_argument("--G", type=float, default=0.25, help="modulus / (rho U_b^2)")
    parser.add_argument("--ratio", type=float, default=1, help="viscosity of the layer / of the fluid")
    parser.add_argument("--thickness", type=float, default=0.5, help="of the layer, h")
    parser.add_argument("--wavelength", type=float, nargs="+", default=[0.75, 1, 1.5, 2, 3, 6], help="h")
    parser.add_argument("--modes", type=int, default=3, help="how many rates to print of each wave")
    parser.add_argument("--points", type=int, nargs=2, default=POINTS, help="in the fluid, in the layer")
    parser.add_argument("--onset", action="store_true", help="find the modulus below which a wave grows")
    return parser.parse_args()


def main():
    options = _options()
    flow, layer = _flow(options), Layer(options.G, options.ratio, options.thickness)
    print(f"mean flow: {flow.name}, Re {flow.reynolds:g}, Re_tau {flow.re_tau:.1f}")
    if options.onset:
        found = onset(flow, layer, options.wavelength)
        print("no wave changes from growth to decay" if found is None else
              f"waves grow below G = {found[0]:.3f}, at first that of length {found[1]:g}")
        return
    print("wave length         growth    frequency   speed of the crests")
    for wavelength in options.wavelength:
        for s in rates(flow, layer, wavelength, options.modes, options.points):
            print(f"{wavelength:11g} {s.real:14.6f} {s.imag:12.6f} {-s.imag * wavelength / (2 * math.pi):10.4f}")


if __name__ == "__main__":
    sys.exit(main())
