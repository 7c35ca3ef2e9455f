"""Memory of a friction law under reversal: one material point of a lagging.

The integral-log law F(r) = r (1 - ln r) is the integral of min(r/xi, 1) over xi from 0 to 1: a set
of elastic-sliding elements in parallel whose break-away slips are spread evenly up to the peak.
Unloading therefore has no free parameter (Masing's rule): with f(z) = A F(z/x_pk),

    tau = s1 f(|x1|) + sum_j 2 s_j f(|x_j - x_(j-1)|/2) + 2 s f(|x - x_k|/2),

x_1..x_k the turning points of the slip, s the signs of the differences, A and x_pk at the present
pressure. Passing x_(k-1) forgets x_k and x_(k-1), passing -x_1 forgets all. Strength lost past the
peak stays lost: A is taken at the largest slip so far. A measured table is such a set as well if
it is concave; a law with a limit is one element (return mapping).

The functions are written for plain floats, so that one source runs interpreted and compiled.
"""

from __future__ import annotations

from collections.abc import MutableSequence
from itertools import pairwise
from math import log
from typing import NamedTuple

from wraparc.friction.base import FrictionLaw
from wraparc.friction.compact import (
    LIMIT,
    TABLE,
    CompactLaw,
    limit_at,
    peak,
    segment_of,
    table_at,
    tail,
)
from wraparc.friction.table import MeasuredTable

#: turning points that are kept, and the least reversal that makes one [m]
MOST_TURNS = 24
ROOM = MOST_TURNS + 2  # places that a point needs
LEAST_TURN = 1e-12
_SMALLEST = 1e-16  # slip over peak slip at which the logarithm is taken


class Backbone(NamedTuple):
    """First loading at one pressure: what :func:`loaded` needs.

    Attributes
    ----------
    segment
        Of the pressure, see :mod:`wraparc.friction.compact`.
    pressure
        Wrap pressure [Pa].
    strength, strength_p
        A [Pa] and its derivative by pressure [-].
    peak_slip, peak_slip_p
        x_pk [m] and its derivative by pressure [m/Pa].
    """

    segment: int
    pressure: float
    strength: float
    strength_p: float
    peak_slip: float
    peak_slip_p: float


class Point(NamedTuple):
    """A material point after a step, not yet taken for good.

    Attributes
    ----------
    slip, stress
        x [m], tau [Pa].
    by_creep, by_pressure
        Slopes of tau by creep [Pa/m] and by pressure [-].
    turns
        Turning points that are left.
    side
        Direction of the slip, +1 or -1; 0 without any.
    """

    slip: float
    stress: float
    by_creep: float
    by_pressure: float
    turns: int
    side: float


def has_memory(law: FrictionLaw) -> bool:
    """Whether the elements of a law exist: a measured table must rise from 0 and be concave."""
    if not isinstance(law, MeasuredTable):
        return True
    if any(row[0] != 0.0 for row in law.values):
        return False
    slips = [row * law.slip[-1] / 200.0 for row in range(201)]
    for pressure in law.pressure:
        values = [float(law.friction(x, pressure)) for x in slips]
        rises = [b - a for a, b in pairwise(values)]
        small = 1e-9 * max(values)
        if min(rises) < -small or any(b > a + small for a, b in pairwise(rises)):
            return False
    return True


def backbone_at(law: CompactLaw, pressure: float, reach: float, share: float = 1.0) -> Backbone:
    """First loading of a law, times a share, at a pressure [Pa] after a largest slip [m]."""
    b = dry_backbone(law, pressure, reach)
    if share == 1.0:
        return b
    return Backbone(
        b.segment, pressure, share * b.strength, share * b.strength_p, b.peak_slip, b.peak_slip_p
    )


def dry_backbone(law: CompactLaw, pressure: float, reach: float) -> Backbone:
    """First loading of a law as it is."""
    edges = law.edges
    last = len(edges) - 1
    segment = segment_of(law, pressure)
    if law.kind == LIMIT:
        mu, mu_p = limit_at(law, segment, pressure)
        return Backbone(segment, pressure, mu * pressure, mu + pressure * mu_p, 1.0, 0.0)
    if law.kind == TABLE:
        return Backbone(segment, pressure, 1.0, 0.0, 1.0, 0.0)
    x_pk, mu, x_p, mu_p = peak(law, segment, pressure)
    if reach > x_pk:
        slope, residual, slope_p, residual_p = tail(law, segment, pressure)
        line = mu + slope * (reach - x_pk)
        if line > min(residual, mu):
            mu_p = mu_p + slope_p * (reach - x_pk) - slope * x_p
            mu = line
        elif residual < mu:
            mu, mu_p = residual, residual_p
    if last >= 0 and segment >= last:  # above the tested pressures the traction is held
        return Backbone(segment, pressure, mu * edges[last], 0.0, x_pk, 0.0)
    if segment < 0:
        mu_p, x_p = 0.0, 0.0
    return Backbone(segment, pressure, mu * pressure, mu + pressure * mu_p, x_pk, x_p)


def loaded(law: CompactLaw, b: Backbone, z: float) -> tuple[float, float, float]:
    """Return f(z) [Pa] and its derivatives by slip z >= 0 [Pa/m] and pressure [-], to the peak."""
    if law.kind == TABLE:
        mu, mu_x, mu_p = table_at(law, b.segment, z, b.pressure)
        p = b.strength * b.pressure  # of a table the strength is a share of it
        return mu * p, mu_x * p, b.strength * (mu + b.pressure * mu_p)
    r = z / b.peak_slip
    if r >= 1.0:
        return b.strength, 0.0, b.strength_p
    if r < _SMALLEST:
        r = _SMALLEST
    lr = log(r)
    form = r - r * lr
    return (
        b.strength * form,
        -b.strength * lr / b.peak_slip,
        b.strength_p * form + b.strength * r * lr * b.peak_slip_p / b.peak_slip,
    )


def shared(law: CompactLaw, b: Backbone, c: float, w: float, guess: float) -> float:
    """Slip z [m] with z + c f(z) = w >= 0, c the compliance of the lagging in shear [m/Pa]."""
    if w <= 0.0:
        return 0.0
    if c == 0.0:
        return w
    if law.kind == TABLE:
        return shared_of_table(law, b, c, w, guess)
    top = b.peak_slip + c * b.strength
    if w >= top:
        return w - c * b.strength
    k = c * b.strength / b.peak_slip
    goal = w / b.peak_slip
    most = goal / (1.0 + k)  # 1 - ln r is at least 1
    r = min(guess / b.peak_slip, most)
    if r <= 0.0:
        r = most / (1.0 + k * (1.0 - log(max(most, _SMALLEST))))
    for _ in range(60):
        lr = log(r)
        step = (goal - r - k * (r - r * lr)) / (1.0 - k * lr)
        r = r + step if r + step > 0.0 else 0.05 * r
        if abs(step) <= 1e-5 * r:  # what is left is of the order of its square
            break
    return r * b.peak_slip


def shared_of_table(law: CompactLaw, b: Backbone, c: float, w: float, guess: float) -> float:
    """Slip z of :func:`shared` for a measured table [m]."""
    z = guess if 0.0 < guess < w else 0.5 * w
    for _ in range(60):
        value, slope, _ = loaded(law, b, z)
        step = (w - z - c * value) / (1.0 + c * slope)
        z = z + step if z + step > 0.0 else 0.05 * z
        if abs(step) <= 1e-9 * z:
            break
    return z


def virgin(
    law: CompactLaw, pressure: float, c: float, u: float, side: float, guess: float, share: float
) -> Point:
    """Return the state of a point that has slipped one way only, at a creep u of that side."""
    b = backbone_at(law, pressure, 0.0, share)
    w = side * u
    if w <= 0.0:
        return Point(0.0, 0.0, 0.0 if c == 0.0 else 1.0 / c, 0.0, 0, side)
    if law.kind != TABLE and w > b.peak_slip + c * b.strength:
        return past_peak(law, b, c, w, side, share)
    z = shared(law, b, c, w, guess)
    f, f_z, f_p = loaded(law, b, z)
    give = 1.0 + c * f_z
    return Point(side * z, side * f, f_z / give, side * f_p / give, 0, side)


def past_peak(law: CompactLaw, b: Backbone, c: float, w: float, side: float, share: float) -> Point:
    """Return the state of a point on the straight line past the peak or at the residual level."""
    slope, residual, _, _ = tail(law, b.segment, b.pressure)
    push = share * b.pressure
    last = len(law.edges) - 1
    if last >= 0 and b.segment >= last:  # above the tested pressures the traction is held
        push = share * law.edges[last]
    fall = slope * push
    z = (w - c * (b.strength - fall * b.peak_slip)) / (1.0 + c * fall)
    least = min(residual * push, b.strength)
    if b.strength + fall * (z - b.peak_slip) <= least:
        fall = 0.0
        z = w - c * least
    at = backbone_at(law, b.pressure, z, share)
    give = 1.0 + c * fall
    return Point(side * z, side * at.strength, fall / give, side * at.strength_p / give, 0, side)


def stuck_or_sliding(
    law: CompactLaw, pressure: float, c: float, u: float, slip: float, stress: float, share: float
) -> Point:
    """Return mapping of a law with a limit: one element, elastic until the limit is reached."""
    b = backbone_at(law, pressure, 0.0, share)
    give = c + law.onset_compliance
    trial = stress + (u - slip - c * stress) / give
    if abs(trial) <= b.strength:
        return Point(u - c * trial, trial, 1.0 / give, 0.0, 0, 0.0)
    side = 1.0 if trial > 0.0 else -1.0
    return Point(u - c * side * b.strength, side * b.strength, 0.0, side * b.strength_p, 0, 0.0)


def moved(
    law: CompactLaw,
    c: float,
    u: float,
    pressure: float,
    turns: MutableSequence[float],
    at: int,
    count: int,
    side: float,
    slip: float,
    stress: float,
    reach: float,
    share: float,
    near: float,
) -> Point:
    """State of a material point after its creep and pressure have changed.

    Parameters
    ----------
    law
        The law.
    c
        Compliance of the lagging in shear, h/G [m/Pa].
    u, pressure
        The new creep [m] and wrap pressure [Pa].
    turns, at, count
        Turning points of the slip [m] from place `at` on, and how many of them hold; the place
        after the last one is written to where the slip has just turned.
    side, slip, stress
        Direction, slip [m] and shear stress [Pa] before.
    reach
        Largest slip so far [m].
    share
        Part of the friction that is there: less than 1 on a wet patch [-].
    near
        A guess of the new slip [m]: the closer, the faster.

    Returns
    -------
    The new state; nothing else is changed, so that a solver can try.
    """
    if law.kind == LIMIT:
        return stuck_or_sliding(law, pressure, c, u, slip, stress, share)
    if side == 0.0:
        side = 1.0 if u >= 0.0 else -1.0
        count = 0
    if count == 0:
        point = virgin(law, pressure, c, u, side, abs(near), share)
        if side * (point.slip - slip) >= -LEAST_TURN and side * u >= 0.0:
            return point
        if abs(slip) < LEAST_TURN:
            return virgin(law, pressure, c, u, -side, 0.0, share)
        turns[at] = slip
        count, side = 1, -side
        turned = True
    else:
        turned = False
    b = backbone_at(law, pressure, reach, share)
    while count > 0:
        base, base_p = carried(law, b, turns, at, count)
        top = turns[at + count - 1]
        w = 0.5 * side * (u - top - c * base)
        guess = 0.5 * side * (near - top)
        z = shared(law, b, c, w, guess)
        x = top + 2.0 * side * z
        if not turned and (w < 0.0 or side * (x - slip) < -LEAST_TURN):
            turned = True
            if abs(slip - top) > LEAST_TURN:
                turns[at + count] = slip
                count += 1
                side = -side
                continue
            # back to a turning point just made: it turns no more
            count -= 1
            side = -side
            continue
        other = -top if count == 1 else turns[at + count - 2]
        if z > 0.5 * abs(top - other):
            count = 0 if count == 1 else count - 2
            turned = True
            continue
        f, f_z, f_p = loaded(law, b, z)
        give = 1.0 + c * f_z
        tau = base + 2.0 * side * f
        return Point(x, tau, f_z / give, (base_p + 2.0 * side * f_p) / give, count, side)
    return virgin(law, pressure, c, u, side, abs(near), share)


def carried(
    law: CompactLaw, b: Backbone, turns: MutableSequence[float], at: int, count: int
) -> tuple[float, float]:
    """Shear stress at the last turning point [Pa], and its derivative by pressure [-]."""
    value, value_p = 0.0, 0.0
    before = 0.0
    for j in range(count):
        d = turns[at + j] - before
        side = 1.0 if d >= 0.0 else -1.0
        if j == 0:
            f, _, f_p = loaded(law, b, abs(d))
            value, value_p = side * f, side * f_p
        else:
            f, _, f_p = loaded(law, b, 0.5 * abs(d))
            value += 2.0 * side * f
            value_p += 2.0 * side * f_p
        before = turns[at + j]
    return value, value_p


def shortened(turns: MutableSequence[float], at: int, count: int) -> int:
    """Forget the smallest loop if there is no room for another turning point; what is left."""
    if count < MOST_TURNS:
        return count
    smallest = 1
    for j in range(1, count):
        if abs(turns[at + j] - turns[at + j - 1]) < abs(
            turns[at + smallest] - turns[at + smallest - 1]
        ):
            smallest = j
    for j in range(smallest + 1, count):
        turns[at + j - 2] = turns[at + j]
    return count - 2
