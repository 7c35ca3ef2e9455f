"""Every wrong input is answered by sentences: file, key, value, what is allowed, remedy."""

import os
from pathlib import Path

import pytest

from wraparc import InputError
from wraparc.errors import Problem
from wraparc.files import drive_from_text, lagging_from_text, load_drive, load_lagging
from wraparc.schema.problems import Report

DRIVE = """format = 1
title = "Head drive"
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
entry_tension = "150 kN"
exit_tension = "60 kN"
"""

LAGGING = """format = 1
name = "mine"
thickness = "12 mm"
elastic_modulus = "6.9 MPa"
[law]
kind = "integral-log"
tested_slip = "15 mm"
knots = [
  { pressure = "34 kPa", peak_friction = 1.3, peak_slip = "16 mm" },
  { pressure = "690 kPa", peak_friction = 0.4, peak_slip = "26 mm" },
]
"""

TENSION_KEYS = "entry_tension, exit_tension, effective_tension, torque, power"


def problems(text: str, *swaps: tuple[str, str]) -> list[str]:
    for old, new in swaps:
        assert text.count(old) >= 1, old
        text = text.replace(old, new)
    read = lagging_from_text if text.startswith(LAGGING[:22]) else drive_from_text
    with pytest.raises(InputError) as caught:
        read(text, file="in.toml")
    assert all(problem.file == "in.toml" for problem in caught.value.problems)
    return [str(problem).removeprefix("in.toml: ") for problem in caught.value.problems]


def test_the_samples_are_good() -> None:
    assert drive_from_text(DRIVE).title == "Head drive"
    assert lagging_from_text(LAGGING)[0].name == "mine"


def between(low: str, high: str, value: str) -> str:
    return f'must be between {low} and {high}, got "{value}".'


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        # missing and unknown keys
        (
            'width = "1200 mm"',
            "",
            'belt.width: missing. Write for example width = "1200 mm".',
        ),
        ("title", "titel", 'titel: unknown key. Did you mean "title"?'),
        (
            'speed = "3 m/s"',
            'colour = "black"',
            (
                "belt.colour: unknown key. Write one of preset, name, kind, width, modulus, "
                "elongation and 20 more."
            ),
        ),
        ('name = "head"', "", 'pulley[1].name: missing. Write name = "head".'),
        # dimensions
        (
            '"1200 mm"',
            '"1200 kN"',
            'belt.width: a force, where a length is needed, got "1200 kN". Write for example '
            '"1200 mm".',
        ),
        (
            '"1200 mm"',
            "1200",
            "belt.width: no unit, where a length is needed, got 1200. Write the unit too, "
            'for example "1200 mm".',
        ),
        (
            '"180 deg"',
            '"180 Deg"',
            'pulley.head.wrap_angle: unknown unit "Deg", got "180 Deg". Did you mean deg?',
        ),
        # numbers that can be read in two ways, or are none
        (
            '"150 kN"',
            '"1,5 kN"',
            (
                "pulley.head.entry_tension: a comma can mean decimal point or thousands "
                'separator, got "1,5 kN". Write "1.5 kN".'
            ),
        ),
        (
            '"60 kN"',
            '"1 800 N"',
            (
                'pulley.head.exit_tension: digits in groups can be one number or several, got "1 '
                '800 N". Write "1800 N".'
            ),
        ),
        (
            '"150 kN"',
            '"nan kN"',
            'pulley.head.entry_tension: not a finite number, got "nan kN". Give the size '
            "that was measured or meant.",
        ),
        (
            '"150 kN"',
            '"1e400 kN"',
            'pulley.head.entry_tension: not a finite number, got "1e400 kN". Give the size '
            "that was measured or meant.",
        ),
        (
            '"150 kN"',
            "inf",
            "pulley.head.entry_tension: no unit, where a force is needed, got Infinity. "
            'Write the unit too, for example "150 kN".',
        ),
        # sizes
        ('"1200 mm"', '"-1200 mm"', f"belt.width: {between('1 mm', '10 m', '-1200 mm')}"),
        ('"800 mm"', '"0 mm"', f"pulley.head.diameter: {between('1 mm', '1000 m', '0 mm')}"),
        (
            '"3 m/s"',
            '"0 m/s"',
            'belt.speed: must be more than 0 m/s and at most 1000 m/s, got "0 m/s".',
        ),
        (
            '"60 kN"',
            '"0 kN"',
            'pulley.head.exit_tension: must be between 0.0001 kN and 1000000 kN, got "0 kN".',
        ),
        (
            '"60 kN"',
            '"-60 kN"',
            'pulley.head.exit_tension: must be between 0.0001 kN and 1000000 kN, got "-60 kN".',
        ),
        *(
            (
                '"180 deg"',
                f'"{angle}"',
                f'pulley.head.wrap_angle: must be between 1 deg and 720 deg, got "{angle}".',
            )
            for angle in ("0 deg", "720.1 deg", "-180 deg", "2.1 turn")
        ),
        # tensions: see test_tensions for all of them
        (
            'exit_tension = "60 kN"',
            'effective_tension = "150 kN"',
            (
                'pulley.head.effective_tension: leaves an exit tension of 0 kN, got "150 kN". '
                "Lower Te, or raise T2."
            ),
        ),
        # names
        (
            "Plylon Plus 1000/4",
            "Plylon 1000/4",
            (
                'belt.preset: the catalogue has no belt of this name, got "Plylon 1000/4". Did '
                'you mean "Plylon Plus 1000/4" or "Plylon Plus 1800/4" or "Plylon Plus 1000/5"?'
            ),
        ),
        (
            'preset = "Plylon Plus 1000/4"',
            "",
            'belt.modulus: missing. Write modulus = "12960 kN/m" or preset = "EP 630/3".',
        ),
        (
            "diamond-rubber",
            "diamond",
            (
                'pulley.head.lagging: the catalogue has no lagging of this name, got "diamond". '
                'Did you mean "diamond-rubber"?'
            ),
        ),
        (
            '"diamond-rubber"',
            '"diamond-rubber"\ncondition = "wett"',
            (
                'pulley.head.condition: lagging "diamond-rubber" has no friction in this '
                'condition, got "wett". Did you mean "wet"?'
            ),
        ),
        (
            "diamond-rubber",
            "../secret.toml",
            (
                'pulley.head.lagging: cannot be a path here, got "../secret.toml". Write a '
                "catalogue name, or add a [lagging.NAME] table."
            ),
        ),
        # kinds of values
        (
            '"60 kN"',
            '"60 kN"\nrecovery = "no"',
            'pulley.head.recovery: must be true or false, got "no". Write it without quotes.',
        ),
        (
            '"60 kN"',
            '"60 kN"\noverrun = "-0.1 km"',
            f"pulley.head.overrun: {between('-1000 mm', '1000 mm', '-0.1 km')}",
        ),
        ('"Head drive"', "1", "title: must be text, got 1. Put it in quotes."),
        (
            '"Head drive"',
            '"\\u001b[2J"',
            'title: contains characters that cannot be printed, got "\\u001b[2J". Remove them.',
        ),
        (
            '"diamond-rubber"',
            "[1]",
            "pulley.head.lagging: must be text, got [1]. Put it in quotes.",
        ),
        # format
        (
            "format = 1",
            "format = 2",
            "format: must be at most 1 for this version of wraparc, got 2. Update wraparc.",
        ),
        (
            "format = 1",
            'format = "1"',
            'format: must be a whole number from 1, got "1". Write format = 1.',
        ),
        ("format = 1", "", "format: missing. Write format = 1."),
        # provenance
        (
            '"3 m/s"',
            '"3 m/s"\nprovenance = { kind = "published" }',
            "belt.provenance: a published number without a source. "
            "Name the publication, or call the number given or illustrative.",
        ),
        (
            '"3 m/s"',
            '"3 m/s"\nsources = { wdith = { kind = "measured" } }',
            'belt.sources.wdith: is no key of this table. Did you mean "width"?',
        ),
    ],
)
def test_one_fault_of_a_drive_file(old: str, new: str, expected: str) -> None:
    assert problems(DRIVE, (old, new)) == [expected]


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            '"690 kPa"',
            '"20 kPa"',
            (
                'law.knots[2].pressure: must be more than "34 kPa" of the row before, got "20 '
                'kPa". Sort the rows by pressure.'
            ),
        ),
        (
            '"690 kPa"',
            '"0.34 bar"',
            (
                'law.knots[2].pressure: must be more than "34 kPa" of the row before, got "0.34 '
                'bar". Sort the rows by pressure.'
            ),
        ),
        (
            "peak_friction = 0.4",
            "peak_friction = -0.4",
            "law.knots[2].peak_friction: must be more than 0 and at most 5, got -0.4.",
        ),
        (
            '"26 mm"',
            '"0 mm"',
            'law.knots[2].peak_slip: must be more than 0 mm and at most 1000 mm, got "0 mm".',
        ),
        (
            'peak_slip = "26 mm"',
            'peak_slip = "26 mm", post_peak_slope = "0.01 1/mm"',
            'law.knots[2].post_peak_slope: must be between -1000 1/mm and 0 1/mm, got "0.01 1/mm".',
        ),
        (
            '"integral-log"',
            '"integral-lag"',
            'law.kind: must be one of "integral-log", "constant", "elastic-plastic", '
            '"power", "table", got "integral-lag". Did you mean "integral-log"?',
        ),
        (
            'kind = "integral-log"',
            "",
            'law.kind: missing. Write one of "integral-log", "constant", "elastic-plastic", '
            '"power", "table".',
        ),
        (
            'tested_slip = "15 mm"',
            'tested_slip = "15 mm"\nslip_unit = "mm"',
            'law.slip_unit: belongs to pieces; each number of knots has its own unit, got "mm".',
        ),
        (
            'elastic_modulus = "6.9 MPa"',
            "",
            "shear_modulus: missing for a lagging with thickness. "
            "Give shear_modulus or elastic_modulus.",
        ),
        (
            'thickness = "12 mm"',
            "",
            'thickness: missing: elastic_modulus needs it. Write thickness = "12 mm".',
        ),
        (
            'thickness = "12 mm"',
            'thickness = "12 mm"\ncompression_modulus = "10 MPa"\nblock = { width = "3 cm" }',
            "block: contradicts compression_modulus. Remove one of them.",
        ),
        (
            'thickness = "12 mm"',
            'thickness = "12 mm"\ncost = { material = 1, installation = 2, currency = "AUD", '
            'area = "6 m2", life_years = [2, 1] }',
            "cost.life_years: must be the shortest and the longest life in years, both more "
            "than 0, got [2.0, 1.0].",
        ),
        (
            'tested_slip = "15 mm"',
            'tested_slip = "15 mm"\nfit = { parameters = ["a"], values = [1], '
            "covariance = [[-1]] }",
            "law.fit.covariance: must have no negative eigenvalue: no variance is negative.",
        ),
    ],
)
def test_one_fault_of_a_lagging_file(old: str, new: str, expected: str) -> None:
    assert problems(LAGGING, (old, new)) == [expected]


def test_laws_of_one_condition() -> None:
    law = '\n[[law]]\nkind = "constant"\nfriction = 0.3\n'
    head = LAGGING[: LAGGING.index("[law]")]
    assert problems(head + law + law) == [
        'law[2].condition: a second law for this condition, got "dry". Give each law its own '
        "condition."
    ]
    assert problems(head) == ["law: missing. Add a [law] table, as the examples show."]


def test_all_faults_at_once_and_in_the_order_of_the_file() -> None:
    swaps = [
        ("title", "titel"),
        ("Plylon Plus", "Plylon Minus"),
        ("1200 mm", "1200 kN"),
        ("800 mm", "0 mm"),
        ("diamond-rubber", "diamond-ruber"),
        ("150 kN", "1,5 kN"),
    ]
    found = problems(DRIVE, *swaps)
    assert [line.split(":")[0] for line in found] == [
        "titel",
        "belt.width",
        "pulley.head.diameter",
        "pulley.head.entry_tension",
        "belt.preset",
        "pulley.head.lagging",
    ]


def test_faults_of_tables_that_are_otherwise_right() -> None:
    """An unknown key does not hide what is wrong between the known ones."""
    found = problems(DRIVE, ("exit_tension", 'torqe = "1 kN m"\npower = "1 W"\nexit_tension'))
    assert [line.split(":")[0] for line in found] == ["pulley.head.torqe", "pulley.head"]


def test_repeated_pulleys() -> None:
    second = DRIVE[DRIVE.index("[[pulley]]") :]
    assert problems(DRIVE + second) == [
        'pulley.name: used 2 times, got "head". Give each its own name.'
    ]
    more = "".join(second.replace("head", f"head {i}") for i in range(10))
    assert problems(DRIVE + more) == ["pulley: must have 1 to 10 entries, got 11."]


def test_a_flood_of_faults_is_cut() -> None:
    text = DRIVE + "".join(f"x{i} = 1\n" for i in range(1000))
    found = problems(text)
    assert len(found) == 51
    assert found[-1] == "950 more problems are not listed."


# ---- text that is no TOML ----


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (
            DRIVE.replace('"1200 mm"', "1200 mm"),
            'line 5: not valid TOML, got "width = 1200 mm". '
            'Text needs quotes, and so does a quantity: width = "1200 mm".',
        ),
        (
            DRIVE + "x = [1, 2\n",
            "line 15: ends too early. Close the bracket or the quotes that are left open.",
        ),
        (
            DRIVE + 'title = "again"\ntitle = "and again"',
            'line 15: is there twice, got "title = \\"and again\\"". Leave one of them out.',
        ),
        (
            DRIVE + "[belt]\n",
            'line 14: is there twice, got "[belt]". Leave one of them out.',
        ),
        (
            DRIVE + 'x = "C:\\users"',
            'line 14: not valid TOML, got "x = \\"C:\\\\users\\"". '
            "Write paths with / , or in single quotes: 'C:\\drives\\lagging.toml'.",
        ),
        (
            DRIVE + "x = 2024-13-45\n",
            'line 14: not valid TOML, got "x = 2024-13-45". '
            'Text needs quotes, and so does a quantity: width = "1200 mm".',
        ),
    ],
)
def test_broken_text(text: str, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        drive_from_text(text, file="in.toml")
    assert str(caught.value) == f"in.toml, {sentence}"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "a = " + "[" * 100_000,
            (
                "in.toml: contains 100,000 lists and tables; at most 20,000 are read. Check that "
                "it is the right file."
            ),
        ),
        (
            "a = " + "[" * 61 + "]" * 61,
            "in.toml: is nested more than 60 deep. Check that it is the right file.",
        ),
        (
            "x = " + "9" * 5000,
            "in.toml: a key or number of more than 200 characters. "
            "Check that it is the right file.",
        ),
        (
            "a." * 41 + "b = 1",
            "in.toml, line 1: a key of more than 10 parts. Check that it is the right file.",
        ),
        ("# " + "x" * 5_000_000, "in.toml: is too large. Check that it is the right file."),
    ],
)
def test_text_that_would_choke_the_reader(text: str, expected: str) -> None:
    with pytest.raises(InputError) as caught:
        drive_from_text(text, file="in.toml")
    assert str(caught.value) == expected


def test_an_empty_file() -> None:
    assert [line.split(":")[0] for line in problems("")] == ["format", "belt", "pulley"]


# ---- files that cannot be read ----


def load_error(path: Path) -> str:
    with pytest.raises(InputError) as caught:
        load_drive(path)
    return str(caught.value).replace(str(path), "PATH")


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    file = tmp_path / "drive.toml"
    assert load_error(file) == "PATH: file not found."
    assert load_error(tmp_path) == "PATH: is a folder. Name a file in it."
    file.write_bytes(b"x" * 5_000_001)
    assert (
        load_error(file)
        == "PATH: is 5.0 MB large, more than 5 MB. Check that it is the right file."
    )
    file.write_bytes(b'format = 1\ntitle = "F\xf6rderer"\n')
    assert load_error(file) == (
        "PATH, line 2: is not UTF-8 text: byte 0xf6. Save it as UTF-8 text."
    )
    file.write_bytes(b" \n")
    assert load_error(file) == "PATH: is empty. Check that it is the right file."
    assert "cannot be read" in load_error(tmp_path / "a\0b")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes on this system")
def test_a_pipe_is_refused_without_waiting(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert load_error(tmp_path / "pipe") == (
        "PATH: is not a plain file. Give the path of a text file."
    )


def test_a_byte_order_mark_is_no_fault(tmp_path: Path) -> None:
    file = tmp_path / "drive.toml"
    file.write_text(DRIVE, "utf-8-sig")
    assert load_drive(file).title == "Head drive"


def test_lagging_files_are_relative_to_the_drive_file(tmp_path: Path) -> None:
    (tmp_path / "laggings").mkdir()
    (tmp_path / "laggings" / "mine.toml").write_text(LAGGING)
    file = tmp_path / "drive.toml"
    file.write_text(DRIVE.replace("diamond-rubber", "laggings/mine.toml"))
    assert load_drive(file).pulleys[0].lagging == load_lagging(tmp_path / "laggings" / "mine.toml")
    with pytest.raises(InputError, match="cannot be a path here"):
        load_drive(file, allow_paths=False)
    with pytest.raises(InputError, match="cannot be a path here"):
        load_lagging(tmp_path / "laggings" / "mine.toml", allow_paths=False)


def test_faults_of_a_lagging_file_name_that_file(tmp_path: Path) -> None:
    file, lagging = tmp_path / "drive.toml", tmp_path / "mine.toml"
    file.write_text(DRIVE.replace("diamond-rubber", "mine.toml"))
    assert load_error(file).replace(str(tmp_path), "DIR") == (
        'PATH: pulley.head.lagging: DIR/mine.toml: file not found, got "mine.toml".'
    )
    lagging.write_text(LAGGING.replace("12 mm", "12 kN"))
    assert load_error(file).replace(str(tmp_path), "DIR") == (
        'DIR/mine.toml: thickness: a force, where a length is needed, got "12 kN". Write for '
        'example "120 mm".'
    )


@pytest.mark.parametrize(
    ("lagging", "told"),
    [
        (
            '{ preset = "diamond-rubber", thickness = "0 mm" }',
            'lagging.thickness: must be at least 0.1 mm with blocks, got "0 mm".',
        ),
        (
            '{ surface = "rubber", law = { kind = "table", friction = 0.5 } }',
            'rows: missing. Write rows = [{ pressure = "100 kPa", friction = [0.0, 0.4, 0.5] }]',
        ),
    ],
)
def test_an_error_of_a_lagging_names_what_was_typed_and_shows_the_form(
    lagging: str, told: str
) -> None:
    found = problems(DRIVE, ('"diamond-rubber"', lagging))
    assert any(told in problem for problem in found), found


def test_a_name_with_a_hyphen_stays_one_step_of_a_key() -> None:
    report = Report("plan.toml")
    error = InputError(Problem(message="no cost", key="cost.lagging.diamond-rubber"))
    report.take(error, ())
    assert "cost.lagging.diamond-rubber" in str(report.problems[0])
