"""The keys of a choose file."""

from wraparc.catalogue import lagging_costs
from wraparc.choose.cost import BeltPrice, Costing
from wraparc.choose.search import Limits
from wraparc.drive import Cost, Lagging, Limit, Pulley, Tensions
from wraparc.files.drive_keys import CONDITION, SAG
from wraparc.schema.kinds import ByName, Choice, Flag, Name, Quantity, Rows, Text, WordOr
from wraparc.schema.shared_keys import FORMAT_ENTRY, PROVENANCE
from wraparc.schema.tables import Entry, Table, limited, need

_LENGTH = Quantity("length", Limit("length", least=0.05e-3, most=10.0))
_MARGIN = Quantity("number", Limit("number", least=0.5, most=20.0))
_YEARS = Quantity("number", Limit("number", least=0.02, most=100.0))
_MONEY = Quantity("number", Limit("number"))
_HOURS = Quantity("number", Limit("number", most=8784.0))
_STRESS = Quantity("pressure", Limit("pressure", least=5e3, most=1e8))
_MOST = 1000

CANDIDATES = Table(
    "Candidates",
    Entry("laggings", "Catalogue names or lagging files.", Rows(Name(500), 1, 50)),
    Entry("belts", "Belts of the catalogue.", Rows(Name(), 1, 200)),
    Entry("thicknesses", "Of the lagging.", Rows(limited(Lagging, "thickness"), 1, _MOST)),
    Entry("diameters", kind=Rows(limited(Pulley, "diameter"), 1, _MOST)),
    Entry("wrap_angles", kind=Rows(limited(Pulley, "wrap_angle"), 1, _MOST)),
    Entry(
        "slack_tensions",
        'Constant in every load case, or "least": the minimum of each design.',
        WordOr("least", Rows(limited(Tensions, "exit"), 1, 100000)),
        title="Slack-side tensions",
    ),
)

LIMITS = Table(
    "Limits",
    Entry("creep", "That of the drive if left out.", _LENGTH),
    Entry("bond_stress", kind=_STRESS),
    Entry("creep_limit_margin", kind=_MARGIN, title="Minimum margin to the creep limit"),
    Entry("tested_slip_margin", kind=_MARGIN, title="Minimum margin to the end of tested slip"),
    Entry(
        "gross_slip_safety",
        "That of the drive if left out.",
        _MARGIN,
        title="Minimum gross-slip safety",
    ),
    Entry(
        "tested_pressure",
        "Unchanged if left out.",
        Flag(),
        title="Wrap pressures in the tested range",
    ),
    Entry("belt_rating", "Unchanged if left out.", Flag()),
    Entry(
        "rating_share",
        "Tension allowed over the belt rating, by load case; 1 where not named.",
        ByName(Quantity("number", Limit("number", least=0.2, most=5.0))),
        title="Share of the rating",
    ),
    Entry(
        "least_pulley_diameter", "Unchanged if left out.", Flag(), title="Minimum pulley diameter"
    ),
    Entry("sag", "That of the drive if left out.", SAG, title="Belt sag"),
    of=Limits,
)

LAGGING_COST = Table(
    "Cost of a lagging",
    Entry("preset", kind=Choice(tuple(c.name for c in lagging_costs())), title="Catalogue cost"),
    Entry("material", kind=_MONEY),
    Entry("installation", kind=_MONEY),
    Entry(
        "area",
        kind=Quantity("area", Limit("area", least=0.01, most=1e3)),
        title="Area the prices are for",
    ),
    Entry("life_years", kind=Rows(_YEARS, 2, 2), title="Shortest and longest life [years]"),
    Entry("provenance", kind=PROVENANCE),
    of=Cost,
)

BELT_COST = Table(
    "Cost of a belt",
    need("price", "Of the whole belt, installed.", _MONEY),
    need("life_years", kind=_YEARS, title="Life [years]"),
    of=BeltPrice,
)

COST = Table(
    "Costs",
    need("currency", kind=Name(10), example='currency = "AUD"'),
    Entry("years", "Years that are counted, 10 if left out.", _YEARS),
    Entry("tariff", "Price of a kilowatt hour.", _MONEY),
    Entry("hours", "Hours of running in a year, by load case.", ByName(_HOURS)),
    Entry("face_width", "Lagged width; the belt width if left out.", _LENGTH),
    Entry("lagging", "By name.", ByName(LAGGING_COST), title="Laggings"),
    Entry("belt", "By name.", ByName(BELT_COST), title="Belts"),
    of=Costing,
)

CHOOSE = Table(
    "Choose file",
    FORMAT_ENTRY,
    Entry("title", kind=Text()),
    need(
        "drive",
        "Drive file, relative to this one.",
        Name(1000),
        example='drive = "head-drive-fabric.toml"',
    ),
    Entry("pulley", "Which pulley, where the drive has several.", Name()),
    need("candidates", kind=CANDIDATES, example="a [candidates] table"),
    Entry("limits", kind=LIMITS),
    Entry(
        "condition", "Designs pass in all; dry if none.", Rows(CONDITION, 1, 20), title="Conditions"
    ),
    need("cost", kind=COST, example="a [cost] table with the currency"),
)
