"""The budget of the turbulent kinetic energy, row by row, from the powers and works that the solver has summed in spectra.h5.

Every term is of the fluctuations about the mean over time and plane: what <u> <f_x> takes of a power is the mean flow's. Rows
are those of the cells; what stands on the faces between two rows belongs to each by half, as in the solver, so that the
transports add up to zero, and all terms in each row. Units: rho U_b^3 / h.
"""

import math

import numpy as np


class Budget:
    """Of a case at a Reynolds number from its heights and sums (y and budget of spectra_data.Spectra)."""

    def __init__(self, y, sums, reynolds):
        self.y, faces = y["center"], y["face"]
        self.dy = np.diff(faces)
        self._mean = {name: sums.mean(name) for name in sums.names()}
        for name in ("rate_u", "rate_kinetic"):  # unknown to earlier versions of the solver
            self._mean.setdefault(name, np.zeros_like(self.y))
        self._gap = np.concatenate([[faces[1]], np.diff(self.y), [self.dy[-1]]])  # between centres, across each face
        u = np.concatenate([[-self._mean["u"][0]], self._mean["u"], [-self._mean["u"][-1]]])  # mirrored at the walls
        self.reynolds = reynolds
        self.shear = np.diff(u) / self._gap  # of the mean flow, on every face

    def mean(self, name):
        return self._mean[name]

    def total(self, rows):
        """Integral over the height."""
        return float((rows * self.dy).sum())

    def _from_faces(self, values):
        return (values[:-1] * self._gap[:-1] + values[1:] * self._gap[1:]) / (2 * self.dy)

    def _stress(self, force, at_wall):
        """The mean stress on every face whose differences are a mean force."""
        return at_wall + np.concatenate([[0], np.cumsum(self._mean[f"force_{force}"] * self.dy)])

    def power(self, force):
        """Of the fluctuations of a force."""
        return self._mean[f"power_{force}"] - self._mean["u"] * self._mean[f"force_{force}"]

    def rate(self):
        """Of change of the turbulent kinetic energy, from the first sample to the last: not small where a window is short."""
        return self._mean["rate_kinetic"] - self._mean["u"] * self._mean["rate_u"]

    def mean_work(self, force):
        """Of a mean stress on the mean shear."""
        at_wall = self.shear[0] / self.reynolds if force == "viscous" else 0.0  # the layer ends below the upper wall alone
        return self._from_faces(self._stress(force, at_wall) * self.shear)

    def work(self, force):
        """Dissipation, or work on the elastic solid, of the fluctuations."""
        return self._mean[f"work_{force}"] - self.mean_work(force)

    def terms(self):
        """By name. They add up to zero: what a mean has left of their sum is the error of closure."""
        flux = np.append(self._mean["uv"], 0.0)
        production = -self._from_faces(flux * self.shear)
        return {
            "production": production,
            "dissipation": -self.work("viscous") - self.work("excess"),
            "work on the wall": -self.work("elastic"),
            "turbulent transport": self.power("convection") - production,
            "pressure transport": self._mean["power_pressure"],
            "viscous transport": self.power("viscous") + self.power("excess") + self.work("viscous") + self.work("excess"),
            "elastic transport": self.power("elastic") + self.work("elastic"),
            "driving": self.power("driving"),
            "rate of change": -self.rate(),
        }

    def closure(self):
        """Integral of |sum of all terms| and |sum of the integrals|, over the production. NaN where nothing is produced, as in
        laminar flow."""
        terms = self.terms()
        rest, produced = sum(terms.values()), self.total(terms["production"])
        if produced <= 0:
            return math.nan, math.nan
        return self.total(abs(rest)) / produced, abs(self.total(rest)) / produced

    def bulk(self):
        """Where the power of the driving gradient goes, integrals over the height: dissipation in both fluids' viscosity, work
        on the wall and kinetic energy, all of the whole flow, and what is left."""
        driving = self.total(self._mean["power_driving"])
        spent = {name: self.total(self._mean[f"work_{name}"]) for name in ("viscous", "excess", "elastic")}
        spent["gained speed"] = self.total(self._mean["rate_kinetic"])
        return driving, spent, driving - sum(spent.values())
