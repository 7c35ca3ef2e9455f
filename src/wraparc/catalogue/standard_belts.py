"""What is usual of a belt that only its standard name is known of, each number with its source.

A name states strength, plies and covers. Nothing else of it is standardised: modulus, carcass and
mass are those that makers publish of such belts, marked as estimates, with what they lie between.
What nobody publishes is None.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from wraparc.catalogue.belt_names import (
    AMBIGUOUS,
    PIW,
    PIW_SAFETY,
    STEEL,
    BeltName,
    parse_belt_name,
)
from wraparc.catalogue.catalogue_belt import CatalogueBelt
from wraparc.errors import Problem, shown
from wraparc.provenance import Kind, Provenance


class Usual(NamedTuple):
    """A usual value, and the least and the largest that are published."""

    value: float
    least: float
    most: float


#: Modulus over breaking strength [-]. EP of Goodyear (2012, p. 15): 7.0 to 11.9 times ten ratings,
#: the median 7.4 with a weft of polyamide, 11.0 of polyester alone; elongation of 2 % at a tenth of
#: the strength (makers' sheets by DIN 22102) makes 5. NN: 2.5 % there (JD Conveyor), at most 4 %
#: (GB/T 7984), no less than EP. Steel cord: 72 of Goodyear and Sempertrans, 50 by an elongation of
#: 0.2 % (BVH Rubber).
MODULUS = {
    "EP": Usual(7.5, 5.0, 12.0),
    "PN": Usual(7.5, 5.0, 12.0),
    "EE": Usual(10.5, 5.0, 12.0),
    "NN": Usual(4.0, 2.5, 5.0),
    PIW: Usual(7.5, 5.0, 12.0),
    STEEL: Usual(72.0, 50.0, 72.0),
}
_GOODYEAR = "Goodyear EP conveyor belt catalogue"
_FABRIC_MODULUS = f"{_GOODYEAR}, 2012, p. 15; elongation at a tenth of the strength, DIN 22102"
_SOURCES = {
    "EP": _FABRIC_MODULUS,
    "PN": _FABRIC_MODULUS,
    "EE": _FABRIC_MODULUS,
    PIW: _FABRIC_MODULUS,
    "NN": "JD Conveyor, elongation of NN and EP fabric; GB/T 7984, at most 4 %",
    STEEL: f"{_GOODYEAR} (Flexsteel), 2012, p. 71; Sempertrans, data sheet of ST 1000, 2014",
}
#: Breaking strength over rated tension: 10 of textile belts of two and three plies, 9 of more
#: (Neelkanth), 10 of all (Roulunds); 6.67 of steel cord (Goodyear, Forech), 7 (NRC).
SAFETY = {"fabric": Usual(10.0, 8.0, 10.0), "steel cord": Usual(1.0 / 0.15, 1.0 / 0.15, 7.0)}
_SAFETY_SOURCES = {
    "fabric": "Roulunds, conveyor belts, 2001; Neelkanth Beltings, selection chart",
    "steel cord": f"{_GOODYEAR} (Flexsteel), 2012, p. 71; Forech, steel cord belts",
}
#: Thickness of a ply with its rubber, by its strength f [N/mm]: 0.7 mm + 3 um f; published ones
#: are 0.8 to 1.4 of that. Of polyamide 0.85 of it, 0.8 to 1.25 of that.
PLY_THICKNESS, PLY_SLOPE, OF_POLYAMIDE = 0.7e-3, 3e-9, 0.85
PLY_SPREAD, POLYAMIDE_SPREAD = (0.8, 1.4), (0.8, 1.25)
_PLY_SOURCES = {
    "EP": f"Neelkanth Beltings, selection chart; Monster Belting, plies; {_GOODYEAR}, 2012, p. 15",
    "NN": "Tatanka, NN belts; Monster Belting, plies",
}
#: Density of a carcass of plies and their rubber, and of covers [kg/m3]: Goodyear has 1,060 to
#: 1,210 and 1,200, Neelkanth 890 to 930 of the carcass, Phoebus and Roulunds 1,290 of whole belts.
PLIES_DENSITY, COVER_DENSITY = 1100.0, 1200.0
#: Mass of steel cords and of the rubber between them, a ST + b d [kg/m2]: within 7 % of those that
#: Goodyear publishes of ST800 to ST7000; 1,150 kg/m3 of covers.
CORDS_MASS, FILLING_MASS, STEEL_COVER_DENSITY = 3.2e-6, 1250.0, 1150.0
_MASS_SOURCES = {
    "fabric": f"{_GOODYEAR}, 2012, p. 15; Neelkanth Beltings, selection chart",
    "steel cord": f"{_GOODYEAR} (Flexsteel), 2012, p. 71",
}


_COVERS = "covers of the same catalogue"


class Cords(NamedTuple):
    """Diameter of the cords and pitch of their axes [m]; pitch nan where it is not published."""

    diameter: float
    pitch: float
    source: str


_STANDARD = "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber"
_NRC, _FLEXSTEEL = "NRC Industries, steel cord belts", f"{_GOODYEAR} (Flexsteel), 2012, p. 71"
_NAN = float("nan")
#: Cords of belts by type [N/mm].
CORDS = {
    500: Cords(3.7e-3, _NAN, _NRC),
    630: Cords(3.7e-3, _NAN, _NRC),
    800: Cords(3.7e-3, 15e-3, _STANDARD),
    1000: Cords(3.9e-3, 12e-3, _STANDARD),
    1250: Cords(4.7e-3, 14e-3, _STANDARD),
    1400: Cords(4.7e-3, _NAN, _NRC),
    1600: Cords(5.4e-3, 15e-3, _STANDARD),
    1800: Cords(5.4e-3, _NAN, _NRC),
    2000: Cords(5.4e-3, 12e-3, _STANDARD),
    2250: Cords(6.2e-3, _NAN, _NRC),
    2500: Cords(7.0e-3, 15e-3, _STANDARD),
    2800: Cords(7.2e-3, _NAN, _NRC),
    3150: Cords(8.1e-3, 15e-3, _STANDARD),
    3500: Cords(8.6e-3, 15e-3, _STANDARD),
    4000: Cords(8.9e-3, 15e-3, _STANDARD),
    4500: Cords(9.7e-3, 16e-3, _STANDARD),
    5000: Cords(10.9e-3, 17e-3, _STANDARD),
    5400: Cords(11.3e-3, 17e-3, _STANDARD),
    6000: Cords(12.4e-3, 21.6e-3, _FLEXSTEEL),
    6500: Cords(12.4e-3, 20.1e-3, _FLEXSTEEL),
    7000: Cords(12.4e-3, 18.8e-3, _FLEXSTEEL),
}
#: By how much cord diameters of a type differ between makers [-].
CORD_SPREAD = 0.08
#: Least drive pulley over the thickness of the tension member, group A of DIN 22101 [-], and the
#: diameters that it is rounded up to [m].
PULLEY_FACTORS = {"EP": 108.0, "PN": 108.0, "EE": 108.0, PIW: 108.0, "NN": 90.0, STEEL: 145.0}
PULLEY_SIZES = (
    0.2, 0.25, 0.315, 0.4, 0.5, 0.63, 0.8, 1.0, 1.25, 1.4, 1.6, 1.8, 2.0,
)  # fmt: skip


def standard_belt(name: str) -> CatalogueBelt | None:
    """Return what is known of a belt by its standard name; None of any other name.

    Raises
    ------
    InputError
        Of a name with a typing slip, with the nearest names.
    """
    of = parse_belt_name(name)
    if of is None:
        return None
    kind = "steel cord" if of.is_steel else "fabric"
    strength, rating, sources = _tensions(of, kind)
    modulus, ends = _NAN, None
    if of.carcass in MODULUS:
        over = MODULUS[of.carcass]
        modulus, ends = strength * over.value, (strength * over.least, strength * over.most)
        note = f"{over.value:g} times the strength, published {over.least:g} to {over.most:g}"
        sources["modulus"] = _estimated(_SOURCES[of.carcass], note)
    found = CatalogueBelt(
        name=" ".join(name.split()),
        kind=kind,
        rating=rating,
        modulus=modulus,
        modulus_ends=ends,
        strength=strength,
        pulley_cover=_known(of.pulley_cover),
        carry_cover=_known(of.carry_cover),
        provenance=Provenance(note=f"by its name: {of.standard}"),
        sources=sources,
    )
    found = _with_cords(found, strength) if of.is_steel else _with_plies(found, of, strength)
    return _with_pulley(found, of.carcass)


def modulus_problem(belt: CatalogueBelt) -> Problem | None:
    """Return what to ask of a belt whose modulus nobody publishes, None of any other."""
    if belt.modulus == belt.modulus:
        return None
    of = parse_belt_name(belt.name)
    if of is None:
        return None
    size = f"{1e-3 * of.strength:g}/{of.plies}"
    options = [shown(f"{carcass} {size}") for carcass in AMBIGUOUS.get(of.carcass, ())]
    return Problem(
        message=f"warp of {of.carcass} is polyester or polyamide",
        remedy=f"Write {' or '.join(options)}, or give modulus or elongation.",
        value=shown(belt.name),
    )


def _known(value: float) -> float | None:
    return value if value == value else None


def _estimated(source: str, note: str) -> Provenance:
    return Provenance(Kind.PUBLISHED, source, note=f"estimated: {note}")


def _tensions(of: BeltName, kind: str) -> tuple[float, float, dict[str, Provenance]]:
    """Return strength and rated tension [N/m], and where that comes from which the name lacks."""
    if of.carcass == PIW:
        source = "CWP and Skecon, conveyor belt strength"
        note = f"{PIW_SAFETY:g} times the rated tension, makers have 8 to 10"
        return PIW_SAFETY * of.rating, of.rating, {"strength": _estimated(source, note)}
    safety = SAFETY[kind]
    note = f"strength over {safety.value:.3g}, makers have {safety.least:.3g} to {safety.most:.3g}"
    rating = {"rating": _estimated(_SAFETY_SOURCES[kind], note)}
    return of.strength, of.strength / safety.value, rating


def _with_plies(belt: CatalogueBelt, of: BeltName, strength: float) -> CatalogueBelt:
    """Return the belt with the carcass of its plies."""
    if of.plies == 0:
        return belt
    share, spread, key = 1.0, PLY_SPREAD, "EP"
    if of.carcass == "NN":
        share, spread, key = OF_POLYAMIDE, POLYAMIDE_SPREAD, "NN"
    elif of.carcass in AMBIGUOUS:
        spread = (POLYAMIDE_SPREAD[0] * OF_POLYAMIDE, PLY_SPREAD[1])
    ply = share * (PLY_THICKNESS + PLY_SLOPE * strength / of.plies)
    thickness = round(1e4 * of.plies * ply) / 1e4  # to 0.1 mm
    note = f"by plies and their strength, published {spread[0]:.2g} to {spread[1]:.3g} of it"
    mass = f"{1e-3 * PLIES_DENSITY:g} kg/m2 a mm of carcass, published 0.9 to 1.25"
    return replace(
        belt,
        carcass=thickness,
        carcass_ends=(spread[0] * thickness, spread[1] * thickness),
        carcass_mass=PLIES_DENSITY * thickness,
        cover_mass=COVER_DENSITY,
        sources={
            **belt.sources,
            "carcass": _estimated(_PLY_SOURCES[key], note),
            "carcass_mass": _estimated(_MASS_SOURCES["fabric"], mass),
            "cover_mass": _estimated(_MASS_SOURCES["fabric"], _COVERS),
        },
    )


def _with_cords(belt: CatalogueBelt, strength: float) -> CatalogueBelt:
    """Return the belt with its cords, where they are published."""
    cords = CORDS.get(round(1e-3 * strength))
    if cords is None:
        return belt
    sources = {
        **belt.sources,
        "carcass": _estimated(
            cords.source, f"cord diameter, makers differ by {100.0 * CORD_SPREAD:g} %"
        ),
        "carcass_mass": _estimated(_MASS_SOURCES["steel cord"], "by strength and cords, to 7 %"),
        "cover_mass": _estimated(_MASS_SOURCES["steel cord"], _COVERS),
    }
    if _known(cords.pitch) is not None:
        sources["cord_pitch"] = _estimated(cords.source, "cord pitch, makers differ")
    return replace(
        belt,
        carcass=cords.diameter,
        carcass_ends=((1.0 - CORD_SPREAD) * cords.diameter, (1.0 + CORD_SPREAD) * cords.diameter),
        cord_pitch=_known(cords.pitch),
        carcass_mass=CORDS_MASS * strength + FILLING_MASS * cords.diameter,
        cover_mass=STEEL_COVER_DENSITY,
        sources=sources,
    )


def _with_pulley(belt: CatalogueBelt, carcass: str) -> CatalogueBelt:
    """Return the belt with its least drive pulley by DIN 22101, rounded up."""
    if belt.carcass is None or carcass not in PULLEY_FACTORS:
        return belt
    least = PULLEY_FACTORS[carcass] * belt.carcass
    sizes = [size for size in PULLEY_SIZES if size >= least - 1e-9]
    if not sizes:
        return belt
    note = f"{PULLEY_FACTORS[carcass]:g} times the thickness of the tension member, rounded up"
    source = {"least_pulley_diameter": _estimated("DIN 22101, group A", note)}
    return replace(belt, least_pulley_diameter=sizes[0], sources={**belt.sources, **source})
