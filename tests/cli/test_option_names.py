"""What is wrong with a value by name is told of its option."""

import pytest

from cli.running import wraparc

DRIVE = "examples/head-drive-fabric.toml"


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("dsign=6000", "--hours dsign: the drive has no such load case. It has design, empty,"),
        ("design=60000", "--hours design: must be between 0 and 8784 in a year"),
    ],
)
def test_hours_of_a_load_case_are_named_as_they_were_typed(given: str, said: str) -> None:
    ran = wraparc("field", DRIVE, "--hours", given)
    assert ran.code == 2
    assert said in ran.err
