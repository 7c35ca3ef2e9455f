"""The pull of a conveyor from its resistances, and the wrap angle from where pulleys stand."""

from wraparc.conveyor.belt_path import Point, wrap_angle
from wraparc.conveyor.choices import choices
from wraparc.conveyor.consequences import (
    CurveAt,
    SagAt,
    TravelOf,
    cema_pull,
    curves,
    sags,
    travel_of,
)
from wraparc.conveyor.conveyor import DRIVES_AT, Conveyor
from wraparc.conveyor.course import course_state, standard_cases
from wraparc.conveyor.extras import Cema, Travel
from wraparc.conveyor.flight import ConveyorCase, DrivePlace, Flight, LoadingPoint
from wraparc.conveyor.local import (
    CleanerResistance,
    PointResistance,
    PulleyResistance,
    SkirtResistance,
    TiltResistance,
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
from wraparc.conveyor.sizes import EMPTIEST, FULLEST, OVER_WIDTH, STEEPEST, USUAL_CONVEYOR
from wraparc.conveyor.state import BeltPoint, DrivePull, Standstill, State, Stretch

__all__ = [
    "DRIVES_AT",
    "EMPTIEST",
    "FULLEST",
    "GRAVITY",
    "LENGTH_COEFFICIENTS",
    "OVER_WIDTH",
    "STEEPEST",
    "USUAL_CONVEYOR",
    "BeltPoint",
    "Cema",
    "CleanerResistance",
    "Conveyor",
    "ConveyorCase",
    "CurveAt",
    "DrivePlace",
    "DrivePull",
    "Flight",
    "LoadingPoint",
    "Point",
    "PointResistance",
    "PulleyResistance",
    "Resistance",
    "SagAt",
    "SkirtResistance",
    "Standstill",
    "State",
    "Stretch",
    "TiltResistance",
    "Travel",
    "TravelOf",
    "cema_pull",
    "choices",
    "course_state",
    "curves",
    "inertia",
    "length_coefficient",
    "main_resistance",
    "sags",
    "slope_resistance",
    "standard_cases",
    "travel_of",
    "wrap_angle",
]
