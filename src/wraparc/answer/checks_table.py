"""The list of checks as every door shows it: a table, a summary, plain data."""

import math
from typing import TYPE_CHECKING, Any

from wraparc.answer.sheet import NONE, Row, Table, percent
from wraparc.answer.sources import Sources
from wraparc.answer.verdict_data import place_data, verdict_object
from wraparc.answer.words import format_verdict
from wraparc.checks import Check, Verdict
from wraparc.checks.action import Action
from wraparc.units import in_units

if TYPE_CHECKING:
    from wraparc.train.whole import Whole

#: Checks that a short answer shows, if no more are missed.
_NEAREST = 4
#: Share of a limit beyond which it is told as so many times.
_FAR = 10.0
HEADS = ("Value", "Limit", "Used", "Status")
#: What to know about the table.
NOTE = "Used: value over a maximum, or a minimum over the value. Each check at its governing place."


def check_table(verdict: Verdict, of: Sources | None = None, title: str = "Checks") -> Table:
    """Return each check with value, limit, how much of the limit is used, status and place.

    Parameters
    ----------
    verdict
        The list.
    of
        Takes the sources of the limits, if they are to be shown.
    title
        Heading.
    """
    judged = [c for c in verdict.listed if c.compares]
    return Table(
        title,
        tuple(_row(check, of) for check in judged),
        HEADS,
        " ".join(text for text in (NOTE, _not_checked(verdict, ": ")) if text),
        name="checks",
        short=_nearest(verdict, title),
        brief=_not_checked(verdict, "  "),
    )


def _nearest(verdict: Verdict, title: str) -> Table:
    """Return the checks that are missed, and the nearest to their limits of the others."""
    told = [c for c in verdict.listed if c.compares and (c.missed or math.isfinite(c.used))]
    told = sorted((c for c in told if not c.below), key=lambda check: check.order)
    rows = tuple(_row(c, None) for c in told[: max(_NEAREST, len(verdict.missed))])
    return Table(title, rows, HEADS, name="checks")


def _row(check: Check, of: Sources | None) -> Row:
    value, _ = check.texts()
    values = (value or NONE, check.bound() or NONE, used_text(check), str(check.level))
    number = "" if of is None else of.number(check.source)
    note = " ".join(part for part in (str(check.place), number) if part)
    return Row(check.title, values, note=note, name=check.name, level=check.level)


def _not_checked(verdict: Verdict, apart: str) -> str:
    """Return what was not checked behind its label, each with the missing key or the reason."""
    left = [c for c in verdict.not_checked if c.name != "wet_creep"]
    named = ", ".join(f"{c.noun or c.title} ({c.missing or c.why})" for c in left)
    return f"Not checked{apart}{named}." if named else ""


def used_text(check: Check) -> str:
    """Return how much of its limit a check uses."""
    used = check.used
    if used > _FAR - 1e-3:
        return f"> {_FAR:g} times"
    return percent(used) if math.isfinite(used) else NONE


def checks_summary(verdict: Verdict) -> str:
    """Return how the checks end, in one sentence."""
    return f"{verdict.passed} of {sum(c.compares for c in verdict.listed)} checks pass."


def check_data(check: Check) -> dict[str, Any]:
    """Return a check as plain data, numbers in SI."""
    return {
        "name": check.name,
        "title": check.title,
        "level": check.level.value,
        "pulley": check.place.pulley,
        "load_case": check.place.load_case,
        "place": place_data(check.place),
        "value": check.value,
        "limit": check.limit,
        "floor": check.floor,
        "dimension": check.dimension,
        "at_most": check.at_most,
        "margin": check.margin,
        "used": check.used,
        "relation": check.relation,
        "source": check.source,
        "binding": check.binding,
        "text": in_units(check.text),
        "full": in_units(check.full_text),
    }


def verdict_document(
    verdict: Verdict,
    action: Action | None = None,
    of: "Whole | None" = None,
    drawn: "Whole | None" = None,
) -> dict[str, Any]:
    """Return a verdict as plain data in SI, see `verdict_object`, and every check once.

    `of` is the drive whose reserve is sought, `drawn` that whose inputs are drawn; none unless
    given.
    """
    own = format_verdict(verdict, verdict.full, action)
    if of is not None:
        from wraparc.answer.reserve_words import with_reserve  # solves rows

        own = with_reserve(own, of, every=True)
    if drawn is not None:
        from wraparc.answer.probability_words import with_probability  # solves rows

        own = with_probability(own, drawn)
    return {
        **verdict_object(own, in_units),
        "checks": [check_data(check) for check in verdict.listed],
    }
