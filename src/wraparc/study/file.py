"""Study files: TOML to a study."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from wraparc import catalogue
from wraparc.batch import BatchResult, Setting
from wraparc.batch.arcs import COLUMNS
from wraparc.checks import before
from wraparc.checks.of_data import weak_inputs
from wraparc.checks.of_wet import estimate_factor
from wraparc.checks.rule import At
from wraparc.checks.verdict import data_line
from wraparc.drive import DESIGN, Drive, Lagging
from wraparc.drive.criteria import is_wet
from wraparc.errors import InputError, name_remedy
from wraparc.files.drive_file import overridden
from wraparc.files.drive_keys import DRIVE, TENSIONS
from wraparc.files.lagging_file import is_path, load_lagging
from wraparc.glossary import RENAMED
from wraparc.provenance import Provenance
from wraparc.schema.origins import own_provenance
from wraparc.schema.overrides import Overrides, load, read_document
from wraparc.schema.problems import Place, Report, place_text
from wraparc.schema.source import Document, check_format, parse, read_text, read_whole
from wraparc.schema.tables import Record
from wraparc.study.across_rows import ACROSS_OUTPUTS
from wraparc.study.fields import DRUM_KEYS, SCALING, label_of
from wraparc.study.file_axes import Axis, field_of, read_axis, read_condition
from wraparc.study.fitted import DrawnFit
from wraparc.study.keys import STUDY
from wraparc.study.parameter_study import (
    LOADS,
    OUTPUTS,
    TRAIN_OUTPUTS,
    Condition,
    Rows,
    Study,
)
from wraparc.study.plan import Drawn, DrawnField, Levels, Plan, Saltelli, Sweep
from wraparc.study.sampling import SAMPLINGS
from wraparc.study.source import DriveSource, Field
from wraparc.study.train_columns import refused
from wraparc.train.drive_parts import check_cases, pulley_of
from wraparc.train.file import any_drive_from_document

#: Results whose sensitivity is shown where the file names none.
SENSITIVE = ("creep_limit_margin", "exit_creep")
#: How near tensions come where the load of a train divides row by row.
_DIVIDED = 1e-4
#: Keys of a pulley that its own load case has.
_PULLS = {entry.key for entry in TENSIONS}
_NO_OUTPUTS = ("status", "identity_error")


@dataclass(frozen=True, eq=False, kw_only=True)
class StudyFile:
    """A study as its file asks for it.

    Attributes
    ----------
    study
        What is solved.
    drive, pulley
        The base drive, and the pulley that is varied.
    sensitivity
        Results whose sensitivity is wanted; none if that was not asked.
    inputs
        Files that were read.
    remarks
        Sentences a reader must not miss.
    sources
        Where friction, conditions and distributions came from.
    """

    study: Study
    drive: Drive
    pulley: str
    sensitivity: tuple[str, ...]
    inputs: tuple[str, ...]
    remarks: tuple[str, ...]
    sources: tuple[str, ...]


def load_study(path: str | os.PathLike[str], *, overrides: Overrides = ()) -> StudyFile:
    """Return the study of a study file; the files it names are relative to it.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(path, study_from_document, overrides, file_kind="study")


def study_from_document(document: Document, *, file: str = "", folder: str = "") -> StudyFile:
    """Return the study of a study file that is already parsed."""
    record, report = read_whole(STUDY, document, file)
    drive_path = os.path.join(folder, record["drive"])
    base, drive = _drive(drive_path, record, report)
    report.raise_all()
    assert drive is not None  # noqa: S101 - else it was reported
    pulley = pulley_of(record, drive, report)
    loads = _load_cases(record, drive, report)
    read = [read_axis(r, base, drive, report) for r in record["axis"] if isinstance(r, Record)]
    axes = [pair for pair in read if pair is not None]
    _each_once(axes, report)
    conditions = [read_condition(r, report) for r in record.get("condition", ())]
    known = tuple(c for c in conditions if c is not None)
    if len(known) == len(conditions):
        _shares(known, report)
    if drive.criteria.covered and any(is_wet(c.name) for c in known):
        message = "contradicts covered = true"
        report.add(("condition",), message, "Leave out covered or the condition.")
    outputs = _outputs(record, OUTPUTS, report)
    sensitivity = _sensitivity(record, report)
    report.raise_all()
    plan = _plan(record, [axis for axis, _ in axes], known, sensitivity, report)
    report.raise_all()
    setting = Setting(record.get("setting", Setting.ENGINEERING.value))
    source = _source(base, pulley, loads, axes, setting, report)
    report.raise_all()
    laggings = _laggings(drive.pulley(pulley).lagging, axes)
    study = Study(
        title=record.get("title", "") or drive.title,
        plan=plan,
        source=source,
        load_cases=loads,
        conditions=known,
        setting=setting,
        outputs=tuple(dict.fromkeys((*outputs, *sensitivity))),
        description={"study": _plain(document), "drive": _plain(base)},
        ground=_ground(drive, pulley, loads, known),
        data_line=_data_line(drive, laggings),
    )
    return StudyFile(
        study=study,
        drive=drive,
        pulley=pulley,
        sensitivity=sensitivity,
        inputs=(file, drive_path),
        remarks=(*_remarks(axes, known), *_left_out(drive, loads), *source.remarks(drive)),
        sources=tuple(_sources(laggings, record, known)),
    )


def _plain(document: Document) -> Document:
    """Return what fixes the numbers: without words for readers."""
    return {k: v for k, v in document.items() if k not in ("title", "description", "outputs")}


def _drive(path: str, record: Record, report: Report) -> tuple[Document, Drive | None]:
    """Return the drive file with the study's settings over it, and its drive."""
    try:
        document = read_document(path, record.get("set", ()), DRIVE, "drive")
        whole = self_contained(document, os.path.dirname(path))
        return whole, any_drive_from_document(whole, file=path, allow_paths=True)
    except InputError as error:
        report.take(error, ("drive",))
        return {}, None


def self_contained(document: Document, folder: str) -> Document:
    """Return a drive file whose lagging files are tables of its own, or named by full paths.

    What a study takes to other computers must not hang on files of this one.
    """
    own: dict[str, Any] = dict(document.get("lagging") or {})
    pulleys = []
    for pulley in document.get("pulley") or []:
        lagging = pulley.get("lagging") if isinstance(pulley, dict) else None
        if isinstance(lagging, str) and is_path(lagging) and lagging not in own:
            name = _free_name(lagging, own)
            table = parse(read_text(os.path.join(folder, lagging)), lagging)
            check_format(table, lagging)
            own[name] = {key: value for key, value in table.items() if key != "format"}
            pulley = {**pulley, "lagging": name}  # noqa: PLW2901 - the document is not changed
        pulleys.append(pulley)
    for name, table in own.items():
        preset = table.get("preset") if isinstance(table, dict) else None
        if isinstance(preset, str) and is_path(preset):
            own[name] = {**table, "preset": os.path.abspath(os.path.join(folder, preset))}
    changed = {**document, "pulley": pulleys} if pulleys else dict(document)
    return changed | ({"lagging": own} if own else {})


def _free_name(path: str, taken: Mapping[str, Any]) -> str:
    stem = os.path.splitext(os.path.basename(path))[0][:50] or "lagging"
    numbered = (stem if n == 1 else f"{stem} {n}" for n in range(1, 1000))
    return next(name for name in numbered if name not in taken)


def _load_cases(record: Record, drive: Drive, report: Report) -> tuple[str, ...]:
    there = [case.name for case in drive.load_cases]
    if "load_cases" not in record:
        fields = [str(r.get("field", "")) for r in record["axis"] if isinstance(r, Record)]
        pulls = any(f.startswith("pulley.") and f.rpartition(".")[2] in _PULLS for f in fields)
        own = [n for n in there if any(f.startswith(f"load_case.{n}.") for f in fields)]
        own += [DESIGN] if pulls and DESIGN in there else []
        return (own[0] if own else drive.load_case().name,)
    given = record["load_cases"]
    if given is None:
        return tuple(there)
    places = ((name, ("load_cases", number)) for number, name in enumerate(given, start=1))
    check_cases(places, drive, report)
    return tuple(dict.fromkeys(given))


def _each_once(axes: Sequence[tuple[Axis, Place]], report: Report) -> None:
    places = [place for _, place in axes]
    for axis, place in axes:
        if places.count(place) > 1 and not any(isinstance(a, DrawnFit) for a, _ in axes):
            report.add(("axis",), "two axes vary the same field", "Remove one.", axis.field)
            return
    fits = [place for axis, place in axes if isinstance(axis, DrawnFit)]
    if len(fits) > 1:
        report.add(("axis",), "only one lagging can be drawn from its fit", "Remove one.")
    for axis, place in axes:
        if place in fits and not isinstance(axis, DrawnFit):
            message = "the lagging is drawn from its fit already"
            report.add(("axis",), message, "Remove one of them.", axis.field)


def _left_out(drive: Drive, loads: Sequence[str]) -> Iterator[str]:
    """Say which load cases of the drive are not solved."""
    left = [case.name for case in drive.load_cases if case.name not in loads]
    if left:
        yield f"Not in this study: load case {', '.join(left)}."


def _ground(
    drive: Drive, pulley: str, loads: Sequence[str], conditions: Sequence[Condition]
) -> str:
    """Return what limits an OK: some load cases, unknown wet friction, tensions no take-up has."""
    of = drive.pulley(pulley)
    spots = (At(drive=drive, case=drive.load_case(name), pulley=of) for name in loads)
    dry = not conditions and any(math.isnan(estimate_factor(at)) for at in spots)
    some = f"load case {', '.join(loads)} only" if [*_left_out(drive, loads)] else ""
    against = any(c.name == "take_up" for c in before(drive).checks)
    take_up = "with tensions that its take-up does not fix" if against else ""
    stated = "reserve not checked" if drive.states_uncertainty else ""
    parts = ("wet not checked" if dry else "", stated, some, take_up)
    return ", ".join(part for part in parts if part)


def _shares(conditions: Sequence[Condition], report: Report) -> None:
    names = [c.name for c in conditions]
    if len(set(names)) < len(names):
        report.add(("condition",), "two conditions have the same name", "Give each its own.")
    shares = [c.share for c in conditions if c.share is not None]
    if shares and len(shares) < len(conditions):
        report.add(("condition",), "some have a share and some have none", "Give all one, or none.")
    elif shares and abs(sum(shares) - 1.0) > 1e-6:
        message = f"the shares of the time add up to {sum(shares):.6g}, not to 1"
        report.add(("condition",), message)


def _outputs(
    record: Mapping[str, Any], default: tuple[str, ...], report: Report
) -> tuple[str, ...]:
    names = tuple(dict.fromkeys(record.get("outputs", default)))
    known = output_names()
    for name in names:
        if name not in known:
            remedy = RENAMED.get(name) or name_remedy(name, known)
            report.add(("outputs",), "no such result", remedy, name)
    return names


def output_names() -> tuple[str, ...]:
    """Return the results that a study can keep."""
    nothing: Any = None
    even = (name for name in BatchResult(nothing, nothing) if name not in _NO_OUTPUTS)
    return (*even, *LOADS, *ACROSS_OUTPUTS, *TRAIN_OUTPUTS)


def _sensitivity(record: Record, report: Report) -> tuple[str, ...]:
    table = record.get("sensitivity")
    if not isinstance(table, Record):
        return ()
    return _outputs(table, SENSITIVE, report)


def _plan(
    record: Record,
    axes: Sequence[Axis],
    conditions: Sequence[Condition],
    sensitivity: tuple[str, ...],
    report: Report,
) -> Plan:
    levels = tuple(axis for axis in axes if isinstance(axis, Levels))
    drawn: tuple[Drawn, ...] = tuple(a for a in axes if not isinstance(a, Levels))
    drawn += tuple(d for condition in conditions for d in condition.drawn())
    table = record.get("sampling")
    if drawn and table is None:
        message = "missing, and something is drawn at random"
        report.add(("sampling",), message, "Write [sampling] with samples and seed.")
    if table is not None and not drawn:
        message = "nothing is drawn at random"
        report.add(("sampling",), message, "Give an axis a distribution, or remove [sampling].")
    if sensitivity and (levels or not drawn):
        message = "needs every axis to have a distribution"
        report.add(("sensitivity",), message, "Give each axis its plausible range: uniform.")
    if report.problems or table is None:
        return Sweep(levels=levels)
    method = table.get("method", "sobol" if sensitivity else "random")
    made: type[Saltelli] | type[Sweep] = Saltelli if sensitivity else Sweep
    return made(
        levels=levels,
        drawn=drawn,
        sampling=SAMPLINGS[method],
        samples=table["samples"],
        seed=table["seed"],
    )


def _source(
    document: Document,
    pulley: str,
    loads: tuple[str, ...],
    axes: Sequence[tuple[Axis, Place]],
    setting: Setting,
    report: Report,
) -> DriveSource:
    """Return the source, every field tried against the drive file itself."""
    pairs = [(a, f) for a, place in axes if (f := field_of(a, place)) is not None]
    fields = [field for _, field in pairs]
    fits = [axis for axis, _ in axes if isinstance(axis, DrawnFit)]
    source = DriveSource(document, pulley, fields, fits, setting=setting)
    if refused(source, loads, report):
        return source
    slow = {
        field.name
        for axis, field in pairs
        if not isinstance(axis, DrawnFit)
        and field.place[-1] not in (*SCALING, *DRUM_KEYS)
        and _differs(source, field, _trials(axis), loads, report)
    }
    if not slow:
        return source
    source = DriveSource(document, pulley, fields, fits, frozenset(slow), setting)
    refused(source, loads, report)
    return source


def _differs(
    source: DriveSource, field: Field, trials: list[float], loads: tuple[str, ...], report: Report
) -> bool:
    """Whether a field does more to an arc than its column says; report one that does nothing."""
    place = ("axis", field.name)
    within = _DIVIDED if source.divides else 1e-12
    differs = changes = False
    for value in trials:
        given = {place_text(field.place): field.given(value)}
        try:
            told = DriveSource(overridden(source.document, given), source.pulley, ())
        except InputError as error:
            report.take(_without_keys(error), place, field.given(value))
            return False
        for case in loads:
            other = told.rows({}, 1, case)
            one = source.rows({field.name: np.array([value])}, 1, case)
            differs |= not _same(one, other, within)
            changes |= not _same(source.rows({}, 1, case), other, within)
    if not changes and len(trials) > 1:
        message = f"changes nothing on pulley {source.pulley}"
        report.add(place, message, "Remove it, or name another pulley.")
    return differs


def _without_keys(error: InputError) -> InputError:
    """Return the error of the drive file as one of the axis that made it."""
    return InputError(replace(problem, file="", key="", value="") for problem in error.problems)


def _trials(axis: Levels | DrawnField) -> list[float]:
    """Values to try an axis with: all words, the ends of numbers."""
    if isinstance(axis, DrawnField):
        return [float(v) for v in axis.distribution.quantile(np.array([0.02, 0.5, 0.98]))]
    if not axis.numeric:
        return [float(k) for k in range(len(axis.values))]
    numbers = [float(v) for v in axis.values]
    return sorted({min(numbers), max(numbers)})


def _same(one: Rows, other: Rows, within: float) -> bool:
    """Whether two single arcs are the same, with their laws and what they are held against."""
    numbers = [
        [getattr(rows.arcs, name)[0] for name in COLUMNS]
        + [column[0] for column in rows.held.columns()]
        for rows in (one, other)
    ]
    a, b = np.array(numbers, dtype=float)
    close = np.allclose(a, b, rtol=within, atol=0.0, equal_nan=True)
    laws = [rows.arcs.laws.compact(int(rows.arcs.law[0])) for rows in (one, other)]
    if _uneven(one) != _uneven(other):
        return False
    return bool(close) and all(np.array_equal(p, q) for p, q in zip(*laws, strict=True))


def _uneven(rows: Rows) -> object:
    """What a single arc is solved across its width by; nothing of a pulley that is even."""
    drive = rows.drives[int(rows.which[0])]
    across = drive.pulley(rows.pulley).across
    return across and (across, drive.belt.in_plane_shear_stiffness)


def _remarks(axes: Sequence[tuple[Axis, Place]], conditions: Sequence[Condition]) -> list[str]:
    told = [(a.field, a.distribution) for a, _ in axes if isinstance(a, DrawnField)]
    told += [(d.field, d.distribution) for c in conditions for d in c.drawn()]
    return [
        f"{label_of(name).capitalize()}: {100.0 * (1.0 - d.kept):.2g} % of the distribution is "
        "outside its limits and is left out."
        for name, d in told
        if d.kept < 1.0 - 1e-6
    ]


def _laggings(own: Lagging, axes: Sequence[tuple[Axis, Place]]) -> tuple[Lagging, ...]:
    """Return the lagging of the drive file and those of the catalogue that an axis has."""
    laggings = {own.name: own}
    for axis, place in axes:
        if isinstance(axis, Levels) and not axis.numeric and place[-1] == "lagging":
            found = (_of_catalogue(str(name)) for name in axis.values)
            laggings |= {one.name: one for one in found if one is not None}
    return tuple(laggings.values())


def _data_line(drive: Drive, laggings: Iterable[Lagging]) -> str:
    """Return the line on the data of all designs: of the drive file and of every lagging."""
    weak = [item for check in before(drive).checks for item in check.weak]
    weak += [item for lagging in laggings for item in weak_inputs(lagging)]
    return data_line(tuple(weak)).text


def _sources(
    laggings: Iterable[Lagging], record: Record, conditions: Sequence[Condition]
) -> Iterator[str]:
    for one in laggings:
        yield f"{one.name}, friction: {one.source_of('law')}"
    quiet = Report()
    for table in record["axis"]:
        origin = own_provenance(table, quiet)
        if origin is not None:
            yield f"{label_of(table['field'])}: {origin}"
    for condition in conditions:
        if condition.provenance != Provenance():
            yield f"{condition.name}: {condition.provenance}"


def _of_catalogue(name: str) -> Lagging | None:
    """Return a lagging of the catalogue, or None."""
    return load_lagging(name) if name in catalogue.lagging_names() else None
