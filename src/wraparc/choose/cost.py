"""What a lagged pulley costs over the years: lagging, installation, belt, energy lost to creep."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arrays import Array
from wraparc.catalogue import LaggingCost, lagging_costs
from wraparc.drive import Cost, Lagging
from wraparc.drive.load_case import hours_problems
from wraparc.errors import Problem, shown
from wraparc.provenance import Provenance
from wraparc.schema.problems import place_text

JOULES_PER_KWH = 3.6e6


@dataclass(frozen=True, kw_only=True)
class Price:
    """Price and life of a lagging, and where they came from."""

    cost: Cost
    source: Provenance


@dataclass(frozen=True, kw_only=True)
class BeltPrice:
    """Price of a belt and how long it lasts.

    Attributes
    ----------
    price
        For the whole belt, spliced and installed [currency].
    life_years
        Expected life [years].
    """

    price: float
    life_years: float


@dataclass(frozen=True, kw_only=True)
class Costing:
    """How designs are priced.

    Attributes
    ----------
    currency
        Currency of the costs.
    years
        Years that are counted.
    laggings
        Prices by name of the lagging, in any currency; see `unpriced`.
    belts
        Prices by name of the belt; empty where the belt costs the same in every design.
    tariff
        Price of a kilowatt hour [currency], 0 where it costs nothing, or None to leave energy out.
    hours
        Hours of running in a year by load case.
    face_width
        Width of the pulley that is lagged [m], or None for that of the belt.
    """

    currency: str
    years: float = 10.0
    laggings: Mapping[str, Price] = field(default_factory=dict, hash=False)
    belts: Mapping[str, BeltPrice] = field(default_factory=dict, hash=False)
    tariff: float | None = None
    hours: Mapping[str, float] = field(default_factory=dict, hash=False)
    face_width: float | None = None

    def unpriced(self, laggings: Iterable[str]) -> dict[str, str]:
        """Return laggings without a price in this currency, and in which they are priced.

        Parameters
        ----------
        laggings
            Names of the candidates.

        Returns
        -------
        The other currency by name, empty where no price is known.
        """
        prices = {name: self.laggings.get(name) for name in laggings}
        others = {n: "" if price is None else price.cost.currency for n, price in prices.items()}
        return {name: other for name, other in others.items() if other != self.currency}


def purchases(years: float, life_years: ArrayLike) -> Array:
    """How often something is bought in `years` when it lasts `life_years` [-]: whole numbers."""
    return np.ceil(years / np.asarray(life_years, float) - 1e-9)


def lagging_cost(
    cost: Cost, area: ArrayLike, years: float, life: ArrayLike = math.nan
) -> tuple[Array, Array, Array]:
    """Cost of a lagging over the years: at the middle, the longest and the shortest life.

    (material + installation) * area / (area of the price) * times bought.

    Parameters
    ----------
    cost
        Prices, the area they are for, and the life.
    area
        Lagged area pi D W [m2], any shape.
    years
        Years that are counted.
    life
        Life by the energy that wears the lagging, in place of that of the vendor [years]; nan
        where it is not known.

    Returns
    -------
    middle, least, most
        [currency], the shape of `area`.
    """
    each = (cost.material + cost.installation) * np.asarray(area, float) / cost.area
    low, high = cost.life_years
    known = np.asarray(life, float)
    middle, least, most = (
        each * purchases(years, np.where(np.isnan(known), v, known))
        for v in ((low + high) / 2, high, low)
    )
    return middle, least, most


def energy_cost(loss: ArrayLike, hours: float, tariff: float, years: float) -> Array:
    """Price of the power lost to creep [currency].

    Parameters
    ----------
    loss
        Power lost [W].
    hours
        Hours of running in a year.
    tariff
        Price of a kilowatt hour [currency].
    years
        Years that are counted.
    """
    return np.asarray(loss, float) * 3600.0 * hours * years / JOULES_PER_KWH * tariff


def catalogue_price(lagging: Lagging, name: str = "") -> Price | None:
    """Price of a lagging: its own, or the catalogue's for its surface.

    Parameters
    ----------
    lagging
        The lagging.
    name
        Which price of the catalogue; the first for the surface unless given.

    Returns
    -------
    None if there is none.
    """
    if lagging.cost is not None and not name:
        return Price(cost=lagging.cost, source=lagging.source_of("cost"))
    fits = [
        c for c in lagging_costs() if (c.name == name if name else c.surface == lagging.surface)
    ]
    return _price(fits[0]) if fits else None


def _price(found: LaggingCost) -> Price:
    cost = Cost(
        material=found.material,
        installation=found.installation,
        currency=found.currency,
        area=found.area,
        life_years=found.life_years,
    )
    return Price(cost=cost, source=found.provenance)


def price_problems(costing: Costing, belts: list[str]) -> list[Problem]:
    """Return a problem for every one of several belts without a price, and for odd costs."""
    missing = [name for name in belts if name not in costing.belts] if len(belts) > 1 else []
    problems = [
        Problem(
            key=place_text(("cost", "belt", name)),
            message=f"belt {shown(name)} has no cost",
            remedy="Give price and life_years of every candidate belt.",
        )
        for name in missing
    ]
    if costing.tariff and not any(h > 0.0 for h in costing.hours.values()):
        message = "a tariff without hours of a load case"
        problems.append(
            Problem(key="cost.hours", message=message, remedy="Write hours.design = 6000.")
        )
    problems += hours_problems(costing.hours, "cost.hours")
    if not 0.0 < costing.years < math.inf:
        value = f"{costing.years:g}"
        problems.append(Problem(key="cost.years", value=value, message="must be more than 0"))
    return problems
