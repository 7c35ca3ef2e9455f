"""Texts of answers, as the API and ``--json`` have them, read in a system of units."""

import math
from typing import Any

from wraparc.checks import Check, Verdict
from wraparc.glossary import GLOSSARY
from wraparc.units import RESULT_DIGITS, Cell, System, in_units


def check_words(check: Check, system: System = "si") -> str:
    """Return all that a check says: its sentence, what to do, its reasons."""
    return in_units(f"{check.text} {check.action_text} {check.full_text}", system)


def verdict_words(verdict: Verdict, system: System = "si") -> str:
    """Return all that a verdict says of what is missed, and its reasons."""
    checks = [] if verdict.governing is None else [verdict.governing, *verdict.also]
    return " ".join(check_words(check, system) for check in checks)


def worded(text: Any, system: System = "si") -> str:
    """Return a text of an answer in a system of units, from its numbers where it has any."""
    if isinstance(text, str):
        return text
    if system == "si" or "us" in text:
        told: str = text["text"] if system == "si" else text["us"]
        return told
    whole, cells = text["text"], text.get("cells")
    if cells is None:
        return _cell(text).text(system)
    parts, end = [], 0
    for cell in cells:
        begin, following = cell["at"]
        parts += [whole[end:begin], _cell(cell).text(system)]
        end = following
    return "".join([*parts, whole[end:]])


def _cell(data: dict[str, Any]) -> Cell:
    name = data.get("name", "")
    of = data.get("dimension") or GLOSSARY[name].dimension
    other = data.get("from", data.get("apart", data.get("error", math.nan)))
    return Cell(
        data["value"], of, data.get("digits", RESULT_DIGITS), data.get("form", ""), other, name
    )
