"""Every number that a note rests on, and where it came from."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from wraparc.arc import ArcResult, DriveResult
from wraparc.drive import CREEP_LIMIT, Belt, Drive, Lagging, Pulley
from wraparc.glossary import GLOSSARY
from wraparc.present.sheet import Row, Table, quantity
from wraparc.present.sources import Sources
from wraparc.provenance import Kind, Provenance
from wraparc.units import Dimension, System

_GIVEN = Provenance()
_CUSTOMARY = Provenance(
    Kind.PUBLISHED,
    "B. DeVries, A model of lagging friction as a function of creep history and wrap pressure",
    note="the conservative customary limit",
)
_FORMULA = "from the compression of the lagging, 1.25 delta sqrt(delta/R)"
_TENSIONS = (
    "T1 at the entry nip, T2 at the exit nip; computed from power or pull where these are given."
)
#: Things alike that fit beside each other on a page, with room for their sources.
_ABREAST = 4


@dataclass(frozen=True)
class Input:
    """One input.

    Attributes
    ----------
    group
        What it belongs to: the belt, a pulley, a lagging, a load case.
    title
        What it is.
    value
        Number [SI] or words.
    dimension
        What a number measures.
    symbol
        Letter of the equations.
    origin
        Where it came from, or None where the words in `computed` say how it was found.
    computed
        How it was computed from other inputs.
    """

    group: str
    title: str
    value: float | str
    dimension: Dimension = "number"
    symbol: str = ""
    origin: Provenance | None = _GIVEN
    computed: str = ""

    def text(self, system: System) -> str:
        """Return the value with its unit."""
        if isinstance(self.value, str):
            return self.value
        return "rigid" if math.isinf(self.value) else quantity(self.value, self.dimension, system)

    def stated_origin(self, of: Sources) -> str:
        """Return where it came from, with the number of its source."""
        if self.origin is None:
            return self.computed
        return of.note(self.origin) or str(self.origin.kind)


def drive_inputs(result: DriveResult, *, divided: bool = False) -> tuple[Input, ...]:
    """Return the inputs of a solved drive: belt, pulleys, laggings, load cases.

    Parameters
    ----------
    result
        The drive.
    divided
        Whether the tensions come from dividing the load of a train, and are no inputs.
    """
    drive = result.drive
    laggings = {pulley.lagging.name: pulley.lagging for pulley in drive.pulleys}
    tensions = () if divided else result.arcs
    return (
        *_belt(drive.belt),
        *(entry for pulley in drive.pulleys for entry in _pulley(drive, pulley)),
        *(entry for lagging in laggings.values() for entry in _lagging(lagging)),
        *(entry for arc in tensions for entry in _tensions(drive, arc)),
    )


def _named(group: str, name: str, value: float, origin: Provenance, title: str = "") -> Input:
    entry = GLOSSARY[name]
    return Input(group, title or entry.title, value, entry.dimension, entry.symbol, origin)


def _belt(belt: Belt) -> Iterator[Input]:
    group = "Belt"

    def origin(key: str) -> Provenance:
        return belt.sources.get(key, belt.provenance)

    name = f"{belt.name} ({belt.kind})" if belt.kind else belt.name
    yield Input(group, "Belt", name, origin=belt.provenance)
    yield _named(group, "belt_width", belt.width, origin("width"))
    yield _named(group, "belt_modulus", belt.modulus, origin("modulus"))
    if belt.rating is not None:
        yield Input(group, "Rating", belt.rating, "force_per_width", "", origin("rating"))
    if belt.least_pulley_diameter is not None:
        least, source = belt.least_pulley_diameter, origin("least_pulley_diameter")
        yield Input(group, "Least drive pulley", least, "length", "", source)
    if belt.speed is not None:
        yield _named(group, "belt_speed", belt.speed, origin("speed"))


def _pulley(drive: Drive, pulley: Pulley) -> Iterator[Input]:
    group = f"Pulley {pulley.name}"

    def origin(key: str) -> Provenance:
        return pulley.sources.get(key, _GIVEN)

    yield _named(group, "diameter", pulley.diameter, origin("diameter"))
    yield _named(group, "wrap_angle", pulley.wrap_angle, origin("wrap_angle"))
    if pulley.overrun is not None:
        yield _named(group, "overrun", pulley.overrun, origin("overrun"))
    else:
        title, symbol = GLOSSARY["overrun"].title, GLOSSARY["overrun"].symbol
        words = "by formula"
        yield Input(group, title, words, "length", symbol, None, _FORMULA)
    if not pulley.recovery:
        yield Input(group, "Recovery of the lagging", "not counted", origin=origin("recovery"))
    limit = drive.creep_limit_of(pulley)
    known = _CUSTOMARY if limit == CREEP_LIMIT else _GIVEN
    yield _named(group, "creep_limit", limit, pulley.sources.get("creep_limit", known))
    lagging = f"{pulley.lagging.name} ({pulley.lagging.condition})"
    yield Input(group, "Lagging", lagging, origin=origin("lagging"))


def _lagging(lagging: Lagging) -> Iterator[Input]:
    group = f"Lagging {lagging.name}"
    law = lagging.law.title
    yield Input(group, "Friction law", law, symbol="mu(x, p)", origin=lagging.source_of("law"))
    for name, key in (
        ("lagging_thickness", "thickness"),
        ("shear_modulus", "shear_modulus"),
        ("compression_modulus", "compression_modulus"),
        ("wear_coefficient", "wear_coefficient"),
    ):
        value = getattr(lagging, key)
        if value is not None:
            yield _named(group, name, value, lagging.source_of(key))
    tested = lagging.law.tested
    if tested is not None:
        source = lagging.source_of("law")
        for title, value, dimension in (
            ("Tested from a pressure of", tested.pressure_min, "pressure"),
            ("Tested to a pressure of", tested.pressure_max, "pressure"),
            ("Tested to a slip of", tested.slip_max, "length"),
        ):
            yield Input(group, title, value, dimension, "", source)  # type: ignore[arg-type]


def _tensions(drive: Drive, result: ArcResult) -> Iterator[Input]:
    arc = result.arc
    several = len(drive.pulleys) > 1
    group = f"Load case {arc.load_case}" + (f", pulley {arc.pulley}" if several else "")
    sources = drive.pulley(arc.pulley).sources
    for name, value in (("entry_tension", arc.entry_tension), ("exit_tension", arc.exit_tension)):
        yield _named(group, name, value, sources.get(name, _GIVEN))


def input_tables(inputs: Sequence[Input], system: System, of: Sources) -> tuple[Table, ...]:
    """Return tables of value and origin; things alike, as two pulleys, side by side in one."""
    groups: dict[str, list[Input]] = {}
    for entry in inputs:
        groups.setdefault(entry.group, []).append(entry)
    alike: dict[tuple[str, ...], list[str]] = {}
    for group, entries in groups.items():
        kind = group.partition(" ")[0]
        alike.setdefault((kind, *(e.title for e in entries)), []).append(group)
    tables = []
    for (kind, *_), names in alike.items():
        of_names = [groups[name] for name in names]
        if kind == "Load":
            tables.append(_tensions_table(names, of_names, system, of))
            continue
        for start in range(0, len(names), _ABREAST):
            some = slice(start, start + _ABREAST)
            tables.append(_side_by_side(kind, names[some], of_names[some], system, of))
    return tuple(tables)


def _side_by_side(
    kind: str, names: Sequence[str], entries: Sequence[list[Input]], system: System, of: Sources
) -> Table:
    rows = []
    for same in zip(*entries, strict=True):
        origins = dict.fromkeys(entry.stated_origin(of) for entry in same)
        values = tuple(entry.text(system) for entry in same)
        rows.append(Row(same[0].title, values, same[0].symbol, "; ".join(origins)))
    if len(names) == 1:
        return Table(names[0], tuple(rows))
    heads = tuple(name.removeprefix(f"{kind} ") for name in names)
    return Table(f"{kind}s", tuple(rows), heads)


def _tensions_table(
    names: Sequence[str], entries: Sequence[list[Input]], system: System, of: Sources
) -> Table:
    rows = []
    for name, both in zip(names, entries, strict=True):
        origins = dict.fromkeys(entry.stated_origin(of) for entry in both)
        values = tuple(entry.text(system) for entry in both)
        rows.append(Row(name.removeprefix("Load case "), values, note="; ".join(origins)))
    heads = tuple(GLOSSARY[n].symbol for n in ("entry_tension", "exit_tension"))
    return Table("Tensions", tuple(rows), heads, _TENSIONS)
