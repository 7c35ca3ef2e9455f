"""How often the truth lies in the 95 % intervals: a long run beside the gate.

    python tests/calibrate/coverage.py 200

writes tests/calibrate/coverage.json, which the gate reads.
"""

import json
import sys
from pathlib import Path

import numpy as np

from wraparc import Distributed, WrapArc
from wraparc.files import load_drive
from wraparc.study.calibration import (
    PARAMETERS,
    Calibration,
    Problemset,
    Trace,
    calibrate,
    calibrated_drive,
)

RESULT = Path(__file__).with_name("coverage.json")
DRIVE = load_drive(Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml")
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


def hits(found: Calibration) -> list[bool]:
    """Whether each interval holds the truth."""
    return [
        e.low is not None and e.high is not None and e.low <= TRUTH[e.name] <= e.high
        for e in found.estimates
    ]


def main(repetitions: int) -> None:
    courses = clean()
    found = [hits(calibrated(seed, courses)) for seed in range(repetitions)]
    share = dict(zip(PARAMETERS, np.mean(found, axis=0).tolist(), strict=True))
    RESULT.write_text(
        json.dumps({"repetitions": repetitions, "noise": NOISE, "coverage": share}, indent=1) + "\n"
    )


if __name__ == "__main__":
    main(int(sys.argv[1]))
