"""The main solver: creep distributed along the arc."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

import numpy as np

from wraparc.arc.answer import Answer
from wraparc.arc.capacity import CAPACITIES, Carried, find_capacities
from wraparc.arc.profile import RECORD, steepest_slip
from wraparc.arc.quantities import BREAKAWAY, SOLVED, Buffer
from wraparc.arc.result import ArcResult, Capacities, Energy, Profile, Status
from wraparc.arc.summary import NEXT_SLIP, Summary, capacity_numbers, solved_arc, summary_of
from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Array

nan = math.nan
#: Numbers that a result has from others of it.
DERIVED = ("effective_tension", "tension_ratio", "k_factor")
_ENERGY = tuple(f.name for f in fields(Energy))


@dataclass(frozen=True)
class Distributed:
    """Creep distributed along the arc: a two-point problem, by collocation to 1e-7 of the creep.

    Attributes
    ----------
    points
        Equal parts of the wrap at which the profile is given, besides kinks of the law.
    capacities
        Whether the three capacities are found too.
    """

    points: int = 180
    capacities: bool = True

    @property
    def name(self) -> str:
        """Name in files and reports."""
        return "distributed"

    def solve(self, arc: WrapArc) -> ArcResult:
        """Solve one arc.

        Raises
        ------
        InputError
            If the law is unfit for the arc, see `WrapArc`.
        """
        law, geometry, load = arc.law.compact(), arc.geometry(), arc.load()
        found, out, count = solved_arc(law, geometry, load, self.points)
        capacities = Capacities()
        if self.capacities:
            carried = find_capacities(law, geometry, load, CAPACITIES)
            capacities = capacities_of(arc, carried)
        return result_of(self.name, arc, found, out, count, capacities)


def capacities_of(arc: WrapArc, carried: Carried) -> Capacities:
    """Capacities and margins as an engineer reads them."""
    told = capacity_numbers(arc.described(), carried)
    return Capacities(**told._asdict())


def result_of(
    method: str,
    arc: WrapArc,
    found: Answer,
    out: Buffer,
    count: int,
    capacities: Capacities,
) -> ArcResult:
    """Return the result of an arc that the kernel has answered, and traced where it is solved."""
    if found.outcome != SOLVED:
        status = Status.BREAKAWAY if found.outcome == BREAKAWAY else Status.UNSOLVED
        return ArcResult.without_state(status, method, arc, capacities)
    told = summary_of(arc.geometry(), arc.described(), arc.law.tested, found)
    profile = _profile(arc, out, count, found.met.rest)
    steepest = steepest_slip(arc.geometry(), found.met)
    return solved_result(method, arc, told, profile, capacities, steepest)


def solved_result(
    method: str,
    arc: WrapArc,
    told: Summary,
    profile: Profile,
    capacities: Capacities,
    steepest_slip: float,
) -> ArcResult:
    """Return the result of a solved arc."""
    numbers = told._asdict()
    energy = Energy(**{name: numbers.pop(name) for name in _ENERGY})
    for name in DERIVED:
        del numbers[name]
    return ArcResult(
        status=Status.SOLVED,
        method=method,
        arc=arc,
        profile=profile,
        capacities=capacities,
        energy=energy,
        steepest_slip=steepest_slip,
        **numbers,
    )


def _profile(arc: WrapArc, out: Buffer, count: int, rest: float) -> Profile:
    rows: Array = np.array(out[: RECORD * count]).reshape(count, RECORD)
    s, q, slip, creep, tau = rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3], rows[:, 4]
    lift = arc.centrifugal
    tension = (arc.entry_tension - lift) * np.exp(q) + lift
    pressure = 2.0 * (tension - lift) / (arc.width * arc.diameter)
    # a stuck belt has the friction of vanishing slip available
    sliding = ((s > rest) | (rest == 0.0)) & ((slip != 0.0) | (tau == 0.0))
    tiny = np.copysign(NEXT_SLIP, np.where(tau == 0.0, arc.side, tau))
    friction = arc.law.friction(np.where(sliding, slip, tiny), pressure)
    return Profile(
        position=s / arc.radius,
        tension=tension,
        wrap_pressure=pressure,
        friction=friction,
        friction_used=tau / pressure,
        slip=slip,
        creep=creep,
        shear_stress=tau,
        shear_angle=np.arctan(tau / arc.shear_modulus),
        sliding=sliding.astype(float),
    )
