"""Rates of the waves in a record: complex exponentials fitted together, of which one is wanted."""

import numpy as np


def fitted_rates(t, records, guesses, steps=60):
    """The rates s_m for which records[n, :] = sum_m c_m exp(s_m t_n) in the sense of least squares, c_m free for each
    column (variable projection with Levenberg's damping; the derivatives by differences). `records`: complex, one row
    for each time, the columns of one size. Returns the rates and the rms of what is left over that of the records."""
    shift = guesses[0]  # of the common growth, so that early and late times count alike
    records = records * np.exp(-shift * t)[:, None]
    s = np.array(guesses, complex) - shift

    def rest(s):
        exponents = np.outer(t, s)
        waves = np.exp(exponents - exponents.real.max(axis=0))  # 1 at most, whatever rate is tried
        return (records - waves @ np.linalg.lstsq(waves, records, rcond=None)[0]).ravel()

    def slopes(s, step=1e-6):
        columns = []
        for m in range(len(s)):
            for direction in (step, 1j * step):
                change = np.zeros(len(s), complex)
                change[m] = direction
                columns.append((rest(s + change) - rest(s - change)) / (2 * step))
        return np.array(columns).T

    def as_real(values):
        return np.concatenate([values.real, values.imag])

    error, damping = rest(s), 1e-3
    for _ in range(steps):
        slope = as_real(slopes(s))
        square, right = slope.T @ slope, -slope.T @ as_real(error)
        while damping < 1e8:
            change = np.linalg.lstsq(square + damping * np.diag(np.diag(square)), right, rcond=None)[0]
            tried = s + change[0::2] + 1j * change[1::2]
            tried_error = rest(tried)
            if np.linalg.norm(tried_error) < np.linalg.norm(error):
                break
            damping *= 4
        else:
            break  # no step is better than none
        moved = np.abs(tried - s).max()
        s, error, damping = tried, tried_error, max(damping / 5, 1e-12)
        if moved < 1e-10:
            break
    return s + shift, np.linalg.norm(error) / np.linalg.norm(records)
