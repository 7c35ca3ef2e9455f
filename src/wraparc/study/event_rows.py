"""Rows of a study over an event on disk: kept as they come, made one file when all are there."""

from __future__ import annotations

import csv
import hashlib
import io
import json
import math
import os
from collections.abc import Sequence
from dataclasses import asdict, replace
from pathlib import Path

from wraparc.errors import InputError, input_error, shown
from wraparc.motion.file import load_motion
from wraparc.saving import (
    alone,
    interrupted,
    replacing,
    save_file,
    to_disk,
    unwritable,
)
from wraparc.study.event_study import (
    EventRow,
    EventStudy,
    EventTell,
    follow_study,
)
from wraparc.study.parquet import require_pyarrow
from wraparc.version import __version__

#: What a file of rows may end in.
SUFFIXES = (".csv", ".parquet")
#: What a row says of a design: its name in `EventRow`, its head in a file, its SI unit.
_COLUMNS = (
    ("peak_creep", "peak creep", "m"),
    ("peak_tension", "peak tension", "N"),
    ("least_tension", "minimum tension", "N"),
    ("swing", "Te ripple of the last pulley", "-"),
    ("friction_energy", "friction work", "J"),
    ("oscillation_frequency", "oscillates at", "Hz"),
    ("used", "limit used", "-"),
    ("closest", "governing check", ""),
    ("level", "worst check", ""),
    ("label", "verdict", ""),
    ("text", "text", ""),
)
NAMES, _TITLES, UNITS = zip(*_COLUMNS, strict=True)
HEADS = tuple(f"{t} [{u}]" if u else t for t, u in zip(_TITLES, UNITS, strict=True))


def run_event_study(
    study: EventStudy,
    path: str | os.PathLike[str],
    *,
    resume: bool = False,
    progress: EventTell | None = None,
) -> list[EventRow]:
    """Follow every design of a study, into a CSV or Parquet file.

    A row is kept on disk as soon as its design is followed, in a file beside `path` whose name
    ends in ``.part``; it goes when the whole file is there.

    Parameters
    ----------
    study
        What is followed.
    path
        Of the file; what it ends in says which kind.
    resume
        Whether to go on with what an interrupted run has left.
    progress
        Called with the designs done and their number.

    Raises
    ------
    InputError
        If a file cannot be written, or the rows there are not of this study.
    MissingExtraError
        For Parquet without pyarrow.
    """
    if os.fspath(path).lower().endswith(".parquet"):
        require_pyarrow()
    part = Path(os.path.realpath(path) + ".part")
    with alone(path, "--output"):
        rows = _begun(study, part, resume=resume)

        def kept() -> str:
            return f"{len(rows)} of {len(study.designs)} designs are saved in {part}"

        with interrupted(lambda: f"{kept()}: go on with --resume."):
            try:
                _follow(study, part, rows, progress)
                save_rows(study, rows, path)
            except (OSError, InputError) as error:
                told = (
                    error.problems[0] if isinstance(error, InputError) else unwritable(part, error)
                )
                message = f"{told.message}; {kept()}"
                remedy = "Make room and go on with --resume."
                raise InputError(replace(told, message=message, remedy=remedy)) from None
        part.unlink(missing_ok=True)
    return rows


def _follow(
    study: EventStudy, part: Path, rows: list[EventRow], progress: EventTell | None
) -> None:
    """Follow what is left of a study, each row on the disk before the next design is begun."""
    with part.open("a", encoding="utf-8") as file:
        for row in follow_study(study, progress, done=len(rows)):
            file.write(json.dumps(asdict(row)) + "\n")
            file.flush()
            to_disk(file.fileno())
            rows.append(row)


def _begun(study: EventStudy, part: Path, *, resume: bool) -> list[EventRow]:
    """Rows that an interrupted run has left; the file begins anew where there are none."""
    key = _key(study)
    rows: list[EventRow] = []
    if part.exists():
        if not resume:
            message = "an interrupted run has left rows there"
            remedy = "Go on with --resume, or remove them."
            raise input_error(
                key="--output", value=shown(str(part)), message=message, remedy=remedy
            )
        rows = _read(part, key)
    try:
        with replacing(part) as draft:
            lines = [json.dumps({"study": key}), *(json.dumps(asdict(row)) for row in rows)]
            draft.write_text("".join(f"{line}\n" for line in lines), "utf-8")
    except OSError as error:
        raise InputError(unwritable(part, error)) from None
    return rows


def _read(part: Path, key: str) -> list[EventRow]:
    rows: list[EventRow] = []
    try:
        first, *lines = part.read_text("utf-8").splitlines(keepends=True)
        mine = json.loads(first) == {"study": key}
        for line in lines:
            if line.endswith("\n"):  # else it was being written when the run ended
                found = json.loads(line)
                rows.append(EventRow(**{**found, "values": tuple(found["values"])}))
    except (OSError, ValueError, TypeError, KeyError):
        mine = False
    if not mine:
        message = "contains rows of another study"
        remedy = "Remove it, or write another file."
        raise input_error(key="--resume", value=shown(str(part)), message=message, remedy=remedy)
    return rows


def _key(study: EventStudy) -> str:
    """What a study is: the same drive, event, pieces and designs."""
    drive = load_motion(study.drive, overrides=study.settings)
    asked = (study.event, study.points, study.fields, study.values)
    return hashlib.sha256(repr((__version__, drive, asked)).encode()).hexdigest()


def save_rows(study: EventStudy, rows: Sequence[EventRow], path: str | os.PathLike[str]) -> None:
    """Write rows as CSV or, with pyarrow, as Parquet; SI, the units in the heads.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    if os.fspath(path).lower().endswith(".parquet"):
        save_file(path, _parquet(study, rows))
        return
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow([*study.fields, *HEADS])
    for row in rows:
        told = [getattr(row, name) for name in NAMES]
        table.writerow([*row.values, *map(_cell, told)])
    save_file(path, text.getvalue())


def _cell(value: object) -> object:
    if not isinstance(value, float):
        return value
    return "" if math.isnan(value) else value + 0.0  # no -0.0


def _parquet(study: EventStudy, rows: Sequence[EventRow]) -> bytes:
    pa = require_pyarrow()
    columns = {
        field: pa.array([row.values[i] for row in rows], pa.string())
        for i, field in enumerate(study.fields)
    }
    for head, name, unit in zip(HEADS, NAMES, UNITS, strict=True):
        kind = pa.float64() if unit else pa.string()
        columns[head] = pa.array([getattr(row, name) for row in rows], kind)
    about = {"wraparc": __version__, "event": study.event, "title": study.title}
    sink = io.BytesIO()
    pa.parquet.write_table(pa.table(columns).replace_schema_metadata(about), sink)
    return sink.getvalue()
