"""Commands read a file whole, and say where an option is given twice."""

from pathlib import Path

import pytest

from cli.running import wraparc

pytestmark = pytest.mark.usefixtures("solved_once")

TANDEM = (Path(__file__).parents[2] / "examples" / "tandem-fabric.toml").read_text("utf-8")


@pytest.mark.parametrize(
    "command",
    ["solve", "check", "trim", "report -o note.md", "field", "what-if --change belt.width=1300mm"],
)
def test_a_table_that_a_command_does_not_use_is_read_all_the_same(
    command: str, tmp_path: Path
) -> None:
    file = tmp_path / "tandem.toml"
    text = TANDEM.replace('"2200 kg m2"', '"-2200 kg m2"', 1).replace('"40 s"', '"8 N"', 1)
    file.write_text(text.replace('width = "1200 mm"', 'width = "1200 kN"'), "utf-8")
    first, *more = command.split()
    code, _, told = wraparc(first, str(file), *more)
    assert code == 2
    assert "motion.drum.first.inertia: must be more than 0 kg m2" in told
    assert "motion.event.start.duration: a force, where a time is needed" in told
    assert "belt.width: a force, where a length is needed" in told


def test_an_option_of_one_value_given_twice_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "tandem.toml"
    file.write_text(TANDEM, "utf-8")
    code, _, told = wraparc("solve", str(file), "--units", "si", "--units=us")
    assert code == 2
    assert "--units: given 2 times, and has one value. Leave all but one out." in told
    again = ("--set", "belt.width=1300 mm", "--set", "belt.width=1.4 m")
    assert "--set belt.width: given 2 times" in wraparc("solve", str(file), *again)[2]
    # what may be given more than once still may
    two = ("--set", "belt.width=1300 mm", "--set", "belt.speed=2.9 m/s")
    assert wraparc("solve", str(file), *two)[0] == 0
