"""Wear along the wrap, and the life of the lagging beside the lives that vendors state."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from wraparc.answer.sheet import NONE, Row, Table, quantity
from wraparc.answer.sources import Sources
from wraparc.arc import ArcResult
from wraparc.arc.wear import (
    IDLE_ENERGY,
    WORN_SHARE,
    coefficient_of_life,
    frictional_power,
    wear_life,
)
from wraparc.catalogue import lagging_costs
from wraparc.drive import Lagging
from wraparc.drive.pitch import turns_an_hour
from wraparc.units import RESULT_DIGITS, Cell

#: Hours of running in a year that a life in years is counted by, where nothing else is said.
HOURS = 6000.0
_LIFE = "life of a lagging as its vendor states it"


def wear_table(result: ArcResult, lagging: Lagging) -> Table | None:
    """Return the frictional power by place along the wrap; None without a belt speed."""
    edges, power = frictional_power(result)
    if not result.status.solved or math.isnan(power[0]):
        return None
    share = lagging.belt_energy_share
    rows = []
    for start, end, mean in zip(edges[:-1], edges[1:], power, strict=True):
        split = () if share is None else (share * mean, (1.0 - share) * mean)
        values = tuple(quantity(float(v), "power_per_area") for v in (mean, *split))
        place = Cell(float(end), "angle", RESULT_DIGITS, "to", float(start), "position")
        rows.append(Row(place, values))
    heads = ("frictional power",) if share is None else ("frictional power", "belt", "lagging")
    split_note = (
        "How it divides between belt and lagging is not said (belt_energy_share of the lagging)."
        if share is None
        else f"Divided by belt_energy_share = {share:g} of the lagging, "
        f"{lagging.source_of('belt_energy_share')}."
    )
    note = f"By place from the entry: shear stress times the speed of slip. {split_note}"
    return Table("Wear along the wrap", tuple(rows), heads, note, "wear")


def life_table(result: ArcResult, lagging: Lagging, of: Sources | None = None) -> Table | None:
    """Return passes, wear and life of the lagging, beside vendors' lives; None without a speed."""
    data = _life_of(result, lagging)
    if data is None:
        return None
    passes = quantity(data["passes_per_hour"], "number")
    rows = [Row("Passes of the lagging under the belt", (f"{passes} 1/h",), name="passes_per_hour")]
    depth = quantity(data["depth"], "length")
    if data["life_hours"] is not None:
        k = quantity(data["coefficient"], "wear_coefficient")
        source = str(lagging.source_of("wear_coefficient"))
        rows.append(Row("Wear coefficient", (k,), note=source, name="wear_coefficient"))
        life = _life(data["life_hours"])
        years = f"frictional energy times wear coefficient; a year has {HOURS:g} h of running here"
        rows.append(Row(f"Life until {depth} is worn off", (life,), note=years, name="life"))
    rows += [_vendor_row(vendor, of) for vendor in data["vendors"]]
    note = f"Depth that may be worn off: half the thickness, {depth}."
    if data["life_hours"] is None:
        note += (
            " The life follows from a wear coefficient, which is not published: calibrate it to a "
            "measured wear (wraparc field --measured-wear), or give wear_coefficient."
        )
    return Table("Life of the lagging", tuple(rows), note=note, name="life")


def _vendor_row(vendor: dict[str, Any], of: Sources | None) -> Row:
    low, high = vendor["coefficient"]
    ends = Cell(high, "wear_coefficient", RESULT_DIGITS, "to", low)
    least, most = vendor["years"]
    years: str = Cell(most, "number", form="to", other=least)
    years = f"over {years}" if least == most else years
    number = "" if of is None else of.number(f"{_LIFE}: {vendor['source']}")
    note = f"whatever the creep; here it would take a wear coefficient of {ends} {number}"
    return Row(
        f"Vendor's life, {vendor['name']}",
        (f"{years} years",),
        note=note.strip(),
        name="vendor_life",
    )


def life_data(result: ArcResult, lagging: Lagging) -> dict[str, Any] | None:
    """Return passes, energy, life and what vendors' lives stand for, as plain data [SI]."""
    data = _life_of(result, lagging)
    if data is None:
        return None
    edges, power = frictional_power(result)
    return {**data, "position": edges.tolist(), "frictional_power": power.tolist()}


def _life_of(result: ArcResult, lagging: Lagging) -> dict[str, Any] | None:
    speed, depth = result.arc.belt_speed, WORN_SHARE * lagging.thickness
    energy = abs(result.energy.frictional_energy)
    if speed is None or not result.status.solved or depth <= 0.0 or not energy > IDLE_ENERGY:
        return None
    passes = turns_an_hour(speed, result.arc.radius + result.arc.offset)
    k = lagging.wear_coefficient
    return {
        "passes_per_hour": passes,
        "frictional_energy": energy,
        "belt_energy_share": lagging.belt_energy_share,
        "depth": depth,
        "coefficient": k,
        "life_hours": None if k is None else wear_life(depth, k, energy, passes),
        "vendors": list(_vendors(lagging, depth, energy, passes)),
    }


def _vendors(
    lagging: Lagging, depth: float, energy: float, passes: float
) -> Iterator[dict[str, Any]]:
    for row in lagging_costs():
        if row.surface == lagging.surface:
            low, high = row.life_years
            ends = (coefficient_of_life(depth, HOURS * y, energy, passes) for y in (high, low))
            yield {
                "name": row.name,
                "years": [low, high],
                "coefficient": list(ends),
                "source": str(row.provenance),
            }


def _life(hours: float) -> str:
    if math.isinf(hours):
        return NONE
    return quantity(hours, "number") + " h"
