"""The list of checks as every door shows it: a table, a summary, plain data."""

import math
from typing import Any

from wraparc.answer.sheet import NONE, Row, Table, quantity
from wraparc.answer.sources import Sources
from wraparc.checks import Check, Level, Verdict

_SAME = 1e-9
#: Checks that a short answer shows, if no more are missed.
_NEAREST = 4
#: What to know about the table.
NOTE = (
    "Margin: how far the value is from its limit, over the limit; positive on the safe side. Each "
    "check is shown where it comes off worst."
)


def check_table(verdict: Verdict, of: Sources | None = None, title: str = "Checks") -> Table:
    """Return each check with what was found, its limit, its margin, and where.

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
    rows = tuple(_row(check, of) for check in judged)
    return Table(
        title,
        rows,
        ("found", "limit", "margin"),
        f"{NOTE}{_left(verdict)}",
        name="checks",
        short=_nearest(verdict, title),
        brief=f"{f'{_counted(verdict)}. ' if verdict.missed else ''}{_unchecked(verdict)}".strip(),
    )


def _nearest(verdict: Verdict, title: str) -> Table:
    """Return the checks that are missed, and the nearest to their limits of the others."""
    told = [c for c in verdict.listed if c.compares and (c.missed or math.isfinite(c.margin))]
    told = sorted((c for c in told if not c.below), key=verdict.nearness)
    rows = (
        Row(c.title, (c.texts()[0] or NONE, c.bound() or NONE), "", str(c.level))
        for c in told[: max(_NEAREST, len(verdict.missed))]
    )
    return Table(title, tuple(rows), ("found", "limit"), name="checks")


def _row(check: Check, of: Sources | None) -> Row:
    found, _ = check.texts()
    values = (found or NONE, check.bound() or NONE, margin_text(check))
    number = "" if of is None else of.number(check.source)
    note = " ".join(part for part in (str(check.place), number) if part)
    return Row(check.title, values, note=note, level=check.level)


def _left(verdict: Verdict) -> str:
    """Say what was not checked, and why."""
    left = [c for c in verdict.listed if c.level is Level.NOT_CHECKED]
    told = (f"{c.title[:1].lower()}{c.title[1:]} ({_why(c)})" for c in left)
    return f" Not checked: {'; '.join(told)}." if left else ""


def _why(check: Check) -> str:
    found, _ = check.texts()
    return f"{check.short}; here it is {found}" if found else check.short


def margin_text(check: Check) -> str:
    """Return a margin as percent with its sign; what is far from its limit as so many times it."""
    margin = check.margin
    if check.below:
        return NONE
    if not math.isnan(check.times):
        return f"{quantity(check.times, 'number')} times the limit"
    if not math.isfinite(margin):
        return NONE
    if 0.9995 <= margin < 1.0 - _SAME:
        return "> +99.9 %"
    if abs(margin) < _SAME:
        return "0 %"
    return f"{100.0 * margin:+.3g} %"


def checks_summary(verdict: Verdict) -> str:
    """Return how the checks end, in one sentence."""
    missed = "; ".join(f"{c.level}: {c.title}" for c in verdict.missed)
    left = ", ".join(c.title for c in verdict.listed if c.level is Level.NOT_CHECKED)
    left = f" Not checked for want of data: {left}." if left else ""
    return f"{_counted(verdict)}.{f' {missed}.' if missed else ''}{left}"


def _counted(verdict: Verdict) -> str:
    judged = [c for c in verdict.listed if c.compares]
    return f"{sum(not c.missed for c in judged)} of {len(judged)} checks are kept"


def _unchecked(verdict: Verdict) -> str:
    left = [c.title for c in verdict.listed if c.level is Level.NOT_CHECKED]
    heads = [title.partition(",")[0] for title in left]
    told = (
        head if heads.count(head) > 1 else title for head, title in zip(heads, left, strict=True)
    )
    return f"Not checked: {'; '.join(dict.fromkeys(told))}." if left else ""


def check_data(check: Check) -> dict[str, Any]:
    """Return a check as plain data, numbers in SI."""
    return {
        "name": check.name,
        "title": check.title,
        "level": check.level.value,
        "pulley": check.place.pulley,
        "load_case": check.place.load_case,
        "value": check.value,
        "limit": check.limit,
        "floor": check.floor,
        "dimension": check.dimension,
        "at_most": check.at_most,
        "margin": check.margin,
        "source": check.source,
        "binding": check.binding,
        "sentence": check.sentence(),
    }


def verdict_document(verdict: Verdict) -> dict[str, Any]:
    """Return a verdict as plain data: its word, the check that governs, every check once."""
    governing = verdict.governing
    return {
        "level": verdict.level.value,
        "word": verdict.word,
        "headline": verdict.headline(),
        "sentences": list(verdict.sentences()),
        "governing": None if governing is None else check_data(governing),
        "checks": [check_data(check) for check in verdict.listed],
    }
