"""Numbers as the page shows them: character for character those of Python.

Expected texts: `in_units`, by which every other door shows them.
"""

import json
import math
import random
import re
import subprocess
from pathlib import Path
from typing import Any, get_args

import pytest

from golden.answers import DOORS
from golden.record import record
from worded import worded
from wraparc import units
from wraparc.answer import answer_data
from wraparc.answer.answer_data import text_data
from wraparc.glossary import GLOSSARY
from wraparc.units import DIMENSIONS, Cell, System, in_units
from wraparc.units.cell import Form
from wraparc.web.answers.form import form

SYSTEMS: tuple[System, ...] = ("si", "us")
#: Numbers in the middle between two, as they are shown, and at the ends of forms.
HARD = (
    0.0, 1e-13, 9.9996, 99996.0, 1234.5, 12345.0, 12355.0, 2.00125, 0.125, 9.99961e-5, 1.2256e15,
    0.0999999, 1e12, 273.15, 6894.757293168361, 0.0254,
)  # fmt: skip


def shown(texts: list[Any]) -> list[list[str]]:
    """Return what the page makes of texts, in both systems of units."""
    given = {"form": form().model_dump(mode="json"), "texts": texts}
    done = subprocess.run(
        ["node", str(Path(__file__).with_name("words_cases.mjs"))], input=json.dumps(given),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: list[list[str]] = json.loads(done.stdout)
    return found


def assert_alike(slots: list[str]) -> None:
    """Hold texts with slots, and the same as the server sends them, against Python."""
    expected = [[in_units(text, system) for system in SYSTEMS] for text in slots]
    data = [text_data(text) for text in slots]
    assert [[worded(text, system) for system in SYSTEMS] for text in data] == expected
    assert shown(data) == expected
    plain = [i for i, text in enumerate(slots) if "\x04" not in text]  # the page makes no others
    made = [re.sub(r"(?<=[|-])inf(?=[|])", "Infinity", slots[i]) for i in plain]
    assert shown(made) == [expected[i] for i in plain]


def number(pick: random.Random) -> float:
    value = pick.choice([-1, 1]) * 10 ** pick.uniform(-9, 12)
    digits = pick.choice([1, 2, 3, 4, 5, 17])
    return pick.choice([pick.choice(HARD), float(f"{value:.{digits}g}")])


def test_every_form_of_a_cell() -> None:
    pick = random.Random(33)  # noqa: S311 - numbers to try, no secrets
    names = ["", *GLOSSARY]
    slots = []
    for _ in range(6000):
        form, value, other = pick.choice(get_args(Form)), number(pick), number(pick)
        if pick.random() < 0.3:
            other = value * (1 + 10 ** pick.uniform(-10, -1))
        name = pick.choice(names)
        of = GLOSSARY[name].dimension if name else pick.choice(DIMENSIONS)
        cell = Cell(value, of, pick.choice([2, 3, 3, 4, 5]), form, other, name)
        slots.append(pick.choice([f"{cell}", f"It is {cell}.", f"👍 {cell} and {cell}"]))
    assert_alike(slots)


def test_what_is_not_finite() -> None:
    forms: tuple[Form, ...] = ("", "bare", "percent", "up", "slip apart", "to", "unit")
    ends = (1.0, math.inf, -math.inf)
    cells = [Cell(a, "force", 3, form, b) for form in forms for a in ends for b in (1e3, math.inf)]
    assert_alike([f"from {cell} on" for cell in cells])


def test_no_digits_behind_the_point() -> None:
    """Of a step of whole percent, as a change of a reserve has it."""
    cells = [Cell(a, "number", 0, "percent signed") for a in (-0.144, 0.0, 0.256, 1.0)]
    assert [cell.text("si") for cell in cells] == ["-14 %", "0 %", "+26 %", "+100 %"]
    assert_alike([f"from {cell} on" for cell in cells])


def test_what_only_looks_like_a_cell() -> None:
    """Anybody may write such a title into a drive file."""
    looks = ("\x02no|3||1|nan|\x03", "\x02length|0||1.2345|nan|\x03", "\x02force|3||1|", "\x02\x03")
    assert shown(list(looks)) == [["no|3||1|nan|"] * 2, *([text] * 2 for text in looks[1:])]
    for text in looks:
        assert in_units(text) in (text, "no|3||1|nan|")


@pytest.fixture(scope="module")
def said() -> list[str]:
    """Return every text with numbers in the answers of the calculator."""
    found: dict[str, None] = {}
    kept = units.placed
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(answer_data, "placed", lambda text: (found.setdefault(text), kept(text))[1])
        for door in DOORS:
            if door in ("web-drives", "web-trains", "web-catalogue", "web-compare"):
                record(door)
    return list(found)


def test_every_text_of_the_golden_answers(said: list[str]) -> None:
    assert len(said) > 1000
    assert sum("\x04" in text for text in said) > 0
    assert_alike(said)
