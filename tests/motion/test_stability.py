"""Small vibrations: closed forms, the static limit, the roots, and small simulated disturbances."""

import math
from dataclasses import replace

import numpy as np
import pytest

from motion.stations import INERTIA, TRAINS, station
from wraparc import InputError, solve_train
from wraparc.motion.arc_response import SteadyProfile
from wraparc.motion.control import (
    Control,
    CoupledMotor,
    Droop,
    Duty,
    ExactSpeed,
    Follower,
    SpeedLoop,
    Trim,
)
from wraparc.motion.event import Event, OnDrum
from wraparc.motion.linear import Linear, contour, windings
from wraparc.motion.march import March
from wraparc.motion.station import Station
from wraparc.motion.vibration import gain_margin, response, stability, stability_map


def follower(name: str, **more: float) -> Station:
    return station(name, ExactSpeed(), Follower(master="first", lag=0.1, **more))


@pytest.mark.parametrize("name", INERTIA)
def test_the_slow_limit_is_the_static_train(name: str) -> None:
    """Theory, 1e-5: 65.7491 and 51.3006; other code, the sensitivity of `solve_train`, whose own
    error is the larger one (1.2e-5 of the theory's for steel cord): 2e-5."""
    linear = Linear.of(station(name, ExactSpeed(), ExactSpeed()))
    static = solve_train(TRAINS[name]).cases[0].sensitivity[1][1]
    found = linear.share_by_speed(1)
    assert found == pytest.approx({"fabric": 65.7491, "steel-cord": 51.3006}[name], rel=1e-5)
    assert found == pytest.approx(static, rel=2e-5)


@pytest.mark.parametrize(
    ("name", "control", "size", "phase"),
    [
        ("fabric", ExactSpeed(), 3.4226e6, -81.5),
        ("steel-cord", ExactSpeed(), 1.5069e7, -64.8),
        ("steel-cord", Droop(droop=0.01), 8.2605e6, None),
    ],
)
def test_run_out_at_one_wave_a_turn(
    name: str, control: Control, size: float, phase: float | None
) -> None:
    """Theory, 1e-4: tension between the drums per run-out of the second one."""
    linear = Linear.of(station(name, control, control))
    turn = np.array([1j * linear.duties[1].speed])
    found = complex(linear.forced(turn, "run-out", 1)["tension"][0, 1])
    assert abs(found) == pytest.approx(size, rel=1e-4)
    if phase is not None:
        assert math.degrees(math.atan2(found.imag, found.real)) == pytest.approx(phase, abs=0.05)


@pytest.mark.parametrize(
    ("name", "root"), [("fabric", complex(2.086, 17.516)), ("steel-cord", complex(2.017, 26.312))]
)
def test_a_follower_has_a_growing_root(name: str, root: complex) -> None:
    """Theory, 1 %: lag 0.1 s, outer tensions held; a speed feedback cures it."""
    linear = Linear.of(follower(name))
    assert linear.rightmost == pytest.approx(root, rel=0.01)
    assert linear.roots_beyond(0.0) == 2
    assert Linear.of(follower(name, damping=0.05)).roots_beyond(0.0) == 0


@pytest.mark.parametrize(
    ("name", "critical", "growth"), [("fabric", 0.0333, 0.0497), ("steel-cord", 0.0482, 0.0931)]
)
def test_the_critical_gain_of_a_trim_loop(name: str, critical: float, growth: float) -> None:
    """Theory, 1 %: dead time 0.5 s, exact speeds; 1.1 times it grows as told."""
    base = station(name, ExactSpeed(), ExactSpeed())

    def at(factor: float) -> Linear:
        trim = Trim(gain=critical * factor, dead_time=0.5)
        return Linear.of(replace(base, drums=(base.drums[0], replace(base.drums[1], trim=trim))))

    assert at(0.99).roots_beyond(0.0) == 0
    assert at(1.01).roots_beyond(0.0) == 2
    assert at(1.1).rightmost.real == pytest.approx(growth, rel=0.01)


@pytest.mark.parametrize(("name", "critical"), [("fabric", 0.0333), ("steel-cord", 0.0482)])
@pytest.mark.parametrize("part", [0.5, 1.25])
def test_the_gain_margin_of_a_trim_loop(name: str, critical: float, part: float) -> None:
    """Theory, 1 %: the critical gain over the gain, above and below 1."""
    base = station(name, ExactSpeed(), ExactSpeed())
    trim = Trim(gain=part * critical, dead_time=0.5)
    linear = Linear.of(replace(base, drums=(base.drums[0], replace(base.drums[1], trim=trim))))
    assert gain_margin(linear, 1) == pytest.approx(1.0 / part, rel=0.01)
    assert math.isnan(gain_margin(linear, 0))


def test_the_gain_margin_of_a_follower_and_of_a_calm_loop() -> None:
    """Identity: at the margin the rightmost root is on the border."""
    linear = Linear.of(follower("fabric"))
    margin = gain_margin(linear, 1)
    assert 0.0 < margin < 1.0  # it grows as it is
    ratio = margin * linear.duties[1].torque / linear.duties[0].torque
    control = Follower(master="first", lag=0.1, ratio=ratio)
    at = linear.controlled(
        linear.station.drums[0], replace(linear.station.drums[1], control=control)
    )
    assert abs(at.rightmost.real) < 0.03
    loop = SpeedLoop(bandwidth=2.0, reset=1.0)
    assert gain_margin(Linear.of(station("fabric", loop, loop)), 1) == math.inf


def test_a_rigid_arc_answers_in_closed_form() -> None:
    """Z = (B/(c lam)) [L - (V/lam)(1 - e^(-lam L/V))] for a belt that does not stretch."""
    n, length, b, k, v = 1601, 1.3, 1.2, 2e8, 3.0
    xi = np.linspace(0.0, 1.0, n)
    profile = SteadyProfile(
        length=length,
        width=b,
        give=0.0,
        speed=v,
        share=1.0,
        overrun_slope=0.0,
        places=xi,
        by_creep=np.full(n, k),
        by_tension=np.zeros(n),
        tension=np.full(n, 1e5),
        creep=np.zeros(n),
    )
    lam = np.array([0.3 + 2j, 5j, 20j])
    expected = b * k / lam * (length - v / lam * (1.0 - np.exp(-lam * length / v)))
    assert profile.response(lam).entry_impedance == pytest.approx(expected, rel=1e-8)


def test_winding_counts_zeros() -> None:
    path = contour(0.0)
    pair = (path - complex(1.0, 8.0)) * (path - complex(1.0, -8.0))
    left = (path - complex(-1.0, 8.0)) * (path - complex(-1.0, -8.0))
    assert windings(pair / (path + 3.0) ** 2) == 2
    assert windings(left / (path + 3.0) ** 2) == 0


@pytest.mark.parametrize(
    "control",
    [
        Droop(droop=0.02, lag=0.05),
        SpeedLoop(bandwidth=2.0, reset=1.0),
        CoupledMotor(pump_inertia=900),
    ],
    ids=lambda c: c.words,
)
def test_small_disturbances_move_as_the_linear_view_says(control: Control) -> None:
    """Other code: the march in time, amplitude of the tension between the drums to 1 %."""
    s = station("steel-cord", control, control)
    march = March(s, Event(happenings=(OnDrum(pulley="second", run_out=2e-5, order=2),)), points=60)
    rows = []
    while march.t < 4.0:
        march.step()
        if march.t > 2.5:
            rows.append((march.drums[1].angle, march.T[1]))
    angle, tension = np.array(rows).T
    basis = np.stack([np.cos(2 * angle), np.sin(2 * angle), np.ones_like(angle)], axis=1)
    c = np.linalg.lstsq(basis, tension, rcond=None)[0]
    linear = Linear.of(s)
    lam = np.array([2j * linear.duties[1].speed])
    expected = abs(linear.forced(lam, "run-out", 1)["tension"][0, 1])
    assert math.hypot(c[0], c[1]) / 2e-5 == pytest.approx(expected, rel=0.01)


def test_a_tandem_with_held_tensions_is_a_series_circuit() -> None:
    """Theory, 2 %: T_hat = dV/(1/Z1 + 1/Z2 + lam l/EA) for a change of one exact speed."""
    linear = Linear.of(station("fabric", ExactSpeed(), ExactSpeed()))
    lam = 2j * math.pi * np.array([0.3, 1.0, 3.0])
    first, second = linear.responses(lam)
    stretch = 3.0 / TRAINS["fabric"].belt.axial_stiffness
    circuit = 1.0 / first.exit_impedance + 1.0 / second.entry_impedance + lam * stretch
    surface = linear.steady.members[1].surface_speed
    found = linear.forced(lam, "speed", 1)["tension"][:, 1]
    assert np.abs(found) == pytest.approx(np.abs(surface / circuit), rel=0.02)


def test_stability_tells_what_the_controls_do() -> None:
    """Theory: 3.3 % of the pull for 0.5 mm at exact speed, 2.7 at 1 % droop, fabric; exact speeds
    do not pulsate by themselves, a follower does."""
    answer = stability(follower("fabric"))
    assert not answer.stable
    assert answer.frequency == pytest.approx(17.516 / (2 * math.pi), rel=0.01)
    by_name = {c.name: c for c in answer.controls}
    assert by_name["exact speed"].stable
    assert by_name["exact speed"].pull * 0.5e-3 == pytest.approx(0.033, abs=0.002)
    assert by_name["droop 1 %"].pull < by_name["exact speed"].pull
    assert by_name["fluid coupling, slip 3 %"].power_loss == pytest.approx(0.031, abs=0.001)
    assert not by_name["torque follower"].stable
    assert by_name["torque follower, damping 3 %"].stable
    assert len(by_name) == len(answer.controls) == 8
    with pytest.raises(InputError, match="less than 50 mm"):
        stability(follower("fabric"), run_out=1.0)


def test_a_map_has_its_border_where_the_roots_cross() -> None:
    """Theory: a droop below 22 % was enough against a lag of 0.1 s."""
    found = stability_map(follower("steel-cord"), points=7, span=(0.01, 10.0))
    assert found.growing[3, 0] == 0
    assert found.growing[3, -1] == 2
    assert found.pull.shape == (7, 7)


def test_responses_fall_off_and_are_finite() -> None:
    found = response(
        Linear.of(station("fabric", Droop(), Droop())), "torque", "second", [0.1, 10.0]
    )
    assert np.all(np.isfinite(found.creep))
    assert abs(found.pull[1, 1]) < abs(found.pull[0, 1])


def test_a_speed_loop_crosses_over_at_its_bandwidth() -> None:
    """Closed form: gain over J times 2 pi i f is 1 in size at the bandwidth, without reset."""
    duty = Duty(speed=7.5, torque=2e4, inertia=2200.0, radius=0.4)
    loop = SpeedLoop(bandwidth=2.0, reset=1e3)
    crossing = 2j * math.pi * 2.0
    assert abs(loop.yielding(duty, crossing) / (duty.inertia * crossing)) == pytest.approx(
        1.0, rel=1e-6
    )
