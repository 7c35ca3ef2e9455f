"""March all strips of a belt together along the wrap, with what their ends depend on.

On every strip, with the tension per unit width t and the creep u,

    dt/ds = -tau(u, t/R) + S d2(lag)/dy2,   du/ds = Gamma + a/R - t/M' ,

and the belt's shear couples the strips through the lag of the label line, lag = lag1 + u - u(0). A
march carries one column for the state and one for each number that the state depends on; the
columns obey the equations linearised about the state. Arrays only, like the arc kernel in plain
numbers: one source runs in the interpreter and compiled.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from wraparc.across.stresses import Knots, stresses
from wraparc.arc.kernel.butcher import (
    to_end,
    to_fifth,
    to_fourth,
    to_last,
    to_second,
    to_sixth,
    to_third,
)
from wraparc.friction.compact import CompactLaw

Array = NDArray[np.float64]


class Strips(NamedTuple):
    """What a march reads of the strips.

    Attributes
    ----------
    knots
        Of the friction law.
    radius
        R [m].
    shear
        h/G of each strip, shape (n,) [m/Pa].
    compliance
        How much less a strip creeps per length and tension, 1/M' (1/M where the lagging does not
        recover), shape (n,) [m/N].
    coupling
        S d2/dy2, shape (n, n) [N/m3 m].
    """

    knots: Knots
    radius: float
    shear: Array
    compliance: Array
    coupling: Array


def rates(law: CompactLaw, strips: Strips, pull: Array, drift: Array, y: Array) -> Array:
    """Rates of change along the arc.

    Parameters
    ----------
    law, strips
        See the module.
    pull
        What the columns of y add to dt/ds: S d2/dy2 of (lag1 - u(0)), shape (n, m + 1).
    drift
        What they add to du/ds: Gamma + a/R, shape (n, m + 1).
    y
        Tensions [N/m] above creep [m], shape (2 n, m + 1): the state and its m derivatives.
    """
    n = len(strips.shear)
    tension, creep = y[:n], y[n:]
    out = np.empty_like(y)
    out[:n] = np.dot(strips.coupling, np.ascontiguousarray(creep)) + pull
    out[n:] = drift - strips.compliance.reshape(n, 1) * tension
    pressure = tension[:, 0] / strips.radius
    stress, by_creep, by_pressure, _ = stresses(
        law, strips.knots, strips.shear, creep[:, 0], pressure
    )
    out[:n, 0] -= stress
    if y.shape[1] > 1:
        out[:n, 1:] -= by_creep.reshape(n, 1) * creep[:, 1:]
        out[:n, 1:] -= (by_pressure / strips.radius).reshape(n, 1) * tension[:, 1:]
    return out


def step(slopes: Callable[[Array], Array], y: Array, h: float) -> Array:
    """Carry an array over a step h of sixth order, its slopes given by the array alone."""
    k1 = h * slopes(y)
    k2 = h * slopes(y + to_second(k1))
    k3 = h * slopes(y + to_third(k2))
    k4 = h * slopes(y + to_fourth(k1, k2, k3))
    k5 = h * slopes(y + to_fifth(k1, k2, k3, k4))
    k6 = h * slopes(y + to_sixth(k2, k3, k4, k5))
    k7 = h * slopes(y + to_last(k1, k2, k3, k4, k6))
    return y + to_end(k1, k3, k4, k5, k6, k7)


def march(
    law: CompactLaw, strips: Strips, pull: Array, drift: Array, y: Array, nodes: Array
) -> Array:
    """Carry a state and its derivatives over mesh nodes; return them at the last.

    Arguments as `rates`; `nodes` are the places s of the mesh, ascending [m].
    """

    def slopes(at: Array) -> Array:
        return rates(law, strips, pull, drift, at)

    for i in range(len(nodes) - 1):
        y = step(slopes, y, float(nodes[i + 1] - nodes[i]))
    return y


def trace(
    law: CompactLaw, strips: Strips, pull: Array, drift: Array, y: Array, nodes: Array
) -> Array:
    """March a state without derivatives, with work int tau du and force int tau ds of each strip.

    Arguments as `march`, but y holds tension, creep, work and force, shape (4 n,). Returns them at
    every node, shape (nodes, 4 n). Work is that of friction and of the belt's shear.
    """
    n = len(strips.shear)
    out = np.empty((len(nodes), 4 * n))
    out[0] = y

    def slopes(at: Array) -> Array:
        state = rates(law, strips, pull, drift, at[: 2 * n].reshape(2 * n, 1))[:, 0]
        stress = strips.coupling @ at[n : 2 * n] + pull[:, 0] - state[:n]
        return np.concatenate([state, stress * state[n:], stress])

    for i in range(len(nodes) - 1):
        y = step(slopes, y, float(nodes[i + 1] - nodes[i]))
        out[i + 1] = y
    return out
