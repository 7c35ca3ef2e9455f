"""Trains for the tests: belts, laggings and random tandems."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from arc.drives import LAWS
from wraparc.arc import Distributed
from wraparc.drive import Belt, Lagging, Pulley
from wraparc.friction import FrictionLaw
from wraparc.train import CaseResult, Division, Shares, Speeds, Train, TrainCase, solve_train

QUICK = Distributed(capacities=False, points=20)
RPM = math.pi / 30.0
FABRIC = Belt(name="fabric", width=1.2, modulus=12.96e6, speed=3.0)
STEEL = Belt(name="steel cord", width=1.2, modulus=144e6, speed=5.0)
RIGID = Belt(name="rigid", width=1.2, modulus=math.inf, speed=3.0)


def lagging(
    law: FrictionLaw | str,
    thickness: float = 12e-3,
    shear_modulus: float = 2.3e6,
    compression_modulus: float = 10e6,
) -> Lagging:
    return Lagging(
        name="lagging",
        law=LAWS[law] if isinstance(law, str) else law,
        thickness=thickness,
        shear_modulus=shear_modulus,
        compression_modulus=compression_modulus,
    )


def pulleys(
    count: int,
    law: FrictionLaw | str | Lagging = "rubber",
    *,
    diameter: float = 0.8,
    wrap_angle: float = math.pi,
    overrun: float | None = None,
) -> tuple[Pulley, ...]:
    made = law if isinstance(law, Lagging) else lagging(law)
    return tuple(
        Pulley(
            name=f"p{i + 1}",
            diameter=diameter,
            wrap_angle=wrap_angle,
            lagging=made,
            overrun=overrun,
        )
        for i in range(count)
    )


def case(
    division: Division,
    entry: float = 150e3,
    exit_: float = 50e3,
    runs: Sequence[float] = (),
    name: str = "full",
) -> TrainCase:
    return TrainCase(
        name=name, entry_tension=entry, exit_tension=exit_, division=division, runs=tuple(runs)
    )


def train(
    of: Sequence[Pulley], *cases: TrainCase, belt: Belt = FABRIC, nominal: Sequence[float] = ()
) -> Train:
    return Train(belt=belt, pulleys=tuple(of), cases=cases, nominal_diameters=tuple(nominal))


def solved(of: Train, method: Distributed = QUICK) -> CaseResult:
    """The first load case, which must have a solution."""
    return solve_train(of, method=method).cases[0]


def tried(of: Train, method: Distributed = QUICK) -> CaseResult:
    """The first load case, whatever comes of it."""
    return solve_train(of, method=method, raise_on_failure=False).cases[0]


def held(of: Train, result: CaseResult) -> Train:
    """The train with the speeds that a result has."""
    trims = zip((m.speed_trim for m in result), of.nominal, strict=True)
    speeds = Speeds(tuple(t / d for t, d in trims))
    return replace(of, cases=(replace(result.case, division=speeds),))


def random_train(rng: np.random.Generator, law: str, count: int = 2) -> Train:
    """A plausible train: fabric or steel cord, any shares, sometimes a drive that brakes."""
    width = float(rng.uniform(0.8, 1.8))
    diameter = float(rng.uniform(0.63, 1.3))
    modulus = float(np.exp(rng.uniform(math.log(8e6), math.log(3e8))))
    entry = float(rng.uniform(200e3, 500e3)) * width * diameter / 2.0
    exit_ = entry / float(rng.uniform(1.3, 1.0 + 0.9 * count))
    shares = rng.dirichlet(np.full(count, 3.0))
    if rng.random() < 0.2:
        shares = shares + np.where(
            np.arange(count) == int(rng.integers(count)), -0.3, 0.3 / (count - 1)
        )
    of = tuple(
        Pulley(
            name=f"p{i + 1}",
            diameter=diameter * float(rng.uniform(0.95, 1.05)),
            wrap_angle=float(rng.uniform(2.8, 3.8)),
            lagging=lagging(
                law,
                float(rng.uniform(8e-3, 18e-3)),
                float(rng.uniform(1.5e6, 6e6)),
                float(rng.uniform(6e6, 30e6)),
            ),
            overrun=[None, 0.0][int(rng.integers(2))] if law not in HOLDING else 0.0,
        )
        for i in range(count)
    )
    total = float(shares.sum())
    divided = Shares(tuple(float(s) / total for s in shares))
    belt = Belt(name="belt", width=width, modulus=modulus, speed=3.0)
    return Train(
        belt=belt,
        pulleys=of,
        cases=(TrainCase(name="c", entry_tension=entry, exit_tension=exit_, division=divided),),
    )


#: Laws that hold the belt without slip.
HOLDING = {"constant", "power", "elastic-plastic", "jump table"}
