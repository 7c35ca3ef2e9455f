"""The conditions that a drive is solved in: read from its file, or asked for from outside."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from wraparc.drive import Drive, Lagging, repeated
from wraparc.drive.conditions import DRY, Condition
from wraparc.errors import InputError, input_error, shown
from wraparc.files.drive_keys import CONDITION
from wraparc.provenance import Provenance
from wraparc.schema.origins import own_provenance
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.source import Document
from wraparc.schema.tables import Record
from wraparc.units import parse_number

_Case = TypeVar("_Case", bound=Any)  # of a drive or of a train


@dataclass(frozen=True)
class Conditions:
    """The conditions that a drive file asks for.

    Attributes
    ----------
    main
        Those of the drive, each with its place; none for that of each lagging.
    cases
        Those that single load cases name.
    """

    main: tuple[tuple[Condition, Place], ...] = ()
    cases: tuple[tuple[Condition, Place], ...] = ()

    @property
    def several(self) -> tuple[tuple[Condition, Place], ...]:
        """Conditions that load cases differ by."""
        return (*(self.main if len(self.main) > 1 else ()), *self.cases)


def build_conditions(record: Record, report: Report) -> Conditions:
    """Return the conditions of a drive file; what is wrong is reported."""
    rows = [row for row in record.get("condition", ()) if row is not NOTHING]
    main = [(condition_of(row, report), ("condition",)) for row in rows]
    for problem in repeated("condition", (condition.name for condition, _ in main)):
        report.take(InputError(problem), ())
    cases = [
        (condition_of(case["condition"], report), (*case.place, "condition"))
        for case in record.get("load_case") or ()
        if isinstance(case, Record) and "condition" in case
    ]
    return Conditions(tuple(main), tuple(cases))


def condition_of(value: Any, report: Report) -> Condition:
    """Return the condition of a name or of a table; one without a name after reporting."""
    if not isinstance(value, Record):
        return Condition(name=str(value))
    factors = value.get("friction_factors", {})
    source = own_provenance(value, report) or Provenance()
    made: Condition | None = CONDITION.built(value, report, factors=factors, source=source)
    return made or Condition(name=str(value.get("name", DRY)))


def at_its_place(condition: Condition, laws: tuple[Lagging, ...]) -> Lagging:
    """Return a lagging in a condition; errors are those of the place that asked for it."""
    try:
        return condition.of(laws)
    except InputError as error:
        raise InputError(
            replace(p, key="", value=shown(condition.name)) for p in error.problems
        ) from None


def condition_name(case: Record) -> str:
    """Return the name of the condition of a load case, empty where it names none."""
    value = case.get("condition", "")
    return str(value.get("name", "")) if isinstance(value, Record) else str(value)


def in_each_condition(cases: Sequence[_Case], conditions: Conditions) -> tuple[_Case, ...]:
    """Return load cases, those that name no condition once for each of several of the drive."""
    names = [condition.name for condition, _ in conditions.main]
    if len(names) < 2:
        return tuple(cases)
    found: list[_Case] = []
    for case in cases:
        split = [replace(case, name=f"{case.name}, {name}", condition=name) for name in names]
        found += [case] if case.condition else split
    return tuple(found)


def refuse_several(drive: Drive, what: str) -> None:
    """Refuse a drive whose load cases have conditions of their own, where one is needed.

    Raises
    ------
    InputError
        If there are such conditions.
    """
    if drive.conditions:
        raise input_error(
            key="condition",
            value=shown(list(drive.conditions)),
            message=f"{what} a drive in one condition",
            remedy='Write one, such as condition = "wet".',
        )


def asking(document: Document, conditions: Iterable[str]) -> Document:
    """Return a drive document that asks for conditions, whatever it says of them itself.

    Parameters
    ----------
    document
        Of a drive file; it is not changed.
    conditions
        Names, or ``NAME=FACTOR`` with the friction over that tested.

    Raises
    ------
    InputError
        If one has no name, or its factor is no number.
    """
    named = [_asked(text.strip()) for text in conditions]

    def without(rows: Any) -> Any:
        if not isinstance(rows, list):
            return rows
        return [
            {k: v for k, v in row.items() if k != "condition"} if isinstance(row, dict) else row
            for row in rows
        ]

    own: Document = {
        key: without(document[key]) for key in ("pulley", "load_case") if key in document
    }
    return {**document, **own, "condition": named}


def _asked(text: str) -> Any:
    name, equals, factor = (part.strip() for part in text.partition("="))
    if not name:
        message, remedy = "a condition without a name", "Write dry,wet or dry,dusty=0.8."
        raise input_error(message=message, remedy=remedy, value=shown(text))
    return {"name": name, "friction_factor": parse_number(factor)} if equals else name
