"""The conveyor belt, as far as a drive pulley feels it."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar, Literal

from wraparc.catalogue.belt_modulus import measurement_problems
from wraparc.errors import Problem
from wraparc.provenance import Provenance
from wraparc.schema.limits import Limit, limit_problems, name_problems, raise_all
from wraparc.schema.uncertain import uncertainty_problems
from wraparc.units import display

Side = Literal["pulley", "carry"]
#: Sides of a belt: that of the return idlers and most drive pulleys, and that of the load.
SIDES: tuple[Side, ...] = ("pulley", "carry")
#: Shear modulus of a belt cover where none is given [Pa], an estimate, and what it lies between.
COVER_SHEAR_MODULUS, COVER_SHEAR_BAND = 1.0e6, (0.8e6, 1.5e6)
MOST_THICKNESS = 0.06  # of a belt [m]
#: Numbers that have an uncertainty.
UNCERTAIN_OF_BELT = ("modulus",)
MOST_PITCH = 0.1  # of its cords [m]
#: Layers of a belt, by key, and the key of their sum.
LAYERS, THICKNESS = ("pulley_cover", "carry_cover", "carcass"), "thickness"
#: Pound-force an inch [N/m]: ratings of American belts stand in their names, 1000/4, by it.
_PIW = 4.4482216152605 / 0.0254


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
    modulus_test, modulus_loads
        How it was measured, one of `MODULUS_TESTS` or empty where that is not stated; lowest and
        highest load of the measurement over the breaking strength [-], or None.
    modulus_ends
        Least and largest modulus published of belts of this name [N/m], where it is a usual one of
        these, or None.
    rating
        Rated (operating) tension per unit width [N/m], or None.
    strength
        Breaking strength per unit width [N/m], or None; names like ST2000 and EP 630/4 tell it.
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
    pulley_cover, carry_cover
        Cover on the side of the pulley, and on the side that carries the load [m], or None.
    carcass
        Thickness of the carcass, or diameter of the cords [m], or None.
    carcass_ends
        Least and largest carcass published of belts of this name [m], where it is a usual one of
        these, or None.
    thickness
        Of the whole belt [m], or None: what is not given of the layers follows from it.
    cover_shear_modulus
        Shear modulus of the covers [Pa], or None for an estimate.
    cord_diameter, cord_pitch
        Of steel cords: diameter, and distance from axis to axis [m], or None. The diameter is the
        carcass, and either stands for the other.
    mass
        Per length of belt [kg/m], or None.
    uncertainty
        How far single numbers may be off either way (95 %), by field: `UNCERTAIN_OF_BELT` [-].
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
        "width": Limit("length", least=1e-3, most=10.0),
        "modulus": Limit("force_per_width", least=1e3, rigid=True),
        "rating": Limit("force_per_width", open=True),
        "strength": Limit("force_per_width", open=True),
        "speed": Limit("speed", open=True, most=1e3),
        "momentary_factor": Limit("number", least=1.0, most=10.0),
        "least_pulley_diameter": Limit("length", open=True),
        "largest_wrap_pressure": Limit("pressure", open=True),
        "in_plane_shear_stiffness": Limit("force_per_width", least=1.0, most=1e9),
        "pulley_cover": Limit("length", most=MOST_THICKNESS),
        "carry_cover": Limit("length", most=MOST_THICKNESS),
        "carcass": Limit("length", open=True, most=MOST_THICKNESS),
        "thickness": Limit("length", open=True, most=MOST_THICKNESS),
        "cover_shear_modulus": Limit("pressure", least=1e5, most=1e8, rigid=True),
        "cord_diameter": Limit("length", open=True, most=MOST_THICKNESS),
        "cord_pitch": Limit("length", open=True, most=MOST_PITCH),
        "mass": Limit("mass_per_length", open=True, most=1e6),
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
    pulley_cover: float | None = None
    carry_cover: float | None = None
    carcass: float | None = None
    thickness: float | None = None
    cover_shear_modulus: float | None = None
    cord_diameter: float | None = None
    cord_pitch: float | None = None
    mass: float | None = None
    modulus_test: str = ""
    modulus_loads: tuple[float, float] | None = None
    modulus_ends: tuple[float, float] | None = None
    carcass_ends: tuple[float, float] | None = None
    uncertainty: Mapping[str, float] = field(default_factory=dict, hash=False)
    provenance: Provenance = field(default_factory=Provenance)
    sources: Mapping[str, Provenance] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        problems = name_problems("name", self.name) + limit_problems(self, self.LIMITS)
        problems += measurement_problems(self.modulus_test, self.modulus_loads)
        problems += uncertainty_problems(self.uncertainty, UNCERTAIN_OF_BELT)
        raise_all(problems or self._cord_problems() or self._layer_problems())

    def _cord_problems(self) -> list[Problem]:
        """Return what contradicts in diameter and pitch of the cords."""
        diameter, pitch, carcass = self.cord_diameter, self.cord_pitch, self.carcass
        if diameter is not None and carcass is not None and abs(diameter - carcass) > 1e-6:
            message = f"must equal the carcass {display(carcass, 'length')}"
            value, remedy = display(diameter, "length"), "Leave one of them out."
            return [Problem(message=message, remedy=remedy, key="cord_diameter", value=value)]
        cord = self.cord
        if pitch is None:
            return []
        if cord is None:
            remedy = 'Write cord_diameter = "5.6 mm", or leave cord_pitch out.'
            return [Problem(message="needs cord_diameter", remedy=remedy, key="cord_pitch")]
        if pitch <= cord:
            message = f"must be more than the cord diameter {display(cord, 'length')}"
            value, remedy = display(pitch, "length"), "Give the distance between cord axes."
            return [Problem(message=message, remedy=remedy, key="cord_pitch", value=value)]
        return []

    def _layer_problems(self) -> list[Problem]:
        """Return what is wrong with the layers together."""
        of = {key: getattr(self, key) for key in LAYERS} | {"carcass": self.cord}
        known = {key: value for key, value in of.items() if value is not None}
        total, whole, layers = sum(known.values()), self.thickness, " + ".join(known)
        if whole is None:
            if total <= MOST_THICKNESS:
                return []
            message = f"{layers} must be at most {display(MOST_THICKNESS, 'length')}"
            key, value, remedy = next(iter(known), THICKNESS), total, "Check their units."
        else:
            key, value, rounding = THICKNESS, whole, 1e-9 * whole
            # a cover may be nothing, a carcass may not
            least, sign = ("at least", 1.0) if self.cord is not None else ("more than", -1.0)
            thin = len(known) == len(LAYERS) and total < 0.98 * whole
            if total <= whole + sign * rounding and not thin:
                return []
            message = (
                f"must be {'at most' if thin else least} {layers} = {display(total, 'length')}"
            )
            remedy = "Leave one out." if thin else "Correct or omit it."
        return [Problem(message=message, remedy=remedy, key=key, value=display(value, "length"))]

    @property
    def is_uncertain(self) -> bool:
        """Whether it is stated or published how far one of its numbers may be off."""
        by_name = self.modulus_ends is not None or self.carcass_ends is not None
        return by_name or len(self.uncertainty) > 0

    @property
    def cord(self) -> float | None:
        """Thickness of the carcass, or diameter of the cords [m]; None where neither is known."""
        return self.carcass if self.cord_diameter is None else self.cord_diameter

    def source_of(self, part: str) -> Provenance:
        """Return where one number came from: its own source, else the belt's."""
        return self.sources.get(part, self.provenance)

    @property
    def breaking_strength(self) -> float | None:
        """Breaking strength per unit width [N/m].

        As given, or as a name tells: ``ST2000`` of steel cord, ``EP 630/4`` and ``630/4`` of fabric
        in N/mm; a name of digits alone may state an American rating instead, in lbf/in, and one
        with PIW does.
        """
        found = re.search(
            r"(?:ST[ -]?|(?:\b(?:EP|EE|NN|PN|NP|PP|EB)[ -]?|^)(?=\d+/\d))(\d{3,5})\b",  # DIN 22102
            self.name.strip().upper(),
        )
        if self.strength is not None or found is None or "PIW" in self.name.upper():
            return self.strength
        told = float(found[1])
        bare = self.name.strip().startswith(found[1])
        if bare and self.rating is not None and abs(self.rating / (told * _PIW) - 1.0) < 0.02:
            return None
        return 1e3 * told

    @property
    def axial_stiffness(self) -> float:
        """EA = M B [N]."""
        return self.modulus * self.width
