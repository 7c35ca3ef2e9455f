"""The keys of a drive file that a variant changes, and the drive that is read with them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees, radians
from typing import Any

from wraparc.actions.variant import Variant
from wraparc.arc import DriveResult
from wraparc.checks.action import Change
from wraparc.drive import Drive, ReadFrom
from wraparc.errors import InputError
from wraparc.files.write import drive_document
from wraparc.schema.below import own_key
from wraparc.schema.overrides import put_over
from wraparc.schema.problems import NOTHING, place_text, value_at
from wraparc.train import Pulls, Train, TrainResult
from wraparc.train.file import drive_or_train_from_document
from wraparc.train.keys import TRAIN_FILE
from wraparc.train.result import drive_with
from wraparc.train.unsolved import given_pairs, load_case
from wraparc.train.whole import Described, Whole
from wraparc.units import Dimension, parse_quantity

_ENDS = ("entry_tension", "exit_tension")


@dataclass(frozen=True, eq=False)
class Source:
    """A drive or train as it is solved, and the document whose keys are changed.

    Attributes
    ----------
    described
        As it is.
    read_from
        The document.
    pulleys
        Names of those whose lagging and diameter are changed.
    take_up
        Tension at the take-up that changes of it are from [N].
    """

    described: Described
    read_from: ReadFrom
    pulleys: tuple[str, ...]
    take_up: float

    @cached_property
    def document(self) -> dict[str, Any]:
        """The document, with the names of its keys."""
        document: dict[str, Any] = dict(self.read_from.document)
        rows = [r for r in document.get("pulley", ()) if isinstance(r, Mapping)]
        kind = next(e.kind for e in TRAIN_FILE.entries if e.key == "pulley")
        table = getattr(kind, "kind", None)
        document["pulley"] = [{own_key(table, k): v for k, v in row.items()} for row in rows]
        return document

    def read(self, changes: tuple[Change, ...]) -> Described:
        """Return the drive or train with changes, in the load cases of the one that is.

        Raises
        ------
        InputError
            If there is no such drive.
        """
        values = {change.key: setting(change) for change in changes}
        found = drive_or_train_from_document(
            put_over(dict(self.read_from.document), values, TRAIN_FILE),
            folder=self.read_from.folder,
            allow_paths=self.read_from.allow_paths,
        )
        return as_asked(found, self.described)

    def changes(self, variant: Variant) -> tuple[Change, ...]:
        """Return the changes of a variant, by the keys of the document."""
        return tuple(self._changes(variant))

    def _changes(self, of: Variant) -> Iterator[Change]:
        belt, criteria = self.described.belt, self.described.criteria
        for name in self.pulleys:
            pulley = next(p for p in self.described.pulleys if p.name == name)
            if of.lagging:
                yield Change(_key(name, "lagging"), pulley.lagging.name, of.lagging)
            if of.diameter:
                yield Change(_key(name, "diameter"), pulley.diameter, of.diameter, "m")
        if of.wrap:
            (pulley,) = self.described.pulleys
            key = _key(pulley.name, "wrap_angle")
            yield Change(key, pulley.wrap_angle, radians(of.wrap), "rad")
        if of.rating and belt.rating is not None:
            yield Change("belt.rating", belt.rating, of.rating, "N/m")
        if of.strength and belt.breaking_strength is not None:
            yield Change("belt.strength", belt.breaking_strength, of.strength, "N/m")
        if of.spacing and criteria.sag is not None:
            yield Change("sag.idler_spacing", criteria.sag.spacing, of.spacing, "m")
        if of.tension:
            yield from self._tensions(of.tension)

    def _tensions(self, tension: float) -> Iterator[Change]:
        """Yield every tension that the document gives, all shifted alike."""
        if "conveyor" in self.document:
            own = self.document["conveyor"]
            if "counterweight" in own:
                before = parse_quantity(own["counterweight"], "mass")
                mass = self.described.criteria.take_up.counterweight(tension)
                yield Change("conveyor.counterweight", before, mass, "kg")
            else:
                before = parse_quantity(own["take_up_tension"], "force")
                yield Change("conveyor.take_up_tension", before, tension, "N")
            return
        lift = tension - self.take_up
        for place in tension_places(self.document):
            before = _number(self.document, place, "force")
            yield Change(place_text(place), before, before + lift, "N")

    @property
    def wrap(self) -> float:
        """Wrap angle of the only pulley; 0 where it is not to be changed [deg]."""
        rows = self.document["pulley"]
        fixed = len(self.described.pulleys) > 1 or "wrap_angle" not in rows[0]
        return 0.0 if fixed else degrees(self.described.pulleys[0].wrap_angle)

    @property
    def own_laggings(self) -> frozenset[str]:
        """Names of the document that are not those of the catalogue."""
        return frozenset(self.document.get("lagging", ()))

    @property
    def has_worn_diameters(self) -> bool:
        """Whether the diameters of the pulleys are nominal ones."""
        return "diameters" in self.document.get("train", {})


def source_of(result: Whole, pulleys: tuple[str, ...], take_up: float) -> Source | None:
    """Return what a solved drive was read from, or would be; None where nothing can be written."""
    described = result.train if isinstance(result, TrainResult) else result.drive
    read_from = described.read_from
    if read_from is not None:
        source = Source(described, read_from, pulleys, take_up)
        try:
            if source.read(()) == described:
                return source
        except InputError:
            pass
    drive = _as_drive(result)
    if drive is None:
        return None
    source = Source(described, ReadFrom(drive_document(drive)), pulleys, take_up)
    return source if source.read(()) == described else None


def _as_drive(result: Whole) -> Drive | None:
    """Return the drive that a drive file can describe; None of a train divided otherwise."""
    if isinstance(result, DriveResult):
        return result.drive
    train = result.train
    if not all(isinstance(case.division, Pulls) for case in train.cases):
        return None
    return drive_with(train, [load_case(train, case, given_pairs(case)) for case in train.cases])


def as_asked(found: Described, like: Described) -> Described:
    """Return a drive or train in the load cases and with the creep limits of another."""
    if isinstance(like, Train) and isinstance(found, Drive):
        found = Train.of(found)
    limits = {pulley.name: pulley.creep_limit for pulley in like.pulleys}
    pulleys = tuple(replace(p, creep_limit=limits[p.name]) for p in found.pulleys)
    if isinstance(found, Train) and isinstance(like, Train):
        names = {case.name for case in like.cases}
        some = tuple(case for case in found.cases if case.name in names)
        return replace(found, pulleys=pulleys, cases=some, creep_limit=like.creep_limit)
    if isinstance(found, Drive) and isinstance(like, Drive):
        names = {case.name for case in like.load_cases}
        cases = tuple(case for case in found.load_cases if case.name in names)
        return replace(found, pulleys=pulleys, load_cases=cases, creep_limit=like.creep_limit)
    return found


def setting(change: Change) -> str:
    """Return the value of a change as a drive file has it."""
    if isinstance(change.after, str):
        return change.after
    return f"{change.after!r} {change.unit}" if change.unit else f"{change.after!r}"


def settings_of(changes: tuple[Change, ...]) -> list[str]:
    """Return changes as the command line takes them, ``KEY=VALUE``."""
    return [f"{change.key}={setting(change)}" for change in changes]


def tension_places(document: Mapping[str, Any]) -> Iterator[tuple[str, ...]]:
    """Yield where a document gives a tension of the belt."""
    tables: list[tuple[str, ...]] = [("train",)]
    tables += [("pulley", row["name"]) for row in document.get("pulley", ())]
    for row in document.get("load_case", ()):
        case = ("load_case", row["name"])
        tables += [(*case, "train"), *((*case, "pulley", name) for name in row.get("pulley", {}))]
    for table in tables:
        for key in _ENDS:
            if value_of(document, (*table, key)) is not NOTHING:
                yield (*table, key)


def value_of(document: Mapping[str, Any], place: tuple[str, ...]) -> object:
    """Return what a document has at a place, rows of arrays by their names."""
    node: object = document
    for step in place:
        if isinstance(node, list):
            node = next((row for row in node if row.get("name") == step), NOTHING)
        else:
            node = value_at(node, (step,))
    return node


def _number(document: Mapping[str, Any], place: tuple[str, ...], dimension: Dimension) -> float:
    return parse_quantity(value_of(document, place), dimension)


def _key(pulley: str, key: str) -> str:
    return place_text(("pulley", pulley, key))
