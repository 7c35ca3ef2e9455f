"""Do the 95 % intervals of a shear-test fit hold the truth 95 times of 100?

    python benchmarks/shear_test_coverage.py --repetitions 400 --points 2000 --study noise \\
        --table benchmarks/results/shear_test_coverage.md

Virtual tests of a known law (8 pressures, 3 repeats, 1 % noise, lash about 0.5 mm) are fitted
again and again, the form of the pressure dependence chosen anew each time. Counted is how often
each interval holds the truth, and how far the estimates are off.
The gate runs the same with few repetitions (tests/shear_test/test_coverage.py).
"""

import argparse
import time
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from wraparc.files import load_lagging
from wraparc.friction import IntegralLog, PressureKnots, TestedRange
from wraparc.shear_test import PlannedTest, Rig, TestPlan, VirtualRig, run_virtual_test
from wraparc.shear_test.analysis import TestResult
from wraparc.shear_test.condition_fit import fit_condition
from wraparc.shear_test.misfit import judged_fit
from wraparc.shear_test.record import MachineRecord
from wraparc.shear_test.reduce import Sample, reduce_record
from wraparc.shear_test.student import t95
from wraparc.shear_test.transition import transition_interval

PRESSURES = np.array([34, 69, 103, 138, 207, 276, 414, 690]) * 1e3
REPEATS = 3
TRANSITION = 172e3
SHEAR_COMPLIANCE = 12e-3 / 2.3e6


def rubber() -> IntegralLog:
    """Two straight pieces of peak slip and of peak friction, peak beyond the tested slip."""
    return _law([34e3, TRANSITION, 690e3], [1.30, 0.86, 0.385], [0.016, 0.0205, 0.026])


def ceramic() -> IntegralLog:
    """Two straight pieces; below the transition the peak is passed and friction falls."""
    return _law([34e3, TRANSITION, 690e3], [1.55, 1.31, 0.535], [0.004, 0.0150, 0.0215], falls=True)


def cubics() -> IntegralLog:
    """The catalogue's diamond rubber: monotone cubics through eleven knots."""
    law = load_lagging("diamond-rubber").law
    assert isinstance(law, IntegralLog)
    return law


def _law(
    pressures: list[float], friction: list[float], slip: list[float], *, falls: bool = False
) -> IntegralLog:
    # Knots so close that the cubics between them are straight to 1e-6.
    p = np.unique(np.concatenate([np.linspace(pressures[0], pressures[-1], 400), pressures]))
    mu, x = np.interp(p, pressures, friction), np.interp(p, pressures, slip)
    slope = np.interp(p, [150e3, TRANSITION], [-13.0, 0.0]) if falls else np.zeros_like(p)
    knots = PressureKnots(
        pressure=tuple(p.tolist()),
        peak_friction=tuple(mu.tolist()),
        peak_slip=tuple(x.tolist()),
        post_peak_slope=tuple(slope.tolist()),
        residual_friction=tuple((0.92 * mu).tolist()),
    )
    tested = TestedRange(pressure_min=34e3, pressure_max=690e3, slip_max=15e-3)
    return IntegralLog(coefficients=knots, tested=tested)


@dataclass(frozen=True)
class Study:
    """One kind of virtual laboratory."""

    title: str
    law: Callable[[], IntegralLog]
    rig: VirtualRig
    corner: bool = True  # whether the law has a transition to be found


def studies(points: int) -> dict[str, Study]:
    base = VirtualRig(law=rubber(), shear_compliance=SHEAR_COMPLIANCE, points=points)
    scattered = replace(base, scatter_friction=0.02, scatter_slip=0.03)
    return {
        "noise": Study("rubber, 1 % noise, samples alike", rubber, base),
        "scatter": Study("rubber, samples scatter by 2 % and 3 %", rubber, scattered),
        "peak": Study("ceramic, peak inside, 1 % noise", ceramic, replace(base, law=ceramic())),
        "outside": Study(
            "a law that no form follows exactly, samples scatter by 2 % and 3 %",
            cubics,
            scattered,
            corner=False,
        ),
    }


def run_once(study: Study, seed: int) -> dict[str, list[tuple[bool, float]]]:
    """Fit one virtual laboratory; by quantity, whether each interval held and the error."""
    law = study.law()
    lash = float(np.random.default_rng(10**6 + seed).uniform(0.45e-3, 0.55e-3))
    rig = replace(study.rig, law=law, lash=lash)
    plan = TestPlan(
        name="virtual", rig=Rig(area=rig.area), tests=(), thickness=12e-3, shear_modulus=2.3e6
    )
    counted: dict[str, list[tuple[bool, float]]] = defaultdict(list)
    results, levels = [], []
    for level, pressure in enumerate(PRESSURES):
        for repeat in range(REPEATS):
            test = run_virtual_test(rig, float(pressure), seed * 1000 + level * REPEATS + repeat)
            sample = Sample(area=rig.area, shear_compliance=SHEAR_COMPLIANCE)
            curve = reduce_record(
                _record(test.time, test.travel, test.force, test.normal_force), sample
            )
            judged = judged_fit(curve, plan.rig.largest_lash)
            results.append(
                TestResult(
                    test=PlannedTest(file=f"{level}-{repeat}", place="test"),
                    record=_record(test.time, test.travel, test.force, test.normal_force),
                    curve=curve,
                    judged=judged,
                    other=None,
                )
            )
            levels.append(level)
            slip, friction, slope, _ = (float(v) for v in law.parameters(pressure))
            truth = {
                "curve: peak slip": ("ln_peak_slip", np.log(slip * test.slip_factor)),
                "curve: peak friction": (
                    "ln_peak_friction",
                    np.log(friction * test.friction_factor),
                ),
                "curve: lash": ("lash", lash),
            }
            if slope < 0.0:
                own = slope * test.friction_factor / test.slip_factor
                truth["curve: post-peak slope"] = ("post_peak_slope", own)
            for name, (parameter, value) in truth.items():
                if parameter in judged.fit.free:
                    low, high = judged.fit.interval(parameter)
                    off = getattr(judged.fit.parameters, parameter) - value
                    size = 1.0 if parameter != "post_peak_slope" else abs(value)
                    counted[name].append((bool(low <= value <= high), off / size))
    found = fit_condition(plan, "dry", results, np.array(levels)).found
    fit = found.fit
    assert fit is not None
    slips, frictions, _, _ = law.parameters(PRESSURES)
    gaps = fit.peaks(PRESSURES) - np.log(np.stack([slips, frictions], axis=-1))
    half = t95(fit.freedom) * fit.peak_errors(PRESSURES)
    for k, name in enumerate(("law: peak slip", "law: peak friction")):
        counted[name] += [
            (bool(abs(o) <= h), float(o)) for o, h in zip(gaps[:, k], half[:, k], strict=True)
        ]
    if found.transition is not None and found.transition.in_law and study.corner:
        low, high = transition_interval(fit, found.points)
        held = bool(low <= TRANSITION <= high)
        counted["transition pressure"].append((held, found.transition.pressure / TRANSITION - 1.0))
    inside = [item.noise_levels for item in found.left_out if item.inside]
    counted["left-out pressure [noise levels]"].append((max(inside) <= 2.0, max(inside)))
    return counted


def _record(
    time: NDArray[np.float64],
    travel: NDArray[np.float64],
    force: NDArray[np.float64],
    normal: NDArray[np.float64],
) -> MachineRecord:
    count = len(travel)
    return MachineRecord(
        file="virtual", place="", encoding="", delimiter="", decimal=".", columns=(),
        travel=travel, force=force, normal_force=normal, time=time,
        lines=np.arange(1, count + 1), rows=count, dropped=(), notes=(), header=(), digest="",
    )  # fmt: skip


def run(study: Study, repetitions: int, first: int = 1) -> dict[str, list[tuple[bool, float]]]:
    counted: dict[str, list[tuple[bool, float]]] = defaultdict(list)
    for seed in range(first, first + repetitions):
        for name, cases in run_once(study, seed).items():
            counted[name] += cases
    return counted


def table(counted: dict[str, list[tuple[bool, float]]]) -> str:
    lines = [
        "| quantity | intervals | hold the truth | bias | spread | largest error |",
        "|---|---|---|---|---|---|",
    ]
    for name, cases in counted.items():
        held = np.array([h for h, _ in cases])
        off = np.array([o for _, o in cases])
        if name == "curve: lash":
            texts = [f"{v * 1e3:.4f} mm" for v in (off.mean(), off.std(), np.abs(off).max())]
        elif "noise levels" in name:
            texts = [f"{v:.2f}" for v in (off.mean(), off.std(), off.max())]
        else:
            texts = [f"{v * 100:.2f} %" for v in (off.mean(), off.std(), np.abs(off).max())]
        lines.append(f"| {name} | {len(cases)} | {100 * held.mean():.1f} % | {' | '.join(texts)} |")
    return "\n".join(lines)


def section(title: str, repetitions: int, points: int, counted: str) -> str:
    """What was done and came out, as a section of a page."""
    return (
        f"### {title[:1].upper()}{title[1:]}\n\n"
        f"{repetitions} repetitions, {points} readings a test.\n\n{counted}\n"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0] if __doc__ else None)
    parser.add_argument("--repetitions", type=int, default=400)
    parser.add_argument("--points", type=int, default=5000)
    parser.add_argument("--study", action="append", choices=list(studies(2)))
    parser.add_argument("--table", default=None, help="append the sections to this file")
    arguments = parser.parse_args()
    for name, study in studies(arguments.points).items():
        if arguments.study and name not in arguments.study:
            continue
        begin = time.process_time()
        counted = table(run(study, arguments.repetitions))
        seconds = time.process_time() - begin
        text = section(study.title, arguments.repetitions, arguments.points, counted)
        print(f"{text}\n({seconds:.0f} s)\n", flush=True)
        if arguments.table:
            with open(arguments.table, "a", encoding="utf-8") as stream:
                stream.write(f"\n{text}")


if __name__ == "__main__":
    main()
