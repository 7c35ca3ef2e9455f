"""By which keys of a drive file an input of a reserve is changed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import isclose

from wraparc.actions.document import Source, source_of, tension_places, value_of
from wraparc.actions.variant import Variant
from wraparc.checks.action import Change
from wraparc.drive import Drive, Tensions
from wraparc.errors import InputError
from wraparc.reserve.inputs import (
    CARCASS,
    COMPRESSION,
    DIAMETER,
    MODULUS,
    PULL,
    SHEAR,
    SLACK,
    START,
    TAKE_UP_PLACE,
    THICKNESS,
    WRAP,
    Input,
    change_drive,
)
from wraparc.schema.problems import Place, place_text
from wraparc.train.whole import Whole, by_pulley
from wraparc.units import Dimension, parse_quantity

#: Inputs that are a number of each pulley: key, attribute and unit.
_OF_PULLEY = {
    DIAMETER: ("diameter", "m"),
    WRAP: ("wrap_angle", "rad"),
}
_OF_LAGGING = {
    THICKNESS: ("thickness", "m"),
    SHEAR: ("shear_modulus", "Pa"),
    COMPRESSION: ("compression_modulus", "Pa"),
}
_OF_CONVEYOR = {TAKE_UP_PLACE: "m", START: None}
_ENDS = {"entry_tension": "entry", "exit_tension": "exit"}
#: Loads that are multiples of the effective tension, with their dimensions and units.
_LOADS: Mapping[str, tuple[Dimension, str]] = {
    "effective_tension": ("force", "N"),
    "power": ("power", "W"),
    "torque": ("torque", "N m"),
}
#: Part by which numbers may differ that are the same [-].
_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class ReserveKeys:
    """Finds the keys of a file by which the inputs of a solved drive or train are changed.

    Attributes
    ----------
    drive
        As it is solved, pulley by pulley.
    source
        Its document; None where nothing can be written.
    """

    drive: Drive
    source: Source | None

    @classmethod
    def of(cls, result: Whole) -> ReserveKeys:
        """Return those of a solved drive or train."""
        drive = by_pulley(result).drive
        take_up = drive.take_up_tension(drive.load_case())
        return cls(drive, source_of(result, (), take_up))

    def changes(self, of: Input, factor: float) -> tuple[Change, ...]:
        """Return the changes of the file that put a factor on an input.

        Empty where no key does: friction and slip follow from the law of a lagging, and an
        effective tension may follow from a conveyor. Of one drive it is read again with the
        changes, and is the one that the reserve is of.
        """
        if self.source is None:
            return ()
        try:
            changes = tuple(self._changes(self.source, of, factor))
            read = self.source.read(changes)
            wanted = change_drive(self.drive, of, factor)
        except (InputError, KeyError):
            return ()
        if isinstance(read, Drive) and not _is_alike(read, wanted):
            return ()
        return changes

    def _changes(self, source: Source, of: Input, factor: float) -> Iterator[Change]:
        if of.name == MODULUS:
            modulus = self.drive.belt.modulus
            yield Change("belt.modulus", modulus, modulus * factor, "N/m")
        elif of.name == CARCASS and self.drive.belt.carcass is not None:
            carcass = self.drive.belt.carcass
            yield Change("belt.carcass", carcass, carcass * factor, "m")
        elif of.name in _OF_CONVEYOR and self.drive.conveyor is not None:
            now = float(getattr(self.drive.conveyor, of.name))
            yield Change(f"conveyor.{of.name}", now, now * factor, _OF_CONVEYOR[of.name])
        elif of.name == SLACK:
            yield from source.changes(Variant(tension=source.take_up * factor))
        elif of.name == PULL:
            yield from self._loads(source, of, factor)
        place: tuple[str, ...]
        for pulley in self.drive.pulleys:
            if pulley.name not in of.pulleys:
                continue
            if of.name in _OF_PULLEY:
                key, unit = _OF_PULLEY[of.name]
                place = ("pulley", pulley.name, key)
                now = float(getattr(pulley, key))
            elif of.name in _OF_LAGGING:
                key, unit = _OF_LAGGING[of.name]
                place = ("pulley", pulley.name, "lagging", key)
                now = float(getattr(pulley.lagging, key))
            else:
                continue
            yield Change(place_text(place), now, now * factor, unit)

    def _loads(self, source: Source, of: Input, factor: float) -> Iterator[Change]:
        """Yield every tension that is another, and every load that is a multiple of them."""
        if "conveyor" in source.document:
            return
        wanted = change_drive(self.drive, of, factor)
        for place in tension_places(source.document):
            before = parse_quantity(value_of(source.document, place), "force")
            after = self._tension(wanted, place, before)
            if not isclose(after, before, rel_tol=_SAME):
                yield Change(place_text(place), before, after, "N")
        for place in self._multiples(source):
            dimension, unit = _LOADS[place[-1]]
            before = parse_quantity(value_of(source.document, place), dimension)
            yield Change(place_text(place), before, before * factor, unit)

    def _tension(self, wanted: Drive, place: Place, before: float) -> float:
        """Return what becomes of a tension of the document: that of a load case that has it."""
        *of, key = place
        names = [p.name for p in self.drive.pulleys]
        end = _ENDS[str(key)]
        name = names[0 if end == "entry" else -1] if of[-1] == "train" else str(of[-1])
        for case in self.drive.load_cases:
            if of[0] == "load_case" and case.name.partition(", ")[0] != of[1]:
                continue
            if isclose(_end(case.tensions[name], end), before, rel_tol=_SAME):
                return _end(wanted.load_case(case.name).tensions[name], end)
        return before

    def _multiples(self, source: Source) -> Iterator[tuple[str, ...]]:
        tables: list[tuple[str, ...]] = [("train",)]
        tables += [("pulley", p.name) for p in self.drive.pulleys]
        for row in source.document.get("load_case", ()):
            case = ("load_case", row["name"])
            tables += [(*case, "train"), *((*case, "pulley", n) for n in row.get("pulley", {}))]
        for table in tables:
            row = value_of(source.document, table)
            keys = row if isinstance(row, dict) else {}
            yield from ((*table, key) for key in _LOADS if key in keys)


def _end(of: Tensions, end: str) -> float:
    return float(getattr(of, end))


def _numbers(drive: Drive) -> Iterator[float]:
    """Yield what the changes of inputs make another."""
    yield from (drive.belt.modulus, drive.belt.carcass or 0.0)
    for pulley in drive.pulleys:
        yield from (pulley.diameter, pulley.wrap_angle)
        for lagging in (pulley.lagging, *pulley.conditions):
            yield from (lagging.thickness, lagging.shear_modulus, lagging.compression_modulus)
    for case in drive.load_cases:
        for name in sorted(case.tensions):
            yield from (case.tensions[name].entry, case.tensions[name].exit)


def _is_alike(one: Drive, other: Drive) -> bool:
    pairs = zip(_numbers(one), _numbers(other), strict=False)
    return all(isclose(a, b, rel_tol=1e3 * _SAME) for a, b in pairs)
