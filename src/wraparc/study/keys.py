"""The keys of a study file."""

from dataclasses import dataclass
from typing import Any

from wraparc.batch import Setting
from wraparc.drive import Limit
from wraparc.schema.kinds import Choice, Kind, Name, Quantity, Rows, Text, WordOr
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.shared_keys import FORMAT_ENTRY, PROVENANCE
from wraparc.schema.tables import Entry, Table
from wraparc.study.fields import FACTOR
from wraparc.study.sampling import SAMPLINGS

#: Most values of one axis, and most samples.
MOST_VALUES, MOST_SAMPLES = 1_000_000, 1_000_000_000

_SHARE = Quantity("number", Limit("number", open=True, most=1.0))


@dataclass(eq=False, repr=False)
class Raw(Kind):
    """A value whose kind follows from another key; it is read once that is known."""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the value as it stands."""
        return raw

    def schema(self) -> dict[str, Any]:
        """A number, a word or a truth value."""
        return {"type": ["number", "string", "boolean"]}


@dataclass(eq=False, repr=False)
class Count(Kind):
    """A whole number."""

    least: int
    most: int

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the number."""
        whole = isinstance(raw, int) and not isinstance(raw, bool)
        if whole and self.least <= raw <= self.most:  # type: ignore[operator]
            return raw
        message = f"must be a whole number from {self.least} to {self.most}"
        report.add(place, message, value=raw)
        return NOTHING

    def schema(self) -> dict[str, Any]:
        """An integer between bounds."""
        return {"type": "integer", "minimum": self.least, "maximum": self.most}


#: distribution -> the keys it needs
DISTRIBUTIONS: dict[str, tuple[str, ...]] = {
    "uniform": ("from", "to"),
    "normal": ("mean", "standard_deviation"),
    "lognormal": ("median", "geometric_standard_deviation"),
    "triangular": ("from", "mode", "to"),
    "fit": (),
}
_NUMBERS = (
    Entry("from", Raw(), "From", "Lowest value."),
    Entry("to", Raw(), "To", "Highest value."),
    Entry("mean", Raw(), "Mean", "Of a normal distribution."),
    Entry("standard_deviation", Raw(), "Standard deviation", "Of a normal distribution."),
    Entry("median", Raw(), "Median", "Of a lognormal distribution."),
    Entry(
        "geometric_standard_deviation",
        Quantity("number"),
        "Geometric standard deviation",
        "Factor to either side of the median that holds 68 %.",
    ),
    Entry("mode", Raw(), "Mode", "Most probable value of a triangular distribution."),
    Entry("least", Raw(), "Least", "Where the distribution is cut below."),
    Entry("most", Raw(), "Most", "Where the distribution is cut above."),
)

AXIS = Table(
    (
        Entry(
            "field",
            Name(500),
            "Field",
            "Key path in the drive file, as for --set.",
            required=True,
            example='field = "pulley.head.wrap_angle"',
        ),
        Entry("values", Rows(Raw(), 1, MOST_VALUES), "Values", "Each combined with all others."),
        Entry("count", Count(2, MOST_VALUES), "Count", "Values from the first to the last."),
        Entry("spacing", Choice(("linear", "logarithmic")), "Spacing", "Linear if left out."),
        Entry("distribution", Choice(tuple(DISTRIBUTIONS)), "Distribution", "Drawn at random."),
        *_NUMBERS,
        Entry("provenance", PROVENANCE, "Provenance", "Where the distribution came from."),
    ),
    "Axis",
)

DRAWN_FACTOR = Table(
    (
        Entry(
            "distribution",
            Choice(tuple(name for name in DISTRIBUTIONS if name != "fit")),
            "Distribution",
            required=True,
        ),
        *_NUMBERS,
    ),
    "Distribution of a friction factor",
)


@dataclass(eq=False, repr=False)
class NumberOr(Kind):
    """A number, or a table."""

    number: Kind
    table: Kind

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the number or the table."""
        return (self.table if isinstance(raw, dict) else self.number).read(raw, place, report)

    def schema(self) -> dict[str, Any]:
        """Either of the two."""
        return {"anyOf": [self.number.schema(), self.table.schema()]}


CONDITION = Table(
    (
        Entry("name", Name(), "Name", "dry, wet, wet and dirty ...", required=True),
        Entry("share", _SHARE, "Share of the time", "For probabilities over all conditions."),
        Entry(
            "friction_factor", NumberOr(FACTOR, DRAWN_FACTOR), "Friction factor", "1 if left out."
        ),
        Entry("provenance", PROVENANCE, "Provenance", "Where the factor came from."),
    ),
    "Condition",
)

SAMPLING = Table(
    (
        Entry("method", Choice(tuple(SAMPLINGS)), "Method", "How the draws are spread."),
        Entry("samples", Count(1, MOST_SAMPLES), "Samples", required=True, example="samples = 99"),
        Entry("seed", Count(0, 2**63 - 1), "Seed", "The same seed gives the same draws.",
              required=True, example="seed = 1"),
    ),
    "Sampling",
)  # fmt: skip

SENSITIVITY = Table(
    (Entry("outputs", Rows(Name(), 1, 20), "Results", "Whose sensitivity is wanted."),),
    "Sensitivity",
)

STUDY = Table(
    (
        FORMAT_ENTRY,
        Entry("title", Text(), "Title"),
        Entry("description", Text(5000, lines=True), "Description"),
        Entry(
            "drive",
            Name(1000),
            "Drive",
            "Drive file, relative to this one.",
            required=True,
            example='drive = "head-drive-fabric.toml"',
        ),
        Entry("set", Rows(Text(1000), 1, 200), "Settings", "KEY=VALUE, put over the drive file."),
        Entry("pulley", Name(), "Pulley", "Which pulley of the drive; the first if left out."),
        Entry(
            "load_cases",
            WordOr("all", Rows(Name(), 1, 50)),
            "Load cases",
            "Every design is solved in each: names, or all; the first if left out.",
        ),
        Entry("setting", Choice(tuple(s.value for s in Setting)), "Setting", "How accurately."),
        Entry("outputs", Rows(Name(), 1, 60), "Results", "Results that are kept."),
        Entry("sampling", SAMPLING),
        Entry("axis", Rows(AXIS, 1, 200), "Axes", "What is varied.", required=True,
              example="an [[axis]] table for each field that is varied"),
        Entry("condition", Rows(CONDITION, 1, 20), "Conditions", "Every design is solved in each."),
        Entry("sensitivity", SENSITIVITY, "Sensitivity", "Ask which axis matters."),
    ),
    "Study file",
)  # fmt: skip
