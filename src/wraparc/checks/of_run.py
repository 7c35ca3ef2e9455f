"""The one judgement of a run in time: how it ended, and the extremes it came to on the way.

An event is judged like a load case whose tensions are its extremes, by the same rules.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np

from wraparc.arc.result import MORE_FRICTION
from wraparc.arc.sliding import SLIDES
from wraparc.checks import of_data, of_drive, of_wet
from wraparc.checks.check import Check, Level, Place, Verdict
from wraparc.checks.judge import diameters, sound
from wraparc.checks.numbers import usual
from wraparc.checks.of_arc import EXIT_CREEP, GROSS_SLIP
from wraparc.checks.of_train import MOTOR_HEAT, motor_load
from wraparc.checks.rule import Spot, Words, not_checked, origin
from wraparc.checks.rules import OF_PULLEY, spot_of
from wraparc.checks.usual import Ends, Owner, owners_of, unusual, usual_sizes
from wraparc.conveyor import GRAVITY
from wraparc.drive import Drive, LoadCase, Pulley, Tensions
from wraparc.errors import InputError
from wraparc.train import Motor, Motors
from wraparc.train.motors import MOMENTARY
from wraparc.train.result import drive_with
from wraparc.units import display, quantity

if TYPE_CHECKING:
    from wraparc.motion.event import Event
    from wraparc.motion.result import DrumHistory, RunResult
    from wraparc.motion.station import Station


#: Miss of the set speed over the belt speed with which a start or stop is over [-]; ours.
SETTLED = 0.1
#: What an AC motor bears of overload: 1.5 times its rated current for 2 min (IEC 60034-1), as loss
#: beyond that at rated torque over it, times time [s].
HEAT = (1.5**2 - 1.0) * 120.0
HEATING = "Heating of the motors beyond their rating"
_LAST = 0.1  # of the run: what lasts

_told: WeakKeyDictionary[RunResult, Verdict] = WeakKeyDictionary()
_otherwise: WeakKeyDictionary[RunResult, tuple[Otherwise, ...]] = WeakKeyDictionary()
#: A length that the file leaves out is tried so many times as long: 50 m of belt, or 200 m.
LONGER = 4.0
#: Largest pull over the weight of what it moves: the steepest slope and a quick start [-].
PULL_OVER_WEIGHT = (0.0, 1.2)
#: Inertia of drums, gears and motors at the belt, over the mass of the conveyor [-].
DRUMS_OVER_CONVEYOR = (0.001, 4.0)


class Otherwise(NamedTuple):
    """A length of [motion] that a file leaves out, and what another would make of a run.

    Attributes
    ----------
    key
        Of the file.
    taken, other
        The length by default, and the one tried [m].
    tension
        Largest belt tension with that [N].
    """

    key: str
    taken: float
    other: float
    tension: float


def judge_run(run: RunResult) -> Verdict:
    """Return every check of a run over its whole length, and so its verdict.

    The same run is judged once, however often it is asked about.
    """
    if run not in _told:
        _told[run] = Verdict(sound(tuple(_checks(run)), None))
    return _told[run]


def otherwise(run: RunResult) -> tuple[Otherwise, ...]:
    """Return what the largest tension would be with other lengths than those taken by default.

    The same event followed again, coarsely and until after its peak, with each length that the file
    leaves out `LONGER` times as large.
    """
    from wraparc.motion.follow import simulate
    from wraparc.motion.result import Outcome

    station, event = run.station, run.event
    if not station.taken or not event.moves or station.conveyor_mass is None:
        return ()
    if run.outcome is Outcome.CANCELLED:  # the user has ended it
        return ()
    if run not in _otherwise:
        until = min(event.duration, 3.0 * run.peak_tension.time + 5.0)
        found = []
        for key in station.taken:
            length = getattr(station, key)
            other = replace(station, **{key: LONGER * length})
            again = simulate(other, replace(event, duration=until), points=20)
            found.append(Otherwise(key, length, LONGER * length, again.peak_tension.value))
        _otherwise[run] = tuple(found)
    return _otherwise[run]


def _checks(run: RunResult) -> Iterator[Check]:
    case = _case(run)
    drive = drive_with(run.station.train, [case]).in_case(case)
    yield from _end(run)
    slackest = min(_slack_ends(run))
    for pulley, drum in zip(drive.pulleys, run, strict=True):
        spot = _spot(drive, case, pulley, drum, slackest)
        yield from _creeps(drive, pulley, drum, spot.place, bool(run.event.moves))
        for rule in OF_PULLEY:
            yield from rule.checks(spot) if rule.of_runs else ()
        yield from _motors(run, drum, spot.place)
    yield from diameters(drive)
    of, at = run.station.train, Place(event=run.event.name)
    yield from of_drive.unknown_trims(of.belt, of.pulleys, at)
    yield _vibration(run)
    yield _tension(run, case)
    yield from _safety(run, drive, case)
    yield from _pull_over_weight(run)
    sizes = [*usual_sizes(drive, *of_run(run.station, run.event))]
    yield from sizes
    if not any(check.missed and "inertia" in check.title for check in sizes):
        yield from _drums_over_conveyor(run)
    yield from (of_data.data(drive, pulley) for pulley in drive.pulleys)
    yield from of_data.belt_mass(drive)
    if not drive.criteria.covered and of_wet.is_dry_only(drive, case):
        yield not_checked(of_wet.WET_CREEP.name, of_wet.TITLE, "the event was solved dry", at)


def _slack_ends(run: RunResult) -> Iterator[tuple[float, str]]:
    """Yield the least tension of the belt before and behind all drums, and of which it is."""
    yield run.drums[0].extremes.least_entry_tension.value, run.drums[0].name
    yield run.drums[-1].extremes.least_exit_tension.value, run.drums[-1].name


def _spot(
    drive: Drive, case: LoadCase, pulley: Pulley, drum: DrumHistory, slackest: tuple[float, str]
) -> Spot:
    """Return a pulley at the extremes that it came to."""
    spot, most = spot_of(drive, case, pulley), drum.extremes
    found = {
        "exit_creep": most.creep.value,
        "largest_slip": most.slip.value,
        "slip_speed": most.slip_speed.value,
        "peak_shear_stress": most.shear.value,
    }
    slack_end = slackest[0] if pulley.name == slackest[1] else math.nan
    state = replace(spot.state, slack_end=slack_end, found=found)
    return replace(spot, place=Place(pulley.name, event=case.name), state=state)


def of_run(station: Station, event: Event) -> Iterator[Owner]:
    """Yield what moves, and what happens to it."""
    yield from owners_of(station.train)
    yield _moving(station, "")
    yield from (_moving(of, f"of event {event.name}") for of in (event, *event.happenings))
    for name, drum in zip(station.names, station.drums, strict=True):
        yield from (_moving(of, f"of drum {name}") for of in (drum, drum.control, drum.trim) if of)


def _moving(of: Any, words: str) -> Owner:
    """Return something of `motion`, described by its classes or by the whole room."""
    kinds = tuple(kind.__name__ for kind in type(of).__mro__)
    more = tuple(_USUAL[kind] for kind in (*kinds, "") if kind in _USUAL)
    return Owner(of, kinds, words, more=more)


#: As `USUAL`, of `motion`; under no name that of any class there.
_USUAL: dict[str, dict[str, Ends]] = {
    "Trim": {"gain": (0.01, 20.0)},
    "Follower": {"ratio": (0.1, 5.0)},
    "LoadStep": {"factor": (-2.0, 4.0)},
    "OnBelt": {"friction": (0.02, 1.0), "compliance": (0.2, 5.0)},
    "": {
        "conveyor_mass": (300.0, 5e7), "carry_run": (0.5, 30e3), "return_run": (0.5, 30e3),
        "winch_speed": (1e-3, 2.0), "inertia": (0.5, 2e6), "run": (0.2, 2e3),
        "brake_torque": (50.0, 3e6), "rated_torque": (50.0, 3e6), "pump_inertia": (1.0, 1e5),
        "bandwidth": (0.05, 20.0), "reset": (0.05, 100.0), "damping": (1e-3, 0.2),
        "droop": (1e-4, 0.1), "rated_slip": (1e-3, 0.1), "coupling_slip": (0.005, 0.1),
        "breakdown_ratio": (1.5, 5.0), "starting_ratio": (0.3, 5.0), "coupling_limit": (1.1, 4.0),
        "torque_limit": (0.5, 5.0), "lag": (1e-3, 2.0), "dead_time": (1e-3, 2.0),
        "filter_time": (1e-3, 60.0), "duration": (0.1, 3600.0), "time": (0.1, 600.0),
        "at": (1e-3, 7200.0), "length": (0.01, 2e3), "rise": (-0.02, 0.02),
        "run_out": (-0.01, 0.01), "joint_rise": (-0.01, 0.01), "joint_width": (1e-3, 0.3),
        "ripple": (-0.3, 0.3),
    },
}  # fmt: skip


def _pull_over_weight(run: RunResult) -> Iterator[Check]:
    """Yield that a conveyor is far too light for its pull, whatever its mass is given as."""
    if run.station.conveyor_mass is None:
        return
    pull = sum(abs(drum.extremes.pull.value) for drum in run)
    over = pull / (run.station.conveyor_mass * GRAVITY)
    if not usual(over, *PULL_OVER_WEIGHT):
        told = "largest pull of the drives over the weight of the conveyor_mass"
        yield unusual(told, "number", Place(), over, PULL_OVER_WEIGHT)


def _drums_over_conveyor(run: RunResult) -> Iterator[Check]:
    """Yield that drums with their motors, J/R^2 at the belt, are far off the conveyor's mass.

    A gear ratio that is ten times off changes it a hundred times.
    """
    if run.station.conveyor_mass is None:
        return
    radii = (pulley.diameter / 2.0 for pulley in run.station.train.pulleys)
    drums = zip(run.station.drums, radii, strict=True)
    at_belt = math.fsum(drum.inertia / radius**2 for drum, radius in drums)
    over = at_belt / run.station.conveyor_mass
    if not usual(over, *DRUMS_OVER_CONVEYOR):
        told = "inertia of drums and motors at the belt over the conveyor_mass"
        check = unusual(told, "number", Place(), over, DRUMS_OVER_CONVEYOR)
        yield replace(check, remedy="Check inertia, motor_inertia, gear_ratio and conveyor_mass.")


def _case(run: RunResult) -> LoadCase:
    """Return the event as a load case: at every pulley its largest and its least tension."""
    from wraparc.motion.event import PowerFailure, Start  # rooms of drives in time, for these alone

    moves = run.event.of(Start) or run.event.of(PowerFailure)
    return LoadCase(
        name=run.event.name,
        kind="starting" if moves else "running",
        condition=run.station.train.case(run.station.load_case).condition,
        tensions={
            d.name: Tensions(
                entry=d.extremes.most_tension.value, exit=d.extremes.least_tension.value
            )
            for d in run
        },
    )


def _end(run: RunResult) -> Iterator[Check]:
    """Say how a run ended that was not followed to its end, or ends before the event does."""
    from wraparc.motion.result import Outcome

    if run.outcome.whole:
        yield from _settled(run)
        return
    failed = run.outcome in (Outcome.SLACK, Outcome.BREAKAWAY)
    yield Check(
        name="run",
        title="Followed to its end",
        level=Level.FAILS if failed else Level.ATTENTION,
        place=Place(event=run.event.name),
        says=f"{run.reason} {run.outcome.value}",
        short="not followed to its end",
    )


def _settled(run: RunResult) -> Iterator[Check]:
    """Ask to look longer where a start or stop is not over at the end of the run."""
    from wraparc.motion.event import Measured, PowerFailure, Stop

    speed, end = run.station.train.belt.speed, float(run.belt_speed[-1])
    told = run.event.moves and not (run.event.of(PowerFailure) or run.event.of(Measured))
    if speed is None or not told:
        return
    asked = 0.0 if isinstance(run.event.moves[-1], Stop) else speed
    if abs(end - asked) <= SETTLED * speed:
        return
    yield Check(
        name="run",
        title="Followed to its end",
        level=Level.ATTENTION,
        place=Place(event=run.event.name),
        says=f"At the end of the run the belt runs at {quantity(end, 'speed')}, not "
        f"{quantity(asked, 'speed')}: what comes until then is not seen.",
        remedy="Give the event a longer duration.",
        short="not followed to its end",
    )


def _creeps(
    drive: Drive, pulley: Pulley, drum: DrumHistory, place: Place, moves: bool
) -> Iterator[Check]:
    creep, limit = drum.extremes.creep, drive.creep_limit_of(pulley)
    slower, otherwise = "", f"C{MORE_FRICTION[1:]}"
    if moves:
        slower, otherwise = (
            "start and stop more slowly, ",
            f"Start and stop more slowly, or {MORE_FRICTION}",
        )
    remedy = f"Raise the slack-side tension, {slower}or {MORE_FRICTION}"
    if creep.value > max(SLIDES, limit):
        slides = _slides(place, creep.value, creep.time, remedy)
        yield replace(slides, otherwise=otherwise)
    words = Words(
        title="Largest creep at exit",
        short="over creep limit",
        says=f"Creeps {{value}} at {quantity(creep.time, 'time')}, more than the limit of "
        f"{{limit}}; it is over it for {quantity(drum.over_limit, 'time', 2)}.",
        remedy=remedy,
        otherwise=otherwise,
    )
    yield EXIT_CREEP.judged(creep.value, limit, place, words)


def _slides(place: Place, creep: float, time: float, remedy: str) -> Check:
    return Check(
        name=GROSS_SLIP.name,
        title="Carries its load",
        level=Level.FAILS,
        place=place,
        short="slides",
        says=f"The belt slides on the pulley: {quantity(creep, 'length')} of creep at "
        f"{quantity(time, 'time')}, more than {{slides}}, is gross slip.",
        more={"slides": (SLIDES, "length")},
        remedy=remedy,
    )


def _motors(run: RunResult, drum: DrumHistory, place: Place) -> Iterator[Check]:
    """Check torque and heating of the motors of a drum; nothing where no rating is known.

    A motor bears 1.5 times its rated current for 2 minutes: what it is heated beyond its rating,
    the integral of (M/M_r)^2 - 1, is held against (1.5^2 - 1) 120 s.
    """
    i = run.station.index(drum.name)
    rating, train = run.station.drums[i].control.rated_torque, run.station.train
    division, several = train.case(run.station.load_case).division, len(train.pulleys) > 1
    motor = division.motors[i] if isinstance(division, Motors) else None
    if rating is None and isinstance(motor, Motor):
        rating = motor.drum_torque * motor.gear_efficiency
    if rating is None:
        why = "the rated torque of its control is not given"
        yield not_checked("motor_heat", HEATING, why, place)
        return
    yield motor_load(drum.extremes.torque.value / rating, MOMENTARY, True, place, several)
    late = run.time >= (1.0 - _LAST) * run.time[-1]
    lasting = float(np.sqrt(np.mean((drum.torque[late] / rating) ** 2)))
    yield motor_load(lasting, 1.0, False, place, several)
    heat = most = 0.0
    for load, time in zip(
        0.5 * (drum.torque[1:] + drum.torque[:-1]) / rating, np.diff(run.time), strict=True
    ):
        heat = max(heat + (load * load - 1.0) * time, 0.0)
        most = max(most, heat)
    words = Words(
        title=HEATING,
        source="IEC 60034-1: 1.5 times the rated current for 2 min",
        short="motor overheated",
        says="The motors are heated by their overload for {value}, and bear {limit}; that "
        "is loss over rated loss, of 1.5 times the rated torque for 2 min.",
        remedy="Start and stop less hard, wait longer between starts, or take larger motors.",
    )
    yield MOTOR_HEAT.judged(float(most), HEAT, place, words)


def _vibration(run: RunResult) -> Check:
    """Check that small vibrations about the running state die out, whatever the event shows."""
    from wraparc.motion.linear import CALM, Linear

    name, title = "vibration", "Growth per second of the least damped vibration"
    place = Place(event=run.event.name)
    try:
        root = Linear.of(run.station).rightmost
    except InputError as error:
        return not_checked(name, title, error.problems[0].message, place)
    hertz = display(abs(root.imag) / (2.0 * math.pi), "number", digits=3)
    check = Check(
        name=name,
        title=f"{title}{'' if math.isnan(root.real) else f', {hertz} Hz'}",
        level=Level.OK,
        place=place,
        value=0.0 if abs(root.real) <= CALM else root.real,
        limit=0.0,
    )
    if not root.real > CALM:
        return check
    double = quantity(math.log(2.0) / root.real, "time", 2)
    return replace(
        check,
        level=Level.FAILS,
        short="pulsates by itself",
        says=f"A vibration of {hertz} Hz grows by itself and doubles every {double}: how large it "
        "is in this event depends on how long that is followed.",
        remedy="wraparc stability says why, and which control cures it.",
    )


def _tension(run: RunResult, case: LoadCase) -> Check:
    belt, peak = run.station.train.belt, run.peak_tension
    rule, title = of_drive.tension_rule(case.kind), "Largest belt tension"
    place, allowed = Place(event=run.event.name), of_drive.allowed_tension(belt, case.kind)
    if allowed is None:
        return not_checked(rule.name, title, of_drive.NO_RATING, place)
    words = Words(
        title=title,
        source=f"rating of the belt times {of_drive.tension_factor(belt, case.kind):g}: "
        f"{origin(belt.sources.get('rating', belt.provenance))}",
        short="over belt rating",
        says=f"The tension, {{value}} at {quantity(peak.time, 'time')}, is more than the belt "
        f"allows, {{limit}}; it is {peak.place}.",
        remedy=_stronger(run),
    )
    return rule.judged(peak.value, allowed * belt.width, place, words)


def _safety(run: RunResult, drive: Drive, case: LoadCase) -> Iterator[Check]:
    spot = spot_of(drive, case, drive.pulleys[0])
    state = replace(spot.state, tight=run.peak_tension.value)
    spot = replace(spot, place=Place(event=run.event.name), state=state)
    for check in of_drive.BELT_SAFETY.checks(spot):
        stronger = replace(check, remedy=_stronger(run), otherwise="")
        yield stronger if check.missed else check


def _stronger(run: RunResult) -> str:
    slower = "Start more slowly, or take" if run.event.moves else "Take"
    return f"{slower} a stronger belt."
