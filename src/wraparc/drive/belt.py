"""The conveyor belt, as far as a drive pulley feels it."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from wraparc.provenance import Provenance
from wraparc.schema.limits import Limit, limit_problems, name_problems, raise_all


@dataclass(frozen=True, kw_only=True)
class Belt:
    """A conveyor belt.

    Parameters
    ----------
    name
        Designation of the maker, or a name of one's own.
    width
        Belt width B [m].
    modulus
        Belt modulus M: tension per unit width over strain [N/m].
    rating
        Rated (operating) tension per unit width [N/m], or None.
    strength
        Breaking strength per unit width [N/m], or None; the name of a steel-cord belt tells it.
    speed
        Belt speed [m/s], or None; power and wear need it.
    kind
        Carcass, for example ``fabric`` or ``steel cord``.
    momentary_factor
        Tension allowed while starting and braking over the rating [-], or None where the maker
        does not say: then 1.
    least_pulley_diameter
        Smallest drive pulley at 75-100 % of the rating [m], or None.
    largest_wrap_pressure
        Largest pressure between belt and pulley face, 2 T/(B D) [Pa], or None.
    in_plane_shear_stiffness
        G_b t_b, shear force per width over shear strain in the plane of the belt [N/m], or None to
        estimate it from the carcass; only a belt that is uneven across its width needs it.
    provenance
        Where the numbers came from.
    sources
        Where single numbers came from, by field, if elsewhere.

    Raises
    ------
    InputError
        With every number outside its limit.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "width": Limit("length", least=1e-3, most=1e3),
        "modulus": Limit("force_per_width", least=1e3, rigid=True),
        "rating": Limit("force_per_width", open=True),
        "strength": Limit("force_per_width", open=True),
        "speed": Limit("speed", open=True, most=1e3),
        "momentary_factor": Limit("number", least=1.0, most=10.0),
        "least_pulley_diameter": Limit("length", open=True),
        "largest_wrap_pressure": Limit("pressure", open=True),
        "in_plane_shear_stiffness": Limit("force_per_width", least=1.0, most=1e9),
    }

    name: str
    width: float
    modulus: float
    rating: float | None = None
    strength: float | None = None
    speed: float | None = None
    kind: str = ""
    momentary_factor: float | None = None
    least_pulley_diameter: float | None = None
    largest_wrap_pressure: float | None = None
    in_plane_shear_stiffness: float | None = None
    provenance: Provenance = field(default_factory=Provenance)
    sources: Mapping[str, Provenance] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        raise_all(name_problems("name", self.name) + limit_problems(self, self.LIMITS))

    def source_of(self, part: str) -> Provenance:
        """Return where one number came from: its own source, else the belt's."""
        return self.sources.get(part, self.provenance)

    @property
    def breaking_strength(self) -> float | None:
        """Breaking strength per unit width [N/m]: as given, or as a name like ``ST2000`` tells."""
        found = re.search(r"ST[ -]?(\d{3,5})\b", self.name.upper())
        return 1e3 * float(found[1]) if found and self.strength is None else self.strength

    @property
    def axial_stiffness(self) -> float:
        """EA = M B [N]."""
        return self.modulus * self.width
