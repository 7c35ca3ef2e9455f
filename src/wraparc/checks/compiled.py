"""Gross slip of one arc for its checks, by compiled code where that has been prepared."""

from __future__ import annotations

from wraparc.arc import WrapArc
from wraparc.arc.kernel import gross_slip as kernel
from wraparc.arc.kernel.gross_slip import Grip, Line
from wraparc.friction.compact import LIMIT, CompactLaw

_STEPS = 24
_ready = {"compiled": False}


def largest_log(arc: WrapArc) -> float:
    """Return the largest ln(tight/slack) that falling friction carries, tight side held [-]."""
    if _ready["compiled"]:
        from wraparc.batch.compiled import largest_log as found

        return found(arc, _STEPS)
    tight = max(arc.entry_tension, arc.exit_tension)
    return kernel.largest_ratio(arc.law.compact(), arc.geometry(), tight, True, _STEPS)[0]


def slip_place(law: CompactLaw, grip: Grip, line: Line) -> float:
    """Return the place k of a line at which gross slip begins; see the kernel's own."""
    if _ready["compiled"]:
        from wraparc.batch.slip_place import compiled_slip_place

        return compiled_slip_place(law, grip, line)
    return kernel.slip_place(law, grip, line, 1.0, 0.0)


def prepare() -> bool:
    """Make or load the compiled code and use it from now on; False where there is no compiler."""
    from wraparc.batch.compiled import prepare as solver
    from wraparc.batch.native import available
    from wraparc.batch.slip_place import compiled_slip_place

    if available() and not _ready["compiled"]:
        law = CompactLaw(LIMIT, (), (0.5, 1.0, 0.0, 0.0))
        compiled_slip_place(law, Grip(3.0, 0.5, 0.0), Line(2e5, 1e5, 1e5, 0.0))
        _ready["compiled"] = solver()
    return _ready["compiled"]
