"""Actions in words: verb and rest of each change, joined to one sentence."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil, radians
from typing import NamedTuple

from wraparc.actions.score import names_left
from wraparc.actions.search import MOST_WRAP, Candidate
from wraparc.actions.variant import WRAP, Task, Variant
from wraparc.units import Cell, Dimension, in_units, quantity
from wraparc.units.cell import Form

#: Words that the sentence of an action has at most; a number with its unit is one.
MOST_WORDS = 20
#: Letters of a way that a button has room for.
_MOST_LETTERS = 92
#: Checks that are left by name at most.
_MOST_NAMED = 2


class Phrase(NamedTuple):
    """Verb, small, and the rest of an imperative without its full stop."""

    verb: str
    rest: str


class Names(NamedTuple):
    """How what is changed is called.

    Attributes
    ----------
    slack
        The tension that is raised or lowered: ``T2``.
    pulleys
        Those whose lagging or diameter is changed; empty where all are.
    checks
        How each check is called, by its name.
    """

    slack: str
    pulleys: tuple[str, ...]
    checks: Mapping[str, str] = {}


def sentence_of(phrases: Sequence[Phrase]) -> str:
    """Return one sentence of the first phrases that it has room for."""
    text = f"{phrases[0].verb.capitalize()} {phrases[0].rest}"
    for phrase in phrases[1:]:
        longer = f"{text}, or {phrase.verb} {phrase.rest}"
        if len(longer.split()) > MOST_WORDS:
            break
        text = longer
    return f"{text}."


def phrase_of(found: Candidate, task: Task, names: Names) -> Phrase:
    """Return a way in words, with what it changes from and which checks it leaves.

    What there is no room for is left out: first what it changes from, then which checks.
    """
    left = _left(found, names)
    alone = sum(bool(value) for value in found.variant) == 1
    told = [_alone(found, task, names)] if alone else _together(found.variant, task, names)
    phrases = [Phrase(verb, f"{rest}{end}") for end in left for verb, rest in told]
    return next(filter(_has_room, phrases), phrases[-1])


def _has_room(phrase: Phrase) -> bool:
    text = " ".join(phrase)
    return len(text.split()) <= MOST_WORDS and len(in_units(text)) <= _MOST_LETTERS


def _left(found: Candidate, names: Names) -> tuple[str, ...]:
    """Return which checks a way leaves, and how many: the longer text first."""
    left = names_left(found.outcome.levels)
    if not left:
        return ("",)
    one = len(left) == 1
    count = f" ({len(left)} check{' still fails' if one else 's still fail'})"
    if len(left) > _MOST_NAMED or not all(name in names.checks for name in left):
        return (count,)
    called = dict.fromkeys(names.checks[name] for name in left)
    return f" ({listed([*called])} still fail{'s' if len(called) == 1 else ''})", count


def _alone(found: Candidate, task: Task, names: Names) -> Phrase:
    """Return the words of a single change."""
    of = found.variant
    if of.tension:
        up = of.tension > task.tension
        form: Form = "to up" if up else "to down"
        ends = Cell(of.tension, "force", form=form, other=task.tension)
        return Phrase("raise" if up else "lower", f"{names.slack} from {ends}")
    if of.wrap:
        ends = Cell(radians(of.wrap), "angle", form="to up", other=radians(task.wrap))
        return Phrase("increase", f"wrap from {ends}")
    if of.lagging:
        creep = quantity(found.outcome.creep, "length")
        of_creep = next(iter(task.now.levels), "") in ("creep", "wet_creep", "uneven_creep")
        return Phrase("use", f"{_lagging(of, names)}{f': creep {creep}' if of_creep else ''}")
    if of.rating:
        return Phrase("use", _changed(*_RATING, of.rating, task.rating))
    if of.diameter:
        changed = _changed(f"pulley {_DIAMETER[0]}", _DIAMETER[1], of.diameter, task.diameter)
        return Phrase("use", f"{changed}{_on(names)}")
    if of.strength:
        return Phrase("use", _changed(*_STRENGTH, of.strength, task.strength))
    return Phrase("use", _changed(*_SPACING, of.spacing, task.spacing, form="down"))


#: What is changed, before its value, and what it measures.
_DIAMETER: tuple[str, Dimension] = "diameter", "length"
_WRAP: tuple[str, Dimension] = "wrap", "angle"
_RATING: tuple[str, Dimension] = "a belt rated", "force_per_width"
_STRENGTH: tuple[str, Dimension] = "a belt of strength", "force_per_width"
_SPACING: tuple[str, Dimension] = "idler spacing", "length"


def _together(of: Variant, task: Task, names: Names) -> list[Phrase]:
    """Return what is used of several changes, then where the tension goes.

    With what each changes from, and without.
    """
    return [Phrase("use", _all_changed(of, now, task.tension, names)) for now in (task, None)]


def _all_changed(of: Variant, now: Task | None, tension: float, names: Names) -> str:
    parts = [
        f"lagging {of.lagging}" if of.lagging else "",
        _changed(*_DIAMETER, of.diameter, now.diameter if now else 0.0),
        _changed(*_WRAP, radians(of.wrap), radians(now.wrap) if now else 0.0),
        _changed(*_RATING, of.rating, now.rating if now else 0.0),
        _changed(*_STRENGTH, of.strength, now.strength if now else 0.0),
        _changed(*_SPACING, of.spacing, now.spacing if now else 0.0, form="down"),
    ]
    some = [part for part in parts if part]
    owned = bool(of.lagging) + bool(of.diameter)
    if owned:
        some[owned - 1] += _on(names)
    if not of.tension:
        return listed(some)
    up = of.tension > tension
    form: Form = "to up" if up else "to down"
    ends = f"from {Cell(of.tension, 'force', form=form, other=tension)}"
    to = ends if now else f"to {Cell(of.tension, 'force', form='up' if up else 'down')}"
    return f"{listed(some)}, and {'raise' if up else 'lower'} {names.slack} {to}"


def _changed(what: str, dimension: Dimension, value: float, now: float, form: Form = "up") -> str:
    """Return what is used, and what it is now where that is to be told."""
    if not value:
        return ""
    told = f" (now {Cell(now, dimension, form='typed')})" if now else ""
    return f"{what} {Cell(value, dimension, form=form)}{told}"


def _lagging(of: Variant, names: Names) -> str:
    return f"lagging {of.lagging}{_on(names)}"


def _on(names: Names) -> str:
    return f" on {listed(names.pulleys)}" if names.pulleys else ""


def listed(parts: Sequence[str], word: str = "and") -> str:
    """Return parts with commas, and a word before the last."""
    return f"{', '.join(parts[:-1])} {word} {parts[-1]}" if len(parts) > 1 else parts[0]


def none_text(percent: int, task: Task) -> str:
    """Return what is said where no change betters the verdict, Te so many percent too large.

    What is to be taken off is said in percent of Te as it is: of 25 % too much, 20 %.
    """
    tried = ["T2"]
    if WRAP in task.kinds and task.wrap < MOST_WRAP:
        tried.append(f"wrap to {MOST_WRAP} deg")
    if task.laggings:
        tried.append("catalogue lagging")
    text = f"No {listed(tried, 'or')} passes"
    lower = ceil(100.0 - 100.0 / (1.0 + percent / 100.0))
    return f"{text}: Te must be {lower} % lower." if percent > 0 else f"{text}."
