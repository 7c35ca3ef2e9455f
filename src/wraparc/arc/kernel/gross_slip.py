"""Gross slip: the largest tension ratio that friction can carry at any creep.

The tight side is held (T1 driving, T2 braking) and the slack side falls. On a braking pulley the
held tension is at the exit, so that the entry tension is an unknown too.
"""

from __future__ import annotations

from math import exp, inf, log, sqrt
from typing import NamedTuple

from wraparc.arc.kernel.effort import (
    TENSION,
    effort_of,
    jumps,
    largest_effort,
    mesh_steps,
    value_of,
)
from wraparc.arc.kernel.quantities import Buffer, Geometry, Parameters, parameters_at, zeros
from wraparc.arc.kernel.search import LARGEST_LOG, carried_ratio, climb
from wraparc.arc.kernel.tension_table import applies, open_table, table_size
from wraparc.friction.compact import CompactLaw, excess_at, plateau_at, residual_at, segment_of

PEAK_STEPS = 12  # mesh steps of a first search of the largest ratio; decides speed only
NEARBY = 0.02  # of effort, around an earlier result
EDGE = 5e-4  # of effort: nearer to the end of where it was sought a peak may lie beyond
_NO_SLACK = 50.0  # miss of a place where the slack side has no tension left
_PIECE = 0.25  # of ln T: where friction is smooth, 5 points are exact to rounding
PRESSURES = 5  # of an arc, at which a falling law is looked at
_ROUNDS, _TOLERANCE, _GROWTH = 200, 1e-9, 2.0


def plateau_capacity(law: CompactLaw, tight_pressure: float, wrap_angle: float) -> float:
    """ln(tight/slack) at gross slip with the largest friction of the law everywhere."""
    return _capacity(law, tight_pressure, wrap_angle, False)


def residual_capacity(law: CompactLaw, tight_pressure: float, wrap_angle: float) -> float:
    """ln(tight/slack) at gross slip with what friction is left with at slips without bound."""
    return _capacity(law, tight_pressure, wrap_angle, True)


def _friction(law: CompactLaw, segment: int, pressure: float, left: bool) -> float:
    """Largest friction of a law at a pressure, or what is left of it [-]."""
    if left:
        return residual_at(law, segment, pressure)
    return plateau_at(law, segment, pressure)


def _capacity(law: CompactLaw, tight_pressure: float, wrap_angle: float, left: bool) -> float:
    """ln(tight/slack) at gross slip.

    d ln T / d theta = -mu(p), integrated in ln p from the tight side: exact to rounding,
    piece by piece (Gauss-Legendre, 5 points, with the last piece closed by Newton's method).
    """
    q, angle = 0.0, wrap_angle
    for _ in range(4 * len(law.edges) + 400):
        segment, span = _piece(law, tight_pressure * exp(-q))
        taken = _angle(law, tight_pressure, segment, q, span, left)
        if taken < angle:
            angle -= taken
            q += span
            continue
        part = span * angle / taken
        for _ in range(50):
            f = _angle(law, tight_pressure, segment, q, part, left) - angle
            mu = _friction(law, segment, tight_pressure * exp(-q - part), left)
            change = f * mu
            part -= change
            if abs(change) < 1e-15:
                break
        return q + part
    return q


def _piece(law: CompactLaw, p: float) -> tuple[int, float]:
    """Segment below a pressure [Pa], and how far ln p may fall in it in one piece."""
    segment = segment_of(law, p * (1.0 - 1e-12))
    return segment, min(_PIECE, log(p / law.edges[segment])) if segment >= 0 else _PIECE


def _angle(
    law: CompactLaw, pressure: float, segment: int, q: float, span: float, left: bool
) -> float:
    """Wrap angle over which ln T falls from -q to -q - span in one piece."""
    total = 0.0
    for node, weight in (
        (0.0, 128.0 / 225.0),
        (-0.5384693101056831, 0.47862867049936647),
        (0.5384693101056831, 0.47862867049936647),
        (-0.906179845938664, 0.23692688505618908),
        (0.906179845938664, 0.23692688505618908),
    ):
        p = pressure * exp(-q - 0.5 * span * (1.0 + node))
        total += weight / _friction(law, segment, p, left)
    return 0.5 * span * total


class Grip(NamedTuple):
    """What friction can carry on an arc, but for its law.

    Attributes
    ----------
    wrap_angle
        phi [rad].
    area
        B R, tension over wrap pressure [m2].
    offset
        ln(tight/slack) that it carries beyond that of the plateau, < 0 where friction falls past
        its peak [-].
    """

    wrap_angle: float
    area: float
    offset: float


class Line(NamedTuple):
    """Tensions of an arc along a line: those at k = 1, and how they grow with k [N]."""

    tight: float
    slack: float
    tight_rise: float
    slack_rise: float


def carried_log(law: CompactLaw, grip: Grip, tight: float) -> float:
    """Largest ln(tight/slack) that friction carries with the tight side at a tension [N]."""
    q = plateau_capacity(law, tight / grip.area, grip.wrap_angle) + grip.offset
    return max(q, 0.0)


def _angle_needed(law: CompactLaw, tight_pressure: float, fall: float) -> float:
    """Wrap angle over which ln T falls so far from the tight side at the plateau [rad]."""
    q, angle = 0.0, 0.0
    while q < fall:
        segment, span = _piece(law, tight_pressure * exp(-q))
        span = min(span, fall - q)
        angle += _angle(law, tight_pressure, segment, q, span, False)
        q += span
        if span <= 1e-15 * q:
            break
    return angle


def _missing(law: CompactLaw, grip: Grip, line: Line, k: float) -> tuple[float, float]:
    """Wrap angle that the tensions at a place of a line need less that of the arc, and its slope.

    d angle = d ln T_tight / mu(p_tight) - d ln T_slack / mu(p_slack) at the plateau.
    """
    tight = line.tight + (k - 1.0) * line.tight_rise
    slack = line.slack + (k - 1.0) * line.slack_rise
    if tight <= 0.0 or slack <= 0.0:
        return _NO_SLACK, 0.0
    if tight <= slack:
        return -grip.wrap_angle, 0.0
    top, fall = tight / grip.area, log(tight / slack) - grip.offset
    end = top * exp(-fall)
    at_top = plateau_at(law, segment_of(law, top), top)
    at_end = plateau_at(law, segment_of(law, end), end)
    slope = line.tight_rise / (tight * at_top) - line.slack_rise / (slack * at_end)
    return _angle_needed(law, top, fall) - grip.wrap_angle, slope


def slip_place(law: CompactLaw, grip: Grip, line: Line, way: float, low: float) -> float:
    """Place k of a line at which gross slip begins (way 1) or ends (way -1), from `low` upwards.

    Newton's method on the wrap angle that the tensions need, within what brackets the place; inf
    if there is none up to 1e4 times `low`, or 1e4.
    """
    step = max(low, 1.0)
    a, b, most = low, inf, 1e4 * step
    if way > 0.0 and line.slack_rise < 0.0:
        b = 1.0 - line.slack / line.slack_rise  # no tension is left there
    k = a + step
    if k >= b:
        k = 0.5 * (a + b)
    for _ in range(_ROUNDS):
        f, slope = _missing(law, grip, line, k)
        f, slope = way * f, way * slope
        if f < 0.0:
            a = k
            if k >= most:
                return inf
        else:
            b = k
        new = k - f / slope if slope > 0.0 else inf
        if abs(new - k) <= _TOLERANCE * k:
            return new
        new = min(new, most)
        if not a < new < b:
            new = 0.5 * (a + b) if b < inf else min(a + step, most)
            step *= _GROWTH
        if abs(new - k) <= 1e-15 * k:
            return k
        k = new
    return k


def largest_ratio(
    law: CompactLaw,
    geometry: Geometry,
    tight: float,
    softening: bool,
    steps: int,
) -> tuple[float, float]:
    """Gross-slip capacity of a held tight side: ln(tight/slack), and the exit creep there [m].

    A law flat past its peak has a supremum, with the friction of its plateau everywhere and no
    finite creep (inf). A softening law is left with its residual everywhere, at no finite creep
    either, unless more is carried at some creep on the way there (`outweighs`).
    """
    radius, wrap, width = geometry.radius, geometry.wrap_angle, geometry.width
    pressure = tight / (width * radius)
    if not softening:
        return plateau_capacity(law, pressure, wrap), inf
    residual = residual_capacity(law, pressure, wrap)
    if not outweighs(law, geometry, tight, residual):
        return residual, inf
    most = plateau_capacity(law, pressure, wrap)
    best, creep = _largest_over_effort(law, geometry, tight, most, steps)
    return (best, creep) if best > residual else (residual, inf)


def outweighs(law: CompactLaw, geometry: Geometry, tight: float, residual: float) -> bool:
    """Whether some creep may carry more than the residual friction everywhere.

    Only if what friction has over its residual past the rise outweighs what it lacks on it,
    int (mu - mu_residual) dx > 0 from the overrun on at some pressure of the arc: with more creep
    the belt passes the rise sooner, and where the belt is tight.
    """
    area = geometry.width * geometry.radius
    for i in range(PRESSURES):
        p = tight / area * exp(-residual * i / (PRESSURES - 1))
        segment = segment_of(law, p)
        start = abs(geometry.kick + geometry.kick_coefficient * p * sqrt(p))
        if excess_at(law, segment, p) + start * residual_at(law, segment, p) > 0.0:
            return True
    return False


def _largest_over_effort(
    law: CompactLaw, geometry: Geometry, tight: float, guess: float, steps: int
) -> tuple[float, float]:
    """Largest ln(tight/slack) of a held tight side over entry creep ratios below 1, and the creep.

    `guess` is one of ln(tight/slack), the creep is that at the exit, towards the slack side [m].
    """
    side = geometry.side
    fine = mesh_steps(law, parameters_at(tight, geometry), steps)
    table = zeros(table_size(LARGEST_LOG, 2 * fine))
    entry = tight if side > 0.0 else tight * exp(-guess)
    coarse = min(PEAK_STEPS, steps)
    mesh = steps if side > 0.0 else coarse
    best, creep, z, before = guess, 0.0, -inf, inf
    for _ in range(40):
        new, creep, z = _peak_of(law, parameters_at(entry, geometry), z, mesh, table)
        change, best = abs(new - best), new
        # a flat peak is found to some 1e-6 only: no use in going on where changes stop falling
        done = change < 1e-8 or (before < 1e-5 and change > 0.5 * before)
        if side > 0.0 or (mesh == steps and done):
            break
        before = change
        if mesh != steps and change < 1e-2:
            mesh, before = steps, inf
        # at its peak the ratio does not change with effort: the tight side is met with that held
        entry, best = _entry_at(law, geometry, tight, z, entry, best, mesh, table)
    return best, creep


def _entry_at(
    law: CompactLaw,
    geometry: Geometry,
    tight: float,
    z: float,
    entry: float,
    ratio: float,
    steps: int,
    table: Buffer,
) -> tuple[float, float]:
    """Entry tension of a braking pulley that carries `tight` at an effort, and ln(T2/T1)."""
    t = t_last = log(entry)
    miss_last = 0.0
    for i in range(8):
        miss = log(tight) - ratio - t
        if abs(miss) < 1e-9:
            break
        new = t + miss
        if i > 0 and miss != miss_last:
            new = t - miss * (t - t_last) / (miss - miss_last)
        t_last, miss_last, t = t, miss, new
        par = parameters_at(exp(t), geometry)
        ratio, _ = carried_ratio(law, par, z, steps, _opened(law, par, steps, table))
    return exp(t), ratio


def _opened(law: CompactLaw, par: Parameters, steps: int, table: Buffer) -> Buffer:
    """`table` opened for marches in tension, or none where they do not apply."""
    if not applies(law, par):
        return zeros(0)
    open_table(law, par, LARGEST_LOG, mesh_steps(law, par, steps), table)
    return table


def _peak_of(
    law: CompactLaw,
    par: Parameters,
    near: float,
    steps: int,
    table: Buffer,
) -> tuple[float, float, float]:
    """Largest ln(tight/slack) over effort, the creep there [m] and the effort.

    `near` narrows the search to the neighbourhood of an earlier result, moved as the peak asks.
    """
    top = largest_effort(law, par)
    low, high = (0.0 if jumps(law) else effort_of(par, par.side * 1e-5)), top
    z, reach = near, NEARBY
    if near == -inf:
        coarse = min(PEAK_STEPS, steps)
        buffer = _opened(law, par, coarse, table)
        # static and residual friction may each have a maximum: which is the larger?
        parts, best, at = 8, -inf, 0
        for i in range(parts + 1):
            z = low + (high - low) * i / parts
            value, _ = carried_ratio(law, par, z, coarse, buffer)
            if value > best:
                best, at = value, i
        span = (high - low) / parts
        low, high = low + span * max(at - 1, 0), low + span * min(at + 1, parts)
        z, shot = climb(law, par, low, high, 1e-2, coarse, buffer)
        value, _ = carried_ratio(law, par, high, coarse, buffer)
        if value > value_of(par, shot, TENSION):
            z = high
        reach = 0.03
    # sought on the coarse mesh, told on the fine one; a sharp peak is sought there again
    buffer = _opened(law, par, steps, table)
    best, shot = carried_ratio(law, par, high, steps, buffer)
    if z < high:
        end, near_end = best, shot
        left = right = z  # sought farther out while the peak lies at an end of where it was sought
        while not (left < z - EDGE or left == low) or not (z + EDGE < right or right == high):
            left, right = max(low, z - reach), min(high, z + reach)
            z, shot = climb(law, par, left, right, 2e-4, steps, buffer)
            reach *= 4.0
        best = value_of(par, shot, TENSION)
        # the coarse mesh misjudges a maximum that hardly rises towards the end
        if end > best:
            best, shot, z = end, near_end, high
    return best, par.side * shot.creep, z
