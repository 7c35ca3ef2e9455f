"""Made-up trend logs of a drive, with what they were made from.

    python benchmarks/plant_log.py OUT --days 60 --seed 1

Writes OUT/trend.csv, OUT/drive.toml, OUT/learn.toml and OUT/truth.json. Nothing of it is the
learner's: the drum has a measured table where the file has a logarithmic law, its shape is bent,
noise is correlated in time and has far outliers, the wheel gathers dirt and is cleaned, torque
drifts with the temperature of the day, the take-up has a play of another width, and tensions are
those of a belt whose modulus follows the weather.
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import RegularGridInterpolator

from wraparc.arc import WrapArc
from wraparc.batch import solve_batch
from wraparc.drive import Drive, Lagging
from wraparc.friction import MeasuredTable
from wraparc.train.file import load_drive

Array = NDArray[Any]
ROOT = Path(__file__).parents[1]
DRIVE = ROOT / "examples/wet-season/wet-season-drive.toml"
STEP, DAY = 10.0, 86400.0
GEAR, RATED_RPM = 20.0, 1500.0
_TOP, _LEAST = 0.35, 1e-5


@dataclass
class Plant:
    """What is true of a plant, and the log that it left.

    Attributes
    ----------
    friction
        Factor on the law at every step, shape (n,).
    dry
        The same without rain and mud.
    radius
        Change of the pulley's radius at every step [m].
    rain
        Start and stop [s], and change of ln friction.
    """

    days: float
    encoder: bool
    time: Array
    running: NDArray[np.bool_]
    torque: Array
    motor_speed: Array
    belt_speed: Array
    pull: Array
    friction: Array
    dry: Array
    radius: Array
    rain: list[tuple[float, float, float]]
    relagged: float | None
    reserve: float
    mud: Callable[[np.random.Generator, float], tuple[Array, Array, float]]
    stated: dict[str, float] = field(default_factory=dict)


def bent_law(lagging: Lagging, tilt: float, bump: float) -> MeasuredTable:
    """Return the law of a lagging as a table, its slips bent."""
    slip = np.concatenate([[0.0], np.geomspace(2e-4, 0.08, 40)])
    pressure = np.geomspace(3e4, 7e5, 9)
    values = []
    for p in pressure:
        mu = np.asarray(lagging.law.friction(slip, np.full(len(slip), p)), dtype=float)
        shape = (np.maximum(slip, 2e-4) / 4e-3) ** tilt * (
            1.0 + bump * np.exp(-0.5 * (np.log(np.maximum(slip, 2e-4) / 8e-3) / 0.6) ** 2)
        )
        values.append(tuple(np.maximum(mu * shape, np.where(slip > 0.0, 2e-6, 0.0))))
    return MeasuredTable(
        slip=tuple(slip),
        pressure=tuple(pressure),
        values=tuple(values),
        slip_includes=lagging.law.slip_includes,
    )


def creep_of(drive: Drive, lagging: Lagging, stiffness: float) -> Callable[..., Array]:
    """Return entry creep ratio by pull, tension behind and ln friction of a true drum."""
    arc = WrapArc.of(drive, drive.pulleys[0], drive.load_case())
    behind = np.geomspace(20e3, 90e3, 6)
    share = np.geomspace(0.01, 3.4, 34)
    ln_f = np.linspace(math.log(0.12), math.log(2.4), 28)
    grid = np.meshgrid(behind, share, indexing="ij")
    b, s = (g.ravel() for g in grid)
    laggings = [
        replace(lagging, name=str(k), law=lagging.law.scaled(math.exp(f), 1.0), fit=None)
        for k, f in enumerate(ln_f)
    ]
    count = len(b)
    result = solve_batch(
        {
            "entry_tension": np.tile(b * (1.0 + s), len(ln_f)),
            "exit_tension": np.tile(b, len(ln_f)),
            "diameter": arc.diameter, "wrap_angle": arc.wrap_angle, "belt_width": arc.width,
            "belt_modulus": drive.belt.modulus * stiffness, "pitch_offset": arc.offset,
            "cover_compliance": arc.cover_compliance, "centrifugal_force": arc.centrifugal,
            "lagging": np.repeat(np.arange(len(ln_f)), count),
        },
        laggings, capacities=False, threads=1,
    )  # fmt: skip
    g = np.where(np.asarray(result.solved), np.asarray(result["entry_creep_ratio"]), _TOP)
    g = np.clip(np.nan_to_num(g, nan=_TOP), 0.0, _TOP).reshape(len(ln_f), len(behind), len(share))
    look = RegularGridInterpolator(
        (ln_f, np.log(behind), np.log(share)),
        np.log(g + _LEAST),
        bounds_error=False,
        fill_value=None,
    )

    def creep(pull: Array, tension: Array, friction: Array) -> Array:
        points = np.stack(
            [
                np.clip(friction, ln_f[0], ln_f[-1]),
                np.clip(np.log(tension), np.log(behind[0]), np.log(behind[-1])),
                np.clip(
                    np.log(np.maximum(pull, 1.0) / tension), np.log(share[0]), np.log(share[-1])
                ),
            ],
            axis=-1,
        )
        return np.asarray(np.minimum(np.exp(look(points)), _TOP) - _LEAST)

    return creep


def correlated(rng: np.random.Generator, n: int, sd: float, steps: float) -> Array:
    """Return noise that forgets itself in so many steps."""
    from scipy.signal import lfilter

    a = math.exp(-1.0 / steps)
    white = rng.standard_normal(n) * sd * math.sqrt(1.0 - a * a)
    return np.asarray(lfilter([1.0], [1.0, -a], white))


def load_of(rng: np.random.Generator, time: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Return load over design, and whether the belt runs: shifts, empty running, stops."""
    load, running = np.zeros(len(time)), np.ones(len(time), dtype=bool)
    at = 0
    while at < len(time):
        kind = rng.choice(5, p=[0.17, 0.18, 0.27, 0.28, 0.10])
        span = int(rng.gamma(2.0, 1500.0) / STEP) + 30
        level = (0.0, rng.uniform(0.25, 0.5), rng.uniform(0.5, 0.8), rng.uniform(0.8, 1.05), -1.0)[
            kind
        ]
        part = slice(at, at + span)
        if level < 0.0:
            running[part] = False
        else:
            load[part] = level
        at += span
    from scipy.signal import lfilter

    a = math.exp(-STEP / 90.0)
    smooth = np.asarray(lfilter([1.0 - a], [1.0, -a], load))
    return smooth * (1.0 + correlated(rng, len(time), 0.03, 30.0)), running


def make_plant(
    seed: int,
    days: float = 60.0,
    *,
    errors: float = 1.0,
    lagging: str = "",
    slope: float = 0.0,
    drive: Drive | None = None,
) -> tuple[Drive, Plant]:
    """Return a drive and a plant of it.

    Parameters
    ----------
    seed
        Of everything that is drawn.
    days
        Length of the log.
    errors
        Size of its errors over those that are stated.
    lagging
        Another lagging on the drum than in the file.
    slope
        By how much the motor speed is read too high at rated torque [-], beside `errors`.
    drive
        As described; the shipped one unless given.
    """
    rng = np.random.default_rng(seed)
    normal = rng.standard_normal
    drive = drive or load_drive(DRIVE)
    n = int(days * DAY / STEP)
    time = np.arange(n) * STEP
    encoder = bool(seed % 2)
    own = drive.pulleys[0].lagging
    if lagging:
        from wraparc.files.lagging_file import load_lagging

        own = load_lagging(lagging)
    bent = replace(
        own, law=bent_law(own, 0.05 * normal(), 0.06 * normal()), fit=None,
        shear_modulus=own.shear_modulus * math.exp(0.15 * errors * normal()),
    )  # fmt: skip
    stiffness = math.exp(0.10 * errors * normal())
    creep = creep_of(drive, bent, stiffness)
    load, running = load_of(rng, time)
    pull = np.maximum(14e3 + 58e3 * load, 1e3)
    # friction: level, drift, slow weather; new after relagging
    level, drift = 0.2 * normal(), rng.uniform(-0.25, 0.05)
    dry = level + drift * time / (90.0 * DAY) + correlated(rng, n, 0.015, 2.0 * DAY / STEP)
    relagged = None
    radius = -rng.uniform(0.0, 0.4e-3) * time / time[-1]
    if seed % 3 == 0 and days > 30.0:
        relagged = DAY * float(rng.integers(12, int(days) - 12))
        after = time >= relagged
        dry = np.where(after, dry + rng.uniform(0.05, 0.3), dry)
        radius = np.where(after, radius + rng.choice([-1.0, 1.0]) * rng.uniform(2e-3, 8e-3), radius)
    friction, rain = dry.copy(), []
    for _ in range(max(1, int(days / 7.0))):
        start, span = rng.uniform(2.0, days - 1.0) * DAY, rng.uniform(0.5, 6.0) * 3600.0
        deep, wetting, drying = rng.uniform(0.1, 0.6), rng.uniform(60, 250), rng.uniform(900, 3600)
        since, over = np.maximum(time - start, 0.0), np.maximum(time - start - span, 0.0)
        course = np.where(over > 0.0, np.exp(-over / drying), 1.0 - np.exp(-since / wetting))
        friction -= deep * np.where(since > 0.0, course, 0.0)
        rain.append((start, start + span, deep))
    # tensions: a take-up with friction and a play of its own width
    width, rub = rng.uniform(0.05, 0.12) * 80e3, max(0.0, 0.03 + 0.02 * errors * normal())
    play = play_of(pull, width)
    weather = np.sin(2.0 * np.pi * (time / DAY - 0.6)) * rng.uniform(0.3, 1.0)
    behind = 50e3 * math.exp(0.05 * errors * normal()) * (1.0 + rub * play)
    g = creep(pull, behind, friction)
    stiff = (
        drive.belt.axial_stiffness
        * stiffness
        * (1.0 - 0.012 * weather * errors + correlated(rng, n, 0.006 * errors, 5.0 * DAY / STEP))
    )
    r = drive.pulleys[0].radius
    strain = pull / stiff
    squeeze_of = own.thickness / (own.compression_modulus * drive.belt.width * r * r)
    squeeze = squeeze_of * (pull + behind)
    # the wheel gathers dirt and is cleaned
    dirt = np.zeros(n)
    at = 0
    while at < n:
        span = int(rng.exponential(6.0) * DAY / STEP) + 1000
        part = np.arange(min(span, n - at))
        dirt[at : at + span] = rng.uniform(0.0, 9e-4) * (1.0 - np.exp(-part * STEP / (3.0 * DAY)))
        at += span
    zero = 0.01 * normal() - radius / r + dirt + correlated(rng, n, 4e-5, 400.0)
    y = zero + g + strain + squeeze
    gain_0 = 1.0 + 0.03 * errors * normal()
    gain = gain_0 + 0.004 * errors * weather
    offset = 0.02 * errors * normal()
    rated = rated_pull(drive)
    true_torque = pull / rated
    by_torque = (0.0004 if encoder else 0.0012) * errors * normal() + slope
    bend = 6e-5 * errors * np.sin(5.0 * true_torque + rng.uniform(0.0, 6.0))
    outlier = np.where(rng.random(n) < 0.002, 6.0, 1.0)
    torque = true_torque * gain + offset + correlated(rng, n, 0.008, 3.0) * outlier
    ripple = correlated(rng, n, 3e-4, 4.0) * outlier + rng.standard_t(4, n) * 4e-4
    rpm = RATED_RPM * (1.0 + correlated(rng, n, 3e-4, 20.0))
    radius_0 = r + WrapArc.of(drive, drive.pulleys[0], drive.load_case()).offset
    belt = (
        rpm
        * 2.0
        * np.pi
        / 60.0
        / GEAR
        * radius_0
        * (1.0 - y - by_torque * true_torque - bend + ripple)
    )
    rpm, torque, belt = (np.where(running, x, 0.0) for x in (rpm, torque, belt))
    top = float(np.quantile(pull[running], 0.999))
    f = np.linspace(math.log(0.13), math.log(2.3), 500)
    slips = creep(np.full(500, top), np.full(500, float(np.median(behind))), f)
    at_slip = float(np.interp(-0.05, -np.minimum.accumulate(slips), f))

    def mud(rng: np.random.Generator, minutes: float) -> tuple[Array, Array, float]:
        """Return torque and difference of full load while mud comes, and when it slips [s]."""
        count = int(2.0 * minutes * 60.0 / STEP)
        full = np.full(count, float(np.quantile(pull[running], 0.97)))
        t = np.arange(count) * STEP
        lowered = dry[-1] + (at_slip_of(full[0]) - dry[-1]) * t / (minutes * 60.0)
        ratio = creep(full, np.full(count, behind[-1]), lowered)
        own = full / rated
        shown = zero[-1] + ratio + (full / stiff[-1]) + squeeze_of * (full + behind[-1])
        shown = (
            shown
            + by_torque * own
            + correlated(rng, count, 3e-4, 4.0)
            + 4e-4 * rng.standard_t(4, count)
        )
        return own * gain_0 + offset, shown, float(t[int(np.argmax(ratio >= 0.05))])

    def at_slip_of(load: float) -> float:
        found = creep(np.full(500, load), np.full(500, behind[-1]), f)
        return float(np.interp(-0.05, -np.minimum.accumulate(found), f))

    return drive, Plant(
        days, encoder, time, running,
        np.round(100.0 * torque, 1), np.round(rpm, 1), np.round(belt, 4),
        pull, friction, dry, radius, rain, relagged, float(dry[-1]) - at_slip, mud,
    )  # fmt: skip


def rated_pull(drive: Drive) -> float:
    """Effective tension at rated torque: a fifth above the design's [N]."""
    case = drive.load_case()
    tensions = case.tensions[drive.pulleys[0].name]
    return 1.2 * (tensions.entry - tensions.exit)


def rated_torque(drive: Drive) -> float:
    """The same as torque of the motor [N m]."""
    arc = WrapArc.of(drive, drive.pulleys[0], drive.load_case())
    return rated_pull(drive) * (arc.radius + arc.offset) / GEAR


def play_of(pull: Array, width: float) -> Array:
    """Return where a take-up with friction stands, -1 where the pull rose last, to 1."""
    place, found = 0.0, np.empty(len(pull))
    for i, value in enumerate(pull.tolist()):
        place = min(max(place, value - width), value + width)
        found[i] = (place - value) / width
    return found


def write_csv(plant: Plant, path: Path) -> None:
    """Write the log as control systems do: semicolons, decimal commas, a local clock."""
    start = np.datetime64("2026-03-01T00:00:00")
    clock = (start + plant.time.astype("timedelta64[s]")).astype(str)
    with path.open("w") as file:
        file.write("Time;M1 speed [rpm];M1 torque [%];Belt speed [m/s]\n")
        for t, a, b, c in zip(
            clock, plant.motor_speed, plant.torque, plant.belt_speed, strict=True
        ):
            file.write(f"{t.replace('T', ' ')};{a:.1f};{b:.1f};{c:.4f}\n".replace(".", ","))


def learn_text(drive: Drive, plant: Plant, title: str = "Made-up conveyor") -> str:
    """Return the learn file of a plant."""
    return f"""format = 1
title = "{title}"
drive = "drive.toml"
files = ["trend.csv"]

[[pulley]]
name = "{drive.pulleys[0].name}"
speed = "M1 speed"
speed_is = "{"encoder" if plant.encoder else "estimated"}"
gear_ratio = {GEAR:g}
torque = "M1 torque"
rated_torque = "{rated_torque(drive):.6g} N m"

[belt_speed]
column = "Belt speed"
at = "tail"

[take_up]
kind = "gravity"
"""


def truth_of(plant: Plant) -> dict[str, Any]:
    """Return what a log was made from, as plain data."""
    last = plant.relagged or 0.0
    first = int(last / STEP)
    return {
        "ln_friction": float(plant.dry[-1]),
        "ln_friction_change": float(plant.dry[-1] - plant.dry[first]),
        "radius_change": float(plant.radius[-1] - plant.radius[first]),
        "ln_reserve": plant.reserve,
        "relagged_day": None if plant.relagged is None else plant.relagged / DAY,
        "rain": plant.rain,
        "encoder": plant.encoder,
    }


def main() -> None:
    """Write a log with its files."""
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=Path)
    parser.add_argument("--days", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    drive, plant = make_plant(given.seed, given.days)
    write_csv(plant, given.out / "trend.csv")
    (given.out / "drive.toml").write_text(DRIVE.read_text())
    (given.out / "learn.toml").write_text(learn_text(drive, plant))
    (given.out / "truth.json").write_text(json.dumps(truth_of(plant), indent=1))


if __name__ == "__main__":
    main()
