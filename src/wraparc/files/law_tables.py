"""Friction laws to the tables of a lagging file: the way back of `laws`."""

from collections.abc import Sequence
from typing import Any

from wraparc.errors import InputError, Problem
from wraparc.files.lagging_keys import LAW
from wraparc.files.trends import trend_text
from wraparc.friction import (
    CoefficientPieces,
    FrictionLaw,
    IntegralLog,
    MeasuredTable,
    Piece,
    PressureKnots,
)
from wraparc.schema.quantity_text import quantity_text
from wraparc.units import unit_factor

Tables = dict[str, Any]
_SLIP_UNITS = ("mm", "m", "in", "cm", "um", "ft")


def law_table(law: FrictionLaw) -> Tables:
    """Return the table of a law, without its condition.

    Raises
    ------
    InputError
        If the file format has no word for such a law.
    """
    if isinstance(law, IntegralLog):
        return _integral_log(law)
    if isinstance(law, MeasuredTable):
        return _measured(law)
    for kind, table in LAW.tables.items():
        if table.of is type(law):
            return {"kind": kind, **table.written(law), **_tested(law)}
    message = f"a law of the class {type(law).__name__} cannot be written to a file"
    raise InputError(Problem(message=message))


def _tested(law: FrictionLaw, own_pressures: bool = False) -> Tables:
    if law.tested is None:
        return {}
    ends = (law.tested.pressure_min, law.tested.pressure_max)
    pressures = {} if own_pressures else {"tested_pressure": _quantities(ends, "pressure")}
    table = pressures | {"tested_slip": quantity_text(law.tested.slip_max, "length")}
    if law.tested.slip_speed is not None:
        table["tested_slip_speed"] = quantity_text(law.tested.slip_speed, "speed")
    return table


def _quantities(values: Sequence[float], dimension: Any) -> list[str]:
    return [quantity_text(value, dimension) for value in values]


def _measured(law: MeasuredTable) -> Tables:
    return {
        "kind": "table",
        "slip": _quantities(law.slip, "length"),
        "rows": [
            {"pressure": quantity_text(pressure, "pressure"), "friction": list(row)}
            for pressure, row in zip(law.pressure, law.values, strict=True)
        ],
    }


def _integral_log(law: IntegralLog) -> Tables:
    coefficients = law.coefficients
    head = {"kind": "integral-log", **_tested(law, len(coefficients.pressure) > 1)}
    if isinstance(coefficients, PressureKnots):
        return {**head, "knots": _knots(coefficients)}
    return {**head, **_pieces(coefficients)}


def _knots(knots: PressureKnots) -> list[Tables]:
    columns = {
        "pressure": _quantities(knots.pressure, "pressure"),
        "peak_friction": knots.peak_friction,
        "peak_slip": _quantities(knots.peak_slip, "length"),
        "post_peak_slope": _quantities(knots.post_peak_slope, "per_length"),
        "residual_friction": knots.residual_friction
        or (knots.peak_friction if knots.post_peak_slope else ()),
    }
    columns = {key: column for key, column in columns.items() if column}
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def _pieces(pieces: CoefficientPieces) -> Tables:
    name = next((n for n in _SLIP_UNITS if unit_factor(n, "length") == pieces.slip_unit), None)
    if name is None:
        message = f"no name is known for a unit of slip of {pieces.slip_unit:g} m"
        raise InputError(Problem(message=message))
    ends = _quantities(pieces.pressure, "pressure")
    rows = [
        {"from": low, "to": high, **_piece(piece, pieces.slip_unit)}
        for piece, low, high in zip(pieces.pieces, ends, ends[1:], strict=False)
    ]
    return {
        "slip_unit": name,
        "pressure_unit": "Pa",
        "continuity": pieces.continuity,
        "pieces": rows,
    }


def _piece(piece: Piece, slip_unit: float) -> Tables:
    default = Piece(a=piece.a, b=piece.b)
    table = {"A": trend_text(piece.a), "b": trend_text(piece.b)}
    if piece.post_peak_slope != default.post_peak_slope:
        table["post_peak_slope"] = trend_text(piece.post_peak_slope, 1.0 / slip_unit)
    if "post_peak_slope" in table or piece.residual_friction != default.residual_friction:
        table["residual_friction"] = trend_text(piece.residual_friction)
    return table
