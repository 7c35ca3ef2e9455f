"""What an answer rests on: every input once, with what it measures and where it came from.

Sheets, notes, workbooks and JSON show this one list.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from wraparc.answer.sheet import percent, quantity, term
from wraparc.answer.sources import Sources
from wraparc.arc import WrapArc
from wraparc.catalogue.belt_modulus import format_test
from wraparc.drive import CREEP_LIMIT, Belt, Drive, Lagging, Pulley
from wraparc.drive.belt import COVER_SHEAR_MODULUS, LAYERS, THICKNESS
from wraparc.drive.conditions import SCALED
from wraparc.drive.pitch import ESTIMATED_COVER, covered, pitch_offset
from wraparc.provenance import Kind, Provenance
from wraparc.units import GIVEN_DIGITS, RESULT_DIGITS, Dimension, either

if TYPE_CHECKING:
    from wraparc.train import Train

_GIVEN = Provenance()
_CUSTOMARY = Provenance(
    Kind.PUBLISHED,
    "B. DeVries, A model of lagging friction as a function of creep history and wrap pressure",
    note="the conservative customary limit",
)
_FORMULA = "from the compression of the lagging, 1.25 delta sqrt(delta/R)"


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
        Number [SI], words, or None for what is not given and shown nowhere but in JSON.
    dimension
        What a number measures.
    symbol
        Letter of the equations.
    origin
        Where it came from, or None where `remark` says how it was computed.
    remark
        What else to know about it.
    name
        Name in the glossary, or empty.
    """

    group: str
    title: str
    value: float | str | None
    dimension: Dimension = "number"
    symbol: str = ""
    origin: Provenance | None = _GIVEN
    remark: str = ""
    name: str = ""

    def text(self) -> str:
        """Return the value with its unit."""
        if self.value is None or isinstance(self.value, str):
            return str(self.value)
        if math.isinf(self.value):
            return "rigid"
        digits = RESULT_DIGITS if self.origin is None else GIVEN_DIGITS
        return quantity(self.value, self.dimension, digits, self.name)

    def note(self, of: Sources) -> str:
        """Return where it came from, with the number of its source, and its remark."""
        origin = "" if self.origin is None else of.note(self.origin)
        return "; ".join(part for part in (origin, self.remark) if part)


def drive_inputs(drive: "Drive | Train", *, divided: bool = False) -> tuple[Input, ...]:
    """Return the inputs of a drive: belt, pulleys, laggings, load cases.

    Parameters
    ----------
    drive
        The drive, or a train.
    divided
        Whether the tensions come from dividing the load of a train, and are no inputs.
    """
    arcs = []
    if isinstance(drive, Drive) and not divided:
        arcs = [WrapArc.of(drive, p, case) for case in drive.load_cases for p in drive.pulleys]
    return (
        *belt_inputs(drive.belt),
        *(entry for pulley in drive.pulleys for entry in _pulley(drive, pulley)),
        *(e for lagging in drive.laggings for e in lagging_inputs(lagging, drive.conditions)),
        *(entry for arc in arcs for entry in (*_tensions(drive, arc), *_overrun(drive, arc))),
    )


def arc_inputs(drive: Drive, arc: WrapArc) -> tuple[Input, ...]:
    """Return the inputs of one arc of a drive, with what follows from them at once."""
    pulley = drive.pulley(arc.pulley).in_condition(drive.load_case(arc.load_case).condition)
    pull, ratio = arc.effective_tension, arc.entry_tension / arc.exit_tension
    group = f"Load case {arc.load_case}"
    return (
        # on a train each drum meets the belt at a speed of its own
        *belt_inputs(replace(drive.belt, speed=arc.belt_speed)),
        *_pulley(drive, pulley, arc.entry_overrun),
        *lagging_inputs(pulley.lagging),
        *_tensions(drive, arc),
        _named(group, "effective_tension", pull, None, arc.duty),
        _named(group, "tension_ratio", ratio, None),
    )


def _named(
    group: str, name: str, value: float | None, origin: Provenance | None, remark: str = ""
) -> Input:
    entry = term(name)
    return Input(group, entry.title, value, entry.dimension, entry.symbol, origin, remark, name)


def belt_inputs(belt: Belt) -> Iterator[Input]:
    """Yield the inputs of a belt."""
    group = "Belt"

    def origin(key: str) -> Provenance:
        return belt.sources.get(key, belt.provenance)

    def own(title: str, value: float | None, dimension: Dimension, key: str) -> Input:
        return Input(group, title, value, dimension, "", origin(key))

    name = f"{belt.name} ({belt.kind})" if belt.kind else belt.name
    yield Input(group, "Belt", name, origin=belt.provenance)
    yield _named(group, "belt_width", belt.width, origin("width"))
    measured = format_test(belt.kind, belt.modulus_test, belt.modulus_loads)
    remark = "" if math.isinf(belt.modulus) else measured
    yield _named(group, "belt_modulus", belt.modulus, origin("modulus"), remark)
    yield _named(group, "axial_stiffness", belt.axial_stiffness, None, "M B")
    yield own("Rating of the belt", belt.rating, "force_per_width", "rating")
    if belt.breaking_strength is not None:
        yield own("Breaking strength", belt.breaking_strength, "force_per_width", "strength")
    least, most = belt.least_pulley_diameter, belt.largest_wrap_pressure
    yield own("Minimum drive pulley", least, "length", "least_pulley_diameter")
    yield own("Maximum wrap pressure", most, "pressure", "largest_wrap_pressure")
    yield own("Momentary tension over rating", belt.momentary_factor, "number", "momentary_factor")
    yield _named(group, "belt_speed", belt.speed, origin("speed"))
    shear = belt.in_plane_shear_stiffness
    if shear is not None:
        origin_of = origin("in_plane_shear_stiffness")
        yield _named(group, "in_plane_shear_stiffness", shear, origin_of)
    layers = (*LAYERS, THICKNESS, "cover_shear_modulus", "cord_diameter", "cord_pitch", "mass")
    for key in layers:
        if getattr(belt, key) is not None:
            name = {"thickness": "belt_thickness", "mass": "belt_mass"}.get(key, key)
            yield _named(group, name, getattr(belt, key), origin(key))
    if covered(belt) and belt.cover_shear_modulus is None:
        yield _named(group, "cover_shear_modulus", COVER_SHEAR_MODULUS, ESTIMATED_COVER)


def _pulley(
    drive: "Drive | Train", pulley: Pulley, overrun: float | None = None
) -> Iterator[Input]:
    """Yield the inputs of a pulley; an overrun by formula has a value on one arc alone."""
    group = f"Pulley {pulley.name}"

    def origin(key: str) -> Provenance:
        return pulley.sources.get(key, _GIVEN)

    yield _named(group, "diameter", pulley.diameter, origin("diameter"))
    yield _named(group, "wrap_angle", pulley.wrap_angle, origin("wrap_angle"))
    offset, side = pitch_offset(drive.belt, pulley.side), f"{pulley.side} side of the belt"
    if offset is not None:
        yield _named(group, "pitch_offset", offset, None, side)
    elif pulley.side != "pulley":
        yield Input(group, "Meets the", side, origin=origin("side"))
    if pulley.mass is not None:
        yield _named(group, "pulley_mass", pulley.mass, origin("mass"))
    if pulley.overrun is not None:
        yield _named(group, "overrun", pulley.overrun, origin("overrun"))
    else:
        by_formula = _named(group, "overrun", overrun, None, _FORMULA)
        yield by_formula if overrun is not None else replace(by_formula, value="by formula")
    if not pulley.recovery:
        yield Input(group, "Recovery of the lagging", "not counted", origin=origin("recovery"))
    limit = drive.creep_limit_of(pulley)
    known = _CUSTOMARY if limit == CREEP_LIMIT else _GIVEN
    yield _named(group, "creep_limit", limit, pulley.sources.get("creep_limit", known))
    conditions = (lagging.condition for lagging in pulley.conditions or (pulley.lagging,))
    lagging, title = f"{pulley.lagging.name} ({', '.join(conditions)})", pulley.lagging.title
    yield Input(group, "Lagging", lagging, origin=origin("lagging"), remark=title)
    yield from _across(pulley, origin)


def _across(pulley: Pulley, origin: Callable[[str], Provenance]) -> Iterator[Input]:
    """Yield what is uneven across the width of a pulley."""
    across, group = pulley.across, f"Pulley {pulley.name}"
    if across is None:
        return
    for key, profile in across.profiles().items():
        title = key.replace("_", " ").capitalize()
        dimension: Dimension = "force_per_width" if key == "entry_profile" else "length"
        rows = f"maximum less minimum of {len(profile.position)} places"
        size = max(profile.value) - min(profile.value) if profile.value else profile.crown
        remark = rows if profile.value else "crown, on radius"
        yield Input(group, title, size, dimension, "", origin("across"), remark)
    if across.misalignment:
        skew = across.misalignment
        text = either(f"{1e3 * skew:.4g} mm/m", f"{12.0 * skew:.4g} in/ft")
        yield Input(group, "Misalignment", text, origin=origin("across"))
    if across.deflection:
        yield Input(group, "Shaft deflection", across.deflection, "length", "", origin("across"))


def lagging_inputs(lagging: Lagging, conditions: tuple[str, ...] = ()) -> Iterator[Input]:
    """Yield the inputs of a lagging in its condition, named where there are several."""
    group = f"Lagging {lagging.name}" + (f", {lagging.condition}" if conditions else "")
    by_law = lagging.source_of("law")
    yield Input(group, "Friction law", lagging.law.title, symbol="mu(x, p)", origin=by_law)
    if SCALED in lagging.sources:
        scaled = lagging.notes[-1]
        yield Input(group, "Scaled to the condition", scaled, origin=lagging.sources[SCALED])
    yield Input(
        group, "Slip of the law includes", in_slip(lagging.law.slip_includes), origin=by_law
    )
    yield from _factors(group, lagging)
    for name, key in (
        ("lagging_thickness", "thickness"),
        ("shear_modulus", "shear_modulus"),
        ("compression_modulus", "compression_modulus"),
        ("wear_coefficient", "wear_coefficient"),
    ):
        yield _named(group, name, getattr(lagging, key), lagging.source_of(key))
    tested = lagging.law.tested
    if tested is not None:
        least, most = tested.pressure_min, tested.pressure_max
        yield Input(group, "Tested from a pressure of", least, "pressure", "p", by_law)
        yield Input(group, "Tested to a pressure of", most, "pressure", "p", by_law)
        yield Input(group, "Tested to a slip of", tested.slip_max, "length", "x", by_law)
        yield Input(group, "Tested at a slip speed of", tested.slip_speed, "speed", "", by_law)


def in_slip(parts: tuple[str, ...] | None) -> str:
    """Say what the slip of a law holds besides the sliding."""
    if parts is None:
        return "shear is not stated"
    return " and ".join(("sliding", *parts))


def _factors(group: str, lagging: Lagging) -> Iterator[Input]:
    """Yield the factors of slip speed and temperature that the tested law was multiplied by."""
    of = lagging.factors
    if of is None:
        return
    if of.by_slip_speed is not None:
        name = "Friction factor of slip speed, up to"
        told = f"the minimum is {of.of_slip_speed:.3g}"
        yield Input(group, name, of.fastest, "speed", "", of.by_slip_speed.source, told)
    if of.by_temperature is not None:
        told = f"{of.of_temperature:.3g}"
        if of.temperature is None:
            told = f"{told}, the minimum of its table: temperature missing"
        name = "Friction factor of temperature"
        yield Input(group, name, told, origin=of.by_temperature.source)


def _overrun(drive: "Drive | Train", arc: WrapArc) -> Iterator[Input]:
    """Yield the overrun that the formula gives at the tensions of an arc."""
    if arc.overrun is None:
        yield _named(_arc_group(drive, arc), "overrun", arc.entry_overrun, None, _FORMULA)


def _arc_group(drive: "Drive | Train", arc: WrapArc) -> str:
    several = len(drive.pulleys) > 1
    return f"Load case {arc.load_case}" + (f", pulley {arc.pulley}" if several else "")


def _tensions(drive: "Drive | Train", arc: WrapArc) -> Iterator[Input]:
    pulley = next(p for p in drive.pulleys if p.name == arc.pulley)
    group = _arc_group(drive, arc)
    tight = "entry_tension" if arc.entry_tension >= arc.exit_tension else "exit_tension"
    for name in ("entry_tension", "exit_tension"):
        value, used = getattr(arc, name), ""
        if name == tight and drive.belt.rating is not None:
            share = percent(value / (drive.belt.rating * drive.belt.width))
            used = f"{share} of the belt's rating"
        origin: Provenance | None = pulley.sources.get(name, _GIVEN)
        why = _computed(drive, arc, name.removesuffix("_tension"))
        if why:
            used, origin = "; ".join(filter(None, (f"{_T[name]} {why}", used))), None
        yield _named(group, name, value, origin, used)


_T = {"entry_tension": "T1", "exit_tension": "T2"}


def _computed(drive: "Drive | Train", arc: WrapArc, side: str) -> str:
    """Return what a tension was computed from; empty where it was given."""
    cases = drive.load_cases if isinstance(drive, Drive) else ()
    found = (c.tensions[arc.pulley].computed for c in cases if c.name == arc.load_case)
    return next(found, {}).get(side, "")
