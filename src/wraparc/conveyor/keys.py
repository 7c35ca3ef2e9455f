"""The keys of the ``[conveyor]`` table, and of the belt path of a pulley."""

import math
from dataclasses import dataclass
from typing import Any

from wraparc.conveyor.belt_path import TURNS, Point
from wraparc.conveyor.conveyor import DRIVES_AT, Conveyor
from wraparc.conveyor.description import UNCERTAIN
from wraparc.conveyor.extras import Cema, Travel
from wraparc.conveyor.flight import (
    LOADED_WORDS,
    PLACES,
    ConveyorCase,
    DrivePlace,
    Flight,
    LoadingPoint,
)
from wraparc.conveyor.local import (
    CleanerResistance,
    PointResistance,
    PulleyResistance,
    SkirtResistance,
    TiltResistance,
)
from wraparc.errors import InputError
from wraparc.schema.kinds import ByName, Choice, Count, Kind, Name, Quantity, Rows
from wraparc.schema.limits import Limit
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.tables import Entry, Table, Variant, need
from wraparc.schema.uncertain import uncertainty_entry
from wraparc.units import parse_quantity

#: Flights, loading points, load cases, drives and resistances at most.
MOST_FLIGHTS, MOST_POINTS = 100, 20
_STOPPING = {"stopping": "braking"}


@dataclass(eq=False, repr=False)
class Slope(Quantity):
    """An angle to the horizontal, or the rise over the horizontal run in percent."""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the angle [rad]."""
        try:
            rise = parse_quantity(raw, "number")
        except InputError:
            return super().read(raw, place, report)
        if abs(rise) > 1.0:
            message = "must be an angle, or a rise over run up to 100 %"
            report.add(place, message, 'Write "2 deg" or "3.5 %".', raw)
            return NOTHING
        return math.atan(rise)

    def schema(self) -> dict[str, Any]:
        """Text with a unit or a percent sign, or a plain number."""
        return super().schema() | {"type": ["number", "string"]}


@dataclass(eq=False, repr=False)
class LoadedFlights(Kind):
    """A word for some flights, or an array of their names."""

    names = Rows(Name(), 0, MOST_FLIGHTS)

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the word or the names."""
        return (
            self.names.read(raw, place, report)
            if isinstance(raw, list)
            else Choice(LOADED_WORDS).read(raw, place, report)
        )

    def schema(self) -> dict[str, Any]:
        """Either of the two."""
        return {"anyOf": [Choice(LOADED_WORDS).schema(), self.names.schema()]}


FLIGHT = Table(
    "Flight",
    need("name", "What load cases call it.", Name()),
    need("length", "Along the belt.", example='length = "600 m"'),
    Entry("lift", "From its beginning to its end, negative downhill; or slope."),
    Entry(
        "slope",
        "Its angle, or its rise over run in percent, negative downhill; level if left out.",
        Slope("angle", Flight.LIMITS["slope"]),
    ),
    Entry("curve_radius", "Radius of the vertical curve from the flight before."),
    Entry("friction_factor", "f of this flight; that of the conveyor if left out."),
    Entry(
        "carry_idler_mass",
        "Of this flight; that of the conveyor if left out.",
        title="Carrying idler mass",
    ),
    Entry("return_idler_mass", "Of this flight; that of the conveyor if left out."),
    Entry(
        "carry_spacing",
        "Distance of its carrying idlers; that of the conveyor if left out.",
        title="Carrying idler spacing",
    ),
    Entry("return_spacing", "Distance of its return idlers; that of the conveyor if left out."),
    of=Flight,
)
LOADING = Table(
    "Loading point",
    need("name", "What it is called.", Name()),
    Entry("flight", "The flight at whose beginning it is; the tail if left out.", Name()),
    Entry("position", "Or its distance from the tail."),
    Entry("capacity", "Mass flow of this point; or material_mass."),
    Entry("material_mass", "Mass of material that it puts onto a metre of belt."),
    Entry("material_speed", "Speed of the material along the belt; 0 if left out."),
    Entry("skirt_width", "Width between the skirts; friction on them where it is stated."),
    Entry("acceleration_length", "Over which the material takes up the belt speed."),
    Entry("belt_friction", "Of material and belt; 0.5 if left out."),
    Entry("skirt_friction", "Of material and skirts; 0.7 if left out."),
    Entry("density", "Bulk density of the material; skirts need it."),
    of=LoadingPoint,
)
CONVEYOR_CASE = Table(
    "Load case of the conveyor",
    need("name", "What it is called.", Name()),
    Entry("loaded", "The flights with material; all if left out.", LoadedFlights()),
    Entry(
        "factor",
        "Material over that of the full belt, by flight; 1 if left out.",
        ByName(Quantity("number", Limit("number", most=10.0))),
    ),
    Entry("kind", "running if left out.", Choice(("running", "starting", "braking"), _STOPPING)),
    of=ConveyorCase,
)
_AT = Entry("at", "Its place; the head if left out.", Choice(PLACES), title="Place")
_POSITION = Entry("position", 'For "carry" from the tail, for "return" from the head.')
DRIVE_PLACE = Table(
    "Drive of the conveyor",
    need("pulley", "Name of its pulley.", Name()),
    _AT,
    _POSITION,
    Entry("brake_share", "Its part of Te while braking; that of running if left out."),
    of=DrivePlace,
)
_COUNT = Entry("count", "So many of them; 1 if left out.", Count(1, 100))
LOCAL = Variant(
    "kind",
    "What resists.",
    Table(
        "pulley",
        _AT,
        _POSITION,
        need("diameter", "Of the pulley."),
        Entry("shaft_diameter", "Of the shaft in its bearings; left out for a drive pulley."),
        Entry("wrap_angle", "Of the belt about it; 180 deg if left out."),
        Entry("mass", "Of the pulley; 0 if left out."),
        _COUNT,
        of=PulleyResistance,
    ),
    Table(
        "cleaner",
        _AT,
        _POSITION,
        need("width", "Of the blade."),
        need("thickness", "Of the blade on the belt."),
        need("pressure", "Between blade and belt, 30 to 100 kPa."),
        Entry("friction", "Of blade and belt; 0.6 if left out."),
        _COUNT,
        of=CleanerResistance,
    ),
    Table(
        "skirt",
        Entry("position", "From the tail to where they begin; 0 if left out."),
        need("length", "Of the skirts, behind the acceleration of the material."),
        need("width", "Between the skirts."),
        need("density", "Bulk density of the material."),
        Entry("friction", "Of material and skirts; 0.7 if left out."),
        of=SkirtResistance,
    ),
    Table(
        "tilt",
        Entry("strand", '"carry" if left out.', Choice(("carry", "return"))),
        need(
            "angle", "Of the outer idlers to the direction of travel.", example='angle = "1.5 deg"'
        ),
        Entry("trough_coefficient", "0.4 of a 30 deg trough, 0.5 of 45 deg; 0.4 if left out."),
        Entry("friction", "Of idlers and belt; 0.3 if left out."),
        Entry("length", "Of the conveyor that has them; all of it if left out."),
        of=TiltResistance,
    ),
    Table(
        "force",
        _AT,
        _POSITION,
        need("force", "How large it is."),
        of=PointResistance,
    ),
)
TRAVEL = Table(
    "Travel of the take-up",
    Entry("temperature_range", "Between the coldest and the warmest belt, in kelvin."),
    Entry("thermal_expansion", "Strain of the belt per kelvin; steel 12e-6."),
    Entry("permanent_elongation", "Of the belt in its life, over its length."),
    Entry("splice_length", "Belt for new splices."),
    of=Travel,
)
CEMA = Table(
    "CEMA",
    need("idler_friction", "Ai, to turn one set of idlers.", example='idler_friction = "1.5 lbf"'),
    Entry("temperature_factor", "Kt; 1 if left out, above freezing."),
    need("ky", "Ky of the carrying strand, by the tables of CEMA.", example="ky = 0.02"),
    Entry("other", "Accessories, pulleys and loading together; 0 if left out."),
    of=Cema,
)
CONVEYOR = Table(
    "Conveyor",
    need(
        "length",
        "From the centre of the head to that of the tail pulley; or flights.",
        example='length = "600 m"',
        unless="flight",
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
    Entry(
        "carry_spacing",
        "Distance of the carrying idlers; sag and CEMA need it.",
        title="Carrying idler spacing",
    ),
    Entry("return_spacing", "Distance of the return idlers; sag needs it."),
    Entry("sag_limit", "Maximum sag over the spacing of the idlers; 1 % if left out."),
    Entry(
        "rest_friction",
        "Part of the main resistance that acts at standstill; 0.5 if left out.",
    ),
    Entry(
        "flight",
        "Its flights from the tail to the head.",
        Rows(FLIGHT, 1, MOST_FLIGHTS),
        title="Flights",
        attribute="flights",
    ),
    Entry(
        "loading",
        "Where material comes onto the belt, instead of capacity.",
        Rows(LOADING, 1, MOST_POINTS),
        title="Loading points",
        attribute="loadings",
    ),
    Entry(
        "load_case",
        "Load cases of its own, made of its flights.",
        Rows(CONVEYOR_CASE, 1, MOST_POINTS),
        title="Load cases of the conveyor",
        attribute="cases",
    ),
    Entry(
        "drive",
        "The place of each drive pulley; drive_at if left out.",
        Rows(DRIVE_PLACE, 1, MOST_POINTS),
        title="Drives",
        attribute="drives",
    ),
    Entry(
        "resistance",
        "Secondary and special resistances one by one, instead of C.",
        Rows(LOCAL, 1, MOST_FLIGHTS),
        title="Resistances",
        attribute="locals",
    ),
    Entry("travel", "What the travel of the take-up is made of.", TRAVEL, title="Take-up travel"),
    Entry("cema", "What Te by CEMA needs.", CEMA, title="CEMA"),
    uncertainty_entry(UNCERTAIN),
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
