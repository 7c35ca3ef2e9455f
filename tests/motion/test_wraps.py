"""Wraps in one table: the linear problem of a step, steps that lay many pieces, several arcs.

Expected: the box equations put down cell by cell and solved densely; the same arcs alone, or in
steps of one piece; polynomials.
"""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray

from motion.alone import alone, roll, settle, wraps_of
from motion.test_arc import steady
from wraparc.files import load_lagging
from wraparc.motion.arc import MovingArc
from wraparc.motion.equations import _missed
from wraparc.motion.held import settle as settled
from wraparc.motion.recorder import _part_over
from wraparc.motion.two_point import PANEL, Cells, changes
from wraparc.motion.wraps import Wraps

Array = NDArray[np.float64]


def random_cells(rng: np.random.Generator, panels: int, stiff: float) -> Cells:
    """Two wraps in units of their own; stiff is b K a of a cell."""
    nodes = panels * PANEL + 1
    cells, ones = (2, nodes - 1), (2, nodes)
    b = rng.uniform(0.5, 1.5, cells)
    return Cells(
        half_width=b,
        half_give_d=rng.uniform(0.5, 1.5, cells),
        half_give_u=rng.uniform(0.5, 1.5, cells),
        stress=rng.normal(size=ones),
        by_creep=stiff * rng.uniform(0.1, 1.0, ones),
        by_tension=1e-2 * rng.normal(size=ones),
        by_m=rng.uniform(0.0, 1.0, ones),
        tension=rng.uniform(1.0, 2.0, ones),
        short=rng.uniform(0.0, 1.0, ones),
    )


def densely(c: Cells, j: int, out: float, f: float) -> Array:
    """The equations of wrap j in T and I of all nodes, one by one; changes of T, then of I."""
    n = c.tension.shape[1]
    matrix, right = np.zeros((2 * n, 2 * n)), np.zeros((2 * n, 3))
    t, i, tau = c.tension[j], c.short[j], c.stress[j]
    k, p, by_m = c.by_creep[j], c.by_tension[j], c.by_m[j]

    def stress(row: int, node: int, weight: float) -> None:
        """Add weight times the change of stress of a node: P dT + K (by_m dm - dI)."""
        matrix[row, node] += weight * p[node]
        matrix[row, n + node] -= weight * k[node]
        right[row, 1] -= weight * k[node] * by_m[node]

    for d in range(n - 1):
        b, u = c.half_width[j, d], d + 1
        matrix[d, d], matrix[d, u] = 1.0, -1.0
        stress(d, d, b)
        stress(d, u, b)
        right[d, 0] = -(t[d] - t[u] + b * (tau[d] + tau[u]))
        row, a_d, a_u = n - 1 + d, c.half_give_d[j, d], c.half_give_u[j, d]
        matrix[row, [n + d, n + u, d, u]] = 1.0, -1.0, -a_d, -a_u
        right[row, 0] = -(i[d] - i[u] - a_d * t[d] - a_u * t[u])
    b = c.half_width[j, 0]
    near, far = 2.0 * b * f * (1.0 - 0.5 * f), b * f * f
    matrix[-2, 1] = 1.0
    stress(2 * n - 2, 1, -near)
    stress(2 * n - 2, 0, -far)
    right[-2, 0] += out - t[1] + near * tau[1] + far * tau[0]
    right[-2, 2] = 1.0
    matrix[-1, 2 * n - 1] = 1.0
    return np.asarray(np.linalg.solve(matrix, right))


@pytest.mark.parametrize("panels", [1, 2, 9])
@pytest.mark.parametrize("stiff", [1e-3, 0.3, 1.0, 50.0])
def test_a_step_solves_the_box_equations(panels: int, stiff: float) -> None:
    """Independent: the same equations assembled densely, for soft and for stiff lagging."""
    rng = np.random.default_rng(panels)
    cells = random_cells(rng, panels, stiff)
    out, inside = rng.uniform(1.0, 2.0, 2), rng.uniform(0.1, 1.0, 2)
    dt, di = changes(cells, out, inside)
    nodes = panels * PANEL + 1
    for j in range(2):
        expected = densely(cells, j, float(out[j]), float(inside[j]))
        scale = np.abs(expected).max(axis=0)
        assert dt[:, j].T / scale == pytest.approx(expected[:nodes] / scale, abs=1e-10)
        assert di[:, j].T / scale == pytest.approx(expected[nodes:] / scale, abs=1e-10)


def put_on(pieces: int) -> MovingArc:
    """A steady arc whose pull is raised by a tenth over half a wrap, in rolls of some pieces."""
    result = steady("tandem-fabric", 0)
    arc = alone(result.arc, 96)
    settle(arc, result.entry_tension, result.exit_tension, 4.0)
    for i in range(48 // pieces):
        more = math.sin(math.pi * min((i + 1) * pieces / 48, 1.0) / 2.0) ** 2
        roll(arc, pieces * arc.spacing, result.entry_tension * (1.0 + 0.1 * more), arc.exit)
    return arc


def test_a_step_of_many_pieces_comes_to_what_single_ones_do() -> None:
    """Other steps of the same march: creep to 2e-4 with twelve steps a half wrap; order 2.5."""
    one, *many = (put_on(pieces) for pieces in (1, 4, 8))
    fine, coarse = (abs(arc.creep()[-1] / one.creep()[-1] - 1.0) for arc in many)
    assert fine < 2e-4
    assert coarse > 5.0 * fine
    works = [abs(arc.work / one.work - 1.0) for arc in many]
    assert works[0] < 1e-3


def test_the_steady_state_knows_nothing_of_steps() -> None:
    """Identity: in the steady state n is linear in travel, so that any pieces between are exact."""
    result = steady("tandem-steel-cord", 1)
    arcs = [alone(result.arc, 50) for _ in range(2)]
    for arc, pieces in zip(arcs, (1, 5), strict=True):
        settle(arc, result.entry_tension, result.exit_tension, 3.0)
        for _ in range(400 // pieces):
            roll(arc, pieces * arc.spacing, result.entry_tension, result.exit_tension)
    assert arcs[1].creep()[-1] == pytest.approx(arcs[0].creep()[-1], rel=1e-9)
    assert arcs[1].felt.slip_speed == pytest.approx(5.0 * arcs[0].felt.slip_speed, rel=5e-3)


def test_arcs_in_one_table_are_the_arcs_alone() -> None:
    """Identity, for arcs of other laggings and lengths, as far as their rolls are solved for."""
    first, second = steady("tandem-fabric", 0), steady("tandem-fabric", 1)
    ceramic = replace(second.arc, law=load_lagging("medium-ceramic").law, wrap_angle=3.0)
    own = [MovingArc(first.arc, 30), MovingArc(ceramic, 30)]
    entries = [first.entry_tension, second.entry_tension]
    exits = [first.exit_tension, second.exit_tension]
    settled(Wraps(own), entries, exits, 1.0)
    for arc, given, entry, exit_ in zip(own, (first.arc, ceramic), entries, exits, strict=True):
        lone = alone(given, 30)
        settle(lone, entry, exit_, 1.0)
        assert arc.creep() == pytest.approx(lone.creep(), abs=1e-10)
        assert arc.work == pytest.approx(lone.work, rel=1e-6)
        assert arc.m == pytest.approx(lone.m, abs=1e-10)


@pytest.mark.parametrize("pieces", [1, 6])
def test_old_and_fresh_contact_meet_where_it_stood(pieces: int) -> None:
    """Identity: two pieces at one place, what they keep apart by the creep of the nip at rest less
    the overrun with which fresh contact begins."""
    result = steady("tandem-fabric", 0)
    arc = alone(result.arc, 40)
    for part in (0.5, 1.0):
        tension = result.exit_tension + part * (result.entry_tension - result.exit_tension)
        roll(arc, 0.0, tension, result.exit_tension)
    jump = arc.creep()[0] - arc.shape.overrun(arc.entry)
    assert jump > 1e-3
    for _ in range(12 // pieces):
        roll(arc, pieces * arc.spacing, result.entry_tension, result.exit_tension)
    there = wraps_of(arc).pieces(arc)
    (i,) = np.flatnonzero(np.diff(there.travel) < 1e-9)
    assert there.travel[i] == pytest.approx(0.0, abs=1e-12)
    assert there.kept[i + 1] - there.kept[i] == pytest.approx(jump, rel=1e-9)


@pytest.mark.parametrize("pieces", [0.0, 0.4, 1.0, 6.0])
def test_a_step_that_is_undone_leaves_nothing(pieces: float) -> None:
    """Identity: the same step after one that was begun, swept and given up."""
    result = steady("tandem-fabric", 0)
    arcs = [alone(result.arc, 40) for _ in range(2)]
    for arc in arcs:
        settle(arc, result.entry_tension, result.exit_tension, 1.0)
    wraps = wraps_of(arcs[1])
    for end in (arcs[1].travel + 9.0 * arcs[1].spacing, arcs[1].travel):
        wraps.begin([end])
        wraps.sweep([end], [arcs[1].m + 1e-3], [0.8 * result.exit_tension])
        wraps.undo()
    for arc in arcs:
        roll(arc, pieces * arc.spacing, 0.9 * result.entry_tension, result.exit_tension)
    assert arcs[1].creep() == pytest.approx(arcs[0].creep(), rel=1e-9)
    assert arcs[1].m == pytest.approx(arcs[0].m, rel=1e-9)


@pytest.mark.parametrize("steps", [(1.0, 1.0, 1.0), (0.3, 0.7, 1.9), (2.0, 0.5, 0.1)])
@pytest.mark.parametrize("power", [0, 1, 2, 3])
def test_a_trapezium_is_mended_for_cubics(steps: tuple[float, float, float], power: int) -> None:
    """Closed form: h/2 (f(0) + f(h)) less int_0^h f, for (t + 1)^power and steps before."""
    h, h_1, h_2 = steps

    def value(t: float) -> float:
        return (t + 1.0) ** power

    points = (h, 0.0, -h_1, -h_1 - h_2)
    rates = [(value(a) - value(b)) / (a - b) for a, b in pairwise(points)]
    expected = 0.5 * h * (value(0.0) + value(h))
    expected -= ((1.0 + h) ** (power + 1) - 1.0) / (power + 1)
    miss, by_end = _missed(h, h_1, h_2, *rates)
    assert miss == pytest.approx(expected, abs=1e-12)
    more, _ = _missed(h, h_1, h_2, rates[0] + 1.0 / h, *rates[1:])  # the value at the end + 1
    assert by_end == pytest.approx(more - miss, rel=1e-12)
    if power < 3:  # with one step before a parabola
        assert _missed(h, h_1, 0.0, *rates)[0] == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(
    ("before", "after", "part"),
    [(0.0, 2.0, 0.5), (2.0, 0.0, 0.5), (1.2, 1.4, 1.0), (0.2, 0.9, 0.0), (0.5, 3.0, 0.8)],
)
def test_time_over_a_limit_is_counted_in_parts_of_a_step(
    before: float, after: float, part: float
) -> None:
    """Closed form: a straight line over a limit of 1."""
    assert _part_over(before, after, 1.0) == pytest.approx(part)
