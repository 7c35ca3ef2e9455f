"""Speed ratios of a real belt: how often 95 % intervals hold the friction that made them.

    python benchmarks/calibrate_speeds.py 200

Simulates records of a drive whose belt thickness, tensions, wheel of the tachometer, compression
and shear of the lagging and shear of the belt cover are wrong within their stated errors,
calibrates friction to each, and tells how many intervals hold the truth: with a zero record of the
idling belt, and without one, where the offset of the tension member is known to its stated error
alone.
"""

import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from wraparc.calibrate.calibration import Calibration, Number, Problemset, calibrate
from wraparc.calibrate.problem import OPEN_ZERO, arc_of, calibrated_drive, speed_ratio, usual_method
from wraparc.drive import Drive, Tensions
from wraparc.drive.changes import with_pulley
from wraparc.drive.pitch import pitch_offset
from wraparc.train.file import load_drive

EXAMPLE = Path(__file__).parents[1] / "examples" / "head-drive-fabric.toml"
#: Standard deviations as they are stated: of the offset [m], of the others as shares.
OFFSET, WHEEL = 0.5e-3, 1e-3
STATED = {
    "exit_tension": 0.02, "effective_tension": 0.03,
    "compression": 0.2, "lagging_shear": 0.1, "cover_shear": 0.2,
}  # fmt: skip
#: Of a reading of the speed ratio, averaged over minutes [-].
READING = 5e-5
FRICTION = 0.85
IDLING = Tensions(entry=63e3, exit=60e3)
CASES = ("design", "empty")


@dataclass(frozen=True, eq=False)
class Simulated:
    """Calibrations of simulated records, and how many of their intervals hold the truth."""

    found: tuple[Calibration, ...]

    @property
    def told(self) -> list[tuple[float, float]]:
        """Intervals of the records that tell the friction [-]."""
        each = [c.estimates[0] for c in self.found]
        return [(e.low, e.high) for e in each if e.low is not None and e.high is not None]

    @property
    def coverage(self) -> float:
        """Share of them that holds the truth [-]."""
        held = [low <= FRICTION <= high for low, high in self.told]
        return sum(held) / len(held) if held else float("nan")


def described() -> Drive:
    """The drive as its file describes it: a belt of 20.6 mm, e = 8.3 mm, its cover in series."""
    drive = load_drive(EXAMPLE)
    pulley = drive.pulleys[0]
    law = replace(pulley.lagging.law, slip_includes=())
    drive = with_pulley(drive, replace(pulley, lagging=replace(pulley.lagging, law=law)))
    return replace(drive, belt=replace(drive.belt, pulley_cover=4e-3, carry_cover=8e-3))


def record(drive: Drive, rng: np.random.Generator) -> tuple[list[Number], Number]:
    """Readings at two loads and of the idling belt, of a drive that is not as it is described."""
    errors = {name: float(np.exp(sd * rng.standard_normal())) for name, sd in STATED.items()}
    wheel = float(np.exp(WHEEL * rng.standard_normal()))
    cover = drive.belt.pulley_cover or 0.0
    belt = replace(drive.belt, pulley_cover=cover + OFFSET * rng.standard_normal())
    true = calibrated_drive(replace(drive, belt=belt), "head", {"friction": FRICTION})

    def reading(case: str, tensions: Tensions | None = None) -> Number:
        arc = arc_of(true, "head", (case, tensions), errors)
        g = float(usual_method().solve(arc).scalars()["exit_creep_ratio"])
        value = speed_ratio(arc, g, wheel) + READING * rng.standard_normal()
        return Number(
            quantity="exit_creep_ratio", value=value, sd=READING, load_case=case,
            apparent=True, tensions=tensions,
        )  # fmt: skip

    return [reading(case) for case in CASES], reading("design", IDLING)


def problem(drive: Drive, numbers: list[Number], zero: Number | None) -> Problemset:
    """Return what a calibrate file with these readings and the stated errors asks."""
    e = pitch_offset(drive.belt, "pulley")
    assert e is not None
    by_zero = float(np.hypot(WHEEL, OFFSET / (0.5 * drive.pulleys[0].diameter + e)))
    known = OPEN_ZERO if zero is not None else by_zero
    return Problemset(
        drive=drive,
        pulley="head",
        parameters=("friction",),
        numbers=tuple(n for n in (*numbers, zero) if n is not None),
        zero=zero,
        errors={"speed_zero": known, **STATED},
    )


def simulated(count: int, *, zeroed: bool = True, first: int = 1) -> Simulated:
    """Calibrate friction to simulated records, with a zero record or without one."""
    found, drive = [], described()
    for seed in range(first, first + count):
        numbers, zero = record(drive, np.random.default_rng(seed))
        found.append(calibrate(problem(drive, numbers, zero if zeroed else None)))
    return Simulated(tuple(found))


def main(count: int) -> None:
    """Print the share of the intervals that hold the truth, and how wide they are."""
    for title, zeroed in (("zero record", True), ("offset stated", False)):
        ran = simulated(count, zeroed=zeroed)
        widths = [0.5 * (high - low) / FRICTION for low, high in ran.told]
        print(
            f"{title}: {len(ran.told)} of {count} tell the friction, {100 * ran.coverage:.1f} % of "
            f"their intervals hold the truth; half width {100 * np.median(widths):.1f} %",
            flush=True,
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 200)
