"""Random drive files that fail: laws, conditions, standards, worn faces, conveyors, trains."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from wraparc.errors import InputError
from wraparc.train.file import drive_or_train_from_document

Document = dict[str, Any]

LAWS: tuple[Document, ...] = (
    {"kind": "constant", "friction": 0.4},
    {"kind": "elastic-plastic", "friction": 0.5, "stiffness": "190 kPa/mm"},
    {
        "kind": "power", "friction": 0.5, "reference_pressure": "200 kPa", "exponent": 0.3,
        "tested_pressure": ["30 kPa", "800 kPa"], "tested_slip": "12 mm",
    },
    {
        "kind": "integral-log", "tested_slip": "9 mm",
        "knots": [
            {"pressure": "40 kPa", "peak_friction": 1.0, "peak_slip": "11 mm"},
            {"pressure": "200 kPa", "peak_friction": 0.7, "peak_slip": "14 mm"},
            {"pressure": "700 kPa", "peak_friction": 0.4, "peak_slip": "17 mm"},
        ],
    },
)  # fmt: skip
LAGGINGS = ("diamond-rubber", "medium-ceramic", "full-ceramic")
UNEVEN: tuple[Document, ...] = (
    {"misalignment": "0.6 mm/m"},
    {"shell_profile": {"crown": "0.8 mm"}},
    {"worn_depth": [["-400 mm", "0.5 mm"], ["0 mm", "2.2 mm"], ["400 mm", "0.4 mm"]]},
)


def failing(count: int, seed: int = 53) -> Iterator[Document]:
    """Yield so many random documents; what no drive can be is left out."""
    rng = np.random.default_rng(seed)
    found = 0
    while found < count:
        document = drawn(rng)
        try:
            drive_or_train_from_document(document)
        except InputError:
            continue
        found += 1
        yield document


def drawn(rng: np.random.Generator) -> Document:
    """Draw one document: a drive, a conveyor's drive, or several drives."""
    width = float(rng.choice([0.8, 1.0, 1.2, 1.6]))
    slack = float(np.exp(rng.uniform(np.log(15e3), np.log(120e3)))) * width
    pull = slack * float(rng.uniform(0.6, 3.5))
    document: Document = {"format": 1, "belt": _belt(rng, width, slack + pull)}
    document |= _criteria(rng)
    kind = rng.uniform()
    if kind < 0.25:
        return document | _train(rng, slack, pull)
    pulley = _pulley(rng, "head", document)
    if kind < 0.32:
        pulley |= {"wrap_angle": f"{rng.uniform(170.0, 225.0):.4g} deg"}
        document.get("take_up", {}).pop("kind", None)
        return document | {"pulley": [pulley], "conveyor": _conveyor(rng)}
    if kind < 0.45:
        pulley["across"] = UNEVEN[int(rng.integers(len(UNEVEN)))]
    return document | {"pulley": [pulley | _tensions(rng, slack, pull)]} | _cases(rng, pull)


def _belt(rng: np.random.Generator, width: float, tight: float) -> Document:
    rating = tight / width / float(rng.uniform(0.55, 1.15))
    steel = rng.uniform() < 0.4
    more: Document = {}
    if rng.uniform() < 0.4:
        more |= {"pulley_cover": "3 mm", "carry_cover": "6 mm", "carcass": "8 mm"}
    if rng.uniform() < 0.3:
        more["mass"] = f"{18.0 * width:.4g} kg/m"
    if rng.uniform() < 0.4:
        more["strength"] = f"{rating * rng.uniform(5.0, 9.0) * 1e-3:.5g} kN/m"
    if rng.uniform() < 0.3:
        more["momentary_factor"] = 1.4
    if rng.uniform() < 0.3:
        more["largest_wrap_pressure"] = f"{rng.uniform(400.0, 900.0):.4g} kPa"
    if rng.uniform() < 0.3:
        more["least_pulley_diameter"] = f"{rng.uniform(500.0, 1100.0):.4g} mm"
    if rng.uniform() < 0.9:
        more["rating"] = f"{rating * 1e-3:.5g} kN/m"
    ratio = rng.uniform(250.0, 480.0) if steel else rng.uniform(70.0, 119.0)
    return {
        "kind": "steel cord" if steel else "fabric", "width": f"{width} m", "speed": "4 m/s",
        "modulus": f"{rating * ratio * 1e-3:.6g} kN/m", **more,
    }  # fmt: skip


def _criteria(rng: np.random.Generator) -> Document:
    found: Document = {}
    standard = str(rng.choice(["", "CEMA", "DIN 22101", "none"]))
    if standard:
        found["design_standard"] = {"name": standard}
        if standard != "none" and rng.uniform() < 0.4:
            found["design_standard"]["binding"] = True
    take_up = str(rng.choice(["", "gravity", "fixed"]))
    if take_up:
        found["take_up"] = {"kind": take_up}
    if rng.uniform() < 0.4:
        mass = f"{rng.uniform(15.0, 90.0):.4g} kg/m"
        found["sag"] = {"idler_spacing": "3 m", "line_mass": mass}
    condition = rng.uniform()
    if condition < 0.25:
        found["covered"] = True
    elif condition < 0.4:
        found["condition"] = ["dry", "wet"]
    elif condition < 0.5:
        found["condition"] = "wet"
    return found


def _pulley(rng: np.random.Generator, name: str, document: Document) -> Document:
    lagging: Any = str(rng.choice(LAGGINGS))
    if rng.uniform() < 0.3 and "condition" not in document:
        law = LAWS[int(rng.integers(len(LAWS)))]
        lagging = {
            "surface": "rubber", "thickness": "12 mm", "shear_modulus": "2 MPa",
            "compression_modulus": "9 MPa", "law": law,
        }  # fmt: skip
        if rng.uniform() < 0.4:
            lagging["bond_strength"] = f"{rng.uniform(150.0, 600.0):.4g} kPa"
    return {
        "name": name, "lagging": lagging, "diameter": f"{rng.uniform(0.5, 1.4):.4g} m",
        "wrap_angle": f"{rng.uniform(165.0, 225.0):.4g} deg",
    }  # fmt: skip


def _tensions(rng: np.random.Generator, slack: float, pull: float) -> Document:
    tension, sign = f"{slack:.6g} N", 1.0 if rng.uniform() < 0.8 else -1.0
    form = int(rng.integers(3)) if sign > 0.0 else 3
    if form == 0:
        return {"exit_tension": tension, "effective_tension": f"{pull:.6g} N"}
    if form == 1:
        return {"exit_tension": tension, "power": f"{4.0 * pull:.6g} W"}
    ends = (f"{slack + pull:.6g} N", tension)
    return dict(zip(("entry_tension", "exit_tension"), ends if form == 2 else ends[::-1],
                    strict=True))  # fmt: skip


def _cases(rng: np.random.Generator, pull: float) -> Document:
    cases = [
        {"name": name, "kind": kind,
         "pulley": {"head": {"effective_tension": f"{pull * rng.uniform(low, high):.6g} N"}}}
        for name, kind, low, high in (
            ("start", "starting", 1.0, 1.5), ("empty", "running", 0.2, 0.6),
        )
        if rng.uniform() < 0.5
    ]  # fmt: skip
    return {"load_case": cases} if cases else {}


def _conveyor(rng: np.random.Generator) -> Document:
    take_up: Document = {"counterweight": f"{rng.uniform(3.0, 12.0):.4g} t"}
    if rng.uniform() < 0.5:
        take_up = {"take_up_tension": f"{rng.uniform(15.0, 60.0):.4g} kN"}
    return {
        "length": f"{rng.uniform(200.0, 1200.0):.4g} m",
        "lift": f"{rng.uniform(-10.0, 40.0):.4g} m",
        "capacity": f"{rng.uniform(400.0, 1500.0):.4g} t/h", "belt_mass": "20 kg/m",
        "carry_idler_mass": "14 kg/m", "return_idler_mass": "6 kg/m", "start_factor": 1.3,
        **take_up,
    }  # fmt: skip


def _train(rng: np.random.Generator, slack: float, pull: float) -> Document:
    count = int(rng.integers(2, 4))
    names = [f"drive {k + 1}" for k in range(count)]
    pulleys = [_pulley(rng, name, {"condition": ""}) for name in names]
    lagging = pulleys[0]["lagging"]
    for pulley in pulleys if rng.uniform() < 0.7 else ():
        pulley["lagging"] = lagging
    train: Document = {"exit_tension": f"{slack:.6g} N", "effective_tension": f"{pull:.6g} N"}
    if rng.uniform() < 0.7:
        train["share"] = [f"{100.0 / count!r} %" for _ in names]
    else:
        train["speeds"] = "equal"
        for pulley in pulleys:
            pulley["diameter"] = pulleys[0]["diameter"]
    found: Document = {"pulley": pulleys, "train": train}
    if rng.uniform() < 0.5:
        found["load_case"] = [
            {"name": "empty", "train": {"effective_tension": f"{0.4 * pull:.6g} N"}}
        ]
    return found
