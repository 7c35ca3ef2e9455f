"""Correlation of noise along a record, from the residuals of a fit that has made them small.

A fit follows slow noise with its parameters, so the residuals show less of it, and a shorter
memory, than it has: estimated from them as they are, 95 % intervals of curves with noise of
neighbour correlation 0.9 held the truth in 61 of 100. Here the noise is a first-order
autoregression whose memory is judged by the restricted likelihood, in which the fitted parameters
are integrated out (Patterson and Thompson 1971), and averaged over all memories it allows.
"""

import numpy as np

from wraparc.arrays import Array

_BLOCKS = (1, 5, 25)
_LEAST_BLOCKS = 20
# 1 - rho from 1 (white) to 0.01.
_MEMORIES = 1.0 - np.geomspace(1.0, 0.01, 28)


def noise_kernel(residual: Array, design: Array) -> Array | None:
    """Covariance of two readings by their distance, in units of the residuals' mean square.

    Parameters
    ----------
    residual
        Reading minus model, in the order they were taken, shape (n,).
    design
        Derivatives of the model by the fitted parameters, shape (n, k).

    Returns
    -------
    kernel
        At distances 0, 1, ..., shape (n,); None where the noise is white. Of means of 1, 5 and 25
        readings, so that a slow part under white noise is seen, the one with the largest sum.
    """
    count = len(residual)
    square = float(np.mean(residual**2))
    best, largest = None, 1.0
    for size in _BLOCKS:
        blocks = count // size
        if blocks < max(_LEAST_BLOCKS, 3 * design.shape[1]) or square <= 0.0:
            break
        used = blocks * size
        means = residual[:used].reshape(blocks, size).mean(1)
        if float(means[1:] @ means[:-1]) < 2.0 / np.sqrt(blocks) * float(means @ means):
            continue
        slopes = design[:used].reshape(blocks, size, -1).mean(1)
        weights, variances = _memories(means, slopes)
        distance = np.arange(count)[:, None] / size
        kernel = (_MEMORIES**distance) @ (weights * variances) / square
        kernel[0] = max(kernel[0], 1.0) if size > 1 else kernel[0]
        total = 2.0 * float(kernel.sum()) - kernel[0]
        if total > largest:
            best, largest = kernel, total
    return best


def _memories(residual: Array, design: Array) -> tuple[Array, Array]:
    """Weight of each memory by the restricted likelihood, and the variance that goes with it."""
    n, k = design.shape
    likelihood, variance = np.empty(len(_MEMORIES)), np.empty(len(_MEMORIES))
    scaled = design / np.maximum(np.sqrt((design**2).sum(0)), 1e-300)
    both = np.concatenate([scaled, residual[:, None]], axis=1)
    first, last = both[0], both[-1]
    here = both.T @ both
    across = both[1:].T @ both[:-1]
    for m, rho in enumerate(_MEMORIES):
        # Products of the whitened rows, from those of the rows themselves.
        products = here + rho**2 * (here - np.outer(last, last) - np.outer(first, first))
        products = products - rho * (across + across.T)
        normal = products[:k, :k] + 1e-12 * np.eye(k)
        side = products[:k, k]
        rest = max(float(products[k, k] - side @ np.linalg.solve(normal, side)), 1e-300)
        variance[m] = rest / (n - k) / (1.0 - rho**2)
        determinant = float(np.linalg.slogdet(normal)[1])
        likelihood[m] = -0.5 * ((n - k) * np.log(rest) + determinant - np.log(1.0 - rho**2))
    weights = np.exp(likelihood - likelihood.max())
    return weights / weights.sum(), variance


def apply(kernel: Array, columns: Array) -> Array:
    """Covariance matrix of stationary noise times columns, by FFT; shape of `columns`."""
    count = len(columns)
    size = 2 ** int(np.ceil(np.log2(2 * count)))
    whole = np.zeros(size)
    whole[:count] = kernel
    whole[-count + 1 :] = kernel[:0:-1]
    product = np.fft.rfft(columns, size, axis=0) * np.fft.rfft(whole)[:, None]
    return np.asarray(np.fft.irfft(product, size, axis=0)[:count])
