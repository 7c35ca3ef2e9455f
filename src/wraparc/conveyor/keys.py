"""The keys of the ``[conveyor]`` table, and of the belt path of a pulley."""

from wraparc.conveyor.belt_path import TURNS, Point
from wraparc.conveyor.conveyor import DRIVES_AT, Conveyor
from wraparc.schema.kinds import Choice
from wraparc.schema.tables import Entry, Table, need

CONVEYOR = Table(
    "Conveyor",
    need(
        "length",
        "From the centre of the head to that of the tail pulley.",
        example='length = "600 m"',
    ),
    Entry("lift", "From tail to head, negative downhill; 0 if left out."),
    Entry("belt_mass", "Mass of the belt per length; or mass of [belt]."),
    need(
        "carry_idler_mass",
        "Rotating mass of the carrying idlers per length.",
        title="Carrying idler mass",
    ),
    need("return_idler_mass", "Rotating mass of the return idlers per length."),
    Entry("material_mass", "Mass of the material per length of full belt; or capacity."),
    Entry("capacity", "Mass flow of the full belt; needs the belt speed."),
    Entry(
        "friction_factor",
        "f of DIN 22101 and ISO 5048, 0.016 to 0.030; 0.02 if left out (average conditions).",
    ),
    Entry("length_coefficient", "C for all secondary resistances; by the length if left out."),
    Entry("secondary_resistance", "The secondary resistances themselves, instead of C."),
    Entry("special_resistance", "Skirts, scrapers, ploughs; 0 if left out."),
    Entry(
        "return_share",
        "Part of secondary and special resistances on the return strand; 0 if left out.",
    ),
    Entry(
        "start_factor",
        "Effective tension while starting over that of the full conveyor; or start_time.",
    ),
    Entry("start_time", "From rest to full speed at constant acceleration."),
    Entry("stop_time", "From full speed to rest at constant deceleration."),
    Entry("take_up_tension", "Belt tension at the take-up; or counterweight."),
    Entry("counterweight", "Mass of the counterweight, at the sheave_ratio of [take_up]."),
    Entry(
        "take_up_distance",
        "From the head to the take-up along the return strand, up to the length, which is the "
        "tail; 0 if left out.",
    ),
    Entry("drive_at", "Where the drive pulley sits; the head if left out.", Choice(DRIVES_AT)),
    of=Conveyor,
)

_PLACE = (
    need("x", "Centre, to the right."),
    need("y", "Centre, upwards."),
)
_TURN = Entry(
    "turn",
    "How it turns with the belt, seen with x to the right and y up; clockwise if left out.",
    Choice(TURNS),
)
_NEIGHBOUR = Table(
    "Neighbour",
    *_PLACE,
    Entry("diameter", "0 if left out: a point that the belt only touches."),
    _TURN,
    of=Point,
)
BELT_PATH = Table(
    "Belt path",
    *_PLACE,
    _TURN,
    need("before", "What the belt passes before.", _NEIGHBOUR, example="a table with x and y"),
    need("after", "What the belt passes next.", _NEIGHBOUR, example="a table with x and y"),
    of=Point,
)
#: Keys of a point.
POINT_KEYS = ("x", "y", "diameter", "turn")
