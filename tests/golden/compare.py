"""Comparing answers with golden ones, by key: numbers, texts, what is missing, what was added."""

import math
from collections.abc import Iterator
from decimal import Decimal, InvalidOperation
from difflib import SequenceMatcher
from enum import StrEnum
from typing import Any, NamedTuple

#: Errors of the solution itself and small differences of large numbers: mostly rounding, which on
#: another machine has other digits.
ERRORS = {
    "identity_error", "tension_error", "speed_error", "excess", "per_percent", "gear_loss",
    "losses",
}  # fmt: skip
_NOTHING = 1e-7
_ZERO = 1e-9  # of what was nothing
_NOT_FINITE = ("nan", "inf", "-inf")


class Kind(StrEnum):
    """What differs."""

    NUMBER = "number"
    TEXT = "text"
    MISSING = "missing"
    ADDED = "added"


class Difference(NamedTuple):
    """One difference: what kind, where (example and keys), and what stands there."""

    kind: Kind
    place: str
    old: Any = None
    new: Any = None

    def __str__(self) -> str:
        if self.kind == Kind.MISSING:
            return f"{self.place}: missing; was {_short(self.old)}"
        if self.kind == Kind.ADDED:
            return f"{self.place}: added: {_short(self.new)}"
        return f"{self.place}: {self.kind} was {_short(self.old)}, is {_short(self.new)}"


def differences(
    old: Any, new: Any, tolerance: float = 0.0, place: str = "", scale: float = 0.0
) -> Iterator[Difference]:
    """Return every difference between recorded and new answers.

    Parameters
    ----------
    old, new
        Answers as `golden.plain.plain` gives them.
    tolerance
        Largest relative difference of two numbers that counts as none; 0 for bit for bit. In a row
        of numbers it is relative to the largest of the row.
    place
        Where the two stand.
    scale
        Numbers count as at least that large.
    """
    if isinstance(old, dict) and isinstance(new, dict):
        yield from _of_tables(old, new, tolerance, place)
    elif _is_text(old) and _is_text(new):
        yield from _of_texts(old, new, tolerance, place)
    elif isinstance(old, list) and isinstance(new, list):
        yield from _of_lists(old, new, tolerance, place)
    elif _is_number(old) and _is_number(new):
        if not _same(old, new, tolerance, scale, place.rpartition(".")[2]):
            yield Difference(Kind.NUMBER, place, old, new)
    elif type(old) is not type(new) or old != new:
        kind = Kind.TEXT if isinstance(old, str) else Kind.NUMBER
        yield Difference(kind, place, old, new)


def _of_tables(
    old: dict[str, Any], new: dict[str, Any], tolerance: float, place: str
) -> Iterator[Difference]:
    dot = f"{place}." if place else ""
    for key, value in old.items():
        if key == "value" and tolerance and _below(old, new):
            continue
        if key not in new:
            yield Difference(Kind.MISSING, dot + key, value)
        else:
            yield from differences(value, new[key], tolerance, dot + key)
    for key in new.keys() - old.keys():
        yield Difference(Kind.ADDED, dot + key, None, new[key])


def _below(old: dict[str, Any], new: dict[str, Any]) -> bool:
    """Whether the values of a check are both below its accuracy."""
    found = (old["value"], new.get("value"))
    return all(isinstance(v, float) and abs(v) < (old.get("floor") or 0.0) for v in found)


def _of_lists(old: list[Any], new: list[Any], tolerance: float, place: str) -> Iterator[Difference]:
    scale = max((abs(x) for x in old if isinstance(x, float)), default=0.0)
    for number, (before, after) in enumerate(zip(old, new, strict=False)):
        yield from differences(before, after, tolerance, f"{place}[{number}]", scale)
    for number in range(len(new), len(old)):
        yield Difference(Kind.MISSING, f"{place}[{number}]", old[number])
    for number in range(len(old), len(new)):
        yield Difference(Kind.ADDED, f"{place}[{number}]", None, new[number])


def _of_texts(old: list[str], new: list[str], tolerance: float, place: str) -> Iterator[Difference]:
    """Compare the numbers of two texts; the last digit shown may turn with the tolerance."""
    pairs = zip(old, new, strict=False)
    if (
        tolerance
        and len(old) == len(new)
        and all(_reads_the_same(*pair, tolerance) for pair in pairs)
    ):
        return
    for what, i, j, k, m in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if what != "equal":
            kind = Kind.ADDED if what == "insert" else Kind.TEXT
            yield Difference(kind, f"{place}[{i}]", old[i:j], new[k:m])


def _reads_the_same(old: str, new: str, tolerance: float) -> bool:
    if old == new:
        return True
    (before, _, unit), (after, _, other) = old.partition(" "), new.partition(" ")
    try:
        a, b = (Decimal(text.replace("−", "-").replace(",", "")) for text in (before, after))
    except InvalidOperation:
        return False  # words that are answers
    step = Decimal(1).scaleb(int(a.as_tuple().exponent))
    near = max(step, Decimal(tolerance) * max(abs(a), abs(b)))
    return unit == other and abs(a - b) <= near


def _same(old: Any, new: Any, tolerance: float, scale: float, key: str) -> bool:
    a, b = float(old), float(new)
    if repr(a) == repr(b):
        return True
    if not (tolerance and math.isfinite(a) and math.isfinite(b)):
        return False
    floor = _NOTHING if key.partition("[")[0] in ERRORS else 0.0 if a else _ZERO
    return abs(a - b) <= max(tolerance * max(abs(a), abs(b), scale), floor)


def _is_number(value: Any) -> bool:
    number = isinstance(value, int | float) and not isinstance(value, bool)
    return number or value in _NOT_FINITE


def _is_text(value: Any) -> bool:
    words = isinstance(value, list) and all(isinstance(x, str) for x in value)
    return words and any(x not in _NOT_FINITE for x in value)


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 100 else f"{text[:97]}..."
