"""The least slack-side tension: each check where it governs, and solved anew on random drives.

Expected values are worked by hand (Cw, capstan ratio, p B D/2) or found by solving the drive anew
at the tension that was found.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from answer.drives import drive, marched, solved
from checks.test_rows import NONE, WIDE, lagging, quiet, rigid
from wraparc import Drive, LoadCase, Tensions, load_lagging, solve
from wraparc.answer.least_tension import least_sentence
from wraparc.answer.sheet import shown
from wraparc.checks import LeastTension, Level, judge, least_tension
from wraparc.drive import Criteria, DesignStandard, Sag, TakeUp
from wraparc.train import Shares, Train, TrainCase, solve_train


def with_slack(of: Drive, slack: float) -> Drive:
    """Return the drive with its slack side at a tension and its pull held."""
    (case,) = of.load_cases
    t = case.tensions["head"]
    rise = slack - min(t.entry, t.exit)
    tensions = {"head": Tensions(entry=t.entry + rise, exit=t.exit + rise)}
    return replace(of, load_cases=(replace(case, tensions=tensions),))


R35 = math.exp(0.35 * math.pi)
#: name of the check that governs, drive, least tension
GOVERN: list[tuple[str, Drive, float]] = [
    # 1.25 times 40 kN just carried at gross slip with T2 held: T2 = 50 kN/(R - 1)
    ("gross_slip", quiet(lagging=rigid(0.35), creep_limit=1.0), 50e3 / (R35 - 1.0)),
    # T1 + T2 held: tight t = kP R/(R - 1), slack t - kP, their sum less P over 2
    (
        "gross_slip",
        quiet(lagging=rigid(0.35), creep_limit=1.0,
              criteria=replace(NONE, take_up=TakeUp(kind="fixed"))),
        (2.0 * 50e3 * R35 / (R35 - 1.0) - 50e3 - 40e3) / 2.0,
    ),
    (
        "design_standard",
        quiet(criteria=Criteria(standard=DesignStandard(name="DIN 22101", condition="wet",
                                                        binding=True))),
        40e3 / (R35 - 1.0),
    ),
    (
        "sag", quiet(criteria=replace(NONE, sag=Sag(spacing=3.0, line_mass=300.0))),
        300.0 * 9.80665 * 3.0 / 0.16,
    ),
    (
        "tested_pressure_min",
        quiet(lagging=lagging(tested=replace(WIDE, pressure_min=130e3))), 130e3 * 1.2 * 0.8 / 2.0,
    ),
    ("creep", quiet(creep_limit=1e-3), math.nan),
    # 1.25 times the pull with the slip as tested asks for more than the slip itself
    ("gross_slip", quiet(lagging=lagging(tested=replace(WIDE, slip_max=3e-4))), math.nan),
]  # fmt: skip


@pytest.mark.parametrize(("name", "of", "expected"), GOVERN)
def test_the_check_that_asks_for_most_governs(name: str, of: Drive, expected: float) -> None:
    found = least_tension(solve(of, raise_on_failure=False))
    assert found is not None
    assert found.governing.name == name
    if not math.isnan(expected):
        assert found.tension == pytest.approx(expected, rel=1e-6)
    assert found.counterweight == pytest.approx(2.0 * found.tension / 9.80665)
    holds_and_fails_below(of, found)


def holds_and_fails_below(of: Drive, found: LeastTension) -> None:
    """Solve anew: every check that sets it is kept at the tension, one is not at 1 % less."""
    least, sets = found.governing.tension, {f.name for f in found.required}
    # a bound from above (rating, pressure) is said on its own
    at = judge(solve(with_slack(of, least * (1.0 + 1e-6)), raise_on_failure=False))
    assert not sets & {c.name for c in at.missed}
    assert [c for c in at.missed if c.binding and c.name not in FROM_ABOVE] == []
    below = judge(solve(with_slack(of, 0.99 * least), raise_on_failure=False))
    assert sets & {c.name for c in below.missed}


def holds_and_fails_above(of: Drive, most: float) -> None:
    """Solve anew: no bound from above is missed at the tension, one is at 1 % more."""
    if most <= 0.0:  # the pull alone is beyond a bound: no slack side is low enough
        t = of.load_cases[0].tensions["head"]
        at = judge(solve(with_slack(of, 0.05 * max(t.entry, t.exit)), raise_on_failure=False))
        assert any(c.name in FROM_ABOVE for c in at.missed)
        return
    for factor, bad in ((1.0 - 1e-6, False), (1.01, True)):
        at = judge(solve(with_slack(of, most * factor), raise_on_failure=False))
        assert any(c.name in FROM_ABOVE for c in at.missed) is bad


FROM_ABOVE = {
    "belt_safety", "belt_tension", "momentary_tension", "face_pressure", "tested_pressure_max",
    "bond_stress", "fatigue_stress", "pulley_diameter", "usual_sizes",
}  # fmt: skip


def random_drives(count: int, seed: int = 5) -> list[Drive]:
    """Return drives over the sizes that conveyors have, of every shipped lagging."""
    rng = np.random.default_rng(seed)
    names = ("diamond-rubber", "plain-rubber", "medium-ceramic", "full-ceramic")
    known = [n for n in names if n in NAMES]
    found = []
    for _ in range(count):
        slack = float(np.exp(rng.uniform(np.log(20e3), np.log(150e3))))
        pull = slack * float(rng.uniform(0.2, 3.0))
        pair = (slack + pull, slack) if rng.uniform() < 0.75 else (slack, slack + pull)
        of: dict[str, Any] = {
            "diameter": float(rng.uniform(0.5, 1.4)),
            "wrap_angle": float(rng.uniform(2.8, 3.9)),
        }
        made = drive(*pair, load_lagging(str(rng.choice(known))), **of)
        kind = str(rng.choice(["running", "starting", "braking"]))
        case = replace(made.load_cases[0], kind=kind)  # type: ignore[arg-type]
        sag = Sag(spacing=3.0, line_mass=float(rng.uniform(10.0, 60.0)))
        standard = DesignStandard(
            name=str(rng.choice(["", "CEMA", "DIN 22101", "none"])),
        )
        if standard.name in ("CEMA", "DIN 22101") and rng.uniform() < 0.5:
            standard = replace(standard, binding=True)
        take_up = TakeUp(kind=str(rng.choice(["", "gravity", "fixed"])))
        criteria = Criteria(
            standard=standard, take_up=take_up, sag=sag if rng.uniform() < 0.5 else None
        )
        found.append(replace(made, load_cases=(case,), criteria=criteria))
    return found


NAMES = ("diamond-rubber", "medium-ceramic", "full-ceramic")


def both_ways(of: Drive) -> None:
    """Solve a drive anew at its least and at its largest tension, and beyond both."""
    found = least_tension(solve(of, raise_on_failure=False))
    assert found is not None
    assert found.highest is not None  # the tests of the lagging bound every drive from above
    holds_and_fails_above(of, found.highest.tension)
    if math.isfinite(
        found.governing.tension
    ):  # else no tension does: said in a sentence, see below
        holds_and_fails_below(of, found)


@pytest.mark.parametrize("number", range(0, 300, 15))
def test_solved_anew_it_keeps_every_binding_check_and_beyond_it_does_not(number: int) -> None:
    """Every fifteenth of the 300 random drives; `benchmarks/verdicts.py` takes all of them."""
    both_ways(random_drives(300)[number])


def test_of_the_random_drives_most_have_one() -> None:
    found = [least_tension(solve(of, raise_on_failure=False)) for of in random_drives(300)[::30]]
    assert sum(f is not None and math.isfinite(f.tension) for f in found) >= 3


def test_where_none_keeps_every_check_it_says_why() -> None:
    tight = quiet(entry=200e3, leaving=100e3,
                  criteria=replace(NONE, sag=Sag(spacing=3.0, line_mass=700.0)))  # fmt: skip
    result = solve(tight)
    found = least_tension(result)
    assert found is not None
    assert math.isinf(found.tension)
    assert shown(least_sentence(result), "si") == (
        "No T2 passes: T2 for sag needs 129 kN, Belt tension, running allows 110 kN."
    )


def test_it_is_never_an_extrapolation() -> None:
    """A braking drive: not a ratio of 20 and more, but the least pressure of the tests."""
    result = solved(70e3, 100e3)
    found = least_tension(result)
    assert found is not None
    assert found.tension >= 34e3 * 1.2 * 0.8 / 2.0 * (1.0 - 1e-9)


def test_nothing_pulled_or_no_capacities_have_none() -> None:
    assert least_tension(marched()) is None


def test_of_a_train_it_is_behind_the_last_pulley() -> None:
    """Equal shares of equal drums: the second asks for most; the first has its pull on top."""
    one = drive(lagging=rigid(0.35), overrun=0.0)
    second = replace(one.pulleys[0], name="second")
    train = Train(
        belt=one.belt, pulleys=(one.pulleys[0], second), creep_limit=1.0, criteria=NONE,
        cases=(TrainCase(name="full", entry_tension=150e3, exit_tension=60e3,
                         division=Shares((0.5, 0.5))),),
    )  # fmt: skip
    found = least_tension(solve_train(train))
    assert found is not None
    assert (found.governing.name, found.governing.place.pulley) == ("gross_slip", "second")
    assert found.tension == pytest.approx(1.25 * 45e3 / (R35 - 1.0))
    assert found.given == 60e3


def test_several_load_cases_have_the_largest() -> None:
    base = quiet()
    heavy = LoadCase(name="heavy", tensions={"head": Tensions(entry=150e3, exit=60e3)})
    both = least_tension(solve(replace(base, load_cases=(*base.load_cases, heavy))))
    alone = least_tension(solve(replace(base, load_cases=(heavy,))))
    assert both is not None
    assert alone is not None
    assert both.tension == alone.tension
    assert judge(solve(base)).level is Level.OK
