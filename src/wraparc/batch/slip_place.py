"""Where gross slip begins along a line of tensions, by compiled code."""

from __future__ import annotations

from typing import Any

from wraparc.arc.kernel import gross_slip as kernel
from wraparc.arc.kernel.gross_slip import Grip, Line
from wraparc.batch.laws import bank_of, law_of
from wraparc.batch.native import compiled
from wraparc.friction.compact import CompactLaw


def place_of(bank: Any, grip: Grip, line: Line) -> float:
    """Place of a line at which gross slip begins, with the only law of a bank; to compile."""
    return kernel.slip_place(law_of(bank, 0), grip, line, 1.0, 0.0)


def compiled_slip_place(law: CompactLaw, grip: Grip, line: Line) -> float:
    """Return `wraparc.arc.kernel.gross_slip.slip_place` of a line, by compiled code."""
    return float(compiled(place_of)(bank_of(law), grip, line))
