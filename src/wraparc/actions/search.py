"""The search for what makes a verdict OK: a pure function over a judgement of variants.

One change alone first, then pairs, then three; of as many the first that is no large one. It knows
no solver and no NumPy: `evaluate` judges many variants at once, by rows or one by one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import inf, log
from typing import NamedTuple

from wraparc.actions.score import Score, answers_first, is_allowed, score_of
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
    Task,
    Variant,
    at_rung,
    key_of,
    rounded_down,
    rounded_up,
    rung_above,
    rung_below,
)

Evaluate = Callable[[list[Variant]], list[Outcome]]
#: Largest wrap that is offered [deg].
MOST_WRAP = 240
#: Most changes that are made together.
MOST_CHANGES = 3
#: Most variants of some kinds of changes that get the belt, pulley or idlers they ask for.
MOST_COMPLETED = 16
#: What the size of a change counts against one check that is left: less than any.
_SIZE = 1e-3
#: What changes by more in all, as by a factor of two, is offered where nothing changes less.
_LARGE = log(2.0)
#: Parts of the step to the first tension that is not allowed, in which the last is looked for.
EDGE_POINTS = 12
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


class Candidate(NamedTuple):
    """A variant that changes some kinds, with its outcome."""

    variant: Variant
    outcome: Outcome
    score: Score
    kinds: tuple[str, ...] = ()


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


def find_ways(
    task: Task, evaluate: Evaluate, confirm: Callable[[Variant], Outcome], most: int = 2
) -> Found:
    """Return the changes that make a verdict OK, or else the one that leaves fewest checks missed.

    Parameters
    ----------
    task
        The drive as it is, and what may be changed.
    evaluate
        Judges variants.
    confirm
        Judges one as it is told: what it does not confirm is not offered. What leaves checks
        missed is offered where it answers the governing one.
    most
        Number of ways at most.
    """
    search = _Search(task, evaluate, confirm)
    before, tried = score_of(task.now), list[Candidate]()
    for size in range(1, MOST_CHANGES + 1):
        ways: list[Candidate] = []
        enough = most if size == 1 else 1
        together = _combinations(task, size)
        if size == MOST_CHANGES:
            search.coarsen()
        search.prepare(together)
        for kinds in together:
            found = search.best(kinds)
            if found is None:
                continue
            tried.append(found)
            sure = search.confirmed(found, kinds) if found.score.left == 0 else None
            if sure is not None and sure.score.left == 0:
                ways.append(sure)
            if sum(not _is_large(way, task) for way in ways) == enough:
                break
        if ways:
            ways.sort(key=lambda way: _is_large(way, task))
            return Found(tuple(ways[:enough]), tuple(tried))
    partial = [one for one in tried if answers_first(one.outcome, task.now)]
    for found in sorted(partial, key=lambda one: one.score.weight):
        sure = search.confirmed(found, found.kinds) if found.score.weight < before.weight else None
        if sure is not None and sure.score.weight < before.weight:
            return Found((sure,), tuple(tried))
    return Found((), tuple(tried))


def _combinations(task: Task, size: int) -> list[tuple[str, ...]]:
    """Return what is changed together, first what answers the governing check."""
    kinds = [*task.first, *(kind for kind in task.kinds if kind not in task.first)]
    every: list[tuple[str, ...]] = [()]
    for _ in range(size):
        every = [
            (*some, kind)
            for some in every
            for kind in kinds[kinds.index(some[-1]) + 1 if some else 0 :]
        ]
    return [some for some in every if not (RAISE in some and LOWER in some)]


class _Search:
    """The variants of one task, each judged once."""

    def __init__(
        self, task: Task, evaluate: Evaluate, confirm: Callable[[Variant], Outcome]
    ) -> None:
        self.task, self._evaluate, self._confirm = task, evaluate, confirm
        self._known: dict[str, Outcome] = {key_of(Variant()): task.now}

    def coarsen(self) -> None:
        """Try fewer tensions and wraps first, where these are many together."""
        points, step = (self.task.points + 1) // 2, 2 * self.task.wrap_step
        self.task = self.task._replace(points=points, wrap_step=step)

    def outcomes(self, variants: Sequence[Variant]) -> list[Outcome]:
        """Return the outcome of each variant."""
        keys = [key_of(variant) for variant in variants]
        every = zip(keys, variants, strict=True)
        new = {key: variant for key, variant in every if key not in self._known}
        if new:
            for key, outcome in zip(new, self._evaluate([*new.values()]), strict=True):
                self._known[key] = outcome
        return [self._known[key] for key in keys]

    def prepare(self, every: Sequence[tuple[str, ...]]) -> None:
        """Judge what is tried first of several kinds of changes, all at once."""
        if self.task.splits < 2:
            return  # one by one: only what is needed
        first = [(kinds, self._first(kinds)) for kinds in every]
        self.outcomes([variant for _, variants in first for variant in variants])
        more = [v for kinds, variants in first for v in self._completed(variants, kinds)]
        self.outcomes(more)

    def _first(self, kinds: tuple[str, ...]) -> list[Variant]:
        """Return what is tried first of some kinds of changes, but for the stated tensions."""
        bases, ways = self._bases(kinds), [kind for kind in kinds if kind in (RAISE, LOWER)]
        if not ways:
            return bases
        return [*bases, *(v for base in bases for v in self._between(base, ways[0] == RAISE))]

    def best(self, kinds: tuple[str, ...]) -> Candidate | None:
        """Return the best variant that changes all of some kinds; None if none is allowed."""
        bases, ways = self._bases(kinds), [kind for kind in kinds if kind in (RAISE, LOWER)]
        if not ways:
            return self._least(bases, kinds)
        up = ways[0] == RAISE
        stated = [v for base in bases for v in self._stated(base, up)]
        known = self._least(stated, kinds)
        if known is not None and known.score.left == 0:
            return known
        between = [self._between(base, up) for base in bases]
        found = self._least([v for variants in between for v in variants], kinds)
        if found is None or found.score.left > 0:
            edges = [v for variants in between for v in self._at_edge(variants, kinds, up)]
            last = self._least(edges, kinds)
            if found is None or (last is not None and last.score.weight < found.score.weight):
                found = last
        if found is None or (known is not None and known.score.weight <= found.score.weight):
            return known  # the number that the table of minimum tensions has
        return found

    def confirmed(self, found: Candidate, kinds: tuple[str, ...]) -> Candidate | None:
        """Return a variant at the least change that leaves as little, as it is confirmed."""
        found = self._nearest(found, kinds)
        for variant in _steps(found.variant, self.task):
            outcome = self._confirm(variant)
            score = score_of(outcome)
            if is_allowed(outcome, self.task.now) and score.weight <= found.score.weight:
                return Candidate(variant, outcome, score, kinds)
        return None

    def _bases(self, kinds: tuple[str, ...]) -> list[Variant]:
        """Return variants of lagging and wrap."""
        laggings = self.task.laggings if LAGGING in kinds else ("",)
        step = self.task.wrap_step
        first = step * (int(self.task.wrap * (1.0 + 1e-9)) // step + 1)
        count = (MOST_WRAP - first) // step + 1 if self.task.wrap > 0.0 else 0
        angles = [float(first + step * k) for k in range(count)] if WRAP in kinds else [0.0]
        return [Variant(lagging=name, wrap=wrap) for name in laggings for wrap in angles]

    def _stated(self, base: Variant, up: bool) -> list[Variant]:
        """Return a variant at the tension that its checks state, if that is to be gone to."""
        outcome = self.outcomes([base])[0]
        stated = outcome.least if up else outcome.most
        if not 0.0 < stated <= self.task.highest or (stated > self.task.tension) != up:
            return []
        return [base._replace(tension=rounded_up(stated) if up else rounded_down(stated))]

    def _between(self, base: Variant, up: bool) -> list[Variant]:
        """Return a variant at tensions between that of now and the last one that is tried."""
        now, points = self.task.tension, self.task.points
        end = self.task.highest if up else self.task.lowest
        if not end > 0.0 or (end > now) != up:
            return []
        steps = [now * (end / now) ** (k / points) for k in range(1, points + 1)]
        places = [rung_above(t) if up else rung_below(t) for t in steps]
        return [base._replace(tension=at_rung(place)) for place in dict.fromkeys(places)]

    def _at_edge(
        self, variants: Sequence[Variant], kinds: tuple[str, ...], up: bool
    ) -> list[Variant]:
        """Return more tensions between the last that is allowed and the first that is not."""
        task, before = self.task, self.task.tension
        if task.splits < 2:
            return []
        self.outcomes([v for variant in variants for v in self._completed([variant], kinds)])
        for variant in variants:
            if self._least([variant], kinds) is None:
                ratio, rung = variant.tension / before, rung_above if up else rung_below
                steps = (before * ratio ** (k / EDGE_POINTS) for k in range(1, EDGE_POINTS))
                places = dict.fromkeys(map(rung, steps))
                return [variant._replace(tension=at_rung(place)) for place in places]
            before = variant.tension
        return []

    def _completed(self, variants: Sequence[Variant], kinds: tuple[str, ...]) -> list[Variant]:
        """Return variants with the belt, pulley and idlers that their misses ask for.

        Of many those that promise most.
        """
        shares = [kind for kind in kinds if kind in _BY_SHARE]
        if not shares:
            return list(variants)
        answered = [name for kind in shares for name in _BY_SHARE[kind]]
        found: list[tuple[float, Variant]] = []
        for variant, outcome in zip(variants, self.outcomes(variants), strict=True):
            complete: Variant | None = variant
            for kind in shares:
                over = max((outcome.used.get(name, 0.0) for name in _BY_SHARE[kind]), default=0.0)
                complete = complete and _with_share(complete, self.task, kind, over)
            levels = {n: rank for n, rank in outcome.levels.items() if n not in answered}
            then = outcome._replace(levels=levels)
            if complete is not None and is_allowed(then, self.task.now):
                found.append((self._order(complete, score_of(then)), complete))
        found.sort(key=lambda one: one[0])
        return [variant for _, variant in found[:MOST_COMPLETED]]

    def _least(self, variants: Sequence[Variant], kinds: tuple[str, ...]) -> Candidate | None:
        """Return the variant that leaves least, of several the one that changes least."""
        found: Candidate | None = None
        least, complete = inf, self._completed(variants, kinds)
        for variant, outcome in zip(complete, self.outcomes(complete), strict=True):
            if not is_allowed(outcome, self.task.now):
                continue
            one = Candidate(variant, outcome, score_of(outcome), kinds)
            order = self._order(variant, one.score)
            if order < least:
                found, least = one, order
        return found

    def _order(self, variant: Variant, score: Score) -> float:
        """Return what sorts variants: what they leave, then how much they change."""
        return score.weight + _SIZE * size_of(variant, self.task)

    def _nearest(self, of: Candidate, kinds: tuple[str, ...]) -> Candidate:
        """Return the same at the tension, or else the wrap, nearest to now that leaves as little.

        The tension that the checks state stays: a table has it.
        """
        task, variant = self.task, of.variant
        if variant.tension:
            base = variant._replace(tension=0.0)
            up = variant.tension > task.tension
            if variant in self._completed(self._stated(_at(base, base.wrap, True), up), kinds):
                return of
            rung = rung_above if up else rung_below
            return self._narrowed(of, kinds, rung(task.tension), rung(variant.tension), False)
        if variant.wrap:
            near = max(int(task.wrap), int(variant.wrap) - task.wrap_step)
            return self._narrowed(of, kinds, near, int(variant.wrap), True)
        return of

    def _narrowed(
        self, of: Candidate, kinds: tuple[str, ...], near: int, far: int, wrap: bool
    ) -> Candidate:
        """Narrow the place between one that leaves more and one that leaves as little."""
        while abs(far - near) > (1 if wrap else self.task.within):
            step = max(1, abs(far - near) // (self.task.splits + 1))
            step = step if far > near else -step
            places = [near + step * k for k in range(1, (abs(far - near) - 1) // abs(step) + 1)]
            bases = [_at(of.variant, float(p) if wrap else at_rung(p), wrap) for p in places]
            if self.task.splits > 1:
                self.outcomes(bases)
                self.outcomes([v for base in bases for v in self._completed([base], kinds)])
            passing = far
            for place, base in zip(places, bases, strict=True):
                one = self._least([base], kinds)
                if one is not None and one.score.weight <= of.score.weight:
                    of, passing = one, place
                    break
            near, far = (places[-1] if passing == far else passing - step), passing
        return of


def _is_large(way: Candidate, task: Task) -> bool:
    """Return whether a way changes sizes by more than a factor of two in all."""
    return size_of(way.variant, task) > _LARGE


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
