"""The check of stated uncertainties: whether one of them reaches another level of the verdict."""

from __future__ import annotations

from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from wraparc.checks import Check, Level, Verdict, judge
from wraparc.checks.check import escaped
from wraparc.train.whole import Whole, by_pulley

if TYPE_CHECKING:
    from wraparc.drive import Drive
    from wraparc.reserve import Flip

_NAME, _TITLE = "reserve", "Reserve"
_verdicts: WeakKeyDictionary[Whole, Verdict] = WeakKeyDictionary()


def judge_uncertain(result: Whole) -> Verdict:
    """Return the verdict of `judge` with the check of its reserve, where uncertainties are stated.

    The reserve is that of the verdict without this check.
    """
    if not by_pulley(result).drive.states_uncertainty:
        return judge(result)
    if result not in _verdicts:
        others = (check for check in judge(result).checks if check.name != _NAME)
        _verdicts[result] = Verdict((*others, _check_reserve(result)))
    return _verdicts[result]


def _check_reserve(result: Whole) -> Check:
    """Return whether a change within a stated uncertainty changes the level of the verdict."""
    from wraparc.reserve import COUNTED, find_reserve  # solves rows

    reserve, drive = find_reserve(result), by_pulley(result).drive
    if reserve.reason:
        return Check(name=_NAME, title=_TITLE, level=Level.NOT_CHECKED, why=reserve.reason)
    flips = [flip for flip in reserve.flips if flip.uncertainty.kind in COUNTED]
    if not flips:
        return Check(name=_NAME, title=_TITLE, level=Level.OK)
    worse = [f for f in flips if f.is_within and f.level.rank > reserve.level.rank]
    return _check_of((worse or flips)[0], drive)


def _check_of(flip: Flip, drive: Drive) -> Check:
    from wraparc.answer.reserve_words import change_text, input_name  # solves rows
    from wraparc.reserve import STATED

    name, change = input_name(flip.input, drive), change_text(flip, drive)
    change = f"{change[:1].upper()}{change[1:]}"
    stated = flip.uncertainty.kind == STATED
    headline = f"{change} changes the verdict, within its uncertainty" if flip.is_within else ""
    return Check(
        name=_NAME,
        title=_TITLE,
        level=Level.ATTENTION if flip.is_within else Level.OK,
        is_placed=False,
        quantity=flip.input.name,
        noun=f"reserve of {name}",
        value=abs(flip.change),
        limit=flip.uncertainty.value,
        is_percent=True,
        at_most=False,
        headline=escaped(headline),
        action=escaped(f"Measure {name}.") if flip.is_within else "",
        label="reserve",
        source="stated uncertainty" if stated else flip.uncertainty.source,
    )
