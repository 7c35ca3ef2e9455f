"""What a calculation note takes for granted, and what it warns of: sentences."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from wraparc.answer.arc_tables import belongs
from wraparc.answer.drive_sheet import method_remarks
from wraparc.answer.sheet import named, percent, started
from wraparc.arc import DriveResult
from wraparc.checks import judge
from wraparc.drive import Lagging
from wraparc.drive.conditions import SCALED
from wraparc.units import distinct

if TYPE_CHECKING:
    from wraparc.train import TrainResult


def assumptions(results: Sequence[DriveResult], train: "TrainResult | None") -> Iterator[str]:
    """Yield what the results of a note rest on."""
    drive = results[0].drive
    yield (
        "Steady running; tension and pressure uniform over the width of the belt; weight, bending "
        "and centrifugal force of the belt left out; diameters over the unloaded lagging."
    )
    if any(pulley.across for pulley in drive.pulleys):
        yield (
            "Across the width alone they are not uniform: the belt is cut into strips that its "
            "in-plane shear couples, the spans are membranes fixed to their track."
        )
    told = "The friction law depends on slip and pressure, not on speed, temperature or time"
    if any(lagging.factors is not None for lagging in drive.laggings):
        told += " (but by the factors among the inputs, the minimum over the whole arc)"
    yield f"{told}; it is that of the condition named ({_conditions(drive.laggings)})."
    for lagging in (lagging for lagging in drive.laggings if SCALED in lagging.sources):
        yield (
            f"The law of {lagging.name} when {lagging.condition} is its dry law scaled as a whole "
            f"({lagging.notes[-1]}; {lagging.sources[SCALED]}): not measured."
        )
    if any(lagging.law.tested is not None for lagging in drive.laggings):
        yield (
            "Below the lowest tested pressure the coefficient of friction is constant, above "
            "the highest the traction; both are extrapolations, as is slip outside the tested "
            "range."
        )
    if any(p.recovery for p in drive.pulleys):
        yield "The compressed lagging recovers as the pressure falls, which adds creep."
    if train is not None:
        yield (
            "Friction on runs between drives is an input; the load is divided as the drive file "
            "says, and belt mass flow is continuous."
        )
    if len(results) > 1:
        yield (
            "The headline numbers are those of the distributed method, which solves equilibrium "
            "and creep along the wrap; the paper's integration is shown as a second opinion."
        )


def _conditions(laggings: Sequence[Lagging]) -> str:
    return ", ".join(f"{lagging.name}: {lagging.condition}" for lagging in laggings)


def warnings(results: Sequence[DriveResult]) -> Iterator[str]:
    """Yield what a reader of a note must not miss."""
    yield from judge(results[0]).remarks
    for arc in results[0]:
        if arc.status.solved and arc.extrapolates:
            share = percent(arc.outside_tested_share)
            yield (
                f"{started(belongs(arc))}: on {share} of the wrap pressure or "
                "slip lies outside the tested range; the friction is extrapolated there."
            )
    gross = results[0].governing.capacities.gross_slip_capacity
    if gross == gross:
        yield (
            "The capacity at gross slip extrapolates the friction law, often far outside any "
            "tested slip; do not design by it."
        )
    yield from method_remarks(results)
    limits = distinct(
        named("creep_limit", limit) for limit in sorted(r.arc.creep_limit for r in results[0])
    )
    yield (
        f"The creep limit ({', '.join(limits)}) is a limit of practice, not of strength; "
        "this note does not check shaft, shell, or the belt's splice."
    )
