"""The one judgement of a run in time: how it ended, the largest creep, the largest tension."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.checks.check import Check, Level, Place, Verdict
from wraparc.checks.of_drive import data, judged, not_checked, origin
from wraparc.checks.rules import RULES, tension_factor, tension_rule
from wraparc.units import display

if TYPE_CHECKING:
    from wraparc.motion.result import RunResult


#: Times the creep limit beyond which a drive slides and does not creep any more [-]; ours.
SLIDES = 10.0


def judge_run(run: RunResult) -> Verdict:
    """Return every check of a run over its whole length, and so its verdict."""
    return Verdict(tuple(_checks(run)))


def _checks(run: RunResult) -> Iterator[Check]:
    event = run.event.name
    from wraparc.motion.result import Outcome  # the rooms of drives in time are for these alone

    if run.outcome in (Outcome.SLACK, Outcome.BREAKAWAY):
        yield Check(
            name="run",
            title="Followed to its end",
            level=Level.FAILS,
            place=Place(event=event),
            says=f"{run.reason} {run.outcome.value}",
            short="not followed to its end",
        )
    elif not run.outcome.whole:
        yield Check(
            name="run",
            title="Followed to its end",
            level=Level.ATTENTION,
            place=Place(event=event),
            says=f"{run.reason} {run.outcome.value}",
            short="not followed to its end",
        )
    yield from _creeps(run)
    yield _tension(run)
    # what the answer stands on is asked of belt and pulleys alone
    of: Any = run.station.train
    yield from (data(of, pulley) for pulley in of.pulleys)


def _creeps(run: RunResult) -> Iterator[Check]:
    train = run.station.train
    for pulley, drum in zip(train.pulleys, run.drums, strict=True):
        i = int(np.argmax(np.abs(drum.exit_creep)))
        over = run.over_limit(drum.name)
        largest, limit = abs(float(drum.exit_creep[i])), train.creep_limit_of(pulley)
        if largest > SLIDES * limit:
            yield _slides(Place(drum.name, event=run.event.name), largest, float(run.time[i]))
        yield judged(
            RULES["creep"],
            "Largest creep at exit",
            largest,
            limit,
            "length",
            place=Place(drum.name, event=run.event.name),
            short="over creep limit",
            says=f"Creeps {{value}} at {display(float(run.time[i]), 'time', digits=3)}, more than "
            f"the limit of {{limit}}, and is over it for {display(over, 'time', digits=2)}.",
            remedy="Start and stop more slowly, raise the slack-side tension, or choose a lagging "
            "with more friction.",
        )


def _slides(place: Place, creep: float, time: float) -> Check:
    return Check(
        name=RULES["gross_slip"].name,
        title="Carries its load",
        level=Level.FAILS,
        place=place,
        short="slides",
        says=f"The belt slides on the pulley: {display(creep, 'length', digits=3)} of creep at "
        f"{display(time, 'time', digits=3)}, more than {SLIDES:g} times the creep limit, is gross "
        "slip.",
        remedy="Raise the slack-side tension, start and stop more slowly, or choose a lagging with "
        "more friction.",
    )


def _tension(run: RunResult) -> Check:
    belt, peak = run.station.train.belt, run.peak_tension
    rule, title = tension_rule("starting"), "Largest belt tension"
    place = Place(event=run.event.name)
    if belt.rating is None:
        return not_checked(rule.name, title, "the rating of the belt is not given", place)
    factor = tension_factor(belt, "starting")
    return judged(
        rule,
        title,
        peak.value,
        factor * belt.rating * belt.width,
        "force",
        place=place,
        source=f"rating of the belt times {factor:g}: "
        f"{origin(belt.sources.get('rating', belt.provenance))}",
        short="over belt rating",
        says=f"The belt tension {peak.place} reaches {{value}} at "
        f"{display(peak.time, 'time', digits=3)}, more than the belt allows, {{limit}}.",
        remedy="Start more slowly, or take a stronger belt.",
    )
