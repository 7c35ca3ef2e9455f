"""A load case whose name says that it starts or stops, and whose kind is running.

Expected: names that users give, sorted by hand.
"""

from dataclasses import replace
from pathlib import Path

import pytest

from checks.test_rows import judged, quiet
from cli.running import DRIVE, drive_file, wraparc
from judgement.rows import BASE
from wraparc import solve
from wraparc.actions import find_action
from wraparc.checks import Check, Level, judge
from wraparc.drive import CaseKind, Drive
from wraparc.files import drive_from_text
from wraparc.units import in_units


def renamed(name: str, kind: CaseKind = "running") -> Drive:
    """Return a drive that passes every check, its load case under another name."""
    of = quiet(kind=kind)
    return replace(of, load_cases=(replace(of.load_cases[0], name=name),))


def asked(name: str, kind: CaseKind = "running") -> list[Check]:
    return [c for c in judged(renamed(name, kind)).checks if c.name == "case_kind"]


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("start", "starting"), ("Start", "starting"), ("full start", "starting"),
        ("start_full", "starting"), ("start, wet", "starting"), ("startup", "starting"),
        ("start-up 130 %", "starting"), ("starting (loaded)", "starting"), ("start2", "starting"),
        ("restart", "starting"), ("acceleration", "starting"),
        ("stop", "braking"), ("emergency stop", "braking"), ("E-Stop", "braking"),
        ("stopping", "braking"), ("brake", "braking"), ("Braking, full", "braking"),
        ("service brake", "braking"), ("{stop}", "braking"), ("aborted start: stop", "starting"),
    ],
)  # fmt: skip
def test_a_name_that_says_start_or_stop_is_asked_about(name: str, kind: str) -> None:
    (check,) = asked(name)
    shown = f'"{name}"' if "," in name else name
    assert in_units(check.text) == f"Load case {shown} is judged as running."
    assert check.action_text == f'Set kind = "{kind}" in load case {shown}.'
    assert check.level is Level.ATTENTION
    assert judged(renamed(name)).level is Level.ATTENTION
    assert not asked(name, "starting")
    assert not asked(name, "braking")
    assert judged(renamed(name, "starting")).level is Level.OK


@pytest.mark.parametrize(
    "name",
    [
        "design", "full", "standstill", "unstoppable", "Startdorf", "brakeless", "stopped", "rest",
        "downhill, braking", "running after start", "steady, before stop", "non-stop",
        "brakes released", "no brake", "regenerative braking", "backstop", "restarted",
    ],
)  # fmt: skip
def test_a_name_that_says_neither_is_not(name: str) -> None:
    assert asked(name) == []
    assert judged(renamed(name)).level is Level.OK


def test_it_is_told_before_solving_and_of_its_load_case_alone(tmp_path: Path) -> None:
    file = drive_file(tmp_path, f'{DRIVE}[[load_case]]\nname = "start"\n')
    assert "Also Load case start is judged as running." in wraparc("check", file).words
    ran = wraparc("solve", file, "--full")
    assert "Kind of load case - - - ATTENTION start" in ran.words
    cases = [line for line in ran.out.splitlines() if line.startswith(" empty: head")]
    assert all("kind of load case" not in line for line in cases)


def test_two_such_load_cases_are_two_checks() -> None:
    of = quiet()
    cases = tuple(replace(of.load_cases[0], name=name) for name in ("start", "stop"))
    found = [c for c in judged(replace(of, load_cases=cases)).checks if c.name == "case_kind"]
    assert [c.place.load_case for c in found] == ["start", "stop"]


def test_a_start_that_is_judged_as_running_needs_no_stronger_belt() -> None:
    """160 kN on 1200 mm of 120 kN/m is over the rating, 144 kN, that a start may exceed."""
    text = BASE.replace('speed = "3 m/s"', 'speed = "3 m/s"\nrating = "120 kN/m"')
    text += (
        '[[load_case]]\nname = "full start"\npulley.head.entry_tension = "160 kN"\n'
        'pulley.head.exit_tension = "95 kN"\n'
    )
    result = solve(drive_from_text(text))
    verdict = judge(result)
    assert verdict.governing is not None
    assert verdict.governing.name != "case_kind"
    assert verdict.governing.place.load_case == "full start"
    action = find_action(result)
    assert action is not None
    assert in_units(action.text) == 'Set kind = "starting" in load case full start.'
