"""A shear-test rig in the computer: tests of a known law, with the faults of real ones.

What a rig of this kind would record for a given friction law: the law's slip and the shear
of the sample and rig behind the lash, then noise, drift, spikes, and a wandering clamp.
"""

from dataclasses import dataclass, replace

import numpy as np

from wraparc.arrays import Array
from wraparc.friction import FrictionLaw


@dataclass(frozen=True, kw_only=True)
class VirtualRig:
    """A sample in a rig.

    Parameters
    ----------
    law
        Friction law of the lagging.
    area
        Area of one face of the sample [m2].
    faces
        Number of sliding faces.
    shear_compliance
        h/G of the sample and of the belt cover that it slides on [m/Pa].
    compliance
        Of the rig [m/N].
    lash
        Travel before the slip starts [m].
    stroke
        Largest travel [m].
    points
        Readings in the stroke.
    speed
        Of the crosshead [m/s].
    noise
        Standard deviation of the force, as a fraction of its largest value.
    correlation
        Readings over which the noise is correlated; 0 for white noise.
    drift
        Change of the force's zero over the stroke, as a fraction of the largest force.
    spikes
        Fraction of the readings that are far off.
    wander
        Standard deviation of the slow relative change of the normal force.
    friction_factor
        Friction over that of the law, for another state of its surface, such as wet.
    scatter_friction, scatter_slip
        Standard deviation of ln mu_pk and ln x_pk from sample to sample, by scaling
        friction and slip of the whole law.
    force_zero
        Constant error of the force [N].
    pre_load
        Travel that is past when the record starts, beyond the lash [m].
    unloading
        Whether the way back is recorded too.
    """

    law: FrictionLaw
    area: float = 0.04
    faces: int = 2
    shear_compliance: float = 0.0
    compliance: float = 0.0
    lash: float = 0.5e-3
    stroke: float = 15.5e-3
    points: int = 5000
    speed: float = 10e-3 / 60
    noise: float = 0.01
    correlation: float = 0.0
    drift: float = 0.0
    spikes: float = 0.0
    wander: float = 0.0
    friction_factor: float = 1.0
    scatter_friction: float = 0.0
    scatter_slip: float = 0.0
    force_zero: float = 0.0
    pre_load: float = 0.0
    unloading: bool = False


@dataclass(frozen=True, kw_only=True, eq=False)
class VirtualTest:
    """What the rig recorded, and the truth behind it.

    Parameters
    ----------
    pressure
        Set pressure [Pa].
    time, travel, force, normal_force
        The record [s, m, N, N], shape (n,).
    slip, friction
        The truth at each reading [m, -], shape (n,).
    friction_factor, slip_factor
        By which this sample differs from the law.
    rig
        The rig.
    """

    pressure: float
    time: Array
    travel: Array
    force: Array
    normal_force: Array
    slip: Array
    friction: Array
    friction_factor: float
    slip_factor: float
    rig: VirtualRig


def run_virtual_test(rig: VirtualRig, pressure: float, seed: int) -> VirtualTest:
    """Record one test.

    Travel d and slip x obey d = lash + x + (h/G) mu p + c n F_n mu; force is n F_n mu.

    Parameters
    ----------
    rig
        The rig.
    pressure
        Pressure on the sample [Pa].
    seed
        Of the random numbers; the same seed gives the same test.
    """
    rng = np.random.default_rng(seed)
    friction_factor = rig.friction_factor * float(np.exp(rng.normal(0.0, rig.scatter_friction)))
    slip_factor = float(np.exp(rng.normal(0.0, rig.scatter_slip)))
    travel = np.linspace(0.0, rig.stroke, rig.points)
    normal = pressure * rig.area
    bending = rig.shear_compliance * pressure + rig.compliance * rig.faces * normal
    # Graded towards 0, where the friction rises steeply; then inverted by interpolation.
    slips = np.linspace(0.0, 1.0, 20_001) ** 3 * (rig.stroke + rig.pre_load)
    mu = friction_factor * rig.law.friction(slips / slip_factor, pressure)
    ways = slips + bending * mu
    slip = np.interp(travel - rig.lash + rig.pre_load, ways, slips, left=0.0)
    friction = friction_factor * rig.law.friction(slip / slip_factor, pressure)
    wandering = 1.0 + rig.wander * _slow(rng, rig.points)
    force = rig.faces * normal * wandering * friction
    largest = float(force.max())
    noise = rig.noise * largest * _coloured(rng, rig.points, rig.correlation)
    force = force + noise + rig.drift * largest * travel / rig.stroke + rig.force_zero
    hit = rng.random(rig.points) < rig.spikes
    force[hit] += (
        rng.choice([-1.0, 1.0], int(hit.sum())) * rng.uniform(0.1, 0.6, int(hit.sum())) * largest
    )
    test = VirtualTest(
        pressure=pressure,
        time=travel / rig.speed,
        travel=travel,
        force=force,
        normal_force=normal * wandering,
        slip=slip,
        friction=friction,
        friction_factor=friction_factor,
        slip_factor=slip_factor,
        rig=rig,
    )
    return _with_way_back(test) if rig.unloading else test


def _slow(rng: np.random.Generator, count: int) -> Array:
    """A slow wander of standard deviation about 1: a few waves of random phase."""
    s = np.linspace(0.0, 1.0, count)
    waves = [np.sin(2 * np.pi * (k * s + rng.random())) / k for k in (1, 2, 3)]
    return np.asarray(np.sqrt(2.0 / 1.36) * np.sum(waves, axis=0))


def _coloured(rng: np.random.Generator, count: int, readings: float) -> Array:
    white = rng.normal(0.0, 1.0, count)
    if readings <= 0.0:
        return white
    rho = float(np.exp(-1.0 / readings))
    noise = np.empty(count)
    state = white[0]
    for k, pulse in enumerate(white):
        state = state if k == 0 else rho * state + np.sqrt(1.0 - rho**2) * pulse
        noise[k] = state
    return noise


def _with_way_back(test: VirtualTest) -> VirtualTest:
    """Append the crosshead's return: the force goes through zero to the other side."""
    back = slice(-2, None, -4)
    travel = np.concatenate([test.travel, test.travel[back]])
    ways = test.travel[-1] - test.travel[back]
    top = float(np.median(test.force[-20:]))
    returned = top * (2.0 * np.exp(-ways / 0.5e-3) - 1.0)
    last = test.time[-1]
    return replace(
        test,
        travel=travel,
        force=np.concatenate([test.force, returned]),
        normal_force=np.concatenate([test.normal_force, test.normal_force[back]]),
        time=np.concatenate([test.time, last + ways / test.rig.speed]),
        slip=np.concatenate([test.slip, np.full(len(ways), np.nan)]),
        friction=np.concatenate([test.friction, np.full(len(ways), np.nan)]),
    )
