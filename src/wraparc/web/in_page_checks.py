"""How the page judges a drive that it has solved: by the checks of the program, translated whole.

What the checks ask of the solver is among the numbers of an arc, `Found`, which the page has from
`in_page.judged`: functions that take it from there stand in the place of those that solve
(`tools/page_kernel.py`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, cast

from wraparc.arc import ArcResult, Capacities, DriveResult, Energy, Status, WrapArc
from wraparc.arc.grip import Rise
from wraparc.arc.sliding import Sliding
from wraparc.checks.check import Check, Level
from wraparc.checks.gross_slip import rises
from wraparc.checks.of_arc import INTERVAL, INTERVAL_NOUN
from wraparc.checks.of_data import WEAK_KINDS, law_words, weak_sources
from wraparc.checks.of_wet import estimate_factor
from wraparc.checks.rule import At, Spot, idle
from wraparc.checks.verdict import Verdict
from wraparc.drive import Drive
from wraparc.train import Train, TrainCase
from wraparc.train.result import drive_with
from wraparc.train.train import Pair
from wraparc.train.unsolved import load_case
from wraparc.web.in_page import Criteria, Found, Given

nan = math.nan


@dataclass(frozen=True, eq=False, kw_only=True)
class FoundArc(ArcResult):
    """An arc that the page has solved."""

    found: Found

    @property
    def covered_creep(self) -> float:
        """Creep at the exit with the belt cover in series [m]."""
        return self.found.covered_creep

    @property
    def creep_interval(self) -> tuple[float, float]:
        """Nan: the page does not find it."""
        return nan, nan


def arcs_of(drive: Drive) -> list[WrapArc]:
    """Return every arc of a drive, load case by load case.

    Raises
    ------
    InputError
        If a law is unfit for an arc.
    """
    return [WrapArc.of(drive, p, case) for case in drive.load_cases for p in drive.pulleys]


def given_of(drive: Drive, arc: WrapArc) -> Given:
    """Return the numbers of a drive that one of its arcs depends on."""
    of = arc.described()
    return Given(
        entry_tension=of.entry_tension,
        exit_tension=of.exit_tension,
        effective_tension=nan,
        torque=nan,
        power=nan,
        diameter=of.diameter,
        wrap_angle=of.wrap_angle,
        overrun=of.overrun,
        recovery=of.recovery,
        width=of.width,
        modulus=drive.belt.modulus,
        speed=_known(drive.belt.speed),
        thickness=of.thickness,
        shear_modulus=of.shear_modulus,
        compression_modulus=of.compression_modulus,
        wear_coefficient=of.wear_coefficient,
        creep_limit=arc.creep_limit,
        steepest_fall=arc.law.steepest_fall(),
        pitch_offset=of.pitch_offset,
        cover_compliance=arc.cover_compliance,
        mass=_known(drive.belt.mass),
        slip_with_shear=arc.slip_with_shear,
        belt_speed=of.belt_speed,
    )


def _known(value: float | None) -> float:
    return nan if value is None else value


def criteria_of(drive: Drive, arcs: Sequence[WrapArc], index: int) -> Criteria:
    """Return what the checks ask of the grip of one of the arcs of a load case."""
    arc = arcs[index]
    case, pulley = drive.load_case(arc.load_case), drive.pulley(arc.pulley)
    conditioned = drive.in_case(case)
    rise = rises(arcs, index, drive.criteria.take_up)
    return Criteria(
        safety=drive.criteria.safety.of(case.kind),
        tight_rise=rise.tight,
        slack_rise=rise.slack,
        cover=arc.cover_left_out,
        strength=_known(drive.belt.breaking_strength) * arc.width,
        pulley_mass=_known(pulley.mass),
        wet=estimate_factor(
            At(drive=conditioned, case=case, pulley=conditioned.pulley(pulley.name))
        ),
    )


def result_of(arc: WrapArc, found: Found) -> FoundArc:
    """Return an arc as the checks take it."""
    of = found.summary
    return FoundArc(
        status=Status.SOLVED if found.solved else Status.BREAKAWAY,
        method="distributed",
        arc=arc,
        profile=cast(Any, None),
        entry_tension=of.entry_tension,
        exit_tension=of.exit_tension,
        exit_creep=of.exit_creep,
        creep_shrinkage=of.creep_shrinkage,
        creep_compression=of.creep_compression,
        creep_global=of.creep_global,
        exit_slip=of.exit_slip,
        entry_creep_ratio=of.entry_creep_ratio,
        exit_creep_ratio=of.exit_creep_ratio,
        peak_shear_stress=of.peak_shear_stress,
        peak_shear_angle=of.peak_shear_angle,
        peak_shear_position=of.peak_shear_position,
        mean_friction=of.mean_friction,
        active_arc=of.active_arc,
        outside_tested_share=of.outside_tested_share,
        stuck_arc=of.stuck_arc,
        capacities=cast(Capacities, found.capacities),
        energy=cast(Energy, of),
        found=found,
    )


def results_of(drive: Drive, arcs: Sequence[WrapArc], found: Sequence[Found]) -> DriveResult:
    """Return a drive as the checks take it."""
    every = tuple(result_of(arc, numbers) for arc, numbers in zip(arcs, found, strict=True))
    return DriveResult(drive, every)


def train_drive(train: Train, case: TrainCase, pairs: Sequence[Pair]) -> Drive:
    """Return a train as a drive in a load case with the tensions of its pulleys."""
    return drive_with(train, [load_case(train, case, [(at.entry, at.exit) for at in pairs])])


def running_at(arcs: Sequence[WrapArc], speeds: Sequence[float]) -> list[WrapArc]:
    """Return arcs with the speeds that the belt meets their pulleys with, nan if unknown [m/s]."""
    return [
        replace(arc, belt_speed=None if math.isnan(speed) else speed)
        for arc, speed in zip(arcs, speeds, strict=True)
    ]


def alone(drive: Drive, name: str) -> Drive:
    """Return a drive in one of its load cases, the first if there is none of that name."""
    cases = [case for case in drive.load_cases if case.name == name]
    return replace(drive, load_cases=tuple([*cases, *drive.load_cases][:1]))


def weak_kinds(drive: Drive) -> list[str]:
    """Return in what ways the data of a drive is weak, each once."""
    found: list[str] = []
    for pulley in drive.pulleys:
        grounds, _ = law_words(pulley.lagging)
        found += [*grounds, *(weak[0] for weak in weak_sources(drive, pulley))]
    return [kind for kind in WEAK_KINDS if kind in found]


def remarks_of(drive: Drive, verdict: Verdict) -> list[str]:
    """Return on what data an answer of the page stands, and what it does not find of a fit."""
    left = (_NO_INTERVAL.format(of.name) for of in drive.laggings if of.fit and of.fit.knots)
    return [*verdict.remarks, *dict.fromkeys(left)]


_NO_INTERVAL = (
    "The interval of the creep that the fit of {} leaves is not calculated in this page, but "
    "by wraparc solve."
)


def idle_in(drive: Drive) -> bool:
    """Whether some pulley has no pull to carry: the page leaves such a drive to the program."""
    return any(idle(arc) for arc in arcs_of(drive))


# In the place of others.


def sliding(result: FoundArc, _rise: Rise | None = None) -> Sliding:
    """Return where the belt slides, as the tensions of the arc rise with the pull."""
    return Sliding(result.found.place, result.found.cause)


def lift(result: FoundArc, _factor: float, _tight_rise: float) -> float:
    """Return by how much all tensions must rise for the safety factor [N]."""
    return result.found.lift


def least_with_slip(result: FoundArc, _limit: float) -> float:
    """Return the least slack-side tension with which the slip keeps the end of the tests [N]."""
    return result.found.least_for_slip


def least_when_covered(result: FoundArc) -> float:
    """Return the least slack-side tension for the creep with the cover in series [N]."""
    return result.found.least_when_covered


def least_when_wet(result: FoundArc, factor: float) -> float:
    """Return the least slack-side tension for the creep when wet [N]; nan without a factor."""
    return result.found.least_when_wet if factor > 0.0 else nan


def least_by_interval(_arc: WrapArc, _least: float) -> float:
    """Return nan: the page does not find the interval."""
    return nan


def wet(result: FoundArc, _factor: float) -> float:
    """Return the creep at the exit when wet [m]."""
    return result.found.wet


def largest_slip(result: FoundArc) -> float:
    """Return the largest slip along the arc [m]."""
    return result.found.largest_slip


def slip_speed(result: FoundArc) -> float:
    """Return the largest speed of the belt on the lagging [m/s]."""
    return result.found.slip_speed


def creep_interval(of: Spot) -> Iterator[Check]:
    """Say of a fitted law what is left to the program: no bare OK."""
    fit = None if of.result is None else of.result.arc.fit
    if fit is None or not fit.knots:
        return
    yield Check(
        name="creep_interval",
        title=INTERVAL,
        level=Level.ATTENTION,
        place=of.place,
        noun=INTERVAL_NOUN,
        headline="Creep, 95 % bound, is not computed in this page",
        action="Solve the file with wraparc solve.",
        label="95 % bound not computed",
        binding=False,
    )


def across(_result: object) -> Iterator[Check]:
    """Yield nothing: the page solves no load across the width."""
    yield from ()


def no_table(*_of: object) -> None:
    """Return no table: it tells of what the page does not solve, or has no profile for."""
