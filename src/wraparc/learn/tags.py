"""Logs to the signals of a drive: which tag is which, by its name; units; files in any order."""

from __future__ import annotations

import datetime as dt
import math
import os
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import InputError, Problem, format_names, name_remedy, shown
from wraparc.learn.file import LearnPlan, TagChoice
from wraparc.machine_tables import LogTag, plain_name, read_bytes, read_log, refuse_no_log
from wraparc.machine_tables.log_names import (
    CURRENT,
    POWER,
    TORQUE,
    has_word,
    is_belt_speed,
    is_motor_speed,
)
from wraparc.units import Dimension, dimension_of, unit_factor

_EXPORT = "Export one row a reading, with clock times."
_TURNS = {"1/min", "u/min", "min-1", "min^-1", "r/min", "rev/min", "upm", "/min"}
_PERCENT = {"%", "percent", "prozent", "pct"}
_RPM = 2.0 * math.pi / 60.0
#: Names of a column that say nothing, and the date or number at the end of a file's name.
_NO_NAMES = {"", "value", "values", "wert", "val", "valeur", "valor", "column 2"}
_DATED = re.compile(r"[-_ .]*(\d{4}[-_.]?\d{2}([-_.]?\d{2})?|[-_ ]\d{1,3})$")
#: Values that are alike in two files [-], how long both may differ as the clock was put back [s].
_ALIKE, _LIVED_TWICE = 1e-4, 7200.0
#: A lone reading that is so far from those before and after it has a wrong clock time [s], and
#: so are few readings that are as far from all others [s, -].
_FAR, _FARTHEST, _FEW = 3600.0, 30 * 86400.0, 0.01


@dataclass(frozen=True, eq=False)
class Signal:
    """One signal of the drive.

    Attributes
    ----------
    role
        ``speed.head``, ``torque.head``, ``belt_speed`` or ``tension``.
    tag
        Name in the log.
    times
        Of its readings, in time order [s since 1970].
    values
        Motor speed [rad/s], torque over rated torque [-], belt speed [m/s], tension [N].
    put_back
        Spans of local time that were lived twice [s since 1970].
    """

    role: str
    tag: str
    times: Array
    values: Array
    put_back: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True, eq=False)
class Log:
    """The signals of a drive, and how it is turned.

    Attributes
    ----------
    signals
        By role.
    pulleys
        As in the plan, tags found, torque rated.
    rows
        Rows that were read.
    skipped
        Rows among them that are no readings.
    unused
        Tags that have no role.
    """

    signals: dict[str, Signal]
    pulleys: tuple[TagChoice, ...]
    rows: int
    skipped: int
    unused: tuple[str, ...]


def read_signals(plan: LearnPlan) -> Log:
    """Return the signals of the logs that a plan names.

    Raises
    ------
    InputError
        With everything that cannot be told, and what to write to tell it.
    """
    tags, rows, skipped, apart = _read_files(plan)
    problems: list[Problem] = []
    found: dict[str, LogTag] = {}
    pulleys = []
    belt = _find(
        tags, plan.belt_speed, is_belt_speed, "belt_speed.column", "belt speed", plan, problems
    )
    if belt:
        found["belt_speed"] = belt
    for number, choice in enumerate(plan.pulleys, start=1):
        key = f"pulley.{choice.pulley}"
        own = _own_tags(tags, choice.pulley, number, len(plan.pulleys))
        speed = _find(
            own, choice.speed, is_motor_speed, f"{key}.speed", "motor speed", plan, problems
        )
        torque = _find_torque(own, choice, key, plan, problems)
        if speed and torque:
            found[f"speed.{choice.pulley}"] = speed
            found[f"torque.{choice.pulley}"] = torque
        pulleys.append(replace(choice, speed=speed.name if speed else "",
                               torque=torque.name if torque else ""))  # fmt: skip
    if plan.tension:
        tension = _find(
            tags, plan.tension, is_belt_speed, "take_up.tension", "tension", plan, problems
        )
        if tension:
            found["tension"] = tension
    problems += [apart[name] for name in dict.fromkeys(t.name for t in found.values())
                 if name in apart]  # fmt: skip
    if problems:
        raise InputError(problems)
    signals, pulleys = _in_si(found, plan, pulleys, problems)
    if problems:
        raise InputError(problems)
    used = {tag.name for tag in found.values()}
    unused = tuple(tag.name for tag in tags if tag.name not in used)
    return Log(signals, tuple(pulleys), rows, skipped, unused)


def _read_files(plan: LearnPlan) -> tuple[list[LogTag], int, int, dict[str, Problem]]:
    """Return the tags of all files, those of one name joined, and where their files differ."""
    parts: dict[str, list[tuple[str, LogTag]]] = {}
    rows = skipped = 0
    problems: list[Problem] = []
    for path in plan.logs:
        try:
            log = read_log(read_bytes(path, _EXPORT), path, order=plan.dates)
            if log is None:
                raise refuse_no_log(path)
        except InputError as error:
            problems += error.problems
            continue
        rows, skipped = rows + log.rows, skipped + log.skipped
        for tag in log.tags:
            zoned = tag if log.is_zoned else replace(tag, times=_to_utc(tag.times, plan.zone, path))
            name = _named(tag.name, path) if len(log.tags) == 1 else tag.name
            parts.setdefault(name, []).append((path, replace(zoned, name=name)))
    if problems:
        raise InputError(problems)
    tags: list[LogTag] = []
    apart: dict[str, Problem] = {}
    for name, read in parts.items():
        pieces = [(path, _forward(piece)) for path, piece in read if len(piece.times)]
        pieces.sort(key=lambda p: float(p[1].times[0]))
        try:
            tags.extend(_joined(pieces))
        except InputError as error:
            apart[name] = error.problems[0]
            tags.append(pieces[0][1])
    return tags, rows, skipped, apart


def _named(name: str, path: str) -> str:
    """Return the name of the only tag of a file: that of the file, less its date, where none is."""
    if plain_name(name) not in _NO_NAMES:
        return name
    stem = os.path.splitext(os.path.basename(path))[0]
    return _DATED.sub("", stem).replace("_", " ").strip() or name


def _joined(pieces: Sequence[tuple[str, LogTag]]) -> list[LogTag]:
    """Return the readings of a tag in several files as one, or none where none has any.

    Raises
    ------
    InputError
        If the files have units of two kinds, or other values at the same times.
    """
    if not pieces:
        return []
    first, whole = pieces[0]
    for path, read in pieces[1:]:
        piece = _in_unit_of(whole, read, path)
        if piece.times[0] > whole.times.max():
            times = np.concatenate([whole.times, piece.times])
            values = np.concatenate([whole.values, piece.values])
        else:
            times, values = _merged(whole, piece, first, path)
        whole = LogTag(whole.name, whole.unit or piece.unit, times, values)
    return [whole]


def _in_unit_of(whole: LogTag, piece: LogTag, path: str) -> LogTag:
    """Return readings in the unit of those before; one that is stated nowhere is the same."""
    if not whole.unit or not piece.unit or whole.unit == piece.unit:
        return piece
    (kind, size), (own_kind, own_size) = _unit_of(whole.unit), _unit_of(piece.unit)
    if kind != own_kind:
        raise InputError(
            Problem(file=path, key=piece.name, value=shown(piece.unit),
                    message=f"another file has it in {shown(whole.unit)}",
                    remedy="Export it in one unit.")
        )  # fmt: skip
    return replace(piece, unit=whole.unit, values=piece.values * (own_size / size))


def _unit_of(unit: str) -> tuple[str, float]:
    """Return what a unit is of, and its size in SI."""
    plain = unit.strip().casefold()
    if plain in _PERCENT:
        return "%", 1.0
    if plain in _TURNS:
        return "rotation_speed", _RPM
    if plain in ("a", "ka"):
        return "current", 1e3 if plain == "ka" else 1.0
    dimension = dimension_of(unit)
    return (plain, 1.0) if dimension is None else (dimension, unit_factor(unit, dimension))


def _merged(whole: LogTag, piece: LogTag, first: str, path: str) -> tuple[Array, Array]:
    """Return the readings of two files that overlap in time, those that both have once."""
    order = np.argsort(whole.times, kind="stable")
    place = np.clip(np.searchsorted(whole.times[order], piece.times), 0, len(order) - 1)
    before = order[place]
    both = whole.times[before] == piece.times
    a, b = whole.values[before], piece.values
    with np.errstate(invalid="ignore"):
        alike = both & ((np.abs(a - b) <= _ALIKE * np.abs(b)) | (np.isnan(a) & np.isnan(b)))
    other = np.flatnonzero(both & ~alike & np.isfinite(a) & np.isfinite(b))
    if len(other) and np.ptp(piece.times[other]) > _LIVED_TWICE:
        k = int(other[0])
        moment = dt.datetime.fromtimestamp(float(piece.times[k]), dt.UTC)
        raise InputError(
            Problem(file=path, key=piece.name,
                    value=f"{a[k]:.5g} and {b[k]:.5g} at {moment:%Y-%m-%d %H:%M}",
                    message=f"differs from {shown(os.path.basename(first))} at the same times",
                    remedy="Leave one of the two files out.")
        )  # fmt: skip
    times = np.concatenate([whole.times, piece.times[~alike]])
    values = np.concatenate([whole.values, piece.values[~alike]])
    if not len(other) and all(np.all(np.diff(p.times) >= -60.0) for p in (whole, piece)):
        order = np.argsort(times, kind="stable")  # no clock was put back in either
        times, values = times[order], values[order]
    return times, values


def _forward(tag: LogTag) -> LogTag:
    """Return readings with the newest last, as some logs are written the other way."""
    if len(tag.times) > 1 and np.mean(np.diff(tag.times) < 0.0) > 0.5:
        return LogTag(tag.name, tag.unit, tag.times[::-1], tag.values[::-1])
    return tag


def _to_utc(times: Array, zone: str, file: str) -> Array:
    """Return local times as UTC where the zone is known, hour by hour [s]."""
    if not zone:
        return times
    try:
        info = ZoneInfo(zone)
    except (ZoneInfoNotFoundError, ValueError, OSError):
        raise InputError(
            Problem(message="no such time zone", remedy="Write for example Europe/Berlin.",
                    key="zone", value=shown(zone), file=file)
        ) from None  # fmt: skip
    hours, which = np.unique(np.floor(times / 900.0), return_inverse=True)
    offsets = []
    for hour in hours.tolist():
        local = dt.datetime.fromtimestamp(900.0 * hour, dt.UTC).replace(tzinfo=info)
        offset = local.utcoffset()
        offsets.append(offset.total_seconds() if offset else 0.0)
    return np.asarray(times - np.array(offsets)[which])


def _own_tags(tags: Sequence[LogTag], pulley: str, number: int, count: int) -> list[LogTag]:
    """Return the tags that name a pulley, or its number where several are numbered."""
    plain = plain_name(pulley)
    named = [tag for tag in tags if plain and plain in plain_name(tag.name)]
    if named and (_is_unique(named) or count > 1):
        return named
    if count > 1:
        marks = {f"m{number}", f"d{number}", f"drive{number}", f"motor{number}", str(number)}
        return [tag for tag in tags if marks.intersection(plain_name(tag.name).split())]
    return list(tags)


def _is_unique(tags: Sequence[LogTag]) -> bool:
    return sum(is_motor_speed(tag.name) for tag in tags) == 1


def _find(
    tags: Sequence[LogTag],
    name: str,
    is_role: Callable[[str], bool],
    key: str,
    words: str,
    plan: LearnPlan,
    problems: list[Problem],
) -> LogTag | None:
    """Return the tag of a role, None after saying what to write."""
    if name:
        plain = plain_name(name)
        fits = [t for t in tags if t.name == name] or [
            t for t in tags if plain in (plain_name(t.name), plain_name(f"{t.name} {t.unit}"))
        ]
        if len(fits) == 1:
            return fits[0]
        remedy = name_remedy(name, [t.name for t in tags])
        problems.append(Problem(file=plan.file, key=key, value=shown(name),
                                message="the log has no such tag", remedy=remedy))  # fmt: skip
        return None
    fits = [tag for tag in tags if is_role(tag.name)]
    if len(fits) == 1:
        return fits[0]
    names = format_names([t.name for t in fits or tags])
    message = f"several tags may be the {words}" if fits else f"no tag is named as the {words}"
    problems.append(Problem(file=plan.file, key=key, message=message,
                            remedy=f"Write which: {names}."))  # fmt: skip
    return None


def _find_torque(
    tags: Sequence[LogTag], choice: TagChoice, key: str, plan: LearnPlan, problems: list[Problem]
) -> LogTag | None:
    """Return the tag of the torque; power or, with its curve, current where there is none."""
    of = f"{key}.torque"
    if not choice.torque:
        for words in (TORQUE, POWER, *((CURRENT,) if choice.current else ())):
            if any(has_word(tag.name, words) for tag in tags):
                return _find(tags, "", partial(has_word, words=words), of, "torque", plan, problems)
    is_torque = partial(has_word, words=TORQUE)
    return _find(tags, choice.torque, is_torque, of, "torque", plan, problems)


def _in_si(
    found: dict[str, LogTag],
    plan: LearnPlan,
    pulleys: list[TagChoice],
    problems: list[Problem],
) -> tuple[dict[str, Signal], list[TagChoice]]:
    """Return the signals in SI; torque over rated torque, which is filled in where it is new."""
    signals: dict[str, Signal] = {}

    def add(role: str, tag: LogTag, factor: float | None) -> Array | None:
        if factor is None:
            return None
        times, values, back = _ascending(tag)
        signals[role] = Signal(role, tag.name, times, values * factor, back)
        return signals[role].values

    if "belt_speed" in found:
        tag = found["belt_speed"]
        unit = plan.belt_unit or tag.unit
        add("belt_speed", tag, _factor(unit, "speed", "belt_speed.unit", tag, plan, problems))
    if "tension" in found:
        tag = found["tension"]
        add("tension", tag, _factor(tag.unit, "force", "take_up.tension", tag, plan, problems))
    ready = []
    for choice in pulleys:
        key, speed = f"pulley.{choice.pulley}", found.get(f"speed.{choice.pulley}")
        torque = found.get(f"torque.{choice.pulley}")
        if speed is None or torque is None:
            ready.append(choice)
            continue
        unit = choice.speed_unit or speed.unit
        turning = _turning_factor(unit, f"{key}.speed_unit", speed, plan, problems)
        add(f"speed.{choice.pulley}", speed, turning)
        if choice.gear_ratio is None and turning is not None:
            problems.append(_ask_gear(choice, speed, turning, found.get("belt_speed"), plan))
        ready.append(_torque_signal(choice, torque, signals, key, plan, problems))
    return signals, ready


def _torque_signal(
    choice: TagChoice,
    tag: LogTag,
    signals: dict[str, Signal],
    key: str,
    plan: LearnPlan,
    problems: list[Problem],
) -> TagChoice:
    """Add the torque over rated torque of a pulley; return what turns it, with a rated torque."""
    unit = (choice.torque_unit or tag.unit).strip()
    role = f"torque.{choice.pulley}"
    times, values, back = _ascending(tag)

    def problem(name: str, message: str, remedy: str) -> TagChoice:
        problems.append(
            Problem(file=plan.file, key=f"{key}.{name}", message=message, remedy=remedy)
        )
        return choice

    if unit.casefold() in _PERCENT:
        if choice.rated_torque is None:
            return problem("rated_torque", f"missing: {shown(tag.name)} is in per cent of it",
                           'Write rated_torque = "? kN m" of one motor.')  # fmt: skip
        signals[role] = Signal(role, tag.name, times, values / 100.0, back)
        return choice
    if unit in ("A", "kA"):
        if not choice.current or len(choice.current) != len(choice.current_torque):
            return problem("current", "missing: a current alone is no torque",
                           "Write current and current_torque, or log the torque.")  # fmt: skip
        amperes = values * (1e3 if unit == "kA" else 1.0)
        torque = np.interp(amperes, choice.current, choice.current_torque)
        torque = np.where(np.isfinite(amperes), torque, np.nan)
    elif dimension_of(unit) == "torque":
        torque = values * unit_factor(unit, "torque")
    elif dimension_of(unit) == "power":
        speed = signals.get(f"speed.{choice.pulley}")
        if speed is None:
            return choice
        at = np.interp(times, speed.times, np.nan_to_num(speed.values))
        power = values * unit_factor(unit, "power")
        torque = np.divide(power, at, out=np.full(len(at), np.nan), where=at > 1.0)
    else:
        what = f"unit {shown(unit)} is no torque" if unit else f"{shown(tag.name)} has no unit"
        return problem("torque_unit", what, 'Write torque_unit = "?": %, kN m, kW or A.')
    rated = choice.rated_torque or float(np.nanquantile(np.abs(torque), 0.995)) / 0.9
    signals[role] = Signal(role, tag.name, times, torque / rated, back)
    return replace(choice, rated_torque=rated)


def _turning_factor(
    unit: str, key: str, tag: LogTag, plan: LearnPlan, problems: list[Problem]
) -> float | None:
    """Return rad/s per unit of a motor speed, None after saying what to write."""
    if unit.strip().casefold() in _TURNS:
        return _RPM
    if unit.strip() == "Hz":
        problems.append(
            Problem(file=plan.file, key=key, value=shown("Hz"),
                    message=f"{shown(tag.name)} is the frequency of a converter, without slip",
                    remedy="Log the speed.")
        )  # fmt: skip
        return None
    return _factor(unit, "rotation_speed", key, tag, plan, problems)


def _factor(
    unit: str, dimension: Dimension, key: str, tag: LogTag, plan: LearnPlan, problems: list[Problem]
) -> float | None:
    """Return the SI value of one unit, None after saying what to write."""
    if unit and dimension_of(unit) == dimension:
        return unit_factor(unit, dimension)
    message = f"unit {shown(unit)} is none of it" if unit else f"{shown(tag.name)} has no unit"
    name = key.rpartition(".")[2]
    problems.append(Problem(file=plan.file, key=key, message=message,
                            remedy=f'Write {name} = "?" with its unit.'))  # fmt: skip
    return None


def _ask_gear(
    choice: TagChoice, speed: LogTag, turning: float, belt: LogTag | None, plan: LearnPlan
) -> Problem:
    """Ask for the ratio of a gear, with the one that the log suggests."""
    remedy = "Write gear_ratio = ?."
    if belt is not None and dimension_of(plan.belt_unit or belt.unit) == "speed":
        v = np.nanmedian(belt.values) * unit_factor(plan.belt_unit or belt.unit, "speed")
        if v > 0.0:
            radius = plan.drive.pulley(choice.pulley).radius
            ratio = float(np.nanmedian(speed.values)) * turning * radius / v
            remedy = f"Write gear_ratio = ? of its name plate; speeds suggest {ratio:.3g}."
    return Problem(file=plan.file, key=f"pulley.{choice.pulley}.gear_ratio", message="missing",
                   remedy=remedy)  # fmt: skip


def _timed(tag: LogTag) -> tuple[Array, Array]:
    """Return times and values without the readings whose clock time is wrong."""
    times, values = tag.times, tag.values
    if len(times) > 2:
        before, after = np.diff(times)[:-1], np.diff(times)[1:]
        lone = (np.minimum(np.abs(before), np.abs(after)) > _FAR) & (before * after < 0.0)
        lone &= np.abs(before + after) < 0.1 * np.abs(before)
        good = np.concatenate([[True], ~lone, [True]])
        times, values = times[good], values[good]
    order = np.argsort(times, kind="stable")
    starts = np.flatnonzero(np.diff(times[order], prepend=-math.inf) > _FARTHEST)
    groups = np.split(order, starts[1:])
    kept = [group for group in groups if len(group) > _FEW * len(times)]
    which = np.sort(np.concatenate(kept)) if kept else order
    return times[which], values[which]


def _ascending(tag: LogTag) -> tuple[Array, Array, tuple[tuple[float, float], ...]]:
    """Return times and values in order, each time once, and the spans that were lived twice."""
    times, values = _timed(tag)
    top = np.maximum.accumulate(times)
    back = times < top - 60.0
    spans: list[tuple[float, float]] = []
    if back.any():
        edges = np.flatnonzero(np.diff(np.concatenate([[0], back.astype(np.int8), [0]])))
        for start, stop in zip(edges[::2], edges[1::2], strict=True):
            spans.append((float(times[start]), float(top[stop - 1])))
    order = np.argsort(times, kind="stable")
    times, values = times[order], values[order]
    once = np.concatenate([[True], np.diff(times) > 0.0])
    return times[once], values[once], tuple(spans)
