"""The keys of a shear test plan."""

from dataclasses import dataclass
from typing import Any

from wraparc.drive import SURFACES, Limit
from wraparc.schema.kinds import ByName, Choice, Flag, Kind, Name, Quantity, Rows, Text
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.shared_keys import FORMAT_ENTRY, PROVENANCE
from wraparc.schema.tables import Entry, Table
from wraparc.shear_test import DELIMITER_NAMES

_MOST_TESTS = 1000


@dataclass(frozen=True)
class Column(Kind):
    """A column by its name, or by its number counted from 1."""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the name or the number."""
        if isinstance(raw, int) and not isinstance(raw, bool):
            if 1 <= raw <= 10_000:
                return raw
            report.add(place, "must be a number from 1", "The first column is 1.", raw)
            return NOTHING
        return Name(200).read(raw, place, report)

    def schema(self) -> dict[str, Any]:
        """Text or a whole number."""
        return {"type": ["string", "integer"], "minimum": 1}


@dataclass(frozen=True)
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
        """A whole number."""
        return {"type": "integer", "minimum": self.least, "maximum": self.most}


_PRESSURE = Quantity("pressure", Limit("pressure", open=True))
_FORCE = Quantity("force", Limit("force", open=True))
_LENGTH = Quantity("length", Limit("length", open=True))
_MODULUS = Quantity("pressure", Limit("pressure", 1.0))

# What can be said of a file; in [columns] for all tests, in a [[test]] for one.
_FILE_ENTRIES = (
    Entry("travel", Column(), "Travel", "Column of the crosshead travel, by name or number."),
    Entry("force", Column(), "Force", "Column of the pulling force, by name or number."),
    Entry(
        "normal_force_column",
        Column(),
        "Normal force column",
        "Column of the measured normal force, by name or number.",
    ),
    Entry("time", Column(), "Time", "Column of the time, by name or number."),
    Entry(
        "units",
        ByName(Text(40)),
        "Units",
        "Unit of a column where the file has none, by name or number of the column.",
    ),
    Entry("decimal", Choice((".", ",")), "Decimal sign"),
    Entry("delimiter", Choice(tuple(DELIMITER_NAMES.values())), "Delimiter"),
    Entry("encoding", Name(40), "Encoding", "As Python calls it."),
    Entry("sheet", Name(200), "Sheet", "Sheet of a workbook."),
    Entry("table", Count(1, 10_000), "Table", "Which table of the file, from 1."),
)
COLUMNS = Table(_FILE_ENTRIES, "What holds for all files")

LAGGING = Table(
    (
        Entry("name", Name(), "Name", "Name that drive files ask for it by.", required=True),
        Entry("title", Text(), "Title", "Name in words."),
        Entry("description", Text(2000, lines=True), "Description"),
        Entry("surface", Choice(SURFACES), "Surface", "Material that touches the belt."),
        Entry("thickness", _LENGTH, "Thickness", "Thickness that shears."),
        Entry("shear_modulus", _MODULUS, "Shear modulus", "G of the rubber."),
        Entry("elastic_modulus", _MODULUS, "Elastic modulus", "E of the rubber."),
        Entry("compression_modulus", _MODULUS, "Compression modulus", "E_c over the gross area."),
        Entry(
            "roughness",
            _LENGTH,
            "Roughness",
            "Of lagging and belt together, for the saturation estimate E * roughness / thickness.",
        ),
    ),
    "Lagging",
)

RIG = Table(
    (
        Entry(
            "sample_area",
            Quantity("area", Limit("area", open=True)),
            "Sample area",
            "Area of one face of the sample.",
            required=True,
        ),
        Entry("faces", Count(1, 2), "Faces", "Faces of the sample that slide, 2 if left out."),
        Entry(
            "compliance",
            Text(40),
            "Compliance",
            "The rig's own travel for a force, such as 0.02 mm/kN.",
        ),
        Entry("largest_lash", _LENGTH, "Largest lash", "Lash the rig can have, 3 mm if left out."),
        Entry("name", Text(), "Name", "What rig and machine."),
    ),
    "Rig",
)

FIT_OPTIONS = Table(
    (
        Entry("transition_pressure", _PRESSURE, "Transition pressure", "Estimated if left out."),
        Entry("pieces", Count(1, 2), "Pieces", "Pieces over pressure, chosen if left out."),
        Entry(
            "variables",
            Choice(("peak", "coefficients")),
            "Variables",
            "Pieces of x_pk and mu_pk, or of A and b.",
        ),
        Entry(
            "remove_shear",
            Flag(),
            "Remove the sample's shear",
            "Whether to take the sample's own shear off the travel; done if it is known.",
        ),
    ),
    "Fit",
)

TEST = Table(
    (
        Entry("file", Name(1000), "File", "Relative to the plan.", required=True),
        Entry("pressure", _PRESSURE, "Pressure", "Set pressure on the sample."),
        Entry("normal_force", _FORCE, "Normal force", "Set normal force."),
        Entry("condition", Name(), "Condition", "dry, wet, dirty ...; dry if left out."),
        Entry("repeat", Name(), "Repeat", "Tests with the same word here are repeats."),
        Entry("temperature", Quantity("temperature", Limit("temperature")), "Temperature"),
        Entry("speed", Quantity("speed", Limit("speed", open=True)), "Crosshead speed"),
        Entry("date", Text(60), "Date"),
        Entry("sample", Text(), "Sample", "Which sample."),
        *_FILE_ENTRIES,
    ),
    "Test",
)

PLAN = Table(
    (
        FORMAT_ENTRY,
        Entry("lagging", LAGGING, required=True, example="a [lagging] table"),
        Entry("rig", RIG, required=True, example='[rig] with sample_area = "400 cm2"'),
        Entry("columns", COLUMNS),
        Entry("fit", FIT_OPTIONS),
        Entry("provenance", PROVENANCE, "Provenance", "Who tested, when; measured if left out."),
        Entry("test", Rows(TEST, 1, _MOST_TESTS), required=True, example="a [[test]] table a test"),
    ),
    "Shear test plan",
)
