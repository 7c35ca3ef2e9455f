"""Actions on whole drives: followed by the keys of their files, solved and judged again.

Expected: what the action says, by the solver of one arc and the judge; numbers by hand where a
closed form has them.
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from actions.follow import follow, solved_document, with_way
from wraparc.actions import find_action, settings_of
from wraparc.actions.document import source_of
from wraparc.checks import judge
from wraparc.schema.overrides import put_over
from wraparc.train.file import drive_or_train_from_document, load_drive_or_train
from wraparc.train.whole import solved
from wraparc.units import in_units

EXAMPLES = Path(__file__).parents[2] / "examples"
DRIVE = """
format = 1
covered = true
[belt]
width = "1 m"
modulus = "5000 kN/m"
rating = "300 kN/m"
speed = "3 m/s"
[design_standard]
name = "none"
[[pulley]]
name = "head"
diameter = "1 m"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
entry_tension = "150 kN"
exit_tension = "50 kN"
"""


def document(text: str = DRIVE, **values: Any) -> dict[str, Any]:
    """Return a drive file with other values."""
    return put_over(tomllib.loads(text), {k.replace("__", "."): v for k, v in values.items()})


@pytest.mark.parametrize("name", [
    "head-drive-fabric.toml", "test-pulley-calibrated.toml", "worn-head-drive-fabric.toml",
    "wet-season/wet-season-drive.toml", "studies/head-drive.toml", "triple-steel-cord.toml",
])  # fmt: skip
def test_actions_of_shipped_examples_hold(name: str) -> None:
    text = (EXAMPLES / name).read_text("utf-8")
    assert follow(tomllib.loads(text)).wrong == []


@pytest.mark.parametrize("name", ["head-drive-fabric.toml", "test-pulley-calibrated.toml"])
def test_settings_give_exactly_the_drive_that_was_proved(name: str) -> None:
    path = EXAMPLES / name
    result = solved(load_drive_or_train(path))
    action = find_action(result)
    assert action is not None
    source = source_of(result, ("",), 1.0)
    assert source is not None
    for way in action.ways:
        typed = load_drive_or_train(path, overrides=settings_of(way.changes))
        assert source.read(way.changes) == typed
        assert judge(solved(typed)).level == "OK"


def test_no_action_where_every_check_passes() -> None:
    assert find_action(solved(load_drive_or_train(EXAMPLES / "tandem-fabric.toml"))) is None


def test_the_belt_is_rated_for_the_tension_that_it_carries() -> None:
    """T1 of 500 kN on 1 m is 500 kN/m; or T2 of 350, with which T1 is 450."""
    given = document(pulley__head__entry_tension="500 kN", pulley__head__exit_tension="400 kN",
                     belt__rating="450 kN/m", pulley__head__diameter="2 m",
                     belt__modulus="20000 kN/m")  # fmt: skip
    action = find_action(solved_document(given))
    assert action is not None
    texts = [in_units(way.text) for way in action.ways]
    assert texts == ["Lower T2 from 400 to 350 kN.", "Use a belt rated 500 kN/m (now 450 kN/m)."]
    assert in_units(action.text) == f"{texts[0][:-1]}, or use a belt rated 500 kN/m (now 450 kN/m)."
    (change,) = action.ways[-1].changes
    assert (change.key, change.before, change.after, change.unit) == (
        "belt.rating", 450e3, 500e3, "N/m",
    )  # fmt: skip
    assert follow(given).wrong == []


FORMS: dict[str, dict[str, Any]] = {
    "entry and power": {"pulley__head__exit_tension": None, "pulley__head__power": "300 kW"},
    "exit and torque": {"pulley__head__entry_tension": None, "pulley__head__torque": "50 kN m"},
    "a load case": {
        "load_case": [
            {"name": "start", "kind": "starting", "pulley": {"head": {"entry_tension": "170 kN"}}}
        ]
    },
    "a load case by its power": {
        "pulley__head__entry_tension": None, "pulley__head__power": "300 kW",
        "load_case": [{"name": "empty", "pulley": {"head": {"power": "90 kW"}}}]},
    "a fixed take-up": {"take_up": {"kind": "fixed"}, "pulley__head__entry_tension": None,
        "pulley__head__power": "300 kW", "load_case": [{"name": "empty", "pulley": {
        "head": {"power": "90 kW"}}}]},
    "a name with blanks": {"pulley__head__name": "head 1, left"},
}  # fmt: skip


@pytest.mark.parametrize("form", FORMS)
def test_all_tensions_shift_alike_however_they_are_given(form: str) -> None:
    given = document(creep_limit="5 mm", **FORMS[form])
    before = drive_or_train_from_document(given)
    result = solved_document(given)
    action = find_action(result)
    assert action is not None
    raised = [w for w in action.ways if all(c.key.endswith("tension") for c in w.changes)]
    assert raised, in_units(action.text)
    after = drive_or_train_from_document(with_way(given, raised[0]))
    lifts = [
        end - start
        for one, other in zip(before.load_cases, after.load_cases, strict=True)  # type: ignore[union-attr]
        for a, b in zip(one.tensions.values(), other.tensions.values(), strict=True)
        for start, end in ((a.entry, b.entry), (a.exit, b.exit))
    ]
    assert lifts[0] > 1.0
    assert lifts == pytest.approx([lifts[0]] * len(lifts), rel=1e-9)
    assert follow(given).wrong == []


def test_a_conveyor_is_raised_at_its_take_up() -> None:
    text = (EXAMPLES / "uphill-conveyor.toml").read_text("utf-8")
    given = put_over(tomllib.loads(text), {"creep_limit": "2.2 mm"})
    told = follow(given)
    assert told.wrong == []
    action = find_action(solved_document(given))
    assert action is not None
    assert told.ways > 0


def test_a_size_that_no_drive_has_is_checked_before_anything_is_advised() -> None:
    # expected: the unit that makes it a pulley; by a drum of 1 km no tension or lagging is tried
    document = tomllib.loads(DRIVE.replace('diameter = "1 m"', 'diameter = "1000 m"'))
    result = solved(drive_or_train_from_document(document))
    assert judge(result).missed
    action = find_action(result)
    assert action is not None
    assert in_units(action.text, "si") == "Check the unit of diameter: 1000 mm?"
    assert action.ways == ()
