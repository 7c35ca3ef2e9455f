"""The keys of a lagging file, and of a lagging inside a drive file."""

import math

from wraparc.drive import SHAPES, SURFACES, Block, Cost, Lagging, Limit
from wraparc.files.common_keys import FORMAT_ENTRY, ORIGINS, PROVENANCE, known, limited
from wraparc.files.kinds import Choice, Name, OneOrMore, Quantity, Rows, Text, WordOr
from wraparc.files.tables import Entry, Table, Variant

_NUMBER = Quantity("number")
_FRICTION = Quantity("number", Limit("number", open=True))
_PRESSURE = Quantity("pressure", Limit("pressure", open=True))
_SLIP = Quantity("length", Limit("length", open=True))
_UNIT = Text(20)
_NOTES = Rows(Text(2000, lines=True), most=50)

BLOCK = Table(
    (
        Entry("shape", Choice(SHAPES), "Shape", "square in plan, or a long strip"),
        Entry(
            "width",
            limited(Block.LIMITS, "width"),
            "Width",
            "Side of the square, width of the strip.",
            required=True,
        ),
        Entry(
            "height",
            limited(Block.LIMITS, "height"),
            "Height",
            "Height of the rubber that is compressed; the thickness if left out.",
        ),
        Entry(
            "stiffening",
            limited(Block.LIMITS, "stiffening"),
            "Stiffening factor k",
            "Gent's factor: 1 for unfilled rubber, 0.54 for a compound of 65 IRHD.",
        ),
        Entry(
            "contact_fraction",
            limited(Block.LIMITS, "contact_fraction"),
            "Contact fraction",
            "Part of the wrap area that the blocks cover.",
        ),
    ),
    "Blocks that carry the pressure",
)

COST = Table(
    (
        Entry("material", limited(Cost.LIMITS, "material"), required=True),
        Entry("installation", limited(Cost.LIMITS, "installation"), required=True),
        Entry("currency", Name(12), required=True),
        Entry("area", limited(Cost.LIMITS, "area"), "Lagged area", required=True),
        Entry("life_years", Rows(_NUMBER, 2, 2), "Shortest and longest life", required=True),
    ),
    "Cost on one pulley",
)

FIT = Table(
    (
        Entry("parameters", Rows(Name(120), 1), required=True),
        Entry("values", Rows(_NUMBER, 1), "Best estimates, SI", required=True),
        Entry("covariance", Rows(Rows(_NUMBER, 1), 1), "Covariance, SI", required=True),
        Entry("residual_noise", Quantity("number", Limit("number"))),
        Entry("date", Text(60)),
        Entry("method", Text(500)),
        Entry("misfit", _NOTES),
    ),
    "Statistics of the fit",
)

KNOT = Table(
    (
        Entry("pressure", _PRESSURE, "Wrap pressure", required=True),
        known("peak_friction", _FRICTION, required=True),
        known("peak_slip", _SLIP, required=True),
        known("post_peak_slope", Quantity("per_length", Limit("per_length", -math.inf, 0.0))),
        known("residual_friction", _FRICTION),
    ),
    "Knot",
)

PIECE = Table(
    (
        Entry("from", _PRESSURE, "From", "Lowest pressure of the piece.", required=True),
        Entry("to", _PRESSURE, "To", "Highest pressure of the piece.", required=True),
        Entry("A", Text(300), "A(p)", "Equation of A.", required=True),
        Entry("b", Text(300), "b(p)", "Equation of b.", required=True),
        Entry("post_peak_slope", Text(300), "Slope past the peak", "Equation of the slope."),
        Entry("residual_friction", Text(300), "Residual friction", "Equation of the level."),
    ),
    "Piece",
)

TABLE_ROW = Table(
    (
        Entry("pressure", _PRESSURE, "Wrap pressure", required=True),
        Entry("friction", Rows(Quantity("number", Limit("number")), 2), required=True),
    ),
    "Row",
)


def _law(kind: str, *entries: Entry, tested: bool = True) -> Table:
    common = [
        Entry("kind", Choice((kind,)), required=True),
        Entry("condition", Name(), "Condition", "State of the surface: dry, wet, dirty ..."),
        Entry("provenance", PROVENANCE, "Provenance of this law"),
        Entry("fit", FIT),
    ]
    if tested:
        common += [
            Entry("tested_pressure", Rows(_PRESSURE, 2, 2), "Tested pressures"),
            Entry("tested_slip", _SLIP, "Largest tested slip"),
        ]
    return Table((*common, *entries), kind)


LAW = Variant(
    "kind",
    {
        "integral-log": _law(
            "integral-log",
            Entry("knots", Rows(KNOT, 1, 200)),
            Entry("slip_unit", _UNIT, "Unit of slip in the equations"),
            Entry("pressure_unit", _UNIT, "Unit of pressure in the equations"),
            Entry("pieces", Rows(PIECE, 1, 50)),
            Entry("continuity", Quantity("number", Limit("number", most=0.5))),
        ),
        "constant": _law("constant", Entry("friction", _FRICTION, required=True)),
        "elastic-plastic": _law(
            "elastic-plastic",
            Entry(
                "stiffness",
                Quantity("pressure_per_length", Limit("pressure_per_length", open=True)),
                required=True,
            ),
            Entry("friction", _FRICTION, required=True),
        ),
        "power": _law(
            "power",
            Entry("friction", _FRICTION, required=True),
            Entry("reference_pressure", _PRESSURE, required=True),
            Entry("exponent", _NUMBER, required=True),
        ),
        "table": _law(
            "table",
            Entry("slip", Rows(Quantity("length", Limit("length")), 2), required=True),
            Entry("rows", Rows(TABLE_ROW, 1, 200), required=True),
            tested=False,
        ),
    },
)


def _rigid_or(key: str) -> WordOr:
    return WordOr("rigid", limited(Lagging.LIMITS, key), math.inf)


_LAGGING = (
    Entry("title", Text(), "Title", "Name in words."),
    Entry("description", Text(5000, lines=True)),
    Entry("surface", Choice(SURFACES), "Surface", "Material that touches the belt."),
    known("thickness", limited(Lagging.LIMITS, "thickness"), "lagging_thickness"),
    Entry(
        "elastic_modulus",
        limited(Lagging.LIMITS, "elastic_modulus"),
        "Elastic modulus",
        "Young's modulus E of the rubber.",
    ),
    known("shear_modulus", _rigid_or("shear_modulus")),
    known("compression_modulus", _rigid_or("compression_modulus")),
    Entry("block", BLOCK),
    known("wear_coefficient", limited(Lagging.LIMITS, "wear_coefficient")),
    Entry("cost", COST),
    Entry("law", OneOrMore(LAW), "Friction laws", "One for each condition."),
    *ORIGINS,
    Entry("notes", _NOTES),
)

LAGGING_FILE = Table(
    (
        FORMAT_ENTRY,
        Entry("name", Name(), required=True, example='name = "my-lagging"'),
        *_LAGGING,
    ),
    "Lagging file",
)
#: A lagging as it is written inside a drive file.
LAGGING_GIVEN = Table(
    (
        Entry("preset", Name(500), "Preset", "Catalogue name or file; other keys override it."),
        Entry("name", Name()),
        *_LAGGING,
    ),
    "Lagging",
)
