"""Machine files read and fitted; runs in a process of its own for every file."""

import re

import numpy as np

from wraparc.errors import InputError
from wraparc.files.write import lagging_text
from wraparc.report.shear_test_record import record_sheet
from wraparc.report.shear_test_tables import plan_sheet
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
from wraparc.shear_test.plan_file import plan_from_document
from wraparc.web.answers.shown import Data, rounded, sheet_data, tables_data
from wraparc.web.errors import problems_data

_PREVIEW, _CURVE, _PRESSURES = 240, 200, 60
_PRESSURE = re.compile(r"(?<![\d.])0*(\d{1,5}(?:[.]\d{1,3})?)[ _]?(kPa|MPa|psi|bar)", re.IGNORECASE)
_UNITS = {"kpa": "kPa", "mpa": "MPa", "psi": "psi", "bar": "bar"}
_TEST_KEYS = ("pressure", "normal_force", "condition", "repeat", "sample")


def read_files(request: Data) -> Data:
    """Return what was understood of several files."""
    return {"files": [read_file(file) for file in request["files"]]}


def read_file(request: Data) -> Data:
    """Return what was understood of a file, or what has to be said about it."""
    name, said = request["name"], request["said"]
    found: Data = {
        "read": False,
        "problems": [],
        "tables": [],
        "columns": [],
        "notes": [],
        "preview": None,
        "pressure_guess": guessed_pressure(name),
        "place": "",
    }
    try:
        test = _one_test(name, said)
        record = read_machine_bytes(request["data"], name, test.choices)
    except InputError as error:
        return {**found, "problems": problems_data(error.problems)}
    sheet = record_sheet(record)
    return {
        **found,
        "read": True,
        "place": sheet.subtitle,
        "tables": tables_data(sheet.tables, sheet.tables, ("columns", "rows")),
        "columns": [{"name": c.name, "unit": c.unit, "role": c.role} for c in record.columns],
        "notes": list(sheet.remarks),
        "preview": _preview(record),
    }


def _one_test(name: str, said: Data) -> PlannedTest:
    document = {
        "format": 1,
        "lagging": {"name": "lagging"},
        "rig": {"sample_area": "1 m2"},
        "test": [_test_table(name, said)],
    }
    return plan_from_document(document).tests[0]


def _test_table(file: str, said: Data) -> Document:
    """Return the table of a test plan for what the user says of a file."""
    table: Document = {"file": file}
    table |= {key: said[key] for key in _TEST_KEYS if said.get(key)}
    choices = dict(said.get("choices") or {})
    if choices.get("normal_force") is not None:
        choices["normal_force_column"] = choices.pop("normal_force")
    table |= {key: value for key, value in choices.items() if value not in (None, "", {})}
    return table


def guessed_pressure(name: str) -> str | None:
    """Return the pressure that a file name tells, as ``207kPa-1.csv`` does, or None."""
    found = _PRESSURE.search(name)
    return f"{found[1]} {_UNITS[found[2].lower()]}" if found else None


def _preview(record: MachineRecord) -> Data:
    step = max(1, len(record.travel) // _PREVIEW)
    return {"travel": rounded(record.travel[::step]), "force": rounded(record.force[::step])}


def fit(request: Data) -> Data:
    """Fit the lagging to all files of a session."""
    files = {f"{upload['id']}: {upload['name']}": upload for upload in request["files"]}
    document = {
        "format": 1,
        "lagging": _without_empty(request["lagging"]),
        "rig": _without_empty(request["rig"]),
        "test": [_test_table(file, upload["said"]) for file, upload in files.items()],
    }
    options = _without_empty(request["fit"])
    document |= {"fit": options} if options else {}
    if request.get("illustrative"):
        note = "virtual tests of a known law, no real product"
        origin = {"kind": "illustrative", "source": "virtual rig", "note": note}
        document["provenance"] = origin
    plan = plan_from_document(document)

    def read(test: PlannedTest) -> MachineRecord:
        return read_machine_bytes(files[test.file]["data"], test.file, test.choices)

    result = fit_plan(plan, read=read)
    return {**_lagging(result), **_result_data(plan, result)}


def _without_empty(table: Data) -> Data:
    return {key: value for key, value in table.items() if value not in (None, "")}


def _lagging(result: PlanResult) -> Data:
    text = lagging_text(result.laggings)
    table = parse(text)
    table.pop("format")
    name = table.pop("name")
    return {"name": name, "lagging": table, "toml": text}


def _result_data(plan: TestPlan, result: PlanResult) -> Data:
    return {
        "sheet": sheet_data(lambda system: plan_sheet(result, system)),
        "conditions": [_condition(condition) for condition in result.conditions],
        "left_out": problems_data(result.left_out),
        "removes_shear": plan.removes_shear,
    }


def _condition(condition: ConditionResult) -> Data:
    found = condition.found
    return {
        "condition": condition.condition,
        "misfit": list(condition.misfit),
        "remarks": list(condition.remarks),
        "curves": [
            _curve(test, bool(flagged))
            for test, flagged in zip(condition.tests, found.flagged, strict=True)
        ],
        "pressure_functions": _pressure_functions(condition),
        "transition": None
        if found.transition is None
        else {
            "pressure": found.transition.pressure,
            "interval": [v if np.isfinite(v) else None for v in found.transition.interval],
            "given": found.transition.given,
            "in_law": found.transition.in_law,
        },
    }


def _curve(test: OneTest, flagged: bool) -> Data:
    fit, p = test.fit, test.fit.parameters
    step = max(1, len(fit.slip) // _CURVE)
    return {
        "file": test.test.file,
        "pressure": test.curve.pressure,
        "slip": rounded(fit.slip[::step]),
        "friction": rounded(fit.friction[::step]),
        "fitted": rounded(fit.fitted[::step]),
        "peak_friction": p.peak_friction,
        "peak_slip": p.peak_slip,
        "lash": p.lash,
        "noise": fit.noise,
        "flagged": flagged,
        "misfit": [sentence.text for sentence in test.judged.misfit],
    }


def _pressure_functions(condition: ConditionResult) -> Data:
    points = condition.found.points
    data: Data = {
        "points": [
            {
                "file": test.test.file,
                "pressure": float(pressure),
                "peak_slip": float(np.exp(value[0])),
                "peak_friction": float(np.exp(value[1])),
            }
            for test, pressure, value in zip(
                condition.tests, points.pressure, points.value, strict=True
            )
        ],
        "pressure": [],
        "peak_slip": [],
        "peak_friction": [],
    }
    fit = condition.fit
    if fit is not None:
        low, high = fit.ends
        pressure = np.geomspace(low, high, _PRESSURES)
        peaks = np.exp(fit.peaks(pressure))
        data |= {
            "pressure": rounded(pressure),
            "peak_slip": rounded(peaks[:, 0]),
            "peak_friction": rounded(peaks[:, 1]),
        }
    return data


def virtual_files(_: Data) -> Data:
    """Return virtual tests of a catalogue lagging as machines write them, for trying."""
    from base64 import b64encode
    from dataclasses import replace

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
        files.append(
            {
                "name": f"virtual-{kpa}kPa{dialect.suffix}",
                "data": b64encode(dialect.write(test)).decode("ascii"),
                "said": {
                    "pressure": f"{kpa} kPa",
                    "choices": {"units": dict(dialect.units)} if dialect.units else {},
                },
            }
        )
    return {"files": files}
