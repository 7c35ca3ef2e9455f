"""Random drive files: what a drive may say, drawn so that a third slips and a third misses a limit.

Documents, as a file has them: names and quantities as texts. Each number has a seed of its own.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from wraparc import catalogue

Data = dict[str, Any]
CONDITIONS: tuple[Any, ...] = (
    "wet", "wet and dirty", {"name": "dusty", "friction_factor": 0.8}, ["dry", "wet"],
)  # fmt: skip


class Draw:
    """What is drawn, by one generator."""

    def __init__(self, seed: int, number: int) -> None:
        self.rng = np.random.default_rng([seed, number])
        #: what the drive is to be: easily carried, near to its limits, or pulled until it slips
        self.strain = self.one_of("calm", "near", "slips")

    def chance(self, share: float) -> bool:
        return bool(self.rng.random() < share)

    def between(self, low: float, high: float) -> float:
        return float(self.rng.uniform(low, high))

    def log_between(self, low: float, high: float) -> float:
        return math.exp(self.between(math.log(low), math.log(high)))

    def one_of(self, *choices: Any) -> Any:
        return choices[int(self.rng.integers(len(choices)))]

    def at_strain(self, calm: Any, near: Any, slips: Any) -> Any:
        """Return what goes with what the drive is to be."""
        return {"calm": calm, "near": near, "slips": slips}[self.strain]

    def some(self, share: float, **of: Any) -> Data:
        """Return some of the keys of a table."""
        return {key: value for key, value in of.items() if self.chance(share)}

    def quantity(self, low: float, high: float, unit: str) -> str:
        return f"{self.log_between(low, high):.5g} {unit}"


def document(seed: int, number: int) -> Data:
    """Return a drive file: of one pulley, of two that each say their tensions, or a train."""
    draw = Draw(seed, number)
    kind = draw.one_of("drive", "drive", "drive", "drive", "pair", "train", "train", "train")
    names = ["head"] if kind == "drive" else ["first", "second", "tail"][: 2 + draw.chance(0.2)]
    names = names[:2] if kind == "pair" else names
    laggings = {f"lagging {i}": own_lagging(draw) for i in range(draw.one_of(0, 0, 1, 1, 2))}
    width = draw.between(0.6, 2.0)
    pulleys = [pulley(draw, name, laggings) for name in names]
    tight, slack = tensions(draw, pulleys, width)
    of_belt = belt(draw, width, tight)
    made: Data = {
        "format": 1,
        "title": f"Drive {seed}-{number}",
        "belt": of_belt,
        "pulley": pulleys,
    }
    if "carcass" in of_belt and draw.chance(0.3):
        pulleys[-1]["side"] = "carry"
    if kind == "train":
        speed = float(of_belt.get("speed", "3 m/s").split()[0])
        made |= train(draw, (tight, slack), speed, pulleys)
    else:
        spread_tensions(draw, pulleys, tight, slack)
        made |= {"load_case": load_cases(draw, names[0], tight, slack)} if draw.chance(0.4) else {}
    made |= {"lagging": laggings} if laggings else {}
    return made | criteria(draw, names) | motion(draw, kind, names)


def belt(draw: Draw, width: float, tight: float) -> Data:
    """Return a belt: of the catalogue, or one's own, about as strong as it is pulled."""
    pull = tight / width
    made: Data = {"width": f"{width:.4g} m"} | draw.some(0.9, speed=draw.quantity(0.5, 7.0, "m/s"))
    if draw.chance(0.4):
        wanted = pull * draw.between(*draw.at_strain((1.5, 3.0), (0.8, 2.0), (1.0, 3.0)))
        near = sorted(catalogue.belts(), key=lambda b: abs(math.log((b.rating or 1.0) / wanted)))
        made["preset"] = draw.one_of(*near[:4]).name
    else:
        kind = draw.one_of("fabric", "steel cord", "aramid")
        stiff = {"fabric": 60.0, "steel cord": 400.0, "aramid": 200.0}[kind]
        made |= draw.some(0.8, kind=kind) | draw.some(0.5, name="own belt")
        made["modulus"] = f"{pull * stiff * draw.between(0.8, 2.5):.5g} N/m"
        made |= draw.some(
            0.6, rating=f"{pull * draw.between(draw.at_strain(1.2, 0.8, 1.1), 2.5):.5g} N/m"
        )
        made |= draw.some(
            0.2, strength=f"{pull * draw.between(draw.at_strain(9.0, 4.0, 7.0), 15.0):.5g} N/m"
        )
    covers = {"pulley_cover": draw.quantity(2, 8, "mm"), "carry_cover": draw.quantity(3, 15, "mm")}
    covers["carcass"] = draw.quantity(4, 12, "mm")
    made |= covers if draw.chance(0.35) else {}
    return made | draw.some(
        draw.at_strain(0.1, 0.25, 0.2),
        mass=f"{width * draw.between(10, 40):.4g} kg/m",
        momentary_factor=draw.between(1.0, 1.5),
        least_pulley_diameter=draw.quantity(0.3, 0.9, "m"),
        largest_wrap_pressure=draw.quantity(0.15, 1.5, "MPa"),
    )


def pulley(draw: Draw, name: str, laggings: Data) -> Data:
    """Return a pulley without tensions."""
    return {
        "name": name,
        "diameter": draw.quantity(0.6, 1.6, "m"),
        "wrap_angle": f"{draw.between(150, 240):.5g} deg",
        "lagging": lagging(draw, laggings),
        **draw.some(draw.at_strain(0.05, 0.2, 0.2), condition=draw.one_of("dry", "wet")),
        **draw.some(0.15, overrun=draw.one_of("0 mm", "formula", "0.02 mm")),
        **draw.some(0.15, recovery=False),
        **draw.some(0.2, creep_limit=draw.quantity(1.5, 15, "mm")),
        **draw.some(0.1, mass="2000 kg"),
    }


def lagging(draw: Draw, own: Data) -> Any:
    """Return a lagging: of the catalogue, that with numbers of its own, or of this file."""
    if own and draw.chance(0.6):
        return draw.one_of(*own)
    name = draw.one_of(*catalogue.lagging_names())
    if draw.chance(0.6):
        return name
    return {
        "preset": name,
        **draw.some(
            0.5,
            thickness=draw.quantity(4, 25, "mm"),
            shear_modulus=draw.quantity(0.8, 5.0, "MPa"),
            compression_modulus=draw.one_of("rigid", draw.quantity(4.0, 40.0, "MPa")),
        ),
    }


def own_lagging(draw: Draw) -> Data:
    """Return a lagging with a law of any kind, of as many knots, pieces or rows as it likes."""
    laws = (knots, pieces, constant, elastic_plastic, power, table)
    law = draw.one_of(*laws)(draw)
    made: Data = {"thickness": draw.quantity(5, 25, "mm"), "law": law}
    if draw.chance(0.6):
        made |= {"shear_modulus": draw.quantity(0.8, 4.0, "MPa")}
        made |= {"compression_modulus": draw.quantity(4.0, 40.0, "MPa")}
    else:
        block = {"width": draw.quantity(10, 60, "mm")} | draw.some(
            0.5,
            height=draw.quantity(3, 5, "mm"),
            contact_fraction=draw.between(0.4, 1.0),
            shape=draw.one_of("square", "strip"),
        )
        made |= {"elastic_modulus": draw.quantity(2.0, 9.0, "MPa"), "block": block}
    origin = {"kind": "measured", "source": "drawn"}
    made["condition_factor"] = [
        {"condition": name, "factor": round(draw.between(0.5, 0.95), 3), "provenance": origin}
        for name in ("wet", "wet and dirty")
    ]
    return made | draw.some(
        0.3,
        surface=draw.one_of("rubber", "ceramic", "polyurethane"),
        bond_strength=draw.quantity(0.03, 2.0, "MPa"),
        fatigue_limit=draw.quantity(0.03, 1.0, "MPa"),
    )


def range_of_tests(draw: Draw, *, pressures: bool) -> Data:
    """Return the range of the tests, which a law need not have."""
    if not draw.chance(0.7):
        return {}
    ends = [draw.quantity(20, 80, "kPa"), draw.quantity(300, 1500, "kPa")]
    more: Data = {"tested_pressure": ends} if pressures else {}
    more["tested_slip"] = draw.quantity(3, 25, "mm")
    return more | draw.some(0.2, tested_slip_speed=draw.quantity(0.5, 50, "mm/s"))


def knots(draw: Draw) -> Data:
    """Return an integral-log law of two to seven knots, a third of them falling past the peak."""
    count = draw.one_of(2, 3, 4, 5, 7)
    pressures = np.geomspace(draw.between(20, 60), draw.between(400, 1500), count)
    peak, slip, falls = draw.between(0.3, 0.9), draw.between(1.0, 15.0), draw.chance(0.3)
    rows = []
    for pressure in pressures:
        peak *= draw.between(0.85, 1.0)
        slip *= draw.between(0.9, 1.15)
        row: Data = {"pressure": f"{pressure:.5g} kPa", "peak_friction": round(peak, 4)}
        row["peak_slip"] = f"{slip:.4g} mm"
        if falls:
            row |= {"post_peak_slope": f"-{0.2 * peak / slip:.3g} 1/mm"}
            row |= {"residual_friction": round(0.6 * peak, 4)}
        rows.append(row)
    return {"kind": "integral-log", "knots": rows, **range_of_tests(draw, pressures=False)}


def pieces(draw: Draw) -> Data:
    """Return an integral-log law of one or two pieces of equations."""
    a, b = draw.between(0.08, 0.3), draw.between(0.05, 0.2)
    middle, top = round(draw.between(150, 250)), draw.quantity(600, 1500, "kPa")
    rows = [
        {"from": "30 kPa", "to": f"{middle} kPa", "A": f"-{a:.4g} + 0.0001 p", "b": f"-{b:.4g}"}
    ]
    if draw.chance(0.5):
        level = f"{-float(f'{a:.4g}') + 1e-4 * middle:.6g}"
        rows += [{"from": f"{middle} kPa", "to": top, "A": level, "b": f"-{b:.4g}"}]
    units = {"slip_unit": "mm", "pressure_unit": "kPa"}
    return {
        "kind": "integral-log",
        **units,
        "pieces": rows,
        **range_of_tests(draw, pressures=False),
    }


def constant(draw: Draw) -> Data:
    return {
        "kind": "constant",
        "friction": draw.between(0.2, 0.8),
        **range_of_tests(draw, pressures=True),
    }


def elastic_plastic(draw: Draw) -> Data:
    stiffness = draw.quantity(20, 300, "kPa/mm")
    law = {"friction": draw.between(0.3, 0.8), "stiffness": stiffness}
    return {"kind": "elastic-plastic", **law, **range_of_tests(draw, pressures=True)}


def power(draw: Draw) -> Data:
    law = {"friction": draw.between(0.3, 0.7), "reference_pressure": draw.quantity(100, 400, "kPa")}
    return {
        "kind": "power",
        **law,
        "exponent": draw.between(0.05, 0.4),
        **range_of_tests(draw, pressures=True),
    }


def table(draw: Draw) -> Data:
    """Return a measured table of two to seven slips at one to four pressures."""
    count = draw.one_of(2, 3, 5, 7)
    slips = [0.0, *np.cumsum([draw.log_between(0.2, 4.0) for _ in range(count)])]
    pressures = np.geomspace(40.0, draw.between(300, 900), draw.one_of(1, 2, 4))
    shape = np.sort([draw.between(0.05, 0.8) for _ in range(count)])
    rows = [
        {"pressure": f"{p:.5g} kPa", "friction": [0.0, *(round(0.97**k * v, 4) for v in shape)]}
        for k, p in enumerate(pressures)
    ]
    return {"kind": "table", "slip": [f"{s:.4g} mm" for s in slips], "rows": rows}


def tensions(draw: Draw, pulleys: list[Data], width: float) -> tuple[float, float]:
    """Return first and last tension [N]: easily carried, near to what is, or more than that."""
    wrap = sum(math.radians(float(p["wrap_angle"].split()[0])) for p in pulleys)
    grip = draw.at_strain((0.05, 0.14), (0.1, 0.3), (0.5, 1.4))
    radius = 0.5 * float(pulleys[0]["diameter"].split()[0])
    pressure = draw.log_between(*draw.at_strain((150e3, 400e3), (80e3, 600e3), (150e3, 800e3)))
    tight = pressure * width * radius
    return tight, tight / math.exp(min(draw.between(*grip) * wrap, 6.0))


def spread_tensions(draw: Draw, pulleys: list[Data], tight: float, slack: float) -> None:
    """Put tensions on pulleys, in any of the ways that a file may say them."""
    ends = np.geomspace(tight, slack, len(pulleys) + 1)
    brakes = draw.chance(0.25)
    for number, of in enumerate(pulleys):
        high, low = ends[number], ends[number + 1]
        entry, leaving = (low, high) if brakes else (high, low)
        ways = [
            {"entry_tension": entry, "exit_tension": leaving},
            {"exit_tension": leaving, "effective_tension": entry - leaving},
            {"entry_tension": entry, "effective_tension": entry - leaving},
        ]
        of |= {key: f"{value / 1e3:.6g} kN" for key, value in draw.one_of(*ways).items()}


def load_cases(draw: Draw, pulley_name: str, tight: float, slack: float) -> list[Data]:
    """Return further states of the conveyor."""
    cases = []
    for name in ("start", "stop")[: draw.one_of(1, 2)]:
        low = slack * draw.between(0.9, 1.3)
        high = low + (tight - slack) * draw.between(0.3, 1.4)
        pair = {"entry_tension": f"{high / 1e3:.6g} kN", "exit_tension": f"{low / 1e3:.6g} kN"}
        case: Data = {"name": name, "pulley": {pulley_name: pair}}
        case |= draw.some(0.5, kind=draw.one_of("running", "starting", "braking"))
        cases.append(case | draw.some(0.2, condition="wet"))
    return cases


def train(draw: Draw, ends: tuple[float, float], speed: float, pulleys: list[Data]) -> Data:
    """Return how the load divides: by shares, by speeds, by motors."""
    (tight, slack), names, count = ends, [p["name"] for p in pulleys], len(pulleys)
    of: Data = {
        "exit_tension": f"{slack / 1e3:.6g} kN",
        "effective_tension": f"{(tight - slack) / 1e3:.6g} kN",
    }
    way = draw.one_of("shares", "speeds", "motors")
    if way == "shares":
        parts = np.array([draw.between(0.7, 1.3) for _ in names])
        of["share"] = [f"{100 * v:.5g} %" for v in parts / parts.sum()]
    elif way == "speeds":
        trims = [100.0, *(draw.between(99.6, 100.1) for _ in range(count - 1))]
        of["speeds"] = draw.one_of("equal", [f"{v:.5g} %" for v in trims])
    else:
        torque = (tight - slack) / count * draw.between(draw.at_strain(1.2, 0.8, 1.0), 1.8)
        of["motor"] = {p["name"]: motor(draw, torque, speed, p) for p in pulleys}
    if draw.chance(0.2):
        of["run"] = {names[-1]: f"{0.05 * slack / 1e3:.5g} kN"}
    made: Data = {"train": of}
    if draw.chance(0.3):
        pull = f"{0.6 * (tight - slack) / 1e3:.6g} kN"
        made["load_case"] = [{"name": "part load", "train": {"effective_tension": pull}}]
    return made


def motor(draw: Draw, pull: float, speed: float, of: Data) -> Data:
    """Return a motor that a pull [N] loads about fully, at about the speed of the belt [m/s]."""
    radius = 0.5 * float(of["diameter"].split()[0])
    common = {
        "rated_power": f"{pull * speed / 1e3:.5g} kW",
        "rated_speed": "1480 rpm",
        "gear_ratio": round(1480.0 / 60.0 * 2.0 * math.pi * radius / speed, 4),
    }
    kind = draw.one_of("converter", "induction", "fluid-coupling")
    if kind == "converter":
        return {"kind": kind, **common, "droop": f"{draw.between(0.3, 2.0):.3g} %"}
    made = {"kind": kind, **common, "synchronous_speed": "1500 rpm"}
    if kind == "induction":
        return made
    load, slip = [0, 0.5, 1, 1.5], ["0 %", "1.2 %", "2.5 %", "4.6 %"]
    return {**made, "coupling_load": load, "coupling_slip": slip}


def criteria(draw: Draw, names: list[str]) -> Data:
    """Return what the drive is compared with."""
    standards: list[Data] = [
        {"name": "DIN 22101", "condition": draw.one_of("dry", "wet and dirty")},
        {"name": "DIN 22101", "binding": True},
        {"name": "CEMA", "start_factor": 1.2},
        {"name": "own", "friction": 0.3, "start_factor": 1.4, "binding": True},
        {"name": "none"},
    ]
    take_ups = [{"kind": "fixed"}, {"kind": "gravity", "sheave_ratio": 1.5}, {"kind": "winch"}]
    return draw.some(
        draw.at_strain(0.08, 0.25, 0.25),
        creep_limit=draw.quantity(2, 15, "mm"),
        condition=draw.one_of(*CONDITIONS),
        take_up=draw.one_of(*take_ups),
        design_standard=draw.one_of(*standards),
        safety_factor={"running": draw.between(1.0, 2.0), "starting": 1.15},
        sag={
            "idler_spacing": draw.quantity(1.0, 4.0, "m"),
            "line_mass": draw.quantity(15, 300, "kg/m"),
        },
    )


def motion(draw: Draw, kind: str, names: list[str]) -> Data:
    """Return what a run needs: an event of which nothing happens before its end."""
    if kind == "pair" or not draw.chance(0.3):
        return {}
    drums = {n: {"inertia": "900 kg m2", "control": {"kind": "exact-speed"}} for n in names}
    late = {"kind": "load-step", "at": "0.05 s", "factor": 1.0}
    event = {"name": "nothing yet", "duration": "0.1 s", "happens": [late]}
    return {"motion": {"conveyor_mass": "100 t", "drum": drums, "event": [event]}}
