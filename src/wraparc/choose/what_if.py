"""What if: the same pulley before and after a change, and why the answer moves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from wraparc.arc import ArcResult, Distributed, Method, WrapArc
from wraparc.drive import Drive


@dataclass(frozen=True)
class Change:
    """A drive after a change.

    Attributes
    ----------
    title
        What was changed, in a few words.
    drive
        The whole drive as it is then.
    note
        What to know about it, such as where a number came from.
    """

    title: str
    drive: Drive
    note: str = ""


@dataclass(frozen=True, eq=False)
class WhatIf:
    """One pulley in one load case, before and after changes.

    Attributes
    ----------
    drive
        The drive as it is.
    pulley, load_case
        Which.
    before
        The drive as it is, solved.
    changes
        What was changed.
    after
        The same pulley after each change.
    """

    drive: Drive
    pulley: str
    load_case: str
    before: ArcResult
    changes: tuple[Change, ...]
    after: tuple[ArcResult, ...]


def what_if(
    drive: Drive,
    pulley: str,
    load_case: str,
    changes: Sequence[Change],
    *,
    method: Method | None = None,
) -> WhatIf:
    """Solve one pulley in one load case before and after each change.

    Raises
    ------
    InputError
        If the drive has no such pulley or load case, or a law is unfit for an arc.
    """
    solver = Distributed() if method is None else method

    def solved(one: Drive) -> ArcResult:
        return solver.solve(WrapArc.of(one, one.pulley(pulley), one.load_case(load_case)))

    after = tuple(solved(change.drive) for change in changes)
    return WhatIf(drive, pulley, load_case, solved(drive), tuple(changes), after)
