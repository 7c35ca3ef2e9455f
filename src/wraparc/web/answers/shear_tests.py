"""Machine files read and fitted; runs in a process of its own for every file."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from pydantic import Field

from wraparc.answer.shear_test_findings import condition_findings
from wraparc.answer.shear_test_record import record_sheet
from wraparc.answer.shear_test_tables import plan_sheet
from wraparc.checks import Level
from wraparc.errors import InputError
from wraparc.files.write import lagging_text
from wraparc.schema.source import Document, parse
from wraparc.shear_test import (
    MachineRecord,
    PlannedTest,
    TestPlan,
    fit_plan,
    read_machine_bytes,
)
from wraparc.shear_test.analysis import ConditionResult, PlanResult
from wraparc.shear_test.analysis import TestResult as OneTest
from wraparc.shear_test.digitised import guessed_pressure, read_points, with_curves
from wraparc.shear_test.file_names import read_name
from wraparc.shear_test.plan_file import plan_from_document
from wraparc.shear_test.plan_keys import PLAN
from wraparc.shear_test.reader import table_columns
from wraparc.shear_test.standard_values import STANDARD_SLIPS, friction_at, law_at_slips
from wraparc.units import in_units
from wraparc.web.answers.shown import (
    Answer,
    Data,
    Numbers,
    Sheet,
    Table,
    Text,
    finite,
    rounded,
    sheet,
    tables,
    worded,
)
from wraparc.web.answers.texts import PlanAnswer, plan_text
from wraparc.web.asked import FileChoices, FitRequest, TestFileRequest
from wraparc.web.errors import ToldProblem, told

_PREVIEW, _CURVE, _PRESSURES = 240, 200, 60
#: A digitiser writes less than this [bytes].
_MOST_POINTS = 1_000_000
#: Which of the standard slips are shown over pressure: 2 and 6.35 mm.
_SHOWN_SLIPS = (1, 3)
_TEST_KEYS = ("pressure", "normal_force", "condition", "repeat", "sample")


@dataclass(frozen=True)
class MachineFile:
    """A file of a test machine, and what is said of it."""

    id: str
    name: str
    data: bytes
    said: TestFileRequest


class FileColumn(Answer):
    """A column of a machine file."""

    name: str
    unit: str
    role: str


class Preview(Answer):
    """Travel [m] and force [N] of a test."""

    travel: Numbers
    force: Numbers


class DigitisedCurve(Answer):
    """A curve of a digitiser's file."""

    name: str
    points: int
    pressure: str | None


class ReadFile(Answer):
    """What was understood of a file, or what has to be said about it.

    `digitised` is what it is if its numbers are points read off a figure.
    """

    read: bool = False
    digitised: list[DigitisedCurve] = Field(default_factory=list)
    problems: list[ToldProblem] = Field(default_factory=list)
    tables: list[Table] = Field(default_factory=list)
    columns: list[FileColumn] = Field(default_factory=list)
    notes: list[str] = Field(default_factory=list)
    preview: Preview | None = None
    pressure_guess: str | None = None
    condition_guess: str | None = None
    number: str | None = None
    place: str = ""


class ReadFiles(Answer):
    """What was understood of several files."""

    files: list[ReadFile]


class FittedCurve(Answer):
    """Friction of one test over slip [m], and the fit through it."""

    file: str
    pressure: float
    slip: Numbers
    friction: Numbers
    fitted: Numbers
    peak_friction: float | None
    peak_slip: float | None
    lash: float | None
    noise: float | None
    flagged: bool
    misfit: list[str]


class PressurePoint(Answer):
    """Peak of one test."""

    file: str
    pressure: float
    peak_slip: float | None
    peak_friction: float | None


class FrictionAtSlip(Answer):
    """Friction over pressure [Pa] at a slip [m]: of the law with its band, and of the tests."""

    slip: float
    pressure: Numbers
    friction: Numbers
    band: Numbers
    points: list[tuple[float, float]]


class PressureFunctions(Answer):
    """Peaks over pressure [Pa]: of the tests, and of the law."""

    points: list[PressurePoint]
    pressure: Numbers = Field(default_factory=list)
    peak_slip: Numbers = Field(default_factory=list)
    peak_friction: Numbers = Field(default_factory=list)


class Transition(Answer):
    """Pressure from which the friction falls [Pa]."""

    pressure: float | None
    given: bool
    in_law: bool


class Finding(Answer):
    """A finding of the tests of one condition; `tests` is how many it concerns, None of a value."""

    title: str
    level: Level
    value: Text
    text: Text
    tests: int | None


class FittedCondition(Answer):
    """What was found in one condition."""

    condition: str
    findings: list[Finding]
    misfit: list[str]
    remarks: list[str]
    curves: list[FittedCurve]
    pressure_functions: PressureFunctions
    at_slips: list[FrictionAtSlip]
    transition: Transition | None


class FitAnswer(Answer):
    """A fitted lagging, as a table for a drive document and as a file.

    Text are there only if the law describes its tests, or its misfit was accepted.
    """

    name: str
    lagging: Data | None
    toml: str | None
    sheet: Sheet
    conditions: list[FittedCondition]
    left_out: list[ToldProblem]
    removes_shear: bool


def said_by_name(name: str) -> TestFileRequest:
    """What the name of a file says of its test; its number makes no repeats, equal pressures do."""
    test = read_name(name)
    return TestFileRequest(pressure=test.pressure, condition=test.condition or "dry")


def read_files(files: list[MachineFile]) -> ReadFiles:
    """Return what was understood of several files."""
    return ReadFiles(files=[_read_file(file) for file in files])


def _read_file(file: MachineFile) -> ReadFile:
    curves, name = _curves_of(file), read_name(file.name)
    guesses = {
        "pressure_guess": name.pressure,
        "condition_guess": name.condition,
        "number": name.number,
    }
    try:
        test = _one_test(file)
        record = read_machine_bytes(file.data, file.name, test.choices)
    except InputError as error:
        columns = _columns_of(file)
        return ReadFile(problems=told(error.problems), columns=columns, digitised=curves, **guesses)
    shown = record_sheet(record)
    step = max(1, len(record.travel) // _PREVIEW)
    return ReadFile(
        read=True,
        digitised=curves,
        place=shown.subtitle,
        tables=tables(shown.tables, ("columns", "rows")),
        columns=[FileColumn(name=c.name, unit=c.unit, role=c.role) for c in record.columns],
        notes=list(shown.remarks),
        preview=Preview(travel=rounded(record.travel[::step]), force=rounded(record.force[::step])),
        **guesses,
    )


def _curves_of(file: MachineFile) -> list[DigitisedCurve]:
    try:
        found = read_points(file.data, file.name) if len(file.data) <= _MOST_POINTS else []
    except InputError:
        return []
    return [
        DigitisedCurve(name=c.name, points=len(c.x), pressure=guessed_pressure(c.name))
        for c in found
    ]


def _columns_of(file: MachineFile) -> list[FileColumn]:
    """Columns of a file that was not understood, so that their units can be given."""
    try:
        found = table_columns(file.data, file.name, _one_test(file).choices)
    except InputError:
        return []
    return [FileColumn(name=c.label, unit=c.unit, role="") for c in found]


def _one_test(file: MachineFile) -> PlannedTest:
    document = {
        "format": 1,
        "lagging": {"name": "lagging"},
        "rig": {"sample_area": "1 m2"},
        "test": [_test_table(file.name, file.said.model_copy(update={"use": True}))],
    }
    return plan_from_document(document).tests[0]


def _test_table(file: str, said: TestFileRequest) -> Document:
    """Return the table of a test plan for what the user says of a file."""
    choices = said.choices.model_dump()
    choices["normal_force_column"] = choices.pop("normal_force")
    given = {**said.more, **said.model_dump(include=set(_TEST_KEYS)), **choices}
    if not said.use:
        given |= {"use": False, "reason": said.reason}
    return {"file": file, **{k: v for k, v in given.items() if v not in (None, "", {})}}


def _test_tables(file: str, said: TestFileRequest) -> list[Document]:
    """One test, or one a curve where the curves of a file were told their pressures."""
    table = _test_table(file, said)
    named = [
        {**table, "curve": name} | ({"pressure": pressure} if pressure else {})
        for name, pressure in said.curve_pressures.items()
    ]
    return named or [table]


def plan_file(asked: FitRequest, uploads: list[MachineFile]) -> PlanAnswer:
    """The file of the test plan; it lies beside the files of the machine."""
    plan = _plan(asked, [(upload.name, upload) for upload in uploads])
    return plan_text(plan, PLAN, f"plan of {asked.lagging.get('name', 'a lagging')}", "plan")


def _plan(asked: FitRequest, files: Sequence[tuple[str, MachineFile]]) -> Document:
    """Return the test plan of files, each with the name that it has in it."""
    document: Data = {
        "format": 1,
        "lagging": _without_empty(asked.lagging),
    }
    rig = _without_empty(asked.rig)
    document |= {"rig": rig} if rig or "digitised" not in asked.more else {}  # a figure needs none
    document |= {key: table for key, table in asked.more.items() if key not in document}
    options = _without_empty(asked.fit)
    document |= {"fit": options} if options else {}
    if any(upload.said.illustrative for _, upload in files):
        note = "virtual tests of a known law, no real product"
        origin = {"kind": "illustrative", "source": "virtual rig", "note": note}
        document["provenance"] = origin
    tests = [table for file, upload in files for table in _test_tables(file, upload.said)]
    return {**document, "test": tests}


def fit(asked: FitRequest, uploads: list[MachineFile]) -> FitAnswer:
    """Fit the friction law; tests that cannot be used are named, the others go on."""
    files = {f"{upload.id}: {upload.name}": upload for upload in uploads}
    plan = plan_from_document(_plan(asked, list(files.items())))

    def read(test: PlannedTest) -> MachineRecord:
        return read_machine_bytes(files[test.file].data, test.file, test.choices)

    if plan.digitised is not None:
        plan, curves = with_curves(plan, lambda test: files[test.file].data)
        read = lambda test: curves[test.file]  # noqa: E731 - as in fit_plan
    result = fit_plan(plan, read=read)
    return _fitted(plan, result.accepting(asked.accept_misfit) if asked.accept_misfit else result)


def _without_empty(table: Data) -> Data:
    return {key: value for key, value in table.items() if value not in (None, "")}


def _fitted(plan: TestPlan, result: PlanResult) -> FitAnswer:
    text = lagging_text(result.laggings) if result.may_be_written else None
    return FitAnswer(
        name=plan.name,
        lagging=None if text is None else _table_of(text),
        toml=text,
        sheet=Sheet(**sheet(plan_sheet(result, laws=True))),
        conditions=[_condition(result, condition) for condition in result.conditions],
        left_out=told(result.left_out),
        removes_shear=plan.removes_shear,
    )


def _table_of(text: str) -> Data:
    """The lagging as a drive document holds it: under its name, without a format."""
    table = parse(text)
    return {key: value for key, value in table.items() if key not in ("format", "name")}


def _condition(result: PlanResult, condition: ConditionResult) -> FittedCondition:
    found, transition = condition.found, condition.found.transition
    return FittedCondition(
        condition=condition.condition,
        findings=[
            Finding(
                title=finding.title,
                level=finding.level,
                value=worded(finding.value),
                text=worded(finding.text),
                tests=finding.tests,
            )
            for finding in condition_findings(result, condition)
        ],
        misfit=list(map(in_units, condition.misfit)),
        remarks=list(map(in_units, condition.remarks)),
        curves=[
            _curve(test, bool(flagged))
            for test, flagged in zip(condition.tests, found.flagged, strict=True)
        ],
        pressure_functions=_pressure_functions(condition),
        at_slips=[_at_slip(condition, k) for k in _SHOWN_SLIPS],
        transition=None
        if transition is None
        else Transition(
            pressure=finite(transition.pressure),
            given=transition.given,
            in_law=transition.in_law,
        ),
    )


def _curve(test: OneTest, flagged: bool) -> FittedCurve:
    fit, p = test.fit, test.fit.parameters
    step = max(1, len(fit.slip) // _CURVE)
    return FittedCurve(
        file=test.test.file,
        pressure=test.curve.pressure,
        slip=rounded(fit.slip[::step]),
        friction=rounded(fit.friction[::step]),
        fitted=rounded(fit.fitted[::step]),
        peak_friction=finite(p.peak_friction),
        peak_slip=finite(p.peak_slip),
        lash=finite(p.lash),
        noise=finite(fit.noise),
        flagged=flagged,
        misfit=[in_units(sentence.text) for sentence in test.judged.misfit],
    )


def _at_slip(condition: ConditionResult, number: int) -> FrictionAtSlip:
    """Friction over pressure at one of the standard slips, up to which tests reached."""
    slip = STANDARD_SLIPS[number]
    friction, expanded = law_at_slips(condition)
    known = [(test.curve.pressure, friction_at(test, slip)) for test in condition.tests]
    return FrictionAtSlip(
        slip=slip,
        pressure=rounded(condition.found.level_pressures()),
        friction=rounded(friction[:, number]),
        band=rounded(np.nan_to_num(expanded[:, number])),
        points=[(p, mu) for p, mu in known if np.isfinite(mu)],
    )


def _pressure_functions(condition: ConditionResult) -> PressureFunctions:
    points, fit = condition.found.points, condition.fit
    law: Any = {}
    if fit is not None:
        pressure = np.geomspace(*fit.ends, _PRESSURES)
        peaks = np.exp(fit.peaks(pressure))
        law = {
            "pressure": rounded(pressure),
            "peak_slip": rounded(peaks[:, 0]),
            "peak_friction": rounded(peaks[:, 1]),
        }
    return PressureFunctions(
        points=[
            PressurePoint(
                file=test.test.file,
                pressure=float(pressure),
                peak_slip=float(np.exp(value[0])),
                peak_friction=float(np.exp(value[1])),
            )
            for test, pressure, value in zip(
                condition.tests, points.pressure, points.value, strict=True
            )
        ],
        **law,
    )


def virtual_files() -> list[MachineFile]:
    """Return virtual tests of a catalogue lagging as machines write them, for trying."""
    from wraparc.files import load_lagging
    from wraparc.shear_test import DIALECTS, VirtualRig, run_virtual_test

    of = load_lagging("diamond-rubber", allow_paths=False)
    rig = VirtualRig(
        law=of.law, area=0.04, shear_compliance=of.shear_compliance, lash=0.5e-3, points=400,
        noise=0.01, wander=0.003, scatter_friction=0.02, scatter_slip=0.03,
    )  # fmt: skip
    dialects = [dialect for name, dialect in DIALECTS.items() if name != "excel"]
    files = []
    for number, kpa in enumerate((34, 69, 138, 207, 414, 690)):
        dialect = dialects[number % len(dialects)]
        test = run_virtual_test(replace(rig), 1e3 * kpa, 100 + number)
        choices = FileChoices(units=dict(dialect.units) or None)
        said = TestFileRequest(pressure=f"{kpa} kPa", choices=choices, illustrative=True)
        files.append(
            MachineFile("", f"virtual-{kpa}kPa{dialect.suffix}", dialect.write(test), said)
        )
    return files
