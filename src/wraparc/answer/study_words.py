"""What a study says in sentences: its headline, how its fields are called, its histograms."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from wraparc.answer.sheet import Row, Table, Verdict, named, percent, quantity, started
from wraparc.checks import RULES, Level
from wraparc.glossary import GLOSSARY
from wraparc.study.fields import names_of
from wraparc.study.histogram import LEAST, LIMITED, Histogram, Limit
from wraparc.study.monte_carlo import Group, Summary
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
    (Level.OK, "pass every check that is made"),
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


def verdict(summary: Summary) -> Verdict:
    """Return the answer in words: the share beyond the creep limit, how rows end, what governs."""
    counts, judged, total = summary.counts, summary.judged, sum(summary.counts.values())
    missed = judged.missed
    level = Level.ATTENTION if missed or judged.total < total else Level.OK
    if judged.share(Level.FAILS).count == total:
        level = Level.FAILS
    what = "designs" if _cases(summary.data) == 1 else "rows"
    unanswered = sum(counts[word] for word, _ in _NO_ANSWER)
    lost = ((counts["breakaway"], "in gross slip"), (unanswered, "without an answer"))
    sentences = [f"{started(_ends(summary))}{_among(lost)}."]
    for word, why in _NO_ANSWER:
        if counts[word]:
            sentences.append(f"{counts[word]:,} {what} have no answer: {why}.")
    if missed:
        name, most = next(iter(missed.items()))
        of = part(most, sum(missed.values())) if len(missed) > 1 else "all"
        governs = f"{started(RULES[name].what)} governs {of} of those that fail or need attention."
        sentences.append(governs)
    left = summary.data.get("not_checked", ())
    ground = summary.data.get("ground", "") if level is Level.OK else ""
    if left:
        sentences.append(f"Rows leave out {' and '.join(left)}, which `wraparc solve` checks.")
    label = f"{level}, {ground}" if ground else ""
    text, data = _sentence(summary, level, what), summary.data.get("data_line", "")
    return Verdict(level, text, tuple(sentences), label, data=data, name="study")


def _sentence(summary: Summary, level: Level, what: str) -> str:
    """Say in one sentence how many designs pass, or miss which limit."""
    over, total, missed = summary.over_limit, sum(summary.counts.values()), summary.judged.missed
    if level is Level.OK:
        return f"All {total:,} {what} pass."
    governing = RULES[next(iter(missed))].what if missed else ""
    if level is Level.FAILS:
        return f"All {total:,} {what} fail{f'; governing: {governing}' if missed else ''}."
    weighted = _weighted(summary, lambda group: group.over_limit.value)
    if over.count and not math.isnan(weighted):
        return f"{_over_time(weighted, summary, what)}."
    if over.count:
        beyond = _exceed("exit_creep", over.count, over.total, what, summary.creep_limit)
        return f"{beyond}."
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
    """Say how much of the time the creep limit is not kept."""
    total = summary.over_limit.total
    count = 0 if share <= 0.0 else total if share >= 1.0 else 1  # for none, all and the verb
    text = _exceed("exit_creep", count, total, what, summary.creep_limit)
    rest = text.partition(f" of {total:,} ")[2]
    weighted = "weighted by time"
    return f"{started(_of_time(share))} of {total:,} {rest}, {weighted}"


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


def _exceed(name: str, count: int, total: int, what: str, limit: Limit) -> str:
    """Say which part of the rows does not keep the limit of a result."""
    verb = "exceed" if limit.at_most else "fall short of"
    if not count:
        verb = "exceeds" if limit.at_most else "falls short of"
    words = LIMITS[name]
    if not math.isnan(limit.least):
        ends = distinct(named(name, v) for v in (limit.least, limit.most))
        words += f" of {' to '.join(ends)}"
    return f"{started(part(count, total))} of {total:,} {what} {verb} {words}"


def _among(lost: tuple[tuple[int, str], ...]) -> str:
    told = " and ".join(f"{count:,} {how}" for count, how in lost if count)
    return f", {told} among them" if told else ""


def histogram_sentence(name: str, found: Histogram) -> str:
    """Say which part of the draws does not keep the limit of a result; what is drawn otherwise."""
    lost = _among(((found.away, "in gross slip"), (found.unanswered, "without an answer")))
    if math.isnan(found.limit.least):
        without = lost.removesuffix(" among them").removeprefix(", ")
        title = GLOSSARY[name].title
        return f"{title} of {found.total:,} draws{f'; {without}' if without else ''}."
    said = _exceed(name, found.beyond, found.total, "draws", found.limit)
    return f"{said}{lost if found.beyond else ''}."


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
        yield Table("What is varied", tuple(rows), heads, name="varied")


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
