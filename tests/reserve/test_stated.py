"""Stated uncertainties: their key, what they mean, and the check of the reserve."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from cli.running import wraparc
from reserve.test_find import FRICTION, PULL, SLACK, WRAP, euler, result_of
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.reserve_words import with_reserve
from wraparc.answer.words import verdict
from wraparc.arc import DriveResult
from wraparc.checks import Check, Level, judge
from wraparc.drive import Belt, Drive
from wraparc.errors import InputError
from wraparc.files import drive_from_document, drive_text
from wraparc.files.drive_file import drive_from_text
from wraparc.reserve import STATED, Input, find_reserve, uncertainty_of
from wraparc.units import in_units

EXAMPLES = Path(__file__).parents[2] / "examples"

#: Safety on gross slip 1.4 is reached where Te grows by this, friction falls by that (Euler).
CAPACITY = SLACK * math.expm1(FRICTION * WRAP)
TO_PULL = CAPACITY / (1.4 * PULL) - 1.0
TO_FRICTION = math.log1p(1.4 * PULL / SLACK) / (FRICTION * WRAP) - 1.0


def document(**uncertainty: dict[str, str]) -> dict[str, Any]:
    """Return the drive of Euler's formula with uncertainties in its tables."""
    given = euler("2 MPa/mm")
    places = {
        "belt": given["belt"],
        "pulley": given["pulley"][0],
        "lagging": given["lagging"]["own"],
    }
    for name, values in uncertainty.items():
        places[name]["uncertainty"] = values
    return given


def reserve_check(given: dict[str, Any]) -> Check:
    checks = judge_uncertain(result_of(given)).listed
    return next(check for check in checks if check.name == "reserve")


@pytest.mark.parametrize(
    ("table", "key", "change", "sentence", "action"),
    [
        ("pulley", "effective_tension", TO_PULL, "Te +{} %", "Measure Te."),
        ("lagging", "friction", TO_FRICTION, "Friction {} %", "Measure friction."),
    ],
)
def test_a_change_within_a_stated_uncertainty_needs_attention(
    table: str, key: str, change: float, sentence: str, action: str
) -> None:
    # expected: Euler's formula; the change is within 1.03 times it, and not within 0.97 times
    wide, narrow = (f"{100.0 * part * abs(change):.6f} %" for part in (1.03, 0.97))
    assert reserve_check(document(**{table: {key: narrow}})).level is Level.OK
    result = result_of(document(**{table: {key: wide}}))
    check = reserve_check(document(**{table: {key: wide}}))
    assert check.level is Level.ATTENTION
    assert check.value == pytest.approx(abs(change), rel=0.01)
    assert check.limit == pytest.approx(1.03 * abs(change), rel=1e-6)
    told = judge_uncertain(result)
    assert (told.level, judge(result).level) == (Level.ATTENTION, Level.OK)
    percent = math.copysign(math.ceil(1000.0 * abs(change)) / 10.0, change)
    shown = (
        f"{percent:.1f}"
        if abs(percent) < 10.0
        else f"{math.copysign(math.ceil(abs(100.0 * change)), change):.0f}"
    )
    changed = f"{sentence.format(shown)} changes the verdict, within its uncertainty."
    assert in_units(check.text) == changed
    assert check.action_text == action
    # the reserve is that of the verdict without the check
    assert find_reserve(result).level is Level.OK
    assert {flip.level for flip in find_reserve(result).flips} >= {Level.ATTENTION}


def test_the_check_stands_last_and_is_none_where_nothing_is_stated() -> None:
    given = document(pulley={"effective_tension": "60 %"})
    given["belt"]["rating"] = "99 kN/m"
    result = result_of(given)
    names = [check.name for check in judge_uncertain(result).missed]
    assert len(names) > 1
    assert names[-1] == "reserve"
    plain = result_of(euler("2 MPa/mm"))
    assert judge_uncertain(plain) is judge(plain)


def test_what_is_exact_is_far_from_every_change() -> None:
    given = document(lagging={"friction": "0 %"})
    check = reserve_check(given)
    assert (check.level, check.limit) == (Level.OK, 0.0)
    last = find_reserve(result_of(given)).flips[-1]
    assert last.input.name == "friction"


def test_a_usual_uncertainty_is_said_and_the_level_stays() -> None:
    given = document()
    given["pulley"][0]["effective_tension"] = f"{PULL * (1.0 + TO_PULL) / 1.105} N"
    result = result_of(given)
    assert isinstance(result, DriveResult)
    line = with_reserve(verdict(result), result, every=False)
    assert line.level is Level.OK
    assert in_units(line.reserve[0]).startswith("ATTENTION at Te +11 %")
    assert "within their uncertainties" in line.reserve[0]


@pytest.mark.parametrize(
    ("stated", "name", "expected"),
    [
        ({"effective_tension": "5 %"}, "effective_tension", 0.05),
        ({"torque": "5 %"}, "effective_tension", 0.05),
        ({"exit_tension": "5 %"}, "slack_tension", 0.05),
        # T1 is off by 5 % of 100 kN: Te, with T2 fixed, by that over 60 kN
        ({"entry_tension": "5 %"}, "effective_tension", 0.05 * (SLACK + PULL) / PULL),
        # Te is known, so T1 moves T2 by as much
        (
            {"effective_tension": "0 %", "entry_tension": "5 %"},
            "slack_tension",
            0.05 * (SLACK + PULL) / SLACK,
        ),
    ],
)
def test_tensions_are_uncertain_by_what_is_stated_of_them(
    stated: dict[str, str], name: str, expected: float
) -> None:
    found = uncertainty_of(drive_from_document(document(pulley=stated)), Input(name))
    assert (found.kind, found.source) == (STATED, "drive file")
    assert found.value == pytest.approx(expected)


def test_pulleys_that_change_together_are_off_by_the_least() -> None:
    given = document(pulley={"diameter": "1 %"})
    second = given["pulley"][0] | {"name": "second", "uncertainty": {"diameter": "3 %"}}
    given["pulley"] = [{**given["pulley"][0]}, second]
    del given["pulley"][0]["exit_tension"]
    drive = drive_from_document(given)
    both = ("head", "second")
    assert uncertainty_of(drive, Input("diameter", both)).value == 0.01
    assert uncertainty_of(drive, Input("diameter", ("second",), "second")).value == 0.03
    assert uncertainty_of(drive, Input("wrap_angle", both)).kind != STATED


def test_written_files_keep_uncertainties() -> None:
    given = document(
        belt={"modulus": "15 %"},
        pulley={"wrap": "2 %", "power": "10 %"},
        lagging={"friction": "8 %", "shear_modulus": "25 %"},
    )
    drive = drive_from_document(given)
    assert drive_from_text(drive_text(drive)) == drive
    assert (drive.belt.uncertainty, drive.pulleys[0].uncertainty) == (
        {"modulus": 0.15},
        {"wrap_angle": 0.02, "effective_tension": 0.1},
    )


def refusals(given: dict[str, Any]) -> list[str]:
    with pytest.raises(InputError) as refused:
        drive_from_document(given, file="d.toml")
    return [str(problem) for problem in refused.value.problems]


def test_bad_uncertainties_are_refused_all_at_once() -> None:
    given = document(
        belt={"modulus": "101 %", "rating": "3 %"},
        pulley={"diameter": "-1 %", "wrap": "2 %", "wrap_angle": "3 %", "exit_tension": "4"},
        lagging={"friction": "abc", "surface": "1 %"},
    )
    end = 'must be a percentage from 0 % to 100 %, got "{}". Write for example "0.5 %".'
    of_lagging = "friction, slip, thickness, shear_modulus, compression_modulus"
    assert sorted(refusals(given)) == sorted([
        f"d.toml: belt.uncertainty.modulus: {end.format('101 %')}",
        f"d.toml: pulley.head.uncertainty.diameter: {end.format('-1 %')}",
        'd.toml: pulley.head.uncertainty.exit_tension: must be a percentage, got "4". Write "4 %".',
        f"d.toml: lagging.own.uncertainty.friction: {end.format('abc')}",
        "d.toml: belt.uncertainty.rating: has no uncertainty. Write modulus.",
        'd.toml: pulley.head.uncertainty.wrap_angle: contradicts that of wrap, got "3 %". '
        "Remove one of them.",
        f"d.toml: lagging.own.uncertainty.surface: has no uncertainty. Write one of {of_lagging}.",
    ])  # fmt: skip


def test_friction_that_a_fit_has_an_interval_of_is_not_stated_again() -> None:
    given = document(lagging={"friction": "5 %"})
    given["lagging"]["own"]["law"]["fit"] = {
        "parameters": ["friction"], "values": [0.5], "covariance": [[1e-4]],
    }  # fmt: skip
    (text,) = refusals(given)
    assert text == (
        "d.toml: lagging.own.uncertainty.friction: contradicts the fit of the law, which has an "
        'interval, got "5 %". Remove one of them.'
    )


def test_python_refuses_what_files_do() -> None:
    with pytest.raises(InputError, match=r"uncertainty.modulus: must be a percentage .* got 120 %"):
        Belt(name="belt", width=1.0, modulus=1e7, uncertainty={"modulus": 1.2})
    with pytest.raises(InputError, match=r"uncertainty.width: has no uncertainty. Write modulus."):
        Belt(name="belt", width=1.0, modulus=1e7, uncertainty={"width": 0.2})
    assert isinstance(drive_from_document(document()), Drive)


def test_commands_that_do_not_find_the_reserve_say_so(tmp_path: Path) -> None:
    """A drive that needs attention by its reserve is a bare OK nowhere."""
    text = (EXAMPLES / "downhill-braking.toml").read_text("utf-8")
    power = 'power = "-250 hp"'
    assert text.count(power) == 1
    path = tmp_path / "drive.toml"
    path.write_text(text.replace(power, f'{power}\nuncertainty = {{ power = "30 %" }}'), "utf-8")
    assert "ATTENTION Te +22 % changes the verdict" in wraparc("solve", path).words
    choose, study = tmp_path / "choose.toml", tmp_path / "study.toml"
    choose.write_text(
        'format = 1\ndrive = "drive.toml"\n[candidates]\nlaggings = ["medium-ceramic"]\n'
        'slack_tensions = "least"\n[cost]\ncurrency = "AUD"\nyears = 10\n',
        "utf-8",
    )
    study.write_text(
        'format = 1\ndrive = "drive.toml"\npulley = "tail"\n[[axis]]\nfield = "belt.width"\n'
        'values = ["48 in"]\n',
        "utf-8",
    )
    assert "OK, reserve not checked" in wraparc("choose", choose).words
    assert "OK, reserve not checked" in wraparc("study", study, "-o", tmp_path / "s.parquet").words
