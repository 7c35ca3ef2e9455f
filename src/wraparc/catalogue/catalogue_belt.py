"""A belt as a maker publishes it, or as its standard name tells it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from wraparc.provenance import Provenance


@dataclass(frozen=True, kw_only=True)
class CatalogueBelt:
    """A belt as a maker publishes it, or as its standard name tells it.

    Parameters
    ----------
    name
        The maker's designation, or a standard name.
    kind
        ``fabric`` or ``steel cord``.
    rating
        Rated (operating) tension per unit width [N/m].
    modulus
        Belt modulus [N/m]; nan where a standard name does not tell the fibre of its carcass.
    modulus_ends
        Least and largest that are published of such belts [N/m], where `modulus` is a usual one.
    strength
        Breaking strength per unit width [N/m], or None to read it from the name.
    least_pulley_diameter
        Smallest drive pulley at 75-100 % of the rating [m], or None if not published.
    pulley_cover, carry_cover
        Covers that the name states [m], or None.
    carcass
        Thickness of the carcass, or diameter of the cords [m], or None if not published.
    carcass_ends
        Least and largest that are published of such belts [m], where `carcass` is a usual one.
    cord_pitch
        Distance between the axes of steel cords [m], or None if not published.
    carcass_mass, cover_mass
        Mass of the carcass [kg/m2], and of the covers per thickness [kg/m3], or None.
    modulus_test, modulus_loads
        How the modulus was measured, see `wraparc.drive.Belt`; empty and None where the maker does
        not state it.
    permanent_elongation
        At the rating [-], or None if not published.
    provenance
        The publication.
    sources
        Where single numbers came from, by field, if elsewhere.
    """

    name: str
    kind: str
    rating: float
    modulus: float
    modulus_ends: tuple[float, float] | None = None
    strength: float | None = None
    least_pulley_diameter: float | None = None
    pulley_cover: float | None = None
    carry_cover: float | None = None
    carcass: float | None = None
    carcass_ends: tuple[float, float] | None = None
    cord_pitch: float | None = None
    carcass_mass: float | None = None
    cover_mass: float | None = None
    modulus_test: str = ""
    modulus_loads: tuple[float, float] | None = None
    permanent_elongation: float | None = None
    provenance: Provenance
    sources: Mapping[str, Provenance] = field(default_factory=dict, hash=False)
