"""Faults that the data of a laboratory show: named with their cause, and sound ones not accused.

Laboratories of closed forms (benchmarks/shear_test_faults.py), no code of the package in them.
"""

import re
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import benchmark_module
from wraparc.answer.shear_test_tables import verdict
from wraparc.checks import Level
from wraparc.units import in_units


def bench() -> Any:
    return benchmark_module("shear_test_faults")


NAMED = {
    "one force from a pressure on (soft)": "backing or clamp gives way",
    "one force from a pressure on (sharp)": "backing or clamp gives way",
    "18 % less friction from a pressure on": "friction steps",
    "one pressure damp, 12 % less": "friction steps",
    "repeats apart by 30 % in slip": "slips of repeats are",
    "repeats apart by 25 % in slip, shorter": "slips of repeats are",
    "repeats are copies, scaled": "is made of",
    "repeats are copies, travel scaled": "is made of",
    "repeats are copies, on another grid": "is made of",
    "repeats are copies with some noise": "is made of",
    "repeats are copies that start later": "is made of",
    "a pressure drawn between its neighbours": "is made of",
    "one force stands in all tests": "stand in all forces",
    "one force is missing in all tests": "before the slip starts",
    "the rig rubs with 8 %": "before the slip starts",
    "stick-slip sampled slower than it swings": "faster than they are sampled",
    "curves start like an S": "the force rises within the",
    "a clamp seats itself": "the force rises within the",
    "a slow filter, 0.8 mm": "the force rises within the",
    "lash differs by 2 mm": "lash differs between tests",
    "travel sensor at its end": "travel is constant",
}


@pytest.mark.parametrize("kind", NAMED)
def test_a_fault_that_the_data_show_is_named(kind: str) -> None:
    result = bench().faulty(kind, 3, 250)  # six pressures
    told = verdict(result)
    assert told.level is Level.ATTENTION
    lines = [told.text, *(also.text for also in told.also), *result.misfit]
    assert any(NAMED[kind] in in_units(line) for line in lines)


@pytest.mark.parametrize(
    ("kind", "seed", "named"),
    [
        # two of eight pressures apart, which hid each other
        ("repeats apart by 30 % in slip", 4, "Slips of repeats are 35 % apart"),
        ("18 % more friction from a pressure on", 2, "Friction steps"),
        ("samples scatter by 14 %", 5, "Samples scatter by"),
        # one zero drifts by 15 % of the force, 23 % less friction behind the peak becomes 8
        ("zero drifts by 15 % in one test", 5, "Behind the peak t00 changes by -"),
        # made of two, whose noise hides in that of its measured normal force
        ("a pressure drawn between its neighbours", 13, "T06 is made of t04"),
    ],
)
def test_faults_that_hide_in_the_scatter_they_make(kind: str, seed: int, named: str) -> None:
    told = verdict(bench().faulty(kind, seed, 250))
    lines = [told.text.removeprefix("Fit rejected: ").capitalize(), *(a.text for a in told.also)]
    assert any(in_units(line).startswith(named) for line in lines)


def test_the_cause_comes_before_the_curves_it_bends() -> None:
    """What gives way makes curves whose first readings are near their largest."""
    told = verdict(bench().faulty("one force from a pressure on (soft)", 1, 250))
    assert in_units(told.text).startswith("Fit rejected: one force from ")
    assert any("first reading has" in in_units(also.text) for also in told.also)


@pytest.mark.parametrize(
    ("kind", "seed"), [("samples scatter by 14 %", 1), ("friction at its peak at once", 4)]
)
def test_a_number_that_says_nothing_is_not_shown(kind: str, seed: int) -> None:
    """No slip that no reading shows, and no remainder of curves that leave none."""
    result = bench().faulty(kind, seed, 250)
    told = verdict(result)
    lines = [told.text, *(also.text for also in told.also), *result.misfit]
    for line in map(in_units, lines):
        assert "inf" not in line
        assert " 0.0 %" not in line
        assert not re.search(r"nan|\d{7}", line)
    assert len(in_units(told.text).split()) <= 17  # a number with its unit is one word
    assert told.action is not None
    assert "fit again" not in told.action.text


def test_sound_laboratories_are_not_accused() -> None:
    """Of 10 none, with 400 the bench counts."""
    accused = []
    for seed in range(1, 11):
        result, _ = bench().sound(seed, 250)
        if verdict(result).level is not Level.OK:
            accused.append((seed, in_units(verdict(result).text)))
    assert not accused


def test_lash_counts_in_the_uncertainty_at_small_slips() -> None:
    """Expected: the curve that was drawn, exp(-(x/1.3 mm)^2) short of the law at its start."""
    from wraparc.shear_test.standard_values import STANDARD_SLIPS, law_at_slips

    lab = bench().draw(3, 250)
    truth = []
    for pressure in sorted({test.pressure for test in lab.tests}):
        slip, friction = lab.peaks(pressure)
        x = np.array(STANDARD_SLIPS[:2])
        r = x / slip
        truth.append(friction * r * (1.0 - np.log(r)) * (1.0 - np.exp(-((x / 1.3e-3) ** 2))))
    result = bench().faulty("curves start like an S", 3, 250)
    friction, half = law_at_slips(result.conditions[0])
    held = np.abs(friction[:, :2] - np.array(truth)) < half[:, :2]
    assert held.mean() > 0.9


def test_the_travel_taken_as_lash_is_on_the_first_screen() -> None:
    lab = bench().draw(2, 250)
    bench().record(lab)
    told = verdict(bench().fit(lab))
    low, high = (1e3 * f(t.lash for t in lab.tests) for f in (min, max))
    (line,) = [in_units(also.text) for also in told.also if also.text.startswith("Lash")]
    words = line.removeprefix("Lash taken off: ").split()
    assert words[1::2] == ["to", "mm."]
    assert [float(word) for word in words[::2]] == pytest.approx([low, high], abs=0.04)
