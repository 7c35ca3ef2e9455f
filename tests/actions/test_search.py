"""The search alone, over drives that are formulas: creep = 10/(T2 grip), limits in closed form.

Expected: the least change by hand, in numbers of three digits.
"""

import math

import pytest

from wraparc.actions.score import is_allowed
from wraparc.actions.search import find_ways
from wraparc.actions.too_large import percent_too_large
from wraparc.actions.variant import (
    LAGGING,
    LOWER,
    RAISE,
    RATING,
    WRAP,
    Outcome,
    Task,
    Variant,
    at_rung,
    rounded_down,
    rounded_up,
    rung_above,
    rung_below,
)

GRIPS = {"": 1.0, "rough": 1.5, "rougher": 3.0}
CREEP, TENSION = "creep", "belt_tension"
T1_MINUS_T2 = 150.0


class World:
    """A drive by formulas: it creeps 1000/(T2 grip wrap/180) and carries T2 + 150 [N]."""

    def __init__(self, limit: float, rating: float, also: tuple[str, ...] = ()) -> None:
        self.limit, self.rating, self.also, self.asked = limit, rating, also, 0
        self.first = CREEP

    def governed_by(self, name: str) -> "World":
        self.first = name
        return self

    def judged(self, of: Variant) -> Outcome:
        self.asked += 1
        tension, wrap = of.tension or 50.0, of.wrap or 180.0
        creep = 1000.0 / (tension * GRIPS[of.lagging] * wrap / 180.0)
        tight = tension + T1_MINUS_T2 * (of.pull or 1.0)
        rating = of.rating or self.rating
        shares = {CREEP: creep / self.limit, TENSION: tight / rating}
        order = sorted(shares, key=lambda name: name != self.first)
        levels = {name: 2 for name in order if shares[name] > 1.0}
        levels |= dict.fromkeys(self.also, 2)
        passed = tuple(name for name in shares if name not in levels)
        return Outcome(True, levels, passed, shares, creep)

    def evaluate(self, variants: list[Variant]) -> list[Outcome]:
        return [self.judged(variant) for variant in variants]

    def task(self, *kinds: str, wrap: float = 180.0) -> Task:
        return Task(
            now=self.judged(Variant()), first=kinds, kinds=kinds, tension=50.0, lowest=2.0,
            highest=800.0, wrap=wrap, laggings=("rough", "rougher"), rating=self.rating,
            strength=0.0, diameter=1.0, spacing=0.0, points=12, wrap_step=10, splits=9, within=1,
        )  # fmt: skip

    def ways(self, *kinds: str) -> list[Variant]:
        found = find_ways(self.task(*kinds), self.evaluate, self.judged)
        return [way.variant for way in found.ways]


@pytest.mark.parametrize(
    ("value", "up", "down"),
    [(84.012e3, 84.1e3, 84.0e3), (1.0, 1.0, 1.0), (999.5, 1000.0, 999.0), (0.01234, 0.0124, 0.0123),
     (63e3, 63e3, 63e3), (63e3 * (1.0 + 1e-13), 63e3, 63e3)],
)  # fmt: skip
def test_numbers_of_three_digits(value: float, up: float, down: float) -> None:
    assert rounded_up(value) == pytest.approx(up, rel=1e-15)
    assert rounded_down(value) == pytest.approx(down, rel=1e-15)
    assert at_rung(rung_above(value) + 1) > at_rung(rung_above(value))
    assert rung_above(value) - rung_below(value) in (0, 1)


def test_the_first_two_that_hold_alone_are_offered_in_their_order() -> None:
    """Creep 20 over 16: T2 = 62.5, wrap = 225 deg, the first lagging."""
    assert World(16.0, 1e9).ways(RAISE, WRAP, LAGGING) == [
        Variant(tension=62.5),
        Variant(wrap=225.0),
    ]
    assert World(16.0, 1e9).ways(LAGGING, RAISE) == [
        Variant(lagging="rough"),
        Variant(tension=62.5),
    ]


def test_a_pair_is_tried_where_nothing_holds_alone() -> None:
    """Creep 20 over 14 takes 71.4 of T2 and wrap, and the rating leaves T2 at 55: 53.6 at least."""
    (way,) = World(14.0, 205.0).ways(RAISE, WRAP)
    creep = 1000.0 / (way.tension * way.wrap / 180.0)
    assert creep <= 14.0
    assert way.tension <= 55.0
    assert way.wrap <= 240.0


def test_three_together_hold_where_no_pair_does() -> None:
    """Creep 20 over 4.7 takes 4.26: 3 of lagging, 4/3 of wrap and 1.1 of T2 make 4.4."""
    world = World(4.7, 205.0)
    assert world.ways(RAISE, WRAP) == []
    (way,) = world.ways(RAISE, WRAP, LAGGING)
    assert way.lagging == "rougher"
    assert way.tension > 50.0
    assert world.judged(way).levels == {}
    assert world.ways(WRAP, LAGGING) == []


def test_none_after_which_a_check_fails_that_passed() -> None:
    """More tension keeps the creep, and then the belt fails its rating: not offered."""
    assert World(16.0, 205.0).ways(RAISE) == []


def test_the_way_that_leaves_fewest_is_offered_where_none_holds() -> None:
    world = World(16.0, 1e9, also=("crown",))
    found = find_ways(world.task(RAISE, WRAP), world.evaluate, world.judged)
    (way,) = found.ways
    assert way.variant == Variant(tension=62.5)
    assert way.score.left == 1


def test_no_way_is_offered_that_leaves_the_governing_check() -> None:
    """Creep 20 over 1 stays; a belt rated 200 passes a check that does not govern."""
    assert World(1.0, 199.0).ways(RATING) == []
    (way,) = World(1.0, 199.0).governed_by(TENSION).ways(RATING)
    assert way.rating >= 200.0


def test_a_belt_is_rated_for_the_tension_with_which_it_is_used() -> None:
    """Creep 20 over 10 takes T2 = 100, and that a belt rated 250."""
    (way,) = World(10.0, 190.0).ways(RAISE, RATING)
    assert way == Variant(tension=100.0, rating=250.0)


def test_less_tension_is_the_most_that_passes() -> None:
    """T2 + 150 within 180.7."""
    assert World(1e9, 180.7).ways(LOWER) == [Variant(tension=30.7)]


def test_the_tension_that_the_checks_state_is_offered_as_they_state_it() -> None:
    """A table has 64.2: no other number stands beside it, though 62.5 passes."""
    world = World(16.0, 1e9)
    task = world.task(RAISE)
    task = task._replace(now=task.now._replace(least=64.15))
    found = find_ways(task, world.evaluate, world.judged)
    assert [way.variant.tension for way in found.ways] == [64.2]


def test_what_is_not_confirmed_is_not_offered() -> None:
    world = World(16.0, 1e9)

    def doubts(variant: Variant) -> Outcome:
        return world.judged(variant._replace(tension=(variant.tension or 50.0) * 0.999))

    (way,) = find_ways(world.task(RAISE), world.evaluate, doubts).ways
    assert way.variant == Variant(tension=62.6)
    never = find_ways(world.task(RAISE), world.evaluate, lambda _: world.task(RAISE).now)
    assert never.ways == ()


def test_what_gross_slip_hides_is_no_news() -> None:
    """An arc without a state has no creep to be judged: that it creeps too much then is better."""
    slips = Outcome(True, {"gross_slip": 3}, ("belt_tension",))
    assert is_allowed(Outcome(True, {"creep": 2}, ("gross_slip",)), slips)
    assert not is_allowed(Outcome(True, {"belt_tension": 2}), slips)
    assert not is_allowed(Outcome(False, {}), slips)


def test_few_variants_are_judged_for_one_that_holds_alone() -> None:
    world = World(16.0, 1e9)
    world.ways(RAISE)
    assert world.asked < 60


def test_an_infinite_misfit_asks_for_no_belt() -> None:
    world = World(math.nan, 1.0)
    assert world.ways(RATING) == [Variant(rating=200.0)]


def test_by_how_many_percent_the_pull_is_too_large() -> None:
    """50 + 150/(1 + n) within 160: n = 36.4 %. No lagging, wrap or more tension helps a rating."""
    world = World(1e9, 160.0)
    task = world.task(RAISE, WRAP, LAGGING)
    assert percent_too_large(task, world.evaluate, TENSION, ()) == 37
    assert percent_too_large(task, World(1e9, 40.0).evaluate, TENSION, ()) == 0
