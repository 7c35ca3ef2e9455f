"""Small vibrations of the whole station: will it pulsate by itself, and what makes it vibrate."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from wraparc.arrays import Array, Complex
from wraparc.errors import input_error
from wraparc.motion.arc_response import ArcResponse
from wraparc.motion.control import (
    Control,
    CoupledMotor,
    Droop,
    ExactSpeed,
    Follower,
    SpeedLoop,
)
from wraparc.motion.linear import CALM, HIGHEST, Linear, NDArrayInt, contour, windings
from wraparc.motion.station import Drum, Station


@dataclass(frozen=True, eq=False)
class FrequencyResponse:
    """Answers of a station to a vibration of one drum over frequency.

    Attributes
    ----------
    kind, pulley
        What vibrates: ``run-out`` [per m], ``torque`` [per N m] or ``speed``.
    frequency
        [Hz], shape (k,).
    tension
        Between and outside the drums, shape (k, n + 1) [N].
    pull
        Relative to the steady torque of every drum, shape (k, n) [-].
    share, creep
        Of every drum, shape (k, n) [-, m].
    """

    kind: str
    pulley: str
    frequency: Array
    tension: Complex
    pull: Complex
    share: Complex
    creep: Complex


def response(
    linear: Linear, kind: str, pulley: str, frequency: Sequence[float] | Array | None = None
) -> FrequencyResponse:
    """Return how a station answers to a vibration; see `FrequencyResponse`."""
    f = np.asarray(np.geomspace(0.02, HIGHEST, 240) if frequency is None else frequency, float)
    i = linear.station.index(pulley)
    found = linear.forced(2j * math.pi * f, kind, i)
    torques = np.array([d.torque for d in linear.duties])
    return FrequencyResponse(
        kind, pulley, f, found["tension"], found["moment"] / torques, found["share"], found["creep"]
    )


@dataclass(frozen=True)
class ControlAnswer:
    """What one way to drive all drums makes of the station.

    Attributes
    ----------
    name
        In words.
    root
        The rightmost root if it grows, else nan [1/s].
    stable
        Whether no vibration grows.
    pull
        Amplitude of the pull of the worst drum per run-out of the drum asked, at one wave a turn,
        relative to its pull [1/m].
    pull_third
        The same at three waves a turn.
    power_loss
        Power that the way costs by slip, of the power of the drives [-].
    """

    name: str
    root: complex
    stable: bool
    pull: float
    pull_third: float
    power_loss: float


@dataclass(frozen=True, eq=False)
class StabilityResult:
    """Whether a station pulsates, and why.

    Attributes
    ----------
    linear
        What it was found from.
    root
        The rightmost root [1/s]: growth and angular frequency; nan where all die out faster than
        e-fold in a third of a second.
    sensitivity
        Static change of share per relative change of speed of every drum but the first [-].
    responses
        To run-out and to torque ripple of every drum.
    controls
        What other controls would make of it.
    run_out
        That amplitudes in words refer to [m].
    softening
        Names of pulleys that work past the peak of their law.
    gain_margins
        For every drum by how much its gain may rise until a vibration grows, all else as it is
        [-]: that of its load sharing, its speed loop, or the ratio of a follower; below 1 by how
        much it must fall; nan without such a gain, inf beyond a thousandfold.
    """

    linear: Linear
    root: complex
    sensitivity: tuple[float, ...]
    responses: tuple[FrequencyResponse, ...]
    controls: tuple[ControlAnswer, ...]
    run_out: float
    softening: tuple[str, ...]
    gain_margins: tuple[float, ...]

    @property
    def stable(self) -> bool:
        """Whether no vibration grows."""
        return not self.root.real > CALM

    @property
    def frequency(self) -> float:
        """Of the least damped vibration [Hz]."""
        return abs(self.root.imag) / (2.0 * math.pi)

    @property
    def margin(self) -> float:
        """Decay of the least damped vibration [1/s]; negative if it grows, nan if fast."""
        return -self.root.real


def stability(station: Station, *, run_out: float = 0.5e-3) -> StabilityResult:
    """Tell whether a station pulsates by itself, and what run-out and ripple do to it.

    Parameters
    ----------
    station
        The station.
    run_out
        Amplitude of the radius that the answers in words refer to [m].

    Raises
    ------
    InputError
        If there is no steady state to vibrate about.
    """
    if not 0.0 < run_out < 0.05:
        message = "must be more than 0 and less than 50 mm"
        raise input_error(key="run_out", value=f"{run_out:g} m", message=message)
    linear = Linear.of(station)
    names = station.names
    return StabilityResult(
        linear=linear,
        root=linear.rightmost,
        sensitivity=tuple(linear.share_by_speed(i) for i in range(1, len(names))),
        responses=tuple(response(linear, kind, n) for kind in ("run-out", "torque") for n in names),
        controls=compare_controls(linear),
        run_out=run_out,
        softening=tuple(
            m.name
            for m, p in zip(linear.steady.members, linear.profiles, strict=True)
            if np.any(p.by_creep < 0.0)
        ),
        gain_margins=tuple(gain_margin(linear, i) for i in range(len(names))),
    )


def gain_margin(linear: Linear, i: int) -> float:
    """Return by how much the gain of a drum may rise until a vibration grows.

    See `StabilityResult.gain_margins`. The border nearest to 1 on the way up if the station is
    stable as it is, on the way down if it is not; to 1e-3.
    """
    drums = linear.station.drums

    def stable(factor: float) -> bool:
        drum = _louder(drums[i], linear, i, factor)
        return linear.controlled(*drums[:i], drum, *drums[i + 1 :]).roots_beyond(0.0) == 0

    if _louder(drums[i], linear, i, 1.0) is drums[i]:
        return math.nan
    now = stable(1.0)
    near, far = 1.0, 2.0 if now else 0.5
    while stable(far) == now:
        near, far = far, far * far
        if not 1e-3 < far < 1e3:
            return math.inf if now else 0.0
    while abs(far / near - 1.0) > 1e-3:
        middle = math.sqrt(near * far)
        near, far = (middle, far) if stable(middle) == now else (near, middle)
    return near if now else far


def _louder(drum: Drum, linear: Linear, i: int, factor: float) -> Drum:
    """The drum with its gain times a factor; the same object if it has none."""
    control = drum.control
    if drum.trim is not None:
        return replace(drum, trim=replace(drum.trim, gain=min(factor * drum.trim.gain, 100.0)))
    if isinstance(control, SpeedLoop):
        bandwidth = min(factor * control.bandwidth, 100.0)
        return replace(drum, control=replace(control, bandwidth=bandwidth))
    if isinstance(control, Follower):
        lead = linear.duties[linear.station.index(control.master)].torque
        ratio = linear.duties[i].torque / lead if control.ratio is None else control.ratio
        return replace(drum, control=replace(control, ratio=min(factor * ratio, 10.0)))
    return drum


def compare_controls(linear: Linear) -> tuple[ControlAnswer, ...]:
    """Return what the usual ways to drive all drums make of a station."""
    drums = linear.station.drums
    ways: list[tuple[str, list[Control]]] = [
        ("as described", [d.control for d in drums]),
        ("exact speed", [ExactSpeed() for _ in drums]),
        ("droop 1 %", [Droop(droop=0.01) for _ in drums]),
        ("droop 3 %", [Droop(droop=0.03) for _ in drums]),
        (
            "fluid coupling, slip 3 %",
            [CoupledMotor(coupling_slip=0.03, pump_inertia=0.2 * d.inertia) for d in drums],
        ),
        ("speed loop, 2 Hz", [SpeedLoop(bandwidth=2.0, reset=1.0) for _ in drums]),
    ]
    if len(drums) > 1:
        lead = linear.station.names[0]
        for damping, name in ((None, "torque follower"), (0.03, "torque follower, damping 3 %")):
            followers: list[Control] = [
                Follower(master=lead, lag=0.1, damping=damping) for _ in drums[1:]
            ]
            ways.append((name, [ExactSpeed(), *followers]))
    return tuple(_answer(linear, name, controls) for name, controls in ways)


def _answer(linear: Linear, name: str, controls: Sequence[Control]) -> ControlAnswer:
    drums = linear.station.drums
    with_ = linear.controlled(
        *(replace(d, control=c) for d, c in zip(drums, controls, strict=True))
    )
    last = len(drums) - 1
    turn = 1j * with_.duties[last].speed
    found = with_.forced(np.array([turn, 3.0 * turn]), "run-out", last)
    torques = np.array([d.torque for d in with_.duties])
    size = np.abs(found["moment"] / torques).max(axis=1)
    total = sum(abs(d.torque * d.speed) for d in with_.duties)
    lost = 0.0
    for duty, control in zip(with_.duties, controls, strict=True):
        if isinstance(control, CoupledMotor):
            slip = control.slip_at(duty.torque / control.rating(duty))
            lost += abs(duty.torque * duty.speed) * slip / (1.0 - slip)
    stable = with_.roots_beyond(CALM) == 0
    root = complex(math.nan, math.nan) if stable else with_.rightmost
    return ControlAnswer(name, root, stable, float(size[0]), float(size[1]), lost / total)


@dataclass(frozen=True, eq=False)
class StabilityMap:
    """Rightmost behaviour over two numbers: how many roots grow.

    Attributes
    ----------
    what
        Name of the number along x: ``droop`` or ``coupling slip``.
    x
        Its values [-], shape (k,).
    inertia
        Of the last drum [kg m2], shape (l,).
    growing
        Roots with a positive real part, shape (l, k).
    pull
        Amplitude of the pull of the last drum per metre of its run-out at one wave a turn,
        relative, shape (l, k) [1/m].
    """

    what: str
    x: Array
    inertia: Array
    growing: NDArrayInt
    pull: Array


def stability_map(
    station: Station,
    *,
    what: str = "droop",
    points: int = 41,
    span: tuple[float, float] | None = None,
) -> StabilityMap:
    """Map stability over droop (or coupling slip) of the last drive and the inertia of its drum.

    A torque follower keeps following: its droop is the speed feedback added to it.

    Parameters
    ----------
    station
        The station.
    what
        ``droop`` or ``coupling slip``.
    points
        Along each side.
    span
        Ends of x [-].
    """
    linear = Linear.of(station)
    low, high = span or ((0.002, 0.5) if what == "droop" else (0.01, 0.1))
    x = np.geomspace(low, high, points)
    drum = station.drums[-1]
    inertia = np.geomspace(drum.inertia / 5.0, drum.inertia * 5.0, points)
    path = contour(0.0, 240)
    responses = linear.responses(path)
    turn = np.array([1j * linear.duties[-1].speed])
    at_turn = linear.responses(turn)
    growing = np.zeros((points, points), dtype=np.int64)
    pull = np.zeros((points, points))
    for k, value in enumerate(x):
        control = _mapped(drum, what, float(value))
        growing[:, k] = _growing(linear, control, inertia, path, responses)
        pull[:, k] = _pulls(linear, control, inertia, turn, at_turn)
    return StabilityMap(what, x, inertia, growing, pull)


def _mapped(drum: Drum, what: str, value: float) -> Control:
    """The control of the last drum at a place of the map."""
    if what != "droop":
        return CoupledMotor(coupling_slip=value, pump_inertia=0.2 * drum.inertia)
    if isinstance(drum.control, Follower):
        return replace(drum.control, damping=value)
    return Droop(droop=value, lag=getattr(drum.control, "lag", 0.0))


def _tables(
    linear: Linear, control: Control, inertia: Array, lam: Complex, responses: list[ArcResponse]
) -> tuple[Complex, Complex, Complex]:
    """Equations at the first inertia of the last drum, their slope by it, rows of the moments.

    The inertia stands in the last row alone, and linearly.
    """
    *others, drum = linear.station.drums
    found = [
        linear.controlled(*others, replace(drum, control=control, inertia=float(j))).table(
            lam, responses
        )
        for j in inertia[[0, -1]]
    ]
    slope = (found[1][0][:, -1] - found[0][0][:, -1]) / (inertia[-1] - inertia[0])
    return found[0][0], slope, found[0][1]["moment"]


def _growing(
    linear: Linear, control: Control, inertia: Array, path: Complex, responses: list[ArcResponse]
) -> NDArrayInt:
    """Roots that grow, at every inertia of the last drum."""
    table, slope, _ = _tables(linear, control, inertia, path, responses)
    size = table.shape[1]
    scale = np.max(np.abs(table[:, :, :size]), axis=(0, 2))
    matrix, own = table[:, :, :size] / scale[:, None], slope[:, :size] / scale[-1]
    # the determinant is linear in the one row that the inertia changes
    follows = np.einsum("ki,ki->k", own, np.linalg.inv(matrix)[:, :, -1])
    return windings(np.linalg.det(matrix) * (1.0 + np.outer(inertia - inertia[0], follows)))


def _pulls(
    linear: Linear, control: Control, inertia: Array, turn: Complex, responses: list[ArcResponse]
) -> Array:
    """Pull of the last drum per run-out at one wave a turn, at every inertia; relative [1/m]."""
    table, slope, moments = _tables(linear, control, inertia, turn, responses)
    size, last = table.shape[1], len(linear.duties) - 1
    tables = np.repeat(table, len(inertia), axis=0)
    tables[:, -1] += (inertia - inertia[0])[:, None] * slope
    found = np.linalg.solve(tables[:, :, :size], -tables[:, :, size + last, None])[..., 0]
    moment = found @ moments[0, last, :size] + moments[0, last, size + last]
    return np.asarray(np.abs(moment) / abs(linear.duties[last].torque))
