"""What the travel of a take-up is made of, and what the pull by CEMA needs."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from wraparc.schema.limits import Limit, limit_problems, raise_all


@dataclass(frozen=True, kw_only=True)
class Travel:
    """What the travel of a take-up is made of besides the elastic elongation.

    Parameters
    ----------
    temperature_range
        Between the coldest and the warmest belt [K].
    thermal_expansion
        Of the belt per kelvin [1/K]: no standard has one of fabric; steel expands by 12e-6.
    permanent_elongation
        Of the belt in its life, over its length [-].
    splice_length
        Belt that is kept for new splices [m].
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "temperature_range": Limit("number", most=200.0),
        "thermal_expansion": Limit("number", most=1e-3),
        "permanent_elongation": Limit("number", most=0.1),
        "splice_length": Limit("length", most=1e3),
    }

    temperature_range: float | None = None
    thermal_expansion: float | None = None
    permanent_elongation: float | None = None
    splice_length: float | None = None

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))

    @property
    def thermal(self) -> float | None:
        """Thermal strain of the belt [-], None where it is not known."""
        if self.temperature_range is None or self.thermal_expansion is None:
            return None
        return self.temperature_range * self.thermal_expansion


@dataclass(frozen=True, kw_only=True)
class Cema:
    """What the effective tension by CEMA needs besides.

    Parameters
    ----------
    idler_friction
        Ai: force that one carrying idler takes to turn [N]. CEMA: 1.5 lbf of 6 in rolls, 1.8 lbf
        of 5 in, 2.3 lbf of 4 in.
    temperature_factor
        Kt [-]; 1 above freezing.
    ky
        Ky of the carrying strand [-]: 0.016 to 0.035 by belt tension, load, slope and length.
    other
        Accessories, pulleys and loading together [N].
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "idler_friction": Limit("force", open=True, most=1e3),
        "temperature_factor": Limit("number", least=1.0, most=4.0),
        "ky": Limit("number", open=True, most=0.1),
        "other": Limit("force", most=1e8),
    }

    idler_friction: float
    temperature_factor: float = 1.0
    ky: float
    other: float = 0.0

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))
