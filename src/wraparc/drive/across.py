"""What is uneven across the width of a pulley and its belt."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from itertools import pairwise
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arrays import Array
from wraparc.errors import Problem, shown
from wraparc.friction.interpolation import evaluate, pchip
from wraparc.schema.limits import Limit, limit_problems, raise_all
from wraparc.units import display

Depth = Literal["full", "half"]
DEPTHS: tuple[Depth, ...] = ("full", "half")
FEWEST_STRIPS, MOST_STRIPS = 4, 128


@dataclass(frozen=True, kw_only=True)
class WidthProfile:
    """A quantity over the width: a parabola, or rows that are interpolated monotonically.

    Parameters
    ----------
    position
        Places across the belt, ascending, 0 in its middle [m].
    value
        The quantity there [SI]; beyond the outermost rows it is held.
    crown
        Height of a parabola in the middle over the edges of the belt [SI], added to the rows.
    uncertainty
        Standard uncertainty of the values [SI], or None where it is not known.

    Raises
    ------
    InputError
        If the rows are not finite and in order.
    """

    position: tuple[float, ...] = ()
    value: tuple[float, ...] = ()
    crown: float = 0.0
    uncertainty: float | None = None

    def __post_init__(self) -> None:
        problems = []
        numbers = (*self.position, *self.value, self.crown)
        if not all(map(math.isfinite, numbers)) or len(self.position) != len(self.value):
            message = "must be pairs of finite numbers, position and value"
            problems.append(Problem(key="rows", value=str(len(self.position)), message=message))
        elif len(self.position) == 1:
            message = "one row alone makes no profile"
            problems.append(Problem(key="rows", message=message, remedy="Give two rows or more."))
        wrong = [b for a, b in pairwise(self.position) if b <= a]
        if wrong:
            problems.append(
                Problem(
                    key="rows",
                    value=display(wrong[0], "length"),
                    message="the positions must ascend",
                    remedy="Sort the rows by position, the middle of the belt being 0.",
                )
            )
        raise_all(problems)

    def at(self, position: ArrayLike, width: float) -> Array:
        """Return the quantity at places across a belt of a width [SI], shape of `position`."""
        y = np.asarray(position, dtype=float)
        out: Array = self.crown * (1.0 - (2.0 * y / width) ** 2)
        if self.position:
            x, v = np.array(self.position), np.array(self.value)
            out = out + evaluate(x, pchip(x, v), np.clip(y, x[0], x[-1]))
        return out

    @property
    def largest(self) -> float:
        """Largest value, the crown added to the largest row [SI]."""
        return max((*self.value, 0.0)) + max(self.crown, 0.0)

    def problems(self, key: str, width: float) -> list[Problem]:
        """Return a problem if rows lie beyond the edges of a belt of a width."""
        edge = 0.5 * width * (1.0 + 1e-9)
        beyond = [y for y in self.position if abs(y) > edge]
        if not beyond:
            return []
        return [
            Problem(
                key=key,
                value=display(beyond[0], "length"),
                message=f"must be between {display(-0.5 * width, 'length')} "
                f"and {display(0.5 * width, 'length')}, the edges",
                remedy="Give positions from the middle of the belt.",
            )
        ]


@dataclass(frozen=True, kw_only=True)
class GrippingPulley:
    """An even pulley at the far end of a span, which grips the belt.

    Parameters
    ----------
    distance
        Length of the span from tangent to tangent [m].
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {"distance": Limit("length", open=True, most=1e5)}

    distance: float

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))


@dataclass(frozen=True, kw_only=True)
class Transition:
    """The trough transition before a pulley.

    Parameters
    ----------
    length
        From the last full trough to the pulley [m].
    trough_angle
        beta of the wing rolls [rad].
    centre_roll
        Width of belt that lies on the centre roll [m].
    depth
        ``full``: the pulley stands level with the centre roll; ``half``: it is raised by half the
        depth of the trough.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "length": Limit("length", open=True, most=1e3),
        "trough_angle": Limit("angle", open=True, most=0.5 * math.pi),
        "centre_roll": Limit("length", most=1e2),
    }

    length: float
    trough_angle: float
    centre_roll: float
    depth: Depth = "full"

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        if self.depth not in DEPTHS:
            message = f"must be one of {', '.join(DEPTHS)}"
            problems.append(Problem(key="depth", value=shown(self.depth), message=message))
        raise_all(problems)


@dataclass(frozen=True, kw_only=True)
class Across:
    """What is uneven across the width, of a pulley and the belt on it.

    Parameters
    ----------
    shell_profile
        Radius of the shell over its mean: crown, out of true [m]; None for an even one.
    worn_depth
        Depth worn off the lagging [m].
    build_up
        Material stuck to the pulley, or more cover on the belt: adds to the radius alone [m].
    misalignment
        Skew of the pulley in the plane of the bisector of its wrap [m per m of width].
    deflection
        How far the middle of the face is pulled in by the belt, relative to its edges [m].
    entry_profile
        Deviation of the tension far before the pulley, from horizontal curves or uneven pull
        [N/m].
    before, after
        Far ends of the spans; None where they are far away.
    strips
        Strips that the belt is cut into.

    Raises
    ------
    InputError
        With every number outside its limit.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "misalignment": Limit("number", least=-0.1, most=0.1),
        "deflection": Limit("length", least=-0.1, most=0.1),
    }

    shell_profile: WidthProfile | None = None
    worn_depth: WidthProfile | None = None
    build_up: WidthProfile | None = None
    misalignment: float = 0.0
    deflection: float = 0.0
    entry_profile: WidthProfile | None = None
    before: GrippingPulley | Transition | None = None
    after: GrippingPulley | None = None
    strips: int = 32

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        if not FEWEST_STRIPS <= self.strips <= MOST_STRIPS:
            message = f"must be a whole number from {FEWEST_STRIPS} to {MOST_STRIPS}"
            problems.append(Problem(key="strips", value=str(self.strips), message=message))
        for key in ("worn_depth", "build_up"):
            profile = getattr(self, key)
            if profile is not None and min((*profile.value, profile.crown)) < 0.0:
                least = display(min((*profile.value, profile.crown)), "length")
                message = "must not be negative"
                problems.append(Problem(key=key, value=least, message=message))
        raise_all(problems)

    def profiles(self) -> dict[str, WidthProfile]:
        """Return the profiles that are there, by name."""
        found = {f.name: getattr(self, f.name) for f in fields(self)}
        return {k: v for k, v in found.items() if isinstance(v, WidthProfile)}

    def problems(self, key: str, width: float) -> list[Problem]:
        """Return what does not fit a belt of a width [m]."""
        found = [
            problem
            for name, profile in self.profiles().items()
            for problem in profile.problems(f"{key}.{name}", width)
        ]
        if isinstance(self.before, Transition) and self.before.centre_roll >= width:
            found.append(
                Problem(
                    key=f"{key}.before.centre_roll",
                    value=display(self.before.centre_roll, "length"),
                    message=f"must be less than the belt width {display(width, 'length')}",
                    remedy="Give the width of belt on the centre roll.",
                )
            )
        return found
