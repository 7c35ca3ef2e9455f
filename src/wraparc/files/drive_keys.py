"""The keys of a drive file."""

from wraparc.drive import (
    CASE_KINDS,
    CONDITIONS,
    MOST_PULLEYS,
    STANDARDS,
    TAKE_UPS,
    Belt,
    DesignStandard,
    Drive,
    Pulley,
    SafetyFactors,
    Sag,
    TakeUp,
    Tensions,
)
from wraparc.files.lagging_keys import LAGGING_GIVEN
from wraparc.schema.kinds import (
    ByName,
    Choice,
    Elsewhere,
    Flag,
    Name,
    Quantity,
    Rows,
    Text,
    TextOr,
    WordOr,
)
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
            "momentary_factor",
            limited(Belt.LIMITS, "momentary_factor"),
            "Momentary factor",
            "Tension allowed while starting and braking over the rating; 1 if left out.",
        ),
        Entry(
            "least_pulley_diameter",
            limited(Belt.LIMITS, "least_pulley_diameter"),
            "Least pulley diameter",
            "Smallest drive pulley that the maker allows.",
        ),
        Entry(
            "largest_wrap_pressure",
            limited(Belt.LIMITS, "largest_wrap_pressure"),
            "Largest wrap pressure",
            "Largest pressure on the pulley face that the maker allows.",
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
        Entry("kind", Choice(CASE_KINDS), "Kind", "Running (if left out), starting or braking."),
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

TAKE_UP = Table(
    (
        Entry(
            "kind",
            Choice(TAKE_UPS),
            "Take-up",
            "Gravity and winch hold the slack-side tension; fixed holds the sum of both.",
        ),
        Entry(
            "sheave_ratio",
            limited(TakeUp.LIMITS, "sheave_ratio"),
            "Sheave ratio",
            "Pull of the counterweight over the belt tension; 2 if left out.",
        ),
    ),
    "Take-up",
)
DESIGN_STANDARD = Table(
    (
        Entry("name", Choice(STANDARDS), "Standard", "CEMA if left out; none asks for nothing."),
        Entry("condition", Choice(CONDITIONS), "Condition", "That of the lagging if left out."),
        Entry(
            "friction",
            limited(DesignStandard.LIMITS, "friction"),
            "Friction",
            "Design friction of a standard of your own.",
        ),
        Entry(
            "start_factor",
            limited(DesignStandard.LIMITS, "start_factor"),
            "Start factor",
            "Pull to design for over the pull of a running load case; 1 if left out.",
        ),
        Entry("binding", Flag(), "Binding", "Whether a drive below the standard fails."),
    ),
    "Design standard of the slack side",
)
_FACTORS = {kind: limited(SafetyFactors.LIMITS, kind) for kind in CASE_KINDS}
SAFETY = Table(
    (
        Entry(
            "running",
            _FACTORS["running"],
            "Running",
            "Pull at gross slip over the pull; 1.25 if left out.",
        ),
        Entry(
            "starting", limited(SafetyFactors.LIMITS, "starting"), "Starting", "1.1 if left out."
        ),
        Entry("braking", limited(SafetyFactors.LIMITS, "braking"), "Braking", "1.1 if left out."),
        Entry("source", Text(500), "Source", "Where the factors came from."),
    ),
    "Safety factors on gross slip",
)
SAG = Table(
    (
        Entry(
            "idler_spacing",
            limited(Sag.LIMITS, "spacing"),
            "Idler spacing",
            "Of the strand behind the pulley.",
            required=True,
            example='idler_spacing = "3 m"',
        ),
        Entry(
            "line_mass",
            limited(Sag.LIMITS, "line_mass"),
            "Mass per length",
            "Of the belt, with its load on a carrying strand.",
            required=True,
            example='line_mass = "22 kg/m"',
        ),
        Entry("share", limited(Sag.LIMITS, "share"), "Sag over spacing", "2 % if left out."),
    ),
    "Belt sag",
)
#: What a drive is held against, by the part of `wraparc.drive.Criteria`.
CRITERIA = (
    Entry("take_up", TAKE_UP, "Take-up", "What keeps the belt tight."),
    Entry("design_standard", DESIGN_STANDARD, "Design standard", "The slack side is held to it."),
    Entry("safety_factor", SAFETY, "Safety factors", "Least pull at gross slip over the pull."),
    Entry("sag", SAG, "Belt sag", "Not looked at if left out."),
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
        *CRITERIA,
        Entry("train", Elsewhere()),
    ),
    "Drive file",
)
