"""Is a sound laboratory told OK and a faulty one not, and do 95 % intervals hold the truth?

    python benchmarks/shear_test_verdicts.py --laboratories 200 --coverage 400 \\
        --table benchmarks/results/shear_test_verdicts.md

Virtual laboratories of known laws, 1 % noise, samples that scatter by 2 % in friction and 3 % in
slip, 250 readings a test. Each kind of fault is put into one test (or one pressure) of a sound
laboratory: **false OK** is the share of faulty laboratories that are told OK, **false ATTENTION**
that of sound ones that are not. Then, laboratory by laboratory, the 95 % intervals of the law's
peak friction and peak slip at the tested pressures are held against the truth, with errors of the
rig drawn within the limits of a plan that states no budget, and with white noise,
noise of memory (0.9 from reading to reading), zeros of the force that are off and not to be seen
in the record, few pressures and no repeats.

**Left out** are laboratories of a rubber that no law here follows exactly (`odd_rubber`): six
pressures, two of them alike, and noise of memory. Each pressure left out in turn is predicted by
the law of the others, and by plain least squares of the same form through the peaks of the single
curves; and the scatter between samples is held against the one that was drawn.
The gate runs a few of each (tests/shear_test/test_judgement.py).
"""

import argparse
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from wraparc.answer.shear_test_tables import verdict
from wraparc.checks import Level
from wraparc.files import load_lagging
from wraparc.friction import IntegralLog, PressureKnots
from wraparc.shear_test import (
    MachineRecord,
    PlannedTest,
    PlanResult,
    Rig,
    TestPlan,
    VirtualRig,
    fit_plan,
    run_virtual_test,
)
from wraparc.shear_test.budget import Uncertainty
from wraparc.shear_test.joint_fit import curve_points
from wraparc.shear_test.left_out import left_out_pressures

THICKNESS, SHEAR_MODULUS = 12e-3, 2.3e6
ALL = np.array([34, 69, 103, 138, 207, 276, 414, 690]) * 1e3
NINE = np.array([34, 69, 103, 138, 207, 276, 414, 550, 690]) * 1e3
DESIGNS: dict[str, tuple[Any, int]] = {
    "3 x 2": (ALL[[0, 3, 6]], 2),
    "4 x 2": (ALL[[0, 2, 4, 6]], 2),
    "8 x 2": (ALL, 2),
    "9 x 1": (NINE, 1),
}
SCATTER = {"scatter_friction": 0.02, "scatter_slip": 0.03}


def smooth() -> IntegralLog:
    """Powers of pressure."""
    p = np.round(np.geomspace(34e3, 690e3, 60), 3)
    return _law(p, 1.25 * (p / p[0]) ** -0.3, 0.010 * (p / p[0]) ** 0.15)


def two_pieces() -> IntegralLog:
    """Two straight pieces that meet at 172 kPa."""
    ends = [34e3, 172e3, 690e3]
    p = np.unique(np.concatenate([np.linspace(34e3, 690e3, 400), ends]))
    return _law(
        p, np.interp(p, ends, [1.30, 0.86, 0.385]), np.interp(p, ends, [0.016, 0.0205, 0.026])
    )


def catalogue() -> IntegralLog:
    """Monotone cubics that no form follows exactly."""
    law = load_lagging("diamond-rubber").law
    assert isinstance(law, IntegralLog)
    return law


LAWS: dict[str, Callable[[], IntegralLog]] = {
    "smooth": smooth, "two pieces": two_pieces, "catalogue": catalogue
}  # fmt: skip


def _law(pressure: Any, friction: Any, slip: Any) -> IntegralLog:
    knots = PressureKnots(
        pressure=tuple(pressure.tolist()),
        peak_friction=tuple(friction.tolist()),
        peak_slip=tuple(slip.tolist()),
    )
    return IntegralLog(coefficients=knots)


@dataclass
class Laboratory:
    """A plan and its records, by file."""

    plan: TestPlan
    records: dict[str, MachineRecord]

    def scale(self, names: Iterable[str], pull: float = 1.0, load: float = 1.0) -> None:
        """Change the pull of tests, and their normal force and planned pressure."""
        for name in names:
            record = self.records[name]
            assert record.normal_force is not None
            self.records[name] = replace(
                record, force=pull * record.force, normal_force=load * record.normal_force
            )
        tests = [
            replace(t, pressure=load * (t.pressure or 0.0)) if t.file in names else t
            for t in self.plan.tests
        ]
        self.plan = replace(self.plan, tests=tuple(tests))

    def fit(self) -> PlanResult:
        return fit_plan(self.plan, read=lambda test: self.records[test.file])


def laboratory(law: IntegralLog, design: str, seed: int, **rig: Any) -> Laboratory:
    """Test ``pXrY`` is repeat Y at the X-th pressure, both from 0."""
    pressures, repeats = DESIGNS[design]
    options: dict[str, Any] = {"points": 250} | SCATTER | rig
    zero, own = options.pop("zero", 0.0), np.random.default_rng(10**6 + seed)
    # Errors of the rig, the same in all its tests: those that a plan without a budget is given.
    pull, load, way, area, bend = own.uniform(-1.0, 1.0, 5) * options.pop("rig_errors", 0.0)
    options["compliance"] = abs(bend) * 0.05e-6
    of = VirtualRig(law=law, shear_compliance=THICKNESS / SHEAR_MODULUS, **options)
    # Of the zero: a share of the largest force.
    off = float(own.normal(0.0, zero)) if zero else 0.0
    tests: list[PlannedTest] = []
    records: dict[str, MachineRecord] = {}
    for k, pressure in enumerate(pressures):
        for r in range(repeats):
            name = f"p{k}r{r}"
            drawn = run_virtual_test(of, float(pressure), seed * 1000 + 10 * k + r)
            force = (drawn.force + off * float(drawn.force.max())) * (1.0 + 0.01 * pull)
            records[name] = MachineRecord(
                file=name, place="", encoding="", delimiter="", decimal=".", columns=(),
                travel=drawn.travel * (1.0 + 0.01 * way), force=force,
                normal_force=drawn.normal_force * (1.0 + 0.01 * load),
                time=drawn.time, lines=np.arange(1, len(force) + 1), rows=len(force),
                dropped=(), notes=(), header=(), digest=name,
            )  # fmt: skip
            place = f"test[{len(tests) + 1}]"
            order = _order(k, r, len(pressures), repeats)
            test = PlannedTest(file=name, place=place, pressure=float(pressure), order=order)
            tests.append(test)
    plan = TestPlan(
        name="virtual",
        surface="rubber",
        rig=Rig(area=of.area * (1.0 + 0.01 * area)),
        tests=tuple(tests),
        thickness=THICKNESS,
        shear_modulus=SHEAR_MODULUS,
        uncertainty=Uncertainty(),
    )
    return Laboratory(plan, records)


def _order(level: int, repeat: int, levels: int, repeats: int) -> int:
    """Pressures upwards and the repeats downwards; without repeats every second one, and back."""
    if repeats == 1:
        return 1 + (level // 2 if level % 2 == 0 else levels - 1 - level // 2)
    return 1 + repeat * levels + (level if repeat % 2 == 0 else levels - 1 - level)


def _half_friction(lab: Laboratory, seed: int) -> None:
    lab.scale([_any(lab, seed)], pull=0.5)


def _thousandth(lab: Laboratory, seed: int) -> None:
    lab.scale([_any(lab, seed)], pull=1e-3)


def _typed_pressure(lab: Laboratory, seed: int) -> None:
    """A tenth of the pressure, or ten times as much, was typed for one test."""
    lab.scale([_any(lab, seed)], load=0.1 if seed % 2 else 10.0)


def _pounds(lab: Laboratory, seed: int) -> None:
    lab.scale([_any(lab, seed)], pull=1 / 4.448222 if seed % 2 else 4.448222)


def _speeds(lab: Laboratory, seed: int) -> None:
    """Every second test was pulled 50 times as fast, with 12 % more friction."""
    names = [test.file for test in lab.plan.tests][1::2]
    lab.scale(names, pull=1.12)
    for name in names:
        record = lab.records[name]
        assert record.time is not None
        lab.records[name] = replace(record, time=record.time / 50.0)


def _standing_force(lab: Laboratory, seed: int) -> None:
    """Half of the largest force stands before the slip starts."""
    name = _any(lab, seed)
    record = lab.records[name]
    lab.records[name] = replace(record, force=record.force + float(record.force.max()))


def _waves(lab: Laboratory, seed: int) -> None:
    """Every curve leaves its law by waves of 6 % of its friction."""
    for name, record in lab.records.items():
        wave = 1.0 + 0.06 * np.sin(record.travel / record.travel[-1] * 15.0 + seed)
        lab.records[name] = replace(record, force=record.force * wave)


def _edit(lab: Laboratory, name: str, rows: Any) -> None:
    """Take rows of a record, in the order given."""
    record = lab.records[name]
    assert record.time is not None
    assert record.normal_force is not None
    lab.records[name] = replace(
        record, travel=record.travel[rows], force=record.force[rows], time=record.time[rows],
        normal_force=record.normal_force[rows], lines=np.arange(1, len(rows) + 1), rows=len(rows),
    )  # fmt: skip


def _clipped(lab: Laboratory, seed: int) -> None:
    """The load cell of one test ends at 85 % of the largest force."""
    name = _any(lab, seed)
    record = lab.records[name]
    end = 0.85 * float(np.quantile(record.force, 0.98))
    lab.records[name] = replace(record, force=np.minimum(record.force, end))


def _travel_ends(lab: Laboratory, seed: int) -> None:
    """The travel of one test ends at 60 % of it, the pull goes on."""
    name = _any(lab, seed)
    record = lab.records[name]
    travel = np.minimum(record.travel, 0.6 * float(record.travel.max()))
    lab.records[name] = replace(record, travel=travel)


def _rows_lost(lab: Laboratory, seed: int) -> None:
    """A tenth of the readings of one test was not written, somewhere in the middle."""
    name = _any(lab, seed)
    count = len(lab.records[name].force)
    first = count // 5 + seed * 37 % (count // 2)
    _edit(lab, name, np.r_[0:first, first + count // 10 : count])


def _rows_twice(lab: Laboratory, seed: int) -> None:
    """A tenth of the readings of one test was written twice."""
    name = _any(lab, seed)
    count = len(lab.records[name].force)
    first = count // 5 + seed * 37 % (count // 2)
    _edit(lab, name, np.r_[0 : first + count // 10, first:count])


def _wears(lab: Laboratory) -> None:
    """Friction of each test is 5 % below that of the test before it."""
    for test in lab.plan.tests:
        record = lab.records[test.file]
        factor = 0.95 ** ((test.order or 1) - 1)
        lab.records[test.file] = replace(record, force=factor * record.force)


def _wears_in_order(lab: Laboratory, seed: int) -> None:
    """The same, the pressures one after the other."""
    tests = [replace(test, order=k) for k, test in enumerate(lab.plan.tests, start=1)]
    lab.plan = replace(lab.plan, tests=tuple(tests))
    _wears(lab)


def _wears_in_mixed_order(lab: Laboratory, seed: int) -> None:
    _wears(lab)


def _stick_slip(lab: Laboratory, seed: int) -> None:
    """Every curve is a sawtooth of 10 % of its friction, of 1 mm and a quarter more or less."""
    rng = np.random.default_rng(seed)
    for name, record in lab.records.items():
        ends = np.cumsum(1e-3 * rng.uniform(0.75, 1.25, 200))
        k = np.searchsorted(ends, record.travel)
        way = ends[k] - record.travel
        tooth = 0.5 - way / np.diff(ends, prepend=0.0)[k]
        lab.records[name] = replace(record, force=record.force * (1.0 + 0.1 * tooth))


def _one_face_for_two(lab: Laboratory, seed: int) -> None:
    """The plan says 1 face, two slid."""
    lab.plan = replace(lab.plan, rig=replace(lab.plan.rig, faces=1))


def _any(lab: Laboratory, seed: int) -> str:
    return lab.plan.tests[seed % len(lab.plan.tests)].file


FAULTS: dict[str, Callable[[Laboratory, int], None]] = {
    "one test at half its friction": _half_friction,
    "one test at a thousandth of its pull": _thousandth,
    "one pressure typed 10 times off": _typed_pressure,
    "one pull in another unit (4.448)": _pounds,
    "two speeds, 12 % apart": _speeds,
    "half of the force stands before the slip": _standing_force,
    "waves of 6 % in every curve": _waves,
    "one load cell at its end": _clipped,
    "one travel sensor at its end": _travel_ends,
    "a tenth of the readings of one test lost": _rows_lost,
    "a tenth of the readings of one test written twice": _rows_twice,
    "5 % less friction a test, pressures upwards": _wears_in_order,
    "5 % less friction a test, mixed order": _wears_in_mixed_order,
    "stick-slip of 10 % in every curve": _stick_slip,
    "1 face in the plan, 2 slid": _one_face_for_two,
}

COVERAGE: dict[str, tuple[str, dict[str, Any]]] = {
    "white noise (4 x 2)": ("4 x 2", {}),
    "correlated noise, AR 0.9 (4 x 2)": ("4 x 2", {"correlation": 9.49}),
    "zero off by 2 %, not in the record (4 x 2)": ("4 x 2", {"zero": 0.02, "lash": 0.0}),
    "few pressures (3 x 2)": ("3 x 2", {}),
    "no repeats (9 x 1)": ("9 x 1", {}),
}

ODD_LOADS = (545.0, 1105.0, 1653.0, 2194.0, 2711.0, 2722.0)
ODD_AREA = 0.02


def odd_rubber(seed: int, scatter: float = 0.0) -> Laboratory:
    """A rubber whose curves are saturating tangents, mu = D sin(C atan(B x - E (B x - atan B x))).

    Parameters
    ----------
    seed
        Of its noise.
    scatter
        Standard deviation of ln mu between samples.
    """
    rng = np.random.default_rng(seed)
    tests: list[PlannedTest] = []
    records: dict[str, MachineRecord] = {}
    rows = 315
    for k, load in enumerate(ODD_LOADS):
        travel = np.cumsum(np.abs(rng.normal(0.034, 0.012, rows)))  # [mm]
        pressure = load / ODD_AREA
        top, slope = 1.49 * (pressure / 27e3) ** -0.195, 1.9 / (3.1 * (pressure / 80e3) ** 0.11)
        bent = slope * travel
        friction = top * np.sin(1.42 * np.arctan(0.9 * bent + 0.1 * np.arctan(bent)))
        noise = np.zeros(rows)
        for i, step in enumerate(rng.normal(0.0, 0.003, rows - 1), start=1):
            noise[i] = 0.9 * noise[i - 1] + step
        count = np.arange(rows)
        wave = 1.0 + 0.03 * np.exp(-count / 60) * np.sin(count / 9) + rng.normal(0, 0.004, rows)
        friction = friction * np.exp(scatter * rng.normal()) + noise + 0.03 * np.exp(-travel / 0.3)
        name = f"p{k}r0"
        records[name] = MachineRecord(
            file=name, place="", encoding="", delimiter="", decimal=".", columns=(),
            travel=1e-3 * travel, force=friction * load * wave, normal_force=load * wave,
            time=np.asarray(0.01 * count, dtype=np.float64), lines=count + 1, rows=rows,
            dropped=(), notes=(), header=(), digest=name,
        )  # fmt: skip
        tests.append(PlannedTest(file=name, place=f"test[{k + 1}]", normal_force=load))
    plan = TestPlan(name="odd rubber", rig=Rig(area=ODD_AREA, faces=1), tests=tuple(tests))
    return Laboratory(plan, records)


def left_out_errors(seed: int) -> tuple[float, float, float]:
    """Mean error at the inner pressures of an odd rubber, each left out; shares of their peaks.

    Returns
    -------
    law, plain
        By the law of the others, and by plain least squares of its form [-].
    scatter
        Standard deviation of ln mu between samples that is claimed, where there is none [-].
    """
    found = odd_rubber(seed).fit().conditions[0].found
    assert found.fit is not None
    points = curve_points(
        [t.curve for t in found.tests], [t.fit for t in found.tests], found.levels
    )
    points = replace(points, covariance=np.tile(1e-4 * np.eye(2), (len(points.level), 1, 1)))
    nothing = replace(found.fit, scatter=1e-8 * np.eye(2), weights=np.ones(len(points.level)))
    plain = left_out_pressures(nothing, points, found.tests, found.levels, found.tails)
    errors = [
        float(np.mean([item.error / item.peak_friction for item in items if item.inside]))
        for items in (found.left_out, plain)
    ]
    assert found.scatter is not None
    return errors[0], errors[1], found.scatter.value


def told_scatter(seed: int, scatter: float) -> tuple[float, bool]:
    """Scatter between samples that is told of an odd rubber, over the one that was drawn.

    And whether its interval holds that.
    """
    found = odd_rubber(seed, scatter).fit().conditions[0].found
    assert found.scatter is not None
    low, high = found.scatter.ends
    return found.scatter.value / scatter, low < scatter < high


PARTS = ("left out", "sound", "faulty", "coverage")


def sound(law: str, design: str, count: int) -> tuple[int, int]:
    """Sound laboratories told ATTENTION, and those told of a transition."""
    accused = bent = 0
    for seed in range(1, count + 1):
        found = laboratory(LAWS[law](), design, seed).fit()
        accused += verdict(found).level is not Level.OK
        bent += found.conditions[0].found.transition is not None
    return accused, bent


def faulty(fault: str, design: str, count: int) -> int:
    """Faulty laboratories that are told OK; what speed does may be told and taken off instead."""
    missed = 0
    for seed in range(1, count + 1):
        law = list(LAWS.values())[seed % len(LAWS)]()
        lab = laboratory(law, design, seed)
        FAULTS[fault](lab, seed)
        found = lab.fit()
        told = found.conditions[0].found.separated.by_slip_speed is not None
        missed += not told and verdict(found).level is Level.OK
    return missed


def coverage(design: str, law: str, count: int, **rig: Any) -> tuple[float, float]:
    """Shares of the intervals of peak friction and peak slip that hold the truth."""
    truth = LAWS[law]()
    held: list[Any] = []
    held_slip: list[Any] = []
    for seed in range(1, count + 1):
        condition = laboratory(truth, design, seed, rig_errors=1.0, **rig).fit().conditions[0]
        at = condition.found.level_pressures()
        slip, friction, error = condition.peaks_at(at)
        true_slip, true_friction, _, _ = truth.parameters(np.array(DESIGNS[design][0]))
        held.append(np.abs(np.log(friction / true_friction)) < error[:, 1])
        held_slip.append(np.abs(np.log(slip / true_slip)) < error[:, 0])
    return float(np.mean(held)), float(np.mean(held_slip))


def _rows(arguments: argparse.Namespace) -> Iterable[str]:
    count = arguments.laboratories
    tables = {
        "left out": (_left_out_rows, count),
        "sound": (_sound_rows, count),
        "faulty": (_faulty_rows, count),
        "coverage": (_coverage_rows, arguments.coverage),
    }
    for part in arguments.part:
        rows, of = tables[part]
        if of:
            yield from rows(of)


def _left_out_rows(count: int) -> Iterable[str]:
    law, plain, scatter = np.array([left_out_errors(k) for k in range(1, count + 1)]).T
    drawn, held = np.array([told_scatter(k, 0.03) for k in range(1, count + 1)]).T
    within = int(np.sum((drawn > 0.5) & (drawn < 2.0)))
    yield f"### Pressures left out, {count} laboratories of the odd rubber\n"
    yield "| | mean | worst |\n|---|---|---|"
    yield f"| error of the law, of the peak | {_both(law)} |"
    yield f"| error of plain least squares | {_both(plain)} |"
    yield f"| law over plain | {np.mean(law / plain):.2f} | {np.max(law / plain):.2f} |"
    yield f"| scatter told where there is none | {_both(scatter)} |"
    yield f"\nScatter of 3 % told within a factor of two: {_share(within, count)}; root mean square"
    yield f"{3.0 * np.sqrt(np.mean(drawn**2)):.2f} %. Its interval holds it: "
    yield f"{_share(int(held.sum()), count)}."


def _sound_rows(count: int) -> Iterable[str]:
    yield f"\n### Sound laboratories, {count} of each kind\n"
    yield "| law | pressures x repeats | false ATTENTION | told of a transition |"
    yield "|---|---|---|---|"
    for law in LAWS:
        for design in DESIGNS:
            accused, bent = sound(law, design, count)
            yield f"| {law} | {design} | {_share(accused, count)} | {_share(bent, count)} |"


def _faulty_rows(count: int) -> Iterable[str]:
    yield f"\n### Faulty laboratories, {count} of each kind\n"
    yield "| fault | pressures x repeats | false OK |\n|---|---|---|"
    for fault in FAULTS:
        for design in DESIGNS:
            yield f"| {fault} | {design} | {_share(faulty(fault, design, count), count)} |"


def _coverage_rows(count: int) -> Iterable[str]:
    yield f"\n### Intervals of the law, {count} laboratories of each kind\n"
    yield "| laboratory | law | peak friction held | peak slip held |\n|---|---|---|---|"
    for title, (design, rig) in COVERAGE.items():
        for law in ("smooth", "catalogue"):
            friction, slip = coverage(design, law, count, **rig)
            yield f"| {title} | {law} | {100 * friction:.1f} % | {100 * slip:.1f} % |"


def _both(values: Any) -> str:
    return f"{100 * values.mean():.2f} % | {100 * values.max():.2f} %"


def _share(part: int, count: int) -> str:
    return f"{part} ({100 * part / count:.1f} %)"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0] if __doc__ else None)
    parser.add_argument("--laboratories", type=int, default=200, help="of each kind")
    parser.add_argument("--coverage", type=int, default=400, help="laboratories of each kind")
    parser.add_argument("--part", nargs="+", choices=PARTS, default=PARTS)
    parser.add_argument("--table", default=None, help="append the tables to this file")
    arguments = parser.parse_args()
    begin = time.process_time()
    for row in _rows(arguments):
        print(row, flush=True)
        if arguments.table:
            with open(arguments.table, "a", encoding="utf-8") as stream:
                stream.write(f"{row}\n")
    print(f"\n({time.process_time() - begin:.0f} s)")


if __name__ == "__main__":
    main()
