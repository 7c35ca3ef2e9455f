"""How uncertain inputs are: as a drive states it, else as it usually is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import expm1, sqrt
from typing import NamedTuple

from wraparc.arc.interval import felt_knots
from wraparc.arc.wrap_arc import WrapArc
from wraparc.catalogue.belt_modulus import STATIC, find_ratio
from wraparc.checks.rule import origin
from wraparc.checks.variant_rows import FRICTION, SLIP
from wraparc.drive import Belt, Drive, Pulley, knots_of
from wraparc.reserve.inputs import (
    CARCASS,
    COMPRESSION,
    DIAMETER,
    MODULUS,
    OF_LAGGING,
    PULL,
    SHEAR,
    SLACK,
    START,
    TAKE_UP_PLACE,
    THICKNESS,
    WRAP,
    Input,
)

#: Kinds of an uncertainty: of the drive file, of what is published of a standard belt, of a fit,
#: with a source, and without one.
STATED, PUBLISHED, FIT, USUAL, ASSUMED = "stated", "published", "fit", "usual", "assumed"
#: Those that count in the level of a verdict; that of a fit does by a check of its own.
COUNTED = (STATED, PUBLISHED)
#: Least uncertainty that changes are told in: of what is exact, every change is far [-].
_LEAST = 1e-9


class Uncertainty(NamedTuple):
    """How far an input may be off, either way (95 %).

    Attributes
    ----------
    value
        Of the input [-].
    kind
        `STATED`, `PUBLISHED`, `FIT`, `USUAL` or `ASSUMED`.
    source
        Where it came from; empty where it is assumed.
    lower
        Of the input downwards [-], where it is not as much as upwards.
    """

    value: float
    kind: str = ASSUMED
    source: str = ""
    lower: float | None = None

    def towards(self, change: float) -> float:
        """Return the uncertainty to the side of a change [-]."""
        return self.value if self.lower is None or change > 0.0 else self.lower

    def units(self, change: float) -> float:
        """Return the size of a change in units of the uncertainty [-]."""
        return abs(change) / max(self.towards(change), _LEAST)

    def has(self, change: float) -> bool:
        """Return whether a change is within the uncertainty."""
        return abs(change) <= self.towards(change)


_HARDNESS = Uncertainty(
    0.2, USUAL, "5 Shore A at 60 Shore A (A. N. Gent, Rubber Chem. Technol. 31, 1958)"
)
#: Of each input. The pull is that of its friction factor, 0.016 to 0.030 about their middle.
UNCERTAINTIES = {
    FRICTION: Uncertainty(0.1),
    SLIP: Uncertainty(0.2),
    SHEAR: _HARDNESS,
    COMPRESSION: _HARDNESS,
    THICKNESS: Uncertainty(0.05),
    DIAMETER: Uncertainty(0.01),
    WRAP: Uncertainty(0.02),
    PULL: Uncertainty(0.3, USUAL, "f from 0.016 to 0.030 (DIN 22101:2002-08, 6.2.3; ISO 5048)"),
    SLACK: Uncertainty(0.05),
    TAKE_UP_PLACE: Uncertainty(0.02),
    START: Uncertainty(0.1),
}
#: Of the modulus of a belt by its carcass; what is not known is taken as fabric.
MODULI = {
    "fabric": Uncertainty(
        0.2,
        USUAL,
        "10 to 22 % by temperature alone, -30 to 30 C (Rudawska et al., Appl. Sci. 10 (2020) 4201)",
    ),
    "steel cord": Uncertainty(0.05),
}
#: Keys of what a pulley, its lagging or a belt states, by input.
_KEYS = {
    FRICTION: "friction", SLIP: "slip", SHEAR: "shear_modulus",
    COMPRESSION: "compression_modulus", THICKNESS: "thickness", DIAMETER: "diameter",
    WRAP: "wrap_angle", MODULUS: "modulus", CARCASS: "carcass",
}  # fmt: skip
_PULL, _ENTRY, _EXIT = "effective_tension", "entry_tension", "exit_tension"


def uncertainty_of(drive: Drive, of: Input) -> Uncertainty:
    """Return how uncertain an input of a drive is: as stated, else as it usually is."""
    stated = _stated(drive, of)
    if stated is not None:
        return Uncertainty(stated, STATED, "drive file")
    known = _published(drive.belt, of.name) or _of_fit(drive, of)
    if known is not None:
        return known
    return _of_modulus(drive.belt) if of.name == MODULUS else UNCERTAINTIES[of.name]


def _published(belt: Belt, name: str) -> Uncertainty | None:
    """Return what is published of belts of a standard name; None of a number of one's own."""
    known = {
        MODULUS: (belt.modulus, belt.modulus_ends),
        CARCASS: (belt.carcass, belt.carcass_ends),
    }
    value, ends = known.get(name, (None, None))
    if value is None or ends is None:
        return None
    lower, upper = (abs(end / value - 1.0) for end in ends)
    return Uncertainty(upper, PUBLISHED, origin(belt.source_of(_KEYS[name])), lower=lower)


def _of_fit(drive: Drive, of: Input) -> Uncertainty | None:
    """Return the 95 % interval of friction or slips by the fits of laws; None without fits.

    The widest of the peaks that the pressures of its arcs feel; of pulleys that change together
    the least.
    """
    if of.name not in (FRICTION, SLIP):
        return None
    quantity = "peak_friction" if of.name == FRICTION else "peak_slip"
    pulleys = [pulley for pulley in drive.pulleys if pulley.name in of.pulleys]
    found = [_spread_at(drive, pulley, quantity) for pulley in pulleys]
    if not found or min(found) == 0.0:
        return None
    widest, name = min(found), pulleys[found.index(min(found))].lagging.name
    return Uncertainty(
        expm1(widest), FIT, f"95 % interval of the law of lagging {name}", lower=-expm1(-widest)
    )


def _spread_at(drive: Drive, pulley: Pulley, quantity: str) -> float:
    """Return the logarithm of the interval of a peak at a pulley [-], 0 where no fit has one."""
    widest = 0.0
    for case in drive.load_cases:
        arc = WrapArc.of(drive, pulley, case)
        fit, knots = arc.fit, knots_of(arc.law)
        if fit is None or knots is None:
            continue
        first, last = felt_knots(arc, knots)
        for i, (place, of) in enumerate(fit.knots):
            if of == quantity and first <= place <= last:
                variance = max(float(fit.log_covariance[i, i]), 0.0)
                widest = max(widest, fit.coverage_factor * sqrt(variance))
    return widest


def _of_modulus(belt: Belt) -> Uncertainty:
    """Return the usual uncertainty of a modulus; a static one is less than what the pulley sees."""
    usual = MODULI.get(belt.kind, MODULI["fabric"])
    if belt.modulus_test == STATIC:
        ratio = find_ratio(belt.kind)
        source = f"dynamic {ratio.least:g} to {ratio.most:g} times static: {ratio.source}"
        return Uncertainty(ratio.most - 1.0, USUAL, source, lower=usual.value)
    return usual


def _stated(drive: Drive, of: Input) -> float | None:
    """Return the stated uncertainty of an input [-], None where it is not stated.

    Pulleys that change together are off by what each of them may be.
    """
    if of.name == MODULUS:
        return drive.belt.uncertainty.get(_KEYS[MODULUS])
    if of.name == START:
        return None if drive.conveyor is None else drive.conveyor.uncertainty.get(START)
    if of.name in (PULL, SLACK):
        found = _of_pull(drive) if of.name == PULL else _of_slack(drive)
        return max(found, default=None)
    pulleys = [pulley for pulley in drive.pulleys if pulley.name in of.pulleys]
    if not pulleys:
        return None
    values = [_of_pulley(pulley, of.name) for pulley in pulleys]
    known = [value for value in values if value is not None]
    return min(known) if known and len(known) == len(values) else None


def _of_pulley(pulley: Pulley, name: str) -> float | None:
    of_lagging = name in OF_LAGGING or name == THICKNESS
    values = pulley.lagging.uncertainty if of_lagging else pulley.uncertainty
    return values.get(_KEYS[name])


class _Known(NamedTuple):
    """Tensions of a pulley or of all together, and what is stated of them."""

    stated: Mapping[str, float]
    entry: float
    exit: float
    pull: float
    take_up: float

    @property
    def tight(self) -> str:
        return _ENTRY if self.pull > 0.0 else _EXIT

    def tension(self, key: str) -> float:
        """Return one of both tensions [N]."""
        return self.entry if key == _ENTRY else self.exit


def _of_pull(drive: Drive) -> Iterator[float]:
    """Yield how far effective tensions may be off, by their own or by the tight side's tension."""
    for of in _known(drive):
        if _PULL in of.stated:
            yield of.stated[_PULL]
        elif of.tight in of.stated:
            yield of.stated[of.tight] * of.tension(of.tight) / abs(of.pull)


def _of_slack(drive: Drive) -> Iterator[float]:
    """Yield how far the tension at the take-up may be off, by the tensions of pulleys.

    Where the effective tension is stated, either tension shifts both.
    """
    for of in _known(drive):
        for key in (_ENTRY, _EXIT):
            if key in of.stated and (_PULL in of.stated or key != of.tight):
                yield of.stated[key] * of.tension(key) / of.take_up


def _known(drive: Drive) -> Iterator[_Known]:
    """Yield the tensions of what pulls, with what is stated: of a load case before a pulley's."""
    for case in drive.load_cases:
        take_up = drive.take_up_tension(case)
        for pulley in drive.pulleys:
            at = case.tensions.get(pulley.name)
            if at is not None and at.effective != 0.0:
                stated = {**pulley.uncertainty, **case.uncertainty.get(pulley.name, {})}
                yield _Known(stated, at.entry, at.exit, at.effective, take_up)
        every = [case.tensions[p.name] for p in drive.pulleys if p.name in case.tensions]
        pull = sum(at.effective for at in every)
        if "" in case.uncertainty and pull != 0.0:
            yield _Known(case.uncertainty[""], every[0].entry, every[-1].exit, pull, take_up)
