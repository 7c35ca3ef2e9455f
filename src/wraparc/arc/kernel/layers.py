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
    friction_of_creep,
    lag_at,
    march_layer,
    value_at,
)
from wraparc.arc.kernel.quantities import BREAKAWAY, SOLVED, UNSOLVED, Parameters, Shot, zeros
from wraparc.friction.compact import CompactLaw

FLOOR = 1e-9  # of creep near rest in the creep of the layers: what it changes is its square
FILLED = 3.0  # relative miss of the arc's length, in tolerances of a step: what steps leave
LARGEST_RATIO = 1.0  # of creep at the entry


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


def _layers_of(
    law: CompactLaw,
    par: Parameters,
    aim: Aim,
    crossing: bool,
    floors: tuple[float, float],
    z: float,
    rest: float,
    tolerance: float,
) -> Layers:
    """Both layers at one lambda, `z`; `rest` is a first guess of T_r."""
    c, kick = par.compliance, par.kick
    way = 1.0 if kick > 0.0 else -1.0
    creep, ratio, length = 0.0, par.side * floors[1] * exp(z), 0.0
    free = kick == 0.0  # the belt enters at rest or nearly so: there is no layer at the entry
    if not free and not crossing:
        creep, ratio = way * floors[0] * exp(z), 0.0
        if abs(creep) >= abs(kick):  # creep grows from the entry on
            spare = exp(z) - abs(kick) / floors[0]
            creep, ratio, free = kick, way * floors[1] * spare, True
    elif not free:
        ratio = -way * floors[1] * exp(z)
    if free:
        rest = par.entry_tension + ratio / c
    else:
        if crossing:
            rest += way * min(way * (ratio / c - (rest - par.entry_tension)), 0.0)
        close = 1e-12 * par.entry_tension
        if aim.of == TENSION:  # of nearly no pull more digits count
            pull = par.entry_tension * abs(1.0 - exp(-par.side * aim.value))
            close = max(min(close, 1e-8 * pull), 1e-15 * par.entry_tension)
        inward = _entry_layer(law, par, rest, (creep, ratio), close, tolerance)
        rest, length = inward.rest_tension, inward.entry_length
        if not inward.solved:
            return inward
    goal = par.side * aim.value
    if aim.of == TENSION:
        goal = c * (rest - par.entry_tension * exp(-goal))
    ahead = goal - value_at(law, par, rest, aim.of, creep, ratio)
    if ahead * (1.0 if creep > 0.0 or ratio > 0.0 else -1.0) <= 0.0:
        # the aim is met before the layer has begun: what is left is of the size of the floor
        near = z == 0.0
        return Layers(near, rest, creep, ratio, length, length if near else 0.0, creep, ratio)
    out = march_layer(law, par, rest, (creep, ratio), 1.0, aim.of, goal, tolerance, zeros(0))
    arrived = out.arrived and out.ratio < c * rest  # no creep is met where no tension is left
    both = length + out.length if arrived else inf
    return Layers(arrived, rest, creep, ratio, length, both, out.creep, out.ratio)


def _entry_layer(
    law: CompactLaw,
    par: Parameters,
    rest: float,
    part: tuple[float, float],
    close: float,
    tolerance: float,
) -> Layers:
    """T_r and length of the layer at the entry: from where the layers part to kick and T1.

    T1 is met to `close` [N].
    T_r is no tension of the belt where creep passes through zero fast: it may be negative.
    """
    c, miss, rest_last, miss_last = par.compliance, inf, 0.0, 0.0
    length = 0.0
    for i in range(40):
        there = march_layer(law, par, rest, part, -1.0, TO_CREEP, par.kick, tolerance, zeros(0))
        if not there.arrived:
            break
        miss, length = rest - there.ratio / c - par.entry_tension, there.length
        if abs(miss) <= close:
            break
        new = rest - miss
        if i > 0 and miss != miss_last:
            new = rest - miss * (rest - rest_last) / (miss - miss_last)
        rest_last, miss_last, rest = rest, miss, new
    good = abs(miss) <= 100.0 * close
    return Layers(good, rest, part[0], part[1], length, length if good else inf, 0.0, 0.0)


def solve_layers(
    law: CompactLaw, par: Parameters, aim: Aim, tolerance: float
) -> tuple[int, Layers]:
    """Layers that meet the entry tension and an aim at the exit, whatever holds the belt at rest.

    Parameters
    ----------
    law, par
        See `wraparc.arc.kernel.march`.
    aim
        ln(tight/slack), or a creep or slip at the exit towards the slack side [m].
    tolerance
        Relative error of a step.

    Returns
    -------
    outcome, layers
        SOLVED; BREAKAWAY: with no creep up to a ratio of 1 at the entry the aim is met within the
        arc; UNSOLVED.
    """
    first, rest, crossing, floors = _at_rest(law, par, aim, tolerance)
    if first.solved and first.length <= par.length:
        return SOLVED, first
    outcome, found = _less_rest(law, par, aim, crossing, floors, first, tolerance)
    if outcome != SOLVED and not first.solved and par.kick != 0.0:
        # at rest the overrun takes more than all tension: creep may pass through zero all the same
        rest = par.entry_tension
        first = _layers_of(law, par, aim, not crossing, floors, 0.0, rest, tolerance)
        other, layers = _less_rest(law, par, aim, not crossing, floors, first, tolerance)
        if other == SOLVED:
            return other, layers
    return outcome, found


def _less_rest(
    law: CompactLaw,
    par: Parameters,
    aim: Aim,
    crossing: bool,
    floors: tuple[float, float],
    first: Layers,
    tolerance: float,
) -> tuple[int, Layers]:
    """Layers that just fill the arc, from those at the floor that are longer."""
    rest = first.rest_tension
    # lambda grows until they do
    low, high, f_low, f_high = 0.0, 0.0, first.length / par.length - 1.0, inf
    best, top = first, log(LARGEST_RATIO / floors[1])
    reach = 2.0
    for _ in range(60):
        if high >= top:
            return BREAKAWAY, best
        high = min(high + reach, top)
        best = _layers_of(law, par, aim, crossing, floors, high, rest, tolerance)
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
        best = _layers_of(law, par, aim, crossing, floors, z, best.rest_tension, tolerance)
        f = best.length / par.length - 1.0
        if abs(f) < FILLED * tolerance or high - low < 1e-13 * high:
            break
        # false position keeps one end: halve its weight when it does (Illinois)
        if f > 0.0:
            f_high *= 0.5 if side > 0 else 1.0
            low, f_low, side = z, f, 1
        else:
            f_low *= 0.5 if side < 0 else 1.0
            high, f_high, side = z, f, -1
    good = best.solved and abs(best.length / par.length - 1.0) < 10.0 * tolerance
    return (SOLVED if good else UNSOLVED), best


def _at_rest(
    law: CompactLaw, par: Parameters, aim: Aim, tolerance: float
) -> tuple[Layers, float, bool, tuple[float, float]]:
    """Layers at the floor, T_r there, whether creep passes through zero, and the floors."""
    exit_tension = par.entry_tension * exp(-par.side * aim.value)
    creep = max(abs(par.kick), aim.value)
    if aim.of == TENSION:
        pull = par.compliance * abs(par.entry_tension - exit_tension)
        creep = max(abs(par.kick), 1e-6)
        for _ in range(8):  # the creep that this pull makes, by w = u/l
            creep = max(abs(par.kick), pull * lag_at(law, par, par.entry_tension, creep), 1e-200)
    floor = FLOOR * creep
    floors = (floor, floor / lag_at(law, par, par.entry_tension, floor))
    first = _layers_of(law, par, aim, False, floors, 0.0, par.entry_tension, tolerance)
    rest = first.rest_tension
    crossing = par.kick * par.side < 0.0
    if aim.of == TENSION:
        crossing = par.kick * (exit_tension - rest) > 0.0
    if crossing:
        first = _layers_of(law, par, aim, True, floors, 0.0, rest, tolerance)
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
