"""One root of a function of one variable, kept in a bracket."""

from __future__ import annotations

from collections.abc import Callable

_MOST, _REACH = 80, 0.01  # steps; first of them that the slope does not tell, of the limits


def rising_root(
    f: Callable[[float], float],
    x: float,
    reach: float,
    low: float,
    high: float,
    tolerance: float,
) -> tuple[float, float]:
    """Return x with |f(x)| <= tolerance, and f(x), of a function that rises through its root.

    Steps away from the first guess, twice as far each time, until the root is between two of
    them; then false position (Illinois), with a halving wherever two steps have not halved the
    bracket.

    Parameters
    ----------
    f
        The function.
    x, reach
        First guess and first step.
    low, high
        Limits of x. Where f does not change its sign between them, the limit is returned.
    tolerance
        Of f.

    Notes
    -----
    Where the bracket shrinks to two neighbouring numbers before the tolerance is met, the better
    one is returned.
    """
    x = min(max(x, low), high)
    value = f(x)
    if abs(value) <= tolerance:
        return x, value
    direction = 1.0 if value < 0.0 else -1.0
    end = high if direction > 0.0 else low
    a, fa = x, value
    while True:
        if a == end:
            return a, fa
        b = min(a + reach, end) if direction > 0.0 else max(a - reach, end)
        fb = f(b)
        if abs(fb) <= tolerance:
            return b, fb
        if fa * fb < 0.0:
            return bracketed_root(f, a, fa, b, fb, tolerance)
        a, fa, reach = b, fb, 2.0 * reach


def bracketed_root(
    f: Callable[[float], float],
    a: float,
    fa: float,
    b: float,
    fb: float,
    tolerance: float,
) -> tuple[float, float]:
    """Return a root between a and b, where f has different signs; see `rising_root`."""
    width, kept = abs(b - a), 0
    for i in range(200):
        x = (a * fb - b * fa) / (fb - fa)
        if i % 3 == 2:
            if abs(b - a) > 0.5 * width:
                x = 0.5 * (a + b)
            width = abs(b - a)
        if not min(a, b) < x < max(a, b):
            x = 0.5 * (a + b)
        if x in (a, b):
            break
        value = f(x)
        if abs(value) <= tolerance:
            return x, value
        if (value < 0.0) == (fa < 0.0):
            a, fa = x, value
            fb *= 0.5 if kept == 1 else 1.0
            kept = 1
        else:
            b, fb = x, value
            fa *= 0.5 if kept == -1 else 1.0
            kept = -1
    at_a, at_b = f(a), f(b)
    return (a, at_a) if abs(at_a) <= abs(at_b) else (b, at_b)


def sloped_root(
    f: Callable[[float], tuple[float, float]], x: float, low: float, high: float, tolerance: float
) -> tuple[float, float]:
    """Return x with |f(x)| <= tolerance, and f(x), of a rising function that tells its slope.

    Newton's method, and halving where it leaves the bracket or is slow. Where f does not change
    its sign between the limits, the limit is returned.

    Parameters
    ----------
    f
        Value and slope.
    x
        First guess.
    low, high
        Limits of x.
    tolerance
        Of f.
    """
    x, before, reach = min(max(x, low), high), 0.0, _REACH * (high - low)
    below = above = False  # whether the limits are known to enclose the root
    value = 0.0
    for _ in range(_MOST):
        value, slope = f(x)
        if abs(value) <= tolerance or (x == high and value < 0.0) or (x == low and value > 0.0):
            break
        if value < 0.0:
            low, below = x, True
        else:
            high, above = x, True
        slow = abs(value) > 0.5 * abs(before) > 0.0
        way = 1.0 if value < 0.0 else -1.0
        new = x - value / slope if slope > 0.0 else x + way * reach
        if below and above and (slow or not low < new < high):
            new = 0.5 * (low + high)
        elif slow and not (below and above):  # the slope knows nothing of where the root is
            new = x + way * max(reach, abs(new - x))
            reach *= 2.0
        before = value
        new = min(max(new, low), high)
        if new == x:
            break
        x = new
    return x, value
