"""Gross slip of one arc for its checks, by compiled code where that has been prepared."""

from __future__ import annotations

from typing import Any

from wraparc.arc import WrapArc
from wraparc.arc.kernel import gross_slip as kernel
from wraparc.arc.kernel.gross_slip import Grip, Line
from wraparc.batch import compiled as batch
from wraparc.batch.laws import bank_of, law_of
from wraparc.batch.native import available, compiled
from wraparc.friction.compact import LIMIT, CompactLaw

_STEPS = 24
_ready = {"compiled": False}


def largest_log(arc: WrapArc) -> float:
    """Return the largest ln(tight/slack) that falling friction carries, tight side held [-]."""
    if _ready["compiled"]:
        return batch.largest_log(arc, _STEPS)
    tight = max(arc.entry_tension, arc.exit_tension)
    return kernel.largest_ratio(arc.law.compact(), arc.geometry(), tight, True, _STEPS)[0]


def place_of(bank: Any, grip: Grip, line: Line) -> float:
    """Place of a line at which gross slip begins, with the only law of a bank; to compile."""
    return kernel.slip_place(law_of(bank, 0), grip, line, 1.0, 0.0)


def slip_place(law: CompactLaw, grip: Grip, line: Line) -> float:
    """Return the place k of a line at which gross slip begins; see the kernel's own."""
    if _ready["compiled"]:
        return float(compiled(place_of)(bank_of(law), grip, line))
    return kernel.slip_place(law, grip, line, 1.0, 0.0)


def prepare() -> bool:
    """Make or load the compiled code and use it from now on; False where there is no compiler."""
    if available() and not _ready["compiled"]:
        law = CompactLaw(LIMIT, (), (0.5, 1.0, 0.0, 0.0))
        compiled(place_of)(bank_of(law), Grip(3.0, 0.5, 0.0), Line(2e5, 1e5, 1e5, 0.0))
        _ready["compiled"] = batch.prepare()
    return _ready["compiled"]
