"""The march as the paper describes it: from the exit nip, with the shrinkage of the belt lumped.

B. DeVries, "A model of lagging friction as a function of creep history and wrap pressure", section
Application. Kept as published, as a second opinion: it overstates the shrinkage of soft belts.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from wraparc.arc.quantities import jumps
from wraparc.arc.result import ArcResult, Capacities, Energy, Profile, Status
from wraparc.arc.traction import plateau_stress, traction
from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Array

nan = math.nan
#: Of the walk found at once: first global creep [m], first slip over creep, most steps of Newton's
#: method, and the relative change after which the next is rounding.
_FIRST_SHARE, _FIRST_SLIP, _NEWTON_STEPS, _SETTLED = 1e-3, 0.2, 20, 1e-9


@dataclass(frozen=True)
class PaperMarch:
    """The paper's calculator: equal segments from the exit, lumped shrinkage, one global creep.

    At the exit end of a segment with the remaining arc L_i behind it

        u = (T1 - T) L_i/EA + (global creep) L_i/L + x_c,

    tau = mu(x, p) p with x = u - (h/G) tau, and T grows by tau B ds towards the entry. The global
    creep, of either sign, is found so that the tension at the entry is T1.

    The paper's belt is a string on the surface of the lagging: its thickness, covers and mass are
    left out.

    Attributes
    ----------
    segment
        Largest length of a segment [m].
    """

    segment: float = 2.5e-3

    @property
    def name(self) -> str:
        """Name in files and reports."""
        return "paper"

    def solve(self, arc: WrapArc) -> ArcResult:
        """Solve one arc; capacities are not part of this method.

        Raises
        ------
        InputError
            If the law is unfit for the arc, see `WrapArc`.
        """
        march = _March(arc, math.ceil(arc.length / self.segment))
        with np.errstate(all="ignore"):
            found = march.at_once()
        if found is not None:
            return march.result(self.name, *found)
        goal = arc.side * math.log(arc.entry_tension / arc.exit_tension)
        if march.most() < goal:
            return ArcResult.without_state(Status.BREAKAWAY, self.name, arc, Capacities())
        status, share = _search(march, goal)
        if not status.solved:
            return ArcResult.without_state(status, self.name, arc, Capacities())
        return march.result(self.name, share, np.array(march.walk(share)))


def _search(march: _March, goal: float) -> tuple[Status, float]:  # noqa: C901
    """Global creep towards the slack side that meets the tensions, or of the largest ratio [m].

    Friction that sets in with a jump on lagging that does not shear is all there or not at all in
    each segment: the ratio is a staircase, and a goal within one step of it is met.
    """
    scale = 1e-3
    low, high = nan, nan
    share, last, f_last = scale, nan, nan
    best, f_best = share, -math.inf
    for _ in range(200):
        f = march.ratio(share) - goal
        if abs(f) < 1e-12:
            return Status.SOLVED, share
        if f > f_best:
            best, f_best = share, f
        if f < 0.0:
            low = share
        else:
            high = share
        if math.isnan(high):
            if f < f_last - 1e-15 or share > march.arc.length:
                # friction no longer grows with creep: the largest ratio lies near the best so far
                best, f_best = _climb(march, 0.5 * best, 2.5 * best, goal)
                if f_best < 0.0:
                    return Status.BREAKAWAY, best
                high, new = best, 0.5 * (low + best)
            else:
                new = 2.0 * share if share > 0.0 else share + scale
        elif math.isnan(low):
            new = share - 2.0 * max(abs(share), scale)
        else:
            new = nan if f == f_last else share - f * (share - last) / (f - f_last)
            if not low < new < high:
                new = 0.5 * (low + high)
            if new in (low, high):
                met = abs(f) < max(1e-8, march.step_of_ratio(share))
                return (Status.SOLVED if met else Status.UNSOLVED), share
        last, f_last, share = share, f, new
    return Status.UNSOLVED, best


def _climb(march: _March, a: float, b: float, goal: float) -> tuple[float, float]:
    ratio = 0.6180339887498949
    for _ in range(40):
        c, d = b - ratio * (b - a), a + ratio * (b - a)
        if march.ratio(c) >= march.ratio(d):
            b = d
        else:
            a = c
    share = 0.5 * (a + b)
    return share, march.ratio(share) - goal


class _March:
    """The march over one arc; it remembers nothing but its input."""

    def __init__(self, arc: WrapArc, segments: int) -> None:
        self.arc, self.segments = arc, segments
        self.law = arc.law.compact()
        self.onset = self.law.onset_compliance

    def ratio(self, share: float) -> float:
        """ln(tight/slack) carried with a global creep towards the slack side [m]."""
        return self.arc.side * math.log(self.walk(share)[-1][1] / self.arc.exit_tension)

    def most(self) -> float:
        """No ln(tight/slack) is larger than this: with the peak of friction all along."""
        arc, tension = self.arc, self.arc.exit_tension
        area, step = arc.width * arc.radius, arc.side * arc.width * arc.length / self.segments
        for _ in range(self.segments):
            tension += step * plateau_stress(self.law, tension / area)
            if tension <= 0.0:
                return math.inf
        return arc.side * math.log(tension / arc.exit_tension)

    def step_of_ratio(self, share: float) -> float:
        """Largest ln(tension) that one segment adds, where it either slips or rests [-]."""
        arc = self.arc
        if not jumps(self.law) or arc.lagging_compliance + self.onset > 0.0:
            return 0.0
        step = arc.width * arc.length / self.segments
        return max(abs(tau) * step / tension for _, tension, _, _, tau in self.walk(share))

    def walk(self, share: float) -> list[tuple[float, float, float, float, float]]:
        """Remaining arc, tension, creep, slip, shear stress at each exit end, then at the entry."""
        arc = self.arc
        length, overrun = arc.length, arc.entry_overrun
        stiffness, shear = arc.axial_stiffness, arc.lagging_compliance
        step = length / self.segments
        area, tension = arc.width * arc.radius, arc.exit_tension
        rows = []
        for i in range(self.segments + 1):
            remaining = length - i * step
            u = (arc.entry_tension - tension) * remaining / stiffness
            u += arc.side * share * remaining / length + overrun
            tau, _, _, x = traction(self.law, shear, tension / area, u)
            rows.append((remaining, tension, u, x, tau))
            if i < self.segments:
                tension = max(tension + tau * arc.width * step, 1e-9 * arc.exit_tension)
        return rows

    def at_once(self) -> tuple[float, Array] | None:
        """Global creep that meets the tensions and the rows of its walk; None where it fails.

        Newton's method for tensions and slips of all segments and the global creep together. Where
        friction falls past its peak two walks meet the same tensions: told is the one of which the
        ratio still grows with the global creep.
        """
        arc, n, law = self.arc, self.segments, self.arc.law
        shear, area, step = arc.lagging_compliance, arc.width * arc.radius, arc.length / n
        pull, remaining = arc.width * step, arc.length - step * np.arange(n)
        by_tension, by_share = remaining / arc.axial_stiffness, arc.side * remaining / arc.length
        ratio, share = arc.entry_tension / arc.exit_tension, _FIRST_SHARE
        tension = arc.exit_tension * ratio ** (np.arange(n + 1) / n)
        slip, change = np.zeros(n), math.inf
        for _ in range(_NEWTON_STEPS):
            pressure = tension[:-1] / area
            creep = (arc.entry_tension - tension[:-1]) * by_tension + by_share * share
            creep += arc.entry_overrun
            slip = np.where(slip * creep > 0.0, slip, _FIRST_SLIP * creep)
            stress = law.friction(slip, pressure) * pressure
            missing = creep - slip - shear * stress, pull * stress - np.diff(tension)
            if change < _SETTLED:
                break
            dx, dp = 1e-6 * np.abs(slip) + 1e-15, 1e-6 * pressure
            by_x = (law.friction(slip + dx, pressure) * pressure - stress) / dx
            by_p = (law.friction(slip, pressure + dp) * (pressure + dp) - stress) / dp
            stiff = 1.0 / (1.0 + shear * by_x)
            slack = by_tension + shear * by_p / area  # slip lost per tension, but for `stiff`
            # changes of the tensions: what is missing, and by the global creep
            grown = np.append(1.0, np.cumprod(1.0 + pull * (by_p / area - by_x * slack * stiff)))
            each = np.stack([missing[1] + pull * by_x * stiff * missing[0],
                             pull * by_x * stiff * by_share])  # fmt: skip
            own, of_share = grown * np.pad(np.cumsum(each / grown[1:], axis=1), ((0, 0), (1, 0)))
            more = (arc.entry_tension - tension[-1] - own[-1]) / of_share[-1]
            moved = own + more * of_share
            new = slip + (missing[0] - slack * moved[:-1] + by_share * more) * stiff
            slip = np.where(new * slip > 0.0, new, 0.1 * slip)
            tension = np.maximum(tension + moved, 1e-3 * arc.exit_tension)
            share += more
            change = float(np.max(np.abs(moved)) / arc.exit_tension + abs(more / share))
        sizes = np.max(np.abs(creep)), arc.exit_tension
        missed = [np.max(np.abs(m)) / size for m, size in zip(missing, sizes, strict=True)]
        if not (change < _SETTLED and max(missed) < 1e-12 and arc.side * of_share[-1] > 0.0):
            return None
        rows = np.stack([remaining, tension[:-1], creep, slip, stress], axis=1)
        tau, _, _, x = traction(self.law, shear, arc.entry_tension / area, arc.entry_overrun)
        return share, np.append(rows, [[0.0, tension[-1], arc.entry_overrun, x, tau]], axis=0)

    def result(self, name: str, share: float, rows: Array) -> ArcResult:
        """Complete result of a walk with a global creep towards the slack side [m]."""
        arc = self.arc
        remaining, tension, creep, slip, stress = rows[::-1].T
        position = remaining / arc.radius
        pressure = 2.0 * tension / (arc.width * arc.diameter)
        peak = int(np.argmax(np.abs(stress)))
        pull = arc.entry_tension - arc.exit_tension
        tested, outside = arc.law.tested, nan
        if tested is not None:
            out = (
                (pressure < tested.pressure_min)
                | (pressure > tested.pressure_max)
                | (np.abs(slip) > tested.slip_max)
            )
            outside = float(np.mean(out))
        change = np.abs(tension[0] - tension) / max(abs(pull), 1e-300)
        active = position[change > 0.01]
        work = float(np.sum(0.5 * (stress[1:] + stress[:-1]) * np.diff(slip)))
        profile = Profile(
            position=position,
            tension=tension,
            wrap_pressure=pressure,
            friction=arc.law.friction(slip, pressure),
            friction_used=stress / pressure,
            slip=slip,
            creep=creep,
            shear_stress=stress,
            shear_angle=np.arctan(stress / arc.shear_modulus),
            sliding=(np.abs(slip) > 0.0).astype(float),
        )
        top = float(abs(stress[peak]))
        return ArcResult(
            status=Status.SOLVED,
            method=name,
            arc=arc,
            profile=profile,
            entry_tension=float(tension[0]),
            exit_tension=arc.exit_tension,
            exit_creep=float(creep[-1]),
            creep_shrinkage=pull * arc.length / arc.axial_stiffness,
            creep_compression=arc.entry_overrun,
            creep_global=arc.side * share,
            exit_slip=float(slip[-1]),
            entry_creep_ratio=arc.side * share / arc.length,
            exit_creep_ratio=arc.side * share / arc.length + pull / arc.axial_stiffness,
            peak_shear_stress=top,
            peak_shear_angle=math.atan(top / arc.shear_modulus),
            peak_shear_position=float(position[peak]),
            mean_friction=abs(math.log(tension[0] / tension[-1])) / arc.wrap_angle,
            active_arc=arc.wrap_angle - float(active[0]) if len(active) else 0.0,
            outside_tested_share=outside,
            stuck_arc=0.0,
            capacities=Capacities(),
            energy=Energy(frictional_energy=work),
            steepest_slip=float(np.max(np.abs(np.diff(slip) / np.diff(remaining)), initial=0.0)),
        )
