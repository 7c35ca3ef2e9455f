"""Sourced data: belts, laggings, design values of friction, costs."""

from wraparc.catalogue.catalogue_belt import CatalogueBelt
from wraparc.catalogue.loader import (
    DesignFriction,
    LaggingCost,
    belt,
    belts,
    design_friction,
    find_belt,
    lagging_costs,
    lagging_names,
    lagging_text,
    own_lagging_names,
    place_of_own,
    unknown_name,
)

__all__ = [
    "CatalogueBelt",
    "DesignFriction",
    "LaggingCost",
    "belt",
    "belts",
    "design_friction",
    "find_belt",
    "lagging_costs",
    "lagging_names",
    "lagging_text",
    "own_lagging_names",
    "place_of_own",
    "unknown_name",
]
