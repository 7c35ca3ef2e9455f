"""Fields of a train as columns: the load divides anew in every row of a study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from wraparc.arrays import Array, Codes, Flags
from wraparc.batch import Setting
from wraparc.drive import Tensions
from wraparc.schema.problems import Place, Report
from wraparc.schema.source import Document
from wraparc.study.fields import DRUM_KEYS, SCALING
from wraparc.study.plan import Values
from wraparc.train import Motors, Train, TrainBatchResult
from wraparc.train.batch import solve_rows
from wraparc.train.batch_result import BEYOND_MOTOR, REFUSED
from wraparc.train.columns import OF_DRUM, of_motor
from wraparc.train.file import train_from_document
from wraparc.train.read_columns import read_rows

_BELT = {"modulus": "belt_modulus", "width": "belt_width", "speed": "belt_speed"}
_LAGGING = {
    "thickness": "lagging_thickness",
    "shear_modulus": "shear_modulus",
    "compression_modulus": "compression_modulus",
    "wear_coefficient": "wear_coefficient",
    **{key: key for key in SCALING},
}
_TENSIONS = ("entry_tension", "exit_tension", "effective_tension")


class _Field(Protocol):
    @property
    def name(self) -> str: ...
    @property
    def place(self) -> Place: ...


@dataclass(frozen=True, eq=False)
class Divided:
    """Trains of a study, their load divided.

    Attributes
    ----------
    solved
        The trains.
    entries, exits
        Tensions, shape (pulleys, n) each [N].
    valid
        Which can be trains that their motors turn, shape (n,).
    lost
        Status of those whose load finds no balance, 0 of the others, shape (n,).
    """

    solved: TrainBatchResult
    entries: Array
    exits: Array
    valid: Flags
    lost: Codes


@dataclass(frozen=True, eq=False)
class TrainColumns:
    """A train whose fields are columns.

    Attributes
    ----------
    train
        The train of the file.
    columns
        Columns that each field is, by its name.
    given
        Which of its tensions the file gives.
    """

    train: Train
    columns: Mapping[str, tuple[str, ...]]
    given: tuple[str, ...]

    @classmethod
    def of(cls, document: Document, fields: Sequence[_Field]) -> TrainColumns | None:
        """Return the train of a drive file; None where a field is no column of it."""
        if "train" not in document or not fields:
            return None
        train = train_from_document(document, allow_paths=True)
        columns = {f.name: _columns(f.place, train, document) for f in fields}
        given = tuple(key for key in _TENSIONS if key in document["train"])
        if not all(columns.values()) or len(given) != 2:
            return None
        return cls(train, columns, given)

    def solve(self, values: Values, size: int, load_case: str, setting: Setting) -> Divided:
        """Return the trains of some values in a load case."""
        case = self.train.case(load_case)
        columns: dict[str, Array] = {
            column: values[name]
            for name, own in self.columns.items()
            if name in values
            for column in own
        }
        for pulley in self.train.pulleys:
            key = f"{pulley.name}.shear_modulus"  # a file has that of the rubber
            if key in columns:
                columns[key] = columns[key] * pulley.lagging.contact_fraction
        if any(key in _TENSIONS or key.endswith(".run") for key in columns):
            for key in self.given:
                columns.setdefault(key, np.full(size, getattr(case, key)))
        columns.setdefault("belt_width", np.full(size, self.train.belt.width))
        read = read_rows(self.train, columns, case.name)
        solved = solve_rows(read.rows, read.start, setting=setting, capacities=False, threads=1)
        drums = list(solved.drums.values())
        entries = np.stack([drum["entry_tension"] for drum in drums])
        exits = np.stack([drum["exit_tension"] for drum in drums])
        sound = (solved.status == 0) | np.isfinite(drums[0]["share"])  # an arc may break away
        lost = np.where(sound | (solved.status > REFUSED), 0, solved.status).astype(np.int8)
        tensions = np.concatenate([entries, exits])
        possible = ((tensions > 0.0) & (tensions <= Tensions.LIMITS["entry"].most)).all(axis=0)
        valid = read.good & (solved.status != BEYOND_MOTOR) & (possible | (lost > 0))
        return Divided(solved, entries, exits, valid, lost)


def _columns(place: Place, train: Train, document: Document) -> tuple[str, ...]:
    """Return the columns of a train that a field is, none where it is none."""
    names = [p.name for p in train.pulleys]
    head, key = place[:-1], str(place[-1])
    if head == ("belt",) and key in _BELT:
        return (_BELT[key],)
    if head == ("train",):
        return (key,) if key in _TENSIONS else ()
    if place[0] == "lagging" and len(place) == 3 and key in _LAGGING:
        users = [p["name"] for p in document["pulley"] if p.get("lagging") == place[1]]
        return tuple(f"{name}.{_LAGGING[key]}" for name in users)
    name = str(place[1]) if len(place) > 2 else str(place[-1])
    if place[:2] == ("train", "run"):
        return (f"{key}.run",)
    if place[:2] == ("train", "motor") and len(place) == 4:
        name = str(place[2])
        division = train.cases[0].division
        if name in names and isinstance(division, Motors):
            own = of_motor(division.motors[names.index(name)])
            return (f"{name}.{key}",) if key in own else ()
    if place[0] != "pulley" or name not in names:
        return ()
    if len(place) == 4 and place[2] == "lagging":
        return (f"{name}.{_LAGGING[key]}",) if key in _LAGGING else ()
    if key == "diameter":  # that of the file is nominal; the drum is as large unless it says more
        both = (f"{name}.diameter", f"{name}.nominal_diameter")
        return () if "diameters" in document["train"] else both
    return (f"{name}.{key}",) if len(place) == 3 and key in (*OF_DRUM, *DRUM_KEYS) else ()


class _Source(Protocol):
    @property
    def document(self) -> Document: ...
    @property
    def pulley(self) -> str: ...
    @property
    def fields(self) -> Sequence[_Field]: ...
    @property
    def divides(self) -> TrainColumns | None: ...


def refused(source: _Source, load_cases: Sequence[str], report: Report) -> bool:
    """Report shares, trims and wear that cannot be varied beside the other fields, if any."""
    place = ("axis",)
    if source.divides is not None:
        columns = {c: np.empty(0) for own in source.divides.columns.values() for c in own}
        train = source.divides.train
        read = [report.tried(lambda n=n: read_rows(train, columns, n), place) for n in load_cases]  # type: ignore[misc]
        return None in read
    message = "belongs to a train"
    if "train" in source.document:
        message = "does not go with fields outside belt, pulleys and [train]"
    alone = ("pulley", source.pulley, "wear")  # of a single drive
    wrong = [
        field
        for field in source.fields
        if field.place[-1] in DRUM_KEYS and ("train" in source.document or field.place != alone)
    ]
    for field in wrong:
        report.add((*place, field.name), message, "Remove it or the other fields.")
    return bool(wrong)
