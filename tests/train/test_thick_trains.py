"""Trains with a belt of some thickness and mass: speeds, trims, torques and powers.

Expected values: flow of belt through both nips written out with R - delta + e; moments times
speeds; the same train by one solver and by rows; motors and speeds that keep what shares ask for.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from train.test_train_batch import EXACT, same
from train.trains import FABRIC, QUICK, case, held, pulleys, random_train, solved, train
from wraparc.answer.sheet import shown
from wraparc.answer.train_words import train_verdict
from wraparc.batch import Setting
from wraparc.checks import Level, judge
from wraparc.drive import Belt
from wraparc.errors import InputError
from wraparc.train import MemberResult, Shares, Speeds, Train, solve_train, solve_train_batch
from wraparc.units import in_units

EVEN = Shares((0.5, 0.5))
THICK = replace(FABRIC, pulley_cover=3e-3, carry_cover=7e-3, carcass=6e-3, mass=60.0)


def tandem(belt: Belt, carries: bool = False, second: float = 0.8) -> Train:
    first, other = pulleys(2)
    other = replace(other, side="carry" if carries else "pulley", diameter=second)
    return train((first, other), case(EVEN), belt=belt)


def flow(m: MemberResult, offset: float) -> float:
    """Unstretched belt that a drum takes in: omega (R - delta + e)(1 - g)/(1 + T/EA)."""
    arc = m.arc.arc
    delta = arc.compression_compliance * arc.entry_pressure
    radius = 0.5 * arc.diameter - delta + offset
    stretch = 1.0 + arc.entry_tension / arc.axial_stiffness
    return m.rotation_speed * radius * (1.0 - m.arc.entry_creep_ratio) / stretch


@pytest.mark.parametrize("carries", [False, True])
def test_the_same_belt_passes_both_drums(carries: bool) -> None:
    """e = 3 + 3 mm on the side of the pulleys, 7 + 3 mm on the other."""
    first, second = solved(tandem(THICK, carries, 0.9)).members
    other = 10e-3 if carries else 6e-3
    assert flow(second, other) == pytest.approx(flow(first, 6e-3), rel=1e-12)


def test_torque_times_speed_is_the_power_of_the_belt() -> None:
    members = solved(tandem(THICK, True, 0.9)).members
    for m in members:
        power = m.drum_torque * m.rotation_speed
        assert power == pytest.approx(m.drum_power, rel=1e-12)
        told = m.arc.energy
        assert told.transmitted_power == pytest.approx(power, rel=1e-12)
        assert told.sliding_power + told.shear_loss == pytest.approx(told.power_loss, rel=1e-12)


def test_equal_drums_on_one_side_keep_their_trim() -> None:
    """To first order in e/R = 1.5 %: what creep differs by changes by about as much of itself."""
    thin, thick = (solved(tandem(b)).members[1].speed_trim for b in (FABRIC, THICK))
    assert abs(thick - thin) < 0.1 * abs(thin - 1.0)
    assert thick != thin


def test_drums_on_opposite_sides() -> None:
    """(R + e_1)/(R + e_2) of the trim on one side: 406/410, nearly 1.0 % slower."""
    one, other = (solved(tandem(THICK, carries)).members[1].speed_trim for carries in (False, True))
    assert other == pytest.approx(one * 406.0 / 410.0, rel=3e-5)
    assert one - other == pytest.approx(0.0098, abs=2e-4)


def test_terms_make_up_the_ratio_to_first_order() -> None:
    m = solved(tandem(THICK, True)).members[1]
    terms = m.contraction_term + m.creep_term + m.compression_term + m.thickness_term
    assert m.thickness_term == pytest.approx(406.0 / 410.0 - 1.0, rel=1e-12)
    assert m.drum_ratio - 1.0 == pytest.approx(terms, abs=1e-4)  # squares of 0.4 %


@pytest.mark.parametrize("carries", [False, True])
def test_speeds_that_shares_ask_for_share_so(carries: bool) -> None:
    of = tandem(THICK, carries, 0.9)
    asked = solved(of)
    found = solved(held(of, asked))
    assert [m.share for m in found] == pytest.approx([m.share for m in asked], abs=1e-6)


def test_equal_drum_speeds_on_covers_that_differ() -> None:
    """The drum on the thicker cover runs 1 % too fast then and takes the load of the other, too."""
    of = tandem(THICK, True)
    even = replace(of.cases[0], division=Speeds((1.0, 1.0)))
    shares = [m.share for m in solved(replace(of, cases=(even,))).members]
    assert shares[1] > 1.0 > shares[0]
    assert sum(shares) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("law", ["rubber", "elastic-plastic"])
def test_rows_are_those_of_the_solver_of_one(law: str) -> None:
    rng = np.random.default_rng(34)
    of = random_train(rng, law, 2)
    first, second = of.pulleys
    belt = replace(of.belt, pulley_cover=4e-3, carry_cover=8e-3, carcass=8e-3, mass=40.0)
    of = replace(of, belt=belt, pulleys=(first, replace(second, side="carry")))
    kept = held(of, solved(of, EXACT))
    for base in (of, kept):
        columns = {
            "p2.wear": rng.uniform(0.0, 1.5e-3, 2),
            "entry_tension": of.cases[0].entry_tension * rng.uniform(0.95, 1.05, 2),
        }
        same(solve_train_batch(base, columns, setting=Setting.PRECISE, capacities=False), 1)


def test_what_cannot_be_is_told() -> None:
    with pytest.raises(InputError, match="side: needs carry_cover of the belt"):
        tandem(replace(FABRIC, pulley_cover=3e-3, carcass=6e-3), True)
    with pytest.raises(InputError, match=r"m v.2 = 90 kN of the belt exceeds its tension 50 kN"):
        tandem(replace(FABRIC, mass=10000.0))
    # rows of 20 kg/m: 200 kN at 100 m/s, 0.18 kN at 3 m/s
    of = tandem(replace(FABRIC, mass=20.0))
    for column, said in (
        ({"belt_speed": [3.0, 100.0]}, r'"belt_speed", row 1: .* m v.2 = 200 kN, .* got 100 m/s'),
        ({"exit_tension": [45e3, 100.0]}, r'"exit_tension", row 1: .* 0.18 kN.* got 0.1 kN'),
    ):
        with pytest.raises(InputError, match=said):
            solve_train_batch(of, column, capacities=False)


@pytest.mark.parametrize(
    ("belt", "carries", "second", "shift"),
    [
        (FABRIC, False, 0.8, None),
        (FABRIC, False, 0.802, None),  # worn: 0.003 %
        (FABRIC, False, 1.0, "0.25 %"),  # 5 mm over 400 less 5 mm over 500
        (FABRIC, True, 0.8, "1 %"),  # 4 mm over 400
        (THICK, True, 1.0, None),
    ],
)
def test_a_trim_between_drums_that_differ_asks_for_the_thickness(
    belt: Belt, carries: bool, second: float, shift: str | None
) -> None:
    result = solve_train(tandem(belt, carries, second), method=QUICK)
    asked = [c for c in judge(result).checks if c.name == "belt_thickness"]
    assert [c.level for c in asked] == [Level.ATTENTION] * (shift is not None)
    if shift is not None:
        assert in_units(asked[0].text) == (
            f"Speed trim uncertain by {shift}: belt thickness missing (p2, full)."
        )
        assert in_units(asked[0].action_text) == "Give pulley_cover, carry_cover and carcass."
        assert judge(result).level is not Level.OK


def test_speeds_without_thickness_say_what_they_miss() -> None:
    """5 mm over 400 mm."""
    for belt, there in ((FABRIC, True), (THICK, False)):
        verdict = shown(train_verdict(solve_train(tandem(belt), method=QUICK)), "si")
        told = " ".join(verdict.sentences)
        assert ("10 mm of belt on a pulley of 800 mm would lower them by 1.25 %" in told) == there
