"""Drives learned from made-up logs: how often the truth is in the intervals, what is found.

    python -m benchmarks.learn_drums 60 --first 301 [--errors 2] [--lagging full-ceramic]

The logs are those of `plant_log.py`, whose errors are not the learner's. Writes a row a plant as
JSON lines to build/learn_drums.jsonl and prints the sums.
"""

from __future__ import annotations

import argparse
import json
import math
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.plant_log import DAY, DRIVE, STEP, Plant, learn_text, make_plant, truth_of

from wraparc.drive import Drive
from wraparc.learn.episodes import PROMISE, WANTED
from wraparc.learn.file import LearnPlan, TagChoice, load_plan
from wraparc.learn.grid import on_grid
from wraparc.learn.learn import Learned, learn_windows
from wraparc.learn.lines import Interval
from wraparc.learn.model import SpeedModel, running_radius, speed_model
from wraparc.learn.tags import Log, Signal
from wraparc.learn.windows import find_windows

LEAST_LOAD, DEEP = 0.30, 0.2


def learned_of(drive: Drive, plant: Plant) -> Learned:
    """Return what is learned of a plant, without the way over a file."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "drive.toml").write_text(DRIVE.read_text())
        Path(folder, "learn.toml").write_text(learn_text(drive, plant))
        plan = load_plan([str(Path(folder, "learn.toml"))])
    name, turns = plan.pulleys[0].pulley, 2.0 * math.pi / 60.0
    start = 1772323200.0 + plant.time
    signals = {
        f"speed.{name}": Signal(f"speed.{name}", "M1 speed", start, plant.motor_speed * turns),
        f"torque.{name}": Signal(f"torque.{name}", "M1 torque", start, plant.torque / 100.0),
        "belt_speed": Signal("belt_speed", "Belt speed", start, plant.belt_speed),
    }
    log = Log(signals, plan.pulleys, len(start), 0, ())
    grid = on_grid(log, "made up")
    windows = find_windows(grid, log, [running_radius(plan.drive, name)])
    model = _model(plan, log.pulleys)
    return learn_windows(plan, log, grid, windows, model)


_MODELS: dict[tuple[TagChoice, ...], SpeedModel] = {}


def _model(plan: LearnPlan, pulleys: tuple[TagChoice, ...]) -> SpeedModel:
    """Return the model of the drive: its tables are the same for every plant."""
    if pulleys not in _MODELS:
        _MODELS[pulleys] = speed_model(plan, pulleys, 1.0)
    return _MODELS[pulleys]


def holds(of: Interval | None, truth: float, *, is_factor: bool) -> dict[str, Any] | None:
    """Return whether an interval holds the truth, half its width, and the error."""
    if of is None:
        return None
    low, value, high = (math.log(v) if is_factor else v for v in (of.low, of.value, of.high))
    return {
        "held": low <= truth <= high,
        "half": 0.5 * (high - low),
        "error": value - truth,
        "truth": truth,
    }


def row_of(seed: int, days: float, errors: float, lagging: str) -> dict[str, Any]:
    """Return what one plant comes to."""
    drive, plant = make_plant(seed, days, errors=errors, lagging=lagging)
    began = time.process_time()
    learned = learned_of(drive, plant)
    seconds = time.process_time() - began
    truth, pulley = truth_of(plant), learned.pulleys[0]
    radius = drive.pulleys[0].radius
    day = truth["relagged_day"]
    cut = any(day is not None and abs(c - day) <= 3 for c in learned.cuts)
    row = {
        "seed": seed, "encoder": plant.encoder, "seconds": seconds, "hours": learned.windows.hours,
        "friction": holds(pulley.friction, truth["ln_friction"], is_factor=True),
        "reserve": holds(pulley.reserve, truth["ln_reserve"], is_factor=True),
        "sensitivity": pulley.sensitivity, "moved": learned.moved, "unlike": list(learned.unlike),
        "cuts": {"true": int(day is not None), "found": int(cut),
                 "false": len(learned.cuts) - int(cut)},
        "alarms": pulley.line.false_alarms, "passed": _passed(learned, plant),
        "cannot": list(learned.cannot),
    }  # fmt: skip
    if day is None or cut:
        since = int(max(learned.since, 0.0) * DAY / STEP) if day is not None else 0
        since = min(since + int(1.5 * DAY / STEP) * (day is not None), len(plant.dry) - 1)
        change = float(plant.dry[-1] - plant.dry[since])
        row["change"] = holds(pulley.friction_change, change, is_factor=True)
        worn = -float(plant.radius[-1] - plant.radius[since]) / radius
        row["zero"] = holds(pulley.zero_change, worn, is_factor=False)
    row.update(_episodes(learned, plant))
    row["mud"] = _mud(learned, plant, seed)
    return row


def _episodes(learned: Learned, plant: Plant) -> dict[str, Any]:
    """Return which falls were found, when, and how many episodes are none."""
    load = plant.pull / np.quantile(plant.pull, 0.995)
    falls, used = [], set()
    for start, stop, deep in plant.rain:
        part = slice(int(start / STEP), int(min(stop, start + 7200.0) / STEP))
        loaded = (load[part] >= LEAST_LOAD) & plant.running[part]
        fits = [
            (k, e) for k, e in enumerate(learned.episodes.found)
            if e.stop > start and e.start < stop + 3600.0
        ]  # fmt: skip
        used |= {k for k, _ in fits}
        if loaded.sum() * STEP < 2700.0 or loaded.mean() < 0.6:
            continue
        known = min((e.alarmed for _, e in fits), default=math.nan)
        falls.append([deep, bool(fits), _loaded_minutes(plant, load, start, known)])
    dip = plant.dry - plant.friction
    false = 0
    for k, e in enumerate(learned.episodes.found):
        part = slice(max(int(e.start / STEP), 0), int(e.stop / STEP))
        if k not in used and dip[part].max(initial=0.0) < 0.04:
            false += 1
    return {"falls": falls, "false": false, "years": learned.windows.hours / 8766.0}


def _passed(learned: Learned, plant: Plant) -> int:
    """Return how often the alarm line is passed where friction is not low, 30 min apart."""
    windows, fit, line = learned.windows, learned.fit, learned.pulleys[0].line
    zero = fit.course("zero", windows.time / DAY)[0]
    end = fit.course("zero", np.array([learned.stop - 1e-9]))[0, 0]
    over = windows.difference[0] - zero + end > np.interp(
        windows.torque[0], line.torque, line.alarm
    )
    dip = (plant.dry - plant.friction)[
        np.minimum(windows.time / STEP, len(plant.dry) - 1).astype(int)
    ]
    times = windows.time[over & (dip < 0.04)]
    return int(np.sum(np.diff(times, prepend=-1e9) > 1800.0))


def _loaded_minutes(plant: Plant, load: Any, start: float, known: float) -> float:
    """Return the minutes of loaded running from the onset of a fall until it is known."""
    if math.isnan(known):
        return math.nan
    part = slice(int(start / STEP), max(int(known / STEP), int(start / STEP)))
    return float(np.sum((load[part] >= LEAST_LOAD) & plant.running[part])) * STEP / 60.0


def _mud(learned: Learned, plant: Plant, seed: int) -> float | None:
    """Return how long before it slips through the line warns [min]; None where it does not."""
    rng = np.random.default_rng(1000 + seed)
    torque, difference, slips = plant.mud(rng, rng.uniform(15.0, 24.0))
    line, steps = learned.pulleys[0].line, 12
    mean = np.convolve(difference, np.ones(steps) / steps, "valid")
    level = np.interp(torque[steps - 1 :], line.torque, line.alarm)
    over = np.flatnonzero(mean > level)
    if not len(over):
        return None
    return (slips - (int(over[0]) + steps - 1) * STEP) / 60.0


def summary(rows: list[dict[str, Any]]) -> str:
    """Return the sums as a table."""
    lines = [
        "| what | held | half-interval | rms error | bias | drums |",
        "|---|---|---|---|---|---|",
    ]
    for key in ("friction", "change", "reserve", "zero"):
        of = [r[key] for r in rows if r.get(key)]
        if of:
            error = np.array([o["error"] for o in of])
            size = (100.0, " % of speed") if key == "zero" else (1.0, "")
            lines.append(
                f"| {key} | {100.0 * np.mean([o['held'] for o in of]):.1f} % | "
                f"{size[0] * np.median([o['half'] for o in of]):.3f}{size[1]} | "
                f"{size[0] * np.sqrt(np.mean(error**2)):.3f} | {size[0] * error.mean():+.3f} | "
                f"{len(of)} |"
            )
    falls = [f for r in rows for f in r["falls"]]
    for low, high in ((0.1, 0.2), (0.2, 0.35), (0.35, 0.61), (0.2, 0.61)):
        of = [f for f in falls if low <= f[0] < high]
        if of:
            delay = [f[2] for f in of if f[1]]
            lines.append(
                f"\nFalls {low:g} to {high:g} at {LEAST_LOAD:.0%} load and more: found "
                f"{100.0 * np.mean([f[1] for f in of]):.0f} % of {len(of)}, "
                f"median {np.median(delay):.0f} min of loaded running, "
                f"90 % {np.quantile(delay, 0.9):.0f} min."
            )
    years = sum(r["years"] for r in rows)
    stated = [sum(r["alarms"][k] * r["years"] for r in rows) / years for k in (0, 1)]
    lines.append(
        f"\nFalse episodes: {sum(r['false'] for r in rows) / years:.1f} a running year, where "
        f"{WANTED:g} to {WANTED * PROMISE:g} are expected. Without a fall the alarm line was "
        f"passed {sum(r['passed'] for r in rows) / years:.1f} times a running year, where "
        f"{stated[0]:.2g} to {stated[1]:.2g} are stated."
    )
    true = sum(r["cuts"]["true"] for r in rows)
    lines.append(
        f"Cuts: {sum(r['cuts']['found'] for r in rows)} of {true} found, "
        f"{sum(r['cuts']['false'] for r in rows)} false in {len(rows)} plants."
    )
    mud = [r["mud"] for r in rows]
    warned = [m for m in mud if m is not None and m > 0.0]
    lines.append(
        f"Mud under full load: the line warned before slip-through in {len(warned)} of {len(mud)}, "
        f"median {np.median(warned):.1f} min, 10 % {np.quantile(warned, 0.1):.1f} min."
    )
    told = [r for r in rows if r["friction"] is not None]
    unknown = sum("which lagging is on the pulley" in r["cannot"] for r in told)
    seconds = np.mean([r["seconds"] for r in rows])
    moved = ", ".join(
        f"{r['seed']} {name} {size:+.1f}"
        for r in rows
        for name, size in r["moved"].items()
        if abs(size) == max(map(abs, r["moved"].values()))
    )
    lines.append(
        f"Friction told in {len(told)} of {len(rows)}, {unknown} of them with the lagging as not "
        f"known; {seconds:.1f} s CPU each."
    )
    lines.append(f"Beyond three standard deviations, and friction not told: {moved or 'none'}.")
    return "\n".join(lines)


def main() -> None:
    """Learn some plants."""
    parser = argparse.ArgumentParser()
    parser.add_argument("count", type=int)
    parser.add_argument("--first", type=int, default=101)
    parser.add_argument("--days", type=float, default=60.0)
    parser.add_argument("--errors", type=float, default=1.0)
    parser.add_argument("--lagging", default="")
    parser.add_argument("--out", type=Path, default=Path("build/learn_drums.jsonl"))
    given = parser.parse_args()
    given.out.parent.mkdir(parents=True, exist_ok=True)
    rows = []
    with given.out.open("w") as file:
        for seed in range(given.first, given.first + given.count):
            rows.append(row_of(seed, given.days, given.errors, given.lagging))
            file.write(json.dumps(rows[-1]) + "\n")
            file.flush()
    print(summary(rows))


if __name__ == "__main__":
    main()
