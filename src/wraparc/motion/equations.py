"""The end of a step: the equations of drums, runs and conveyor around the arcs, and their solution.

Trapezium rule, but of fourth order for the conveyor, whose swing on its belt hardly dies. Flows of
belt appear only as their integrals over the step, so that belt is conserved to rounding. Newton's
method on m of every drum, every tension, omega of every drum and the speed of the conveyor, in this
order, with the arcs as affine maps.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from wraparc.motion.drum_state import DrumState
from wraparc.motion.station_state import HaltError, StationState
from wraparc.motion.wraps import Found

_ITERATIONS = 16
#: Last relative change of a tension and of a drum's speed with which a step is solved: what is left
#: is of the order of the square. (Pieces that pass the nips alone change a tension by 6e-5 a step.)
_SETTLED, _SPEED_SETTLED = 1.5e-4, 1e-6
#: Angle of the conveyor's swing in a step up to which a rule of fourth order feeds it by less than
#: 3e-5 of it a radian [rad].
SWING = 0.3
#: Part of a step by which what happens at its ends is looked at on its own side of them.
BESIDE = 1e-6
_STANDS = 1e-13  # least travel of an arc that moves [m]


@dataclass
class Trial:
    """A trial of the end of a step of h [s]: the unknowns, and what follows of them.

    Attributes
    ----------
    h
        Length of the step [s].
    m, tensions, omega, v
        The unknowns: [m], [N], [rad/s], [m/s].
    residual, slopes
        Of the equations, and their derivatives.
    travels, angles, surfaces
        Of every drum: S [m], turn [rad]; rise, compliance and dryness at the nip.
    flow_in, flow_out
        Unstretched belt through the nips over the step with its slopes by m, T_in, omega, and
        behind the drum by T_out too.
    """

    h: float
    m: list[float]
    tensions: list[float]
    omega: list[float]
    v: float
    residual: Any = None
    slopes: Any = None
    travels: list[float] = field(default_factory=list)
    angles: list[float] = field(default_factory=list)
    surfaces: list[tuple[float, float, float]] = field(default_factory=list)
    flow_in: list[tuple[float, float, float, float]] = field(default_factory=list)
    flow_out: list[tuple[float, float, float, float, float]] = field(default_factory=list)


class End(NamedTuple):
    """Where a drum is at the end of a step.

    Attributes
    ----------
    travel, angle
        S [m], turn [rad].
    surface
        Rise [m], compliance of belt and recovery [1/N] and share of friction at the nip.
    entries, speeds
        Entry tension [N] and speed of the loaded surface at the nip [m/s], before and there: that
        of the tension member times R/(R + e).
    """

    travel: float
    angle: float
    surface: tuple[float, float, float]
    entries: tuple[float, float]
    speeds: tuple[float, float]


@np.errstate(all="ignore")  # a trial may be far off; what is not finite halts it
def solved(march: StationState, h: float) -> Trial:
    """Solve for the end of a step of h [s].

    Raises
    ------
    HaltError
        If there is no such end: the belt goes slack or a drive breaks away.
    """
    n = march.n
    trial = guessed(march, h)
    softer = [march.softer_run(i, [d.arc.travel for d in march.drums]) for i in range(n - 1)]
    worst, place = 0.0, march.names[-1]
    for iteration in range(_ITERATIONS):
        trial.residual, trial.slopes = np.zeros(3 * n + 2), np.zeros((3 * n + 2, 3 * n + 2))
        try:
            _arcs(march, trial, iteration == 0)
            _runs(march, trial, softer)
            _ends(march, trial)
            _turn(march, trial)
            change = np.linalg.solve(trial.slopes, -trial.residual)
        except np.linalg.LinAlgError:
            raise HaltError("gross slip", place) from None
        step: list[float] = change.tolist()
        if not math.isfinite(sum(step)):
            raise HaltError("gross slip", place)
        fall = max(-step[n + i] / trial.tensions[i] for i in range(n + 1))
        if fall > 0.8:  # too far: no tension may turn into a push on the way
            step = [0.8 / fall * s for s in step]
        _take(trial, step, n)
        worst = 0.0
        for moved, name in zip(
            march.wraps.change(trial.m, trial.tensions[1:]), march.names, strict=True
        ):
            if moved > worst:
                worst, place = moved, name
        faster = max(
            abs(s) / d.duty.speed
            for s, d in zip(step[2 * n + 1 : 3 * n + 1], march.drums, strict=True)
        )
        if worst < _SETTLED and faster < _SPEED_SETTLED and fall <= 0.8:
            return trial
    if march.slackens(trial.tensions):
        raise march.goes_slack(trial.tensions)
    raise HaltError("gross slip", place)


def guessed(march: StationState, h: float) -> Trial:
    """Guess the end of a step: every unknown goes on as it went in the last two steps."""
    w = march.onward(h)
    return Trial(
        h=h,
        m=[d.arc.m + h * (d.slope + w * (d.slope - d.slope_0)) for d in march.drums],
        tensions=[
            max(t + h * (r + w * (r - r_0)), 0.5 * t)
            for t, r, r_0 in zip(march.T, march.rates, march.rates_0, strict=True)
        ],
        omega=[d.guessed(h, w) for d in march.drums],
        v=march.v + h * (march.v_rate + w * (march.v_rate - march.v_rate_0)),
    )


def _take(trial: Trial, step: list[float], n: int) -> None:
    trial.m = [a + b for a, b in zip(trial.m, step, strict=False)]
    trial.tensions = [a + b for a, b in zip(trial.tensions, step[n:], strict=False)]
    trial.omega = [a + b for a, b in zip(trial.omega, step[2 * n + 1 :], strict=False)]
    trial.v += step[-1]


def _arcs(march: StationState, trial: Trial, first: bool) -> None:
    """Sweep the arcs: entry tensions, and the flow of belt through every nip."""
    ends = [_travelled(march, trial, i) for i in range(march.n)]
    trial.travels = [end.travel for end in ends]
    trial.angles = [end.angle for end in ends]
    trial.surfaces = [end.surface for end in ends]
    if first:
        for d in march.drums:
            d.arc.lift = d.lift_at(d.omega)
        march.wraps.begin(trial.travels, trial.h, march.onward(trial.h))
    for d, end, w1 in zip(march.drums, ends, trial.omega, strict=True):
        d.arc.lift = d.lift_at(w1)
        if d.arc.moves and (d.riders or d.on_drum):
            march.wraps.at_nip(d.arc, *end.surface)
    travels = [
        max(end.travel, d.arc.travel + _STANDS) for d, end in zip(march.drums, ends, strict=True)
    ]
    found = march.wraps.sweep(travels, trial.m, trial.tensions[1:])
    trial.flow_in, trial.flow_out = [], []
    for i, (end, out) in enumerate(zip(ends, found, strict=True)):
        _flows(march, trial, i, end, out)


def _travelled(march: StationState, trial: Trial, i: int) -> End:
    """How far a drum has come."""
    d, half, rise_of_run = march.drums[i], 0.5 * trial.h, march.run_rises[i]
    arc, w1 = d.arc, trial.omega[i]
    entry0, entry1 = march.T[i] + rise_of_run, trial.tensions[i] + rise_of_run
    turn = half * (d.omega + w1)
    surface = d.at_nip(arc.travel + turn * d.radius * d.share, d.angle + turn, march.stretch)
    press0, press1 = entry0 - d.lift_at(d.omega), entry1 - d.lift_at(w1)
    v_0 = d.share * (d.omega * (d.radius - d.squeeze * press0 + arc.rise))
    v_1 = d.share * (w1 * (d.radius - d.squeeze * press1 + surface[0]))
    return End(
        arc.travel + half * (v_0 + v_1), d.angle + turn, surface, (entry0, entry1), (v_0, v_1)
    )


def _flows(march: StationState, trial: Trial, i: int, end: End, out: Found) -> None:
    """Equation of an arc, and the unstretched belt through its nips over the step."""
    n, half, r, jac = march.n, 0.5 * trial.h, trial.residual, trial.slopes
    d, w1, give, m1 = march.drums[i], trial.omega[i], end.surface[1], trial.m[i]
    arc, (entry0, entry1), (v_0, v_1) = d.arc, end.entries, end.speeds
    # the arc: T_in = its affine map
    r[i] = entry1 - out.entry
    jac[i, n + i], jac[i, n + i + 1], jac[i, i] = 1.0, -out.entry_x, -out.entry_m
    # belt through the entry nip: a = 1/EA' there, belt alone without the recovery; the tension
    # member runs faster by 1/share than the surface that m and W are measured on
    own0, own1 = arc.give - d.recovery, give - d.recovery
    down = 1.0 / (1.0 + 0.5 * (own0 * entry0 + own1 * entry1))
    fast = down / d.share
    up = half * (v_0 * (1.0 + arc.give * entry0) + v_1 * (1.0 + give * entry1))
    q = (up - (m1 - arc.m)) * fast
    by_t = half * (v_1 * give - d.share * w1 * d.squeeze * (1.0 + give * entry1)) * fast
    by_t -= 0.5 * q * own1 * down
    by_w = half * (v_1 / w1 if w1 else d.share * d.radius) * (1.0 + give * entry1) * fast
    trial.flow_in.append((q, -fast, by_t, by_w))
    # belt through the exit nip: Q + dW - d Lambda
    stored = out.wrapped - arc.wrapped - (out.lifted - arc.lifted) / d.radius
    out_flow = q + stored / d.share
    slopes = out.wrapped_m / d.share - fast, by_t, out.wrapped_x / d.share, by_w
    trial.flow_out.append((out_flow, *slopes))


def _runs(march: StationState, trial: Trial, softer: list[float]) -> None:
    """Unstretched belt on the runs between the drums: what comes less what leaves."""
    n, r, jac = march.n, trial.residual, trial.slopes
    for i in range(n - 1):
        row, length = n + i, march.drums[i + 1].run
        c0 = length * march.stretch + softer[i]
        c1 = length * march.stretch + march.softer_run(i, trial.travels)
        q, by_m, by_t, by_w = trial.flow_in[i + 1]
        p, p_m, p_t, p_x, p_w = trial.flow_out[i]
        rise = 0.5 * march.run_rises[i + 1]
        r[row] = (trial.tensions[i + 1] + rise) * c1 - (march.T[i + 1] + rise) * c0 - q + p
        jac[row, n + i], jac[row, n + i + 1] = p_t, c1 - by_t + p_x
        jac[row, i], jac[row, i + 1] = p_m, -by_m
        jac[row, 2 * n + 1 + i], jac[row, 2 * n + 2 + i] = p_w, -by_w


def _ends(march: StationState, trial: Trial) -> None:
    """Equations of the first and last tension."""
    n, station, h = march.n, march.station, trial.h
    r, jac, before, after = trial.residual, trial.slopes, march.T, trial.tensions
    first, last, own = 2 * n - 1, 2 * n, 3 * n + 1
    if station.conveyor_mass is None:
        load = march.load(march.t + h - BESIDE * h)
        r[first] = after[0] - (march.slack + march.pull * load)
        r[last] = after[n] - march.slack
        jac[first, n] = jac[last, 2 * n] = jac[own, own] = 1.0
        return
    way, by_t, by_v = _conveyor(march, trial)
    carry, back = station.carry_run * march.stretch, station.return_run * march.stretch
    q, q_m, q_t, q_w = trial.flow_in[0]
    r[first] = carry * (after[0] - before[0]) - q + way
    jac[first, n], jac[first, 0], jac[first, 2 * n] = carry - q_t + by_t, -q_m, -by_t
    jac[first, 2 * n + 1], jac[first, own] = -q_w, by_v
    if station.take_up == "gravity":
        r[last] = after[n] - march.slack
        jac[last, 2 * n] = 1.0
        return
    p, p_m, p_t, p_x, p_w = trial.flow_out[-1]
    r[last] = back * (after[n] - before[n]) - way + p
    jac[last, 2 * n], jac[last, 2 * n - 1] = back + p_x + by_t, p_t
    jac[last, n] -= by_t
    jac[last, n - 1], jac[last, 3 * n], jac[last, own] = p_m, p_w, -by_v
    if station.take_up == "winch":
        r[last] -= h * march.winch(before[n])


def _conveyor(march: StationState, trial: Trial) -> tuple[float, float, float]:
    """Equation of the conveyor's speed; its way over the step, with slopes by T_0 and speed.

    The way follows from speed and acceleration at both ends, the change of speed from the pull at
    both ends and at those of the two steps before. Where a swing takes so few steps that this would
    feed it, both are trapezia.
    """
    n, h, half, own = march.n, trial.h, 0.5 * trial.h, 3 * march.n + 1
    v0, v1, mass = march.v, trial.v, march.mass
    pull0, pull1 = march.T[0] - march.T[n], trial.tensions[0] - trial.tensions[n]
    f0, _ = march.resistance(v0, march.t + BESIDE * h)
    f1, slope = march.resistance(v1, march.t + h - BESIDE * h)
    part, miss, by_pull = 0.0, 0.0, 0.0
    if h * march.swing <= SWING:
        part = h * h / (12.0 * mass)
        rates = (r[0] - r[n] for r in (march.rates, march.rates_0))
        miss, by_pull = _missed(h, march.h_before, march.h_0, (pull1 - pull0) / h, *rates)
    force = half * (pull0 - f0 + pull1 - f1) - miss
    trial.residual[own] = mass * (v1 - v0) - force
    by_pull = half - by_pull
    trial.slopes[own, n], trial.slopes[own, 2 * n] = -by_pull, by_pull
    trial.slopes[own, own] = mass + half * slope
    way = half * (v0 + v1) + part * (pull0 - f0 - pull1 + f1)
    return way, -part, half + part * slope


def _missed(
    h: float, h_1: float, h_2: float, rate: float, rate_1: float, rate_2: float
) -> tuple[float, float]:
    """What a trapezium over a step counts too much, and its slope by the value at its end.

    By the polynomial through the ends of this and of the last two steps, of these lengths and with
    these mean rates.
    """
    if not h_1:
        return 0.0, 0.0
    bend, by_end = (rate - rate_1) / (h + h_1), 1.0 / (h * (h + h_1))
    miss = h**3 / 6.0 * bend
    by = h**3 / 6.0 * by_end
    if h_2:
        known = h + h_1 + h_2
        turn = (bend - (rate_1 - rate_2) / (h_1 + h_2)) / known
        weight = h**3 * (h + 2.0 * h_1) / 12.0
        miss, by = miss + weight * turn, by + weight * by_end / known
    return miss, by


def _turn(march: StationState, trial: Trial) -> None:
    """Equations of the drums."""
    n, r, jac = march.n, trial.residual, trial.slopes
    leads: dict[int, tuple[float, float]] = {}
    for i in march.order:
        d, row = march.drums[i], 2 * n + 1 + i
        w1, entry = trial.omega[i], trial.tensions[i] + march.run_rises[i]
        rises = d.rises(trial.travels[i])
        moment, by_in, by_out = d.moment_of(entry, trial.tensions[i + 1], *rises)
        if d.on_drum:
            d.extra = d.ripple(trial.angles[i])
        jac[row, row] = 1.0
        if d.locked:
            r[row] = w1
            leads[i] = (0.0, 0.0)
            continue
        if d.held:
            r[row] = w1 - d.duty.speed * d.level
            # what holds the speed gives the torque that the belt and the drum's inertia ask
            leads[i] = (moment + d.inertia * (w1 - d.omega) / trial.h, d.inertia / trial.h)
            continue
        lead = leads[d.master] if d.master >= 0 else (0.0, 0.0)
        torque, slope, by_lead = d.driven(w1, lead[0])
        scale = 0.5 * trial.h / d.inertia
        r[row] = w1 - d.omega - scale * (d.torque - d.moment + torque - moment)
        jac[row, row] = 1.0 - scale * slope
        jac[row, n + i] += scale * by_in
        jac[row, n + i + 1] += scale * by_out
        if d.master >= 0 and by_lead:
            _lead(march, trial, d, row, scale * by_lead, lead[1])
        leads[i] = (torque, slope)


def _lead(
    march: StationState, trial: Trial, d: DrumState, row: int, by_lead: float, slope: float
) -> None:
    """Slopes of a follower's torque by what decides its master's."""
    n, jac, lead = march.n, trial.slopes, march.drums[d.master]
    jac[row, 2 * n + 1 + d.master] -= by_lead * slope
    if lead.held:
        arm = lead.radius - lead.squeeze * (trial.tensions[d.master] - lead.arc.lift)
        jac[row, n + d.master] -= by_lead * arm
        jac[row, n + d.master + 1] += by_lead * arm
