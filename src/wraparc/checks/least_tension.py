"""The least slack-side tension with which every check is kept that it helps."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from weakref import WeakKeyDictionary

from wraparc.alike import largest, least
from wraparc.arc import ArcResult, DriveResult, WrapArc
from wraparc.arc.capacity import highest_tight
from wraparc.arc.grip import lift
from wraparc.arc.interval import laws_at_ends
from wraparc.arc.sliding import with_friction
from wraparc.checks.check import Level, Place
from wraparc.checks.design_standard import asked
from wraparc.checks.gross_slip import rises
from wraparc.checks.least_numbers import Pull, least_for_creep, least_for_slip
from wraparc.checks.of_arc import COVER_CREEP, CREEP_INTERVAL, design_slack
from wraparc.checks.of_wet import WET_CREEP, estimate_factor
from wraparc.checks.rule import Rule, Spot, idle
from wraparc.checks.rules import OF_PULLEY, spot_of
from wraparc.conveyor import Conveyor
from wraparc.drive import Drive, LoadCase
from wraparc.train import TrainResult

inf = math.inf

#: Tension of a belt that does not hang slack [N].
TAUT = 1.0
#: Rounds of a search at most, and its last step over what is sought [-].
_ROUNDS, _NEAR = 20, 1e-7


@dataclass(frozen=True)
class Figure:
    """What one check asks of the slack side.

    Attributes
    ----------
    name, title
        Key of the check, and its words.
    tension
        Least (or, of a bound above, largest) tension of the belt at the take-up, see
        `Drive.take_up_tension` [N]; inf where none keeps the check.
    place
        Where it asks so much.
    binding
        Whether a design must keep the check. Of the others, a design standard that was not made
        binding, a cover in series, the interval of a fitted law and the estimate of wet, counts
        what a tension keeps, see `LeastTension.required`.
    at_least
        Whether it is a bound from below.
    """

    name: str
    title: str
    tension: float
    place: Place
    binding: bool = True
    at_least: bool = True


@dataclass(frozen=True)
class LeastTension:
    """The least slack-side tension of a drive or a train, at its take-up.

    The pull of every pulley is held, and so is how the load divides.

    Attributes
    ----------
    figures
        What each check asks, each once, where it asks most.
    given
        The same tension of the load case that governs [N].
    counterweight
        Mass of the counterweight for the least tension, where the take-up stands [kg].
    elsewhere
        Whether the take-up is not on the slack side in every load case.
    """

    figures: tuple[Figure, ...]
    given: float
    counterweight: float
    elsewhere: bool = False

    @cached_property
    def required(self) -> tuple[Figure, ...]:
        """What sets the least tension: what binds, and what else some tension keeps.

        A tension beyond what another check allows keeps none.
        """
        top = inf if self.highest is None else self.highest.tension
        below = (f for f in self.figures if f.at_least)
        return tuple(f for f in below if f.binding or (f.tension <= top and f.tension < inf))

    @cached_property
    def governing(self) -> Figure:
        """The check that requires most."""
        return largest(self.required, _tension)

    @property
    def tension(self) -> float:
        """The least tension [N]; inf where no tension keeps every check."""
        top = self.highest
        if top is not None and top.tension < self.governing.tension * (1.0 - 1e-9):
            return inf
        return self.governing.tension

    @property
    def level(self) -> Level:
        """Whether as much is given."""
        return Level.OK if self.tension <= self.given else Level.ATTENTION

    @property
    def raise_to(self) -> float | None:
        """The tension of the slack side to raise to [N].

        None where none is to be raised, where none is enough, and where the take-up is elsewhere.
        """
        none = self.tension <= self.given or math.isinf(self.tension) or self.elsewhere
        return None if none else self.tension

    @cached_property
    def highest(self) -> Figure | None:
        """The check that allows least above, if any bounds the tension from above."""
        above = [f for f in self.figures if not f.at_least]
        return least(above, _tension) if above else None

    @property
    def standard(self) -> Figure | None:
        """What the design standard requires, if one does."""
        return next((f for f in self.figures if f.name == "design_standard"), None)


def _tension(figure: Figure) -> float:
    return figure.tension


_found: WeakKeyDictionary[DriveResult, LeastTension | None] = WeakKeyDictionary()


def least_tension(result: DriveResult | TrainResult) -> LeastTension | None:
    """Return the least slack-side tension of a solved drive or train.

    It is never less than what any binding check requires: creep, slip and wrap pressures within
    the tests, sag, the safety factor on gross slip, a design standard made binding. Nor than what
    the design standard, the cover of the belt in series, the interval of a fitted law or the
    estimate of wet ask for, where a tension that no check forbids keeps them.

    Returns
    -------
    None where nothing is pulled, the method finds no capacities, or no division of the load is
    found.
    """
    if isinstance(result, TrainResult) and result.adrift:
        return None
    one = result.drive_result() if isinstance(result, TrainResult) else result
    if one not in _found:
        _found[one] = least_of(one, one.drive)
    return _found[one]


def figures(result: DriveResult, drive: Drive) -> Iterator[Figure]:
    """Yield what every check asks of the take-up of a drive, on every pulley in every load case.

    It stands at one place and holds one tension: what a load case requires is what it has there,
    and what its slack side lacks.
    """
    for name, arcs in _by_case(result).items():
        case = result.drive.load_case(name)
        end = drive.take_up_tension(case)
        yield from _figures(result.drive.in_case(case), case, arcs, end)
    if drive.conveyor is not None:
        yield taut(drive.conveyor)


def taut(conveyor: Conveyor) -> Figure:
    """Return what a belt that nowhere hangs slack asks of the take-up of a conveyor."""
    ends = {s.name: min(s.head, s.tail, s.entry, s.exit) for s in conveyor.reckoned()}
    slackest = least(ends, lambda name: ends[name])
    tension = conveyor.take_up - ends[slackest] + TAUT
    return Figure("taut", "Belt taut at both ends", tension, Place("", slackest))


def _by_case(result: DriveResult) -> dict[str, list[ArcResult]]:
    by_case: dict[str, list[ArcResult]] = {}
    for arc in result:
        by_case.setdefault(arc.arc.load_case, []).append(arc)
    return by_case


def least_of(result: DriveResult, drive: Drive) -> LeastTension | None:
    """Return the same of some load cases of a drive, at the take-up that it has for all."""
    if any(_pulls(a) and math.isnan(a.capacities.gross_slip_capacity) for a in result):
        return None
    worst: dict[str, Figure] = {}
    for figure in figures(result, drive):
        held = worst.get(figure.name)
        either = (figure,) if held is None else (held, figure)
        worst[figure.name] = (largest if figure.at_least else least)(either, _tension)
    if not any(f.at_least and f.binding for f in worst.values()):
        return None
    found = LeastTension(tuple(worst.values()), 0.0, 0.0)
    if drive.conveyor is not None:
        given = drive.conveyor.take_up
    else:
        given = drive.take_up_tension(drive.load_case(found.governing.place.load_case))
    weight = drive.criteria.take_up.counterweight(found.tension)
    return LeastTension(found.figures, given, weight, bool(drive.take_up_place))


def _pulls(result: ArcResult) -> bool:
    return not idle(result.arc)


def _figures(
    drive: Drive, case: LoadCase, arcs: Sequence[ArcResult], end: float
) -> Iterator[Figure]:
    """Yield what every check asks of the take-up: all tensions rise with `end`, what it holds."""
    for index, result in enumerate(arcs):
        spot = spot_of(drive, case, drive.pulley(result.arc.pulley), result)
        place, offset = spot.place, end - spot.state.slack
        if _pulls(result):
            least = result.capacities.least_exit_tension
            yield Figure("creep", "Creep", offset + (inf if math.isnan(least) else least), place)
            yield from _slip(result, offset, place)
            yield from _estimates(spot, result, offset)
            yield from _standard(spot, offset)
            yield _gross_slip(drive, case, arcs, index, end)
        for rule in OF_PULLEY:
            yield from _of_tension(rule, spot, end)


def _of_tension(rule: Rule, of: Spot, end: float) -> Iterator[Figure]:
    """Yield what a check of a tension, or of its pressure, requires: all of them rise alike.

    The safety factor of a belt, its tension the other way round, requires what its rating does.
    """
    words = rule.words and rule.words(of)
    if not is_of_tension(rule) or words is None or words.missing:
        return
    rise = rule.rise_to(of.state, rule.limit_at(of))
    yield Figure(rule.name, words.title, end + rise, of.place, at_least=rule.tension == "raise")


def is_of_tension(rule: Rule) -> bool:
    """Return whether a check compares a tension, or what grows evenly with it, with a limit."""
    return bool(rule.tension) and rule.firm is None and rule.value is not None


def _standard(of: Spot, offset: float) -> Iterator[Figure]:
    criteria, pulley = of.drive.criteria, of.pulley
    rule = asked(criteria.standard, criteria.take_up, pulley.lagging, pulley.wrap_angle)
    if rule is None:
        return
    binding, tension = criteria.standard.binding, inf  # none keeps a rule that cannot be applied
    if not math.isnan(rule.wrap_factor):
        tension = offset + design_slack(of, rule.wrap_factor)
    elif not (binding and criteria.standard.name):
        return
    yield Figure("design_standard", rule.rule, tension, of.place, binding=binding)


def _slip(result: ArcResult, offset: float, place: Place) -> Iterator[Figure]:
    """Yield what the tested slip requires; slip is never more than creep, so mostly nothing."""
    tested = result.arc.law.tested
    if tested is not None and tested.slip_max < result.arc.creep_limit:
        least = least_with_slip(result, tested.slip_max)
        yield Figure("tested_slip", "Largest slip, tested", offset + least, place)


def least_with_slip(result: ArcResult, limit: float) -> float:
    """Least slack-side tension with which the slip at the exit keeps a limit, the pull held [N]."""
    return least_for_tested_slip(result.arc, limit)


def least_for_tested_slip(arc: WrapArc, limit: float) -> float:
    """Return the same of an arc that is not solved [N]."""
    found = least_for_slip(arc.law.compact(), arc.geometry(), _pull_of(arc), limit)
    return found + arc.centrifugal


def _estimates(spot: Spot, result: ArcResult, offset: float) -> Iterator[Figure]:
    """Yield what the checks ask for that estimate a larger creep than that of the arc."""
    factor = estimate_factor(spot)
    for rule, title, asks in (
        (COVER_CREEP, "Creep with the cover of the belt in series", least_when_covered(result)),
        (CREEP_INTERVAL, "Creep at the end of its interval", _by_interval(result)),
        (WET_CREEP, "Creep when wet, estimated", least_when_wet(result, factor)),
    ):
        if not math.isnan(asks):
            yield Figure(rule.name, title, offset + asks, spot.place, binding=False)


def least_when_covered(result: ArcResult) -> float:
    """Least slack-side tension for the creep with the cover in series; nan if there is none [N]."""
    arc = result.arc
    if arc.cover_left_out == 0.0:
        return math.nan
    geometry = arc.geometry()
    series = geometry._replace(shear=geometry.shear + arc.cover_left_out)
    found = least_for_creep(arc.law.compact(), series, _pull_of(arc), arc.creep_limit)
    return found + arc.centrifugal


def least_when_wet(result: ArcResult, factor: float) -> float:
    """Least slack-side tension for the creep with a factor on the friction [N]; nan without it."""
    arc = result.arc
    if not factor > 0.0:
        return math.nan
    wet = with_friction(arc.geometry(), factor)
    found = least_for_creep(arc.law.compact(), wet, _pull_of(arc), arc.creep_limit)
    return found + arc.centrifugal


def _by_interval(result: ArcResult) -> float:
    if result.method == "paper":
        return math.nan
    return least_by_interval(result.arc, result.capacities.least_exit_tension)


def least_by_interval(arc: WrapArc, least: float) -> float:
    """Least slack-side tension for the end of the creep's interval [N]; nan if there is none.

    The laws at the ends depend on the tensions: they are found anew at each tension.

    Parameters
    ----------
    arc
        The arc.
    least
        Its least slack-side tension for the creep by the law itself, nan if there is none [N].
    """
    if arc.fit is None or not arc.fit.knots:
        return math.nan
    if math.isnan(least):
        return inf
    pull, last = abs(arc.effective_tension), math.nan
    for _ in range(_ROUNDS):
        ends = (least + pull, least) if arc.side > 0.0 else (least, least + pull)
        at = replace(arc, entry_tension=ends[0], exit_tension=ends[1])
        laws = laws_at_ends(at)
        if laws is None:
            return math.nan
        geometry, of = at.geometry(), _pull_of(at)
        under = (least_for_creep(law.compact(), geometry, of, at.creep_limit) for law in laws)
        last, least = (
            least,
            max([least_of_law + arc.centrifugal for least_of_law in under] or [least]),
        )
        if math.isinf(least) or abs(least - last) <= _NEAR * least:
            break
    return least


def _pull_of(arc: WrapArc) -> Pull:
    tight, tested = max(arc.entry_tension, arc.exit_tension) - arc.centrifugal, arc.law.tested
    largest = math.nan if tested is None else tested.pressure_max
    top = highest_tight(largest, arc.width * arc.radius, tight)
    return Pull(abs(arc.effective_tension), tight, top)


def _gross_slip(
    drive: Drive, case: LoadCase, arcs: Sequence[ArcResult], index: int, end: float
) -> Figure:
    """Return what the safety factor on gross slip requires, with what the take-up holds."""
    arc, factor = arcs[index].arc, drive.criteria.safety.of(case.kind)
    rise = rises([r.arc for r in arcs], index, drive.criteria.take_up)
    raised = lift(arcs[index], factor, rise.tight)
    title = f"Safety {factor:g} against gross slip"
    raised = inf if math.isnan(raised) else raised
    return Figure("gross_slip", title, end + raised, Place(arc.pulley, case.name))
