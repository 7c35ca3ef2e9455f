"""A folder of virtual tests with its plan."""

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

from wraparc.drive import Lagging
from wraparc.errors import InputError, Problem, input_error, name_remedy, shown
from wraparc.files import load_lagging
from wraparc.friction import COVER_SHEAR
from wraparc.provenance import Kind
from wraparc.saving import save_file, unwritable
from wraparc.schema.emit import document_text
from wraparc.schema.quantity_text import quantity_text
from wraparc.shear_test import DIALECTS, Dialect, VirtualRig, run_virtual_test
from wraparc.shear_test.plan_keys import PLAN
from wraparc.units import parse_number

_AREA = 0.04
_HEAD = "# Virtual tests, made by `wraparc rig` from a known law: no machine wrote these files.\n"
_TEXT_DIALECTS = tuple(name for name in DIALECTS if name != "excel")


def write_virtual_tests(folder: Path, lagging: str, pressures: str, **said: Any) -> Path:
    """Write tests and plan; return the path of the plan.

    Parameters
    ----------
    folder
        Made if it is not there.
    lagging
        Name in the catalogue or path of a file.
    pressures
        Numbers in kPa, separated by blanks.
    **said
        ``conditions``, each a name or ``NAME=FACTOR`` on friction; ``dialects``, names of
        `DIALECTS`, taken in turn; ``repeats``, ``points``, ``noise``, ``lash`` [mm],
        ``scatter``, ``seed``; ``cover`` [mm] and ``cover_modulus`` [MPa] of the belt in the rig.
    """
    of = load_lagging(lagging)
    values = _pressures(pressures)
    writers = _dialects(said["dialects"])
    conditions = _conditions(said["conditions"])
    if said["cover"] and COVER_SHEAR in (of.law.slip_includes or ()):
        message = "the slip of this law includes the cover shear already"
        remedy = "Leave --cover out, or test another lagging."
        value = f"{said['cover']:g} mm"
        raise input_error(message=message, remedy=remedy, key="--cover", value=value)
    rig = VirtualRig(
        law=of.law,
        area=_AREA,
        shear_compliance=of.shear_compliance + said["cover"] / said["cover_modulus"] * 1e-9,
        lash=said["lash"] * 1e-3,
        points=said["points"],
        noise=said["noise"],
        wander=0.003,
        scatter_friction=said["scatter"],
        scatter_slip=1.5 * said["scatter"],
    )
    _make(folder)
    tests: list[dict[str, Any]] = []
    repeats = range(1, said["repeats"] + 1)
    for (condition, factor), pressure, repeat in product(conditions.items(), values, repeats):
        dialect = writers[len(tests) % len(writers)]
        state = replace(rig, friction_factor=factor)
        test = run_virtual_test(state, pressure, said["seed"] * 100_000 + len(tests))
        prefix = f"{condition}-" if len(conditions) > 1 else ""
        name = f"{prefix}{pressure / 1e3:04.0f}kPa-{repeat}{dialect.suffix}"
        save_file(folder / name, dialect.write(test))
        tests.append({"file": name, "pressure": quantity_text(pressure, "pressure")})
        tests[-1]["speed"] = "10 mm/min"
        if conditions.keys() != {"dry"}:
            tests[-1]["condition"] = condition
        if dialect.units:
            tests[-1]["units"] = dict(dialect.units)
    plan = folder / "plan.toml"
    save_file(plan, _HEAD + document_text(_plan(of, tests, said), PLAN))
    return plan


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(unwritable(folder, error)) from None


# What measures in the computer has no errors but those that were asked for.
_NO_ERRORS = {
    "force": "0 %", "normal_force": "0 %", "area": "0 %", "travel": "0 %",
    "compliance": "0 mm/kN", "shear_modulus": "0 %", "cover_shear_modulus": "0 %",
}  # fmt: skip


def _plan(lagging: Lagging, tests: list[dict[str, Any]], said: dict[str, Any]) -> dict[str, Any]:
    sample: dict[str, Any] = {
        "name": f"{lagging.name}-virtual"[:60],
        "title": f"{lagging.title or lagging.name}, virtual tests"[:200],
    }
    if lagging.surface:
        sample["surface"] = lagging.surface
    if lagging.thickness > 0.0 and lagging.shear_modulus < float("inf"):
        sample["thickness"] = quantity_text(lagging.thickness, "length")
        sample["shear_modulus"] = quantity_text(lagging.shear_modulus, "pressure")
        if lagging.elastic_modulus:
            sample["elastic_modulus"] = quantity_text(lagging.elastic_modulus, "pressure")
        if lagging.compression_modulus < float("inf"):
            modulus = quantity_text(lagging.compression_modulus, "pressure")
            sample["compression_modulus"] = modulus
        sample["roughness"] = "0.3 mm"
    note = (
        f"made by the virtual rig from the law of {lagging.name}: noise {said['noise']:g}, "
        f"lash {said['lash']:g} mm, scatter between samples {said['scatter']:g}"
    )
    changed = [f"{n} {f:g}" for n, f in _conditions(said["conditions"]).items() if f != 1.0]
    if changed:
        note += f"; friction times, by condition: {', '.join(changed)}"
    belt, of = dict[str, Any](), lagging.law
    if said["cover"]:
        modulus = quantity_text(said["cover_modulus"] * 1e6, "pressure")
        thickness = quantity_text(said["cover"] * 1e-3, "length")
        belt = {"test_belt": {"cover_thickness": thickness, "cover_shear_modulus": modulus}}
    elif of.slip_includes is not None and COVER_SHEAR not in of.slip_includes:
        belt = {"test_belt": {"cover_thickness": "0 mm"}}  # nothing shears but the sample
    return {
        "format": 1,
        "lagging": sample,
        **belt,
        "rig": {"name": "virtual rig", "sample_area": quantity_text(_AREA, "area"), "faces": 2},
        "uncertainty": _NO_ERRORS,
        "provenance": {"kind": Kind.ILLUSTRATIVE.value, "source": "virtual rig", "note": note},
        "test": tests,
    }


def _pressures(text: str) -> list[float]:
    try:
        values = [parse_number(part) * 1e3 for part in text.split()]
    except InputError as error:
        raise InputError(
            [Problem(message=p.message, remedy=p.remedy, key="--pressures") for p in error.problems]
        ) from None
    if not values or not all(0.0 < value <= 1e7 for value in values):
        raise input_error(
            message="must be pressures from 0 to 10000 kPa",
            remedy='Write for example --pressures "69 138 276".',
            key="--pressures",
            value=shown(text),
        )
    return sorted(set(values))


def _conditions(given: Sequence[str]) -> dict[str, float]:
    """Friction of each condition over that of the law."""
    factors: dict[str, float] = {}
    for text in given or ("dry",):
        name, sign, number = text.partition("=")
        try:
            factor = parse_number(number) if sign else 1.0
        except InputError:
            factor = 0.0
        if not re.fullmatch(r"[A-Za-z0-9_]{1,30}", name) or not 0.0 < factor <= 10.0:
            raise input_error(
                message="must be a name, or NAME=FACTOR up to 10",
                remedy="Write for example --condition wet=0.7.",
                key="--condition",
                value=shown(text),
            )
        factors[name] = factor
    return factors


def _dialects(names: Sequence[str]) -> list[Dialect]:
    unknown = [name for name in names if name not in DIALECTS]
    if unknown:
        raise input_error(
            message="no such dialect",
            remedy=name_remedy(unknown[0], DIALECTS),
            key="--dialect",
            value=shown(unknown[0]),
        )
    return [DIALECTS[name] for name in names or _TEXT_DIALECTS]
