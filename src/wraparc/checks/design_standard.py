"""The slack-side tension that a design standard requires."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from wraparc.arc import wrap_factor
from wraparc.arrays import Array
from wraparc.catalogue import design_friction
from wraparc.checks.numbers import as_printed
from wraparc.drive import DesignStandard, Lagging, TakeUp

#: CEMA's drive factor Cw of a single pulley with a manual take-up, by wrap angle [deg]. CEMA gives
#: its values for an automatic take-up in the same table; they are 1/(exp(mu phi) - 1) with a
#: friction of 0.25 bare and 0.35 lagged. Public pages that quote CEMA confirm both frictions, and
#: of the manual values the largest, 1.2 (bare, 180 degrees); the table itself is not public.
MANUAL_WRAP_FACTORS = {
    "bare": ((180.0, 1.2), (200.0, 1.0), (210.0, 1.0), (220.0, 0.9), (240.0, 0.8)),
    "lagged": ((180.0, 0.8), (200.0, 0.7), (210.0, 0.7), (220.0, 0.6), (240.0, 0.6)),
}
#: What a rule of the user is called.
OWN = "design standard"
_ROUNDING = 1e-9  # of angles in degrees
MANUAL_SOURCE = "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8)"


#: What to do where a standard has no friction for a drive.
SET_FRICTION = "Set design_standard.friction."


@dataclass(frozen=True)
class StandardRequirement:
    """What a standard requires of a pulley.

    Attributes
    ----------
    name
        The standard.
    how
        Its friction and condition, or its factor.
    wrap_factor
        Slack-side tension over effective tension [-]; nan where the standard says nothing.
    source
        Where it is written.
    why_not, remedy
        Why there is no wrap factor, and what to do.
    """

    name: str
    how: str
    wrap_factor: float
    source: str
    why_not: str = ""
    remedy: str = SET_FRICTION

    @property
    def rule(self) -> str:
        """The standard with its friction and condition, in words."""
        return f"{self.name}, {self.how}" if self.how else self.name


def find_requirement(
    standard: DesignStandard, take_up: TakeUp, lagging: Lagging, wrap_angle: float
) -> StandardRequirement | None:
    """Return what a standard requires of a pulley with a lagging; None where none does.

    Parameters
    ----------
    standard, take_up
        The rule, and whether the take-up is manual (fixed).
    lagging
        Its surface and condition choose the design friction.
    wrap_angle
        phi [rad].
    """
    if standard.name == "none":
        return None
    if by_table(standard, take_up, lagging):
        return _manual(lagging, wrap_angle)
    friction, found = _friction(standard, lagging)
    if friction is None:
        return found
    factor = wrap_factor(friction, wrap_angle)
    return replace(
        found, wrap_factor=as_printed(factor) if prints(standard, lagging.surface) else factor
    )


def wrap_factors(
    standard: DesignStandard, take_up: TakeUp, lagging: Lagging, wrap_angle: Array
) -> Array:
    """Return the wrap factors that `find_requirement` finds, nan for none, shape (n,) [-].

    Parameters
    ----------
    standard, take_up, lagging
        As there.
    wrap_angle
        phi, shape (n,) [rad].
    """
    none = np.full(len(wrap_angle), math.nan)
    if standard.name == "none":
        return none
    if by_table(standard, take_up, lagging):
        first, factor = np.array(_rows(lagging)).T
        angle = np.degrees(wrap_angle)
        row = np.searchsorted(first, angle + _ROUNDING, side="right") - 1
        inside = (row >= 0) & (angle <= first[-1] + _ROUNDING)
        return np.where(inside, factor[np.maximum(row, 0)], none)
    friction, _ = _friction(standard, lagging)
    if friction is None:
        return none
    factors = 1.0 / np.expm1(friction * wrap_angle)
    if not prints(standard, lagging.surface):
        return factors
    return np.asarray(np.vectorize(as_printed, otypes=[float])(factors))  # of no row too


def prints(standard: DesignStandard, surface: str) -> bool:
    """Whether a standard prints its drive factors, with two decimals: CEMA, bare and of rubber."""
    return _cema(standard) and surface in ("bare", "rubber")


def _cema(standard: DesignStandard) -> bool:
    return standard.friction is None and (standard.name or "CEMA") == "CEMA"


def by_table(standard: DesignStandard, take_up: TakeUp, lagging: Lagging) -> bool:
    """Whether CEMA's table of manual take-ups holds."""
    return _cema(standard) and take_up.fixed and bool(lagging.surface)


def _friction(
    standard: DesignStandard, lagging: Lagging
) -> tuple[float | None, StandardRequirement]:
    """Return the friction that a standard designs with, and what to say of it."""
    name = standard.name or "CEMA"
    if standard.friction is not None:
        how = f"friction {standard.friction:.2f}"
        return standard.friction, StandardRequirement(OWN, how, math.nan, "input")
    if not lagging.surface:
        return None, _silent(name, f"{lagging.name} has no surface")
    condition = standard.condition or lagging.condition
    found = [d for d in design_friction() if d.standard == name and d.surface == lagging.surface]
    value = next((d for d in found if d.condition in ("", condition)), None)
    if value is None:
        return None, _silent(name, f"no value for {lagging.surface}, {condition}")
    friction = value.friction[0]
    stated = ", ".join(part for part in (value.surface, value.condition) if part)
    how = f"friction {friction:.2f} ({stated})"
    return friction, StandardRequirement(name, how, math.nan, str(value.provenance))


def _rows(lagging: Lagging) -> tuple[tuple[float, float], ...]:
    return MANUAL_WRAP_FACTORS["bare" if lagging.surface == "bare" else "lagged"]


def _manual(lagging: Lagging, wrap_angle: float) -> StandardRequirement:
    rows = _rows(lagging)
    angle = math.degrees(wrap_angle)
    if not rows[0][0] - _ROUNDING <= angle <= rows[-1][0] + _ROUNDING:
        ends = f"{rows[0][0]:g} to {rows[-1][0]:g} deg"
        end = f"from {rows[0][0]:g}" if angle < rows[0][0] else f"to {rows[-1][0]:g}"
        why = f"wrap {angle:.4g} deg, manual take-up factors {end} deg"
        return _silent("CEMA", why, f"Use a wrap of {ends}, or set design_standard.friction.")
    # between two rows the factor of the smaller wrap: the table is rounded to steps
    factor = next(value for row, value in reversed(rows) if row <= angle + _ROUNDING)
    return StandardRequirement("CEMA", f"manual take-up, Cw {factor:g}", factor, MANUAL_SOURCE)


def _silent(name: str, why: str, remedy: str = SET_FRICTION) -> StandardRequirement:
    return StandardRequirement(name, "", math.nan, "", why, remedy)
