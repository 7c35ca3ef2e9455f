"""Every way that is offered on random drives is followed: it does what it says, to its end.

Expected: what the action says, by solver and judge. 300 of them: `benchmarks/advice.py`.
"""

import pytest

from actions.draws import failing
from actions.follow import follow, solved_document
from wraparc.actions import find_action

DRAWN = 16


@pytest.mark.parametrize("number", range(DRAWN))
def test_every_way_that_is_offered_holds(number: int) -> None:
    document = [*failing(DRAWN)][number]
    told = follow(document)
    assert told.wrong == []
    assert told.end
    action = find_action(solved_document(document))
    assert action is None or len(action.text.split()) <= 20  # a number with its unit is one
