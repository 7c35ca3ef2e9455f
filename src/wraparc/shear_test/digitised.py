"""Curves read off published figures: friction over slip, or A and b over pressure.

A digitiser (WebPlotDigitizer, Engauge, StarryDigitizer ...) writes points as CSV or JSON. They
become curves that are fitted as tests are: no lash, no unknown zero, no rig, but an error of the
reading, a share of full scale, common to all curves of a figure.
"""

import json
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from hashlib import sha256
from typing import Any

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.errors import InputError, Problem, format_names, name_remedy, shown
from wraparc.friction import peak_from_ab
from wraparc.machine_tables import RawTable, column_words, find_tables, refused
from wraparc.shear_test.budget import ReadOff, Uncertainty
from wraparc.shear_test.plan import Digitised, PlannedTest, TestPlan
from wraparc.shear_test.record import MachineRecord
from wraparc.shear_test.reduce import FrictionCurve
from wraparc.units import parse_quantity

#: Points of a curve; a plain CSV or JSON of more than this many curves is no figure.
LEAST_POINTS, _MOST_CURVES, _DEEPEST = 10, 200, 12
_STEPS = 60
# Slip that shear tests of laggings reach [m]; a figure outside it has to say its unit. Ours.
_USUAL_SLIP = (2e-3, 50e-3)
# As far as this beyond the last b, a pressure of A is that of its last.
_EDGE = 1.05
# Below 0 by more than this many errors of a point is no error of it.
_ERRORS = 2.0
_RENAME = "Give each its own name in the digitiser."
_PRESSURE = re.compile(
    r"(?<![\d.,])0*(\d{1,5}(?:[.]\d{1,6}|,\d{1,2})?)[ _]?(kPa|MPa|psi|bar)", re.IGNORECASE
)
# "34 to 69 kPa" is no pressure.
_RANGE = re.compile(r"\d\s*(?:\s-\s|[\u2013\u2026]|\.\.+|\bto\b|\bbis\b)\s*$|^\s*[\d.]+-$")
_CONDITIONS = re.compile(r"\b(dry|wet|dirty|muddy)\b", re.IGNORECASE)
# Heads of slip and of friction, of a column that counts points, and of one that names curves.
_KIND = re.compile(
    r"(?i)(?<![^\W_])(?:(?P<x>x|slip|travel|displacement)"
    r"|y|mu|\u00b5|\u03bc|friction|cof)"
    r"(?![^\W\d_])"
)
_NUMBER = re.compile(r"(?:n|nr|no|index|point|#)?\.?", re.IGNORECASE)
_GROUP = re.compile(r"(?:data ?set|curve|series|group|name)s?", re.IGNORECASE)
# What else a project of WebPlotDigitizer keeps: places in the image.
_NO_DATA = {"axesColl", "autoDetectionData", "measurementColl", "calibration"}
_UNITS = {"kpa": "kPa", "mpa": "MPa", "psi": "psi", "bar": "bar"}


@dataclass(frozen=True, eq=False)
class Points:
    """Points of one curve as digitised, ascending in x."""

    name: str
    x: Array
    y: Array


def guessed_pressure(name: str) -> str | None:
    """Return the pressure that a name tells, as ``207kPa-1.csv`` does, or None."""
    found = _PRESSURE.search(name)
    if found is None or _RANGE.search(name[: found.start()]):
        return None
    return f"{found[1].replace(',', '.')} {_UNITS[found[2].lower()]}"


def read_points(data: bytes, file: str) -> list[Points]:
    """Read the curves of a digitiser's file.

    JSON: every list of points, ``{"value": [x, y]}``, ``[x, y]`` or ``{"x": .., "y": ..}``, with
    the name that stands beside it. CSV: two columns; pairs of columns under names; one x and
    several y; a column that names the curve of each row; several such tables under each other.

    Raises
    ------
    InputError
        If there is no curve in it.
    """
    if data.lstrip()[:1] in (b"{", b"["):
        try:
            found = list(_in_json(json.loads(data), "", 0))
        except (ValueError, RecursionError):
            raise refused(file, "is no valid JSON", "Export it again.") from None
    else:
        found = _in_table(data, file)
    if len(found) > _MOST_CURVES:
        raise refused(file, f"contains {len(found)} curves", f"At most {_MOST_CURVES} are read.")
    curves = [
        Points(name, *np.array(sorted(points), dtype=float).T)
        for name, points in found
        if len(points) > 1
    ]
    if not curves:
        raise refused(
            file,
            "contains no digitised curve",
            "Export the points as CSV or JSON.",
        )
    return curves


def _in_json(node: Any, name: str, depth: int) -> Iterator[tuple[str, list[tuple[float, float]]]]:
    """Lists of points anywhere in a document, with the nearest name."""
    if depth > _DEEPEST:
        return
    if isinstance(node, list):
        points = [point for item in node if (point := _point(item)) is not None]
        if len(points) > 1 and len(points) == len(node):
            yield name, points
            return
        for item in node:
            yield from _in_json(item, name, depth + 1)
    elif isinstance(node, dict):
        own = node.get("name")
        x, y = node.get("x"), node.get("y")
        if isinstance(x, list) and isinstance(y, list) and len(x) == len(y):
            node = {"data": [list(point) for point in zip(x, y, strict=True)]}
        for key, value in node.items():
            if isinstance(value, list | dict) and key not in _NO_DATA:
                yield from _in_json(value, own if isinstance(own, str) else name, depth + 1)


def _point(item: Any) -> tuple[float, float] | None:
    """Values of a point; its place in the image counts only where there is nothing else."""
    if isinstance(item, dict):
        item = item.get("value") or [item.get("x"), item.get("y")]
    if not isinstance(item, list) or len(item) < 2:
        return None
    try:
        x, y = (float(v) for v in item[:2] if isinstance(v, str | int | float))
    except ValueError:  # also where one of them is neither
        return None
    return (x, y) if np.isfinite(x) and np.isfinite(y) else None


_Curve = tuple[str, list[tuple[float, float]]]


def _in_table(data: bytes, file: str) -> list[_Curve]:
    """Curves of all tables of a file, which may stand under each other."""
    found = find_tables(data, file)

    def words(table: RawTable, column: int) -> list[str]:
        return column_words(data, table, column, found.encoding)

    tables = [table for table in found.tables if table.rows > 1]
    return [curve for table in tables for curve in _of_table(table, file, words)]


_Words = Callable[[RawTable, int], list[str]]


def _of_table(table: RawTable, file: str, words_of: _Words) -> list[_Curve]:
    style = table.found_style(file)
    values = [table.numbers(k, style) for k in range(len(table.columns))]
    rows = [[cell.strip() for cell in row] for row in table.header if len(row) == len(values)]
    heads = [next((row[k] for row in reversed(rows) if row[k]), "") for k in range(len(values))]
    titles = next((row for row in rows if any(row)), [""] * len(values))
    above = " ".join(" ".join(row) for row in table.header if len(row) != len(values))
    filled = [k for k, column in enumerate(values) if np.isfinite(column).any()]
    filled = [k for k in filled if not _counts(heads[k], values[k])]
    groups = _groups(table, heads, values, filled, words_of)
    if groups is not None:
        filled = [k for k in filled if not _GROUP.fullmatch(heads[k])]
    of = _pairs(filled, heads, titles)
    if not of and filled:
        slips = [k for k in filled if _kind(heads[k]) == "x"]
        x = slips[0] if len(slips) == 1 else filled[0]
        others = [k for k in filled if k != x]
        lone = [above.strip("# ;,")] if len(others) == 1 and _kind(heads[others[0]]) else []
        of = [(lone[0] if lone else heads[k], x, k) for k in others]
    found: list[_Curve] = []
    for name, x, y in of:
        both = np.isfinite(values[x]) & np.isfinite(values[y])
        whole = {name: np.ones(table.rows, dtype=bool)}
        for group, rows_of in (groups or whole).items():
            keep = both & rows_of
            points = zip(values[x][keep].tolist(), values[y][keep].tolist(), strict=True)
            found.append((group, list(points)))
    return found


def _counts(head: str, values: Array) -> bool:
    """Whether a column only counts the points."""
    return _NUMBER.fullmatch(head) is not None and bool(np.all(np.diff(values) == 1.0))


def _groups(
    table: RawTable, heads: list[str], values: list[Array], filled: list[int], words_of: _Words
) -> dict[str, Flags] | None:
    """Rows of each curve, where a column names them: words, or a number under such a head."""
    for k in range(len(table.columns)):
        named = k in filled and _GROUP.fullmatch(heads[k])
        if not named and np.isfinite(values[k]).any():
            continue
        words = [cell.strip() for cell in words_of(table, k)]
        if named or (all(words) and not np.isfinite(values[k]).any()):
            return {
                name: np.array([word == name for word in words]) for name in dict.fromkeys(words)
            }
    return None


def _pairs(filled: list[int], heads: list[str], titles: list[str]) -> list[tuple[str, int, int]]:
    """Name, x and y of columns that stand in pairs; none where they do not."""
    xs, ys = filled[0::2], filled[1::2]
    if len(filled) < 4 or len(xs) != len(ys):
        return []
    kinds = all(_kind(heads[k]) == "x" for k in xs) and all(_kind(heads[k]) == "y" for k in ys)
    same = len({heads[k] for k in xs}) == 1
    over = all(titles[k] for k in xs) and not any(titles[k] for k in ys)
    if not (kinds or same or over):
        return []
    return [
        (_KIND.sub(" ", titles[x] or titles[y]).strip() or heads[x], x, y)
        for x, y in zip(xs, ys, strict=True)
    ]


def _kind(head: str) -> str:
    """``x`` or ``y`` for the head of a column of slip or of friction, else empty."""
    found = _KIND.search(head)
    return "" if found is None else "x" if found["x"] else "y"


def with_curves(
    plan: TestPlan, data_of: Callable[[PlannedTest], bytes]
) -> tuple[TestPlan, dict[str, MachineRecord]]:
    """Return the plan with a test for each digitised curve, and the record of each by its file.

    Parameters
    ----------
    plan
        A plan whose `digitised` says what its files are.
    data_of
        The bytes of a test's file.

    Raises
    ------
    InputError
        With all that is wrong in the files.
    """
    of = plan.digitised
    assert of is not None  # noqa: S101 - asked only of such a plan
    problems: list[Problem] = []
    taken: list[tuple[PlannedTest, Points]] = []
    for test in plan.used_tests:
        try:
            taken += [
                (test, curve) for curve in _wanted(read_points(data_of(test), test.file), test)
            ]
        except InputError as error:
            problems += error.problems
    if problems:
        raise InputError(problems)
    if of.quantity == "friction":
        _refuse_scale(of, taken)
    else:
        _refuse_unitless(of, taken[0][0].file)
    curves = _coefficient_curves(of, taken) if of.quantity == "coefficients" else taken
    tests: list[PlannedTest] = []
    records: dict[str, MachineRecord] = {}
    for test, curve in curves:
        pressure = test.pressure
        said = guessed_pressure(curve.name) or guessed_pressure(test.file)
        if pressure is None and said:
            pressure = parse_quantity(said, "pressure")
        label = f"{test.file}: {curve.name}" if curve.name else test.file
        try:
            _refuse_condition(label, curve, test)
            record = _record(label, curve, pressure, of, plan)
            _refuse_again(record, records)
            records[label] = record
        except InputError as error:
            problems += error.problems
            continue
        tests.append(replace(test, file=label, pressure=pressure, normal_force=None))
    if problems:
        raise InputError(problems)
    # Nothing else is known of how the paper measured, and nothing is invented. What the plan says
    # of the rubbers whose shear it takes off, and of temperature, stays.
    limits = replace(
        plan.uncertainty or Uncertainty(), force=0.0, normal_force=0.0, area=0.0, travel=0.0,
        zero=0.0, compliance=0.0, stated=True, read_off=_errors(of, taken),
    )  # fmt: skip
    held = plan.held if plan.held.lash is not None else replace(plan.held, lash=0.0)
    read = replace(plan, tests=(*tests, *plan.unused_tests), uncertainty=limits, held=held)
    return read, records


def as_drawn(curve: FrictionCurve, first: float, errors: ReadOff | None = None) -> FrictionCurve:
    """Return the curve of a figure: its slip is counted from 0, not from its first point [m].

    It has no unknown zero, nothing recorded it, and no rise before its first point is lost: there
    is none at no slip. Its points are wrong by the `errors` of the reading.
    """
    return replace(
        curve,
        travel=curve.travel + first,
        binned_travel=curve.binned_travel + first,
        first_friction=0.0,
        read_off=(0.0, 0.0) if errors is None else (errors.slip, errors.friction),
        onset=0.0,
        zero=None,
        zero_unknown=0.0,
        faults=(),
        swing=None,
    )


def _errors(of: Digitised, taken: list[tuple[PlannedTest, Points]]) -> ReadOff:
    """Largest errors: the share of the largest slip and friction, or of the largest A and b."""
    if of.quantity == "friction":
        slip, friction = (max(float(getattr(c, axis).max()) for _, c in taken) for axis in "xy")
        return ReadOff(slip=of.error * slip * of.metres, friction=of.error * friction)
    tops = {_letter(test, curve): float(np.abs(curve.y).max()) for test, curve in taken}
    return ReadOff(a=of.error * tops["a"], b=of.error * tops["b"], unit=of.metres)


def _refuse_scale(of: Digitised, taken: list[tuple[PlannedTest, Points]]) -> None:
    """Refuse slip or friction below 0, and slip that is likely in another unit than mm."""
    problems: list[Problem] = []
    for axis, title in (("x", "slip"), ("y", "friction")):
        top = max(float(getattr(curve, axis).max()) for _, curve in taken)
        for test, curve in taken:
            least = float(getattr(curve, axis).min())
            if least < -_ERRORS * of.error * top:
                remedy = "See the axes in the digitiser, and which column is x."
                message = f"its {title} goes down to {least:.3g}"
                problems += refused(f"{test.file}: {curve.name}", message, remedy).problems
    end = max(float(curve.x.max()) for _, curve in taken) * of.metres
    if of.slip_unit is None and not _USUAL_SLIP[0] <= end <= _USUAL_SLIP[1]:
        message = f"missing: in mm the slip would end at {end * 1e3:.3g} mm"
        remedy = 'Write slip_unit = "?" with the unit of x.'
        problems += refused(taken[0][0].file, message, remedy, key="digitised.slip_unit").problems
    if problems:
        raise InputError(problems)


def _refuse_unitless(of: Digitised, file: str) -> None:
    """Ask for the units without which A and b mean nothing."""
    given = {"slip_unit": of.slip_unit, "pressure_unit": of.pressure_unit}
    problems = [
        Problem(message="missing", remedy=f'Write {key} = "?" with its unit.', file=file,
                key=f"digitised.{key}")
        for key, value in given.items()
        if value is None
    ]  # fmt: skip
    if problems:
        raise InputError(problems)


def _wanted(curves: list[Points], test: PlannedTest) -> list[Points]:
    """All curves of the file, or the one that the test names."""
    if not test.curve:
        if len(curves) > 1 and test.pressure is not None:
            raise refused(
                test.file,
                f"one pressure for {len(curves)} curves",
                "Give each curve its own [[test]] with pressure.",
                key="pressure",
            )
        return curves
    if len(curves) == 1:
        return [replace(curves[0], name=test.curve)]
    chosen = [curve for curve in curves if curve.name.strip() == test.curve.strip()]
    if len(chosen) > 1:
        raise refused(test.file, f"{len(chosen)} curves have this name", _RENAME, key="curve")
    if not chosen:
        raise refused(
            test.file,
            "no such curve",
            name_remedy(test.curve, [curve.name for curve in curves]),
            key="curve",
            value=shown(test.curve),
        )
    return chosen


def _refuse_condition(label: str, curve: Points, test: PlannedTest) -> None:
    """Refuse a curve whose name says another condition than its test."""
    said = _CONDITIONS.search(curve.name)
    if said and said[1].casefold() not in test.condition.casefold():
        own = shown(said[1].casefold())
        remedy = f"Give it a [[test]] with condition = {own}."
        raise refused(label, f"is named {own}, its test {shown(test.condition)}", remedy)


def _refuse_again(record: MachineRecord, others: dict[str, MachineRecord]) -> None:
    """Refuse a curve that another one is, by its name or by its points."""
    if record.file in others:
        raise refused(record.file, "two curves of the file have this name", _RENAME)
    same = next((name for name, other in others.items() if other.digest == record.digest), None)
    if same is not None:
        remedy = "Click its own points, or take it out."
        raise refused(record.file, f"has the same points as {shown(same)}", remedy)


def _letter(test: PlannedTest, curve: Points) -> str:
    return (test.curve or curve.name).strip().casefold()


def _coefficient_curves(
    of: Digitised, taken: list[tuple[PlannedTest, Points]]
) -> list[tuple[PlannedTest, Points]]:
    """A and b over pressure as friction over slip: a curve at each pressure of A."""
    letters = [_letter(test, curve) for test, curve in taken]
    for letter, title in (("a", "A"), ("b", "b")):
        if letters.count(letter) > 1:
            raise refused(taken[0][0].file, f"two curves are named {title}", _RENAME)
    by = dict(zip(letters, taken, strict=True))
    if not {"a", "b"} <= by.keys():
        listed = format_names([curve.name for _, curve in taken], 4)
        remedy = 'Write curve = "A" and curve = "b" in two [[test]].'
        raise refused(taken[0][0].file, f"lacks A or b, and has {listed}", remedy)
    (test, a), (_, b) = by["a"], by["b"]
    beyond = a.x[(a.x * _EDGE < b.x[0]) | (a.x > b.x[-1] * _EDGE)]
    if len(beyond):
        raise refused(
            test.file,
            f"A is read at {beyond[0]:.4g}, b only from {b.x[0]:.4g} to {b.x[-1]:.4g}",
            "Read both at the same pressures.",
        )
    curves = []
    for p, first, second in zip(a.x, a.y, np.interp(a.x, b.x, b.y), strict=True):
        if not first < 0.0 or abs(second / first) > 10.0:
            raise refused(
                test.file,
                f"A = {first:.4g} and b = {second:.4g} at {p:.4g} make no peak of friction",
                "A is below 0 in mu = A x ln x - b x; see the axes and the unit of x.",
            )
        _, peak = peak_from_ab(float(first), float(second))
        end = peak if of.slip_max is None else min(of.slip_max / of.metres, peak)
        x = np.linspace(0.0, end, _STEPS)  # no law beyond its peak
        with np.errstate(divide="ignore", invalid="ignore"):
            y = np.where(x > 0.0, first * x * np.log(x) - second * x, 0.0)
        pressure = p * (of.pressure_unit or 1e3)
        own = replace(test, pressure=pressure, curve="")
        curves.append((own, Points(f"{pressure / 1e3:.4g} kPa", x, y)))
    return curves


def _record(
    label: str, curve: Points, pressure: float | None, of: Digitised, plan: TestPlan
) -> MachineRecord:
    """The record of a test that would have given the curve."""
    count = len(curve.x)
    if pressure is None:
        remedy = 'Give pressure in its [[test]], or name the curve "207 kPa" in the digitiser.'
        raise refused(label, "the pressure of this curve is not known", remedy)
    if not pressure > 0.0:
        raise refused(label, f"its pressure is {pressure / 1e3:.4g} kPa", "It is above 0.")
    if count < LEAST_POINTS:
        remedy = f"Click {LEAST_POINTS} points or more along it, most where it bends."
        raise refused(label, f"the curve has {count} points only", remedy)
    force = curve.y * pressure * plan.rig.area * plan.rig.faces
    return MachineRecord(
        file=label, place=f"{count} points", encoding="", delimiter="", decimal=".", columns=(),
        travel=curve.x * of.metres, force=force, normal_force=None, time=None,
        lines=np.arange(1, count + 1), rows=count, dropped=(),
        notes=(of.provenance(None).source,), header=(),
        digest=sha256(curve.x.tobytes() + curve.y.tobytes()).hexdigest(),
    )  # fmt: skip
