"""Goal seek: the inputs that give a wanted result, by a search over the drive itself."""

import itertools
import json
import math
from pathlib import Path
from typing import Any

import pytest

from cli.running import wraparc
from wraparc.arc import Distributed, WrapArc
from wraparc.errors import InputError
from wraparc.files import drive_from_document
from wraparc.schema.source import parse
from wraparc.study.seek import Goal, Sought, seek
from wraparc.train.file import any_drive_from_document

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
HEAD = parse((EXAMPLES / "head-drive-fabric.toml").read_text("utf-8"))
TANDEM = parse((EXAMPLES / "tandem-fabric.toml").read_text("utf-8"))
OF_PRESETS = {"pulley.head.lagging.thickness": "12 mm"}
CAPSTAN = parse(
    """
format = 1
[belt]
width = "1000 mm"
modulus = "10000 kN/m"
[lagging.plain]
thickness = "10 mm"
shear_modulus = "rigid"
compression_modulus = "rigid"
law = { kind = "constant", friction = 0.35 }
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "plain"
entry_tension = "120 kN"
exit_tension = "60 kN"
"""
)


def sought(document: dict[str, Any], field: str, result: str, value: str, **more: str) -> Sought:
    return seek(document, Goal(field=field, result=result, value=value, **more))


@pytest.mark.parametrize(
    ("field", "result", "value"),
    [
        ("pulley.head.wrap_angle", "exit_creep", "6 mm"),
        ("pulley.head.exit_tension", "peak_shear_stress", "80 kPa"),
        ("pulley.head.diameter", "creep_limit_margin", "0.95"),
        ("pulley.head.lagging.thickness", "exit_creep", "7.5 mm"),
    ],
)
def test_what_is_found_gives_what_was_wanted(field: str, result: str, value: str) -> None:
    # expected: the wanted number itself, by a solve of the drive file with the found value in it
    more = {"now": OF_PRESETS[field]} if field in OF_PRESETS else {}
    found = sought(HEAD, field, result, value, **more)
    assert len(found.values) >= 1
    for at, whole in zip(found.values, found.drives, strict=True):
        unit = {"wrap_angle": "rad", "exit_tension": "N"}
        text = f"{at!r} {unit.get(field.rpartition('.')[2], 'm')}"
        drive = any_drive_from_document(HEAD, overrides=[f"{field}={text}"])
        arc = Distributed().solve(WrapArc.of(drive, drive.pulleys[0], drive.load_cases[0]))
        assert arc.scalars()[result] == pytest.approx(found.wanted, rel=1e-8)
        assert whole.arc("head", "design").scalars()[result] == pytest.approx(found.wanted, 1e-8)


def test_slipping_arc_of_the_capstan_equation() -> None:
    # expected: closed form; the exit part over which 99 % of the tension change takes place is
    # ln(1 + 0.99 (T1/T2 - 1))/mu, which is 90 deg where T1/T2 = 1 + (exp(mu pi/2) - 1)/0.99
    found = sought(CAPSTAN, "pulley.head.entry_tension", "active_arc", "90 deg")
    expected = 60e3 * (1.0 + (math.exp(0.35 * math.pi / 2.0) - 1.0) / 0.99)
    assert list(found.values) == pytest.approx([expected], rel=1e-3)


def test_every_value_is_found_the_nearest_first() -> None:
    # friction that rises with slip and pressure: peak shear over wrap falls and may rise again;
    # expected: wherever the curve of tried values crosses the wanted one
    found = sought(HEAD, "pulley.head.lagging.shear_modulus", "peak_shear_stress", "89 kPa",
                   now="2.3 MPa")  # fmt: skip
    above = [r > found.wanted for r in found.results if math.isfinite(r)]
    crossings = sum(a is not b for a, b in itertools.pairwise(above))
    assert len(found.values) == crossings >= 1
    far = [abs(v - found.now) for v in found.values]
    assert far == sorted(far)


def test_second_drum_of_a_train() -> None:
    # expected: the result of the train solved with the found total load
    found = sought(TANDEM, "train.exit_tension", "exit_creep", "5 mm", pulley="second")
    assert found.pulley == "second"
    for whole in found.drives:
        creep = whole.arc("second", found.load_case).exit_creep
        assert creep == pytest.approx(5e-3, rel=1e-6)


def test_no_value_is_told_with_what_there_is() -> None:
    code, out, _ = wraparc(
        "seek", str(EXAMPLES / "head-drive-fabric.toml"), "--vary", "pulley.head.wrap_angle",
        "--result", "exit_creep", "--value", "1 mm",
    )  # fmt: skip
    assert code == 1
    told = " ".join(out.split())
    text = (
        "No wrap from 60 to 540 deg gives creep 1 mm; minimum 4.86 mm (head, design; now 180 deg)."
    )
    assert f"FAILS {text} Action Try another input, or a wider range" in told


def test_command_prints_and_writes_the_values(tmp_path: Path) -> None:
    # expected: the creep of `wraparc solve` with the found value in the file
    file = str(EXAMPLES / "head-drive-fabric.toml")
    goal = ("--vary", "pulley.head.wrap_angle", "--result", "exit_creep", "--value", "6 mm")
    written = tmp_path / "found.json"
    code, out, _ = wraparc("seek", file, *goal, "--json", written)
    assert code == 0
    told = " ".join(out.split())
    assert "ATTENTION Wrap 236.9 deg gives creep 6 mm (head, design; now 180 deg)." in told
    assert "Also Creep 8.90 mm exceeds the 6.35 mm limit (head, start)." in told
    told = json.loads(written.read_text("utf-8"))
    (value,) = told["found"]
    setting = f"pulley.head.wrap_angle={value['value']!r} rad"
    solved = json.loads(wraparc("solve", file, "--set", setting, "--json", "-")[1])
    assert solved["arcs"][0]["exit_creep"] == pytest.approx(6e-3, rel=1e-9)
    assert value["level"] == solved["verdict"]["level"]


@pytest.mark.parametrize(
    ("field", "result", "value", "more", "sentence"),
    [
        ("pulley.head.lagging", "exit_creep", "6 mm", {}, "is no quantity of a drive file"),
        ("pulley.head.wrap_angel", "exit_creep", "6 mm", {}, "wrap_angle"),
        ("pulley.head.wrap_angle", "creep", "6 mm", {}, "no result of a pulley"),
        ("pulley.head.wrap_angle", "exit_creep", "6 kN", {}, "kN"),
        ("pulley.head.wrap_angle", "exit_creep", "6 mm", {"pulley": "tail"}, "tail"),
        ("pulley.head.wrap_angle", "exit_creep", "6 mm", {"load_case": "stop"}, "stop"),
        ("pulley.head.overrun", "exit_creep", "6 mm", {}, "has no value to start from"),
        (
            "pulley.head.wrap_angle", "exit_creep", "6 mm",
            {"least": "200 deg", "most": "190 deg"}, "is an empty range",
        ),
    ],
)  # fmt: skip
def test_what_cannot_be_sought_is_told(
    field: str, result: str, value: str, more: dict[str, str], sentence: str
) -> None:
    with pytest.raises(InputError) as refused:
        sought(HEAD, field, result, value, **more)
    assert sentence in str(refused.value)


def test_values_no_drive_can_have_are_stepped_over() -> None:
    # a wrap of less than 1 deg is refused, gross slip has no creep: neither ends the search
    found = sought(HEAD, "pulley.head.wrap_angle", "exit_creep", "7 mm", least="1 deg")
    assert any(math.isnan(result) for result in found.results)
    drive = drive_from_document(HEAD)
    assert found.now == drive.pulleys[0].wrap_angle
    assert len(found.values) == 1


@pytest.mark.parametrize(
    ("name", "field", "value", "changes"),
    [
        ("head-drive-fabric", "pulley.head.exit_tension", "5 mm", []),
        ("downhill-braking", "pulley.tail.entry_tension", "-3 mm", []),
        ("tandem-fabric", "train.exit_tension", "3.3 mm", []),
        ("tandem-fabric", "train.exit_tension", "20 mm", ['train.share=["130 %","-30 %"]']),
    ],
)
def test_a_value_is_judged_as_solve_does(
    name: str, field: str, value: str, changes: list[str]
) -> None:
    # expected: label and sentence of `wraparc solve` with the found value put over the file
    file, told = EXAMPLES / f"{name}.toml", [arg for c in changes for arg in ("--set", c)]
    goal = ("--vary", field, "--result", "exit_creep", "--value", value)
    values = json.loads(wraparc("seek", file, *goal, *told, "--json", "-").out)["found"]
    assert values
    for found in values:
        now = ("--set", f"{field}={found['value']!r} N")
        verdict = json.loads(wraparc("solve", file, *told, *now, "--json", "-").out)["verdict"]
        assert {key: found[key] for key in ("level", "label", "text")} == {
            key: verdict[key] for key in ("level", "label", "text")
        }
