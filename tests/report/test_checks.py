"""Checks against limits: pass and fail told by word and sign, margins by hand."""

import math
from dataclasses import replace

import pytest

from present.drives import BELT, drive, marched, solved
from wraparc import Constant, Drive, Lagging, load_lagging, solve
from wraparc.report.checks import Check, Outcome, check_table, checks, margin_text


def found(of: Drive) -> dict[str, Check]:
    return {c.title: c for c in checks(solve(of, raise_on_failure=False))}


def test_the_margin_is_positive_on_the_safe_side() -> None:
    """By hand: 4 of at most 5 leaves a fifth; 6 of at least 5 a fifth as well."""
    under = Check("a", Outcome.PASS, found=4.0, limit=5.0)
    over = Check("b", Outcome.PASS, found=6.0, limit=5.0, at_most=False)
    assert under.margin == pytest.approx(0.2)
    assert over.margin == pytest.approx(0.2)
    assert replace(under, found=6.0).margin == pytest.approx(-0.2)
    assert math.isnan(Check("c", Outcome.NOT_KNOWN).margin)


def test_creep_passes_up_to_its_limit_and_fails_beyond() -> None:
    creep = solved().arc("head").exit_creep
    for factor, outcome in ((1.001, Outcome.PASS), (1.0, Outcome.PASS), (0.999, Outcome.FAIL)):
        check = found(replace(drive(), creep_limit=factor * creep))["Creep at exit"]
        assert check.outcome is outcome, factor
        assert check.found == pytest.approx(creep)
        assert check.margin == pytest.approx(1.0 - 1.0 / factor, abs=1e-9)


def test_the_slack_side_is_held_against_the_least_one() -> None:
    least = solved().arc("head").capacities.least_exit_tension
    check = found(drive())["Slack-side tension for the creep limit"]
    assert check.outcome is Outcome.FAIL
    assert check.found == 60e3
    assert check.limit == pytest.approx(least)
    enough = found(drive(90e3 + 1.02 * least, 1.02 * least))
    assert enough["Slack-side tension for the creep limit"].outcome is Outcome.PASS


def test_cema_asks_for_its_wrap_factor() -> None:
    """Cw = 1/(exp(0.35 pi) - 1) = 0.4993 of 90 kN is 44.94 kN (CEMA, rubber lagged)."""
    check = found(drive())["Slack side by CEMA, friction 0.35 (rubber)"]
    assert check.limit == pytest.approx(90e3 / math.expm1(0.35 * math.pi))
    assert check.limit == pytest.approx(44.94e3, rel=1e-3)
    assert check.outcome is Outcome.PASS
    less = found(drive(120e3, 30e3))["Slack side by CEMA, friction 0.35 (rubber)"]
    assert less.outcome is Outcome.FAIL
    assert less.sign == "−"


def test_the_belt_is_held_against_its_rating() -> None:
    """150 kN on 1.2 m at 175 kN/m: 210 kN, a margin of 2/7."""
    check = found(drive())["Belt tension, rated"]
    assert check.margin == pytest.approx(2.0 / 7.0)
    assert check.outcome is Outcome.PASS
    over = found(drive(211e3, 120e3))["Belt tension, rated"]
    assert over.outcome is Outcome.FAIL
    unknown = found(drive(belt=replace(BELT, rating=None)))["Belt tension, rated"]
    assert unknown.outcome is Outcome.NOT_KNOWN
    assert unknown.sign == "?"


def test_the_diameter_is_held_against_the_least_of_the_belt() -> None:
    small = found(drive(belt=replace(BELT, least_pulley_diameter=0.801)))
    assert small["Pulley diameter, least for the belt"].outcome is Outcome.FAIL
    fits = found(drive(belt=replace(BELT, least_pulley_diameter=0.8)))
    assert fits["Pulley diameter, least for the belt"].outcome is Outcome.PASS
    assert "Pulley diameter, least for the belt" not in found(drive())


def test_the_tested_range_is_held_at_both_ends() -> None:
    """p = 2 T/(B D): 150 and 60 kN on 1.2 by 0.8 m are 312.5 and 125 kPa."""
    there = found(drive())
    assert there["Largest wrap pressure, tested"].found == pytest.approx(312.5e3)
    assert there["Least wrap pressure, tested"].found == pytest.approx(125e3)
    assert there["Largest wrap pressure, tested"].limit == pytest.approx(690e3)
    high = found(drive(340e3, 200e3))["Largest wrap pressure, tested"]
    assert high.outcome is Outcome.FAIL
    plain = Lagging(name="plain", law=Constant(friction_coefficient=0.4), thickness=0.012,
                    shear_modulus=2.3e6)  # fmt: skip
    untested = found(drive(lagging=plain, overrun=0.0))
    assert untested["Wrap pressure and slip in the tested range"].outcome is Outcome.NOT_KNOWN


def test_a_breakaway_fails_and_keeps_its_place() -> None:
    broken = found(drive(180e3, 1e3))
    assert broken["Friction carries the load"].outcome is Outcome.FAIL
    assert broken["Creep at exit"].outcome is Outcome.FAIL
    assert "breaks away: pulley head" in broken["Creep at exit"].where


def test_each_check_is_that_of_the_arc_that_comes_off_worst() -> None:
    base = drive()
    light = replace(base.load_cases[0], name="light", tensions=drive(80e3).load_cases[0].tensions)
    both = found(replace(base, load_cases=(light, *base.load_cases)))
    assert both["Creep at exit"].where == "pulley head, load case full"
    assert both["Least wrap pressure, tested"].where.endswith("light") or (
        both["Least wrap pressure, tested"].found == pytest.approx(125e3)
    )


def test_idling_pulls_nothing() -> None:
    idle = found(drive(100e3, 100e3, load_lagging("full-ceramic"), overrun=0.0))
    assert idle["Slack-side tension for the creep limit"].where == "no pull to carry"
    assert not [title for title in idle if "CEMA" in title]


def test_the_table_says_it_in_words_and_signs() -> None:
    table = check_table(checks(solved()), "si")
    rows = {row.title: row for row in table.rows}
    assert rows["Creep at exit"].values == (
        "at most 6.350 mm", "7.377 mm", "−16.2 %", "− FAIL",
    )  # fmt: skip
    assert rows["Belt tension, rated"].values[2:] == ("+28.6 %", "+ PASS")
    assert [margin_text(m) for m in (0.0, 0.99999, -1e-3)] == ["0 %", "> +99.9 %", "−0.1 %"]


def test_a_method_without_capacities_fails_nothing_for_it() -> None:
    """The paper's march alone: its slack side and its energy balance are not known, not failed."""
    told = {c.title: c for c in checks(marched())}
    slack = told["Slack-side tension for the creep limit"]
    assert (slack.outcome, slack.where) == (Outcome.NOT_KNOWN, "the method finds no capacities")
    assert "Energy balance of the solution" not in told
