"""What if: the same pulley before and after a change, and why the answer moves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from wraparc.arc import ArcResult, Distributed, DriveResult, Method, solve
from wraparc.drive import Drive
from wraparc.train import Train
from wraparc.train.as_drive import as_drive


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
    pulley, load_case
        Which.
    wholes
        The whole drive in that load case, solved: as it is, then after each change.
    changes
        What was changed.
    """

    pulley: str
    load_case: str
    wholes: tuple[DriveResult, ...]
    changes: tuple[Change, ...]

    @property
    def results(self) -> tuple[ArcResult, ...]:
        """The pulley as it is, then after each change."""
        return tuple(whole.arc(self.pulley, self.load_case) for whole in self.wholes)

    @property
    def before(self) -> ArcResult:
        """The pulley as it is."""
        return self.results[0]

    @property
    def after(self) -> tuple[ArcResult, ...]:
        """The pulley after each change."""
        return self.results[1:]


def redivided(train: Train, changed: Drive) -> Drive:
    """Return a changed drive with the load of its train divided anew.

    Belt and pulleys are those of the changed drive; the drums turn, or share, as in the train.

    Raises
    ------
    InputError
        If there is no such division.
    """
    return as_drive(
        replace(
            train,
            belt=changed.belt,
            pulleys=changed.pulleys,
            nominal_diameters=train.nominal,
        )
    )


def what_if(
    drive: Drive,
    pulley: str,
    load_case: str,
    changes: Sequence[Change],
    *,
    method: Method | None = None,
) -> WhatIf:
    """Solve a drive in one load case before and after each change.

    Raises
    ------
    InputError
        If the drive has no such pulley or load case, or a law is unfit for an arc.
    """
    solver = Distributed() if method is None else method

    def solved(one: Drive) -> DriveResult:
        case = one.load_case(load_case)
        one.pulley(pulley)
        return solve(replace(one, load_cases=(case,)), method=solver, raise_on_failure=False)

    wholes = tuple(solved(one) for one in (drive, *(change.drive for change in changes)))
    return WhatIf(pulley, load_case, wholes, tuple(changes))
