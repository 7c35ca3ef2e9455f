"""Sourced data: belts, laggings, design values of friction, costs."""

from wraparc.catalogue.loader import (
    CatalogueBelt,
    DesignFriction,
    LaggingCost,
    belt,
    belts,
    design_friction,
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
    "lagging_costs",
    "lagging_names",
    "lagging_text",
    "own_lagging_names",
    "place_of_own",
    "unknown_name",
]
