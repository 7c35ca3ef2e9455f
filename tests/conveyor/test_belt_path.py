"""Wrap angles by plane geometry."""

import math
from dataclasses import replace

import pytest

from wraparc import InputError
from wraparc.conveyor import Point, wrap_angle

HEAD = Point(x=0.0, y=0.0, diameter=1.0)


def test_an_equal_pulley_leaves_half_a_turn() -> None:
    tail = Point(x=-20.0, y=-3.0, diameter=1.0)
    assert wrap_angle(tail, HEAD, tail) == pytest.approx(math.pi, rel=1e-12)


@pytest.mark.parametrize("turn", ["clockwise", "counterclockwise"])
@pytest.mark.parametrize("diameter", [0.4, 1.0, 1.6])
def test_two_unequal_pulleys_of_an_open_belt(turn: str, diameter: float) -> None:
    """pi + 2 asin((R - r)/d), the open belt of every textbook; the turn does not matter."""
    tail = Point(x=-5.0, y=0.0, diameter=diameter, turn=turn)
    expected = math.pi + 2.0 * math.asin((1.0 - diameter) / 2.0 / 5.0)
    assert wrap_angle(tail, replace(HEAD, turn=turn), tail) == pytest.approx(expected, rel=1e-12)


def test_a_crossed_belt_wraps_more() -> None:
    """pi + 2 asin((R + r)/d)."""
    tail = Point(x=-5.0, y=0.0, diameter=0.6, turn="counterclockwise")
    expected = math.pi + 2.0 * math.asin(0.8 / 5.0)
    assert wrap_angle(tail, HEAD, tail) == pytest.approx(expected, rel=1e-12)


def test_a_snub_pulley_adds_its_angle() -> None:
    """The belt comes level on top; between head and snub it crosses over, so that it leaves at
    the direction of the centres and asin((R + r)/d) more."""
    idler = Point(x=-10.0, y=0.5)
    snub = Point(x=-1.2, y=-0.6, diameter=0.5, turn="counterclockwise")
    distance = math.hypot(1.2, 0.6)
    expected = math.pi + math.asin((0.5 + 0.25) / distance) - math.atan2(0.6, 1.2)
    assert wrap_angle(idler, HEAD, snub) == pytest.approx(expected, rel=1e-12)
    assert expected > math.pi


def test_the_mirror_image_wraps_alike() -> None:
    idler = Point(x=-10.0, y=0.5)
    snub = Point(x=-1.2, y=-0.6, diameter=0.5, turn="counterclockwise")
    flipped = [
        replace(p, x=-p.x, turn="clockwise" if p.turn == "counterclockwise" else "counterclockwise")
        for p in (idler, HEAD, snub)
    ]
    assert wrap_angle(*flipped) == pytest.approx(wrap_angle(idler, HEAD, snub), rel=1e-12)


def test_a_belt_that_touches_does_not_wrap() -> None:
    straight = Point(x=-10.0, y=0.5), Point(x=10.0, y=0.5)
    assert wrap_angle(straight[0], HEAD, straight[1]) == pytest.approx(0.0, abs=1e-12)


def test_pulleys_that_overlap_are_refused() -> None:
    with pytest.raises(InputError, match=r"overlaps the pulley: their centres are 600 mm apart"):
        wrap_angle(Point(x=-0.6, y=0.0, diameter=0.5), HEAD, Point(x=-9.0, y=-0.5))
