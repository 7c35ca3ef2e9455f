"""Answers to numbers: what a golden file keeps of a result, a JSON answer or a text.

Kept are every number, yes and no, and a few words that are answers themselves (`ANSWERS`). Other
texts leave only their numbers with their units, in order: a sentence may be said better. What a
text tells as a typed number is kept as that, in SI; others as they are shown. What differs from run
to run or from machine to machine is left out by name (`LEFT_OUT`). A long row of numbers is kept
thinned, with the sum of the sizes of all of them.
"""

import dataclasses
import enum
import math
import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

Plain = Any
#: Words that are answers.
ANSWERS = {"status", "level", "state", "method", "pulley", "load_case", "kind", "unit", "surface"}
#: Times, progress, versions, names of sessions; program objects; texts of whole files.
LEFT_OUT = {
    "date", "version", "program", "libraries", "id", "session", "expires_in", "started", "seconds",
    "elapsed", "duration", "time", "done", "case", "drive", "train", "law", "provenance", "sources",
    "fingerprint", "toml", "html", "svg", "sequence",
}  # fmt: skip
#: Where an answer holds tables of texts, as shown: one text, so that rows may come in between.
TABLES = "tables"
_KEPT = 12  # numbers of a long row
_DIGITS = 12  # of a typed number
_NOTHING = 1e-9  # what is shown as 0
_UNIT = (
    r"(?:%|deg|rad|rpm|N m|kN m|lbf ft|kN/m|N/mm|MN/m|N/m|PIW|kPa/mm|psi/in|1/mm|1/in|J/m2|W|kW|hp"
    r"|MPa|kPa|Pa|psi|ksi|mm3/J|in3/\(ft lbf\)|kg/m|lbm/ft|m/s|fpm|m2|mm|in|ft|m|kN|N|lbf|h|years)"
)
_NUMBER = re.compile(
    rf"(?<![\w.])([-+−]?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?)(?: ?({_UNIT})(?![\w/]))?"
)
_NO_NUMBER = re.compile(r"\\?\[\d+\\?\]|\d{4}-\d\d-\d\d|wraparc \d+\.\d+\.\d+\w*")


def numbers_of_text(text: str) -> list[str]:
    """Return the numbers of a text with their units, in order, without notes and dates."""
    found = _NUMBER.findall(_NO_NUMBER.sub(" ", text))
    return [f"{number} {unit}".strip() for number, unit in found]


def numbers_told(text: Mapping[str, Any]) -> list[str]:
    """Return the same of a text that comes with its numbers."""
    if "cells" not in text:
        return _typed(text)
    found, end = [], 0
    for cell in text["cells"]:
        begin, following = cell["at"]
        found += [*numbers_of_text(text["text"][end:begin]), *_typed(cell)]
        end = following
    return found + numbers_of_text(text["text"][end:])


def _typed(cell: Mapping[str, Any]) -> list[str]:
    """Return a number in SI; nothing of one that is what rounding left."""
    if cell.get("form") == "unit":
        return []
    unit = "" if cell["unit"] == "1" else cell["unit"]
    values = [cell[key] for key in ("from", "value") if key in cell]
    small = cell["unit"] != "m3/J"
    told = [0.0 if small and abs(v or 0.0) < _NOTHING else v for v in values]
    return [f"{v:.{_DIGITS}g} {unit}".strip() for v in told]


def plain(value: Any, key: str = "") -> Plain:
    """Return the numbers of an answer as dictionaries, lists and numbers; None if it has none."""
    if isinstance(value, np.ndarray):
        return _row(value.ravel().tolist())
    if isinstance(value, np.generic):
        return plain(value.item(), key)
    if value is None or isinstance(value, bool | int | float | str | enum.Enum):
        return _one(value, key)
    if isinstance(value, _Told):
        return [*value] or None
    if isinstance(value, list | tuple):
        return _list(value, key)
    named = value if isinstance(value, Mapping) else _fields(value)
    if is_told(named):
        return numbers_told(named) or None
    if TABLES in named:
        named = {**named, TABLES: _Told(_texts(named[TABLES]))}
    found = {str(k): plain(v, str(k)) for k, v in named.items() if k not in LEFT_OUT}
    return {k: v for k, v in found.items() if v is not None or named[k] is None} or None


def _one(value: Any, key: str) -> Plain:
    if isinstance(value, enum.Enum):
        return value.name
    if isinstance(value, float):
        return value if math.isfinite(value) else f"{value}"
    if isinstance(value, str):
        return value if key in ANSWERS else (numbers_of_text(value) or None)
    return value


def _fields(value: Any) -> dict[str, Any]:
    """Return fields and properties of a frozen result; nothing of an object without fields."""
    if not dataclasses.is_dataclass(value):
        return {}
    kind = type(value)
    names = [f.name for f in dataclasses.fields(value)]
    names += [name for name in dir(kind) if isinstance(getattr(kind, name), property)]
    return {name: getattr(value, name) for name in names if not name.startswith("_")}


def _list(values: Any, key: str) -> Plain:
    leaves = _leaves(values)
    if leaves is not None:
        return _row(leaves) if leaves else None
    named = _by_name(values)
    if named is not None:
        return {name: plain(item) for name, item in named.items()}
    items = [plain(item, key) for item in values]
    return items if any(item is not None for item in items) else None


class _Told(list[str]):
    """Numbers of texts, one after the other."""


def is_told(value: Mapping[str, Any]) -> bool:
    """Whether it is a text that comes with its numbers; a verdict and its checks are none."""
    return "text" in value and "level" not in value and ("cells" in value or "unit" in value)


def _texts(value: Any) -> Iterator[str]:
    """Yield the numbers of tables as they stand, each table by its keys in order."""
    if isinstance(value, str):
        yield from numbers_of_text(value)
    elif isinstance(value, Mapping):
        if is_told(value):
            yield from numbers_told(value)
        else:
            for key in sorted(value):
                yield from _texts(value[key])
    elif isinstance(value, list | tuple):
        for item in value:
            yield from _texts(item)


def _by_name(values: Any) -> dict[str, Any] | None:
    """Return tables by their keys or names, so that a new one among them moves no other."""
    for label in ("key", "name"):
        names = [str(v.get(label) or "") if isinstance(v, Mapping) else "" for v in values]
        if all(names) and len(set(names)) == len(names):
            return dict(zip(names, values, strict=True))
    return None


def _leaves(values: Any) -> list[Any] | None:
    """Return the numbers of nested rows one after the other; None if there is something else."""
    found: list[Any] = []
    for value in values:
        if isinstance(value, list | tuple | np.ndarray):
            inner = _leaves(value)
            if inner is None:
                return None
            found += inner
        elif value is None or isinstance(value, bool | int | float | np.number):
            found.append(value.item() if isinstance(value, np.generic) else value)
        else:
            return None
    return found


def _row(values: list[Any]) -> Plain:
    shown = [plain(v) for v in values]
    if len(shown) <= _KEPT:
        return shown
    every = -(-len(shown) // _KEPT)
    return {"numbers": len(shown), "every": every, "kept": shown[::every], "sum": _sizes(shown)}


def _sizes(values: list[Any]) -> float:
    """Return the sum of the sizes of numbers, in which none takes from another."""
    return math.fsum(abs(value) for value in values if isinstance(value, int | float))
