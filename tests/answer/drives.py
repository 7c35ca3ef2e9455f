"""Solved drives for the tests of tables and pictures."""

import math
from dataclasses import replace
from functools import cache

from wraparc import (
    Belt,
    Constant,
    Drive,
    DriveResult,
    Lagging,
    LoadCase,
    PaperMarch,
    Pulley,
    Tensions,
    TestedRange,
    load_lagging,
    solve,
)

BELT = Belt(name="EP 1000/4", width=1.2, modulus=12.96e6, rating=175e3, speed=3.0, kind="fabric")
#: A law that holds the belt at rest over part of the arc, tested in less than the arc asks for.
STICKY = Lagging(
    name="sticky",
    law=Constant(
        friction_coefficient=0.5,
        tested=TestedRange(pressure_min=140e3, pressure_max=300e3, slip_max=2e-3),
    ),
    thickness=0.012,
    shear_modulus=2.3e6,
    surface="rubber",
)


def drive(
    entry: float = 150e3,
    leaving: float = 60e3,
    lagging: Lagging | None = None,
    belt: Belt = BELT,
    **of_pulley: float,
) -> Drive:
    """One pulley of 0.8 m and 180 deg in one load case."""
    pulley = Pulley(
        name="head",
        diameter=0.8,
        wrap_angle=math.pi,
        lagging=lagging or load_lagging("diamond-rubber"),
    )
    case = LoadCase(name="full", tensions={"head": Tensions(entry=entry, exit=leaving)})
    return Drive(
        title="Test drive",
        belt=belt,
        pulleys=(replace(pulley, **of_pulley),),  # type: ignore[arg-type]
        load_cases=(case,),
    )


@cache
def solved(entry: float = 150e3, leaving: float = 60e3) -> DriveResult:
    """The drive of diamond rubber, solved."""
    return solve(drive(entry, leaving), raise_on_failure=False)


@cache
def marched(entry: float = 150e3, leaving: float = 60e3) -> DriveResult:
    """The same by the paper's integration."""
    return solve(drive(entry, leaving), method=PaperMarch(), raise_on_failure=False)


@cache
def sticking() -> DriveResult:
    """A drive with a stuck zone and a part outside the tested range."""
    return solve(drive(180e3, 50e3, STICKY, overrun=0.0))
