"""The belt across its width in the rows of a study: results, and what they do to the verdict."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from wraparc.across import AcrossResult, AcrossSolver, wide_arc
from wraparc.across.result import UNEVEN
from wraparc.arrays import Array, Codes, Integers
from wraparc.batch.arcs import Arcs
from wraparc.checks import Level, of_across
from wraparc.checks.of_rows import NAMES
from wraparc.drive import Drive, LoadCase, Pulley, Tensions
from wraparc.drive.belt_mass import in_width

#: Results across the width that a study can keep; not a number where the pulley is even.
ACROSS_OUTPUTS = (*UNEVEN, "levelling_depth")


def solve_rows(
    drives: Sequence[Drive],
    which: Integers,
    arcs: Arcs,
    friction: Array,
    slip: Array,
    where: tuple[str, str],
    judged: tuple[Codes, Codes, Array],
) -> dict[str, Array]:
    """Solve the rows whose pulley is uneven, and judge them by the checks across the width.

    Parameters
    ----------
    drives, which
        The drives, and that of each row, whose arc may say otherwise.
    arcs
        The arcs, one a row.
    friction, slip
        Factors on the friction and the slips of their laws, shape (n,) [-].
    where
        Names of the pulley and the load case.
    judged
        Verdicts, what governs, both by their codes, and its margin; those of uneven rows become
        those of a check across the width where that is worse.

    Returns
    -------
    dict
        The results by name, nan where a pulley is even or its belt is not carried, shape (n,).
    """
    found = {name: np.full(len(which), np.nan) for name in ACROSS_OUTPUTS}
    uneven = np.array([d.pulley(where[0]).across is not None for d in drives])
    if not uneven.any():
        return found
    columns = arcs.columns()
    for k in np.flatnonzero(uneven[which]).tolist():
        drive = drives[which[k]]
        row = {name: float(values[k]) for name, values in columns.items()}
        own, pulley, case = _row(drive, where, row, float(friction[k]), float(slip[k]))
        result = AcrossSolver().solve(wide_arc(own, pulley, case))
        _judge(own, case, result, judged, k)
        if result.status.solved:
            for name in ACROSS_OUTPUTS:
                found[name][k] = _number(result, name)
    return found


def _number(result: AcrossResult, name: str) -> float:
    """A result as one number; of the levelling depths that of the first mode."""
    return float(np.ravel(getattr(result, name))[0])


def _row(
    drive: Drive, where: tuple[str, str], row: dict[str, float], friction: float, slip: float
) -> tuple[Drive, Pulley, LoadCase]:
    """Return a drive with the numbers of a row in place of its own."""
    pulley, case = drive.pulley(where[0]), drive.load_case(where[1])
    lagging = pulley.lagging_in(case.condition)
    lagging = replace(
        lagging.with_thickness(row["lagging_thickness"]),
        law=lagging.law.scaled(friction, slip),
        shear_modulus=row["shear_modulus"],
        compression_modulus=row["compression_modulus"],
    )
    own = replace(
        pulley, lagging=lagging, conditions=(), diameter=row["diameter"],
        wrap_angle=row["wrap_angle"], creep_limit=row["creep_limit"],
        overrun=None if np.isnan(row["overrun"]) else row["overrun"],
    )  # fmt: skip
    belt = replace(in_width(drive.belt, row["belt_width"]), modulus=row["belt_modulus"])
    tensions = Tensions(entry=row["entry_tension"], exit=row["exit_tension"])
    load = replace(case, condition="", tensions={own.name: tensions})
    return replace(drive, belt=belt, pulleys=(own,), load_cases=(load,)), own, load


def _judge(
    drive: Drive, case: LoadCase, result: AcrossResult, judged: tuple[Codes, Codes, Array], k: int
) -> None:
    """Let the worst check across the width govern a row where it is worse than the others."""
    levels, governing, least = judged
    for check in of_across.across(drive, case, result):
        rank = check.level.rank
        if check.level is Level.NOT_CHECKED:
            continue
        if rank > levels[k] or (rank == levels[k] and check.margin < least[k]):
            levels[k], governing[k], least[k] = rank, NAMES.index(check.name), check.margin
