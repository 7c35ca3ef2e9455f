"""The keys of a drive file."""

from wraparc.catalogue import design_friction
from wraparc.catalogue.own import MODULUS_KEYS
from wraparc.conveyor.keys import BELT_PATH, CONVEYOR
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
from wraparc.drive.belt import SIDES, UNCERTAIN_OF_BELT
from wraparc.drive.conditions import Condition
from wraparc.drive.load_case import UNCERTAIN_OF_CASE
from wraparc.drive.pulley import UNCERTAIN_OF_PULLEY
from wraparc.files.across_keys import ACROSS
from wraparc.files.elongation import Elongation
from wraparc.files.lagging_keys import LAGGING_GIVEN
from wraparc.schema.kinds import (
    ByName,
    Choice,
    Elsewhere,
    Flag,
    Name,
    OneOrMore,
    Quantity,
    Rows,
    Text,
    TextOr,
    WordOr,
)
from wraparc.schema.shared_keys import FORMAT_ENTRY, ORIGINS, PROVENANCE, known
from wraparc.schema.tables import Entry, Misplaced, Table, limited, need
from wraparc.schema.uncertain import uncertainty_entry

BELT = Table(
    "Belt",
    Entry(
        "preset",
        "A belt of the catalogue, or a standard name: EP 630/3, EP 1000/4 6+3 Y, NN 500/4, "
        "ST 2000, 330 PIW 3 ply. Other keys override it.",
        Name(),
        title="Belt",
    ),
    Entry(
        "name",
        "Designation of the belt. A standard name without a modulus brings its usual data, as in "
        "preset.",
        Name(),
    ),
    Entry("kind", "Carcass, for example fabric or steel cord.", Text(60)),
    known("width", quantity="belt_width", required=True),
    known("modulus", quantity="belt_modulus"),
    Entry(
        "elongation",
        "Elongation at a share of the breaking strength, 1.5 % at 10 %, instead of the modulus.",
        Elongation(),
    ),
    Entry("rating", "Rated (operating) tension per unit width."),
    Entry(
        "strength",
        "Breaking strength per unit width, for the safety factor of the belt; that in the name of "
        "the belt, ST2000 or EP 630/4, if left out.",
    ),
    *MODULUS_KEYS,
    known("speed", quantity="belt_speed"),
    Entry(
        "momentary_factor",
        "Tension allowed while starting and braking over the rating; 1 if left out.",
    ),
    Entry(
        "least_pulley_diameter",
        "Smallest drive pulley that the maker allows.",
        title="Minimum pulley diameter",
    ),
    Entry(
        "largest_wrap_pressure",
        "Maximum pressure on the pulley face that the maker allows.",
        title="Maximum wrap pressure",
    ),
    Entry(
        "in_plane_shear_stiffness",
        "Shear force per width over shear strain in the plane of the belt; estimated from the "
        "carcass if left out.",
    ),
    known("pulley_cover"),
    known("carry_cover"),
    known("carcass"),
    Entry(
        "thickness",
        "Of the whole belt, covers and carcass in all; one of them follows from it.",
    ),
    Entry(
        "cover_shear_modulus",
        "Shear modulus of the covers; 1 MPa if left out, an estimate of what lies between 0.8 and "
        "1.5 MPa.",
    ),
    Entry("cord_diameter", "Diameter of steel cords; the carcass if left out."),
    Entry(
        "cord_pitch",
        "Distance between the axes of neighbouring steel cords: the rubber between them shears "
        "too, by 1 to 2.5 mm more than the cover; left out, it is not counted.",
    ),
    Entry(
        "mass",
        "Mass of a metre of belt; or belt_mass of [conveyor]. Of a preset with both covers it is "
        "computed where its maker publishes the masses of its layers.",
    ),
    uncertainty_entry(UNCERTAIN_OF_BELT),
    *ORIGINS,
    of=Belt,
)

_TENSION = limited(Tensions, "entry")
TENSIONS = (
    known("entry_tension", _TENSION),
    known("exit_tension", _TENSION),
    known("effective_tension", Quantity("force")),
    Entry(
        "torque",
        "Torque on the pulley, effective tension times D/2 and the offset of the tension member, "
        "if the belt layers are stated; negative when braking.",
        Quantity("torque"),
    ),
    Entry(
        "power",
        "Power to the belt, effective tension times belt speed; negative when braking.",
        Quantity("power"),
    ),
)

_FACTOR = limited(Condition, "factor")
_STANDARDS = tuple(dict.fromkeys(d.standard for d in design_friction() if d.condition))
CONDITION = Table(
    "Condition",
    need("name", "dry, wet, wet and dirty ...", Name()),
    Entry("friction_factor", "Friction over tested friction.", _FACTOR, attribute="factor"),
    Entry("friction_factors", "By surface.", ByName(_FACTOR)),
    Entry("standard", "Take the ratio of its design values for the surface.", Choice(_STANDARDS)),
    Entry("provenance", "Where the factors came from.", PROVENANCE),
    of=Condition,
)
_CONDITION = TextOr(Name(), CONDITION)

PULLEY = Table(
    "Pulley",
    need("name", "Name of the pulley.", Name(), example='name = "head"'),
    known("diameter", required=True),
    known("wrap_angle", required=True, alias="wrap", unless="belt_path"),
    Entry("belt_path", "Coordinates of the pulleys, instead of the wrap angle.", BELT_PATH),
    need(
        "lagging",
        "Catalogue name, name of a [lagging.NAME] table, path of a lagging file, or a table.",
        TextOr(Name(500), LAGGING_GIVEN),
        example='lagging = "diamond-rubber"',
    ),
    Entry("condition", "If not that of the drive: dry, wet ...", _CONDITION),
    *TENSIONS,
    known("overrun", WordOr("formula", limited(Pulley, "overrun"))),
    Entry("recovery", "Whether the lagging adds creep as it recovers along the arc."),
    known("creep_limit"),
    Entry(
        "side",
        "Side of the belt that meets the pulley: pulley (if left out), or its other side, as "
        "on one pulley of an S-wrap.",
        Choice(SIDES),
        title="Belt side",
    ),
    known("mass", quantity="pulley_mass"),
    Entry("across", "What is uneven across the width.", ACROSS),
    uncertainty_entry(UNCERTAIN_OF_PULLEY),
    Entry("sources", "Where single numbers came from, by key.", ByName(PROVENANCE)),
    of=Pulley,
)

#: What stands for the name of a pulley in a hint, until it is known.
A_PULLEY = "NAME"
LOAD_CASE = Table(
    "Load case",
    need("name", "Name of the case.", Name(), example='name = "start"'),
    Entry("description", "What happens then.", Text(1000, lines=True)),
    Entry(
        "kind",
        "Running (if left out), starting or braking; stopping is read as braking.",
        Choice(CASE_KINDS, {"stopping": "braking"}),
    ),
    Entry("condition", "Dry, wet ...; that of the drive if left out.", _CONDITION),
    Entry(
        "pulley",
        "Tensions by pulley; those not named retain their own.",
        ByName(Table("Tensions", *TENSIONS, uncertainty_entry(UNCERTAIN_OF_CASE))),
        title="Tensions",
    ),
    Entry("train", kind=Elsewhere()),
    misplaced=Misplaced(
        tuple(entry.key for entry in TENSIONS),
        "tensions of a load case belong to its pulleys",
        f"Write pulley.{A_PULLEY}.{{key}} in the load case.",
        owner="pulley",
    ),
)

TAKE_UP = Table(
    "Take-up",
    Entry(
        "kind",
        "Gravity and winch fix the slack-side tension; fixed means a constant sum of both.",
        Choice(TAKE_UPS),
        title="Take-up",
    ),
    Entry("sheave_ratio", "Force of the counterweight over the belt tension; 2 if left out."),
    Entry(
        "after",
        "Pulley behind which it is, between drives; if left out, behind the last drive.",
        Name(),
        title="Behind pulley",
    ),
    of=TakeUp,
)
DESIGN_STANDARD = Table(
    "Design standard of T2",
    Entry("name", "CEMA if left out; none for no standard.", Choice(STANDARDS), title="Standard"),
    Entry("condition", "That of the lagging if left out.", Choice(CONDITIONS)),
    Entry("friction", "Design friction of a standard of your own."),
    Entry(
        "start_factor", "Design effective tension over that of a running load case; 1 if left out."
    ),
    Entry("binding", "Whether a drive below the standard fails."),
    of=DesignStandard,
)
SAFETY = Table(
    "Safety factors on gross slip",
    Entry(
        "running", "Effective tension at gross slip over the effective tension; 1.25 if left out."
    ),
    Entry("starting", "1.1 if left out."),
    Entry("braking", "1.1 if left out."),
    Entry("source", "Where the factors came from.", Text(500)),
    of=SafetyFactors,
)
SAG = Table(
    "Belt sag",
    need(
        "idler_spacing",
        "Of the strand behind the pulley.",
        example='idler_spacing = "3 m"',
        attribute="spacing",
    ),
    Entry(
        "line_mass",
        "Of the belt, with its load on a carrying strand; the mass of the belt if left out.",
        title="Mass per length",
    ),
    Entry("share", "2 % if left out.", title="Sag over spacing"),
    of=Sag,
)
#: What a drive is held against, by the part of `wraparc.drive.Criteria`.
CRITERIA = (
    Entry("take_up", "What tensions the belt.", TAKE_UP, title="Take-up"),
    Entry("design_standard", "Standard for the minimum T2.", DESIGN_STANDARD, attribute="standard"),
    Entry(
        "safety_factor",
        "Minimum effective tension at gross slip over the effective tension.",
        SAFETY,
        title="Safety factors",
        attribute="safety",
    ),
    Entry("sag", "Not looked at if left out.", SAG, title="Belt sag"),
    Entry(
        "covered",
        "Whether the drive never runs wet: its creep when wet is then not estimated; false if left "
        "out.",
        Flag(),
    ),
)

DRIVE = Table(
    "Drive file",
    FORMAT_ENTRY,
    Entry("title", "What the drive is called.", Text()),
    Entry("description", "Anything worth saying.", Text(5000, lines=True)),
    known("creep_limit", stated=True),
    Entry(
        "condition",
        "Dry, wet, wet and dirty ...; several are solved side by side.",
        OneOrMore(_CONDITION, 8),
    ),
    need("belt", "The belt.", BELT, example="a [belt] table"),
    need(
        "pulley",
        "The drive pulleys in belt order.",
        Rows(PULLEY, 1, MOST_PULLEYS),
        title="Pulleys",
        example="a [[pulley]] table for each pulley",
    ),
    Entry("lagging", "Laggings of this drive, by name.", ByName(LAGGING_GIVEN), title="Laggings"),
    Entry("load_case", "States of the conveyor.", Rows(LOAD_CASE, 1), title="Load cases"),
    Entry("conveyor", "The load cases by resistances, instead of tensions.", CONVEYOR),
    *CRITERIA,
    Entry("train", kind=Elsewhere()),
    Entry("motion", "The drives in time: events, inertias, controls.", Elsewhere()),
    Entry("learned", "What wraparc learn took from the logs of the drive.", Elsewhere()),
    of=Drive,
)
