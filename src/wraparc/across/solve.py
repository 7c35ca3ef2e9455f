"""Solve the pulleys of a drive that are uneven across their width."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache

from wraparc.across.build import wide_arc
from wraparc.across.result import AcrossResult, AcrossStatus
from wraparc.across.solver import AcrossSolver
from wraparc.arc import DriveResult, WrapArc
from wraparc.drive import Across, Drive, LoadCase, Pulley
from wraparc.drive.compression import Block
from wraparc.errors import BreakawayError, ConvergenceError, SlackBeltError
from wraparc.units import in_units, quantity


def solve_across(
    drive: Drive,
    pulley: str | None = None,
    load_case: str | None = None,
    *,
    strips: int | None = None,
    solver: AcrossSolver | None = None,
    raise_on_failure: bool = True,
) -> AcrossResult:
    """Solve one pulley across the width of its belt.

    Parameters
    ----------
    drive
        The drive, see `wraparc.load_drive`.
    pulley, load_case
        Names; the first pulley that says what is uneven (else the first), and the running load
        case of the largest pull.
    strips
        Strips across the belt, or None for those of the pulley.
    solver
        `AcrossSolver()` unless given.
    raise_on_failure
        Raise if a strip goes slack or the pulley cannot carry its load; otherwise the result says
        so.

    Returns
    -------
    AcrossResult
        Fields over arc and width, profiles, scalars.

    Raises
    ------
    InputError
        If there is no such pulley or load case, or the lagging is worn through.
    SlackBeltError
        If a strip goes slack, saying which and by how much; nothing is clipped.
    BreakawayError
        If the pulley cannot carry its load.
    ConvergenceError
        If the solver did not reach its accuracy.
    """
    chosen = drive.pulley(pulley) if pulley is not None else uneven_pulleys(drive)[0]
    wide = wide_arc(drive, chosen, drive.load_case(load_case), strips=strips)
    result = (solver or AcrossSolver()).solve(wide)
    if raise_on_failure and not result.status.solved:
        where = f"pulley {wide.arc.pulley}, load case {wide.arc.load_case}"
        raise _failure(f"{where}: {result.status}", result)
    return result


@dataclass(frozen=True)
class _Task:
    """One uneven pulley in one load case, known by what its answer depends on."""

    arc: WrapArc
    across: Across
    carcass: str
    block: Block | None
    stiffness: float | None
    drive: Drive = field(compare=False)
    pulley: Pulley = field(compare=False)
    case: LoadCase = field(compare=False)


@lru_cache(maxsize=64)
def _solved(task: _Task) -> AcrossResult:
    return AcrossSolver().solve(wide_arc(task.drive, task.pulley, task.case))


def across_of(result: DriveResult) -> tuple[AcrossResult, ...]:
    """Return every pulley of a solved drive that says what is uneven, in every load case.

    Failures are results too. What was solved lately is not solved again.
    """
    drive, belt = result.drive, result.drive.belt
    return tuple(
        _solved(
            _Task(
                WrapArc.of(drive, pulley, case),
                pulley.across,
                belt.kind,
                pulley.lagging_in(case.condition).block,
                belt.in_plane_shear_stiffness,
                drive,
                pulley,
                case,
            )
        )
        for case in drive.load_cases
        for pulley in drive.pulleys
        if pulley.across is not None
    )


def uneven_pulleys(drive: Drive) -> tuple[Pulley, ...]:
    """Return the pulleys that say what is uneven across their width; all if none does."""
    return tuple(p for p in drive.pulleys if p.across is not None) or drive.pulleys


def slack_words(result: AcrossResult) -> str:
    """Say which strip goes slack and by how much; empty if none does."""
    slack = result.slack
    if slack is None:
        return ""
    place = quantity(slack.position, "length")
    lacking = quantity(-slack.tension, "force_per_width")
    text = f"The strip at {place} from the middle of the belt goes slack: it lacks {lacking}"
    if slack.share < 1.0:
        return f"{text}, and is slack from {100.0 * slack.share:.0f} % of the input unevenness on."
    return f"{text}."


def _failure(sentence: str, result: AcrossResult) -> Exception:
    if result.status is AcrossStatus.SLACK:
        return SlackBeltError(in_units(f"{sentence} {slack_words(result)}"), result)
    if result.status is AcrossStatus.BREAKAWAY:
        return BreakawayError(sentence, result)
    return ConvergenceError(sentence)
