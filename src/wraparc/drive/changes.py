"""Changes to a drive: another lagging, belt or thickness, worn, bare."""

from __future__ import annotations

import math
from dataclasses import replace

from wraparc.catalogue import CatalogueBelt, DesignFriction, belts, design_friction
from wraparc.drive.belt import Belt
from wraparc.drive.belt_mass import is_of_layers, layer_mass, layer_source, with_mass
from wraparc.drive.conditions import Condition
from wraparc.drive.drive import Drive
from wraparc.drive.lagging import Lagging
from wraparc.drive.pulley import Pulley
from wraparc.errors import input_error, name_remedy, shown
from wraparc.friction import Constant
from wraparc.provenance import Kind, Provenance
from wraparc.units import display

#: Part of a lagging that says that it is worn, and its law that of before.
WORN = "worn"


def with_pulley(drive: Drive, pulley: Pulley) -> Drive:
    """Return the drive with the pulley of the same name replaced."""
    return replace(
        drive, pulleys=tuple(pulley if p.name == pulley.name else p for p in drive.pulleys)
    )


def with_lagging(drive: Drive, pulley: str, lagging: Lagging) -> Drive:
    """Return the drive with another lagging on a pulley.

    Where load cases have conditions of their own, the lagging is put into them by published values.

    Raises
    ------
    InputError
        If no published value covers one of the conditions.
    """
    base = drive.pulley(pulley)
    conditions = tuple(Condition(name=c.condition).of((lagging,)) for c in base.conditions)
    return with_pulley(drive, replace(base, lagging=lagging, conditions=conditions))


def with_thickness(drive: Drive, pulley: str, thickness: float) -> Drive:
    """Return the drive with a lagging of another thickness [m]; the diameter stays over it.

    The compression modulus follows the shape of the blocks, see `Lagging.with_thickness`.
    """
    return with_pulley(drive, _as_thick(drive.pulley(pulley), thickness))


def worn_to(drive: Drive, pulley: str, thickness: float) -> Drive:
    """Return the drive with its lagging worn down: thinner, and the diameter smaller by as much.

    The friction stays that of the unworn lagging: what wear of tread and tiles takes off it is
    not known, and ``sources["worn"]`` of the lagging says so.

    Raises
    ------
    InputError
        If that is thicker than the lagging is.
    """
    base = drive.pulley(pulley)
    if thickness > base.lagging.thickness:
        given, now = (display(h, "length") for h in (thickness, base.lagging.thickness))
        raise input_error(
            key="worn",
            value=given,
            message=f"must be at most the lagging thickness {now}",
            remedy="Give the thickness left after wear.",
        )
    diameter = base.diameter - 2.0 * (base.lagging.thickness - thickness)
    worn = _as_thick(base, thickness)
    source = Provenance(note=f"worn to {display(thickness, 'length')}, the law that of before")
    lagging, *others = (
        replace(lagging, sources={**lagging.sources, WORN: source})
        for lagging in (worn.lagging, *worn.conditions)
    )
    worn = replace(worn, diameter=diameter, lagging=lagging, conditions=tuple(others))
    return with_pulley(drive, worn)


def _as_thick(pulley: Pulley, thickness: float) -> Pulley:
    """Return a pulley with its lagging of another thickness, in every condition."""
    lagging, *others = (
        lagging.with_thickness(thickness) for lagging in (pulley.lagging, *pulley.conditions)
    )
    return replace(pulley, lagging=lagging, conditions=tuple(others))


#: What a belt of the catalogue brings.
BELT_KEYS = (
    "kind", "modulus", "modulus_test", "modulus_loads", "modulus_ends", "rating", "strength",
    "least_pulley_diameter", "pulley_cover", "carry_cover", "carcass", "carcass_ends",
    "cord_pitch",
)  # fmt: skip


def belt_sources(row: CatalogueBelt) -> dict[str, Provenance]:
    """Return where single numbers of a belt of the catalogue come from, by field of a belt."""
    return {key: of for key, of in row.sources.items() if key in Belt.LIMITS}


def with_belt(drive: Drive, row: CatalogueBelt) -> Drive:
    """Return the drive with a belt of the catalogue, its width and speed kept."""
    return replace(drive, belt=belt_of(row, drive.belt))


def belt_of(row: CatalogueBelt, like: Belt) -> Belt:
    """Return a belt of the catalogue in the width and at the speed of another.

    Width, speed, a mass that is stated, and covers that the name does not state keep the provenance
    they had there; else the mass is that of the layers, where its maker publishes them.
    """
    kept = ["width", "speed", "cover_shear_modulus"]
    kept += [key for key in ("pulley_cover", "carry_cover") if getattr(row, key) is None]
    computed = like.mass is None or is_of_layers(like)
    kept += [] if computed else ["mass"]
    sources = {key: like.source_of(key) for key in kept if getattr(like, key) is not None}
    belt = Belt(
        name=row.name,
        provenance=row.provenance,
        sources=sources | belt_sources(row),
        **{key: getattr(row, key) for key in BELT_KEYS if key not in kept},
        **{key: getattr(like, key) for key in kept},
    )
    if not computed or belt.pulley_cover is None or belt.carry_cover is None:
        return belt
    mass = layer_mass(row, belt.width, belt.pulley_cover, belt.carry_cover)
    return belt if mass is None else with_mass(belt, mass, layer_source(row))


def other_carcass(belt: Belt) -> CatalogueBelt:
    """Return the catalogue belt of the other carcass whose rating is nearest.

    Raises
    ------
    InputError
        If rating or carcass are not known.
    """
    if belt.rating is None or belt.kind not in ("fabric", "steel cord"):
        raise input_error(
            key="belt",
            value=shown(belt.name),
            message="needs rating and kind to find the other carcass",
            remedy="Give both, or name the other belt.",
        )
    others = [b for b in belts() if b.kind != belt.kind]
    rating = belt.rating
    return min(others, key=lambda b: abs(math.log(b.rating / rating)))


def bare(drive: Drive, pulley: str, standard: str, condition: str = "dry") -> tuple[Drive, str]:
    """Return the drive with a bare pulley by the design value of a standard, and its source.

    The lower end of the published values, as a constant friction on steel that neither shears
    nor compresses. The diameter stays.

    Raises
    ------
    InputError
        If the standard has no such value.
    """
    found = [d for d in design_friction() if d.standard == standard and d.surface == "bare"]
    design = next((d for d in found if d.condition in (condition, "")), None)
    if design is None:
        known = sorted({d.standard for d in design_friction() if d.surface == "bare"})
        raise input_error(
            value=shown(standard),
            message=f"no design value of a bare pulley, {condition}",
            remedy=name_remedy(standard, known),
        )
    lagging = _bare_lagging(design, condition)
    source = lagging.provenance
    return with_lagging(drive, pulley, lagging), f"friction {design.friction[0]:g}, {source}"


def _bare_lagging(design: DesignFriction, condition: str) -> Lagging:
    origin = design.provenance
    note = "lower end of the design values"
    return Lagging(
        name="bare",
        title="Bare steel",
        law=Constant(friction_coefficient=design.friction[0]),
        surface="bare",
        condition=condition,
        provenance=Provenance(Kind.PUBLISHED, origin.source, origin.date, note),
    )
