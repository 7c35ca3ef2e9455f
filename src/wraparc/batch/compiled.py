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
from wraparc.arc.kernel.answer import (
    CAPACITIES,
    Answer,
    Carried,
    answer,
    profile_of,
    profile_size,
)
from wraparc.arc.kernel.layers import NO_LAYERS
from wraparc.arc.kernel.quantities import RECORD, SOLVED, Shot, parameters_at, zeros
from wraparc.arc.solver import capacities_of, result_of
from wraparc.batch import row
from wraparc.batch.laws import LawBank
from wraparc.batch.native import available, compiled
from wraparc.batch.precise import capacity_rows, law_of
from wraparc.friction import FrictionLaw

_ROOM = 2_000  # records of a profile that there is room for at first


def solve_one(given: Any, bank: Any, steps: int, points: int, out: Any, found: Any) -> int:
    """Solve an arc and trace its profile, as `Distributed.solve` does; compiled only.

    Parameters
    ----------
    given
        Its numbers, in the order of `wraparc.batch.row.INPUTS`, shape (16,).
    bank
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
    law, load = law_of(bank, 0), row.load_of(given)
    solved = answer(law, row.geometry_of(given), load, steps)
    if solved.outcome != SOLVED:
        return 0
    size = profile_size(law, solved, points)
    if size > len(out):
        return -size
    records = zeros(size)
    shot, count = profile_of(law, solved, load.exit_tension, points, records)
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
        bank, given = _bank(arc.law).arrays, np.array((*arc.geometry(), *arc.load()))
        kernel, found = compiled(solve_one), np.zeros(len(Shot._fields))
        out = np.zeros(RECORD * _ROOM)
        count = int(kernel(given, bank, self.steps, self.points, out, found))
        if count < 0:
            out = np.zeros(-count)
            count = int(kernel(given, bank, self.steps, self.points, out, found))
        capacities = self._capacities(arc, given, bank) if self.capacities else Capacities()
        if not count:  # a breakaway: what is left to tell of it is not worth compiling
            plain = Distributed(self.steps, self.points, capacities=False)
            return replace(plain.solve(arc), capacities=capacities)
        par = parameters_at(arc.entry_tension, arc.geometry())
        solved = Answer(SOLVED, par, 0.0, Shot(*found.tolist()), NO_LAYERS, self.steps)
        records = out[: RECORD * count].tolist()
        return result_of(self.name, arc, solved, records, count, capacities)

    def _capacities(self, arc: WrapArc, given: Any, bank: Any) -> Capacities:
        rows = np.full((1, row.FOUND_NUMBERS), math.nan)
        rows[0, row.OUTCOME] = SOLVED
        which, wanted = np.zeros(1, dtype=np.int64), np.array([CAPACITIES], dtype=np.int64)
        compiled(capacity_rows)(given[None, :], bank, which, wanted, self.steps, rows)
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
