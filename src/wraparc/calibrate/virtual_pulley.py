"""A virtual instrumented pulley: the records a known drive would leave, with noise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from wraparc.arc import ArcResult
from wraparc.arrays import Array

_RATE = 200.0  # samples in a second [1/s]


@dataclass(frozen=True, eq=False)
class PulleyRecord:
    """A continuous record of an instrumented pulley, samples in order of time.

    Attributes
    ----------
    angle
        Rotation angle of the pulley, not wrapped, shape (n,) [rad].
    displacement
        Displacement of the belt against the shell, driving positive, shape (n,) [m], or None.
    shear_angle
        Shear angle of the lagging under the sensor, driving positive, shape (n,) [rad], or None.
    """

    angle: Array
    displacement: Array | None
    shear_angle: Array | None

    def __len__(self) -> int:
        return len(self.angle)


def virtual_record(
    result: ArcResult,
    *,
    samples: int = 3600,
    revolutions: float = 5.0,
    entry: float = 1.0,
    noise: float = 0.01,
    seed: int = 1,
) -> PulleyRecord:
    """Return the record that sensors of a solved pulley would leave.

    A sensor in the shell passes under the belt once a turn, from the entry nip on; off the belt
    both signals are back at zero.

    Parameters
    ----------
    result
        The solved arc.
    samples, revolutions
        Length of the record.
    entry
        Rotation angle at which the sensor passes the entry nip [rad].
    noise
        Standard deviation of the noise over the largest value of each signal [-].
    seed
        Of the noise.
    """
    rng = np.random.default_rng(seed)
    angle = np.linspace(0.0, 2.0 * np.pi * revolutions, samples, endpoint=False)
    along = np.mod(angle - entry, 2.0 * np.pi)
    under = along <= result.arc.wrap_angle
    signals = []
    for course in (result.profile.creep, result.profile.shear_angle):
        clean = np.where(under, np.interp(along, result.profile.position, course), 0.0)
        signals.append(clean + noise * np.abs(clean).max() * rng.standard_normal(samples))
    return PulleyRecord(angle, signals[0], signals[1])


def record_text(record: PulleyRecord) -> str:
    """Return a record as a CSV table: time, rotation within the turn, displacement, shear angle."""
    heads, columns = ["time [s]", "rotation [deg]"], [np.arange(len(record)) / _RATE]
    columns.append(np.degrees(np.mod(record.angle, 2.0 * np.pi)))
    if record.displacement is not None:
        heads.append("belt displacement [mm]")
        columns.append(record.displacement * 1e3)
    if record.shear_angle is not None:
        heads.append("lagging shear [deg]")
        columns.append(np.degrees(record.shear_angle))
    rows = np.stack(columns, axis=1).tolist()
    lines = [",".join(f"{v:.4f}" for v in row) for row in rows]
    return "\n".join([",".join(heads), *lines]) + "\n"
