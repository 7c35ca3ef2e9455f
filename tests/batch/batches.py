"""Arcs of one by one as columns, and random tables of designs."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import Distributed, WrapArc
from wraparc.batch import STATUSES, BatchResult
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.drive import Lagging
from wraparc.friction import FrictionLaw
from wraparc.provenance import Kind, Provenance


def lagging(name: str, law: FrictionLaw) -> Lagging:
    """A lagging of a law; its elasticity is that of the table."""
    return Lagging(
        name=name,
        law=law,
        thickness=12e-3,
        shear_modulus=2.3e6,
        compression_modulus=10e6,
        provenance=Provenance(kind=Kind.ILLUSTRATIVE, source="test"),
    )


def columns_of(arcs: Sequence[WrapArc], laggings: Sequence[Lagging]) -> Arcs:
    """The same arcs by column; laggings are known by their laws."""
    place = {id(lag.law): i for i, lag in enumerate(laggings)}
    return arcs_of_table(
        {
            "lagging": [place[id(a.law)] for a in arcs],
            "entry_tension": [a.entry_tension for a in arcs],
            "exit_tension": [a.exit_tension for a in arcs],
            "diameter": [a.diameter for a in arcs],
            "wrap_angle": [a.wrap_angle for a in arcs],
            "belt_width": [a.width for a in arcs],
            "belt_modulus": [a.axial_stiffness / a.width for a in arcs],
            "lagging_thickness": [a.thickness for a in arcs],
            "shear_modulus": [a.shear_modulus for a in arcs],
            "compression_modulus": [a.compression_modulus for a in arcs],
            "overrun": [np.nan if a.overrun is None else a.overrun for a in arcs],
            "recovery": [float(a.recovery) for a in arcs],
            "creep_limit": [a.creep_limit for a in arcs],
            "belt_speed": [np.nan if a.belt_speed is None else a.belt_speed for a in arcs],
        },
        laggings,
    )


def designs(n: int, seed: int) -> dict[str, NDArray[np.float64]]:
    """Driving drives with fabric and steel-cord belts."""
    rng = np.random.default_rng(seed)
    entry = rng.uniform(60e3, 250e3, n)
    fabric = rng.random(n) < 0.5
    return {
        "entry_tension": entry,
        "exit_tension": entry / rng.uniform(1.2, 3.0, n),
        "diameter": rng.uniform(0.5, 1.4, n),
        "wrap_angle": rng.uniform(2.8, 3.8, n),
        "belt_width": rng.uniform(0.8, 1.8, n),
        "belt_modulus": np.where(fabric, rng.uniform(5e6, 20e6, n), rng.uniform(5e7, 1.5e8, n)),
        "lagging_thickness": rng.uniform(8e-3, 18e-3, n),
    }


#: differences of nearly equal numbers, and places of an extreme, are no better than this: creep to
#: 1e-6 of some millimetres, and that over the arc
SMALL = {
    "creep_shrinkage": 1e-8,
    "creep_compression": 1e-8,
    "creep_global": 1e-8,
    "entry_creep_ratio": 1e-8,
    "exit_creep_ratio": 1e-8,
    "peak_shear_position": 1e-4,
    "outside_tested_share": 1e-4,  # crossings by straight lines between some hundred points
    "active_arc": 5e-4,  # one arc takes the tension as straight between 180 points
    "mean_friction": 1e-11,  # the solver reaches T2 to so much
    "transmitted_power": 1e-5,
    "efficiency": 1e-12,
    "shear_loss": 1e-7,
    "power_loss": 1e-7,
    "sliding_power": 1e-7,
    "frictional_energy": 1e-9,
}
OF_OPERATING_POINT = {
    "exit_creep", "creep_shrinkage", "creep_compression", "creep_global", "exit_slip",
    "entry_creep_ratio", "exit_creep_ratio", "peak_shear_stress", "peak_shear_angle",
    "peak_shear_position", "mean_friction", "active_arc", "outside_tested_share", "stuck_arc",
    "transmitted_power", "sliding_power", "shear_loss", "power_loss", "efficiency",
    "frictional_energy", "wear_rate", "exit_tension", "entry_tension", "tension_ratio",
    "effective_tension",
}  # fmt: skip


def same(batch: BatchResult, arcs: list[WrapArc], *, capacities: bool, within: float) -> None:
    """Every number that one arc reports, by name."""
    solver = Distributed(capacities=capacities)
    columns = dict(batch)
    for i, arc in enumerate(arcs):
        result = solver.solve(arc)
        assert STATUSES[int(columns["status"][i])] == result.status.value, arc
        scalars = result.scalars()
        for name, column in columns.items():
            if name not in scalars or (name in OF_OPERATING_POINT and not result.status.solved):
                continue
            expected, found = scalars[name], float(column[i])
            if math.isnan(expected) or math.isinf(expected):
                assert str(found) == str(expected), (name, arc)
            else:
                scale = arc.wrap_angle if name.endswith("_arc") else abs(expected)
                small = SMALL.get(name, 0.0)
                assert abs(found - expected) <= within * scale + small, (name, found, arc)
