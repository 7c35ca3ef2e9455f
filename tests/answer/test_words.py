"""The verdict: whole sentences, for every way an arc can end. Numbers are those of the result."""

import math
from dataclasses import replace

import pytest

from answer.drives import BELT, STICKY, drive, marched, solved, sticking
from wraparc import Lagging, LoadCase, PaperMarch, Tensions, load_lagging, solve
from wraparc.answer.sheet import shown
from wraparc.answer.sheet import shown as told_in
from wraparc.answer.words import level_of, short, verdict
from wraparc.checks import Level, least_tension
from wraparc.units import System


def test_within_the_limit() -> None:
    told = told_in(verdict(solved(100e3, 70e3)), "si")
    result = solved(100e3, 70e3).arc("head")
    least = 34e3 * 1.2 * 0.8 / 2.0  # the least pressure tested, 34 kPa, asks for most
    assert result.capacities.least_exit_tension < least
    assert told.level is Level.OK
    assert told.told == "OK, on illustrative data"
    assert told.headline.startswith("All ")
    assert "nearest to its limit is belt tension" in told.headline
    assert "100 kN, at most 210 kN" in told.headline
    assert told.sentences == (
        "The least slack-side tension with which every check that it helps passes is "
        f"{least / 1e3:.2f} kN, set by the least wrap pressure tested (pulley head, load case "
        "full); given 70 kN.",
        "Wet: creep 2.33 mm (estimated) passes.",
    )


def test_over_the_limit() -> None:
    told, result = told_in(verdict(solved()), "si"), solved().arc("head")
    least = result.capacities.least_exit_tension / 1e3
    assert told.level is Level.ATTENTION
    assert told.headline.startswith(
        f"Pulley head, load case full: Creeps {1e3 * result.exit_creep:.2f} mm, more than the "
        "limit of 6.35 mm. Practice may allow this belt up to 12.7 mm"
    )
    assert told.sentences[0] == (
        "The least slack-side tension with which every check that it helps passes is "
        f"{math.ceil(10.0 * least) / 10.0:.1f} kN, set by the creep limit (pulley head, load case "
        "full); given 60 kN."
    )


def test_a_standard_that_does_not_bind_sets_it_too() -> None:
    firm = load_lagging("full-ceramic")
    result = solve(drive(150e3, 60e3, firm))
    sentence = told_in(verdict(result), "si").sentences[0]
    asked = 90.0 / math.expm1(0.5 * math.pi)
    least = least_tension(result)
    assert least is not None
    assert least.tension == pytest.approx(asked * 1e3)
    shown = f"{math.ceil(10.0 * asked) / 10.0:.1f} kN"
    assert f"passes is {shown}, set by the design standard" in sentence


def test_no_slack_side_helps() -> None:
    told = told_in(verdict(solved(186e3, 60e3)), "si")
    assert told.sentences[0] == (
        "No slack-side tension with wrap pressures in the tested range keeps the creep limit "
        "(pulley head, load case full)."
    )
    assert "Raise the slack-side tension" not in " ".join((told.headline, *told.sentences))


def test_breakaway_of_a_law_that_never_falls() -> None:
    told, result = told_in(verdict(solved(150e3, 2e3)), "si"), solved(150e3, 2e3).arc("head")
    c = result.capacities
    assert told.level is Level.FAILS
    assert told.headline.startswith("Pulley head, load case full: Gross slip: no creep carries")
    assert told.headline.endswith("choose a lagging with more friction.")
    assert told.sentences[-1] == (
        f"Asked for T1/T2 = 75; at the creep limit it carries T1/T2 = {c.creep_limit_capacity:.2f}."
    )


def test_breakaway_of_a_braking_pulley_speaks_of_its_own_side() -> None:
    result = solved(2e3, 150e3)
    told, c = told_in(verdict(result), "si"), result.arc("head").capacities
    assert (
        f"at the creep limit it carries T1/T2 = {1 / c.creep_limit_capacity:.3f}."
        in told.sentences[-1]
    )
    assert "given 70 kN" in told_in(verdict(solved(70e3, 100e3)), "si").sentences[0]


def test_what_lies_outside_the_tests_is_told() -> None:
    told = told_in(verdict(sticking()), "si")
    text = " ".join((told.headline, *told.sentences))
    assert "above the 300 kPa tested on lagging sticky" in text
    assert "below the 140 kPa" in text
    assert "beyond the 2 mm" in text


def test_several_arcs_and_the_one_that_governs() -> None:
    base = drive()
    cases = [
        LoadCase(name=name, tensions={"head": Tensions(entry=entry, exit=leaving)})
        for name, entry, leaving in (
            ("full", 150e3, 60e3), ("empty", 80e3, 60e3), ("start", 150e3, 2e3),
        )
    ]  # fmt: skip
    several = solve(replace(base, load_cases=tuple(cases)), raise_on_failure=False)
    told = told_in(verdict(several), "si")
    assert told.level is Level.FAILS
    assert told.headline.startswith("Pulley head, load case start: Gross slip")
    assert any("ATTENTION: Pulley head, load case full: Creeps" in s for s in told.sentences)
    answers = [short(several, arc) for arc in several]
    assert answers == ["over creep limit", "carries", "breaks away"]
    assert [level_of(several, arc) for arc in several] == [
        Level.ATTENTION, Level.OK, Level.FAILS,
    ]  # fmt: skip


def test_the_paper_march_has_no_least_tension() -> None:
    told = told_in(verdict(marched()), "si")
    assert told.level is Level.ATTENTION
    assert not any("least slack-side" in s for s in told.sentences)
    broken = solve(drive(150e3, 2e3), method=PaperMarch(), raise_on_failure=False)
    assert "Gross slip" in told_in(verdict(broken), "si").headline


def test_a_surface_without_design_values_is_not_compared() -> None:
    plain = Lagging(name="plain", law=STICKY.law, thickness=0.012, shear_modulus=2.3e6)
    result = solve(drive(100e3, 70e3, plain, BELT, overrun=0.0))
    assert not any("CEMA" in s for s in told_in(verdict(result), "si").sentences)


def test_us_units_reach_every_sentence() -> None:
    told = shown(verdict(solved()), "us")
    text = " ".join((told.headline, *told.sentences))
    assert "0.25 in" in text
    for unit in ("mm", "kN", "kPa"):
        assert f" {unit}" not in text


@pytest.mark.parametrize("system", ["si", "us"])
def test_no_sentence_runs_into_the_next(system: System) -> None:
    for result in (solved(), solved(150e3, 2e3), solved(100e3, 70e3), sticking()):
        told = shown(verdict(result), system)
        for sentence in (told.headline, *told.sentences):
            assert sentence[0].isalnum()
            assert sentence.endswith(".")
            assert "  " not in sentence
            assert "nan" not in sentence
            assert "inf" not in sentence.split()
