"""A drive learned from its logs, in words and tables."""

import math
from collections import Counter
from collections.abc import Iterator
from typing import Any

from wraparc.answer.sheet import NONE, Also, Row, Sheet, Table, Verdict, percent, quantity
from wraparc.checks import Level
from wraparc.checks.action import Action
from wraparc.learn.errors import ERROR_KINDS, TAKE_UP_FRICTION
from wraparc.learn.grid import moment_of
from wraparc.learn.learn import LEAST_RANGE, MOST_MOVED, Learned, LearnedPulley
from wraparc.learn.lines import Interval, UsedUp
from wraparc.learn.write import LearnedLevels
from wraparc.units import fixed

#: Change of friction, and of a tie, below which nothing has changed [-].
_SMALL = 0.03
#: Part of the reserve left, and days to its end, below which friction asks for attention.
_LITTLE, _SOON = 0.25, 183.0
#: Loads at which the first screen tells the alarm line [-], and the speed of the usual switch.
_LOADS, _SWITCH = (0.2, 0.8), 0.20
_TABLES_OF_TWO = 2


def learn_sheet(learned: Learned) -> Sheet:
    """Return what was learned: change of friction, reserve, zero, alarm line, what was left out."""
    own = [_pulley_table(learned, pulley) for pulley in learned.pulleys]
    tables = [
        *own,
        *(_alarm_table(learned, pulley) for pulley in learned.pulleys),
        _episodes(learned),
        _errors(learned),
        _left_out(learned),
        _columns(learned),
    ]
    title = learned.plan.title or learned.plan.drive.title or "Drive"
    return Sheet(
        title=f"{title}, {learned.stop:.0f} days, {learned.windows.hours:.0f} h steady",
        verdict=_verdict(learned),
        tables=tuple(t for t in tables if t.rows),
        remarks=tuple(_remarks(learned)),
        kept=(),
    )


def day_text(learned: Learned, days: float) -> str:
    """Return a day of the log in words, ``1 March 2026``."""
    moment = moment_of(learned.grid.start + 86400.0 * days)
    return f"{moment.day} {moment:%B %Y}"


def _short_day(learned: Learned, days: float) -> str:
    return day_text(learned, days)[:-5]


def _verdict(learned: Learned) -> Verdict:
    level, text, action = _governing(learned)
    also = tuple(Also(level, sentence) for sentence in _also_sentences(learned))
    stated = len(learned.plan.errors.stated)
    assumed = len(learned.plan.errors.assumed)
    data = f"{assumed} errors assumed, {stated} stated (--table errors)."
    if learned.plan.events:
        data = f"{data[:-1]}; {len(learned.plan.events)} events stated."
    return Verdict(
        level, text, also=also, action=action, data=data, checks_at="--full", name="learn"
    )


def _governing(learned: Learned) -> tuple[Level, str, Action | None]:
    """Return the sentence that leads, with what to do."""
    if learned.unlike:
        names = ", ".join(learned.unlike)
        return (
            Level.ATTENTION,
            f"Speed scatter exceeds 5 times the usual: friction not identified ({names}).",
            Action("Check the belt speed signal: wheel, bearing, tachometer."),
        )
    if learned.moved:
        name = _moved_first(learned)[0]
        size = fixed(abs(learned.moved[name]), 1)
        return (
            Level.ATTENTION,
            f"{_error_title(name)} is {size} standard deviations off: friction not identified.",
            Action("Check motor speed, rated torque, T2, belt and lagging of the drive file."),
        )
    if not learned.tells_friction:
        return (
            Level.ATTENTION,
            f"Torque range is below {percent(LEAST_RANGE)} of rating: only the zero is known.",
            Action("Give a log with empty and loaded running."),
        )
    worst = min(learned.pulleys, key=lambda p: p.reserve.value if p.reserve else math.inf)
    since = _short_day(learned, learned.since)
    if worst.reserve is not None and worst.reserve.value <= 1.0 / (1.0 - _LITTLE):
        left = fixed(_lost(worst.reserve.value), 0, "percent fixed")
        return (
            Level.ATTENTION,
            f"Friction reserve is only {left} ({worst.name}).",
            Action("Raise T2, or plan relagging; set the alarm line (--table alarm)."),
        )
    fallen = min(
        learned.pulleys, key=lambda p: p.friction_change.value if p.friction_change else 1.0
    )
    change = fallen.friction_change
    if change is not None and change.high < 1.0 and change.value < 1.0 - _SMALL:
        fell = fixed(1.0 - change.value, 0, "percent fixed")
        return (
            Level.ATTENTION,
            f"Friction fell {fell} since {since} ({fallen.name}).",
            Action("Plan relagging; set the alarm line (--table alarm)."),
        )
    line = fallen.line
    return (
        Level.OK,
        f"Friction has not fallen since {since}; alarm {percent(line.at(_LOADS[1]))} at "
        f"{percent(_LOADS[1])} torque ({fallen.name}).",
        None,
    )


def _lost(factor: float) -> float:
    """Return by how much friction may fall, of its factor over that of gross slip [-]."""
    return 1.0 - 1.0 / factor


def _moved_first(learned: Learned) -> list[str]:
    """Return the errors that the log moved too far, the farthest first."""
    return sorted(learned.moved, key=lambda name: -abs(learned.moved[name]))


def _also_sentences(learned: Learned) -> Iterator[str]:
    others = _moved_first(learned)[1:]
    if others:
        yield f"Off instead, as well: {', '.join(map(_error_title, others))} (--table errors)."
    found = learned.episodes.found
    if found:
        worst = min(found, key=lambda e: e.change)
        day = _short_day(learned, worst.start / 86400.0)
        hours = sum(e.stop - e.start for e in found) / 3600.0
        yield (
            f"Wet or dirty: friction down to {fixed(worst.change, 0, 'percent signed')} "
            f"({len(found)} times, {hours:.0f} h; worst {day})."
        )
    if learned.cannot:
        yield f"Not known: {'; '.join(learned.cannot)}."


def _pulley_table(learned: Learned, pulley: LearnedPulley) -> Table:
    """Return what the first screen tells of a pulley."""
    since = _short_day(learned, learned.since)
    rows = []
    if pulley.friction is not None:
        note = "width set by torque and belt modulus, not by hours"
        rows.append(
            Row("Friction of its law", _factor(pulley.friction), note=note, name="friction")
        )
    if pulley.friction_change is not None:
        c = pulley.friction_change
        changed = Interval(c.value - 1.0, c.low - 1.0, c.high - 1.0)
        rows.append(Row(f"Change since {since}", _signed(changed, 0), name="change"))
    if pulley.reserve is not None:
        r = pulley.reserve
        lost = Interval(_lost(r.value), _lost(r.low), _lost(r.high))
        note = f"at {percent(pulley.top_torque, 2)} torque, the highest seen"
        rows.append(Row("Friction reserve", _share(lost), note=note, name="friction_reserve"))
    elif pulley.friction is not None:
        note = "no gross slip at any tabled friction"
        rows.append(Row("Friction reserve", (NONE, NONE), note=note, name="friction_reserve"))
    if pulley.used_up is not None:
        rows.append(Row("Reserve used up", _date(learned, pulley.used_up), name="used_up"))
    rows.append(Row("Zero of speed", _signed(pulley.zero, 2), name="zero"))
    worn = _worn(learned, pulley)
    rows.append(
        Row(f"Zero since {since}", _signed(pulley.zero_change, 2), note=worn, name="zero_change")
    )
    low, high = (f"{percent(pulley.line.at(m))} at {percent(m)} torque" for m in _LOADS)
    rows.append(Row("Alarm line", (low, high), name="alarm_line"))
    few, many = pulley.line.false_alarms
    rows.append(
        Row(
            "False alarms a running year",
            (_rate(few), f"up to {_rate(many)}" if many >= 1.0 else ""),
            name="false_alarms",
        )
    )
    slips = pulley.line.at(1.0, "trip") < _SWITCH
    rows.append(
        Row(
            "80 % speed switch",
            ("after gross slip" if slips else "before the trip line", ""),
            name="switch",
        )
    )
    share = percent(learned.grid.share_left_out, 2)
    rows.append(Row("Left out", (share, _reasons(learned)), name="left_out"))
    name = f", {pulley.name}" if len(learned.pulleys) > 1 else ""
    return Table(f"Learned{name}", tuple(rows), ("value", "95 % interval"), name="learned")


def _factor(of: Interval) -> tuple[str, str]:
    cells = [fixed(v, 2) for v in (of.value, of.low, of.high)]
    return cells[0], f"{cells[1]} to {cells[2]}"


def _signed(of: Interval, digits: int) -> tuple[str, str]:
    cells = [fixed(v, digits, "percent signed") for v in (of.value, of.low, of.high)]
    return cells[0], f"{cells[1]} to {cells[2]}"


def _share(of: Interval) -> tuple[str, str]:
    cells = [fixed(v, 0, "percent fixed") for v in (of.value, of.low, of.high)]
    return cells[0], f"{cells[1]} to {cells[2]}"


def _rate(value: float) -> str:
    return "below 1" if value < 1.0 else NONE if math.isinf(value) else f"{math.ceil(value)}"


def _rates(few: float, many: float) -> str:
    return f"{_rate(few)} to {_rate(many)}" if many >= 1.0 else _rate(few)


def _worn(learned: Learned, pulley: LearnedPulley) -> str:
    """Return a change of the zero as wear of the pulley, where it is one."""
    radius = learned.plan.drive.pulley(pulley.name).radius
    c = pulley.zero_change
    low, value, high = (quantity(v * radius, "length", 2) for v in (c.low, c.value, c.high))
    if not c.excludes_zero:
        return "no wear that shows"
    what = "pulley worn" if c.value > 0.0 else "pulley grown (dirt)"
    return f"{what} {value} ({low} to {high}), or measuring wheel"


def _date(learned: Learned, of: UsedUp) -> tuple[str, str]:
    """Return when the reserve is used up, as far as it can be told."""
    if not of.is_told or not math.isfinite(of.earliest):
        return "no fall that shows", ""
    if of.earliest > of.horizon:
        return f"not within {of.horizon:.0f} days at this rate", ""
    earliest = f"not before {day_text(learned, learned.stop + of.earliest)}"
    if of.expected > of.horizon:
        return earliest, ""
    return earliest, f"expected {day_text(learned, learned.stop + of.expected)}"


def _reasons(learned: Learned) -> str:
    found = Counter(span.why for span in learned.grid.left_out)
    return ", ".join(f"{n} {why}" for why, n in found.most_common(3))


def _alarm_table(learned: Learned, pulley: LearnedPulley) -> Table:
    """Return the levels by torque, as a control system takes them."""
    line = pulley.line
    rows = [
        Row(str(percent(m)), (percent(n), percent(a), percent(t)), name=f"torque_{100.0 * m:.0f}")
        for m, n, a, t in zip(line.torque, line.normal, line.alarm, line.trip, strict=True)
    ]
    few, many = line.false_alarms
    note = (
        "1 - v/(omega R/i) by torque, mean of two minutes in steady running, over the zero of "
        f"{day_text(learned, learned.stop - 0.02)}; {_rates(few, many)} false alarms a "
        "running year. Learn anew after relagging or a change of the wheel."
    )
    return Table(
        f"Alarm line, {pulley.name}", tuple(rows), ("normal", "alarm", "trip"), note, "alarm"
    )


def levels_table(levels: LearnedLevels) -> Table:
    """Return the levels that a drive file has from a log."""
    rows = [
        Row(str(percent(m)), (percent(n), percent(a), percent(t)))
        for m, n, a, t in zip(levels.torque, levels.normal, levels.alarm, levels.trip, strict=True)
    ]
    title = f"Levels learned from logs to {levels.until}, by torque, {levels.pulley}"
    return Table(title, tuple(rows), ("normal", "alarm", "trip"), name="learned")


def _episodes(learned: Learned) -> Table:
    """Return the spans of lower friction, the deepest first."""
    found = sorted(learned.episodes.found, key=lambda e: e.change)
    rows = [
        Row(
            _moment(learned, e.start),
            (
                f"{(e.stop - e.start) / 3600.0:.1f} h",
                fixed(e.change, 0, "percent signed"),
                percent(e.torque, 2),
            ),
        )
        for e in found
    ]
    return Table("Wet or dirty episodes", tuple(rows), ("length", "friction", "torque up to"),
                 name="episodes")  # fmt: skip


def _moment(learned: Learned, seconds: float) -> str:
    moment = moment_of(learned.grid.start + seconds)
    return f"{moment.day} {moment:%B %H:%M}"


def _error_title(name: str) -> str:
    key, _, pulley = name.partition(".")
    title = ERROR_KINDS[key].title
    return f"{title} ({pulley})" if pulley else title


def _errors(learned: Learned) -> Table:
    """Return every error: stated or assumed, and how the log moves it."""
    errors, fit = learned.plan.errors, learned.fit
    now, moved, alone = fit.nuisance(), fit.moved(), fit.by_log_alone()
    rows = []
    for key in ERROR_KINDS:
        names = [n for n in fit.prior_sd if n.partition(".")[0] == key] or [key]
        for name in names:
            sd = fit.prior_sd.get(name, errors.sd(key))
            value = percent(now[name], 2) if name in now else NONE
            size = fixed(moved[name], 1, "signed") if name in moved else NONE
            level = Level.ATTENTION if name in moved and abs(moved[name]) > MOST_MOVED else None
            source = "stated" if key in errors.stated else "assumed"
            by_log = percent(alone[name], 2) if name in alone else NONE
            cells = (percent(sd, 2), source, value, by_log, size)
            rows.append(Row(_error_title(name), cells, level=level))
    note = (
        f"Standard deviations. Take-up friction is expected at {percent(TAKE_UP_FRICTION)}. By the "
        "log alone: were nothing stated of this error and the others as stated. Write "
        "those that are known into [errors]: an error smaller than it is makes intervals that do "
        "not contain the truth."
    )
    heads = (
        "standard deviation", "source", "estimate", "by the log alone", "in standard deviations",
    )  # fmt: skip
    return Table("Errors of the log", tuple(rows), heads, note, "errors")


def _left_out(learned: Learned) -> Table:
    rows = [
        Row(span.tag, (_moment(learned, span.start - learned.grid.start),
                       f"{(span.stop - span.start) / 3600.0:.1f} h", span.why))
        for span in learned.grid.left_out
    ]  # fmt: skip
    return Table("Left out", tuple(rows), ("from", "length", "reason"), name="left-out")


def _columns(learned: Learned) -> Table:
    rows = [
        Row(role.replace("_", " ").replace(".", ", "), (signal.tag,))
        for role, signal in learned.log.signals.items()
    ]
    unused = ", ".join(learned.log.unused)
    note = f"Not used: {unused}." if unused else ""
    return Table("Tags", tuple(rows), ("tag",), note, "tags")


def _remarks(learned: Learned) -> Iterator[str]:
    cuts = [_short_day(learned, c) for c in learned.cuts]
    if cuts:
        yield f"Zero and friction may jump on {', '.join(cuts)}: relagged, or another wheel."
    yield (
        "The fit does not identify the lagging: with another than in the drive file, "
        "friction and reserve are those of a law that is not there."
    )
    yield (
        "Friction of an empty belt does not show in speeds. Wear of the pulley, wear of the "
        "measuring wheel and belt thickness are one zero."
    )
    yield "The date of a used-up reserve supposes that friction falls on in a straight line."


def learn_document(learned: Learned) -> dict[str, Any]:
    """Return what was learned as plain data [SI], times in ISO 8601."""
    moved = learned.fit.moved()
    return {
        "format": 1,
        "period": [_iso(learned, 0.0), _iso_of(learned.grid.start + learned.grid.time[-1])],
        "hours": learned.windows.hours,
        "columns": {role: s.tag for role, s in learned.log.signals.items()},
        "left_out": [
            {"tag": s.tag, "from": _iso_of(s.start), "to": _iso_of(s.stop), "why": s.why}
            for s in learned.grid.left_out
        ],
        "cuts": [_iso(learned, float(c)) for c in learned.cuts],
        "pulleys": [_pulley_document(learned, p) for p in learned.pulleys],
        "episodes": [
            {
                "from": _iso(learned, e.start / 86400.0), "to": _iso(learned, e.stop / 86400.0),
                "change": e.change, "torque": e.torque,
            }
            for e in learned.episodes.found
        ],
        "errors": {
            "stated": dict(learned.plan.errors.stated),
            "assumed": list(learned.plan.errors.assumed),
            "moved": {name: moved[name] for name in learned.moved},
        },
        "cannot": list(learned.cannot),
    }  # fmt: skip


def _pulley_document(learned: Learned, pulley: LearnedPulley) -> dict[str, Any]:
    """Return what was learned of one pulley as plain data."""
    times = [_iso(learned, d) for d in learned.days.tolist()]
    course = zip(times, *pulley.zero_course.tolist(), strict=True)
    line = pulley.line
    used = pulley.used_up
    return {
        "name": pulley.name,
        "zero": [{"t": t, "value": v, "low": a, "high": b} for t, v, a, b in course],
        "zero_change": _interval(pulley.zero_change),
        "friction": _interval(pulley.friction),
        "change": _interval(pulley.friction_change),
        "friction_reserve": _interval(pulley.reserve),
        "used_up": used
        and {
            "is_told": used.is_told, "rate_per_day": _interval(used.rate),
            "earliest_days": _finite(used.earliest), "expected_days": _finite(used.expected),
            "horizon_days": used.horizon,
        },
        "alarm_line": [
            {"torque": m, "normal": n, "alarm": a, "trip": t}
            for m, n, a, t in zip(
                line.torque.tolist(), line.normal.tolist(), line.alarm.tolist(),
                line.trip.tolist(), strict=True,
            )
        ],
        "false_alarms": [_finite(v) for v in line.false_alarms],
        "share": learned.grid.share_left_out,
        "sensitivity": pulley.sensitivity,
    }  # fmt: skip


def _interval(of: Interval | None) -> dict[str, float] | None:
    return None if of is None else {"value": of.value, "low": of.low, "high": of.high}


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _iso(learned: Learned, days: float) -> str:
    return _iso_of(learned.grid.start + 86400.0 * days)


def _iso_of(seconds: float) -> str:
    return moment_of(seconds).isoformat()
