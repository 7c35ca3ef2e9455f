"""What a study says in sentences: its headline, how its fields are called, its histograms."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from wraparc.alike import largest
from wraparc.answer.sheet import Also, Row, Table, Verdict, named, percent, quantity, started
from wraparc.checks import RULES, Check, Level
from wraparc.checks.action import Action
from wraparc.glossary import GLOSSARY
from wraparc.study.fields import names_of
from wraparc.study.histogram import LEAST, LIMITED, Histogram, Limit
from wraparc.study.monte_carlo import Group, Summary
from wraparc.study.sensitivity import Global
from wraparc.units import Dimension, distinct, in_units

_SETTINGS = {"engineering": "creep within 1e-4", "precise": "the accuracy of `wraparc solve`"}
_NO_ANSWER = (
    ("refused", "the friction law is unfit for their arc"),
    ("invalid", "their tensions or sizes cannot be"),
    ("unsolved", "the solver did not reach its accuracy"),
)
_ENDS = (
    (Level.FAULT, "could not be solved"),
    (Level.FAILS, "fail"),
    (Level.ATTENTION, "need attention"),
    (Level.OK, "pass"),
)
#: What the limit of a result is called.
LIMITS = dict.fromkeys(LEAST, "the margin") | {
    name: rules[0].what for name, rules in LIMITED.items()
}


def subtitle(data: Mapping[str, Any]) -> str:
    """Return how many designs there are, how they are drawn and solved."""
    drawn = f", {data['sampling']} draws, seed {data['seed']}" if data["sampling"] else ""
    cases = _cases(data)
    times = f" in {cases} cases" if cases > 1 else ""
    setting = _SETTINGS[data["setting"]]
    return f"{data['designs']:,} designs{times}{drawn}; {data['setting']} setting, {setting}."


def _cases(data: Mapping[str, Any]) -> int:
    return len(data["load_cases"]) * max(1, len(data["conditions"]))


def verdict(summary: Summary, indices: Global | None = None) -> Verdict:
    """Return the answer in words: the share beyond the creep limit, how rows end, what governs.

    Parameters
    ----------
    summary
        The results of a study.
    indices
        Parts of their variance, if they were asked for.
    """
    counts, judged, total = summary.counts, summary.judged, sum(summary.counts.values())
    missed = judged.missed
    level = Level.ATTENTION if missed or judged.total < total else Level.OK
    if judged.share(Level.FAILS).count == total:
        level = Level.FAILS
    what = "designs" if _cases(summary.data) == 1 else "rows"
    unanswered = sum(counts[word] for word, _ in _NO_ANSWER)
    lost = _lost((counts["breakaway"], "in gross slip"), (unanswered, "without an answer"))
    ends = f"{started(_ends(summary))}."
    sentences = [ends, *([f"{started(lost)}."] if lost else [])]
    also = [ends] if level is Level.ATTENTION else []
    for word, why in _NO_ANSWER:
        if counts[word]:
            sentences.append(f"{counts[word]:,} {what} have no answer: {why}.")
    if missed:
        name, most = next(iter(missed.items()))
        of = part(most, sum(missed.values())) if len(missed) > 1 else "all"
        sentences.append(f"{started(RULES[name].what)} governs {of} of these.")
        also += sentences[-1:] if also and summary.over_limit.count else []
    left = summary.data.get("not_checked", ())
    ground = summary.data.get("ground", "") if level is Level.OK else ""
    if left:
        sentences.append(f"Rows leave out {' and '.join(left)}, which `wraparc solve` checks.")
    label = f"{level}, {ground}" if ground else ""
    return Verdict(
        level,
        _sentence(summary, level, what),
        tuple(sentences),
        label,
        action=_first_input(summary, indices) if level is not Level.OK else None,
        also=tuple(Also(level, text) for text in also),
        data=summary.data.get("data_line", ""),
        name="study",
    )


def _first_input(summary: Summary, indices: Global | None) -> Action | None:
    """Return which input to control first: the one that makes most of the variance of the creep."""
    of_creep = [
        of_case["exit_creep"] for of_case in (indices or {}).values() if "exit_creep" in of_case
    ]
    inputs = [one for found in of_creep for one in found.inputs]
    if not inputs:
        return None
    most = largest(inputs, lambda one: one.first)
    name = names_of(summary.data)(most.name)
    return Action(f"Try controlling {name} first: {percent(most.first, 2)} of the creep variance.")


def _sentence(summary: Summary, level: Level, what: str) -> str:
    """Say in one sentence how many designs pass, or miss which limit."""
    over, total, missed = summary.over_limit, sum(summary.counts.values()), summary.judged.missed
    if level is Level.OK:
        return f"All {total:,} {what} pass.{_closest(summary)}"
    governing = RULES[next(iter(missed))].what if missed else ""
    if level is Level.FAILS:
        return f"All {total:,} {what} fail{f'; governing: {governing}' if missed else ''}."
    weighted = _weighted(summary, lambda group: group.over_limit.value)
    if over.count and not math.isnan(weighted):
        return f"{_over_time(weighted, summary, what)}."
    if over.count:
        return f"{_exceed('exit_creep', over.count, over.total, what, summary.creep_limit)}."
    if not missed:
        return (
            f"{started(part(total - summary.judged.total, total))} of {total:,} {what} not judged."
        )
    count = sum(missed.values())
    return (
        f"{started(part(count, total))} of {total:,} {what} miss a check; governing: {governing}."
    )


def _ends(summary: Summary) -> str:
    """Say which part of all rows fails, needs attention, keeps every check."""
    total = sum(summary.counts.values())
    over_time = [
        (_weighted(summary, lambda group, level=level: group.judged.share(level).value), one)  # type: ignore[misc]
        for level, one in _ENDS
    ]
    if not math.isnan(over_time[0][0]) and summary.judged.total == total:
        return ", ".join(f"{_of_time(share)} {one}" for share, one in over_time if share > 0.0)
    ends = [(summary.judged.share(level).count, one) for level, one in _ENDS]
    ends.insert(2, (total - summary.judged.total, "could not be judged"))
    return ", ".join(f"{part(count, total)} {one}" for count, one in ends if count)


def _weighted(summary: Summary, value: Callable[[Group], float]) -> float:
    """Mean of a share over levels and load cases, each condition by its time; nan without times."""
    sums: dict[tuple[float | str, ...], float] = {}
    for group in summary.groups:
        if group.share is None:
            return math.nan
        key = (*group.levels.values(), group.load_case)
        sums[key] = sums.get(key, 0.0) + group.share * value(group)
    return sum(sums.values()) / len(sums) if sums else math.nan


def _of_time(share: float) -> str:
    told = percent(share)
    return "all" if share >= 1.0 else "none" if share <= 0.0 else told


def _over_time(share: float, summary: Summary, what: str) -> str:
    """Say how much of the time the creep limit is exceeded."""
    total, limit = summary.over_limit.total, summary.creep_limit
    beyond = _missed_limit("exit_creep", limit, some=share > 0.0)
    return f"{started(_of_time(share))} of {total:,} {what} {beyond}, weighted by time"


def part(count: int, total: int) -> str:
    """Return a share in words: all, none, or percent that never round to these."""
    if count == total:
        return "all"
    if not count:
        return "none"
    told = in_units(percent(count / total))
    if told in ("100 %", "0 %"):
        return f"all but {total - count:,}" if told == "100 %" else f"{count:,}"
    return told


def _closest(summary: Summary) -> str:
    """Say how near creep comes to its limit: the largest, where inputs are drawn in 95 %."""
    limit, places = (
        summary.creep_limit,
        (0, 2) if summary.drawn else (1,),
    )  # 5 and 95 %, braking too
    known = [group.percentiles.get("exit_creep", ()) for group in summary.groups]
    creeps = [abs(of[place]) for of in known if of for place in places]
    if not creeps or not limit.one or math.isnan(limit.least):
        return ""
    check = Check(
        name="creep", title="creep", level=Level.OK, value=max(creeps), limit=limit.least,
        dimension=GLOSSARY["exit_creep"].dimension,
    )  # fmt: skip
    return f" Closest: creep {check.measured}{' (95 %)' if summary.drawn else ''}."


def _exceed(name: str, count: int, total: int, what: str, limit: Limit) -> str:
    """Say which part of the rows misses the limit of a result."""
    beyond = _missed_limit(name, limit, some=count > 0)
    return f"{started(part(count, total))} of {total:,} {what} {beyond}"


def _missed_limit(name: str, limit: Limit, *, some: bool) -> str:
    """Return that some or none misses the limit of a result, ``exceed the 6.35 mm creep limit``."""
    verb = ("exceed" if some else "exceeds") if limit.at_most else "fall short of"
    if not some and not limit.at_most:
        verb = "falls short of"
    if math.isnan(limit.least):
        return f"{verb} {LIMITS[name]}"
    ends = " to ".join(distinct(named(name, v) for v in (limit.least, limit.most)))
    if name == "exit_creep":
        return f"{verb} the {ends} creep limit"
    return f"{verb} {LIMITS[name]} of {ends}"


def _lost(*counts: tuple[int, str]) -> str:
    return " and ".join(f"{count:,} {how}" for count, how in counts if count)


def histogram_sentence(name: str, found: Histogram) -> str:
    """Say which part of the draws misses the limit of a result; what is drawn otherwise."""
    lost = _lost((found.away, "in gross slip"), (found.unanswered, "without an answer"))
    if math.isnan(found.limit.least):
        title = GLOSSARY[name].title
        return f"{title} of {found.total:,} draws{f'; {lost}' if lost else ''}."
    among = f", {lost} among them" if lost and found.beyond else ""
    return f"{_exceed(name, found.beyond, found.total, 'draws', found.limit)}{among}."


def varied_table(data: Mapping[str, Any]) -> Iterator[Table]:
    """Yield what is varied and how, each with its key path in the drive file."""
    called = names_of(data)
    axes = data["input"].get("study", {}).get("axis", ())
    rows = [
        Row(started(called(str(axis["field"]))), (str(axis["field"]), _spread(axis)))
        for axis in axes
    ]
    if rows:
        heads = ("field of the drive file", "values")
        yield Table("Variables", tuple(rows), heads, name="varied")


def _spread(axis: Mapping[str, Any]) -> str:
    """Say how an axis is spread, as its file does."""
    values = axis.get("values")
    if values is not None:
        return ", ".join(str(v) for v in values)
    kind = [str(axis["distribution"])] if "distribution" in axis else []
    spread = [
        f"{str(key).replace('_', ' ')} {value}"
        for key, value in axis.items()
        if key not in ("field", "distribution", "provenance")
    ]
    return ", ".join(kind + spread)


def value_of(name: str, value: float | str, units: Mapping[str, Dimension | None]) -> str:
    """Return the value of a field in its unit."""
    dimension = units.get(name)
    if isinstance(value, str | bool) or dimension is None:
        return str(value)
    return quantity(value, dimension)


def group_name(group: Group, units: Mapping[str, Dimension | None]) -> str:
    """Return the levels of a group."""
    parts = [value_of(name, value, units) for name, value in group.levels.items()]
    return ", ".join(parts)
