"""Effective compression modulus of lagging blocks."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, Literal

from wraparc.arrays import Number
from wraparc.errors import Problem, shown
from wraparc.schema.limits import Limit, limit_problems, raise_all

Shape = Literal["square", "strip"]
SHAPES: tuple[Shape, ...] = ("square", "strip")


@dataclass(frozen=True, kw_only=True)
class Block:
    """The rubber blocks that carry the wrap pressure, bonded below and held by friction above.

    Parameters
    ----------
    shape
        ``square`` in plan, or ``strip`` (much longer than wide).
    width
        Side of the square, width of the strip [m].
    height
        Height of the rubber that is compressed [m].
    stiffening
        k, Gent's numerical factor: 1 for unfilled rubber, falling to about 0.5 for hard
        filled compounds (0.57 at 60 IRHD, 0.54 at 65, 0.53 at 70) [-].
    contact_fraction
        f, part of the wrap area that the blocks cover [-]: they bear p/f and tau/f, so that the
        compression modulus and the shear modulus over the gross area are f times theirs. A shear
        modulus has no shape factor; grooves are taken as deep as the lagging is thick.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "width": Limit("length", least=1e-4, most=10.0),
        "height": Limit("length", least=1e-4, most=1.0),
        "stiffening": Limit("number", most=10.0),
        "contact_fraction": Limit("number", least=0.01, most=1.0),
    }

    shape: Shape = "square"
    width: float
    height: float
    stiffening: float = 0.54
    contact_fraction: float = 1.0

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        if self.shape not in SHAPES:
            message = f"must be one of {', '.join(SHAPES)}"
            problems.append(Problem(key="shape", value=shown(self.shape), message=message))
        raise_all(problems)

    @property
    def shape_factor(self) -> float:
        """S, loaded area over the area free to bulge [-]: a/(4 h) square, w/(2 h) strip."""
        factor: float = shape_factor(self.shape == "square", self.width, self.height)
        return factor


def compression_modulus(elastic_modulus: float, block: Block) -> float:
    """Effective compression modulus of a lagging over its gross area [Pa].

    E_c = f E (1 + 2 k S^2) for square blocks, f (4/3) E (1 + k S^2) for long strips, with
    the contact fraction f, the shape factor S and the stiffening factor k.

    Parameters
    ----------
    elastic_modulus
        Young's modulus E of the rubber [Pa].
    block
        Shape of the blocks.

    Notes
    -----
    An estimate: small strain (below about 10 %), S up to about 3 (beyond, the bulk
    modulus of rubber counts), upper faces held by friction.

    References
    ----------
    A. N. Gent and P. B. Lindley, "The compression of bonded rubber blocks", Proc. Inst.
    Mech. Engrs. 173 (1959) 111-122; P. B. Lindley, "Engineering Design with Natural
    Rubber", MRPRA Technical Bulletin, 4th ed. (1978), for k by hardness.
    """
    square = block.shape == "square"
    modulus: float = block_modulus(
        elastic_modulus, square, block.width, block.height, block.stiffening, block.contact_fraction
    )
    return modulus


def shape_factor(square: bool, width: float, height: Number) -> Number:
    """S, loaded area over the area free to bulge [-]: a/(4 h) square, w/(2 h) strip."""
    return width / ((4.0 if square else 2.0) * height)


def block_modulus(
    elastic_modulus: float, square: bool, width: float, height: Number, k: float, contact: float
) -> Number:
    """Effective compression modulus by plain numbers, see `compression_modulus` [Pa]."""
    s2 = shape_factor(square, width, height) ** 2
    if square:
        return contact * elastic_modulus * (1.0 + 2.0 * k * s2)
    return contact * (4.0 / 3.0) * elastic_modulus * (1.0 + k * s2)
