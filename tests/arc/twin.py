"""An independent solver of the wrap-arc equations, slow and readable, to test the fast one against.

State (ln T, creep u) and a root for the slip at every evaluation; Hairer's DOP853 in SciPy at 1e-10;
the laws written out again from their formulas, with SciPy's interpolator. Nothing is shared with
wraparc.arc or wraparc.friction but the field names of their descriptions.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from math import copysign, exp, log, sqrt
from typing import Any

from scipy.integrate import ode
from scipy.interpolate import PchipInterpolator

from wraparc.arc import WrapArc
from wraparc.friction import (
    CoefficientPieces,
    Constant,
    ElasticPlastic,
    FrictionLaw,
    IntegralLog,
    MeasuredTable,
    PressurePower,
)

Scalar = Callable[[float], float]


def pchip(x: tuple[float, ...], y: tuple[float, ...]) -> Scalar:
    """SciPy's interpolant as a quick scalar function."""
    poly = PchipInterpolator(x, y)
    cubics = poly.c.T.tolist()

    def value(at: float) -> float:
        i = min(max(bisect_right(x, at) - 1, 0), len(x) - 2)
        t = at - x[i]
        c3, c2, c1, c0 = cubics[i]
        return float(((c3 * t + c2) * t + c1) * t + c0)

    return value


def friction(law: FrictionLaw) -> Callable[[float, float], float]:
    """mu(x, p) for x >= 0 from the formulas of the documentation."""
    if isinstance(law, Constant | PressurePower | ElasticPlastic):
        return lambda x, p: limit(law, p)
    if isinstance(law, MeasuredTable):
        rows = [pchip(law.slip, row) for row in law.values]
        edges = law.pressure

        def table(x: float, p: float) -> float:
            at, x = min(max(p, edges[0]), edges[-1]), min(x, law.slip[-1])
            i = min(max(bisect_right(edges, at) - 1, 0), len(edges) - 2)
            w = (at - edges[i]) / (edges[i + 1] - edges[i])
            return ((1 - w) * rows[i](x) + w * rows[i + 1](x)) * min(1.0, edges[-1] / p)

        return table
    assert isinstance(law, IntegralLog)
    c = law.coefficients
    first, last = c.pressure[0], c.pressure[-1]
    if isinstance(c, CoefficientPieces):
        pieces = c

        def parts(p: float) -> tuple[float, float, float, float]:
            i = min(max(bisect_right(pieces.pressure, p) - 1, 0), len(pieces.pieces) - 1)
            piece = pieces.pieces[i]
            a, b = (sum(k * p**j for j, k in enumerate(t.coefficients)) for t in (piece.a, piece.b))
            x_pk = exp(b / a - 1)
            return x_pk, -a * x_pk, 0.0, -a * x_pk

    else:
        columns = (c.peak_slip, c.peak_friction, c.post_peak_slope or (0.0,) * len(c.pressure))
        level = c.residual_friction or c.peak_friction
        level = tuple(min(r, m) for r, m in zip(level, c.peak_friction, strict=True))
        f = [pchip(c.pressure, column) for column in (*columns, level)]

        def parts(p: float) -> tuple[float, float, float, float]:
            return f[0](p), f[1](p), f[2](p), f[3](p)

    def integral_log(x: float, p: float) -> float:
        x_pk, mu_pk, m, res = parts(min(max(p, first), last))
        held = min(1.0, last / p)
        if x <= 0:
            return 0.0
        if x <= x_pk:
            a = -mu_pk / x_pk
            return held * (a * x * log(x) - a * (1 + log(x_pk)) * x)
        return held * max(mu_pk + m * (x - x_pk), min(res, mu_pk))

    return integral_log


def limit(law: FrictionLaw, p: float) -> float:
    """Friction limit of the laws that have nothing else."""
    assert isinstance(law, Constant | PressurePower | ElasticPlastic)
    low, high = (0.0, float("inf"))
    if law.tested is not None:
        low, high = law.tested.pressure_min, law.tested.pressure_max
    mu = law.friction_coefficient
    if isinstance(law, PressurePower):
        mu *= (law.reference_pressure / min(max(p, low), high)) ** law.exponent
    return mu * min(1.0, high / p)


class Twin:
    """One arc, integrated at a given entry creep ratio."""

    def __init__(self, arc: WrapArc) -> None:
        self.arc, self.mu = arc, friction(arc.law)
        self.radius = arc.diameter / 2
        self.length = self.radius * arc.wrap_angle
        self.shear = arc.thickness / arc.shear_modulus
        squeeze = arc.thickness / arc.compression_modulus
        kappa = 2 * squeeze / (arc.width * arc.diameter * self.radius) if arc.recovery else 0.0
        self.compliance = 1 / arc.axial_stiffness + kappa
        delta = squeeze * self.pressure(arc.entry_tension)
        formula = 1.25 * delta * sqrt(delta / self.radius)
        self.kick = formula if arc.overrun is None else arc.overrun
        self.slip = 0.0

    def pressure(self, tension: float) -> float:
        return 2 * tension / (self.arc.width * self.arc.diameter)

    def stress(self, u: float, p: float) -> tuple[float, float]:
        """Shear stress and slip from creep: u = x + (h/G) tau."""
        law, a = self.arc.law, abs(u)
        if isinstance(law, Constant | PressurePower | ElasticPlastic):
            elastic = self.shear + (1 / law.stiffness if isinstance(law, ElasticPlastic) else 0.0)
            most = limit(law, p) * p
            tau = min(a / elastic, most) if elastic > 0 else most * (a > 0)
            return copysign(tau, u), copysign(a - self.shear * tau, u)
        held = self.mu(0.0, p) * p
        if held > 0 and a <= self.shear * held:
            return copysign(a / self.shear, u), 0.0
        x = self.root(a, p)
        return copysign(self.mu(x, p) * p, u), copysign(x, u)

    def root(self, u: float, p: float) -> float:
        """Slip x in [0, u] with x + (h/G) mu(x, p) p = u (secants inside a bracket)."""
        shear, mu = self.shear, self.mu
        if u == 0.0 or shear == 0.0:
            return u
        low, high = 0.0, u
        x = min(self.slip, u) if self.slip > 0.0 else 0.5 * u
        x_last, f_last = u, shear * mu(u, p) * p
        for _ in range(200):
            f = x + shear * mu(x, p) * p - u
            if f > 0:
                high = x
            else:
                low = x
            if abs(f) <= 1e-15 * u or high - low <= 1e-15 * u:
                break
            new = x - f * (x - x_last) / (f - f_last) if f != f_last else 0.5 * (low + high)
            if not low < new < high:
                new = 0.5 * (low + high)
            x_last, f_last, x = x, f, new
        self.slip = x
        return x

    def integrate(self, g: float) -> tuple[float, float, float, float]:
        """ln(T2/T1), creep and slip at the exit, and the largest shear stress on the way."""
        t1, radius, length = self.arc.entry_tension, self.radius, self.length
        path: list[tuple[float, float, float]] = []

        def rates(xi: float, y: Any) -> list[float]:
            q, u = float(y[0]), float(y[1])
            tension = t1 * exp(q)
            p = self.pressure(tension)
            tau, _ = self.stress(u, p)
            ds = 4 * length * xi**3
            return [-tau / (p * radius) * ds, (g + (t1 - tension) * self.compliance) * ds]

        def note(xi: float, y: Any) -> None:
            path.append((xi, float(y[0]), float(y[1])))

        def scheme_at(xi: float, q: float, u: float) -> Any:
            scheme = ode(rates).set_integrator("dop853", rtol=1e-10, atol=1e-14, nsteps=100000)
            return scheme.set_initial_value([q, u], xi)

        def stress_of(q: float, u: float) -> float:
            return abs(self.stress(u, self.pressure(t1 * exp(q)))[0])

        scheme = ode(rates).set_integrator(
            "dop853", rtol=1e-10, atol=1e-14, nsteps=100000, max_step=0.02
        )
        scheme.set_solout(note)
        scheme.set_initial_value([0.0, self.kick], 0.0)
        q, u = (float(v) for v in scheme.integrate(1.0))
        assert scheme.successful()
        _, x = self.stress(u, self.pressure(t1 * exp(q)))
        # the largest stress: golden section between the steps around the largest step value
        i = max(range(len(path)), key=lambda k: stress_of(*path[k][1:]))
        start = path[max(i - 1, 0)]
        a, b = start[0], path[min(i + 1, len(path) - 1)][0]
        best = stress_of(*path[i][1:])
        for _ in range(45):
            c, d = b - 0.6180339887 * (b - a), a + 0.6180339887 * (b - a)
            f_c, f_d = (stress_of(*scheme_at(*start).integrate(v)) for v in (c, d))
            best = max(best, f_c, f_d)
            if f_c >= f_d:
                b = d
            else:
                a = c
        return q, u, x, best
