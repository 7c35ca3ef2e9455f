"""Another kind of file is named with its command; one slip is one problem; stopping is braking.

Expected: the sentences, by hand, for every shipped file and every command that reads one.
"""

from pathlib import Path

import pytest

from cli.running import DRIVE, drive_file, wraparc
from wraparc import InputError, load_drive
from wraparc.files.write import drive_document

EXAMPLES = Path(__file__).parents[2] / "examples"
FILES = {
    "drive": (EXAMPLES / "head-drive-fabric.toml", "a drive file: wraparc solve"),
    "train": (EXAMPLES / "tandem-fabric.toml", "a drive file: wraparc solve"),
    "choose": (EXAMPLES / "wet-season" / "choose.toml", "a choose file: wraparc choose"),
    "study": (EXAMPLES / "studies" / "tolerances.toml", "a study file: wraparc study"),
    "event study": (EXAMPLES / "studies" / "start-ramp.toml", "a study file: wraparc study"),
    "plan": (EXAMPLES / "shear_tests" / "plan.toml", "a test plan: wraparc fit"),
    "calibrate": (
        EXAMPLES / "test-pulley" / "published-pair.toml", "a calibrate file: wraparc calibrate",
    ),
    "record": (
        EXAMPLES / "wet-season" / "wet-day-record.toml", "a calibrate file: wraparc calibrate",
    ),
    "csv": (EXAMPLES / "shear_tests" / "dry-0034kPa-1.csv", "a test file: wraparc read"),
    "tra": (EXAMPLES / "shear_tests" / "dry-0276kPa-1.TRA", "a test file: wraparc read"),
    "xlsx": (EXAMPLES / "shear_tests" / "dry-0069kPa-1.xlsx", "a test file: wraparc read"),
}  # fmt: skip
_DRIVES, _TESTS = ("drive", "train"), ("csv", "tra", "xlsx")
#: Command, what follows the file, and which files it reads.
COMMANDS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "solve": ((), _DRIVES),
    "check": ((), _DRIVES),
    "trim": ((), _DRIVES),
    "run": ((), _DRIVES),
    "stability": ((), _DRIVES),
    "report": (("-o", "-"), _DRIVES),
    "page": (("-o", "-"), _DRIVES),
    "field": ((), _DRIVES),
    "what-if": (("--worn", "6 mm"), _DRIVES),
    "family": (("--ratios", "2"), _DRIVES),
    "seek": (
        ("--vary", "belt.width", "--result", "exit_creep", "--value", "5 mm"), _DRIVES,
    ),
    "virtual-record": (("-",), _DRIVES),
    "lagging": ((), ()),
    "choose": ((), ("choose",)),
    "study": ((), ("study", "event study")),
    "fit": ((), ("plan",)),
    "calibrate": ((), ("calibrate", "record")),
    "overlay": ((), ("calibrate", "record")),
    "read": ((), _TESTS),
}  # fmt: skip


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_names_another_kind_of_file(command: str, tmp_path: Path) -> None:
    more, own = COMMANDS[command]
    if command == "virtual-record":
        more = (str(tmp_path / "record.csv"),)
    for kind, (path, words) in FILES.items():
        if kind in own or (command == "read" and kind == "record"):
            continue
        if command == "lagging" and kind in _TESTS:  # the name of one, as it has no .toml
            continue
        ran = wraparc(command, path, *more)
        assert ran.code == 2, (command, kind)
        assert ran.err == f"Error: {path}: this is {words} FILE.\n", (command, kind)


def test_a_lagging_file_is_named_too(tmp_path: Path) -> None:
    path = tmp_path / "lagging.toml"
    written = wraparc("fit", FILES["plan"][0], "-o", path)
    assert written.code == 0, written.err
    for command in ("solve", "choose", "study", "fit", "calibrate", "read"):
        ran = wraparc(command, path)
        assert ran.err == f"Error: {path}: this is a lagging file: wraparc lagging FILE.\n"
    assert wraparc("lagging", path).code == 0


def test_a_file_that_is_not_there_is_not_there(tmp_path: Path) -> None:
    assert "this is" not in wraparc("solve", tmp_path / "none.csv").err
    assert "this is" not in wraparc("read", tmp_path / "none.toml").err


#: A drive whose tensions are all in load cases.
WITHOUT = "".join(
    line for line in DRIVE.partition("[[load_case]]")[0].splitlines(keepends=True)
    if not line.startswith(("entry_tension", "exit_tension", "effective_tension"))
)  # fmt: skip
CASE = '[[load_case]]\nname = "start"\nkind = "starting"\n'
SLIPS = {
    "[pulley]": (
        DRIVE.replace("[[pulley]]", "[pulley]"),
        "pulley", "must be an array of tables", "Write [[pulley]] for [pulley].",
    ),
    "[load_case]": (
        DRIVE.replace("[[load_case]]", "[load_case]"),
        "load_case", "must be an array of tables", "Write [[load_case]] for [load_case].",
    ),
    "tensions in a load case": (
        f'{DRIVE}{CASE}entry_tension = "180 kN"\nexit_tension = "60 kN"\n',
        "load_case.start.entry_tension", "tensions of a load case belong to its pulleys",
        "Write pulley.head.entry_tension in the load case.",
    ),
    "a pull in a load case": (
        f'{DRIVE}{CASE}power = "180 kW"\n',
        "load_case.start.power", "tensions of a load case belong to its pulleys",
        "Write pulley.head.power in the load case.",
    ),
    "tensions in every load case of a print-out": (
        f'{WITHOUT}{CASE}entry_tension = "180 kN"\nexit_tension = "60 kN"\n'
        '[[load_case]]\nname = "full"\nentry_tension = "1,500 kN"\nexit_tension = "60 kN"\n',
        "load_case.start.entry_tension", "tensions of a load case belong to its pulleys",
        "Write pulley.head.entry_tension in the load case.",
    ),
}  # fmt: skip


@pytest.mark.parametrize("slip", SLIPS)
def test_one_slip_is_one_problem(slip: str, tmp_path: Path) -> None:
    text, key, message, remedy = SLIPS[slip]
    path = drive_file(tmp_path, text)
    with pytest.raises(InputError) as refused:
        load_drive(path)
    (problem,) = refused.value.problems
    assert (problem.key, problem.message, problem.remedy) == (key, message, remedy)
    assert str(problem) in wraparc("solve", path).err


def test_other_unknown_keys_of_a_load_case_are_still_named(tmp_path: Path) -> None:
    path = drive_file(tmp_path, f'{DRIVE}{CASE}entry_tension = "180 kN"\nkinds = "x"\n')
    with pytest.raises(InputError) as refused:
        load_drive(path)
    keys = [problem.key for problem in refused.value.problems]
    assert keys == ["load_case.start.entry_tension", "load_case.start.kinds"]


def test_stopping_is_read_as_braking(tmp_path: Path) -> None:
    text = f"{DRIVE}{CASE.replace('starting', 'stopping').replace('start', 'stop', 1)}"
    drive = load_drive(drive_file(tmp_path, text))
    assert drive.load_case("stop").kind == "braking"
    (_, case) = drive_document(drive)["load_case"]
    assert case["kind"] == "braking"
    assert wraparc("check", drive_file(tmp_path, text)).code == 0
