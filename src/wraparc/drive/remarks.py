"""What an experienced reader would say about a drive before solving it."""

from collections.abc import Iterator

from wraparc.drive.belt import Belt
from wraparc.drive.drive import Drive
from wraparc.drive.load_case import LoadCase
from wraparc.drive.pulley import Pulley
from wraparc.provenance import Kind
from wraparc.units import Dimension, System, display

# Sizes that conveyor drives have; outside, a unit is more likely wrong than the drive.
_USUAL: dict[str, tuple[Dimension, float, float]] = {
    "width": ("length", 0.2, 4.0),
    "modulus": ("force_per_width", 1e5, 1e9),
    "speed": ("speed", 0.05, 15.0),
    "diameter": ("length", 0.15, 3.0),
}
_ROUNDING = 1e-9


def design_remarks(drive: Drive, system: System = "si") -> tuple[str, ...]:
    """Return remarks on a drive that need no solving, one sentence each.

    Sizes far from usual ones, tensions above the belt's rating, pulleys below the belt's
    least diameter, wrap pressures outside the tested range of the lagging, and which
    data is illustrative or calibrated.
    """
    return (
        *_unusual("belt", drive.belt, system, "width", "modulus", "speed"),
        *(remark for pulley in drive.pulleys for remark in _pulley_remarks(drive, pulley, system)),
        *(
            remark
            for case in drive.load_cases
            for pulley in drive.pulleys
            for remark in _tension_remarks(drive.belt, pulley, case, system)
        ),
        *_origin_remarks(drive),
    )


def _unusual(owner: str, thing: object, system: System, *fields: str) -> Iterator[str]:
    for name in fields:
        value = getattr(thing, name)
        dimension, least, most = _USUAL[name]
        if value is not None and not least <= value <= most:
            size = display(value, dimension, system)
            usual = f"{display(least, dimension, system)} to {display(most, dimension, system)}"
            yield f"The {name} of {owner}, {size}, is outside the usual {usual}: check the unit."


def _pulley_remarks(drive: Drive, pulley: Pulley, system: System) -> Iterator[str]:
    yield from _unusual(f"pulley {pulley.name}", pulley, system, "diameter")
    least = drive.belt.least_pulley_diameter
    if least is not None and pulley.diameter < least * (1.0 - _ROUNDING):
        yield (
            f"Pulley {pulley.name}, {display(pulley.diameter, 'length', system)}, is smaller than "
            f"the least drive pulley of belt {drive.belt.name}, {display(least, 'length', system)}."
        )


def _tension_remarks(belt: Belt, pulley: Pulley, case: LoadCase, system: System) -> Iterator[str]:
    where = f"Load case {case.name}, pulley {pulley.name}"
    tensions = case.tensions[pulley.name]
    highest = max(tensions.entry, tensions.exit)
    if belt.rating is not None and highest > belt.rating * belt.width * (1.0 + _ROUNDING):
        yield (
            f"{where}: the tension {display(highest, 'force', system)} is above the rating of the "
            f"belt, {display(belt.rating * belt.width, 'force', system)}."
        )
    tested = pulley.lagging.law.tested
    if tested is None:
        return
    low, high = tested.pressure_min, tested.pressure_max
    for side, tension in (("entry", tensions.entry), ("exit", tensions.exit)):
        pressure = 2.0 * tension / (belt.width * pulley.diameter)
        if not low * (1.0 - _ROUNDING) <= pressure <= high * (1.0 + _ROUNDING):
            found, least, most = (
                display(value, "pressure", system) for value in (pressure, low, high)
            )
            yield (
                f"{where}: the wrap pressure at the {side}, {found}, is outside the tested "
                f"{least} to {most} of lagging {pulley.lagging.name}."
            )


def _origin_remarks(drive: Drive) -> Iterator[str]:
    laws = {p.lagging.name: p.lagging.source_of("law").kind for p in drive.pulleys}
    for name, kind in laws.items():
        if kind is Kind.ILLUSTRATIVE:
            yield f"The friction of {name} is illustrative: it describes no real product."
        elif kind is Kind.CALIBRATED:
            yield f"The friction of {name} is calibrated: it was fitted to a known result."
    owners = {"belt": drive.belt.sources} | {p.name: p.sources for p in drive.pulleys}
    for kind in (Kind.ILLUSTRATIVE, Kind.CALIBRATED):
        parts = [
            f"{part} of {owner}"
            for owner, sources in owners.items()
            for part, source in sources.items()
            if source.kind is kind
        ]
        if parts:
            yield f"These inputs are {kind}: {', '.join(parts)}."
