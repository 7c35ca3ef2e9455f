"""Factors on a tested friction law: slip speed, temperature, and conditions such as dirt.

Tests run at a tenth of a millimetre a second and at room temperature, belts slip a hundred times
faster on pulleys in frost and sun. What that does to friction is a small table of its own, measured
or published, and the law that a drive is solved with is the tested one times the factor. Where a
drive does not say at what speed and temperature, the least factor of the table counts.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import ClassVar

from wraparc.errors import Problem, shown
from wraparc.friction import FrictionLaw, MeasuredTable
from wraparc.provenance import Provenance
from wraparc.schema.limits import Limit, limit_problems, raise_all
from wraparc.units import Dimension, display


@dataclass(frozen=True, kw_only=True)
class FrictionFactor:
    """Friction over that of the tested law, in dependence on one quantity.

    Parameters
    ----------
    at
        Values of the quantity, ascending, shape (n,), n >= 2 [SI].
    factor
        Factors there, > 0, shape (n,) [-]; straight lines between them.
    source
        Where they came from.
    """

    at: tuple[float, ...]
    factor: tuple[float, ...]
    source: Provenance

    def __post_init__(self) -> None:
        n, problems = len(self.at), list[Problem]()
        if n < 2 or len(self.factor) != n:
            count = f"{n} values and {len(self.factor)} factors"
            message = "must be as many factors as values, two at least"
            problems.append(Problem(key="factor", value=count, message=message))
        if any(after <= before for before, after in pairwise(self.at)):
            problems.append(Problem(key="at", value=shown(list(self.at)), message="must ascend"))
        bad = [v for v in self.factor if not 0.0 < v <= 10.0]
        if bad:
            message = "must be more than 0 and at most 10"
            problems.append(Problem(key="factor", value=shown(bad[0]), message=message))
        raise_all(problems)

    def least(self, low: float, high: float) -> float:
        """Return the least factor between two values of the quantity [-]."""
        inside = [f for x, f in zip(self.at, self.factor, strict=True) if low <= x <= high]
        return min([*inside, self._of(low), self._of(high)])

    def _of(self, value: float) -> float:
        """Return the factor at a value of the quantity, that of the ends beyond them [-]."""
        rows = list(zip(self.at, self.factor, strict=True))
        for (x, f), (x1, f1) in pairwise(rows):
            if x <= value < x1:
                return (f1 - f) / (x1 - x) * (value - x) + f
        return self.factor[0] if value < self.at[0] else self.factor[-1]


@dataclass(frozen=True, kw_only=True)
class Factors:
    """The factors on a tested law, and the speed and temperature that it is used at.

    Parameters
    ----------
    law
        As tested.
    by_slip_speed, by_temperature
        The factors over slip speed [m/s] and temperature [K], or None.
    slip_speed
        Largest slip speed it is used at [m/s]; None for the largest of the table.
    temperature
        Temperature it is used at [K]; None for any of the table.

    Raises
    ------
    InputError
        If speed or temperature lie outside their table, or there is no table for them.
    """

    law: FrictionLaw
    by_slip_speed: FrictionFactor | None = None
    by_temperature: FrictionFactor | None = None
    slip_speed: float | None = None
    temperature: float | None = None

    def __post_init__(self) -> None:
        raise_all(
            [
                *_outside("slip_speed", self.slip_speed, self.by_slip_speed, "speed"),
                *_outside("temperature", self.temperature, self.by_temperature, "temperature"),
            ]
        )

    @property
    def fastest(self) -> float | None:
        """Slip speed up to which the law is used [m/s], or None without a factor of it."""
        table = self.by_slip_speed
        return None if table is None else self.slip_speed or table.at[-1]

    @property
    def of_slip_speed(self) -> float:
        """Least factor up to the largest slip speed [-]."""
        table, fastest = self.by_slip_speed, self.fastest
        return 1.0 if table is None or fastest is None else table.least(table.at[0], fastest)

    @property
    def of_temperature(self) -> float:
        """Factor at the temperature, the least of the table where it is not said [-]."""
        table = self.by_temperature
        if table is None:
            return 1.0
        if self.temperature is not None:
            return table.least(self.temperature, self.temperature)
        return min(table.factor)

    @property
    def used(self) -> FrictionLaw:
        """The law that a drive is solved with; its tests reach to the largest slip speed."""
        law = self.law.scaled(self.of_slip_speed * self.of_temperature)
        tested, fastest = law.tested, self.fastest
        if tested is None or fastest is None or isinstance(law, MeasuredTable):
            return law  # a table of friction says nothing of speed
        return replace(law, tested=replace(tested, slip_speed=fastest))  # type: ignore[call-arg]

    @property
    def sources(self) -> dict[str, Provenance]:
        """Where the factors came from, by their keys."""
        tables = {
            "slip_speed_factor": self.by_slip_speed, "temperature_factor": self.by_temperature
        }  # fmt: skip
        return {key: table.source for key, table in tables.items() if table is not None}


def _outside(
    key: str, value: float | None, table: FrictionFactor | None, dimension: Dimension
) -> list[Problem]:
    """Return what is wrong with a speed or temperature, by the table of its factors."""
    if value is None:
        return []
    if table is None:
        message = f"the law has no {key}_factor"
        remedy = f"Leave it out, or add [law.{key}_factor]."
        return [Problem(key=key, value=display(value, dimension), message=message, remedy=remedy)]
    low, high = (0.0 if key == "slip_speed" else table.at[0]), table.at[-1]
    if low <= value <= high:
        return []
    ends = f"{display(table.at[0], dimension)} and {display(high, dimension)}"
    message = f"must be between {ends}, where its factor is known"
    return [Problem(key=key, value=display(value, dimension), message=message,
                    remedy="Test the lagging there.")]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class ConditionFactor:
    """Friction of a lagging in a condition over that of its tests.

    Parameters
    ----------
    factor
        > 0 [-].
    source
        Where it came from.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {"factor": Limit("number", open=True, most=10.0)}

    factor: float
    source: Provenance

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))
