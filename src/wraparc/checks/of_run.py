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

from wraparc.alike import largest
from wraparc.arc.sliding import SLIDES
from wraparc.checks import of_data, of_drive, of_wet
from wraparc.checks.check import Amount, Check, Level, Place, escaped
from wraparc.checks.judge import diameters
from wraparc.checks.numbers import usual
from wraparc.checks.of_arc import EXIT_CREEP, GRIP_NOUN, GROSS_SLIP
from wraparc.checks.of_train import MOTOR_HEAT, motor_load
from wraparc.checks.rule import CheckText, Rule, Spot, not_checked
from wraparc.checks.rules import OF_PULLEY, spot_of
from wraparc.checks.usual import Ends, Owner, owners_of, unusual, usual_sizes
from wraparc.checks.verdict import Verdict
from wraparc.conveyor import GRAVITY
from wraparc.drive import Drive, LoadCase, Pulley, Tensions
from wraparc.errors import InputError
from wraparc.train import Motor, Motors
from wraparc.train.motors import MOMENTARY
from wraparc.train.result import drive_with
from wraparc.units import quantity

if TYPE_CHECKING:
    from wraparc.motion.event import Event
    from wraparc.motion.result import DrumHistory, RunResult
    from wraparc.motion.station import Station


#: Miss of the set speed over the belt speed with which a start or stop is over [-]; ours.
SETTLED = 0.1
#: What an AC motor bears of overload: 1.5 times its rated current for 2 min (IEC 60034-1), as loss
#: beyond that at rated torque over it, times time [s].
HEAT = (1.5**2 - 1.0) * 120.0
HEATING, HEATING_NOUN = "Motor heating", "motor heating"
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
        _told[run] = Verdict(tuple(_checks(run)))
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
        yield from _creeps(run, drive, pulley, drum, spot.place)
        for rule in OF_PULLEY:
            if rule.of_runs:
                yield from (_at_peak(check, rule, drum) for check in rule.checks(spot))
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
    if not any(check.missed and "inertia" in check.noun for check in sizes):
        yield from _drums_over_conveyor(run)
    yield from (of_data.data(drive, pulley) for pulley in drive.pulleys)
    yield from of_data.belt_mass(drive)
    if not drive.criteria.covered and of_wet.is_dry_only(drive, case):
        yield not_checked(
            of_wet.WET_CREEP.name, of_wet.TITLE, of_wet.NOUN, at, why="the event was solved dry"
        )


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
        yield from (
            _moving(of, f"of pulley {name}") for of in (drum, drum.control, drum.trim) if of
        )


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
        name = "Te over the weight of conveyor_mass"
        yield unusual(name, "number", Place(), over, PULL_OVER_WEIGHT)


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
        name = "inertia at the belt over conveyor_mass"
        check = unusual(name, "number", Place(), over, DRUMS_OVER_CONVEYOR)
        yield replace(check, action="Check inertia, motor_inertia, gear_ratio and conveyor_mass.")


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
        title="Event completed",
        noun="event",
        level=Level.FAILS if failed else Level.ATTENTION,
        place=Place(event=run.event.name),
        headline=escaped(run.reason),
        action=""
        if run.outcome is Outcome.CANCELLED
        else "Give the pulley a backstop or brake."
        if run.outcome is Outcome.TURNED_BACK
        else f"{HIGHER} or a slower start."
        if run.event.moves
        else f"{HIGHER}.",
        label="not completed",
        more={"slack": _slack(run)},
    )


def _settled(run: RunResult) -> Iterator[Check]:
    """Ask to look longer where a start or stop is not over at the end of the run."""
    from wraparc.motion.event import Measured, PowerFailure, Stop

    speed, end = run.station.train.belt.speed, float(run.belt_speed[-1])
    told = run.event.moves and not (run.event.of(PowerFailure) or run.event.of(Measured))
    if speed is None or not told:
        return
    required = 0.0 if isinstance(run.event.moves[-1], Stop) else speed
    if abs(end - required) <= SETTLED * speed:
        return
    yield Check(
        name="run",
        title="Event completed",
        noun="event",
        level=Level.ATTENTION,
        place=Place(event=run.event.name),
        headline="Belt speed {end} at the end, not {required}",
        action="Give the event a longer duration.",
        label="not completed",
        more={"end": Amount(end, "speed"), "required": Amount(required, "speed")},
    )


def _creeps(
    run: RunResult, drive: Drive, pulley: Pulley, drum: DrumHistory, place: Place
) -> Iterator[Check]:
    creep, limit = drum.extremes.creep, drive.creep_limit_of(pulley)
    place = place._replace(time=creep.time)
    action, slack = SLOWER if run.event.moves else f"{HIGHER}.", _slack(run)
    if creep.value > max(SLIDES, limit):
        yield _slides(place, creep.value, action, slack)
    text = CheckText(
        title="Peak creep",
        noun="peak creep",
        label="creep",
        headline="Creep {value} exceeds the {limit} limit",
        fails="Creep {creep} exceeds the {slides} gross-slip limit",
        action=action,
        full=f"The creep exceeds its limit for {quantity(drum.over_limit, 'time', 2)}.",
        more={
            "creep": Amount(creep.value, "length"),
            "slides": Amount(SLIDES, "length"),
            "slack": slack,
        },
    )
    yield EXIT_CREEP.compare(creep.value, limit, place, text)


#: What to try where an event is too fast, and where nothing is to be slower.
SLOWER, HIGHER = "Try a slower start.", "Try a higher T2 (now {slack})"


def _slack(run: RunResult) -> Amount:
    """Return the slack-side tension that the event begins with [N]."""
    case = run.station.train.case(run.station.load_case)
    return Amount(min(case.entry_tension, case.exit_tension), "force", "typed")


def _slides(place: Place, creep: float, action: str, slack: Amount) -> Check:
    return Check(
        name=GROSS_SLIP.name,
        title="Gross slip",
        noun=GRIP_NOUN,
        level=Level.FAILS,
        place=place,
        label="gross slip",
        headline="Gross slip: creep {creep} exceeds {slides}",
        action=action,
        more={
            "creep": Amount(creep, "length"),
            "slides": Amount(SLIDES, "length"),
            "slack": slack,
        },
    )


def _at_peak(check: Check, rule: Rule, drum: DrumHistory) -> Check:
    """Return a check with the time, and the end of the wrap, of what it compares."""
    most = drum.extremes
    tension = most.most_tension if rule.tension == "lower" else most.least_tension
    peaks = {"largest_slip": most.slip, "slip_speed": most.slip_speed}
    peaks["peak_shear_stress"] = most.shear
    if not check.missed:
        return check
    if rule.result in peaks:
        return replace(check, place=check.place._replace(time=peaks[rule.result].time))
    if rule.value is None:
        return check
    at_entry = tension in (most.most_entry_tension, most.least_entry_tension)
    spot = "entry" if at_entry else "exit"
    return replace(check, place=check.place._replace(spot=spot, time=tension.time))


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
        missing = "control.rated_torque"
        yield not_checked("motor_heat", HEATING, HEATING_NOUN, place, missing=missing)
        return
    peak = drum.extremes.torque
    power = motor.rated_power if isinstance(motor, Motor) else math.nan
    late_place = place._replace(time=peak.time)
    yield motor_load(peak.value / rating, MOMENTARY, True, late_place, several, power)
    late = run.time >= (1.0 - _LAST) * run.time[-1]
    lasting = float(np.sqrt(np.mean((drum.torque[late] / rating) ** 2)))
    yield motor_load(lasting, 1.0, False, place, several, power)
    heat = most = 0.0
    for load, time in zip(
        0.5 * (drum.torque[1:] + drum.torque[:-1]) / rating, np.diff(run.time), strict=True
    ):
        heat = max(heat + (load * load - 1.0) * time, 0.0)
        most = max(most, heat)
    text = CheckText(
        title=HEATING,
        noun=HEATING_NOUN,
        source="IEC 60034-1: 1.5 times the rated current for 2 min",
        label="motor heating",
        headline="Motor heating {value} exceeds the {limit} limit",
        action="Try a softer start or longer pauses.",
        full="Heating: loss over rated loss less 1, integrated over time; the limit is 1.5 times "
        "the rated torque for 2 min.",
    )
    yield MOTOR_HEAT.compare(float(most), HEAT, place, text)


def _vibration(run: RunResult) -> Check:
    """Check that small vibrations about the running state die out, whatever the event shows."""
    from wraparc.motion.linear import CALM, Linear

    name, title, noun = "vibration", "Self-excited oscillation", "oscillation growth per second"
    place = Place(event=run.event.name)
    try:
        root = Linear.of(run.station).rightmost
    except InputError as error:
        return not_checked(name, title, noun, place, why=error.problems[0].message)
    check = Check(
        name=name,
        title=title,
        noun=noun,
        level=Level.OK,
        place=place,
        value=0.0 if abs(root.real) <= CALM else root.real,
        limit=0.0,
    )
    if not root.real > CALM:
        return check
    return replace(
        check,
        level=Level.FAILS,
        label="oscillation",
        headline="Self-excited oscillation at {hertz} Hz, doubling time {double}",
        action="Try another control (wraparc stability).",
        full="Its size in this event depends on the duration.",
        more={
            "hertz": Amount(abs(root.imag) / (2.0 * math.pi), "number"),
            "double": Amount(math.log(2.0) / root.real, "time"),
        },
    )


def _tension(run: RunResult, case: LoadCase) -> Check:
    belt, (peak, place) = run.station.train.belt, _peak_tension(run)
    rule, allowed = of_drive.tension_rule(case.kind), of_drive.allowed_tension(belt, case.kind)
    text = replace(of_drive.tension_text(belt, case.kind, peak), title="Belt tension, peak")
    if allowed is None:
        return not_checked(
            rule.name, text.title, text.noun, Place(event=run.event.name), missing=text.missing
        )
    return rule.compare(peak, allowed * belt.width, place, text)


def _peak_tension(run: RunResult) -> tuple[float, Place]:
    """Return the largest tension of the belt [N], and where and when it is."""
    peaks = {
        place: peak
        for drum in run
        for place, peak in (
            (Place(drum.name, spot="entry"), drum.extremes.most_entry_tension),
            (Place(drum.name, spot="exit"), drum.extremes.most_exit_tension),
        )
    }
    place = largest(peaks, lambda at: peaks[at].value)
    peak = peaks[place]
    return peak.value, place._replace(event=run.event.name, time=peak.time)


def _safety(run: RunResult, drive: Drive, case: LoadCase) -> Iterator[Check]:
    spot, (peak, place) = spot_of(drive, case, drive.pulleys[0]), _peak_tension(run)
    state = replace(spot.state, tight=peak)
    yield from of_drive.BELT_SAFETY.checks(replace(spot, place=place, state=state))
