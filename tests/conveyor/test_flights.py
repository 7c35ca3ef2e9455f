"""A conveyor of several flights against `slow_course`, which marches along the belt by itself."""

import math
from dataclasses import replace
from typing import Any

import pytest

from conveyor.slow_course import STEP, Bend, G, Loop, Part
from wraparc import InputError
from wraparc.conveyor import (
    Cema,
    CleanerResistance,
    Conveyor,
    ConveyorCase,
    DrivePlace,
    Flight,
    LoadingPoint,
    PointResistance,
    PulleyResistance,
    State,
    Travel,
    cema_pull,
    curves,
    sags,
    travel_of,
)

BELT, MATERIAL, CARRY, RETURN = 28.0, 110.0, 17.0, 6.5
FLIGHTS = (
    Flight(name="plain", length=700.0, lift=5.0),
    Flight(name="down", length=400.0, lift=-12.0, friction_factor=0.016, curve_radius=500.0),
    Flight(name="ramp", length=300.0, lift=24.0, curve_radius=200.0),
)
LENGTH = 1400.0


def conveyor(**more: Any) -> Conveyor:
    given = {
        "length": LENGTH, "lift": 17.0, "belt_mass": BELT, "carry_idler_mass": CARRY,
        "return_idler_mass": RETURN, "material_mass": MATERIAL, "friction_factor": 0.02,
        "length_coefficient": 1.07, "take_up_tension": 60e3, "speed": 4.0, "flights": FLIGHTS,
        "drives": (DrivePlace(pulley="head"),), "start_factor": 1.4, "stop_time": 16.0,
    }  # fmt: skip
    return Conveyor(**{**given, **more})


def parts(*loads: float) -> tuple[Part, ...]:
    return tuple(
        Part(f.length, f.rise, load * MATERIAL, f.friction_factor or 0.02, CARRY, RETURN)
        for f, load in zip(FLIGHTS, loads, strict=True)
    )


def states(of: Conveyor) -> dict[str, State]:
    return {state.name: state for state in of.states()}


LOADS = {
    "full": (1, 1, 1), "empty": (0, 0, 0), "inclines": (1, 0, 1), "declines": (0, 1, 0),
    "heavy": (1, 1, 1.3), "start": (1, 1, 1), "stop": (1, 1, 1),
}  # fmt: skip
HEAVY = ConveyorCase(name="heavy", factor={"ramp": 1.3})


def main_resistance(loop: Loop) -> float:
    """What f and the masses make on both strands, of the slow twin without lift [N]."""
    level = replace(loop, acceleration=0.0, spread_carry=0.0)
    total = 0.0
    for k in range(round(2 * LENGTH / STEP)):
        place = (k + 0.5) * STEP
        lifted = replace(level, parts=tuple(replace(p, friction=0.0) for p in level.parts))
        total += (level.per_metre(place) - lifted.per_metre(place)) * STEP
    return total


ARRANGEMENTS = {
    "head": (((LENGTH, 1.0),), (DrivePlace(pulley="a"),), 0.0),
    "tandem, take-up at the tail": (
        ((LENGTH, 0.5), (LENGTH, 0.5)),
        (DrivePlace(pulley="a", share=0.5), DrivePlace(pulley="b", share=0.5)),
        LENGTH - 200.0,
    ),
    "head and tail": (
        ((LENGTH, 0.7), (2 * LENGTH, 0.3)),
        (DrivePlace(pulley="a", share=0.7), DrivePlace(pulley="b", at="tail", share=0.3)),
        0.0,
    ),
    "head and booster": (
        ((850.0, 0.25), (LENGTH, 0.75)),
        (
            DrivePlace(pulley="a", at="carry", position=850.0, share=0.25),
            DrivePlace(pulley="b", share=0.75),
        ),
        30.0,
    ),
}


@pytest.mark.parametrize("name", list(ARRANGEMENTS))
@pytest.mark.parametrize("case", ["full", "inclines", "heavy", "start", "stop"])
def test_every_drive_has_the_tensions_of_the_slow_march(name: str, case: str) -> None:
    """Steps of five metres from the take-up around, the pull by secants: `slow_course`."""
    places, drives, behind = ARRANGEMENTS[name]
    made = conveyor(drives=drives, take_up_distance=behind, cases=(HEAVY,), start_time=None)
    state = states(made)[case]
    loop = Loop(
        parts(*LOADS[case]), BELT, 60e3, LENGTH + behind,
        tuple((at % (2 * LENGTH), share) for at, share in places),
    )  # fmt: skip
    # a tail drive is met before the belt begins its way again
    spread = 0.07 * main_resistance(loop) / LENGTH
    acceleration = {"stop": -4.0 / 16.0}.get(case, 0.0)
    loop = replace(loop, spread_carry=spread, acceleration=acceleration)
    if case == "start":
        full = replace(loop, acceleration=0.0).solved()[0]
        moving = sum((BELT + p.material + CARRY + BELT + RETURN) * p.length for p in loop.parts)
        loop = replace(loop, acceleration=0.4 * full / moving)
    if behind == 0.0:  # the take-up is behind the drives at the head, which are met last
        loop = replace(loop, take_up_at=LENGTH)
    pull, tensions = loop.solved()
    assert state.pull == pytest.approx(pull, rel=1e-9)
    for drive, (before, after) in zip(state.drives, tensions, strict=True):
        assert drive.entry == pytest.approx(before, rel=1e-9)
        assert drive.exit == pytest.approx(after, rel=1e-9)


@pytest.mark.parametrize("name", list(ARRANGEMENTS))
def test_what_resists_is_what_the_drives_do(name: str) -> None:
    """The sum of resistances is that of the drives, and each flight closes, to 1e-9."""
    _, drives, behind = ARRANGEMENTS[name]
    items = (
        PulleyResistance(at="tail", diameter=0.8, shaft_diameter=0.14, mass=900.0),
        CleanerResistance(width=1.2, thickness=0.01, pressure=5e4),
        PointResistance(at="carry", position=500.0, force=800.0),
    )
    made = conveyor(
        drives=drives, take_up_distance=behind, cases=(HEAVY,), length_coefficient=None,
        locals=items, width=1.2, thickness=0.016,
    )  # fmt: skip
    for state in made.states():
        done = sum(drive.entry - drive.exit for drive in state.drives)
        assert done == pytest.approx(state.pull, rel=1e-9)
        assert sum(s.resistance for s in state.stretches) == pytest.approx(state.pull, rel=1e-9)
        for one, other in zip(state.stretches, (*state.stretches[1:], state.stretches[0]),
                              strict=True):  # fmt: skip
            grown = one.resistance - one.driven
            assert one.end - one.start == pytest.approx(grown, rel=1e-9, abs=1e-9 * 60e3)
            assert other.start == pytest.approx(one.end, rel=1e-9)


def test_pulleys_take_what_their_tension_makes_them_take() -> None:
    """Bending and bearings go by the mean tension of both sides: by bisection in the twin."""
    made = conveyor(
        length_coefficient=None, width=1.2, thickness=0.016,
        locals=(PulleyResistance(at="tail", diameter=0.8, shaft_diameter=0.14, mass=900.0),),
    )  # fmt: skip
    bend = Bend(0.0, 0.8, 0.14, 900.0)
    loop = Loop(
        parts(1, 1, 1), BELT, 60e3, LENGTH, ((LENGTH, 1.0),), bends=(bend,), width=1.2,
        thickness=0.016,
    )  # fmt: skip
    pull, tensions = loop.solved()
    full = states(made)["full"]
    assert full.pull == pytest.approx(pull, rel=1e-9)
    assert (full.entry, full.exit) == pytest.approx(tensions[0], rel=1e-9)


def test_loading_points_add_up_along_the_belt() -> None:
    """40 and 70 kg/m: the slope resistance of each part of the way by hand."""
    made = conveyor(
        material_mass=None, length_coefficient=1.0, friction_factor=0.005,
        loadings=(
            LoadingPoint(name="mine", material_mass=40.0),
            LoadingPoint(name="plant", position=900.0, material_mass=70.0),
        ),
    )  # fmt: skip
    by_name = {r.name: r for r in states(made)["full"].resistances}
    up = 40.0 * 5.0 + 40.0 * (-12.0 * 200 / 400) + 110.0 * (-12.0 * 200 / 400) + 110.0 * 24.0
    assert by_name["slope"].total == pytest.approx(G * up, rel=1e-12)
    assert made.material == 110.0


def test_material_that_lands_takes_its_speed_from_the_belt() -> None:
    """440 kg/s at 1 m/s onto 4 m/s: 1320 N; skirts 0.8 m apart by the formula of ISO 5048."""
    point = LoadingPoint(
        name="mine", material_mass=110.0, material_speed=1.0, skirt_width=0.8, density=1600.0,
    )  # fmt: skip
    made = conveyor(
        material_mass=None, length_coefficient=None, loadings=(point,),
        locals=(PointResistance(force=1.0),),
    )  # fmt: skip
    long = (4.0**2 - 1.0**2) / (2 * G * 0.5)
    volume = 440.0 / 1600.0
    rubbing = 0.7 * volume**2 * 1600.0 * G * long / (2.5**2 * 0.8**2)
    by_name = {r.name: r for r in states(made)["full"].resistances}
    assert by_name["loading"].total == pytest.approx(440.0 * 3.0 + rubbing, rel=1e-12)
    assert "loading" not in {r.name for r in states(made)["empty"].resistances if r.total}


def test_brakes_share_as_they_are_said_to() -> None:
    drives = (
        DrivePlace(pulley="a", share=0.7, brake_share=0.0),
        DrivePlace(pulley="b", at="tail", share=0.3, brake_share=1.0),
    )
    made = states(conveyor(drives=drives, stop_time=5.0))
    stop = made["stop"]
    assert stop.drives[0].entry == stop.drives[0].exit
    assert stop.drives[1].entry - stop.drives[1].exit == pytest.approx(stop.pull, rel=1e-9)
    assert made["full"].drives[0].share == 0.7


def test_sag_is_told_at_the_lowest_tension_of_each_flight() -> None:
    """m' g l/(8 T): the parabola, on the ramp of which the belt enters with its lowest tension."""
    made = conveyor(carry_spacing=1.2, return_spacing=3.0)
    by_place = {
        (s.stretch.flight, s.stretch.strand): s for s in sags(made, made.states(), running=False)
    }
    stop = states(made)["stop"]
    ramp = next(s for s in stop.stretches if s.flight == "ramp" and s.strand == "carry")
    cosine = math.sqrt(1 - (24 / 300) ** 2)
    worst = by_place["ramp", "carry"]
    assert worst.load_case == "stop"
    expected = (BELT + MATERIAL) * G * cosine * 1.2 / (8 * ramp.start)
    assert worst.share == pytest.approx(expected, rel=1e-12)
    assert len(by_place) == 6


def test_the_take_up_moves_by_half_of_what_the_belt_grows() -> None:
    """A level belt without friction but f: T rises linearly, so the mean tension is known."""
    made = Conveyor(
        length=1000.0, belt_mass=BELT, carry_idler_mass=CARRY, return_idler_mass=RETURN,
        material_mass=MATERIAL, length_coefficient=1.0, take_up_tension=50e3,
        travel=Travel(temperature_range=50.0, thermal_expansion=12e-6, permanent_elongation=1e-3,
                      splice_length=6.0),
    )  # fmt: skip
    by_name = states(made)
    grown = by_name["full"].pull - by_name["empty"].pull  # all of it on the carrying strand
    travel = travel_of(made, made.states(), 80e6)
    assert travel.elastic == pytest.approx(0.5 * (0.5 * grown * 1000.0) / 80e6, rel=1e-9)
    assert (travel.shortest, travel.longest) == ("empty", "full")
    assert (travel.thermal, travel.permanent, travel.splice) == pytest.approx((0.6, 1.0, 3.0))


def test_a_concave_curve_needs_its_tension_over_the_weight_of_the_belt() -> None:
    made = conveyor()
    found = {curve.flight: curve for curve in curves(made, made.states())}
    assert [curve.concave for curve in found.values()] == [False, True]
    worst = max(p.after for s in made.states() for p in s.points
                if p.kind == "flight" and p.name == "ramp" and p.strand == "carry")  # fmt: skip
    cosine = math.sqrt(1 - (24 / 300) ** 2)
    assert found["ramp"].least == pytest.approx(worst / (BELT * G * cosine), rel=1e-12)


def test_what_holds_a_belt_at_rest() -> None:
    """Inclines only: the load of 24 m and 5 m of lift less half of the main resistance."""
    made = conveyor(friction_factor=0.01)
    rest = states(made)["inclines"].standstill
    assert rest is not None
    assert rest.slope == pytest.approx(G * MATERIAL * 29.0, rel=1e-12)
    assert rest.holding(0.5) == pytest.approx(rest.slope - 0.5 * rest.friction)
    down = states(made)["declines"].standstill
    assert down is not None
    assert down.slope == pytest.approx(-G * MATERIAL * 12.0)
    assert down.holding(0.0) == pytest.approx(down.slope)
    assert down.holding(1.0) == pytest.approx(min(0.0, down.slope + down.friction))


def test_cema_has_the_pull_of_its_formula() -> None:
    """Te = L Kt (Kx + Ky Wb + 0.015 Wb) + Wm (L Ky + H) of one flight, in pounds and feet."""
    pound, foot = 4.4482216152605, 0.3048
    per_foot = pound / foot
    made = Conveyor(
        length=2000 * foot, lift=100 * foot, belt_mass=12 * per_foot / G,
        carry_idler_mass=CARRY, return_idler_mass=RETURN, material_mass=50 * per_foot / G,
        take_up_tension=40e3, carry_spacing=4 * foot,
        cema=Cema(idler_friction=1.5 * pound, ky=0.02, other=500 * pound),
    )  # fmt: skip
    kx = 0.00068 * (12 + 50) + 1.5 / 4
    expected = 2000 * (kx + 0.02 * 12 + 0.015 * 12) + 50 * (2000 * 0.02 + 100) + 500
    pull = cema_pull(made, states(made)["full"])
    assert pull is not None
    assert pull / pound == pytest.approx(expected, rel=1e-9)


def test_everything_that_does_not_fit_is_told_at_once() -> None:
    flights = (
        *FLIGHTS[:2],
        Flight(name="ramp", length=300.0, lift=24.0, slope=math.radians(9.0)),
    )
    with pytest.raises(InputError) as caught:
        conveyor(
            length=1500.0, lift=40.0, flights=flights, take_up_after="a", take_up_distance=20.0,
            drives=(DrivePlace(pulley="a", at="carry", position=2000.0),
                    DrivePlace(pulley="b", at="tail")),
            cases=(ConveyorCase(name="nothing", loaded=()),
                   ConveyorCase(name="odd", loaded=("rampe",))),
        )  # fmt: skip
    told = {p.key: p.message for p in caught.value.problems}
    assert told == {
        "length": "the flights make 1400 m",
        "lift": "the flights make 17 m",
        "flight[3].slope": "contradicts lift 24 m, it makes 46.93 m",
        "load_case[1].loaded": "loads no flight",
        "load_case[2].loaded": "no such flight",
        "drive[1].position": "is on no flight, the conveyor is 1500 m long",
        "take_up_distance": "is a second take-up, besides that after a pulley of [take_up]",
    }
