"""The keys of a study file."""

from dataclasses import dataclass
from typing import Any

from wraparc.batch import Setting
from wraparc.drive import Limit
from wraparc.schema.kinds import Choice, Count, Kind, Name, Quantity, Rows, Text, TextOr, WordOr
from wraparc.schema.problems import Place, Report
from wraparc.schema.shared_keys import FORMAT_ENTRY, PROVENANCE
from wraparc.schema.tables import Entry, Table, need
from wraparc.study.distributions import Distribution, Lognormal, Normal, Triangular, Uniform
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


#: Distributions by their words; the fields of each without a default are the numbers it needs.
DISTRIBUTIONS: dict[str, type[Distribution]] = {
    "uniform": Uniform,
    "normal": Normal,
    "lognormal": Lognormal,
    "triangular": Triangular,
}
#: The numbers of the distributions.
NUMBERS = (
    Entry("from", "Lowest value.", Raw(), attribute="low"),
    Entry("to", "Highest value.", Raw(), attribute="high"),
    Entry("mean", "Of a normal distribution.", Raw()),
    Entry("standard_deviation", "Of a normal distribution.", Raw()),
    Entry("median", "Of a lognormal distribution.", Raw()),
    Entry(
        "geometric_standard_deviation",
        "Factor to either side of the median that contains 68 %.",
        Quantity("number"),
    ),
    Entry("mode", "Most probable value of a triangular distribution.", Raw()),
    Entry("least", "Where the distribution is cut below.", Raw(), title="Minimum"),
    Entry("most", "Where the distribution is cut above.", Raw()),
)

AXIS = Table(
    "Axis",
    need(
        "field",
        "Key path in the drive file, as for --set.",
        Name(500),
        example='field = "pulley.head.wrap_angle"',
    ),
    Entry("values", "Each combined with all others.", Rows(Raw(), 1, MOST_VALUES)),
    Entry("count", "Values from the first to the last.", Count(2, MOST_VALUES)),
    Entry("spacing", "Linear if left out.", Choice(("linear", "logarithmic"))),
    Entry("distribution", "Drawn at random.", Choice((*DISTRIBUTIONS, "fit"))),
    *NUMBERS,
    Entry("provenance", "Where the distribution came from.", PROVENANCE),
)

DRAWN_FACTOR = Table(
    "Distribution of a friction factor",
    need("distribution", kind=Choice(tuple(DISTRIBUTIONS))),
    *NUMBERS,
)


CONDITION = Table(
    "Condition",
    need("name", "dry, wet, wet and dirty ...", Name()),
    Entry("share", "For probabilities over all conditions.", _SHARE, title="Share of the time"),
    Entry("friction_factor", "1 if left out.", TextOr(FACTOR, DRAWN_FACTOR)),
    Entry("provenance", "Where the factor came from.", PROVENANCE),
)

SAMPLING = Table(
    "Sampling",
    Entry("method", "How the draws are spread.", Choice(tuple(SAMPLINGS))),
    need("samples", kind=Count(1, MOST_SAMPLES), example="samples = 99"),
    need("seed", "The same seed gives the same draws.", Count(0, 2**63 - 1), example="seed = 1"),
)

SENSITIVITY = Table(
    "Sensitivity",
    Entry("outputs", "Whose sensitivity is wanted.", Rows(Name(), 1, 20), title="Results"),
)

STUDY = Table(
    "Study file",
    FORMAT_ENTRY,
    Entry("title", kind=Text()),
    Entry("description", kind=Text(5000, lines=True)),
    need(
        "drive",
        "Drive file, relative to this one.",
        Name(1000),
        example='drive = "head-drive-fabric.toml"',
    ),
    Entry("set", "KEY=VALUE, put over the drive file.", Rows(Text(1000), 1, 200), title="Settings"),
    Entry("pulley", "Which pulley, where the drive has several.", Name()),
    Entry(
        "load_cases",
        "Every design is solved in each: names, or all; if left out the one whose tensions are "
        "varied, else the running one of maximum effective tension.",
        WordOr("all", Rows(Name(), 1, 50)),
    ),
    Entry("setting", "How accurately.", Choice(tuple(s.value for s in Setting))),
    Entry("outputs", "Results to record.", Rows(Name(), 1, 60), title="Results"),
    Entry("sampling", kind=SAMPLING),
    need(
        "axis",
        "What is varied.",
        Rows(AXIS, 1, 200),
        title="Axes",
        example="an [[axis]] table for each field that is varied",
    ),
    Entry(
        "condition", "Every design is solved in each.", Rows(CONDITION, 1, 20), title="Conditions"
    ),
    Entry("sensitivity", "Ask which axis matters.", SENSITIVITY),
)
