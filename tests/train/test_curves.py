"""Curves, marks, maps and what-ifs of trains.

Expected values: the same train solved afresh at the place in question (the slow way).
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from train.trains import FABRIC, QUICK, STEEL, case, lagging, pulleys, solved, train
from wraparc.drive import Belt
from wraparc.errors import InputError
from wraparc.train import (
    Axis,
    MarkKind,
    Motors,
    ShareCurve,
    Shares,
    Speeds,
    TrainResult,
    VariableSpeed,
    match_drives,
    share_curve,
    share_map,
    solve_train,
    what_if,
)

EQUAL = Shares((0.5, 0.5))


@cache
def tandem(law: str = "rubber", belt: Belt = FABRIC, overrun: float | None = None) -> TrainResult:
    of = pulleys(2, law, diameter=0.8 if belt is FABRIC else 1.0, overrun=overrun)
    return solve_train(train(of, case(EQUAL), belt=belt), method=QUICK)


def afresh(curve: ShareCurve, value: float) -> tuple[float, ...]:
    """Shares at a value of a curve, solved from nothing."""
    old, drive = curve.train.cases[0], curve.drive
    here = float(next(m.value for m in curve.marks if m.kind is MarkKind.OPERATING))
    speeds = [m.speed_trim / d for m, d in zip(curve.case, curve.train.nominal, strict=True)]
    of, given = curve.train.pulleys, old
    if curve.axis is Axis.TRIM:
        speeds[drive] *= value / here
    elif curve.axis is Axis.DIAMETER:
        wide = replace(of[drive], diameter=of[drive].diameter * value / here)
        of = (*of[:drive], wide, *of[drive + 1 :])
    else:
        given = replace(given, entry_tension=old.exit_tension + value * old.effective_tension)
    given = replace(given, division=Speeds(tuple(speeds)))
    return solved(replace(curve.train, pulleys=of, cases=(given,))).shares


@pytest.mark.parametrize("axis", list(Axis))
@pytest.mark.parametrize("law", ["rubber", "softening", "constant"])
def test_a_curve_is_the_train_solved_afresh(axis: Axis, law: str) -> None:
    curve = share_curve(tandem(law, overrun=0.0), axis=axis, points=9)
    for i in (0, 3, 6, 8):
        # shares of a small load are large numbers: compare parts of the full load
        full = curve.values[i] if axis is Axis.LOAD else 1.0
        if np.isfinite(curve.shares[i, 0]):
            expected = np.array(afresh(curve, curve.values[i]))
            assert full * curve.shares[i] == pytest.approx(full * expected, abs=2e-5)
    there = np.isfinite(curve.shares[:, 0])
    assert there.sum() >= 7
    loads = curve.values[there] if axis is Axis.LOAD else 1.0
    assert loads * (curve.shares[there].sum(axis=1) - 1.0) == pytest.approx(0.0, abs=1e-6)


def test_marks_are_where_they_say() -> None:
    curve = share_curve(tandem(), points=11)
    (equal,) = curve.at(MarkKind.EQUAL)
    assert equal == pytest.approx(curve.case["p2"].speed_trim, abs=1e-6)
    for mark in curve.marks:
        shares = afresh(curve, mark.value)
        assert mark.shares == pytest.approx(shares, abs=5e-5)
        if mark.kind is MarkKind.UNLOADED:
            assert shares[mark.drive] == pytest.approx(0.0, abs=5e-5)
    limits = [m for m in curve.marks if m.kind is MarkKind.CREEP_LIMIT]
    assert [m.drive for m in limits] == [0, 1], "the slower drum sheds its load to the other"
    for mark in limits:
        at = replace(
            curve.train,
            cases=(replace(curve.train.cases[0], division=Speeds((1.0, mark.value))),),
        )
        creep = solved(at).members[mark.drive].arc.exit_creep
        assert creep == pytest.approx(6.35e-3, rel=1e-4)


def test_a_breakaway_ends_a_curve() -> None:
    from train.test_branches import SOFT

    of = pulleys(2, SOFT)
    result = solve_train(train(of, case(EQUAL, 150e3, 40e3)), method=QUICK)
    curve = share_curve(result, span=(0.98, 1.02), points=21)
    ends = [m for m in curve.marks if m.kind is MarkKind.BREAKAWAY]
    assert [m.drive for m in ends] == [0, 1]
    assert np.isnan(curve.shares[0]).all()
    assert np.isnan(curve.shares[-1]).all()
    inside = (curve.values > ends[0].value) & (curve.values < ends[1].value)
    assert np.isfinite(curve.shares[inside]).all()
    assert np.isnan(curve.shares[~inside]).all()


def test_the_slope_of_a_curve_is_the_sensitivity() -> None:
    result = tandem()
    here = result.cases[0]["p2"].speed_trim
    curve = share_curve(result, span=(here - 1e-4, here + 1e-4), points=3)
    slope = (curve.shares[2, 1] - curve.shares[0, 1]) / 2e-4 * here
    assert result.cases[0].sensitivity[1][1] == pytest.approx(slope, rel=2e-4)
    assert result.cases[0].share_per_trim(1) == pytest.approx(1e-3 * slope, rel=2e-4)


def test_a_curve_with_motors_keeps_their_droop() -> None:
    drooping = VariableSpeed(rated_power=3e5, rated_speed=155.0, gear_ratio=20.0, droop=0.01)
    of = pulleys(2)
    result = solve_train(train(of, case(Motors((drooping, drooping)))), method=QUICK)
    curve = share_curve(result, points=5)
    slope = np.gradient(curve.shares[:, 1], curve.values)[2]
    rigid = share_curve(solve_train(train(of, case(Speeds((1.0, 1.0)))), method=QUICK), points=5)
    assert 0.0 < slope < 0.7 * np.gradient(rigid.shares[:, 1], rigid.values)[2]


@pytest.mark.parametrize("down", [Axis.LOAD, Axis.DIAMETER])
@pytest.mark.parametrize(("law", "belt"), [("rubber", STEEL), ("softening", FABRIC)])
def test_a_map_is_the_slow_answer(down: Axis, law: str, belt: Belt) -> None:
    """Interpolated in tables, within 0.2 % of the full load of each share."""
    result = tandem(law, belt)
    here = result.cases[0]["p2"].speed_trim
    x = here + np.linspace(-4e-3, 4e-3, 17)
    y = np.linspace(0.3, 1.2, 7) if down is Axis.LOAD else np.linspace(0.996, 1.004, 7)
    fast = share_map(result, x=x, y=y, down=down)
    checked = 0
    for j, i in ((0, 8), (2, 3), (3, 8), (4, 12), (6, 5), (6, 14)):
        if not np.isfinite(fast.shares[j, i, 0]):
            continue
        slow = share_curve(result, axis=down, span=(y[j], y[j] + 1e-9), points=3)
        speeds = tuple(m.speed_trim / d for m, d in zip(slow.case, slow.train.nominal, strict=True))
        of = slow.train.pulleys
        given = replace(slow.train.cases[0], division=Speeds((speeds[0], speeds[1] * x[i] / here)))
        load = 1.0
        if down is Axis.LOAD:
            load = float(y[j])
            entry = given.exit_tension + load * given.effective_tension
            given = replace(given, entry_tension=entry)
        else:
            of = (of[0], replace(of[1], diameter=of[1].diameter * float(y[j])))
        answer = solved(replace(slow.train, pulleys=of, cases=(given,)))
        assert load * fast.shares[j, i] == pytest.approx(
            [load * s for s in answer.shares], abs=2e-3
        )
        checked += 1
    assert checked >= 4


def test_maps_refuse_what_tables_cannot_hold() -> None:
    x, y = np.linspace(0.99, 1.01, 5), np.linspace(0.5, 1.0, 5)
    with pytest.raises(InputError, match="no map for the law of lagging lagging, which sticks"):
        share_map(tandem("constant", overrun=0.0), x=x, y=y)
    with pytest.raises(InputError, match="both axes are speed_trim"):
        share_map(tandem(), x=x, y=x, down=Axis.TRIM)


def test_wear_of_one_drum_moves_load_to_the_other() -> None:
    result = tandem()
    for worn, other in (("p1", "p2"), ("p2", "p1")):
        after = what_if(result, pulley=worn, wear=1e-3)
        assert after[worn].share < 0.5 - 0.1
        assert after[other].share > 0.5 + 0.1
        by_hand = tuple(
            replace(
                p,
                diameter=p.diameter - (2e-3 if p.name == worn else 0.0),
                lagging=replace(
                    p.lagging, thickness=p.lagging.thickness - (1e-3 if p.name == worn else 0.0)
                ),
            )
            for p in result.train.pulleys
        )
        speeds = Speeds(tuple(m.speed_trim for m in result.cases[0]))
        expected = solved(train(by_hand, case(speeds), nominal=(0.8, 0.8)))
        assert after.shares == pytest.approx(expected.shares, abs=1e-9)
    with pytest.raises(InputError, match="between 0 and the thickness"):
        what_if(result, pulley="p1", wear=20e-3)
    with pytest.raises(InputError, match="no such pulley"):
        what_if(result, pulley="p9")


def test_a_slippery_drum_sheds_load() -> None:
    slick = lagging("elastic-plastic")
    after = what_if(tandem(overrun=0.0), pulley="p2", lagging=slick)
    assert after["p2"].arc.arc.law is slick.law


def test_all_about_matching() -> None:
    result = solve_train(train(pulleys(2), case(Speeds((1.0, 1.0)))), method=QUICK)
    matching = match_drives(result, points=11)
    assert matching.equal.shares == pytest.approx((0.5, 0.5))
    (equal,) = matching.trim.at(MarkKind.EQUAL, 1)
    assert equal == pytest.approx(matching.equal["p2"].speed_trim, abs=2e-6)
    assert [c.pulley for c in matching.changes] == ["p1", "p2"]
    assert matching.equal.loss_ratio < matching.case.loss_ratio


@pytest.mark.parametrize(
    ("how", "complaint"),
    [
        ({"drive": 0}, "trims are relative to the first drive"),
        ({"drive": 2}, "the drives are 0 to 1"),
        ({"span": (1.0, 0.9)}, "the smaller one first"),
        ({"points": 2}, "between 3 and 10001"),
    ],
)
def test_what_makes_no_curve(how: dict[str, object], complaint: str) -> None:
    with pytest.raises(InputError, match=complaint):
        share_curve(tandem(), **how)  # type: ignore[arg-type]


def test_one_pulley_shares_with_nobody() -> None:
    alone = solve_train(train(pulleys(1), case(Shares((1.0,)))), method=QUICK)
    with pytest.raises(InputError, match="shares its load with nobody"):
        share_curve(alone)
