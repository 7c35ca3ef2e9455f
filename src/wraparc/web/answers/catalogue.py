"""The catalogue as plain data."""

from functools import cache
from typing import Any

import numpy as np

from wraparc import catalogue
from wraparc.drive import Lagging
from wraparc.files.lagging_file import load_lagging_conditions, pick_condition
from wraparc.present.catalogue_sheets import lagging_sheet
from wraparc.schema.source import parse
from wraparc.web.answers.shown import Data, quantity_both, rounded, sheet_data
from wraparc.web.examples import examples

_PRESSURES = 5
_POINTS = 80


@cache
def whole() -> Data:
    """Return belts, laggings, design values of friction and examples."""
    return {
        "belts": [_belt(belt) for belt in catalogue.belts()],
        "laggings": [_lagging(name) for name in catalogue.lagging_names()],
        "design_friction": [
            {
                "standard": value.standard,
                "surface": value.surface,
                "condition": value.condition,
                "friction": list(value.friction),
                "source": str(value.provenance),
            }
            for value in catalogue.design_friction()
        ],
        "examples": [
            {
                "name": example.name,
                "title": str(example.document.get("title", example.name)),
                "kind": example.kind,
                "pulleys": len(example.document["pulley"]),
            }
            for example in examples()
        ],
    }


def _belt(belt: catalogue.CatalogueBelt) -> Data:
    least = belt.least_pulley_diameter
    return {
        "name": belt.name,
        "kind": belt.kind,
        "rating": quantity_both(belt.rating, "force_per_width"),
        "modulus": quantity_both(belt.modulus, "force_per_width"),
        "least_pulley_diameter": None if least is None else quantity_both(least, "length"),
        "source": str(belt.provenance),
    }


def _lagging(name: str) -> Data:
    conditions = load_lagging_conditions(name, allow_paths=False)
    first = conditions[0]
    origin = first.source_of("law")
    tested = first.law.tested
    return {
        "name": name,
        "title": first.title,
        "surface": first.surface,
        "conditions": [lagging.condition for lagging in conditions],
        "thickness": _modulus(first.thickness, "length"),
        "shear_modulus": _modulus(first.shear_modulus, "pressure"),
        "compression_modulus": _modulus(first.compression_modulus, "pressure"),
        "kind": origin.kind.value,
        "source": str(origin),
        "tested": None
        if tested is None
        else {
            "pressure": {
                s: f"{low} to {high}"
                for (s, low), high in zip(
                    quantity_both(tested.pressure_min, "pressure").items(),
                    quantity_both(tested.pressure_max, "pressure").values(),
                    strict=True,
                )
            },
            "slip": quantity_both(tested.slip_max, "length"),
        },
        "notes": list(first.notes),
    }


def _modulus(value: float, dimension: Any) -> Data:
    if value == float("inf"):
        return {"si": "rigid", "us": "rigid"}
    return quantity_both(value, dimension)


def lagging(request: Data) -> Data:
    """Return one lagging with its friction curves."""
    conditions = load_lagging_conditions(request["name"], allow_paths=False)
    one = pick_condition(conditions, request["condition"])
    table = parse(catalogue.lagging_text(request["name"]))
    table.pop("format", None)
    return {
        "name": one.name,
        "condition": one.condition,
        "document": table,
        **sheet_data(lambda system: lagging_sheet(conditions, system)),
        **law_data(one),
    }


def law_data(one: Lagging) -> Data:
    """Return friction curves over slip at pressures of the tested range."""
    tested = one.law.tested
    low, high, most = 7e4, 7e5, 1.5e-2
    if tested is not None:
        low, high, most = tested.pressure_min, tested.pressure_max, tested.slip_max
    pressures = np.geomspace(max(low, 1e3), high, _PRESSURES)
    slip = 1.5 * most * np.linspace(0.0, 1.0, _POINTS) ** 1.5
    friction = np.array([one.law.friction(slip, np.full_like(slip, p)) for p in pressures])
    return {
        "law": {
            "slip": rounded(slip),
            "pressures": rounded(pressures),
            "friction": rounded(friction),
            "tested_slip": None if tested is None else tested.slip_max,
        }
    }
