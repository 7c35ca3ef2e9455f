"""Files of `wraparc run`: there and whole, or not there; what is kept is said and gone on from."""

import errno
import signal
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from cli.running import Ran, wraparc
from wraparc.cli import run_rows
from wraparc.motion import checkpoint, follow
from wraparc.motion.checkpoint import Checkpoint
from wraparc.motion.march import March
from wraparc.saving import alone, put_in_place, to_disk

FILE = "examples/tandem-fabric.toml"
SHORT = "motion.event.start.duration=1 s"


def run(folder: Path, *more: str, name: str = "rows.csv") -> Ran:
    return wraparc(
        "run", FILE, "--quiet", "--points", "10", "--every", "0.02 s", "--set", SHORT,
        "--csv", str(folder / name), *more,
    )  # fmt: skip


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    folder = tmp_path_factory.mktemp("whole")
    assert run(folder).code == 0
    assert [p.name for p in folder.iterdir()] == ["rows.csv"]
    return (folder / "rows.csv").read_bytes()


@pytest.fixture(autouse=True)
def _often(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every step is looked at, and saved."""
    monkeypatch.setattr(follow, "_NOW_AND_THEN", 1)
    monkeypatch.setattr(Checkpoint, "due", Checkpoint.save)


def interrupted_at(monkeypatch: pytest.MonkeyPatch, moment: float) -> None:
    """Press Ctrl-C when the run has come to a moment [s]."""
    step = March.step

    def pressed(march: March, *given: object) -> None:
        step(march, *given)  # type: ignore[arg-type]
        if march.t - march.h < moment <= march.t:
            signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(March, "step", pressed)


def test_an_interrupted_run_goes_on_to_the_same_file(
    tmp_path: Path, undisturbed: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    state = tmp_path / "run.npz"
    with monkeypatch.context() as patch:
        patch.setattr(follow, "_NOW_AND_THEN", 1)
        interrupted_at(patch, 0.5)
        ran = run(tmp_path, "--checkpoint", str(state), "--plot", str(tmp_path / "a.svg"))
    assert ran.code == 130
    rows = len((tmp_path / "rows.csv.part").read_text("utf-8").splitlines()) - 1
    assert rows > 5
    assert ran.err.endswith(
        f"Interrupted.\n{rows} rows are saved in {tmp_path}/rows.csv.part. "
        f"{tmp_path}/rows.csv was not written. {tmp_path}/a.svg was not written. "
        f"The same command goes on from {state}.\n"
    )
    assert sorted(p.name for p in tmp_path.iterdir()) == ["rows.csv.part", "run.npz"]
    assert run(tmp_path, "--checkpoint", str(state)).code == 0
    assert (tmp_path / "rows.csv").read_bytes() == undisturbed
    assert [p.name for p in tmp_path.iterdir()] == ["rows.csv"]


def test_rows_of_an_interrupted_run_are_never_taken_for_whole(
    tmp_path: Path, undisturbed: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "rows.csv").write_text("of an earlier run")
    interrupted_at(monkeypatch, 0.5)
    ran = run(tmp_path, "--parquet", str(tmp_path / "rows.parquet"))
    assert ran.code == 130
    assert f"{tmp_path}/rows.parquet was not written." in ran.err
    assert (tmp_path / "rows.csv").read_text() == "of an earlier run"
    part = (tmp_path / "rows.csv.part").read_bytes()
    assert undisturbed.startswith(part)
    assert len(pq.read_table(tmp_path / "rows.parquet.part")) == part.count(b"\n") - 1


def test_a_full_disk_keeps_the_state_and_says_so(
    tmp_path: Path, undisturbed: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    state, written = tmp_path / "run.npz", []

    def full(file: int) -> None:
        written.append(file)
        if len(written) > 8:
            raise OSError(errno.ENOSPC, "No space left on device")
        to_disk(file)

    with monkeypatch.context() as patch:
        patch.setattr(run_rows, "to_disk", full)
        ran = run(tmp_path, "--checkpoint", str(state))
    assert ran.code == 2
    assert ran.err == (
        f"Error: {tmp_path}/rows.csv.part: cannot be written: No space left on device. Make "
        f"room: the same command goes on from {state}.\n"
    )
    assert sorted(p.name for p in tmp_path.iterdir()) == ["rows.csv.part", "run.npz"]
    assert run(tmp_path, "--checkpoint", str(state)).code == 0
    assert (tmp_path / "rows.csv").read_bytes() == undisturbed


def test_a_run_that_cannot_begin_leaves_nothing(tmp_path: Path) -> None:
    ran = run(tmp_path, "--checkpoint", str(tmp_path / "run.npz"), "--step", "9 s")
    assert ran.code == 2
    assert list(tmp_path.iterdir()) == []


def test_the_last_rows_are_safe_before_the_state_goes(
    tmp_path: Path, undisturbed: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    state, full = tmp_path / "run.npz", OSError(errno.ENOSPC, "No space left on device")
    end = Checkpoint.end

    def last(point: Checkpoint, *given: object, whole: bool) -> None:
        def flush() -> None:
            raise full

        point.flush = flush
        end(point, *given, whole=whole)  # type: ignore[arg-type]

    with monkeypatch.context() as patch:
        patch.setattr(Checkpoint, "end", last)
        assert run(tmp_path, "--checkpoint", str(state)).code == 2
    assert state.exists()
    assert not (tmp_path / "rows.csv").exists()
    assert run(tmp_path, "--checkpoint", str(state)).code == 0
    assert (tmp_path / "rows.csv").read_bytes() == undisturbed


def test_rows_without_a_saved_state_go_with_a_full_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(run_rows, "put_in_place", full)
    ran = run(tmp_path)
    assert ran.code == 2
    assert "cannot be written: No space left on device. Choose another place." in ran.err
    assert list(tmp_path.iterdir()) == []


class _DiesError(BaseException):
    pass


def test_what_a_run_leaves_that_dies_while_it_saves_goes_with_the_next(
    tmp_path: Path, undisturbed: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    state = tmp_path / "run.npz"

    def dies(draft: Path, target: Path) -> None:
        put_in_place(draft, target)
        draft.write_bytes(b"half a state")
        raise _DiesError

    with monkeypatch.context() as patch:
        patch.setattr(checkpoint, "put_in_place", dies)
        with pytest.raises(_DiesError):
            run(tmp_path, "--checkpoint", str(state))
    assert (tmp_path / ".run.npz.tmp").exists()
    assert run(tmp_path, "--checkpoint", str(state)).code == 0
    assert [p.name for p in tmp_path.iterdir()] == ["rows.csv"]
    assert (tmp_path / "rows.csv").read_bytes() == undisturbed


@pytest.mark.parametrize("taken", ["rows.csv", "run.npz"])
def test_two_runs_do_not_write_the_same_files(tmp_path: Path, taken: str) -> None:
    with alone(tmp_path / taken):
        ran = run(tmp_path, "--checkpoint", str(tmp_path / "run.npz"))
    assert ran.code == 2
    assert f'another run is writing this file, got "{tmp_path}/{taken}".' in ran.err
    assert list(tmp_path.iterdir()) == []
