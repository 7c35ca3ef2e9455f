"""How often the truth lies in the 95 % intervals: a long run beside the gate.

    python tests/calibrate/coverage.py 200 60 60

writes tests/calibrate/coverage.json, which the gate reads: repetitions with a record of creep and
shear angle, of creep alone, and of the shear angle alone. The last two do not tell all parameters;
there it counts whether those are held back that the data leave open.
"""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

from wraparc import Distributed, WrapArc
from wraparc.calibrate.calibration import (
    PARAMETERS,
    Calibration,
    Problemset,
    Trace,
    calibrate,
    calibrated_drive,
)
from wraparc.files import load_drive

RESULT = Path(__file__).with_name("coverage.json")
_FILE = Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml"
DRIVE = calibrated_drive(load_drive(_FILE), "head", {"shear_modulus": 2.3e6})  # where fits start
TRUTH = {
    "friction": 0.9,
    "peak_slip": 1.1,
    "shear_modulus": 2.0e6,
    "overrun": 1.5e-4,
    "belt_modulus": 11e6,
}
NOISE = 0.01
POINTS = 90


def clean() -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Creep and shear angle along the arc of the true drive, on a fine profile."""
    drive = calibrated_drive(DRIVE, "head", TRUTH)
    arc = WrapArc.of(drive, drive.pulleys[0], drive.load_cases[0])
    profile = Distributed(points=720, capacities=False).solve(arc).profile
    position = np.linspace(0.0, arc.wrap_angle, POINTS)
    return {
        name: (position, np.interp(position, profile.position, getattr(profile, name)))
        for name in ("creep", "shear_angle")
    }


def calibrated(seed: int, courses: dict[str, tuple[np.ndarray, np.ndarray]]) -> Calibration:
    """All five parameters from one virtual record with 1 % noise, started from the wrong drive."""
    rng = np.random.default_rng(seed)
    traces = tuple(
        Trace(
            quantity=name,
            position=position,
            value=value + NOISE * value.max() * rng.standard_normal(POINTS),
            sd=None,
            load_case="design",
        )
        for name, (position, value) in courses.items()
    )
    problem = Problemset(drive=DRIVE, pulley="head", parameters=PARAMETERS, traces=traces)
    return calibrate(problem)


def hits(found: Calibration) -> list[bool | None]:
    """Whether each interval holds the truth; None where the parameter is not told."""
    return [
        None if e.low is None or e.high is None else e.low <= TRUTH[e.name] <= e.high
        for e in found.estimates
    ]


def table(rows: list[list[bool | None]]) -> dict[str, dict[str, float | None]]:
    """Of each parameter: how often it is told, and how often its interval then holds the truth."""
    columns = zip(*rows, strict=True)
    told = [[hit for hit in column if hit is not None] for column in columns]
    return {
        name: {"told": len(hit) / len(rows), "coverage": float(np.mean(hit)) if hit else None}
        for name, hit in zip(PARAMETERS, told, strict=True)
    }


def intervals(found: Calibration) -> list[list[float | None]]:
    """Interval and value of each parameter; of the first repetition the gate finds them again."""
    return [[e.low, e.value, e.high] for e in found.estimates]


def kinds(courses: Any) -> dict[str, Any]:
    """Return the records: of both signals, of creep alone, of the shear angle alone."""
    return {
        "creep and shear angle": courses,
        "creep alone": {"creep": courses["creep"]},
        "shear angle alone": {"shear_angle": courses["shear_angle"]},
    }


def main(repetitions: list[int]) -> None:
    """Write the table of each record."""
    records = kinds(clean())
    found = {
        title: {
            "repetitions": count,
            "first": intervals(calibrated(0, record)),
            "parameters": table([hits(calibrated(seed, record)) for seed in range(count)]),
        }
        for (title, record), count in zip(records.items(), repetitions, strict=True)
    }
    RESULT.write_text(json.dumps({"noise": NOISE, "records": found}, indent=1) + "\n")


if __name__ == "__main__":
    main([int(count) for count in sys.argv[1:]])
