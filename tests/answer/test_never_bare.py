"""An OK that stands on illustrative data says so in the data line of every command that judges."""

import re
from pathlib import Path

import pytest

from cli.running import wraparc
from files.samples import example

pytestmark = pytest.mark.usefixtures("solved_once")

UPHILL = example("uphill-conveyor")
#: No level of speeds is an OK without the layers of the belt.
LAYERS = ("--set", "belt.pulley_cover=4 mm", "--set", "belt.carcass=6 mm")


@pytest.mark.parametrize("command", [("what-if", "--worn", "8 mm"), ("field", *LAYERS), ("check",)])
def test_an_ok_names_its_data(command: tuple[str, ...]) -> None:
    # the alarm of the uphill conveyor is no OK: two load cases of it differ by their compression
    of = example("downhill-braking") if command[0] == "field" else UPHILL
    ran = wraparc(command[0], of, *command[1:])
    assert ran.code == 0, ran.err
    assert re.search(r" OK .* Data Friction, block", ran.words)
    assert "illustrative" in ran.words.partition(" Data ")[2]


def test_a_choice_names_the_data_of_its_lagging(tmp_path: Path) -> None:
    text = (
        'format = 1\ndrive = "uphill.toml"\n[candidates]\nlaggings = ["full-ceramic"]\n'
        'slack_tensions = ["60 kN"]\n[cost]\ncurrency = "AUD"\nyears = 10\n'
    )
    (tmp_path / "uphill.toml").write_text(UPHILL.read_text("utf-8"), "utf-8")
    (tmp_path / "choose.toml").write_text(text, "utf-8")
    ran = wraparc("choose", tmp_path / "choose.toml")
    assert ran.code == 0, ran.err
    assert re.search(r" OK Lowest cost: full-ceramic.* Data .*illustrative", ran.words)


def test_a_thinner_lagging_is_compressed_less_on_a_brake_too() -> None:
    """h/E_c falls to 0.4 (1 + k)/(1 + k 2.5^2) = 0.141: strips 30 mm wide, 15 and 6 mm thick.

    S = 1 and 2.5, k = 0.54; the creep that compression makes is negative there.
    """
    ran = wraparc("what-if", example("downhill-braking"), "--worn", "6 mm", "--full")
    assert "the lagging is compressed less (h/E_c times 0.141)" in ran.words
