"""The answer in words: does it carry, how near is a limit, what to do."""

import math
from collections.abc import Iterator

from wraparc.arc import ArcResult, DriveResult, Status
from wraparc.drive import CREEP_LIMIT
from wraparc.present.arc_tables import belongs
from wraparc.present.design_values import comparison_sentence
from wraparc.present.sheet import Level, Verdict, named, percent
from wraparc.units import System


def verdict(result: DriveResult, system: System = "si") -> Verdict:
    """Return the answer for a whole drive, told by the arc that governs."""
    worst = result.governing
    level = level_of(worst)
    headline = _headline(worst, system)
    if len(result) > 1:
        headline = f"{_count(result)} Governing: {belongs(worst)}. {headline}"
    sentences = [*_sentences(worst, system)]
    lagging = result.drive.pulley(worst.arc.pulley).lagging
    sentences += [s for s in (comparison_sentence(worst, lagging, system),) if s]
    sentences += _outside(result)
    return Verdict(level, headline, tuple(sentences))


def level_of(result: ArcResult) -> Level:
    """Return how good the news of one arc is."""
    if not result.status.solved:
        return Level.BAD
    return Level.GOOD if result.within_creep_limit else Level.WARNING


def short(result: ArcResult) -> str:
    """Return the answer for one arc in a few words, for a table."""
    if result.status is Status.BREAKAWAY:
        return "breaks away"
    if result.status is Status.UNSOLVED:
        return "not solved"
    return "carries" if result.within_creep_limit else "over limit"


def _count(result: DriveResult) -> str:
    failed = sum(not r.status.solved for r in result)
    over = sum(r.status.solved and not r.within_creep_limit for r in result)
    if not failed and not over:
        return f"All {len(result)} arcs carry their load within the creep limit."
    parts = [f"{failed} cannot carry their load"] if failed else []
    parts += [f"{over} {'creeps' if over == 1 else 'creep'} more than the limit"] if over else []
    return f"Of {len(result)} arcs (pulleys and load cases) {' and '.join(parts)}."


def _headline(result: ArcResult, system: System) -> str:
    if not result.status.solved:
        return str(result.status)
    creep = named("exit_creep", abs(result.exit_creep), system)
    limit = named("creep_limit", result.arc.creep_limit, system)
    if result.within_creep_limit:
        return f"The pulley carries its load; its creep, {creep}, is within the limit of {limit}."
    return f"The pulley carries its load, but creeps {creep}, more than the limit of {limit}."


def _sentences(result: ArcResult, system: System) -> Iterator[str]:
    if result.status is Status.BREAKAWAY:
        yield from _breakaway(result, system)
    if result.status is not Status.UNSOLVED:
        yield from _slack(result, system)
    limit = result.arc.creep_limit
    if result.status.solved and not result.within_creep_limit and limit == CREEP_LIMIT:
        yield (
            f"{named('creep_limit', limit, system)} is a conservative limit; more may be tolerated "
            "for steel cord belts above ST1600 and fabric belts above "
            f"{named('belt_modulus', 140e3, system)} of working tension."
        )


def _breakaway(result: ArcResult, system: System) -> Iterator[str]:
    c, arc = result.capacities, result.arc
    asked = arc.entry_tension / arc.exit_tension
    ratio, creep = result.tension_ratio, result.exit_creep
    if not math.isnan(c.gross_slip_capacity):
        ratio, creep = c.gross_slip_capacity, c.gross_slip_creep
        if arc.side < 0.0:
            ratio = 1.0 / ratio
    end = "which no finite creep attains"
    if math.isfinite(creep):
        end = f"at a creep of {named('exit_creep', abs(creep), system)}"
    most = "largest" if arc.side > 0.0 else "smallest"
    yield (
        f"Asked for T1/T2 = {named('tension_ratio', asked)}; the {most} the friction can carry is "
        f"{named('tension_ratio', ratio)}, {end} (an extrapolation of the friction law)."
    )
    if not math.isnan(c.creep_limit_capacity):
        limit = c.creep_limit_capacity if arc.side > 0.0 else 1.0 / c.creep_limit_capacity
        yield f"At the creep limit it carries T1/T2 = {named('tension_ratio', limit)}."


def _slack(result: ArcResult, system: System) -> Iterator[str]:
    c, arc = result.capacities, result.arc
    slack = "T2" if arc.side > 0.0 else "T1"
    given = min(arc.entry_tension, arc.exit_tension)
    pull = named("effective_tension", abs(arc.effective_tension), system)
    least, most = c.least_exit_tension, c.largest_effective_tension
    given_text, least_text = named("tension", given, system), named("tension", least, system)
    if not math.isnan(least):
        if least <= given:
            yield (
                f"For the same effective tension {pull} the slack side {slack} could fall from "
                f"{given_text} to {least_text} before the creep reaches its limit."
            )
        else:
            yield (
                f"To carry the same effective tension {pull} within the creep limit, the slack "
                f"side {slack} must rise from {given_text} to {least_text}."
            )
    elif not math.isnan(most):
        yield (
            f"No slack-side tension with wrap pressures in the tested range carries {pull} within "
            f"the creep limit; the largest pull carried so is {named('tension', most, system)}."
        )


def _outside(result: DriveResult) -> Iterator[str]:
    arcs = [r for r in result if r.status.solved and r.outside_tested_share > 0.0]
    if arcs:
        worst = max(arcs, key=lambda r: r.outside_tested_share)
        share = percent(worst.outside_tested_share)
        where = f" ({belongs(worst)})" if len(result) > 1 else ""
        yield (
            f"On {share} of the wrap{where} pressure or slip lies outside what the lagging was "
            "tested in: there the friction is an extrapolation."
        )
