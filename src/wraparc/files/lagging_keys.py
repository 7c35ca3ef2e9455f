"""The keys of a lagging file, and of a lagging inside a drive file."""

from wraparc.drive import (
    SHAPES,
    SURFACES,
    Block,
    ConditionFactor,
    Cost,
    Fit,
    FrictionFactor,
    Lagging,
    Limit,
)
from wraparc.drive.lagging import UNCERTAIN_OF_LAGGING
from wraparc.friction import (
    SLIP_INCLUDES,
    Constant,
    ElasticPlastic,
    IntegralLog,
    MeasuredTable,
    PressurePower,
)
from wraparc.schema.kinds import Choice, Name, OneOrMore, Quantity, Rows, Text
from wraparc.schema.shared_keys import FORMAT_ENTRY, ORIGINS, PROVENANCE, known
from wraparc.schema.tables import Entry, Table, Variant, need
from wraparc.schema.uncertain import uncertainty_entry

_NUMBER = Quantity("number")
_NOT_NEGATIVE = Quantity("number", Limit("number"))
# beyond what any surface does, so that a wrong unit is told
_FRICTION = Quantity("number", Limit("number", open=True, most=5.0))
_FACTOR = Quantity("number", Limit("number", open=True, most=10.0))
_TABLE_FRICTION = Quantity("number", Limit("number", most=5.0))
_PRESSURE = Quantity("pressure", Limit("pressure", open=True, most=1e9))
_SLIP = Quantity("length", Limit("length", open=True, most=1.0))
_SLOPE = Quantity("per_length", Limit("per_length", -1e6, 0.0))
_STIFFNESS = Quantity("pressure_per_length", Limit("pressure_per_length", open=True, most=1e15))
_EQUATION = Text(300)
_NOTES = Rows(Text(2000, lines=True), most=50)


BLOCK = Table(
    "Blocks that take the pressure",
    Entry("shape", "In plan: square, or a strip much longer than wide.", Choice(SHAPES)),
    need("width", "Side of the square, width of the strip."),
    Entry("height", "Rubber that is compressed; else the thickness."),
    Entry(
        "stiffening",
        "1 for unfilled rubber, falling with hardness: 0.57 at 60 IRHD, 0.54 at 65 "
        "(the value if left out), 0.53 at 70.",
        title="Stiffening factor k",
    ),
    Entry(
        "contact_fraction",
        "Part of the wrap area that the blocks cover, which bears all pressure and shear; 1 if "
        "left out.",
    ),
    of=Block,
)

COST = Table(
    "Cost on one pulley",
    need("material", "Price of the lagging."),
    need("installation", "Price of putting it on."),
    need("currency", "Currency of the prices.", Name(12)),
    need("area", "Lagged area the prices are for."),
    need("life_years", "Shortest and longest life in years.", Rows(_NUMBER, 2, 2), title="Life"),
    of=Cost,
)

FIT = Table(
    "Statistics of the fit",
    need(
        "parameters",
        "What was fitted, each by its place in the law: knots[2].peak_slip.",
        Rows(Name(120), 1),
    ),
    need("values", "Best estimates, in SI units.", Rows(_NUMBER, 1)),
    need("covariance", "Their covariance, row by row, in SI units.", Rows(Rows(_NUMBER, 1), 1)),
    Entry(
        "residual_noise",
        "Standard deviation of the measured friction about the law.",
        _NOT_NEGATIVE,
    ),
    Entry(
        "coverage_factor",
        "Standard deviations to either side of a 95 % interval; 1.96 if left out.",
        Quantity("number", Limit("number", 1.0)),
    ),
    Entry("date", "When it was fitted.", Text(60)),
    Entry("method", "How it was fitted.", Text(500)),
    Entry("misfit", "Where the law does not describe the data.", _NOTES),
    Entry("misfit_accepted", "Why the law was written nevertheless.", Text(500)),
    of=Fit,
)

KNOT = Table(
    "Knot",
    need("pressure", "Pressure of the knot.", _PRESSURE, title="Wrap pressure"),
    known("peak_friction", _FRICTION, required=True),
    known("peak_slip", _SLIP, required=True),
    known("post_peak_slope", _SLOPE),
    known("residual_friction", _FRICTION),
    on_one_line=True,
)

PIECE = Table(
    "Piece",
    need("from", "Lowest pressure of the piece.", _PRESSURE),
    need("to", "Highest pressure; the next piece goes on from there.", _PRESSURE),
    need("A", "Equation of A.", _EQUATION, title="A(p)"),
    need("b", "Equation of b.", _EQUATION, title="b(p)"),
    Entry("post_peak_slope", "Equation, 0 if left out.", _EQUATION, title="Slope past the peak"),
    Entry("residual_friction", "Equation; the peak friction if left out.", _EQUATION),
    on_one_line=True,
)

TABLE_ROW = Table(
    "Row",
    need("pressure", "Pressure of the row.", _PRESSURE, title="Wrap pressure"),
    need(
        "friction", "Friction at each of the slips.", Rows(_TABLE_FRICTION, 2), attribute="values"
    ),
    on_one_line=True,
)


_FACTORS = need("factor", "Friction over that of the tested law.", Rows(_FACTOR, 2, 100))
_SOURCE = need("provenance", "Where the factors came from.", PROVENANCE)
SPEED_FACTOR = Table(
    "Factor of slip speed",
    need(
        "slip_speed",
        "Slip speeds, rising.",
        Rows(Quantity("speed", Limit("speed", open=True)), 2, 100),
        attribute="at",
    ),
    _FACTORS,
    _SOURCE,
    of=FrictionFactor,
)
TEMPERATURE_FACTOR = Table(
    "Factor of temperature",
    need(
        "temperature",
        "Temperatures of the surface, rising.",
        Rows(Quantity("temperature", Limit("temperature")), 2, 100),
        attribute="at",
    ),
    _FACTORS,
    _SOURCE,
    of=FrictionFactor,
)
CONDITION_FACTOR = Table(
    "Factor of a condition",
    need("condition", "State of the surface: wet, dirty ...", Name()),
    need("factor", "Friction over that of the tested law.", _FACTOR),
    _SOURCE,
    of=ConditionFactor,
    on_one_line=True,
)


_LAW = (
    Entry("condition", "State of the surface; dry if left out.", Name()),
    Entry("provenance", "Where this law came from, if elsewhere.", PROVENANCE),
    Entry(
        "condition_factor",
        "Of a law that was scaled to its condition: the factor on the tested friction.",
        _FACTOR,
    ),
    Entry(
        "condition_source",
        "Of a law that was scaled to its condition: where the factor came from.",
        PROVENANCE,
    ),
    Entry("fit", "Statistics of the fit.", FIT),
    Entry(
        "slip_includes",
        "What the slip contains besides the sliding, [] for nothing; not known if left out.",
        Rows(Choice(SLIP_INCLUDES), most=2),
    ),
    Entry("slip_speed_factor", "What slip speed does to the tested friction.", SPEED_FACTOR),
    Entry("temperature_factor", "What temperature does to it.", TEMPERATURE_FACTOR),
    Entry("notes", "What a reader must know of this law.", _NOTES),
)
_TESTED = (
    *_LAW,
    Entry(
        "tested_pressure",
        "Lowest and highest; not for knots and pieces, whose ends they are.",
        Rows(_PRESSURE, 2, 2),
        title="Tested pressures",
    ),
    Entry("tested_slip", "Maximum slip of the tests.", _SLIP),
    Entry(
        "tested_slip_speed",
        "Speed of slip in the tests.",
        Quantity("speed", Limit("speed", open=True)),
    ),
)
_CONSTANT = need(
    "friction", "Friction once the belt slips.", _FRICTION, attribute="friction_coefficient"
)

LAW = Variant(
    "kind",
    "Kind of the law.",
    Table(
        "integral-log",
        *_TESTED,
        Entry("knots", "The curve at rising pressures.", Rows(KNOT, 1, 200)),
        Entry("pieces", "Equations over pressure, in pieces.", Rows(PIECE, 1, 50)),
        Entry("slip_unit", "Unit of slip that A and b are for.", Text(20), title="Unit of slip"),
        Entry("pressure_unit", "Unit of p in the equations.", Text(20), title="Unit of pressure"),
        Entry(
            "continuity",
            "Maximum step between pieces, relative; 0.02 if left out.",
            Quantity("number", Limit("number", most=0.5)),
        ),
        of=IntegralLog,
    ),
    Table("constant", *_TESTED, _CONSTANT, of=Constant),
    Table(
        "elastic-plastic",
        *_TESTED,
        need("stiffness", "Shear stress per slip at first.", _STIFFNESS),
        _CONSTANT,
        of=ElasticPlastic,
    ),
    Table(
        "power",
        *_TESTED,
        need(
            "friction",
            "Friction at the reference pressure.",
            _FRICTION,
            attribute="friction_coefficient",
        ),
        need("reference_pressure", "Pressure p_0.", _PRESSURE),
        need("exponent", "n of (p/p_0)^-n, from 0 to below 1.", _NUMBER),
        of=PressurePower,
    ),
    Table(
        "table",
        *_LAW,
        need(
            "slip",
            "Rising from 0.",
            Rows(Quantity("length", Limit("length", most=1.0)), 2),
            title="Slips",
            example='slip = ["0 mm", "2 mm", "10 mm"]',
        ),
        need(
            "rows",
            "Friction at rising pressures.",
            Rows(TABLE_ROW, 1, 200),
            example='rows = [{ pressure = "100 kPa", friction = [0.0, 0.4, 0.5] }], a friction for '
            "each slip",
        ),
        of=MeasuredTable,
    ),
)


_LAGGING = (
    Entry("title", "Name in words.", Text()),
    Entry("description", "What it looks like.", Text(5000, lines=True)),
    Entry("surface", "Material that touches the belt.", Choice(SURFACES)),
    known("thickness", quantity="lagging_thickness", stated=True),
    Entry("elastic_modulus", "Young's modulus E of the rubber."),
    Entry(
        "shear_modulus",
        "Of the rubber, beside a block or over a preset with blocks: over the gross area it is "
        "taken times their contact fraction. Without blocks that over the gross area, as a grooved "
        "sample shows it. A third of the elastic modulus if left out.",
        title="Shear modulus of the lagging",
        stated=True,
    ),
    known("compression_modulus", stated=True),
    Entry(
        "block",
        "Shape of the blocks, to estimate the moduli over the gross area.",
        BLOCK,
        title="Blocks",
    ),
    known("wear_coefficient"),
    Entry("belt_energy_share", "Part of the frictional energy that the belt takes."),
    Entry(
        "bond_strength",
        "Shear stress that the lagging and its bond may bear steadily.",
    ),
    Entry(
        "fatigue_limit",
        "Shear stress that they may bear at every pass of the belt.",
    ),
    Entry("cost", "What it costs on one pulley.", COST),
    Entry(
        "slip_speed",
        "Maximum slip speed it is used at, for slip_speed_factor; its table's if left out.",
        Quantity("speed", Limit("speed", open=True)),
    ),
    Entry(
        "temperature",
        "Temperature it is used at, for temperature_factor; the minimum factor if left out.",
        Quantity("temperature", Limit("temperature")),
    ),
    Entry(
        "condition_factor",
        "Friction in conditions that it was not tested in.",
        Rows(CONDITION_FACTOR, most=20),
    ),
    Entry("law", "One for each condition.", OneOrMore(LAW), title="Friction laws"),
    uncertainty_entry(UNCERTAIN_OF_LAGGING),
    *ORIGINS,
    Entry("notes", "What a reader must know.", _NOTES),
)

LAGGING_FILE = Table(
    "Lagging file",
    FORMAT_ENTRY,
    need("name", "Name it is called by.", Name(), example='name = "my-lagging"'),
    *_LAGGING,
    of=Lagging,
)
#: A lagging as it is written inside a drive file.
LAGGING_GIVEN = Table(
    "Lagging",
    Entry("preset", "Catalogue name or file; other keys override it.", Name(500)),
    Entry("name", "Name it is called by, if not that of its table.", Name()),
    *_LAGGING,
    of=Lagging,
)
