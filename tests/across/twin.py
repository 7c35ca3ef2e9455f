"""The whole belt, span, wrap and span, as one equation by finite volumes: the slow twin.

Unknown are the lag of the label line at the nodes of one mesh along the belt, and the drum number.
Tension comes from the lag, M (strain) in the spans and M' (Gamma + a/R - lag_s) on the pulley; its
balance over every cell, t_s = -tau R/(R + e) + S lag_yy with the three-point lag_yy, is solved by
Newton's method with sparse matrices from the even belt; what presses is t - m v^2/B. No modes, no
stages, no stresses of the room: slip is bisected from the public friction of the law.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.sparse
from numpy.typing import NDArray
from scipy.sparse.linalg import spsolve

from wraparc.across.wide_arc import WideArc
from wraparc.friction import FrictionLaw

Array = NDArray[np.float64]
sparse: Any = scipy.sparse  # its types know no mixed blocks


def stress(law: FrictionLaw, compliance: Array | float, creep: Array, pressure: Array) -> Array:
    """Shear stress by bisection of slip [Pa]."""
    low, high = np.zeros_like(creep), np.abs(creep)
    for _ in range(60):
        slip = 0.5 * (low + high)
        over = slip + compliance * law.friction(slip, pressure) * pressure > np.abs(creep)
        low, high = np.where(over, low, slip), np.where(over, slip, high)
    slip = 0.5 * (low + high)
    stuck = np.abs(creep) - slip
    held = np.all(compliance > 0.0)
    shear = stuck / compliance if held else law.friction(slip, pressure) * pressure
    return np.sign(creep) * shear


def graded(length: float, cells: int, power: float) -> Array:
    """Nodes from 0, fine there."""
    return length * np.linspace(0.0, 1.0, cells + 1) ** power


class Twin:
    """The discrete belt."""

    def __init__(self, wide: WideArc, cells: int = 120, span: int = 60) -> None:
        arc, self.wide = wide.arc, wide
        far = 8.0 * float(np.max(np.concatenate([wide.length_before, wide.length_after])))
        xi = np.linspace(0.0, 1.0, cells + 1)
        wrap = arc.length * (xi**3 * (1.0 - xi) + xi * (1.0 - (1.0 - xi) ** 2))
        out = graded(far, span, 3.0)
        self.s = np.concatenate([-out[:0:-1], wrap, arc.length + out[1:]])
        self.first, self.last = span, span + cells
        self.n, self.m = wide.strips, len(self.s)
        self._matrices()

    def _matrices(self) -> None:
        wide, arc, n, m = self.wide, self.wide.arc, self.n, self.m
        h = np.diff(self.s)
        on = (np.arange(m - 1) >= self.first) & (np.arange(m - 1) < self.last)
        eye, pitch = sparse.identity(n), arc.radius + (arc.pitch_offset or 0.0)
        self.lift = arc.centrifugal / arc.width
        modulus = np.where(on[:, None], 1.0 / wide.compliance, wide.belt_modulus)
        slope = sparse.diags_array([-1.0 / h, 1.0 / h], offsets=[0, 1], shape=(m - 1, m))
        self.by_lag = sparse.diags_array(-modulus.ravel()) @ sparse.kron(slope, eye)
        self.by_drum = (modulus * on[:, None]).ravel()
        base = np.zeros((m - 1, n))
        base[: self.first] = arc.entry_tension / arc.width + wide.entry_profile
        given = self.lift * (wide.compliance - 1.0 / wide.belt_modulus)  # squeezes no lagging
        base[on] = (wide.radius_deviation / pitch + given) / wide.compliance
        base[self.last :] = arc.exit_tension / arc.width
        # the path is longer at the tangents: the lag jumps there
        base[self.first - 1] += wide.belt_modulus * wide.entry_misfit / h[self.first - 1]
        base[self.last] += wide.belt_modulus * wide.exit_misfit / h[self.last]
        self.base = base.ravel()
        difference = sparse.diags_array([1.0, -1.0], offsets=[0, -1], shape=(m, m - 1))
        self.balance = sparse.kron(difference, eye)
        self.ends = np.zeros((m, n))
        self.ends[0] = -(arc.entry_tension / arc.width + wide.entry_profile)
        self.ends[-1] = arc.exit_tension / arc.width
        cell = np.zeros(m)
        cell[:-1] += 0.5 * h
        cell[1:] += 0.5 * h
        touched = np.zeros(m)
        touched[self.first : self.last] += 0.5 * h[self.first : self.last]
        touched[self.first + 1 : self.last + 1] += 0.5 * h[self.first : self.last]
        self.touched = np.repeat(touched * arc.radius / pitch, n)
        second = sparse.diags_array([1.0, -2.0, 1.0], offsets=[-1, 0, 1], shape=(n, n)).tolil()
        second[0, 0] = second[-1, -1] = -1.0
        second = second.tocsr() * (wide.shear_stiffness / (arc.width / n) ** 2)
        self.shear = sparse.kron(sparse.diags_array(cell), second)
        average = sparse.diags_array([0.5, 0.5], offsets=[0, -1], shape=(m, m - 1)).tolil()
        average[0, 0] = average[m - 1, m - 2] = 1.0
        self.average = sparse.kron(average.tocsr(), eye)
        start = sparse.csr_array((np.ones(m), (np.arange(m), np.full(m, self.first))), shape=(m, m))
        self.creep = sparse.kron(sparse.identity(m) - start, eye)

    def solve(self, drum: float) -> Twin:
        """Newton's method from a straight label line."""
        law, arc = self.wide.arc.law, self.wide.arc
        compliance, n, m = np.tile(self.wide.shear, self.m), self.n, self.m
        lag, on = np.zeros(m * n), self.touched > 0.0
        lag += np.repeat(np.clip(self.s, 0.0, arc.length), n) * 0.4 * drum
        gauge = np.zeros(m * n)
        gauge[self.first * n : (self.first + 1) * n] = 1.0 / n
        for _ in range(40):
            middle = self.base + self.by_lag @ lag + self.by_drum * drum
            u = self.creep @ lag + (arc.overrun or 0.0)
            p = np.maximum(self.average @ middle - self.lift, 1.0) / arc.radius
            du, dp = 1e-9, 1e-4 * p
            tau = np.where(on, stress(law, compliance, u, p), 0.0)
            by_u = np.where(
                on,
                stress(law, compliance, u + du, p) - stress(law, compliance, u - du, p),
                0.0,
            ) / (2.0 * du)
            by_p = np.where(on, stress(law, compliance, u, p + dp) - tau, 0.0) / dp
            miss = self.balance @ middle + self.ends.ravel()
            miss = miss + self.touched * tau - self.shear @ lag
            weight = sparse.diags_array(self.touched)
            by_t = weight @ sparse.diags_array(by_p / arc.radius) @ self.average
            jacobian = (self.balance + by_t) @ self.by_lag - self.shear
            jacobian = jacobian + weight @ sparse.diags_array(by_u) @ self.creep
            column = (self.balance + by_t) @ self.by_drum
            whole: Any = sparse.block_array(
                [[jacobian, column[:, None]], [gauge[None, :], None]], format="csc"
            )
            step: Any = spsolve(whole, -np.append(miss, float(gauge @ lag)))
            lag, drum = lag + step[:-1], drum + float(step[-1])
            if np.max(np.abs(miss)) < 1e-5 * arc.entry_tension / arc.width:
                break
        else:
            raise AssertionError("the twin did not converge")
        self.middle = (self.base + self.by_lag @ lag + self.by_drum * drum).reshape(m - 1, n)
        self.drum = drum
        return self

    @property
    def entry_tension(self) -> Array:
        """t1, carried from both sides to the tangent [N/m]."""
        return self._at(self.first)

    @property
    def exit_tension(self) -> Array:
        """t2 [N/m]."""
        return self._at(self.last)

    def _at(self, node: int) -> Array:
        s = self.s
        before = 0.5 * (s[node - 1] + s[node]), 0.5 * (s[node] + s[node + 1])
        w = (s[node] - before[0]) / (before[1] - before[0])
        return np.asarray((1.0 - w) * self.middle[node - 1] + w * self.middle[node])
