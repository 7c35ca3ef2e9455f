"""The rubber between steel cords against a solution of Laplace's equation.

Displacement along the belt is constant on the cover's surface and 0 on each cord of an endless
row; no stress leaves the far side. Here the field is a sum of line sources inside the cords with
their images in the surface (method of fundamental solutions, periodic Green function), fitted to
the surface of a cord: it meets that to 1e-12, and 200 sources agree with 60 to eight digits.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from wraparc.drive.belt import SIDES, Belt
from wraparc.drive.pitch import cover_compliance, pitch_offset, sheared_thickness
from wraparc.errors import InputError


def solved(cover: float, diameter: float, pitch: float, points: int = 120) -> float:
    """Thickness of flat rubber whose shear is that of the rubber below cords."""
    radius, wave = diameter / 2.0, 2.0 * math.pi / pitch
    height = cover + radius

    def ring(at: float, count: int) -> tuple[np.ndarray, np.ndarray]:
        angle = (np.arange(count) + 0.5) / count * math.pi
        return at * np.sin(angle), height - at * np.cos(angle)

    def source(dx: np.ndarray, dy: np.ndarray) -> np.ndarray:
        return -np.log(2.0 * (np.cosh(wave * dy) - np.cos(wave * dx))) / (4.0 * math.pi)

    (x, y), (xs, ys) = ring(radius, points), ring(0.7 * radius, points // 2)
    matrix = sum(
        source(x[:, None] - sign * xs, y[:, None] - ys)
        - source(x[:, None] - sign * xs, y[:, None] + ys)
        for sign in (1.0, -1.0)
    )
    strengths, *_ = np.linalg.lstsq(matrix / 2.0, np.ones(points), rcond=1e-13)
    assert np.abs(matrix @ strengths / 2.0 - 1.0).max() < 1e-6
    return float(pitch / strengths.sum())


@pytest.mark.parametrize(
    ("cover", "diameter", "pitch", "lies_between"),
    # two other solutions, by finite differences and by conformal mapping
    [(5, 5.2, 12, (6.2, 6.3)), (6, 11, 17, (7.3, 7.4)), (4, 3.6, 12, (5.5, 5.6))],
)
def test_solution_lies_where_two_others_do(
    cover: float, diameter: float, pitch: float, lies_between: tuple[float, float]
) -> None:
    found = solved(cover, diameter, pitch)
    assert found == pytest.approx(solved(cover, diameter, pitch, 200), rel=1e-8)
    assert lies_between[0] < found < lies_between[1]


def test_thin_cords_have_the_resistance_of_wires_over_a_plate() -> None:
    # grid of wires over a plate (Maxwell): h = H - p/(2 pi) ln(2 sinh(pi d/2p)...) for d << p
    cover, diameter, pitch = 30.0, 0.2, 10.0
    height = cover + diameter / 2.0
    wires = height + pitch / (2.0 * math.pi) * math.log(pitch / (math.pi * diameter))
    assert solved(cover, diameter, pitch) == pytest.approx(wires, rel=1e-4)
    assert sheared_thickness(cover, diameter, pitch) == pytest.approx(wires, rel=3e-3)


def test_formula_is_that_of_the_solution() -> None:
    worst = 0.0
    for share in (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9):
        for cover in (0.1, 0.2, 0.4, 0.7, 1.0, 2.0):
            exact = solved(cover, share, 1.0, 200)
            worst = max(worst, abs(sheared_thickness(cover, share, 1.0) / exact - 1.0))
    assert worst < 0.003


def belt(**change: float | None) -> Belt:
    flat = Belt(name="ST1250", width=1.2, modulus=72e6, speed=5.0, pulley_cover=5e-3)
    return replace(flat, carry_cover=8e-3, cover_shear_modulus=1e6, **change)  # type: ignore[arg-type]


def test_rubber_between_cords_adds_to_either_cover() -> None:
    flat, cords = belt(carcass=5.2e-3), belt(cord_diameter=5.2e-3, cord_pitch=12e-3)
    for side, cover in zip(SIDES, (5.0, 8.0), strict=True):
        added = 1e6 * (cover_compliance(cords, side) - cover_compliance(flat, side))
        assert added == pytest.approx(1e-3 * (solved(cover, 5.2, 12.0) - cover), abs=6e-5)
        assert pitch_offset(cords, side) == pitch_offset(flat, side)


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({"cord_diameter": 5e-3, "carcass": 6e-3}, "must equal the carcass 6 mm, got 5 mm"),
        ({"cord_pitch": 12e-3}, "cord_pitch: needs cord_diameter"),
        (
            {"cord_diameter": 12e-3, "cord_pitch": 12e-3},
            "must be more than the cord diameter 12 mm, got 12 mm",
        ),
        ({"cord_diameter": 5e-3, "thickness": 17e-3}, "carcass = 18 mm, got 17 mm"),
    ],
)
def test_cords_that_contradict_are_refused(change: dict[str, float], problem: str) -> None:
    with pytest.raises(InputError, match=problem):
        belt(**change)
