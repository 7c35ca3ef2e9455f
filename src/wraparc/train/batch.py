"""Solve many trains: chunks of rows on the threads of this process."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arc import Distributed
from wraparc.arrays import Array, Codes, Flags
from wraparc.batch import BatchResult, Setting, row
from wraparc.batch.arcs import Arcs
from wraparc.batch.scaled import solve_scaled
from wraparc.batch.solve import share_chunks
from wraparc.drive.pitch import centrifugal_of, strain_ratio
from wraparc.drive.pull import given_up, rises_of
from wraparc.errors import InputError
from wraparc.train.balance import Balanced, Equations, balance
from wraparc.train.batch_result import (
    BEYOND_MOTOR,
    BREAKAWAY,
    REFUSED,
    SOLVED,
    UNSOLVED,
    DrumColumns,
    TrainBatchResult,
    drum_columns,
)
from wraparc.train.motor_rows import MotorRows
from wraparc.train.read_columns import read_rows
from wraparc.train.result import TrainStatus
from wraparc.train.rows import TrainRows
from wraparc.train.solve import solve_case
from wraparc.train.train import Train

Progress = Callable[[int, int], object]

#: Trains of a chunk.
CHUNK = {Setting.ENGINEERING: 4096, Setting.PRECISE: 256}
_CODES = {
    TrainStatus.SOLVED: SOLVED,
    TrainStatus.BREAKAWAY: BREAKAWAY,
    TrainStatus.BEYOND_MOTOR: BEYOND_MOTOR,
    TrainStatus.UNSOLVED: UNSOLVED,
}
_ROUNDING = 1e-9  # of a load at the end of a motor's curve
_WRONG = 1e-5  # a miss of the speeds that is no solution, whatever was found


def solve_train_batch(
    train: Train,
    columns: Mapping[str, ArrayLike],
    case: str = "",
    *,
    setting: Setting = Setting.ENGINEERING,
    capacities: bool = True,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TrainBatchResult:
    """Solve many trains that differ in some numbers.

    Parameters
    ----------
    train
        The train that they all come from.
    columns
        What differs, one number for all rows or one for each [SI]. Of the train
        ``entry_tension``, ``exit_tension``, ``effective_tension`` (then the entry tension follows,
        or the exit tension where the entry tension is given), ``belt_width``, ``belt_modulus``,
        ``belt_speed``. Of each drum, after the name of its pulley and a dot: ``diameter`` (as it is
        now), ``nominal_diameter``, ``wrap_angle``, ``overrun``, ``creep_limit``,
        ``lagging_thickness``, ``shear_modulus``, ``compression_modulus``, ``wear_coefficient``,
        ``friction_factor``, ``slip_factor``, ``wear`` (depth off the lagging: diameter and
        thickness follow), ``run`` (rise of tension before it), ``share``, ``speed_trim``, and the
        numbers of its motor (``setting``, ``droop``, ``rated_speed`` ..., ``ratio`` of a
        follower). A pandas or Polars frame will do.
    case
        Load case, the first one without a name.
    setting, capacities, threads, progress
        As for `wraparc.batch.solve_arcs`; progress is told in trains.

    Returns
    -------
    Columns of shape (n,) for every drum [SI]; a train without a solution has a status and a reason,
    and no exception.

    Raises
    ------
    InputError
        With every unknown column, and column by column the rows that cannot be.

    Notes
    -----
    With a column ``share`` the load divides as given, the other drums taking the rest in the
    proportion they had, and speeds follow. Otherwise the load of a train with given shares goes on
    dividing so, unless a drum is trimmed or wears (``speed_trim``, ``wear``): then all drums keep
    the speeds that the shares of `train` ask for, and the shares follow, as in `what_if`.
    """
    read = read_rows(train, columns, case)
    if read.problems:
        raise InputError(read.problems)
    return solve_rows(
        read.rows,
        read.start,
        setting=setting,
        capacities=capacities,
        threads=threads,
        progress=progress,
    )


def solve_rows(
    rows: TrainRows,
    start: tuple[float, ...],
    *,
    setting: Setting = Setting.ENGINEERING,
    capacities: bool = True,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TrainBatchResult:
    """Solve trains by row, see `solve_train_batch`."""
    n, count = len(rows), len(rows.names)
    located = _Located.of(n, count)
    found = np.full((n * count, row.FOUND_NUMBERS), np.nan)

    def run(which: slice) -> None:
        part = rows.rows(which)
        equations = Equations(part, setting)
        here = _located(part, balance(equations, start))
        located.put(which, here)
        some = slice(which.start * count, which.stop * count)
        found[some] = _arcs(equations, here, capacities)

    share_chunks(run, n, CHUNK[setting], threads, progress)
    return _result(rows, located, found, setting)


@dataclass(frozen=True, eq=False)
class _Located:
    """Tensions of trains, and what came of looking for them."""

    between: Array
    status: Codes
    fallen: Flags
    reasons: dict[int, str]

    @classmethod
    def of(cls, n: int, count: int) -> _Located:
        status, fallen = np.zeros(n, dtype=np.int8), np.zeros((n, count), dtype=bool)
        return cls(np.empty((n, count - 1)), status, fallen, {})

    def put(self, which: slice, part: _Located) -> None:
        """Take the results of some rows."""
        self.between[which], self.status[which] = part.between, part.status
        self.fallen[which] = part.fallen
        self.reasons.update({which.start + i: reason for i, reason in part.reasons.items()})


def _located(rows: TrainRows, balanced: Balanced) -> _Located:
    """Return the tensions, those of unsure rows by the solver of one train."""
    found = _Located.of(len(rows), len(rows.names))
    found.between[:], found.fallen[:] = balanced.between, balanced.fallen
    found.status[~balanced.found] = BREAKAWAY
    for i in np.flatnonzero(balanced.unsure).tolist():
        train = rows.row(i)
        try:
            solved = solve_case(train, train.cases[0], Distributed(capacities=False, points=20))
        except InputError as error:
            found.status[i], found.reasons[i] = REFUSED, str(error)
            continue
        found.status[i] = _CODES[solved.status]
        found.reasons[i] = solved.reason or solved.status.value
        lift = centrifugal_of(train.belt)
        found.between[i] = [m.arc.exit_tension - lift for m in solved.members[:-1]]
    return found


def _arcs(equations: Equations, located: _Located, capacities: bool) -> Array:
    """Rows of the kernel's numbers for all arcs of trains with a balance, nan for the others."""
    rows, count = equations.rows, equations.count
    arcs = _tensioned(equations, located.between, _rough_speeds(equations, located.between))
    found = np.full((len(arcs), row.FOUND_NUMBERS), np.nan)
    found[:, row.OUTCOME] = np.repeat(np.minimum(located.status, REFUSED), count)
    known = np.isin(located.status, (SOLVED, BEYOND_MOTOR))
    which = np.flatnonzero(np.repeat(known, count))
    factors = (rows.drums[k].ravel()[which] for k in ("friction_factor", "slip_factor"))
    solved = solve_scaled(
        arcs.rows(which), *factors, setting=equations.setting, capacities=capacities
    )
    found[which] = solved.found
    return found


def _rough_speeds(equations: Equations, between: Array) -> Array:
    """Belt speeds but for creep, shape (n,): enough to tell slips beyond the tested speed."""
    rows, which = equations.rows, np.arange(len(equations.rows))
    if not (rows.absolute or rows.motors):
        return rows.whole["belt_speed"]
    torques = equations.torques(which, *equations.tensions(which, between))
    first = equations.turned[0]
    speeds = equations.drum_speeds(which, torques)[:, first]
    return np.asarray(speeds * equations.radius[:, first])


def _tensioned(equations: Equations, between: Array, belt_speed: Array) -> Arcs:
    """Return the arcs of all drums at their tensions; belt speeds at the first entry nip."""
    rows = equations.rows
    entries, exits = equations.tensions(np.arange(len(rows)), between)
    strain = strain_ratio(entries, entries[:, :1], rows.light_stiffness[:, None])
    speeds = belt_speed[:, None] * strain
    return replace(
        equations.arcs,
        entry_tension=entries.ravel(),
        exit_tension=exits.ravel(),
        belt_speed=speeds.ravel(),
    )


def _result(rows: TrainRows, located: _Located, found: Array, setting: Setting) -> TrainBatchResult:
    count, everywhere = len(rows.names), np.arange(len(rows))
    equations = Equations(rows, setting)
    entries, exits = equations.tensions(everywhere, located.between)
    outcomes = found[:, row.OUTCOME].reshape(-1, count)
    balanced = located.status == SOLVED
    fallen = np.where(balanced[:, None], outcomes == BREAKAWAY, located.fallen)
    status = np.where(balanced, outcomes.max(axis=1), located.status).astype(np.int8)
    ratios = found[:, row.CREEP_RATIO].reshape(-1, count)
    speed, error = rows.whole["belt_speed"], np.zeros(len(rows))
    if (rows.pulls is None and count > 1) or rows.absolute or rows.motors:
        levels = equations.asked(everywhere, entries, exits, ratios[:, equations.turned])
        misses = np.abs(levels - levels[:, :1]).max(axis=1)
        torques = np.abs(equations.unfollowed(everywhere, entries, exits)).max(axis=1, initial=0.0)
        error = np.maximum(misses, torques)
        status[(status == SOLVED) & ~(error <= _WRONG)] = UNSOLVED
        if rows.absolute or rows.motors:
            speed = np.exp(-levels[:, 0]) * (1.0 + entries[:, 0] / rows.light_stiffness)
    arcs = _tensioned(equations, located.between, speed)
    lift = np.repeat(rows.lift, count)
    arcs = replace(
        arcs,
        entry_tension=arcs.entry_tension + lift,
        exit_tension=arcs.exit_tension + lift,
        centrifugal_force=lift,
    )
    pulls = np.where(balanced[:, None], entries - exits, np.nan).T
    lost = given_up(pulls, rows.names, rows.train.criteria.take_up)
    drums = []
    for i in range(count):
        own = {key: rows.drums[key][:, i] for key in ("friction_factor", "slip_factor")}
        tight, slack = rises_of(pulls, i, lost)
        drum = BatchResult(arcs.rows(slice(i, None, count)), found[i::count], setting, **own)
        drums.append(drum.growing(tight, slack))
    columns = drum_columns(rows, drums, speed, balanced)
    for i, motor in enumerate(rows.motors):
        if isinstance(motor, MotorRows):
            low, high = motor.limits
            load = columns[i]["motor_load"]
            beyond = (load < low - _ROUNDING) | (load > high + _ROUNDING)
            status[(status == SOLVED) & beyond] = BEYOND_MOTOR
    return TrainBatchResult(
        rows=rows,
        status=status,
        drums={
            name: DrumColumns(drum, own)
            for name, drum, own in zip(rows.names, drums, columns, strict=True)
        },
        belt_speed=speed,
        speed_error=error,
        fallen=fallen,
        reasons=located.reasons,
    )
