"""Solve many arcs: chunks of rows on the threads of this process."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arrays import Array
from wraparc.batch import row
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.batch.result import BatchResult
from wraparc.batch.rows import solve_rows
from wraparc.batch.setting import Setting, named_setting
from wraparc.drive import Lagging
from wraparc.drive.usual_sizes import OF_COLUMNS, OVER_WIDTH, USUAL_SIZES, unusual_rows
from wraparc.errors import InputError, Problem
from wraparc.glossary import GLOSSARY
from wraparc.units import display

Progress = Callable[[int, int], object]

#: rows of a chunk: enough to hide what its calls cost, few enough for threads to share the work
CHUNK = 4096


def solve_batch(
    table: Mapping[str, ArrayLike],
    laggings: Sequence[Lagging] | Lagging,
    *,
    setting: Setting | str = Setting.ENGINEERING,
    capacities: bool = True,
    threads: int | None = None,
    progress: Progress | None = None,
) -> BatchResult:
    """Solve many designs given by column.

    Parameters
    ----------
    table
        Columns by their names in the glossary, one number for all rows or one for each [SI]:
        ``entry_tension``, ``exit_tension``, ``diameter``, ``wrap_angle``, ``belt_width``,
        ``belt_modulus``; if they are not to come from the lagging ``lagging_thickness``,
        ``shear_modulus`` (over the gross area, see `wraparc.drive.Lagging`),
        ``compression_modulus`` (else it follows the thickness, see
        `wraparc.drive.Lagging.with_thickness`), ``wear_coefficient``; and ``overrun`` (nan: by
        formula), ``recovery`` (1 or 0), ``creep_limit``, ``belt_speed``, and of the belt
        ``pitch_offset`` (e), ``cover_compliance`` (h_b/G_b [m/Pa]), ``centrifugal_force``
        (m v^2), each 0 if left out. With more than one lagging also ``lagging``: names, or places
        in `laggings`. A pandas DataFrame will do.
    laggings
        The laggings.
    setting, capacities, threads, progress
        See `solve_arcs`.

    Returns
    -------
    Columns of shape (n,) [SI]. Arcs that break away have a status and no exception.

    Raises
    ------
    InputError
        With every unknown or missing column and, column by column, the values that cannot be.

    Warns
    -----
    UserWarning
        Once a column of sizes that no drive has: a wrap of 180 rad, kN for N.
    """
    arcs = arcs_of_table(table, laggings)
    for message in _implausible(table, arcs.belt_width):
        warnings.warn(message, stacklevel=2)
    return solve_arcs(
        arcs,
        setting=setting,
        capacities=capacities,
        threads=threads,
        progress=progress,
    )


def _implausible(table: Mapping[str, Any], width: Array) -> Iterator[str]:
    """Yield a sentence for every column of sizes that no drive has."""
    narrow, wide = USUAL_SIZES[OF_COLUMNS["belt_width"]]
    width = np.where((width < narrow) | (width > wide), 1.0, width)  # told of itself
    for name in (name for name in OF_COLUMNS if name in table):
        ends = USUAL_SIZES[OF_COLUMNS[name]]
        scale = width if name in OVER_WIDTH else np.ones_like(width)
        values = np.broadcast_to(np.asarray(table[name], dtype=float), width.shape)
        low, high = unusual_rows(values / scale, ends)
        rows = np.flatnonzero(low | high)
        if len(rows):
            first, dimension = rows[0], GLOSSARY[name].dimension
            value = display(float(values[first]), dimension)
            least, most = (display(float(end * scale[first]), dimension) for end in ends)
            count = f"{len(rows)} of {len(width)} rows" if len(width) > 1 else "this row"
            yield f"{name}: {value} in {count}, usual are {least} to {most}. Give it in SI units."


def solve_arcs(
    arcs: Arcs,
    *,
    setting: Setting | str = Setting.ENGINEERING,
    capacities: bool = True,
    parts: int | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> BatchResult:
    """Solve arcs.

    Parameters
    ----------
    arcs
        The arcs, see `wraparc.batch.arcs.arcs_of_table`.
    setting
        How accurately: a `Setting`, or its name, ``"precise"``.
    capacities
        Whether capacities and margins are wanted; without them the columns are nan.
    parts
        What is wanted instead, see `wraparc.batch.row`.
    threads
        Threads to use, by default one a processor. Results do not depend on it: an arc has the same
        numbers to the last bit whatever it is solved with.
    progress
        Called in the calling thread with the arcs done and their number. What it raises ends the
        work and reaches the caller.

    Raises
    ------
    InputError
        If `threads` is less than 1, or there is no such setting.
    """
    setting = named_setting(setting)
    wanted = row.EVERYTHING if capacities else row.TENSIONS
    wanted = wanted if parts is None else parts
    found = np.empty((len(arcs), row.FOUND_NUMBERS))

    def run(which: slice) -> None:
        found[which] = solve_rows(arcs.rows(which), wanted, setting.accuracy)[0]

    share_chunks(run, len(arcs), CHUNK, threads, progress)
    return BatchResult(arcs, found, setting=setting)


def share_chunks(
    run: Callable[[slice], None],
    total: int,
    size: int,
    threads: int | None,
    progress: Progress | None,
) -> None:
    """Run chunks of rows on the threads of this process, see `solve_arcs`.

    Raises
    ------
    InputError
        If `threads` is less than 1.
    """
    workers = os.cpu_count() or 1 if threads is None else threads
    if workers < 1:
        problem = Problem(key="threads", value=str(threads), message="must be at least 1")
        raise InputError(problem)
    starts = range(0, total, size)

    def chunk(start: int) -> int:
        which = slice(start, min(start + size, total))
        run(which)
        return which.stop - which.start

    if workers == 1 or len(starts) < 2:
        done = 0
        for start in starts:
            done += chunk(start)
            _tell(progress, done, total)
    else:
        _share(chunk, starts, workers, progress, total)


def _share(
    run: Callable[[int], int],
    starts: range,
    workers: int,
    progress: Progress | None,
    total: int,
) -> None:
    """Run chunks on threads; whatever goes wrong, chunks not begun are dropped."""
    with ThreadPoolExecutor(workers) as pool:
        waiting: set[Future[int]] = {pool.submit(run, start) for start in starts}
        done = 0
        try:
            while waiting:
                ended, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                done += sum(future.result() for future in ended)
                _tell(progress, done, total)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _tell(progress: Progress | None, done: int, total: int) -> None:
    if progress is not None:
        progress(done, total)
