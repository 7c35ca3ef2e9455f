"""The keys of a drive file."""

from wraparc.drive import MOST_PULLEYS, Belt, Drive, Pulley, Tensions
from wraparc.files.lagging_keys import LAGGING_GIVEN
from wraparc.schema.kinds import ByName, Elsewhere, Flag, Name, Quantity, Rows, Text, TextOr, WordOr
from wraparc.schema.shared_keys import FORMAT_ENTRY, ORIGINS, PROVENANCE, known, limited
from wraparc.schema.tables import Entry, Table

BELT = Table(
    (
        Entry("preset", Name(), "Belt", "A belt of the catalogue; other keys override it."),
        Entry("name", Name(), "Name", "Designation of the belt."),
        Entry("kind", Text(60), "Kind", "Carcass, for example fabric or steel cord."),
        known("width", limited(Belt.LIMITS, "width"), "belt_width", required=True),
        known("modulus", limited(Belt.LIMITS, "modulus"), "belt_modulus"),
        Entry(
            "rating",
            limited(Belt.LIMITS, "rating"),
            "Rating",
            "Rated (operating) tension per unit width.",
        ),
        known("speed", limited(Belt.LIMITS, "speed"), "belt_speed"),
        Entry(
            "least_pulley_diameter",
            limited(Belt.LIMITS, "least_pulley_diameter"),
            "Least pulley diameter",
            "Smallest drive pulley that the maker allows.",
        ),
        *ORIGINS,
    ),
    "Belt",
)

_TENSION = limited(Tensions.LIMITS, "entry")
TENSIONS = (
    known("entry_tension", _TENSION),
    known("exit_tension", _TENSION),
    known("effective_tension", Quantity("force")),
    Entry(
        "torque",
        Quantity("torque"),
        "Torque",
        "Torque on the pulley, effective tension times D/2; negative when braking.",
    ),
    Entry(
        "power",
        Quantity("power"),
        "Power",
        "Power to the belt, effective tension times belt speed; negative when braking.",
    ),
)

PULLEY = Table(
    (
        Entry(
            "name",
            Name(),
            "Name",
            "Name of the pulley.",
            required=True,
            example='name = "head"',
        ),
        known("diameter", limited(Pulley.LIMITS, "diameter"), required=True),
        known("wrap_angle", limited(Pulley.LIMITS, "wrap_angle"), required=True, alias="wrap"),
        Entry(
            "lagging",
            TextOr(Name(500), LAGGING_GIVEN),
            "Lagging",
            "Catalogue name, name of a [lagging.NAME] table, path of a lagging file, or a table.",
            required=True,
            example='lagging = "diamond-rubber"',
        ),
        Entry("condition", Name(), "Condition", "Which law of the lagging: dry, wet ..."),
        *TENSIONS,
        known("overrun", WordOr("formula", limited(Pulley.LIMITS, "overrun"))),
        Entry(
            "recovery",
            Flag(),
            "Recovery",
            "Whether the lagging adds creep as it recovers along the arc.",
        ),
        known("creep_limit", limited(Pulley.LIMITS, "creep_limit")),
        Entry("sources", ByName(PROVENANCE), "Sources", "Where single numbers came from, by key."),
    ),
    "Pulley",
)

LOAD_CASE = Table(
    (
        Entry(
            "name",
            Name(),
            "Name",
            "Name of the case.",
            required=True,
            example='name = "start"',
        ),
        Entry("description", Text(1000, lines=True), "Description", "What happens then."),
        Entry(
            "pulley",
            ByName(Table(TENSIONS, "Tensions")),
            "Tensions",
            "Tensions by pulley; those not named keep their own.",
        ),
        Entry("train", Elsewhere()),
    ),
    "Load case",
)

DRIVE = Table(
    (
        FORMAT_ENTRY,
        Entry("title", Text(), "Title", "What the drive is called."),
        Entry("description", Text(5000, lines=True), "Description", "Anything worth saying."),
        known("creep_limit", limited(Drive.LIMITS, "creep_limit")),
        Entry("belt", BELT, "Belt", "The belt.", required=True, example="a [belt] table"),
        Entry(
            "pulley",
            Rows(PULLEY, 1, MOST_PULLEYS),
            "Pulleys",
            "The drive pulleys in belt order.",
            required=True,
            example="a [[pulley]] table for each pulley",
        ),
        Entry("lagging", ByName(LAGGING_GIVEN), "Laggings", "Laggings of this drive, by name."),
        Entry("load_case", Rows(LOAD_CASE, 1), "Load cases", "States of the conveyor."),
        Entry("train", Elsewhere()),
    ),
    "Drive file",
)
