"""The wrap angle of a pulley from where it and its neighbours stand."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from wraparc.errors import Problem
from wraparc.schema.limits import Limit, limit_problems, raise_all
from wraparc.units import display

#: Ways in which the belt turns about a pulley, seen from the side with x to the right and y up.
TURNS = ("clockwise", "counterclockwise")
_PLACE = Limit("length", least=-1e5, most=1e5)


@dataclass(frozen=True, kw_only=True)
class Point:
    """A pulley or idler that the belt passes.

    Parameters
    ----------
    x, y
        Centre; x to the right, y up [m].
    diameter
        Diameter; 0 for a point that the belt only touches [m].
    turn
        ``clockwise`` or ``counterclockwise``: how it turns with the belt, and so on which side
        the belt passes.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "x": _PLACE,
        "y": _PLACE,
        "diameter": Limit("length", most=1e3),
    }

    x: float
    y: float
    diameter: float = 0.0
    turn: str = "clockwise"

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))

    @property
    def side(self) -> float:
        """Radius, positive where the centre is left of the belt (counterclockwise) [m]."""
        return self.diameter / 2.0 * (1.0 if self.turn == "counterclockwise" else -1.0)


def wrap_angle(before: Point, pulley: Point, after: Point) -> float:
    """Return the angle over which the belt lies on a pulley [rad].

    The belt runs straight along the tangent common to two pulleys, whose direction is

    ``phi = theta - asin((s2 - s1)/d)``,

    theta and d being direction and length of the line between the centres and s the radii,
    positive where the centre is left of the belt. The wrap is the turn between both tangents.

    Parameters
    ----------
    before, pulley, after
        What the belt passes, in its direction of travel.

    Returns
    -------
    float
        From 0 up to 2 pi [rad].

    Raises
    ------
    InputError
        If two of them overlap, so that no straight belt runs between them.
    """
    raise_all(overlaps(before, pulley, after))
    return turned_by(before, pulley, after)


def turned_by(before: Point, pulley: Point, after: Point) -> float:
    """Return the same of pulleys that do not overlap [rad]."""
    incoming, outgoing = _direction(before, pulley), _direction(pulley, after)
    turned = outgoing - incoming if pulley.turn == "counterclockwise" else incoming - outgoing
    turned = turned % math.tau
    # a belt that passes straight on must not round to a whole turn
    return 0.0 if math.tau - turned < 1e-9 else turned


def overlaps(before: Point, pulley: Point, after: Point) -> list[Problem]:
    """Return a problem for each neighbour that overlaps the pulley."""
    problems = []
    for end, key in ((before, "before"), (after, "after")):
        distance = math.hypot(end.x - pulley.x, end.y - pulley.y)
        if distance < (end.diameter + pulley.diameter) / 2.0 or distance == 0.0:
            message = f"overlaps the pulley: their centres are {display(distance, 'length')} apart"
            remedy = "Check the coordinates and the diameters."
            problems.append(Problem(key=key, message=message, remedy=remedy))
    return problems


def _direction(start: Point, end: Point) -> float:
    """Return the direction of the straight belt between two pulleys [rad]."""
    dx, dy = end.x - start.x, end.y - start.y
    offset = end.side - start.side
    return math.atan2(dy, dx) - math.asin(offset / math.hypot(dx, dy))
