"""Uncertainties of tensions, stated by load cases, trains and conveyors."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from reserve.test_find import PULL, SLACK, euler
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.checks import Level
from wraparc.conveyor import Conveyor
from wraparc.drive import Drive, LoadCase, Tensions
from wraparc.errors import InputError
from wraparc.files import drive_from_document, drive_text
from wraparc.files.drive_file import drive_from_text
from wraparc.reserve import STATED, Input, uncertainty_of
from wraparc.train.file import drive_or_train_from_document
from wraparc.train.whole import by_pulley, solved

EXAMPLES = Path(__file__).parents[2] / "examples"


def example(name: str) -> dict[str, Any]:
    return tomllib.loads((EXAMPLES / f"{name}.toml").read_text("utf-8"))


def stated(drive: Drive, name: str) -> float | None:
    found = uncertainty_of(drive, Input(name))
    return found.value if found.kind == STATED else None


def with_case(uncertainty: dict[str, str], own: dict[str, str]) -> dict[str, Any]:
    """Return the drive of Euler's formula with a second load case of the same tensions."""
    given = euler()
    given["pulley"][0]["uncertainty"] = own
    given["load_case"] = [{"name": "full", "pulley": {"head": {"uncertainty": uncertainty}}}]
    return given


def test_a_load_case_states_its_own_before_those_of_the_pulley() -> None:
    drive = drive_from_document(with_case({"torque": "4 %"}, {"exit_tension": "3 %"}))
    assert (stated(drive, "effective_tension"), stated(drive, "slack_tension")) == (0.04, 0.03)
    # in the load case "design" the pulley's own holds: the larger of both counts
    both = drive_from_document(with_case({"exit_tension": "1 %"}, {"exit_tension": "3 %"}))
    assert stated(both, "slack_tension") == 0.03
    assert drive_from_text(drive_text(both)) == both


def test_a_change_within_that_of_a_load_case_needs_attention() -> None:
    # by Euler's formula the safety of 1.4 is missed at Te +81 %
    for percent, level in (("83 %", Level.ATTENTION), ("79 %", Level.OK)):
        drive = drive_from_document(with_case({"effective_tension": percent}, {}))
        checks = judge_uncertain(solved(drive)).listed
        assert next(c for c in checks if c.name == "reserve").level is level


def test_a_train_states_those_of_all_its_pulleys_together() -> None:
    given = example("tandem-fabric")
    given["train"]["uncertainty"] = {"power": "7 %", "exit_tension": "3 %"}
    given["load_case"][-1].setdefault("train", {})["uncertainty"] = {"effective_tension": "9 %"}
    drive = by_pulley(solved(drive_or_train_from_document(given))).drive
    assert drive.states_uncertainty
    assert stated(drive, "effective_tension") == 0.09
    assert stated(drive, "slack_tension") == pytest.approx(0.03)


def test_the_tight_side_of_a_train_is_uncertain_by_the_pull_of_all() -> None:
    """T1 of the first pulley, off by 2 %: Te of all, T2 fixed, by that over their sum."""
    given = example("tandem-fabric")
    given["train"]["uncertainty"] = {"entry_tension": "2 %"}
    drive = by_pulley(solved(drive_or_train_from_document(given))).drive
    shares = []
    for case in drive.load_cases:
        ends = [case.tensions[p.name] for p in drive.pulleys]
        shares.append(0.02 * ends[0].entry / abs(sum(at.effective for at in ends)))
    assert stated(drive, "effective_tension") == pytest.approx(max(shares))


def level(**more: str) -> dict[str, Any]:
    """Return a drive of a level conveyor: Te = C f g L times the masses (DIN 22101, 6.2)."""
    given = euler()
    pulley = given["pulley"][0]
    del pulley["exit_tension"], pulley["effective_tension"]
    given["belt"]["speed"] = "3 m/s"
    given["conveyor"] = {
        "length": "800 m", "belt_mass": "20 kg/m", "carry_idler_mass": "18 kg/m",
        "return_idler_mass": "8 kg/m", "material_mass": "90 kg/m", "friction_factor": 0.022,
        "length_coefficient": 1.12, "take_up_tension": "40 kN", "uncertainty": more,
    }  # fmt: skip
    return given


@pytest.mark.parametrize(
    ("uncertainty", "name", "expected"),
    [
        # Te is as f, and as C
        ({"friction_factor": "20 %"}, "effective_tension", 0.2),
        ({"friction_factor": "3 %", "length_coefficient": "4 %"}, "effective_tension", 0.05),
        # the material is 90 kg/m of 156 kg/m (two strands of belt)
        ({"material_mass": "10 %"}, "effective_tension", 0.1 * 90.0 / 156.0),
        ({"take_up_tension": "5 %"}, "slack_tension", 0.05),
    ],
)
def test_a_conveyor_states_them_by_its_resistances(
    uncertainty: dict[str, str], name: str, expected: float
) -> None:
    drive = drive_from_document(level(**uncertainty))
    assert stated(drive, name) == pytest.approx(expected, rel=1e-6)
    other = ({"effective_tension", "slack_tension"} - {name}).pop()
    assert stated(drive, other) is None
    assert drive_from_text(drive_text(drive)) == drive


def refusals(given: dict[str, Any]) -> list[str]:
    with pytest.raises(InputError) as refused:
        drive_or_train_from_document(given, file="d.toml")
    return [str(problem) for problem in refused.value.problems]


def test_bad_uncertainties_of_load_cases_are_refused_all_at_once() -> None:
    given = with_case({"exit_tension": "-1 %", "wrap": "2 %", "power": "3 %", "torque": "3 %"}, {})
    place = "d.toml: load_case.full.pulley.head.uncertainty"
    end = 'must be a percentage from 0 % to 100 %, got "-1 %". Write for example "0.5 %".'
    keys = "entry_tension, exit_tension, effective_tension"
    assert sorted(refusals(given)) == sorted([
        f"{place}.exit_tension: {end}",
        f"{place}.wrap: has no uncertainty. Write one of {keys}.",
        f'{place}.torque: contradicts that of power, got "3 %". Remove one of them.',
    ])  # fmt: skip


def test_bad_uncertainties_of_conveyors_are_refused() -> None:
    (text,) = refusals(level(friction_factor="101 %"))
    assert text.startswith("d.toml: conveyor.uncertainty.friction_factor: must be a percentage")
    (text,) = refusals(level(length="1 %"))
    assert text.startswith("d.toml: conveyor.uncertainty.length: has no uncertainty. ")
    (text,) = refusals(level(counterweight="1 %"))
    expected = 'conveyor.uncertainty.counterweight: counterweight is missing, got "1 %". Give both.'
    assert text == f"d.toml: {expected}"


@pytest.mark.parametrize("table", ["train", "conveyor"])
def test_tensions_are_not_stated_of_pulleys_too(table: str) -> None:
    given = example("tandem-fabric") if table == "train" else level(friction_factor="5 %")
    if table == "train":
        given["train"]["uncertainty"] = {"effective_tension": "5 %"}
    given["pulley"][0]["uncertainty"] = {"power": "5 %", "diameter": "1 %"}
    name = given["pulley"][0]["name"]
    assert refusals(given) == [
        f"d.toml: pulley.{name}.uncertainty.power: contradicts those of [{table}], "
        'got "5 %". Remove one of them.'
    ]


def test_a_train_on_a_conveyor_takes_those_of_the_conveyor() -> None:
    given = level(friction_factor="5 %")
    second = given["pulley"][0] | {"name": "second"}
    given["pulley"] = [given["pulley"][0], second]
    given["train"] = {"share": ["50 %", "50 %"]}
    drive = by_pulley(solved(drive_or_train_from_document(given))).drive
    assert stated(drive, "effective_tension") == pytest.approx(0.05)
    given["train"]["uncertainty"] = {"effective_tension": "5 %"}
    (text,) = refusals(given)
    assert "train.uncertainty: the [conveyor] table gives the tensions already" in text


def test_python_refuses_what_files_do() -> None:
    at = {"head": Tensions(entry=SLACK + PULL, exit=SLACK)}
    with pytest.raises(InputError, match=r"uncertainty.wrap: has no uncertainty"):
        LoadCase(name="full", tensions=at, uncertainty={"head": {"wrap": 0.1}})
    with pytest.raises(InputError, match=r"uncertainty.lift: must be a percentage .* got -10 %"):
        Conveyor(
            length=800.0, belt_mass=20.0, carry_idler_mass=18.0, return_idler_mass=8.0,
            material_mass=90.0, take_up_tension=4e4, uncertainty={"lift": -0.1},
        )  # fmt: skip
