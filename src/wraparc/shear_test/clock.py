"""Time as a clock writes it: 12:21:58.029, with or without a date."""

import re
from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Array

_CLOCK = re.compile(
    r"(?:\S+[ T])?(\d{1,2}):([0-5]\d)(?::([0-5]\d(?:[.,:]\d{1,9})?))?(?: ?([ap])\.?m\.?)?Z?",
    re.IGNORECASE,
)
_DAY = 86400.0


def clock_seconds(cells: Sequence[str]) -> Array | None:
    """Return seconds since the first of some clock times, over midnight too; None for others.

    Parameters
    ----------
    cells
        As written, of 24 or of 12 hours.
    """
    found = []
    for cell in cells:
        match = _CLOCK.fullmatch(cell.strip().strip('"'))
        if match is None:
            return None
        hours, minutes, seconds, half = match.groups()
        hour = int(hours) % 12 + 12 * (half in {"p", "P"}) if half else int(hours)
        rest = float((seconds or "0").replace(",", ".").replace(":", "."))
        found.append(3600.0 * hour + 60.0 * int(minutes) + rest)
    if not found:
        return None
    times = np.array(found)
    days = np.concatenate([[0.0], np.cumsum(np.diff(times) < -0.5 * _DAY)])
    return np.asarray(times + _DAY * days - times[0])
