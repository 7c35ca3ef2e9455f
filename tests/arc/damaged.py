"""Drive files damaged field by field, and what an arc of them must end with.

The example drives and a drive with laggings of every law: nothing, less than nothing, huge, tiny,
nan, inf, a wrong unit, a wrong type; tables that jump, are flat at the start or hold no friction
there for a while. Cast over thousands by benchmarks/damaged_drives.py.
"""

from __future__ import annotations

import math
from copy import deepcopy
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

from files.samples import EXAMPLE_DRIVES
from wraparc.arc import ArcResult, Status
from wraparc.schema.source import parse

EXAMPLES = Path(__file__).parents[2] / "examples"
EVERY_LAW = """format = 1
[belt]
width = "1 m"
modulus = "10 MN/m"
speed = "3 m/s"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "200 deg"
lagging = "own"
overrun = "0 mm"
recovery = true
entry_tension = "100 kN"
exit_tension = "60 kN"
[lagging.own]
thickness = "12 mm"
shear_modulus = "2.3 MPa"
compression_modulus = "10 MPa"
wear_coefficient = "1e-6 mm3/J"
[[load_case]]
name = "brake"
pulley.head.entry_tension = "60 kN"
pulley.head.exit_tension = "90 kN"
[[load_case]]
name = "idle"
pulley.head.entry_tension = "60.2 kN"
pulley.head.exit_tension = "60 kN"
"""
LAWS = (
    """kind = "constant"
friction = 0.4""",
    """kind = "elastic-plastic"
friction = 0.5
stiffness = "190 kPa/mm" """,
    """kind = "pressure-power"
friction = 0.5
reference_pressure = "200 kPa"
exponent = 0.3
tested_pressure = ["50 kPa", "600 kPa"]""",
    """kind = "integral-log"
slip_unit = "mm"
pressure_unit = "kPa"
pieces = [
  { from = "34 kPa", to = "172 kPa", A = "-0.08 + 2.2e-4 p", b = "-0.30 + 8e-4 p" },
]""",
    """kind = "integral-log"
tested_slip = "12 mm"
[[lagging.own.law.knots]]
pressure = "40 kPa"
peak_friction = 1.5
peak_slip = "4 mm"
post_peak_slope = "-0.013 1/mm"
residual_friction = 1.42
[[lagging.own.law.knots]]
pressure = "170 kPa"
peak_friction = 1.3
peak_slip = "14 mm"
post_peak_slope = "-0.004 1/mm"
residual_friction = 1.28
[[lagging.own.law.knots]]
pressure = "600 kPa"
peak_friction = 0.6
peak_slip = "21 mm"
post_peak_slope = "0 1/mm"
residual_friction = 0.6""",
    """kind = "table"
slip = ["0 mm", "0.5 mm", "1.5 mm", "4 mm", "8 mm", "12 mm"]
rows = [
  { pressure = "40 kPa", friction = [0, 0.25, 0.5, 0.8, 0.95, 0.9] },
  { pressure = "150 kPa", friction = [0, 0.2, 0.42, 0.68, 0.8, 0.8] },
  { pressure = "600 kPa", friction = [0, 0.1, 0.22, 0.38, 0.46, 0.5] },
]""",
    """kind = "table"
slip = ["0 mm", "1 mm", "4 mm", "10 mm"]
rows = [
  { pressure = "40 kPa", friction = [0.3, 0.5, 0.7, 0.75] },
  { pressure = "600 kPa", friction = [0.15, 0.25, 0.35, 0.4] },
]""",
)
UNITS = ("mm", "m", "kN", "kPa", "MPa", "deg", "rad", "1/mm", "kN/m", "m/s", "W", "lbf", "")


@cache
def documents() -> list[dict[str, Any]]:
    samples = [parse((EXAMPLES / f"{name}.toml").read_text("utf-8")) for name in EXAMPLE_DRIVES]
    return samples + [parse(f"{EVERY_LAW}[[lagging.own.law]]\n{law}\n") for law in LAWS] * 2


def fields(node: Any) -> list[tuple[Any, Any]]:
    """Every number, quantity and table of a document: where it hangs, and its key."""
    found = []
    items: Any = node.items() if isinstance(node, dict) else enumerate(node)
    for key, value in items:
        if isinstance(value, dict | list):
            found += fields(value)
        if not isinstance(value, str) or value[:1] in "-0123456789.":
            found.append((node, key))
    return found


def damage(document: dict[str, Any], rng: Random) -> None:
    """Damage one to three fields."""
    for _ in range(rng.choice((1, 1, 2, 3))):
        node, key = rng.choice(fields(document))
        value = node[key]
        if isinstance(value, list) and value and all(isinstance(v, int | float) for v in value):
            node[key] = rows_of(value, rng)
        elif isinstance(value, list | dict | bool) or rng.random() < 0.03:
            node[key] = rng.choice((value, value, not value, [], {}, "x", 1, ""))
        else:
            node[key] = other(value, rng)


def rows_of(row: list[float], rng: Random) -> list[float]:
    """Friction of a table: a jump, flat or dead at the start, falling, tiny, or at random."""
    n, k = len(row), rng.randrange(1, max(len(row), 2))
    low = rng.choice((0.0, 1e-300, 1e-12, 1e-6, 1e-3))
    return rng.choice((
        [low] * k + row[k:],
        [row[0]] + [low] * (k - 1) + [rng.choice((0.3, 2.0, 50.0))] * (n - k),
        [*row[:k], rng.choice((1e-9, 1e-3, 10.0, 1e6)), *row[k + 1 :]],
        row[::-1],
        [rng.choice((0.0, 0.2)), *(rng.uniform(0.001, 1.5) for _ in range(n - 1))],
        [0.0] + [v * 10.0 ** rng.uniform(-6, 3) for v in row[1:]],
    ))  # fmt: skip


def other(value: Any, rng: Random) -> Any:
    """Another number in place of one, with its unit or with a wrong one."""
    number, _, unit = str(value).partition(" ")
    try:
        given = float(number)
    except ValueError:
        return value
    new = rng.choice((
        0.0, -given, math.nan, math.inf, 1e-300, 1e300, 5e-324,
        *(given * 10.0 ** rng.uniform(-a, a) for a in (0.3, 0.3, 1, 1, 2, 2, 3, 3, 6, 6, 12)),
    ))  # fmt: skip
    if rng.random() < 0.05:
        unit = rng.choice(UNITS)
    return f"{new!r} {unit}" if isinstance(value, str) else new


def judged(result: ArcResult) -> str:
    """How an arc ended; raises if its numbers are none."""
    if result.status is Status.BREAKAWAY:
        return "breakaway"
    assert result.status is Status.SOLVED, "unsolved"
    numbers = [
        result.exit_creep, result.exit_slip, result.creep_shrinkage, result.creep_compression,
        result.creep_global, result.entry_creep_ratio, result.exit_creep_ratio,
        result.peak_shear_stress, result.peak_shear_angle, result.peak_shear_position,
        result.mean_friction, result.active_arc, result.stuck_arc,
        result.energy.frictional_energy, result.energy.identity_error,
    ]  # fmt: skip
    if result.arc.belt_speed is not None:
        energy = result.energy
        numbers += [energy.transmitted_power, energy.sliding_power, energy.power_loss]
    assert all(map(math.isfinite, numbers)), f"not finite: {numbers}"
    for name, column in result.profile.columns():
        assert np.isfinite(column).all(), f"not finite: {name}"
    return "solved"


def damaged(seed: int) -> dict[str, Any]:
    """A damaged document of a seed of its own."""
    rng = Random(seed)  # noqa: S311 - a repeatable drive
    document = deepcopy(rng.choice(documents()))
    damage(document, rng)
    return document
