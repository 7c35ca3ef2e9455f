"""Friction laws to the tables of a lagging file: the way back of `laws`."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from wraparc.errors import input_error
from wraparc.files.lagging_keys import KNOT, LAW, TABLE_ROW
from wraparc.files.trends import trend_text
from wraparc.friction import (
    CoefficientPieces,
    FrictionLaw,
    IntegralLog,
    MeasuredTable,
    Piece,
)
from wraparc.schema.quantity_text import quantity_text
from wraparc.units import unit_factor

Tables = dict[str, Any]
_SLIP_UNITS = ("mm", "m", "in", "cm", "um", "ft")


def law_table(law: FrictionLaw, **more: Any) -> Tables:
    """Return the table of a law; `more` is what a file says of it besides.

    Raises
    ------
    InputError
        If the file format has no word for such a law.
    """
    in_slip = None if law.slip_includes is None else list(law.slip_includes)
    more["slip_includes"] = in_slip
    for kind, table in LAW.tables.items():
        if table.of is type(law):
            return table.written(law, kind=kind, **_tested(law), **_parts(law), **more)
    message = f"a law of the class {type(law).__name__} cannot be written to a file"
    raise input_error(message=message)


def _tested(law: FrictionLaw) -> Tables:
    """Return the tested range; pressures that are ends of knots or pieces are not said again."""
    if law.tested is None:
        return {}
    ends = (law.tested.pressure_min, law.tested.pressure_max)
    own_ends = isinstance(law, IntegralLog) and len(law.coefficients.pressure) > 1
    table: Tables = {} if own_ends else {"tested_pressure": _pressures(ends)}
    table["tested_slip"] = quantity_text(law.tested.slip_max, "length")
    if law.tested.slip_speed is not None:
        table["tested_slip_speed"] = quantity_text(law.tested.slip_speed, "speed")
    return table


def _parts(law: FrictionLaw) -> Tables:
    """Return the rows of a law that has some."""
    if isinstance(law, MeasuredTable):
        return {"rows": TABLE_ROW.rows(law)}
    if not isinstance(law, IntegralLog):
        return {}
    if isinstance(law.coefficients, CoefficientPieces):
        return _pieces(law.coefficients)
    knots = law.coefficients
    if knots.post_peak_slope:  # without a level to fall to the slope would mean nothing
        knots = replace(knots, residual_friction=knots.residual_friction or knots.peak_friction)
    return {"knots": KNOT.rows(knots)}


def _pressures(values: Sequence[float]) -> list[str]:
    return [quantity_text(value, "pressure") for value in values]


def _pieces(pieces: CoefficientPieces) -> Tables:
    name = next((n for n in _SLIP_UNITS if unit_factor(n, "length") == pieces.slip_unit), None)
    if name is None:
        message = f"no name is known for a unit of slip of {pieces.slip_unit:g} m"
        raise input_error(message=message)
    ends = _pressures(pieces.pressure)
    rows: list[Tables] = [
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
