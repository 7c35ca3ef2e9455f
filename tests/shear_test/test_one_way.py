"""Steps of friction over pressure, told from laws that bend: numbers drawn here, no rig."""

from typing import Any

import numpy as np
import pytest

from wraparc.shear_test.one_way import nonnegative, step_over_pressure

PRESSURES = np.array([35e3, 60e3, 90e3, 140e3, 200e3, 290e3, 420e3, 650e3])

# ln mu over p of laggings: a power, contact that saturates, a constant part, and friction in two
# straight pieces over p that meet at 172 kPa (the catalogue's odd rubber).
COURSES = {
    "power": lambda p: -0.25 * np.log(p / 1e5),
    "saturates": lambda p: -0.5 * np.log1p(p / 2e5),
    "constant part": lambda p: np.log(0.4 + 0.5 * (p / 1e5) ** -0.7),
    "two pieces": lambda p: np.log(np.interp(p, [34e3, 172e3, 690e3], [1.3, 0.86, 0.385])),
}


def told(ln_friction: Any, seed: int, at: Any = slice(None), scatter: float = 0.02) -> Any:
    """What is told of two samples a pressure, whose scatter is drawn towards 3 % as of 4 more."""
    own = ln_friction[at, None] + scatter * np.random.default_rng(seed).normal(
        size=(len(PRESSURES[at]), 2)
    )
    freedom = len(own) + 3
    within = float(own.var(axis=1, ddof=1).sum() + 4.0 * 0.03**2) / (len(own) + 4)
    return step_over_pressure(
        PRESSURES[at], own.mean(axis=1), np.full(len(own), within / 2.0), freedom
    )


@pytest.mark.parametrize("course", COURSES)
def test_a_law_that_bends_is_no_step(course: str) -> None:
    accused = [seed for seed in range(60) if told(COURSES[course](PRESSURES), seed)]
    assert len(accused) <= 1


@pytest.mark.parametrize(("factor", "dent"), [(0.82, False), (1.18, False), (0.88, True)])
def test_a_step_is_named_with_its_place_and_size(factor: float, dent: bool) -> None:
    place = np.arange(8) == 4 if dent else np.arange(8) >= 4
    ln_friction = COURSES["power"](PRESSURES) + np.log(factor) * place
    found = [told(ln_friction, seed) for seed in range(20)]
    assert sum(f is not None for f in found) >= 18
    named = [f for f in found if f is not None]
    assert sum((f.pressure, f.is_dent) == (4, dent) for f in named) >= 0.8 * len(named)
    assert np.median([f.size for f in named]) == pytest.approx(np.log(factor), abs=0.04)


def test_of_three_pressures_every_step_is_a_bend() -> None:
    """Proof: 0.82 of the friction from 140 kPa on is that of a law in two pieces of ln p."""
    at = np.array([0, 3, 7])
    ln_friction = COURSES["power"](PRESSURES) + np.log(0.82) * (np.arange(8) >= 3)
    assert told(ln_friction, 1, at) is None
    sound = np.interp(np.log(PRESSURES), np.log(PRESSURES[at]), ln_friction[at])
    assert np.all(np.diff(sound) < 0.0)  # falls everywhere, and bends one way
    assert sound[at] == pytest.approx(ln_friction[at])


def test_least_squares_without_negative_unknowns() -> None:
    """Against all sets of unknowns, tried one by one."""
    rng = np.random.default_rng(3)
    for _ in range(20):
        matrix, target = rng.normal(size=(7, 4)), rng.normal(size=7)
        best = np.inf
        for chosen in range(16):
            used = np.array([bool(chosen >> k & 1) for k in range(4)])
            part = np.linalg.lstsq(matrix[:, used], target, rcond=None)[0]
            if np.all(part >= 0.0):
                best = min(best, float(((target - matrix[:, used] @ part) ** 2).sum()))
        found = nonnegative(matrix, target)
        assert np.all(found >= 0.0)
        assert float(((target - matrix @ found) ** 2).sum()) == pytest.approx(best, rel=1e-9)
