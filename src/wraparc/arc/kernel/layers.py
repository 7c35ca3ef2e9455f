"""Long arcs: the belt hands over its tension in layers at the nips and rests in between.

Where the arc is many shear-lag lengths long, what happens at the exit grows like e^(L/l) out of
what goes in at the entry: no number at the entry tells the one exit tension from the other. In
between there is a point where the creep is least, or passes through zero. Seen from there both
layers grow, towards the entry and towards the exit, and a march is well behaved in both directions.

State: creep u and creep ratio w = du/ds. With the tension T_r at which w would be 0 (u'' depends on
no other place),

    du/ds = w,   dw/ds = C B tau(u, T),   T = T_r - w/C.

The unknown lambda says how near to rest the belt comes: the least creep, or the creep ratio where
creep is 0, are floors times e^lambda. Where the layers of the floor do not fill the arc, the belt
rests in what is left.
"""

from __future__ import annotations

from math import exp, inf, log, nan, sqrt
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
from wraparc.arc.kernel.quantities import (
    BREAKAWAY,
    RECORD,
    SOLVED,
    UNSOLVED,
    Buffer,
    Parameters,
    Shot,
    zeros,
)
from wraparc.friction.compact import (
    KNOTS,
    LIMIT,
    PIECES,
    PLASTIC,
    SMALLEST,
    CompactLaw,
    branch_of,
    friction_at,
    peak,
    segment_of,
)

FLOOR = 1e-9  # of creep near rest in the creep of the layers: what it changes is its square
STEP_TOLERANCE = 1e-9  # relative error of a step
MOST_STEPS = 800  # of a layer: some 100 are usual
LARGEST_RATIO = 1.0  # of creep at the entry
NODES = 400  # of a layer that a profile records at most


class Arrival(NamedTuple):
    """A layer marched from the point of least creep to a nip."""

    arrived: bool
    length: float  # [m]
    creep: float  # [m]
    ratio: float  # w [-]


class Layers(NamedTuple):
    """An arc of two layers."""

    solved: bool
    rest_tension: float  # T_r [N]
    creep: float  # where the layers part [m]
    ratio: float  # w there [-]
    entry_length: float  # of the layer at the entry [m]
    length: float  # of both layers [m]
    exit_creep: float  # [m]
    exit_ratio: float  # [-]


NO_LAYERS = Layers(False, nan, nan, nan, nan, nan, nan, nan)


def friction_of_creep(
    law: CompactLaw, par: Parameters, tension: float, u: float
) -> tuple[float, float]:
    """Shear stress [Pa] and slip [m] at a creep and a tension."""
    if u == 0.0:
        return 0.0, 0.0
    p = par.entry_pressure * max(tension / par.entry_tension, 1e-9)
    mu, x = _slip_and_friction(law, par.shear * p, p, abs(u))
    return (mu * p, x) if u > 0.0 else (-mu * p, -x)


def _slip_and_friction(
    law: CompactLaw, ease: float, pressure: float, creep: float
) -> tuple[float, float]:
    """Friction [-] and slip x [m] with x + ease mu(x) = creep (Newton, inside a bracket)."""
    segment = segment_of(law, pressure)
    x = creep
    if law.kind in (KNOTS, PIECES):
        slip_pk, mu_pk, _, _ = peak(law, segment, pressure)
        if segment >= len(law.edges) - 1 >= 0:
            mu_pk *= law.edges[len(law.edges) - 1] / pressure
        if creep <= slip_pk + ease * mu_pk:
            return _on_the_rise(slip_pk, mu_pk, ease, creep)
    if ease > 0.0:
        # a law that starts with a jump holds the belt: the lagging alone gives way
        held, _, _ = friction_at(law, segment, PLASTIC if law.kind == LIMIT else 0, 0.0, pressure)
        if (law.kind != LIMIT or law.coefficients[3] == 0.0) and creep <= ease * held:
            return creep / ease, 0.0
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


def _on_the_rise(slip_pk: float, mu_pk: float, ease: float, creep: float) -> tuple[float, float]:
    """The same before the peak of an integral-log law: r (1 + k (1 - ln r)) = w."""
    k, w = ease * mu_pk / slip_pk, creep / slip_pk
    r = max(min(w / (1.0 + k * (1.0 - log(max(min(w, 1.0), SMALLEST)))), 1.0), 1e-300)
    for _ in range(30):
        lr = log(r)
        change = (r * (1.0 + k * (1.0 - lr)) - w) / (1.0 - k * lr)
        r = min(max(r - change, 0.1 * r), 1.0)
        if abs(change) <= 1e-14 * r:
            break
    return mu_pk * r * (1.0 - log(r)), r * slip_pk


def _growth(law: CompactLaw, par: Parameters, rest: float, u: float, w: float) -> float:
    """dw/ds = C B tau [1/m]."""
    tau, _ = friction_of_creep(law, par, rest - w / par.compliance, u)
    return par.compliance * par.width * tau


def _step(
    law: CompactLaw, par: Parameters, rest: float, u: float, w: float, h: float
) -> tuple[float, float]:
    """One step of length h, which may be negative: creep and creep ratio at its end."""
    a1, b1 = h * w, h * _growth(law, par, rest, u, w)
    v = w + to_second(b1)
    a2, b2 = h * v, h * _growth(law, par, rest, u + to_second(a1), v)
    v = w + to_third(b2)
    a3, b3 = h * v, h * _growth(law, par, rest, u + to_third(a2), v)
    v = w + to_fourth(b1, b2, b3)
    a4, b4 = h * v, h * _growth(law, par, rest, u + to_fourth(a1, a2, a3), v)
    v = w + to_fifth(b1, b2, b3, b4)
    a5, b5 = h * v, h * _growth(law, par, rest, u + to_fifth(a1, a2, a3, a4), v)
    v = w + to_sixth(b2, b3, b4, b5)
    a6, b6 = h * v, h * _growth(law, par, rest, u + to_sixth(a2, a3, a4, a5), v)
    v = w + to_last(b1, b2, b3, b4, b6)
    a7, b7 = h * v, h * _growth(law, par, rest, u + to_last(a1, a2, a3, a4, a6), v)
    return u + to_end(a1, a3, a4, a5, a6, a7), w + to_end(b1, b3, b4, b5, b6, b7)


def march_layer(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    start: tuple[float, float],
    towards: float,
    to_creep: bool,
    goal: float,
    path: Buffer,
) -> Arrival:
    """March from the point of least creep until the creep, or the creep ratio, reaches a goal.

    Parameters
    ----------
    rest
        T_r [N].
    start
        Creep [m] and creep ratio [-].
    towards
        +1 to the exit, -1 to the entry.
    to_creep, goal
        Whether the goal is a creep [m] or a creep ratio [-]; it lies ahead.
    path
        Takes s, u, w of every step [m, m, -], its first number how many; empty for none.
    """
    u, w = start
    s, h = 0.0, 0.02 * lag_at(law, par, rest, max(abs(u), abs(goal) if to_creep else abs(u)))
    ahead = goal - (u if to_creep else w)
    for _ in range(MOST_STEPS):
        if len(path) > 0:
            n = int(path[0])
            path[0], path[3 * n + 1], path[3 * n + 2], path[3 * n + 3] = n + 1.0, s, u, w
        u1, w1 = _step(law, par, rest, u, w, towards * h)
        um, wm = _step(law, par, rest, u, w, 0.5 * towards * h)
        u2, w2 = _step(law, par, rest, um, wm, 0.5 * towards * h)
        size_u, size_w = abs(u2) + abs(w2) * h, abs(w2) + abs(w2 - w)
        error = max(abs(u2 - u1) / max(size_u, 1e-300), abs(w2 - w1) / max(size_w, 1e-300))
        if not error <= 1.0:
            error = 1.0
        factor = 0.9 * (STEP_TOLERANCE / max(error, 1e-16)) ** (1.0 / 7.0)
        if error > STEP_TOLERANCE and h > 1e-12 * par.length:
            h *= max(min(factor, 0.7), 0.1)
            continue
        left = goal - (u2 if to_creep else w2)
        if left * ahead <= 0.0:
            part, u2, w2 = _landing(law, par, rest, (u, w), towards * h, to_creep, goal)
            s += part * h
            if len(path) > 0:
                n = int(path[0])
                path[0], path[3 * n + 1], path[3 * n + 2], path[3 * n + 3] = n + 1.0, s, u2, w2
            return Arrival(True, s, u2, w2)
        s, u, w = s + h, u2, w2
        if s > 4.0 * par.length:
            break
        h *= min(max(factor, 0.3), 4.0)
    return Arrival(False, s, u, w)


def _landing(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    start: tuple[float, float],
    h: float,
    to_creep: bool,
    goal: float,
) -> tuple[float, float, float]:
    """The part of a step after which the goal is met, and creep and creep ratio there."""
    low, high = 0.0, 1.0
    f_low = (start[0] if to_creep else start[1]) - goal
    u, w = _step(law, par, rest, start[0], start[1], h)
    f_high = (u if to_creep else w) - goal
    size = max(abs(goal), 1e-300)
    part = 1.0
    for _ in range(60):
        if f_high == f_low:
            break
        part = (low * f_high - high * f_low) / (f_high - f_low)
        u, w = _step(law, par, rest, start[0], start[1], part * h)
        f = (u if to_creep else w) - goal
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


def _layers_of(
    law: CompactLaw,
    par: Parameters,
    exit_tension: float,
    crossing: bool,
    floors: tuple[float, float],
    z: float,
    rest: float,
) -> Layers:
    """Both layers at one lambda, `z`; `rest` is a first guess of T_r."""
    c, kick = par.compliance, par.kick
    creep, ratio, length = 0.0, par.side * floors[1] * exp(z), 0.0
    free = kick == 0.0  # the belt enters at rest or nearly so: there is no layer at the entry
    if kick > 0.0 and not crossing:
        creep, ratio = floors[0] * exp(z), 0.0
        if creep >= kick:  # creep grows from the entry on
            creep, ratio, free = kick, floors[1] * (exp(z) - kick / floors[0]), True
    elif kick > 0.0:
        ratio = -floors[1] * exp(z)
    if free:
        rest = par.entry_tension + ratio / c
    else:
        if crossing:
            rest += min(ratio / c - (rest - par.entry_tension), 0.0)
        inward = _entry_layer(law, par, rest, (creep, ratio))
        rest, length = inward.rest_tension, inward.entry_length
        if not inward.solved:
            return inward
    goal = c * (rest - exit_tension)
    if (goal - ratio) * (1.0 if creep > 0.0 or ratio > 0.0 else -1.0) <= 0.0:
        # the tension is met before the layer has begun: what is left is of the size of the floor
        near = z == 0.0
        return Layers(near, rest, creep, ratio, length, length if near else 0.0, creep, ratio)
    out = march_layer(law, par, rest, (creep, ratio), 1.0, False, goal, zeros(0))
    both = length + out.length if out.arrived else inf
    return Layers(out.arrived, rest, creep, ratio, length, both, out.creep, out.ratio)


def _entry_layer(
    law: CompactLaw, par: Parameters, rest: float, part: tuple[float, float]
) -> Layers:
    """T_r and length of the layer at the entry: from where the layers part to kick and T1.

    T_r is no tension of the belt where creep passes through zero fast: it may be negative.
    """
    c, miss, rest_last, miss_last = par.compliance, inf, 0.0, 0.0
    length = 0.0
    for i in range(40):
        there = march_layer(law, par, rest, part, -1.0, True, par.kick, zeros(0))
        if not there.arrived:
            break
        miss, length = rest - there.ratio / c - par.entry_tension, there.length
        if abs(miss) <= 1e-12 * par.entry_tension:
            break
        new = rest - miss
        if i > 0 and miss != miss_last:
            new = rest - miss * (rest - rest_last) / (miss - miss_last)
        rest_last, miss_last, rest = rest, miss, new
    good = abs(miss) <= 1e-10 * par.entry_tension
    return Layers(good, rest, part[0], part[1], length, length if good else inf, 0.0, 0.0)


def solve_layers(law: CompactLaw, par: Parameters, exit_tension: float) -> tuple[int, Layers]:
    """Layers that meet both tensions of an arc, for laws without a jump.

    Returns
    -------
    outcome, layers
        SOLVED; BREAKAWAY: with no creep up to a ratio of 1 at the entry the tensions are met within
        the arc; UNSOLVED.
    """
    first, rest, crossing, floors = _at_rest(law, par, exit_tension)
    if first.solved and first.length <= par.length:
        return SOLVED, first
    # less rest: lambda grows until the layers just fill the arc
    low, high, f_low, f_high = 0.0, 0.0, first.length / par.length - 1.0, inf
    best, top = first, log(LARGEST_RATIO / floors[1])
    reach = 2.0
    for _ in range(60):
        if high >= top:
            return BREAKAWAY, best
        high = min(high + reach, top)
        best = _layers_of(law, par, exit_tension, crossing, floors, high, rest)
        f_high = best.length / par.length - 1.0
        if f_high <= 0.0:
            break
        # the length falls by about a shear-lag length a unit of lambda
        fall = (f_low - f_high) / (high - low)
        reach = min(max(1.1 * f_high / fall, 0.5), 12.0) if 0.0 < fall < inf else 2.0
        low, f_low, rest = high, f_high, best.rest_tension
    side = 0
    for i in range(100):
        z = 0.5 * (low + high)
        if f_low < inf and i % 8 < 7:
            z = (low * f_high - high * f_low) / (f_high - f_low)
        if not low < z < high:
            z = 0.5 * (low + high)
        best = _layers_of(law, par, exit_tension, crossing, floors, z, best.rest_tension)
        f = best.length / par.length - 1.0
        if abs(f) < 1e-11 or z in (low, high):
            break
        # false position keeps one end: halve its weight when it does (Illinois)
        if f > 0.0:
            f_high *= 0.5 if side > 0 else 1.0
            low, f_low, side = z, f, 1
        else:
            f_low *= 0.5 if side < 0 else 1.0
            high, f_high, side = z, f, -1
    good = best.solved and abs(best.length / par.length - 1.0) < 1e-8
    return (SOLVED if good else UNSOLVED), best


def _at_rest(
    law: CompactLaw, par: Parameters, exit_tension: float
) -> tuple[Layers, float, bool, tuple[float, float]]:
    """Layers at the floor, T_r there, whether creep passes through zero, and the floors."""
    pull = par.compliance * abs(par.entry_tension - exit_tension)
    creep = max(par.kick, 1e-6)
    for _ in range(8):  # the creep that this pull makes, by w = u/l
        creep = max(par.kick, pull * lag_at(law, par, par.entry_tension, creep), 1e-200)
    floor = FLOOR * creep
    floors = (floor, floor / lag_at(law, par, par.entry_tension, floor))
    first = _layers_of(law, par, exit_tension, False, floors, 0.0, par.entry_tension)
    rest = first.rest_tension
    crossing = par.kick > 0.0 and rest < exit_tension
    if crossing:
        first = _layers_of(law, par, exit_tension, True, floors, 0.0, rest)
        rest = first.rest_tension
    return first, rest, crossing, floors


def shot_of_layers(law: CompactLaw, par: Parameters, found: Layers) -> Shot:
    """Exit quantities of solved layers; friction's work is what the exact loss leaves to it."""
    c = par.compliance
    tension = found.rest_tension - found.exit_ratio / c
    tau, x = friction_of_creep(law, par, tension, found.exit_creep)
    entry_tau, _ = friction_of_creep(law, par, par.entry_tension, par.kick)
    g = c * (found.rest_tension - par.entry_tension)
    work = 0.5 * (found.exit_ratio**2 - g * g) / (c * par.width)
    work -= 0.5 * par.shear * (tau * tau - entry_tau * entry_tau)
    return Shot(log(tension / par.entry_tension), x, found.exit_creep, tau, work, g, 0.0)


def trace_layers(
    law: CompactLaw, par: Parameters, found: Layers, points: int, out: Buffer
) -> tuple[Shot, int]:
    """Profile of solved layers: exit quantities and the number of records."""
    path = zeros(3 * MOST_STEPS + 10)
    count, part = 0, (found.creep, found.ratio)
    g = par.compliance * (found.rest_tension - par.entry_tension)
    begin = min(found.entry_length, par.length)
    out_length = max(found.length - found.entry_length, 0.0)
    if begin > 0.0:
        march_layer(law, par, found.rest_tension, part, -1.0, True, par.kick, path)
        count = _record_path(law, par, found.rest_tension, g, path, begin, -1.0, points, out, 0)
    elif par.kick == 0.0:
        _record(law, par, found.rest_tension, g, 0.0, 0.0, found.ratio, out, 0)
        count = 1
    # the rest in between
    end = max(par.length - out_length, begin)
    j = int(begin / par.length * points * (1.0 + 1e-12)) + 1
    while j < points and j * par.length / points < end:
        _record(law, par, found.rest_tension, g, j * par.length / points, 0.0, 0.0, out, count)
        count += 1
        j += 1
    path[0] = 0.0
    if out_length > 0.0:
        march_layer(law, par, found.rest_tension, part, 1.0, False, found.exit_ratio, path)
    else:
        path[0], path[1], path[2], path[3] = 1.0, 0.0, found.exit_creep, found.exit_ratio
    count = _record_path(law, par, found.rest_tension, g, path, end, 1.0, points, out, count)
    out[RECORD * (count - 1)] = par.length
    return shot_of_layers(law, par, found), count


def _record_path(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    g: float,
    path: Buffer,
    origin: float,
    towards: float,
    points: int,
    out: Buffer,
    count: int,
) -> int:
    """Record a layer in order of position, with the points of the equal division inside it."""
    n = int(path[0])
    skip = 1 + n // NODES
    for k in range(n):
        i = k if towards > 0.0 else n - 1 - k
        s, u, w = path[3 * i + 1], path[3 * i + 2], path[3 * i + 3]
        here = origin + towards * s
        if k > 0:
            # points between the node before and this one, from the nearer to where they part
            m = i - 1 if towards > 0.0 else i
            from_s = path[3 * m + 1]
            start = (path[3 * m + 2], path[3 * m + 3])
            before = origin + towards * path[3 * (i - 1 if towards > 0.0 else i + 1) + 1]
            j = int(before / par.length * points * (1.0 + 1e-12)) + 1
            while j < points and j * par.length / points < here * (1.0 - 1e-12):
                at = j * par.length / points
                h = towards * (towards * (at - origin) - from_s)
                v, y = _step(law, par, rest, start[0], start[1], h)
                _record(law, par, rest, g, at, v, y, out, count)
                count += 1
                j += 1
        if k in (0, n - 1) or k % skip == 0:
            _record(law, par, rest, g, max(here, 0.0), u, w, out, count)
            count += 1
    return count


def _record(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    g: float,
    s: float,
    u: float,
    w: float,
    out: Buffer,
    count: int,
) -> None:
    """Write one point of a profile, see wraparc.arc.kernel.march.record."""
    tension = rest - w / par.compliance
    tau, x = friction_of_creep(law, par, tension, u)
    entry_tau, _ = friction_of_creep(law, par, par.entry_tension, par.kick)
    work = 0.5 * (w * w - g * g) / (par.compliance * par.width)
    work -= 0.5 * par.shear * (tau * tau - entry_tau * entry_tau)
    i = RECORD * count
    out[i], out[i + 1], out[i + 2] = s, log(tension / par.entry_tension), x
    out[i + 3], out[i + 4], out[i + 5], out[i + 6] = u, tau, work, 0.0
