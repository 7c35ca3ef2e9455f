"""What answers are made of: texts with their numbers, tables, sheets, numbers of a picture.

An answer states its form once: the framework reads it, checks it and writes the OpenAPI document.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal, NotRequired, Self, cast

import numpy as np
from pydantic import BaseModel, ConfigDict
from typing_extensions import TypedDict

from wraparc.answer import sheet as sheets
from wraparc.answer.answer_data import answer_data, table_data, text_data, verdict_data
from wraparc.arc import ArcResult
from wraparc.arc import Profile as ArcProfile
from wraparc.checks import Check, Level
from wraparc.provenance import Kind
from wraparc.units import Dimension, in_units
from wraparc.units.cell import Form

Data = dict[str, Any]
Numbers = list[float | None]
#: Whole powers of ten: to look one up takes a sixth of the time of raising it.
_TENS = 10.0 ** np.arange(301.0)
StatusName = Literal["solved", "breakaway", "unsolved"]
DriveKind = Literal["drive", "train"]


class Answer(BaseModel):
    """Part of an answer."""

    model_config = ConfigDict(
        extra="forbid", from_attributes=True, ser_json_bytes="base64", val_json_bytes="base64"
    )


_Number = TypedDict(
    "_Number",
    {
        "value": float | None,
        "from": NotRequired[float],
        "apart": NotRequired[float],
        "error": NotRequired[float],
        "unit": str,
        "name": NotRequired[str],
        "dimension": NotRequired[Dimension],
        "digits": NotRequired[int],
        "form": NotRequired[Form],
    },
)


class NumberInText(_Number):
    """A number in a text, at its first and behind its last character."""

    at: tuple[int, int]


class Number(_Number):
    """A text that is one number [in its SI `unit`]; None without bound.

    `name` is that of the glossary, which has its dimension; `dimension` is there where there is
    none. `form` is how it is shown, see `wraparc.units.cell.Form`; `from` is where a range begins,
    `apart` a number that its digits tell it from, `error` half its interval. Left out are three
    digits and the plain form.
    """

    text: str


class TextWithNumbers(TypedDict):
    """A text in metric units with its numbers; in US units where more than these differs."""

    text: str
    cells: list[NumberInText]
    us: NotRequired[str]


Text = str | Number | TextWithNumbers


Change = TypedDict(
    "Change", {"key": str, "from": float | str, "to": float | str, "unit": str | None}
)


class Way(Answer):
    """Changes that are made together; `left` checks are missed with them."""

    changes: list[Change]
    proved: bool
    left: int
    text: Text


class Action(Answer):
    """What to do, in one sentence, and the ways that it offers."""

    text: Text
    ways: list[Way]


class Also(Answer):
    """What else is missed."""

    level: Level
    name: str
    place: dict[str, str | float | None] | None
    quantity: str | None
    value: float | None
    limit: float | None
    unit: str | None
    relation: Literal["exceeds", "below", "within", "none"]
    used: float | None
    text: Text


class Verdict(Answer):
    """The answer in a few lines, see `wraparc.answer.sheet.Verdict`.

    Numbers are SI, those of the check that governs; `label` stands for the level, ``OK (dry)``.
    """

    level: Level
    label: str
    name: str
    place: dict[str, str | float | None] | None
    quantity: str | None
    value: float | None
    limit: float | None
    unit: str | None
    relation: Literal["exceeds", "below", "within", "none"]
    used: float | None
    text: Text
    action: Action | None
    changes: list[Text]
    also: list[Also]
    wet: Data | None
    reserve: list[Data]
    reserve_text: Text | None
    probability: Data | None
    data: Data | None
    passed: int | None
    missed: int | None
    not_checked: list[str]
    sentences: list[Text]

    @classmethod
    def of(cls, told: sheets.Verdict) -> Self:
        """Return the words of a sheet."""
        return cls.model_validate(verdict_data(told))


class Row(Answer):
    """One line of a table."""

    name: str
    title: Text
    symbol: str
    values: list[Text]
    note: Text
    level: Level | None


class Table(Answer):
    """Rows under one heading; `name` is what ``--table`` asks for it by."""

    key: str = ""
    name: str
    title: Text
    heads: list[Text]
    note: Text
    rows: list[Row]


class Sheet(Answer):
    """Everything to show of one thing."""

    title: Text
    subtitle: Text
    verdict: Verdict | None
    tables: list[Table]
    remarks: list[Text]
    table_sources: list[str]


class Bar(Answer):
    """A check as a bar against its limit; `share` is the value [SI] over the limit.

    `says` is what it says where it is not kept, `source` where its limit came from.
    """

    name: str
    title: str
    level: Level
    place: Text
    at_most: bool
    value: float
    share: float
    found: Text
    limit: Text
    says: Text
    source: str


class Source(Answer):
    """Where a number came from."""

    of: str
    part: str
    kind: Kind
    source: str
    date: str
    note: str


class Profile(Answer):
    """Quantities along the arc [SI]; the glossary of the schema names them."""

    position: Numbers
    tension: Numbers
    wrap_pressure: Numbers
    friction: Numbers
    friction_used: Numbers
    slip: Numbers
    creep: Numbers
    shear_stress: Numbers
    shear_angle: Numbers
    sliding: Numbers

    @classmethod
    def of(cls, profile: ArcProfile, most: int = 0) -> "Profile":
        """Return a profile, of at most so many points if said, both ends included."""
        kept: Any = slice(None)
        if 0 < most < len(profile):
            kept = np.unique(np.linspace(0, len(profile) - 1, most).round().astype(int))
        names, columns = zip(*profile.columns(), strict=True)
        rows = rounded([column[kept] for column in columns])
        # numbers of our own: to check each again takes longer than to solve the arc
        return cls.model_construct(**dict(zip(names, rows, strict=True)))


class Tested(Answer):
    """Range that the lagging was tested in [Pa, Pa, m]."""

    pressure_min: float
    pressure_max: float
    slip_max: float


def worded(told: str) -> Text:
    """Return a text with its numbers."""
    return cast(Text, text_data(told))


def texts(sentences: Iterable[str]) -> list[Text]:
    """Return sentences."""
    return [worded(sentence) for sentence in sentences]


def tables(made: Sequence[sheets.Table | None], keys: Iterable[str] = ()) -> list[Table]:
    """Return tables, those that are there; keys by position."""
    names = [*keys] or [f"table{number}" for number in range(1, len(made) + 1)]
    return [
        Table.model_validate({**table_data(table), "key": key})
        for key, table in zip(names, made, strict=True)
        if table is not None
    ]


def sheet(told: sheets.Sheet) -> Data:
    """Return the fields of a whole sheet."""
    fields = answer_data(told)
    del fields["format"]
    sources = fields.pop("sources")
    return {**fields, "tables": tables(told.tables), "table_sources": sources}


def bars(checks: Sequence[Check]) -> list[Bar]:
    """Return the checks that have a value and a limit, in the order of their table."""
    return [_bar(check) for check in checks if not math.isnan(check.share)]


def _bar(check: Check) -> Bar:
    found, limit = check.texts()
    return Bar(
        name=check.name,
        title=check.title,
        level=check.level,
        place=worded(str(check.place)),
        at_most=check.at_most,
        value=check.value,
        share=check.share,
        found=worded(found),
        limit=worded(limit),
        says=worded(check.text if check.missed else ""),
        source=check.source,
    )


def status_of(result: ArcResult) -> StatusName:
    """Return how the solve of an arc ended."""
    return cast(StatusName, result.status.name.lower())


def numbers(scalars: Mapping[str, float]) -> dict[str, float | None]:
    """Return numbers by name, None where there is none or no bound."""
    return {name: finite(value) for name, value in scalars.items()}


def finite(value: float) -> float | None:
    """Return a number, None where there is none or no bound."""
    return value if math.isfinite(value) else None


def rounded(values: Any, digits: int = 6) -> list[Any]:
    """Return numbers of an array with so many significant digits; None for what is not finite."""
    array = np.asarray(values, float)
    with np.errstate(divide="ignore", invalid="ignore"):
        power = np.floor(np.log10(np.abs(array)))
    power = np.where(np.isfinite(power), power, 0.0)
    # by division and by multiplication with whole powers of ten: the shortest text comes out
    shift = np.clip(digits - 1 - power, -300, 300).astype(int)
    up, down = _TENS[np.maximum(shift, 0)], _TENS[np.maximum(-shift, 0)]
    found = np.round(array * up / down) / up * down
    known = np.isfinite(found)
    told: Any = found if known.all() else np.where(known, found, cast(Any, None))
    plain: list[Any] = told.tolist()
    return plain


def plain(value: Any) -> Any:
    """Return plain data with None for what is not finite and arrays rounded."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        if value and all(isinstance(item, float) for item in value):
            return rounded(value, 7)
        return [plain(item) for item in value]
    if isinstance(value, str):
        return in_units(value)
    return finite(value) if isinstance(value, float) else value


def outside(result: ArcResult) -> list[tuple[float, float]]:
    """Return the stretches of the arc outside the tested range [rad]."""
    tested = result.arc.law.tested
    if tested is None:
        return []
    p, x = result.profile.wrap_pressure, np.abs(result.profile.slip)
    out = (p < tested.pressure_min) | (p > tested.pressure_max) | (x > tested.slip_max)
    if not out.any():
        return []
    edges = np.flatnonzero(np.diff(np.concatenate([[0], out.astype(int), [0]])))
    at = result.profile.position
    last = len(at) - 1
    return [
        (float(at[max(a - 1, 0)]), float(at[min(b, last)]))
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]
