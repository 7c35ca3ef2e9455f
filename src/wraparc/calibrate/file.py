"""Calibrate files: a drive, what was measured on it, and what is to be found."""

import math
import os
from dataclasses import dataclass, replace
from typing import Any

from wraparc.arc import ArcResult, Distributed, Method, PaperMarch, WrapArc
from wraparc.calibrate.calibration import (
    PARAMETERS,
    QUANTITIES,
    Calibration,
    Number,
    Prior,
    Problemset,
    Trace,
)
from wraparc.calibrate.fold import Folded, fold
from wraparc.calibrate.problem import (
    ERRORS,
    OPEN_ZERO,
    PLANT_ERRORS,
    arc_of,
    offset_by,
    take_up_error,
    usual_method,
)
from wraparc.calibrate.record import ROLES, RecordChoices, read_record
from wraparc.drive import Drive, Lagging, Limit, Tensions, half_interval
from wraparc.drive.belt import MOST_THICKNESS
from wraparc.drive.pitch import USUAL_OFFSET, pitch_offset
from wraparc.errors import name_remedy
from wraparc.glossary import GLOSSARY
from wraparc.provenance import Kind, Provenance
from wraparc.schema.kinds import ByName, Choice, Name, Percent, Quantity, Rows, Text
from wraparc.schema.origins import own_provenance
from wraparc.schema.overrides import Overrides, load
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.shared_keys import FORMAT_ENTRY, PROVENANCE
from wraparc.schema.source import Document, read_tables
from wraparc.schema.tables import Entry, Record, Table, need
from wraparc.shear_test import DELIMITER_NAMES
from wraparc.shear_test.plan_keys import Column
from wraparc.train.drive_parts import case_of, drive_of, pulley_of
from wraparc.units import Dimension, parse_quantity

METHODS = {"distributed": Distributed, "paper": PaperMarch}
_SPEED_RATIO = ("drum_speed", "belt_speed")
_DIMENSIONS: dict[str, Dimension] = {
    "friction": "number",
    "peak_slip": "number",
    "shear_modulus": "pressure",
    "overrun": "length",
    "belt_modulus": "force_per_width",
}
#: Errors of what is a parameter, too: it is one or the other.
_SAME = {"lagging_shear": "shear_modulus", "modulus": "belt_modulus", "slip_axis": "peak_slip"}
_SPEED = Quantity("speed", Limit("speed", open=True))
_LENGTH = Quantity("length", Limit("length", open=True))
_SIGN = Choice(("+", "-"))

PRIOR = Table(
    "What is known beforehand",
    need("mean", "With its unit.", Text(60), example='mean = "1"'),
    need("sd", kind=Text(60), title="Standard deviation", example='sd = "0.1"'),
)
_PART = Percent(1.0)
_TENSION = Quantity("force", Limit("force", open=True))
_DRUM_SPEED = "Of its shaft, times the radius over the unloaded lagging."
ZERO = Table(
    "A record at little load, which zeroes the speed ratio",
    need(
        "drum_speed", _DRUM_SPEED, _SPEED, title="Pulley speed", example='drum_speed = "3.05 m/s"'
    ),
    need("belt_speed", "At the nip.", _SPEED, example='belt_speed = "3.1 m/s"'),
    need(
        "sd", "Of the speed ratio.", Text(60), title="Standard deviation", example='sd = "0.01 %"'
    ),
    Entry("nip", "Where the belt is measured; exit if left out.", Choice(("entry", "exit"))),
    Entry("load_case", "Of the drive file, if it has one of this load.", Name()),
    Entry("entry_tension", "Else the tensions of the record.", _TENSION),
    Entry("exit_tension", kind=_TENSION),
    Entry("provenance", kind=PROVENANCE),
)
ERRORS_TABLE = Table(
    "Standard deviations of what was measured with, common to all load cases",
    Entry("entry_tension", "Of the entry tensions, T1.", _PART),
    Entry("exit_tension", "Of the exit tensions, T2: a load cell at the take-up.", _PART),
    Entry("effective_tension", "Of the effective tensions: power of the motor.", _PART),
    Entry("compression", "Of the compression of the lagging, by its modulus E_c.", _PART),
    Entry("lagging_shear", "Of the shear of the lagging, by its modulus G and thickness.", _PART),
    Entry("cover_shear", "Of that of the belt cover, by its modulus and thickness.", _PART),
    Entry("torque_offset", "Of the maximum effective tension: torque at no load.", _PART),
    Entry("take_up", "Of T2, of each record anew: friction of the take-up.", _PART),
    Entry("modulus", "Of the modulus of the belt.", _PART),
    Entry("slip_axis", "Of the slip axis of the friction law.", _PART),
    Entry("speed_by_torque", "Of speeds, at the maximum effective tension.", _PART),
    Entry(
        "assumed",
        "plant: those that the record of a plant has, where they are left out.",
        Choice(("plant",)),
    ),
    Entry("belt_speed", "Of the belt speed: radius of the wheel.", _PART),
    Entry("diameter", "Of the diameter over the lagging.", _LENGTH),
    Entry("pitch_offset", "Of the offset e of the tension member: covers and carcass.", _LENGTH),
)
NUMBER = Table(
    "A measured number",
    need("quantity", kind=Choice(QUANTITIES)),
    Entry("value", "With its unit.", Text(60)),
    need("sd", kind=Text(60), title="Standard deviation", example='sd = "0.1 mm"'),
    Entry("drum_speed", _DRUM_SPEED, _SPEED, title="Pulley speed"),
    Entry("belt_speed", "At the nip that the quantity is of.", _SPEED),
    Entry("load_case", "The running one of maximum effective tension if left out.", Name()),
    Entry("provenance", kind=PROVENANCE),
)
RECORD = Table(
    "A record of an instrumented pulley",
    need("file", "Relative to this one.", Name(1000)),
    Entry("load_case", "The running one of maximum effective tension if left out.", Name()),
    Entry("columns", f"By role: {', '.join(ROLES)}.", ByName(Column())),
    Entry("units", "By role, where the file has none.", ByName(Text(40))),
    Entry("signs", "By role: what a driving pulley shows.", ByName(_SIGN)),
    Entry("delimiter", kind=Choice(tuple(DELIMITER_NAMES.values()))),
    Entry("provenance", kind=PROVENANCE),
)
CALIBRATE = Table(
    "Calibrate file",
    FORMAT_ENTRY,
    Entry("title", kind=Text()),
    Entry("description", kind=Text(5000, lines=True)),
    need("drive", "Drive file, relative to this one.", Name(1000)),
    Entry("pulley", "Which pulley, where the drive has several.", Name()),
    Entry("method", "distributed if left out.", Choice(tuple(METHODS))),
    Entry(
        "parameters",
        "What is to be identified; a shear modulus is that over the gross area of the lagging.",
        Rows(Choice(PARAMETERS), 0, 5),
    ),
    Entry("zero", "Belt idling, or nearly so.", ZERO, title="Zero record"),
    Entry("errors", "How wrong what was measured may be.", ERRORS_TABLE),
    Entry("prior", "By parameter.", ByName(PRIOR), title="Priors"),
    Entry("number", kind=Rows(NUMBER, 0, 100), title="Measured numbers"),
    Entry("record", kind=Rows(RECORD, 0, 50), title="Records"),
)


@dataclass(frozen=True, eq=False, kw_only=True)
class Measured:
    """What a calibrate file holds.

    Attributes
    ----------
    problem
        What is to be found from what.
    title, description
        Of the file.
    folded
        The records by load case.
    sources
        Where the measurements came from, in the order of the file, numbers first.
    """

    problem: Problemset
    title: str
    description: str
    folded: tuple[tuple[str, Folded], ...]
    sources: tuple[Provenance, ...]


def load_measured(path: str | os.PathLike[str], *, overrides: Overrides = ()) -> Measured:
    """Return what a calibrate file says; the files it names are relative to it.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(path, measured_from_document, overrides, file_kind="calibrate")


def measured_from_document(document: Document, *, file: str = "", folder: str = "") -> Measured:
    """Return what a calibrate file says that is already parsed."""
    record, report = read_tables(CALIBRATE, document, file)
    drive = drive_of(record, folder, report) if "drive" in record else None
    if drive is None:
        report.raise_all()
    assert drive is not None  # noqa: S101 - else it was reported
    pulley = pulley_of(record, drive, report)
    numbers = [_number(r, drive, pulley, report) for r in _tables(record, "number")]
    folded = [
        _folded(r, drive, pulley, folder, report) for r in _tables(record, "record") if r.sound()
    ]
    priors = _priors(record, report)
    zero = _zero(record.get("zero"), drive, pulley, report)
    assumed = _assumed(record)
    errors = _errors(record, drive, pulley, zero, assumed, report)
    report.raise_all()
    records = [f for f in folded if f is not None]
    sources = [
        own_provenance(r, report) or Provenance()
        for r in (
            *record.get("number", ()),
            *filter(None, [record.get("zero")]),
            *record.get("record", ()),
        )
    ]
    report.raise_all()
    problem = report.sure(
        lambda: Problemset(
            drive=drive,
            pulley=pulley,
            parameters=tuple(dict.fromkeys(record.get("parameters", ()))),
            numbers=tuple(n for n in (*numbers, zero) if n is not None),
            assumed=assumed,
            zero=zero,
            traces=tuple(t for case, f in records for t in traces_of(f, case)),
            priors=priors,
            method=_method(record.get("method", "distributed")),
        )
    )
    return Measured(
        problem=_of_each_record(errors, problem),
        title=record.get("title", ""),
        description=record.get("description", ""),
        folded=tuple(records),
        sources=tuple(sources),
    )


def _tables(record: Record, key: str) -> list[Record]:
    """Return the tables of a key that could be read, with what of them could be."""
    return [item for item in record.get(key, ()) if isinstance(item, Record)]


def _method(name: str) -> Method:
    return PaperMarch() if name == "paper" else usual_method()


def traces_of(folded: Folded, load_case: str) -> list[Trace]:
    """Return the courses of a folded record, as they are fitted: their noise found by the fit."""
    found = []
    for quantity, values in (("creep", folded.displacement), ("shear_angle", folded.shear_angle)):
        if values is not None:
            found.append(
                Trace(
                    quantity=quantity,
                    position=folded.position,
                    value=values,
                    sd=None,
                    load_case=load_case,
                )
            )
    return found


def _si(text: str, dimension: Dimension, place: Place, report: Report) -> float | None:
    return report.tried(lambda: parse_quantity(text, dimension), place, text)


def _number(record: Record, drive: Drive, pulley: str, report: Report) -> Number | None:
    quantity, case = record.get("quantity"), case_of(record, drive, report)
    if quantity is None:
        return None
    dimension = GLOSSARY[quantity].dimension
    sd = _deviation(record, dimension, report)
    value, apparent = None, False
    if "value" in record:
        value = _si(record["value"], dimension, (*record.place, "value"), report)
    elif all(key in record for key in _SPEED_RATIO) and quantity.endswith("creep_ratio"):
        value, apparent = _shown(record), True
    elif record.sound("value", *_SPEED_RATIO):
        report.add(record.place, "no value", "Write value, or drum_speed and belt_speed.")
    if value is None or sd is None:
        return None
    return Number(quantity=quantity, value=value, sd=sd, load_case=case, apparent=apparent)


def _deviation(record: Record, dimension: Dimension, report: Report) -> float | None:
    """Return the standard deviation of a measured number [SI], or None after reporting."""
    if "sd" not in record:
        return None
    sd = _si(record["sd"], dimension, (*record.place, "sd"), report)
    if sd is not None and not sd > 0.0:
        report.add((*record.place, "sd"), "must be more than 0", value=record["sd"])
        return None
    return sd


def _shown(record: Record) -> float:
    """What a tachometer pair shows, 1 - v/(omega R) [-]."""
    return float(1.0 - record["belt_speed"] / record["drum_speed"])


def _zero(record: Any, drive: Drive, pulley: str, report: Report) -> Number | None:
    """Return the record that zeroes the speed ratio, or None after reporting what is wrong."""
    if not isinstance(record, Record):
        return None
    sd, both = _deviation(record, "number", report), ("entry_tension", "exit_tension")
    given = [key for key in both if key in record]
    if given and "load_case" in record:
        report.add((*record.place, "load_case"), "contradicts the tensions", "Remove one.")
        return None
    if len(given) != 2 and "load_case" not in record and record.sound(*both, "load_case"):
        message = "needs the tensions of this record"
        remedy = "Write entry_tension and exit_tension, or load_case of the drive file."
        report.add(record.place, message, remedy)
        return None
    if sd is None or not record.sound():
        return None
    tensions = None
    if given:
        tensions = Tensions(entry=record["entry_tension"], exit=record["exit_tension"])
    return Number(
        quantity=f"{record.get('nip', 'exit')}_creep_ratio",
        value=_shown(record),
        sd=sd,
        load_case=case_of(record, drive, report),
        apparent=True,
        tensions=tensions,
    )


def _assumed(record: Record) -> tuple[str, ...]:
    """Return the errors of a plant's record that are assumed, as the file leaves them out."""
    stated, found = record.get("errors", {}), record.get("parameters", ())
    if "assumed" not in stated or not found:
        return ()
    # load cells on both sides need no torque, and see what the take-up does
    cells = {"entry_tension", "exit_tension"} <= set(stated)
    known = {*stated, *(("torque_offset", "take_up") if cells else ())}
    return tuple(k for k in PLANT_ERRORS if k not in known and _SAME.get(k) not in found)


def _of_each_record(errors: dict[str, float], problem: Problemset) -> Problemset:
    """Return the problem with the friction of the take-up as an error of each of its records."""
    if "take_up" not in errors:
        return replace(problem, errors=errors)
    sd = errors["take_up"]
    own = {take_up_error(state): sd for state in problem.used}
    return replace(problem, errors={k: v for k, v in errors.items() if k != "take_up"} | own)


def _check_errors(stated: dict[str, float], record: Record, report: Report) -> None:
    """Report errors that contradict each other or what is to be found."""
    if {"entry_tension", "exit_tension", "effective_tension"} <= set(stated):
        report.add(
            ("errors", "effective_tension"),
            "three errors of two independent tensions",
            "Leave one of the three out.",
        )
    for key, parameter in _SAME.items():
        if key in stated and parameter in record.get("parameters", ()):
            report.add(
                ("errors", key),
                f"contradicts {parameter} in parameters",
                "Give it a prior instead, or leave one out.",
            )
    for key, value in stated.items():
        if not value > 0.0:
            report.add(("errors", key), "must be more than 0", "Leave it out where it is exact.")


def _errors(
    record: Record,
    drive: Drive,
    pulley: str,
    zero: Number | None,
    assumed: tuple[str, ...],
    report: Report,
) -> dict[str, float]:
    """Return the standard deviations of the errors that are fitted along.

    Radius of the wheel, diameter and thickness of the belt all shift every speed ratio alike: no
    record tells them apart, and they are one zero.
    """
    stated = {k: v for k, v in record.get("errors", {}).items() if k != "assumed"}
    _check_errors(stated, record, report)
    stated |= {key: PLANT_ERRORS[key] for key in assumed}
    errors = {key: stated[key] for key in ERRORS if key in stated}
    on, speeds = drive.pulley(pulley), [r for r in _tables(record, "number") if "drum_speed" in r]
    e = pitch_offset(drive.belt, on.side)
    radius = 0.5 * on.diameter + (e or 0.0)
    lengths = stated.get("pitch_offset", 0.0), 0.5 * stated.get("diameter", 0.0)
    by_zero = math.hypot(stated.get("belt_speed", 0.0), *(length / radius for length in lengths))
    if zero is None and not (speeds and record.sound("zero", "errors")):
        return errors
    if not record.get("parameters"):  # nothing is found, only laid beside the prediction
        return errors
    if zero is None and e is None:
        report.add(
            ("belt", "thickness"),
            "missing: without it a speed ratio is uncertain by "
            f"{_percent_of(2.0 * USUAL_OFFSET, on.diameter)}",
            "Give a [zero] record, or covers and carcass.",
        )
    elif zero is None and not by_zero:
        report.add(
            ("errors",),
            f"missing: 0.1 mm of radius is {_percent_of(1e-4, radius)} of speed",
            "Give a [zero] record, or belt_speed, diameter and pitch_offset.",
        )
    known = by_zero and e is not None
    errors = {"speed_zero": by_zero if known else OPEN_ZERO, **errors}
    if zero is not None:
        _check_zero(
            record["zero"], zero, drive, pulley, errors["speed_zero"] if known else by_zero, report
        )
    return errors


def _percent_of(length: float, radius: float) -> str:
    """Return a length as a share of a radius, in words."""
    return f"{100.0 * length / radius:.2g} %"


def _check_zero(
    record: Record, zero: Number, drive: Drive, pulley: str, sd: float, report: Report
) -> None:
    """Report a zero record that no belt shows: its tension member below the lagging's surface."""
    arc = arc_of(drive, pulley, zero.state, {})
    # at little load the surface runs as fast as the belt at one of the nips, or between
    ratios = (0.0, (arc.exit_tension - arc.entry_tension) * arc.compliance)
    low, high = sorted(offset_by(arc, g, zero) for g in ratios)
    room = 3.0 * sd * arc.radius
    if high < -room or low > MOST_THICKNESS + room:
        report.add(
            ("zero", "belt_speed"),
            f"puts the tension member {1e3 * high:.3g} mm above the lagging, not 0 to "
            f"{1e3 * MOST_THICKNESS:g} mm",
            "Check speeds and diameter.",
            record.raw.get("belt_speed", NOTHING),
        )


def _folded(
    record: Record, drive: Drive, pulley: str, folder: str, report: Report
) -> tuple[str, Folded] | None:
    case = case_of(record, drive, report)
    for key in ("columns", "units", "signs"):
        for role in record.get(key, {}):
            if role not in ROLES:
                place = (*record.place, key, role)
                report.add(place, "no such role", name_remedy(role, ROLES))
    choices = RecordChoices(
        columns=record.get("columns", {}),
        units=record.get("units", {}),
        signs={role: 1 if sign == "+" else -1 for role, sign in record.get("signs", {}).items()},
        delimiter=record.get("delimiter"),
    )

    def folded() -> tuple[str, Folded]:
        read = read_record(os.path.join(folder, record["file"]), choices)
        return case, fold(read, drive, pulley, case, choices=choices)

    return report.tried(folded, record.place)


def _priors(record: Record, report: Report) -> dict[str, Prior]:
    priors = {}
    for name, table in record.get("prior", {}).items():
        place = ("prior", name)
        if name not in record.get("parameters", ()) and record.sound("parameters"):
            report.add(place, "is not among the parameters", "Add it to parameters.")
            continue
        if not isinstance(table, Record) or not table.sound() or name not in _DIMENSIONS:
            continue
        mean, sd = (
            _si(table[key], _DIMENSIONS[name], (*place, key), report) for key in ("mean", "sd")
        )
        if mean is None or sd is None:
            continue
        if not (sd > 0.0 and (mean > 0.0 or (name == "overrun" and mean == 0.0))):
            report.add(place, "mean and standard deviation must be more than 0")
            continue
        priors[name] = Prior(mean=mean, sd=sd)
    return priors


def overlays(measured: Measured) -> dict[str, tuple[ArcResult, ...]]:
    """Return the prediction of both methods for every load case something was measured in."""
    p = measured.problem
    used = {n.load_case for n in p.numbers} | {t.load_case for t in p.traces}
    return {
        case.name: tuple(
            m.solve(WrapArc.of(p.drive, p.drive.pulley(p.pulley), case))
            for m in (Distributed(), PaperMarch())
        )
        for case in p.drive.load_cases
        if case.name in used
    }


def calibrated_source(measured: Measured, title: str) -> Provenance:
    """Return the provenance of numbers that were calibrated to what a file holds."""
    given = [s for s in measured.sources if s.kind is not Kind.GIVEN]
    note = "; ".join(str(s) for s in dict.fromkeys(given))
    source = title or measured.title or "measured drive"
    return replace(Provenance(Kind.CALIBRATED, f"calibrated to: {source}"), note=note[:900])


#: Uncertainty of a lagging by the parameter that was found, and by the error that was stated.
_OF_PARAMETER = {"friction": "friction", "peak_slip": "slip", "shear_modulus": "shear_modulus"}
_OF_ERROR = {"slip_axis": "slip", "lagging_shear": "shear_modulus"}


def _uncertainties(found: Calibration, measured: Measured, before: Lagging) -> dict[str, float]:
    """Return how far numbers of a calibrated lagging may be off.

    By the 95 % intervals of what was found, else as it was stated of them, else by the errors.
    """
    errors = {k: v for k, v in measured.problem.errors.items() if k not in measured.problem.assumed}
    known = {_OF_ERROR[key]: half_interval(errors[key]) for key in _OF_ERROR if key in errors}
    known |= before.uncertainty
    for one in found.estimates:
        if one.name in _OF_PARAMETER and one.value and one.low and one.high:
            off = max(one.high / one.value - 1.0, 1.0 - one.low / one.value)
            known[_OF_PARAMETER[one.name]] = min(round(off, 4), 1.0)
    return known


def calibrated_lagging(found: Calibration, measured: Measured, name: str = "") -> Lagging:
    """Return the calibrated lagging; what was not calibrated keeps its source.

    Parameters
    ----------
    found
        The calibration.
    measured
        What it was calibrated to.
    name
        Of the lagging; that of the drive with ``-calibrated`` unless given.
    """
    lagging = found.drive.pulley(found.pulley).lagging
    before = measured.problem.drive.pulley(found.pulley).lagging
    parts = [part for part in before.LIMITS if part not in measured.problem.parameters]
    kept = {part: before.source_of(part) for part in parts if getattr(before, part) is not None}
    return replace(
        lagging,
        uncertainty=_uncertainties(found, measured, before),
        name=name or f"{before.name}-calibrated"[:60],
        title=f"{before.title or before.name}, calibrated",
        provenance=calibrated_source(measured, measured.title),
        sources=kept,
        fit=None,
    )
