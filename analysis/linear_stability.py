#!/usr/bin/env python3
"""Growth rates of small waves exp(i k x + s t) at the interface of a fluid with a mean flow and a soft layer.

  python3 analysis/linear_stability.py --G 0.25 --wavelength 2            one wave: its rates, the fastest first
  python3 analysis/linear_stability.py --profile cess --onset             the modulus at which waves begin to grow

interface_operators.py has the equations, a generalized eigenvalue problem A q = s M q, which is solved by eigenvalues of
(A - shift M)^-1 M. Units: h, U_b, density 1.
"""

import argparse
import math
import sys
from dataclasses import replace

import packages

packages.needed("numpy")
import numpy as np

import mean_profiles
from interface_operators import POINTS, Layer, eigenvalue_problem
from mean_profiles import DEPTH

TOLERANCE = 0.02  # between two numbers of points, for a rate to count, U_b/h


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


LOWEST_ONSET, HIGHEST_ONSET = 0.05, 2.0
POINTS_OF_ONSET = 100, 44  # rates change by less than the tolerance with more


def onset(flow, layer, wavelengths, high=HIGHEST_ONSET, low=LOWEST_ONSET, tolerance=0.01, points=POINTS_OF_ONSET):
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
    parser.add_argument("--points", type=int, nargs=2, help=f"in the fluid, in the layer; default: {POINTS}, of an "
                        f"onset {POINTS_OF_ONSET}")
    parser.add_argument("--onset", action="store_true", help="find the modulus below which a wave grows")
    return parser.parse_args()


def main():
    options = _options()
    flow, layer = _flow(options), Layer(options.G, options.ratio, options.thickness)
    print(f"mean flow: {flow.name}, Re {flow.reynolds:g}, Re_tau {flow.re_tau:.1f}")
    if options.onset:
        found = onset(flow, layer, options.wavelength, points=options.points or POINTS_OF_ONSET)
        print(f"no onset between G = {LOWEST_ONSET:g} and {HIGHEST_ONSET:g}" if found is None else
              f"waves grow below G = {found[0]:.3f}, at first that of length {found[1]:g}")
        return
    print("wave length         growth    frequency   speed of the crests")
    for wavelength in options.wavelength:
        for s in rates(flow, layer, wavelength, options.modes, options.points or POINTS):
            print(f"{wavelength:11g} {s.real:14.6f} {s.imag:12.6f} {-s.imag * wavelength / (2 * math.pi):10.4f}")


if __name__ == "__main__":
    sys.exit(main())
