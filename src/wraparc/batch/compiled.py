"""One arc by the compiled kernel: what `wraparc.arc.Distributed` answers, many times faster.

For a server that solves arc after arc. The first use in a process loads compiled code, and the
first on a machine makes it, which takes a minute; see `prepare`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from wraparc.arc import ArcResult, Capacities, Distributed, Status, WrapArc
from wraparc.arc.kernel.capacity import STUCK, parameters_at, profile_size, solve_tension, trace
from wraparc.arc.kernel.march import RECORD, room
from wraparc.arc.kernel.shoot import FOUND
from wraparc.arc.solver import BALANCE, result_of
from wraparc.batch import row
from wraparc.batch.laws import LawBank
from wraparc.batch.native import available, compiled
from wraparc.batch.precise import capacity_rows, law_of
from wraparc.friction import FrictionLaw

nan = math.nan
_ROOM = 2_000  # records of a profile that there is room for at first


def solve_one(
    given: Any, kinds: Any, numbers: Any, places: Any, steps: int, points: int, out: Any, found: Any
) -> int:
    """Solve an arc and trace its profile, as `Distributed.solve` does; compiled only.

    Parameters
    ----------
    given
        Its numbers, in the order of `wraparc.batch.arcs.INPUTS`, shape (16,).
    kinds, numbers, places
        A bank of one law.
    steps, points
        Mesh steps, and equal parts of the wrap in the profile.
    out
        Takes the records of the profile.
    found
        Takes the shot, shape (7,).

    Returns
    -------
    Records of the profile; 0 if the arc is not solved; negative: the room that `out` needs.
    """
    law = law_of(kinds, numbers, places, 0)
    geometry = row.geometry_of(given)
    entry, exit_tension = given[9], given[10]
    par = parameters_at(entry, geometry)
    none = room(0)
    outcome, z, shot = solve_tension(law, par, exit_tension, steps, none)
    if (outcome not in (FOUND, STUCK)) or not abs(
        entry * math.exp(shot[0]) / exit_tension - 1.0
    ) <= BALANCE:
        return 0
    size = profile_size(law, par, steps, points)
    if size > len(out):
        return -size
    records = room(size)
    count = points + 1
    if z > -math.inf:
        shot, count = trace(law, par, exit_tension, z, steps, points, records)
    else:
        for i in range(count):
            records[RECORD * i] = given[1] * given[2] * i / points
    for i in range(RECORD * count):
        out[i] = records[i]
    for i in range(7):
        found[i] = shot[i]
    return count


@lru_cache(maxsize=64)
def _bank(law: FrictionLaw) -> LawBank:
    return LawBank.of([law])


@dataclass(frozen=True)
class Compiled:
    """`wraparc.arc.Distributed` with its kernel compiled.

    Attributes
    ----------
    steps, points, capacities
        As there.
    """

    steps: int = 24
    points: int = 180
    capacities: bool = True

    @property
    def name(self) -> str:
        """Name in files and reports: the method is the same."""
        return "distributed"

    def solve(self, arc: WrapArc) -> ArcResult:
        """Solve one arc; see `wraparc.arc.Distributed`."""
        bank, given, law = _bank(arc.law), _given(arc), arc.compact_law()
        kernel, found = compiled(solve_one), np.zeros(7)
        parts = (bank.kind, bank.numbers, bank.places)
        out = np.zeros(RECORD * _ROOM)
        count = int(kernel(given, *parts, self.steps, self.points, out, found))
        if count < 0:
            out = np.zeros(-count)
            count = int(kernel(given, *parts, self.steps, self.points, out, found))
        capacities = self._capacities(arc, given, parts) if self.capacities else Capacities()
        if not count:  # a breakaway: what is left to tell of it is not worth compiling
            plain = Distributed(self.steps, self.points, capacities=False)
            return replace(plain.solve(arc), capacities=capacities)
        return result_of(
            self.name,
            arc,
            law,
            parameters_at(arc.entry_tension, arc.geometry()),
            Status.SOLVED,
            tuple(found.tolist()),  # type: ignore[arg-type]
            out[: RECORD * count].tolist(),
            count,
            capacities,
        )

    def _capacities(self, arc: WrapArc, given: Any, parts: tuple[Any, ...]) -> Capacities:
        rows = np.full((1, row.FOUND_NUMBERS), nan)
        rows[0, row.OUTCOME] = row.SOLVED
        which, wanted = np.zeros(1, dtype=np.int64), np.array([row.CAPACITIES], dtype=np.int64)
        compiled(capacity_rows)(given[None, :], *parts, which, wanted, self.steps, rows)
        found = rows[0].tolist()
        ratios = [math.exp(found[k]) for k in (row.CREEP_CAPACITY, row.SLIP_CAPACITY)]
        gross = math.exp(found[row.GROSS_CAPACITY])
        actual = max(arc.entry_tension, arc.exit_tension)
        actual /= min(arc.entry_tension, arc.exit_tension)
        creep, slip = ratios
        return Capacities(
            creep_limit_capacity=creep,
            creep_limit_margin=creep / actual,
            equivalent_friction=math.log(creep) / arc.wrap_angle,
            least_exit_tension=found[row.LEAST_SLACK],
            largest_effective_tension=found[row.MOST_PULL],
            tested_slip_capacity=slip,
            tested_slip_margin=slip / actual,
            gross_slip_capacity=gross,
            gross_slip_margin=gross / actual,
            gross_slip_creep=found[row.GROSS_CREEP],
        )


def _given(arc: WrapArc) -> Any:
    tested = arc.law.tested
    ends = (nan,) * 3
    if tested is not None:
        ends = (tested.pressure_min, tested.pressure_max, tested.slip_max)
    numbers = (*arc.geometry(), arc.entry_tension, arc.exit_tension, arc.creep_limit, *ends)
    return np.array((*numbers, arc.law.steepest_fall()), dtype=float)


def prepare() -> bool:
    """Make or load the compiled code; False where nothing can be compiled."""
    if not available():
        return False
    from wraparc.friction import Constant

    arc = WrapArc(
        law=Constant(friction_coefficient=0.3),
        entry_tension=2e4,
        exit_tension=1e4,
        diameter=0.5,
        wrap_angle=math.pi,
        width=1.0,
        axial_stiffness=1e7,
        thickness=0.01,
        shear_modulus=2e6,
    )
    Compiled().solve(arc)
    return True
