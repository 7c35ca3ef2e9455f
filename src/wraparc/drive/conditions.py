"""Wet, dirty, dusty: friction laws in conditions they were not tested in.

Laws of laggings are measured dry. What water and dirt take away is known of constant design
values only, so a law is scaled as a whole: by a factor that its lagging or the drive gives, or by
the ratio of published design values. Where the factor came from stands in ``sources["condition"]``
of the lagging, and the checks ask for attention.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import ClassVar

from wraparc.catalogue import DesignFriction, design_friction
from wraparc.drive import Lagging
from wraparc.drive.criteria import is_wet
from wraparc.errors import InputError, Problem, format_names, input_error, nearest, shown
from wraparc.provenance import Kind, Provenance
from wraparc.schema.limits import Limit, limit_problems, raise_all

DRY = "dry"
#: Whose table of design values gives the ratios of conditions before others.
MAIN = "DIN 22101"
#: Part of a lagging that says where the factor on its tested law came from.
SCALED = "condition"


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
        Whose design values give the factor, as the ratio of this condition over the tested one;
        `source` is then theirs. Without one, DIN 22101 where it covers the surface.
    source
        Where the factors came from.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {"factor": Limit("number", open=True, most=2.0)}

    name: str
    factor: float | None = None
    factors: Mapping[str, float] = field(default_factory=dict, hash=False)
    standard: str = ""
    source: Provenance = field(default_factory=Provenance)

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS) + self._wetter())

    def _wetter(self) -> list[Problem]:
        """Return a problem for a wet friction above the dry one."""
        factors = {"factor": self.factor, **self.factors}
        if not is_wet(self.name):
            return []
        message, remedy = "more friction wet than dry", "Give friction wet over dry, such as 0.8."
        return [
            Problem(key=key, value=f"{factor:g}", message=message, remedy=remedy)
            for key, factor in factors.items()
            if factor is not None and factor > 1.0
        ]

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
            sources={**lagging.sources, SCALED: source},
            fit=None,
            factors=None,
            scaled_by=factor,
            notes=(*lagging.notes, self._told(lagging, factor, source)),
        )

    def _told(self, lagging: Lagging, factor: float, source: Provenance) -> str:
        """Say what is left of the friction, and by whom."""
        by = f", {source.source.partition(' and ')[0]}" if source.kind is Kind.PUBLISHED else ""
        return f"{self.name}: friction {factor:.3g} of {lagging.condition}{by}"

    def of(self, laws: Sequence[Lagging]) -> Lagging:
        """Return the one of a lagging's laws for this condition, else its dry law scaled.

        Raises
        ------
        InputError
            As for `lagging`.
        """
        tested = next((lagging for lagging in laws if lagging.condition == self.name), None)
        if tested is not None:
            return tested
        return self.lagging(next((lag for lag in laws if lag.condition == DRY), laws[0]))

    def factor_of(self, lagging: Lagging) -> tuple[float, Provenance]:
        """Friction factor for a lagging [-], and where it came from."""
        own = lagging.condition_factors.get(self.name)
        if own is not None:
            return own.factor, own.source
        if lagging.surface in self.factors:
            return self.factors[lagging.surface], self.source
        if self.standard:
            return design_ratio(self.standard, lagging.surface, self.name, lagging.condition)
        if self.factor is not None:
            return self.factor, self.source
        if self.name == DRY == lagging.condition:
            return 1.0, Provenance()
        return self._published(lagging)

    def _published(self, lagging: Lagging) -> tuple[float, Provenance]:
        """Ratio by the first table that has both conditions for the surface of a lagging [-].

        Wet and dry of one table and one surface: those of different tables are of different kinds,
        and their ratios turn the order of the wet values round.
        """
        tables = dict.fromkeys(d.standard for d in design_friction() if d.condition)
        for standard in sorted(tables, key=lambda name: name != MAIN):
            try:
                return design_ratio(standard, lagging.surface, self.name, lagging.condition)
            except InputError:  # it says nothing of this surface or condition
                continue
        raise InputError(self._uncovered(lagging))

    def _uncovered(self, lagging: Lagging) -> Problem:
        known = published_conditions(lagging.surface)
        more = "a law to the lagging" if lagging.surface else "surface to the lagging"
        return Problem(
            key=f"condition.{self.name}",
            message=f"lagging {shown(lagging.name)} has no friction in this condition",
            remedy=nearest(self.name, known) or f"Give a friction_factor, or add {more}.",
        )


def covered(laws: Sequence[Lagging]) -> tuple[str, ...]:
    """Return the conditions that the friction of a lagging is known in, the tested ones first.

    Parameters
    ----------
    laws
        The lagging in every condition that it has a law for.
    """
    first = laws[0]
    names = (*(lag.condition for lag in laws), *first.condition_factors)
    asked = dict.fromkeys((*names, *published_conditions(first.surface)))
    return tuple(name for name in asked if _is_known(name, laws))


def _is_known(name: str, laws: Sequence[Lagging]) -> bool:
    try:
        Condition(name=name).of(laws)
    except InputError:
        return False
    return True


def published_conditions(surface: str) -> tuple[str, ...]:
    """Return the conditions that published values of friction cover for a surface."""
    values = (d for d in design_friction() if d.surface == surface and d.condition)
    return tuple(dict.fromkeys(d.condition for d in values))


def design_ratio(
    standard: str, surface: str, condition: str, tested: str = DRY
) -> tuple[float, Provenance]:
    """Friction in a condition over that in the tested one, by the design values of a standard [-].

    The middle of the published values is taken: a ratio of constant coefficients, stretched here
    to a whole friction law, which nobody has measured.

    Raises
    ------
    InputError
        If the standard has no value for the surface in either condition.
    """
    there = [d for d in design_friction() if d.standard == standard and d.surface == surface]
    here = next((d for d in there if d.condition == condition), None)
    dry = next((d for d in there if d.condition == tested), None)
    if here is None or dry is None:
        known = sorted({d.standard for d in design_friction() if d.condition})
        raise input_error(
            key=f"condition.{condition}",
            value=shown(standard),
            message=f"no design values {tested} and {shown(condition)} of surface {shown(surface)}",
            remedy=f"Give a factor, or one of {format_names(known)}.",
        )
    low, high = here.friction[0] / dry.friction[1], here.friction[1] / dry.friction[0]
    band = f", {low:.3g} to {high:.3g}" if low < high else ""
    note = (
        f"{surface} {condition} {_ends(here)} over {tested} {_ends(dry)}, middle values{band}; a "
        "ratio of constant design values applied to the whole law"
    )
    source = Provenance(Kind.PUBLISHED, here.provenance.source, here.provenance.date, note)
    return sum(here.friction) / sum(dry.friction), source


def _ends(design: DesignFriction) -> str:
    low, high = design.friction
    return f"{low:g}" if low == high else f"{low:g}-{high:g}"
