"""How wrong what a plant logs may be: the errors of a log, and what is assumed of each.

Every error is fitted along with the friction, by its standard deviation. One that is left out
would be taken as exact and make every interval too narrow.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple


class ErrorKind(NamedTuple):
    """One error: what it is of, and the standard deviation that is assumed of it."""

    title: str
    usual: float
    meaning: str


#: By key. All are parts of one: of the quantity, of rated torque, or of speed.
ERROR_KINDS: dict[str, ErrorKind] = {
    "torque_gain": ErrorKind("Torque, gain", 0.03, "Of every torque, of the torque."),
    "torque_offset": ErrorKind("Torque, offset", 0.02, "Of every torque, of rated torque."),
    "exit_tension": ErrorKind("T2", 0.05, "Of the take-up's tension."),
    "take_up_friction": ErrorKind(
        "Take-up friction", 0.02, "Of T2, by which way the take-up moved last; 3 % is expected."
    ),
    "belt_modulus": ErrorKind("Belt modulus", 0.10, "Of the modulus of the belt."),
    "belt_modulus_drift": ErrorKind(
        "Belt modulus, drift", 0.015, "Of the modulus, within two weeks: temperature."
    ),
    "peak_slip": ErrorKind("Peak slip", 0.10, "Of the slip axis of the friction law."),
    "lagging_shear": ErrorKind("Lagging shear", 0.15, "Of the shear of the lagging."),
    "speed_by_torque": ErrorKind(
        "Speed by torque", 0.0004, "Of speed at rated torque; 0.12 % for an estimated speed."
    ),
    "torque_curve": ErrorKind(
        "Bend of the torque signal", 0.00008, "Of speed, that a bent torque signal looks like."
    ),
    "friction_level": ErrorKind(
        "Friction over its law", 0.35, "Of friction, over the law of the drive file."
    ),
    "law_shape": ErrorKind(
        "Shape of the friction law", 0.08, "Of friction: what its law misses between two slips."
    ),
    "friction_days": ErrorKind(
        "Friction from day to day", 0.015, "Of friction, about its course: temperature, moisture."
    ),
    "wheel": ErrorKind("Measuring wheel", 0.0008, "Of speed: dirt and wear of the wheel."),
}
#: Take-up friction that is expected of every take-up, as it always opposes [-].
TAKE_UP_FRICTION = 0.03
#: `speed_by_torque` of a motor speed that a converter estimates [-].
ESTIMATED_SPEED = 0.0012


@dataclass(frozen=True)
class LogErrors:
    """Standard deviations of the errors of a log.

    Attributes
    ----------
    stated
        By key of `ERROR_KINDS`, those that the file states [-].
    """

    stated: Mapping[str, float] = field(default_factory=dict)

    def sd(self, key: str, *, is_estimated: bool = False) -> float:
        """Return the standard deviation of an error, the assumed one where none is stated [-]."""
        if key == "speed_by_torque" and is_estimated and key not in self.stated:
            return ESTIMATED_SPEED
        return self.stated.get(key, ERROR_KINDS[key].usual)

    @property
    def assumed(self) -> tuple[str, ...]:
        """Keys of which the file states nothing."""
        return tuple(key for key in ERROR_KINDS if key not in self.stated)
