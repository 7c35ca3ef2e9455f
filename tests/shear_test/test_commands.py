"""``wraparc rig``, ``read``, ``fit`` as a laboratory uses them, and ``solve`` with the result."""

import shlex
import shutil
from pathlib import Path

import numpy as np
import pytest

from cli.running import wraparc
from wraparc.cli.demo import examples_folder
from wraparc.files import load_lagging, load_lagging_conditions
from wraparc.shear_test import DIALECTS, read_machine_file
from wraparc.shear_test.plan_file import load_plan

EXAMPLE = examples_folder() / "shear_tests"
DRIVE = (examples_folder() / "head-drive-fabric.toml").read_text("utf-8")
# As the page "From tests to a lagging" prints it.
MAKE = shlex.split(
    "--lagging diamond-rubber --condition dry --condition wet=0.7 --repeats 2 --points 250 "
    "--scatter 0.01 --dialect bluehill --dialect testxpert --dialect excel --dialect "
    "bluehill-inch --dialect testsuite --dialect microtest --dialect logger --dialect trapezium "
    "--dialect polish"
)


def test_the_example_is_what_its_command_makes(tmp_path: Path) -> None:
    """Pinned: regenerate with ``wraparc rig examples/shear_tests`` and the options above."""
    folder = tmp_path / "made"
    assert wraparc("rig", folder, *MAKE).code == 0
    names = sorted(path.name for path in EXAMPLE.iterdir())
    assert names == sorted(path.name for path in folder.iterdir())
    assert (folder / "plan.toml").read_text("utf-8") == (EXAMPLE / "plan.toml").read_text("utf-8")
    for test in load_plan(EXAMPLE / "plan.toml").tests[::7]:
        shipped, made = (
            read_machine_file(at / test.file, test.choices) for at in (EXAMPLE, folder)
        )
        np.testing.assert_allclose(made.travel, shipped.travel, rtol=1e-9)
        np.testing.assert_allclose(made.force, shipped.force, rtol=1e-4, atol=0.01)
    assert sum(path.stat().st_size for path in EXAMPLE.iterdir()) < 1_500_000


def test_the_example_says_that_no_machine_wrote_it() -> None:
    text = (EXAMPLE / "plan.toml").read_text("utf-8")
    assert text.startswith("# Virtual tests, made by `wraparc rig`")
    plan = load_plan(EXAMPLE / "plan.toml")
    assert plan.provenance.kind.value == "illustrative"
    assert "made by the virtual rig" in plan.provenance.note


def test_from_files_to_a_solved_drive(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    ran = wraparc("fit", EXAMPLE / "plan.toml", "-o", "lagging.toml", "--report", "fit.html")
    assert (ran.code, ran.err) == (0, "Wrote lagging.toml\nWrote fit.html\n")
    assert "32 of 32 tests used; condition dry, wet" in ran.out
    assert Path("fit.html").read_text("utf-8").count("<figure") == 6
    dry, wet = load_lagging_conditions("lagging.toml")
    truth = load_lagging("diamond-rubber").law
    for pressure in (50e3, 207e3, 500e3):
        slips = np.linspace(1e-3, 12e-3, 8)
        wanted = truth.friction(slips, pressure)
        np.testing.assert_allclose(dry.law.friction(slips, pressure), wanted, rtol=0.06)
        np.testing.assert_allclose(wet.law.friction(slips, pressure), 0.7 * wanted, rtol=0.06)
    text = DRIVE.replace('lagging = "diamond-rubber"', 'lagging = "lagging.toml"')
    assert text != DRIVE
    Path("drive.toml").write_text(text, "utf-8")
    Path("truth.toml").write_text(DRIVE, "utf-8")
    creeps = []
    for name, more in (
        ("truth.toml", []),
        ("drive.toml", []),
        ("drive.toml", ["--set", "pulley.head.condition=wet"]),
    ):
        solved = wraparc("solve", name, "--load-case", "design", "--json", "-", *more)
        assert solved.code == 0
        creeps.append(solved.json["arcs"][0]["exit_creep"])
    assert creeps[1] == pytest.approx(creeps[0], rel=0.05)
    assert creeps[2] > 1.3 * creeps[0]


@pytest.mark.parametrize("name", list(DIALECTS))
def test_every_dialect_is_read_from_the_command_line(name: str, tmp_path: Path) -> None:
    dialect = DIALECTS[name]
    wraparc("rig", tmp_path / "lab", "--pressures", 69, "--repeats", 1, "--points", 60,
            "--dialect", name)  # fmt: skip
    (file,) = (p for p in (tmp_path / "lab").iterdir() if p.name != "plan.toml")
    ran = wraparc("read", file)
    if dialect.units:
        assert ran.code == 2
        assert "column Elongation has no unit. Add --unit 'Elongation=?'." in ran.err
        units = [f"{column}={unit}" for column, unit in dialect.units]
        ran = wraparc("read", file, "--unit", units[0], "--unit", units[1])
    assert ran.code == 0
    assert "used as travel" in ran.words
    assert "used as force" in ran.words
    assert "Used 60" in ran.words


def test_what_cannot_be_read_is_said_for_every_file(tmp_path: Path) -> None:
    good = EXAMPLE / "dry-0034kPa-1.csv"
    empty, binary = tmp_path / "empty.csv", tmp_path / "binary.csv"
    empty.write_bytes(b"")
    binary.write_bytes(bytes(range(256)) * 20)
    ran = wraparc("read", good, empty, binary, tmp_path / "gone.csv", tmp_path)
    assert ran.code == 2
    assert "Used 250" in ran.words  # the good one is shown
    assert ran.err.count("\n") == 5
    for text in ("is empty", "binary", "file not found", "is a folder"):
        assert text in ran.err
    assert "Traceback" not in ran.err


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (
            ["--unit", "Load"],
            'must be a column and its unit, got "Load". Write for example --unit Load=N.',
        ),
        (
            ["--unit", "Extension=N"],
            """units['Extension']: contradicts "mm" in the file, got "N".""",
        ),
        (["--unit", "Extension=furlong"], "no such unit"),
        (["--travel", "Weg"], "Weg"),
        (["--travel", "99"], "99"),
        (["--table", "3"], "has 1 tables"),
        (["--decimal", ","], 'decimal: contradicts 0.00000 in the file, got ",".'),
        (["--delimiter", "space"], "no such delimiter"),
        (["--encoding", "ebcdic7"], "ebcdic7"),
    ],
)
def test_wrong_options_of_read(options: list[str], sentence: str) -> None:
    ran = wraparc("read", EXAMPLE / "dry-0034kPa-1.csv", *options)
    assert ran.code == 2
    assert sentence in ran.err
    assert "Traceback" not in ran.err


def test_a_column_can_be_chosen() -> None:
    file = EXAMPLE / "dry-0034kPa-2.TRA"
    assert "The travel is 'Standardweg'; the file also has 'Traverse absolut'" in (
        wraparc("read", file).words
    )
    words = wraparc("read", file, "--travel", "Traverse absolut").words
    assert "Traverse absolut mm -794.8 -779.3 used as travel" in words
    assert "Traverse absolut mm -794.8 -779.3 used as travel" in (
        wraparc("read", file, "--travel", "3").words
    )


def small_plan(folder: Path, *more: str) -> Path:
    for name in ("dry-0034kPa-1.csv", "dry-0069kPa-2.csv", "dry-0103kPa-2.MTR"):
        shutil.copy(EXAMPLE / name, folder)
    tests = "".join(f'[[test]]\nfile = "{name}"\npressure = "{p} kPa"\n' for name, p in (
        ("dry-0034kPa-1.csv", 34), ("dry-0069kPa-2.csv", 69), ("dry-0103kPa-2.MTR", 103),
        ("gone.csv", 207),
    ))  # fmt: skip
    plan = folder / "plan.toml"
    head = 'format = 1\n[lagging]\nname = "mine"\n[rig]\nsample_area = "400 cm2"\n'
    plan.write_text(head + tests + "".join(more), "utf-8")
    return plan


def test_other_tests_go_on_and_what_was_left_out_is_listed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "200")  # the path of a file is not broken
    ran = wraparc("fit", small_plan(tmp_path), "-o", tmp_path / "out.toml")
    assert ran.code == 0
    assert "ATTENTION 2 of 4 tests could not be used." in ran.words
    assert "test[3]: column Elongation has no unit." in ran.words
    assert "gone.csv: test[4]: file not found." in ran.words
    assert load_lagging(tmp_path / "out.toml").name == "mine"


def test_the_result_as_json(tmp_path: Path) -> None:
    ran = wraparc("fit", small_plan(tmp_path), "--json", "-")
    assert ran.code == 0
    (condition,) = ran.json["conditions"]
    first = condition["tests"][0]
    low, high = first["peak_friction_interval"]
    assert low < first["peak_friction"] < high
    assert first["lash"] == pytest.approx(0.5e-3, abs=0.1e-3)
    # A = -mu_pk/x_pk with x in mm
    assert first["A"] == pytest.approx(-first["peak_friction"] / (1e3 * first["peak_slip"]))
    assert first["post_peak_slope_interval"] is None
    assert [row["pressure"] for row in condition["law"]] == pytest.approx([34e3, 69e3], rel=1e-2)
    assert len(ran.json["left_out"]) == 3
    file = tmp_path / "fit.json"
    ran = wraparc("fit", tmp_path / "plan.toml", "--json", file)
    assert f"Wrote {file}" in ran.err
    assert file.read_text("utf-8").startswith("{")


def test_nothing_is_written_where_no_test_can_be_used(tmp_path: Path) -> None:
    plan = small_plan(tmp_path)
    for name in ("dry-0034kPa-1.csv", "dry-0069kPa-2.csv"):
        (tmp_path / name).unlink()
    ran = wraparc("fit", plan, "-o", tmp_path / "out.toml", "--report", tmp_path / "fit.pdf")
    assert ran.code == 2
    assert ran.err.count("file not found") == 3
    assert not (tmp_path / "out.toml").exists()
    assert not (tmp_path / "fit.pdf").exists()


@pytest.mark.parametrize("option", ["-o", "--report"])
def test_outputs_are_checked_before_anything_is_read(option: str, tmp_path: Path) -> None:
    ran = wraparc("fit", tmp_path / "nowhere.toml", option, tmp_path / "out.docx")
    assert ran.code == 2
    assert "out.docx" in ran.err


def test_the_plan_is_not_written_over(tmp_path: Path) -> None:
    plan = small_plan(tmp_path)
    before = plan.read_bytes()
    ran = wraparc("fit", plan, "-o", plan)
    assert ran.code == 2
    assert "must not be a file that is read" in ran.err
    assert plan.read_bytes() == before


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (["--pressures", "69 kPa"], "--pressures"),
        (["--pressures", "-5"], "must be pressures from 0 to 10000 kPa, got"),
        (["--dialect", "klingon"], 'no such dialect, got "klingon". Write one of "bluehill"'),
        (["--condition", "wet=x"], "Write for example --condition wet=0.7."),
        (["--condition", "../up"], "must be a name"),
        (["--lagging", "nothing"], "nothing"),
    ],
)
def test_wrong_options_of_the_rig(options: list[str], sentence: str, tmp_path: Path) -> None:
    ran = wraparc("rig", tmp_path / "lab", *options)
    assert ran.code == 2
    assert sentence in ran.err
    assert not (tmp_path / "lab").exists()


def test_the_rig_writes_into_a_new_folder_only(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine", "utf-8")
    ran = wraparc("rig", tmp_path)
    assert ran.code == 2
    assert "is there already and not an empty folder" in ran.err
