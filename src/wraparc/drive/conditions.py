"""Wet, dirty, worn: friction laws in conditions they were not tested in.

Laws of laggings are measured dry. What water and dirt take away is known of constant design
values only, so a law is scaled as a whole by a stated factor, with the place it came from.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from wraparc.catalogue import DesignFriction, design_friction
from wraparc.drive import Lagging
from wraparc.errors import InputError, Problem, shown
from wraparc.provenance import Kind, Provenance

DRY = "dry"


@dataclass(frozen=True, kw_only=True)
class Condition:
    """A state of the surfaces in which a drive has to work.

    Attributes
    ----------
    name
        ``dry``, ``wet``, ``wet and dirty`` ...
    factor
        Friction over the friction of the tested law [-], or None where `factors` or `standard`
        says it.
    factors
        The same by surface (``rubber``, ``ceramic`` ...), before `factor`.
    standard
        Design values whose ratio, this condition over dry, is the factor; `source` is then theirs.
    source
        Where the factors came from.
    """

    name: str
    factor: float | None = None
    factors: Mapping[str, float] = field(default_factory=dict, hash=False)
    standard: str = ""
    source: Provenance = field(default_factory=Provenance)

    def lagging(self, lagging: Lagging) -> Lagging:
        """Return a lagging in this condition.

        A lagging that was tested in it is returned as it is, any other with its law scaled.

        Raises
        ------
        InputError
            If no factor is stated for it.
        """
        if lagging.condition == self.name:
            return lagging
        factor, source = self.factor_of(lagging)
        return replace(
            lagging,
            law=lagging.law.scaled(factor),
            condition=self.name,
            sources={**lagging.sources, "law": source},
            fit=None,
            notes=(*lagging.notes, f"{self.name}: friction {factor:.3g} of {lagging.condition}"),
        )

    def factor_of(self, lagging: Lagging) -> tuple[float, Provenance]:
        """Friction factor for a lagging [-], and where it came from."""
        if lagging.surface in self.factors:
            return self.factors[lagging.surface], self.source
        if self.standard:
            return design_ratio(self.standard, lagging.surface, self.name)
        if self.factor is not None:
            return self.factor, self.source
        if self.name == DRY:
            return 1.0, Provenance()
        raise InputError(
            Problem(
                key=f"condition.{self.name}",
                message=f"lagging {shown(lagging.name)} was tested {lagging.condition}, and "
                f"nothing is said of its friction when {self.name}",
                remedy='Write friction_factor = 0.8, or standard = "DIN 22101" for the ratio of '
                "its design values.",
            )
        )


def design_ratio(standard: str, surface: str, condition: str) -> tuple[float, Provenance]:
    """Friction in a condition over dry friction, by the design values of a standard [-].

    The middle of the published values is taken: a ratio of constant coefficients, stretched here
    to a whole friction law, which nobody has measured.

    Raises
    ------
    InputError
        If the standard has no value for the surface in the condition, or dry.
    """
    there = [d for d in design_friction() if d.standard == standard and d.surface == surface]
    here = next((d for d in there if d.condition == condition), None)
    dry = next((d for d in there if d.condition == DRY), None)
    if here is None or dry is None:
        known = sorted({d.standard for d in design_friction() if d.condition})
        raise InputError(
            Problem(
                key=f"condition.{condition}",
                value=shown(standard),
                message=f"no design values of surface {shown(surface)} both dry and {condition}",
                remedy=f"{', '.join(known)} have dry, wet, and wet and dirty; or state a factor.",
            )
        )
    note = (
        f"{surface} {condition} {_ends(here)} over dry {_ends(dry)}, middle values; a ratio of "
        "constant design values applied to the whole law"
    )
    source = Provenance(Kind.PUBLISHED, here.provenance.source, here.provenance.date, note)
    return sum(here.friction) / sum(dry.friction), source


def _ends(design: DesignFriction) -> str:
    low, high = design.friction
    return f"{low:g}" if low == high else f"{low:g}-{high:g}"
