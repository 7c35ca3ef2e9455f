"""The pull of a conveyor from its resistances, and the wrap angle from where pulleys stand."""

from wraparc.conveyor.belt_path import Point, wrap_angle
from wraparc.conveyor.conveyor import (
    DRIVES_AT,
    EMPTIEST,
    FULLEST,
    OVER_WIDTH,
    STEEPEST,
    USUAL_CONVEYOR,
    Conveyor,
    State,
    choices,
)
from wraparc.conveyor.resistance import (
    GRAVITY,
    LENGTH_COEFFICIENTS,
    Resistance,
    inertia,
    length_coefficient,
    main_resistance,
    slope_resistance,
)

__all__ = [
    "DRIVES_AT",
    "EMPTIEST",
    "FULLEST",
    "GRAVITY",
    "LENGTH_COEFFICIENTS",
    "OVER_WIDTH",
    "STEEPEST",
    "USUAL_CONVEYOR",
    "Conveyor",
    "Point",
    "Resistance",
    "State",
    "choices",
    "inertia",
    "length_coefficient",
    "main_resistance",
    "slope_resistance",
    "wrap_angle",
]
