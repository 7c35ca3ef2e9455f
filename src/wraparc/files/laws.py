"""Friction laws in lagging files: tables of keys to law objects."""

from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise

from wraparc.errors import InputError, Problem, input_error, shown
from wraparc.files.lagging_keys import LAW
from wraparc.files.trends import read_trend
from wraparc.friction import (
    CoefficientPieces,
    FrictionLaw,
    IntegralLog,
    MeasuredTable,
    Piece,
    PressureKnots,
    TestedRange,
    Trend,
)
from wraparc.schema.problems import Report
from wraparc.schema.tables import Record
from wraparc.units import Dimension, unit_factor

# Keys of the file by the names that the laws use in their errors.
_FILE_KEYS = {
    "friction_coefficient": "friction",
    "slip_max": "tested_slip",
    "tested": "tested_pressure",
    "pieces.a": "A",
    "values": "rows",
} | dict.fromkeys(("peak_friction", "peak_slip", "post_peak_slope", "residual_friction"), "knots")
_PRESSURE_KEY = {"integral-log": "knots", "table": "rows"}


def read_law(record: Record, report: Report) -> FrictionLaw | None:
    """Return the law of a ``[law]`` table, or None after reporting why there is none."""
    if not record.sound():
        return None
    kind = record["kind"]
    names = _FILE_KEYS | {"pressure": _PRESSURE_KEY.get(kind, "tested_pressure")}
    try:
        law: FrictionLaw | None
        if kind == "integral-log":
            law = _integral_log(record)
        elif kind == "table":
            law = _table(record)
        else:
            law = LAW.built(record, report, tested=_tested(record))
        if law is not None and "slip_includes" in record:
            law = replace(law, slip_includes=tuple(dict.fromkeys(record["slip_includes"])))
        return law
    except InputError as error:
        report.take(error, record.place, record.raw, names)
        return None


def _problem(key: str, message: str, remedy: str = "", value: str = "") -> InputError:
    return input_error(message=message, remedy=remedy, key=key, value=value)


def _tested(record: Record, ends: tuple[float, float] | None = None) -> TestedRange | None:
    """Return the tested range; its pressures are `ends` where the law has its own."""
    pressures, slip = record.get("tested_pressure"), record.get("tested_slip")
    speed = record.get("tested_slip_speed")
    if ends is not None:
        if pressures is not None:
            raise _problem(
                "tested_pressure",
                "contradicts the ends of knots or pieces",
                "Leave it out.",
                shown(record.raw["tested_pressure"]),
            )
        pressures = list(ends)
    if slip is None and speed is not None:
        raise _problem("tested_slip", "missing: tested_slip_speed needs it", "Give both.")
    if slip is None and (pressures is None or ends is not None):
        return None
    if pressures is None or slip is None:
        missing, there = "tested_pressure", "tested_slip"
        if slip is None:
            missing, there = there, missing
        raise _problem(missing, f"missing: {there} needs it", "Give both or none.")
    return TestedRange(
        pressure_min=pressures[0], pressure_max=pressures[1], slip_max=slip, slip_speed=speed
    )


def _integral_log(record: Record) -> IntegralLog:
    if ("knots" in record) == ("pieces" in record):
        found = "both knots and pieces" if "knots" in record else "neither knots nor pieces"
        raise _problem("", f"an integral-log law with {found}", "Give one of the two.")
    if "knots" in record:
        coefficients: PressureKnots | CoefficientPieces = _knots(record)
    else:
        coefficients = _pieces(record)
    p = coefficients.pressure
    tested = _tested(record, (p[0], p[-1]) if len(p) > 1 else None)
    return IntegralLog(coefficients=coefficients, tested=tested)


def _knots(record: Record) -> PressureKnots:
    for key in ("slip_unit", "pressure_unit", "continuity"):
        if key in record:
            raise _problem(key, "belongs to pieces; each number of knots has its own unit")
    rows: list[Record] = record["knots"]
    _check_order(rows, "knots")
    _raise(
        _useless_slope(f"knots[{number}].residual_friction")
        for number, row in enumerate(rows, start=1)
        if row.get("post_peak_slope", 0.0) < 0.0 and "residual_friction" not in row
    )
    tail = any("post_peak_slope" in row or "residual_friction" in row for row in rows)
    return PressureKnots(
        pressure=tuple(row["pressure"] for row in rows),
        peak_friction=tuple(row["peak_friction"] for row in rows),
        peak_slip=tuple(row["peak_slip"] for row in rows),
        post_peak_slope=tuple(row.get("post_peak_slope", 0.0) for row in rows) if tail else (),
        residual_friction=(
            tuple(row.get("residual_friction", row["peak_friction"]) for row in rows)
            if tail
            else ()
        ),
    )


def _useless_slope(key: str) -> Problem:
    return Problem(
        key=key,
        message="missing: post_peak_slope needs it",
        remedy="Give the level that friction falls to.",
    )


def _raise(problems: Iterable[Problem]) -> None:
    if found := list(problems):
        raise InputError(found)


def _check_order(rows: list[Record], key: str) -> None:
    """Refuse rows whose pressures do not ascend, naming each that is out of order."""
    problems = [
        Problem(
            key=f"{key}[{number}].pressure",
            message=f"must be more than {shown(before.raw['pressure'])} of the row before",
            remedy="Sort the rows by pressure.",
        )
        for number, (before, row) in enumerate(pairwise(rows), start=2)
        if row["pressure"] <= before["pressure"]
    ]
    _raise(problems)


def _pieces(record: Record) -> CoefficientPieces:
    slip_unit = _unit(record, "slip_unit", "length", "mm")
    pressure_unit = _unit(record, "pressure_unit", "pressure", "kPa")
    rows: list[Record] = record["pieces"]
    problems = [
        Problem(
            key=f"pieces[{number}].from",
            message=f"must be {shown(before.raw['to'])}, the end of the piece before",
            remedy="Leave no gap and no overlap.",
        )
        for number, (before, row) in enumerate(pairwise(rows), start=2)
        if abs(row["from"] / before["to"] - 1.0) > 1e-9
    ]
    pieces: list[Piece] = []
    for number, row in enumerate(rows, start=1):
        try:
            pieces.append(_piece(row, slip_unit, pressure_unit))
        except InputError as error:
            problems += [
                Problem(message=p.message, remedy=p.remedy, key=f"pieces[{number}].{p.key}")
                for p in error.problems
            ]
    _raise(problems)
    more = {"continuity": record["continuity"]} if "continuity" in record else {}
    return CoefficientPieces(
        pressure=(*(row["from"] for row in rows), rows[-1]["to"]),
        pieces=tuple(pieces),
        slip_unit=slip_unit,
        **more,
    )


def _piece(row: Record, slip_unit: float, pressure_unit: float) -> Piece:
    """Return one piece; A and b stay per slip unit, the slope goes to SI."""
    trends: dict[str, Trend] = {}
    problems: list[Problem] = []
    if "post_peak_slope" in row and "residual_friction" not in row:
        problems.append(_useless_slope("residual_friction"))
    factors = {"A": 1.0, "b": 1.0, "post_peak_slope": 1.0 / slip_unit, "residual_friction": 1.0}
    for key in [key for key in factors if key in row]:
        try:
            trends[key.lower()] = read_trend(row[key], pressure_unit, factors[key])
        except InputError as error:
            problems += [
                Problem(message=p.message, remedy=p.remedy, key=key) for p in error.problems
            ]
    _raise(problems)
    return Piece(**trends)


def _unit(record: Record, key: str, dimension: Dimension, example: str) -> float:
    if key not in record:
        remedy = f'Write {key} = "{example}", or the unit of their fit.'
        raise _problem(key, "missing: A and b need it", remedy)
    unit: str = record[key]
    try:
        return unit_factor(unit, dimension)
    except InputError as error:
        remedy = f'Write for example "{example}".'
        raise _problem(key, error.problems[0].message, remedy) from None


def _table(record: Record) -> MeasuredTable:
    rows: list[Record] = record["rows"]
    _check_order(rows, "rows")
    slips = len(record["slip"])
    problems = [
        Problem(
            key=f"rows[{number}].friction",
            message=f"{len(row['friction'])} values for {slips} slips",
            remedy="Give one for each slip.",
        )
        for number, row in enumerate(rows, start=1)
        if len(row["friction"]) != slips
    ]
    _raise(problems)
    return MeasuredTable(
        slip=tuple(record["slip"]),
        pressure=tuple(row["pressure"] for row in rows),
        values=tuple(tuple(row["friction"]) for row in rows),
    )
