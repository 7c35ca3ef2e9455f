"""What the drive page needs to judge a drive of one pulley itself: its numbers, and the words."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import fields, replace
from itertools import product
from typing import Any

import numpy as np

from wraparc.arc import ArcResult, DriveResult, Energy, Profile, Status
from wraparc.checks import RULES, Check, Figure, Level, idle, judge, least_tension
from wraparc.checks.check import LEADING, Place
from wraparc.checks.design_standard import asked, by_table, design_friction_of, prints
from wraparc.checks.judge import every_check
from wraparc.checks.least_tension import figures
from wraparc.checks.numbers import Criteria
from wraparc.checks.of_arc import BALANCE, FIRST, of_sliding
from wraparc.checks.of_data import wet_factor
from wraparc.checks.of_drive import sense
from wraparc.checks.rules import asked_safety, start_factor, tension_factor
from wraparc.checks.sliding import Sliding
from wraparc.drive import CREEP_LIMIT, Drive, LoadCase, Pulley
from wraparc.present.least_tension import least_name
from wraparc.schema.source import Document
from wraparc.units import Dimension
from wraparc.web.answers.prepared import Plain, Prepared, elsewhere, prepared
from wraparc.web.answers.shown import Tested

#: Checks that a page does not find the numbers of.
BRAKES = "brakes"  # when a pulley holds the belt back
_SERVERS = ("creep_interval", "take_up")


class Miss(Plain):
    """What a check says where it is not kept."""

    level: Level
    short: str
    says: str
    remedy: str
    fails_beyond: float
    because: str
    tolerates: float
    allows: str
    otherwise: str


class Words(Plain):
    """A check without its numbers, and whether it leads where it fails.

    `when` names the outcome of the arc that it is for, if one, and after a colon where it slides.
    """

    name: str
    title: str
    level: Level
    place: str
    value: float
    limit: float
    dimension: Dimension
    at_most: bool
    short: str
    says: str
    remedy: str
    otherwise: str
    more: dict[str, tuple[float, Dimension]]
    binding: bool
    advises: bool
    numerical: bool
    leads: bool
    miss: Miss | None
    when: str = ""


class Ask(Plain):
    """What a check asks of the slack side, but for the tension; `what` sets it, in words."""

    name: str
    title: str
    what: str
    place: str
    binding: bool
    at_least: bool


class JudgedCase(Plain):
    """One load case: its arc as numbers, and its checks."""

    load_case: str
    prepared: Prepared
    elsewhere: list[list[str | int]]
    tested: Tested | None
    criteria: dict[str, float]
    checks: list[Words]
    asks: list[Ask]


class Judging(Plain):
    """A drive of one pulley."""

    levels: list[Level]
    qualifier: str
    take_up: bool
    least_name: str
    counterweight: float
    held_at: float
    cases: list[JudgedCase]
    checks: list[Words]


def judging(document: Document, result: DriveResult) -> Judging | None:
    """Return what a page judges a drive by; None where it needs more than the page has."""
    drive, verdict = result.drive, judge(result)
    if len(drive.pulleys) > 1 or any(map(_servers, result)):
        return None
    odd = any(c.name == "usual_sizes" and c.missed for c in verdict.checks)
    if odd or drive.pulleys[0].across or any(c.name in _SERVERS for c in verdict.checks):
        return None
    first, other = (_checks(result, status) for status in (Status.SOLVED, Status.BREAKAWAY))
    cases, asks, name = [], _asks(result), drive.pulleys[0].name
    for case in drive.load_cases:
        ready = prepared(document, drive, drive.pulleys[0], case)
        if ready is None:
            return None
        law = drive.pulleys[0].lagging_in(case.condition).law
        cases.append(
            JudgedCase(
                load_case=case.name,
                prepared=ready,
                elsewhere=elsewhere(document, drive, case),
                tested=None if law.tested is None else Tested.model_validate(law.tested),
                criteria={k: float(v) for k, v in _criteria(drive, case)._asdict().items()},
                checks=[
                    *sliding_words(drive.in_case(case), case, result.arc(name, case.name)),
                    *either(_of(first, case), _of(other, case)),
                    words_of(sense(case, drive.pulleys[0]), BRAKES),
                ],
                asks=asks[case.name],
            )
        )
    return Judging(
        levels=list(Level),
        qualifier=verdict.qualifier,
        take_up=bool(drive.criteria.take_up.kind),
        least_name=least_name(result),
        counterweight=drive.criteria.take_up.counterweight(1.0),
        held_at=math.nan if drive.conveyor is None else drive.conveyor.take_up,
        cases=cases,
        checks=[words_of(c) for c in first if not c.place.load_case],
    )


def _asks(result: DriveResult) -> dict[str, list[Ask]]:
    """Return what is asked of the slack side in every load case; nothing without capacities."""
    found: dict[str, list[Ask]] = {case.name: [] for case in result.drive.load_cases}
    if least_tension(result) is None:
        return found
    sought = list(figures(result))  # of all load cases: once, not once for each of them
    for case in result.drive.load_cases:
        place = Place(result.drive.pulleys[0].name, case.name)
        told = [f for f in sought if f.place.load_case == case.name]
        if not any(f.name == "tested_slip" for f in told):  # a larger creep limit brings it
            told.insert(1, Figure("tested_slip", "Largest slip, tested", 0.0, place))
        found[case.name] = [
            Ask(
                name=f.name,
                title=f.title,
                what=RULES[f.name].what,
                place=str(f.place),
                binding=f.binding,
                at_least=f.at_least,
            )
            for f in told
        ]
    return found


def _servers(result: ArcResult) -> bool:
    """Whether an arc has numbers that only the server finds."""
    fitted = result.arc.fit is not None and bool(result.arc.fit.knots)
    return result.status is Status.UNSOLVED or idle(result.arc) or fitted


def _checks(result: DriveResult, status: Status) -> tuple[Check, ...]:
    """Return the checks as they were if every arc ended so."""
    arcs = (arc if arc.status is status else _ended(arc, status) for arc in result)
    return every_check(DriveResult(result.drive, tuple(arcs)))


def _ended(arc: ArcResult, status: Status) -> ArcResult:
    """Return an arc as if it ended so, for the words: zeros stand for the numbers it has not."""
    if not status.solved:
        return replace(arc, status=status)
    # what has no number is not equal to itself
    none = {f.name: 0.0 for f in fields(arc) if getattr(arc, f.name) != getattr(arc, f.name)}
    given: dict[str, Any] = {
        **none,
        "status": status,
        "profile": Profile(*(np.zeros(2) for _ in fields(Profile))),
        "energy": Energy(identity_error=0.0),
    }
    return replace(arc, **given)


def _of(checks: tuple[Check, ...], case: LoadCase) -> list[Check]:
    here = [check for check in checks if check.place.load_case == case.name]
    return [check for check in here if check.name not in ("sense", "gross_slip")]


def sliding_words(drive: Drive, case: LoadCase, arc: ArcResult) -> Iterator[Words]:
    """Yield the words of the safety against gross slip, however an arc ends and it slides."""
    for status, cause in product((Status.SOLVED, Status.BREAKAWAY), FIRST):
        check = of_sliding(drive, case, replace(arc, status=status), Sliding(1.0, cause))
        yield words_of(check, f"{'solved' if status.solved else 'breakaway'}:{cause}")


def either(solved: Sequence[Check], broken: Sequence[Check]) -> Iterator[Words]:
    """Yield what is checked of an arc however it ends, each once."""
    here, there = set(map(_key, solved)), set(map(_key, broken))
    slips = {c.name: words_of(c, "breakaway") for c in broken if _key(c) not in here}
    for check in solved:
        if check.name in slips:
            yield slips.pop(check.name)
        yield words_of(check, "" if _key(check) in there else "solved")
    yield from slips.values()


def _key(check: Check) -> tuple[str, str, bool]:
    return check.name, check.title, check.miss is None


def words_of(check: Check, when: str = "") -> Words:
    """Return a check without its numbers."""
    names = ("name", "title", "level", "value", "limit", "dimension", "at_most", "short", "says")
    fields = {
        name: getattr(check, name)
        for name in (*names, "remedy", "otherwise", "binding", "advises", "numerical")
    }
    miss = None if check.miss is None else Miss(**check.miss._asdict())
    place = str(check.place)
    leads = check.name in LEADING
    return Words(**fields, leads=leads, place=place, more=dict(check.more), miss=miss, when=when)


def _criteria(drive: Drive, case: LoadCase) -> Criteria:
    """Return what the checks of a load case hold the arc against, as numbers."""
    criteria, belt, pulley = drive.criteria, drive.belt, _pulley_in(drive, case)
    tested = pulley.lagging.law.tested
    by = criteria.standard, criteria.take_up, pulley.lagging
    friction, table, rule = design_friction_of(*by), by_table(*by), asked(*by, pulley.wrap_angle)
    allowed = None if belt.rating is None else tension_factor(belt, case.kind) * belt.rating
    return Criteria(
        safety=criteria.safety.of(case.kind),
        standard=_number(friction),
        start=start_factor(criteria, case.kind),
        belt_tension=_number(allowed),
        rating=_number(belt.rating),
        strength=_number(belt.breaking_strength),
        belt_safety=asked_safety(belt, case.kind),
        face_pressure=_number(belt.largest_wrap_pressure),
        bond_strength=_number(pulley.lagging.bond_strength),
        fatigue_limit=_number(pulley.lagging.fatigue_limit),
        slip_speed=_number(None if tested is None else tested.slip_speed),
        balance=BALANCE,
        sag=_number(None if criteria.sag is None else criteria.sag.tension),
        pulley_diameter=_number(belt.least_pulley_diameter),
        fixed=criteria.take_up.fixed,
        behind=bool(criteria.take_up.after),
        factor=math.nan if not table or rule is None else rule.wrap_factor,
        alone=True,
        printed=prints(criteria.standard, pulley.lagging.surface),
        customary=drive.creep_limit_of(pulley) == CREEP_LIMIT,
        wrap_angle=pulley.wrap_angle if table else math.nan,
        pulley_mass=_number(pulley.mass),
        wet=wet_factor(pulley.lagging),
    )


def _pulley_in(drive: Drive, case: LoadCase) -> Pulley:
    return drive.in_case(case).pulleys[0]


def _number(value: float | None) -> float:
    return math.nan if value is None else value
