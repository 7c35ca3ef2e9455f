"""Drives as they are solved for every answer: what was solved last is not solved again.

Answer, action and reserve of a drive are three questions about one result, and what a user goes
back to has been solved before.
"""

import pickle
from collections import OrderedDict
from dataclasses import replace
from threading import Lock

from wraparc.arc import Distributed, DriveResult, PaperMarch, solve
from wraparc.drive import Drive
from wraparc.train import Train, solve_train
from wraparc.train.whole import Whole, by_pulley
from wraparc.web.answers.documents import asked_for, case_only, read
from wraparc.web.answers.shown import Data

#: Drives whose results are kept in a process; one of three load cases takes some 300 kB.
_MOST_KEPT = 8
_kept: OrderedDict[bytes, Whole] = OrderedDict()
_lock = Lock()


def solved_whole(document: Data, load_case: str | None, points: int) -> Whole:
    """Return a drive or train solved in all its load cases, or in one of them."""
    thing = read(document)
    if isinstance(thing, Train):
        return _once(case_only(thing, load_case), None)
    if load_case is not None:
        thing = replace(thing, load_cases=(asked_for(thing, None, load_case)[1],))
    return _once(thing, Distributed(points=points))


def solved_by_paper(drive: Drive) -> DriveResult:
    """Return a drive solved by the integration of the paper."""
    return by_pulley(_once(drive, PaperMarch()))


def _once(thing: Drive | Train, method: Distributed | PaperMarch | None) -> Whole:
    # all that is stated, texts too, which no comparison of drives has
    key = pickle.dumps((thing, method))
    with _lock:
        if key in _kept:
            _kept.move_to_end(key)
            return _kept[key]
    found: Whole
    if isinstance(thing, Train):
        found = solve_train(thing, raise_on_failure=False)
    else:
        found = solve(thing, method=method, raise_on_failure=False)
    with _lock:
        _kept[key] = found
        while len(_kept) > _MOST_KEPT:
            _kept.popitem(last=False)
    return found
