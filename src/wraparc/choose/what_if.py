"""What if: the same pulley before and after a change, and why the answer moves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from wraparc.arc import ArcResult, DriveResult, Method
from wraparc.checks import judge
from wraparc.drive import Drive
from wraparc.train import Train
from wraparc.train.whole import Described, Whole, by_pulley, solved


@dataclass(frozen=True)
class Change:
    """A drive after a change.

    Attributes
    ----------
    title
        What was changed, in a few words.
    drive
        The whole drive as it is then, or the train.
    note
        What to know about it, such as where a number came from.
    """

    title: str
    drive: Described
    note: str = ""


@dataclass(frozen=True, eq=False)
class WhatIf:
    """One pulley in one load case, before and after changes.

    Attributes
    ----------
    pulley, load_case
        Which.
    wholes
        The whole drive in all its load cases, solved: as it is, then after each change.
    changes
        What was changed.
    """

    pulley: str
    load_case: str
    wholes: tuple[Whole, ...]
    changes: tuple[Change, ...]

    @cached_property
    def drives(self) -> tuple[DriveResult, ...]:
        """The same pulley by pulley."""
        return tuple(map(by_pulley, self.wholes))

    @cached_property
    def results(self) -> tuple[ArcResult, ...]:
        """The pulley as it is, then after each change."""
        return tuple(drive.arc(self.pulley, self.load_case) for drive in self.drives)

    @property
    def before(self) -> ArcResult:
        """The pulley as it is."""
        return self.results[0]

    @property
    def after(self) -> tuple[ArcResult, ...]:
        """The pulley after each change."""
        return self.results[1:]


def redivided(train: Train, changed: Drive) -> Train:
    """Return a train with belt and pulleys of a changed drive: it divides its load anew.

    The drums turn, or share, as in the train.
    """
    return replace(
        train, belt=changed.belt, pulleys=changed.pulleys, nominal_diameters=train.nominal
    )


def what_if(
    drive: Described,
    pulley: str,
    load_case: str | None,
    changes: Sequence[Change],
    *,
    method: Method | None = None,
) -> WhatIf:
    """Solve a drive in all its load cases before and after each change, to compare one arc.

    Where no load case is named it is that of the check that is missed, if it is of the pulley.

    Raises
    ------
    InputError
        If the drive has no such pulley or load case, or a law is unfit for an arc.
    """
    wholes = (solved(one, method) for one in (drive, *(change.drive for change in changes)))
    found = WhatIf(pulley, load_case or "", tuple(wholes), tuple(changes))
    if load_case is None:
        found = replace(found, load_case=_missed(found))
    for whole in found.drives:
        whole.drive.pulley(pulley)
        whole.drive.load_case(found.load_case)
    return found


def _missed(found: WhatIf) -> str:
    """Load case of the check that is missed at the pulley, in all drives; else the usual one."""
    worst = judge(found.wholes[0]).governing
    if worst is not None and worst.missed and worst.place.pulley == found.pulley:
        case = worst.place.load_case
        if all(case in {c.name for c in whole.drive.load_cases} for whole in found.drives):
            return case
    return found.drives[0].drive.load_case(None).name
