"""The march of one pulley of a train, by compiled code where that has been prepared."""

from __future__ import annotations

from typing import Any

from wraparc.arc.kernel.effort import shoot_from
from wraparc.arc.kernel.quantities import NO_SHOT, Parameters, Shot, zeros
from wraparc.batch.laws import bank_of, law_of
from wraparc.batch.native import available, compiled
from wraparc.friction.compact import LIMIT, CompactLaw

_ready = {"compiled": False}


def shoot_one(bank: Any, par: Parameters, z: float, steps: int) -> Shot:
    """March one arc with the only law of a bank; an entry to compile."""
    shot, _ = shoot_from(law_of(bank, 0), par, z, steps, 0, zeros(0))
    return shot


def shoot(law: CompactLaw, par: Parameters, z: float, steps: int) -> Shot:
    """March one arc to its exit at an effort; see `wraparc.arc.kernel.effort.shoot_from`.

    Where tension grows beyond all numbers, that of the shot is not finite.
    """
    if _ready["compiled"]:
        shot: Shot = compiled(shoot_one)(bank_of(law), par, float(z), steps)
        return shot
    try:
        return shoot_plainly(law, par, z, steps)
    except OverflowError:
        return NO_SHOT


def shoot_plainly(law: CompactLaw, par: Parameters, z: float, steps: int) -> Shot:
    """March one arc to its exit at an effort, interpreted (or in the page)."""
    return shoot_from(law, par, z, steps, 0, zeros(0))[0]


def prepare() -> bool:
    """Make or load the compiled march and use it from now on; False where there is no compiler."""
    if available() and not _ready["compiled"]:
        law = CompactLaw(LIMIT, (), (0.5, 1.0, 0.0, 0.0))
        par = Parameters(1e5, 2e5, 0.5, 1.5, 1e-7, 5e-9, 0.0, 1.0, 1.0, 0.0)
        compiled(shoot_one)(bank_of(law), par, 1.0, 8)
        _ready["compiled"] = True
    return _ready["compiled"]
