"""The station around the arcs: drums, runs, take-up, conveyor, brakes. Frozen, no solving."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar, Literal

from wraparc.drive import Limit, Pulley
from wraparc.errors import Problem, input_error, name_remedy, nearest, shown
from wraparc.motion.control import Control, Droop, Follower, Trim
from wraparc.schema.limits import limit_problems, raise_all
from wraparc.train import Train

TakeUp = Literal["gravity", "fixed", "winch"]
TAKE_UPS: tuple[TakeUp, ...] = ("gravity", "fixed", "winch")


@dataclass(frozen=True, kw_only=True)
class Drum:
    """One drum of the station, by the pulley that it is.

    Attributes
    ----------
    inertia
        Of the drum with its gear and motor, as seen at the drum shaft [kg m2].
    run
        Length of the belt from the pulley before to this one [m]; of the first drum it is that of
        the conveyor.
    control
        How it is driven.
    trim
        Load sharing on top of it, or None.
    backstop
        Whether it cannot turn back.
    brake_torque
        Of its brake at the drum, on in an emergency stop [N m].
    """

    LIMITS: ClassVar[dict[str, Limit]] = {
        "inertia": Limit("moment_of_inertia", open=True, most=1e9),
        "run": Limit("length", open=True, most=1e5),
        "brake_torque": Limit("torque", most=1e9),
    }

    inertia: float
    run: float = 3.0
    control: Control = field(default_factory=Droop)
    trim: Trim | None = None
    backstop: bool = True
    brake_torque: float = 0.0

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))


@dataclass(frozen=True, kw_only=True)
class Station:
    """The drives of a train in one load case, with what decides how they move.

    Attributes
    ----------
    train
        Pulleys and belt.
    drums
        One for each pulley, in belt order.
    load_case
        Name of the load case that runs; if empty the running one of the largest pull.
    conveyor_mass
        Belt, load and idlers, moving with the belt [kg]; None where the tensions outside the
        drives are held.
    carry_run, return_run
        Length of belt that is stretched between the conveyor's mass and the first drum, and
        between the last drum and the mass [m].
    lift_share
        Part of the resistance that also pulls at rest: an inclined conveyor [-].
    take_up
        ``gravity`` holds the last tension, ``fixed`` holds the length of the belt, ``winch``
        winds it towards the last tension.
    winch_speed
        Largest belt speed of the winch [m/s].
    source
        Where the numbers came from.
    taken
        Keys that a file leaves out, and that are taken as they are here.
    """

    LIMITS: ClassVar[dict[str, Limit]] = {
        "conveyor_mass": Limit("mass", open=True, most=1e9),
        "carry_run": Limit("length", open=True, most=1e5),
        "return_run": Limit("length", open=True, most=1e5),
        "lift_share": Limit("number", most=1.0),
        "winch_speed": Limit("speed", open=True, most=10.0),
    }

    train: Train
    drums: tuple[Drum, ...]
    load_case: str = ""
    conveyor_mass: float | None = None
    carry_run: float = 50.0
    return_run: float = 20.0
    lift_share: float = 0.0
    take_up: TakeUp = "gravity"
    winch_speed: float = 0.1
    source: str = ""
    taken: tuple[str, ...] = field(default=(), compare=False)

    def __post_init__(self) -> None:
        limits = dict(self.LIMITS)
        if self.conveyor_mass is None:
            del limits["conveyor_mass"]
        problems = limit_problems(self, limits)
        names = [p.name for p in self.train.pulleys]
        if len(self.drums) != len(names):
            message = f"must be one for each of the {len(names)} pulleys"
            problems.append(Problem(key="drum", value=str(len(self.drums)), message=message))
        if self.take_up not in TAKE_UPS:
            allowed = ", ".join(map(shown, TAKE_UPS))
            problems.append(
                Problem(
                    key="take_up", value=shown(self.take_up), message=f"must be one of {allowed}"
                )
            )
        if self.conveyor_mass is None and self.take_up != "gravity":
            message = "needs conveyor_mass"
            remedy = "Give conveyor_mass, or leave take_up out."
            problems.append(
                Problem(key="take_up", value=shown(self.take_up), message=message, remedy=remedy)
            )
        problems += self._followers(names)
        raise_all(problems)
        self.train.case(self.load_case)

    def _followers(self, names: list[str]) -> list[Problem]:
        problems = []
        for name, drum in zip(names, self.drums, strict=False):
            control = drum.control
            if not isinstance(control, Follower):
                continue
            key = f"motor.{name}.master"
            if control.master not in names or control.master == name:
                message = "must be another pulley"
                remedy = nearest(control.master, [n for n in names if n != name])
                problems.append(
                    Problem(key=key, value=shown(control.master), message=message, remedy=remedy)
                )
            elif isinstance(self.drums[names.index(control.master)].control, Follower):
                message = "must not follow another drive itself"
                problems.append(Problem(key=key, value=shown(control.master), message=message))
        if all(isinstance(d.control, Follower) for d in self.drums):
            message = "every drive follows another one"
            problems.append(Problem(key="motor", message=message))
        return problems

    @property
    def pulleys(self) -> tuple[Pulley, ...]:
        """The pulleys in belt order, their laggings in the condition of the load case."""
        return self.train.in_case(self.train.case(self.load_case)).pulleys

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the pulleys in belt order."""
        return tuple(p.name for p in self.train.pulleys)

    def index(self, name: str) -> int:
        """Return the place of a pulley.

        Raises
        ------
        InputError
            If there is none of that name.
        """
        if name in self.names:
            return self.names.index(name)
        remedy = name_remedy(name, self.names)
        raise input_error(key="pulley", value=shown(name), message="no such pulley", remedy=remedy)
