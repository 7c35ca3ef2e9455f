"""What to do about a verdict: changes of the drive, each solved and judged before it is told.

``find_action(result)`` is the action for a solved drive or train, None where every check passes.
The search (`search.py`) is a pure function over a judgement of variants: by rows for a drive of one
even pulley (`rows.py`), one by one for all others (`single.py`), and what is told is confirmed by
the solver and the judge of every door. `document.py` knows by which keys of the drive file a change
is made.
"""

from wraparc.actions.document import settings_of
from wraparc.actions.find import find_action

__all__ = ["find_action", "settings_of"]
