"""Sag of the slack belt between idlers: a lower bound of its tension beside creep."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from wraparc.drive import Limit
from wraparc.schema.limits import limit_problems, raise_all

#: Standard acceleration of gravity [m/s2].
GRAVITY = 9.80665
#: Sag over idler spacing that is customary [-].
CUSTOMARY = 0.02
SOURCE = (
    "belt sag: T = m' g l/(8 h), a parabola; the rule of DIN 22101 and of CEMA, Belt Conveyors for "
    "Bulk Materials (6.25 S W for 2 %, 4.2 S W for 3 %)"
)


@dataclass(frozen=True, kw_only=True)
class Sag:
    """How far the slack belt may sag between the idlers that follow the pulley.

    Parameters
    ----------
    spacing
        Distance l of the idlers [m].
    line_mass
        Mass m' of what hangs between them per length of belt: the empty belt on a return strand,
        belt and load on a carrying one [kg/m].
    share
        Largest sag over spacing h [-].

    Raises
    ------
    InputError
        With every number outside its limit.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "spacing": Limit("length", open=True, most=100.0),
        "line_mass": Limit("mass_per_length", open=True, most=10_000.0),
        "share": Limit("number", open=True, most=0.1),
    }

    spacing: float
    line_mass: float
    share: float = CUSTOMARY

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))

    @property
    def tension(self) -> float:
        """Least tension, m' g l/(8 h) [N]."""
        return self.line_mass * GRAVITY * self.spacing / (8.0 * self.share)
