"""Run a study: parts to files as they are solved, resumed where it stopped, merged at the end."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from time import process_time

from wraparc.batch import Setting
from wraparc.errors import InputError, Problem, input_error, shown
from wraparc.saving import (
    FULL,
    alone,
    interrupted,
    put_in_place,
    replacing,
    save_file,
    saving_problems,
    unwritable,
)
from wraparc.study.executor import Executor, Part, Threads
from wraparc.study.parameter_study import Study
from wraparc.study.parquet import merge, require_pyarrow, rows_of, schema_of

Progress = Callable[[int, int], object]

#: Rows of a study that is run without asking.
MOST_ROWS = 1_000_000
#: Rows of a part: a third of a second of work or so, and few enough for little memory.
PART_ROWS = {Setting.ENGINEERING: 4_096, Setting.PRECISE: 2_048}
_BYTES_A_NUMBER = 8
#: Of the sample that tells the time: places in the study, designs at each, and its own most [s].
_PLACES, _SAMPLES, _MOST_TIME = 4, (8, 136), 2.0
_PLAN, _WHOLE = "study.json", "whole.tmp"


@dataclass(frozen=True, kw_only=True)
class Run:
    """How a study is run; none of it changes a number.

    Attributes
    ----------
    executor
        Where.
    part_designs
        Designs of a part, or None for what suits the setting.
    resume
        Whether to go on with what an interrupted run has left.
    confirmed_rows
        Number of rows that the caller knows of; needed above `MOST_ROWS`.
    progress
        Called with the designs done and their number. What it raises ends the run; parts that are
        done stay.
    """

    executor: Executor = Threads()  # noqa: RUF009 - frozen
    part_designs: int | None = None
    resume: bool = False
    confirmed_rows: int | None = None
    progress: Progress | None = None


def parts_folder(path: str | os.PathLike[str]) -> Path:
    """Return where the parts of results are until they are merged."""
    target = Path(os.path.realpath(path))
    return target.with_name(f"{target.name}.parts")


def run_study(study: Study, path: str | os.PathLike[str], how: Run | None = None) -> None:
    """Solve a study into a Parquet file.

    Parameters
    ----------
    study
        The study.
    path
        File of results, ending in ``.parquet``. Parts stand in a folder beside it until the end.
    how
        How it is run.

    Raises
    ------
    InputError
        Before any work: if the file cannot be written, the study is larger than confirmed, the
        disk too small, the cluster out of reach, or an unfinished run is there. While at work: if
        the disk is full; parts that are done stay.
    """
    how = how or Run()
    require_pyarrow()
    with alone(path, "--output"):
        raise_problems(run_problems(study, path, how))
        how.executor.check()
        folder = parts_folder(path)
        parts = _begin(study, folder, how)
        with interrupted(lambda: _kept(folder, parts)):
            done = {part for part in parts if _is_done(study, folder, part)}
            _solve(study, folder, parts, done, how)
            _merge(study, folder, parts, path)
        shutil.rmtree(folder, ignore_errors=True)


def _merge(study: Study, folder: Path, parts: Sequence[Part], path: str | os.PathLike[str]) -> None:
    """Make one file of all parts, in their folder: what is left of it if all ends here goes too."""
    draft = folder / _WHOLE
    try:
        merge((_file(folder, part) for part in parts), schema_of(study), draft)
        put_in_place(draft, Path(os.path.realpath(path)))
    except OSError as error:
        draft.unlink(missing_ok=True)
        raise _stopped(error, path, len(parts), len(parts)) from None


def _kept(folder: Path, parts: Sequence[Part]) -> str:
    count = sum(_file(folder, part).exists() for part in parts)
    return f"{count} of {len(parts)} parts are saved in {folder}: go on with --resume."


def run_problems(study: Study, path: str | os.PathLike[str], how: Run) -> list[Problem]:
    """Return why a study could not be run; nothing if it can."""
    problems = saving_problems(path, suffixes=(".parquet",), key="--output")
    rows, confirmed = study.rows, how.confirmed_rows
    if rows > MOST_ROWS and confirmed != rows:
        size = _bytes(study) / 1e9
        problems.append(
            Problem(
                key="rows",
                value=f"{rows}",
                message=f"more than {MOST_ROWS:,}, up to {size:.1f} GB",
                remedy=f"Confirm it: --confirm {rows}.",
            )
        )
    folder = parts_folder(path)
    if not problems:
        free = shutil.disk_usage(folder.parent).free
        if 2 * _bytes(study) > free:
            problems.append(
                Problem(
                    key="--output",
                    value=shown(os.fspath(path)),
                    message=f"{2 * _bytes(study) / 1e9:.1f} GB needed, {free / 1e9:.1f} GB free",
                    remedy="Choose another place, or fewer outputs.",
                )
            )
    if folder.exists() and not how.resume:
        problems.append(
            Problem(
                key="--output",
                value=shown(os.fspath(path)),
                message="an interrupted run has left parts beside it",
                remedy="Go on with --resume, or remove them.",
            )
        )
    return problems


def raise_problems(problems: Sequence[Problem]) -> None:
    """Raise all problems as one error, if there are any."""
    if problems:
        raise InputError(problems)


def _bytes(study: Study) -> int:
    """Bytes that the results take at most."""
    return study.rows * _BYTES_A_NUMBER * len(schema_of(study).names)


def part_designs(study: Study) -> int:
    """Designs of a part that suit the setting."""
    rows = PART_ROWS[study.setting]
    return max(1, rows // len(study.cases))


def expected_time(study: Study) -> float:
    """Return the processor time that a study takes, about [s].

    That of a sample: designs at `_PLACES` of the study, more at once than at first, so that what
    does not grow with their number counts once.
    """
    total, took = len(study.plan), list[float]()
    for size in _SAMPLES:
        each = min(size, max(1, total // _PLACES))
        begin = process_time()
        for place in range(min(_PLACES, total)):
            start = place * total // _PLACES
            study.solve(start, min(start + each, total))
        took.append(process_time() - begin)
        if took[-1] > _MOST_TIME or each < size:
            return took[-1] * total / (min(_PLACES, total) * each)
    few, many = _SAMPLES
    return (took[0] + (took[1] - took[0]) * (total - few) / (many - few)) / _PLACES


def _begin(study: Study, folder: Path, how: Run) -> list[Part]:
    """Return the parts: those of the interrupted run where there is one."""
    size = how.part_designs or part_designs(study)
    file = folder / _PLAN
    if file.exists():
        size = _size_of(study, file)
    else:
        known = {"fingerprint": study.fingerprint, "title": study.title, "part_designs": size}
        try:
            folder.mkdir(exist_ok=True)
            save_file(file, json.dumps(known) + "\n")
        except OSError as error:
            raise InputError(unwritable(folder, error)) from None
        except InputError:
            with suppress(OSError):  # nothing is done yet, and nothing is left
                folder.rmdir()
            raise
    total = len(study.plan)
    return [Part(start, min(start + size, total)) for start in range(0, total, size)]


def _size_of(study: Study, file: Path) -> int:
    try:
        told = json.loads(file.read_text("utf-8"))
        same, size = told["fingerprint"] == study.fingerprint, int(told["part_designs"])
    except (OSError, ValueError, KeyError, TypeError):
        same, size = False, 0
    if not same or size < 1:
        raise input_error(
            key="--resume",
            value=shown(str(file.parent)),
            message="contains parts of another study",
            remedy="Remove it, or write another file.",
        )
    return size


def _file(folder: Path, part: Part) -> Path:
    return folder / f"{part.start:012d}-{part.stop:012d}.parquet"


def _is_done(study: Study, folder: Path, part: Part) -> bool:
    file = _file(folder, part)
    rows = (part.stop - part.start) * len(study.cases)
    return file.exists() and rows_of(file, study.fingerprint) == rows


def _solve(study: Study, folder: Path, parts: Sequence[Part], done: set[Part], how: Run) -> None:
    total = len(study.plan)
    designs = sum(part.stop - part.start for part in done)
    _tell(how.progress, designs, total)
    solved = how.executor.solve(study, [part for part in parts if part not in done])
    count = len(done)
    try:
        for part, content in solved:
            try:
                with replacing(_file(folder, part)) as draft:
                    draft.write_bytes(content)
            except OSError as error:
                raise _stopped(error, folder, count, len(parts)) from None
            count, designs = count + 1, designs + part.stop - part.start
            _tell(how.progress, designs, total)
    finally:
        close = getattr(solved, "close", None)
        if close is not None:
            close()


def _tell(progress: Progress | None, done: int, total: int) -> None:
    if progress is not None:
        progress(done, total)


def _stopped(error: OSError, path: str | os.PathLike[str], done: int, total: int) -> InputError:
    full = error.errno in FULL
    reason = "the disk is full" if full else f"cannot be written: {error.strerror or error}"
    return input_error(
        value=shown(os.fspath(path)),
        message=f"{reason}; {done} of {total} parts are done",
        remedy="Go on with --resume.",
    )
