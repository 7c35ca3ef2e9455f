"""What a checking engineer looks for first: what was changed, computed, in which condition."""

from pathlib import Path

from cli.running import wraparc

EXAMPLES = Path(__file__).parents[2] / "examples"


def note(tmp_path: Path, file: Path, *options: str) -> str:
    out = tmp_path / "note.md"
    ran = wraparc("report", str(file), "-o", str(out), *options)
    assert ran.code in (0, 1), ran.err
    return out.read_text("utf-8")


def test_title_block_tells_changes_conditions_and_the_conveyor(tmp_path: Path) -> None:
    more = ("--set", "belt.speed=2.8 m/s", "--conditions", "dry,wet", "--creep-limit", "8 mm")
    text = note(tmp_path, EXAMPLES / "uphill-conveyor.toml", *more)
    assert (
        "- Changed from the file: belt.speed=2.8 m/s; conditions dry,wet; creep limit 8 mm\n"
        in text
    )
    assert "- Condition of the lagging: dry, wet\n" in text
    assert "- Conveyor: length 600 m, lift 20 m, capacity 1000 t/h\n" in text  # as in the file
    assert "T1 computed from the resistances of the conveyor" in text
    plain = note(tmp_path, EXAMPLES / "head-drive-fabric.toml")
    assert "Changed from" not in plain
    assert "- Condition of the lagging: dry\n" in plain


def test_what_was_given_is_told_from_what_was_computed(tmp_path: Path) -> None:
    text = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")
    file = tmp_path / "power.toml"
    head = text.partition("# The tensions above")[0]
    file.write_text(head.replace('entry_tension = "150 kN"', 'power = "270 kW"'), "utf-8")
    lines = note(tmp_path, file).splitlines()
    (row,) = [line for line in lines if line.startswith("| design | 150") and "rating" in line]
    assert "T1 computed from power 270 kW; 71.4 % of the belt's rating" in row
    assert "T2 computed" not in row


def test_every_coloured_row_has_its_word_and_they_are_as_many_as_are_counted(
    tmp_path: Path,
) -> None:
    text = note(tmp_path, EXAMPLES / "head-drive-fabric.toml")
    table = text.partition("## Checks against limits")[2].partition("Used: value over")[0]
    rows = [line for line in table.splitlines() if line.startswith("| ")][1:]
    words = [row.split("|")[5].strip() for row in rows]
    assert set(words) == {"OK", "ATTENTION"}
    kept = words.count("OK")
    assert f"- {kept} of {len(words)} checks pass.\n" in text
    results = text.partition("### All load cases and pulleys")[2].partition("###")[0]
    for method in ("distributed", "paper's integration"):
        marked = [line for line in results.splitlines() if line.endswith("| ATTENTION creep |")]
        assert [line[: line.index(" |", 2)] for line in marked if method in line] == [
            f"| design: head, {method}", f"| start: head, {method}",
        ]  # fmt: skip
    assert results.count("ATTENTION") == 4


def test_a_scaled_law_is_called_what_it_is(tmp_path: Path) -> None:
    text = note(tmp_path, EXAMPLES / "uphill-conveyor.toml", "--conditions", "wet")
    lead = (
        "- **ATTENTION** diamond-rubber not tested wet: dry friction times 0.824 used (head, full)."
    )
    assert lead in text
    assert "Data** Friction, block, E\\_c illustrative; G estimated." in text
    assert "is its dry law scaled as a whole" in text
    wet = ("--set", "condition=wet")
    named = note(tmp_path, EXAMPLES / "head-drive-fabric.toml", *wet)
    assert "## Results by load case, wet\n" in named
    assert "## Governing arc in detail: pulley head, load case start, wet\n" in named
    assert "a tested law" not in text
