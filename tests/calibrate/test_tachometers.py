"""Tachometers before and behind a drum against the slow twin: moments, and the mass of the belt."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from arc.gauges import gauges
from shear_test.virtual import benchmark_module
from wraparc import Distributed, WrapArc
from wraparc.calibrate.calibration import Number, Problemset, calibrate
from wraparc.calibrate.field_numbers import field_numbers
from wraparc.calibrate.problem import OPEN_ZERO
from wraparc.drive import Tensions
from wraparc.drive.changes import with_pulley

BENCH = benchmark_module("calibrate_speeds")
described = BENCH.described

DRIVES = {
    "driving": lambda: described("head-drive-fabric"),
    "braking": lambda: described("downhill-braking"),
    "carry side of an S-wrap": lambda: described("head-drive-fabric", side="carry"),
    "steel cord": lambda: described("steel-cord-drive"),
    "heavy and fast": lambda: replace(
        (d := described("head-drive-fabric")), belt=replace(d.belt, mass=60.0, speed=7.5)
    ),
}


@pytest.mark.parametrize("name", list(DRIVES))
def test_field_levels_are_what_the_gauges_of_the_twin_read(name: str) -> None:
    """To 1e-5 of the creep: both solvers integrate the same equations of the arc."""
    drive = DRIVES[name]()
    arcs = {c.name: WrapArc.of(drive, drive.pulleys[0], c) for c in drive.load_cases}
    results = {n: Distributed(capacities=False).solve(arc) for n, arc in arcs.items()}
    shown = field_numbers(results, {}, {}, coefficient=None, depth=6e-3).shown
    assert shown is not None
    for case, arc in arcs.items():
        read = gauges(arc)
        for at, speed in zip(shown[case], (read.before, read.behind), strict=True):
            assert at == pytest.approx(1.0 - speed / read.surface_speed, abs=1e-7), (case, at)


def record(arc: WrapArc, nip: str, **more: Any) -> Number:
    read = gauges(arc)
    speed = read.before if nip == "entry" else read.behind
    value = 1.0 - speed / read.surface_speed
    return Number(quantity=f"{nip}_creep_ratio", value=value, sd=5e-5, apparent=True, **more)


@pytest.mark.parametrize("name", list(DRIVES))
@pytest.mark.parametrize("nip", ["entry", "exit"])
@pytest.mark.parametrize("zeroed", [True, False])
def test_friction_comes_back_from_speeds_without_noise(name: str, nip: str, zeroed: bool) -> None:
    drive = DRIVES[name]()
    on, case = drive.pulleys[0], drive.load_cases[0]
    law = on.lagging.law.scaled(0.9, 1.0)
    true = with_pulley(drive, replace(on, lagging=replace(on.lagging, law=law)))
    arc = WrapArc.of(true, true.pulleys[0], case)
    slack = min(arc.entry_tension, arc.exit_tension)
    idling = Tensions(entry=1.05 * slack, exit=slack)
    idle = replace(arc, entry_tension=idling.entry, exit_tension=idling.exit)
    zero = record(idle, nip, load_case=case.name, tensions=idling) if zeroed else None
    number = record(arc, nip, load_case=case.name)
    found = calibrate(
        Problemset(
            drive=drive, pulley=on.name, parameters=("friction",), zero=zero,
            numbers=(number, zero) if zero else (number,),
            errors={"speed_zero": OPEN_ZERO if zero else 1e-4},
        )
    )  # fmt: skip
    assert found.estimates[0].value == pytest.approx(0.9, rel=2e-3)
    if zero:
        assert found.offset == pytest.approx(arc.offset, abs=1e-6)


def test_behind_the_drum_the_recovery_of_the_lagging_moves_its_surface_not_the_belt() -> None:
    """The surface below the leaving belt has risen to R - delta2 + e; creep is g2 = g + dT/EA'.

    Both ways come to one speed but for squares: with k dT the recovery and eps = T/EA, the belt is
    faster by k dT (1 - R/(R - delta1 + e)) + [(k dT)^2 + g2^2 - g^2 + eps1^2 - eps2^2]/2.
    """
    drive = DRIVES["driving"]()
    for case in (drive.load_case("design"), drive.load_case("start")):
        arc = WrapArc.of(drive, drive.pulleys[0], case)
        result = Distributed(capacities=False).solve(arc)
        g, g2 = result.entry_creep_ratio, result.exit_creep_ratio
        delta = arc.compression_compliance * arc.wrap_pressure(arc.exit_tension)
        by_surface = (arc.radius - delta + arc.offset) * (1.0 - g2)
        eps1, eps2 = (t / arc.axial_stiffness for t in (arc.entry_tension, arc.exit_tension))
        risen = arc.recovery_compliance * arc.effective_tension
        assert risen > 5e-4
        squares = risen * (1.0 - arc.radius / arc.pitch_radius)
        squares += 0.5 * (risen**2 + g2**2 - g**2 + eps1**2 - eps2**2)
        faster = gauges(arc).behind / by_surface - 1.0
        assert squares > 5e-5
        assert faster == pytest.approx(squares, rel=0.02)
