"""Where the arc is stepped: graded to the entry nip, cut where errors grow, nodes at kinks.

Friction that sticks and then slides, or is given by a table, bends where one piece of the law hands
over to the next. A step of high order across such a kink loses its order; every strip has kinks of
its own, which move with the unknowns. So the mesh gets a node at each, found on the solution that
is at hand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from wraparc.across.interface import branch_of
from wraparc.across.stresses import stresses
from wraparc.across.wide_arc import Array, WideArc
from wraparc.arc import ArcResult
from wraparc.arc.kernel.step import MESH_POWER
from wraparc.friction.compact import LIMIT, TABLE

#: logarithm of the growth of errors over one piece of the arc; decides speed and safety only
GROWTH = 6.0
#: largest growth over one mesh step: beyond it the method of order 6 is no longer accurate
STEP_GROWTH = 1.0
MOST_STEPS = 400
#: share of a step: a kink nearer to a node than this needs no node of its own
_NEAR = 1e-3
#: halvings of a step to find a kink in it
_HALVINGS = 24


@dataclass(frozen=True)
class Mesh:
    """Where the arc is stepped and cut.

    Attributes
    ----------
    nodes
        Places s, from 0 to L [m].
    cuts
        Numbers of the nodes where a piece begins, the first 0, and the last node.
    """

    nodes: Array
    cuts: tuple[int, ...]

    def with_nodes(self, places: Array) -> Mesh:
        """Return the mesh with nodes at further places too, the cuts where they were."""
        kept, last = [], -1.0
        step = np.diff(self.nodes)
        for s in np.sort(places).tolist():
            i = min(int(np.searchsorted(self.nodes, s, side="right")) - 1, len(step) - 1)
            near = _NEAR * float(step[i])
            if min(s - max(last, float(self.nodes[i])), float(self.nodes[i + 1]) - s) > near:
                kept.append(s)
                last = s
        nodes = np.sort(np.concatenate([self.nodes, kept]))
        cuts = np.searchsorted(nodes, self.nodes[list(self.cuts)])
        return Mesh(nodes, tuple(int(c) for c in cuts))


def mesh_of(wide: WideArc, even: ArcResult, steps: int) -> Mesh:
    """Mesh graded to the entry nip, cut where errors would have grown too far."""
    numbers = wide.numbers
    stiffness = float(np.min(wide.compliance))
    shortest = wide.shear_stiffness * float(wide.wave_numbers[-1]) ** 2
    onset = wide.arc.law.compact().onset_compliance
    lag = float(np.max(numbers.shear)) + onset
    s = even.profile.position * wide.arc.radius
    creep = np.maximum(np.abs(even.profile.creep), 1e-12)
    held = np.abs(even.profile.shear_stress) / creep
    if lag > 0.0:
        held = np.minimum(held, 1.0 / lag)
    growth = np.sqrt((held + shortest) * stiffness)
    whole = np.concatenate([[0.0], np.cumsum(0.5 * (growth[1:] + growth[:-1]) * np.diff(s))])
    length = wide.arc.length
    fewest = MESH_POWER * length * float(np.max(growth)) / STEP_GROWTH
    steps = max(steps, min(math.ceil(fewest), MOST_STEPS))
    nodes = length * np.linspace(0.0, 1.0, steps + 1) ** MESH_POWER
    pieces = max(1, math.ceil(whole[-1] / GROWTH))
    at = np.interp(nodes, s, whole)
    cuts = [int(np.searchsorted(at, whole[-1] * k / pieces)) for k in range(pieces)]
    return Mesh(nodes, tuple(sorted({*cuts, steps})))


def bends(wide: WideArc) -> bool:
    """Whether the friction law has kinks in creep that a mesh must have nodes at."""
    return wide.arc.law.compact().kind in (LIMIT, TABLE)


def kinks(wide: WideArc, nodes: Array, state: Array, pull: Array, drift: Array) -> Array:
    """Places where a strip goes from one piece of its friction law to the next [m].

    Parameters
    ----------
    wide, nodes
        The arc and the places s of the mesh [m].
    state
        Tension [N/m] beside creep [m] at the nodes, shape (m, 2 n).
    pull, drift
        What pulls and what drives the strips, see `wraparc.across.march.rates`, shape (n,).
    """
    n, numbers, law = wide.strips, wide.numbers, wide.arc.law.compact()
    tension, creep = state[:, :n], state[:, n:]
    shear = np.broadcast_to(numbers.shear, tension.shape)
    flat = shear.ravel(), creep.ravel(), tension.ravel() / numbers.radius
    branches = np.array([branch_of(law, *row) for row in zip(*(v.tolist() for v in flat),
                                                            strict=True)])  # fmt: skip
    branches = branches.reshape(tension.shape)
    stress = stresses(law, numbers.knots, *flat)[0].reshape(tension.shape)
    slope = creep @ numbers.coupling.T + pull - stress, drift - numbers.compliance * tension
    found = []
    for i, j in np.argwhere(branches[1:] != branches[:-1]).tolist():
        ends = [np.array([v[i, j], v[i + 1, j], d[i, j], d[i + 1, j]]).tolist()
                for v, d in zip((tension, creep), slope, strict=True)]  # fmt: skip
        begin, step = float(nodes[i]), float(nodes[i + 1] - nodes[i])
        low, high = 0.0, 1.0
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            t, u = (_between(end, step, middle) for end in ends)
            if branch_of(law, float(numbers.shear[j]), u, t / numbers.radius) == branches[i, j]:
                low = middle
            else:
                high = middle
        found.append(begin + 0.5 * (low + high) * step)
    return np.array(found)


def _between(ends: list[float], h: float, x: float) -> float:
    """Value at a share x of a step h by the cubic of the values and slopes at both ends."""
    first, last, slope, end_slope = ends
    y = 1.0 - x
    lean = x * y * h * (y * slope - x * end_slope)
    return y * y * (1.0 + 2.0 * x) * first + x * x * (1.0 + 2.0 * y) * last + lean
