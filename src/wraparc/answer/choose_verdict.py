"""The verdict of a search: what to choose, or why there is nothing to."""

from collections.abc import Iterator
from dataclasses import replace

from wraparc.answer.choose_words import (
    closest_words,
    design_name,
    missing_price_keys,
    missing_prices,
    money,
    next_cost_words,
    reasons,
    saving_words,
    slack_words,
    unpriced_words,
)
from wraparc.answer.least_tension import at_least, tension_at
from wraparc.answer.sheet import Also, Verdict, named, percent
from wraparc.answer.words import action_of, format_verdict, minimum_sentences, stated_action, under
from wraparc.checks import Level
from wraparc.checks.action import Action
from wraparc.choose.belt_rating import LighterBelt
from wraparc.choose.selection import Selection


def choose_verdict(selection: Selection, lighter: LighterBelt | None) -> Verdict:
    """Return the answer of a search in a few lines.

    Parameters
    ----------
    selection
        The answer.
    lighter
        Lightest belt that the best design could do with, if that was asked.
    """
    if not len(selection.ranking):
        return _single(selection) if len(selection) == 1 else _none(selection)
    best = int(selection.ranking[0])
    text = _first(selection, best)
    sentences = [
        *unpriced_words(selection),
        *next_cost_words(selection),
        *saving_words(selection),
    ]
    if lighter is not None:
        sentences.append(_lighter_belt(selection, lighter))
    missing = missing_prices(selection.search)
    if missing:
        sentences.insert(0, missing_price_keys(selection.search))
    action = " ".join(_other_search(selection)) or (missing and sentences[0])
    own = Verdict(
        Level.ATTENTION if missing else Level.OK,
        text,
        tuple(sentences),
        action=Action(action) if action else None,
        also=(Also(Level.ATTENTION, missing, None),) if missing else (),
        name="choose",
    )
    judged = selection.verdict
    told = under(own, format_verdict(judged, action=stated_action(judged)))
    if told.level is Level.OK and selection.search.drive.states_uncertainty:
        return replace(told, label=f"{Level.OK}, reserve not checked")
    return told


def _first(selection: Selection, best: int) -> str:
    """Return the sentence on the first design of the ranking: its tension, and its cost."""
    search, total = selection.search, float(selection.costs.total[best])
    held = tension_at(search.drive.take_up_place)
    design = (
        f"{design_name(selection, best, slack=False)} with {held} "
        f"{at_least(float(selection.slack_tension[best]))}"
    )
    if search.unpriced and not total > 0.0:
        return f"Lowest creep: {design}, creep {named('exit_creep', selection.creep[best])}."
    cost = f"{money(total, search.costing.currency)} in {search.costing.years:g} years"
    first = "Lowest cost without lagging" if search.unpriced else "Lowest cost"
    return f"{first}: {design}, {cost}."


def _lighter_belt(selection: Selection, lighter: LighterBelt) -> str:
    """Say which lightest belt of the catalogue would do."""
    tight = named("belt_modulus", lighter.tight_tension / selection.search.drive.belt.width)
    shares = (selection.search.limits.rating or {}).items()
    allowed = "".join(f", of which {case} may take {percent(s)}" for case, s in shares)
    return (
        f"The lightest catalogue belt that would do is {lighter.belt.name}: "
        f"{slack_words(selection.search)} {named('tension', lighter.slack_tension)}, maximum "
        f"tension {tight} of a rated {named('belt_modulus', lighter.belt.rating or 0.0)}{allowed}."
    )


def _none(selection: Selection) -> Verdict:
    """Say that no candidate passes, which is closest, and what most of them miss."""
    near = selection.nearest()
    told = ", ".join(f"{w} ({n} of {len(selection)})" for w, n in _misses(selection).items())
    return Verdict(
        Level.FAILS,
        f"No candidate passes. Closest: {closest_words(selection, near)}.",
        (f"Missed: {told}.", f"Closest: {reasons(selection, near)}."),
        action=_other_candidates(selection),
        name="choose",
    )


def _misses(selection: Selection) -> dict[str, int]:
    """Return how many candidates miss a check, by its words."""
    counts = {s.rule.what: int(s.broken.sum()) for s in selection.standings.values()}
    return {what: count for what, count in counts.items() if count}


def _other_candidates(selection: Selection) -> Action:
    counts = _misses(selection)
    return Action(f"Add candidates against what most miss, {max(counts, key=lambda n: counts[n])}.")


def _single(selection: Selection) -> Verdict:
    """Say what the only candidate comes to, as `solve` does: there is nothing to choose."""
    judged, broken, (result, *more) = selection.judged(0), selection.broken(0), selection.results(0)
    failed = set(broken) & selection.search.limits.stated
    action = stated_action(judged) if more else action_of(result)
    missed = (f"Missed: {reasons(selection, 0)}.",) if broken else ()
    own = Verdict(
        Level.FAILS if failed else judged.level,
        f"The candidate {design_name(selection, 0)} does not pass.",
        (*missed, *minimum_sentences(result)),
        action=None if action else _other_candidates(selection),
        name="choose",
    )
    return under(own, format_verdict(judged, action=action))


def _other_search(selection: Selection) -> Iterator[str]:
    """Yield what to search instead where the recommended design misses a check."""
    missed = {check.name for check in selection.verdict.missed}
    if not missed:
        return
    found = selection.sounder
    if found is None:
        if missed & selection.search.limits.stated:
            yield "Search again with that limit, or with other candidates."
        return
    cost = money(float(selection.costs.total[found]), selection.search.costing.currency)
    judged = selection.judged(found)
    does = "no check fails" if judged.missed else f"all {judged.passed} checks pass"
    yield f"Use {design_name(selection, found)}: {does}, {cost}."
