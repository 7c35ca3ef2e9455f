"""``wraparc solve`` and ``check``: answers, exit codes, files. Numbers are those of the API."""

import csv
import dataclasses
import io
import json
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cli.running import DRIVE, SOFTENING, drive_file, wraparc
from wraparc import ArcResult, DriveResult, PaperMarch, Profile, load_drive, solve
from wraparc.cli.solve import METHODS
from wraparc.glossary import GLOSSARY
from wraparc.units import System, display_unit, unit_factor

pytestmark = pytest.mark.usefixtures("solved_once")

BREAKING = ("--set", "pulley.head.exit_tension=2 kN", "--load-case", "design")


@pytest.fixture
def drive(tmp_path: Path) -> Path:
    return drive_file(tmp_path)


# ---- the answer and the exit code ----


def test_a_drive_within_its_limit(drive: Path) -> None:
    ran = wraparc("solve", drive, "--load-case", "empty", "--full")
    assert (ran.code, ran.err) == (0, "")
    lead = "Head drive OK All 10 checks pass. Closest: belt tension 82 of 210 kN (head, empty)."
    assert ran.words.startswith(lead)
    assert "Wet Creep 1.73 mm (estimated) passes. Reserve ATTENTION at friction +47 % " in ran.words
    assert "Data Friction, block, E_c ill" in ran.words
    assert "CEMA, Belt Conveyors for Bulk Materials" in ran.out


def test_a_creep_over_its_limit_is_said_and_is_no_failure(drive: Path) -> None:
    ran = wraparc("solve", drive, "--full")
    assert ran.code == 0
    assert "ATTENTION Creep 7.49 mm exceeds the 6.35 mm limit (head, design)." in ran.words
    assert "Action Use lagging full-ceramic: creep 4.36 mm." in ran.words
    assert " Creep: DeVries allows 12.7 mm for this belt (creep_limit)." in ran.words
    assert "ATTENTION: 118 % of the limit, 6.35 mm" in ran.words


def test_a_breakaway_is_printed_and_gives_exit_code_1(drive: Path) -> None:
    ran = wraparc("solve", drive, *BREAKING)
    assert (ran.code, ran.err) == (1, "")
    assert "FAILS Gross slip: safety 0.214 is below 1 (head, design). Action " in ran.words
    assert "Creep at exit u(phi)" not in ran.words
    full = wraparc("solve", drive, *BREAKING, "--full").words
    assert "T1/T2 required: 75; transmissible at the creep limit: " in full


def test_a_breakaway_of_a_softening_law_tells_the_creep_there(tmp_path: Path) -> None:
    path = drive_file(tmp_path, SOFTENING)
    ran = wraparc("solve", path, "--load-case", "design", "--full")
    assert ran.code == 1
    result = solve(load_drive(path), raise_on_failure=False).arc("head")
    ratio, creep = result.capacities.gross_slip_capacity, result.capacities.gross_slip_creep
    assert ratio < 150 / 60
    assert math.isfinite(creep)
    assert f"{ratio:.2f} extrapolated, at {1e3 * creep:.2f} mm of creep" in ran.words


def test_one_breakaway_among_many_gives_exit_code_1(drive: Path) -> None:
    setting = "pulley.head.exit_tension=2 kN"
    ran = wraparc("solve", drive, "--set", setting)
    assert ran.code == 1
    assert "FAILS Creep 845 mm exceeds the 63.5 mm gross-slip limit (head, empty)." in ran.words


def test_the_governing_arc_is_shown_in_full_and_with_all_every_one(drive: Path) -> None:
    one, every = wraparc("solve", drive), wraparc("solve", drive, "--all")
    assert "Result: pulley head, load case design" in one.out
    assert "Result: pulley head, load case empty" not in one.out
    assert "Result: pulley head, load case design" in every.out
    assert "Result: pulley head, load case empty" in every.out


def test_settings_go_over_the_file(drive: Path) -> None:
    ran = wraparc("solve", drive, "--set", "pulley.head.lagging=full-ceramic", "--full")
    assert ran.words.count("The friction of full-ceramic is illustrative") == 1
    assert ran.words.count("Data Friction, block, E_c illustrative; G estimated.") == 1
    assert "diamond-rubber" not in ran.out


def test_a_creep_limit_goes_over_every_pulley(tmp_path: Path) -> None:
    path = drive_file(tmp_path, DRIVE.replace("[belt]", 'creep_limit = "1 mm"\n[belt]'))
    lead = "ATTENTION Creep 7.49 mm exceeds the 1 mm limit (head, design)."
    assert lead in wraparc("solve", path).words
    ran = wraparc("solve", path, "--creep-limit", "10 mm")
    assert (
        "OK All 10 checks pass. Closest: wet creep (estimated) 9.41 of 10 mm (head, design)."
        in ran.words
    )
    assert "Creep 7.49 mm max 10 mm 74.9 % OK head, design" in ran.words


@pytest.mark.parametrize("method", METHODS)
def test_every_method_is_offered(drive: Path, method: str) -> None:
    ran = wraparc("solve", drive, "--method", method)
    assert ran.code == 0
    assert ("The paper's integration lumps the shrinkage" in ran.words) is (method != "distributed")


def test_both_methods_stand_side_by_side(drive: Path) -> None:
    ran = wraparc("solve", drive, "--method", "both", "--load-case", "design", "--full")
    first = solve(load_drive(drive)).arc("head")
    second = solve(load_drive(drive), method=PaperMarch()).arc("head")
    texts = [f"{1e3 * r.exit_creep:.{p}f} mm" for r, p in ((first, 2), (second, 1))]
    assert f"Creep at exit u(phi) {texts[0]} {texts[1]}" in ran.words


# ---- JSON ----


def equal(value: object, number: float) -> bool:
    return value is None if not math.isfinite(number) else value == number


def test_json_holds_exactly_what_the_api_returns(drive: Path) -> None:
    ran = wraparc("solve", drive, "--method", "both", "--json", "-")
    assert (ran.code, ran.err) == (0, "")
    solved = load_drive(drive)
    arcs = [*solve(solved), *solve(solved, method=PaperMarch())]
    data = ran.json
    assert len(data["arcs"]) == len(arcs) == 4
    for told, arc in zip(data["arcs"], arcs, strict=True):
        scalars = arc.scalars()
        assert set(scalars) <= set(told)
        assert all(equal(told[name], number) for name, number in scalars.items())
        infinite = [name for name, number in scalars.items() if math.isinf(number)]
        assert told["unbounded"] == infinite
        assert told["profile"] == {n: values.tolist() for n, values in arc.profile.columns()}
        assert (told["pulley"], told["method"]) == ("head", arc.method)
        assert (told["status"], told["status_text"]) == ("solved", str(arc.status))
        assert told["inputs"]["overrun"] == arc.arc.entry_overrun
    assert data["arcs"][2]["creep_limit_capacity"] is None
    assert data["within_creep_limit"] is False
    assert data["governing"] == {
        "load_case": "design", "pulley": "head", "method": "distributed"
    }  # fmt: skip


def test_json_names_are_those_of_the_glossary_with_their_units(drive: Path) -> None:
    data = wraparc("solve", drive, "--json", "-").json
    arc = data["arcs"][0]
    told = {k for k, v in arc.items() if isinstance(v, float) or v is None}
    numbers = told | set(arc["profile"]) | set(arc["inputs"]) - {"overrun_by_formula", "recovery"}
    assert numbers <= set(GLOSSARY)
    assert numbers <= set(data["units"])
    for name, unit in data["units"].items():
        if unit != "1":
            assert unit_factor(unit, GLOSSARY[name].dimension) == 1.0


def test_json_tells_versions_sources_and_remarks(drive: Path) -> None:
    import numpy as np

    from wraparc import __version__

    data = wraparc("solve", drive, "--json", "-").json
    assert data["format"] == 3
    assert data["program"] == {"name": "wraparc", "version": __version__}
    assert data["libraries"]["numpy"] == np.__version__
    assert data["remarks"] == [
        "The friction of diamond-rubber is illustrative: it describes no real product. "
        "Illustrative: block of diamond-rubber, E_c of diamond-rubber. "
        "Estimated: G of diamond-rubber, E_c of diamond-rubber."
    ]
    kinds = {(s["of"], s["part"]): s["kind"] for s in data["sources"]}
    assert kinds["belt Plylon Plus 1000/4", ""] == "published"
    assert kinds["lagging diamond-rubber", ""] == "illustrative"
    cema = data["arcs"][0]["classical"][0]
    assert (cema["standard"], cema["friction"]) == ("CEMA", [0.35, 0.35])
    assert cema["slack_tension"][0] == pytest.approx(90e3 / math.expm1(0.35 * math.pi))


def test_json_of_a_breakaway(drive: Path) -> None:
    ran = wraparc("solve", drive, *BREAKING, "--json", "-")
    assert ran.code == 1
    (arc,) = ran.json["arcs"]
    assert arc["status"] == "breakaway"
    assert arc["status_text"].startswith("Gross slip")
    assert arc["gross_slip_creep"] is None
    assert "gross_slip_creep" in arc["unbounded"]
    assert ran.json["verdict"]["level"] == "FAILS"


# ---- CSV ----


def rows_of(text: str, delimiter: str = ",") -> list[list[str]]:
    return list(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter))


@pytest.mark.parametrize("system", ["si", "us"])
def test_csv_is_the_profile_in_the_units_of_its_heads(drive: Path, system: System) -> None:
    ran = wraparc("solve", drive, "--csv", "-", "--units", system)
    assert ran.out.startswith("\ufeff")
    head, *rows = rows_of(ran.out[1:])
    names = [field.name for field in dataclasses.fields(Profile)]
    units = [display_unit(GLOSSARY[name].dimension, system) for name in names]
    texts = [f"{n} [{u}]" if u else n for n, (u, _) in zip(names, units, strict=True)]
    assert head == ["load_case", "pulley", "method", *texts]
    arcs = solve(load_drive(drive)).arcs
    assert [row[:3] for row in rows] == [
        [a.arc.load_case, "head", "distributed"] for a in arcs for _ in range(len(a.profile))
    ]
    columns = np.array([row[3:] for row in rows], float).T
    for column, name, (_, size) in zip(columns, names, units, strict=True):
        expected = np.concatenate([getattr(a.profile, name) for a in arcs])
        assert column * size == pytest.approx(expected, rel=1e-9, abs=1e-15)


def test_csv_with_decimal_commas(drive: Path) -> None:
    points = rows_of(wraparc("solve", drive, "--csv", "-").out[1:])
    commas = rows_of(wraparc("solve", drive, "--csv", "-", "--decimal-comma").out[1:], ";")
    assert commas[1][4] == "150"
    assert commas[100][4].startswith("1")
    assert "," in commas[100][4]
    assert [[c.replace(",", ".") for c in row] for row in commas] == points


def test_csv_defuses_names_that_a_spreadsheet_would_run(tmp_path: Path) -> None:
    path = drive_file(tmp_path, DRIVE.replace('name = "empty"', 'name = "=1+1"'))
    ran = wraparc("solve", path, "--csv", "-", "--load-case", "=1+1")
    assert rows_of(ran.out[1:])[1][0] == "'=1+1"


# ---- files ----


def test_files_are_written_whole_and_named(drive: Path, tmp_path: Path) -> None:
    names = ("result.json", "profile.csv", "picture.svg")
    files = [tmp_path / name for name in names]
    options = zip(("--json", "--csv", "--plot"), files, strict=True)
    ran = wraparc("solve", drive, *(part for pair in options for part in pair))
    assert ran.code == 0
    assert ran.err == "".join(f"Wrote {file}\n" for file in files)
    assert json.loads(files[0].read_text("utf-8"))["solved"] is True
    assert files[1].read_bytes().startswith(b"\xef\xbb\xbfload_case,")
    assert b"<svg" in files[2].read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted((*names, "drive.toml"))


def test_a_breakaway_writes_its_files_too(drive: Path, tmp_path: Path) -> None:
    ran = wraparc("solve", drive, *BREAKING, "--plot", tmp_path / "b.png")
    assert ran.code == 1
    assert (tmp_path / "b.png").read_bytes().startswith(b"\x89PNG")


@pytest.fixture
def _no_solving(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> DriveResult:
        raise AssertionError("solved before the outputs were checked")

    monkeypatch.setattr("wraparc.cli.solve.solve_drive", refuse)


@pytest.mark.usefixtures("_no_solving")
def test_outputs_are_checked_before_anything_is_solved(drive: Path, tmp_path: Path) -> None:
    ran = wraparc(
        "solve", drive, "--json", tmp_path / "none" / "x.json", "--csv", tmp_path / "x.txt",
        "--plot", tmp_path / "x.jpg",
    )  # fmt: skip
    assert ran.code == 2
    assert ran.out == ""
    assert ran.err == (
        "Error: 3 problems:\n"
        f'  - --json: its folder does not exist, got "{tmp_path}/none/x.json". Make the '
        "folder first.\n"
        f'  - --csv: must end in .csv, got "{tmp_path}/x.txt". '
        f'Write for example "{tmp_path}/x.csv".\n'
        f'  - --plot: must end in .svg or .png or .pdf, got "{tmp_path}/x.jpg". '
        f'Write for example "{tmp_path}/x.svg".\n'
    )
    assert list(tmp_path.iterdir()) == [drive]


@pytest.mark.usefixtures("_no_solving")
def test_the_input_is_never_written_over(tmp_path: Path) -> None:
    path = drive_file(tmp_path, name="d.json")
    ran = wraparc("solve", path, "--json", path)
    assert ran.code == 2
    assert f'must not be a file that is read, got "{path}". Choose another name.' in ran.err
    assert path.read_text("utf-8") == DRIVE


@pytest.mark.usefixtures("_no_solving")
def test_two_outputs_are_two_files(
    drive: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.csv").symlink_to(tmp_path / "a.json")
    ran = wraparc("solve", drive, "--json", "a.json", "--csv", "a.csv")
    assert ran.code == 2
    assert '--csv: --json writes to the same place, got "a.csv". Name two files.' in ran.err
    both = wraparc("solve", drive, "--json", "-", "--csv", "-")
    assert (both.code, both.out) == (2, "")
    assert '--csv: --json writes to the same place, got "-".' in both.err


@pytest.mark.usefixtures("_no_solving")
def test_a_picture_without_matplotlib_is_refused_at_once(
    drive: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
    monkeypatch.setitem(__import__("sys").modules, "matplotlib.figure", None)
    ran = wraparc("solve", drive, "--plot", tmp_path / "x.svg")
    assert ran.code == 2
    assert ran.err == "Error: needs matplotlib: pip install 'wraparc[plot]'\n"


# ---- bad input ----


def test_every_problem_of_a_file_is_told_in_full_sentences(tmp_path: Path) -> None:
    text = DRIVE.replace("1200 mm", "1200 kN").replace("150 kN", "1,5 kN")
    path = drive_file(tmp_path, text)
    ran = wraparc("solve", path)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == (
        "Error: 2 problems:\n"
        f'  - {path}: belt.width: a force, where a length is needed, got "1200 kN". Write for '
        'example "1200 mm".\n'
        f"  - {path}: pulley.head.entry_tension: a comma can mean decimal point or thousands "
        'separator, got "1,5 kN". Write "1.5 kN".\n'
    )


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--load-case", "emty"], ('--load-case: the drive has no such load case, got "emty". '
                                   'Did you mean "empty"?')),
        (["--creep-limit", "10"], "--creep-limit: no unit, where a length is needed, got "
                                  '"10". Write the unit too, for example "1200 mm".'),
        (["--creep-limit", "-1 mm"], "--creep-limit: must be more than 0 mm and at most 1000 "
                                     'mm, got "-1 mm".'),
        (["--set", "belt.with=1 m"], 'belt.with: unknown key. Did you mean "width"?'),
    ],
)  # fmt: skip
def test_bad_options_are_told_in_full_sentences(
    drive: Path, arguments: list[str], sentence: str
) -> None:
    ran = wraparc("solve", drive, *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.rstrip().endswith(sentence)


def test_a_missing_file() -> None:
    ran = wraparc("solve", "nowhere.toml")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == ("Error: nowhere.toml: file not found.\n")


@given(st.text(max_size=40), st.text(max_size=40))
def test_no_text_of_a_setting_shows_a_traceback(key: str, value: str) -> None:
    path = Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml"
    for setting in (f"{key}={value}", f"pulley.head.{key}={value}", f"belt.width={value}"):
        ran = wraparc("solve", path, "--set", setting, "--load-case", "design")
        assert ran.code in (0, 1, 2), ran.err
        assert "Traceback" not in ran.err
        assert bool(ran.err) is (ran.code == 2)


# ---- check ----


def test_check_tells_inputs_and_remarks_and_solves_nothing(drive: Path) -> None:
    ran = wraparc("check", drive, "--full")
    assert ran.code == 0
    assert "OK Drive file valid: 1 pulley, 2 load cases. Data Friction, block, E_c ill" in ran.words
    modulus = "Belt modulus M 12960 kN/m published [1], rating: rated tension"
    assert f"{modulus}; static or dynamic: not stated" in ran.words
    assert "The friction of diamond-rubber is illustrative" in ran.words
    assert "Creep at exit" not in ran.out


def test_check_refuses_a_bad_file(tmp_path: Path) -> None:
    ran = wraparc("check", drive_file(tmp_path, "format = 1"))
    assert ran.code == 2
    assert "pulley: missing." in ran.err


def test_what_an_unsolved_arc_returns(drive: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A solver that misses its accuracy is a fault of the program, not of the drive."""
    from wraparc import Status

    solved = solve(load_drive(drive))

    def unsolved(arc: ArcResult) -> ArcResult:
        return dataclasses.replace(arc, status=Status.UNSOLVED)

    failed = dataclasses.replace(solved, arcs=tuple(map(unsolved, solved.arcs)))
    monkeypatch.setattr("wraparc.cli.solve.solve_drive", lambda *_, **__: failed)
    ran = wraparc("solve", drive)
    assert ran.code == 3
    assert "INTERNAL ERROR No solution (head, design)." in ran.words
    assert "Action Do not use this result. Report the drive file." in ran.words
    full = wraparc("solve", drive, "--full").words
    assert "The solver did not reach its accuracy on this arc." in full
