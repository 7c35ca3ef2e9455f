"""Records of measured drives: how often 95 % intervals hold the truth that made the records.

    python benchmarks/calibrate_speeds.py 200
    python benchmarks/calibrate_speeds.py 200 1 plant

The records are not this program's: the slow twin of the tests integrates each drive, and its
gauges read torque by moments and speeds by the mass of belt that passes (tests/arc/gauges.py). The
drive that the twin integrates differs from the drive file by one standard deviation of everything
that [errors] states; the readings have noise. Each record is written as a calibrate file, read and
calibrated. Kinds of records and drives take turns; with a second number the first seed is that.
Records of a plant have the errors of its log besides: torque at no load, a take-up that rubs, a
belt and a law off their data, a motor speed that torque bends. Their file states none of these.

The share that holds the truth is luck of the draws too: beside each calibration stands a linear
problem with the same draws, whose intervals hold the truth in 95 of 100.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.arc import WrapArc
from wraparc.arrays import Array
from wraparc.calibrate.calibration import Calibration, Problemset, Trace, calibrate
from wraparc.calibrate.file import measured_from_document
from wraparc.calibrate.fit import Fit
from wraparc.calibrate.problem import variable_of
from wraparc.drive import Drive, Tensions
from wraparc.drive.belt import Side
from wraparc.drive.changes import with_pulley
from wraparc.train.file import load_drive

if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it
if TYPE_CHECKING:
    from arc.gauges import Gauges

EXAMPLES = Path(__file__).parents[1] / "examples"
LAYERS: dict[str, Any] = {"pulley_cover": 4e-3, "carry_cover": 8e-3, "carcass": 8.6e-3}
#: Standard deviations as they are stated, shares of the value; of lengths in m.
STATED = {
    "compression": 0.2, "lagging_shear": 0.1, "cover_shear": 0.2,
    "belt_speed": 1e-3, "diameter": 0.4e-3, "pitch_offset": 0.5e-3,
}  # fmt: skip
TENSIONS = {
    "torque": {"exit_tension": 0.02, "effective_tension": 0.03},
    "cells": {"entry_tension": 0.015, "exit_tension": 0.015},
}
#: Of a ratio of speeds averaged over minutes [-], of a creep by chalk marks [m], of an angle and of
#: samples along the arc over the largest of them [-].
READING, CHALK, ANGLE, SAMPLE = 5e-5, 0.1e-3, 0.01, 0.02
POINTS = 45
#: Spread of the truth about the drive file, of the logarithm [-].
FRICTION, MODULUS = 0.1, 0.1
NORMAL_95 = 1.959964  # half of the interval of 95 % of a normal distribution [-]


@dataclass(frozen=True, kw_only=True)
class Kind:
    """A kind of record: what is read, and how tensions and the zero of the speeds are known."""

    title: str
    reads: tuple[str, ...]
    zero: str = ""
    tensions: str = "torque"
    parameters: tuple[str, ...] = ("friction",)


KINDS = (
    Kind(title="behind the drive, zero record", reads=("exit_creep_ratio",), zero="exit"),
    Kind(title="behind the drive, radii as stated", reads=("exit_creep_ratio",)),
    Kind(title="before the drive, zero record", reads=("entry_creep_ratio",), zero="entry"),
    Kind(title="before the drive, radii as stated", reads=("entry_creep_ratio",)),
    Kind(
        title="before and behind, zero record behind, load cells",
        reads=("entry_creep_ratio", "exit_creep_ratio"), zero="exit", tensions="cells",
    ),
    Kind(title="creep by chalk marks", reads=("exit_creep",)),
    Kind(title="creep and shear angle, load cells", reads=("exit_creep", "peak_shear_angle"),
         tensions="cells"),
    Kind(title="courses of creep and shear angle", reads=("courses",),
         parameters=("friction", "belt_modulus")),
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Station:
    """A drive that is measured at two loads, and idling."""

    title: str
    example: str
    cases: tuple[str, str]
    idling: Tensions
    side: Side = "pulley"


STATIONS = (
    Station(title="fabric, driving", example="head-drive-fabric", cases=("design", "empty"),
            idling=Tensions(entry=63e3, exit=60e3)),
    Station(title="fabric, braking", example="downhill-braking", cases=("design", "empty"),
            idling=Tensions(entry=40e3, exit=41e3)),
    Station(title="fabric, carry side of an S-wrap", example="head-drive-fabric", side="carry",
            cases=("design", "empty"), idling=Tensions(entry=63e3, exit=60e3)),
    Station(title="steel cord, driving", example="steel-cord-drive", cases=("design", "start"),
            idling=Tensions(entry=135e3, exit=130e3)),
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Outcome:
    """A calibration, the truth by parameter (factors, and the modulus [N/m]), `Record.linear`."""

    kind: Kind
    station: Station
    found: Calibration
    truth: dict[str, float]
    linear: dict[str, float]

    @property
    def both_hits(self) -> list[tuple[bool, bool]]:
        """Whether each interval holds the truth, and whether that of the linear problem does."""
        return [(e.low <= self.truth[e.name] <= e.high, abs(self.linear[e.name]) < NORMAL_95)
                for e in self.found.estimates if e.low is not None and e.high is not None
                ]  # fmt: skip

    @property
    def hits(self) -> list[bool]:
        """Whether each interval holds the truth."""
        return [hit for hit, _ in self.both_hits]


def layered(name: str, side: Side) -> str:
    """The file of an example with the layers of its belt: 20.6 mm, e = 8.3 mm."""
    text = (EXAMPLES / f"{name}.toml").read_text("utf-8")
    layers = "".join(f'{k} = "{1e3 * v:g} mm"\n' for k, v in LAYERS.items())
    text = text.replace("[belt]\n", f"[belt]\n{layers}", 1)
    return text.replace("[[pulley]]\n", f'[[pulley]]\nside = "{side}"\n', 1)


def described(name: str = "head-drive-fabric", side: Side = "pulley") -> Drive:
    """An example with the layers of its belt, the cover in series with the lagging."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "drive.toml"
        file.write_text(layered(name, side), "utf-8")
        drive = load_drive(file)
    on = drive.pulleys[0]
    lagging = replace(on.lagging, law=replace(on.lagging.law, slip_includes=()))
    return with_pulley(drive, replace(on, lagging=lagging))


class Truth:
    """A drive as it is, off what its file says by what is stated."""

    def __init__(
        self,
        drive: Drive,
        kind: Kind,
        errors: dict[str, float],
        rng: np.random.Generator,
        *,
        plant: bool = False,
    ) -> None:
        def off(sd: float) -> float:
            return float(np.exp(sd * rng.standard_normal()))

        self.drive, self.kind = drive, kind
        self.friction, self.modulus = off(FRICTION), 1.0
        if "belt_modulus" in kind.parameters:
            self.modulus = off(MODULUS)
        self.tensions = {k: off(errors[k]) for k in TENSIONS[kind.tensions]}
        self.soft, self.shear, self.cover, self.wheel = (
            off(errors[k]) for k in ("compression", "lagging_shear", "cover_shear", "belt_speed")
        )
        self.diameter = errors["diameter"] * float(rng.standard_normal())
        self.offset = errors["pitch_offset"] * float(rng.standard_normal())
        self.bias = self.by_torque = 0.0
        self.slip, self.take_up = 1.0, dict.fromkeys(("design", "empty", "start", "zero"), 1.0)
        self.stiff = 1.0
        if plant:
            self.bias = 0.02 * float(rng.standard_normal())
            self.by_torque = 4e-4 * float(rng.standard_normal())
            self.slip = off(0.10)
            self.stiff = 1.0 if "belt_modulus" in kind.parameters else off(0.10)
            rub = max(0.0, 0.03 + 0.02 * float(rng.standard_normal()))  # opposes its last travel
            self.take_up = {k: 1.0 + rub * float(rng.choice([-1.0, 1.0])) for k in self.take_up}

    @property
    def values(self) -> dict[str, float]:
        """What is to be found."""
        return {"friction": self.friction, "belt_modulus": self.modulus * self.drive.belt.modulus}

    def variables(self, names: tuple[str, ...]) -> Array:
        """Return the fitted variables as they truly are, in the order of their names."""
        said = WrapArc.of(self.drive, self.drive.pulleys[0], self.drive.load_cases[0])
        assert said.pitch_offset is not None
        pitch = 0.5 * said.diameter + said.pitch_offset
        values = {
            **self.values, **self.tensions,
            "speed_zero": self.wheel * (1.0 + (0.5 * self.diameter + self.offset) / pitch),
            "compression": self.soft, "lagging_shear": self.shear, "cover_shear": self.cover,
            "torque_offset": 1.0 + self.bias, "speed_by_torque": 1.0 + self.by_torque,
            "modulus": self.stiff, "slip_axis": self.slip,
            **{f"take_up.{name}": value for name, value in self.take_up.items()},
        }  # fmt: skip
        return np.array([variable_of(name, values[name]) for name in names])

    def arc(self, case: str, tensions: Tensions | None = None) -> WrapArc:
        """The arc as it is, at tensions that a load cell and a torque meter report otherwise."""
        said = WrapArc.of(self.drive, self.drive.pulleys[0], self.drive.load_case(case))
        if tensions is not None:
            said = replace(said, entry_tension=tensions.entry, exit_tension=tensions.exit)
        assert said.pitch_offset is not None
        arc = replace(
            said,
            law=said.law.scaled(self.friction, self.slip),
            axial_stiffness=said.axial_stiffness * self.modulus * self.stiff,
            diameter=said.diameter + self.diameter,
            pitch_offset=said.pitch_offset + self.offset,
            compression_modulus=said.compression_modulus / self.soft,
            shear_modulus=said.shear_modulus / self.shear,
            cover_compliance=said.cover_compliance * self.cover,
        )
        return self._loaded(said, arc, "zero" if tensions is not None else case)

    @property
    def rated(self) -> float:
        """The largest effective tension of the drive file [N]."""
        cases = self.drive.load_cases
        arcs = [WrapArc.of(self.drive, self.drive.pulleys[0], case) for case in cases]
        return max(abs(arc.entry_tension - arc.exit_tension) for arc in arcs)

    def _loaded(self, said: WrapArc, arc: WrapArc, record: str) -> WrapArc:
        """The arc with its true tensions; pull by moments, the lagging compressed by T1."""
        leaving = said.exit_tension * self.tensions["exit_tension"]
        if self.kind.tensions == "cells":
            entry = said.entry_tension * self.tensions["entry_tension"]
            return replace(arc, entry_tension=entry, exit_tension=leaving)
        leaving *= self.take_up[record]
        torque = (said.entry_tension - said.exit_tension) * (0.5 * said.diameter + said.offset)
        torque *= self.tensions["effective_tension"]
        torque += self.bias * self.rated * (0.5 * said.diameter + said.offset)
        entry, radius = said.entry_tension, 0.5 * arc.diameter
        for _ in range(20):
            pressure = (entry - arc.centrifugal) / (arc.width * radius)
            pressed = arc.thickness / arc.compression_modulus * pressure
            entry = leaving + torque / (radius - pressed + arc.offset)
        return replace(arc, entry_tension=entry, exit_tension=leaving)


class Record:
    """A calibrate file with what the gauges of the twin read."""

    def __init__(
        self, station: Station, kind: Kind, seed: int, part: float = 1.0, *, plant: bool = False
    ) -> None:
        self.station, self.kind, self.rng = station, kind, np.random.default_rng(seed)
        self.drive = described(station.example, station.side)
        self.errors = {k: part * sd for k, sd in (STATED | TENSIONS[kind.tensions]).items()}
        self.plant = plant
        self.truth = Truth(self.drive, kind, self.errors, self.rng, plant=plant)
        self.traces: list[Trace] = []
        self.noise: list[float] = []  # in residuals: what would be measured less what was

    def _noise(self, count: int = 1, *, sign: float = -1.0) -> Array:
        """Return noise of the next readings [-]; `sign`: of the residual that more of it makes."""
        drawn = self.rng.standard_normal(count)
        self.noise.extend((sign * drawn).tolist())
        return drawn

    def problem(self) -> Problemset:
        """Return what the calibrate file asks."""
        cases = self.station.cases
        numbers = [n for case in cases for n in self._readings(case)]
        document: dict[str, Any] = {
            "format": 1, "drive": "drive.toml", "parameters": list(self.kind.parameters),
            "number": numbers, "errors": self._errors(),
        }  # fmt: skip
        if self.kind.zero:
            document["zero"] = self._zero()
        if self.traces:  # the columns of a record are no part of the file: put in below
            some = {"quantity": "exit_creep", "value": "1 mm", "sd": "1 mm"}
            document["number"] = [some | {"load_case": case} for case in cases]
        with tempfile.TemporaryDirectory() as folder:
            text = layered(self.station.example, self.station.side)
            (Path(folder) / "drive.toml").write_text(text, "utf-8")
            asked = measured_from_document(document, folder=folder).problem
        of_file = () if self.traces else asked.numbers
        return replace(asked, drive=self.drive, numbers=of_file, traces=tuple(self.traces))

    def _errors(self) -> dict[str, str]:
        lengths = ("diameter", "pitch_offset")
        stated = {
            k: f"{1e3 * sd:g} mm" if k in lengths else f"{100.0 * sd:g} %"
            for k, sd in self.errors.items()
        }
        return stated | ({"assumed": "plant"} if self.plant else {})

    def _speeds(self, read: Gauges, quantity: str, arc: WrapArc) -> dict[str, str]:
        """Drum and belt speed as the shaft, the stated diameter and the wheel tell them."""
        speed = read.before if quantity.startswith("entry") else read.behind
        noise = 1.0 + READING * float(self._noise(sign=1.0)[0])  # what is shown is 1 - v/(omega R)
        drum = 0.5 * self.drive.pulleys[0].diameter  # at 1 rad/s
        load = (arc.entry_tension - arc.exit_tension) / self.truth.rated
        belt = speed * self.truth.wheel * noise * (1.0 - self.truth.by_torque * load)
        return {
            "drum_speed": f"{10.0 * drum!r} m/s", "belt_speed": f"{10.0 * belt!r} m/s",
            "sd": f"{100.0 * READING} %",
        }  # fmt: skip

    def _zero(self) -> dict[str, str]:
        from arc.gauges import gauges

        idling, nip = self.station.idling, self.kind.zero
        arc = self.truth.arc(self.station.cases[0], idling)
        return {
            "nip": nip, **self._speeds(gauges(arc), nip, arc),
            "entry_tension": f"{idling.entry} N", "exit_tension": f"{idling.exit} N",
        }  # fmt: skip

    def _readings(self, case: str) -> Iterator[dict[str, str]]:
        from arc.gauges import courses, gauges

        arc = self.truth.arc(case)
        for quantity in self.kind.reads:
            about = {"quantity": quantity, "load_case": case}
            if quantity.endswith("creep_ratio"):
                yield {**about, **self._speeds(gauges(arc), quantity, arc)}
            elif quantity == "exit_creep":
                value = gauges(arc).creep + CHALK * float(self._noise()[0])
                yield {**about, "value": f"{1e3 * value!r} mm", "sd": f"{1e3 * CHALK} mm"}
            elif quantity == "peak_shear_angle":
                peak = float(np.abs(courses(arc, 721).shear_angle).max())
                value = peak * (1.0 + ANGLE * float(self._noise()[0]))
                yield {**about, "value": f"{value!r} rad", "sd": f"{ANGLE * peak!r} rad"}
            else:
                self._sample(arc, case)

    def _sample(self, arc: WrapArc, case: str) -> None:
        """Sensors in the shell, revolutions averaged."""
        from arc.gauges import courses

        read = courses(arc, POINTS)
        for name, values in (("creep", read.creep), ("shear_angle", read.shear_angle)):
            noise = SAMPLE * np.abs(values).max() * self._noise(POINTS)
            self.traces.append(
                Trace(quantity=name, position=read.position, value=values + noise, sd=None,
                      load_case=case)
            )  # fmt: skip

    def draws(self, problem: Problemset) -> Array:
        """Return what was drawn as residuals of readings and variables [-], 0 of parameters."""
        x = self.truth.variables(problem.variables)
        stated = [problem.errors.get(name, np.inf) for name in problem.variables]
        return np.concatenate([self.noise, x / np.array(stated)])

    def linear(self, problem: Problemset) -> dict[str, float]:
        """Return by how many standard deviations a linear problem with these draws would miss.

        With J the derivatives of the residuals at the truth and d the draws, its estimate is off by
        -(J^T J)^-1 J^T d, of the covariance (J^T J)^-1: no prediction of the fit enters.
        """
        fit, x = Fit(problem), self.truth.variables(problem.variables)
        residuals = partial(readings, fit), fit.prior_residuals
        j = np.concatenate([fit.jacobian(of, x) for of in residuals])
        covariance = np.linalg.inv(j.T @ j)
        off = -(covariance @ j.T @ self.draws(problem)) / np.sqrt(np.diag(covariance))
        return dict(zip(problem.variables, off.tolist(), strict=True))


def readings(fit: Fit, x: Array) -> Array:
    """Return misfits of the readings over their standard deviations; courses start at 0.01 [-]."""
    return fit.data_residuals(x, [SAMPLE / 0.01] * len(fit.problem.traces))


def simulated(
    count: int,
    *,
    first: int = 1,
    kinds: tuple[Kind, ...] = KINDS,
    part: float = 1.0,
    plant: bool = False,
) -> Iterator[Outcome]:
    """Calibrate to records of the twin, kinds and drives in turns, with a part of each error."""
    for seed in range(first, first + count):
        kind, station = kinds[seed % len(kinds)], STATIONS[seed // len(kinds) % len(STATIONS)]
        record = Record(station, kind, seed, part, plant=plant)
        problem = record.problem()
        yield Outcome(kind, station, calibrate(problem), record.truth.values,
                      record.linear(problem))  # fmt: skip


def row(title: str, outcomes: list[Outcome]) -> str:
    """Return a line of the table: how many tell, how many hold the truth, how wide they are."""
    hits = [hit for o in outcomes for hit in o.hits]
    told = [e for o in outcomes for e in o.found.estimates]
    widths = [0.5 * (e.high - e.low) / e.value for e in told
              if e.low is not None and e.high is not None and e.value]  # fmt: skip
    share = f"{100.0 * np.mean(hits):.1f} %" if hits else "-"
    half = f"{100.0 * np.median(widths):.1f} %" if widths else "-"
    linear = sum(hit for o in outcomes for _, hit in o.both_hits)
    hold = f"{sum(hits)} ({share})"
    cells = (title, len(outcomes), f"{len(hits)} of {len(told)}", hold, linear, half)
    return f"| {' | '.join(map(str, cells))} |"


def without_luck(outcomes: list[Outcome]) -> tuple[float, float]:
    """Return the share that holds the truth and its standard error, by a control variate.

    The linear problem holds it in 0.95 of all draws; what differs on the same draws is ours.
    """
    less = np.array([float(hit) - float(linear) for o in outcomes for hit, linear in o.both_hits])
    return 0.95 + float(less.mean()), float(less.std(ddof=1) / np.sqrt(len(less)))


def main(count: int, first: int, *, plant: bool) -> None:
    """Print how many intervals hold the truth, by kind of record, by drive and in all."""
    outcomes = []
    for done, outcome in enumerate(simulated(count, first=first, plant=plant), start=1):
        outcomes.append(outcome)
        if done % 25 == 0:
            print(row(f"after {done}", outcomes), file=sys.stderr, flush=True)
    print("| records | calibrations | told | hold the truth | linear | half an interval |")
    print("|---|---|---|---|---|---|")
    for kind in KINDS:
        print(row(kind.title, [o for o in outcomes if o.kind is kind]))
    for station in STATIONS:
        print(row(station.title, [o for o in outcomes if o.station is station]))
    print(row("all", outcomes))
    share, error = without_luck(outcomes)
    print(f"\nLuck of the draws taken out: {100.0 * share:.1f} +- {100.0 * error:.1f} %")


if __name__ == "__main__":
    given = sys.argv[1:]
    numbers = [int(text) for text in given if text != "plant"]
    main(*(numbers + [200, 1][len(numbers) :]), plant="plant" in given)
