"""Verdicts of many rows at once are those of the drives one by one.

Expected values are the judgement of each drive, solved by the interpreted kernel.
"""

import math
from collections import Counter
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from arc.drives import SOFTENING
from checks.test_least_tension import random_drives
from checks.test_rows import NONE, WIDE, lagging, quiet
from wraparc import Drive, IntegralLog, Pulley, Tensions, load_lagging, solve
from wraparc.arc import Distributed
from wraparc.batch import Setting, solve_arcs
from wraparc.batch.precise import solve_precisely
from wraparc.batch.result import BatchResult
from wraparc.batch.row import EVERYTHING, TENSIONS
from wraparc.catalogue import design_friction
from wraparc.checks import Check, Level, judge
from wraparc.checks.design_standard import find_requirement, wrap_factors
from wraparc.checks.of_arc import slip_speed
from wraparc.checks.of_rows import LEVELS, NAMES, worst_of_rows
from wraparc.checks.rules import ACROSS_CHECKS
from wraparc.drive import Criteria, DesignStandard, Fit, SafetyFactors, Sag, TakeUp
from wraparc.drive.belt import Side
from wraparc.files import drive_from_document
from wraparc.files.write import drive_document
from wraparc.study.source import DriveSource
from wraparc.units import in_units

QUICK = Distributed(capacities=False)


def of_rows(of: Drive, pulley: str = "head", document: Any = None) -> tuple[str, str]:
    """Verdict and governing check of a pulley in the first load case, by columns."""
    rows = DriveSource(document or drive_document(of), pulley, ()).rows(
        {}, 1, of.load_cases[0].name
    )
    softens = rows.arcs.laws.steepest_fall[0] < 0.0
    found = solve_precisely(rows.arcs, EVERYTHING if softens else TENSIONS)
    level, governing, _ = worst_of_rows(
        BatchResult(rows.arcs, found), rows.held, (np.ones(1), np.ones(1)), Setting.PRECISE
    )
    return str(LEVELS[level[0]]), NAMES[governing[0]]


def one_by_one(of: Drive, pulley: str = "head") -> tuple[str, str]:
    result = solve(of, method=QUICK, raise_on_failure=False)
    verdict = judge(result).at(pulley, of.load_cases[0].name)
    assert isinstance(verdict.governing, Check)
    return str(verdict.level), verdict.governing.name


def random_pairs(count: int, seed: int = 8) -> list[Drive]:
    """Return drives of one and two pulleys on every kind of limit, near to where each is missed."""
    rng = np.random.default_rng(seed)
    found = []
    for of in random_drives(count, seed):
        (case,) = of.load_cases
        t = case.tensions["head"]
        belt = replace(
            of.belt,
            rating=max(t.entry, t.exit) / 1.2 * float(rng.uniform(0.6, 1.6)),
            momentary_factor=float(rng.choice([1.0, 1.4])),
            largest_wrap_pressure=float(rng.uniform(2e5, 6e5)) if rng.uniform() < 0.5 else None,
            least_pulley_diameter=float(rng.uniform(0.3, 1.0)) if rng.uniform() < 0.5 else None,
        )
        head = of.pulleys[0]
        law = head.lagging.law
        tested = law.tested
        if isinstance(law, IntegralLog) and tested is not None and rng.uniform() < 0.4:
            law = replace(law, tested=replace(tested, slip_speed=float(rng.uniform(1e-3, 0.05))))
        lag = replace(
            head.lagging,
            law=law,
            bond_strength=float(rng.uniform(2e4, 3e5)) if rng.uniform() < 0.5 else None,
            fatigue_limit=float(rng.uniform(2e4, 3e5)) if rng.uniform() < 0.5 else None,
        )
        pulleys: tuple[Pulley, ...] = (replace(head, lagging=lag),)
        tensions = dict(case.tensions)
        if rng.uniform() < 0.4:
            pulleys = (*pulleys, replace(head, name="second"))
            tensions["second"] = Tensions(entry=t.exit, exit=t.exit * float(rng.uniform(0.8, 1.2)))
        cases = (replace(case, tensions=tensions),)
        found.append(replace(of, belt=belt, pulleys=pulleys, load_cases=cases))
    return found


@pytest.mark.parametrize("start", [0, 10])
def test_random_drives_end_alike_row_by_row(start: int) -> None:
    """20 of them; `benchmarks/verdicts.py` has 300."""
    ends: Counter[tuple[str, str]] = Counter()
    for of in random_pairs(20)[start : start + 10]:
        assert of_rows(of) == one_by_one(of)
        ends[of_rows(of)] += 1
    assert len(ends) >= 4  # not always the same


@pytest.mark.parametrize(
    ("modulus", "limit", "level"),
    [(8e4, 20e-3, "ATTENTION"), (7e4, 20e-3, "FAILS"), (7e4, 80e-3, "FAILS")],
)
def test_a_creep_of_ten_customary_limits_is_sliding(
    modulus: float, limit: float, level: str
) -> None:
    """63.5 mm, whatever limit is given: the same of rows and of drives."""
    of = quiet(belt={"modulus": modulus}, creep_limit=limit)
    (arc,) = solve(of, method=QUICK)
    assert (arc.exit_creep > 63.5e-3) is (modulus < 7.5e4)
    assert of_rows(of)[0] == one_by_one(of)[0] == level
    found = next(c for c in judge(solve(of, method=QUICK)).checks if c.name == "creep")
    said = level == "FAILS" and limit < 63.5e-3
    assert ("exceeds the 63.5 mm gross-slip limit" in in_units(found.text)) is said
    (slides,) = (c for c in judge(solve(of, method=QUICK)).checks if c.name == "gross_slip")
    assert (slides.value < 1.0) is (level == "FAILS")


def test_gross_slip_leads_whatever_else_fails() -> None:
    """A belt of 30 times its rating in one load case, gross slip in another: rows alike."""
    slips = quiet(lagging=lagging(0.2), entry=90e3, leaving=40e3)
    torn = quiet(lagging=lagging(0.2), entry=90e3, leaving=90e3, belt={"rating": 3e3})
    cases = (replace(torn.load_cases[0], name="full"), replace(slips.load_cases[0], name="start"))
    verdict = judge(solve(replace(torn, load_cases=cases), method=QUICK, raise_on_failure=False))
    assert {c.name for c in verdict.missed if c.level.value == "FAILS"} >= {
        "gross_slip", "belt_tension",
    }  # fmt: skip
    assert verdict.governing is not None
    assert (verdict.governing.name, verdict.governing.place.load_case) == ("gross_slip", "start")
    both = quiet(lagging=lagging(0.2), entry=90e3, leaving=40e3, belt={"rating": 3e3})
    assert of_rows(both) == one_by_one(both) == ("FAILS", "gross_slip")


SOFT = load_lagging("diamond-rubber")
CASES: list[tuple[str, Drive]] = [
    ("gross_slip", quiet(lagging=lagging(0.35), entry=90e3, leaving=40e3, creep_limit=0.06)),
    ("gross_slip", quiet(lagging=lagging(0.2), entry=90e3, leaving=40e3)),  # breaks away
    ("design_standard", quiet(entry=100e3, leaving=30e3, creep_limit=0.06, criteria=Criteria(
        standard=DesignStandard(name="CEMA", binding=True, start_factor=1.5)))),
    ("creep", quiet(creep_limit=1e-4)),
    ("wet_creep", quiet(lagging=SOFT, criteria=replace(NONE, covered=False), creep_limit=3e-3)),
    ("wet_creep", quiet(lagging=lagging(0.3, surface="bare"), criteria=replace(NONE, covered=False),
                        creep_limit=0.06)),  # wet it slips
    ("belt_tension", quiet(belt={"rating": 80e3})),
    ("momentary_tension", quiet(belt={"rating": 80e3}, kind="starting")),
    ("face_pressure", quiet(belt={"largest_wrap_pressure": 1e5})),
    ("pulley_diameter", quiet(belt={"least_pulley_diameter": 1.0})),
    ("usual_sizes", quiet(belt={"speed": 30.0})),
    ("usual_sizes", quiet(belt={"mass": 500.0})),
    ("usual_sizes", quiet(entry=800.0, leaving=60.0, lagging=lagging(1.5, tested=None))),
    ("case_kind", replace(
        quiet(), load_cases=(replace(quiet().load_cases[0], name="full start"),))),
    ("bond_stress", quiet(lagging=lagging(bond_strength=1e3))),
    ("fatigue_stress", quiet(lagging=lagging(fatigue_limit=1e3))),
    ("tested_pressure_max", quiet(lagging=lagging(tested=replace(WIDE, pressure_max=1e5)))),
    ("tested_pressure_min", quiet(lagging=lagging(tested=replace(WIDE, pressure_min=150e3)))),
    ("tested_slip_speed", quiet(lagging=lagging(tested=replace(WIDE, slip_speed=3e-6)))),
    ("sag", quiet(criteria=replace(NONE, sag=Sag(spacing=5.0, line_mass=300.0)))),
]  # fmt: skip


COVERS = {"pulley_cover": 20e-3, "carry_cover": 25e-3, "carcass": 6e-3}


@pytest.mark.parametrize("side", ["pulley", "carry"])
def test_a_cover_that_the_law_may_include_is_asked_about_in_rows_too(side: Side) -> None:
    """A limit between the creep without the cover and with it; not of a law that says so."""
    of = quiet(belt=COVERS, pulley={"side": side})
    (arc,) = solve(of).arcs
    limit = 0.5 * (abs(arc.exit_creep) + abs(arc.covered_creep))
    assert limit > 1.05 * abs(arc.exit_creep)
    asked = replace(of, creep_limit=limit)
    assert one_by_one(asked)[1] == "cover_creep"
    assert of_rows(asked) == one_by_one(asked)
    head = asked.pulleys[0]
    law = replace(head.lagging.law, slip_includes=("cover shear",))
    stated = replace(asked, pulleys=(replace(head, lagging=replace(head.lagging, law=law)),))
    assert of_rows(stated) == one_by_one(stated)
    assert of_rows(stated)[0] == Level.OK.value


#: Checks that other tests compare row by row.
_ELSEWHERE = {
    "belt_safety", "belt_thickness", "condition", "cover_creep", "fit", "momentary_load",
    "motor_load", "tested_slip",
}  # fmt: skip


def test_no_check_is_forgotten_where_rows_are_judged() -> None:
    # a study must never say OK where `wraparc solve` does not: a check of RULES that is made of no
    # row is named in of_rows, every other one has a case here
    cases = {name for name, _ in CASES}
    assert cases | _ELSEWHERE == {name for name in NAMES if name} - ACROSS_CHECKS
    assert cases.isdisjoint(_ELSEWHERE)


@pytest.mark.parametrize(("name", "of"), CASES)
def test_each_check_governs_a_row_where_it_governs_the_drive(name: str, of: Drive) -> None:
    assert one_by_one(of)[1] == name
    assert of_rows(of) == one_by_one(of)


def test_slip_beyond_the_tests_stands_behind_the_safety_within_them() -> None:
    """What slips farther than was tested leaves the tests at less than its pull: that leads."""
    of = quiet(lagging=lagging(tested=replace(WIDE, slip_max=1e-5)))
    assert one_by_one(of) == of_rows(of) == ("ATTENTION", "gross_slip")
    assert "tested_slip" in {check.name for check in judge(solve(of)).missed}


def test_where_friction_falls_past_its_peak_the_margin_is_the_same() -> None:
    assert SOFTENING.steepest_fall() < 0.0
    of = quiet(lagging=replace(SOFT, law=SOFTENING), entry=150e3, leaving=50e3,
               criteria=replace(NONE, safety=SafetyFactors(running=6.0)))  # fmt: skip
    assert one_by_one(of) == ("ATTENTION", "gross_slip")
    assert of_rows(of) == one_by_one(of)


def test_a_law_scaled_to_its_condition_asks_for_attention_in_rows_too() -> None:
    open_air = replace(NONE, covered=False)
    document = drive_document(quiet(lagging=SOFT, criteria=open_air)) | {"condition": "wet"}
    of = drive_from_document(document)
    assert one_by_one(of) == ("ATTENTION", "condition")
    assert of_rows(of, document=document) == one_by_one(of)
    # what has no number and binds nothing leaves the word to what has one
    document = document | {"creep_limit": "0.1 mm"}
    of = drive_from_document(document)
    assert one_by_one(of) == ("ATTENTION", "creep")
    assert of_rows(of, document=document) == one_by_one(of)


@pytest.mark.parametrize(("binding", "name"), [(False, "creep"), (True, "design_standard")])
def test_a_standard_that_cannot_be_applied_ends_alike(binding: bool, name: str) -> None:
    standard = DesignStandard(name="CEMA", binding=binding)
    of = quiet(
        lagging=replace(SOFT, surface=""),
        creep_limit=1e-4,
        criteria=replace(NONE, standard=standard),
    )
    assert one_by_one(of)[1] == name
    assert of_rows(of) == one_by_one(of)


def test_advice_leads_only_where_no_limit_is_missed() -> None:
    """Ten thousand times the speed of the tests says less than a creep just over its limit."""
    assert SOFT.law.tested is not None
    slow = replace(SOFT.law, tested=replace(SOFT.law.tested, slip_speed=3e-6))  # type: ignore[call-arg]
    of = quiet(lagging=replace(SOFT, law=slow))
    assert one_by_one(of) == ("ATTENTION", "tested_slip_speed")
    assert of_rows(of) == one_by_one(of)
    creep = solve(of, method=QUICK).arcs[0].exit_creep
    over = replace(of, creep_limit=0.99 * creep)
    assert one_by_one(over) == ("ATTENTION", "creep")
    assert of_rows(over) == one_by_one(over)
    below = replace(of, criteria=replace(NONE, standard=DesignStandard(name="CEMA")),
                    creep_limit=0.99 * creep)  # fmt: skip
    short = replace(below, load_cases=quiet(lagging=SOFT, entry=130e3, leaving=40e3).load_cases)
    assert one_by_one(short) == ("ATTENTION", "creep")
    assert of_rows(short) == one_by_one(short)


def test_a_law_that_does_not_fit_its_tests_asks_for_attention_in_rows_too() -> None:
    fit = Fit(
        parameters=("knots[0].peak_friction",),
        values=(0.6,),
        covariance=((1e-4,),),
        misfit=("the law misses the tests by 9 % of the peak", "two repeats disagree"),
    )
    of = quiet(lagging=replace(SOFT, fit=fit))
    assert one_by_one(of) == ("ATTENTION", "fit")
    assert of_rows(of) == one_by_one(of)
    verdict = judge(solve(of))
    assert (
        in_units(verdict.text)
        == "Friction law of diamond-rubber deviates from its tests (head, full)."
    )
    assert "misses the tests by 9 % of the peak (and 1 more of its lagging file)" in verdict.full[0]


@pytest.mark.parametrize("times", [1e-3, 0.5, 0.99, 1.01, 2.0])
def test_rows_know_whether_the_slip_speed_is_above_that_of_the_tests(
    times: float,
) -> None:
    """At so many times the slip speed of the arc itself, by the scalar kernel."""
    of = quiet(lagging=SOFT, criteria=NONE)
    arc = solve(of, method=QUICK).arcs[0]
    tested = replace(WIDE, slip_speed=times * slip_speed(arc))
    law = replace(SOFT.law, tested=replace(SOFT.law.tested, slip_speed=tested.slip_speed))  # type: ignore[call-arg, type-var]
    of = quiet(lagging=replace(SOFT, law=law), criteria=NONE)
    rows = DriveSource(drive_document(of), "head", ()).rows({}, 1, "full")
    solved = solve_arcs(rows.arcs, capacities=False)
    level, governing, _ = worst_of_rows(
        solved, rows.held, (np.ones(1), np.ones(1)), Setting.PRECISE
    )
    missed = NAMES[governing[0]] == "tested_slip_speed" and str(LEVELS[level[0]]) == "ATTENTION"
    assert missed is (times < 1.0)


@pytest.mark.parametrize("fixed", [False, True])
@pytest.mark.parametrize("standard", ["CEMA", "DIN 22101", "own", "none"])
def test_wrap_factors_of_columns_are_those_of_the_standard(standard: str, fixed: bool) -> None:
    rule = DesignStandard(name=standard, friction=0.3 if standard == "own" else None)
    take_up = TakeUp(kind="fixed" if fixed else "")
    angles = np.radians([150.0, 180.0, 195.0, 200.0, 219.999999, 220.0, 240.0, 250.0])
    surfaces = {d.surface for d in design_friction()}
    for surface in sorted(surfaces | {""}):
        lag = replace(SOFT, surface=surface)
        one = [find_requirement(rule, take_up, lag, float(a)) for a in angles]
        expected = [math.nan if a is None else a.wrap_factor for a in one]
        np.testing.assert_allclose(wrap_factors(rule, take_up, lag, angles), expected, rtol=1e-14)
