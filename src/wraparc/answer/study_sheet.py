"""The sheet of a study, and its results as plain data."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from wraparc.alike import ALIKE
from wraparc.answer.sheet import (
    NONE,
    Row,
    Sheet,
    Table,
    headed,
    named,
    number,
    percent,
    quantity,
    started,
)
from wraparc.answer.study_words import group_name, subtitle, varied_table, verdict
from wraparc.checks import RULES, Level
from wraparc.glossary import GLOSSARY
from wraparc.study.fields import Called, names_of
from wraparc.study.monte_carlo import PERCENTS, Group, Summary, over_conditions
from wraparc.study.sensitivity import Global, Local, Swing
from wraparc.study.share import CONFIDENCE, Share
from wraparc.units import Dimension, bare, fixed

#: Results that a table of groups shows the percentiles of.
_SHOWN = ("exit_creep", "least_exit_tension", "creep_limit_margin", "peak_shear_stress")
_MOST_ROWS, _SHORT_ROWS = 60, 8
BAD = (Level.FAILS, Level.ATTENTION)


def study_sheet(
    summary: Summary,
    units: Mapping[str, Dimension | None],
    *,
    local: Local | None = None,
    indices: Global | None = None,
    remarks: Sequence[str] = (),
    sources: Sequence[str] = (),
) -> Sheet:
    """Return what a study says.

    Parameters
    ----------
    summary
        Its results.
    units
        What the fields of its axes measure.
    local, indices
        Sensitivities, if they were asked for.
    remarks, sources
        What else a reader must know, and where numbers came from.
    """
    data = summary.data
    tables: list[Table] = []
    if indices is not None:
        tables += _index_tables(indices, names_of(data))
    if local is not None:
        wanted = set(next(iter(indices.values()), {})) if indices else None
        tables += _tornado_tables(local, units, names_of(data), wanted)
    if local is None and summary.groups:
        tables += _group_tables(summary, units)
    tables += varied_table(data)
    told = verdict(summary, indices)
    return Sheet(
        title=str(data["title"]),
        subtitle=subtitle(data),
        verdict=told,
        tables=tuple(tables),
        remarks=(*_remarks(summary), *remarks),
        sources=tuple(sources),
    )


def _group_tables(summary: Summary, units: Mapping[str, Dimension | None]) -> Iterator[Table]:
    called = names_of(summary.data)
    fields = ", ".join(called(name) for name in summary.data["levels"])
    by_case: dict[tuple[str, str], list[Group]] = {}
    for group in summary.groups:
        by_case.setdefault((group.load_case, group.condition), []).append(group)
    worst = max(by_case, key=lambda case: _badness(by_case[case]), default=None)
    for (load, condition), groups in by_case.items():
        where = ", ".join(part for part in (load, condition) if part)
        if summary.drawn:
            title = f"{where}: probability by {fields or 'all draws'}"
            table = _chances(title, groups, units)
        else:
            table = _values(f"{where}: by {fields}", groups, units)
        short = _worst_rows(table, groups) if (load, condition) == worst else Table("", ())
        yield replace(table, short=short)
    together = over_conditions(summary) if summary.drawn else ()
    if together:
        yield _together(together, units)
    if summary.drawn:
        yield _convergence(summary, units)


def _badness(groups: Sequence[Group]) -> tuple[float, ...]:
    """Return how large a share of groups fails, then how large a share asks for attention."""
    return tuple(sum(group.judged.share(level).value for group in groups) for level in BAD)


def _worst_rows(table: Table, groups: Sequence[Group]) -> Table:
    """Return a table of groups with those that come off worst, in their order."""
    by_badness = sorted(
        range(len(table.rows)), key=lambda i: _badness(groups[i : i + 1]), reverse=True
    )
    return replace(table, rows=tuple(table.rows[i] for i in sorted(by_badness[:_SHORT_ROWS])))


def _chances(title: str, groups: Sequence[Group], units: Mapping[str, Dimension | None]) -> Table:
    outputs = [n for n in _SHOWN[:2] if n in groups[0].percentiles]
    heads = ["fails", "attention", "breakaway", f"creep over limit [{CONFIDENCE:.0%} interval]"]
    for name in outputs:
        short = {"exit_creep": "creep", "least_exit_tension": "T2 for the limit"}[name]
        heads += [headed(f"{short} {p:g} %", GLOSSARY[name].dimension) for p in PERCENTS[1:3]]
    rows = []
    for group in groups[:_MOST_ROWS]:
        cells = [percent(group.judged.share(level).value) for level in BAD]
        cells.append(percent(group.breakaway.value))
        cells.append(_with_interval(group.over_limit))
        for name in outputs:
            of = group.percentiles[name]
            cells += [number(name, value) for value in of[1:3]]
        rows.append(Row(group_name(group, units) or "all", tuple(cells)))
    lacking = any(math.isinf(v) for g in groups for n in outputs for v in g.percentiles[n][1:3])
    note = "infinite: so many draws have none within the tested pressures" if lacking else ""
    more = len(groups) - len(rows)
    note += f"; {more} more in the file" if more > 0 else ""
    return Table(title, tuple(rows), tuple(heads), note, "groups")


def _with_interval(share: Share) -> str:
    low, high = share.interval
    return f"{percent(share.value)} [{bare(100 * low, 'number')}-{bare(100 * high, 'number')}]"


def _values(title: str, groups: Sequence[Group], units: Mapping[str, Dimension | None]) -> Table:
    """Results of a grid, a design a row."""
    names = [n for n in _SHOWN if n in groups[0].percentiles]
    heads = ["answer"]
    heads += [headed(GLOSSARY[name].title, GLOSSARY[name].dimension) for name in names]
    rows = []
    for group in groups[:_MOST_ROWS]:
        cells = [_answer(group)]
        cells += [number(name, group.percentiles[name][1]) for name in names]
        rows.append(Row(group_name(group, units), tuple(cells)))
    more = len(groups) - len(rows)
    note = f"{more} more designs are in the file" if more > 0 else ""
    return Table(title, tuple(rows), tuple(heads), note, "groups")


def _answer(group: Group) -> str:
    """Say how a single design ends: its verdict with what governs it, or why there is none."""
    for level, name in group.judged.counts:
        return level if level == str(Level.OK) else f"{level}: {RULES[name].what}"
    return next(word for word, count in group.counts.items() if count)


def _together(
    groups: Sequence[tuple[Group, float, float]],
    units: Mapping[str, Dimension | None],
) -> Table:
    rows = []
    for group, away, over in groups[:_MOST_ROWS]:
        parts = (group_name(group, units), group.load_case)
        name = ", ".join(part for part in parts if part)
        rows.append(Row(name, (percent(away), percent(over))))
    note = "each condition counted by its share of the time"
    heads = ("breakaway", "creep over limit")
    return Table("Over all conditions", tuple(rows), heads, note, "together")


def _convergence(summary: Summary, units: Mapping[str, Dimension | None]) -> Table:
    """How the estimate settles, for the group that is least certain."""
    group = max(summary.groups, key=lambda g: g.over_limit.interval[1] - g.over_limit.interval[0])
    rows = [
        Row(f"{s.draws:,} draws", (percent(s.breakaway.value), _with_interval(s.over_limit)))
        for s in group.steps[-6:]
    ]
    parts = (group_name(group, units), group.load_case, group.condition)
    where = ", ".join(part for part in parts if part)
    heads = ("breakaway", f"creep over limit [{CONFIDENCE:.0%} interval]")
    return Table(
        f"Convergence where it is most uncertain ({where})", tuple(rows), heads, name="convergence"
    )


def _index_tables(indices: Global, called: Called) -> Iterator[Table]:
    for (load, condition), of_case in indices.items():
        where = ", ".join(part for part in (load, condition) if part)
        for name, found in of_case.items():
            title = f"{GLOSSARY[name].title}, {where}: part of the variance (Sobol indices)"
            spread = named(name, found.deviation)
            if not found.inputs:
                lost = f"{found.lost:,} of {found.samples:,} draws lack the result"
                note = f"no indices: {lost}; use creep_limit_margin, which gross slip has too"
                rows = [Row("none", (NONE, NONE))]
                yield Table(title, tuple(rows), ("alone", "with others"), note, "indices")
                continue
            rows = [
                Row(
                    started(called(i.name)),
                    (
                        _index(i.first, i.first_interval),
                        _index(i.total, i.total_interval),
                    ),
                    name=i.name,
                )
                for i in found.inputs
            ]
            note = f"standard deviation {spread}; {found.samples:,} draws"
            note += f", {found.lost:,} left out" if found.lost else ""
            heads = (f"alone [{CONFIDENCE:.0%}]", f"with others [{CONFIDENCE:.0%}]")
            yield Table(title, tuple(rows), heads, note, "indices")


def _index(value: float, interval: tuple[float, float]) -> str:
    return f"{fixed(value, 3)} [{fixed(interval[0], 3)} to {fixed(interval[1], 3)}]"


def _tornado_tables(
    local: Local,
    units: Mapping[str, Dimension | None],
    called: Called,
    wanted: set[str] | None,
) -> Iterator[Table]:
    for (load, condition), of_case in local.items():
        where = ", ".join(part for part in (load, condition) if part)
        for name, swings in of_case.items():
            if (wanted is not None and name not in wanted) or not swings:
                continue
            rows = [
                Row(
                    started(called(s.field)),
                    (
                        named(name, s.per_percent),
                        _range(s, units),
                        f"{named(name, s.at_low)} to {named(name, s.at_high)}",
                    ),
                    name=s.field,
                )
                for s in swings
            ]
            base = named(name, swings[0].base)
            yield Table(
                f"{GLOSSARY[name].title}, {where}: each input alone",
                tuple(rows),
                ("for 1 % more", "plausible range", "result over it"),
                f"{base} with every input at its median; plausible range: 5 % to 95 %",
                "alone",
            )


def _range(swing: Swing, units: Mapping[str, Dimension | None]) -> str:
    dimension = units.get(swing.field) or "number"
    return " to ".join(quantity(v, dimension) for v in (swing.low, swing.high))


def _remarks(summary: Summary) -> Iterator[str]:
    data = summary.data
    if not summary.groups:
        yield "Too many combinations to list here: read the file, pandas.read_parquet(...)."
    shares = [
        (g.percentiles["outside_tested_share"][2], g)
        for g in summary.groups
        if "outside_tested_share" in g.percentiles
    ]
    worst = max((v for v, _ in shares if not math.isnan(v)), default=0.0)
    if worst > ALIKE:
        yield (
            f"Up to {percent(worst, 2)} of the wrap (95 % of the rows) lies outside the tested "
            "range of the lagging: an extrapolation."
        )
    if data["plan"] == "sweep" and data["sampling"] in ("sobol", "latin-hypercube"):
        yield (
            f"The intervals are those of independent draws; {data['sampling']} draws are spread "
            "more evenly, and mostly nearer to the truth than that."
        )
    if data["sampling"] == "sobol" and data["samples"] & (data["samples"] - 1):
        yield f"{data['samples']:,} samples is no power of 2: Sobol points are then less even."
