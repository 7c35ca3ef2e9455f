"""Life-cycle cost of every design: lagging by its wear, belt, energy."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arc.wear import WORN_SHARE
from wraparc.arrays import Array
from wraparc.choose.cost import energy_cost, lagging_cost, purchases
from wraparc.choose.search import Grid, Search
from wraparc.drive.pitch import turns_an_hour


@dataclass(frozen=True, eq=False)
class Costs:
    """Life-cycle cost of every design by part, shape (n,) [currency].

    The parts of the lagging are nan, and not in the total, where one of them has no price.
    """

    lagging: Array
    lagging_least: Array
    lagging_most: Array
    belt: Array
    energy: Array

    @property
    def total(self) -> Array:
        """Lagging at the middle of its life, belt, energy."""
        return np.asarray(np.nan_to_num(self.lagging) + self.belt + self.energy)


def _area(search: Search, grid: Grid) -> Array:
    face = search.costing.face_width or search.drive.belt.width
    return np.asarray(math.pi * grid.diameter * face)


def _lives(search: Search, grid: Grid, dry: Sequence[Mapping[str, Array]]) -> Array:
    """Life of every lagging by the energy that wears it [years]; nan where it cannot be told.

    Half the thickness may be worn off; hours are those of the costs, by load case.
    """
    known = [lag.wear_coefficient for lag in search.laggings]
    coefficient = np.array([math.nan if k is None else k for k in known])[grid.places[0]]
    speeds = np.array([math.nan if b.speed is None else b.speed for b in search.belts])
    passes = turns_an_hour(speeds[grid.places[2]], 0.5 * grid.diameter + grid.offset)
    energy = np.zeros(len(grid))
    for case, answer in zip(search.drive.load_cases, dry, strict=True):
        hours = search.costing.hours.get(case.name, 0.0)
        if hours > 0.0:
            energy = energy + hours * passes * np.abs(answer["frictional_energy"])
    worn = coefficient * energy
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(worn > 0.0, WORN_SHARE * grid.thickness / worn, np.nan)


def costs_of(search: Search, grid: Grid, dry: Sequence[Mapping[str, Array]]) -> Costs:
    """Cost of every design; energy by the first condition."""
    c, n = search.costing, len(grid)
    area = _area(search, grid)
    parts = np.full((3, n), math.nan)
    life = _lives(search, grid, dry)
    for place, lagging in enumerate(() if search.unpriced else search.laggings):
        mine = grid.places[0] == place
        cost = c.laggings[lagging.name].cost
        parts[:, mine] = lagging_cost(cost, area[mine], c.years, life[mine])
    belts = np.zeros(len(search.belts))
    for place, belt in enumerate(search.belts):
        if belt.name in c.belts:
            price = c.belts[belt.name]
            belts[place] = price.price * float(purchases(c.years, price.life_years))
    energy = np.zeros(n)
    if c.tariff:
        for case, answer in zip(search.drive.load_cases, dry, strict=True):
            hours = c.hours.get(case.name, 0.0)
            if hours > 0.0:
                energy = energy + energy_cost(answer["power_loss"], hours, c.tariff, c.years)
    return Costs(parts[0], parts[1], parts[2], belts[grid.places[2]], energy)
