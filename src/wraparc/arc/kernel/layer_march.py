"""March through a layer of a long arc, from the point of least creep to a nip.

State: creep u and creep ratio w = du/ds. With the tension T_r at which w would be 0 (u'' depends on
no other place),

    du/ds = w,   dw/ds = C B tau(u, T),   T = T_r - w/C.

Why long arcs are solved so, see :mod:`wraparc.arc.kernel.layers`.
"""

from __future__ import annotations

from math import log, sqrt
from typing import NamedTuple

from wraparc.arc.kernel.butcher import (
    to_end,
    to_fifth,
    to_fourth,
    to_last,
    to_second,
    to_sixth,
    to_third,
)
from wraparc.arc.kernel.quantities import Buffer, Parameters
from wraparc.arc.kernel.table_slip import slip_under_table
from wraparc.friction.compact import (
    KNOTS,
    LIMIT,
    PIECES,
    PLASTIC,
    SMALLEST,
    TABLE,
    CompactLaw,
    branch_of,
    friction_at,
    peak,
    segment_of,
)

STEP_TOLERANCE = 1e-9  # relative error of a step
COARSE_TOLERANCE = 1e-6  # the same of a first search
KINK_TOLERANCE = 0.01  # times that for laws that hold and let go: what a kink leaves is no noise
MOST_STEPS = 800  # of a layer: some 100 are usual


# what a layer is marched to, in the order of aims (wraparc.arc.kernel.effort): a tension is met at
# a creep ratio
TO_RATIO, TO_CREEP, TO_SLIP = range(3)


class Arrival(NamedTuple):
    """A layer marched from the point of least creep to a nip."""

    arrived: bool
    length: float  # [m]
    creep: float  # [m]
    ratio: float  # w [-]


def friction_of_creep(
    law: CompactLaw, par: Parameters, tension: float, u: float
) -> tuple[float, float]:
    """Shear stress [Pa] and slip [m] at a creep and a tension."""
    if u == 0.0:
        return 0.0, 0.0
    p = par.entry_pressure * max(tension / par.entry_tension, 1e-9)
    mu, x = _slip_and_friction(law, par.shear * p, p, abs(u), 1.0)
    return (mu * p, x) if u > 0.0 else (-mu * p, -x)


def _slip_and_friction(
    law: CompactLaw, ease: float, pressure: float, creep: float, share: float
) -> tuple[float, float]:
    """Friction [-] and slip x [m] with x + ease mu(x) = creep (Newton, inside a bracket).

    `share` is a first guess of slip over creep.
    """
    segment = segment_of(law, pressure)
    if law.kind == TABLE:
        return slip_under_table(law, segment, ease, pressure, creep, share)
    if law.kind in (KNOTS, PIECES):
        slip_pk, mu_pk, _, _ = peak(law, segment, pressure)
        if segment >= len(law.edges) - 1 >= 0:
            mu_pk *= law.edges[len(law.edges) - 1] / pressure
        if creep <= slip_pk + ease * mu_pk:
            return _on_the_rise(slip_pk, mu_pk, ease, creep, share)
    if law.kind == LIMIT and ease > 0.0 and law.coefficients[3] == 0.0:
        # a law that starts with a jump holds the belt: the lagging alone gives way
        held, _, _ = friction_at(law, segment, PLASTIC, 0.0, pressure)
        if creep <= ease * held:
            return creep / ease, 0.0
    return _past_the_rise(law, segment, ease, pressure, creep, share * creep)


def _past_the_rise(
    law: CompactLaw, segment: int, ease: float, pressure: float, creep: float, x: float
) -> tuple[float, float]:
    """The same past a peak, and under a law with a limit; `x` is a first guess of the slip [m]."""
    low, high = 0.0, creep
    mu = 0.0
    for _ in range(60):
        branch = branch_of(law, segment, x, pressure)
        mu, mu_x, _ = friction_at(law, segment, branch, x, pressure)
        miss = x + ease * mu - creep
        if abs(miss) <= 1e-13 * creep or high - low <= 1e-14 * creep:
            break
        if miss > 0.0:
            high = x
        else:
            low = x
        slope = 1.0 + ease * mu_x
        x = x - miss / slope if slope > 0.0 else low
        if not low < x < high:
            x = 0.5 * (low + high)
    return mu, x


def _on_the_rise(
    slip_pk: float, mu_pk: float, ease: float, creep: float, share: float
) -> tuple[float, float]:
    """The same before the peak of an integral-log law: r (1 + k (1 - ln r)) = w."""
    k, w = ease * mu_pk / slip_pk, creep / slip_pk
    r = share * w
    if share == 1.0:  # nothing is known
        r = w / (1.0 + k * (1.0 - log(max(min(w, 1.0), SMALLEST))))
    r = max(min(r, 1.0), 1e-300)
    for _ in range(30):
        lr = log(r)
        change = (r * (1.0 + k * (1.0 - lr)) - w) / (1.0 - k * lr)
        r = min(max(r - change, 0.1 * r), 1.0)
        if abs(change) <= 1e-14 * r:
            break
    return mu_pk * r * (1.0 - log(r)), r * slip_pk


def _growth(
    law: CompactLaw, par: Parameters, rest: float, u: float, w: float, share: float
) -> tuple[float, float]:
    """dw/ds = C B tau [1/m], and slip over creep; `share` is a first guess of that."""
    if u == 0.0:
        return 0.0, share
    tension = rest - w / par.compliance
    p = par.entry_pressure * max(tension / par.entry_tension, 1e-9)
    mu, x = _slip_and_friction(law, par.shear * p, p, abs(u), share)
    growth = par.compliance * par.width * mu * p
    return (growth if u > 0.0 else -growth), x / abs(u)


def layer_step(
    law: CompactLaw, par: Parameters, rest: float, u: float, w: float, h: float
) -> tuple[float, float]:
    """One step of length h, which may be negative: creep and creep ratio at its end."""
    g1, x = _growth(law, par, rest, u, w, 1.0)
    a1, b1 = h * w, h * g1
    v = w + to_second(b1)
    g2, x = _growth(law, par, rest, u + to_second(a1), v, x)
    a2, b2 = h * v, h * g2
    v = w + to_third(b2)
    g3, x = _growth(law, par, rest, u + to_third(a2), v, x)
    a3, b3 = h * v, h * g3
    v = w + to_fourth(b1, b2, b3)
    g4, x = _growth(law, par, rest, u + to_fourth(a1, a2, a3), v, x)
    a4, b4 = h * v, h * g4
    v = w + to_fifth(b1, b2, b3, b4)
    g5, x = _growth(law, par, rest, u + to_fifth(a1, a2, a3, a4), v, x)
    a5, b5 = h * v, h * g5
    v = w + to_sixth(b2, b3, b4, b5)
    g6, x = _growth(law, par, rest, u + to_sixth(a2, a3, a4, a5), v, x)
    a6, b6 = h * v, h * g6
    v = w + to_last(b1, b2, b3, b4, b6)
    g7, x = _growth(law, par, rest, u + to_last(a1, a2, a3, a4, a6), v, x)
    a7, b7 = h * v, h * g7
    return u + to_end(a1, a3, a4, a5, a6, a7), w + to_end(b1, b3, b4, b5, b6, b7)


def march_layer(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    start: tuple[float, float],
    towards: float,
    to: int,
    goal: float,
    tolerance: float,
    path: Buffer,
) -> Arrival:
    """March from the point of least creep until a goal is reached.

    Parameters
    ----------
    rest
        T_r [N].
    start
        Creep [m] and creep ratio [-].
    towards
        +1 to the exit, -1 to the entry.
    to, goal
        TO_RATIO [-], TO_CREEP [m] or TO_SLIP [m], and its value, which lies ahead.
    tolerance
        Relative error of a step.
    path
        Takes s, u, w of every step [m, m, -], its first number how many; empty for none.
    """
    u, w = start
    s, h = 0.0, 0.02 * lag_at(law, par, rest, max(abs(u), abs(goal) if to != TO_RATIO else abs(u)))
    ahead = goal - value_at(law, par, rest, to, u, w)
    if law.kind == LIMIT:
        tolerance *= KINK_TOLERANCE
    _note(path, s, u, w)
    for _ in range(MOST_STEPS):
        u1, w1 = layer_step(law, par, rest, u, w, towards * h)
        um, wm = layer_step(law, par, rest, u, w, 0.5 * towards * h)
        u2, w2 = layer_step(law, par, rest, um, wm, 0.5 * towards * h)
        size_u, size_w = abs(u2) + abs(w2) * h, abs(w2) + abs(w2 - w)
        error = max(abs(u2 - u1) / max(size_u, 1e-300), abs(w2 - w1) / max(size_w, 1e-300))
        if not error <= 1.0:
            error = 1.0
        factor = 0.9 * (tolerance / max(error, 1e-16)) ** (1.0 / 7.0)
        if error > tolerance and h > 1e-12 * par.length:
            h *= max(min(factor, 0.7), 0.1)
            continue
        left = goal - value_at(law, par, rest, to, u2, w2)
        if left * ahead <= 0.0:
            part, u2, w2 = _landing(law, par, rest, (u, w), towards * h, to, goal)
            s += part * h
            _note(path, s, u2, w2)
            return Arrival(True, s, u2, w2)
        s, u, w = s + h, u2, w2
        _note(path, s, u, w)
        if s > 4.0 * par.length:
            break
        h *= min(max(factor, 0.3), 4.0)
    return Arrival(False, s, u, w)


def value_at(law: CompactLaw, par: Parameters, rest: float, to: int, u: float, w: float) -> float:
    """Of a state, what a goal is compared with."""
    if to == TO_RATIO:
        return w
    if to == TO_CREEP:
        return u
    return friction_of_creep(law, par, rest - w / par.compliance, u)[1]


def _note(path: Buffer, s: float, u: float, w: float) -> None:
    """Write one step of a path that has room."""
    if len(path) > 0:
        n = int(path[0])
        path[0], path[3 * n + 1], path[3 * n + 2], path[3 * n + 3] = n + 1.0, s, u, w


def _landing(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    start: tuple[float, float],
    h: float,
    to: int,
    goal: float,
) -> tuple[float, float, float]:
    """The part of a step after which the goal is met, and creep and creep ratio there."""
    low, high = 0.0, 1.0
    f_low = value_at(law, par, rest, to, start[0], start[1]) - goal
    u, w = layer_step(law, par, rest, start[0], start[1], h)
    f_high = value_at(law, par, rest, to, u, w) - goal
    size = max(abs(goal), 1e-300)
    part = 1.0
    for _ in range(60):
        if f_high == f_low:
            break
        part = (low * f_high - high * f_low) / (f_high - f_low)
        u, w = layer_step(law, par, rest, start[0], start[1], part * h)
        f = value_at(law, par, rest, to, u, w) - goal
        if abs(f) <= 1e-14 * size or high - low < 1e-15:
            break
        # false position keeps one end: halve its weight (Illinois)
        if f * f_high > 0.0:
            high, f_high, f_low = part, f, 0.5 * f_low
        else:
            low, f_low, f_high = part, f, 0.5 * f_high
    return part, u, w


def lag_at(law: CompactLaw, par: Parameters, tension: float, creep: float) -> float:
    """Shear-lag length sqrt(u / (tau B C)) of a creep [m]; the whole arc where nothing holds."""
    tau, _ = friction_of_creep(law, par, tension, creep)
    stiffness = tau * par.width * par.compliance
    if stiffness <= 0.0:
        return par.length
    return min(sqrt(creep / stiffness), par.length)
