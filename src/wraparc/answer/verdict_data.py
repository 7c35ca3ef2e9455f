"""A verdict as plain data: one object for every door, numbers in SI."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from wraparc.answer.sheet import Also, Verdict
from wraparc.checks import Check, Place
from wraparc.checks import Verdict as Judgement
from wraparc.checks.action import Action, Way
from wraparc.checks.verdict import DATA_CLASSES
from wraparc.units import DIMENSION_TEXT

if TYPE_CHECKING:
    from wraparc.reserve import Flip, Probability

Data = dict[str, Any]
#: What forms a text of cells.
FormText = Callable[[str], Any]


def verdict_object(told: Verdict, form: FormText) -> Data:
    """Return a verdict as plain data.

    Parameters
    ----------
    told
        The verdict.
    form
        What forms its texts: `wraparc.units.in_units`, or `text_data` for those with their numbers.
    """
    judged = told.judged
    facts = _no_facts(told.name) if told.check is None else _facts(told.check)
    return {
        "level": told.level.value,
        "label": told.word,
        **facts,
        "text": form(told.text),
        "action": told.action and action_data(told.action, form),
        "changes": [form(text) for text in told.changes],
        "also": [_also(other, form) for other in told.also],
        "wet": None if judged is None else _wet(judged, told.wet, form),
        "reserve": [_flip(flip) for flip in told.flips],
        "reserve_text": form(told.reserve[0]) if told.reserve else None,
        "probability": None if told.shares is None else _probability(told.shares, told, form),
        "data": None if judged is None else _data(judged),
        "passed": None if judged is None else judged.passed,
        "missed": None if judged is None else len(judged.missed),
        "not_checked": [] if judged is None else [c.name for c in judged.not_checked],
        "sentences": [form(sentence) for sentence in told.sentences],
    }


def action_data(action: Action, form: FormText) -> Data:
    """Return what to do as plain data."""
    return {"text": form(action.text), "ways": [_way(way, form) for way in action.ways]}


def _way(way: Way, form: FormText) -> Data:
    changes = [{"key": c.key, "from": c.before, "to": c.after, "unit": c.unit} for c in way.changes]
    return {"changes": changes, "proved": way.proved, "left": way.left, "text": form(way.text)}


def place_data(place: Place) -> Data:
    """Return a place as plain data: None where it has no such part."""
    names = ("pulley", "spot", "load_case", "event", "condition")
    return {**{name: getattr(place, name) or None for name in names}, "time": place.time}


def _flip(flip: "Flip") -> Data:
    from wraparc.answer.reserve_words import flip_data  # rows are loaded where there are some

    return flip_data(flip)


def _probability(of: "Probability", told: Verdict, form: FormText) -> Data:
    from wraparc.answer.probability_words import probability_data  # rows, as above

    return {**probability_data(of), "text": form(told.probability)}


def _facts(check: Check) -> Data:
    """Return what a check compared."""
    return {
        "name": check.name,
        "place": place_data(check.place),
        "quantity": check.quantity or None,
        "value": _finite(check.value),
        "limit": _finite(check.limit),
        "unit": DIMENSION_TEXT[check.dimension].si_unit or None,
        "relation": check.relation,
        "used": _finite(check.used),
    }


def _no_facts(name: str) -> Data:
    keys = ("place", "quantity", "value", "limit", "unit")
    return {"name": name, **dict.fromkeys(keys), "relation": "none", "used": None}


def _also(other: Also, form: FormText) -> Data:
    facts = _no_facts("") if other.check is None else _facts(other.check)
    return {"level": other.level.value, **facts, "text": form(other.text)}


def _wet(judged: Judgement, text: str, form: FormText) -> Data | None:
    wet = judged.wet
    if wet is None or not text:
        return None
    return {
        "value": _finite(wet.value),
        "limit": _finite(wet.limit),
        "level": wet.level.value,
        "estimated": True,
        "text": form(text),
    }


def _data(judged: Judgement) -> Data:
    line = judged.data
    return {**{kind: line.of_class(kind) for kind in DATA_CLASSES}, "text": line.text}


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
