"""Measured tables for the lanes: cells of slip and pressure with what friction is there, flat.

A row is a head, the cells of the first interval of pressure by slip, then those of the next ones. A
cell knows where it begins and ends, the cubic in slip at its lower pressure, and by how much the
coefficients of that grow with pressure.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, log2

import numpy as np
from numpy.typing import NDArray

from wraparc.batch.laws import LawBank
from wraparc.friction.compact import TABLE, CompactLaw

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

#: numbers of a head: cells of an interval, intervals, first and last pressure [Pa], slip up to
#: which friction falls at no pressure [m]
TABLE_HEAD = 5
#: numbers of a cell: slip and pressure where it begins and ends; two cubics
TABLE_CELL = 12
FIRST_CUBIC, GROWTH_CUBIC = 4, 8  # where they begin
EXIT_OVER_MEAN = 1.6  # of friction, guessed
WITHOUT_END = 1e300  # slip where the last cell ends [m]


@dataclass(frozen=True, eq=False)
class LaneTables:
    """The measured tables of a bank that begin without friction.

    Attributes
    ----------
    numbers
        Rows one after the other.
    row
        Where the row of each law begins, -1 for a law that is none of them, shape (m,).
    halvings
        Of a number of cells until one is left.
    """

    numbers: Array
    row: Integers
    halvings: int

    @classmethod
    def of(cls, bank: LawBank) -> LaneTables:
        """Return the tables of a bank."""
        laws = {int(i): bank.compact(int(i)) for i in np.flatnonzero(bank.kind == TABLE)}
        laws = {i: law for i, law in laws.items() if law.coefficients[0] == 0.0}
        row = np.full(len(bank), -1, dtype=np.int64)
        rows, begins, most = [np.empty(0)], 0, 1
        for i, law in laws.items():
            row[i] = begins
            rows.append(_row(law))
            begins += len(rows[-1])
            most = max(most, len(law.slips), len(law.edges))
        return cls(np.concatenate(rows), row, ceil(log2(most)) + 1)


def _row(law: CompactLaw) -> Array:
    slips, edges = np.array(law.slips), np.array(law.edges)
    cubics = np.array(law.coefficients).reshape(len(edges), len(slips), 4)
    if len(edges) == 1:  # one interval without a length
        edges, cubics = np.repeat(edges, 2), np.repeat(cubics, 2, axis=0)
        width = np.ones(1)
    else:
        width = np.diff(edges)
    cells = np.empty((len(edges) - 1, len(slips), TABLE_CELL))
    cells[..., 0], cells[..., 1] = slips, np.append(slips[1:], WITHOUT_END)
    cells[..., 2], cells[..., 3] = edges[:-1, None], edges[1:, None]
    cells[..., FIRST_CUBIC:GROWTH_CUBIC] = cubics[:-1]
    cells[..., GROWTH_CUBIC:] = np.diff(cubics, axis=0) / width[:, None, None]
    head = [len(slips), len(edges) - 1, edges[0], edges[-1], _rises_to(law)]
    return np.concatenate([head, cells.ravel()])


def _rises_to(law: CompactLaw) -> float:
    """First slip from which friction falls at some pressure [m]."""
    slips = np.array(law.slips)
    values = np.array(law.coefficients).reshape(-1, len(slips), 4)[..., 0]
    falls = np.flatnonzero((np.diff(values, axis=1) < 0.0).any(axis=0))
    return float(slips[falls[0]]) if len(falls) else WITHOUT_END


def guess_under(law: CompactLaw, mean: Array, pressure: Array) -> tuple[Array, Array]:
    """Slip at the exit [m] and friction per slip at small slip [1/m], guessed.

    Parameters
    ----------
    law
        A measured table.
    mean
        Mean friction that is asked for, shape (n,) [-].
    pressure
        Wrap pressure half the way, shape (n,) [Pa].
    """
    slips, edges = np.array(law.slips), np.array(law.edges)
    values = np.array(law.coefficients).reshape(len(edges), len(slips), 4)[..., 0]
    held = edges[-1] / np.maximum(pressure, edges[-1])
    plateau = held * np.interp(pressure, edges, values.max(axis=1))
    form = np.maximum.accumulate((values / values.max(axis=1, keepdims=True)).mean(axis=0))
    share = np.minimum(EXIT_OVER_MEAN * mean / plateau, 0.95)
    return np.interp(share, form, slips), np.interp(pressure, edges, values[:, 1]) / slips[1]
