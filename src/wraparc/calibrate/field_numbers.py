"""Field numbers: what a healthy drive shows, when to alarm, how long the lagging lasts."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from wraparc.arc import ArcResult, Distributed
from wraparc.calibrate.problem import strain_of, tachometer_ratio
from wraparc.drive.load_case import hours_problems
from wraparc.drive.pitch import turns_an_hour
from wraparc.errors import InputError, Problem, input_error
from wraparc.provenance import Kind, Provenance


@dataclass(frozen=True, kw_only=True)
class TripRule:
    """A customary rule of when to stop a drive: belt speed over its full speed [-]."""

    name: str
    speed_share: float
    source: Provenance


#: Rules that speed switches are set by, to set beside what the drive really shows.
TRIP_RULES = (
    TripRule(
        name="80 % of full speed",
        speed_share=0.80,
        source=Provenance(
            Kind.PUBLISHED,
            "South Africa, Mine Health and Safety Act, guideline for conveyor belt installations "
            "(R.1024), annexure B, belt slip protection",
            note="trips when the belt speed is below 80 % of full speed; for constant speed, "
            "bypassed when starting and stopping",
        ),
    ),
    TripRule(
        name="95 % of full speed",
        speed_share=0.95,
        source=Provenance(
            note="customary in practice (belt not under 95 % of the pulley), no source"
        ),
    ),
)


@dataclass(frozen=True, kw_only=True)
class FieldNumbers:
    """Speeds, alarm levels and wear of one pulley.

    Attributes
    ----------
    healthy
        Drum less belt speed over drum speed by load case, of the belt before the drum and behind
        it [-], see `speed_differences`.
    at_limit
        Size of the difference behind the drum at the creep limit in the load case that gets there
        first, of those that pull as the one that creeps most; None if none gets there [-].
    at_breakaway
        Creep at gross slip over the length of the wrap, None if no finite creep attains it [-].
    alarm, trip
        Speed differences over the drum speed that follow [-], see `field_numbers`.
    wear_per_year
        Depth worn off in a year [m], nan without a wear coefficient.
    life_years
        Years until the depth allowed is worn off, nan without a wear coefficient [years].
    energy_per_year
        Frictional energy per area of lagging in a year [J/m2].
    passes_per_year
        Passages under the belt in a year.
    diameter
        Over the lagging, that the levels are for [m].
    depth
        Depth of lagging that may be worn off [m].
    pitch
        (R - delta + e)/R where the alarm is set, at which the belt runs, over the radius that a
        shaft is compared with [-]; 1 where the thickness of the belt is not known: the levels then
        compare the belt with the lagging surface.
    shown
        What a tachometer pair shows of `healthy`, 1 - v/(omega R) by load case [-]; None where the
        thickness of the belt is not known.
    limits
        Difference behind the drum at the creep limit by load case, its size and as it is seen [-]:
        the compression of the lagging shifts what a tachometer pair shows by the tension.
    covered
        `worst_seen` with the cover of the belt in series, inf or -inf where the belt slips through;
        None where the law says whether its slip includes that shear [-].
    """

    healthy: Mapping[str, tuple[float, float]] = field(hash=False)
    at_limit: float | None
    at_breakaway: float | None
    alarm: float
    trip: float
    wear_per_year: float
    life_years: float
    energy_per_year: float
    passes_per_year: float
    diameter: float
    depth: float
    pitch: float = 1.0
    shown: Mapping[str, tuple[float, float]] | None = field(default=None, hash=False)
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict, hash=False)
    covered: float | None = None

    @property
    def side(self) -> float:
        """-1 where the belt runs ahead of a drum that it drives and levels are below, else 1."""
        ratios = [ratio for pair in self.healthy.values() for ratio in pair]
        return -1.0 if max(ratios, key=abs) < 0.0 else 1.0

    @property
    def worst_seen(self) -> float:
        """Healthy ratio nearest to the alarm, as a tachometer pair shows it [-]."""
        seen = self.healthy if self.shown is None else self.shown
        return self.side * max(self.side * ratio for pair in seen.values() for ratio in pair)

    def alarms_at(self, seen: float) -> bool:
        """Whether a ratio is beyond the alarm, more than rounding makes [-]."""
        return self.side * (seen - self.seen(self.alarm, 0.0)) > 1e-12

    def worn_seen(self, worn: float) -> float:
        """Return the healthy ratio nearest to the alarm by a worn lagging [-].

        Parameters
        ----------
        worn
            Depth w worn off since the diameter was measured [m].
        """
        return self.worst_seen + (1.0 - self.side * self.worst) * worn * self.drift

    @property
    def drift(self) -> float:
        """Rise of every ratio per depth that is worn off since the diameter was measured [1/m]."""
        return 2.0 / self.diameter

    @property
    def worst(self) -> float:
        """Largest healthy difference [-]."""
        return max(max(abs(a), abs(b)) for a, b in self.healthy.values())

    def seen(self, difference: float, worn: float) -> float:
        """Difference that shaft speed and the unworn diameter show, by a worn lagging [-].

        1 - (1 - d)(R - delta + e - w)/R: the belt runs at the pitch radius, which wear lessens.

        Parameters
        ----------
        difference
            True difference d of drum surface and belt over the drum [-].
        worn
            Depth w worn off since the diameter was measured [m].
        """
        share = self.pitch - 2.0 * worn / self.diameter
        return 1.0 - (1.0 - self.side * difference) * share

    @property
    def wear_to_alarm(self) -> float:
        """Depth worn since the diameter was measured that alarms by itself [m].

        inf on a brake: wear raises every ratio, and its alarm is below.
        """
        if self.side < 0.0:
            return math.inf
        room = self.seen(self.alarm, 0.0) - self.worst_seen
        return max(room / ((1.0 - self.worst) * self.drift), 0.0)


def wear_coefficient(depth: float, energy: float) -> float:
    """Energetic wear coefficient from a measured wear [m3/J]: depth / frictional energy per area.

    Parameters
    ----------
    depth
        Depth worn off the lagging, > 0 [m].
    energy
        Frictional energy per area that wore it, > 0 [J/m2].

    Raises
    ------
    InputError
        If one is not positive and finite.
    """
    for key, value in (("depth", depth), ("energy", energy)):
        if not 0.0 < value < math.inf:
            raise input_error(key=key, value=f"{value:g}", message="must be positive and finite")
    return depth / energy


def field_numbers(
    results: Mapping[str, ArcResult],
    limits: Mapping[str, ArcResult],
    hours: Mapping[str, float],
    *,
    coefficient: float | None,
    depth: float,
) -> FieldNumbers:
    """Return what to expect of a drive in the field.

    The healthy difference of drum and belt speed is that of the worst load case, before the drum or
    behind it, see `speed_differences`. The **alarm** is set at the difference behind the drum at
    the creep limit, and where that is not found at the healthy one with a quarter more; the
    **trip** at gross slip or twice the alarm, whichever is less. The factors are this program's
    choice. All are ratios to the lagging surface at the entry nip; `FieldNumbers.seen` gives what a
    tachometer pair shows of them.

    Parameters
    ----------
    results
        Solved arcs of one pulley by load case.
    limits
        The same arcs at the creep limit, tight side held; those that have one.
    hours
        Hours of running in a year by load case.
    coefficient
        Energetic wear coefficient [m3/J], or None.
    depth
        Depth of lagging that may be worn off [m].

    Raises
    ------
    InputError
        If a load case breaks away, or hours are given without a belt speed.
    """
    _check(results, hours)
    healthy = {n: speed_differences(r) for n, r in results.items()}
    worst = max(max(abs(a), abs(b)) for a, b in healthy.values())
    side = max(results.values(), key=lambda r: abs(r.exit_creep_ratio)).arc.side
    limit = min((r for r in limits.values() if r.arc.side == side), key=_nearest, default=None)
    at_limit = None if limit is None else abs(speed_differences(limit)[1])
    told = limit or max(results.values(), key=lambda r: abs(r.exit_creep_ratio))
    gross = [
        r.capacities.gross_slip_creep / r.arc.length
        for r in results.values()
        if math.isfinite(r.capacities.gross_slip_creep)
    ]
    at_breakaway = min(gross, default=None)
    alarm = 1.25 * worst if at_limit is None else at_limit
    trip = 2.0 * alarm
    if at_breakaway is not None:
        trip = max(min(trip, at_breakaway), alarm)
    energy, turns = 0.0, 0.0
    for name, share in hours.items():
        r = results[name]
        n = share * turns_an_hour(r.arc.belt_speed or 0.0, r.arc.radius + r.arc.offset)
        turns += n
        energy += n * abs(r.energy.frictional_energy)
    wear = math.nan if coefficient is None else coefficient * energy
    life = depth / wear if wear > 0.0 else math.nan
    return FieldNumbers(
        healthy=healthy,
        at_limit=at_limit,
        at_breakaway=at_breakaway,
        alarm=alarm,
        trip=trip,
        wear_per_year=wear,
        life_years=life,
        energy_per_year=energy,
        passes_per_year=turns,
        diameter=next(iter(results.values())).arc.diameter,
        depth=depth,
        pitch=1.0 if told.arc.pitch_offset is None else told.arc.pitch_radius / told.arc.radius,
        shown=None
        if told.arc.pitch_offset is None
        else {name: _seen(r) for name, r in results.items()},
        limits={n: (abs(speed_differences(r)[1]), _seen(r)[1]) for n, r in limits.items()},
        covered=_covered(results, side),
    )


def speed_differences(result: ArcResult) -> tuple[float, float]:
    """Return drum less belt speed over drum speed, of the belt before the drum and behind it [-].

    g, and 1 - (1 - g)(1 + T2/EA)/(1 + T1/EA): the drum speed is that of the lagging surface where
    the belt meets it, and behind the drum the belt follows its strain alone.
    """
    g = result.entry_creep_ratio
    return g, 1.0 - (1.0 - g) * strain_of(result.arc)


def _seen(result: ArcResult) -> tuple[float, float]:
    """Both differences as a tachometer pair shows them; to the surface without thickness [-]."""
    if result.arc.pitch_offset is None:
        return speed_differences(result)
    return tachometer_ratio(result, "entry"), tachometer_ratio(result, "exit")


def _nearest(result: ArcResult) -> float:
    """Difference behind the drum as it is seen, driving positive [-]."""
    return result.arc.side * _seen(result)[1]


def _covered(results: Mapping[str, ArcResult], side: float) -> float | None:
    """Return the seen ratio nearest to the alarm with the cover of the belt in series [-]."""
    found = None
    for r in results.values():
        if r.arc.cover_left_out > 0.0:
            arc = replace(r.arc, cover_compliance=r.arc.cover_left_out, cover_left_out=0.0)
            again = Distributed(capacities=False).solve(arc)
            ends = _seen(again) if again.status.solved else (side * math.inf,)
            found = max(ends if found is None else (found, *ends), key=lambda ratio: side * ratio)
    return found


def _check(results: Mapping[str, ArcResult], hours: Mapping[str, float]) -> None:
    problems = [
        Problem(key=f"load_case.{name}", message=str(r.status))
        for name, r in results.items()
        if not r.status.solved
    ]
    problems += [
        Problem(
            key=f"hours.{name}",
            message="the drive has no such load case",
            remedy=f"It has {', '.join(results)}.",
        )
        for name in hours
        if name not in results
    ]
    problems += hours_problems(hours)
    if hours and any(r.arc.belt_speed is None for r in results.values()):
        message = "needed to count the turns in a year"
        problems.append(Problem(key="belt.speed", message=message, remedy="Add it to the drive."))
    if problems:
        raise InputError(problems)


def at_creep_limit(result: ArcResult) -> ArcResult | None:
    """Solve an arc again at its creep limit, tight side held; None if it has no such ratio."""
    ratio = result.capacities.creep_limit_capacity
    if not ratio > 1.0:
        return None
    arc = result.arc
    tight = max(arc.entry_tension, arc.exit_tension)
    slack = tight / ratio
    ends = (tight, slack) if arc.side > 0.0 else (slack, tight)
    changed = replace(arc, entry_tension=ends[0], exit_tension=ends[1])
    found = Distributed(points=60, capacities=False).solve(changed)
    return found if found.status.solved else None
