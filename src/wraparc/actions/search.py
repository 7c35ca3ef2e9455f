"""The search for what makes a verdict OK: a pure function over a judgement of variants.

One change alone first, then pairs, then three. It knows no solver and no NumPy: `evaluate` judges
many variants at once, by rows or one by one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import combinations
from math import inf, log
from typing import NamedTuple

from wraparc.actions.variant import (
    DIAMETER,
    LAGGING,
    LOWER,
    RAISE,
    RATING,
    SPACING,
    STRENGTH,
    WRAP,
    Outcome,
    Variant,
    at_rung,
    rounded_down,
    rounded_up,
    rung_above,
    rung_below,
)

Evaluate = Callable[[list[Variant]], list[Outcome]]
#: Checks that data are missing for: no change of the drive answers them, and none is held to them.
DATA_CHECKS = (
    "condition", "fit", "usual_sizes", "belt_thickness", "tested_slip_speed", "case_kind",
    "profile_extent", "reserve", "data", "sense",
)  # fmt: skip
#: Largest wrap that is offered, and the steps in which wraps are tried first [deg].
MOST_WRAP, WRAP_STEP = 240, 10
#: Most changes that are made together.
MOST_CHANGES = 3
#: Checks whose miss tells what belt, pulley or idlers would do.
_BY_SHARE: dict[str, tuple[str, ...]] = {
    RATING: ("belt_tension", "momentary_tension"),
    STRENGTH: ("belt_safety",),
    DIAMETER: (
        "tested_pressure_max", "face_pressure", "pulley_diameter", "uneven_pressure",
        "uneven_face_pressure",
    ),
    SPACING: ("sag",),
}  # fmt: skip


class Score(NamedTuple):
    """How much is left, the less the better: checks that are missed, and the worst level."""

    left: int
    level: int


class Task(NamedTuple):
    """What the search begins with.

    Attributes
    ----------
    now
        Outcome of the drive as it is.
    first, kinds
        What may be changed: for the governing check, and for any that is missed.
    tension, lowest, highest
        At the take-up: as it is, and within what it is tried [N].
    wrap
        Wrap angle of the only pulley, 0 where it is not to be changed [deg].
    laggings
        Names of the catalogue that are tried.
    rating, strength, diameter, spacing
        As they are; 0 where they are not known [N/m, N/m, m, m].
    points
        Tensions that are tried between the ends; 0 for those alone that the checks state.
    splits
        Values that are tried at once between one that leaves more and one that leaves as little.
    """

    now: Outcome
    first: tuple[str, ...]
    kinds: tuple[str, ...]
    tension: float
    lowest: float
    highest: float
    wrap: float
    laggings: tuple[str, ...]
    rating: float
    strength: float
    diameter: float
    spacing: float
    points: int
    splits: int


class Candidate(NamedTuple):
    """A variant with its outcome."""

    variant: Variant
    outcome: Outcome
    score: Score


class Found(NamedTuple):
    """What the search ends with.

    Attributes
    ----------
    ways
        Variants that are offered, the first first; empty where none betters the verdict.
    tried
        The best of every kind that was tried, whatever it leaves.
    """

    ways: tuple[Candidate, ...]
    tried: tuple[Candidate, ...]


def count_left(levels: Mapping[str, int]) -> int:
    """Return how many checks are missed that a change of the drive may answer."""
    return sum(name not in DATA_CHECKS for name in levels)


def score_of(outcome: Outcome) -> Score:
    """Return how much an outcome leaves; what gross slip or too much creep hides counts too."""
    names = [name for name in outcome.levels if name not in DATA_CHECKS]
    ranks = [outcome.levels[name] for name in names]
    slips = "operating_point" in names or "gross_slip" in names
    hidden = slips and "creep" not in names and "creep" not in outcome.passed
    dry = ("creep" in names or hidden) and "wet_creep" not in outcome.passed
    wet = dry and "wet_creep" not in names
    return Score(len(names) + hidden + wet, max(ranks, default=0))


def is_allowed(outcome: Outcome, now: Outcome) -> bool:
    """Return whether no check is missed that passed, and none is at a worse level."""
    if not outcome.possible:
        return False
    for name, rank in outcome.levels.items():
        if name in now.passed or rank > now.levels.get(name, inf):
            return False
    return True


def find_ways(
    task: Task, evaluate: Evaluate, confirm: Callable[[Variant], Outcome], most: int = 2
) -> Found:
    """Return the changes that make a verdict OK, or those that leave fewest checks missed.

    Parameters
    ----------
    task
        The drive as it is, and what may be changed.
    evaluate
        Judges variants.
    confirm
        Judges one as it is told: what it does not confirm is not offered.
    most
        Number of ways at most.
    """
    search = _Search(task, evaluate, confirm)
    before, tried = score_of(task.now), list[Candidate]()
    for size in range(1, MOST_CHANGES + 1):
        ways: list[Candidate] = []
        for kinds in _combinations(task, size):
            found = search.best(kinds)
            if found is None:
                continue
            tried.append(found)
            if found.score.left > 0:
                continue
            sure = search.confirmed(found)
            if sure is not None and sure.score.left == 0:
                ways.append(sure)
            if len(ways) == (most if size == 1 else 1):
                break
        if ways:
            return Found(tuple(ways), tuple(tried))
    for found in sorted(tried, key=lambda one: one.score):
        if found.score < before:
            sure = search.confirmed(found)
            if sure is not None and sure.score < before:
                return Found((sure,), tuple(tried))
    return Found((), tuple(tried))


def _combinations(task: Task, size: int) -> list[tuple[str, ...]]:
    """Return what is changed together, first what answers the governing check."""
    kinds = [*task.first, *(kind for kind in task.kinds if kind not in task.first)]
    every = combinations(kinds, size)
    return [some for some in every if not (RAISE in some and LOWER in some)]


class _Search:
    """The variants of one task, each judged once."""

    def __init__(
        self, task: Task, evaluate: Evaluate, confirm: Callable[[Variant], Outcome]
    ) -> None:
        self.task, self._evaluate, self._confirm = task, evaluate, confirm
        self._known: dict[Variant, Outcome] = {Variant(): task.now}

    def outcomes(self, variants: Sequence[Variant]) -> list[Outcome]:
        """Return the outcome of each variant."""
        new = [v for v in dict.fromkeys(variants) if v not in self._known]
        if new:
            self._known |= dict(zip(new, self._evaluate(new), strict=True))
        return [self._known[variant] for variant in variants]

    def best(self, kinds: tuple[str, ...]) -> Candidate | None:
        """Return the best variant that changes all of some kinds; None if none is allowed."""
        bases = self._bases(kinds)
        ways = [kind for kind in kinds if kind in (RAISE, LOWER)]
        if not ways:
            found = self._least(self._completed(bases, kinds))
            narrow = WRAP in kinds and found is not None
            return self._nearest_wrap(found, kinds) if narrow and found else found
        up = ways[0] == RAISE
        stated = [v for base in bases for v in self._stated(base, up)]
        known = self._least(self._completed(stated, kinds))
        if known is not None and known.score.left == 0:
            return known
        between = [v for base in bases for v in self._between(base, up)]
        found = self._least(self._completed([*stated, *between], kinds))
        if found is None or (known is not None and known.score <= found.score):
            return known  # the number that the table of minimum tensions has
        return self._nearest_tension(found, kinds, up)

    def confirmed(self, found: Candidate) -> Candidate | None:
        """Return a variant as it is confirmed, a rounded step further if that takes it."""
        for variant in _steps(found.variant, self.task):
            outcome = self._confirm(variant)
            score = score_of(outcome)
            if is_allowed(outcome, self.task.now) and score <= found.score:
                return Candidate(variant, outcome, score)
        return None

    def _bases(self, kinds: tuple[str, ...]) -> list[Variant]:
        """Return variants of lagging and wrap."""
        laggings = self.task.laggings if LAGGING in kinds else ("",)
        first = WRAP_STEP * (int(self.task.wrap * (1.0 + 1e-9)) // WRAP_STEP + 1)
        wraps = range(first, MOST_WRAP + 1, WRAP_STEP) if self.task.wrap > 0.0 else ()
        angles = [float(wrap) for wrap in wraps] if WRAP in kinds else [0.0]
        return [Variant(lagging=name, wrap=wrap) for name in laggings for wrap in angles]

    def _stated(self, base: Variant, up: bool) -> list[Variant]:
        """Return a variant at the tension that its checks state, if that is to be gone to."""
        stated = self.outcomes([base])[0].tension
        if not 0.0 < stated < inf or (stated > self.task.tension) != up:
            return []
        return [base._replace(tension=rounded_up(stated))]

    def _between(self, base: Variant, up: bool) -> list[Variant]:
        """Return a variant at tensions between that of now and the last one that is tried."""
        now, points = self.task.tension, self.task.points
        end = self.task.highest if up else self.task.lowest
        if not end > 0.0 or (end > now) != up:
            return []
        steps = [now * (end / now) ** (k / points) for k in range(1, points + 1)]
        places = [rung_above(t) if up else rung_below(t) for t in steps]
        return [base._replace(tension=at_rung(place)) for place in dict.fromkeys(places)]

    def _completed(self, variants: Sequence[Variant], kinds: tuple[str, ...]) -> list[Variant]:
        """Return variants with the belt, pulley and idlers that their misses ask for."""
        shares = [kind for kind in kinds if kind in _BY_SHARE]
        if not shares:
            return list(variants)
        found = []
        for variant, outcome in zip(variants, self.outcomes(variants), strict=True):
            complete: Variant | None = variant
            for kind in shares:
                over = max((outcome.used.get(name, 0.0) for name in _BY_SHARE[kind]), default=0.0)
                complete = None if complete is None else _with_share(complete, self.task, kind, over)
            if complete is not None:
                found.append(complete)
        return found

    def _least(self, variants: Sequence[Variant]) -> Candidate | None:
        """Return the variant that leaves least, of several the one that changes least."""
        found: Candidate | None = None
        for variant, outcome in zip(variants, self.outcomes(variants), strict=True):
            if not is_allowed(outcome, self.task.now):
                continue
            one = Candidate(variant, outcome, score_of(outcome))
            if found is None or self._order(one) < self._order(found):
                found = one
        return found

    def _order(self, of: Candidate) -> tuple[int, int, float]:
        return (*of.score, size_of(of.variant, self.task))

    def _nearest_tension(self, of: Candidate, kinds: tuple[str, ...], up: bool) -> Candidate:
        """Return the same at the tension nearest to that of now that leaves as little."""
        rung = rung_above if up else rung_below
        near, far = rung(self.task.tension), rung(of.variant.tension)
        return self._nearest(of, kinds, near, far, False)

    def _nearest_wrap(self, of: Candidate, kinds: tuple[str, ...]) -> Candidate:
        """Return the same at the smallest wrap that leaves as little."""
        near = max(int(self.task.wrap), int(of.variant.wrap) - WRAP_STEP)
        return self._nearest(of, kinds, near, int(of.variant.wrap), True)

    def _nearest(
        self, of: Candidate, kinds: tuple[str, ...], near: int, far: int, wrap: bool
    ) -> Candidate:
        """Narrow the place between one that leaves more and one that leaves as little."""
        while abs(far - near) > 1:
            step = max(1, abs(far - near) // (self.task.splits + 1))
            step = step if far > near else -step
            places = [*range(near + step, far, step)]
            bases = [_at(of.variant, float(p) if wrap else at_rung(p), wrap) for p in places]
            self.outcomes(bases)
            passing = far
            for place, base in zip(places, bases, strict=True):
                one = self._least(self._completed([base], kinds))
                if one is not None and one.score <= of.score:
                    of, passing = one, place
                    break
            near, far = (places[-1] if passing == far else passing - step), passing
        return of


def _at(variant: Variant, value: float, wrap: bool) -> Variant:
    """Return a variant with another wrap or tension, and nothing that follows from it."""
    base = Variant(tension=variant.tension, wrap=variant.wrap, lagging=variant.lagging)
    return base._replace(wrap=value) if wrap else base._replace(tension=value)


def _with_share(variant: Variant, task: Task, kind: str, over: float) -> Variant | None:
    """Return a variant with what carries so many times as much; None where none is to carry it."""
    if not 1.0 < over < inf:
        return None
    if kind == RATING:
        return variant._replace(rating=rounded_up(task.rating * over)) if task.rating else None
    if kind == STRENGTH:
        return variant._replace(strength=rounded_up(task.strength * over))
    if kind == DIAMETER:
        return variant._replace(diameter=rounded_up(task.diameter * over))
    return variant._replace(spacing=rounded_down(task.spacing / over)) if task.spacing else None


def _steps(variant: Variant, task: Task) -> list[Variant]:
    """Return a variant, and those one and two rounded steps further from the drive as it is."""
    found = [variant]
    for more in (1, 2):
        if variant.tension > task.tension:
            tension = at_rung(rung_above(variant.tension) + more)
            found.append(variant._replace(tension=tension))
        elif variant.tension > 0.0:
            tension = at_rung(rung_below(variant.tension) - more)
            found.append(variant._replace(tension=tension))
        elif 0.0 < variant.wrap <= MOST_WRAP - more:
            found.append(variant._replace(wrap=variant.wrap + more))
    return found


def size_of(variant: Variant, task: Task) -> float:
    """Return how much a variant changes: the sum of the logarithms of its ratios [-]."""
    pairs = (
        (variant.tension, task.tension), (variant.wrap, task.wrap), (variant.rating, task.rating),
        (variant.strength, task.strength), (variant.diameter, task.diameter),
        (variant.spacing, task.spacing),
    )  # fmt: skip
    return sum(abs(log(after / before)) for after, before in pairs if after > 0.0 < before)
