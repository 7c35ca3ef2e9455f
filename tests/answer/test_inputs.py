"""Every input has an origin, and the number of its source."""

from dataclasses import replace
from pathlib import Path

from answer.drives import drive, solved
from wraparc import Kind, PaperMarch, Provenance, load_drive, solve
from wraparc.answer.input_tables import input_tables
from wraparc.answer.inputs import drive_inputs
from wraparc.answer.sheet import shown
from wraparc.answer.sources import Sources
from wraparc.units import in_units

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_every_input_says_where_it_came_from() -> None:
    for name in ("head-drive-fabric", "downhill-braking", "test-pulley-calibrated"):
        drive = load_drive(EXAMPLES / f"{name}.toml")
        result = solve(drive, method=PaperMarch(), raise_on_failure=False)
        of = Sources()
        for table in shown(input_tables(drive_inputs(result.drive), of, stated=True), "si"):
            for row in table.rows:
                assert row.note, (name, table.title, row.title)


def test_the_assumed_inputs_of_the_test_pulley_say_so() -> None:
    """Its file marks the geometry illustrative and the tensions calibrated."""
    result = solve(load_drive(EXAMPLES / "test-pulley-calibrated.toml"), raise_on_failure=False)
    kinds = {(e.group, e.title): e.origin.kind for e in drive_inputs(result.drive) if e.origin}
    assert kinds["Pulley test", "Diameter over lagging"] is Kind.ILLUSTRATIVE
    assert kinds["Load case design", "Entry tension"] is Kind.CALIBRATED
    assert kinds["Belt", "Belt width"] is Kind.ILLUSTRATIVE
    assert kinds["Belt", "Rating of the belt"] is Kind.PUBLISHED


def test_the_customary_limit_names_its_source_and_another_does_not() -> None:
    def origin(limit: float) -> Provenance | None:
        result = solve(replace(drive(), creep_limit=limit), raise_on_failure=False)
        return next(e.origin for e in drive_inputs(result.drive) if e.title == "Creep limit")

    customary, own = origin(6.35e-3), origin(10e-3)
    assert customary is not None
    assert customary.kind is Kind.PUBLISHED
    assert "DeVries" in customary.source
    assert own is not None
    assert own.kind is Kind.GIVEN


def test_an_overrun_by_formula_is_called_computed() -> None:
    entries = {e.title: e for e in drive_inputs(solved().drive)}
    assert entries["Entry overrun"].origin is None
    assert "1.25 delta sqrt(delta/R)" in entries["Entry overrun"].remark
    given = {e.title: e for e in drive_inputs(drive(overrun=2e-5))}
    assert in_units(given["Entry overrun"].text()) == "0.02 mm"


def test_pulleys_alike_stand_side_by_side() -> None:
    base = drive()
    second = replace(base.pulleys[0], name="second", diameter=0.9)
    case = replace(
        base.load_cases[0],
        tensions=dict.fromkeys(("head", "second"), base.load_cases[0].tensions["head"]),
    )
    two = replace(base, pulleys=(base.pulleys[0], second), load_cases=(case,))
    tables = {t.title: t for t in shown(input_tables(drive_inputs(two), Sources()), "si")}
    assert tables["Pulleys"].heads == ("head", "second")
    assert tables["Pulleys"].rows[0].values == ("800 mm", "900 mm")
    assert [row.title for row in tables["Tensions"].rows] == [
        "full, pulley head",
        "full, pulley second",
    ]
    assert tables["Tensions"].heads == ("T1", "T2", "x_c")
    assert all(len(row.values) == len(t.heads) for t in tables.values() for row in t.rows)
