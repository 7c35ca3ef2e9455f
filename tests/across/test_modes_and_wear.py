"""The fast screening by modes, the shares of defects, and wear that feeds back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from across.wides import CORD, FABRIC, braking, mode, wide
from wraparc import load_drive
from wraparc.across import (
    CAUSES,
    AcrossSolver,
    WearHistory,
    WideArc,
    march_wear,
    mode_response,
    screen,
    solve_across,
)
from wraparc.arc import WrapArc
from wraparc.arrays import Array
from wraparc.drive import Across, GrippingPulley, Transition, WidthProfile
from wraparc.errors import ConvergenceError
from wraparc.friction import Constant

EXAMPLES = Path(__file__).parents[2] / "examples"


def _deviating(given: WideArc, cause: str, profile: Array) -> WideArc:
    if cause == "lagging":
        return given.worn(-profile)
    key = "radius_deviation" if cause == "radius" else cause
    return replace(given, **{key: profile})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("arc", "amplitude"),
    [
        (replace(CORD, overrun=None), 1e-5),
        (braking(FABRIC), 1e-5),
        (replace(FABRIC, recovery=False), 1e-5),
    ],
    ids=["cord with an overrun", "braking", "no recovery"],
)
def test_small_deviations_are_the_modes(arc: WrapArc, amplitude: float) -> None:
    """Source: the scalar equations of a mode, against all strips."""
    n, number = 7, 2
    given = wide(arc, n)
    modes = mode_response(given, 4)
    shape = mode(number, n)
    for cause in CAUSES:
        size = amplitude * (1e7 if cause == "entry_profile" else 1.0)
        found = AcrossSolver(1e-9).solve(_deviating(given, cause, size * shape))
        j = CAUSES.index(cause)
        for got, table in (
            (found.entry_tension, modes.entry_tension),
            (found.exit_tension, modes.exit_tension),
            (found.exit_creep, modes.exit_creep),
            (found.frictional_energy, modes.energy),
        ):
            by_unit = float(shape @ (got - np.mean(got))) * 2.0 / n / size
            scale = float(np.max(np.abs(table[:, j])))
            assert by_unit == pytest.approx(table[number - 1, j], abs=1e-5 * scale)


def test_what_is_not_linear_falls_as_the_square() -> None:
    """Source: the second order of a smooth problem."""
    given, shape = wide(FABRIC, 6), mode(1, 6)
    slope = mode_response(given, 1).entry_tension[0, CAUSES.index("radius")]

    def miss(size: float) -> float:
        found = AcrossSolver().solve(_deviating(given, "radius", size * shape))
        got = float(shape @ found.entry_tension) / 3.0 / size
        return abs(got / float(slope) - 1.0)

    assert miss(0.8e-3) / miss(0.4e-3) == pytest.approx(4.0, rel=0.1)


def test_levelling_depth_of_driving_and_braking() -> None:
    """Source: D_1 is about 0.7 (0.64-0.82) of the exit creep per radian of wrap."""
    driving = mode_response(wide(FABRIC, 6), 4)
    even = AcrossSolver().solve(wide(FABRIC, 4))
    by_creep = float(even.exit_creep[0]) / FABRIC.wrap_angle
    assert 0.6 < driving.levelling_depth[0] / by_creep < 0.85
    assert np.all(np.diff(driving.levelling_depth) > 0.0)
    assert np.all(mode_response(wide(braking(FABRIC), 6), 4).levelling_depth < 0.0)


@pytest.fixture(scope="module")
def healing() -> WearHistory:
    given = wide(replace(FABRIC, wear_coefficient=5e-11, belt_speed=3.0), 4)
    return march_wear(given.worn(2e-5 - 2e-5 * mode(1, 4)), 0.5e-3)


def test_wear_levels_a_driving_pulley(healing: WearHistory) -> None:
    """Source: exp(-w/D_1) of the mode equations, within 1 %."""
    depth = mode_response(healing.wide, 1).levelling_depth[0]
    left = (mode(1, 4) @ healing.thickness[-1]) / (mode(1, 4) @ healing.thickness[0])
    assert healing.mean_depth[-1] == pytest.approx(0.5e-3)
    assert left == pytest.approx(np.exp(-0.5e-3 / depth), rel=0.01)
    assert healing.heals
    assert not healing.ended


def test_wear_takes_its_time(healing: WearHistory) -> None:
    """Source: depth a pass is the wear coefficient times the mean energy, one pass a turn."""
    energy = float(np.mean(healing.energy))
    passes = 0.5e-3 / (5e-11 * energy)
    assert healing.passes[-1] == pytest.approx(passes, rel=0.01)
    speed = healing.wide.arc.belt_speed
    assert speed is not None
    assert healing.hours[-1] == pytest.approx(passes * np.pi * 0.8 / speed / 3600.0, rel=0.01)
    middle = float(np.min(healing.thickness[1]))
    assert healing.hours_to(middle) == pytest.approx(healing.hours[1], rel=1e-9)
    assert np.isnan(healing.hours_to(1e-3))


def test_wear_runs_away_on_a_braking_pulley() -> None:
    """Source: exp(-w/D_1) with a negative D_1, within 1 %."""
    given = wide(braking(FABRIC), 4).worn(2e-5 - 2e-5 * mode(1, 4))
    history = march_wear(given, 0.4e-3)
    depth = mode_response(given, 1).levelling_depth[0]
    grown = (mode(1, 4) @ history.thickness[-1]) / (mode(1, 4) @ history.thickness[0])
    assert grown == pytest.approx(np.exp(-0.4e-3 / depth), rel=0.01)
    assert not history.heals


def test_grit_in_a_zone_and_the_least_thickness() -> None:
    """A strip of twice the wear coefficient wears twice as deep at first; the march stops."""
    given = wide(FABRIC, 4)
    grit = 5e-11 * np.array([1.0, 1.0, 1.0, 2.0])
    history = march_wear(given, 4e-3, coefficient=grit, least_thickness=11e-3)
    off = history.thickness[0] - history.thickness[1]
    assert 1.5 < off[3] / off[0] < 2.0
    assert "minimum thickness" in history.ended
    assert np.min(history.thickness) >= 11e-3


def test_stationary_shape_wears_evenly() -> None:
    """Source: the lagging of the stationary shape under its cause has even energy."""
    n = 6
    given, shape = wide(FABRIC, n), mode(1, n)
    cause = 500.0 * shape
    height = mode_response(given, 1).stationary_lagging("entry_profile")[0] * cause
    found = AcrossSolver().solve(replace(given, entry_profile=cause).worn(-height))
    alone = AcrossSolver().solve(replace(given, entry_profile=cause))
    assert abs(shape @ found.frictional_energy) < 0.02 * abs(shape @ alone.frictional_energy)
    assert np.ptp(found.entry_tension) > np.ptp(alone.entry_tension)


def test_shares_add_up_to_what_the_strips_say() -> None:
    """Source: the strips, to the second order of small defects."""
    drive = load_drive(EXAMPLES / "head-drive-fabric.toml")
    across = Across(
        shell_profile=WidthProfile(crown=0.1e-3),
        worn_depth=WidthProfile(position=(-0.6, 0.0, 0.6), value=(0.0, 1e-4, 0.0)),
        build_up=WidthProfile(position=(0.2, 0.6), value=(0.0, 1e-4)),
        misalignment=2e-4,
        deflection=1e-4,
        entry_profile=WidthProfile(position=(-0.6, 0.6), value=(-500.0, 500.0)),
        before=Transition(length=9.0, trough_angle=0.6, centre_roll=0.465),
        after=GrippingPulley(distance=3.0),
        strips=9,
    )
    pulley = replace(drive.pulleys[0], across=across)
    drive = replace(drive, pulleys=(pulley,))
    found = screen(drive, pulley, drive.load_cases[0])
    names = {share.name for share in found.shares}
    assert names == {
        "shell_profile", "worn_depth", "build_up", "misalignment", "deflection",
        "entry_profile", "before",
    }  # fmt: skip
    assert found.band[0] < found.entry_unevenness < found.band[1]
    strips = solve_across(drive)
    together = np.sum([s.entry_tension for s in found.shares], axis=0)
    deviation = strips.entry_tension - np.mean(strips.entry_tension)
    assert together == pytest.approx(deviation, abs=0.02 * float(np.max(np.abs(deviation))))


def test_no_modes_of_a_belt_that_breaks_away() -> None:
    arc = replace(FABRIC, exit_tension=5e3, law=Constant(friction_coefficient=0.3))
    with pytest.raises(ConvergenceError, match="Gross slip"):
        mode_response(wide(arc, 4), 2)
