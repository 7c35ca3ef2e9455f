"""Changes that are stated, confirmed from both sides by the solver of one arc."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from wraparc.arc import Distributed
from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Integers
from wraparc.batch import Setting
from wraparc.checks.of_arc import GROSS_SLIP, grip
from wraparc.checks.rule import Rule
from wraparc.checks.rules import spot_of
from wraparc.errors import InputError
from wraparc.reserve.brackets import OF_CHANGE, WIDTH, Brackets
from wraparc.reserve.inputs import Input, change_drive
from wraparc.reserve.levels import ANEW, FACTORS, IMPOSSIBLE, JUDGED, LevelRows

#: Margin up to which a check of rows is made of one arc: a hundred times what rows may be off [-].
_NEAR = 100.0 * Setting.PRECISE.accuracy


def confirm(levels: LevelRows, brackets: Brackets, which: Integers, now: int) -> Brackets:
    """Return brackets, some of them solved by the solver of one arc at both ends.

    The check that changes there is made of its arc, if in rows it is so near to its limit that an
    arc might be found on the other side. Where it is, the change is found anew by that solver.
    """
    near, far = brackets.near.copy(), brackets.far.copy()
    rank = brackets.at_far.rank.copy()
    for i in which.tolist():
        step = brackets.rows(np.array([i]))
        if not _agrees(levels, step, now):
            near[i], far[i], rank[i] = _bisect(levels, step, now)
    at_far = brackets.at_far._replace(rank=rank)
    return brackets._replace(near=near, far=far, at_far=at_far)


def _agrees(levels: LevelRows, step: Brackets, now: int) -> bool:
    """Return whether the checks that change the level have the same ranks by one arc."""
    changed = levels.inputs[int(step.which[0])]
    for check, place in _decisive(step, now):
        for factor, found in ((step.near, step.at_near), (step.far, step.at_far)):
            rule, margin = JUDGED[check], found.margins[check, place, 0]
            if _NEAR < abs(margin) < np.inf:
                continue
            rank = _rank_of(levels, changed, float(factor[0]), rule, place)
            if rank != found.ranks[check, place, 0]:
                return False
    return True


def _decisive(step: Brackets, now: int) -> Iterator[tuple[int, int]]:
    """Yield places of the checks by which the level changes, and of the arcs."""
    near, far = step.at_near.ranks[..., 0], step.at_far.ranks[..., 0]
    rank = int(step.at_far.rank[0])
    changes = (far == rank) & (near < rank) if rank > now else (near > rank) & (far <= rank)
    for check, place in zip(*np.nonzero(changes), strict=True):
        rule = JUDGED[int(check)]
        if rule.result or rule in ANEW:
            yield int(check), int(place)


def _rank_of(levels: LevelRows, changed: Input, factor: float, rule: Rule, place: int) -> int:
    """Return the rank of a check of one arc, with one input changed."""
    pulley, name = levels.places[place]
    try:
        drive = change_drive(levels.drive, changed, factor)
        case = drive.load_case(name)
        there = drive.in_case(case)
        arc = WrapArc.of(there, there.pulley(pulley), case)
        solved = Distributed(capacities=False).solve(arc)
    except InputError:
        return IMPOSSIBLE
    if rule is GROSS_SLIP:
        return grip(there, case, [solved], 0).level.rank
    checks = rule.checks(spot_of(there, case, there.pulley(pulley), solved))
    return max((check.level.rank for check in checks), default=0)


def _bisect(levels: LevelRows, step: Brackets, now: int) -> tuple[float, float, int]:
    """Return a bracket by the solver of one arc: from one that is wide enough to have the change.

    The bracket of rows stays where there is none.
    """
    changed = levels.inputs[int(step.which[0])]
    near, far, width = float(step.near[0]), float(step.far[0]), float(step.width[0])
    way, end = (1.0, FACTORS[1]) if far > near else (-1.0, FACTORS[0])

    def rank_at(factor: float) -> int:
        return levels.level_of(changed, factor)

    while way * (near - 1.0) > 0.0 and rank_at(near) != now:
        near, width = way * max(way * (near - way * width), way), 2.0 * width
    while way * (end - far) > 0.0 and rank_at(far) == now:
        far, width = way * min(way * (far + way * width), way * end), 2.0 * width
    rank = rank_at(far)
    if rank in (now, IMPOSSIBLE):
        return float(step.near[0]), float(step.far[0]), int(step.at_far.rank[0])
    while abs(far - near) > min(WIDTH, OF_CHANGE * abs(far - 1.0)):
        middle = 0.5 * (near + far)
        found = rank_at(middle)
        near, far, rank = (middle, far, rank) if found == now else (near, middle, found)
    return near, far, rank
