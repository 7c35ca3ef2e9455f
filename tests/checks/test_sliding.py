"""The pull at which a belt slides: solved anew at that pull, the belt does what is said of it.

Expected values are the limits themselves: a creep of 63.5 mm, the largest slip of the tests; and
the closed form exp(mu phi) of constant friction under a lagging that hardly shears.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from arc.drives import SOFTENING
from checks.test_least_tension import random_drives
from checks.test_rows import quiet, rigid
from present.drives import drive
from wraparc import Drive, Tensions, load_lagging, solve
from wraparc.arc import ArcResult, Distributed, WrapArc
from wraparc.batch import Setting
from wraparc.checks import judge
from wraparc.checks.gross_slip import Rise, loaded, rises, sliding
from wraparc.checks.sliding import CREEP, MOST, SLIDES, TESTED, lift_for_safety
from wraparc.checks.sliding_rows import LoadedRows, pulls_at_sliding, tight_at_sliding
from wraparc.drive import TakeUp
from wraparc.files.write import drive_document
from wraparc.study.source import DriveSource

QUICK = Distributed(capacities=False)


def at_pull(of: Drive, rise: Rise, k: float) -> ArcResult:
    """Solve a drive of one pulley with its tensions grown along the line of its take-up."""
    (case,) = of.load_cases
    t = case.tensions["head"]
    up, down = (k - 1.0) * rise.tight, (k - 1.0) * rise.slack
    entry, leaving = (up, down) if t.entry >= t.exit else (down, up)
    tensions = {"head": Tensions(entry=t.entry + entry, exit=t.exit + leaving)}
    (arc,) = solve(replace(of, load_cases=(replace(case, tensions=tensions),)), method=QUICK)
    return arc


def untested(of: Drive) -> Drive:
    """Return the drive with a lagging that states no tests, so that its creep comes first."""
    head = of.pulleys[0]
    law = replace(head.lagging.law, tested=None)  # type: ignore[call-arg]
    return replace(of, pulleys=(replace(head, lagging=replace(head.lagging, law=law)),))


@pytest.mark.parametrize("number", [0, 3, 6, 9])
@pytest.mark.parametrize("tests", [True, False])
def test_solved_anew_at_that_pull_the_belt_is_where_it_slides(number: int, tests: bool) -> None:
    of = random_drives(10)[number]
    of = of if tests else untested(of)
    (arc,) = solve(of, method=QUICK, raise_on_failure=False)
    rise = rises([arc], 0, of.criteria.take_up)
    found = sliding(arc, rise)
    there = at_pull(of, rise, found.place)
    creep, slip = abs(there.exit_creep), float(np.abs(there.profile.slip).max())
    if found.cause == TESTED:
        tested = arc.arc.law.tested
        assert tested is not None
        assert slip == pytest.approx(tested.slip_max, rel=1e-5)
        assert creep < SLIDES
    else:
        assert found.cause == CREEP
        assert creep == pytest.approx(SLIDES, rel=1e-5)


@pytest.mark.parametrize(("fixed", "place"), [(False, 1.5017), (True, None)])
def test_constant_friction_slides_where_all_of_it_is_used(fixed: bool, place: float | None) -> None:
    """T1/T2 = exp(0.35 pi) = R: (R - 1) T2 over the pull, or by the sum of both sides."""
    of = quiet(lagging=rigid(0.35), entry=100e3, leaving=40e3)
    (arc,) = solve(of, method=QUICK)
    found = sliding(arc, rises([arc], 0, TakeUp(kind="fixed" if fixed else "gravity")))
    r = math.exp(0.35 * math.pi)
    own = 40e3 * (r - 1.0) / 60e3 if not fixed else 140e3 * (r - 1.0) / (r + 1.0) / 60e3
    assert found.place == pytest.approx(own, rel=1e-6)
    assert found.cause == MOST


def test_the_largest_friction_of_a_law_that_falls_comes_first() -> None:
    """No pull beyond it is carried, and one just below it is."""
    of = untested(drive(lagging=replace(load_lagging("diamond-rubber"), law=SOFTENING)))
    (arc,) = solve(of, method=QUICK, raise_on_failure=False)
    rise = rises([arc], 0, of.criteria.take_up)
    found = sliding(arc, rise)
    assert found.cause in (MOST, CREEP)
    if found.cause == MOST:
        assert abs(at_pull(of, rise, found.place * (1.0 - 1e-3)).exit_creep) < SLIDES


@pytest.mark.parametrize("number", [1, 6, 9])
def test_the_tension_for_a_safety_gives_that_safety(number: int) -> None:
    of = random_drives(10)[number]
    (arc,) = solve(of, method=QUICK, raise_on_failure=False)
    rise = rises([arc], 0, of.criteria.take_up)
    lift = lift_for_safety(loaded(arc), 1.6, rise.tight)
    raised = at_lift(of, lift)
    assert sliding(raised, rises([raised], 0, of.criteria.take_up)).place == pytest.approx(1.6)


def at_lift(of: Drive, lift: float) -> ArcResult:
    (case,) = of.load_cases
    t = case.tensions["head"]
    tensions = {"head": Tensions(entry=t.entry + lift, exit=t.exit + lift)}
    (arc,) = solve(replace(of, load_cases=(replace(case, tensions=tensions),)), method=QUICK)
    return arc


def test_rows_find_the_pulls_of_single_arcs() -> None:
    """Place, cause and least tension, to the accuracy of the rows."""
    for number in (0, 3, 6, 9):
        of = random_drives(10)[number]
        rows = DriveSource(drive_document(of), "head", ()).rows({}, 1, of.load_cases[0].name)
        arc = solve(of, method=QUICK, raise_on_failure=False).arcs[0]
        rise = rises([arc], 0, of.criteria.take_up)
        one = sliding(arc, rise)
        many = LoadedRows.of(rows.arcs, setting=Setting.PRECISE)
        place, cause = pulls_at_sliding(many, (np.array([rise.tight]), np.array([rise.slack])))
        assert place[0] == pytest.approx(one.place, rel=1e-5)
        assert cause[0] == one.cause
        pull = abs(arc.arc.effective_tension)
        least = tight_at_sliding(many, np.array([1.4 * pull]))[0]
        tight = max(arc.arc.entry_tension, arc.arc.exit_tension)
        lift = lift_for_safety(loaded(arc), 1.4, 0.0)
        assert least - tight == pytest.approx(lift, rel=1e-4, abs=1e-5 * tight)


def test_a_drive_beyond_its_tests_is_never_ok() -> None:
    """15 to 1 on diamond rubber: it creeps 43 mm, where the tests ended at 15 mm of slip."""
    verdict = judge(solve(drive(150e3, 10e3, load_lagging("diamond-rubber"))))
    (check,) = (c for c in verdict.checks if c.name == "gross_slip")
    assert check.value < 1.0
    assert "by tested slip" in check.title
    assert "the slip reaches the end of the tests" in check.sentence().lower()
    assert "allow" not in verdict.headline()


def test_where_no_creep_carries_the_pull_the_sentence_is_one() -> None:
    """At the edge of what friction ever carries: less than the pull, in one sentence."""
    head = WrapArc.of(drive(), drive().pulleys[0], drive().load_cases[0])
    assert head.law.steepest_fall() == 0.0
    verdict = judge(solve(drive(450e3, 200e3, diameter=0.5), raise_on_failure=False))
    sentence = verdict.headline()
    assert "no creep carries the pull" in sentence
    assert "at 1 times" not in sentence
