"""What to do about a verdict, as data: changes of the drive, tried before they are offered."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Change:
    """One value of a drive, before and after.

    Attributes
    ----------
    key
        Of the drive file, with the name of its owner: ``pulley.head.lagging``.
    before, after
        A number [SI] or a name.
    unit
        The SI unit of a number; None of a name and of a number without one.
    """

    key: str
    before: float | str
    after: float | str
    unit: str | None = None


@dataclass(frozen=True)
class Way:
    """Changes that are made together.

    Attributes
    ----------
    changes
        All of them.
    proved
        Whether the drive was solved and judged with them.
    left
        How many checks are missed with them; 0 where the whole verdict is OK.
    text
        One imperative sentence that stands alone: ``Raise T2 from 50 to 84.1 kN.`` Its quantities
        are cells.
    """

    changes: tuple[Change, ...]
    proved: bool
    left: int
    text: str


@dataclass(frozen=True)
class Action:
    """What to do about a verdict.

    Attributes
    ----------
    text
        One imperative sentence of at most 20 words, of all the ways that it offers. Its quantities
        are cells.
    ways
        What it offers, the first first; none where data are missing or nothing was calculated.
    """

    text: str
    ways: tuple[Way, ...] = ()
