"""Sizes that conveyors and their drives have: what is far from them is asked about.

`USUAL_SIZES` are those that every arc compares, on the page too; here stand those of
all that is described besides, by class and field.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from wraparc.arc.summary import available
from wraparc.checks.check import NOWHERE, Amount, Check, Level, Place, escaped
from wraparc.checks.numbers import (
    LARGE_MOTORS,
    USUAL_MOTORS,
    Sizes,
    compared_motor,
    compared_sizes,
    usual,
)
from wraparc.checks.rule import Rule
from wraparc.conveyor import (
    EMPTIEST,
    FULLEST,
    OVER_WIDTH,
    STEEPEST,
    USUAL_CONVEYOR,
    Conveyor,
)
from wraparc.drive import Drive, Lagging, LoadCase, Pulley
from wraparc.drive.pitch import pitch_offset
from wraparc.drive.pull import idles
from wraparc.drive.usual_sizes import USUAL_SIZES
from wraparc.train import Motor, Motors, Speeds, Train
from wraparc.train.motors import VariableSpeed
from wraparc.units import Cell, Dimension, meant_by

Ends = tuple[float, float]

USUAL_RULE = Rule("usual_sizes", "an implausible input", binding=False)
TITLE = "Input plausibility"

#: Least and most of a field by its class [SI]; 0 is none.
USUAL: dict[str, dict[str, Ends]] = {
    "Belt": {
        "momentary_factor": (1.0, 2.0), "in_plane_shear_stiffness": (5e3, 5e6),
        "pulley_cover": (0.4e-3, 25e-3), "carry_cover": (0.4e-3, 35e-3),
        "carcass": (0.4e-3, 30e-3), "thickness": (1.5e-3, 60e-3),
        "cover_shear_modulus": (0.3e6, 5e6), "cord_diameter": (1.5e-3, 20e-3),
        "cord_pitch": (4e-3, 40e-3),
    },
    "TakeUp": {"sheave_ratio": (0.2, 8.0)},
    "DesignStandard": {"friction": (0.1, 0.9), "start_factor": (1.0, 2.5)},
    "SafetyFactors": {"running": (1.05, 6.0), "starting": (1.0, 4.0), "braking": (1.0, 4.0)},
    "Sag": {"spacing": (0.3, 8.0), "line_mass": (1.0, 3000.0), "share": (0.002, 0.05)},
    # of a conveyor of 3 m C is 9.2, and 1.92 of one of 80 m (DIN 22101:2002-08, ISO 5048)
    "Conveyor": {
        "length_coefficient": (1.0, 9.5), "start_factor": (1.05, 2.5),
        "carry_spacing": (0.3, 6.0), "return_spacing": (0.5, 12.0), "sag_limit": (0.002, 0.05),
    },
    "Flight": {
        "curve_radius": (20.0, 20e3), "friction_factor": (0.01, 0.04),
        "carry_idler_mass": (1.0, 200.0), "return_idler_mass": (0.5, 100.0),
        "carry_spacing": (0.3, 6.0), "return_spacing": (0.5, 12.0),
    },
    "LoadingPoint": {
        "capacity": (1.0, 15e3), "material_mass": (0.5, 4000.0), "material_speed": (0.1, 12.0),
        "skirt_width": (0.1, 4.0), "acceleration_length": (0.1, 30.0), "density": (100.0, 8e3),
        "belt_friction": (0.2, 1.2), "skirt_friction": (0.2, 1.2),
    },
    "Local": {
        "diameter": (0.1, 3.0), "shaft_diameter": (0.02, 0.8), "wrap_angle": (0.05, 6.3),
        "mass": (10.0, 20e3), "width": (0.1, 4.0), "thickness": (1e-3, 0.1),
        "pressure": (3e3, 300e3), "friction": (0.1, 1.2), "length": (0.3, 20e3),
        "density": (100.0, 8e3), "angle": (0.0017, 0.09), "trough_coefficient": (0.1, 1.0),
        "force": (10.0, 200e3),
    },
    "Travel": {
        "temperature_range": (2.0, 150.0), "thermal_expansion": (1e-6, 1e-3),
        "permanent_elongation": (1e-4, 0.05), "splice_length": (0.2, 100.0),
    },
    "Cema": {"idler_friction": (1.0, 60.0), "ky": (0.01, 0.05), "other": (10.0, 200e3)},
    "Lagging": {
        "elastic_modulus": (0.3e6, 100e6), "wear_coefficient": (1e-13, 1e-10),
        "belt_energy_share": (0.01, 1.0),
    },
    "Block": {
        "width": (2e-3, 0.5), "height": (0.5e-3, 60e-3), "stiffening": (0.1, 4.0),
        "contact_fraction": (0.15, 1.0),
    },
    "Cost": {"area": (0.05, 200.0)},
    "ConditionFactor": {"factor": (0.05, 1.3)},
    "GrippingPulley": {"distance": (0.3, 500.0)},
    "Transition": {
        "length": (0.2, 20.0), "trough_angle": (math.radians(5.0), math.radians(70.0)),
        "centre_roll": (0.05, 2.0),
    },
    "Across": {"misalignment": (-0.01, 0.01), "deflection": (-5e-3, 5e-3)},
    "Motor": {
        "gear_ratio": (1.0, 250.0), "gear_efficiency": (0.6, 1.0), "motor_efficiency": (0.5, 1.0),
        "droop": (1e-3, 0.15), "torque_limit": (0.8, 4.0), "breakdown_ratio": (1.5, 5.0),
    },
    "TorqueFollower": {"ratio": (0.1, 5.0)},
}  # fmt: skip
#: Largest deviations across the width [m], and friction that laggings have [-]: up to 1.55 of
#: ceramic at the lowest pressures (DeVries 2026), 0.1 of wet and muddy bare steel (DIN 22101).
_PROFILES = {"shell_profile": 15e-3, "worn_depth": 25e-3, "build_up": 30e-3}
_FRICTION = (0.03, 1.9)
#: Names, dimensions and ends of what a law was tested in.
_TESTED: dict[str, tuple[str, Dimension, Ends]] = {
    "pressure_min": ("minimum tested pressure", "pressure", (0.5e3, 2e6)),
    "pressure_max": ("maximum tested pressure", "pressure", (10e3, 10e6)),
    "slip_max": ("maximum tested slip", "length", (0.05e-3, 0.3)),
    "slip_speed": ("tested slip speed", "speed", (2e-6, 0.3)),
}


#: Density of steel [kg/m3], and modulus over rating of the stiffest fabric belts [-]; 119 is
#: published (Goodyear 2012).
STEEL, FABRIC = 7850.0, 250.0


class Owner(NamedTuple):
    """Something that is described: by which tables of `USUAL`, what of it is called, and where.

    `more` are tables besides.
    """

    of: Any
    kinds: tuple[str, ...]
    words: str
    place: Place = NOWHERE
    more: tuple[dict[str, Ends], ...] = ()


def usual_sizes(drive: Drive, *others: Owner) -> Iterator[Check]:
    """Check sizes, tensions and what they make together for a slip of unit.

    Parameters
    ----------
    drive
        What is described.
    others
        What else is, by the same table: the train, motors, what moves and what happens to it.
    """
    parts = [*_others(drive, others)]
    odd = {check.text: check for check in (*unusual_sizes(drive, bool(parts)), *parts)}
    yield from odd.values()
    if not odd:
        yield Check(name=USUAL_RULE.name, title=TITLE, noun="inputs", level=Level.OK, binding=False)


def least_margin(drive: Drive) -> float:
    """Return the least margin of sizes beside those of its arcs that are asked about [-].

    Infinite where there are none.
    """
    return min((check.margin for check in _others(drive, ())), default=math.inf)


def unusual_sizes(drive: Drive, odd: bool) -> Iterator[Check]:
    """Yield what is unusual of `USUAL_SIZES`; what is made of others only where they are not."""
    for case in drive.load_cases:
        for pulley in drive.in_case(case).pulleys:
            names = _names(pulley, case)
            values = compared_sizes(sizes_of(drive, case, pulley))
            for (name, dimension, place), value, (least, most) in zip(
                names, values, USUAL_SIZES, strict=True
            ):
                made = name in (_RATIO, _STRONG, _SAG) or name == _AT_RATING
                if not (usual(value, least, most) or (made and odd)):
                    size = drive.belt.width if dimension in _OVER_WIDTH else 1.0
                    odd = True
                    yield unusual(name, dimension, place, size * value, (size * least, size * most))


def _others(drive: Drive, others: tuple[Owner, ...]) -> Iterator[Check]:
    for owner in (*_owners(drive), *others):
        yield from _of_owner(owner)
        if owner.kinds in (_MOTOR, _TURNS):
            yield from _turning(drive, owner)
    yield from _motor_sizes(drive, [o.of for o in others if o.kinds == _MOTOR])
    if drive.conveyor is not None:
        yield from _conveyor_sizes(drive.conveyor, drive.belt.width)
    width = drive.belt.width
    for pulley in drive.pulleys:
        if pulley.mass is not None:
            solid = STEEL * 0.25 * math.pi * pulley.diameter**2 * width
            ends = 0.02 * solid, 1.5 * solid  # a thin drum, and with a shaft as long as two faces
            if not usual(pulley.mass, *ends):
                place = Place(pulley.name)
                yield unusual("pulley mass", "mass", place, pulley.mass, ends)
    rating, stiff = drive.belt.rating, drive.belt.modulus
    fabric = drive.belt.kind == "fabric" and rating and usual(rating, *USUAL_SIZES[11])
    if fabric and rating and not usual(stiff / rating, 0.0, FABRIC):
        yield unusual(_RATIO, "number", NOWHERE, stiff / rating, (15.0, FABRIC))
    for lagging in drive.laggings:
        yield from _law_sizes(lagging)


def _owners(drive: Drive) -> Iterator[Owner]:
    """Yield all that a drive is described by."""
    criteria = drive.criteria
    yield Owner(drive.belt, ("Belt",), "of the belt")
    yield Owner(criteria.take_up, ("TakeUp",), "of the take-up")
    yield Owner(criteria.standard, ("DesignStandard",), "of the design standard")
    yield Owner(criteria.safety, ("SafetyFactors",), "safety factor")
    yield Owner(criteria.sag, ("Sag",), "for the sag of the belt")
    yield from _conveyor_owners(drive.conveyor)
    for lagging in drive.laggings:
        of = f"of {lagging.name}"
        yield Owner(lagging, ("Lagging",), of)
        yield Owner(lagging.block, ("Block",), f"of the blocks {of}")
        yield Owner(lagging.cost, ("Cost",), f"that the cost {of} is for")
        for name, factor in lagging.condition_factors.items():
            yield Owner(factor, ("ConditionFactor",), f"on the friction {of}, {name}")
    for pulley in drive.pulleys:
        place, of = Place(pulley.name), f"of pulley {pulley.name}"
        if pulley.across is not None:
            yield Owner(pulley.across, ("Across",), of, place)
            yield Owner(pulley.across.before, _NEIGHBOUR, f"before pulley {pulley.name}", place)
            yield Owner(pulley.across.after, _NEIGHBOUR, f"behind pulley {pulley.name}", place)


def _conveyor_owners(conveyor: Conveyor | None) -> Iterator[Owner]:
    """Yield all that a conveyor is described by."""
    yield Owner(conveyor, ("Conveyor",), "of the conveyor")
    if conveyor is None:
        return
    for flight in conveyor.flights:
        yield Owner(flight, ("Flight",), f"of flight {flight.name}")
    for point in conveyor.loadings:
        yield Owner(point, ("LoadingPoint",), f"of loading point {point.name}")
    for local in conveyor.locals:
        yield Owner(local, ("Local",), "of a resistance")
    yield Owner(conveyor.travel, ("Travel",), "of the take-up travel")
    yield Owner(conveyor.cema, ("Cema",), "of CEMA")


def _of_owner(owner: Owner) -> Iterator[Check]:
    """Yield what of one thing is unusual."""
    of, limits = owner.of, getattr(owner.of, "LIMITS", None) or {}
    tables = [*owner.more, *(USUAL.get(kind, {}) for kind in owner.kinds)]
    for key, limit in limits.items():
        ends, value = next((t[key] for t in tables if key in t), None), getattr(of, key)
        if ends and value and not usual(value, *ends):
            name = f"{key.replace('_', ' ')} {owner.words}".rstrip()
            yield unusual(name, limit.dimension, owner.place, value, ends)
    for happening in getattr(of, "happenings", None) or ():
        if happening.at >= of.duration:
            check = unusual("start", "time", NOWHERE, happening.at, (0.0, of.duration))
            headline = f"Event {escaped(of.name)} starts at {{value}}, after the end {{limit}}"
            yield replace(check, headline=headline, action="Give an earlier time.")
    if "Across" in owner.kinds:
        for key, most in _PROFILES.items():
            profile = getattr(of, key)
            heights = () if profile is None else (profile.largest, -min((*profile.value, 0.0)))
            if max(heights, default=0.0) > most:
                name = f"{key.replace('_', ' ')} {owner.words}".rstrip()
                yield unusual(name, "length", owner.place, max(heights), (0.0, most))


def _law_sizes(lagging: Lagging) -> Iterator[Check]:
    """Yield what is unusual of a friction law: what it was tested in, and how much it is there."""
    tested, of = lagging.law.tested, f"lagging {lagging.name}"
    if lagging.condition != "dry":
        of += f", {lagging.condition}"
    odd = False
    for key, (name, dimension, ends) in _TESTED.items():
        value = getattr(tested, key, None)
        if value is not None and not usual(value, *ends):
            odd = True
            yield unusual(f"{name} of {of}", dimension, NOWHERE, value, ends)
    if odd:
        return
    pressures, slip = [100e3], 10e-3
    if tested is not None:
        pressures, slip = [tested.pressure_min, tested.pressure_max], tested.slip_max
    law = lagging.law.compact()
    for friction in [available(law, slip, pressure) for pressure in pressures]:
        if not usual(friction, *_FRICTION):
            yield unusual(f"friction of {of}", "number", NOWHERE, friction, _FRICTION)
            return


def owners_of(train: Train) -> Iterator[Owner]:
    """Yield the motors of a train, or the speeds that its drums are given, and its conveyor."""
    yield from _conveyor_owners(train.conveyor)
    division = train.cases[0].division
    if isinstance(division, Speeds) and division.absolute:
        for pulley, turns in zip(train.pulleys, division.rotation_speeds, strict=True):
            yield Owner(turns, _TURNS, "", Place(pulley.name))
    for pulley, motor in zip(
        train.pulleys, division.motors if isinstance(division, Motors) else (), strict=False
    ):
        kinds = _MOTOR if isinstance(motor, Motor) else ("TorqueFollower",)
        yield Owner(motor, kinds, f"of the motor of pulley {pulley.name}", Place(pulley.name))


#: What may stand before and behind a pulley whose load is uneven.
_NEIGHBOUR = ("Transition", "GrippingPulley")
#: What turns a drum: a motor, or a speed that it is given.
_MOTOR, _TURNS = ("Motor",), ("Speed",)


def _turning(drive: Drive, owner: Owner) -> Iterator[Check]:
    """Yield what is unusual of a motor, and of a speed that does not fit that of the belt."""
    motor, pulley, power, speed = owner.of, drive.pulley(owner.place.pulley), math.nan, math.nan
    turns, action = motor, "Check train.speeds, diameter, belt speed."
    if isinstance(motor, Motor):
        power, speed = motor.rated_power, motor.rated_speed
        setting = motor.setting if isinstance(motor, VariableSpeed) else 1.0
        turns = setting * speed / motor.gear_ratio
        action = "Check gear_ratio, rated_speed, diameter, belt speed."
    belt = math.nan if drive.belt.speed is None else drive.belt.speed
    radius = pulley.radius + (pitch_offset(drive.belt, pulley.side) or 0.0)
    values = compared_motor(power, speed, turns, radius, belt)
    for (name, dimension), value, ends in zip(_MOTOR_NAMES, values, USUAL_MOTORS, strict=True):
        if not usual(value, *ends):
            check = unusual(name, dimension, owner.place, value, ends)
            if name == _FITS:
                check = replace(
                    check,
                    headline="Pulley speed {drum} does not match belt speed {belt}",
                    action=action,
                    full="The speed of the pulley was used.",
                    more={"drum": Amount(turns * radius, "speed"), "belt": Amount(belt, "speed")},
                )
            yield check


def _motor_sizes(drive: Drive, motors: Sequence[Motor]) -> Iterator[Check]:
    """Yield that motors are far too large for every pull; that they are too small is a check."""
    pulls = [
        abs(case.tensions[drive.pulleys[0].name].entry - case.tensions[drive.pulleys[-1].name].exit)
        for case in drive.load_cases
    ]
    needed = max(pulls) * (drive.belt.speed or math.nan)
    rated = sum(motor.count * motor.rated_power for motor in motors)
    if rated and needed and not usual(rated / needed, 0.0, LARGE_MOTORS):
        yield unusual(_LARGE, "number", NOWHERE, rated / needed, (0.0, LARGE_MOTORS))


_FITS = "pulley speed over belt speed"
_MOTOR_NAMES: tuple[tuple[str, Dimension], ...] = (
    ("rated motor power", "power"),
    ("rated motor speed", "rotation_speed"),
    (_FITS, "number"),
)


def _conveyor_sizes(of: Conveyor, width: float) -> Iterator[Check]:
    """Yield what is unusual of a conveyor; what is made of its sizes only where they are usual."""
    odd = False
    for value, (key, *ends) in zip(of.sizes(), USUAL_CONVEYOR, strict=True):
        least, most = (end * (width if key in OVER_WIDTH else 1.0) for end in ends)
        if not usual(value, least, most):
            odd = True
            name = f"conveyor {key.replace('_', ' ')}"
            dimension = Conveyor.LIMITS[key].dimension
            yield unusual(name, dimension, NOWHERE, value, (least, most))
    least, most = (float(f"{end * width**2:.2g}") for end in (EMPTIEST, FULLEST))
    load, slope = (least, most), of.lift / of.length
    if not (odd or usual(of.material, *load)):
        yield unusual(_HEAPED, "mass_per_length", NOWHERE, of.material, load)
    if not (odd or usual(slope, -STEEPEST, STEEPEST)):
        yield unusual(_STEEP, "number", NOWHERE, slope, (-STEEPEST, STEEPEST))


def unusual(
    name: str, dimension: Dimension, place: Place, value: float, ends: tuple[float, float]
) -> Check:
    """Return the check that a value [SI] outside its usual ends misses."""
    least, most = ends
    small = least if least > 0.0 else 0.1 * most  # nothing is meant that is next to nothing
    meant = " or ".join(meant_by(value, dimension, small, most))
    # named also here: it may stand under a check that this size makes fail
    action = f"Check the unit of {name}{f': {meant}?' if meant else '.'}"
    if dimension == "number":
        near = next((n for n in (0.1, 10.0, 0.01, 100.0) if least <= n * value <= most), None)
        action = f"Check {name}{'.' if near is None else f': {near * value:.3g}?'}"
    if name == _WRAP and value > most:
        action = "Give each pulley its own wrap."
    if name in _CHECKED:
        action = f"Check {_CHECKED[name]}."
    usual_ends = Cell(most, dimension, form="to", other=least)
    headline = f"{name[:1].upper()}{name[1:]} {{value}} is outside the usual {usual_ends}"
    if name == _WRAP and value > most:
        headline = "Wrap {value} exceeds {limit} on one pulley"
    return Check(
        name=USUAL_RULE.name,
        title=TITLE,
        noun=name,
        level=USUAL_RULE.missed,
        place=place,
        value=value,
        limit=most if value > most else least,
        dimension=dimension,
        at_most=value > most,
        source="sizes that conveyor drives have",
        label="implausible input",
        headline=headline,
        action=escaped(action),
        binding=False,
    )


#: Dimensions of sizes that are compared over the width of the belt.
_OVER_WIDTH = ("force", "mass_per_length")
_MASS = "belt mass"
_HEAPED = "material per length of belt"
_LARGE, _STEEP = "motor power over required power", "conveyor lift over length"
_WRAP = "wrap"
_AT_RATING = "wrap pressure at the belt rating"
_SAG = "tension for sag"
_STRONG = "belt strength over rating"
_RATIO = "belt modulus over rating"
#: What is checked of sizes that are made of several inputs.
_CHECKED = {
    _AT_RATING: "diameter and belt.rating",
    _STRONG: "belt.strength and belt.rating: both per width",
    _RATIO: "belt.modulus and belt.rating: both per width",
    _MASS: "belt.mass: per length of belt",
    _LARGE: "rated_power of the motors, Te, belt speed",
    _HEAPED: "capacity or material_mass of the conveyor, and belt.speed",
    _STEEP: "conveyor.lift and conveyor.length",
    _SAG: "idler_spacing, line_mass and share of [sag]",
}


def _names(pulley: Pulley, case: LoadCase) -> list[tuple[str, Dimension, Place]]:
    """Return what `compared_sizes` are called, in their order, what they measure and where."""
    belt, drum, at = Place(), Place(pulley.name), Place(pulley.name, case.name)
    return [
        ("belt width", "length", belt),
        ("belt modulus", "force_per_width", belt),
        ("belt speed", "speed", belt),
        ("diameter", "length", drum),
        (_WRAP, "angle", drum),
        (_WRAP, "angle", drum),
        ("creep limit", "length", drum),
        ("overrun", "length", drum),
        ("lagging thickness", "length", drum),
        ("shear modulus", "pressure", drum),
        ("compression modulus", "pressure", drum),
        ("belt rating", "force_per_width", belt),
        ("bond strength", "pressure", drum),
        ("fatigue limit", "pressure", drum),
        ("maximum wrap pressure of the belt", "pressure", belt),
        ("minimum pulley diameter of the belt", "length", belt),
        (_SAG, "force", belt),
        (_STRONG, "number", belt),
        (_RATIO, "number", belt),
        (_AT_RATING, "pressure", drum),
        ("entry tension", "force", at),
        ("exit tension", "force", at),
        ("power", "power", at),
        (_MASS, "mass_per_length", belt),
    ]


def sizes_of(drive: Drive, case: LoadCase, pulley: Pulley) -> Sizes[float]:
    """Return what is given of belt, pulley and lagging in a load case."""
    belt, lagging, sag = drive.belt, pulley.lagging, drive.criteria.sag
    tensions = case.tensions[pulley.name]

    idle = idles(tensions.entry, tensions.exit)

    def known(value: float | None) -> float:
        return math.nan if value is None else value

    return Sizes(
        width=belt.width,
        modulus=belt.modulus,
        speed=known(belt.speed),
        diameter=pulley.diameter,
        idle_wrap=pulley.wrap_angle if idle else math.nan,
        wrap_angle=math.nan if idle else pulley.wrap_angle,
        creep_limit=drive.creep_limit_of(pulley),
        overrun=known(pulley.overrun),
        thickness=lagging.thickness,
        shear_modulus=lagging.shear_modulus,
        compression_modulus=lagging.compression_modulus,
        rating=known(belt.rating),
        strength=known(belt.breaking_strength),
        bond_strength=known(lagging.bond_strength),
        fatigue_limit=known(lagging.fatigue_limit),
        face_pressure=known(belt.largest_wrap_pressure),
        least_diameter=known(belt.least_pulley_diameter),
        sag=known(None if sag is None else sag.tension),
        entry=tensions.entry,
        leaving=tensions.exit,
        pull=math.nan if idle or len(drive.pulleys) > 1 else tensions.effective,
        mass=known(belt.mass),
    )
