"""Solve every pulley of a drive in every load case."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from wraparc.alike import largest
from wraparc.arc.result import ArcResult, Status
from wraparc.arc.solver import Distributed
from wraparc.arc.wrap_arc import WrapArc
from wraparc.drive import Drive
from wraparc.errors import BreakawayError, ConvergenceError
from wraparc.views import Viewable


class Method(Protocol):
    """What solves an arc: `Distributed` or `PaperMarch`."""

    @property
    def name(self) -> str:
        """Name in files and reports."""

    def solve(self, arc: WrapArc) -> ArcResult:
        """Solve one arc."""


@dataclass(frozen=True, eq=False)
class DriveResult(Viewable):
    """Results of every pulley in every load case, in the order of the drive.

    Attributes
    ----------
    drive
        What was solved.
    arcs
        One result for each load case and pulley, load case by load case.
    """

    drive: Drive
    arcs: tuple[ArcResult, ...]

    def __iter__(self) -> Iterator[ArcResult]:
        return iter(self.arcs)

    def __len__(self) -> int:
        return len(self.arcs)

    def arc(self, pulley: str, load_case: str = "") -> ArcResult:
        """Result of one pulley, in the running load case of the largest pull unless one is named.

        Raises
        ------
        KeyError
            If the drive has no such pulley or load case.
        """
        found = {result.arc.load_case: result for result in self if result.arc.pulley == pulley}
        name = load_case or self.drive.load_case().name
        if name not in found:
            raise KeyError((pulley, load_case))
        return found[name]

    @property
    def governing(self) -> ArcResult:
        """The result that is nearest to, or furthest beyond, its limits.

        An unsolved arc governs over a breakaway, a breakaway over a solved one; among breakaways
        the least margin to gross slip, among solved ones the largest creep over its limit.
        """

        def severity(result: ArcResult) -> tuple[float, float]:
            if result.status is Status.UNSOLVED:
                return 2.0, 0.0
            if result.status is Status.BREAKAWAY:
                margin = result.capacities.extrapolated_gross_slip_margin
                return 1.0, -margin if math.isfinite(margin) else 0.0
            return 0.0, result.share_of_limit

        worst = max(severity(result)[0] for result in self.arcs)
        return largest(
            (result for result in self.arcs if severity(result)[0] == worst),
            lambda result: severity(result)[1],
        )

    @property
    def solved(self) -> bool:
        """Whether every pulley carries its load in every load case."""
        return all(r.status.solved for r in self.arcs)

    @property
    def within_creep_limit(self) -> bool:
        """Whether, besides, every creep is within its limit."""
        return all(r.within_creep_limit for r in self.arcs)


def solve(
    drive: Drive, *, method: Method | None = None, raise_on_failure: bool = True
) -> DriveResult:
    """Solve a drive.

    Parameters
    ----------
    drive
        The drive, see `wraparc.load_drive`.
    method
        `Distributed()` unless given.
    raise_on_failure
        Raise if a pulley cannot carry its load; otherwise its result says so.

    Returns
    -------
    DriveResult
        One complete result for each load case and pulley.

    Raises
    ------
    InputError
        If a law is unfit for an arc.
    BreakawayError
        If a pulley cannot carry its load; the error carries the result.
    ConvergenceError
        If the solver did not reach its accuracy.
    """
    solver = Distributed() if method is None else method
    result = DriveResult(
        drive,
        tuple(
            solver.solve(WrapArc.of(drive, pulley, case))
            for case in drive.load_cases
            for pulley in drive.pulleys
        ),
    )
    if raise_on_failure and not result.solved:
        worst = result.governing
        where = f"pulley {worst.arc.pulley}, load case {worst.arc.load_case}"
        if worst.status is Status.BREAKAWAY:
            raise BreakawayError(f"{where}: {worst.status}", result)
        raise ConvergenceError(f"{where}: {worst.status}")
    return result
