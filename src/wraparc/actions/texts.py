"""Actions in words: verb and rest of each change, joined to one sentence."""

from __future__ import annotations

from collections.abc import Sequence
from math import radians
from typing import NamedTuple

from wraparc.actions.score import count_left
from wraparc.actions.search import MOST_WRAP, Candidate
from wraparc.actions.variant import WRAP, Task, Variant
from wraparc.units import Cell, quantity
from wraparc.units.cell import Form

#: Words that the sentence of an action has at most; a number with its unit is one.
MOST_WORDS = 20


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
    """

    slack: str
    pulleys: tuple[str, ...]


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
    """Return a way in words, with how many checks it leaves."""
    left = count_left(found.outcome.levels)
    more = f" ({left} check{'' if left == 1 else 's'} left)" if left else ""
    verb, rest = _alone(found, task, names) or ("use", _together(found.variant, names))
    return Phrase(verb, f"{rest}{more}")


def _alone(found: Candidate, task: Task, names: Names) -> Phrase | None:
    """Return the words of a single change; None of several."""
    of = found.variant
    if sum(bool(value) for value in of) > 1:
        return None
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
        return Phrase("use", f"{_lagging(of, names)}: creep {creep}")
    if of.rating:
        return Phrase("use", f"{_belt(of)} (now {quantity(task.rating, 'force_per_width')})")
    if of.diameter:
        return Phrase("use", f"{_pulley(of, names)} (now {quantity(task.diameter, 'length')})")
    return Phrase("use", _together(of, names))


def _together(of: Variant, names: Names) -> str:
    """Return what is used of several changes."""
    parts = [
        f"lagging {of.lagging}" if of.lagging else "",
        f"a pulley of {_up(of.diameter, 'length')}" if of.diameter else "",
        f"wrap {_up(radians(of.wrap), 'angle')}" if of.wrap else "",
        f"{names.slack} {_up(of.tension, 'force')}" if of.tension else "",
        _belt(of) if of.rating else "",
        f"a belt of strength {_up(of.strength, 'force_per_width')}" if of.strength else "",
        f"idler spacing {Cell(of.spacing, 'length', form='down')}" if of.spacing else "",
    ]
    some = [part for part in parts if part]
    owned = bool(of.lagging) + bool(of.diameter)
    if owned:
        some[owned - 1] += _on(names)
    return listed(some)


def _up(value: float, dimension: str) -> str:
    return Cell(value, dimension, form="up")  # type: ignore[arg-type]


def _lagging(of: Variant, names: Names) -> str:
    return f"lagging {of.lagging}{_on(names)}"


def _belt(of: Variant) -> str:
    return f"a belt rated {_up(of.rating, 'force_per_width')}"


def _pulley(of: Variant, names: Names) -> str:
    return f"a pulley of {_up(of.diameter, 'length')}{_on(names)}"


def _on(names: Names) -> str:
    return f" on {listed(names.pulleys)}" if names.pulleys else ""


def listed(parts: Sequence[str], word: str = "and") -> str:
    """Return parts with commas, and a word before the last."""
    return f"{', '.join(parts[:-1])} {word} {parts[-1]}" if len(parts) > 1 else parts[0]


def none_text(percent: int, task: Task) -> str:
    """Return what is said where no change betters the verdict, Te so many percent too large."""
    tried = ["T2"]
    if WRAP in task.kinds and task.wrap < MOST_WRAP:
        tried.append(f"wrap to {MOST_WRAP} deg")
    if task.laggings:
        tried.append("catalogue lagging")
    text = f"No {listed(tried, 'or')} passes"
    return f"{text}: Te is {percent} % too large." if percent > 0 else f"{text}."
