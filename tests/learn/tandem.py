"""A tandem whose truth is known: two pulleys of one belt, their speeds by the solver.

What is expected of the learner are the numbers put in here. Both motors share the torque equally;
one wheel measures the belt, whose wobble both speed differences have in common.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from learn.plant import DAY, EXAMPLES, GEAR, Array, clock
from wraparc.batch import solve_batch
from wraparc.train.file import load_drive

DRIVE = EXAMPLES / "tandem-fabric.toml"
NAMES, T2, RATED, ZEROS = ("first", "second"), 45e3, 60e3, (0.010, 0.004)
LEARN = f"""format = 1
title = "Overland CV-08"
drive = "{DRIVE}"
files = ["trend.csv"]
[[pulley]]
name = "first"
speed = "M1 speed"
torque = "M1 torque"
speed_is = "encoder"
gear_ratio = {GEAR:g}
rated_torque = "{RATED * 0.4 / GEAR:g} N m"
[[pulley]]
name = "second"
speed = "M2 speed"
torque = "M2 torque"
speed_is = "encoder"
gear_ratio = {GEAR:g}
rated_torque = "{RATED * 0.4 / GEAR:g} N m"
"""


@cache
def creep(which: int, ln_friction: float) -> tuple[Array, Array]:
    """Pulls of one pulley, and its entry creep ratio at each; the other pulls as much."""
    drive = load_drive(DRIVE)
    on = drive.pulleys[which]
    lagging = replace(on.lagging, law=on.lagging.law.scaled(math.exp(ln_friction)), fit=None)
    pulls = np.linspace(1e3, 60e3, 50)
    behind = T2 + (pulls if which == 0 else 0.0)
    found = solve_batch(
        {
            "entry_tension": behind + pulls, "exit_tension": behind, "diameter": on.diameter,
            "wrap_angle": on.wrap_angle, "belt_width": drive.belt.width,
            "belt_modulus": drive.belt.modulus,
        },
        lagging, capacities=False,
    )  # fmt: skip
    ratio = np.where(np.asarray(found.solved), np.asarray(found["entry_creep_ratio"]), 0.3)
    return pulls, ratio


def written(folder: Path, days: float, falls: tuple[float, float], seed: int = 1) -> Path:
    """Write a log with its learn file; the friction of each pulley falls by so much a day."""
    drive = load_drive(DRIVE)
    rng, step = np.random.default_rng(seed), 30.0
    n = int(days * DAY / step)
    t = np.arange(n) * step
    loads = np.array((0.2, 0.7, 1.0, 0.4, 0.85, 0.95))
    pull = 50e3 * loads[(t // 5400.0).astype(int) % len(loads)] * (1.0 + 0.02 * np.sin(t / 700.0))
    wheel = 4e-4 * rng.standard_normal(n)
    rows: list[Any] = [clock(t)]
    heads = ["Time"]
    belt = 3.0 * (1.0 + 1e-4 * rng.standard_normal(n))
    for which, fall in enumerate(falls):
        ln_f = np.round(-fall * t / DAY, 2)
        g = np.empty(n)
        for value in np.unique(ln_f).tolist():
            own = ln_f == value
            g[own] = np.interp(pull[own], *creep(which, value))
        on = drive.pulleys[which]
        entering = T2 + pull * (2.0 if which == 0 else 1.0)
        lagging = on.lagging
        squeeze = lagging.thickness / (
            lagging.compression_modulus * drive.belt.width * on.radius**2
        )
        y = ZEROS[which] + g + (entering - T2) / drive.belt.axial_stiffness + squeeze * entering
        # the drives follow the belt: what the wheel shows of it wobbles
        rpm = belt / (1.0 - y) / on.radius * GEAR * 60.0 / (2.0 * math.pi)
        rows.append(np.round(rpm * (1.0 + 1e-4 * rng.standard_normal(n)), 1))
        rows.append(np.round(100.0 * pull / RATED + 0.6 * rng.standard_normal(n), 1))
        heads += [f"M{which + 1} speed [rpm]", f"M{which + 1} torque [%]"]
    rows.append(np.round(belt * (1.0 + wheel), 4))
    heads.append("Belt speed [m/s]")
    lines = [",".join(map(str, row)) for row in zip(*rows, strict=True)]
    (folder / "trend.csv").write_text("\n".join([",".join(heads), *lines]), "utf-8")
    (folder / "learn.toml").write_text(LEARN, "utf-8")
    return folder / "learn.toml"
