"""How peak slip and peak friction follow pressure: trend lines through nodes.

A quantity is given by its values at nodes of pressure (lowest tested, transition, highest)
and runs between two nodes as one of the trend lines of a spreadsheet. Because the logarithms
of the node values are the parameters, every quantity is positive over the tested range and
continuous at the transition by construction.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from wraparc.arrays import Array
from wraparc.friction.interpolation import evaluate, pchip

Variables = Literal["peak", "coefficients"]
#: Trend -> whether pressure, whether the value enters by its logarithm.
TRENDS: dict[str, tuple[bool, bool]] = {
    "constant": (False, False),
    "linear": (False, False),
    "logarithmic": (True, False),
    "exponential": (False, True),
    "power": (True, True),
}
_MM = 1e-3


@dataclass(frozen=True)
class LawForm:
    """Trends of the two quantities.

    Parameters
    ----------
    first, second
        Trends of each piece, one or two: of peak slip and peak friction, or of -A and -b.
    variables
        ``"peak"`` for (x_pk, mu_pk), ``"coefficients"`` for (A, b) with x in millimetres.
    nodes
        Pressures of a law through points [Pa], instead of trends: a value at each, monotone
        cubics between; `first` and `second` are then empty.
    """

    first: tuple[str, ...] = ()
    second: tuple[str, ...] = ()
    variables: Variables = "peak"
    nodes: tuple[float, ...] = ()

    @property
    def has_transition(self) -> bool:
        """Whether a quantity has two pieces."""
        return len(self.first) > 1 or len(self.second) > 1

    @property
    def size(self) -> int:
        """Number of parameters, the transition pressure included."""
        if self.nodes:
            return 2 * len(self.nodes)
        return node_count(self.first) + node_count(self.second) + self.has_transition

    def names(self) -> tuple[str, ...]:
        """Names of the parameters: logarithms of node values, of the transition pressure."""
        quantities = (
            ("peak_slip", "peak_friction") if self.variables == "peak" else ("minus_A", "minus_b")
        )
        names = [
            f"ln_{quantity}[{node}]"
            for quantity, trends in zip(quantities, (self.first, self.second), strict=True)
            for node in ([f"{p / 1e3:.4g} kPa" for p in self.nodes] or _node_names(trends))
        ]
        return (*names, *(("ln_transition_pressure",) if self.has_transition else ()))

    def __str__(self) -> str:
        if self.nodes:
            return "a value at each tested pressure"
        symbols = ("x_pk", "mu_pk") if self.variables == "peak" else ("A", "b")
        parts = [
            f"{symbol} {' then '.join(trends)}"
            for symbol, trends in zip(symbols, (self.first, self.second), strict=True)
        ]
        return ", ".join(parts)


def node_count(trends: Sequence[str]) -> int:
    """Nodes of a quantity: one more than its pieces, one only for a constant."""
    return 1 if tuple(trends) == ("constant",) else len(trends) + 1


def _node_names(trends: Sequence[str]) -> tuple[str, ...]:
    return {1: ("all",), 2: ("low", "high"), 3: ("low", "transition", "high")}[node_count(trends)]


def _between(
    trend: str, ends: tuple[float, float], values: tuple[float, float], p: Array
) -> tuple[Array, Array]:
    """Logarithm of a quantity on a trend line between two nodes, and its derivatives.

    Returns
    -------
    value
        Shape (n,).
    partial
        By the logarithms of the two values and of the two pressures, shape (n, 4).
    """
    by_log, value_log = TRENDS[trend]
    low, high = (float(np.log(end)) if by_log else end for end in ends)
    grow = (1.0, 1.0) if by_log else ends
    width = max(high - low, 1e-300)
    t = ((np.log(p) if by_log else p) - low) / width
    if value_log:
        value = (1.0 - t) * values[0] + t * values[1]
        share, rise = t, np.full_like(t, values[1] - values[0])
    else:
        # Relative to the first node; positive between the nodes.
        ratio = float(np.exp(np.clip(values[1] - values[0], -50.0, 50.0)))
        inner = np.maximum(1.0 - t + t * ratio, 1e-12)
        value = values[0] + np.log(inner)
        share, rise = t * ratio / inner, (ratio - 1.0) / inner
    by_low, by_high = rise * (t - 1.0) / width * grow[0], -rise * t / width * grow[1]
    return value, np.stack([1.0 - share, share, by_low, by_high], axis=-1)


def _ln_quantity(
    trends: Sequence[str], nodes: Array, ends: tuple[float, float], transition: float, p: Array
) -> tuple[Array, Array]:
    """Logarithm of a quantity, and its derivatives by the nodes and ln of the transition."""
    partial = np.zeros((len(p), len(nodes) + 1))
    if len(nodes) == 1:
        partial[:, 0] = 1.0
        return np.full(len(p), nodes[0]), partial
    if len(trends) == 1:
        value, part = _between(trends[0], ends, (nodes[0], nodes[1]), p)
        partial[:, :2] = part[:, :2]
        return value, partial
    value = np.empty(len(p))
    below = p <= transition
    for k, mask, span in ((0, below, (ends[0], transition)), (1, ~below, (transition, ends[1]))):
        value[mask], part = _between(trends[k], span, (nodes[k], nodes[k + 1]), p[mask])
        partial[mask, k : k + 2] = part[:, :2]
        partial[mask, 3] = part[:, 3 - k]
    return value, partial


def ln_peaks(
    form: LawForm, theta: Array, ends: tuple[float, float], p: Array
) -> tuple[Array, Array]:
    """(ln x_pk, ln mu_pk) at pressures, and their derivatives.

    Parameters
    ----------
    form
        The form.
    theta
        Its parameters, in the order of `LawForm.names`, shape (k,).
    ends
        Lowest and highest tested pressure [Pa].
    p
        Pressures [Pa], shape (n,).

    Returns
    -------
    value
        Shape (n, 2).
    jacobian
        By theta, shape (n, 2, k).
    """
    if form.nodes:
        return _through_points(form.nodes, theta, p)
    split = node_count(form.first)
    stop = split + node_count(form.second)
    transition = float(np.exp(theta[stop])) if form.has_transition else ends[1]
    one, by_one = _ln_quantity(form.first, theta[:split], ends, transition, p)
    two, by_two = _ln_quantity(form.second, theta[split:stop], ends, transition, p)
    jacobian = np.zeros((len(p), 2, len(theta)))
    jacobian[:, 0, :split], jacobian[:, 1, split:stop] = by_one[:, :-1], by_two[:, :-1]
    if form.has_transition:
        jacobian[:, 0, stop], jacobian[:, 1, stop] = by_one[:, -1], by_two[:, -1]
    if form.variables == "peak":
        return np.stack([one, two], axis=-1), jacobian
    slope = np.exp(two - one)[:, None]
    by_slip = slope * (jacobian[:, 1] - jacobian[:, 0])
    value = np.stack(peaks_from_coefficients(one, two), axis=-1)
    return value, np.stack([by_slip, jacobian[:, 0] + by_slip], axis=1)


def _through_points(nodes: Sequence[float], theta: Array, p: Array) -> tuple[Array, Array]:
    """Monotone cubics in pressure through the values at the nodes, held beyond them."""
    at, count = np.clip(p, nodes[0], nodes[-1]), len(nodes)
    knots = np.array(nodes)

    def column(ln_values: Array) -> Array:
        return np.asarray(np.log(evaluate(knots, pchip(knots, np.exp(ln_values)), at)))

    value = np.stack([column(theta[:count]), column(theta[count:])], axis=-1)
    jacobian = np.zeros((len(p), 2, len(theta)))
    for k in range(len(theta)):
        quantity, own = divmod(k, count)
        shifted = theta[quantity * count : (quantity + 1) * count].copy()
        shifted[own] += 1e-6
        jacobian[:, quantity, k] = (column(shifted) - value[:, quantity]) / 1e-6
    return value, jacobian


def peaks_from_coefficients(ln_a: Array, ln_b: Array) -> tuple[Array, Array]:
    """(ln x_pk, ln mu_pk), x in metres, from ln(-A), ln(-b) with x in millimetres."""
    ln_slip = np.exp(ln_b - ln_a) - 1.0 + np.log(_MM)
    return ln_slip, ln_a + ln_slip - np.log(_MM)


def coefficients_from_peaks(ln_slip: Array, ln_friction: Array) -> tuple[Array, Array]:
    """(ln(-A), ln(-b)), x in millimetres; NaN for b where the peak slip is below 0.37 mm."""
    in_mm = ln_slip - np.log(_MM)
    ln_a = ln_friction - in_mm
    with np.errstate(invalid="ignore", divide="ignore"):
        return ln_a, ln_a + np.log(1.0 + in_mm)


def equations(form: LawForm, theta: Array, ends: tuple[float, float]) -> tuple[str, ...]:
    """The trend lines as equations, p in kPa, x in mm, A and b in 1/mm.

    Each with the pressures it holds between.
    """
    if form.nodes:
        return ("x_pk and mu_pk: monotone cubics (PCHIP) through the values at the pressures",)
    split = node_count(form.first)
    stop = split + node_count(form.second)
    nodes = [ends[0], ends[1]]
    if form.has_transition:
        nodes.insert(1, float(np.exp(theta[stop])))
    if form.variables == "peak":
        rows = (
            ("x_pk/mm", form.first, theta[:split] - np.log(_MM), 1.0),
            ("mu_pk", form.second, theta[split:stop], 1.0),
        )
    else:
        rows = (
            ("A/(1/mm)", form.first, theta[:split], -1.0),
            ("b/(1/mm)", form.second, theta[split:stop], -1.0),
        )
    lines = []
    for symbol, trends, values, sign in rows:
        at = nodes if len(trends) > 1 else [ends[0], ends[1]]
        for k, trend in enumerate(trends):
            low, high = at[k] / 1e3, at[k + 1] / 1e3
            pair = values[[k, min(k + 1, len(values) - 1)]]
            text = _equation(trend, (low, high), np.exp(pair), sign)
            lines.append(f"{symbol} = {text}    ({low:.4g} <= p/kPa <= {high:.4g})")
    if form.variables == "peak":
        lines.append("A = -mu_pk/x_pk, b = A (1 + ln x_pk)    (x_pk in mm: A and b in 1/mm)")
    return tuple(lines)


def _equation(trend: str, ends: tuple[float, float], values: Array, sign: float) -> str:
    by_log, value_log = TRENDS[trend]
    if trend == "constant":
        return f"{sign * values[0]:.5g}"
    p0, p1 = (float(np.log(p)) if by_log else p for p in ends)
    v0, v1 = (np.log(v) if value_log else v for v in values)
    slope = float((v1 - v0) / (p1 - p0))
    start = float(v0 - slope * p0)
    if trend == "power":
        return f"{sign * np.exp(start):.5g} p^{slope:.5g}"
    if trend == "exponential":
        return f"{sign * np.exp(start):.5g} e^({slope:.5g} p)"
    variable = "ln p" if by_log else "p"
    return f"{sign * start:.5g} {'+' if sign * slope >= 0 else '-'} {abs(slope):.5g} {variable}"
