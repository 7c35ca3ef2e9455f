"""Runs: the same numbers however they are cut, kept when stopped, refused before they begin."""

import errno
import os
import signal
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq
import pytest

from cli.running import wraparc_process, wraparc_started
from study.studies import FOLDER, FRICTION, SAMPLING, TAKE_UP, study_of
from wraparc.errors import InputError
from wraparc.saving import put_in_place
from wraparc.study import run as run_module
from wraparc.study.executor import DaskCluster, Threads, executor_named
from wraparc.study.parameter_study import Study
from wraparc.study.parquet import METADATA, read_data
from wraparc.study.run import Run, parts_folder, run_study

CONDITIONS = [{"name": "dry", "share": 0.5}, {"name": "wet", "share": 0.5, "friction_factor": 0.8}]


QUICK = ["exit_creep", "exit_slip", "peak_shear_stress"]  # without the capacities


def small(**keys: Any) -> Study:
    """160 designs in 2 load cases and 2 conditions."""
    axes = [{**TAKE_UP, "count": 4}, FRICTION]
    whole: dict[str, Any] = {
        "condition": CONDITIONS,
        "load_cases": "all",
        "sampling": SAMPLING | {"samples": 40},
        "outputs": QUICK,
    }
    whole |= keys
    return study_of(*axes, **whole).study


def columns(path: Path) -> dict[str, bytes]:
    """Every column as its bytes: nan is like nan, and one bit matters."""
    table = pq.read_table(path).combine_chunks()
    return {
        name: str(table[name].to_pylist()).encode()
        if str(table.schema.field(name).type).startswith("dictionary")
        else np.ascontiguousarray(table[name].to_numpy()).tobytes()
        for name in table.column_names
    }


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("whole") / "whole.parquet"
    run_study(small(), path)
    return path


@pytest.mark.parametrize(("size", "threads"), [(1000, 1), (7, 2), (64, 3)])
def test_the_same_numbers_however_they_are_cut(
    whole: Path, tmp_path: Path, size: int, threads: int
) -> None:
    run_study(small(), tmp_path / "a.parquet", Run(part_designs=size, executor=Threads(threads)))
    assert columns(tmp_path / "a.parquet") == columns(whole)
    assert [p.name for p in tmp_path.iterdir()] == ["a.parquet"]


def test_the_file_says_what_it_holds(whole: Path) -> None:
    schema = pq.read_schema(whole)
    data = read_data(whole)
    assert data["seed"] == 4
    assert data["conditions"] == {"dry": 0.5, "wet": 0.5}
    assert data["input"]["drive"]["pulley"][0]["name"] == "head"
    assert schema.field("exit_creep").metadata[b"unit"] == b"m"
    assert METADATA in schema.metadata
    frame = pq.read_table(whole).to_pandas()
    assert len(frame) == 640
    assert frame["load_case"].cat.categories.tolist() == ["design", "start"]
    assert set(frame["status"]) == {"solved"}
    assert frame["design"].is_monotonic_increasing
    wet = frame[frame.condition == "wet"].set_index(["design", "load_case"])
    dry = frame[frame.condition == "dry"].set_index(["design", "load_case"])
    assert (wet.exit_creep > dry.exit_creep).all()


class _Stop(Exception):  # noqa: N818 - no error
    pass


def _stopping(after: int) -> Any:
    def tell(done: int, total: int) -> None:
        if done >= after:
            raise _Stop

    return tell


def test_a_stopped_run_is_resumed_where_it_was(whole: Path, tmp_path: Path) -> None:
    path = tmp_path / "a.parquet"
    with pytest.raises(_Stop):
        run_study(small(), path, Run(part_designs=16, progress=_stopping(48)))
    assert not path.exists()
    kept = sorted(parts_folder(path).glob("*.parquet"))
    assert 3 <= len(kept) < 10
    times = {file: file.stat().st_mtime_ns for file in kept}
    kept[0].write_bytes(kept[0].read_bytes()[:-20])  # a part that is torn is done again
    told: list[int] = []
    seen: dict[Path, int] = {}

    def tell(done: int, total: int) -> None:
        told.append(done)
        seen.update({f: f.stat().st_mtime_ns for f in kept if f.exists()})

    run_study(small(), path, Run(resume=True, progress=tell))
    assert told[0] == 16 * (len(kept) - 1)
    assert all(seen[file] == times[file] for file in kept[1:])
    assert seen[kept[0]] != times[kept[0]]
    assert columns(path) == columns(whole)
    assert not parts_folder(path).exists()


def test_parts_of_another_study_are_not_taken(tmp_path: Path) -> None:
    path = tmp_path / "a.parquet"
    with pytest.raises(_Stop):
        run_study(small(), path, Run(part_designs=16, progress=_stopping(16)))
    with pytest.raises(InputError, match="an interrupted run has left parts beside it"):
        run_study(small(), path)
    with pytest.raises(InputError, match="contains parts of another study"):
        run_study(small(setting="precise"), path, Run(resume=True))


def test_a_full_disk_keeps_what_is_done(
    whole: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.parquet"
    replace, count = os.replace, iter(range(100))

    def full(draft: Path, file: Path) -> None:
        if str(file).endswith(".parquet") and next(count) == 3:
            raise OSError(errno.ENOSPC, "No space left on device")
        replace(draft, file)

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(InputError, match="the disk is full; 3 of 10 parts are done"):
        run_study(small(), path, Run(part_designs=16))
    assert len(list(parts_folder(path).glob("*.parquet"))) == 3
    monkeypatch.undo()
    run_study(small(), path, Run(resume=True))
    assert columns(path) == columns(whole)


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("no/such/folder/a.parquet", "its folder does not exist"),
        ("a.csv", "must end in .parquet"),
    ],
)
def test_a_path_that_cannot_be_written(tmp_path: Path, name: str, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        run_study(small(), tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_a_large_study_has_to_be_confirmed_with_its_number(tmp_path: Path) -> None:
    study = small(sampling={"samples": 100_000, "seed": 1})
    for confirmed in (None, 1_599_999):
        with pytest.raises(InputError) as caught:
            run_study(study, tmp_path / "a.parquet", Run(confirmed_rows=confirmed))
        assert "rows: more than 1,000,000, up to 0.2 GB, got 1600000." in str(caught.value)
        assert "--confirm 1600000" in str(caught.value)
    assert (
        run_module.run_problems(study, tmp_path / "a.parquet", Run(confirmed_rows=1_600_000)) == []
    )


def test_a_study_that_the_disk_cannot_hold(tmp_path: Path) -> None:
    rows = 400_000_000 * 16
    study = small(sampling={"samples": 400_000_000, "seed": 1})
    with pytest.raises(InputError, match=r"GB needed, [\d.]+ GB free"):
        run_study(study, tmp_path / "a.parquet", Run(confirmed_rows=rows))


@pytest.mark.parametrize(
    ("address", "sentence"),
    [
        ("tcp://127.0.0.1:1", "no Dask scheduler answers there"),
        ("here", "is no address of a scheduler"),
        ("tcp://host:99999", "no Dask scheduler answers there"),
        ("local:0", "no number of processes"),
        ("local:x", "no number of processes"),
    ],
)
def test_a_cluster_out_of_reach_is_told_before_any_work(
    tmp_path: Path, address: str, sentence: str
) -> None:
    with pytest.raises(InputError, match=sentence):
        run_study(small(), tmp_path / "a.parquet", Run(executor=executor_named(address)))
    assert list(tmp_path.iterdir()) == []
    assert isinstance(executor_named("tcp://h:1"), DaskCluster)


# The second part waits until the first is kept, tells it, and is held
# until the run is given up.
_HELD = """
import glob
from wraparc.study import executor
solve_part, begun = executor.solve_part, []
kept = lambda: len(glob.glob(glob.escape(FOLDER) + "/*.parquet"))
before = kept()

def held(study, start, stop, tell):
    begun.append(start)
    if len(begun) == 1:
        return solve_part(study, start, stop, tell)
    while kept() == before:
        tell(0, stop - start)
    print("kept", flush=True)
    while True:
        tell(0, stop - start)

executor.solve_part = held
"""


@pytest.mark.processes
@pytest.mark.skipif(sys.platform == "win32", reason="no such signals there")
def test_a_run_killed_and_interrupted_ends_in_the_same_file(tmp_path: Path) -> None:
    """Real processes that have kept one part more and are at work on the next."""
    path, whole = tmp_path / "a.parquet", tmp_path / "whole.parquet"
    file, outputs = Path(FOLDER) / "take-up-grid.toml", 'outputs=["exit_creep"]'
    arguments = ("study", file, "--threads", "1", "--part", "40", "--set", outputs, "-o")
    code = f"FOLDER = {str(parts_folder(path))!r}\n{_HELD}"
    for count, number in enumerate((signal.SIGKILL, signal.SIGINT), start=1):
        process = wraparc_started(*arguments, path, "--resume", code=code)
        assert process.stdout is not None
        assert process.stdout.readline() == "kept\n"
        if count == 1:
            with pytest.raises(InputError, match="another run is writing this file"):
                run_study(small(), path, Run(resume=True))
        process.send_signal(number)
        _, told = process.communicate()
        assert len(list(parts_folder(path).glob("*.parquet"))) == count
        assert not path.exists()
    assert process.returncode == 130, told
    kept = f"2 of 3 parts are saved in {parts_folder(path)}: go on with --resume."
    assert f"Interrupted.\n{kept}\n" in told
    for into in (path, whole):
        ran = wraparc_process(*arguments, into, "--resume")
        assert ran.returncode == 0, ran.stderr
    assert path.read_bytes() == whole.read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.parquet", "whole.parquet"]


def test_what_a_run_leaves_that_dies_while_it_merges_goes_with_its_parts(
    whole: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.parquet"

    def dies(draft: Path, _: Path) -> None:
        assert draft.exists()
        raise _Stop

    monkeypatch.setattr(run_module, "put_in_place", dies)
    with pytest.raises(_Stop):
        run_study(small(), path)
    assert [p.name for p in tmp_path.iterdir()] == ["a.parquet.parts"]
    monkeypatch.setattr(run_module, "put_in_place", put_in_place)
    run_study(small(), path, Run(resume=True))
    assert path.read_bytes() == whole.read_bytes()
    assert [p.name for p in tmp_path.iterdir()] == ["a.parquet"]


def test_a_disk_without_room_for_the_first_byte_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(InputError, match="No space left on device"):
        run_study(small(), tmp_path / "a.parquet")
    assert list(tmp_path.iterdir()) == []
