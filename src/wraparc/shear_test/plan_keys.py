"""The keys of a shear test plan."""

from dataclasses import dataclass
from typing import Any

from wraparc.drive import SURFACES, Limit
from wraparc.schema.kinds import (
    ByName,
    Choice,
    Count,
    Flag,
    Kind,
    Name,
    Percent,
    Quantity,
    Rows,
    Text,
)
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.shared_keys import FORMAT_ENTRY, PROVENANCE
from wraparc.schema.tables import Entry, Table, need
from wraparc.shear_test import DELIMITER_NAMES, PlannedTest, PressureOptions, Rig
from wraparc.shear_test.budget import Uncertainty
from wraparc.shear_test.circumstances import LoadCell, ReportHead
from wraparc.shear_test.curve_held import Held
from wraparc.shear_test.plan import QUANTITIES, Digitised
from wraparc.shear_test.record_faults import STICK_SLIP
from wraparc.shear_test.reduce import STROKES

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


_PRESSURE = Quantity("pressure", Limit("pressure", least=500.0, most=2e7))
_FORCE = Quantity("force", Limit("force", least=5.0, most=1e6))
_FORCE_OR_NONE = Quantity("force", Limit("force"))
_LENGTH = Quantity("length", Limit("length", open=True, most=1.0))
_MODULUS = Quantity("pressure", Limit("pressure", 1.0))
_FRICTION = Quantity("number", Limit("number", least=1e-4, most=1e4))
_HUMIDITY = Percent()

# What can be said of a file; in [columns] for all tests, in a [[test]] for one.
_FILE_ENTRIES = (
    Entry("travel", "Column of the crosshead travel, by name or number.", Column()),
    Entry("force", "Column of the pulling force, by name or number.", Column()),
    Entry(
        "normal_force_column", "Column of the measured normal force, by name or number.", Column()
    ),
    Entry("time", "Column of the time, by name or number.", Column()),
    Entry(
        "units",
        "Unit of a column where the file has none, by name or number of the column.",
        ByName(Text(40)),
    ),
    Entry("decimal", kind=Choice((".", ",")), title="Decimal sign"),
    Entry("delimiter", kind=Choice(tuple(DELIMITER_NAMES.values()))),
    Entry("encoding", "As Python calls it.", Name(40)),
    Entry("sheet", "Sheet of a workbook.", Name(200)),
    Entry("table", "Which table of the file, from 1.", Count(1, 10000)),
    Entry(
        "block",
        "Which of the tests in the table, side by side or under each other, from 1.",
        Count(1, 1000),
    ),
    Entry(
        "stress_area",
        "Area that the machine divided the force by, where the force column is a stress.",
        Quantity("area", Limit("area", open=True)),
    ),
    Entry(
        "stroke",
        "Which stroke of a record of several: first if left out, last after run-in cycles, the "
        "readings of all, or their mean at each travel.",
        Choice(STROKES),
    ),
    Entry(
        "stick_slip",
        "Which part of stick-slip is fitted: the mean of its oscillation, or its upper or lower "
        "ends.",
        Choice(STICK_SLIP),
    ),
)
COLUMNS = Table("Common to all files", *_FILE_ENTRIES)

LAGGING = Table(
    "Lagging",
    need("name", "Name of the lagging in drive files.", Name()),
    Entry("title", "Name in words.", Text()),
    Entry("description", kind=Text(2000, lines=True)),
    Entry("surface", "Material that touches the belt.", Choice(SURFACES)),
    Entry("thickness", "Thickness that shears.", _LENGTH),
    Entry(
        "shear_modulus",
        "G over the gross area: of the rubber, times the part of the area that blocks cover.",
        _MODULUS,
    ),
    Entry("elastic_modulus", "E of the rubber.", _MODULUS),
    Entry("compression_modulus", "E_c over the gross area.", _MODULUS),
    Entry(
        "roughness",
        "Of lagging and belt together, for the saturation estimate E * roughness / thickness.",
        _LENGTH,
    ),
)

LOAD_CELL = Table(
    "Load cell",
    Entry("make", "Maker and type.", Text()),
    Entry("serial", "Serial number.", Text(60)),
    Entry("accuracy", "Class or calibration uncertainty, as its certificate says it.", Text()),
    Entry("calibrated", "Date of its calibration.", Text(60)),
    Entry("certificate", "Number of the certificate.", Text(60)),
    of=LoadCell,
)

RIG = Table(
    "Rig",
    need(
        "sample_area",
        "Area of one face of the sample.",
        Quantity("area", Limit("area", least=1e-4, most=2.0)),
        attribute="area",
    ),
    Entry("faces", "Faces of the sample that slide, 2 if left out.", Count(1, 2)),
    Entry("compliance", "The rig's own travel for a force, such as 0.02 mm/kN.", Text(40)),
    Entry(
        "largest_lash", "Lash the rig can have, 3 mm if left out.", _LENGTH, title="Maximum lash"
    ),
    Entry(
        "least_friction",
        "A test that reaches less is left out: a unit or column is wrong; 0.02 if left out.",
        _FRICTION,
        title="Minimum friction",
    ),
    Entry(
        "most_friction",
        "A test that reaches more is left out: a unit or column is wrong; 3 if left out.",
        _FRICTION,
    ),
    Entry("name", "What rig.", Text()),
    Entry("machine", "Testing machine: maker, type, serial number.", Text()),
    Entry("operator", "Who tests.", Text()),
    Entry("force_cell", "What measures the pulling force.", LOAD_CELL),
    Entry("normal_force_cell", "What measures the normal force.", LOAD_CELL),
    of=Rig,
)

TEST_BELT = Table(
    "Belt of the tests",
    need(
        "cover_thickness",
        "Rubber between a sliding face and the carcass; 0 mm where nothing shears.",
        Quantity("length", Limit("length", most=0.06)),
        example='cover_thickness = "4 mm"',
    ),
    Entry(
        "cover_shear_modulus",
        "Shear modulus of that rubber.",
        Quantity("pressure", Limit("pressure", 1e4)),
    ),
)

_PART = Percent(0.5)
UNCERTAINTY = Table(
    "Maximum errors, common to all tests",
    Entry("force", 'Of the pulling force: "0.5 %" for class 0.5; 1 % if left out.', _PART),
    Entry("normal_force", "Of the normal force or set pressure; 1 % if left out.", _PART),
    Entry("area", "Of the sample area; 1 % if left out.", _PART),
    Entry("travel", "Of the travel; 1 % if left out.", _PART),
    Entry("zero", "Of the zero of the pulling force; 0 if left out.", _FORCE_OR_NONE),
    Entry(
        "compliance",
        "Of the rig's compliance; 20 % of it if left out, or 0.05 mm/kN where it is missing.",
        Text(40),
    ),
    Entry(
        "temperature",
        "What the temperature of the tests may change in friction; 0 if left out.",
        _PART,
    ),
    Entry("shear_modulus", "Of the modulus of the sample; 20 % if left out.", _PART),
    Entry(
        "cover_shear_modulus",
        "Of the modulus of the test belt's cover; 20 % if left out.",
        _PART,
    ),
    of=Uncertainty,
)

DIGITISED = Table(
    "Curves read off a figure",
    need("source", "Who published it: author, title, year.", Text(), example='source = "..."'),
    Entry("figure", "Which figures.", Text(200)),
    Entry(
        "quantity",
        "What the curves are: friction over slip (left out), or A and b over pressure.",
        Choice(QUANTITIES),
    ),
    Entry("slip_unit", "Unit of x, mm if left out; A and b are per it, and need it.", Text(20)),
    Entry("pressure_unit", "Unit of pressure under A and b.", Text(20)),
    Entry("error", "Of a point, as a share of full scale; 1 % if left out.", _PART),
    Entry("slip_max", "Slip up to which A and b are valid, their peak if left out.", _LENGTH),
    of=Digitised,
)

FIXED = Table(
    "Fixed parameters of the curves",
    Entry("peak_slip", "Slip at the peak.", _LENGTH),
    Entry("peak_friction", "Friction at the peak.", _FRICTION),
    Entry("lash", "Lash of the rig.", Quantity("length", Limit("length"))),
    of=Held,
    on_one_line=True,
)

FIT_OPTIONS = Table(
    "Fit",
    Entry("transition_pressure", "Estimated if left out.", _PRESSURE),
    Entry("pieces", "Pieces over pressure, chosen if left out.", Count(1, 2)),
    Entry(
        "variables", "Pieces of x_pk and mu_pk, or of A and b.", Choice(("peak", "coefficients"))
    ),
    Entry(
        "remove_shear",
        "Whether to take the sample's own shear off the travel; done if it is known.",
        Flag(),
        title="Remove the sample's shear",
    ),
    Entry("fixed", 'Fixed instead of fitted, such as { lash = "0.5 mm" }.', FIXED),
    of=PressureOptions,
)

# What can be said of all tests at once, or of one.
_CIRCUMSTANCES = (
    Entry("temperature", kind=Quantity("temperature", Limit("temperature"))),
    Entry("humidity", 'Relative humidity of the air, such as "50 %".', _HUMIDITY),
    Entry(
        "speed",
        kind=Quantity("speed", Limit("speed", least=1e-7, most=1.0)),
        title="Crosshead speed",
    ),
    Entry("date", kind=Text(60)),
    Entry("operator", "Who tested, if not the operator of the rig.", Text()),
    Entry("lot", "Lot of the specimen.", Text()),
    Entry("belt_cover", "What the lagging slides on.", Text()),
    Entry("conditioning", "How sample and belt were stored and prepared before.", Text(500)),
)
ALL_TESTS = Table("Common to all tests", *_CIRCUMSTANCES)

TEST = Table(
    "Test",
    need("file", "Relative to the plan.", Name(1000)),
    Entry("pressure", "Set pressure on the sample.", _PRESSURE),
    Entry("normal_force", "Set normal force.", _FORCE),
    Entry("condition", "dry, wet, dirty ...; dry if left out.", Name()),
    Entry("repeat", "Tests with the same word here are repeats.", Name()),
    Entry("sample", "Which sample.", Text()),
    Entry("order", "Place in the order in which the tests were done, from 1.", Count(1, 100_000)),
    Entry("curve", "Which curve of a digitised file, by its name; all if left out.", Name(200)),
    Entry("use", "false leaves the test out; say why in reason.", Flag()),
    Entry("reason", "Why the test is left out.", Text(500)),
    *_CIRCUMSTANCES,
    *_FILE_ENTRIES,
    of=PlannedTest,
)

REPORT = Table(
    "Report",
    Entry("laboratory", "Who reports.", Text()),
    Entry("number", "Number of the report.", Text(60)),
    Entry("customer", "For whom.", Text()),
    Entry("tested_by", "Who signs as having tested.", Text()),
    Entry("checked_by", "Who signs as having checked.", Text()),
    of=ReportHead,
)

PLAN = Table(
    "Shear test plan",
    FORMAT_ENTRY,
    need("lagging", kind=LAGGING, example="a [lagging] table"),
    need("rig", kind=RIG, example='[rig] with sample_area = "400 cm2"'),
    Entry("test_belt", "Its cover, to take its shear off the travel.", TEST_BELT),
    Entry("columns", kind=COLUMNS),
    Entry("all_tests", "Common to all tests; a [[test]] overrules it.", ALL_TESTS),
    Entry("report", "Title block and signatures of the report.", REPORT),
    Entry("uncertainty", "How wrong the measured may be.", UNCERTAINTY),
    Entry("digitised", "Curves of a figure in the place of tests.", DIGITISED),
    Entry("fit", kind=FIT_OPTIONS),
    Entry("provenance", "Who tested, when; measured if left out.", PROVENANCE),
    need("test", kind=Rows(TEST, 1, _MOST_TESTS), example="a [[test]] table a test"),
)
