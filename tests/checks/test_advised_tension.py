"""The tension that is advised answers every check that asks for more tension.

Each random drive is solved anew at the advised tension as it is shown, and 1 % below it. Wet is
solved as the same drive with laggings in their wet condition.
"""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from answer.drives import BELT, drive
from arc.drives import LAWS
from checks.test_least_tension import with_slack
from checks.test_rows import NONE, quiet
from wraparc import Drive, Lagging, load_lagging, solve
from wraparc.answer.least_tension import at_least, least_sentence, least_table
from wraparc.answer.sheet import shown
from wraparc.checks import RULES, LeastTension, judge, least_tension
from wraparc.checks.of_wet import is_dry_only
from wraparc.drive import Belt, Criteria, DesignStandard, Fit, Sag, TakeUp
from wraparc.drive.conditions import Condition
from wraparc.friction import IntegralLog, PressureKnots

#: A belt whose cover the slip of a law may hold or not.
COVERED = Belt(
    name="covered", width=1.2, modulus=12.96e6, speed=3.0, mass=20.0, pulley_cover=6e-3,
    carry_cover=9e-3, carcass=9e-3,
)  # fmt: skip
RAISING = {rule.name for rule in RULES.values() if rule.tension == "raise"}


def fitted(spread: float) -> Lagging:
    """A lagging whose law is uncertain by a part of its peak slip."""
    knots = PressureKnots(pressure=(1e5,), peak_friction=(0.8,), peak_slip=(10e-3,))
    fit = Fit(
        parameters=("knots[1].peak_slip",), values=(10e-3,),
        covariance=(((10e-3 * spread) ** 2,),),
    )  # fmt: skip
    return Lagging(
        name="fitted", law=IntegralLog(coefficients=knots), thickness=12e-3, shear_modulus=2.3e6,
        fit=fit,
    )  # fmt: skip


def advised(of: Drive) -> LeastTension:
    found = least_tension(solve(of, raise_on_failure=False))
    assert found is not None
    return found


def as_shown(tension: float) -> float:
    number, unit = shown(at_least(tension), "si").split()
    return float(number) * {"N": 1.0, "kN": 1e3, "MN": 1e6}[unit]


def missed_for_tension(of: Drive) -> set[str]:
    """Return the checks that more tension helps against and that are missed, wet solved anew."""
    # a standard that cannot be applied asks for no tension
    checks = (c for c in judge(solve(of, raise_on_failure=False)).missed if c.limit == c.limit)
    missed = {c.name for c in checks} & RAISING
    (head,) = of.pulleys
    if is_dry_only(of, of.load_cases[0]) and head.lagging.surface:
        wet = Condition(name="wet").lagging(head.lagging)
        result = solve(replace(of, pulleys=(replace(head, lagging=wet),)), raise_on_failure=False)
        missed_wet = {c.name for c in judge(result).missed}
        if "creep" in missed_wet or not result.arcs[0].status.solved:
            missed |= {"wet_creep"}
    return missed


def answers_all(of: Drive) -> str:
    """Solve a drive anew at what it is advised and below; return what governs, "" for nothing."""
    found = advised(of)
    if math.isinf(found.tension):
        return ""
    kept_by_none = {f.name for f in found.figures if f not in found.required}
    at = with_slack(of, as_shown(found.tension))
    assert missed_for_tension(at) <= kept_by_none, found
    below = with_slack(of, 0.99 * found.tension)
    assert found.governing.name in missed_for_tension(below), found
    return found.governing.name


@cache
def random_drives() -> tuple[Drive, ...]:
    """Return drives of mixed laws and belts under mixed criteria."""
    rng = np.random.default_rng(52)
    shipped = [load_lagging(n) for n in ("diamond-rubber", "medium-ceramic", "full-ceramic")]
    own = [
        Lagging(name=n, law=law, thickness=12e-3, shear_modulus=2.3e6,
                surface=str(rng.choice(["rubber", ""])))
        for n, law in LAWS.items() if n != "softening"
    ]  # fmt: skip
    laggings = [*shipped * 3, *own, fitted(0.05), fitted(0.02)]
    found = []
    for _ in range(120):
        slack = float(np.exp(rng.uniform(np.log(20e3), np.log(120e3))))
        pull = slack * float(rng.uniform(0.2, 2.0))
        pair = (slack + pull, slack) if rng.uniform() < 0.75 else (slack, slack + pull)
        lagging = laggings[rng.integers(len(laggings))]
        law = lagging.law
        if isinstance(law, IntegralLog):
            if law.tested is not None and rng.uniform() < 0.3:
                law = replace(law, tested=replace(law.tested, slip_max=4e-3))
            if rng.uniform() < 0.3:
                includes: tuple[tuple[str, ...], ...] = (("cover",), (), ("lagging",))
                law = replace(law, slip_includes=includes[rng.integers(3)])
            lagging = replace(lagging, law=law)
        belt = COVERED if rng.uniform() < 0.6 else replace(BELT, rating=600e3)
        made = drive(
            *pair, lagging, belt, diameter=float(rng.uniform(0.7, 1.4)),
            wrap_angle=float(rng.uniform(2.8, 3.9)),
        )  # fmt: skip
        kind = str(rng.choice(["running", "starting", "braking"]))
        case = replace(made.load_cases[0], kind=kind)  # type: ignore[arg-type]
        sag = Sag(spacing=3.0, line_mass=float(rng.uniform(50.0, 400.0)))
        criteria = Criteria(
            standard=DesignStandard(
                name=str(rng.choice(["", "CEMA", "DIN 22101", "none"])),
            ),
            take_up=TakeUp(kind=str(rng.choice(["", "gravity", "fixed"]))),
            sag=sag if rng.uniform() < 0.4 else None,
        )
        limit = float(rng.choice([6.35e-3, 12e-3]))
        found.append(replace(made, load_cases=(case,), criteria=criteria, creep_limit=limit))
    return tuple(found)


@pytest.mark.parametrize("part", range(6))
def test_no_check_asks_for_more_at_the_advised_tension(part: int) -> None:
    governs = [answers_all(of) for of in random_drives()[part::6]]
    assert sum(map(bool, governs)) >= 8
    assert len(set(governs)) >= 3


def test_each_reason_governs_some_drive() -> None:
    """Expected: that of each check which estimates a larger creep, a drive is found it governs."""
    of = quiet(belt={"rating": None}, creep_limit=4e-3, lagging=fitted(0.05))
    assert answers_all(of) == "creep_interval"
    rubber = load_lagging("diamond-rubber")
    assert answers_all(drive(110e3, 60e3, rubber)) == "wet_creep"
    untold = replace(rubber, surface="")
    of = replace(drive(110e3, 60e3, untold, COVERED), criteria=NONE)
    assert answers_all(of) == "cover_creep"
    assert "the cover of the belt in series" in shown(least_sentence(solve(of)), "si")


def test_what_no_tension_keeps_sets_none_and_is_named_so() -> None:
    """Wet it asks for more than the rating of the belt allows: the dry creep governs."""
    never_covered = Criteria(standard=DesignStandard(name="none"))
    of = replace(drive(180e3, 90e3, load_lagging("diamond-rubber")), criteria=never_covered)
    result = solve(of, raise_on_failure=False)
    found = least_tension(result)
    assert found is not None
    wet = next(f for f in found.figures if f.name == "wet_creep")
    assert wet not in found.required
    assert math.isfinite(found.tension)
    table = least_table(result)
    assert table is not None
    notes = [row.note for row in table.rows if row.title.startswith("Creep when wet")]
    assert notes == ["not counted, as no tension keeps all, pulley head, load case full"]
