"""A plant whose truth is known: a log of a drive by the solver, a row each half minute.

What is expected of the learner are the numbers put in here. The creep is that of the solver at the
true friction, between pulls by a straight line; noise, zero and errors are this file's.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.batch import solve_batch
from wraparc.drive import Drive
from wraparc.files.lagging_file import load_lagging
from wraparc.train.file import load_drive

Array = NDArray[Any]
EXAMPLES = Path(__file__).parents[2] / "examples"
DRIVE = EXAMPLES / "wet-season" / "wet-season-drive.toml"
START = np.datetime64("2026-03-01T00:00:00")
STEP, DAY, GEAR, RATED = 30.0, 86400.0, 20.0, 80e3
T2 = 50e3


@cache
def drive() -> Drive:
    return load_drive(DRIVE)


@cache
def _creep(ln_friction: float, other: str = "") -> tuple[Array, Array]:
    """Pulls, and the entry creep ratio at each with the friction of the law times a factor."""
    from dataclasses import replace

    d = drive()
    on = d.pulleys[0]
    own = load_lagging(other) if other else on.lagging
    lagging = replace(own, law=own.law.scaled(math.exp(ln_friction)), fit=None)
    pulls = np.linspace(1e3, 85e3, 60)
    found = solve_batch(
        {
            "entry_tension": T2 + pulls, "exit_tension": T2, "diameter": on.diameter,
            "wrap_angle": on.wrap_angle, "belt_width": d.belt.width,
            "belt_modulus": d.belt.modulus,
        },
        lagging, capacities=False,
    )  # fmt: skip
    ratio = np.where(np.asarray(found.solved), np.asarray(found["entry_creep_ratio"]), 0.3)
    return pulls, ratio


@dataclass(frozen=True)
class Made:
    """What a log is made from.

    Attributes
    ----------
    days
        Its length.
    friction
        Factor on the law by time [s].
    zero
        Of the speed ratio by time [s].
    loads
        Pulls that the shifts take turns in, over 70 kN.
    lagging
        On the pulley, where it is another than in the drive file.
    """

    days: float = 12.0
    friction: Callable[[Array], Array] = field(default=np.ones_like)
    zero: Callable[[Array], Array] = field(default=lambda t: np.full_like(t, 0.01))
    loads: tuple[float, ...] = (0.15, 0.6, 0.95, 0.35, 0.8, 1.0)
    noise: float = 6e-4
    seed: int = 1
    lagging: str = ""


def readings(made: Made) -> dict[str, Array]:
    """Return time [s], motor speed [rpm], torque [%] and belt speed [m/s] of a plant."""
    rng = np.random.default_rng(made.seed)
    n = int(made.days * DAY / STEP)
    t = np.arange(n) * STEP
    shift = (t // 5400.0).astype(int)
    pull = 70e3 * np.array(made.loads)[shift % len(made.loads)]
    pull = pull * (1.0 + 0.02 * np.sin(t / 700.0))
    ln_f = np.round(np.log(made.friction(t)), 2)
    g = np.empty(n)
    for value in np.unique(ln_f).tolist():
        own = ln_f == value
        g[own] = np.interp(pull[own], *_creep(value, made.lagging))
    d, on = drive(), drive().pulleys[0]
    lagging = load_lagging(made.lagging) if made.lagging else on.lagging
    squeeze = lagging.thickness / (lagging.compression_modulus * d.belt.width * on.radius**2)
    y = made.zero(t) + g + pull / d.belt.axial_stiffness + squeeze * (pull + T2)
    rpm = 1500.0 + 0.4 * rng.standard_normal(n)
    belt = (
        rpm
        * 2.0
        * math.pi
        / 60.0
        / GEAR
        * on.radius
        * (1.0 - y + made.noise * rng.standard_normal(n))
    )
    torque = 100.0 * pull / RATED + 0.6 * rng.standard_normal(n)
    return {
        "time": t, "speed": np.round(rpm, 1), "torque": np.round(torque, 1),
        "belt": np.round(belt, 4),
    }  # fmt: skip


def clock(t: Array) -> list[str]:
    """Return times as text."""
    stamps = (START + t.astype("timedelta64[s]")).astype(str).tolist()
    return [stamp.replace("T", " ") for stamp in stamps]


def wide(values: dict[str, Array]) -> str:
    """Return a table with a column a tag."""
    rows = zip(
        clock(values["time"]), values["speed"], values["torque"], values["belt"], strict=True
    )
    head = "Time,M1 speed [rpm],M1 torque [%],Belt speed [m/s]\n"
    return head + "".join(f"{a},{b},{c},{d}\n" for a, b, c, d in rows)


RATED_TORQUE = RATED * 0.4 / GEAR
LEARN = f"""format = 1
title = "Overland CV-07"
drive = "{DRIVE}"
files = ["trend.csv"]
[[pulley]]
name = "head"
speed_is = "encoder"
gear_ratio = {GEAR:g}
rated_torque = "{RATED_TORQUE:g} N m"
[belt_speed]
at = "tail"
"""


def written(folder: Path, values: dict[str, Array], text: str = LEARN) -> Path:
    """Write a log with its learn file into a folder; return the learn file."""
    (folder / "trend.csv").write_text(wide(values), "utf-8")
    (folder / "learn.toml").write_text(text, "utf-8")
    return folder / "learn.toml"
