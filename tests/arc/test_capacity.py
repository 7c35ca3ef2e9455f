"""What the pulley could carry: three capacities, and the least slack-side tension.

Expected values: the definitions. A solve at the capacity must show the creep or slip it is the
capacity of; a scan over all creep ratios, by the independent twin, must find no larger one.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

from arc.drives import ARC, LAWS, RUBBER, SOFTENING, integral_log, random_arc
from arc.twin import Twin
from wraparc.arc import ArcResult, Capacities, Distributed, Status, WrapArc
from wraparc.files import load_lagging
from wraparc.friction import Constant, FrictionLaw

JUMPS = {"jump table", "constant", "power", "elastic-plastic"}
every_law = pytest.mark.parametrize("name", LAWS)
SIDES = [(name, side) for name in LAWS for side in (False, True)]
either_side = pytest.mark.parametrize("braking", [False, True])

#: falls soon and deeply: the largest ratio is reached at 16 mm of creep
BRITTLE = integral_log(0.8, 3e-3, -60.0, 0.5)


def solve(arc: WrapArc) -> ArcResult:
    return Distributed(capacities=False, points=18).solve(arc)


def capacities(arc: WrapArc) -> Capacities:
    result = Distributed(points=18).solve(arc)
    assert result.status is not Status.UNSOLVED
    return result.capacities


def drives(name: str, count: int, braking: bool) -> list[WrapArc]:
    """Random drives with a real pull, on one side."""
    rng = np.random.default_rng([7, sorted(LAWS).index(name)])
    found: list[WrapArc] = []
    while len(found) < count:
        arc = random_arc(LAWS[name], rng)
        ratio = max(arc.entry_tension, arc.exit_tension) / min(arc.entry_tension, arc.exit_tension)
        if (arc.side < 0) == braking and ratio > 1.01:
            # an overrun is refused where a law holds the belt against it, as at low tensions
            found.append(replace(arc, overrun=0.0) if name in JUMPS else arc)
    return found


def with_tensions(arc: WrapArc, tight: float, slack: float) -> WrapArc:
    entry, exit_ = (tight, slack) if arc.side > 0 else (slack, tight)
    return replace(arc, entry_tension=entry, exit_tension=exit_)


def tight_of(arc: WrapArc) -> float:
    return max(arc.entry_tension, arc.exit_tension)


def meets(arc: WrapArc, ratio: float, quantity: str, limit: float) -> bool:
    """Whether a quantity is at its limit to 1e-6 at a ratio, or to 1e-6 of that ratio.

    The tight side is held. Close to gross slip a little more of the ratio is a lot more creep.
    """
    tight = tight_of(arc)
    found: list[float] = []
    for share in (1 + 1e-6, 1.0, 1 - 1e-6):
        there = solve(with_tensions(arc, tight, tight / ratio * share))
        assert there.status is Status.SOLVED
        found.append(there.scalars()[quantity] * arc.side)
    return abs(found[1] / limit - 1.0) <= 1e-6 or found[0] < limit < found[2]


@pytest.mark.parametrize(("name", "braking"), SIDES)
def test_creep_limit_capacity_is_at_the_creep_limit(name: str, braking: bool) -> None:
    for arc in drives(name, 3, braking):
        c = capacities(arc)
        assert meets(arc, c.creep_limit_capacity, "exit_creep", arc.creep_limit)


def test_an_overrun_beyond_the_creep_limit_leaves_nothing_to_a_brake() -> None:
    """The belt may creep less than the overrun moves it the other way: the entry has to be tight.

    Expected: the definition, by a drive of these tensions, which creeps backwards by the limit.
    """
    arc = replace(
        ARC, law=RUBBER, overrun=2e-4, entry_tension=40e3, exit_tension=60e3, creep_limit=1e-5
    )
    carried = capacities(arc)
    driven = solve(replace(arc, entry_tension=60e3 / carried.creep_limit_capacity))
    assert carried.creep_limit_capacity < 1.0
    assert driven.exit_creep == pytest.approx(-1e-5, rel=1e-4)
    assert carried.equivalent_friction == carried.largest_effective_tension == 0.0


@pytest.mark.parametrize(
    ("name", "braking"), [side for side in SIDES if LAWS[side[0]].tested is not None]
)
def test_tested_slip_capacity_is_at_the_tested_slip(name: str, braking: bool) -> None:
    for arc in drives(name, 2, braking):
        c = capacities(arc)
        tested = arc.law.tested
        assert tested is not None
        assert meets(arc, c.tested_slip_capacity, "exit_slip", tested.slip_max)


@every_law
def test_margins_and_equivalent_friction(name: str) -> None:
    for arc in drives(name, 2, False) + drives(name, 2, True):
        result = Distributed(points=18).solve(arc)
        c = result.capacities
        ratio = max(arc.entry_tension / arc.exit_tension, arc.exit_tension / arc.entry_tension)
        assert c.creep_limit_margin == pytest.approx(c.creep_limit_capacity / ratio, rel=1e-14)
        assert c.extrapolated_gross_slip_margin == pytest.approx(
            c.gross_slip_capacity / ratio, rel=1e-14
        )
        mu = math.log(c.creep_limit_capacity) / arc.wrap_angle
        assert c.equivalent_friction == pytest.approx(mu, rel=1e-14)
        assert result.within_creep_limit == (c.creep_limit_margin >= 1)
        assert (result.status is Status.BREAKAWAY) == (c.extrapolated_gross_slip_margin < 1)
        assert c.creep_limit_capacity <= c.gross_slip_capacity * (1 + 1e-9)
        if arc.law.tested is None:
            assert math.isnan(c.tested_slip_capacity)
            assert math.isnan(c.tested_slip_margin)
        else:
            slip_margin = c.tested_slip_capacity / ratio
            assert c.tested_slip_margin == pytest.approx(slip_margin, rel=1e-14)


# --- least slack-side tension ------------------------------------------------------------------


def carries(arc: WrapArc, slack: float) -> bool:
    """Whether the pull of an arc is carried within the creep limit with that slack-side tension."""
    at = solve(with_tensions(arc, slack + abs(arc.effective_tension), slack))
    return at.within_creep_limit


@pytest.mark.parametrize(
    ("name", "braking"), [side for side in SIDES if not (side[1] and side[0] in JUMPS)]
)
def test_least_slack_tension_is_the_smallest_that_is_enough(name: str, braking: bool) -> None:
    for arc in drives(name, 2, braking):
        c, pull = capacities(arc), abs(arc.effective_tension)
        least = c.least_exit_tension
        if math.isnan(least):
            continue
        assert math.isnan(c.largest_effective_tension)
        at = solve(with_tensions(arc, least + pull, least))
        assert at.exit_creep * arc.side == pytest.approx(arc.creep_limit, rel=1e-6)
        tested = arc.law.tested
        assert tested is None or arc.wrap_pressure(least + pull) <= tested.pressure_max
        assert carries(arc, least * (1 + 1e-5))
        assert not any(carries(arc, least * f) for f in (1e-3, 0.1, 0.3, 0.6, 0.8, 0.95, 1 - 1e-5))


@pytest.mark.parametrize("braking", [False, True])
@pytest.mark.parametrize("law", [RUBBER, SOFTENING])
def test_the_largest_pull_where_no_slack_tension_is_enough(law: FrictionLaw, braking: bool) -> None:
    arc = replace(ARC, law=law, entry_tension=280e3, exit_tension=20e3, overrun=1e-5)
    if braking:
        arc = replace(arc, entry_tension=20e3, exit_tension=280e3)
    c = capacities(arc)
    assert math.isnan(c.least_exit_tension)
    top = 600e3 * arc.width * arc.radius  # tension at the highest tested pressure
    pulls = []
    for tight in np.geomspace(0.2 * top, top, 7):
        there = with_tensions(arc, float(tight), 0.9 * float(tight))
        pulls.append(float(tight) * (1 - 1 / capacities(there).creep_limit_capacity))
    assert max(pulls) < abs(arc.effective_tension)
    assert c.largest_effective_tension >= max(pulls) * (1 - 1e-7)
    assert c.largest_effective_tension == pytest.approx(max(pulls), rel=0.05)


# --- gross slip and breakaway ------------------------------------------------------------------


def largest_by_scan(arc: WrapArc) -> tuple[float, float]:
    """Largest ln(tight/slack) of a driving pulley over all entry creep ratios, and its creep."""
    twin = Twin(arc)

    def loss(log_g: float) -> float:
        return twin.integrate(math.exp(log_g)).log_tension

    grid = np.linspace(math.log(1e-6), 0.0, 24)
    i = int(np.argmin([loss(z) for z in grid]))
    bounds = (grid[max(i - 1, 0)], grid[min(i + 1, 23)])
    best = minimize_scalar(loss, bounds=bounds, method="bounded", options={"xatol": 1e-4})
    return -float(best.fun), twin.integrate(math.exp(float(best.x))).creep


def carried_by_what_is_left(arc: WrapArc) -> float:
    """ln(T1/T2) with the friction of a slip of a kilometre all along the arc."""
    area = arc.width * arc.radius

    def rates(_: float, q: NDArray[np.float64]) -> NDArray[np.float64]:
        return -np.atleast_1d(arc.law.friction(1e3, arc.entry_tension / area * math.exp(q[0])))

    found = solve_ivp(rates, (0.0, arc.wrap_angle), (0.0,), rtol=1e-11, atol=1e-12)
    return -float(found.y[0, -1])


@pytest.mark.parametrize("law", [BRITTLE, SOFTENING])
@pytest.mark.parametrize(("overrun", "tight"), [(0.0, 60e3), (2e-5, 200e3)])
def test_gross_slip_of_a_softening_law_is_the_largest_ratio_there_is(
    law: FrictionLaw, overrun: float, tight: float
) -> None:
    arc = replace(ARC, law=law, overrun=overrun, entry_tension=tight, exit_tension=0.7 * tight)
    ratio, creep = largest_by_scan(arc)
    left = carried_by_what_is_left(arc)
    c = capacities(arc)
    assert (left > ratio) == (law is SOFTENING)
    assert math.log(c.gross_slip_capacity) == pytest.approx(max(ratio, left), rel=1e-6)
    if left > ratio:  # the ratio rises all the way to that of the residual
        assert math.isinf(c.gross_slip_creep)
        assert 0.97 * left < ratio
    else:
        assert c.gross_slip_creep == pytest.approx(creep, rel=0.01)  # flat at the maximum
    # just below it the pulley carries, with less creep than there: the branch below the maximum
    below = solve(replace(arc, exit_tension=tight * math.exp(-0.9999 * ratio)))
    assert below.status is Status.SOLVED
    assert below.exit_creep < creep
    # just above it nothing carries
    most = 1.0001 * max(ratio, left)
    above = solve(replace(arc, exit_tension=tight * math.exp(-most)))
    assert above.status is Status.BREAKAWAY


def test_a_ratio_that_rises_all_the_way_is_that_of_the_residual() -> None:
    """Shipped ceramics: at an entry creep ratio of 1 it is not yet there."""
    ceramic = load_lagging("full-ceramic")
    arc = replace(
        ARC, law=ceramic.law, entry_tension=62660.0, exit_tension=26266.0, diameter=1.06511,
        wrap_angle=3.779106, width=1.606632, axial_stiffness=19654016.0 * 1.606632,
        thickness=17.9846e-3, compression_modulus=18.4e6, overrun=None,
    )  # fmt: skip
    at_rest = -Twin(arc).integrate(1.0).log_tension
    c = capacities(arc)
    left = carried_by_what_is_left(arc)
    assert math.log(c.gross_slip_capacity) == pytest.approx(left, rel=1e-7)
    assert left > at_rest > 0.98 * left
    assert math.isinf(c.gross_slip_creep)


def test_gross_slip_of_a_braking_softening_law() -> None:
    # the exit is held: the same ratio by a solve just below and none just above
    arc = replace(ARC, law=BRITTLE, entry_tension=100e3, exit_tension=150e3)
    ratio = capacities(arc).gross_slip_capacity
    below, above = (
        solve(replace(arc, entry_tension=150e3 / ratio**f)) for f in (1 - 1e-5, 1 + 1e-5)
    )
    assert below.status is Status.SOLVED
    assert above.status is Status.BREAKAWAY


def test_creep_limit_beyond_the_largest_ratio() -> None:
    # with a limit of 40 mm the belt breaks away first: the capacity is that of breaking away
    arc = replace(ARC, law=BRITTLE, exit_tension=140e3, creep_limit=40e-3)
    ratio, creep = largest_by_scan(arc)
    assert creep < 20e-3
    assert math.log(capacities(arc).creep_limit_capacity) == pytest.approx(ratio, rel=1e-6)


@every_law
def test_gross_slip_is_out_of_reach_but_approached(name: str) -> None:
    # a law that does not fall: no finite creep reaches its plateau everywhere
    for arc in drives(name, 2, False):
        c = capacities(arc)
        if arc.law.steepest_fall() < 0:
            continue
        assert c.gross_slip_creep == math.inf
        reached = -Twin(arc).integrate(0.5).log_tension
        assert reached < math.log(c.gross_slip_capacity) * (1 + 1e-9)
        assert reached == pytest.approx(math.log(c.gross_slip_capacity), rel=0.02)


@every_law
@either_side
def test_breakaway_is_an_answer(name: str, braking: bool) -> None:
    for arc in drives(name, 2, braking):
        gross = capacities(arc).gross_slip_capacity
        asked = with_tensions(arc, tight_of(arc), tight_of(arc) / (2 * gross))
        result = Distributed(points=18).solve(asked)
        assert result.status is Status.BREAKAWAY
        assert not result.within_creep_limit
        # the tensions are those asked for, and no state between them is told
        told = {name: value for name, value in result.scalars().items() if value == value}
        asked_for = {"entry_tension", "exit_tension", "tension_ratio", "effective_tension"}
        asked_for |= {"gross_slip_safety"}
        assert result.gross_slip_safety < 1.0
        assert told.keys() == asked_for | told.keys() & vars(result.capacities).keys()
        assert (result.entry_tension, result.exit_tension) == (
            asked.entry_tension, asked.exit_tension,
        )  # fmt: skip
        assert len(result.profile) == 0
        assert result.capacities.gross_slip_capacity == pytest.approx(gross, rel=1e-7)
        assert result.capacities.extrapolated_gross_slip_margin == pytest.approx(0.5, rel=1e-7)


def test_capacities_can_be_left_out() -> None:
    result = Distributed(capacities=False).solve(replace(ARC, law=Constant(friction_coefficient=1)))
    assert all(math.isnan(v) for v in vars(result.capacities).values())
