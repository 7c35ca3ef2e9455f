"""The slack-side tension that a design standard asks for."""

from __future__ import annotations

import math
from dataclasses import dataclass

from wraparc.arc import wrap_factor
from wraparc.catalogue import design_friction
from wraparc.drive import DesignStandard, Lagging, TakeUp

#: CEMA's drive factor Cw of a single pulley with a manual take-up, by wrap angle [deg]. CEMA gives
#: its values for an automatic take-up in the same table; they are 1/(exp(mu phi) - 1) with a
#: friction of 0.25 bare and 0.35 lagged.
MANUAL_WRAP_FACTORS = {
    "bare": ((180.0, 1.2), (200.0, 1.0), (210.0, 1.0), (220.0, 0.9), (240.0, 0.8)),
    "lagged": ((180.0, 0.8), (200.0, 0.7), (210.0, 0.7), (220.0, 0.6), (240.0, 0.6)),
}
MANUAL_SOURCE = "CEMA, Belt Conveyors for Bulk Materials, table of the drive factor Cw"


@dataclass(frozen=True)
class Asked:
    """What a standard asks of a pulley.

    Attributes
    ----------
    rule
        The standard with its friction and condition, in words.
    wrap_factor
        Slack-side tension over effective tension [-]; nan where the standard says nothing.
    source
        Where it is written.
    why_not
        Why there is no wrap factor.
    """

    rule: str
    wrap_factor: float
    source: str
    why_not: str = ""


def asked(
    standard: DesignStandard, take_up: TakeUp, lagging: Lagging, wrap_angle: float
) -> Asked | None:
    """Return what a standard asks of a pulley with a lagging; None where none is asked.

    Parameters
    ----------
    standard, take_up
        The rule, and whether the take-up is manual (fixed).
    lagging
        Its surface and condition choose the design friction.
    wrap_angle
        phi [rad].
    """
    name = standard.name or "CEMA"
    if name == "none":
        return None
    if standard.friction is not None:
        rule = f"your own rule, friction {standard.friction:.2f}"
        return Asked(rule, wrap_factor(standard.friction, wrap_angle), "given")
    if not lagging.surface:
        return _silent(name, f"lagging {lagging.name} does not say what its surface is")
    if name == "CEMA" and take_up.fixed:
        return _manual(lagging, wrap_angle)
    condition = standard.condition or lagging.condition
    found = [d for d in design_friction() if d.standard == name and d.surface == lagging.surface]
    value = next((d for d in found if d.condition in ("", condition)), None)
    if value is None:
        return _silent(name, f"it has no value for {lagging.surface} when {condition}")
    friction = value.friction[0]
    stated = ", ".join(part for part in (value.surface, value.condition) if part)
    rule = f"{name}, friction {friction:.2f} ({stated})"
    return Asked(rule, wrap_factor(friction, wrap_angle), str(value.provenance))


def _manual(lagging: Lagging, wrap_angle: float) -> Asked:
    rows = MANUAL_WRAP_FACTORS["bare" if lagging.surface == "bare" else "lagged"]
    angle = math.degrees(wrap_angle)
    if not rows[0][0] - 1e-9 <= angle <= rows[-1][0] + 1e-9:
        ends = f"{rows[0][0]:g} to {rows[-1][0]:g} degrees"
        return _silent("CEMA", f"its factors for manual take-ups are for wraps of {ends}")
    # between two rows the factor of the smaller wrap: the table is rounded to steps
    factor = next(value for row, value in reversed(rows) if row <= angle + 1e-9)
    return Asked(f"CEMA, manual take-up, Cw {factor:g}", factor, MANUAL_SOURCE)


def _silent(name: str, why: str) -> Asked:
    return Asked(name, math.nan, "", why)
