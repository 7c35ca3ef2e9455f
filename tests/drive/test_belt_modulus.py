"""How the modulus of a belt was measured: keys, words, and the ratio of the two tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from wraparc.answer.inputs import belt_inputs
from wraparc.catalogue import belts
from wraparc.catalogue.belt_modulus import MODULUS_RATIOS
from wraparc.drive import Belt
from wraparc.errors import InputError
from wraparc.files.drive_file import drive_from_text
from wraparc.files.write import drive_text

DRIVE = """
format = 1
[belt]
{belt}
width = "1200 mm"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
entry_tension = "150 kN"
exit_tension = "60 kN"
"""


def belt_of(text: str) -> Belt:
    return drive_from_text(DRIVE.format(belt=text)).belt


def remark(belt: Belt) -> str:
    return next(entry.remark for entry in belt_inputs(belt) if entry.name == "belt_modulus")


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ("", "static or dynamic: not stated"),
        ('modulus_test = "dynamic"', "dynamic"),
        (
            'modulus_test = "dynamic"\nmodulus_loads = ["2 %", "10 %"]',
            "dynamic, 2 to 10 % of strength",
        ),
        ('modulus_test = "static"', "static: dynamic 1.6 to 2 times as much"),
        (
            'modulus_test = "static"\nkind = "steel cord"\nmodulus_loads = ["0 %", "10 %"]',
            "static, 0 to 10 % of strength: dynamic 1.5 to 2.2 times as much",
        ),
    ],
)
def test_inputs_say_how_the_modulus_was_measured(keys: str, words: str) -> None:
    drive = drive_from_text(DRIVE.format(belt=f'modulus = "12 MN/m"\n{keys}'))
    assert remark(drive.belt) == words
    assert drive_from_text(drive_text(drive)) == drive


def test_maker_states_no_test_of_any_shipped_belt() -> None:
    assert {item.modulus_test for item in belts()} == {""}
    assert remark(belt_of('preset = "Plylon Plus 1000/4"')) == "static or dynamic: not stated"


def test_ratio_is_that_of_the_published_elongations() -> None:
    """1 + M e / k: at the rating k a first stretch is k/M + e long, a later one k/M."""
    known = [item for item in belts() if item.permanent_elongation is not None]
    assert {item.kind for item in known} == {"fabric"}
    stretch = [item.rating / item.modulus for item in known]
    lasting = [item.permanent_elongation or 0.0 for item in known]
    ratios = [(a + b) / a for a, b in zip(stretch, lasting, strict=True)]
    fabric, cord = MODULUS_RATIOS["fabric"], MODULUS_RATIOS["steel cord"]
    assert (fabric.least, fabric.most) == (round(min(ratios), 1), round(max(ratios), 1))
    elastic = [item.rating / item.modulus for item in belts() if item.kind == "steel cord"]
    assert cord.least == pytest.approx(1.0 + 0.0010 / max(elastic), abs=0.05)
    assert cord.most == pytest.approx(1.0 + 0.0025 / min(elastic), abs=0.05)


def test_faults_of_a_measurement_come_together() -> None:
    text = DRIVE.format(
        belt='modulus = "12 MN/m"\nmodulus_test = "secant"\nmodulus_loads = ["2 %", "110 %"]'
    )
    with pytest.raises(InputError) as refused:
        drive_from_text(text)
    assert [str(problem) for problem in refused.value.problems] == [
        'belt.modulus_test: must be one of "dynamic", "static", got "secant".',
        'belt.modulus_loads[2]: must be a percentage from 0 % to 100 %, got "110 %". '
        'Write for example "0.5 %".',
    ]
    with pytest.raises(InputError, match=r'highest load, .* got \["10 %", "2 %"\]'):
        Belt(name="belt", width=1.2, modulus=12e6, modulus_loads=(0.10, 0.02))
    with pytest.raises(InputError, match='must be one of "dynamic", "static", got "secant"'):
        Belt(name="belt", width=1.2, modulus=12e6, modulus_test="secant")


def test_own_belts_bring_their_test(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "belts.toml").write_text(
        """
format = 1
[[belt]]
name = "ACME EP800/4"
kind = "fabric"
rating = "140 kN/m"
modulus = "10 MN/m"
modulus_test = "dynamic"
modulus_loads = ["2 %", "10 %"]
""",
        "utf-8",
    )
    (tmp_path / "laggings").mkdir()
    monkeypatch.setenv("WRAPARC_CATALOGUE", str(tmp_path))
    own = belt_of('preset = "ACME EP800/4"')
    assert (own.modulus_test, own.modulus_loads) == ("dynamic", (0.02, 0.1))
    other = belt_of('preset = "ACME EP800/4"\nmodulus = "9 MN/m"')
    assert (other.modulus_test, other.modulus_loads) == ("", None)
