"""The march across the width in plain numbers, compiled where numba is there.

What `wraparc.across.march` does with arrays, strip by strip, in one function that numba takes as
it stands. The first use on a machine compiles it, which takes some seconds; see `prepare`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from wraparc.across.interface import stress_of
from wraparc.across.march import Array, Strips, march, trace
from wraparc.across.stresses import knots_of
from wraparc.arc.kernel.butcher import (
    to_end,
    to_fifth,
    to_fourth,
    to_last,
    to_second,
    to_sixth,
    to_third,
)
from wraparc.batch.native import available, compiled
from wraparc.friction.compact import LIMIT, CompactLaw


class Marches(NamedTuple):
    """What carries the strips of a belt along the arc.

    Attributes
    ----------
    march
        See `wraparc.across.march.march`.
    trace
        See `wraparc.across.march.trace`.
    """

    march: Callable[[CompactLaw, Strips, Array, Array, Array, Array], Array]
    trace: Callable[[CompactLaw, Strips, Array, Array, Array, Array], Array]


#: In arrays, without a compiler.
PLAIN = Marches(march, trace)


def carry(
    law: Any,
    radius: float,
    shear: Any,
    compliance: Any,
    coupling: Any,
    pull: Any,
    drift: Any,
    y: Any,
    nodes: Any,
    record: Any,
) -> None:
    """Carry a state and its derivatives over mesh nodes, in place.

    Parameters
    ----------
    law
        A friction law, its numbers in arrays.
    radius, shear, compliance, coupling
        See `wraparc.across.march.Strips`.
    pull, drift
        See `wraparc.across.march.rates`.
    y
        Tension and creep, shape (2 n, columns), or with work and force of each strip, (4 n, 1).
    nodes
        Places s, ascending [m].
    record
        Takes the first column at every node, shape (nodes, rows); none if empty.
    """
    rows, columns = y.shape
    k = np.empty((7, rows, columns))
    at, flat = np.empty((rows, columns)), k.reshape(7, rows * columns)
    if len(record) > 0:
        record[0, :] = y[:, 0]
    for node in range(len(nodes) - 1):
        h = nodes[node + 1] - nodes[node]
        for stage in range(7):
            if stage < 4:
                to_stage(stage, flat, y.ravel(), at.ravel())
            else:
                to_late_stage(stage, flat, y.ravel(), at.ravel())
            fill(law, radius, shear, compliance, coupling, pull, drift, at, h, k[stage])
        to_late_stage(7, flat, y.ravel(), y.ravel())
        if len(record) > 0:
            record[node + 1, :] = y[:, 0]


def to_stage(stage: int, k: Any, y: Any, out: Any) -> None:
    """Put the state of one of the first four stages of the method into `out`."""
    if stage == 0:
        for i in range(len(y)):
            out[i] = y[i]
    elif stage == 1:
        for i in range(len(y)):
            out[i] = y[i] + to_second(k[0, i])
    elif stage == 2:
        for i in range(len(y)):
            out[i] = y[i] + to_third(k[1, i])
    else:
        for i in range(len(y)):
            out[i] = y[i] + to_fourth(k[0, i], k[1, i], k[2, i])


def to_late_stage(stage: int, k: Any, y: Any, out: Any) -> None:
    """Put the state of a further stage of the method, or of the end of the step, into `out`."""
    if stage == 4:
        for i in range(len(y)):
            out[i] = y[i] + to_fifth(k[0, i], k[1, i], k[2, i], k[3, i])
    elif stage == 5:
        for i in range(len(y)):
            out[i] = y[i] + to_sixth(k[1, i], k[2, i], k[3, i], k[4, i])
    elif stage == 6:
        for i in range(len(y)):
            out[i] = y[i] + to_last(k[0, i], k[1, i], k[2, i], k[3, i], k[5, i])
    else:
        for i in range(len(y)):
            out[i] = y[i] + to_end(k[0, i], k[2, i], k[3, i], k[4, i], k[5, i], k[6, i])


def fill(
    law: Any,
    radius: float,
    shear: Any,
    compliance: Any,
    coupling: Any,
    pull: Any,
    drift: Any,
    y: Any,
    h: float,
    out: Any,
) -> None:
    """Put the rates of change over a step h into `out`, arguments as `carry`."""
    n, columns = len(shear), y.shape[1]
    for i in range(n):
        found = stress_of(law, shear[i], y[n + i, 0], y[i, 0] / radius)
        tension, creep = out[i], out[n + i]
        for j in range(columns):
            tension[j] = pull[i, j]
            creep[j] = h * (drift[i, j] - compliance[i] * y[i, j])
        for m in range(n):
            c = coupling[i, m]
            for j in range(columns):
                tension[j] += c * y[n + m, j]
        by_tension = found.by_pressure / radius
        tension[0] = h * (tension[0] - found.stress)
        for j in range(1, columns):
            tension[j] = h * (tension[j] - found.by_creep * y[n + i, j] - by_tension * y[i, j])
        if len(y) > 2 * n:
            out[2 * n + i, 0] = found.stress * creep[0]
            out[3 * n + i, 0] = h * found.stress


def _numbers(law: CompactLaw) -> CompactLaw:
    """Return a law with arrays for its tuples."""
    tuples: Any = (law.edges, law.coefficients, law.slips)
    edges, coefficients, slips = (np.array(v, dtype=float) for v in tuples)
    arrays: tuple[Any, ...] = (law.kind, edges, coefficients, slips, float(law.onset_compliance))
    return CompactLaw(*arrays)


def _carried(
    law: CompactLaw,
    strips: Strips,
    pull: Array,
    drift: Array,
    y: Array,
    nodes: Array,
    record: Array,
) -> Array:
    y = np.array(y, dtype=float, order="C")
    pull, drift = np.ascontiguousarray(pull), np.ascontiguousarray(drift)
    kernel = compiled(carry)
    coupling = np.ascontiguousarray(strips.coupling)
    kernel(
        _numbers(law), float(strips.radius), strips.shear, strips.compliance, coupling, pull,
        drift, y, np.ascontiguousarray(nodes), record,
    )  # fmt: skip
    return y


def compiled_march(
    law: CompactLaw, strips: Strips, pull: Array, drift: Array, y: Array, nodes: Array
) -> Array:
    """What `wraparc.across.march.march` gives, compiled."""
    return _carried(law, strips, pull, drift, y, nodes, np.empty((0, 0)))


def compiled_trace(
    law: CompactLaw, strips: Strips, pull: Array, drift: Array, y: Array, nodes: Array
) -> Array:
    """What `wraparc.across.march.trace` gives, compiled."""
    record = np.empty((len(nodes), len(y)))
    _carried(law, strips, pull, drift, y[:, None], nodes, record)
    return record


#: friction that does not matter, to compile with
_SMOOTH = CompactLaw(LIMIT, (), (0.5, 1.0, 0.0, 0.0))
COMPILED = Marches(compiled_march, compiled_trace)
_ready = {"compiled": False}


def prepare() -> bool:
    """Make or load the compiled march and use it from now on; False where there is no compiler."""
    if available() and not _ready["compiled"]:
        one, two = np.zeros(1), np.zeros((1, 1))
        strips = Strips(knots_of(_SMOOTH), 1.0, one, one, two)
        compiled_march(_SMOOTH, strips, two, two, np.ones((2, 1)), np.array([0.0, 1.0]))
        _ready["compiled"] = True
    return _ready["compiled"]


def quickest() -> Marches:
    """Return the compiled march if it has been prepared in this process, else that in arrays."""
    return COMPILED if _ready["compiled"] else PLAIN
