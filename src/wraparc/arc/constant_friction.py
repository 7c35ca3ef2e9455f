"""The classical drive: one friction for the whole wrap, and the design values that go with it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from wraparc.arc.wrap_arc import WrapArc
from wraparc.catalogue import DesignFriction, design_friction
from wraparc.drive import Lagging

Range = tuple[float, float]


def capstan_ratio(friction: float, wrap_angle: float) -> float:
    """Largest tension ratio of constant friction, exp(mu phi) (Euler and Eytelwein) [-].

    Parameters
    ----------
    friction
        mu [-].
    wrap_angle
        phi [rad].
    """
    return math.exp(friction * wrap_angle)


def wrap_factor(friction: float, wrap_angle: float) -> float:
    """Slack-side tension over effective tension, Cw = 1/(exp(mu phi) - 1) (CEMA) [-].

    Parameters
    ----------
    friction
        mu > 0 [-].
    wrap_angle
        phi > 0 [rad].
    """
    return 1.0 / math.expm1(friction * wrap_angle)


def slipping_arc(friction: float, tension_ratio: float) -> float:
    """Exit part of the wrap that slips, ln(T1/T2)/mu, the rest being at rest [rad].

    Parameters
    ----------
    friction
        mu > 0 [-].
    tension_ratio
        T1/T2 or its inverse, > 0 [-].
    """
    return abs(math.log(tension_ratio)) / friction


@dataclass(frozen=True)
class ClassicalDrive:
    """What a published design value of friction says of an arc.

    Every pair is for the lower and the upper end of the design value, in this order.

    Attributes
    ----------
    design
        The design value and its source.
    ratio
        Largest ratio of tight-side to slack-side tension [-].
    wrap_factor
        Cw [-].
    slack_tension
        Slack-side tension that the effective tension needs, Cw abs(T1 - T2) [N].
    slipping_arc
        Part of the wrap that slips at the tensions given; above the wrap angle the belt slips
        through [rad].
    """

    design: DesignFriction
    ratio: Range
    wrap_factor: Range
    slack_tension: Range
    slipping_arc: Range

    @property
    def safe_slack_tension(self) -> float:
        """Slack-side tension for the lower end of the design value [N]."""
        return self.slack_tension[0]


def classical_drives(arc: WrapArc, lagging: Lagging) -> tuple[ClassicalDrive, ...]:
    """Return what the published design values for the surface of a lagging say of an arc.

    Values for the condition of the lagging come first; none are known of a lagging that does not
    say what its surface is.
    """
    known = [value for value in design_friction() if value.surface == lagging.surface]
    known.sort(key=lambda value: value.condition not in ("", lagging.condition))
    return tuple(_classical(arc, value) for value in known)


def _classical(arc: WrapArc, value: DesignFriction) -> ClassicalDrive:
    low, high = value.friction
    phi, pull = arc.wrap_angle, abs(arc.effective_tension)
    ratio = arc.entry_tension / arc.exit_tension
    factors = wrap_factor(low, phi), wrap_factor(high, phi)
    return ClassicalDrive(
        design=value,
        ratio=(capstan_ratio(low, phi), capstan_ratio(high, phi)),
        wrap_factor=factors,
        slack_tension=(factors[0] * pull, factors[1] * pull),
        slipping_arc=(slipping_arc(low, ratio), slipping_arc(high, ratio)),
    )
