"""Curves of few points: clicked off a figure, or thinned by a machine.

Expected: the closed form mu = M r (1 - ln r) that made them, and the count of what is accused.
"""

from typing import Any

import numpy as np
import pytest

from shear_test.virtual import as_record, benchmark_module, single
from wraparc.answer.shear_test_tables import verdict
from wraparc.checks import Level
from wraparc.shear_test import Sample, VirtualRig, reduce_record, run_virtual_test
from wraparc.shear_test.digitised import read_points
from wraparc.shear_test.misfit import judged_fit


def bench() -> Any:
    return benchmark_module("shear_test_faults")


def test_sound_figures_are_taken_and_their_intervals_hold() -> None:
    """Of 24 figures of 10 to 45 points one may be refused; 23 of 40 were."""
    found = [bench().figure(seed) for seed in range(1, 25)]
    assert sum(verdict(result).level is not Level.OK for result, _ in found) <= 1
    held = np.concatenate([own for _, own in found])
    assert 0.92 <= held.mean() <= 0.995


@pytest.mark.parametrize("points", [12, 20, 25, 40, 80])
def test_a_thinned_record_rubs_nowhere(points: int) -> None:
    """A record of so few readings has one before the slip starts, or none."""
    rig = VirtualRig(law=single(0.9, 7e-3), points=points, lash=0.4e-3, noise=0.008)
    for seed in range(6):
        curve = reduce_record(as_record(run_virtual_test(rig, 60e3, seed)), Sample(area=0.04))
        judged = judged_fit(curve, 3e-3)
        assert not judged.misfit
        assert judged.fit.parameters.peak_friction == pytest.approx(0.9, rel=0.03)


def test_a_step_of_friction_is_a_jump_however_many_points_it_has() -> None:
    for points in (12, 40, 250):
        record = as_record(
            run_virtual_test(VirtualRig(law=single(0.9, 7e-3), points=points), 1e5, 1)
        )
        noise = np.random.default_rng(points).normal(0.0, 30.0, points)
        record.force[:] = np.where(record.travel > 1e-3, 6000.0, 0.0) + noise
        judged = judged_fit(reduce_record(record, Sample(area=0.04)), 3e-3)
        assert "jump" in {sentence.about for sentence in judged.misfit}


def test_names_of_curves_in_a_long_table_are_read() -> None:
    """The quick way of long tables keeps numbers only: such a curve was called nan."""
    rows = [f"{p} kPa,{0.1 * k + 0.1:.2f},{0.01 * k:.3f}" for p in (50, 200) for k in range(120)]
    curves = read_points("\n".join(["curve,x,y", *rows, ""]).encode(), "x")
    assert [(curve.name, len(curve.x)) for curve in curves] == [("50 kPa", 120), ("200 kPa", 120)]
