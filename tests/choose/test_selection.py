"""Selection against brute force: every design put together by hand and solved by `solve`."""

import itertools
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from choose.searches import CERAMIC, CORD, FABRIC, RUBBER, drive, search
from wraparc import Belt, InputError, Lagging, LoadCase, Tensions, solve
from wraparc.answer.choose_sheet import choose_sheet
from wraparc.answer.sheet import shown
from wraparc.arc.quantities import SOLVED
from wraparc.batch import BatchResult, Setting, row, solve_arcs
from wraparc.batch.arcs import Arcs
from wraparc.checks import Level, judge
from wraparc.choose import judged
from wraparc.choose import selection as selection_module
from wraparc.choose.belt_rating import least_belt
from wraparc.choose.ranking import front
from wraparc.choose.search import Limits
from wraparc.choose.selection import Selection, choose
from wraparc.drive.conditions import Condition
from wraparc.units import in_units


@pytest.fixture(scope="module")
def selection() -> Selection:
    return choose(search())


def by_hand(lagging: Lagging, belt: Belt, diameter: float, slack: float) -> tuple[float, float]:
    """Worst creep over load cases and conditions [m], and cost [EUR]; creep inf if it fails."""
    wet = replace(lagging, law=scaled_knots(lagging, 0.85))
    cost = 10.0 / {"diamond-rubber": 2.0, "full-ceramic": 10.0}[lagging.name]
    cost *= {"diamond-rubber": 4600.0, "full-ceramic": 8600.0}[lagging.name]
    cost *= math.pi * diameter * 1.2 / 6.0
    cost += {"fabric": 50e3, "cord": 90e3}[belt.name]
    worst = 0.0
    for surface in (lagging, wet):
        base = drive()
        pulley = replace(base.pulleys[0], diameter=diameter, lagging=surface)
        cases = (
            LoadCase(name="full", tensions={"head": Tensions(entry=slack + 75e3, exit=slack)}),
            LoadCase(name="brake", tensions={"head": Tensions(entry=slack - 15e3, exit=slack)}),
        )
        result = solve(
            replace(base, belt=belt, pulleys=(pulley,), load_cases=cases), raise_on_failure=False
        )
        worst = max([worst, *(abs(r.exit_creep) if r.status.solved else math.inf for r in result)])
        if surface is lagging:
            cost += result.arcs[0].energy.power_loss / 1e3 * 5000 * 10 * 0.2
    return worst, cost


def scaled_knots(lagging: Lagging, factor: float) -> Any:
    law: Any = lagging.law
    c = law.coefficients
    columns = ("peak_friction", "post_peak_slope", "residual_friction")
    new = {k: tuple(factor * v for v in getattr(c, k)) for k in columns}
    return replace(law, coefficients=replace(c, **new))


def test_ranking_costs_and_creeps_equal_brute_force(selection: Selection) -> None:
    expected = []
    designs = itertools.product((RUBBER, CERAMIC), (FABRIC, CORD), (0.7, 0.9), (45e3, 60e3))
    for i, (lagging, belt, diameter, slack) in enumerate(designs):
        creep, cost = by_hand(lagging, belt, diameter, slack)
        assert selection.creep[i] == pytest.approx(creep, rel=1e-6)
        assert selection.costs.total[i] == pytest.approx(cost, rel=1e-6)
        keeps_creep = creep <= 6.35e-3
        keeps_belt = (slack + 75e3) / 1.2 <= belt.rating  # type: ignore[operator]
        keeps_pulley = belt is FABRIC or diameter >= 0.8
        if keeps_creep and keeps_belt and keeps_pulley:
            expected.append((cost, i))
        said = {n for n in ("creep", "belt_tension", "pulley_diameter") if n in selection.broken(i)}
        truth = {
            name
            for name, kept in (
                ("creep", keeps_creep),
                ("belt_tension", keeps_belt),
                ("pulley_diameter", keeps_pulley),
            )
            if not kept
        }
        assert said == truth, i
    assert 1 < len(expected) < 16
    # 45 and 60 kN of one lagging, belt and diameter are neighbours: the first feasible of each two
    # stands for both, and all keep the least of CEMA (0.50 of 75 kN)
    good = {i for _, i in expected}
    first = {i for i in good if i % 2 == 0 or i - 1 not in good}
    order = sorted(expected, key=lambda found: (found[1] not in first, found[0]))
    assert selection.ranking.tolist() == [i for _, i in order]


def test_less_wrap_and_tension_is_recommended_and_never_below_the_standard() -> None:
    """Expected: CEMA's printed Cw of 0.50 and 0.38 on rubber, times 20 kN: 10 and 7.6 kN."""
    of = search(
        drive=replace(drive(), load_cases=drive(95e3, 75e3).load_cases[:1]),
        belts=(FABRIC,), laggings=(RUBBER,), diameters=(0.8,),
        slack_tensions=(8e3, 9e3, 75e3), wrap_angles=(math.pi, math.radians(210.0)),
        limits=Limits(tested_pressure=False),
    )  # fmt: skip
    found = choose(replace(of, conditions=of.conditions[:1]))
    names = [(int(w), int(t)) for w, t in found.grid.places[4:].T]  # wrap, tension
    ranked = [names[i] for i in found.ranking]
    # 180 deg keeps the 10 kN with 75 kN alone, 210 deg its 7.6 kN with all
    assert ranked[0] == (0, 2)
    assert set(ranked[:4]) == {(0, 2), (1, 0), (1, 1), (1, 2)}
    assert set(ranked) == set(names)
    assert found.costs.total[found.ranking[0]] > min(found.costs.total[found.ranking])


def test_an_excess_is_the_value_over_its_limit(selection: Selection) -> None:
    """Design 4, rubber on cord with 0.7 m, breaks the cord's least pulley of 0.8 m by 12.5 %."""
    least = selection.standings["pulley_diameter"]
    assert (least.value[4], least.limit[4]) == (0.7, 0.8)
    assert least.excess[4] == pytest.approx(0.125)
    creep = selection.standings["creep"]
    assert np.allclose(creep.excess, selection.creep / 6.35e-3 - 1.0)


def test_the_worst_place_is_told(selection: Selection) -> None:
    """Wet is worse than dry, and the full belt worse than braking with a fifth of its pull."""
    where = selection.standings["creep"].where
    assert {selection.place(w) for w in where.tolist()} == {("head", "full", "wet")}


def test_the_fronts_hold_what_nothing_beats(selection: Selection) -> None:
    for chosen, other in (
        (selection.creep_front, selection.creep),
        (selection.slack_front, selection.slack_tension),
    ):
        cost = selection.costs.total
        truth = [
            i
            for i in sorted(selection.ranking, key=lambda i: cost[i])
            if not any(
                cost[j] <= cost[i]
                and other[j] <= other[i]
                and (cost[j], other[j]) != (cost[i], other[i])
                for j in selection.ranking
            )
        ]
        assert chosen.tolist() == truth


def test_front_of_made_up_numbers() -> None:
    ranking = np.arange(5)
    other = np.array([5.0, 5.0, 6.0, 2.0, 3.0])
    assert front(ranking, np.arange(5.0), other).tolist() == [0, 3]


#: What stands in the place of the solver, for large searches: creep D T1/T2 in mm.
RIGID_CREEP = 1e-3


class MadeUp(BatchResult):
    """A result with 1 kW m/D lost."""

    def __getitem__(self, name: str) -> Any:
        return 1e3 / self.arcs.diameter if name == "power_loss" else super().__getitem__(name)


@pytest.fixture
def made_up(monkeypatch: pytest.MonkeyPatch) -> None:
    def solved(arcs: Arcs, **_: Any) -> BatchResult:
        found = np.zeros((len(arcs), row.FOUND_NUMBERS))
        found[:, row.OUTCOME] = SOLVED
        found[:, row.EXIT_CREEP] = RIGID_CREEP * arcs.entry_tension / arcs.exit_tension
        found[:, row.EXIT_CREEP] *= arcs.diameter
        return MadeUp(arcs, found)

    monkeypatch.setattr(judged, "solve_arcs", solved)


@pytest.mark.usefixtures("made_up")
def test_a_large_search_equals_a_loop_and_its_best_beats_its_neighbours() -> None:
    diameters = tuple(np.linspace(0.5, 1.5, 11))
    slack = tuple(np.linspace(30e3, 90e3, 31))
    limits = Limits(gross_slip_safety=1e-6)
    found = choose(search(diameters=diameters, slack_tensions=slack, limits=limits))
    best, truth = math.inf, -1
    for i, (lag, belt, d, t) in enumerate(
        itertools.product((RUBBER, CERAMIC), (FABRIC, CORD), diameters, slack)
    ):
        kept = max(t + 75e3, t + 15e3) / t * d * 1e-3 <= 6.35e-3 and (t + 75e3) / 1.2 <= belt.rating
        kept &= belt is FABRIC or d >= 0.8
        pressure = lag.law.tested
        assert pressure is not None
        kept &= 2 * (t + 75e3) / (1.2 * d) <= pressure.pressure_max
        kept &= 2 * t / (1.2 * d) >= pressure.pressure_min
        each, times = (4600.0, 5) if lag is RUBBER else (8600.0, 1)
        cost = each * math.pi * d * 1.2 / 6.0 * times + 1.0 / d * 10_000
        cost += 50e3 if belt is FABRIC else 90e3
        if kept and cost < best:
            best, truth = cost, i
    assert found.costs.total[truth] == pytest.approx(best)
    assert found.costs.total[found.ranking[0]] == pytest.approx(best)
    place = found.grid.places[:, found.ranking[0]]
    for kind in range(6):
        for step in (-1, 1):
            near = place.copy()
            near[kind] += step
            if 0 <= near[kind] < found.search.shape[kind]:
                i = int(np.ravel_multi_index(tuple(near), found.search.shape))
                assert not found.feasible[i] or found.costs.total[i] >= best * (1 - 1e-12)


def test_engineering_accuracy_decides_as_precision_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """Expected: the same search with every design solved at the accuracy of one arc."""
    many = search(
        diameters=tuple(np.linspace(0.6, 1.2, 7)),
        slack_tensions=tuple(np.linspace(30e3, 90e3, 25)),
        limits=Limits(bond_stress=4e5),
        drive=replace(drive(), load_cases=drive().load_cases[:1]),
    )
    precise = choose(many)
    monkeypatch.setattr(selection_module, "MOST_PRECISE", 0)
    asked: list[Setting] = []

    def watched(*args: Any, setting: Setting, **options: Any) -> Any:
        asked.append(setting)
        return solve_arcs(*args, setting=setting, **options)

    monkeypatch.setattr(judged, "solve_arcs", watched)
    quick = choose(many)
    assert set(asked) == set(Setting)
    np.testing.assert_array_equal(quick.feasible, precise.feasible)
    assert 200 < len(quick.ranking) < len(many)
    np.testing.assert_array_equal(quick.ranking[:100], precise.ranking[:100])
    np.testing.assert_allclose(quick.costs.total, precise.costs.total, rtol=1e-4)
    assert not np.array_equal(quick.creep, precise.creep)  # it was the other accuracy


def test_the_least_slack_tension_just_meets_the_creep_limit_in_the_worst_case() -> None:
    found = choose(search(slack_tensions=(), diameters=(0.8,), belts=(FABRIC,)))
    assert found.slack_tension[0] > 55e3
    assert found.creep[0] == pytest.approx(6.35e-3, rel=1e-6)
    less = replace(found.search, slack_tensions=(float(found.slack_tension[0]) * 0.999,))
    assert "creep" in choose(less).broken(0)


def test_the_least_slack_tension_keeps_the_tested_pressure() -> None:
    """Of a light pull the lowest tested pressure, 34 kPa, asks for p B D/2 = 16.32 kN."""
    from wraparc.choose.search import Limits

    one = search(
        slack_tensions=(), diameters=(0.8,), belts=(FABRIC,), limits=Limits(creep=0.05),
        laggings=(CERAMIC,), drive=drive(40e3, 25e3),
    )  # fmt: skip
    assert choose(one).slack_tension[0] == pytest.approx(34e3 * 1.2 * 0.8 / 2 + 15e3)


@pytest.mark.parametrize(
    ("changes", "name", "level", "cheapest"),
    [
        ({}, "", Level.OK, "full-ceramic with T2 20 kN"),
        ({"fatigue_limit": 20e3}, "wet_creep", Level.ATTENTION, "diamond-rubber with T2 20 kN"),
        ({"least": 1.0}, "pulley_diameter", Level.FAILS, "full-ceramic with T2 20 kN"),
    ],
)
def test_what_is_recommended_is_judged_as_solve_does(
    changes: dict[str, float], name: str, level: Level, cheapest: str
) -> None:
    # expected: the checks of the same drive, put together by hand and judged
    limit = changes.get("fatigue_limit")
    lagging = replace(CERAMIC, fatigue_limit=limit)
    belt = replace(FABRIC, least_pulley_diameter=changes.get("least"))
    # two load cases, each with a slack-side tension of its own
    full = drive(145e3, 70e3).load_cases[0]
    light = LoadCase(name="light", tensions={"head": Tensions(entry=40e3, exit=20e3)})
    whole = replace(drive(), load_cases=(full, light))
    found = choose(
        search(
            laggings=(RUBBER, lagging), belts=(belt,), diameters=(0.8,), slack_tensions=None,
            drive=whole, conditions=(Condition(name="dry"),),
            limits=Limits(least_pulley_diameter=False),
        )
    )  # fmt: skip
    chosen = found.search.laggings[found.grid.places[0, found.ranking[0]]]
    pulley = replace(whole.pulleys[0], lagging=chosen)
    by_hand = judge(solve(replace(whole, belt=belt, pulleys=(pulley,))))
    missed = [in_units(c.text) for c in by_hand.missed]
    assert [in_units(c.text) for c in found.verdict.missed] == missed
    assert [c.name for c in by_hand.missed][:1] == [name][: len(by_hand.missed)]
    told = shown(choose_sheet(found), "si").verdict
    assert told is not None
    assert told.level is level
    assert told.text.startswith(f"Lowest cost: {cheapest}, ")
    assert [other.text for other in told.also] == missed


def test_a_lighter_belt_is_solved_with_its_own_modulus() -> None:
    found = choose(
        search(
            laggings=(CERAMIC,),
            diameters=(0.9,),
            belts=(FABRIC,),
            slack_tensions=(),
            drive=replace(drive(), load_cases=drive().load_cases[:1]),
        )
    )
    soft = Belt(name="soft", width=1.2, modulus=6e6, rating=120e3, speed=3.0)
    weak = Belt(name="weak", width=1.2, modulus=6e6, rating=50e3, speed=3.0)
    lighter = least_belt(found, int(found.ranking[0]), (FABRIC, weak, soft))
    assert lighter is not None
    assert lighter.belt.name == "soft"
    assert lighter.slack_tension > found.slack_tension[0]


@pytest.mark.usefixtures("made_up")
def test_the_next_dearer_lagging_is_dearer_to_buy() -> None:
    found = choose(search(diameters=(0.9,), belts=(FABRIC,), slack_tensions=(70e3,)))
    assert found.next_dearer() is None  # the ceramic, dearer to buy, is cheaper over ten years
    short = choose(replace(found.search, costing=replace(found.search.costing, years=2.0)))
    assert short.ranking[0] == 0
    assert short.next_dearer() == 1


@pytest.mark.usefixtures("made_up")
def test_the_nearest_of_infeasible_designs_is_told() -> None:
    from wraparc.choose.search import Limits

    found = choose(search(limits=Limits(creep=1e-4)))
    assert len(found.ranking) == 0
    worst = np.max([np.where(h.broken, h.excess, 0.0) for h in found.standings.values()], axis=0)
    assert worst[found.nearest()] == worst.min()
    assert "creep" in found.broken(found.nearest())


def test_a_belt_without_cost_is_refused_and_a_lagging_is_left_out() -> None:
    from wraparc.choose.cost import Costing

    with pytest.raises(InputError) as raised:
        search(costing=Costing(currency="EUR"))
    text = str(raised.value)
    assert "lagging" not in text
    assert 'belt "cord" has no cost' in text
    free = search(costing=replace(search().costing, laggings={}))
    assert free.unpriced == {"diamond-rubber": "", "full-ceramic": ""}
    found = choose(free)
    assert np.isnan(found.costs.lagging).all()
    assert found.costs.total == pytest.approx(found.costs.belt + found.costs.energy)
    assert found.next_dearer() is None
