"""The keys of a choose file."""

from wraparc.catalogue import design_friction, lagging_costs
from wraparc.drive import Limit, Pulley, Tensions
from wraparc.files.drive_keys import SAG
from wraparc.schema.kinds import ByName, Choice, Flag, Name, Quantity, Rows, Text, WordOr
from wraparc.schema.shared_keys import FORMAT_ENTRY, PROVENANCE, limited
from wraparc.schema.tables import Entry, Table

_LENGTH = Quantity("length", Limit("length", open=True))
_POSITIVE = Quantity("number", Limit("number", open=True))
_MONEY = Quantity("number", Limit("number"))
_FACTOR = Quantity("number", Limit("number", open=True, most=2.0))
_MOST = 1000

CANDIDATES = Table(
    (
        Entry("laggings", Rows(Name(500), 1, 50), "Laggings", "Catalogue names or lagging files."),
        Entry("belts", Rows(Name(), 1, 200), "Belts", "Belts of the catalogue."),
        Entry("thicknesses", Rows(_LENGTH, 1, _MOST), "Thicknesses", "Of the lagging."),
        Entry("diameters", Rows(limited(Pulley.LIMITS, "diameter"), 1, _MOST), "Diameters"),
        Entry("wrap_angles", Rows(limited(Pulley.LIMITS, "wrap_angle"), 1, _MOST), "Wrap angles"),
        Entry(
            "slack_tensions",
            WordOr("least", Rows(limited(Tensions.LIMITS, "exit"), 1, 100_000)),
            "Slack-side tensions",
            "Kept by the take-up in every load case, or least: as low as each design can do.",
        ),
    ),
    "Candidates",
)

LIMITS = Table(
    (
        Entry("creep", _LENGTH, "Creep", "That of the drive if left out."),
        Entry("bond_stress", Quantity("pressure", Limit("pressure", open=True)), "Bond stress"),
        Entry("creep_limit_margin", _POSITIVE, "Least margin to the creep limit"),
        Entry("tested_slip_margin", _POSITIVE, "Least margin to the edge of tested slip"),
        Entry("gross_slip_margin", _POSITIVE, "Least margin to gross slip"),
        Entry("tested_pressure", Flag(), "Wrap pressures in the tested range", "Kept if left out."),
        Entry("belt_rating", Flag(), "Belt rating", "Kept if left out."),
        Entry(
            "rating_share",
            ByName(_POSITIVE),
            "Share of the rating",
            "Tension allowed over the belt rating, by load case; 1 where not named.",
        ),
        Entry("least_pulley_diameter", Flag(), "Least pulley diameter", "Kept if left out."),
        Entry("sag", SAG, "Belt sag", "Not looked at if left out."),
    ),
    "Limits",
)

_STANDARDS = tuple(dict.fromkeys(d.standard for d in design_friction() if d.condition))
CONDITION = Table(
    (
        Entry("name", Name(), "Name", "dry, wet, wet and dirty ...", required=True),
        Entry("friction_factor", _FACTOR, "Friction factor", "Friction over tested friction."),
        Entry("friction_factors", ByName(_FACTOR), "Friction factors", "By surface."),
        Entry(
            "standard",
            Choice(_STANDARDS),
            "Standard",
            "Take the ratio of its design values for the surface.",
        ),
        Entry("provenance", PROVENANCE, "Provenance", "Where the factors came from."),
    ),
    "Condition",
)

LAGGING_COST = Table(
    (
        Entry("preset", Choice(tuple(c.name for c in lagging_costs())), "Catalogue cost"),
        Entry("material", _MONEY, "Material"),
        Entry("installation", _MONEY, "Installation"),
        Entry("area", Quantity("area", Limit("area", open=True)), "Area the prices are for"),
        Entry("life_years", Rows(_POSITIVE, 2, 2), "Shortest and longest life [years]"),
        Entry("provenance", PROVENANCE, "Provenance"),
    ),
    "Cost of a lagging",
)

BELT_COST = Table(
    (
        Entry("price", _MONEY, "Price", "Of the whole belt, installed.", required=True),
        Entry("life_years", _POSITIVE, "Life [years]", required=True),
    ),
    "Cost of a belt",
)

COST = Table(
    (
        Entry("currency", Name(10), "Currency", required=True, example='currency = "AUD"'),
        Entry("years", _POSITIVE, "Years", "Years that are counted, 10 if left out."),
        Entry("tariff", _MONEY, "Tariff", "Price of a kilowatt hour."),
        Entry("hours", ByName(_MONEY), "Hours", "Hours of running in a year, by load case."),
        Entry("face_width", _LENGTH, "Face width", "Lagged width; the belt width if left out."),
        Entry("lagging", ByName(LAGGING_COST), "Laggings", "By name."),
        Entry("belt", ByName(BELT_COST), "Belts", "By name."),
    ),
    "Costs",
)

CHOOSE = Table(
    (
        FORMAT_ENTRY,
        Entry("title", Text(), "Title"),
        Entry(
            "drive",
            Name(1000),
            "Drive",
            "Drive file, relative to this one.",
            required=True,
            example='drive = "head-drive-fabric.toml"',
        ),
        Entry("pulley", Name(), "Pulley", "Which pulley of the drive; the first if left out."),
        Entry("candidates", CANDIDATES, required=True, example="a [candidates] table"),
        Entry("limits", LIMITS),
        Entry("condition", Rows(CONDITION, 1, 20), "Conditions", "All must be kept; dry if none."),
        Entry("cost", COST, required=True, example="a [cost] table with the currency"),
    ),
    "Choose file",
)
