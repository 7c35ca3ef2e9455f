"""The pull at which a belt slides: solved anew at that pull, the belt does what is said of it.

Expected values are the limits themselves: a creep of 63.5 mm, the largest slip of the tests; and
the closed form exp(mu phi) of constant friction under a lagging that hardly shears.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from answer.drives import drive
from arc.drives import SOFTENING, integral_log
from checks.test_least_tension import random_drives
from checks.test_rows import quiet, rigid
from wraparc import Drive, Tensions, load_lagging, solve
from wraparc.arc import ArcResult, Distributed, WrapArc
from wraparc.arc.grip import Rise, lift, loaded_arc, sliding
from wraparc.arc.gross_slip import Line
from wraparc.arc.sliding import (
    CREEP,
    MOST,
    SLIDES,
    TESTED,
    at_limits,
    carried_at,
    pull_at_sliding,
)
from wraparc.arc.sliding import tight_at_sliding as tight_of_one
from wraparc.batch import Setting
from wraparc.batch import sliding as sliding_rows
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.batch.sliding import LoadedRows, pulls_at_sliding, tight_at_sliding
from wraparc.checks import Level, judge
from wraparc.checks.gross_slip import rises
from wraparc.drive import Lagging, TakeUp
from wraparc.files.write import drive_document
from wraparc.friction import PressureKnots
from wraparc.study.source import DriveSource
from wraparc.units import in_units

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
    rise = rises([arc.arc], 0, of.criteria.take_up)
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
    found = sliding(arc, rises([arc.arc], 0, TakeUp(kind="fixed" if fixed else "gravity")))
    r = math.exp(0.35 * math.pi)
    own = 40e3 * (r - 1.0) / 60e3 if not fixed else 140e3 * (r - 1.0) / (r + 1.0) / 60e3
    assert found.place == pytest.approx(own, rel=1e-6)
    assert found.cause == MOST


def test_the_largest_friction_of_a_law_that_falls_comes_first() -> None:
    """No pull beyond it is carried, and one just below it is."""
    of = untested(drive(lagging=replace(load_lagging("diamond-rubber"), law=SOFTENING)))
    (arc,) = solve(of, method=QUICK, raise_on_failure=False)
    rise = rises([arc.arc], 0, of.criteria.take_up)
    found = sliding(arc, rise)
    assert found.cause in (MOST, CREEP)
    if found.cause == MOST:
        assert abs(at_pull(of, rise, found.place * (1.0 - 1e-3)).exit_creep) < SLIDES


@pytest.mark.parametrize("number", [1, 6, 9])
def test_the_tension_for_a_safety_gives_that_safety(number: int) -> None:
    of = random_drives(10)[number]
    (arc,) = solve(of, method=QUICK, raise_on_failure=False)
    rise = rises([arc.arc], 0, of.criteria.take_up)
    raised = at_lift(of, lift(arc, 1.6, rise.tight))
    assert sliding(raised, rises([raised.arc], 0, of.criteria.take_up)).place == pytest.approx(1.6)


def at_lift(of: Drive, more: float) -> ArcResult:
    (case,) = of.load_cases
    t = case.tensions["head"]
    tensions = {"head": Tensions(entry=t.entry + more, exit=t.exit + more)}
    (arc,) = solve(replace(of, load_cases=(replace(case, tensions=tensions),)), method=QUICK)
    return arc


def test_rows_find_the_pulls_of_single_arcs() -> None:
    """Place, cause and least tension, to the accuracy of the rows."""
    for number in (0, 3, 6, 9):
        of = random_drives(10)[number]
        rows = DriveSource(drive_document(of), "head", ()).rows({}, 1, of.load_cases[0].name)
        arc = solve(of, method=QUICK, raise_on_failure=False).arcs[0]
        rise = rises([arc.arc], 0, of.criteria.take_up)
        one = sliding(arc, rise)
        many = LoadedRows.of(rows.arcs, setting=Setting.PRECISE)
        place, cause = pulls_at_sliding(many, (np.array([rise.tight]), np.array([rise.slack])))
        assert place[0] == pytest.approx(one.place, rel=1e-5)
        assert cause[0] == one.cause
        pull = abs(arc.arc.effective_tension)
        least = tight_at_sliding(many, np.array([1.4 * pull]))[0]
        tight = max(arc.arc.entry_tension, arc.arc.exit_tension)
        raised = lift(arc, 1.4, 0.0)
        assert least - tight == pytest.approx(raised, rel=1e-4, abs=1e-5 * tight)


#: How the tensions of the tight and the slack side grow with the pull, over it.
LINES = {"slack held": (1.0, 0.0), "sum held": (0.5, -0.5), "both grow": (1.5, 0.5)}


def designs(side: float, lagging: Lagging, n: int) -> Arcs:
    """Return drives with fabric and steel-cord belts, side 1 driving and -1 braking."""
    rng = np.random.default_rng(5)
    tight = rng.uniform(80e3, 200e3, n)
    slack = tight / rng.uniform(1.3, 3.0, n)
    return arcs_of_table(
        {
            "entry_tension": tight if side > 0.0 else slack,
            "exit_tension": slack if side > 0.0 else tight,
            "diameter": rng.uniform(0.5, 1.2, n),
            "wrap_angle": rng.uniform(2.9, 3.7, n),
            "belt_width": rng.uniform(0.8, 1.6, n),
            "belt_modulus": np.exp(rng.uniform(np.log(5e6), np.log(1.2e8), n)),
        },
        lagging,
    )


def rubber_tested_to(slip: float) -> Lagging:
    """Return diamond rubber as if its tests had gone so far, beyond which creep comes first."""
    lagging = load_lagging("diamond-rubber")
    tested = lagging.law.tested
    assert tested is not None
    law = replace(lagging.law, tested=replace(tested, slip_max=slip))  # type: ignore[call-arg]
    return replace(lagging, law=law)


LAGGINGS = {
    "tests first": load_lagging("diamond-rubber"),
    "ceramic": load_lagging("full-ceramic"),
    "slip or creep": rubber_tested_to(57e-3),
}


@pytest.mark.parametrize("name", LAGGINGS)
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_many_arcs_slide_where_each_does(
    name: str, side: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Pulls, causes and least tensions as the scalar solver has them, and without a search."""

    def searches(of: LoadedRows, *_: object) -> tuple[Any, Any]:
        assert len(of.arcs) == 0
        return np.empty(0), np.empty(0, dtype=np.int8)

    def searched(*_: object) -> None:
        raise AssertionError("a search")

    monkeypatch.setattr(sliding_rows, "_places", searches)
    monkeypatch.setattr("wraparc.arc.sliding.slide_place", searched)
    lagging = LAGGINGS[name]
    arcs = designs(side, lagging, 4)
    many = LoadedRows.of(arcs, setting=Setting.PRECISE)
    singles = [loaded_arc(arcs.arc(i, [lagging.law])) for i in range(4)]
    assert [one.peaks for one in singles] == many.peaks.tolist() == [False] * 4
    begun = [at_limits(one) for one in singles]
    tight = np.maximum(arcs.entry_tension, arcs.exit_tension)
    slack = np.minimum(arcs.entry_tension, arcs.exit_tension)
    for up, down in LINES.values():
        rise = up * (tight - slack), down * (tight - slack)
        place, cause = pulls_at_sliding(many, rise)
        for i, one in enumerate(singles):
            line = Line(tight[i], slack[i], rise[0][i], rise[1][i])
            expected = pull_at_sliding(one, line, begun[i])
            assert place[i] == pytest.approx(expected.place, rel=2e-6)
            assert cause[i] == expected.cause
    least = tight_at_sliding(many, 1.2 * (tight - slack))
    for i, one in enumerate(singles):
        expected_least = tight_of_one(one, 1.2 * float(tight[i] - slack[i]), begun[i])
        assert least[i] == pytest.approx(expected_least, rel=2e-6)


@pytest.mark.parametrize("free", [True, False])
def test_a_law_whose_peak_carries_most_is_known_without_its_capacities(free: bool) -> None:
    """A law free of pressure, and one of several pressures; rows as the scalar solver has them."""
    law = integral_log(slope=-10.0, residual=0.4)
    if not free:
        knots = SOFTENING.coefficients
        assert isinstance(knots, PressureKnots)
        steep = tuple(6.0 * slope for slope in knots.post_peak_slope)
        low = tuple(0.4 * left for left in knots.residual_friction)
        knots = replace(knots, post_peak_slope=steep, residual_friction=low)
        law = replace(SOFTENING, coefficients=knots)
    arcs = designs(1.0, replace(load_lagging("diamond-rubber"), law=law), 3)
    for i, peaks in enumerate(LoadedRows.of(arcs).peaks.tolist()):
        arc = arcs.arc(i, [law])
        assert math.isfinite(Distributed().solve(arc).capacities.gross_slip_creep)
        assert peaks
        assert loaded_arc(arc).peaks


@pytest.mark.parametrize("number", [4, 6, 8])
def test_where_both_sides_grow_the_belt_is_where_it_slides(number: int) -> None:
    """A pulley in front of another: its ratio of tensions grows slowly, to one it carries not."""
    of = random_drives(10)[number]
    (arc,) = solve(of, method=QUICK, raise_on_failure=False)
    pull = abs(arc.arc.effective_tension)
    rise = Rise(1.6 * pull, 0.6 * pull)
    found = sliding(arc, rise)
    there = at_pull(of, rise, found.place)
    tested = arc.arc.law.tested
    assert tested is not None
    slip = float(np.abs(there.profile.slip).max())
    at_slip = slip == pytest.approx(tested.slip_max, rel=1e-5)
    assert at_slip if found.cause == TESTED else abs(there.exit_creep) == pytest.approx(SLIDES)


@pytest.mark.parametrize("number", [0, 3])
def test_where_both_sides_grow_a_belt_that_slides_already_is_said_to(number: int) -> None:
    """It carries less than it is asked: with less pull its slack side would pass through none."""
    of = random_drives(10)[number]
    (arc,) = solve(of, method=QUICK, raise_on_failure=False)
    t = of.load_cases[0].tensions["head"]
    tight = max(t.entry, t.exit)
    carried = math.exp(carried_at(loaded_arc(arc.arc, math.inf), tight)[0])
    assert carried < tight / min(t.entry, t.exit)
    pull = abs(arc.arc.effective_tension)
    assert 0.0 < sliding(arc, Rise(1.6 * pull, 0.6 * pull)).place < 1.0


@pytest.mark.parametrize("number", [0, 3, 6])
def test_with_the_tight_side_held_it_slides_at_its_capacity(number: int) -> None:
    """Of ln(T_tight/T_slack) at the tested slip or the creep of sliding, found with it held."""
    of = random_drives(10)[number]
    (arc,) = solve(of, method=QUICK, raise_on_failure=False)
    tight = max(arc.arc.entry_tension, arc.arc.exit_tension)
    pull = abs(arc.arc.effective_tension)
    carried, cause = carried_at(loaded_arc(arc.arc, math.inf), tight)
    found = sliding(arc, Rise(0.0, -pull))
    assert found.place == pytest.approx(tight * -math.expm1(-carried) / pull, rel=1e-6)
    assert found.cause == cause


def test_a_drive_beyond_its_tests_is_never_ok() -> None:
    """15 to 1 on diamond rubber: it creeps 43 mm, where the tests ended at 15 mm of slip."""
    verdict = judge(solve(drive(150e3, 10e3, load_lagging("diamond-rubber"))))
    (check,) = (c for c in verdict.checks if c.name == "gross_slip")
    assert check.value < 1.0
    assert check.level is Level.ATTENTION  # it is not known to slide
    assert verdict.governing is check
    said = in_units(verdict.text)
    assert said.startswith("Tested friction transmits 0.")
    assert said.endswith(" times Te, minimum 1.25 (head, full).")


def test_where_no_creep_carries_the_pull_the_sentence_is_one() -> None:
    """At the edge of what friction ever carries: less than the pull, in one sentence."""
    head = WrapArc.of(drive(), drive().pulleys[0], drive().load_cases[0])
    assert head.law.steepest_fall() == 0.0
    verdict = judge(solve(drive(450e3, 200e3, diameter=0.5), raise_on_failure=False))
    assert in_units(verdict.text) == "Gross slip: safety 0.547 is below 1 (head, full)."
