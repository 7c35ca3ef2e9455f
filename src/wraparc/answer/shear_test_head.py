"""What a test report states beside its numbers: title box, circumstances, digests, signatures."""

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from wraparc.answer.inputs import in_slip
from wraparc.answer.shear_test_numbers import rig_compliance
from wraparc.answer.sheet import NONE, Row, Table
from wraparc.shear_test.analysis import PlanResult
from wraparc.shear_test.campaign import order_of
from wraparc.shear_test.plan import PlannedTest, TestPlan
from wraparc.shear_test.speeds import per_minute
from wraparc.units import GIVEN_DIGITS, Dimension, count, distinct, percent, quantity

NOT_STATED = "not stated"
#: Who signs a test report.
SIGNERS = ("Tested by", "Checked by")
_ROW = ("Name", "Date", "Signature")


def title_box(result: PlanResult) -> tuple[tuple[str, str], ...]:
    """What stands in the box below the title, name and value."""
    head = result.plan.head
    return (
        ("Laboratory", head.laboratory or NOT_STATED),
        ("Report number", head.number or NOT_STATED),
        ("Customer", head.customer or NOT_STATED),
        ("Evaluated", result.date),
    )


def signatures(result: PlanResult) -> tuple[tuple[str, str, str], ...]:
    """Who signs: role, name as far as it is known, date left to be written."""
    head = result.plan.head
    names = (head.tested_by or result.plan.rig.operator, head.checked_by)
    return tuple((role, name, "") for role, name in zip(SIGNERS, names, strict=True))


def signature_table(result: PlanResult) -> Table:
    """The block to sign, for a page that is printed."""
    line = "_" * 24
    rows = (Row(role, (name or line, line, line)) for role, name, _ in signatures(result))
    return Table("Signatures", tuple(rows), _ROW)


def circumstances_table(result: PlanResult) -> Table:
    """Specimen, rig and conditions; what a report on friction must say is there even if unstated.

    ISO 8295 and ASTM D1894 ask for what is marked as not stated: specimen and counterface,
    conditioning, temperature, humidity, speed, area, apparatus, operator and date.
    """
    plan = result.plan
    rows = [Row(title, (value or NOT_STATED,)) for title, value in _asked_for(result)]
    known = {
        "Shear modulus G": plan.shear_modulus
        and quantity(plan.shear_modulus, "pressure", GIVEN_DIGITS),
        "Elastic modulus E": plan.elastic_modulus
        and quantity(plan.elastic_modulus, "pressure", GIVEN_DIGITS),
        "Compression modulus E_c": plan.compression_modulus
        and quantity(plan.compression_modulus, "pressure", GIVEN_DIGITS),
        "Roughness": plan.roughness and quantity(plan.roughness, "length", GIVEN_DIGITS),
    }
    rows += [Row(title, (value,)) for title, value in known.items() if value]
    return Table("Specimen, rig and conditions", tuple(rows), name="rig")


def _asked_for(result: PlanResult) -> Iterable[tuple[str, str]]:
    plan, rig = result.plan, result.plan.rig
    if plan.digitised is not None:
        return (
            ("Specimen", plan.title or plan.name),
            ("Curves", plan.provenance.source),
            ("Error of a point", plan.provenance.note),
        )
    tests = [test.test for condition in result.conditions for test in condition.tests]
    thickness = plan.thickness
    per_force = rig_compliance(rig.compliance) if rig.compliance else ""
    return (
        ("Specimen", plan.title or plan.name),
        ("Lot", _texts(tests, lambda t: t.lot)),
        ("Belt cover it slides on", _texts(tests, lambda t: t.belt_cover)),
        ("Conditioning", _texts(tests, lambda t: t.conditioning)),
        ("Date of the tests", _dates(tests)),
        ("Order of the tests", _order(tests)),
        ("Operator", _texts(tests, lambda t: t.operator or rig.operator)),
        ("Temperature", _span([t.temperature for t in tests], "temperature")),
        ("Humidity", _ends([t.humidity for t in tests], percent)),
        ("Test speed", _speeds([t.speed for t in tests])),
        ("Area of a face", quantity(rig.area, "area", GIVEN_DIGITS)),
        ("Faces that slide", count(rig.faces)),
        (
            "Thickness that shears",
            "" if thickness is None else quantity(thickness, "length", GIVEN_DIGITS),
        ),
        ("Slip includes", _slip_includes(plan)),
        ("Rig", rig.name),
        ("Testing machine", rig.machine),
        ("Compliance of the rig", per_force),
        ("Load cell, force", rig.force_cell.device),
        ("Calibration, force", rig.force_cell.calibration),
        *_normal_force(result),
    )


def _slip_includes(plan: TestPlan) -> str:
    """What the slip of the law holds besides the sliding: a drive must not count it twice."""
    rig = () if plan.rig.compliance else ("the rig's own travel",)
    return in_slip((*(plan.slip_includes or ()), *rig))


def _normal_force(result: PlanResult) -> list[tuple[str, str]]:
    """How the normal force is known, and what measures it."""
    records = [test.record for c in result.conditions for test in c.tests]
    measured, cell = (
        sum(r.normal_force is not None for r in records),
        result.plan.rig.normal_force_cell,
    )
    if measured in (0, len(records)):
        how = "measured" if measured else "as set, not measured"
    else:
        how = f"measured in {measured} of {len(records)} tests, else as set"
    if not measured and not cell.device:
        return [("Normal force", how)]
    return [
        ("Normal force", how),
        ("Load cell, normal force", cell.device),
        ("Calibration, normal force", cell.calibration),
    ]


def _stated(values: Iterable[object], text: str) -> str:
    """A text, and for how many tests it is not stated."""
    values = list(values)
    missing = sum(value in (None, "") for value in values)
    if not text or not missing:
        return text
    return f"{text} ({missing} of {len(values)} tests: {NOT_STATED})"


def _texts(tests: Iterable[PlannedTest], of: Callable[[PlannedTest], str]) -> str:
    values = [of(test) for test in tests]
    different = list(dict.fromkeys(value for value in values if value))
    return _stated(values, "; ".join(different[:4]) + ("; ..." if len(different) > 4 else ""))


def _dates(tests: Iterable[PlannedTest]) -> str:
    values = [test.date for test in tests]
    dates = sorted({value for value in values if value})
    return _stated(values, " to ".join(dict.fromkeys([*dates[:1], *dates[-1:]])))


def _order(tests: Sequence[PlannedTest]) -> str:
    """The first tests as they followed each other, and the last."""
    order = order_of(tests)
    if order is None:
        return ""
    following = [tests[k] for k in np.argsort(order, kind="stable")]
    named = [test.file for test in following[:3]]
    return ", ".join(named) + (f", ... {following[-1].file}" if len(following) > 3 else "")


def _ends(values: list[float | None], shown: Callable[[float], str]) -> str:
    known = [value for value in values if value is not None]
    if not known:
        return ""
    ends = distinct(shown(value) for value in (min(known), max(known)))
    return _stated(values, " to ".join(ends))


def _span(values: list[float | None], dimension: Dimension) -> str:
    return _ends(values, lambda value: quantity(value, dimension, GIVEN_DIGITS))


def _speeds(values: list[float | None]) -> str:
    return _ends(values, per_minute)


def digests_table(result: PlanResult) -> Table:
    """SHA-256 of every machine file, by which it can be proved to be the one that was fitted."""
    files = {t.test.file: t.record.digest for c in result.conditions for t in c.tests}
    rows = tuple(Row(f"{digest or NONE}  {file}", ()) for file, digest in files.items())
    return Table("Digests (SHA-256) of the machine files", rows, heads=())
