"""A result as plain data, for JSON: SI numbers under the names of the glossary."""

import json
import math
import re
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields
from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.answer.checks_table import check_data, verdict_document
from wraparc.answer.conditions_table import conditions_data
from wraparc.answer.conveyor_table import conveyor_data
from wraparc.answer.inputs import arc_inputs
from wraparc.answer.least_tension import least_data
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.wear_table import life_data
from wraparc.answer.words import action_of
from wraparc.arc import ArcResult, ClassicalDrive, DriveResult, WrapArc, classical_drives
from wraparc.checks import Level, judge
from wraparc.drive import Belt, Drive, Lagging
from wraparc.glossary import GLOSSARY
from wraparc.provenance import Provenance
from wraparc.units import DIMENSION_TEXT, in_units
from wraparc.version import __version__

if TYPE_CHECKING:
    from wraparc.train import TrainResult
    from wraparc.train.whole import Whole

#: Counts up when a name goes or changes its meaning, not when one is added.
DOCUMENT_FORMAT = 3

_PYTHON = ".".join(map(str, sys.version_info[:3]))

# An array of numbers as `json` indents it, to be put on one line.
_NUMBERS = re.compile(r"\[\s+(?:-?[0-9.eE+-]+|null)(?:,\s+(?:-?[0-9.eE+-]+|null))*\s+\]")

Data = dict[str, Any]


def result_document(
    results: Sequence[DriveResult],
    whole: "Whole | None" = None,
    *,
    file: str = "",
    reserve: bool = False,
    probability: bool = False,
) -> Data:
    """Return a solved drive as plain data.

    Numbers are SI (metres, newtons, pascals, radians, watts), under the names of the glossary;
    the unit of every name is listed under ``units``. What has no number is None, and so is what
    has no bound: its name is then listed under ``unbounded``.

    Parameters
    ----------
    results
        The drive solved by one method or by several.
    whole
        What the pulleys are of, where they are those of a train: it is judged.
    file
        Where the drive was read from.
    reserve
        Whether the verdict has the smallest change of each input that changes it.
    probability
        Whether the verdict has how probable its level is.
    """
    drive, whole = results[0].drive, whole or results[0]
    told = judge_uncertain(whole)
    judged = [whole, *results[1:]]
    arcs = [_arc_data(a, r, of) for r, of in zip(results, judged, strict=True) for a in r]
    conveyor = conveyor_data(drive) if isinstance(whole, DriveResult) else _train_conveyor(whole)
    uneven = _uneven(results[0])
    return {
        "format": DOCUMENT_FORMAT,
        "program": {"name": "wraparc", "version": __version__},
        "libraries": {"python": _PYTHON, "numpy": np.__version__},
        "drive": _drive_data(drive, file),
        **({"conveyor": conveyor} if conveyor else {}),
        **({"conditions": conditions_data(results[0], whole)} if drive.conditions else {}),
        "solved": results[0].solved,
        "within_creep_limit": results[0].within_creep_limit,
        "governing": _place(results[0].governing),
        "verdict": verdict_document(
            told, action_of(whole), whole if reserve else None, whole if probability else None
        ),
        "least_tension": least_data(whole),
        "remarks": list(told.remarks),
        "arcs": arcs,
        **({"across": uneven} if uneven else {}),
        "sources": sources_of(drive),
        "units": _units(arcs),
    }


def _train_conveyor(result: "TrainResult") -> Data | None:
    return conveyor_data(result.train, result)


def solved_document(
    results: Sequence[DriveResult],
    train: "TrainResult | None" = None,
    *,
    file: str = "",
    reserve: bool = False,
    probability: bool = False,
) -> Data:
    """Return what ``wraparc solve --json`` writes besides the answer of its sheet.

    Parameters
    ----------
    results
        The drive solved by one method or by several.
    train
        The train whose drives these are, if they are of one.
    file
        Where the drive was read from.
    reserve
        Whether the verdict has the smallest change of each input that changes it.
    probability
        Whether the verdict has how probable its level is.
    """
    wanted = {"reserve": reserve, "probability": probability}
    document = result_document(results, train, file=file, **wanted)
    if train is not None:
        from wraparc.answer.train_document import train_document

        document["train"] = train_document(train, **wanted)
    return document


def _uneven(result: DriveResult) -> list[Data]:
    """Return what is told of uneven pulleys; their solver is loaded where there is one."""
    if not any(pulley.across for pulley in result.drive.pulleys):
        return []
    from wraparc.across import across_of
    from wraparc.answer.across_tables import across_data

    return [across_data(found) for found in across_of(result)]


def json_text(document: Mapping[str, Any]) -> str:
    """Return a document as JSON that every reader takes: no NaN, no Infinity."""
    text = json.dumps(_plain(document), allow_nan=False, indent=1, ensure_ascii=False)
    return _NUMBERS.sub(lambda found: " ".join(found[0].split()), text) + "\n"


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, str):
        return in_units(value)
    if isinstance(value, float):
        return value + 0.0 if math.isfinite(value) else None  # no -0.0
    return value


def _place(result: ArcResult) -> Data:
    arc = result.arc
    return {"load_case": arc.load_case, "pulley": arc.pulley, "method": result.method}


def _arc_data(result: ArcResult, of: DriveResult, whole: "Whole") -> Data:
    drive = of.drive
    judged = judge(whole).at(result.arc.pulley, result.arc.load_case)
    scalars = result.scalars()
    case = drive.load_case(result.arc.load_case)
    lagging = drive.pulley(result.arc.pulley).lagging_in(case.condition)
    return {
        **_place(result),
        "status": result.status.name.lower(),
        "status_text": str(result.status),
        "within_creep_limit": result.within_creep_limit,
        "level": judged.level.value,
        "checks": [check_data(c) for c in judged.listed if c.level is not Level.NOT_CHECKED],
        "inputs": _inputs(drive, result.arc),
        **scalars,
        "unbounded": [name for name, value in scalars.items() if math.isinf(value)],
        "classical": [_classical_data(c) for c in classical_drives(result.arc, lagging)],
        "wear": life_data(result, lagging),
        "profile": {name: column.tolist() for name, column in result.profile.columns()},
    }


def _inputs(drive: Drive, arc: WrapArc) -> Data:
    numbers = {entry.name: entry.value for entry in arc_inputs(drive, arc) if entry.name}
    return {**numbers, "overrun_by_formula": arc.overrun is None, "recovery": arc.recovery}


def _classical_data(classical: ClassicalDrive) -> Data:
    design = classical.design
    return {
        "standard": design.standard,
        "surface": design.surface,
        "condition": design.condition,
        "friction": list(design.friction),
        "tension_ratio": list(classical.ratio),
        "wrap_factor": list(classical.wrap_factor),
        "slack_tension": list(classical.slack_tension),
        "slipping_arc": list(classical.slipping_arc),
        "source": _origin(design.provenance),
    }


def _drive_data(drive: Drive, file: str) -> Data:
    belt = drive.belt
    return {
        "file": file,
        "title": drive.title,
        "creep_limit": drive.creep_limit,
        "belt": {
            "name": belt.name,
            "kind": belt.kind,
            "belt_width": belt.width,
            "belt_modulus": belt.modulus,
            "rating": belt.rating,
            "belt_speed": belt.speed,
        },
        "pulleys": [
            {
                "name": pulley.name,
                "diameter": pulley.diameter,
                "wrap_angle": pulley.wrap_angle,
                "side": pulley.side,
                "lagging": lagging_data(pulley.lagging),
            }
            for pulley in drive.pulleys
        ],
        "load_cases": [case.name for case in drive.load_cases],
    }


def lagging_data(lagging: Lagging) -> Data:
    """Return what a lagging is as plain data, SI."""
    tested = lagging.law.tested
    ends = {} if tested is None else {f.name: getattr(tested, f.name) for f in fields(tested)}
    return {
        "name": lagging.name,
        "title": lagging.title,
        "condition": lagging.condition,
        "surface": lagging.surface,
        "law": type(lagging.law).__name__,
        "slip_includes": lagging.law.slip_includes,
        "tested": ends or None,
        "lagging_thickness": lagging.thickness,
        "shear_modulus": lagging.shear_modulus,
        "compression_modulus": lagging.compression_modulus,
    }


def sources_of(drive: Drive) -> list[Data]:
    """Return where every input came from, with what it is the source of."""
    found: list[Data] = []
    for of, thing in _sourced(drive):
        found.append({"of": of, "part": "", **_origin(thing.provenance)})
        found += [
            {"of": of, "part": part, **_origin(origin)} for part, origin in thing.sources.items()
        ]
    for pulley in drive.pulleys:
        found += [
            {"of": f"pulley {pulley.name}", "part": part, **_origin(origin)}
            for part, origin in pulley.sources.items()
        ]
    return found


def _sourced(drive: Drive) -> Iterable[tuple[str, Belt | Lagging]]:
    yield f"belt {drive.belt.name}", drive.belt
    for lagging in drive.laggings:
        of = f", {lagging.condition}" if drive.conditions else ""
        yield f"lagging {lagging.name}{of}", lagging


def _origin(provenance: Provenance) -> Data:
    return {
        "kind": provenance.kind.value,
        "source": provenance.source,
        "date": provenance.date,
        "note": provenance.note,
    }


def _units(arcs: Iterable[Data]) -> dict[str, str]:
    """Return the SI unit of every name of the glossary that the arcs use, 1 for plain numbers."""
    names = {name for arc in arcs for part in (arc, arc["inputs"], arc["profile"]) for name in part}
    names |= {"belt_modulus", "wrap_factor"}
    return {
        name: DIMENSION_TEXT[GLOSSARY[name].dimension].si_unit or "1"
        for name in sorted(names)
        if name in GLOSSARY
    }
