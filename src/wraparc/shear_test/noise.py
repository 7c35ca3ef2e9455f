"""Noise of a record, and readings that are not part of it."""

import numpy as np

from wraparc.arrays import Array, Flags

_MAD = 1.4826
_WINDOW = 15
_FAR = 8.0
_MOST_SPIKES = 0.02


def noise_level(values: Array) -> float:
    """Standard deviation of one reading about a smooth curve, robust to outliers.

    From second differences y[i-1] - 2 y[i] + y[i+1], whose variance is 6 times that of
    white noise: sigma = 1.4826 median(|second difference|) / sqrt(6). Noise correlated over
    several readings is not seen in it.
    """
    if len(values) < 5:
        return 0.0
    return float(_MAD * np.median(np.abs(np.diff(values, 2))) / np.sqrt(6.0))


def despiked(values: Array) -> Flags:
    """Readings to keep: not further than 8 noise levels from the median of 15 neighbours.

    If more than 2 % were to go, they belong to the test (stick-slip) and all are kept.
    """
    keep = np.ones(len(values), dtype=bool)
    if len(values) < 3 * _WINDOW:
        return keep
    half = _WINDOW // 2
    padded = np.concatenate([values[half:0:-1], values, values[-2 : -half - 2 : -1]])
    windows = np.lib.stride_tricks.sliding_window_view(padded, _WINDOW)
    off = np.abs(values - np.median(windows, axis=1))
    level = max(noise_level(values), float(_MAD * np.median(off)))
    far = off > _FAR * level
    if level > 0.0 and far.mean() <= _MOST_SPIKES:
        keep = ~far
    return keep
