"""What a run in time gives: histories, pictures of the wrap, largest values, and how it ended."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from enum import Enum

import numpy as np

from wraparc.alike import largest, least
from wraparc.arc.result import MORE_FRICTION
from wraparc.arrays import Array
from wraparc.motion.event import Event
from wraparc.motion.station import Station


class Outcome(Enum):
    """How a run ended; the text is the sentence that the user reads."""

    WHOLE = "The event was followed to its end."
    SLACK = (
        "The belt goes slack; the run ends there. Raise the take-up tension, or start and stop "
        "more slowly."
    )
    BREAKAWAY = (
        "Gross slip: no creep gives enough friction. The run ends there. Raise the take-up "
        f"tension, start more slowly, or {MORE_FRICTION}"
    )
    TURNED_BACK = (
        "A pulley turns back, which is not modelled; the run ends there. Give the pulley a "
        "backstop or a brake."
    )
    CANCELLED = "The run was cancelled and ends there."

    @property
    def whole(self) -> bool:
        """Whether the event was followed to its end."""
        return self is Outcome.WHOLE


@dataclass(frozen=True)
class Peak:
    """The largest of something over a run.

    Attributes
    ----------
    value
        In SI.
    time
        When [s].
    place
        Name of the pulley, or of the run of belt; empty where it is clear.
    """

    value: float
    time: float
    place: str = ""


@dataclass(frozen=True)
class Extremes:
    """The largest at one drum over every step of a run, whatever rows are kept.

    Attributes
    ----------
    creep
        At the exit nip, either way [m].
    slip, slip_speed, shear
        Anywhere on the wrap, either way [m, m/s, Pa].
    pull, torque
        T1 - T2 and torque from the motor, either way [N, N m].
    most_entry_tension, most_exit_tension, least_entry_tension, least_exit_tension
        At the nips [N].
    """

    creep: Peak
    slip: Peak
    slip_speed: Peak
    shear: Peak
    pull: Peak
    torque: Peak
    most_entry_tension: Peak
    most_exit_tension: Peak
    least_entry_tension: Peak
    least_exit_tension: Peak

    @property
    def most_tension(self) -> Peak:
        """Largest tension at either nip [N]."""
        return largest((self.most_entry_tension, self.most_exit_tension), _value)

    @property
    def least_tension(self) -> Peak:
        """Least tension at either nip [N]."""
        return least((self.least_entry_tension, self.least_exit_tension), _value)


def _value(peak: Peak) -> float:
    return peak.value


#: Names of the peaks of `Extremes`, in order.
EXTREMES = tuple(f.name for f in fields(Extremes))


@dataclass(frozen=True, eq=False)
class DrumHistory:
    """One drum in time, at the times of the run; shape (k,) each.

    Attributes
    ----------
    name
        Of the pulley.
    entry_tension, exit_tension
        T1 and T2 [N].
    speed
        Of the drum [rad/s].
    torque
        From its motor [N m].
    share
        Part of the pull of all drums; nan where they hardly pull [-].
    exit_creep, exit_slip
        Creep and slip at the exit nip [m].
    peak_shear
        Largest shear stress on the wrap, with its sign [Pa].
    place
        Positions of the pictures over the wrap, 0 to 1, shape (s,) [-].
    creep, shear
        Creep [m] and shear stress [Pa] over the wrap at the times of the pictures, shape (q, s).
    extremes
        The largest creep, slip, shear stress and tensions of every step.
    over_limit
        Time that the exit creep is over its limit [s].
    friction_energy, drum_work
        Friction work on the lagging, and work of the drum on the belt [J].
    """

    name: str
    entry_tension: Array
    exit_tension: Array
    speed: Array
    torque: Array
    share: Array
    exit_creep: Array
    exit_slip: Array
    peak_shear: Array
    place: Array
    creep: Array
    shear: Array
    extremes: Extremes
    over_limit: float
    friction_energy: float
    drum_work: float

    @property
    def effective_tension(self) -> Array:
        """T1 - T2 [N]."""
        return self.entry_tension - self.exit_tension


@dataclass(frozen=True, eq=False)
class RunResult:
    """A run in time.

    Attributes
    ----------
    station, event
        What moved and what happened.
    outcome, reason
        How it ended, and when and where if before its end.
    time
        Times of the histories, shape (k,) [s].
    drums
        The drums in belt order.
    belt_speed
        Of the conveyor [m/s], shape (k,).
    picture_time
        Times of the pictures of the wraps, shape (q,) [s].
    step, steps
        Time step [s] and how many were taken.
    belt_error
        Unstretched belt won or lost over the run, over what the belt stretches; nan where belt
        runs in and out [-].
    build_distance
        Travel of the belt until the exit creep of every drum stays within 5 % of its last value,
        for a start [m]; nan for other events.
    """

    station: Station
    event: Event
    outcome: Outcome
    reason: str
    time: Array
    drums: tuple[DrumHistory, ...]
    belt_speed: Array
    picture_time: Array
    step: float
    steps: int
    belt_error: float
    build_distance: float

    def __iter__(self) -> Iterator[DrumHistory]:
        return iter(self.drums)

    def drum(self, name: str) -> DrumHistory:
        """Return the drum of a pulley."""
        return self.drums[self.station.index(name)]

    @property
    def peak_creep(self) -> Peak:
        """Largest creep at an exit nip, either way [m]."""
        drum = largest(self.drums, lambda d: d.extremes.creep.value)
        return replace(drum.extremes.creep, place=drum.name)

    @property
    def peak_tension(self) -> Peak:
        """Largest tension of the belt [N]."""
        return largest(self._tensions("most"), _value)

    @property
    def least_tension(self) -> Peak:
        """Least tension of the belt [N]."""
        return least(self._tensions("least"), _value)

    def creep_left(self) -> tuple[float, ...]:
        """Exit creep of every drum at the end of the run [m]."""
        return tuple(float(d.exit_creep[-1]) for d in self.drums)

    def energy_per_area(self, name: str) -> float:
        """Frictional energy of the event over the lagging of the drum's shell [J/m2]."""
        i = self.station.index(name)
        pulley = self.station.train.pulleys[i]
        area = np.pi * pulley.diameter * self.station.train.belt.width
        return self.drums[i].friction_energy / float(area)

    def wear_depth(self, name: str) -> float | None:
        """Wear of the lagging over the event, evenly around the shell; None if not known [m]."""
        coefficient = self.station.pulleys[self.station.index(name)].lagging.wear_coefficient
        return None if coefficient is None else coefficient * self.energy_per_area(name)

    def _tensions(self, which: str) -> Iterator[Peak]:
        """Yield the most or least tension before and behind every drum."""
        for d in self.drums:
            yield replace(getattr(d.extremes, f"{which}_entry_tension"), place=f"before {d.name}")
            yield replace(getattr(d.extremes, f"{which}_exit_tension"), place=f"behind {d.name}")
