"""Rows of ``wraparc run`` as they come: into FILE.part, which takes FILE's place at the end."""

from __future__ import annotations

import csv
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

from wraparc.cli.output import STANDARD_OUTPUT
from wraparc.cli.pipe import has_left
from wraparc.errors import InputError, MissingExtraError, Problem, input_error
from wraparc.motion.recorder import row_names
from wraparc.motion.station import Station
from wraparc.saving import alone, is_device, put_in_place, to_disk, unwritable

#: Rows that are written at once.
_BLOCK = 1000


@contextmanager
def streamed(
    station: Station, csv_file: str | None, parquet_file: str | None, state_file: str | None
) -> Iterator[Rows]:
    """Give what takes rows; their files are there when all went well, and whole.

    What was written so far stays in FILE.part where the run was cancelled, or where `state_file`
    holds what it goes on from.

    Raises
    ------
    InputError
        If a file cannot be written, or another run writes it.
    """
    with ExitStack() as locks:
        rows = Rows(station, csv_file, parquet_file, state_file)
        for path in (*rows.drafts, *([state_file] if state_file else [])):
            locks.enter_context(alone(path))
        try:
            with ExitStack() as files:
                rows.open(files)
                yield rows
                rows.flush()
            if not rows.cancelled:
                rows.in_place()
        except OSError as error:
            if has_left(error) or not rows.wanted:
                raise
            raise InputError(rows.unwritable(error)) from None
        finally:
            rows.clear_away()


class Rows:
    """Rows of a run on their way to files; see `streamed`.

    Attributes
    ----------
    cancelled
        Whether the run was ended before its end: its files are not put in place.
    drafts
        By the path of a file as it was given, where it is written.
    """

    def __init__(
        self,
        station: Station,
        csv_file: str | None,
        parquet_file: str | None,
        state_file: str | None,
    ) -> None:
        self.names, self.csv_file, self.parquet_file = row_names(station), csv_file, parquet_file
        self.state_file, self.cancelled, self.count = state_file, False, 0
        given = [path for path in (csv_file, parquet_file) if path and path != STANDARD_OUTPUT]
        self.drafts = {path: _draft(path) for path in given}
        self._block: list[Sequence[float]] = []
        self._sinks: list[Callable[[list[Sequence[float]]], object]] = []
        self._part: Any = None

    @property
    def wanted(self) -> bool:
        """Whether there is any file of rows."""
        return bool(self.csv_file or self.parquet_file)

    @property
    def _goes_on(self) -> bool:
        """Whether the same command goes on from a saved state."""
        return bool(self.state_file) and os.path.exists(self.state_file or "")

    def open(self, files: ExitStack) -> None:
        """Begin the files; that of a run that may go on waits for `resumed`."""
        self._files = files
        if self.csv_file == STANDARD_OUTPUT:
            self._to_csv(sys.stdout)
        elif self.csv_file and not self.state_file:
            self._to_csv(self._opened("w"))
        if self.parquet_file:
            self._to_parquet(self.drafts[self.parquet_file])

    def _opened(self, mode: str) -> Any:
        draft = self.drafts[self.csv_file or ""]
        return self._files.enter_context(draft.open(mode, encoding="utf-8", newline=""))

    def resumed(self, rows: int) -> None:
        """Go on behind the rows that were streamed before."""
        if not self.csv_file:
            return
        draft = self.drafts[self.csv_file]
        self._part = part = self._opened("r+" if draft.exists() else "w+")
        kept = 0
        while kept < (rows + 1 if rows else 0) and part.readline():
            kept += 1
        if rows and kept < rows + 1:
            message = f"has {max(kept - 1, 0)} rows, and the saved state {rows}"
            remedy = "Remove the saved state."
            raise input_error(key="--csv", value=part.name, message=message, remedy=remedy)
        part.seek(part.tell())
        part.truncate()
        self.count = rows
        self._to_csv(part, head=not rows)

    def take(self, row: Sequence[float]) -> None:
        """Take a row."""
        self._block.append(row)
        if len(self._block) >= _BLOCK:
            self.flush()

    def flush(self) -> None:
        """Write what has come so far; of a run that may go on, to the disk."""
        for sink in self._sinks if self._block else ():
            sink(self._block)
        self.count += len(self._block)
        self._block = []
        if self._part is not None:
            self._part.flush()
            to_disk(self._part.fileno())

    def in_place(self) -> None:
        """Let whole drafts take the places of the files."""
        for path, draft in self.drafts.items():
            if draft != Path(os.path.realpath(path)):
                put_in_place(draft, Path(os.path.realpath(path)))

    def clear_away(self) -> None:
        """Remove drafts that nobody goes on with."""
        for path, draft in self.drafts.items():
            if not (self.cancelled or self._goes_on or draft == Path(os.path.realpath(path))):
                with suppress(OSError):
                    draft.unlink(missing_ok=True)

    def kept(self, others: Sequence[str]) -> str:
        """Say what there is of a run that was cancelled, and which files there are not."""
        parts = " and ".join(str(draft) for draft in self.drafts.values())
        said = [f"{self.count} rows are saved in {parts}."] if parts else []
        said += [f"{path} was not written." for path in (*self.drafts, *others)]
        if self.state_file:
            said += [f"The same command goes on from {self.state_file}."]
        return " ".join(said)

    def unwritable(self, error: OSError) -> Problem:
        """Return the problem of rows that cannot be written."""
        place = next(iter(self.drafts.values()), None)
        if self._goes_on:
            remedy = f"Make room: the same command goes on from {self.state_file}."
            return unwritable(place or "", error, remedy)
        return unwritable(place or "standard output", error)

    def _to_csv(self, stream: Any, *, head: bool = True) -> None:
        writer = csv.writer(stream, lineterminator="\n")
        if head:
            writer.writerow(self.names)
        self._sinks.append(
            lambda rows: writer.writerows([f"{v + 0.0:.10g}" for v in r] for r in rows)
        )

    def _to_parquet(self, draft: Path) -> None:
        try:
            import pyarrow as pa
            import pyarrow.parquet as pq
        except ImportError:
            raise MissingExtraError("pyarrow", "study") from None
        schema = pa.schema([(name, pa.float64()) for name in self.names])
        writer = self._files.enter_context(pq.ParquetWriter(draft, schema))

        def sink(rows: list[Sequence[float]]) -> None:
            columns = [pa.array([float(v) for v in c]) for c in zip(*rows, strict=True)]
            writer.write_table(pa.table(columns, schema=schema))

        self._sinks.append(sink)


def _draft(path: str) -> Path:
    target = Path(os.path.realpath(path))
    return target if is_device(target) else target.with_name(f"{target.name}.part")
