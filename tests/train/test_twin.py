"""Trains against an independent solver, slow and readable.

Expected values: tests/arc/twin.py (SciPy's DOP853 on creep and tension, laws written out again);
speeds to shares by Brent's method on the tension between the drums, with nothing shared with
wraparc.train.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq

from arc.twin import Twin
from train.trains import case, held, pulleys, random_train, solved, train, tried
from wraparc.arc import WrapArc
from wraparc.train import CaseResult, Shares, Speeds

LAWS = ["rubber", "softening", "table"]


def log_surface_speed(arc: WrapArc, near: float) -> float:
    """ln(v_surface/v0) at the entry: belt strain and the twin's creep ratio."""
    g, _ = Twin(arc).solve_near(near)
    return math.log1p(arc.entry_tension / arc.axial_stiffness) - math.log1p(-g)


def log_drum_speed(arc: WrapArc, near: float) -> float:
    delta = arc.thickness / arc.compression_modulus * arc.entry_pressure
    return log_surface_speed(arc, near) - math.log(arc.diameter / 2.0 - delta)


@pytest.mark.parametrize("law", LAWS)
def test_speeds_of_given_shares(law: str) -> None:
    rng = np.random.default_rng([3, LAWS.index(law)])
    done = 0
    while done < 4:
        result = tried(random_train(rng, law, 3))
        if not result.status.solved:
            continue
        arcs = [m.arc for m in result]
        logs = [log_drum_speed(a.arc, a.entry_creep_ratio) for a in arcs]
        for m, own in zip(result, logs, strict=True):
            ratio = math.exp(own - logs[0])
            assert m.rotation_speed / result.members[0].rotation_speed == pytest.approx(
                ratio, abs=2e-8
            )
        done += 1


def share_by_brent(result: CaseResult, trim: float) -> float:
    """Share of the second drum of a tandem at a ratio of drum speeds."""
    one, two = (m.arc.arc for m in result)
    near = [m.arc.entry_creep_ratio for m in result]

    def miss(between: float) -> float:
        first = replace(one, exit_tension=between)
        second = replace(two, entry_tension=between)
        speeds = log_drum_speed(first, near[0]), log_drum_speed(second, near[1])
        return speeds[1] - speeds[0] - math.log(trim)

    start = two.entry_tension
    between = float(brentq(miss, 0.85 * start, 1.15 * start, xtol=1e-4))
    return (between - two.exit_tension) / (one.entry_tension - two.exit_tension)


@pytest.mark.parametrize("law", ["rubber", "softening"])
@pytest.mark.parametrize("trim", [0.996, 0.998])
def test_shares_of_given_speeds(law: str, trim: float) -> None:
    of = train(pulleys(2, law), case(Speeds((1.0, trim))))
    result = solved(of)
    assert result["p2"].share == pytest.approx(share_by_brent(result, trim), abs=2e-6)


def test_shares_of_given_speeds_with_overruns_towards_travel() -> None:
    of = train(pulleys(2, "rubber", overrun=-5e-5), case(Speeds((1.0, 0.997))))
    result = solved(of)
    assert result["p2"].share == pytest.approx(share_by_brent(result, 0.997), abs=2e-6)


def test_sensitivity_is_the_slope_of_the_twin() -> None:
    of = train(pulleys(2, "rubber"), case(Shares((0.5, 0.5))))
    result = solved(of)
    trim, step = result["p2"].speed_trim, 2e-4
    up, down = (share_by_brent(result, trim + s) for s in (step, -step))
    slope = (up - down) / (2.0 * step / trim)
    assert result.sensitivity[1][1] == pytest.approx(slope, rel=1e-3)
    again = solved(held(of, result))
    assert again.sensitivity[1][1] == pytest.approx(result.sensitivity[1][1], rel=1e-3)
