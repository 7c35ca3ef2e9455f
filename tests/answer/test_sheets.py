"""Tables: every number is that of the result, the same in both systems, with its source."""

import math
import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from answer.drives import BELT, drive, marched, solved, sticking
from wraparc import (
    ArcResult,
    DriveResult,
    Kind,
    Lagging,
    LoadCase,
    Provenance,
    Tensions,
    load_lagging,
    solve,
)
from wraparc.answer.catalogue_sheets import belts_sheet, lagging_sheet, laggings_sheet
from wraparc.answer.drive_sheet import drive_sheet, input_sheet
from wraparc.answer.sheet import Row, Sheet, Table, between, named, percent, quantity, shown
from wraparc.answer.sheet import shown as told_in
from wraparc.answer.sources import Sources
from wraparc.checks import Level, judge
from wraparc.glossary import GLOSSARY
from wraparc.units import Dimension, System, in_units, parse_quantity

LBF = 4.4482216152605
#: Tables whose rows have names of checks.
OF_CHECKS = ("checks", "least")

CASES: dict[str, Callable[[], DriveResult]] = {
    "over the limit": solved,
    "within the limit": lambda: solved(100e3, 70e3),
    "braking": lambda: solved(60e3, 80e3),
    "breaking away": lambda: solved(150e3, 2e3),
    "sticking": sticking,
}


@pytest.fixture(params=CASES)
def result(request: pytest.FixtureRequest) -> DriveResult:
    """A drive that ends in one of the ways an arc can end."""
    return CASES[request.param]()


def table(sheet: Sheet, title: str) -> Table:
    return next(t for t in sheet.tables if t.title.startswith(title))


def row(of: Table, title: str) -> Row:
    return next(r for r in of.rows if r.title.startswith(title))


def texts(sheet: Sheet) -> list[str]:
    return [
        text for t in sheet.tables for r in t.rows for text in (r.title, *r.values, r.note, t.note)
    ]


def test_rows_of_the_glossary_hold_the_result(result: DriveResult) -> None:
    """Read back: title, symbol and value to the three digits shown."""
    arc, checked = result.arc("head"), 0
    for t in told_in(drive_sheet([result]), "si").tables:
        if t.name in OF_CHECKS:
            continue
        for r in t.rows:
            numbers = arc.scalars()  # other names are of the table alone
            if r.name not in numbers or r.values[0] in ("-", "infinite"):
                continue
            entry, value = GLOSSARY[r.name], numbers[r.name]
            assert r.title == entry.title
            number = r.values[0].partition(" (")[0].partition(" of ")[0]
            assert parse_quantity(number, entry.dimension) == pytest.approx(value, rel=6e-3)
            checked += 1
    assert checked >= (4 if not result.solved else 15)


def test_rows_of_checks_hold_the_checks(result: DriveResult) -> None:
    """Read back: title, value, limit with its sense, share of the limit, status and place."""
    checks = {check.name: check for check in judge(result).listed}
    sheet = told_in(drive_sheet([result]), "si")
    rows = table(sheet, "Checks").rows
    assert {r.name for r in rows} == {name for name, check in checks.items() if check.compares}
    for r in rows:
        check = checks[r.name]
        value, limit, used, status = r.values
        assert (r.title, r.level, status) == (check.title, check.level, str(check.level))
        assert r.note.startswith(str(check.place))
        if check.name in ("balance", "usual_sizes"):
            assert value in ("-", "< 1e-4")
            continue
        assert parse_quantity(value, check.dimension) == pytest.approx(check.value, rel=6e-3)
        sense = "max " if check.at_most else "min "
        assert limit.startswith(sense)
        known = parse_quantity(limit.removeprefix(sense), check.dimension)
        assert known == pytest.approx(check.limit, rel=6e-3)
        share = check.value / check.limit if check.at_most else check.limit / check.value
        assert used == "> 10 times" or float(used.removesuffix(" %")) == pytest.approx(
            100.0 * share, rel=6e-3
        )
        assert (used == "> 10 times") == (share > 10.0)


def test_us_units_say_the_same(result: DriveResult) -> None:
    """Every quantity of the SI tables, read back, equals the one at the same place in US units."""
    si, us = (shown(drive_sheet([result]), s) for s in ("si", "us"))
    of_checks = {check.name: check.dimension for check in judge(result).listed}
    pairs = 0
    for one, other in zip(si.tables, us.tables, strict=True):
        for r, s in zip(one.rows, other.rows, strict=True):
            assert (r.title, r.name, r.level) == (s.title, s.name, s.level)
            for a, b in zip(r.values, s.values, strict=True):
                if not re.fullmatch(r"-?[0-9.]+(e-?\d+)? [A-Za-z0-9/ ()]+", a):
                    continue
                if one.name == "least":
                    dimension: Dimension = "mass" if r.name == "counterweight" else "force"
                elif one.name == "checks":
                    dimension = of_checks[r.name]
                elif r.name in GLOSSARY:
                    dimension = GLOSSARY[r.name].dimension
                else:  # a name of the table alone
                    continue
                values = [
                    parse_quantity(re.sub(r" \(.*", "", x) if "%" in x else x, dimension)
                    for x in (a, b)
                ]
                assert values[0] == pytest.approx(values[1], rel=1e-2)
                pairs += 1
    assert pairs >= 12
    units = " ".join(texts(us))
    assert not re.search(r"\d (mm|kN|kPa|kW)\b", units)


def test_the_creep_budget_adds_up() -> None:
    creep = table(told_in(drive_sheet([solved()]), "si"), "Creep by source")
    shares = [float(re.findall(r"\(([-0-9.]+) %\)", r.values[0])[0]) for r in creep.rows[:3]]
    assert sum(shares) == pytest.approx(100.0, abs=1.0)
    parts = [float(r.values[0].split()[0]) for r in creep.rows]
    assert sum(parts[:3]) == pytest.approx(parts[3], abs=2e-2)


def test_the_comparison_holds_closed_forms() -> None:
    """T_slack = Te/(exp(mu phi) - 1), ratio exp(mu phi), slipping arc ln(T1/T2)/mu, at 180 deg.

    The tension is a minimum: rounded up.
    """
    rows = table(told_in(drive_sheet([solved()]), "si"), "Compared with constant friction")
    assert row(rows, "This load").values == (
        f"{math.log(2.5) / math.pi:.3f}", "2.5", "60 kN", "180 deg"
    )  # fmt: skip
    cema = row(rows, "CEMA, rubber")
    slack, ratio = 90.0 / math.expm1(0.35 * math.pi), math.exp(0.35 * math.pi)
    slips = math.degrees(math.log(2.5) / 0.35)
    assert cema.values == (
        "0.35", f"{ratio:.2f}", f"{math.ceil(10.0 * slack) / 10.0:.1f} kN", f"{slips:.0f} deg",
    )  # fmt: skip
    dirty = row(rows, "DIN 22101, rubber, wet and dirty")
    assert dirty.values[3] == "gross slip"
    assert dirty.level is Level.ATTENTION
    c = solved().arc("head").capacities
    assert row(rows, "At the creep limit").values == (
        f"{c.equivalent_friction:.3f}",
        f"{c.creep_limit_capacity:.2f}",
        told_in(named("tension", c.least_exit_tension), "si"),
        "-",
    )


def test_gross_slip_is_marked_as_an_extrapolation_and_never_headlined() -> None:
    for result in (solved(), solved(100e3, 70e3)):
        sheet = told_in(drive_sheet([result]), "si")
        gross = row(table(sheet, "Capacity"), "Capacity at gross slip")
        assert gross.note.startswith("extrapolated, ")
        assert sheet.verdict is not None
        shown = gross.values[0]
        assert shown not in " ".join((sheet.verdict.text, *sheet.verdict.sentences))


def test_a_breakaway_shows_no_state_that_was_not_asked_for() -> None:
    sheet = told_in(drive_sheet([solved(150e3, 2e3)]), "si")
    titles = [t.title.partition(":")[0] for t in sheet.tables]
    assert titles == [
        "Checks", "Minimum T2 by check", "All load cases and pulleys",
        "Loads of pulleys and belt", "Capacity", "Compared with constant friction",
        "Inputs",
    ]  # fmt: skip


@pytest.mark.parametrize(("system", "force", "length"), [("si", 1e3, 1e-3), ("us", LBF, 0.0254)])
def test_one_line_for_each_arc(system: System, force: float, length: float) -> None:
    """Bare numbers in the units of the heads."""
    cases = [
        LoadCase(name=name, tensions={"head": Tensions(entry=150e3, exit=leaving)})
        for name, leaving in (("full", 60e3), ("start", 2e3))
    ]
    result = solve(replace(drive(), load_cases=tuple(cases)), raise_on_failure=False)
    lines = table(shown(drive_sheet([result]), system), "All load cases and pulleys")
    full = result.arcs[0]
    assert [r.title for r in lines.rows] == ["full: head", "start: head"]
    numbers = [float(text) for text in lines.rows[0].values if re.fullmatch(r"[0-9.]+", text)]
    assert numbers == pytest.approx(
        [
            150e3 / force, 60e3 / force, 2.5, full.exit_creep / length,
            full.capacities.least_exit_tension / force,
        ],
        rel=6e-3,
    )  # fmt: skip
    assert lines.rows[0].values[4] == f"{100 * full.exit_creep / 6.35e-3:.0f} %"
    assert lines.rows[1].values[3:] == ("-", "-", "none", "FAILS gross slip")
    assert [r.level for r in lines.rows] == [Level.ATTENTION, Level.FAILS]


def test_both_methods_side_by_side() -> None:
    results = [solved(), marched()]
    answer = table(told_in(drive_sheet(results), "si"), "Result")
    assert answer.heads == ("distributed", "paper's integration")
    creep = row(answer, "Creep at exit")
    assert creep.values == tuple(
        told_in(named("exit_creep", r.arc("head").exit_creep), "si") for r in results
    )
    assert all(len(r.values) == 2 for r in answer.rows)


def test_a_method_that_breaks_away_is_said_and_its_column_left_out() -> None:
    from wraparc import Status

    def broken(arc: ArcResult) -> ArcResult:
        return replace(arc, status=Status.BREAKAWAY)

    other = replace(marched(), arcs=tuple(map(broken, marched().arcs)))
    sheet = told_in(drive_sheet([solved(), other]), "si")
    assert table(sheet, "Result").heads == ("",)
    assert any(
        r.startswith("pulley head, load case full, by the paper's integration: Gross slip")
        for r in sheet.remarks
    )


def test_every_source_is_listed_once_and_referred_to() -> None:
    sheet = told_in(drive_sheet([solved()]), "si")
    assert len(set(sheet.sources)) == len(sheet.sources) > 3
    referred = {int(n) for text in texts(sheet) for n in re.findall(r"\[(\d+)\]", text)}
    assert referred == set(range(1, len(sheet.sources) + 1))


def test_illustrative_and_calibrated_inputs_are_remarked() -> None:
    source = Provenance(Kind.CALIBRATED, "a known result")
    base = drive()
    pulley = replace(base.pulleys[0], sources={"entry_tension": source})
    marked = replace(base, pulleys=(pulley,))
    sheet = told_in(drive_sheet([solve(marked)]), "si")
    assert sheet.remarks == (
        "The friction of diamond-rubber is illustrative: it describes no real product. "
        "Illustrative: block of diamond-rubber, E_c of diamond-rubber. "
        "Calibrated: entry tension of pulley head. Estimated: G of diamond-rubber, "
        "E_c of diamond-rubber.",
    )
    assert row(table(sheet, "Inputs"), "Entry tension").note == (
        f"calibrated [{len(sheet.sources)}]; 71.4 % of the belt's rating"
    )


def test_rigid_parts_and_unknown_speed() -> None:
    bare = Lagging(name="bare", law=load_lagging("diamond-rubber").law, surface="bare")
    slow = replace(BELT, speed=None)
    sheet = told_in(drive_sheet([solve(drive(120e3, 80e3, bare, slow))]), "si")
    inputs = table(sheet, "Inputs")
    assert row(inputs, "Shear modulus").values == ("rigid",)
    energy = table(sheet, "Energy")
    assert energy.note == "Give the belt speed to see powers."
    assert [r.name for r in energy.rows] == ["efficiency", "frictional_energy"]


def test_wear_is_shown_where_the_coefficient_is_known() -> None:
    worn = replace(load_lagging("diamond-rubber"), wear_coefficient=1e-12)
    result = solve(drive(lagging=worn))
    wear = row(table(told_in(drive_sheet([result]), "si"), "Energy"), "Wear per million passes")
    energy = result.arc("head").energy.frictional_energy
    assert wear.values == (told_in(named("wear_rate", 1e6 * 1e-12 * energy), "si"),)


def test_idling_pulleys_are_told_as_such() -> None:
    sheet = told_in(drive_sheet([solve(drive(80e3, 80e3), raise_on_failure=False)]), "si")
    assert row(table(sheet, "Inputs"), "Effective tension").note == "idling"
    assert "nan" not in " ".join(texts(sheet)).casefold().replace("finance", "")


def test_the_input_sheet_solves_nothing() -> None:
    sheet = told_in(input_sheet(drive()), "si")
    assert [t.title for t in sheet.tables] == [
        "Checks before solving", "Belt", "Pulley head", "Lagging diamond-rubber",
        "Tensions",
    ]  # fmt: skip


# ---- catalogue ----


@pytest.mark.parametrize("system", ["si", "us"])
def test_the_friction_table_is_the_law(system: System) -> None:
    lagging = load_lagging("medium-ceramic")
    found = table(shown(lagging_sheet([lagging]), system), "Friction mu")
    unit = {"si": 1e-3, "us": 0.0254}[system]
    for r in found.rows:
        pressure = parse_quantity(r.title, "pressure")
        expected = lagging.law.friction(np.array([float(h) for h in found.heads]) * unit, pressure)
        assert [float(v) for v in r.values] == pytest.approx(expected.tolist(), abs=3e-3)


def test_coefficients_turn_back_into_the_law() -> None:
    """mu = A x ln x - b x with the printed A and b, x in mm, below the peak."""
    lagging = load_lagging("diamond-rubber")
    found = table(shown(lagging_sheet([lagging]), "si"), "Coefficients")
    for r in found.rows:
        a, b = (float(text) for text in r.values[:2])
        x, pressure = 6.35, parse_quantity(r.title, "pressure")
        mu = a * x * math.log(x) - b * x
        assert mu == pytest.approx(float(lagging.law.friction(6.35e-3, pressure)), abs=2e-4)


def test_lists_name_everything() -> None:
    laggings = told_in(laggings_sheet([load_lagging("full-ceramic")]), "si")
    assert laggings.tables[0].rows[0].title == "full-ceramic"
    assert len(told_in(belts_sheet(), "si").tables) == 2


# ---- parts ----


def test_texts_of_numbers() -> None:
    assert told_in(quantity(math.nan, "force"), "si") == "-"
    assert told_in(quantity(math.inf, "length"), "si") == "infinite"
    assert in_units(percent(0.12345)) == "12.3 %"
    assert told_in(percent(math.nan), "si") == "-"
    assert in_units(between("tension", 150e3, 60e3)) == "150 to 60 kN"
    assert in_units(between("tension", 60e3, 60e3)) == "60 kN"
    assert in_units(between("tension", 50e3, 30e3), "us") == "11200 to 6740 lbf"


def test_a_source_is_numbered_once() -> None:
    of = Sources()
    made = Provenance(Kind.PUBLISHED, "Maker", "2012", "rated")
    assert of.note(Provenance()) == ""
    assert of.note(Provenance(Kind.ILLUSTRATIVE)) == "illustrative"
    assert of.note(made) == "published [1], rated"
    assert of.note(replace(made, note="")) == "published [1]"
    assert of.note(Provenance(Kind.MEASURED, "Lab")) == "measured [2]"
    assert of.listed() == ("Maker, 2012", "Lab")
