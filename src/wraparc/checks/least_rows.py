"""What the checks of many arcs ask of the slack side: the numbers of `checks.least_tension`."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from wraparc.arc.capacity import LEAST
from wraparc.arrays import Array, Flags
from wraparc.batch import Setting
from wraparc.batch.arcs import Arcs
from wraparc.batch.scaled import solve_scaled
from wraparc.batch.sliding import LoadedRows, tight_at_sliding
from wraparc.checks.least_tension import is_of_tension, least_by_interval, least_for_tested_slip
from wraparc.checks.of_arc import (
    COVER_CREEP,
    CREEP_INTERVAL,
    DESIGN_STANDARD,
    EXIT_CREEP,
    GROSS_SLIP,
    TESTED_SLIP,
)
from wraparc.checks.of_rows import Held
from wraparc.checks.of_wet import WET_CREEP
from wraparc.checks.rule import Rule
from wraparc.checks.rules import OF_PULLEY
from wraparc.drive import Lagging
from wraparc.drive.pull import idle_rows


@dataclass(frozen=True, eq=False)
class RowFigure:
    """What one check asks of many arcs, columns of shape (n,).

    Attributes
    ----------
    rule
        The check.
    rise
        By how much all tensions rise until it is just kept [N]: infinite where no tension keeps
        it, nan where it requires nothing.
    binding
        Whether each drive must keep it.
    at_least
        Whether it is a bound from below.
    """

    rule: Rule
    rise: Array
    binding: Flags
    at_least: bool = True


def figures_of_rows(
    arcs: Arcs, held: Held, laggings: Sequence[Lagging], rules: Sequence[Rule] = OF_PULLEY
) -> Iterator[RowFigure]:
    """Yield what every check asks of the tensions of arcs, each arc's pull held.

    Parameters
    ----------
    arcs
        The arcs.
    held
        What they are held against.
    laggings
        Those whose laws the arcs refer to.
    rules
        The checks that count.
    """
    n, slack = len(arcs), held.state.slack
    pulls = np.flatnonzero(~idle_rows(arcs.entry_tension, arcs.exit_tension))
    own, of = arcs.rows(pulls), held.rows(pulls)
    least = _least_exit(own, np.ones(len(own)))
    for rule, asks in (
        (EXIT_CREEP, np.where(np.isnan(least), math.inf, least)),
        (TESTED_SLIP, _for_slip(own, laggings)),
        (COVER_CREEP, _when_covered(own, of)),
        (CREEP_INTERVAL, _by_interval(own, laggings, least)),
        (WET_CREEP, _when_wet(own, of)),
        (DESIGN_STANDARD, _by_standard(of)),
        (GROSS_SLIP, of.state.slack + _lift(own, of)),
    ):
        if rule is not GROSS_SLIP and rule not in rules:
            continue
        rise = np.full(n, math.nan)
        rise[pulls] = asks - slack[pulls]
        firm = held.firm.get(rule.name, np.full(n, rule.binding))
        yield RowFigure(rule, rise, firm)
    for rule in rules:
        if is_of_tension(rule):
            rise = rule.rise_to(held.state, held.limit(rule))
            yield RowFigure(rule, rise, np.full(n, rule.binding), rule.tension == "raise")


def _least_exit(arcs: Arcs, friction: Array) -> Array:
    """Return least slack-side tensions for the creep with factors on the friction [N]."""
    one = np.ones(len(arcs))
    found = solve_scaled(arcs, friction, one, setting=Setting.PRECISE, parts=LEAST)
    return np.asarray(found["least_exit_tension"])


def _some(asks: Array, there: Flags) -> Array:
    """Return what is asked for by rows, infinite where nothing helps and nan of the others."""
    found = np.full(len(there), math.nan)
    found[there] = np.where(np.isnan(asks), math.inf, asks)
    return found


def _when_covered(arcs: Arcs, held: Held) -> Array:
    there = held.cover_left_out > 0.0
    some, cover = arcs.rows(np.flatnonzero(there)), held.cover_left_out[there]
    covered = replace(some, cover_compliance=some.cover_compliance + cover)
    return _some(_least_exit(covered, np.ones(len(some))), there)


def _when_wet(arcs: Arcs, held: Held) -> Array:
    there = held.wet_factor > 0.0
    some = arcs.rows(np.flatnonzero(there))
    return _some(_least_exit(some, held.wet_factor[there]), there)


def _for_slip(arcs: Arcs, laggings: Sequence[Lagging]) -> Array:
    """Return the same for the tested slip, arc by arc: it is mostly more than the creep."""
    laws = [lagging.law for lagging in laggings]
    slip = arcs.laws.tested[arcs.law].T[2]
    found = np.full(len(arcs), math.nan)
    for i in np.flatnonzero(slip < arcs.creep_limit):
        found[i] = least_for_tested_slip(arcs.arc(int(i), laws), float(slip[i]))
    return found


def _by_interval(arcs: Arcs, laggings: Sequence[Lagging], least: Array) -> Array:
    """Return the same for the interval of fitted laws, arc by arc."""
    laws = [lagging.law for lagging in laggings]
    fitted = np.array([lag.fit is not None and bool(lag.fit.knots) for lag in laggings])
    found = np.full(len(arcs), math.nan)
    for i in np.flatnonzero(fitted[arcs.law]):
        arc = replace(arcs.arc(int(i), laws), fit=laggings[int(arcs.law[i])].fit)
        found[i] = least_by_interval(arc, float(least[i]))
    return found


def _by_standard(held: Held) -> Array:
    """Return what the design standard requires: where it cannot be applied, only if it binds."""
    never = np.isinf(held.standard) & ~held.firm[DESIGN_STANDARD.name]
    return np.where(never, math.nan, held.standard)


def _lift(arcs: Arcs, held: Held) -> Array:
    """Return by how much all tensions rise for the safety factor on gross slip [N]."""
    pull = np.abs(arcs.entry_tension - arcs.exit_tension)
    of = LoadedRows.of(arcs, setting=Setting.PRECISE)
    tight = tight_at_sliding(of, held.safety * pull) + arcs.centrifugal_force
    lift = tight - held.state.tight - (held.safety - 1.0) * held.tight_rise
    return np.where(np.isnan(lift), math.inf, lift)
