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
    assert told.word == "OK"
    assert told.text == "All 11 checks pass. Closest: belt tension 100 of 210 kN (head, full)."
    assert told.action is None
    assert told.wet == "Creep 2.33 mm (estimated) passes."
    assert told.data == "Friction, block, E_c illustrative; G estimated."
    assert told.sentences == (
        f"Minimum T2 {least / 1e3:.2f} kN (Minimum wrap pressure, head, full); now 70 kN.",
    )


def test_over_the_limit() -> None:
    told, result = told_in(verdict(solved()), "si"), solved().arc("head")
    least = result.capacities.least_exit_tension / 1e3
    assert told.level is Level.ATTENTION
    creep = f"{1e3 * result.exit_creep:.2f} mm"
    assert told.text == f"Creep {creep} exceeds the 6.35 mm limit (head, full)."
    assert told.sentences == (
        f"Minimum T2 {math.ceil(10.0 * least) / 10.0:.1f} kN (Creep, head, full); now 60 kN.",
        "Creep: DeVries allows 12.7 mm for this belt (creep_limit).",
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
    assert sentence == f"Minimum T2 {shown} (T2 by CEMA, head, full); now 60 kN."


def test_no_slack_side_helps() -> None:
    told = told_in(verdict(solved(186e3, 60e3)), "si")
    assert told.sentences[0] == (
        "No T2 in the tested pressure range meets the creep limit (head, full)."
    )
    assert told.action is not None
    assert "T2" not in told.action.text


def test_breakaway_of_a_law_that_never_falls() -> None:
    told, result = told_in(verdict(solved(150e3, 2e3)), "si"), solved(150e3, 2e3).arc("head")
    c = result.capacities
    assert told.level is Level.FAILS
    assert told.text == "Gross slip: safety 0.214 is below 1 (head, full)."
    assert told.sentences[-1] == (
        f"T1/T2 required: 75; transmissible at the creep limit: {c.creep_limit_capacity:.2f}."
    )


def test_breakaway_of_a_braking_pulley_speaks_of_its_own_side() -> None:
    result = solved(2e3, 150e3)
    told, c = told_in(verdict(result), "si"), result.arc("head").capacities
    limit = 1 / c.creep_limit_capacity
    assert told.sentences[-1] == (
        f"T1/T2 required: 0.0133; transmissible at the creep limit: {limit:.3f}."
    )
    sentence = told_in(verdict(solved(70e3, 100e3)), "si").sentences[0]
    assert sentence.startswith("Minimum slack-side tension T1 ")
    assert sentence.endswith("; now 70 kN.")


def test_what_lies_outside_the_tests_is_told() -> None:
    told = told_in(verdict(sticking()), "si")
    text = " ".join(other.text for other in told.also)
    assert "exceeds the tested 300 kPa" in text
    assert "is below the tested 140 kPa" in text
    assert "exceeds the tested 2 mm" in text
    assert "Slip, tested range: There the friction is extrapolated." in told.sentences


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
    assert told.text == "Gross slip: safety 0.214 is below 1 (head, start)."
    assert told.also[0].level is Level.ATTENTION
    assert told.also[0].text == "Creep 7.49 mm exceeds the 6.35 mm limit (head, full)."
    answers = [short(several, arc) for arc in several]
    assert answers == ["ATTENTION creep", "OK", "FAILS gross slip"]
    assert [level_of(several, arc) for arc in several] == [
        Level.ATTENTION, Level.OK, Level.FAILS,
    ]  # fmt: skip


def test_the_paper_march_has_no_least_tension() -> None:
    told = told_in(verdict(marched()), "si")
    assert told.level is Level.ATTENTION
    assert not any("Minimum T2" in s for s in told.sentences)
    broken = solve(drive(150e3, 2e3), method=PaperMarch(), raise_on_failure=False)
    assert told_in(verdict(broken), "si").text.startswith("Gross slip: safety ")


def test_a_surface_without_design_values_is_not_compared() -> None:
    plain = Lagging(name="plain", law=STICKY.law, thickness=0.012, shear_modulus=2.3e6)
    result = solve(drive(100e3, 70e3, plain, BELT, overrun=0.0))
    assert not any("CEMA" in s for s in told_in(verdict(result), "si").sentences)


def test_us_units_reach_every_sentence() -> None:
    told = shown(verdict(solved()), "us")
    text = " ".join((told.text, *told.sentences))
    assert "0.25 in" in text
    for unit in ("mm", "kN", "kPa"):
        assert f" {unit}" not in text


@pytest.mark.parametrize("system", ["si", "us"])
def test_no_sentence_runs_into_the_next(system: System) -> None:
    for result in (solved(), solved(150e3, 2e3), solved(100e3, 70e3), sticking()):
        told = shown(verdict(result), system)
        for sentence in (told.text, *told.sentences):
            assert sentence[0].isalnum()
            assert sentence.endswith(".")
            assert "  " not in sentence
            assert "nan" not in sentence
            assert "inf" not in sentence.split()
