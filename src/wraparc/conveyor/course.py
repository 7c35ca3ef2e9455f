"""The course of the belt through the flights of a conveyor: every force, and every tension.

The belt is a loop of segments, each with one slope and one load, and of spots where a force acts
at a point: loading points, pulleys, cleaners, drives, the take-up. The take-up fixes the tension
at one spot; from there the tension is followed once around, in the direction of travel. The drives
together make up for all resistances, so that the loop closes.
"""

import math
from collections.abc import Mapping, Sequence

from wraparc.conveyor.description import ConveyorData
from wraparc.conveyor.flight import ALL, DECLINES, HEAD, INCLINES, NONE, TAIL, ConveyorCase
from wraparc.conveyor.local import (
    OF_BEARING,
    OF_CLEANER,
    OF_LOADING,
    OF_SKIRT,
    OF_TILT,
    OF_WRAP,
)
from wraparc.conveyor.loop import (
    BEARING,
    CLEANER,
    INERTIA_NAME,
    LOADING,
    MAIN_NAME,
    SECONDARY_NAME,
    SKIRT,
    SLOPE_NAME,
    SPECIAL_NAME,
    TILT,
    WRAP,
    Segment,
    Spot,
    Step,
    belt_steps,
    is_drive,
    is_take_up,
    spot_forces,
)
from wraparc.conveyor.resistance import (
    GIVEN,
    INERTIA,
    MAIN,
    SECONDARY,
    SLOPE,
    Resistance,
)
from wraparc.conveyor.state import (
    CARRY,
    RETURN,
    STRANDS,
    BeltPoint,
    DrivePull,
    Standstill,
    State,
    Stretch,
)

#: Names of the resistances, in the order in which they are shown.
NAMES = (
    MAIN_NAME, SECONDARY_NAME, LOADING, WRAP, BEARING, CLEANER, SLOPE_NAME, SPECIAL_NAME, SKIRT,
    TILT, INERTIA_NAME,
)  # fmt: skip
#: Those that are shown only where there are such.
ITEMISED = (LOADING, WRAP, BEARING, CLEANER, SKIRT, TILT)
_SOURCES = {
    LOADING: OF_LOADING, WRAP: OF_WRAP, BEARING: OF_BEARING, CLEANER: OF_CLEANER,
    SKIRT: OF_SKIRT, TILT: OF_TILT, SPECIAL_NAME: GIVEN, SLOPE_NAME: SLOPE, INERTIA_NAME: INERTIA,
}  # fmt: skip
#: By how much of the highest tension the loop may still move, and after how many rounds at most.
_STILL, _ROUNDS = 1e-13, 100


def standard_cases(conveyor: ConveyorData) -> list[ConveyorCase]:
    """Return the load cases of a conveyor: those that every one has, and its own.

    Full and empty, inclines only and declines only where it has both, starting and stopping full
    where it says how.
    """
    cases = [ConveyorCase(name="full"), ConveyorCase(name="empty", loaded=NONE)]
    rises = [flight.rise for flight in conveyor.course_flights]
    if min(rises) < 0.0 < max(rises):
        cases.append(ConveyorCase(name=INCLINES, loaded=INCLINES))
        cases.append(ConveyorCase(name=DECLINES, loaded=DECLINES))
    if conveyor.start_factor is not None or conveyor.start_time is not None:
        cases.append(ConveyorCase(name="start", kind="starting"))
    if conveyor.stop_time is not None:
        cases.append(ConveyorCase(name="stop", kind="braking"))
    return [*cases, *conveyor.cases]


def course_states(conveyor: ConveyorData) -> list[State]:
    """Return every load case of a conveyor with flights, whatever tensions it leaves."""
    full = course_state(conveyor, ConveyorCase(name="full", loaded=ALL))
    return [course_state(conveyor, case, full.pull) for case in standard_cases(conveyor)]


def course_state(conveyor: ConveyorData, case: ConveyorCase, full_pull: float = 0.0) -> State:
    """Return one load case.

    Parameters
    ----------
    conveyor
        With flights.
    case
        Which flights have material, and whether it starts or stops.
    full_pull
        Effective tension of the full running conveyor, which a `start_factor` multiplies [N].
    """
    steps = belt_steps(conveyor, case)
    moving = sum(step.moving for step in steps if isinstance(step, Segment))
    tensions = [(conveyor.take_up, conveyor.take_up)] * len(steps)
    acceleration = 0.0
    forces: list[dict[str, float]] = []
    for _ in range(_ROUNDS):
        forces = [
            {**step.forces} if isinstance(step, Segment)
            else spot_forces(conveyor, case, step, 0.5 * (before + after))
            for step, (before, after) in zip(steps, tensions, strict=True)
        ]  # fmt: skip
        resting = math.fsum(math.fsum(one.values()) for one in forces)
        acceleration = _acceleration(conveyor, case, resting, full_pull, moving)
        for step, one in zip(steps, forces, strict=True):
            if isinstance(step, Segment):
                one[INERTIA_NAME] = acceleration * step.moving
        moved = _follow(conveyor, case, steps, forces)
        change = max(
            abs(new[1] - old[1]) for new, old in zip(moved, tensions, strict=True)
        )  # fmt: skip
        tensions = moved
        if change <= _STILL * max(abs(after) for _, after in tensions):
            break
    return _state(conveyor, case, acceleration, steps, forces, tensions)


def drive_shares(conveyor: ConveyorData, kind: str) -> list[float]:
    """Return the part of the effective tension that each drive has in a kind of load case [-]."""
    braked = [d.brake_share for d in conveyor.course_drives if d.brake_share is not None]
    if kind == "braking" and len(braked) > 0:
        return [d.brake_share or 0.0 for d in conveyor.course_drives]
    return [drive.share for drive in conveyor.course_drives]


def _acceleration(
    conveyor: ConveyorData, case: ConveyorCase, resting: float, full_pull: float, moving: float
) -> float:
    """Return the acceleration of the belt in a load case [m/s2]."""
    speed = conveyor.speed
    if case.kind == "starting" and conveyor.start_factor is not None:
        return (conveyor.start_factor * full_pull - resting) / moving
    if case.kind == "starting" and conveyor.start_time is not None and speed is not None:
        return speed / conveyor.start_time
    if case.kind == "braking" and conveyor.stop_time is not None and speed is not None:
        return -speed / conveyor.stop_time
    return 0.0


def _follow(
    conveyor: ConveyorData,
    case: ConveyorCase,
    steps: Sequence[Step],
    forces: Sequence[Mapping[str, float]],
) -> list[tuple[float, float]]:
    """Return the tension before and behind every step, from the take-up once around [N]."""
    total = math.fsum(math.fsum(one.values()) for one in forces)
    shares = drive_shares(conveyor, case.kind)
    start = next(i for i, step in enumerate(steps) if is_take_up(step))
    tensions = [(0.0, 0.0)] * len(steps)
    now = conveyor.take_up
    for k in range(len(steps)):
        i = (start + k) % len(steps)
        step, before = steps[i], now
        now = before + math.fsum(forces[i].values())
        if isinstance(step, Spot) and step.kind == "drive":
            now -= shares[step.which] * total
        tensions[i] = (before, now)
    return tensions


def _state(
    conveyor: ConveyorData,
    case: ConveyorCase,
    acceleration: float,
    steps: Sequence[Step],
    forces: Sequence[Mapping[str, float]],
    tensions: Sequence[tuple[float, float]],
) -> State:
    """Return a load case of what was found on every step."""
    shares = drive_shares(conveyor, case.kind)
    drives: list[DrivePull] = []
    for i, drive in enumerate(conveyor.course_drives):
        at = next(k for k, s in enumerate(steps) if is_drive(s, i))
        drives.append(DrivePull(drive.pulley, shares[i], tensions[at][0], tensions[at][1]))
    back = [i for i, step in enumerate(steps) if step.strand == RETURN]
    runs = [i for i in back if isinstance(steps[i], Segment)]
    gravity = math.fsum(one.get(SLOPE_NAME, 0.0) for one in forces)
    friction = math.fsum(one.get(MAIN_NAME, 0.0) for one in forces)
    return State(
        name=case.name,
        kind=case.kind,
        resistances=_resistances(conveyor, steps, forces),
        head=tensions[runs[0]][0],
        tail=tensions[runs[-1]][1],
        entry=drives[0].entry,
        exit=drives[-1].exit,
        acceleration=acceleration,
        points=_points(steps, tensions),
        stretches=_stretches(steps, forces, tensions),
        drives=tuple(drives),
        standstill=Standstill(gravity, friction),
    )


def _resistances(
    conveyor: ConveyorData, steps: Sequence[Step], forces: Sequence[Mapping[str, float]]
) -> tuple[Resistance, ...]:
    """Return what resists on both strands, by name."""
    sources = {
        **_SOURCES,
        MAIN_NAME: f"{MAIN}, f = {conveyor.friction_factor:g}{conveyor.unusual_friction}",
        SECONDARY_NAME: GIVEN,
    }
    if conveyor.coefficient is not None:
        sources[SECONDARY_NAME] = f"{SECONDARY}, C = {conveyor.coefficient:.3g}"
        if conveyor.length_coefficient is not None:
            sources[SECONDARY_NAME] += " (input)"
    found: list[Resistance] = []
    for name in NAMES:
        parts = {
            strand: math.fsum(
                one.get(name, 0.0)
                for step, one in zip(steps, forces, strict=True)
                if step.strand == strand
            )
            for strand in STRANDS
        }
        if name in ITEMISED and parts[CARRY] == 0.0 == parts[RETURN]:
            continue
        found.append(Resistance(name, parts[CARRY], parts[RETURN], sources[name]))
    return tuple(found)


def _points(
    steps: Sequence[Step], tensions: Sequence[tuple[float, float]]
) -> tuple[BeltPoint, ...]:
    """Return every point of the belt at which a flight begins or a force acts."""
    points: list[BeltPoint] = []
    last = ("", "")
    for step, (before, after) in zip(steps, tensions, strict=True):
        if isinstance(step, Spot):
            place = (step.strand, step.position, step.name, step.kind)
            points.append(BeltPoint(*place, before, after))
        elif (step.strand, step.flight.name) != last:
            last = (step.strand, step.flight.name)
            place = (step.strand, step.position, step.flight.name, "flight")
            points.append(BeltPoint(*place, before, before))
    return tuple(points)


def _stretches(
    steps: Sequence[Step],
    forces: Sequence[Mapping[str, float]],
    tensions: Sequence[tuple[float, float]],
) -> tuple[Stretch, ...]:
    """Return every flight of both strands with its balance, and what stands at both ends.

    A spot where two flights meet belongs to the one that follows, at the end of a strand to the
    end of the conveyor.
    """
    owners: list[tuple[str, str]] = []
    for i, step in enumerate(steps):
        if isinstance(step, Segment):
            owners.append((step.flight.name, step.strand))
            continue
        following = next((s for s in steps[i:] if isinstance(s, Segment)), None)
        if following is None or following.strand != step.strand:
            owners.append((HEAD if step.strand == CARRY else TAIL, step.strand))
        else:
            owners.append((following.flight.name, step.strand))
    found: list[Stretch] = []
    for owner in dict.fromkeys(owners):
        own = [i for i, other in enumerate(owners) if other == owner]
        total: dict[str, float] = {}
        driven, weight, length = 0.0, 0.0, 0.0
        for i in own:
            for name, force in forces[i].items():
                total[name] = total.get(name, 0.0) + force
            step = steps[i]
            if isinstance(step, Segment):
                weight += step.carried * step.length
                length += step.length
            elif step.kind == "drive":
                driven += tensions[i][0] - tensions[i][1] + math.fsum(forces[i].values())
        found.append(
            Stretch(
                flight=owner[0],
                strand=owner[1],
                start=tensions[own[0]][0],
                end=tensions[own[-1]][1],
                least=min(min(tensions[i]) for i in own),
                forces=total,
                driven=driven,
                mass=weight / length if length > 0.0 else 0.0,
            )
        )
    return tuple(found)
