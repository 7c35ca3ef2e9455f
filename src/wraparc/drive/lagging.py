"""The lagging of a pulley: its friction law, its elasticity, and where they came from."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np

from wraparc.arrays import Array
from wraparc.drive.compression import Block, block_modulus, compression_modulus
from wraparc.drive.factors import ConditionFactor, Factors
from wraparc.drive.fit import Fit
from wraparc.errors import Problem, shown
from wraparc.friction import LAGGING_SHEAR, FrictionLaw
from wraparc.provenance import Provenance
from wraparc.schema.limits import Limit, limit_problems, name_problems, raise_all
from wraparc.schema.uncertain import uncertainty_problems
from wraparc.views import Viewable

#: Surfaces that published design values of friction are given for.
SURFACES = ("bare", "rubber", "polyurethane", "ceramic")
#: Numbers that have an uncertainty; friction and slip are factors on the law.
UNCERTAIN_OF_LAGGING = ("friction", "slip", "thickness", "shear_modulus", "compression_modulus")
_FITTED = "contradicts the fit of the law, which has an interval"


@dataclass(frozen=True, kw_only=True)
class Cost:
    """What a lagging costs on one pulley.

    Parameters
    ----------
    material, installation
        Price of the lagging and of putting it on [currency].
    currency
        For example ``AUD``.
    area
        Lagged area the prices are for [m2].
    life_years
        Shortest and longest expected life [years].
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "material": Limit("number"),
        "installation": Limit("number"),
        "area": Limit("area", open=True),
    }

    material: float
    installation: float
    currency: str
    area: float
    life_years: tuple[float, float]

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        years = self.life_years
        if not (0.0 < years[0] <= years[1] < math.inf):
            message = "must be the shortest and the longest life in years, both more than 0"
            problems.append(Problem(key="life_years", value=shown(list(years)), message=message))
        raise_all(problems)


@dataclass(frozen=True, kw_only=True)
class Lagging(Viewable):
    """A lagging in one condition (dry, wet ...).

    Parameters
    ----------
    name
        Name it is asked for by.
    law
        Friction law mu(x, p).
    thickness
        Thickness h that shears [m]; 0 for a surface that does not.
    shear_modulus
        Effective shear modulus G over the gross area [Pa]: f times that of the rubber, G_r, where
        blocks cover the fraction f of it, which bear tau/f: tan(gamma) = tau/(f G_r). Infinite if
        the lagging does not shear.
    compression_modulus
        Effective compression modulus E_c over the gross area [Pa].
    title
        Name in words.
    condition
        State of the surface the law holds for.
    surface
        Material that touches the belt, to find published design values for comparison:
        ``bare``, ``rubber``, ``polyurethane``, ``ceramic`` or empty.
    elastic_modulus
        Young's modulus E of the rubber [Pa], or None.
    wear_coefficient
        Worn volume per frictional energy [m3/J], or None.
    belt_energy_share
        Part of the frictional energy that the belt takes, the lagging taking the rest [-], or None.
    bond_strength
        Shear stress that the lagging and its bond may bear steadily [Pa], or None.
    fatigue_limit
        Shear stress that they may bear at every pass of the belt [Pa], or None.
    cost
        Prices and life, or None.
    fit
        Statistics of the fitted law, or None.
    factors
        Factors of slip speed and temperature that the tested law was multiplied by, or None.
    condition_factors
        Friction in other conditions over that of this law, by condition.
    block
        Blocks that the compression modulus was estimated from, or None: how it follows a worn
        thickness. It is no part of what makes two laggings equal.
    replaced_block
        Blocks of a preset whose compression modulus another was given for, or None: they shear on.
    uncertainty
        How far single numbers may be off either way (95 %), by field, and friction and slip of the
        law: `UNCERTAIN_OF_LAGGING` [-].
    provenance
        Where the lagging's numbers came from.
    sources
        Where single numbers came from, by field (``law``, ``thickness`` ...), if elsewhere.
    scaled_by
        Factor on the friction of the law that was tested, where the law is scaled by it [-].
    notes
        What a reader must know.
    description
        What it looks like.

    Raises
    ------
    InputError
        With every number outside its limit.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "thickness": Limit("length", most=1.0),
        "shear_modulus": Limit("pressure", least=1e3, rigid=True),
        "compression_modulus": Limit("pressure", least=1e3, rigid=True),
        "elastic_modulus": Limit("pressure", least=1e3),
        "wear_coefficient": Limit("wear_coefficient", most=1.0),
        "belt_energy_share": Limit("number", most=1.0),
        "bond_strength": Limit("pressure", open=True),
        "fatigue_limit": Limit("pressure", open=True),
    }

    name: str
    law: FrictionLaw
    thickness: float = 0.0
    shear_modulus: float = math.inf
    compression_modulus: float = math.inf
    title: str = ""
    condition: str = "dry"
    surface: str = ""
    elastic_modulus: float | None = None
    wear_coefficient: float | None = None
    belt_energy_share: float | None = None
    bond_strength: float | None = None
    fatigue_limit: float | None = None
    cost: Cost | None = None
    fit: Fit | None = None
    factors: Factors | None = None
    condition_factors: Mapping[str, ConditionFactor] = field(default_factory=dict, hash=False)
    block: Block | None = field(default=None, compare=False)
    replaced_block: Block | None = field(default=None, compare=False)
    uncertainty: Mapping[str, float] = field(default_factory=dict, hash=False)
    provenance: Provenance = field(default_factory=Provenance)
    sources: Mapping[str, Provenance] = field(default_factory=dict, hash=False)
    scaled_by: float | None = None
    notes: tuple[str, ...] = ()
    description: str = ""

    def __post_init__(self) -> None:
        problems = name_problems("name", self.name) + name_problems("condition", self.condition)
        problems += limit_problems(self, self.LIMITS)
        if self.surface and self.surface not in SURFACES:
            message = f"must be one of {', '.join(SURFACES)}"
            problems.append(Problem(key="surface", value=shown(self.surface), message=message))
        problems += uncertainty_problems(self.uncertainty, UNCERTAIN_OF_LAGGING)
        if self.fit is not None:
            problems += [
                Problem(key=f"uncertainty.{key}", message=_FITTED, remedy="Remove one of them.")
                for key in ("friction", "slip")
                if key in self.uncertainty
            ]
        raise_all(problems)

    @property
    def contact_fraction(self) -> float:
        """f, part of the gross area that blocks cover, 1 without blocks [-]."""
        block = self.block or self.replaced_block
        return 1.0 if block is None else block.contact_fraction

    @property
    def shear_compliance(self) -> float:
        """h/G, shear displacement per shear stress beside the slip of the law [m/Pa].

        0 where the slip includes it.
        """
        if LAGGING_SHEAR in (self.law.slip_includes or ()):
            return 0.0
        return self.thickness / self.shear_modulus

    @property
    def compression_compliance(self) -> float:
        """h/E_c, compression per wrap pressure [m/Pa]."""
        return self.thickness / self.compression_modulus

    def compression_modulus_at(self, thickness: Array) -> Array:
        """Return E_c where the lagging has another thickness [Pa], shape of `thickness` [m].

        Blocks that are lower bulge less, E_c follows their shape factor; without blocks it stays.
        """
        if self.block is None or not math.isfinite(self.compression_modulus):
            return np.full(thickness.shape, self.compression_modulus)
        of, usual = self.block, compression_modulus(1.0, self.block)
        heights = np.maximum(of.height + thickness - self.thickness, 1e-4)
        square = of.shape == "square"
        shaped = block_modulus(1.0, square, of.width, heights, of.stiffening, of.contact_fraction)
        return np.asarray(self.compression_modulus * (shaped / usual))

    def with_thickness(self, thickness: float) -> "Lagging":
        """Return the lagging at another thickness [m], E_c by the shape factor of its blocks.

        The blocks grow higher or lower by as much; without blocks E_c stays.
        """
        if thickness == self.thickness or self.block is None:
            return replace(self, thickness=thickness)
        modulus = float(self.compression_modulus_at(np.array([thickness]))[0])
        height = max(self.block.height + thickness - self.thickness, 1e-4)
        block, of = replace(self.block, height=height), self.source_of("compression_modulus")
        note = f"estimated: E_c by the shape of the blocks, S = {block.shape_factor:.3g}"
        sources = {**self.sources, "compression_modulus": replace(of, note=note)}
        return replace(
            self, thickness=thickness, compression_modulus=modulus, block=block, sources=sources
        )

    def source_of(self, part: str) -> Provenance:
        """Return where one number came from: its own source, else the lagging's."""
        return self.sources.get(part, self.provenance)
