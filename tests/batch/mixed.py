"""Random tables of unlike rows: every law, laggings of unlike knots, belts, loads, gaps."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from arc.drives import JUMP_TABLE, PIECEWISE
from arc.wide import any_table, log_uniform
from wraparc.arc import WrapArc
from wraparc.drive import Lagging
from wraparc.errors import InputError
from wraparc.files import load_lagging_conditions
from wraparc.friction import (
    Constant,
    ElasticPlastic,
    FrictionLaw,
    IntegralLog,
    PressureKnots,
    PressurePower,
    TestedRange,
)

KINDS = ("knots", "softening", "pieces", "table", "jump table", "constant", "power", "elastic")
SHIPPED = ("diamond-rubber", "medium-ceramic", "full-ceramic")

Row = dict[str, Any]


def knotted(rng: np.random.Generator, *, softens: bool = False) -> IntegralLog:
    """An integral-log law of 1 to 8 knots, tested up to anything from 60 kPa to 1 MPa."""
    n = int(rng.integers(1, 9))
    top = log_uniform(rng, 60e3, 1e6)
    pressure = np.sort(top * np.append(rng.uniform(0.1, 0.95, n - 1), 1.0))
    friction = np.sort(rng.uniform(0.25, 1.4, n))[::-1]
    more: Row = {}
    if softens:
        more = {
            # less steep and deep at more pressure: otherwise the pull has several tops
            "post_peak_slope": tuple(np.sort(rng.uniform(-12.0, 0.0, n)).tolist()),
            "residual_friction": tuple((friction * np.sort(rng.uniform(0.7, 1.0, n))).tolist()),
        }
    knots = PressureKnots(
        pressure=tuple(pressure.tolist()),
        peak_friction=tuple(friction.tolist()),
        peak_slip=tuple(np.sort(rng.uniform(3e-3, 25e-3, n)).tolist()),
        **more,
    )
    return IntegralLog(coefficients=knots, tested=tested(rng, pressure) if n > 1 else None)


def tested(rng: np.random.Generator, pressure: Any) -> TestedRange | None:
    """The tested range of a law, without one in every third, some with the speed of the tests."""
    if rng.random() < 0.33:
        return None
    speed = float(rng.uniform(1e-5, 1e-3)) if rng.random() < 0.5 else None
    return TestedRange(
        pressure_min=float(pressure[0]),
        pressure_max=float(pressure[-1]),
        slip_max=log_uniform(rng, 2e-3, 20e-3),
        slip_speed=speed,
    )


def any_law(kind: str, rng: np.random.Generator) -> FrictionLaw:
    """A random law of a kind."""
    mu = float(rng.uniform(0.2, 0.9))
    ends = np.sort(np.exp(rng.uniform(math.log(3e4), math.log(9e5), 2)))
    if kind in ("knots", "softening"):
        return knotted(rng, softens=kind == "softening")
    if kind == "table":
        return any_table(rng)
    if kind == "constant":
        return Constant(friction_coefficient=mu, tested=tested(rng, ends))
    if kind == "power":
        return PressurePower(
            friction_coefficient=mu,
            reference_pressure=2e5,
            exponent=float(rng.uniform(0.0, 0.6)),
            tested=tested(rng, ends),
        )
    if kind == "elastic":
        return ElasticPlastic(
            stiffness=log_uniform(rng, 1e7, 1e9), friction_coefficient=mu, tested=tested(rng, ends)
        )
    law: FrictionLaw = PIECEWISE if kind == "pieces" else JUMP_TABLE
    return law.scaled(float(rng.uniform(0.7, 1.2)), float(rng.uniform(0.7, 1.2)))


def any_laggings(rng: np.random.Generator) -> list[Lagging]:
    """Shipped laggings in their conditions, and two of each kind of law."""
    shipped = [lag for name in SHIPPED for lag in load_lagging_conditions(name)]
    made = [
        Lagging(
            name=f"{kind}-{i}",
            law=any_law(kind, rng),
            thickness=float(rng.uniform(6e-3, 20e-3)) if rng.random() < 0.9 else 0.0,
            shear_modulus=float(rng.uniform(1.5e6, 6e6)) if rng.random() < 0.9 else math.inf,
            compression_modulus=float(rng.uniform(5e6, 30e6)) if rng.random() < 0.9 else math.inf,
        )
        for kind in KINDS
        for i in range(2)
    ]
    return [*shipped, *made]


def any_row(rng: np.random.Generator, laggings: list[Lagging]) -> Row:
    """One row: a third carries little, a third much, a third more than most laws do."""
    diameter, width = float(rng.uniform(0.4, 1.6)), float(rng.uniform(0.5, 2.2))
    tight = log_uniform(rng, 3e4, 1.4e6) * width * diameter / 2.0
    ratio = 1.0 + log_uniform(rng, *((1e-7, 0.2), (0.2, 2.0), (2.0, 20.0))[int(rng.integers(3))])
    entry, leaving = (tight, tight / ratio) if rng.random() < 0.65 else (tight / ratio, tight)
    if rng.random() < 0.03:
        leaving = entry
    lift = float(rng.uniform(0.0, 0.3)) * min(entry, leaving) if rng.random() < 0.4 else 0.0
    return {
        "lagging": int(rng.integers(len(laggings))),
        "entry_tension": entry,
        "exit_tension": leaving,
        "diameter": diameter,
        "wrap_angle": math.radians(float(rng.uniform(60.0, 260.0))),
        "belt_width": width,
        "belt_modulus": log_uniform(rng, 2e6, 5e8) if rng.random() < 0.97 else math.inf,
        "overrun": (math.nan, 0.0, 2e-5, -1e-5)[int(rng.integers(4))],
        "recovery": float(rng.random() < 0.7),
        "creep_limit": log_uniform(rng, 1e-3, 20e-3),
        "belt_speed": float(rng.uniform(0.5, 8.0)) if rng.random() < 0.7 else math.nan,
        "wear_coefficient": log_uniform(rng, 1e-14, 1e-12) if rng.random() < 0.5 else math.nan,
        "pitch_offset": float(rng.uniform(0.0, 12e-3)) if rng.random() < 0.6 else 0.0,
        "cover_compliance": log_uniform(rng, 1e-9, 1e-8) if rng.random() < 0.5 else 0.0,
        "centrifugal_force": lift,
    }


def table_of(rows: list[Row]) -> dict[str, Any]:
    """The rows as columns."""
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


def arc_of(row: Row, laggings: list[Lagging]) -> WrapArc | str:
    """The row as an arc alone, or why there is none."""
    lagging: Lagging = laggings[row["lagging"]]

    def known(name: str) -> float | None:
        return None if math.isnan(row[name]) else row[name]

    try:
        return WrapArc(
            law=lagging.law,
            entry_tension=row["entry_tension"],
            exit_tension=row["exit_tension"],
            diameter=row["diameter"],
            wrap_angle=row["wrap_angle"],
            width=row["belt_width"],
            axial_stiffness=row["belt_modulus"] * row["belt_width"],
            thickness=lagging.thickness,
            shear_modulus=lagging.shear_modulus,
            compression_modulus=lagging.compression_modulus,
            overrun=known("overrun"),
            recovery=bool(row["recovery"]),
            creep_limit=row["creep_limit"],
            belt_speed=known("belt_speed"),
            wear_coefficient=known("wear_coefficient"),
            pitch_offset=row["pitch_offset"],
            cover_compliance=row["cover_compliance"],
            centrifugal=row["centrifugal_force"],
        )
    except InputError as error:
        return str(error)
