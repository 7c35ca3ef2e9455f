"""An independent solver of the wrap-arc equations, slow and readable, to test the fast one with.

State (ln T, creep u) and a root for the slip at every evaluation; SciPy's DOP853 at 1e-10; the laws
written out again from their formulas, with SciPy's interpolator. Nothing is shared with wraparc.arc
or wraparc.friction but the field names of their descriptions.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from math import copysign, exp, inf, log, sqrt
from typing import Any, NamedTuple

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
    PressureKnots,
    PressurePower,
)

Scalar = Callable[[float], float]


def pchip(x: tuple[float, ...], y: tuple[float, ...]) -> Scalar:
    """SciPy's interpolant as a quick scalar function; a single knot makes a constant."""
    if len(x) == 1:
        return lambda at: y[0]
    poly = PchipInterpolator(x, y)
    cubics = poly.c.T.tolist()

    def value(at: float) -> float:
        i = min(max(bisect_right(x, at) - 1, 0), len(x) - 2)
        t = at - x[i]
        c3, c2, c1, c0 = cubics[i]
        return float(((c3 * t + c2) * t + c1) * t + c0)

    return value


def friction(law: FrictionLaw) -> Callable[[float], Scalar]:
    """mu(x) for x >= 0 at a pressure, from the formulas of the documentation."""
    if isinstance(law, IntegralLog):
        return integral_log(law)
    if isinstance(law, MeasuredTable):
        return table(law)
    return lambda p: lambda x: limit(law, p)


def table(law: MeasuredTable) -> Callable[[float], Scalar]:
    rows, edges, end = [pchip(law.slip, row) for row in law.values], law.pressure, law.slip[-1]

    def at_pressure(p: float) -> Scalar:
        at, held = min(max(p, edges[0]), edges[-1]), min(1.0, edges[-1] / p)
        i = max(min(bisect_right(edges, at) - 1, len(edges) - 2), 0)
        low, high, w = rows[i], rows[min(i + 1, len(edges) - 1)], 0.0
        if len(edges) > 1:
            w = (at - edges[i]) / (edges[i + 1] - edges[i])
        return lambda x: held * ((1 - w) * low(min(x, end)) + w * high(min(x, end)))

    return at_pressure


def integral_log(law: IntegralLog) -> Callable[[float], Scalar]:
    c = law.coefficients
    parts = from_pieces(c) if isinstance(c, CoefficientPieces) else from_knots(c)
    first, last = (c.pressure[0], c.pressure[-1]) if len(c.pressure) > 1 else (0.0, inf)

    def at_pressure(p: float) -> Scalar:
        x_pk, mu_pk, m, res = parts(min(max(p, first), last))
        held = min(1.0, last / p)
        a = -mu_pk / x_pk
        b = a * (1 + log(x_pk))

        def mu(x: float) -> float:
            if x <= 0:
                return 0.0
            if x <= x_pk:
                return held * (a * x * log(x) - b * x)
            return held * max(mu_pk + m * (x - x_pk), min(res, mu_pk))

        return mu

    return at_pressure


def from_pieces(c: CoefficientPieces) -> Callable[[float], tuple[float, float, float, float]]:
    """Peak slip and friction, slope and residual friction of polynomial pieces in metres."""

    def parts(p: float) -> tuple[float, float, float, float]:
        i = min(max(bisect_right(c.pressure, p) - 1, 0), len(c.pieces) - 1)
        piece = c.pieces[i]
        a, b = (sum(k * p**j for j, k in enumerate(t.coefficients)) for t in (piece.a, piece.b))
        x_pk = exp(b / a - 1)
        return x_pk, -a * x_pk, 0.0, -a * x_pk

    return parts


def from_knots(c: PressureKnots) -> Callable[[float], tuple[float, float, float, float]]:
    """Peak slip and friction, slope and residual friction between knots of pressure."""
    level = c.residual_friction or c.peak_friction
    level = tuple(min(r, m) for r, m in zip(level, c.peak_friction, strict=True))
    slope = c.post_peak_slope or (0.0,) * len(c.pressure)
    f = [pchip(c.pressure, v) for v in (c.peak_slip, c.peak_friction, slope, level)]
    return lambda p: (f[0](p), f[1](p), f[2](p), f[3](p))


def limit(law: FrictionLaw, p: float) -> float:
    """Friction limit of the laws that have nothing else."""
    assert isinstance(law, Constant | PressurePower | ElasticPlastic)
    low, high = (0.0, inf)
    if law.tested is not None:
        low, high = law.tested.pressure_min, law.tested.pressure_max
    mu = law.friction_coefficient
    if isinstance(law, PressurePower):
        mu *= (law.reference_pressure / min(max(p, low), high)) ** law.exponent
    return mu * min(1.0, high / p)


class Exit(NamedTuple):
    """The belt at the exit nip, and the largest shear stress [Pa] on the way."""

    log_tension: float  # ln(T2/T1)
    creep: float  # [m]
    slip: float  # [m]
    peak_stress: float


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
        self.overrun_constant = formula if arc.overrun is None else arc.overrun
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
        mu = self.mu(p)
        held = mu(0.0) * p
        if held > 0 and a <= self.shear * held:
            return copysign(a / self.shear, u), 0.0
        x = self.root(a, p, mu)
        return copysign(mu(x) * p, u), copysign(x, u)

    def root(self, u: float, p: float, mu: Scalar) -> float:
        """Slip x in [0, u] with x + (h/G) mu(x, p) p = u (secants inside a bracket)."""
        if u == 0.0 or self.shear == 0.0:
            return u
        ease = self.shear * p
        low, high = 0.0, u
        x = min(self.slip, u) if self.slip > 0.0 else 0.5 * u
        x_last, f_last = u, ease * mu(u)
        for _ in range(200):
            f = x + ease * mu(x) - u
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

    def integrate(self, g: float) -> Exit:
        """Integrate from the entry nip to the exit nip at an entry creep ratio."""
        path: list[tuple[float, float, float]] = []

        def note(xi: float, y: Any) -> None:
            path.append((xi, float(y[0]), float(y[1])))

        q, u = self._carry(g, (0.0, 0.0, self.overrun_constant), 1.0, note)
        _, x = self.stress(u, self.pressure(self.arc.entry_tension * exp(q)))
        return Exit(q, u, x, self._peak(g, path))

    def solve_near(self, g: float) -> tuple[float, Exit]:
        """Entry creep ratio and exit for T(phi) = T2, one secant step away from g.

        The tension at the exit is so sensitive to g on a soft belt (e^(L/l), l the shear-lag
        length) that two solvers are compared at one tension, not at one g.
        """
        goal = log(self.arc.exit_tension / self.arc.entry_tension)
        first = self.integrate(g)
        step = 1e-5 * (abs(g) + abs(self.overrun_constant) / self.length)
        if abs(first.log_tension - goal) <= 3e-7 * abs(goal) or step == 0.0:
            return g, first
        second = self.integrate(g + step)
        while abs(second.log_tension - first.log_tension) > 1e-3 * abs(goal):
            step *= 1e-3
            second = self.integrate(g + step)
        w = (goal - first.log_tension) / (second.log_tension - first.log_tension)
        return g + w * step, Exit(*(a + w * (b - a) for a, b in zip(first, second, strict=True)))

    def _rates(self, g: float, xi: float, q: float, u: float) -> tuple[float, float]:
        """Rates of ln T and u by xi, s = L xi^4."""
        tension = self.arc.entry_tension * exp(q)
        p = self.pressure(tension)
        ds = 4 * self.length * xi**3
        dq = -self.stress(u, p)[0] / (p * self.radius)
        return dq * ds, (g + (self.arc.entry_tension - tension) * self.compliance) * ds

    def _carry(
        self, g: float, start: tuple[float, float, float], end: float, note: Any = None
    ) -> tuple[float, float]:
        scheme = ode(lambda xi, y: self._rates(g, xi, float(y[0]), float(y[1])))
        scheme.set_integrator("dop853", rtol=1e-10, atol=1e-14, nsteps=100000, max_step=0.1)
        if note is not None:
            scheme.set_solout(note)
        scheme.set_initial_value(start[1:], start[0])
        q, u = scheme.integrate(end)
        assert scheme.successful()
        return float(q), float(u)

    def _stress_of(self, q: float, u: float) -> float:
        return abs(self.stress(u, self.pressure(self.arc.entry_tension * exp(q)))[0])

    def _peak(self, g: float, path: list[tuple[float, float, float]]) -> float:
        """Largest shear stress: located on the cubics between steps, integrated to that point."""
        at = [self._stress_of(*point[1:]) for point in path]
        best = max(at)
        near = set()  # a law of pieces may have two maxima, the higher one between nodes
        for i in range(len(at)):
            if at[i] > 0.99 * best and at[i] == max(at[max(i - 1, 0) : i + 2]):
                near |= {max(i - 1, 0), min(i, len(at) - 2)}
        for start, end in (path[i : i + 2] for i in sorted(near)):
            h = end[0] - start[0]
            slopes = [self._rates(g, *point) for point in (start, end)]

            def between(f: float, k: int) -> float:
                e = 1 - f
                rise = (1 + 2 * f) * start[k + 1] + f * h * slopes[0][k]  # noqa: B023
                fall = (1 + 2 * e) * end[k + 1] - e * h * slopes[1][k]  # noqa: B023
                return e * e * rise + f * f * fall

            a, b = 0.0, 1.0
            while b - a > 1e-6:
                c, d = b - 0.6180339887 * (b - a), a + 0.6180339887 * (b - a)
                f_c, f_d = (self._stress_of(between(f, 0), between(f, 1)) for f in (c, d))
                a, b = (a, d) if f_c >= f_d else (c, b)
            if a > 1e-6 and b < 1 - 1e-6:
                best = max(best, self._stress_of(*self._carry(g, start, start[0] + h * a)))
        return best
