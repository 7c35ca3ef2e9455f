"""Shear test plans: TOML to the plan as data."""

import os
from dataclasses import replace
from typing import Any

from wraparc.errors import InputError
from wraparc.provenance import Kind, Provenance
from wraparc.schema.origins import own_provenance
from wraparc.schema.overrides import load
from wraparc.schema.problems import Report
from wraparc.schema.source import Document, parse, read_tables
from wraparc.schema.tables import Record
from wraparc.shear_test import Choices, PressureOptions, TestPlan
from wraparc.shear_test.budget import Uncertainty
from wraparc.shear_test.circumstances import LoadCell, ReportHead
from wraparc.shear_test.curve_held import FREE
from wraparc.shear_test.plan import Digitised
from wraparc.shear_test.plan_keys import (
    DIGITISED,
    FIT_OPTIONS,
    FIXED,
    LOAD_CELL,
    PLAN,
    REPORT,
    RIG,
    TEST,
    UNCERTAINTY,
)
from wraparc.units import Dimension, parse_quantity, unit_factor

_CHOICES = (
    "travel", "force", "time", "decimal", "delimiter", "encoding", "sheet", "table", "block",
    "stress_area",
)  # fmt: skip


# A figure has no rig: what was pressed and pulled is a friction already.
_NO_RIG = {"sample_area": "1 m2", "faces": 1}
_SHEAR_OF_FIGURE = (
    "Write true if the slip of the figure includes the shear of the sample, else false."
)
_FIGURE_UNITS: dict[str, Dimension] = {"slip_unit": "length", "pressure_unit": "pressure"}


def load_plan(path: str | os.PathLike[str]) -> TestPlan:
    """Return the test plan of a file; the files it names are relative to it.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(path, plan_from_document, file_kind="plan")


def plan_from_text(text: str, *, file: str = "") -> TestPlan:
    """Return the test plan of a text."""
    return plan_from_document(parse(text, file), file=file)


def plan_from_document(document: Document, *, file: str = "", folder: str = "") -> TestPlan:
    """Return the test plan of a document that is already parsed."""
    if "digitised" in document and "rig" not in document:
        document = {**document, "rig": _NO_RIG}
    record, report = read_tables(PLAN, document, file)
    rig = _rig(record.get("rig"), report)
    provenance = own_provenance(record, report)
    common, circumstances = record.get("columns", {}), record.get("all_tests", {})
    head = REPORT.built(record.get("report"), report) or ReportHead()
    tests = [
        _test(_with(circumstances, item), position, common, report)
        for position, item in enumerate(record.get("test") or (), start=1)
        if isinstance(item, Record)
    ]
    _check_cover(record.get("test_belt"), report)
    uncertainty = _uncertainty(record.get("uncertainty"), report)
    digitised = _digitised(record.get("digitised"), report)
    fit = record.get("fit", {})
    moduli = {"shear_modulus", "elastic_modulus"} & record.get("lagging", {}).keys()
    known = bool(moduli) and "thickness" in record["lagging"]
    if "digitised" in record and known and "remove_shear" not in fit:
        report.add(("fit", "remove_shear"), "missing", _SHEAR_OF_FIGURE)
    report.raise_all()
    return TestPlan(
        rig=rig,
        tests=tuple(tests),
        options=FIT_OPTIONS.built(fit, report) or PressureOptions(),
        remove_shear=fit.get("remove_shear"),
        **record.get("test_belt", {}),
        held=FIXED.built(fit.get("fixed"), report) or FREE,
        provenance=digitised.provenance(provenance)
        if digitised
        else _sourced(provenance or Provenance(Kind.MEASURED), head),
        digitised=digitised,
        head=head,
        uncertainty=uncertainty,
        file=file,
        folder=folder,
        **record["lagging"],
    )


def _check_cover(record: Any, report: Report) -> None:
    """Report a cover that shears by nobody knows how much."""
    if not isinstance(record, Record) or not record.sound():
        return
    if record.get("cover_thickness") and "cover_shear_modulus" not in record:
        report.add(
            (*record.place, "cover_shear_modulus"),
            "missing: the cover shears",
            "Give it (mostly 0.8 to 1.5 MPa), or leave [test_belt] out.",
        )


def _sourced(provenance: Provenance, head: ReportHead) -> Provenance:
    """Name the report as the source of what was measured, where the plan names none."""
    if provenance.source or provenance.kind is not Kind.MEASURED:
        return provenance
    return replace(provenance, source=head.source)


def _with(circumstances: dict[str, Any], record: Record) -> Record:
    """A test with what holds for all tests, where it says nothing else."""
    return Record({**circumstances, **record}, record.place, record.raw, record.faulty)


def _rig(record: Any, report: Report) -> Any:
    more: dict[str, Any] = {}
    for cell in ("force_cell", "normal_force_cell"):
        if isinstance(record, Record) and cell in record:
            more[cell] = LOAD_CELL.built(record[cell], report) or LoadCell()
    if isinstance(record, Record) and "compliance" in record:
        more["compliance"] = _compliance(record, report)
    return RIG.built(record, report, **more)


def _uncertainty(record: Any, report: Report) -> Uncertainty:
    """Errors as the plan says them, else those of a usual rig."""
    if not isinstance(record, Record):
        return Uncertainty()
    more = {"compliance": _compliance(record, report)} if "compliance" in record else {}
    return UNCERTAINTY.built(record, report, stated=True, **more) or Uncertainty()


def _digitised(record: Any, report: Report) -> Digitised | None:
    """The figure that curves were read off, its units as SI values."""
    if not isinstance(record, Record):
        return None
    more: dict[str, Any] = {}
    for key, dimension in _FIGURE_UNITS.items():
        if key in record:
            try:
                more[key] = unit_factor(record[key].strip(), dimension)
            except InputError as error:
                report.take(error, (*record.place, key))
    figure: Digitised | None = DIGITISED.built(record, report, **more)
    return figure


def _compliance(record: Record, report: Report) -> float:
    """Return a length over a force, ``0.02 mm/kN``, in metres per newton."""
    text = record["compliance"]
    place = (*record.place, "compliance")
    length, slash, force = text.partition("/")
    value = -1.0
    if slash:
        try:
            value = parse_quantity(length, "length") / unit_factor(force.strip(), "force")
        except InputError as error:
            report.take(error, place)
            return 0.0
    if value < 0.0:
        report.add(place, "must be a length over a force", 'Write "0.02 mm/kN".', text)
    return value


def _test(record: Record, position: int, common: Any, report: Report) -> Any:
    place = f"test[{position}]"
    if "pressure" in record and "normal_force" in record:
        report.add(
            (*record.place, "normal_force"),
            "contradicts pressure",
            "Remove one of them.",
            record.raw["normal_force"],
        )
    if record.get("use") is False and not record.get("reason", "").strip():
        report.add((*record.place, "reason"), "missing", "Write why the test is left out.")
    said = {**common, **record}
    choices = {key: said[key] for key in _CHOICES if key in said}
    if "normal_force_column" in said:
        choices["normal_force"] = said["normal_force_column"]
    units = {**common.get("units", {}), **record.get("units", {})}
    pull = {"stroke": said.get("stroke", "first"), "stick_slip": said.get("stick_slip", "")}
    own = Choices(units=units, in_plan=True, **choices)
    return TEST.built(record, report, place=place, choices=own, **pull)
