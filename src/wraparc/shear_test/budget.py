"""What a friction law is uncertain by beyond its readings: a budget after the GUM.

JCGM 100, *Guide to the expression of uncertainty in measurement*: each part as a standard
uncertainty, combined by its sensitivity; errors of transducers are common to all tests, so
repeating a test does not lessen them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.curve_fit import CurveFit
from wraparc.shear_test.curve_model import PARAMETERS, friction_and_jacobian

#: Largest error of a rig's compliance that nothing is known of [m/N], and of one that was measured,
#: over it [-].
UNKNOWN_COMPLIANCE = 0.05e-6
MEASURED_COMPLIANCE = 0.2
#: Largest error of the modulus of a rubber, assumed: what 5 degrees of Shore A hardness make,
#: +23 and -18 % at 60 Shore A (A. N. Gent, Rubber Chem. Technol. 31, 1958).
RUBBER_MODULUS = 0.2
_STEP = 0.02  # of ln p, for slopes over pressure


@dataclass(frozen=True, kw_only=True)
class ReadOff:
    """Largest errors of what was read off a figure, common to its curves.

    Parameters
    ----------
    slip
        [m].
    friction
        [-].
    a, b
        Of the coefficients of mu = A x ln x - b x [1/unit].
    unit
        SI value of the unit of x [m].
    """

    slip: float = 0.0
    friction: float = 0.0
    a: float = 0.0
    b: float = 0.0
    unit: float = 1e-3

    def effects(self, peaks: Array) -> dict[str, Array]:
        """Changes of (ln x_pk, ln mu_pk) by each, shape (n, 2) [-].

        Of the coefficients by x_pk = exp(b/A - 1), mu_pk = -A x_pk.

        Parameters
        ----------
        peaks
            (ln x_pk, ln mu_pk), shape (n, 2).
        """
        slip, friction = np.exp(peaks).T
        zero = np.zeros_like(slip)
        a = -friction * self.unit / slip
        b_over_a = 1.0 + np.log(slip / self.unit)
        by_a = -self.a * b_over_a / a
        found = {
            "slip off the figure": np.stack([self.slip / slip, zero], axis=-1),
            "friction off the figure": np.stack([zero, self.friction / friction], axis=-1),
            "A off the figure": np.stack([by_a, by_a + self.a / a], axis=-1),
            "b off the figure": np.stack([self.b / a, self.b / a], axis=-1),
        }
        return {name: effect for name, effect in found.items() if effect.any()}


@dataclass(frozen=True, kw_only=True)
class Uncertainty:
    """Largest errors of what the tests were measured with; each anywhere within its limits.

    The standard uncertainty is the limit over the root of 3 (rectangular distribution).

    Parameters
    ----------
    force, normal_force
        Of the two forces, of the reading [-]; 1 % is class 1 of ISO 7500-1.
    area
        Of the sample area [-].
    travel
        Of the travel, of the reading [-].
    zero
        Of the zero of the force that the readings cannot show [N].
    compliance
        Of the rig's compliance [m/N]; None for 20 % of it, or 0.05 mm/kN where it is not known.
    temperature
        What the temperature of the tests may change in the friction [-].
    shear_modulus, cover_shear_modulus
        Of the moduli of the sample and of the test belt's cover [-]; None for `RUBBER_MODULUS`.
    stated
        Whether the plan says them, or they are those of a usual rig.
    read_off
        Of curves read off a figure, or None.
    """

    force: float = 0.01
    normal_force: float = 0.01
    area: float = 0.01
    travel: float = 0.01
    zero: float = 0.0
    compliance: float | None = None
    temperature: float = 0.0
    shear_modulus: float | None = None
    cover_shear_modulus: float | None = None
    stated: bool = False
    read_off: ReadOff | None = None

    def compliance_error(self, compliance: float) -> float:
        """Return the largest error of a rig's compliance [m/N], 0 where that is not known."""
        if self.compliance is not None:
            return self.compliance
        return MEASURED_COMPLIANCE * compliance if compliance else UNKNOWN_COMPLIANCE

    @staticmethod
    def modulus_error(stated: float | None) -> float:
        """Return the largest error of the modulus of a rubber [-]."""
        return RUBBER_MODULUS if stated is None else stated


@dataclass(frozen=True, kw_only=True)
class Common:
    """Errors common to all tests, as a law over pressure feels them.

    Parameters
    ----------
    limits
        Their limits.
    force_at
        Pulling force per friction and pressure: faces times sample area [m2].
    compliance
        Largest error of the rig's compliance [m/N].
    sample_compliance, cover_compliance
        h/G of the sample and of the belt cover as far as its shear is taken off the travel [m/Pa].
    weighed
        Whether the normal force was given or measured; else the pressure, which the area turns
        into the normal force.
    bent
        Change of (ln x_pk, ln mu_pk) for a travel that is bent away at the peak and not taken off,
        over x_pk, shape (2,) [-]; see `bent_peak`.
    """

    limits: Uncertainty
    force_at: float
    compliance: float
    sample_compliance: float
    cover_compliance: float
    weighed: bool
    bent: Array

    def effects(self, peaks: Callable[[Array], Array], pressure: Array) -> dict[str, Array]:
        """Standard uncertainties of (ln x_pk, ln mu_pk) with their signs, shape (n, 2) each [-].

        With mu = F_x/(n F_n) and p = F_n/A, an error of F_n changes mu and the pressure that it is
        ascribed to; s is the slope of ln mu_pk or ln x_pk over ln p.

        Parameters
        ----------
        peaks
            (ln x_pk, ln mu_pk) over pressure, as of `PressureFit.peaks`.
        pressure
            [Pa], shape (n,).
        """
        of, at = self.limits, peaks(pressure)
        ahead, behind = peaks(pressure * (1.0 + _STEP)), peaks(pressure * (1.0 - _STEP))
        slope = (ahead - behind) / (2.0 * _STEP)
        stress = pressure * np.exp(at[:, 1])
        pull = self.force_at * stress
        friction = np.broadcast_to([0.0, 1.0], at.shape)
        slip = np.broadcast_to([1.0, 0.0], at.shape)
        over_slip = self.bent / np.exp(at[:, :1])
        # what sample and cover shear is taken off by the stress, F_x over the area
        rubbers = {
            "modulus of the sample": (self.sample_compliance, of.shear_modulus),
            "modulus of the belt cover": (self.cover_compliance, of.cover_shear_modulus),
        }
        shears = {name: h * stress[:, None] * over_slip for name, (h, _) in rubbers.items()}
        shear = sum(shears.values())
        # a pressure that was set is the normal force, but for the area
        area = slope if self.weighed else -friction
        found = {
            "pulling force": of.force * (friction - shear),
            "normal force": -of.normal_force * (friction + slope),
            "sample area": of.area * (area + shear),
            "travel": of.travel * slip,
            "zero of the force": of.zero / pull[:, None] * friction,
            "compliance of the rig": self.compliance * pull[:, None] * over_slip,
            "temperature": of.temperature * friction,
        }
        for name, (compliance, stated) in rubbers.items():
            if compliance > 0.0:
                found[name] = of.modulus_error(stated) * shears[name]
        if of.read_off is not None:
            found |= of.read_off.effects(at)
        return {name: effect / math.sqrt(3.0) for name, effect in found.items()}

    def covariance(self, peaks: Callable[[Array], Array], pressure: Array) -> Array:
        """Covariance of (ln x_pk, ln mu_pk) between pressures, shape (n, n, 2, 2)."""
        each = np.stack(list(self.effects(peaks, pressure).values()))
        return np.asarray(np.einsum("sni,smj->nmij", each, each))


def bent_peak(fit: CurveFit) -> Array:
    """Change of (ln x_pk, ln mu_pk) of a curve for a travel bent away and not taken off [-].

    For the part of x_pk that the rig or the sample yields by at the peak. To first order: the
    change of the curve, fitted by its free parameters as its readings were.
    """
    of, step = fit.parameters, 1e-4 * fit.parameters.peak_slip
    travel = fit.slip + of.lash + fit.bending * (fit.fitted - of.zero)
    here, jacobian = friction_and_jacobian(travel, fit.bending, of)
    ahead, _ = friction_and_jacobian(travel, fit.bending + step / of.peak_friction, of)
    columns = [PARAMETERS.index(name) for name in fit.free]
    weights = fit.weights
    change, *_ = np.linalg.lstsq(
        weights[:, None] * jacobian[:, columns], weights * (ahead - here), rcond=1e-10
    )
    peaks = [change[fit.free.index(name)] for name in ("ln_peak_slip", "ln_peak_friction")]
    return np.array(peaks) * of.peak_slip / step


@dataclass(frozen=True, kw_only=True, eq=False)
class Budget:
    """The budget of a law at its tested pressures.

    Parameters
    ----------
    pressure
        Shape (n,) [Pa].
    parts
        Standard uncertainties of (ln x_pk, ln mu_pk) by name, shape (n, 2) each [-].
    coverage_factor
        k of the expanded uncertainty [-].
    """

    pressure: Array
    parts: dict[str, Array]
    coverage_factor: float

    @property
    def combined(self) -> Array:
        """Combined standard uncertainty, root of the sum of squares, shape (n, 2) [-]."""
        return np.asarray(np.sqrt(sum(part**2 for part in self.parts.values())))

    @property
    def expanded(self) -> Array:
        """Expanded uncertainty, k times the combined, shape (n, 2) [-]."""
        return self.coverage_factor * self.combined
