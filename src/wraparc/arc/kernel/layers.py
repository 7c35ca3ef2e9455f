"""Long arcs: the belt hands over its tension in layers at the nips and rests in between.

Where the arc is many shear-lag lengths long, what happens at the exit grows like e^(L/l) out of
what goes in at the entry: no number at the entry tells the one exit tension from the other. In
between there is a point where the creep is least, or passes through zero. Seen from there both
layers grow, towards the entry and towards the exit, and a march is well behaved in both directions
(:mod:`wraparc.arc.kernel.layer_march`).

The unknown lambda says how near to rest the belt comes: the least creep, or the creep ratio where
creep is 0, are floors times e^lambda. Where the layers of the floor do not fill the arc, the belt
rests in what is left.
"""

from __future__ import annotations

from math import exp, inf, log, nan
from typing import NamedTuple

from wraparc.arc.kernel.effort import TENSION, Aim
from wraparc.arc.kernel.layer_march import (
    TO_CREEP,
    Arrival,
    friction_of_creep,
    lag_at,
    march_layer,
    value_at,
)
from wraparc.arc.kernel.quantities import BREAKAWAY, SOLVED, UNSOLVED, Parameters, Shot, zeros
from wraparc.friction.compact import CompactLaw

FLOOR = 1e-9  # of creep near rest in the creep of the layers: what it changes is its square
NOISE = 100.0  # miss of a held tension, in `Case.close`, that steps leave
FILLED = 3.0  # relative miss of the arc's length, in tolerances of a step: what steps leave
HALVINGS = 4  # of lambda, between layers that come to no end and such that fill too little
MARGIN = 4.0  # times what these grew by with the last of them
NEARBY = 8  # secants from the layers of nearly the same arc
LEAST_TENSION = 1e-6  # of T1, where layers part
LARGEST_RATIO = 1.0  # of creep at the entry


class Layers(NamedTuple):
    """An arc of two layers."""

    solved: bool
    z: float  # lambda [-]
    entry_tension: float  # T1 [N]
    rest_tension: float  # T_r [N]
    creep: float  # where the layers part [m]
    ratio: float  # w there [-]
    entry_length: float  # of the layer at the entry [m]
    length: float  # of both layers [m]
    exit_creep: float  # [m]
    exit_ratio: float  # [-]


NO_LAYERS = Layers(False, nan, nan, nan, nan, nan, nan, nan, nan, nan)


class Case(NamedTuple):
    """What the layers of an arc meet."""

    aim: Aim
    exit_tension: float  # T2 held instead of T1 [N], of aims of creep or slip; nan: T1 is held
    crossing: bool  # whether creep passes through zero
    floors: tuple[float, float]  # of the least creep [m], and of the creep ratio where creep is 0
    close: float  # how near the held tension is met [N]
    tolerance: float  # relative error of a step


def _layers_of(law: CompactLaw, par: Parameters, case: Case, z: float, rest: float) -> Layers:
    """Both layers at one lambda, `z`; `rest` is a first guess of T_r."""
    creep, ratio, free = _parting(par, case, z)
    held_exit = case.exit_tension == case.exit_tension
    length, entry = 0.0, par.entry_tension
    if not held_exit:
        if free:
            rest = entry + ratio / par.compliance
        else:
            if case.crossing:
                way = 1.0 if par.kick > 0.0 else -1.0
                rest += way * min(way * (ratio / par.compliance - (rest - entry)), 0.0)
            _, met, rest, there = _layer(law, par, case, rest, (creep, ratio), -1.0)
            if not met:
                return Layers(False, z, entry, rest, creep, ratio, there.length, inf, 0.0, 0.0)
            length = there.length
    begun, met, rest, out = _layer(law, par, case, rest, (creep, ratio), 1.0)
    if not begun:
        # the aim is met before the layer has begun: what is left is of the size of the floor
        near = z == 0.0
        both = length if near else 0.0
        return Layers(near, z, entry, rest, creep, ratio, both, both, creep, ratio)
    met = met and out.ratio < par.compliance * rest  # no creep is met where no tension is left
    if held_exit:
        entry = rest - ratio / par.compliance
        if met and not free:
            there = march_layer(
                law, par, rest, (creep, ratio), -1.0, TO_CREEP, par.kick, case.tolerance, zeros(0)
            )
            met, length = there.arrived, there.length
            entry = rest - there.ratio / par.compliance
        met = met and entry > 0.0
    both = length + out.length if met else inf
    return Layers(met, z, entry, rest, creep, ratio, length, both, out.creep, out.ratio)


def _parting(par: Parameters, case: Case, z: float) -> tuple[float, float, bool]:
    """Creep and creep ratio where the layers part, and whether there is none at the entry."""
    kick, floors = par.kick, case.floors
    way = 1.0 if kick > 0.0 else -1.0
    if kick == 0.0:  # the belt enters at rest or nearly so
        return 0.0, par.side * floors[1] * exp(z), True
    if case.crossing:
        return 0.0, -way * floors[1] * exp(z), False
    creep = way * floors[0] * exp(z)
    if abs(creep) < abs(kick):
        return creep, 0.0, False
    spare = exp(z) - abs(kick) / floors[0]
    return kick, way * floors[1] * spare, True  # creep grows from the entry on


def _layer(
    law: CompactLaw,
    par: Parameters,
    case: Case,
    rest: float,
    part: tuple[float, float],
    towards: float,
) -> tuple[bool, bool, float, Arrival]:
    """A layer from where the layers part to its nip, and the T_r at which a held tension is met.

    T_r is no tension of the belt where creep passes through zero fast: it may be negative.

    Returns
    -------
    begun, met, T_r, arrival
        Whether its end lies ahead, and whether it is reached with the held tension.
    """
    c, aim = par.compliance, case.aim
    held = par.entry_tension if towards < 0.0 else case.exit_tension
    free = towards > 0.0 and held != held
    miss, rest_last, miss_last = 0.0, 0.0, 0.0
    least, tried = part[1] / c + LEAST_TENSION * par.entry_tension, inf
    there = Arrival(False, 0.0, part[0], part[1])
    for i in range(40):
        to, goal = TO_CREEP, par.kick
        if towards > 0.0:
            to, goal = aim.of, par.side * aim.value
            if to == TENSION:
                goal = c * (rest - par.entry_tension * exp(-goal))
            ahead = goal - value_at(law, par, rest, to, part[0], part[1])
            if ahead * (1.0 if part[0] > 0.0 or part[1] > 0.0 else -1.0) <= 0.0:
                return False, False, rest, there
        there = march_layer(law, par, rest, part, towards, to, goal, case.tolerance, zeros(0))
        if free or not there.arrived:
            return True, there.arrived, rest, there
        miss = rest - there.ratio / c - held
        # what the steps leave moves the end of a long march about
        noise = i > 2 and abs(miss) <= NOISE * case.close
        if abs(miss) <= case.close or (noise and abs(miss) > 0.1 * abs(miss_last)):
            break
        new = rest - miss
        if i > 0 and miss != miss_last:
            new = rest - miss * (rest - rest_last) / (miss - miss_last)
        if new <= least:  # no tension would be left where the layers part
            if rest <= least:
                return True, False, rest, there  # and with next to none it is more than is held
            new = least if tried == inf else 0.5 * (rest + tried)
            tried = least
        rest_last, miss_last, rest = rest, miss, new
    return True, abs(miss) <= NOISE * case.close, rest, there


def solve_layers(
    law: CompactLaw,
    par: Parameters,
    aim: Aim,
    exit_tension: float,
    tolerance: float,
    before: Layers,
) -> tuple[int, Layers]:
    """Layers that meet a held tension and an aim at the exit, whatever holds the belt at rest.

    Parameters
    ----------
    law, par
        See `wraparc.arc.kernel.march`.
    aim
        ln(tight/slack), or a creep or slip at the exit towards the slack side [m].
    exit_tension
        Held instead of that of `par`, which is a guess then [N]; nan: T1 is held.
    tolerance
        Relative error of a step.
    before
        Layers of nearly the same arc to begin with, or `NO_LAYERS`.

    Returns
    -------
    outcome, layers
        SOLVED; BREAKAWAY: with no creep up to a ratio of 1 at the entry the aim is met within the
        arc; UNSOLVED.
    """
    case = _case(law, par, aim, exit_tension, tolerance)
    if before.solved and before.z > 0.0:
        near = _nearby(law, par, case, before)
        if near.solved:
            return SOLVED, near
    case, first = _at_rest(law, par, case)
    if first.solved and first.length <= par.length:
        return SOLVED, first
    outcome, found = _less_rest(law, par, case, first)
    if outcome != SOLVED and not first.solved and par.kick != 0.0:
        # at rest the overrun takes more than all tension: creep may pass through zero all the same
        case = _crossed(case, not case.crossing)
        first = _layers_of(law, par, case, 0.0, par.entry_tension)
        other, layers = _less_rest(law, par, case, first)
        if other == SOLVED:
            return other, layers
    return outcome, found


def _less_rest(law: CompactLaw, par: Parameters, case: Case, first: Layers) -> tuple[int, Layers]:
    """Layers that just fill the arc, from those at the floor that are longer."""
    rest, tolerance = first.rest_tension, case.tolerance
    # lambda grows until they do
    low, high, f_low, f_high = 0.0, 0.0, first.length / par.length - 1.0, inf
    best, top = first, log(LARGEST_RATIO / case.floors[1])
    reach = 2.0
    for _ in range(60):
        if high >= top:
            return BREAKAWAY, best
        high = min(high + reach, top)
        best = _layers_of(law, par, case, high, rest)
        f_high = best.length / par.length - 1.0
        if f_high <= 0.0:
            break
        # the length falls by about a shear-lag length a unit of lambda
        fall = (f_low - f_high) / (high - low)
        reach = min(max(1.1 * f_high / fall, 0.5), 12.0) if 0.0 < fall < inf else 2.0
        low, f_low, rest = high, f_high, best.rest_tension
    side, rise = 0, inf
    for i in range(100):
        if f_low == inf and i >= HALVINGS and f_high + MARGIN * rise * (high - low) < 0.0:
            break  # layers come to no end where these do not fill the arc yet
        z = 0.5 * (low + high)
        if f_low < inf and f_low != f_high and i % 8 < 7:
            z = (low * f_high - high * f_low) / (f_high - f_low)
        if not low < z < high:
            z = 0.5 * (low + high)
        best = _layers_of(law, par, case, z, best.rest_tension)
        f = best.length / par.length - 1.0
        if abs(f) < FILLED * tolerance or high - low < 1e-13 * high:
            break
        # false position keeps one end: halve its weight when it does (Illinois)
        if f > 0.0:
            f_high *= 0.5 if side > 0 else 1.0
            low, f_low, side = z, f, 1
        else:
            f_low *= 0.5 if side < 0 else 1.0
            rise = max(f - f_high, 0.0) / (high - z)
            high, f_high, side = z, f, -1
    good = best.solved and abs(best.length / par.length - 1.0) < 10.0 * tolerance
    return (SOLVED if good else UNSOLVED), best


def _nearby(law: CompactLaw, par: Parameters, case: Case, before: Layers) -> Layers:
    """Layers that just fill the arc, by secants from those of nearly the same arc."""
    case = _crossed(case, par.kick != 0.0 and before.creep == 0.0)
    z, rest, z_last, f_last = before.z, before.rest_tension, 0.0, 0.0
    slope = -case.floors[0] / (case.floors[1] * par.length)  # a shear-lag length a unit of lambda
    for i in range(NEARBY):
        best = _layers_of(law, par, case, z, rest)
        f = best.length / par.length - 1.0
        if not best.solved or abs(f) < FILLED * case.tolerance:
            return best
        if i > 0 and z != z_last:
            slope = (f - f_last) / (z - z_last)
        if slope >= 0.0:
            break
        z_last, f_last, rest = z, f, best.rest_tension
        z -= f / slope
        if z <= 0.0:
            break
    return NO_LAYERS


def _case(
    law: CompactLaw, par: Parameters, aim: Aim, exit_tension: float, tolerance: float
) -> Case:
    """What is to be met, with its floors."""
    close = 1e-12 * par.entry_tension
    if exit_tension == exit_tension:
        close = 0.1 * tolerance * exit_tension
    creep = max(abs(par.kick), aim.value)
    if aim.of == TENSION:
        pull = par.entry_tension * abs(1.0 - exp(-par.side * aim.value))
        close = max(min(close, 1e-8 * pull), 1e-15 * par.entry_tension)  # no pull: more digits
        creep = max(abs(par.kick), 1e-6)
        for _ in range(8):  # the creep that this pull makes, by w = u/l
            lag = lag_at(law, par, par.entry_tension, creep)
            creep = max(abs(par.kick), par.compliance * pull * lag, 1e-200)
    floor = FLOOR * creep
    floors = (floor, floor / lag_at(law, par, par.entry_tension, floor))
    return Case(aim, exit_tension, False, floors, close, tolerance)


def _at_rest(law: CompactLaw, par: Parameters, case: Case) -> tuple[Case, Layers]:
    """The layers at the floor, and the case, in which creep may pass through zero."""
    aim = case.aim
    first = _layers_of(law, par, case, 0.0, par.entry_tension)
    crossing = par.kick * par.side < 0.0
    if aim.of == TENSION:
        last = par.entry_tension * exp(-par.side * aim.value)
        crossing = par.kick * (last - first.rest_tension) > 0.0
    if crossing:
        case = _crossed(case, True)
        first = _layers_of(law, par, case, 0.0, first.rest_tension)
    return case, first


def _crossed(case: Case, crossing: bool) -> Case:
    """The same with or without creep that passes through zero."""
    return Case(case.aim, case.exit_tension, crossing, case.floors, case.close, case.tolerance)


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
