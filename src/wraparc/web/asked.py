"""Requests of the API."""

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BaseModel, ConfigDict, Field

System = Literal["si", "us"]
#: Tables of a drive file as JSON: the same keys and the same quantity texts.
Document = Annotated[
    dict[str, Any],
    Field(
        description="Tables of a drive file: the same keys and the same texts for quantities.",
        examples=[
            {
                "format": 1,
                "belt": {"preset": "Plylon Plus 1000/4", "width": "1200 mm", "speed": "3 m/s"},
                "pulley": [
                    {
                        "name": "head",
                        "diameter": "800 mm",
                        "wrap_angle": "180 deg",
                        "lagging": "diamond-rubber",
                        "entry_tension": "150 kN",
                        "exit_tension": "60 kN",
                    }
                ],
            }
        ],
    ),
]


def _printable(text: str) -> str:
    if not all(c.isprintable() or c in "\n\t" for c in text):
        raise ValueError("contains characters that cannot be printed")
    return text


Line = Annotated[str, Field(max_length=200), AfterValidator(_printable)]
Name = Annotated[str, Field(min_length=1, max_length=200), AfterValidator(_printable)]
Lines = Annotated[str, Field(max_length=5000), AfterValidator(_printable)]
Head = Annotated[str, Field(max_length=120)]
_CASE = "The running one of maximum effective tension if left out."
Short = Annotated[str, Field(max_length=60)]


class Request(BaseModel):
    """A request; unknown keys are refused."""

    model_config = ConfigDict(extra="forbid", strict=True)


class FastRequest(Request):
    """One arc without capacities."""

    document: Document
    pulley: Line | None = Field(None, description="The first if left out.")
    load_case: Line | None = Field(None, description=_CASE)
    governing: bool = Field(
        False, description="Whether that pulley and load case are meant that govern the verdict."
    )
    points: int = Field(120, ge=8, le=1000, description="Parts of the wrap in the profile.")
    tables: bool = Field(False, description="Whether to send tables as well.")
    prepared: bool = Field(
        False, description="Whether to send the arc as numbers, of which the page goes on itself."
    )
    sequence: int = Field(0, ge=0, le=2**53, description="Returned unchanged.")


class SolveRequest(Request):
    """Everything, by both methods."""

    document: Document
    load_case: Line | None = Field(None, description="Only this one.")
    points: int = Field(180, ge=8, le=1000)
    prepared: bool = Field(
        False, description="Whether to send the checks as numbers, of which the page goes on."
    )
    search: bool = Field(
        True, description="Whether changes are tried for the action; else see `/solve/action`."
    )
    sequence: int = Field(0, ge=0, le=2**53)


class ActionRequest(Request):
    """What to do about the verdict on a drive, or how little changes it."""

    document: Document
    load_case: Line | None = Field(None, description="Only this one.")
    sequence: int = Field(0, ge=0, le=2**53, description="Returned unchanged.")


class CheckRequest(Request):
    """A drive, as a document or as the text of its file."""

    document: Document | None = None
    toml: str | None = Field(None, max_length=1_000_000)


class TomlRequest(Request):
    """The text of a drive file."""

    toml: str = Field(max_length=1_000_000)
    name: Line = ""


class DocumentRequest(Request):
    """A drive."""

    document: Document


class LaggingRequest(Request):
    """The text of a lagging file."""

    toml: str = Field(max_length=1_000_000)


class QuantityItem(Request):
    """A quantity as typed."""

    text: str = Field(max_length=200)
    dimension: Short


class QuantitiesRequest(Request):
    """Quantities as typed."""

    items: list[QuantityItem] = Field(max_length=500)


class CompareRequest(Request):
    """The same drive with other laggings or belts."""

    document: Document
    pulley: Line | None = None
    load_case: Line | None = None
    what: Literal["laggings", "belts"] = "laggings"
    names: list[Line] | None = Field(None, max_length=60)
    years: float = Field(10.0, gt=0.0, le=100.0)
    hours: float = Field(6000.0, ge=0.0, le=8784.0)
    tariff: float | None = Field(None, ge=0.0, le=1e6)
    currency: Line = "AUD"


class SeekRequest(Request):
    """Which value of an input gives a wanted result."""

    document: Document
    field: str = Field(max_length=500, description="Key path of the input.")
    result: Short = Field(description="Name of the result in the glossary.")
    value: Short = Field(description="What it is to be, with its unit.")
    pulley: Line = ""
    load_case: Line = ""
    least: Short = Field("", description="Minimum input; a third of the present one if left out.")
    most: Short = Field("", description="Most; three times the present one if left out.")
    now: Short = Field("", description="The present input where a preset gives it.")


class WhatIfRequest(Request):
    """A pulley before and after changes, each made to the drive as it is."""

    document: Document
    pulley: Line | None = None
    load_case: Line | None = None
    other_carcass: bool = False
    belts: list[Line] = Field([], max_length=12)
    laggings: list[Line] = Field([], max_length=12)
    thicknesses: list[Short] = Field([], max_length=12)
    worn: list[Short] = Field([], max_length=12)
    wet: Short = Field("", description='Friction when wet over dry, or "DIN 22101".')
    bare: Short = Field("", description='"CEMA" or "DIN 22101".')


class ChooseRequest(Request):
    """Candidates for one pulley, every combination of them, and what they cost.

    What has no candidates stays as the drive has it; laggings and belts are those of the catalogue.
    """

    document: Document
    pulley: Line | None = None
    laggings: list[Line] = Field([], max_length=50)
    belts: list[Line] = Field([], max_length=60)
    thicknesses: list[Short] = Field([], max_length=50)
    diameters: list[Short] = Field([], max_length=50)
    wrap_angles: list[Short] = Field([], max_length=50)
    slack_tensions: list[Short] = Field([], max_length=200)
    least_slack: bool = Field(False, description="Each design with its minimum T2.")
    currency: Line = "AUD"
    years: float = Field(10.0, gt=0.0, le=100.0)
    tariff: float | None = Field(None, ge=0.0, le=1e6)
    hours: dict[Line, float] = Field({}, max_length=50, description="Of a year, by load case.")


class MeasuredFile(Request):
    """A file of a measured drive: a record, or a calibrate file that names records."""

    name: Name
    data: str = Field(max_length=27_000_000, description="Its bytes in base 64.")


class MeasuredRequest(Request):
    """What was measured on a pulley; a calibrate file says all but the drive itself."""

    document: Document
    pulley: Line | None = None
    load_case: Line = ""
    parameters: list[Literal["friction", "peak_slip", "shear_modulus"]] = Field([], max_length=3)
    files: list[MeasuredFile] = Field(min_length=1, max_length=50)


class OnSiteRequest(Request):
    """What is known of the site."""

    document: Document
    pulley: Line | None = None
    hours: dict[Line, float] = Field({}, max_length=50, description="Of a year, by load case.")
    wear_hours: dict[Line, float] = Field({}, max_length=50)
    wear_coefficient: Short = ""
    measured_wear: Short = ""
    depth: Short = ""


class TrainRequest(Request):
    """Several drives on one belt."""

    document: Document
    load_case: Line | None = None
    match: bool = False
    drive: Line | None = Field(None, description="Drive to vary; the second if left out.")
    span: list[Short] | None = Field(
        None, min_length=2, max_length=2, description="Ends of the trims."
    )
    points: int = Field(61, ge=3, le=401)
    wear: Short = "1 mm"
    map: bool = False


class AcrossRequest(Request):
    """A pulley across the width of its belt."""

    document: Document
    pulley: Line | None = Field(None, description="The first if left out.")
    load_case: Line | None = Field(None, description=_CASE)


class AcrossWearRequest(AcrossRequest):
    """What wear makes of an uneven lagging."""

    depth: Short | None = Field(
        None, description="Mean depth to wear off; or `passes`; on to re-lagging if left out."
    )
    passes: float | None = Field(None, gt=0.0, le=1e12, description="Turns of the pulley.")
    least_thickness: Short = Field("3 mm", description="Of the thinnest strip when re-lagged.")
    hours: float | None = Field(
        None,
        gt=0.0,
        le=1e7,
        description="Run since the lagging was new, for its wear rate.",
    )


class AcrossThicknessRequest(AcrossRequest):
    """What thicker laggings cushion."""

    thicknesses: list[Short] = Field(min_length=2, max_length=12)


class StudyRequest(Request):
    """A study of a drive."""

    study: dict[str, Any] = Field(description="Tables of a study file; its drive is `document`.")
    document: Document


class LearnRequest(Request):
    """What logs that were uploaded say of a drive."""

    document: Document
    learn: dict[str, Any] = Field(
        default_factory=dict,
        description="Tables of a learn file; its drive is `document`, its logs are uploaded.",
    )


class EventRequest(Request):
    """The drives of a design in time: a run through an event, or whether they pulsate."""

    document: Document
    what: Literal["run", "stability", "map"] = "run"
    event: Line | None = Field(None, description="The first if left out.")
    points: int = Field(60, ge=10, le=400, description="Pieces of lagging on the shortest wrap.")
    step: Short | None = Field(None, description="Time step; chosen if left out.")
    run_out: Short = Field("0.5 mm", description="Amplitude that the answers refer to.")
    over: Literal["droop", "coupling slip"] = Field("droop", description="What a map goes over.")


class DesignRequest(Request):
    """A design to save."""

    name: Name
    document: Document
    note: Lines = ""
    who: Line = ""


class VersionRequest(Request):
    """A new version of a design."""

    document: Document
    note: Lines = ""
    who: Line = ""
    base: int = Field(ge=1, le=2**31 - 1, description="The version it was made from.")
    name: Name | None = Field(None, description="A new name of the design.")


class RenameRequest(Request):
    """A new name of a design."""

    name: Name


class ReportHead(Request):
    """Title block of a calculation note."""

    title: Head = ""
    project: Head = ""
    number: Head = ""
    revision: Head = ""
    author: Head = ""
    date: Head = ""
    paper: Literal["a4", "us-letter"] = "a4"


class ExportRequest(Request):
    """A drive whose answer is wanted as a file."""

    document: Document
    units: System = "si"
    name: Line = Field("drive", description="Name of the file, without its ending.")


class ReportRequest(ExportRequest):
    """A calculation note."""

    head: ReportHead = ReportHead()


class FileChoices(Request):
    """What a machine file does not tell of itself."""

    travel: Line | int | None = None
    force: Line | int | None = None
    normal_force: Line | int | None = None
    time: Line | int | None = None
    units: dict[str, Short] | None = Field(None, max_length=100)
    decimal: Short | None = None
    delimiter: Short | None = None
    encoding: Short | None = None
    sheet: Line | None = None
    table: int | None = None
    block: int | None = None
    stress_area: Short | None = None
    stroke: Short | None = None
    stick_slip: Short | None = None


class TestFileRequest(Request):
    """What is said of a machine file."""

    __test__ = False  # not a test class, whatever its name suggests to a test collector

    pressure: Short | None = None
    normal_force: Short | None = None
    condition: Line = "dry"
    repeat: Line = ""
    sample: Line = ""
    use: bool = True
    reason: Line = ""
    choices: FileChoices = FileChoices()
    curve_pressures: dict[str, Short] = Field(
        {}, max_length=200, description="Of the curves of a digitised file, by their names."
    )
    more: dict[str, Any] = Field(
        {}, description="Other keys of its test in a plan: speed, temperature, lot ..."
    )
    illustrative: bool = False


class FitRequest(Request):
    """The lagging, the rig and how to fit, as in a test plan."""

    lagging: dict[str, Any]
    rig: dict[str, Any]
    fit: dict[str, Any] = {}
    more: dict[str, Any] = Field(
        {}, description="Other tables of the plan: columns, all_tests, uncertainty, report ..."
    )
    accept_misfit: str = ""
