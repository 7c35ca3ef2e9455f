"""The keys of a lagging file, and of a lagging inside a drive file."""

import math

from wraparc.drive import SHAPES, SURFACES, Block, Cost, Lagging, Limit
from wraparc.schema.kinds import Choice, Name, OneOrMore, Quantity, Rows, Text, WordOr
from wraparc.schema.shared_keys import FORMAT_ENTRY, ORIGINS, PROVENANCE, known, limited
from wraparc.schema.tables import Entry, Table, Variant

_NUMBER = Quantity("number")
_NOT_NEGATIVE = Quantity("number", Limit("number"))
_FRICTION = Quantity("number", Limit("number", open=True))
_PRESSURE = Quantity("pressure", Limit("pressure", open=True))
_SLIP = Quantity("length", Limit("length", open=True))
_SLOPE = Quantity("per_length", Limit("per_length", -math.inf, 0.0))
_STIFFNESS = Quantity("pressure_per_length", Limit("pressure_per_length", open=True))
_EQUATION = Text(300)
_NOTES = Rows(Text(2000, lines=True), most=50)


def _needed(key: str, kind: Quantity | Rows | Text | Name, title: str, meaning: str) -> Entry:
    return Entry(key, kind, title, meaning, required=True)


def _block(key: str) -> Quantity:
    return limited(Block.LIMITS, key)


BLOCK = Table(
    (
        Entry(
            "shape", Choice(SHAPES), "Shape", "In plan: square, or a strip much longer than wide."
        ),
        _needed("width", _block("width"), "Width", "Side of the square, width of the strip."),
        Entry(
            "height", _block("height"), "Height", "Rubber that is compressed; else the thickness."
        ),
        Entry(
            "stiffening",
            _block("stiffening"),
            "Stiffening factor k",
            "1 for unfilled rubber, falling with hardness: 0.57 at 60 IRHD, 0.54 at 65 (the value "
            "if left out), 0.53 at 70.",
        ),
        Entry(
            "contact_fraction",
            _block("contact_fraction"),
            "Contact fraction",
            "Part of the wrap area that the blocks cover; 1 if left out.",
        ),
    ),
    "Blocks that carry the pressure",
)

COST = Table(
    (
        _needed("material", limited(Cost.LIMITS, "material"), "Material", "Price of the lagging."),
        _needed(
            "installation",
            limited(Cost.LIMITS, "installation"),
            "Installation",
            "Price of putting it on.",
        ),
        _needed("currency", Name(12), "Currency", "Currency of the prices."),
        _needed("area", limited(Cost.LIMITS, "area"), "Area", "Lagged area the prices are for."),
        _needed("life_years", Rows(_NUMBER, 2, 2), "Life", "Shortest and longest life in years."),
    ),
    "Cost on one pulley",
)

FIT = Table(
    (
        _needed(
            "parameters",
            Rows(Name(120), 1),
            "Parameters",
            "What was fitted, each by its place in the law: knots[2].peak_slip.",
        ),
        _needed("values", Rows(_NUMBER, 1), "Values", "Best estimates, in SI units."),
        _needed(
            "covariance",
            Rows(Rows(_NUMBER, 1), 1),
            "Covariance",
            "Their covariance, row by row, in SI units.",
        ),
        Entry(
            "residual_noise",
            _NOT_NEGATIVE,
            "Residual noise",
            "Standard deviation of the measured friction about the law.",
        ),
        Entry("date", Text(60), "Date", "When it was fitted."),
        Entry("method", Text(500), "Method", "How it was fitted."),
        Entry("misfit", _NOTES, "Misfit", "Where the law does not describe the data."),
    ),
    "Statistics of the fit",
)

KNOT = Table(
    (
        _needed("pressure", _PRESSURE, "Wrap pressure", "Pressure of the knot."),
        known("peak_friction", _FRICTION, required=True),
        known("peak_slip", _SLIP, required=True),
        known("post_peak_slope", _SLOPE),
        known("residual_friction", _FRICTION),
    ),
    "Knot",
)

PIECE = Table(
    (
        _needed("from", _PRESSURE, "From", "Lowest pressure of the piece."),
        _needed("to", _PRESSURE, "To", "Highest pressure; the next piece goes on from there."),
        _needed("A", _EQUATION, "A(p)", "Equation of A."),
        _needed("b", _EQUATION, "b(p)", "Equation of b."),
        Entry("post_peak_slope", _EQUATION, "Slope past the peak", "Equation, 0 if left out."),
        Entry(
            "residual_friction",
            _EQUATION,
            "Residual friction",
            "Equation; the peak friction if left out.",
        ),
    ),
    "Piece",
)

TABLE_ROW = Table(
    (
        _needed("pressure", _PRESSURE, "Wrap pressure", "Pressure of the row."),
        _needed("friction", Rows(_NOT_NEGATIVE, 2), "Friction", "Friction at each of the slips."),
    ),
    "Row",
)


def _law(kind: str, *entries: Entry, tested: bool = True) -> Table:
    common = [
        Entry("kind", Choice((kind,)), "Kind", "Kind of the law.", required=True),
        Entry("condition", Name(), "Condition", "State of the surface; dry if left out."),
        Entry("provenance", PROVENANCE, "Provenance", "Where this law came from, if elsewhere."),
        Entry("fit", FIT, "Fit", "Statistics of the fit."),
        Entry("notes", _NOTES, "Notes", "What a reader must know of this law."),
    ]
    if tested:
        common += [
            Entry(
                "tested_pressure",
                Rows(_PRESSURE, 2, 2),
                "Tested pressures",
                "Lowest and highest; not for knots and pieces, whose ends they are.",
            ),
            Entry("tested_slip", _SLIP, "Tested slip", "Largest slip of the tests."),
            Entry(
                "tested_slip_speed",
                Quantity("speed", Limit("speed", open=True)),
                "Tested slip speed",
                "Speed of slip in the tests.",
            ),
        ]
    return Table((*common, *entries), kind)


_CONSTANT = _needed("friction", _FRICTION, "Friction", "Friction once the belt slips.")

LAW = Variant(
    "kind",
    {
        "integral-log": _law(
            "integral-log",
            Entry("knots", Rows(KNOT, 1, 200), "Knots", "The curve at rising pressures."),
            Entry("pieces", Rows(PIECE, 1, 50), "Pieces", "Equations over pressure, in pieces."),
            Entry("slip_unit", Text(20), "Unit of slip", "Unit of slip that A and b are for."),
            Entry("pressure_unit", Text(20), "Unit of pressure", "Unit of p in the equations."),
            Entry(
                "continuity",
                Quantity("number", Limit("number", most=0.5)),
                "Continuity",
                "Largest step between pieces, relative; 0.02 if left out.",
            ),
        ),
        "constant": _law("constant", _CONSTANT),
        "elastic-plastic": _law(
            "elastic-plastic",
            _needed("stiffness", _STIFFNESS, "Stiffness", "Shear stress per slip at first."),
            _CONSTANT,
        ),
        "power": _law(
            "power",
            _needed("friction", _FRICTION, "Friction", "Friction at the reference pressure."),
            _needed("reference_pressure", _PRESSURE, "Reference pressure", "Pressure p_0."),
            _needed("exponent", _NUMBER, "Exponent", "n of (p/p_0)^-n, from 0 to below 1."),
        ),
        "table": _law(
            "table",
            _needed(
                "slip", Rows(Quantity("length", Limit("length")), 2), "Slips", "Rising from 0."
            ),
            _needed("rows", Rows(TABLE_ROW, 1, 200), "Rows", "Friction at rising pressures."),
            tested=False,
        ),
    },
)


def _rigid_or(key: str) -> WordOr:
    return WordOr("rigid", limited(Lagging.LIMITS, key), math.inf)


_LAGGING = (
    Entry("title", Text(), "Title", "Name in words."),
    Entry("description", Text(5000, lines=True), "Description", "What it looks like."),
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
    Entry("block", BLOCK, "Blocks", "Shape of the blocks, to estimate the compression modulus."),
    known("wear_coefficient", limited(Lagging.LIMITS, "wear_coefficient")),
    Entry(
        "bond_strength",
        limited(Lagging.LIMITS, "bond_strength"),
        "Bond strength",
        "Shear stress that the lagging and its bond may bear steadily.",
    ),
    Entry(
        "fatigue_limit",
        limited(Lagging.LIMITS, "fatigue_limit"),
        "Fatigue limit",
        "Shear stress that they may bear at every pass of the belt.",
    ),
    Entry("cost", COST, "Cost", "What it costs on one pulley."),
    Entry("law", OneOrMore(LAW), "Friction laws", "One for each condition."),
    *ORIGINS,
    Entry("notes", _NOTES, "Notes", "What a reader must know."),
)

LAGGING_FILE = Table(
    (
        FORMAT_ENTRY,
        Entry(
            "name",
            Name(),
            "Name",
            "Name it is called by.",
            required=True,
            example='name = "my-lagging"',
        ),
        *_LAGGING,
    ),
    "Lagging file",
)
#: A lagging as it is written inside a drive file.
LAGGING_GIVEN = Table(
    (
        Entry("preset", Name(500), "Preset", "Catalogue name or file; other keys override it."),
        Entry("name", Name(), "Name", "Name it is called by, if not that of its table."),
        *_LAGGING,
    ),
    "Lagging",
)
