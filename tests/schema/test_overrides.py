"""Values put over those of a document, by key path."""

import pytest

from wraparc import InputError
from wraparc.files import drive_from_text, overridden, parse_override
from wraparc.schema.overrides import parse_path
from wraparc.schema.source import parse

TEXT = """
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
[lagging.worn]
preset = "diamond-rubber"
thickness = "6 mm"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap = "180 deg"
lagging = "worn"
entry_tension = "150 kN"
exit_tension = "60 kN"
[[pulley]]
name = "no. 2"
diameter = "800 mm"
wrap_angle = "190 deg"
lagging = "full-ceramic"
effective_tension = "20 kN"
[[load_case]]
name = "start"
pulley.head.entry_tension = "180 kN"
"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("belt.width=1400 mm", ("belt.width", "1400 mm")),
        ('belt.width="1400 mm"', ("belt.width", "1400 mm")),
        (" belt.width = 1400 mm ", ("belt.width", "1400 mm")),
        ("title=a=b", ("title", "a=b")),
        ("pulley.head.recovery=false", ("pulley.head.recovery", False)),
        ("train.shares=[0.5, 0.5]", ("train.shares", [0.5, 0.5])),
        ("law.friction=0.35", ("law.friction", 0.35)),
        ("format=1", ("format", 1)),
        ("date=2024-01-31", ("date", "2024-01-31")),
        ("x=1\ny=2", ("x", "1\ny=2")),
        ("x=[1", ("x", "[1")),
        ("x=falsely", ("x", "falsely")),
        ("pulley.head.power=", ("pulley.head.power", None)),
    ],
)
def test_settings_on_a_command_line(text: str, expected: tuple[str, object]) -> None:
    assert parse_override(text) == expected


@pytest.mark.parametrize(
    ("path", "steps"),
    [
        ("belt.width", ("belt", "width")),
        ("pulley[2].diameter", ("pulley", 2, "diameter")),
        ('pulley."no. 2".diameter', ("pulley", "no. 2", "diameter")),
        ('pulley."a\\"b"', ("pulley", 'a"b')),
        ("load_case.start.pulley.head.power", ("load_case", "start", "pulley", "head", "power")),
    ],
)
def test_key_paths(path: str, steps: tuple[str | int, ...]) -> None:
    assert parse_path(path) == steps


@pytest.mark.parametrize("path", ["", "a..b", ".a", "a.", "[1].a", "a b", 'a."b', "a[x]", "a[1]b"])
def test_what_is_no_key_path(path: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_path(path)
    assert "no key path" in str(caught.value)


def test_the_document_is_not_changed() -> None:
    document, before = parse(TEXT), parse(TEXT)
    changed = overridden(document, {"pulley.head.diameter": "1 m", "belt.speed": "3 m/s"})
    assert document == before
    assert changed["pulley"][0]["diameter"] == "1 m"
    assert changed["belt"]["speed"] == "3 m/s"
    assert changed["pulley"][1] is document["pulley"][1]


def test_tables_of_arrays_are_found_by_name_or_position() -> None:
    document = parse(TEXT)
    for path in ('pulley."no. 2".diameter', "pulley[2].diameter", "pulley.2.diameter"):
        assert overridden(document, {path: "1 m"})["pulley"][1]["diameter"] == "1 m"
    case = overridden(document, ["load_case.start.pulley.head.exit_tension=70 kN"])
    assert case["load_case"][0]["pulley"]["head"] == {
        "entry_tension": "180 kN", "exit_tension": "70 kN",
    }  # fmt: skip


def test_a_key_is_taken_away_by_nothing() -> None:
    document = overridden(parse(TEXT), ["pulley.head.exit_tension=", "pulley.head.power=1 kW"])
    assert "exit_tension" not in document["pulley"][0]
    assert len(overridden(parse(TEXT), {"pulley[2]": None})["pulley"]) == 1


def test_a_path_below_a_preset_makes_a_table_of_it() -> None:
    lagging = drive_from_text(TEXT, overrides=["pulley.head.lagging.thickness=20 mm"])
    assert lagging.pulleys[0].lagging.thickness == 0.02
    assert lagging.pulleys[0].lagging.law == drive_from_text(TEXT).pulleys[0].lagging.law
    worn = drive_from_text(TEXT, overrides=["lagging.worn.thickness=3 mm"])
    assert worn.pulleys[0].lagging.thickness == 0.003


def test_both_words_for_the_wrap_angle() -> None:
    for word in ("wrap", "wrap_angle"):
        for pulley, position in (("head", 0), ('"no. 2"', 1)):
            drive = drive_from_text(TEXT, overrides={f"pulley.{pulley}.{word}": "200 deg"})
            assert drive.pulleys[position].wrap_angle == pytest.approx(3.490658504)


@pytest.mark.parametrize(
    ("override", "expected"),
    [
        (
            "pulley.tail.diameter=1 m",
            ('drive.toml: pulley.tail.diameter: pulley has nothing called "tail", got "1 m". '
             'Write one of "head", "no. 2".'),
        ),
        (
            "pulley.haed.diameter=1 m",
            ('drive.toml: pulley.haed.diameter: pulley has nothing called "haed", got "1 m". '
             'Did you mean "head"?'),
        ),
        (
            "pulley[3].diameter=1 m",
            ('drive.toml: pulley[3].diameter: pulley has nothing called 3, got "1 m". Write '
             'one of "head", "no. 2".'),
        ),
        (
            "belt.width.mm=3",
            "drive.toml: belt.width.mm: belt.width has nothing called mm, got 3.",
        ),
        (
            "belt.widht=1 m",
            'drive.toml: belt.widht: unknown key. Did you mean "width"?',
        ),
        (
            "belt.width=1 kN",
            'drive.toml: belt.width: a force, where a length is needed, got "1 kN". Write '
            'for example "1200 mm".',
        ),
        ("belt.width", ('no setting of a key, got "belt.width". Write KEY=VALUE, '
                       "belt.width=1400 mm.")),
    ],
)  # fmt: skip
def test_overrides_that_lead_nowhere(override: str, expected: str) -> None:
    with pytest.raises(InputError) as caught:
        drive_from_text(TEXT, file="drive.toml", overrides=[override])
    assert str(caught.value) == expected
