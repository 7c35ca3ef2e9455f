"""Exact checks of the belt across its width: closed forms, limits, symmetries, identities."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import simpson
from scipy.linalg import expm
from scipy.optimize import brentq

from across.wides import (
    CORD,
    FABRIC,
    RANGE,
    RUBBER,
    SOFTENING,
    UNLIMITED,
    braking,
    crown,
    mode,
    wide,
)
from arc.finer import finer
from wraparc.across.collocation import System, along, newton, started
from wraparc.across.elements import Elements, graded
from wraparc.across.result import AcrossResult, AcrossStatus, to_the_edges
from wraparc.across.solver import AcrossSolver
from wraparc.across.spans import extra_path, length_after, length_before
from wraparc.across.stresses import Law, pieces, stresses
from wraparc.across.wide_arc import WideArc, centres
from wraparc.arc import Distributed, WrapArc
from wraparc.arc.profile import Range, read
from wraparc.arrays import Array
from wraparc.drive.across import GrippingPulley, Transition
from wraparc.friction import (
    CoefficientPieces,
    Constant,
    ElasticPlastic,
    FrictionLaw,
    MeasuredTable,
    Piece,
    PressurePower,
    Trend,
)
from wraparc.friction.integral_log import IntegralLog

LAWS: dict[str, FrictionLaw] = {
    "rubber": RUBBER,
    "softening": SOFTENING,
    "pieces": IntegralLog(
        coefficients=CoefficientPieces(
            pressure=(34e3, 690e3),
            pieces=(
                Piece(a=Trend(coefficients=(-60.0, 4e-5)), b=Trend(coefficients=(175.0, -1.2e-4))),
            ),
        ),
        tested=RANGE,
    ),
    "table": MeasuredTable(
        slip=(0.0, 1e-3, 4e-3, 12e-3),
        pressure=(40e3, 200e3, 600e3),
        values=((0.0, 0.5, 0.9, 1.0), (0.0, 0.4, 0.7, 0.8), (0.0, 0.2, 0.4, 0.5)),
    ),
    "jump table": MeasuredTable(
        slip=(0.0, 1e-3, 4e-3, 10e-3),
        pressure=(40e3, 200e3, 600e3),
        values=((0.3, 0.5, 0.7, 0.75), (0.25, 0.4, 0.55, 0.6), (0.15, 0.25, 0.35, 0.4)),
    ),
    "constant": Constant(friction_coefficient=0.45),
    "power": PressurePower(
        friction_coefficient=0.55, reference_pressure=2e5, exponent=0.3, tested=RANGE
    ),
    "elastic-plastic": ElasticPlastic(stiffness=4e8, friction_coefficient=0.5),
}


def solved(given: WideArc, accuracy: float = 1e-6) -> AcrossResult:
    result = AcrossSolver(accuracy).solve(given)
    assert result.status is AcrossStatus.SOLVED
    return result


@pytest.mark.parametrize("name", LAWS)
def test_stress_by_the_public_friction_of_the_law(name: str) -> None:
    """Source: u = x + (h/G) mu(x, p) p with the law as the public calls it; differences."""
    law, c = Law.of(LAWS[name].compact()), 5.2e-9
    u = np.array([-7e-3, -1e-3, -2e-5, 3e-6, 4e-4, 2.5e-3, 9e-3, 0.03])
    p = np.array([20e3, 90e3, 150e3, 250e3, 330e3, 400e3, 500e3, 800e3])
    u, p = (v.ravel() for v in np.meshgrid(u, p))
    given = np.full(len(u), c)
    tau, by_u, by_p, x = stresses(law, given, u, p)
    assert u == pytest.approx(x + c * tau, abs=1e-15, rel=1e-9)
    friction = LAWS[name].friction
    sliding = np.abs(x) > 0.0
    assert np.any(sliding)
    assert tau[sliding] == pytest.approx((friction(x, p) * p)[sliding], rel=1e-9)
    assert np.all(np.abs(tau) <= np.abs(friction(np.sign(u) * 1e9, p)) * p + 1e9 * sliding)
    du, dp = 1e-5 * u, 1e-5 * p
    # not where the law bends between: 400 and 800 kPa are off its edges, its slips are hit by none
    low, high = (pieces(law, given, u + k * du, p) for k in (-1, 1))
    smooth = low == high
    a, b = (stresses(law, given, u + k * du, p).stress for k in (-1, 1))
    assert ((b - a) / (2.0 * du))[smooth] == pytest.approx(by_u[smooth], rel=1e-4, abs=1.0)
    low, high = (pieces(law, given, u, p + k * dp) for k in (-1, 1))
    smooth = low == high
    a, b = (stresses(law, given, u, p + k * dp).stress for k in (-1, 1))
    assert ((b - a) / (2.0 * dp))[smooth] == pytest.approx(by_p[smooth], rel=1e-4, abs=1e-6)


def test_a_strip_without_pressure_carries_nothing() -> None:
    for law in LAWS.values():
        found = stresses(
            Law.of(law.compact()), np.full(5, 5e-9), np.full(5, 1e-3), np.full(5, -1.0)
        )
        assert np.all(np.array(found[:3]) == 0.0)
        assert np.all(found.slip == 1e-3)


@pytest.mark.parametrize("arc", [FABRIC, braking(FABRIC), replace(CORD, overrun=None)])
def test_an_even_belt_is_that_of_the_arc(arc: WrapArc) -> None:
    """Source: the static solver, a two-point problem of its own."""
    even = Distributed(capacities=False).solve(arc)
    found = solved(wide(arc, strips=4))
    g = found.entry_creep_ratio
    assert g == pytest.approx(np.full(4, even.entry_creep_ratio), rel=1e-6)
    assert found.exit_creep == pytest.approx(np.full(4, even.exit_creep), rel=1e-6)
    assert found.exit_slip == pytest.approx(np.full(4, even.exit_slip), rel=1e-6)
    energy = even.energy.frictional_energy
    assert found.frictional_energy == pytest.approx(np.full(4, energy), rel=1e-6)


def test_an_even_belt_to_more_digits() -> None:
    """Source: the static solver, on a finer mesh."""
    even = finer(FABRIC)
    slip = read(FABRIC.geometry(), even, Range(math.nan, math.nan, math.nan)).slip
    found = solved(wide(FABRIC, strips=4), 1e-9)
    assert found.exit_creep[0] == pytest.approx(even.course.creep[-1], rel=1e-8)
    assert found.exit_slip[0] == pytest.approx(slip, rel=1e-8)


ENDS = {
    "far": {},
    "gripping": {"length_before": 0.8, "length_after": 3.0},
    "endless": {"length_before": 5.0, "length_after": 1e9},
}


@pytest.mark.parametrize(
    ("number", "ends", "coupled"),
    [(1, "far", True), (6, "gripping", True), (3, "endless", False)],
)
def test_unlimited_friction_is_linear(number: int, ends: str, coupled: bool) -> None:
    """Source: a mode is two linear equations; their matrix exponential (and, for far spans, the
    closed form of the page on the width)."""
    n, a, e1, e2, f = 8, 0.3e-3, 2e-4, -1e-4, 4e3
    lengths: dict[str, Any] = {key: np.full(n - 1, value) for key, value in ENDS[ends].items()}
    arc = replace(FABRIC, law=UNLIMITED)
    shape = mode(number, n)
    given = wide(
        arc, n, radius_deviation=a * shape, entry_misfit=e1 * shape, exit_misfit=e2 * shape,
        entry_profile=f * shape, **lengths,
    )  # fmt: skip
    stiffness = 1e5 if coupled else 0.0
    given = replace(given, shear_stiffness=stiffness)
    found = solved(given, 1e-10)

    m, k = given.belt_modulus, arc.shear_modulus / arc.thickness
    wave = number * math.pi / arc.width
    soft = 1.0 / m + arc.thickness / (arc.radius**2 * arc.compression_modulus)
    s = stiffness * wave**2
    before, after = given.length_before[number - 1], given.length_after[number - 1]
    # (t, u, 1)' for a unit of t1 and for the constant
    ends_by = []
    for t1 in (0.0, 1.0):
        lag1 = e1 - before * (t1 - f) / m
        rate = np.array([[0.0, -k - s, -s * lag1], [-soft, 0.0, a / arc.radius], [0.0, 0.0, 0.0]])
        ends_by.append(expm(rate * arc.length) @ np.array([t1, 0.0, 1.0]))
    path = [e1 + e2 + y[1] + (before * (f - t1) - after * y[0]) / m
            for t1, y in zip((0.0, 1.0), ends_by, strict=True)]  # fmt: skip
    t1 = -path[0] / (path[1] - path[0])
    t2 = ends_by[0][0] + t1 * (ends_by[1][0] - ends_by[0][0])
    scale = abs(t1) + abs(t2)
    assert _mode(found.entry_tension, number) == pytest.approx(t1, abs=1e-8 * scale)
    assert _mode(found.exit_tension, number) == pytest.approx(t2, abs=1e-8 * scale)
    if ends == "far" and coupled:
        lam = before
        length = math.sqrt(1.0 / soft / (k + m / lam**2))
        q, r, mm = arc.length / length, length / lam, m * soft
        den = 1.0 - mm * r**2 + (1.0 + mm * r**2) * math.cosh(q) + (1.0 + mm) * r * math.sinh(q)
        crowned = wide(arc, n, radius_deviation=a * shape)
        alone = (math.cosh(q) - 1.0 + mm * r * math.sinh(q)) / den * a / (arc.radius * soft)
        assert _mode(solved(crowned, 1e-8).entry_tension, number) == pytest.approx(alone, rel=1e-6)


def _mode(values: Array, number: int) -> float:
    n = len(values)
    return float(mode(number, n) @ values) * 2.0 / n


def test_the_tension_at_the_very_edge() -> None:
    """Source: a linear profile far before, with no lag and without friction, is linear to the edge:
    f(B/2) = 0.2 of the mean, whatever the number of strips; and of a quadratic, by hand."""
    mean = 100e3
    for n in (4, 8, 32):
        y = (np.arange(n) + 0.5) / n - 0.5
        rows = mean * np.stack([1.0 + 0.4 * y, 1.0 + 0.1 * y, 1.0 - 0.4 * y])
        edges = to_the_edges(rows)
        assert edges[:, 0] == pytest.approx(mean * np.array([0.8, 0.95, 1.2]), rel=1e-12)
        assert edges[:, -1] == pytest.approx(mean * np.array([1.2, 1.05, 0.8]), rel=1e-12)
        assert edges[:, 1:-1] == pytest.approx(rows)
    assert to_the_edges(np.array([9.0, 4.0, 1.0, 0.0])).tolist() == [11.5, 9.0, 4.0, 1.0, 0.0, -0.5]
    # in a result: tightest is the edge of an uneven pull, and the strip beside it is told
    n = 8
    y = centres(FABRIC.width, n)
    profile = 0.4 * FABRIC.entry_tension / FABRIC.width * y / FABRIC.width
    found = solved(wide(FABRIC, n, entry_profile=profile))
    edge = 1.2 * FABRIC.entry_tension / FABRIC.width  # in the span, as it arrives
    assert found.largest_running_tension == pytest.approx(edge, rel=1e-9)
    assert found.largest_static_tension == pytest.approx(edge, rel=1e-9)
    strip = (1.0 + 0.4 * (0.5 - 0.5 / n)) * FABRIC.entry_tension / FABRIC.width
    assert found.tightest_strip_tension == pytest.approx(strip, rel=1e-9)


def test_without_shear_every_strip_is_a_belt_of_its_own() -> None:
    """Source: the static solver for each strip at its own tensions and drum number."""
    n = 6
    held = {"length_before": np.full(n - 1, 2.0), "length_after": np.full(n - 1, 1.5)}
    given = wide(FABRIC, n, 0.0, radius_deviation=crown(1e-3, n), entry_misfit=1e-4 * mode(1, n),
                 **held)  # fmt: skip
    found = solved(given, 1e-8)
    m, e = given.belt_modulus, given.entry_misfit
    rise = found.exit_creep - found.fields.creep[0]
    path = (2.0 * found.entry_tension + 1.5 * found.exit_tension) / m - rise - e
    assert np.ptp(path) < 1e-12
    for j in range(n):
        strip = replace(
            FABRIC,
            entry_tension=float(found.entry_tension[j]) * FABRIC.width,
            exit_tension=float(found.exit_tension[j]) * FABRIC.width,
        )
        even = Distributed(capacities=False).solve(strip)
        assert found.entry_creep_ratio[j] == pytest.approx(even.entry_creep_ratio, rel=1e-4)
        assert found.exit_creep[j] == pytest.approx(even.exit_creep, rel=1e-6)


def test_little_shear_comes_near_none() -> None:
    """Source: the same spans without shear; the distance falls as the shear."""
    n = 6
    held = {"length_before": np.full(n - 1, 2.0), "length_after": np.full(n - 1, 1.5)}
    tensions = [
        solved(wide(FABRIC, n, s, radius_deviation=crown(1e-3, n), **held)).entry_tension
        for s in (0.0, 100.0, 1000.0)
    ]
    near, far = (np.max(np.abs(t - tensions[0])) for t in tensions[1:])
    assert far / near == pytest.approx(10.0, rel=0.02)


def test_a_belt_that_does_not_shear() -> None:
    """Source: a_n M'/R inside, 1/(1 + sqrt(M'/M)) of it at both tangents, S to infinity."""
    arc = replace(FABRIC, law=UNLIMITED)
    given = wide(arc, 4, 2e9, radius_deviation=1e-4 * mode(1, 4))
    found = solved(given)
    soft = 1.0 / given.compliance[0]
    inside = soft * 1e-4 / arc.radius
    middle = int(np.searchsorted(found.angle, 0.5 * math.pi))
    assert _mode(found.fields.tension[middle], 1) == pytest.approx(inside, rel=0.02)
    tangent = inside / (1.0 + math.sqrt(soft / given.belt_modulus))
    assert _mode(found.entry_tension, 1) == pytest.approx(tangent, rel=0.02)
    assert _mode(found.exit_tension, 1) == pytest.approx(tangent, rel=0.02)


@pytest.mark.parametrize(("accuracy", "miss"), [(1e-6, 3e-4), (1e-7, 3e-5)])
def test_constant_friction_strip_by_strip(accuracy: float, miss: float) -> None:
    """Source: stick by shear lag, then Euler's law, at the tension and drum number of a strip.

    Where each strip begins to slip there is a kink inside an element.
    """
    n, mu = 6, 0.45
    arc = replace(FABRIC, law=Constant(friction_coefficient=mu))
    held = {"length_before": np.full(n - 1, 2.0), "length_after": np.full(n - 1, 1.5)}
    given = wide(arc, n, 0.0, radius_deviation=crown(0.4e-3, n), **held)
    found = solved(given, accuracy)
    c, deviation = arc.shear_compliance, np.ptp(found.exit_tension)
    for j in range(n):
        soft = 1.0 / given.compliance[j]
        free = soft * (found.drum_number + given.radius_deviation[j] / arc.radius)
        lag, over = math.sqrt(soft * c), free - found.entry_tension[j]

        def stick(s: float, free: float = free, over: float = over, lag: float = lag) -> float:
            t = free - over * math.cosh(s / lag)
            return over * math.sinh(s / lag) / lag - mu * t / arc.radius

        sj = brentq(stick, 0.0, arc.length, xtol=1e-14)
        tj = free - over * math.cosh(sj / lag)
        t2 = tj * math.exp(-mu * (arc.length - sj) / arc.radius)
        uj = c * mu * tj / arc.radius
        u2 = uj + free * (arc.length - sj) / soft - arc.radius * (tj - t2) / (mu * soft)
        assert found.exit_tension[j] == pytest.approx(t2, abs=miss * deviation)
        assert found.exit_creep[j] == pytest.approx(u2, rel=0.1 * miss)


CASES: list[tuple[str, WrapArc, float]] = [
    ("driving", FABRIC, 1e-9),
    ("braking", braking(FABRIC), 1e-9),
    ("idling", replace(FABRIC, exit_tension=149.9e3), 1e-9),
    ("overrun, no recovery", replace(CORD, overrun=None, recovery=False), 1e-9),
]


@pytest.mark.parametrize(("name", "arc", "miss"), CASES, ids=[c[0] for c in CASES])
def test_energy_forces_and_reading(name: str, arc: WrapArc, miss: float) -> None:
    """Source: exact balances: of energy (see the model), and T1 - T2 = int int tau."""
    n = 6
    more: dict[str, Any] = {"radius_deviation": crown(1e-3, n), "entry_misfit": 2e-4 * mode(1, n)}
    found = solved(wide(arc, n, **more), 1e-8)
    assert found.identity_error < miss
    pull, tight = arc.effective_tension, max(arc.entry_tension, arc.exit_tension)
    force = float(np.mean(found.friction_force)) * arc.width
    assert force == pytest.approx(pull, abs=1e-10 * tight)
    assert np.mean(found.exit_tension) * arc.width == pytest.approx(arc.exit_tension, rel=1e-10)
    # and by another rule than the solver's: Simpson's, in the variable of the places, s = L xi^4
    xi = (found.angle / arc.wrap_angle) ** 0.25
    even = np.min(np.abs(xi[:, None] - np.linspace(0.0, 1.0, 49)), axis=1) < 1e-9
    rate = 4.0 * arc.length * xi[even, None] ** 3 * found.fields.shear_stress[even]
    by_rule, largest = simpson(rate, x=xi[even], axis=0), np.max(np.abs(found.friction_force))
    assert by_rule == pytest.approx(found.friction_force, rel=2e-5, abs=2e-5 * float(largest))


def test_mirror_constants_and_scale() -> None:
    """Source: symmetries of the equations."""
    n = 8
    shape = 1e-3 * mode(1, n) + 0.5e-3 * mode(3, n)
    base = wide(FABRIC, n, radius_deviation=shape, exit_misfit=1e-4 * mode(2, n))
    found = solved(base)
    other = solved(replace(base, radius_deviation=shape[::-1]))
    assert other.entry_tension[::-1] == pytest.approx(found.entry_tension, rel=1e-12)
    moved = replace(base, radius_deviation=shape + 1e-3, exit_misfit=base.exit_misfit + 1e-3)
    assert solved(moved).exit_tension == pytest.approx(found.exit_tension, rel=1e-12)
    assert solved(moved).drum_number == pytest.approx(found.drum_number - 1e-3 / 0.4, rel=1e-12)
    double = replace(
        FABRIC, width=2.4, entry_tension=300e3, exit_tension=120e3,
        axial_stiffness=2.0 * FABRIC.axial_stiffness,
    )  # fmt: skip
    again = solved(wide(double, n, 4e5, radius_deviation=shape, exit_misfit=1e-4 * mode(2, n)))
    assert again.entry_tension == pytest.approx(found.entry_tension, rel=1e-12)
    assert again.exit_tension == pytest.approx(found.exit_tension, rel=1e-12)


@pytest.mark.parametrize("name", LAWS)
def test_every_law_is_solved(name: str) -> None:
    """Every law, jumps included; the balance of energy holds."""
    arc = braking(FABRIC) if name in ("power", "softening") else FABRIC
    loaded = replace(arc, law=LAWS[name], entry_tension=0.8 * arc.entry_tension + 30e3)
    found = solved(wide(loaded, 5, radius_deviation=crown(0.5e-3, 5)), 1e-7)
    assert found.identity_error < 3e-7
    assert found.iterations <= 18  # on five meshes at most


FAR: dict[str, WideArc] = {
    "rigid": wide(replace(FABRIC, thickness=0.0, compression_modulus=math.inf),
                  radius_deviation=crown(0.5e-3, 8)),
    "thin, constant friction": wide(
        replace(FABRIC, thickness=1e-4, law=Constant(friction_coefficient=0.6)),
        radius_deviation=crown(0.3e-3, 8),
    ),
    "hardly sheared": wide(CORD, 8, 1e9, radius_deviation=crown(0.2e-3, 8)),
    "long": wide(replace(FABRIC, wrap_angle=6.0), radius_deviation=crown(0.5e-3, 8)),
    "every other strip": wide(CORD, 32, radius_deviation=0.5e-3 * (-1.0) ** np.arange(32)),
    "idle": wide(replace(CORD, exit_tension=CORD.entry_tension), radius_deviation=crown(5e-4, 8)),
}  # fmt: skip


@pytest.mark.parametrize("name", FAR)
def test_far_from_what_is_usual(name: str) -> None:
    """Source: the balances of energy and forces, and the path of each mode, which closes."""
    given = FAR[name]
    found = solved(given)
    n, m, width = given.strips, given.belt_modulus, given.arc.width
    assert found.error_estimate < 1e-6
    assert found.identity_error < 1e-5
    tight = given.arc.entry_tension / width
    force = found.entry_tension - found.exit_tension - found.friction_force
    assert np.mean(force) == pytest.approx(0.0, abs=1e-9 * tight)
    rise = found.exit_creep - found.fields.creep[0]
    scale = float(np.max(np.abs(rise))) + given.arc.length * tight / m
    for k in range(1, n):
        t1, t2, u = (_mode(v, k) for v in (found.entry_tension, found.exit_tension, rise))
        before, after = given.length_before[k - 1], given.length_after[k - 1]
        assert u == pytest.approx((before * t1 + after * t2) / m, abs=1e-8 * scale)


def test_spans_to_a_pulley_that_grips() -> None:
    """Source: v'' = v/lambda^2 by exponentials; v = 0 at a pulley before, v' = 0 at one behind."""
    decay, d = np.array([4.3, 1.0, 0.2]), 1.5
    grip = GrippingPulley(distance=d)
    away, back = np.exp(d / decay), np.exp(-d / decay)
    assert length_before(decay, grip) == pytest.approx(decay * (away - back) / (away + back))
    assert length_after(decay, grip) == pytest.approx(decay * (away + back) / (away - back))
    assert length_before(decay, None) is decay
    assert length_after(decay, None) is decay
    stiff = np.array([1e6])  # hardly any shear: the length of the span, and no hold behind
    assert length_before(stiff, grip) == pytest.approx(d, rel=1e-9)
    assert length_after(stiff, grip) > 1e9


def test_what_makes_a_strip_slack_is_said() -> None:
    """A build-up of 30 mm on a quarter of the face; nothing is clipped."""
    n = 8
    found = AcrossSolver().solve(wide(FABRIC, n, radius_deviation=30e-3 * (np.arange(n) > 5)))
    assert found.status is AcrossStatus.SLACK
    assert found.slack is not None
    assert 0.1 < found.slack.share < 0.5
    assert found.slack.tension == found.least_tension < 0.0
    assert abs(found.slack.position) < 0.6
    # from that share of the heap on, and not before: nothing is left there
    at = found.slack.share
    less, more = (
        AcrossSolver().solve(wide(FABRIC, n, radius_deviation=30e-3 * share * (np.arange(n) > 5)))
        for share in (0.98 * at, 1.02 * at)
    )
    assert less.status is AcrossStatus.SOLVED
    assert more.status is AcrossStatus.SLACK
    assert less.least_tension < 0.02 * abs(found.slack.tension)
    assert less.position[int(np.argmin(np.min(less.fields.tension, 0)))] == found.slack.position


def test_the_least_tension_is_read_between_the_places_of_a_result() -> None:
    """Source: the same solution at ten thousand places; no place of its own is as low."""
    found = solved(wide(FABRIC, 8, radius_deviation=crown(15e-3, 8)))
    strip = int(np.argmin(np.min(found.fields.tension, axis=0)))
    at = int(np.argmin(found.fields.tension[:, strip]))
    assert 0 < at < len(found.angle) - 1
    system = System(found.wide, Elements(graded(FABRIC.length, 48), 4))
    again = newton(system, started(system, found.even))
    places = np.linspace(0.0, FABRIC.length, 10001)
    tension = along(again, places)[1][:, strip]
    assert found.least_tension == pytest.approx(float(np.min(tension)), rel=2e-6)
    place = float(places[np.argmin(tension)])
    assert found.angle[at] * FABRIC.radius == pytest.approx(place, abs=2e-3)
    others = np.delete(found.fields.tension[:, strip], at)
    assert float(np.min(others)) > 1.0005 * found.least_tension


def test_breakaway_is_that_of_the_even_belt() -> None:
    arc = replace(FABRIC, exit_tension=5e3, law=Constant(friction_coefficient=0.3))
    assert AcrossSolver().solve(wide(arc, 4)).status is AcrossStatus.BREAKAWAY


def test_the_extra_path_of_a_trough_is_that_of_its_corners() -> None:
    """Independent: the straight line from the wing of the last full trough to the pulley."""
    beta, length, centre, width = np.radians(35.0), 2.9, 0.465, 1.2
    z = 0.5 * (width - centre)
    edge = np.array([z * (1.0 - np.cos(beta)), z * np.sin(beta)])  # in and up, at its place
    for depth, raised in (("full", 0.0), ("half", 0.5 * edge[1])):
        trough = Transition(length=length, trough_angle=beta, centre_roll=centre, depth=depth)  # type: ignore[arg-type]
        line = np.hypot(length, np.hypot(edge[0], edge[1] - raised))
        found = extra_path(trough, np.array([-0.6, 0.0, 0.6]), width)
        assert found[[0, 2]] == pytest.approx(line / length - 1.0, rel=5e-3)  # small angles
        assert found[1] == pytest.approx(np.hypot(length, raised) / length - 1.0, abs=1e-5)
