"""What wear makes of an uneven lagging, and what a thicker one cushions: sentences and tables."""

from __future__ import annotations

import math

import numpy as np

from wraparc.across import AcrossResult, Cushion, WearHistory
from wraparc.answer.sheet import NONE, Row, Table, Verdict, named
from wraparc.checks import Level
from wraparc.units import GIVEN_DIGITS, count, fixed, quantity

#: Rows of a table of wear; the march has more steps.
_ROWS = 8


def wear_verdict(now: AcrossResult, history: WearHistory, least: float) -> Verdict:
    """Return whether uneven wear heals or runs away, how fast, and when to re-lag.

    Parameters
    ----------
    now
        The belt across its width before the wear.
    history
        The lagging as it wears.
    least
        Thickness of the thinnest strip at which the pulley is re-lagged [m].
    """
    if np.min(history.thickness[0]) <= least:
        return Verdict(Level.ATTENTION, relag_sentence(history, least))
    first, last = (float(v) for v in history.unevenness[[0, -1]])
    depth = named("lagging_thickness", float(history.mean_depth[-1]))
    uneven, left = (named("lagging_thickness", v) for v in (first, last))
    rate = float(np.min(np.abs(now.levelling_depth)))
    pace = named("levelling_depth", rate)
    if now.wear_grows:
        level, headline = Level.ATTENTION, f"Runs away: wear makes it more uneven, {uneven} "
        headline += f"from thickest to thinnest now, {left} after {depth} of mean wear."
        sentences = [f"Fastest where {pace} of mean wear makes a shape 2.7 times as uneven."]
    elif last < first:
        level, headline = Level.OK, f"Heals: wear evens it out, {uneven} from thickest to "
        headline += f"thinnest now, {left} after {depth} of mean wear."
        sentences = [f"Fastest where {pace} of mean wear leaves 37 % of a shape."]
    else:
        level, headline = Level.OK, f"Does not heal while its cause lasts: {uneven} from thickest "
        headline += f"to thinnest now, {left} after {depth} of mean wear."
        sentences = ["It wears to the shape that wears evenly under what is uneven, and stays so."]
    if history.ended:
        sentences.append(f"The integration ended early. {history.ended}")
    return Verdict(level, headline, (*sentences, relag_sentence(history, least)))


def relag_sentence(history: WearHistory, least: float) -> str:
    """Say after which running time the thinnest strip is down to a thickness [m]."""
    to = quantity(least, "length", GIVEN_DIGITS)
    thinnest = np.min(history.thickness, axis=1)
    if thinnest[0] <= least:
        return f"Re-lag now: the thinnest strip is down to {to} already."
    if np.all(np.isnan(history.passes)):
        return (
            f"Time to re-lagging at {to} unknown: give the hours run since the lagging was "
            "new, or a lagging with a wear coefficient."
        )
    if math.isnan(float(history.hours[-1])):
        return "Hours to re-lagging unknown: give the belt speed."
    hours = history.hours_to(least)
    if math.isnan(hours):
        thin = quantity(float(thinnest[-1]), "length", GIVEN_DIGITS)
        return f"The thinnest strip has {thin} left after {_hours(float(history.hours[-1]))}."
    return f"Re-lag after {_hours(hours)}: then the thinnest strip is down to {to}."


def _hours(hours: float) -> str:
    return f"{float(f'{hours:.3g}'):,.0f} hours of running"


def wear_table(history: WearHistory) -> Table:
    """Return how lagging, tension and wear go on, at some places of the march."""
    steps = len(history.mean_depth)
    kept = np.unique(np.linspace(0, steps - 1, min(_ROWS, steps)).round().astype(int))
    timed = not math.isnan(float(history.hours[-1]))
    heads = ["unevenness", "thinnest strip", "tightest strip over mean", "wear, worst over mean"]
    rows = []
    for k in kept.tolist():
        tension, energy = history.entry_tension[k], history.energy[k]
        values = [
            named("lagging_thickness", float(history.unevenness[k])),
            named("lagging_thickness", float(np.min(history.thickness[k]))),
            fixed(float(np.max(tension) / np.mean(tension)), 3),
            fixed(float(np.max(energy) / np.mean(energy)), 3),
        ]
        values += [f"{count(float(history.hours[k]))} h"] if timed else []
        depth = named("lagging_thickness", float(history.mean_depth[k]))
        rows.append(Row(f"after {depth} of mean wear", tuple(values)))
    if timed:
        heads.append("running time")
    return Table("Wear of the uneven lagging", tuple(rows), tuple(heads))


def cushion_verdict(found: Cushion) -> Verdict:
    """Return what the thickest lagging takes off the unevenness, and what it costs in creep."""
    thin, thick = (quantity(float(found.thickness[k]), "length", GIVEN_DIGITS) for k in (0, -1))
    if len(found.thickness) < 2 or not np.all(np.isfinite(found.unevenness)):
        where = [r for r in found.results if not r.status.solved]
        words = str(where[0].status) if where else "One thickness alone compares nothing."
        return Verdict(Level.FAILS if where else Level.NOT_CHECKED, words)
    uneven, creep = found.unevenness, found.creep
    if not uneven[0] > 1e-9:
        return Verdict(Level.NOT_CHECKED, "The belt is even: there is nothing to cushion.")
    less, more = 1.0 - uneven[-1] / uneven[0], creep[-1] / creep[0] - 1.0
    does = "takes" if less >= 0.0 else "adds"
    onto = "off" if less >= 0.0 else "to"
    headline = (
        f"{thick} instead of {thin} {does} {100.0 * abs(less):.0f} % {onto} the unevenness of the "
        f"belt tension and changes creep by {100.0 * more:+.0f} %."
    )
    from_to = f"from {100.0 * uneven[0]:.1f} % to {100.0 * uneven[-1]:.1f} %"
    return Verdict(
        Level.OK, headline, (f"The tightest strip is above the mean by {from_to} of it.",)
    )


def cushion_table(found: Cushion) -> Table:
    """Return the unevenness left and the creep paid by thickness."""
    rows = []
    for k, result in enumerate(found.results):
        thickness = quantity(float(found.thickness[k]), "length", GIVEN_DIGITS)
        if not result.status.solved:
            rows.append(Row(thickness, (NONE,) * 5, note=str(result.status), level=Level.FAILS))
            continue
        creep, uneven = float(found.creep[k]), float(found.unevenness[k])
        values = (
            fixed(uneven, 2, "percent signed"),
            _change(uneven, float(found.unevenness[0])),
            fixed(float(found.wear_unevenness[k]), 3),
            named("exit_creep", creep),
            _change(creep, float(found.creep[0])),
        )
        rows.append(Row(thickness, values))
    heads = (
        "tightest strip over mean", "against the first", "wear, worst over mean", "mean creep",
        "against the first",
    )  # fmt: skip
    return Table("Thickness of the lagging", tuple(rows), heads)


def _change(value: float, first: float) -> str:
    return NONE if not abs(first) > 1e-12 else fixed(value / first - 1.0, 1, "percent signed")
