"""What a drive is held against, and whether it passes: each limit with its margin and a word."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from wraparc.arc import ArcResult, ClassicalDrive, DriveResult, classical_drives
from wraparc.drive import Drive
from wraparc.present.arc_tables import belongs
from wraparc.present.sheet import NONE, Level, Row, Table, quantity
from wraparc.units import Dimension, System

#: Largest miss of the energy balance that a solution is trusted with [-].
BALANCE = 1e-5
_SAME = 1e-9


class Outcome(StrEnum):
    """How a check ends; told by the word and by the sign, never by colour alone."""

    PASS = "PASS"  # noqa: S105 - a word of the report
    FAIL = "FAIL"
    NOT_KNOWN = "NOT KNOWN"


@dataclass(frozen=True)
class Check:
    """One limit and what was found.

    Attributes
    ----------
    title
        What is held against its limit.
    outcome
        How it ends.
    where
        Pulley and load case with the least margin, or why it is not known.
    found, limit
        Values [SI]; nan where there are none.
    dimension
        What they measure.
    at_most
        Whether the limit is an upper one.
    """

    title: str
    outcome: Outcome
    where: str = ""
    found: float = math.nan
    limit: float = math.nan
    dimension: Dimension = "number"
    at_most: bool = True

    @property
    def margin(self) -> float:
        """How far from the limit, over the limit: positive on the safe side [-]."""
        if math.isnan(self.found) or math.isnan(self.limit) or self.limit == 0.0:
            return math.nan
        return (1.0 if self.at_most else -1.0) * (1.0 - self.found / self.limit)

    @property
    def sign(self) -> str:
        """``+`` passed, ``-`` failed, ``?`` not known."""
        return {Outcome.PASS: "+", Outcome.FAIL: "−"}.get(self.outcome, "?")


def checks(result: DriveResult) -> tuple[Check, ...]:
    """Return every check of a solved drive, each for the arc that comes off worst.

    The load carried, creep, slack side, tested range of the lagging, rating and least pulley of
    the belt, customary design values, and the energy balance of the solution.
    """
    return tuple(_checks(result))


def _checks(result: DriveResult) -> Iterator[Check]:
    arcs = result.arcs
    solved = [arc for arc in arcs if arc.status.solved]
    yield _carried(arcs)
    yield _creep(arcs, solved)
    yield _slack(arcs)
    yield from _tested(arcs, solved)
    yield _rating(result.drive, arcs)
    yield from _diameters(result.drive)
    yield from _design_values(result)
    balanced = [arc for arc in solved if not math.isnan(arc.energy.identity_error)]
    if balanced:
        error = _worst(balanced, lambda arc: -abs(arc.energy.identity_error))
        miss = abs(error.energy.identity_error)
        yield _compared("Energy balance of the solution", error, miss, BALANCE)


def _worst(arcs: Iterable[ArcResult], margin: Callable[[ArcResult], float]) -> ArcResult:
    return min(arcs, key=margin)


def _compared(
    title: str,
    arc: ArcResult,
    found: float,
    limit: float,
    dimension: Dimension = "number",
    *,
    at_most: bool = True,
) -> Check:
    over = found - limit if at_most else limit - found
    outcome = Outcome.PASS if over <= _SAME * abs(limit) else Outcome.FAIL
    return Check(title, outcome, belongs(arc), found, limit, dimension, at_most)


def _carried(arcs: Sequence[ArcResult]) -> Check:
    failed = [arc for arc in arcs if not arc.status.solved]
    title = "Friction carries the load"
    if not failed:
        count = len(arcs)
        where = f"on all {count} arcs" if count > 1 else belongs(arcs[0])
        return Check(title, Outcome.PASS, where)
    return Check(title, Outcome.FAIL, "; ".join(belongs(arc) for arc in failed))


def _creep(arcs: Sequence[ArcResult], solved: Sequence[ArcResult]) -> Check:
    title = "Creep at exit"
    for arc in arcs:
        if not arc.status.solved:
            limit = arc.arc.creep_limit
            where = f"breaks away: {belongs(arc)}"
            return Check(title, Outcome.FAIL, where, math.nan, limit, "length")
    worst = _worst(solved, lambda r: -abs(r.exit_creep) / r.arc.creep_limit)
    return _compared(title, worst, abs(worst.exit_creep), worst.arc.creep_limit, "length")


def _slack(arcs: Sequence[ArcResult]) -> Check:
    title = "Slack-side tension for the creep limit"
    pulled = [arc for arc in arcs if arc.arc.effective_tension]
    if not pulled:
        return Check(title, Outcome.PASS, "no pull to carry")
    if all(math.isnan(arc.capacities.gross_slip_capacity) for arc in pulled):
        return Check(title, Outcome.NOT_KNOWN, "the method finds no capacities")

    def share(arc: ArcResult) -> float:
        least = arc.capacities.least_exit_tension
        return -math.inf if math.isnan(least) else _slack_tension(arc) / least

    worst = _worst(pulled, share)
    least, given = worst.capacities.least_exit_tension, _slack_tension(worst)
    if math.isnan(least):
        where = f"none keeps to it within the tested pressures: {belongs(worst)}"
        return Check(title, Outcome.FAIL, where, given, math.nan, "force", at_most=False)
    return _compared(title, worst, given, least, "force", at_most=False)


def _slack_tension(arc: ArcResult) -> float:
    return min(arc.arc.entry_tension, arc.arc.exit_tension)


def _tested(arcs: Sequence[ArcResult], solved: Sequence[ArcResult]) -> Iterator[Check]:
    known = [arc for arc in solved if arc.arc.law.tested is not None]
    if not known:
        why = "the law has no tested range" if solved else "breaks away"
        yield Check("Wrap pressure and slip in the tested range", Outcome.NOT_KNOWN, why)
        return

    def pressures(arc: ArcResult) -> tuple[float, float, float, float]:
        tested, p = arc.arc.law.tested, arc.profile.wrap_pressure
        assert tested is not None  # noqa: S101 - chosen so above
        return float(p.max()), tested.pressure_max, float(p.min()), tested.pressure_min

    high = _worst(known, lambda arc: -pressures(arc)[0] / pressures(arc)[1])
    yield _compared("Largest wrap pressure, tested", high, *pressures(high)[:2], "pressure")
    low = _worst(known, lambda arc: pressures(arc)[2] / pressures(arc)[3])
    title = "Least wrap pressure, tested"
    yield _compared(title, low, *pressures(low)[2:], "pressure", at_most=False)

    def slips(arc: ArcResult) -> tuple[float, float]:
        tested = arc.arc.law.tested
        assert tested is not None  # noqa: S101 - chosen so above
        return float(np.abs(arc.profile.slip).max()), tested.slip_max

    far = _worst(known, lambda arc: -slips(arc)[0] / slips(arc)[1])
    yield _compared("Largest slip, tested", far, *slips(far), "length")


def _rating(drive: Drive, arcs: Sequence[ArcResult]) -> Check:
    title, rating = "Belt tension, rated", drive.belt.rating
    if rating is None:
        return Check(title, Outcome.NOT_KNOWN, "the belt's rating is not given")

    def highest(arc: ArcResult) -> float:
        return max(arc.arc.entry_tension, arc.arc.exit_tension)

    worst = _worst(arcs, lambda arc: -highest(arc))
    return _compared(title, worst, highest(worst), rating * drive.belt.width, "force")


def _diameters(drive: Drive) -> Iterator[Check]:
    least = drive.belt.least_pulley_diameter
    if least is None:
        return
    small = min(drive.pulleys, key=lambda pulley: pulley.diameter)
    outcome = Outcome.PASS if small.diameter >= least * (1.0 - _SAME) else Outcome.FAIL
    title = "Pulley diameter, least for the belt"
    where = f"pulley {small.name}"
    yield Check(title, outcome, where, small.diameter, least, "length", at_most=False)


def _design_values(result: DriveResult) -> Iterator[Check]:
    """Hold the slack side against what CEMA and DIN 22101 ask for."""
    for standard in ("CEMA", "DIN 22101"):
        pairs = [
            (arc, drive)
            for arc in result
            if arc.arc.effective_tension and (drive := _design(result, arc, standard)) is not None
        ]
        if not pairs:
            continue
        arc, drive = min(pairs, key=lambda pair: _slack_tension(pair[0]) / _asked(pair[1]))
        design = drive.design
        surface = ", ".join(p for p in (design.surface, design.condition) if p)
        title = f"Slack side by {standard}, friction {design.friction[0]:.2f} ({surface})"
        yield _compared(title, arc, _slack_tension(arc), _asked(drive), "force", at_most=False)


def _design(result: DriveResult, arc: ArcResult, standard: str) -> ClassicalDrive | None:
    lagging = result.drive.pulley(arc.arc.pulley).lagging
    for drive in classical_drives(arc.arc, lagging):
        design = drive.design
        if design.standard == standard and design.condition in ("", lagging.condition):
            return drive
    return None


def _asked(drive: ClassicalDrive) -> float:
    return drive.safe_slack_tension


def check_table(found: Sequence[Check], system: System) -> Table:
    """Return checks as a table: limit, found, margin, answer, where."""
    rows = []
    for check in found:
        bound = "at most" if check.at_most else "at least"
        limit = quantity(check.limit, check.dimension, system)
        values = (
            limit if limit == NONE else f"{bound} {limit}",
            quantity(check.found, check.dimension, system),
            margin_text(check.margin),
            f"{check.sign} {check.outcome}",
        )
        level = {Outcome.PASS: Level.GOOD, Outcome.FAIL: Level.BAD}.get(check.outcome)
        rows.append(Row(check.title, values, note=check.where, level=level))
    note = (
        "Margin: how far the value is from its limit, over the limit; positive on the safe side. "
        "Each check is shown where it comes off worst. A belt is rated for running; its maker says "
        "what is allowed while starting."
    )
    return Table("", tuple(rows), ("limit", "found", "margin", "answer"), note)


def margin_text(margin: float) -> str:
    """Return a margin as percent with its sign."""
    if math.isnan(margin):
        return NONE
    if 0.9995 <= margin < 1.0:
        return "> +99.9 %"
    if abs(margin) < _SAME:
        return "0 %"
    return f"{100.0 * margin:+.3g} %".replace("-", "−")
