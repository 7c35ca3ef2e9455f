"""What goal seek found: a sentence, the values with what the drive is like then, and data."""

import math
from collections.abc import Iterator
from typing import Any

from wraparc.answer.sheet import Row, Sheet, Table, named, quantity
from wraparc.arc import DriveResult
from wraparc.checks import judge
from wraparc.glossary import GLOSSARY
from wraparc.study.fields import label_of
from wraparc.study.seek import Sought


def seek_sheet(found: Sought, title: str) -> Sheet:
    """Return the sheet of a search."""
    rows = tuple(
        Row(
            value_text(found, value),
            (named(found.result, _result(found, drive)), judge(whole).word),
            note=judge(whole).lead,
        )
        for value, whole, drive in zip(found.values, found.wholes, found.drives, strict=True)
    )
    heads = (GLOSSARY[found.result].title, "Verdict on the drive")
    return Sheet(
        title=title,
        subtitle=f"Pulley {found.pulley}, load case {found.load_case}.",
        verdict=None,
        tables=(Table(label_of(found.field).capitalize(), rows, heads, name="values"),)
        if rows
        else (),
        remarks=(sentence(found),),
    )


def sentence(found: Sought) -> str:
    """Return the answer in one sentence."""
    what, name = label_of(found.field), GLOSSARY[found.result].title.lower()
    wanted = named(found.result, found.wanted)
    if found.values:
        values = " or ".join(value_text(found, value) for value in found.values)
        return f"{name.capitalize()} is {wanted} where the {what} is {values}{_now(found)}."
    low, high = (value_text(found, v) for v in (found.tried[0], found.tried[-1]))
    return (
        f"No {what} from {low} to {high} gives {name} of {wanted}: "
        f"{'; '.join(_reached(found))}{_now(found)}."
    )


def _reached(found: Sought) -> Iterator[str]:
    """Yield how far the result goes over the range."""
    pairs = [(r, v) for v, r in zip(found.tried, found.results, strict=True) if math.isfinite(r)]
    if not pairs:
        yield "it has no value on all of the way"
        return
    for word, (result, value) in (("least", min(pairs)), ("most", max(pairs))):
        told = named(found.result, result)
        yield f"the {word} is {told}, with {value_text(found, value)}"


def _now(found: Sought) -> str:
    if math.isnan(found.now):
        return ""
    now = value_text(found, found.now)
    if math.isnan(found.result_now):
        return f" (now {now})"
    return f" (now {now}: {named(found.result, found.result_now)})"


def value_text(found: Sought, value: float) -> str:
    """Return a value of the input with its unit, in four digits."""
    return quantity(value, found.dimension, 4)


def _result(found: Sought, drive: DriveResult) -> float:
    return drive.arc(found.pulley, found.load_case).scalar(found.result)


def seek_document(found: Sought) -> dict[str, Any]:
    """Return a search as plain data: SI."""
    return {
        "field": found.field,
        "result": found.result,
        "wanted": found.wanted,
        "pulley": found.pulley,
        "load_case": found.load_case,
        "now": {"value": found.now, "result": found.result_now},
        "found": [
            {
                "value": value,
                "result": _result(found, drive),
                "level": judge(whole).level.value,
                "word": judge(whole).word,
                "headline": judge(whole).headline(),
            }
            for value, whole, drive in zip(found.values, found.wholes, found.drives, strict=True)
        ],
        "tried": {"value": list(found.tried), "result": list(found.results)},
    }
