"""The verdict: whole sentences, for every way an arc can end. Numbers are those of the result."""

import math
from dataclasses import replace

import pytest

from present.drives import BELT, STICKY, drive, marched, solved, sticking
from wraparc import Lagging, LoadCase, PaperMarch, Status, Tensions, solve
from wraparc.present.sheet import Level
from wraparc.present.words import verdict


def test_within_the_limit() -> None:
    told = verdict(solved(100e3, 70e3))
    result = solved(100e3, 70e3).arc("head")
    least = result.capacities.least_exit_tension / 1e3
    asked = 30.0 / math.expm1(0.35 * math.pi)
    assert told.level is Level.GOOD
    assert told.headline == (
        f"The pulley carries its load; its creep, {1e3 * result.exit_creep:.3f} mm, is within the "
        "limit of 6.350 mm."
    )
    assert told.sentences == (
        "For the same effective tension 30.00 kN the slack side T2 could fall from 70.00 kN to "
        f"{least:.3f} kN before the creep reaches its limit.",
        f"CEMA's design value 0.35 for rubber asks for {asked:.2f} kN on the slack side; within "
        f"the creep limit this pulley needs {least:.3f} kN, {100 * (1 - least / asked):.0f} % "
        "less.",
    )


def test_over_the_limit() -> None:
    told, result = verdict(solved()), solved().arc("head")
    least = result.capacities.least_exit_tension / 1e3
    assert told.level is Level.WARNING
    assert told.headline == (
        f"The pulley carries its load, but creeps {1e3 * result.exit_creep:.3f} mm, more than the "
        "limit of 6.350 mm."
    )
    assert told.sentences[0] == (
        "To carry the same effective tension 90.00 kN within the creep limit, the slack side T2 "
        f"must rise from 60.00 kN to {least:.2f} kN."
    )
    assert told.sentences[1] == (
        "6.350 mm is a conservative limit; more may be tolerated for steel cord belts above "
        "ST1600 and fabric belts above 140.0 kN/m of working tension."
    )
    assert "99 % more." in told.sentences[2]


def test_a_limit_of_ones_own_is_not_called_conservative() -> None:
    own = replace(drive(), creep_limit=7e-3)
    assert not any("conservative" in s for s in verdict(solve(own)).sentences)


def test_no_slack_side_helps() -> None:
    told, result = verdict(solved(186e3, 60e3)), solved(186e3, 60e3).arc("head")
    most = result.capacities.largest_effective_tension / 1e3
    assert told.sentences[0] == (
        "No slack-side tension with wrap pressures in the tested range carries 126.0 kN within "
        f"the creep limit; the largest pull carried so is {most:.1f} kN."
    )


def test_breakaway_of_a_law_that_never_falls() -> None:
    told, result = verdict(solved(150e3, 2e3)), solved(150e3, 2e3).arc("head")
    c = result.capacities
    assert told.level is Level.BAD
    assert told.headline == str(Status.BREAKAWAY)
    assert told.sentences[:2] == (
        f"Asked for T1/T2 = 75.00; the largest the friction can carry is "
        f"{c.gross_slip_capacity:.2f}, which no finite creep attains (an extrapolation of the "
        "friction law).",
        f"At the creep limit it carries T1/T2 = {c.creep_limit_capacity:.3f}.",
    )


def test_breakaway_of_a_braking_pulley_speaks_of_its_own_side() -> None:
    result = solved(2e3, 150e3)
    told, c = verdict(result), result.arc("head").capacities
    assert (
        f"the smallest the friction can carry is {1 / c.gross_slip_capacity:.5f}"
        in (told.sentences[0])
    )
    assert (
        verdict(solved(70e3, 100e3))
        .sentences[0]
        .startswith(
            "For the same effective tension 30.00 kN the slack side T1 could fall from 70.00 kN to "
        )
    )


def test_the_share_outside_the_tested_range_is_told() -> None:
    result = sticking()
    share = 100.0 * result.arc("head").outside_tested_share
    assert 1.0 < share < 99.0
    assert verdict(result).sentences[-1] == (
        f"On {share:.1f} % of the wrap pressure or slip lies outside what the lagging was tested "
        "in: there the friction is an extrapolation."
    )


def test_several_arcs_are_counted_and_the_governing_one_named() -> None:
    base = drive()
    cases = [
        LoadCase(name=name, tensions={"head": Tensions(entry=entry, exit=leaving)})
        for name, entry, leaving in (
            ("full", 150e3, 60e3), ("empty", 80e3, 60e3), ("start", 150e3, 2e3),
        )
    ]  # fmt: skip
    several = solve(replace(base, load_cases=tuple(cases)), raise_on_failure=False)
    told = verdict(several)
    assert told.level is Level.BAD
    assert told.headline == (
        "Of 3 arcs (pulleys and load cases) 1 cannot carry their load and 1 creeps more than the "
        f"limit. Governing: pulley head, load case start. {Status.BREAKAWAY}"
    )
    calm = solve(replace(base, load_cases=(cases[1], replace(cases[1], name="idle"))))
    assert verdict(calm).headline.startswith(
        "All 2 arcs carry their load within the creep limit. Governing: pulley head, load case "
        "empty. "
    )


def test_the_paper_march_has_no_capacities_to_speak_of() -> None:
    told = verdict(marched())
    assert told.level is Level.WARNING
    assert len(told.sentences) == 1
    broken = solve(drive(150e3, 2e3), method=PaperMarch(), raise_on_failure=False)
    assert "the largest the friction can carry is" in verdict(broken).sentences[0]


def test_a_surface_without_design_values_is_not_compared() -> None:
    plain = Lagging(name="plain", law=STICKY.law, thickness=0.012, shear_modulus=2.3e6)
    result = solve(drive(100e3, 70e3, plain, BELT, overrun=0.0))
    assert not any("CEMA" in s for s in verdict(result).sentences)


def test_us_units_reach_every_sentence() -> None:
    told = verdict(solved(), "us")
    text = " ".join((told.headline, *told.sentences))
    assert "0.2500 in" in text
    for unit in ("mm", "kN", "kPa"):
        assert f" {unit}" not in text


@pytest.mark.parametrize("system", ["si", "us"])
def test_no_sentence_runs_into_the_next(system: str) -> None:
    for result in (solved(), solved(150e3, 2e3), solved(100e3, 70e3), sticking()):
        told = verdict(result, system)  # type: ignore[arg-type]
        for sentence in (told.headline, *told.sentences):
            assert sentence[0].isalnum()
            assert sentence.endswith(".")
            assert "  " not in sentence
            assert "nan" not in sentence
            assert "inf" not in sentence.split()
