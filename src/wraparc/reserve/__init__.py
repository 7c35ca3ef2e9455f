"""How sure a verdict is: the smallest change of each input that changes its level.

``find_reserve(result)`` is the reserve of a solved drive or train. Changes are judged as rows
(`levels.py`), between two of which the nearest is sought (`brackets.py`, `divide.py`); those that
are stated are confirmed (`confirm.py`). `inputs.py` says what is changed, and how, `uncertainty.py`
how far inputs are off, as stated or usually. ``find_reserves(table, laggings, like)``
is that of designs by column (`of_table.py`). ``find_probability(result)`` draws all inputs at once
(`probability.py`, `draws.py`); `predict.py` leaves out of the solving what is far from limits.
"""

from wraparc.reserve.find import Flip, Reserve, find_reserve, nearest_flips, stated_count
from wraparc.reserve.inputs import Input, change_drive
from wraparc.reserve.of_table import find_reserves
from wraparc.reserve.probability import Probability, find_probability
from wraparc.reserve.uncertainty import COUNTED, STATED, Uncertainty, uncertainty_of

__all__ = [
    "COUNTED",
    "STATED",
    "Flip",
    "Input",
    "Probability",
    "Reserve",
    "Uncertainty",
    "change_drive",
    "find_probability",
    "find_reserve",
    "find_reserves",
    "nearest_flips",
    "stated_count",
    "uncertainty_of",
]
