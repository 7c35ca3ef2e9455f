"""Tensions from any two quantities. Expected values: T1 - T2 = Te = 2 M/D = P/v, by hand."""

from itertools import combinations

import pytest

from wraparc import InputError
from wraparc.drive import DESIGN
from wraparc.files import drive_from_text

HEAD = """
format = 1
[belt]
width = "1200 mm"
modulus = "13 MN/m"
speed = "3 m/s"
"""

PULLEY = """
[[pulley]]
name = "{name}"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
"""

# 90 kN of pull: 0.4 m times that, 3 m/s times that.
DRIVING = {
    "entry_tension": "150 kN",
    "exit_tension": "60 kN",
    "effective_tension": "90 kN",
    "torque": "36 kN m",
    "power": "270 kW",
}
BRAKING = {
    "entry_tension": "60 kN",
    "exit_tension": "150 kN",
    "effective_tension": "-90 kN",
    "torque": "-36 kN m",
    "power": "-270 kW",
}
SAME = {"effective_tension", "torque", "power"}


def drive(*pulleys: dict[str, str], more: str = "") -> str:
    text = HEAD
    for number, given in enumerate(pulleys, start=1):
        text += PULLEY.format(name=f"p{number}")
        text += "".join(f'{key} = "{value}"\n' for key, value in given.items())
    return text + more


def tensions(text: str, case: str = DESIGN) -> list[tuple[float, float]]:
    cases = {c.name: c for c in drive_from_text(text).load_cases}
    return [(t.entry, t.exit) for t in cases[case].tensions.values()]


def complaints(text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        drive_from_text(text, file="drive.toml")
    return [str(problem) for problem in caught.value.problems]


@pytest.mark.parametrize("given", [DRIVING, BRAKING], ids=["driving", "braking"])
@pytest.mark.parametrize("keys", list(combinations(DRIVING, 2)))
def test_any_two_quantities(given: dict[str, str], keys: tuple[str, str]) -> None:
    text = drive({key: given[key] for key in keys})
    if SAME.issuperset(keys):
        assert complaints(text) == [
            f"drive.toml: pulley.p1: {keys[0]} and {keys[1]} each fix the effective tension. "
            "Leave one of them out."
        ]
    else:
        entry = 150e3 if given is DRIVING else 60e3
        assert tensions(text) == [pytest.approx((entry, 210e3 - entry), rel=1e-12)]


@pytest.mark.parametrize("key", list(DRIVING))
def test_one_quantity_is_not_enough(key: str) -> None:
    assert complaints(drive({key: DRIVING[key]})) == [
        f"drive.toml: pulley.p1: {key} alone does not fix the tensions. Give two of "
        "entry_tension, exit_tension, effective_tension (torque, power)."
    ]


def test_none_at_all() -> None:
    assert complaints(drive({})) == [
        (
            "drive.toml: pulley.p1: tensions missing. Give two of entry_tension, exit_tension, "
            "effective_tension (torque, power)."
        )
    ]


NO_DIAMETER = 'drive.toml: pulley.p1.diameter: missing. Write for example diameter = "1200 mm".'


def without_diameter(given: dict[str, str]) -> str:
    return drive(given).replace("diameter", "# diameter")


def test_tensions_are_asked_for_together_with_what_else_is_missing() -> None:
    missing, asked = complaints(without_diameter({}))
    assert missing == NO_DIAMETER
    assert asked == complaints(drive({}))[0]


def test_a_torque_without_a_diameter_lacks_the_diameter_alone() -> None:
    text = without_diameter({"exit_tension": "60 kN", "torque": "36 kN m"})
    assert complaints(text) == [NO_DIAMETER]


def test_three_that_agree_are_still_too_many() -> None:
    keys = ("entry_tension", "exit_tension", "power")
    assert complaints(drive({key: DRIVING[key] for key in keys})) == [
        (
            "drive.toml: pulley.p1: entry_tension, exit_tension and power are one too many. "
            "Leave one of them out."
        )
    ]


def test_three_that_contradict_each_other() -> None:
    given = DRIVING | {"power": "300 kW"}
    keys = ("entry_tension", "exit_tension", "power")
    assert complaints(drive({key: given[key] for key in keys})) == [
        "drive.toml: pulley.p1: power makes 100 kN, the tensions 90 kN. Leave one of them out."
    ]


def test_a_pull_beyond_the_tight_side() -> None:
    text = drive({"entry_tension": "150 kN", "effective_tension": "160 kN"})
    assert complaints(text) == [
        (
            'drive.toml: pulley.p1.effective_tension: leaves an exit tension of -10 kN, got "160 '
            'kN". Lower Te, or raise T2.'
        )
    ]
    text = drive({"exit_tension": "150 kN", "power": "-450 kW"})
    assert complaints(text) == [
        (
            'drive.toml: pulley.p1.power: leaves an entry tension of 0 kN, got "-450 kW". Lower '
            "Te, or raise T2."
        )
    ]


def test_power_needs_the_belt_speed() -> None:
    text = drive({"exit_tension": "60 kN", "power": "270 kW"}).replace("speed", "# speed")
    assert complaints(text) == [
        "drive.toml: pulley.p1.power: power needs the belt speed. "
        'Write speed = "3 m/s" in [belt], or give effective_tension.'
    ]


def test_a_faulty_speed_is_not_called_missing() -> None:
    text = drive({"exit_tension": "60 kN", "power": "270 kW"}).replace("3 m/s", "3 mm")
    assert complaints(text) == [
        'drive.toml: belt.speed: a length, where a speed is needed, got "3 mm". Write for '
        'example "3 m/s".'
    ]


def test_tensions_pass_from_pulley_to_pulley() -> None:
    """T1 of a pulley is T2 of the one before, whichever end is known."""
    first = {"entry_tension": "150 kN", "effective_tension": "50 kN"}
    text = drive(first, {"power": "120 kW"}, {"exit_tension": "30 kN"})
    expected = [(150e3, 100e3), (100e3, 60e3), (60e3, 30e3)]
    assert tensions(text) == expected
    text = drive(
        {"effective_tension": "50 kN"}, {"power": "120 kW"},
        {"effective_tension": "30 kN", "exit_tension": "30 kN"},
    )  # fmt: skip
    assert tensions(text) == expected
    text = drive(first, {}, {"entry_tension": "60 kN", "exit_tension": "30 kN"})
    assert tensions(text) == expected


def test_pulleys_apart_have_tensions_of_their_own() -> None:
    text = drive(
        {"entry_tension": "150 kN", "exit_tension": "90 kN"},
        {"entry_tension": "80 kN", "exit_tension": "30 kN"},
    )
    assert tensions(text) == [(150e3, 90e3), (80e3, 30e3)]


def test_a_gap_in_the_chain_is_named() -> None:
    text = drive({"entry_tension": "150 kN", "exit_tension": "90 kN"}, {})
    assert complaints(text) == [
        (
            "drive.toml: pulley.p2: tensions missing. Give two of entry_tension, exit_tension, "
            "effective_tension (torque, power)."
        )
    ]


# ---- load cases ----

CASES = """
[[load_case]]
name = "empty"
pulley.p1.power = "90 kW"

[[load_case]]
name = "moved take-up"
pulley.p1.exit_tension = "70 kN"

[[load_case]]
name = "brake"
pulley.p1 = { entry_tension = "60 kN", torque = "-36 kN m" }
"""


def test_load_cases_override_their_own_kind_or_all() -> None:
    text = drive({"effective_tension": "90 kN", "exit_tension": "60 kN"}, more=CASES)
    assert [c.name for c in drive_from_text(text).load_cases] == [
        DESIGN, "empty", "moved take-up", "brake",
    ]  # fmt: skip
    assert tensions(text) == [(150e3, 60e3)]
    assert tensions(text, "empty") == [(90e3, 60e3)]
    assert tensions(text, "moved take-up") == [(160e3, 70e3)]
    assert tensions(text, "brake") == [(60e3, 150e3)]


FIXED = '\n[take_up]\nkind = "fixed"\n'


@pytest.mark.parametrize("key", ["effective_tension", "torque", "power"])
def test_a_fixed_take_up_holds_the_sum_where_a_load_case_gives_the_pull_alone(key: str) -> None:
    """150 + 60 = 210 kN held: a pull of 30 kN makes 120 and 90 kN, braking 30 kN the reverse."""
    size = {"effective_tension": "30 kN", "torque": "12 kN m", "power": "90 kW"}[key]
    table = '\n[[load_case]]\nname = "{name}"\npulley.p1.{key} = "{size}"\n'
    more = FIXED + table.format(name="empty", key=key, size=size)
    more += table.format(name="back", key=key, size=f"-{size}")
    text = drive({"effective_tension": "90 kN", "exit_tension": "60 kN"}, more=more)
    assert tensions(text, "empty") == [pytest.approx((120e3, 90e3))]
    assert tensions(text, "back") == [pytest.approx((90e3, 120e3))]
    held = text.replace("fixed", "gravity")
    assert tensions(held, "empty") == [(90e3, 60e3)]


def test_under_a_fixed_take_up_a_pull_alone_is_not_enough_where_the_sum_is_not_known() -> None:
    case = '\n[[load_case]]\nname = "empty"\npulley.p1.effective_tension = "30 kN"\n'
    text = drive({"exit_tension": "60 kN"}, more=FIXED + case)
    (told,) = complaints(text)
    assert "effective_tension alone does not fix the tensions" in told


def test_pulleys_without_enough_of_their_own_make_no_load_case() -> None:
    text = drive({"exit_tension": "60 kN"}, more=CASES.replace("exit_tension", "power", 1))
    text = text.replace('power = "70 kN"', 'power = "70 kW"')
    assert [c.name for c in drive_from_text(text).load_cases] == ["empty", "moved take-up", "brake"]


def test_a_third_quantity_in_a_load_case() -> None:
    text = drive({"entry_tension": "150 kN", "exit_tension": "60 kN"}, more=CASES)
    assert complaints(text) == [
        (
            "drive.toml: load_case.empty.pulley.p1: power makes 30 kN, the tensions 90 kN. Give "
            "two of entry_tension, exit_tension, power in the load case."
        )
    ]


def test_faults_of_load_cases() -> None:
    more = """
    [[load_case]]
    name = "empty"
    pulley.p2.power = "90 kW"
    [[load_case]]
    name = "empty"
    pulley.p1.power = "90 kN"
    pulley.p1.exit = "60 kN"
    [[load_case]]
    pulley.p1.exit_tension = "60 kN"
    """
    text = drive({"effective_tension": "90 kN", "exit_tension": "60 kN"}, more=more)
    assert complaints(text) == [
        'drive.toml: load_case[2].pulley.p1.exit: unknown key. Did you mean "exit_tension"?',
        'drive.toml: load_case[2].pulley.p1.power: a force, where a power is needed, got "90 '
        'kN". Write for example "250 kW".',
        'drive.toml: load_case[3].name: missing. Write name = "start".',
        'drive.toml: load_case[1].pulley.p2: no such pulley. Write one of "p1".',
        'drive.toml: load_case.name: used 2 times, got "empty". Give each its own name.',
    ]
