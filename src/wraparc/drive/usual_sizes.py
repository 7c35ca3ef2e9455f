"""Sizes that conveyor drives have: outside them a unit is likely wrong."""

from math import pi

import numpy as np

from wraparc.arrays import Array, Flags

#: Tensions that the belt of a conveyor has, over its width: from a light belt that just does not
#: sag to the strength of the strongest steel cord [N/m].
USUAL_TENSION = (0.5e3, 1e7)
#: Strength over rating; 6.7 of steel cord, 8 to 10 of fabric (DIN 22101, makers) [-].
USUAL_STRENGTH = (4.0, 20.0)
#: Sizes that conveyor drives have, least and most, in the order of `compared_sizes` [SI].
USUAL_SIZES = (
    (0.2, 4.0),  # width
    (1e5, 1e9),  # modulus
    (0.05, 15.0),  # speed
    (0.15, 3.0),  # diameter
    (10.0 * pi / 180.0, 270.0 * pi / 180.0),  # wrap angle of a pulley that does not pull
    (120.0 * pi / 180.0, 270.0 * pi / 180.0),  # of one that does; with a snub pulley 240 deg
    (0.5e-3, 61e-3),  # creep limit; ten customary ones, 63.5 mm, are sliding
    (-2e-3, 2e-3),  # overrun; lagging that is compressed by it makes some 0.1 mm to 1 mm
    (0.0, 60e-3),  # thickness of the lagging
    (0.1e6, 50e6),  # its shear modulus
    (0.1e6, 5e9),  # its compression modulus
    (5e3, 2e6),  # rating of the belt
    (10e3, 50e6),  # bond strength
    (10e3, 50e6),  # fatigue limit
    (50e3, 10e6),  # largest wrap pressure of the belt
    (0.1, 3.0),  # its least pulley
    USUAL_TENSION,  # tension that keeps the belt from sagging, over the width
    USUAL_STRENGTH,
    # modulus over rating; published are 69 to 119 of fabric, 480 of steel cord (Goodyear 2012)
    (15.0, 1000.0),
    # pressure at the rating; published are up to 1.05 MPa on the least pulley (ST7000, the same)
    (0.0, 1.6e6),
    USUAL_TENSION,  # entry tension over the width
    USUAL_TENSION,  # exit tension
    (250.0, 2e7),  # power of a pulley that pulls
    (1.0, 130.0),  # mass of the belt over its width [kg/m2]
)

#: Columns of a table of arcs, by the place of their sizes.
OF_COLUMNS = {
    "belt_width": 0, "belt_modulus": 1, "belt_speed": 2, "diameter": 3, "wrap_angle": 4,
    "creep_limit": 6, "overrun": 7, "lagging_thickness": 8, "shear_modulus": 9,
    "compression_modulus": 10, "entry_tension": 20, "exit_tension": 21,
}  # fmt: skip
#: Those that stand in the table over the width of the belt.
OVER_WIDTH = ("entry_tension", "exit_tension")


def unusual_rows(values: Array, ends: tuple[float, float]) -> tuple[Flags, Flags]:
    """Return which of many sizes are below and which above usual ends; nan and inf are neither."""
    least, most = ends
    return np.asarray(values < least), np.asarray((values > most) & np.isfinite(values))
