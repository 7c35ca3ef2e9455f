"""The mass of a belt: of the layers that its maker publishes, and what is usual for its kind."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf, isnan, log
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.catalogue import CatalogueBelt, belts
from wraparc.drive.belt import Belt
from wraparc.drive.pitch import layers_of
from wraparc.provenance import Provenance

#: Notes on a mass that is not stated for the belt itself.
OF_LAYERS = "computed from carcass and covers"
OF_CONVEYOR = Provenance(note="belt_mass of [conveyor]")
#: Covers of belts, on the side of the pulley and on that of the load [m]; ours.
USUAL_COVERS = ((1.5e-3, 6e-3), (3e-3, 15e-3))
#: Ratings whose ratio is less belong to belts of about the same carcass [-].
LIKE_RATING = 1.3


def layer_mass(
    row: CatalogueBelt, width: float, pulley_cover: float, carry_cover: float
) -> float | None:
    """Return the mass of a belt of the catalogue, B (m_c + rho (h_p + h_c)) [kg/m].

    Parameters
    ----------
    row
        The belt, with the mass of its carcass m_c [kg/m2] and the density of covers rho [kg/m3].
    width, pulley_cover, carry_cover
        B and the thickness of both covers [m].

    Returns
    -------
    None where its maker publishes no masses.
    """
    if row.carcass_mass is None or row.cover_mass is None:
        return None
    return width * (row.carcass_mass + row.cover_mass * (pulley_cover + carry_cover))


def layer_source(row: CatalogueBelt) -> Provenance:
    """Return where the mass by `layer_mass` comes from."""
    origin = row.sources.get("carcass_mass", row.sources.get("carcass", row.provenance))
    notes = (OF_LAYERS, origin.note)
    if origin.note.startswith("estimated"):  # what it is must lead
        notes = (origin.note, OF_LAYERS)
    return replace(origin, note="; ".join(notes))


def is_of_layers(belt: Belt) -> bool:
    """Return whether the mass of a belt was computed from its layers."""
    return belt.mass is not None and OF_LAYERS in belt.source_of("mass").note


def is_stated(belt: Belt) -> bool:
    """Return whether the mass of a belt is stated for the belt itself."""
    return belt.mass is not None and not (is_of_layers(belt) or is_of_conveyor(belt))


def is_of_conveyor(belt: Belt) -> bool:
    """Return whether the mass of a belt is that of its conveyor."""
    return belt.mass is not None and belt.source_of("mass").note == OF_CONVEYOR.note


def with_mass(belt: Belt, mass: float | None, source: Provenance | None = None) -> Belt:
    """Return the belt with another mass [kg/m], and where that comes from."""
    sources = {key: of for key, of in belt.sources.items() if key != "mass"}
    return replace(belt, mass=mass, sources=sources | ({} if source is None else {"mass": source}))


def masses_at(belts: Sequence[Belt], which: Integers, width: Array) -> Array:
    """Return the masses of belts in other widths, shape (n,); nan where not known [kg/m].

    One that was computed from the layers grows with the width; one that is stated stays.

    Parameters
    ----------
    belts
        The belts.
    which, width
        Place of that of every row in `belts`, and its width there [m], shape (n,) each.
    """
    mass = np.array([np.nan if b.mass is None else b.mass for b in belts])
    usual = np.array([b.width if is_of_layers(b) else np.nan for b in belts])
    return np.asarray(mass[which] * np.where(np.isnan(usual[which]), 1.0, width / usual[which]))


def in_width(belt: Belt, width: float) -> Belt:
    """Return the belt in another width [m]; a mass of its layers grows with it."""
    mass = belt.mass
    if mass is not None and is_of_layers(belt):
        mass *= width / belt.width
    return replace(belt, width=width, mass=mass)


class MassRange(NamedTuple):
    """Least and largest mass of a belt [kg/m]."""

    least: float
    most: float


def usual_mass(belt: Belt) -> MassRange:
    """Return what belts of a kind, a rating and covers weigh [kg/m].

    Carcasses are those of the catalogue, of the belt itself or of those of its kind and about its
    rating, of its kind alone where there are none; covers are those of the belt, else usual ones.
    """
    rows = [row for row in belts() if row.carcass_mass is not None and row.cover_mass is not None]
    for near in (
        [row for row in rows if row.name == belt.name],
        [row for row in rows if _kind_agrees(row, belt) and _rating_agrees(row, belt)],
        [row for row in rows if _kind_agrees(row, belt)],
    ):
        if near:
            rows = near
            break
    known = layers_of(belt)
    covers = [
        ends if isnan(cover) else (cover, cover)
        for cover, ends in zip((known.pulley_cover, known.carry_cover), USUAL_COVERS, strict=True)
    ]
    least, most = inf, 0.0
    for row in rows:
        light = layer_mass(row, belt.width, covers[0][0], covers[1][0])
        heavy = layer_mass(row, belt.width, covers[0][1], covers[1][1])
        least, most = min(least, light or inf), max(most, heavy or 0.0)
    return MassRange(least, most)


def _kind_agrees(row: CatalogueBelt, belt: Belt) -> bool:
    return row.kind == belt.kind or not belt.kind


def _rating_agrees(row: CatalogueBelt, belt: Belt) -> bool:
    return belt.rating is not None and abs(log(row.rating / belt.rating)) <= log(LIKE_RATING)
