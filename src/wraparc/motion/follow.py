"""Follow a station through an event; what is kept does not grow with the event's length."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from wraparc.batch.native import available
from wraparc.errors import InputError, Problem
from wraparc.motion import arc_kernel as k
from wraparc.motion.drum_state import DrumState
from wraparc.motion.event import Event, Measured, OnDrum, Start
from wraparc.motion.march import March
from wraparc.motion.result import Array, DrumHistory, Outcome, RunResult
from wraparc.motion.station import Station
from wraparc.motion.station_state import HaltError
from wraparc.units import display

#: Rows and pictures that are kept at most; when there are more, every other one is dropped.
_ROWS, _PICTURES, _ACROSS = 4000, 240, 61
#: Steps that a wave of the fastest thing asked for needs.
_STEPS_A_WAVE = 16

Sink = Callable[[Sequence[float]], None]


def simulate(
    station: Station,
    event: Event,
    *,
    step: float | None = None,
    points: int = 100,
    every: float | None = None,
    sink: Sink | None = None,
    progress: Callable[[float], bool | None] | None = None,
) -> RunResult:
    """Follow a station through an event.

    Parameters
    ----------
    station
        What moves.
    event
        What happens.
    step
        Time step [s]; None for one piece of lagging a step at running speed.
    points
        Pieces of lagging on the shortest wrap: the error falls with their square.
    every
        Time between the rows that are kept or streamed [s]; None for every step.
    sink
        Called with every row: time, belt speed, then for every drum entry and exit tension, speed,
        torque, exit creep, exit slip and peak shear stress (see `wraparc.motion.follow.row_names`).
    progress
        Called with the part of the event that is done, now and then; True cancels the run.

    Returns
    -------
    The run. A belt that goes slack or a drive that breaks away on the way is an answer: the run is
    kept up to there.

    Raises
    ------
    InputError
        If the event needs what the station has not, or the step is too coarse for it.

    Notes
    -----
    Second order in step and points. Quasi-static belt on the drums, one mass for the conveyor, no
    viscoelastic rubber, no friction that depends on speed or on rest.
    """
    check_event(station, event)
    march = March(station, event, step, points)
    _check_step(march, event)
    _check_ramps(march, event)
    keeper = _Keeper(march, every or march.h, sink)
    outcome, reason = Outcome.WHOLE, ""
    total = max(math.ceil(event.duration / march.h - 1e-9), 1)
    for count in range(1, total + 1):
        try:
            march.step()
        except HaltError as halt:
            outcome, reason = _told(halt, march.t)
            break
        keeper.take(count == total)
        if progress is not None and count % 50 == 0 and progress(count / total):
            outcome, reason = Outcome.CANCELLED, f"Cancelled at {march.t:.3g} s."
            break
    return keeper.result(outcome, reason, keeper.count)


def row_names(station: Station) -> list[str]:
    """Names of the numbers of a row, with their units."""
    names = ["time [s]", "belt speed [m/s]"]
    for name in station.names:
        names += [f"{name}: {what}" for what in _COLUMNS]
    return names


_COLUMNS = (
    "entry tension [N]",
    "exit tension [N]",
    "drum speed [rad/s]",
    "torque [N m]",
    "exit creep [m]",
    "exit slip [m]",
    "peak shear stress [Pa]",
)


def _told(halt: HaltError, t: float) -> tuple[Outcome, str]:
    if halt.what == "breaks away":
        return Outcome.BREAKAWAY, f"{halt.place} breaks away at {t:.4g} s."
    if halt.what == "turns back":
        return Outcome.TURNED_BACK, f"The drum of {halt.place} turns back at {t:.4g} s."
    return Outcome.SLACK, f"The belt goes slack {halt.place} at {t:.4g} s."


def check_event(station: Station, event: Event) -> None:
    """Refuse an event that the station cannot follow.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    problems = []
    moves = [h for h in event.of(Start) if isinstance(h, Start)]
    if moves and station.conveyor_mass is None:
        problems.append(
            Problem(
                key="motion.conveyor_mass",
                message="missing: a start or stop needs the mass that is moved",
                remedy='Write for example conveyor_mass = "120 t": belt, load and idlers.',
            )
        )
    if len({h.at for h in moves}) < len(moves):
        problems.append(Problem(key="event", message="two starts or stops begin at the same time"))
    for thing in (*event.of(OnDrum), *event.of(Measured)):
        name = getattr(thing, "pulley", "")
        if name not in station.names:
            there = ", ".join(f'"{n}"' for n in station.names)
            problems.append(
                Problem(
                    key="event.pulley",
                    value=f'"{name}"',
                    message=f"no such pulley; the pulleys are {there}",
                )
            )
    measured = [h.pulley for h in event.of(Measured) if isinstance(h, Measured)]
    if len(set(measured)) < len(measured):
        message = "two records for one drum: its speed and its torque cannot both be given"
        problems.append(Problem(key="event.measured", message=message))
    if problems:
        raise InputError(problems)


def _check_step(march: March, event: Event) -> None:
    """Refuse a step that is too coarse for what turns with the drums."""
    fastest, what = 0.0, ""
    for thing in event.of(OnDrum):
        if not isinstance(thing, OnDrum):
            continue
        d = march.drums[march.station.index(thing.pulley)]
        order = thing.order if thing.run_out or thing.ripple else 0.0
        if thing.joint_rise:
            order = max(order, 2.0 * math.pi * d.radius / thing.joint_width)
        frequency = order * d.duty.speed / (2.0 * math.pi)
        if frequency > fastest:
            fastest, what = frequency, thing.pulley
    if fastest and march.h > 1.0 / (_STEPS_A_WAVE * fastest):
        need = 1.0 / (_STEPS_A_WAVE * fastest)
        raise InputError(
            Problem(
                key="step",
                value=display(march.h, "time"),
                message=f"too coarse for {fastest:.3g} Hz at {what}",
                remedy=f"Take {display(0.99 * need, 'time', digits=2)} or less.",
            )
        )


def _check_ramps(march: March, event: Event) -> None:
    """Refuse a start that asks for more than the limits of the motors give altogether."""
    station, drums = march.station, march.drums
    given = math.fsum(
        own.control.most_torque(d.duty) / d.radius
        for own, d in zip(station.drums, drums, strict=True)
    )
    moved = (station.conveyor_mass or 0.0) + math.fsum(d.inertia / d.radius**2 for d in drums)
    for start in event.of(Start):
        if not isinstance(start, Start) or type(start) is not Start or start.time <= 0.0:
            continue
        steepest = {"ramp": 1.0, "s-curve": 0.5 * math.pi}.get(start.shape)
        if steepest is None or math.isinf(given):
            continue
        need = march.pull + moved * steepest * march.speed / start.time
        if need <= given:
            continue
        message = (
            f"a start in {display(start.time, 'time', digits=3)} needs {display(need, 'force')} at "
            f"the belt; the torque limits of the motors give {display(given, 'force')}"
        )
        least = moved * steepest * march.speed / max(given - march.pull, 1e-9)
        remedy = f"Take {display(1.01 * least, 'time', digits=3)} or more, or"
        if given <= march.pull:  # not even the load is carried
            remedy = "Lower the load, or"
        remedy += " raise torque_limit or rated_torque of the motors."
        raise InputError(Problem(key=f"motion.event.{event.name}", message=message, remedy=remedy))


@dataclass
class _Keeper:
    """Keeps rows and pictures; thins them out when there are too many."""

    march: March
    every: float
    sink: Sink | None
    rows: list[list[float]] = field(default_factory=list)
    pictures: list[tuple[float, list[Array], list[Array]]] = field(default_factory=list)
    work: list[float] = field(default_factory=list)
    count: int = 0

    def __post_init__(self) -> None:
        self.between = self.every
        self.next = self.next_picture = 0.0
        self.between_pictures = max(self.march.event.duration / _PICTURES, self.march.h, self.every)
        self.streamed = -math.inf
        self.work = [0.0] * self.march.n
        self.power = [0.0] * self.march.n
        self.across = np.linspace(0.0, 1.0, _ACROSS)
        self.travel0 = [d.arc.travel for d in self.march.drums]
        for d in self.march.drums:
            d.arc.work = 0.0
        self.take(False)
        self.count = 0

    def take(self, last: bool) -> None:
        """Take what the march has come to."""
        m = self.march
        self.count += 1
        for i, d in enumerate(m.drums):
            power = d.moment * d.omega
            self.work[i] += 0.5 * m.h * (self.power[i] + power) if self.rows else 0.0
            self.power[i] = power
        if m.t >= self.next - 1e-9 or last:
            row = self._row()
            if self.sink is not None and (m.t >= self.streamed + self.every - 1e-9 or last):
                self.sink(row)
                self.streamed = m.t
            self.rows.append(row)
            self.next = m.t + self.between
            if len(self.rows) > _ROWS and not last:
                self.rows = self.rows[::2]
                self.between *= 2.0
        elif self.sink is not None and m.t >= self.streamed + self.every - 1e-9:
            self.sink(self._row())
            self.streamed = m.t
        if m.t >= self.next_picture - 1e-9 or last:
            self._picture()

    def _row(self) -> list[float]:
        m = self.march
        row = [m.t, m.v if m.station.conveyor_mass is not None else m.speed]
        for i, d in enumerate(m.drums):
            slip, stress, shear = _exit_of(d)
            creep = slip + d.arc.shape.shear * stress
            entry = m.T[i] + m.run_rises[i]
            row += [entry, m.T[i + 1], d.omega, d.torque, creep, slip, shear]
        return row

    def _picture(self) -> None:
        m, creep, shear = self.march, [], []
        for d in m.drums:
            place = d.arc.place() / d.arc.shape.length
            creep.append(np.interp(self.across, place, d.arc.creep()))
            shear.append(np.interp(self.across, place, d.arc.along(k.STRESS)))
        self.pictures.append((m.t, creep, shear))
        self.next_picture = m.t + self.between_pictures
        if len(self.pictures) > 2 * _PICTURES:
            self.pictures = self.pictures[::2]
            self.between_pictures *= 2.0

    def result(self, outcome: Outcome, reason: str, steps: int) -> RunResult:
        """Return everything, frozen."""
        m = self.march
        table = np.array(self.rows)
        width = len(_COLUMNS)
        columns = [table[:, 2 + width * i : 2 + width * (i + 1)] for i in range(m.n)]
        pulls = [c[:, 0] - c[:, 1] for c in columns]
        total = np.sum(pulls, axis=0)
        small = np.abs(total) < 1e-3 * abs(m.pull)
        drums = []
        for i, c in enumerate(columns):
            share = np.where(small, np.nan, pulls[i] / np.where(small, 1.0, total))
            entry, exit_, speed, torque, creep, slip, shear = (
                _frozen(c[:, j]) for j in range(width)
            )
            drums.append(
                DrumHistory(
                    name=m.station.names[i],
                    entry_tension=entry,
                    exit_tension=exit_,
                    speed=speed,
                    torque=torque,
                    share=_frozen(share),
                    exit_creep=creep,
                    exit_slip=slip,
                    peak_shear=shear,
                    place=_frozen(self.across),
                    creep=_frozen(np.array([p[1][i] for p in self.pictures])),
                    shear=_frozen(np.array([p[2][i] for p in self.pictures])),
                    friction_energy=m.drums[i].arc.work,
                    drum_work=self.work[i],
                )
            )
        return RunResult(
            station=m.station,
            event=m.event,
            outcome=outcome,
            reason=reason,
            time=_frozen(table[:, 0]),
            drums=tuple(drums),
            belt_speed=_frozen(table[:, 1]),
            picture_time=_frozen(np.array([p[0] for p in self.pictures])),
            step=m.h,
            steps=steps,
            belt_error=self._belt_error(),
            build_distance=self._build_distance(table, columns),
            compiled=available(),
        )

    def _belt_error(self) -> float:
        """Unstretched belt won or lost, over the stretch of the belt in the train."""
        m = self.march
        if m.station.conveyor_mass is None or m.station.take_up != "fixed":
            return math.nan
        return abs(m.belt() - m.belt_before) / abs(m.belt_before)

    def _build_distance(self, table: Array, columns: list[Array]) -> float:
        if not self.march.event.from_rest or len(table) < 3:
            return math.nan
        travel = np.concatenate(
            [[0.0], np.cumsum(0.5 * np.diff(table[:, 0]) * (table[1:, 1] + table[:-1, 1]))]
        )
        worst = 0.0
        for c in columns:
            creep = c[:, 4]
            off = np.nonzero(np.abs(creep - creep[-1]) > 0.05 * abs(creep[-1]))[0]
            worst = max(worst, float(travel[min(off[-1] + 1, len(travel) - 1)]) if len(off) else 0)
        return worst


def _exit_of(d: DrumState) -> tuple[float, float, float]:
    """Slip and shear stress at the exit nip, and the largest shear stress with its sign."""
    arc = d.arc
    first, nip = int(arc.span[0]), int(arc.span[1])
    a, b = arc.rows[first], arc.rows[first + 1]
    w = (arc.shape.length - arc.travel + b[k.TRAVEL]) / (b[k.TRAVEL] - a[k.TRAVEL])
    stress = b[k.STRESS] + w * (a[k.STRESS] - b[k.STRESS])
    slip = b[k.SLIP] + w * (a[k.SLIP] - b[k.SLIP])
    stresses = arc.rows[first + 1 : nip + 1, k.STRESS]
    top = float(stresses[np.argmax(np.abs(stresses))])
    shear = top if abs(top) > abs(stress) else float(stress)
    return float(slip), float(stress), shear


def _frozen(values: Array) -> Array:
    values = np.ascontiguousarray(values)
    values.setflags(write=False)
    return values
