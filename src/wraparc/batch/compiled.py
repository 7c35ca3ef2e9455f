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

from wraparc.arc import ArcResult, Capacities, Distributed, WrapArc
from wraparc.arc.kernel.answer import CAPACITIES, Answer, Carried
from wraparc.arc.kernel.layers import NO_LAYERS
from wraparc.arc.kernel.quantities import RECORD, SOLVED, Shot, parameters_at
from wraparc.arc.solver import capacities_of, result_of
from wraparc.batch import row
from wraparc.batch.laws import LawBank
from wraparc.batch.native import available, compiled
from wraparc.batch.precise import capacity_rows, tension_rows
from wraparc.friction import FrictionLaw

_ROOM = 2_000  # records of a profile that there is room for at first
_UNKNOWN = np.full((1, row.STARTS), math.nan)
_SHOT = (  # where a row has it
    row.LOG_RATIO,
    row.EXIT_SLIP,
    row.EXIT_CREEP,
    row.EXIT_STRESS,
    row.WORK,
    row.CREEP_RATIO,
    row.STUCK_LENGTH,
)


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
        bank, given = _bank(arc.law).arrays, np.array([(*arc.geometry(), *arc.load())])
        found, out, count = self._operating_point(given, bank)
        capacities = self._capacities(arc, given, bank) if self.capacities else Capacities()
        if not count:  # a breakaway: what is left to tell of it is not worth compiling
            plain = Distributed(self.steps, self.points, capacities=False)
            return replace(plain.solve(arc), capacities=capacities)
        par = parameters_at(arc.entry_tension, arc.geometry())
        solved = Answer(SOLVED, par, 0.0, Shot(*found[_SHOT,].tolist()), NO_LAYERS, self.steps)
        records = out[: RECORD * count].tolist()
        return result_of(self.name, arc, solved, records, count, capacities)

    def _operating_point(self, given: Any, bank: Any) -> tuple[Any, Any, int]:
        """Row of results, profile and its number of records, 0 where the arc is not solved."""
        found, out = np.empty((1, row.FOUND_NUMBERS)), np.empty(RECORD * _ROOM)
        which, wanted = np.zeros(1, dtype=np.int64), np.array([row.TENSIONS], dtype=np.int64)
        kernel, mesh = compiled(tension_rows), (self.steps, self.points)
        count = int(kernel(given, bank, which, wanted, mesh, found, out, _UNKNOWN))
        if RECORD * count > len(out):
            out = np.empty(RECORD * count)
            kernel(given, bank, which, wanted, mesh, found, out, _UNKNOWN)
        return found[0], out, count

    def _capacities(self, arc: WrapArc, given: Any, bank: Any) -> Capacities:
        rows = np.full((1, row.FOUND_NUMBERS), math.nan)
        rows[0, row.OUTCOME] = SOLVED
        which, wanted = np.zeros(1, dtype=np.int64), np.array([CAPACITIES], dtype=np.int64)
        compiled(capacity_rows)(given, bank, which, wanted, self.steps, rows, _UNKNOWN)
        places = (
            row.CREEP_CAPACITY,
            row.SLIP_CAPACITY,
            row.GROSS_CAPACITY,
            row.GROSS_CREEP,
            row.LEAST_SLACK,
            row.MOST_PULL,
        )
        return capacities_of(arc, Carried(*rows[0, places].tolist()))


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
