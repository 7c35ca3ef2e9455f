"""Follow a station through an event; what is kept does not grow with the event's length."""

from __future__ import annotations

import math
from collections.abc import Callable

from wraparc.errors import InputError, Problem, input_error, name_remedy, shown
from wraparc.motion.checkpoint import Checkpoint
from wraparc.motion.event import Event, Measured, OnDrum, Start
from wraparc.motion.march import March
from wraparc.motion.recorder import Recorder, Sink
from wraparc.motion.result import Outcome, RunResult
from wraparc.motion.station import Station
from wraparc.motion.station_state import HaltError
from wraparc.units import display

#: Steps that a wave of the fastest thing asked for needs.
_STEPS_A_WAVE = 16
#: Part of the shortest wrap that the lagging may move in a step.
_A_STEP = 0.25
#: Steps of a run at most: hours of computing.
_MOST_STEPS = 20_000_000
#: Steps between two looks at progress and checkpoint.
_NOW_AND_THEN = 50


def simulate(
    station: Station,
    event: Event,
    *,
    step: float | None = None,
    points: int = 100,
    every: float | None = None,
    sink: Sink | None = None,
    progress: Callable[[float], bool | None] | None = None,
    checkpoint: Checkpoint | None = None,
) -> RunResult:
    """Follow a station through an event.

    Parameters
    ----------
    station
        What moves.
    event
        What happens.
    step
        Time step [s]; None for 7 % of the shortest wrap a step at running speed, in parts where
        much happens (a start begins, tensions and speeds turn, fresh lagging reaches the exit),
        and for one piece of lagging a step where something turns with a drum, rides on the belt
        or follows with a delay.
    points
        Pieces of lagging on the shortest wrap: the error falls with their square.
    every
        Time between the rows that are kept or streamed [s]; None for every step.
    sink
        Called with every row: time, belt speed, then for every drum entry and exit tension, speed,
        torque, exit creep, exit slip and peak shear stress, see
        `wraparc.motion.recorder.row_names`.
    progress
        Called with the part of the event that is done, now and then; True cancels the run.
    checkpoint
        Where the state of the run is saved now and then. If it is there already, a run that was
        broken off or cancelled goes on from it, bit for bit; it goes with the end of the run.

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
    Second order in points and step; the step that is chosen errs less than 100 points do.
    Quasi-static belt on the drums, one mass for the conveyor, no viscoelastic rubber, no friction
    that depends on speed or on rest.
    """
    check_event(station, event)
    march = March(station, event, step, points, every)
    _check_step(march, event)
    _check_steps(march, event)
    _check_ramps(march, event)
    recorder = Recorder(march, every or march.h, None if checkpoint else sink)
    if checkpoint is not None:
        checkpoint.begin(march, recorder, sink)
    outcome, reason = Outcome.WHOLE, ""
    total = max(math.ceil(event.duration / march.h - 1e-9), 1)
    for count in range(recorder.count + 1, total + 1):
        try:
            march.step()
        except HaltError as halt:
            outcome, reason = _told(halt, march.t)
            break
        recorder.take(count == total)
        if count % _NOW_AND_THEN:
            continue
        if checkpoint is not None:
            checkpoint.due(march, recorder)
        if progress is not None and progress(count / total):
            outcome, reason = Outcome.CANCELLED, f"Run stopped at {march.t:.3g} s: cancelled"
            break
    if checkpoint is not None:
        checkpoint.end(march, recorder, whole=outcome is not Outcome.CANCELLED)
    return recorder.result(outcome, reason, recorder.count)


def _told(halt: HaltError, t: float) -> tuple[Outcome, str]:
    if halt.what == "gross slip":
        return Outcome.BREAKAWAY, f"Gross slip on {halt.place} at {t:.4g} s"
    if halt.what == "turns back":
        return Outcome.TURNED_BACK, f"Pulley {halt.place} turns back at {t:.4g} s"
    return Outcome.SLACK, f"Belt goes slack {halt.place} at {t:.4g} s"


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
                message="missing: starts and stops need it",
                remedy='Write conveyor_mass = "120 t": belt, load and idlers.',
            )
        )
    if len({h.at for h in moves}) < len(moves):
        problems.append(Problem(key="event", message="two starts or stops begin together"))
    for thing in (*event.of(OnDrum), *event.of(Measured)):
        name = getattr(thing, "pulley", "")
        if name not in station.names:
            remedy = name_remedy(name, station.names)
            problems.append(
                Problem(
                    key="event.pulley", value=shown(name), message="no such pulley", remedy=remedy
                )
            )
    measured = [h.pulley for h in event.of(Measured) if isinstance(h, Measured)]
    if len(set(measured)) < len(measured):
        message = "one pulley has two records"
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
            order = max(order, 2.0 * math.pi * d.arc.arc.radius / thing.joint_width)
        frequency = order * d.duty.speed / (2.0 * math.pi)
        if frequency > fastest:
            fastest, what = frequency, thing.pulley
    if fastest and march.h > 1.0 / (_STEPS_A_WAVE * fastest):
        need = 1.0 / (_STEPS_A_WAVE * fastest)
        raise input_error(
            key="step",
            value=display(march.h, "time"),
            message=f"too coarse for {fastest:.3g} Hz at {what}",
            remedy=f"Take {display(0.99 * need, 'time', digits=2)} or less.",
        )


def _check_steps(march: March, event: Event) -> None:
    """Refuse a step that is too coarse for the wraps, or far too fine for the event."""
    shortest = min(d.arc.shape.length for d in march.drums)
    steps = event.duration / march.h
    if march.h * march.speed > _A_STEP * shortest or steps > _MOST_STEPS:
        message = f"{steps:,.0f} steps, more than {_MOST_STEPS:,}"
        remedy = "Take a longer step, or a shorter event."
        if steps <= _MOST_STEPS:
            least = _A_STEP * shortest / march.speed
            message = f"too coarse for a wrap of {display(shortest, 'length', digits=3)}"
            remedy = f"Take {display(0.99 * least, 'time', digits=2)} or less."
        raise input_error(
            key="step", value=display(march.h, "time"), message=message, remedy=remedy
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
            f"the start needs {display(need, 'force')}, the motors give {display(given, 'force')}"
        )
        least = moved * steepest * march.speed / max(given - march.pull, 1e-9)
        remedy = f"Start in {display(1.01 * least, 'time', digits=3)}, or raise torque_limit."
        if given <= march.pull:  # not even the load is carried
            remedy = "Lower the load, or raise torque_limit."
        raise input_error(key=f"motion.event.{event.name}", message=message, remedy=remedy)
