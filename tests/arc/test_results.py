"""What a result says besides its march: energy, shares outside, overrun, errors, odd inputs.

Expected values: independent computation from the profile or from the formula, written out here.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from arc.drives import ARC, LAWS, RANGE, RUBBER, random_arc
from wraparc import InputError
from wraparc.arc import ArcResult, Distributed, Status, WrapArc
from wraparc.friction import IntegralLog, TestedRange

QUICK = Distributed(capacities=False)
FINE = Distributed(capacities=False, points=4000)
SPEED = 3.7
_JUMPING = {"constant", "power", "jump table", "elastic-plastic"}


def integral(y: np.ndarray, x: np.ndarray) -> float:
    """Trapezoids."""
    return float(np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(x)))


@pytest.mark.parametrize("law", list(LAWS))
@pytest.mark.parametrize("tensions", [(150e3, 75e3), (70e3, 140e3)], ids=["driving", "braking"])
def test_energy_from_the_profile(law: str, tensions: tuple[float, float]) -> None:
    """Losses from tau along 4,000 points of the arc: int tau dx, and the shear given up.

    v_s int tau du B is the loss too: the belt goes slower than the shell by du/ds.
    """
    arc = replace(
        ARC, law=LAWS[law], entry_tension=tensions[0], exit_tension=tensions[1], belt_speed=SPEED,
        wear_coefficient=2e-15, overrun=0.0 if law in _JUMPING else 2e-4,
    )  # fmt: skip
    result = FINE.solve(arc)
    p, energy = result.profile, result.energy
    surface = SPEED / (1.0 - result.entry_creep_ratio)
    sliding = integral(p.shear_stress, p.slip)
    given_up = 0.5 * arc.thickness / arc.shear_modulus * (
        p.shear_stress[-1] ** 2 - p.shear_stress[0] ** 2
    )  # fmt: skip
    assert energy.sliding_power == pytest.approx(surface * arc.width * sliding, rel=1e-5)
    assert energy.shear_loss == pytest.approx(surface * arc.width * given_up, rel=1e-6)
    loss = surface * arc.width * integral(p.shear_stress, p.creep)
    assert energy.power_loss == pytest.approx(loss, rel=1e-5)
    assert energy.power_loss == pytest.approx(energy.sliding_power + energy.shear_loss, rel=1e-12)
    power = surface * (tensions[0] - tensions[1])
    assert energy.transmitted_power == pytest.approx(power, rel=1e-9)
    # driving: the shaft gives the power, the belt gets it less the loss; braking: the belt gives
    # the shaft power and the loss, the shaft gets the power
    if power > 0.0:
        assert energy.efficiency == pytest.approx((power - loss) / power, rel=1e-7)
    else:
        assert energy.efficiency == pytest.approx(-power / (-power + loss), rel=1e-7)
    assert 0.97 < energy.efficiency < 1.0
    assert energy.frictional_energy == pytest.approx(sliding, rel=1e-5)
    assert energy.wear_rate == pytest.approx(1e6 * 2e-15 * sliding, rel=1e-5)


def test_the_belt_loses_what_the_shaft_gives_and_it_does_not_get() -> None:
    """Balance of a slice of belt: T v at both nips with the speeds of the belt there, and EA.

    v ~ 1 + T/EA; the power to the belt is the integral of v dT, and with the loss that of the
    surface, whose speed rises by kappa (T1 - T) as the lagging recovers.
    """
    arc = replace(ARC, law=RUBBER, belt_speed=SPEED)
    result = FINE.solve(arc)
    tension, g = result.profile.tension, result.entry_creep_ratio
    # the model is of first order in strains: speeds over that of the surface at the entry
    belt = 1.0 - g - (tension[0] - tension) / arc.axial_stiffness
    surface = 1.0 + arc.recovery_compliance * (tension[0] - tension)
    given, taken = integral(surface, -tension), integral(belt, -tension)
    v_s = SPEED / (1.0 - g)
    assert result.energy.power_loss == pytest.approx(v_s * (given - taken), rel=1e-5)


def test_no_speed_no_power_and_idle_no_efficiency() -> None:
    without = QUICK.solve(replace(ARC, law=RUBBER)).energy
    for name in ("transmitted_power", "sliding_power", "shear_loss", "power_loss", "wear_rate"):
        assert math.isnan(getattr(without, name)), name
    assert without.efficiency == pytest.approx(
        QUICK.solve(replace(ARC, law=RUBBER, belt_speed=SPEED)).energy.efficiency, rel=1e-12
    )
    idle = QUICK.solve(replace(ARC, law=RUBBER, exit_tension=ARC.entry_tension, belt_speed=SPEED))
    assert math.isnan(idle.energy.efficiency)
    assert idle.energy.power_loss == 0.0


def outside_by_brute_force(result: ArcResult, tested: TestedRange) -> float:
    """Part of half a million even places where pressure or slip lies outside."""
    p = result.profile
    s = np.linspace(0.0, p.position[-1], 500_001)
    pressure, slip = np.interp(s, p.position, p.wrap_pressure), np.interp(s, p.position, p.slip)
    out = (pressure < tested.pressure_min) | (pressure > tested.pressure_max)
    return float(np.mean(out | (np.abs(slip) > tested.slip_max)))


@pytest.mark.parametrize(
    ("entry", "leaving"),
    [(150e3, 60e3), (150e3, 15e3), (320e3, 160e3), (330e3, 40e3), (18e3, 120e3), (400e3, 350e3)],
)
@pytest.mark.parametrize("slip", [12e-3, 2e-3])
def test_share_outside_the_tested_range(entry: float, leaving: float, slip: float) -> None:
    tested = replace(RANGE, slip_max=slip)
    law = IntegralLog(coefficients=RUBBER.coefficients, tested=tested)
    arc = replace(ARC, law=law, entry_tension=entry, exit_tension=leaving)
    result = FINE.solve(arc)
    expected = outside_by_brute_force(result, tested)
    assert result.outside_tested_share == pytest.approx(expected, abs=1e-5)
    # an arc reported at fewer points says the same
    assert QUICK.solve(arc).outside_tested_share == pytest.approx(expected, abs=1e-4)


def test_the_overrun_is_that_of_a_string_on_an_elastic_layer() -> None:
    """x_c = 1.25 delta sqrt(delta/R), delta = h p1/E_c; written out in numbers."""
    arc = replace(ARC, law=RUBBER, overrun=None)
    p1 = 2.0 * 150e3 / (1.2 * 0.8)  # 312.5 kPa
    delta = 12e-3 * p1 / 10e6  # 0.375 mm
    assert delta == pytest.approx(0.375e-3)
    expected = 1.25 * delta * math.sqrt(delta / 0.4)  # 0.014353 mm
    assert expected == pytest.approx(1.435e-5, rel=1e-3)
    assert arc.entry_overrun == pytest.approx(expected, rel=1e-14)
    for tensions in ((150e3, 60e3), (150e3, 150e3), (150e3, 200e3)):
        solved = QUICK.solve(replace(arc, entry_tension=tensions[0], exit_tension=tensions[1]))
        # rearward always, whether driving, idling or braking
        creep = solved.profile.creep[0]
        assert creep == pytest.approx(expected, rel=1e-9), tensions


@pytest.mark.parametrize("law", list(LAWS))
@pytest.mark.parametrize("overrun", [0.0, None])
def test_the_smallest_pulls(law: str, overrun: float | None) -> None:
    """No breakaway, and creep goes on steadily to that of an idle pulley."""
    arc = replace(ARC, law=LAWS[law], overrun=overrun if law not in _JUMPING else 0.0)
    idle = QUICK.solve(replace(arc, exit_tension=arc.entry_tension))
    assert idle.status is Status.SOLVED
    last = math.inf
    for part in 10.0 ** np.arange(-6.0, -17.0, -1.8):
        pull = float(part) * arc.entry_tension
        for sign in (1.0, -1.0):
            result = QUICK.solve(replace(arc, exit_tension=arc.entry_tension - sign * pull))
            assert result.status is Status.SOLVED, (part, sign)
            off = abs(result.exit_creep - idle.exit_creep)
            assert off <= last * 1.1 + 1e-13, (part, sign)
        last = off


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"entry_tension": 0.0}, "entry_tension: must be positive and finite, got 0 N."),
        ({"exit_tension": -5.0}, "exit_tension: must be positive and finite, got -5 N."),
        ({"diameter": math.inf}, "diameter: must be positive and finite, got inf m."),
        ({"wrap_angle": math.nan}, "wrap_angle: must be positive and finite, got nan rad."),
        ({"width": -1.2}, "width: must be positive and finite, got -1.2 m."),
        ({"creep_limit": 0.0}, "creep_limit: must be positive and finite, got 0 m."),
        ({"thickness": -0.01}, "thickness: must be 0 or positive, and finite, got -0.01 m."),
        ({"overrun": -math.inf}, "overrun: must be finite, got -inf m."),
        ({"axial_stiffness": 0.0}, "axial_stiffness: must be positive, got 0 N."),
        ({"shear_modulus": math.nan}, "shear_modulus: must be positive, got nan Pa."),
        ({"compression_modulus": -1.0}, "compression_modulus: must be positive, got -1 Pa."),
    ],
)
def test_what_is_no_arc(change: dict[str, float], sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        replace(ARC, **change)  # type: ignore[arg-type]
    assert str(caught.value) == sentence


def test_everything_wrong_with_an_arc_is_told_at_once() -> None:
    with pytest.raises(InputError) as caught:
        replace(ARC, entry_tension=-1.0, diameter=0.0, thickness=-1.0, axial_stiffness=-1.0)
    keys = [problem.key for problem in caught.value.problems]
    assert keys == ["entry_tension", "diameter", "thickness", "axial_stiffness"]


def test_a_kick_beyond_what_a_law_holds_is_refused() -> None:
    with pytest.raises(InputError, match=r"where this law starts to slip, got 0\.005 m\. Write"):
        replace(ARC, overrun=5e-3)


#: Drives at the ends of what anybody might give: change, and whether friction can carry the load.
EXTREMES: dict[str, tuple[dict[str, float], bool]] = {
    "a string": ({"width": 1e-3, "axial_stiffness": 1e4, "entry_tension": 80.0,
                  "exit_tension": 40.0}, True),
    "a toy": ({"diameter": 5e-3, "width": 5e-3, "entry_tension": 2.0, "exit_tension": 1.0}, True),
    "a giant": ({"diameter": 5.0, "width": 4.0, "entry_tension": 8e6, "exit_tension": 5e6,
                 "axial_stiffness": 1e9}, True),
    "a nudge of wrap": ({"wrap_angle": 1e-3}, False),
    "many turns": ({"wrap_angle": 20.0}, True),
    "a rigid belt": ({"axial_stiffness": math.inf}, True),
    "a rubber band": ({"axial_stiffness": 5e5}, True),
    "bare": ({"thickness": 0.0}, True),
    "very soft lagging": ({"shear_modulus": 3e5}, True),
    "hardly any slack side": ({"exit_tension": 1.0}, False),
    "almost no pull": ({"exit_tension": 150e3 - 1e-3}, True),
    "a great pressure": ({"diameter": 0.05}, True),
}  # fmt: skip


@pytest.mark.parametrize("name", list(EXTREMES))
@pytest.mark.parametrize("law", ["rubber", "softening", "constant"])
def test_extreme_inputs_solve_or_say_why(law: str, name: str) -> None:
    """Tensions met, the loss identity kept, no warning; or a breakaway with finite numbers."""
    change, _ = EXTREMES[name]
    arc: WrapArc = replace(replace(ARC, law=LAWS[law]), **change)  # type: ignore[arg-type]
    result = QUICK.solve(arc)
    assert result.status in (Status.SOLVED, Status.BREAKAWAY)
    assert np.all(np.isfinite(result.profile.tension))
    assert np.all(np.isfinite(result.profile.slip))
    if result.status is Status.SOLVED:
        assert result.profile.tension[-1] == pytest.approx(arc.exit_tension, rel=1e-8)
        assert result.energy.identity_error < 1e-4
        along = arc.radius * result.profile.position
        sheared = integral(result.profile.shear_stress, along) * arc.width
        assert sheared == pytest.approx(
            arc.effective_tension, rel=2e-2, abs=1e-9 * arc.entry_tension
        )


@pytest.mark.parametrize("name", [n for n, (_, carries) in EXTREMES.items() if not carries])
def test_extremes_that_friction_cannot_carry(name: str) -> None:
    """Constant friction carries exp(mu phi) and no more."""
    arc: WrapArc = replace(ARC, **EXTREMES[name][0])  # type: ignore[arg-type]
    assert arc.entry_tension / arc.exit_tension > math.exp(0.4 * arc.wrap_angle)
    assert QUICK.solve(arc).status is Status.BREAKAWAY


def test_random_drives_keep_the_loss_identity() -> None:
    rng = np.random.default_rng(20)
    for law in LAWS.values():
        for _ in range(4):
            result = QUICK.solve(random_arc(law, rng))
            if result.status is Status.SOLVED:
                assert result.energy.identity_error < 5e-5


@pytest.mark.parametrize("ratio", [1.5, 600.0])
def test_a_scalar_is_that_of_all(ratio: float) -> None:
    result = Distributed().solve(replace(ARC, exit_tension=ARC.entry_tension / ratio))
    assert (result.status is Status.BREAKAWAY) == (ratio > 100.0)
    for name, value in result.scalars().items():
        assert result.scalar(name) == pytest.approx(value, rel=0.0, nan_ok=True), name
    with pytest.raises(KeyError):
        result.scalar("no such result")
