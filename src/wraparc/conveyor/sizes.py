"""Sizes that conveyors have: outside them a unit is likely wrong."""

#: Of these masses the sizes below are those over the width of the belt [kg/m2].
OVER_WIDTH = ("belt_mass", "carry_idler_mass", "return_idler_mass")
#: Sizes that conveyors have, least and most, in the order of `Conveyor.sizes` [SI].
USUAL_CONVEYOR = (
    ("length", 3.0, 30e3),
    ("lift", -1500.0, 1500.0),
    ("belt_mass", 3.0, 100.0),
    ("carry_idler_mass", 2.0, 60.0),
    ("return_idler_mass", 0.7, 30.0),
    ("material_mass", 0.5, 4000.0),
    ("capacity", 0.1, 15e3),
    ("friction_factor", 0.01, 0.04),
    ("secondary_resistance", 10.0, 500e3),
    ("special_resistance", 10.0, 200e3),
    ("start_time", 1.0, 600.0),
    ("stop_time", 1.0, 600.0),
    ("take_up_tension", 300.0, 2e6),
    ("counterweight", 30.0, 200e3),
)
#: Steepest that a belt carries: lift over length [-]; a troughed belt slides its load at 0.35.
STEEPEST = 0.5
#: Least and most material per length over the square of the belt width: a trough of which the
#: thousandth part is filled, and a full one of ore [kg/m3].
EMPTIEST, FULLEST = 0.7, 700.0
