"""The load case that is meant where none is named: the running one of the largest pull.

Expected: by hand; the first of the file may be the empty conveyor.
"""

from dataclasses import replace

from wraparc import load_drive, load_train
from wraparc.drive import LoadCase, Tensions
from wraparc.train import match_drives, solve_train


def test_a_drive_means_its_largest_running_pull() -> None:
    drive = load_drive("examples/head-drive-fabric.toml")

    def case(name: str, entry: float, leaving: float, kind: str = "running") -> LoadCase:
        tensions = {"head": Tensions(entry=entry, exit=leaving)}
        return LoadCase(name=name, tensions=tensions, kind=kind)  # type: ignore[arg-type]

    empty, full, back = case("a", 9e4, 7e4), case("b", 17e4, 7e4), case("c", 6e4, 18e4)
    start = case("d", 25e4, 6e4, "starting")
    every = replace(drive, load_cases=(empty, full, start))
    assert every.load_case().name == "b"
    assert replace(drive, load_cases=(empty, full, back)).load_case().name == "c"  # brakes most
    assert replace(drive, load_cases=(start,)).load_case().name == "d"
    twice = replace(drive, load_cases=(empty, full, replace(full, name="e")))
    assert twice.load_case().name == "b"


def test_a_train_is_matched_for_its_largest_running_pull() -> None:
    train = load_train("examples/tandem-fabric.toml")
    turned = replace(train, cases=train.cases[::-1])
    assert [case.name for case in turned.cases] == ["empty", "design"]
    assert turned.case().name == "design"
    one, other = (match_drives(solve_train(of), points=5) for of in (train, turned))
    assert other.case.case.name == "design"
    assert other.equal.members[1].speed_trim == one.equal.members[1].speed_trim
