"""Spectrum in wave number and frequency of the interface, from the complex amplitudes of its longest waves in time."""

import numpy as np

LEAST_MOMENTS = 16  # of a segment
LONGEST_GAP = 4  # between two moments of one, in usual ones


def segments(time, start, length, share=0.5):
    """Parts of the moments from `start` on, of so much time each, every one beginning by a share of it later. Parts in which
    sampling has paused tell nothing of fast waves and are left out."""
    longest_gap, found, begin = LONGEST_GAP * np.median(np.diff(time)), [], start
    while begin + length <= time[-1] * (1 + 1e-9):
        part = np.flatnonzero((time >= begin) & (time <= begin + length))
        gaps = np.diff(np.concatenate([[begin], time[part], [begin + length]]))
        if len(part) >= LEAST_MOMENTS and gaps.max() <= longest_gap:
            found.append(part)
        begin += share * length
    return found


def _trapezoidal(time):
    """Weights of an integral over moments that need not lie evenly."""
    gaps = np.diff(time)
    return (np.append(gaps, 0) + np.append(0, gaps)) / 2


def space_time_spectrum(time, amplitude, start, length):
    """Frequencies w and E(m, w), [frequency][mode], of the waves exp(i (k x - w t)), from amplitudes [moment][mode]: mean over
    segments of that length (Hann window, half overlapping), such that the integral over w, of both signs, is the mean of
    |amplitude|^2 of the mode. None where there is no whole segment. Positive frequencies travel downstream."""
    parts = segments(time, start, length)
    if not parts:
        return None
    step = np.median(np.diff(time))
    most = int(length / (2 * step))
    frequencies = 2 * np.pi * np.arange(-most, most + 1) / length
    total = 0
    for part in parts:
        t = time[part] - time[part[0]]
        weight = _trapezoidal(t) * np.sin(np.pi * t / t[-1]) ** 2
        transform = np.exp(1j * np.outer(frequencies, t)) @ (weight[:, None] * amplitude[part])
        total = total + abs(transform) ** 2 / (_trapezoidal(t) * np.sin(np.pi * t / t[-1]) ** 4).sum() / (2 * np.pi)
    return frequencies, total / len(parts)
