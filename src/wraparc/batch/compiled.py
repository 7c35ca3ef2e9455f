"""One arc by the compiled kernel: what `wraparc.arc.Distributed` answers, many times faster.

For a server that solves arc after arc. The first use in a process loads compiled code, and the
first on a machine makes it, which takes a minute; see `prepare`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from wraparc.arc import ArcResult, Capacities, Distributed, Profile, WrapArc
from wraparc.arc.kernel.answer import CAPACITIES, GROSS_SLIP, Answer, Carried
from wraparc.arc.kernel.layers import NO_LAYERS
from wraparc.arc.kernel.quantities import RECORD, SOLVED, Geometry, Shot, parameters_at
from wraparc.arc.solver import capacities_of, solved_result
from wraparc.arc.summary import Columns, Description, Summary, columns_of, summary_of
from wraparc.batch import row
from wraparc.batch.laws import bank_of, law_of, tested_ends
from wraparc.batch.native import available, compiled
from wraparc.batch.precise import capacity_rows, tension_rows

_ROOM = 2_000  # records of a profile that there is room for at first
_CARRIED = (  # where a row has it
    row.CREEP_CAPACITY,
    row.SLIP_CAPACITY,
    row.GROSS_CAPACITY,
    row.GROSS_CREEP,
    row.LEAST_SLACK,
    row.MOST_PULL,
)
_UNKNOWN = np.full((1, row.STARTS), math.nan)


class _Ends(NamedTuple):
    """The tested range as compiled code reads it; nan without one."""

    pressure_min: float
    pressure_max: float
    slip_max: float


def read_off(
    bank: Any,
    geometry: Geometry,
    arc: Description,
    tested: Any,
    found: Any,
    steps: int,
    out: Any,
    count: int,
) -> tuple[Summary, Columns]:
    """Read the numbers and the profile of a solved arc off its records; compiled only."""
    law, par = law_of(bank, 0), parameters_at(arc.entry_tension, geometry)
    shot = Shot(
        found[row.LOG_RATIO],
        found[row.EXIT_SLIP],
        found[row.EXIT_CREEP],
        found[row.EXIT_STRESS],
        found[row.WORK],
        found[row.CREEP_RATIO],
        found[row.STUCK_LENGTH],
    )
    solved = Answer(SOLVED, par, 0.0, shot, NO_LAYERS, steps)
    told = summary_of(law, arc, tested, solved, out, count)
    return told, columns_of(law, arc, solved, out, count)


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
        bank, given = _numbers(arc)
        found, out, count = self._operating_point(given, bank)
        capacities = Capacities()
        if self.capacities:
            capacities = capacities_of(arc, _carried(arc, CAPACITIES, self.steps))
        if not count:  # a breakaway: what is left to tell of it is not worth compiling
            plain = Distributed(self.steps, self.points, capacities=False)
            return replace(plain.solve(arc), capacities=capacities)
        told, columns = compiled(read_off)(
            bank,
            arc.geometry(),
            arc.described(),
            _Ends(*tested_ends(arc.law)),
            found,
            self.steps,
            out,
            count,
        )
        if arc.law.tested is None:
            told = told._replace(outside_tested_share=math.nan)
        return solved_result(self.name, arc, told, Profile(*columns), capacities)

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


def largest_log(arc: WrapArc, steps: int) -> float:
    """Return ln(tight/slack) at gross slip with the tight side held [-]."""
    return _carried(arc, GROSS_SLIP, steps).gross_slip


def _numbers(arc: WrapArc) -> tuple[Any, Any]:
    """Law and numbers of an arc, as compiled code reads them."""
    return bank_of(arc.law.compact()), np.array([(*arc.geometry(), *arc.load())])


def _carried(arc: WrapArc, parts: int, steps: int) -> Carried:
    bank, given = _numbers(arc)
    rows = np.full((1, row.FOUND_NUMBERS), math.nan)
    rows[0, row.OUTCOME] = SOLVED
    which, wanted = np.zeros(1, dtype=np.int64), np.array([parts], dtype=np.int64)
    compiled(capacity_rows)(given, bank, which, wanted, steps, rows, _UNKNOWN)
    return Carried(*rows[0, _CARRIED].tolist())


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
