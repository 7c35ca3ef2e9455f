"""The state of a run in a file, so that one that was broken off goes on where it was."""

from __future__ import annotations

import hashlib
import json
import os
import time
import zipfile
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from wraparc.errors import InputError, input_error, shown
from wraparc.motion.march import March
from wraparc.motion.recorder import Recorder, Sink
from wraparc.saving import put_in_place, unwritable
from wraparc.version import __version__

#: Least time between two savings [s].
SELDOM = 2.0
_FORMAT = "wraparc run 1"


@dataclass
class Checkpoint:
    """Where a run is saved, and what is told to whoever writes its rows.

    Attributes
    ----------
    path
        Of the file.
    resumed
        Called once, before the first row, with the rows that were streamed before.
    flush
        Called before the state is saved: rows streamed so far must be safe by then.
    seldom
        Least time between two savings [s].
    """

    path: str | os.PathLike[str]
    resumed: Callable[[int], None] = lambda rows: None
    flush: Callable[[], None] = lambda: None
    seldom: float = SELDOM

    def begin(self, march: March, recorder: Recorder, sink: Sink | None) -> None:
        """Go on from the file if it is there, else begin.

        Raises
        ------
        InputError
            If the file is none of this run.
        """
        self.saved = time.monotonic()
        self.key = _key(march, recorder)
        there = Path(self.path).exists()
        if there:
            self._restore(march, recorder)
        self.resumed(recorder.told)
        recorder.sink = sink
        if not there:
            recorder.stream()

    def due(self, march: March, recorder: Recorder) -> None:
        """Save if it is time."""
        if time.monotonic() - self.saved >= self.seldom:
            self.save(march, recorder)

    def end(self, march: March, recorder: Recorder, *, whole: bool) -> None:
        """Remove the file after a run that came to its end, its rows safe, else save it."""
        if whole:
            self.flush()
            for path in (Path(self.path), self._draft):
                path.unlink(missing_ok=True)
        else:
            self.save(march, recorder)

    def save(self, march: March, recorder: Recorder) -> None:
        """Save the state of a run."""
        self.flush()
        arrays: dict[str, Any] = {
            "rows": np.array(recorder.rows),
            "picture_times": np.array([p[0] for p in recorder.pictures]),
            "creep": np.array([p[1] for p in recorder.pictures]),
            "shear": np.array([p[2] for p in recorder.pictures]),
        }
        numbers: dict[str, Any] = {}
        for name, part in _parts(march, recorder):
            numbers[name] = {}
            for key, value in vars(part).items():
                if isinstance(value, np.ndarray):
                    arrays[f"{name}.{key}"] = value
                elif _is_number(value) or _are_numbers(value):
                    numbers[name][key] = list(value) if not _is_number(value) else value
        about = json.dumps({"format": _FORMAT, "key": self.key, "numbers": numbers})
        try:
            with self._draft.open("wb") as file:
                np.savez(file, about=np.array(about), **arrays)
            put_in_place(self._draft, Path(os.path.realpath(self.path)))
        except OSError as error:
            self._draft.unlink(missing_ok=True)
            kept = "Make room: the same command goes on from the state before."
            remedy = kept if os.path.exists(self.path) else "Choose another place."
            problem = unwritable(self.path, error, remedy, key="--checkpoint")
            raise InputError(problem) from None
        self.saved = time.monotonic()

    @property
    def _draft(self) -> Path:
        """Always the same: what a run leaves that dies while it saves is written over."""
        target = Path(os.path.realpath(self.path))
        return target.with_name(f".{target.name}.tmp")

    def _restore(self, march: March, recorder: Recorder) -> None:
        try:
            with np.load(self.path, allow_pickle=False) as file:
                arrays = {key: file[key] for key in file.files}
            about = json.loads(str(arrays["about"]))
            fits = (about["format"], about["key"]) == (_FORMAT, self.key)
        except (OSError, ValueError, KeyError, TypeError, EOFError, zipfile.BadZipFile):
            raise self._problem("is no saved state of a run", "Name another file.") from None
        if not fits:
            message = "is the state of another run"
            raise self._problem(message, "Remove it, or name another file.")
        for name, part in _parts(march, recorder):
            for key, value in about["numbers"][name].items():
                kind = type(getattr(part, key, value))
                setattr(part, key, kind(value) if kind in (tuple, deque) else value)
            for key, value in vars(part).items():
                if isinstance(value, np.ndarray):
                    setattr(part, key, arrays[f"{name}.{key}"])
        recorder.rows = arrays["rows"].tolist()
        pictures = zip(arrays["picture_times"], arrays["creep"], arrays["shear"], strict=True)
        recorder.pictures = [(float(t), list(creep), list(shear)) for t, creep, shear in pictures]

    def _problem(self, message: str, remedy: str) -> InputError:
        return input_error(
            key="--checkpoint", value=shown(os.fspath(self.path)), message=message, remedy=remedy
        )


def _parts(march: March, recorder: Recorder) -> Iterator[tuple[str, Any]]:
    """Everything that changes on the march, by name."""
    yield "march", march
    yield "wraps", march.wraps
    yield "recorder", recorder
    for i, d in enumerate(march.drums):
        yield f"drum{i}", d
        yield f"arc{i}", d.arc
        yield f"turning{i}", d.turning
        if d.trimming is not None:
            yield f"trimming{i}", d.trimming


def _is_number(value: object) -> bool:
    return isinstance(value, bool | int | float)


def _are_numbers(value: Any) -> bool:
    return type(value) in (list, tuple, deque) and all(map(_is_number, value))


def _key(march: March, recorder: Recorder) -> str:
    """What a run is: the same program, station, event, step, pieces and rows."""
    points = [d.arc.points for d in march.drums]
    parts = (__version__, march.station, march.event, march.h, points, recorder.every)
    return hashlib.sha256(repr(parts).encode()).hexdigest()
