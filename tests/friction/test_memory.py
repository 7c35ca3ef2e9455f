"""Memory of a law under reversal: closed forms of loops, and a sum of elements as a twin."""

import math
from typing import NamedTuple, Self

import numpy as np
import pytest

from friction.laws import CROSSING, TRENDS
from wraparc import Constant, ElasticPlastic, FrictionLaw, IntegralLog, MeasuredTable, PressureKnots
from wraparc.files import load_lagging
from wraparc.friction.memory import (
    MOST_TURNS,
    ROOM,
    Lagging,
    Past,
    Points,
    has_memory,
    shorten,
)

LOG = IntegralLog(
    coefficients=PressureKnots(
        pressure=(2e5,),
        peak_friction=(0.8,),
        peak_slip=(20e-3,),
        post_peak_slope=(0.0,),
        residual_friction=(0.8,),
    )
)
RUBBER = load_lagging("diamond-rubber").law
CERAMIC = load_lagging("medium-ceramic").law


class Point(NamedTuple):
    """A point in plain numbers."""

    slip: float
    stress: float
    by_creep: float
    by_pressure: float
    side: float

    @classmethod
    def of(cls, points: Points) -> Self:
        """The first of some points."""
        slip, stress, by_creep, by_pressure, _, side = (float(v[0]) for v in points)
        return cls(slip, stress, by_creep, by_pressure, side)


class Material:
    """One point, driven by slip and pressure (c = 0) or by creep."""

    def __init__(self, law: FrictionLaw, c: float = 0.0) -> None:
        self.lagging = Lagging(law.compact(), c)
        none = np.zeros(1)
        self.turns, self.count = np.zeros((1, ROOM)), np.zeros(1, dtype=np.int64)
        self.reach, self.whole = none, np.ones(1)
        self.points = Points(none, none, none, none, self.count, none)

    @property
    def at(self) -> Point:
        """Where it is, in plain numbers."""
        return Point.of(self.points)

    def moved(self, u: float, p: float) -> Points:
        a = self.points
        past = Past(self.turns, self.count, a.side, a.slip, a.stress, self.reach, self.whole)
        return self.lagging.moved(np.array([u]), np.array([p]), past, a.slip)

    def try_(self, u: float, p: float) -> Point:
        return Point.of(self.moved(u, p))

    def to(self, u: float, p: float) -> float:
        self.points = self.moved(u, p)
        self.count = self.points.held.copy()
        shorten(self.turns, self.count)
        self.reach = np.maximum(self.reach, np.abs(self.points.slip))
        return self.at.stress


class Elements:
    """The law as elastic-sliding elements with evenly spread break-away slips: the slow twin."""

    def __init__(self, law: IntegralLog, number: int, most: float) -> None:
        self.law = law
        self.y = (np.arange(number) + 0.5) * most / number
        self.e = np.zeros(number)

    def to(self, dx: float, p: float) -> float:
        self.e = np.clip(self.e + dx, -self.y, self.y)
        x_pk, mu, _, _ = (float(v) for v in self.law.parameters(p))
        ends = self.law.coefficients.pressure
        held = min(1.0, ends[-1] / p) if len(ends) > 1 else 1.0
        # the last element counts for the part of it below the peak slip
        width = self.y[1] - self.y[0]
        part = np.clip((x_pk - self.y) / width + 0.5, 0.0, 1.0)
        return float(p * mu * held * np.sum(part * self.e / self.y) * width / x_pk)


@pytest.mark.parametrize("law", [LOG, RUBBER, TRENDS], ids=["log", "rubber", "trends"])
def test_memory_is_a_sum_of_elements(law: IntegralLog) -> None:
    """Independent: 40,000 elements under random slip and pressure, 1e-5 of p mu_pk."""
    rng = np.random.default_rng(7)
    x, worst = 0.0, 0.0
    peaks = law.parameters(np.linspace(50e3, 6e5, 500))[0]
    top = 0.9 * float(peaks.min())  # before the peak at any pressure: there the law is elements
    point, twin = Material(law), Elements(law, 40_000, 1.01 * float(peaks.max()))
    for _ in range(150):
        goal = rng.uniform(-top, top)
        p = 2e5 if law is LOG else rng.uniform(50e3, 6e5)
        tau = point.to(goal, p)
        expected = twin.to(goal - x, p)
        x = goal
        mu = float(law.parameters(p)[1])
        worst = max(worst, abs(tau - expected) / (p * mu))
    assert worst < 1e-5


@pytest.mark.parametrize(
    "law", [LOG, RUBBER, CERAMIC, TRENDS, CROSSING], ids=["log", "rubber", "ceramic", "t", "x"]
)
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_monotone_slip_at_any_pressure_is_the_law(law: IntegralLog, side: float) -> None:
    """Identity: without a turn the stress is p mu(x, p), past the peak as well."""
    rng = np.random.default_rng(3)
    point = Material(law)
    for x in np.sort(rng.uniform(0.0, 40e-3, 60)):
        p = rng.uniform(30e3, 8e5)
        expected = p * float(law.friction(side * x, p))
        assert point.to(side * x, p) == pytest.approx(expected, rel=1e-12, abs=1e-9 * p)


def loop(law: FrictionLaw, top: float, p: float, steps: int = 500) -> tuple[float, float]:
    """Work of the first loading to `top`, and of a closed loop of that amplitude [J/m2]."""
    point = Material(law)
    phase = np.linspace(0.0, 0.5 * math.pi, steps)
    up = top * np.sin(phase)
    first = [point.to(x, p) for x in up]
    around = top * np.cos(np.linspace(0.0, 2.0 * math.pi, 4 * steps))
    taus = [point.to(x, p) for x in around]
    assert taus[-1] == pytest.approx(first[-1], rel=1e-6)
    return float(np.trapezoid(first, up)), float(np.trapezoid(taus, around))


@pytest.mark.parametrize("ratio", [0.1, 0.5, 1.0])
def test_a_loop_dissipates_what_masing_says(ratio: float) -> None:
    """Closed form: 2 p mu_pk x_a^2/x_pk; loading stores p mu x (1/4 - ln(r)/2) r^2 and dissipates
    p mu_pk x_pk r^2/2."""
    p, mu, x_pk = 2e5, 0.8, 20e-3
    first, around = loop(LOG, ratio * x_pk, p)
    assert around == pytest.approx(2.0 * p * mu * (ratio * x_pk) ** 2 / x_pk, rel=1e-5)
    stored = ratio**2 * (0.25 - math.log(ratio) / 2.0)
    assert first == pytest.approx(p * mu * x_pk * (stored + ratio**2 / 2.0), rel=1e-5)


def test_a_loop_beyond_the_peak() -> None:
    """Closed form: 4 p mu_pk (x_a - x_pk/2)."""
    _, around = loop(LOG, 35e-3, 2e5)
    assert around == pytest.approx(4.0 * 2e5 * 0.8 * (35e-3 - 10e-3), rel=1e-5)


def test_strength_lost_past_the_peak_stays_lost() -> None:
    """Closed form: back to the largest slip the line of the law is met again."""
    p, top = 69e3, 12e-3
    point = Material(CERAMIC)
    there = point.to(top, p)
    assert isinstance(CERAMIC, IntegralLog)
    assert there < p * float(CERAMIC.parameters(p)[1])
    point.to(0.0, p)
    assert point.to(-0.9 * top, p) == pytest.approx(-there)  # slid over the whole way back
    assert point.to(top, p) == pytest.approx(there, rel=1e-9)
    assert point.to(14e-3, p) == pytest.approx(p * float(CERAMIC.friction(14e-3, p)), rel=1e-9)


def test_turns_are_forgotten_where_a_loop_closes() -> None:
    point = Material(LOG)
    for x in (10e-3, -4e-3, 6e-3, 1e-3):
        point.to(x, 2e5)
    assert point.count == 3
    point.to(7e-3, 2e5)  # past 6 mm: that loop is closed, the first one is not
    assert point.count == 2
    point.to(11e-3, 2e5)
    assert point.count == 0


@pytest.mark.parametrize("law", [LOG, CERAMIC], ids=["log", "ceramic"])
def test_creep_slip_and_slopes_belong_together(law: FrictionLaw) -> None:
    """Identities: u = x + c tau, and the slopes are those of differences."""
    rng, c = np.random.default_rng(5), 12e-3 / 2.3e6
    point = Material(law, c)
    for _ in range(200):
        u, p = rng.uniform(-14e-3, 14e-3), rng.uniform(6e4, 5e5)
        tau = point.to(u, p)
        assert point.at.slip + c * tau == pytest.approx(u, abs=1e-12)
    # a small step on from where the point is does not turn it
    side = point.at.side
    u = point.at.slip + c * point.at.stress + side * 1e-4
    at = point.try_(u, p)
    du, dp = side * 1e-9, 1.0
    by_u = (point.try_(u + du, p).stress - point.try_(u - du, p).stress) / (2.0 * du)
    by_p = (point.try_(u, p + dp).stress - point.try_(u, p - dp).stress) / (2.0 * dp)
    assert at.by_creep == pytest.approx(by_u, rel=1e-4)
    assert at.by_pressure == pytest.approx(by_p, rel=1e-4, abs=1e-6)


@pytest.mark.parametrize("top", [9e-3, 14e-3, 45e-3])
@pytest.mark.parametrize("eased", [0.0, 2e-3])
def test_slopes_past_the_peak(top: float, eased: float) -> None:
    """Identity: slopes by creep and pressure are those of differences, on the line past the peak
    and on the residual level, sliding on and eased from there."""
    c, p = 12e-3 / 2.3e6, 90e3
    point = Material(CERAMIC, c)
    point.to(top, p)
    point.to(top - eased, p)
    u = point.at.slip + c * point.at.stress + (1e-4 if not eased else -1e-4)
    at, du, dp = point.try_(u, p), 1e-9, 1.0
    by_u = (point.try_(u + du, p).stress - point.try_(u - du, p).stress) / (2.0 * du)
    by_p = (point.try_(u, p + dp).stress - point.try_(u, p - dp).stress) / (2.0 * dp)
    assert at.by_creep == pytest.approx(by_u, rel=1e-4, abs=10.0)
    assert at.by_pressure == pytest.approx(by_p, rel=1e-4, abs=1e-6)


def test_laws_with_a_limit_are_one_element() -> None:
    """Closed form: elastic unloading from the limit, sliding the other way after 2 p mu/k."""
    p, k, mu = 2e5, 4e7, 0.5
    point = Material(ElasticPlastic(stiffness=k, friction_coefficient=mu))
    assert point.to(10e-3, p) == pytest.approx(p * mu)
    assert point.to(9e-3, p) == pytest.approx(p * mu - k * 1e-3)
    assert point.to(0.0, p) == pytest.approx(-p * mu)
    c = 5e-9
    sheared = Material(Constant(friction_coefficient=mu), c)
    assert sheared.to(1e-4, p) == pytest.approx(1e-4 / c)
    assert sheared.at.slip == pytest.approx(0.0, abs=1e-18)


def test_a_table_has_memory_if_it_is_concave() -> None:
    """Close to the law that it is a table of; one that is not concave is told."""
    x = tuple(float(v) for v in np.linspace(0.0, 20e-3, 41))
    values = tuple(float(LOG.friction(v, 2e5)) for v in x)
    table = MeasuredTable(slip=x, pressure=(2e5,), values=(values,))
    assert has_memory(table)
    a, b = Material(table, 5e-9), Material(LOG, 5e-9)
    for u in (12e-3, 3e-3, 8e-3, -6e-3, 13e-3):
        assert a.to(u, 2e5) == pytest.approx(b.to(u, 2e5), abs=0.03 * 2e5 * 0.8)
    waved = MeasuredTable(
        slip=(0.0, 1e-3, 2e-3, 3e-3), pressure=(2e5,), values=((0, 0.1, 0.5, 0.6),)
    )
    jumping = MeasuredTable(slip=(0.0, 1e-2), pressure=(2e5,), values=((0.2, 0.6),))
    assert not has_memory(waved)
    assert not has_memory(jumping)


def test_there_is_always_room_for_another_turn() -> None:
    point = Material(LOG)
    for j in range(60):
        point.to((1.0 if j % 2 else -1.0) * 15e-3 * 0.97**j, 2e5)
    assert point.count < MOST_TURNS
