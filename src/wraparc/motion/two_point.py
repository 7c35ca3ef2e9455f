"""The linear two-point problem of wraps at one instant: a step of Newton's method for their pieces.

Box scheme between neighbouring pieces, d the one nearer to the exit, u the one nearer to the nip:

    T_d - T_u + b (tau_d + tau_u) = 0,      I_d - I_u - a_d T_d - a_u T_u = 0,

with tau by T and by u = m - n - I; I = 0 at the nip, T = T_out at the exit, which lies inside the
first cell. Cells are taken in panels: of each the changes inside follow from that of T at its exit
side and of I at its nip side, a small dense system in T alone (both conditions at one end would
grow like exp(length/l)); a second small system joins the panels.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Integers

#: Cells of a panel: the dense systems cost its square a cell, the one that joins them the rest.
PANEL = 13


class Cells(NamedTuple):
    """Wraps in numbers, from the exit to the nip; shape (wraps, nodes), of cells one less.

    Attributes
    ----------
    half_width, half_give_d, half_give_u
        b, a_d, a_u: half of width, and of the compliances of either end, times the cell's length
        [m2, m/N].
    stress, by_creep, by_tension
        tau [Pa], K [Pa/m], P [1/m2].
    by_m
        How creep follows m at fixed I: 1, and less of a piece that is laid in this step [-].
    tension, short
        T [N] and I [m].
    """

    half_width: Array
    half_give_d: Array
    half_give_u: Array
    stress: Array
    by_creep: Array
    by_tension: Array
    by_m: Array
    tension: Array
    short: Array


def changes(cells: Cells, exit_tension: Array, inside: Array) -> tuple[Array, Array]:
    """Changes of T and I of every node: of the residual, by m and by the exit tension.

    Parameters
    ----------
    cells
        The wraps; the number of cells is a multiple of `PANEL`.
    exit_tension
        T_out [N], shape (wraps,).
    inside
        Part of the first cell that is on the wrap [-], shape (wraps,).

    Returns
    -------
    dT, dI
        Shape (3, wraps, nodes).

    Raises
    ------
    numpy.linalg.LinAlgError
        If the wraps have no such change.
    """
    wraps, nodes = cells.tension.shape
    t, i = _inside(cells)  # (wraps, panels, PANEL + 1, 4) of the residual, by m, T, I
    ends = _joined(cells, t, i, exit_tension, inside)
    both = np.concatenate([t, i], axis=2) @ ends
    both = both.reshape(wraps, -1, 2, PANEL + 1, 3)
    out = np.empty((2, 3, wraps, nodes))
    inner = out[..., :-1].reshape(2, 3, wraps, -1, PANEL)
    inner[...] = both[..., :-1, :].transpose(2, 4, 0, 1, 3)
    out[..., -1] = both[:, -1, :, -1, :].transpose(1, 2, 0)
    return out[0], out[1]


def _inside(cells: Cells) -> tuple[Array, Array]:
    """Changes of T and I at the nodes of every panel: of the residual, by m, by T and I of ends."""
    b, a_d, a_u, t, i = cells[0], cells[1], cells[2], cells.tension, cells.short
    stiff, push = cells.by_creep, cells.by_tension
    k_d, k_u = b * stiff[:, :-1], b * stiff[:, 1:]
    p_d, p_u = 1.0 + b * push[:, :-1], 1.0 - b * push[:, 1:]
    cell = t[:, :-1] - t[:, 1:] + b * (cells.stress[:, :-1] + cells.stress[:, 1:])
    short = i[:, :-1] - i[:, 1:] - a_d * t[:, :-1] - a_u * t[:, 1:]
    by_m = k_d * cells.by_m[:, :-1] + k_u * cells.by_m[:, 1:]
    k_d, k_u, p_d, p_u, cell, short, by_m, a_d, a_u = (
        v.reshape(-1, PANEL) for v in (k_d, k_u, p_d, p_u, cell, short, by_m, a_d, a_u)
    )
    # dI of node i is that at the nip side, less what is short, and sum of weight[i, k] dT_k
    n, (later, places) = len(cell), _masks()
    weight = np.zeros((n, PANEL + 1, PANEL + 1))
    weight[:, :, 1:] = later * a_u[:, None, :]
    weight[:, :, :-1] += later * a_d[:, None, :]
    gone = np.zeros((n, PANEL + 1))
    gone[:, :-1] = short[:, ::-1].cumsum(axis=1)[:, ::-1]
    matrix = -k_d[:, :, None] * weight[:, :-1] - k_u[:, :, None] * weight[:, 1:]
    flat = matrix.reshape(n, -1)
    flat[:, places] += p_d
    flat[:, places + 1] -= p_u
    right = np.empty((n, PANEL, 4))
    right[..., 0] = -cell - k_d * gone[:, :-1] - k_u * gone[:, 1:]
    right[..., 1], right[..., 2], right[..., 3] = -by_m, -matrix[..., 0], k_d + k_u
    at = np.zeros((n, PANEL + 1, 4))
    at[:, 0, 2] = 1.0
    at[:, 1:] = np.linalg.solve(matrix[..., 1:], right)
    along = weight @ at
    along[..., 0] -= gone
    along[..., 3] += 1.0
    shape = (len(t), -1, PANEL + 1, 4)
    return at.reshape(shape), along.reshape(shape)


def _joined(cells: Cells, t: Array, i: Array, exit_tension: Array, inside: Array) -> Array:
    """What the four columns of every panel are to be multiplied by, shape (wraps, panels, 4, 3)."""
    wraps, panels = t.shape[:2]
    last, first = t[:, :, -1], i[:, :, 0]
    # unknown are dT at the exit side of every panel, then dI at its nip side
    matrix = np.zeros((wraps, 2 * panels, 2 * panels))
    right = np.zeros((wraps, 2 * panels, 3))
    j = np.arange(2 * panels)
    matrix[:, j, j] = 1.0
    j = np.arange(panels - 1)
    matrix[:, j + 1, j], matrix[:, j + 1, panels + j] = -last[:, :-1, 2], -last[:, :-1, 3]
    right[:, 1:panels, :2] = last[:, :-1, :2]
    matrix[:, panels + j, j + 1] = -first[:, 1:, 2]
    matrix[:, panels + j, panels + j + 1] = -first[:, 1:, 3]
    right[:, panels:-1, :2] = first[:, 1:, :2]
    # the exit: T_u - near tau_u - far tau_d = T_out, tau linear in the first cell
    b, f = cells.half_width[:, 0], inside
    near, far = 2.0 * b * f * (1.0 - 0.5 * f), b * f * f
    k, p, tau = cells.by_creep, cells.by_tension, cells.stress
    k_near, k_far = near * k[:, 1], far * k[:, 0]
    ends = (
        (1.0 - near * p[:, 1])[:, None] * t[:, 0, 1]
        - (far * p[:, 0])[:, None] * t[:, 0, 0]
        + k_near[:, None] * i[:, 0, 1]
        + k_far[:, None] * i[:, 0, 0]
    )
    matrix[:, 0, 0], matrix[:, 0, panels] = ends[:, 2], ends[:, 3]
    miss = exit_tension - cells.tension[:, 1] + near * tau[:, 1] + far * tau[:, 0]
    right[:, 0, 0] = miss - ends[:, 0]
    right[:, 0, 1] = k_near * cells.by_m[:, 1] + k_far * cells.by_m[:, 0] - ends[:, 1]
    right[:, 0, 2] = 1.0
    found = np.linalg.solve(matrix, right)
    out = np.zeros((wraps, panels, 4, 3))
    out[:, :, 0, 0] = out[:, :, 1, 1] = 1.0
    out[:, :, 2], out[:, :, 3] = found[:, :panels], found[:, panels:]
    return out


@cache
def _masks() -> tuple[Array, Integers]:
    """Which cells of a panel lie on the nip side of a node; where its diagonal stands."""
    node, cell = np.arange(PANEL + 1)[:, None], np.arange(PANEL)
    return (cell >= node).astype(float), cell * (PANEL + 2)
