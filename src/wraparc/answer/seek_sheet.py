"""What goal seek found: a sentence, the values with what the drive is like then, and data."""

import math
from typing import Any

from wraparc.answer.sheet import Row, Sheet, Table, Verdict, named, quantity, started
from wraparc.answer.words import under, whole_verdict
from wraparc.arc import DriveResult
from wraparc.checks import Level, Place, judge
from wraparc.checks.action import Action
from wraparc.glossary import GLOSSARY
from wraparc.schema.overrides import parse_path
from wraparc.study.fields import label_of
from wraparc.study.seek import Sought
from wraparc.units import Cell, in_units


def seek_sheet(found: Sought, title: str) -> Sheet:
    """Return the sheet of a search."""
    rows = tuple(
        Row(
            value_text(found, value),
            (named(found.result, _result(found, drive)), judge(whole).label),
            note=judge(whole).text,
        )
        for value, whole, drive in zip(found.values, found.wholes, found.drives, strict=True)
    )
    heads = (GLOSSARY[found.result].title, "Verdict on the drive")
    return Sheet(
        title=title,
        subtitle=f"Pulley {found.pulley}, load case {found.load_case}.",
        verdict=_verdict(found),
        tables=(Table(label_of(found.field).capitalize(), rows, heads, name="values"),)
        if rows
        else (),
    )


def _verdict(found: Sought) -> Verdict:
    """Return which value gives the wanted result, and under it the drive with this value."""
    text = sentence(found)
    if not found.values:
        return Verdict(Level.FAILS, text, action=_OTHER, name="seek")
    drive = whole_verdict(found.wholes[_best(found)])
    return under(Verdict(Level.OK, text, name="seek"), drive)


_OTHER = Action("Try another input, or a wider range (--from, --to).")


def _best(found: Sought) -> int:
    """Return the place of the value with which the drive is best, the nearest of alike ones."""
    ranks = [judge(whole).level.rank for whole in found.wholes]
    return ranks.index(min(ranks))


def sentence(found: Sought) -> str:
    """Return the answer in one sentence."""
    what, result = _input(found), _result_noun(found.result)
    wanted, now = named(found.result, found.wanted), _now(found)
    if found.values:
        value = value_text(found, found.values[_best(found)])
        return f"{started(what)} {value} gives {result} {wanted}{now}."
    low, high = found.tried[0], found.tried[-1]
    ends = Cell(high, found.dimension, 4, "to", low)
    return f"No {what} from {ends} gives {result} {wanted}{_reached(found)}{now}."


def _reached(found: Sought) -> str:
    """Return how near the result comes to what is wanted over the range."""
    known = [value for value in found.results if math.isfinite(value)]
    if not known:
        return ": no solution"
    least, most = min(known), max(known)
    if found.wanted < least:
        return f"; minimum {named(found.result, least)}"
    if found.wanted > most:
        return f"; maximum {named(found.result, most)}"
    return ": it jumps over it"


#: Inputs and results by shorter words than those of their keys.
_INPUTS = {
    "wrap_angle": "wrap", "exit_tension": "T2", "entry_tension": "T1", "effective_tension": "Te",
}  # fmt: skip


def _input(found: Sought) -> str:
    key = str(parse_path(found.field)[-1])
    return _INPUTS.get(key) or label_of(found.field, found.pulley)


def _result_noun(result: str) -> str:
    if result == "exit_creep":
        return "creep"
    title = GLOSSARY[result].title
    return title[:1].lower() + title[1:]


def _now(found: Sought) -> str:
    """Return the place of the result with the present value of the input, in brackets."""
    place = str(Place(found.pulley, found.load_case))
    return (
        f" ({place})"
        if math.isnan(found.now)
        else (f" ({place}; now {value_text(found, found.now)})")
    )


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
                "label": judge(whole).label,
                "text": in_units(judge(whole).text),
            }
            for value, whole, drive in zip(found.values, found.wholes, found.drives, strict=True)
        ],
        "tried": {"value": list(found.tried), "result": list(found.results)},
    }
