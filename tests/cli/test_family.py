"""``wraparc family``: creep along the wrap for several tension ratios, the paper's Figure 1."""

import json
import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from answer.drives import drive
from cli.running import wraparc
from wraparc import InputError, solve
from wraparc.arc import WrapArc
from wraparc.arc.family import tension_ratio_family
from wraparc.friction import Constant
from wraparc.plot.family import plot_family

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
DRIVE = str(EXAMPLES / "head-drive-fabric.toml")


def arc(entry: float = 150e3, leaving: float = 60e3) -> WrapArc:
    described = drive(entry, leaving)
    return WrapArc.of(described, described.pulleys[0], described.load_cases[0])


def test_each_member_is_the_drive_solved_with_that_ratio() -> None:
    """Expected: `wraparc.solve` of the drive with T2 = T1/ratio written into it."""
    results = tension_ratio_family(arc(), (1.5, 3.0))
    for ratio, found in zip((1.5, 3.0), results, strict=True):
        alone = solve(drive(150e3, 150e3 / ratio), raise_on_failure=False).arcs[0]
        assert found.exit_creep == alone.exit_creep
        assert found.arc.entry_tension == 150e3


def test_a_braking_pulley_keeps_its_tight_side_too() -> None:
    (found,) = tension_ratio_family(arc(60e3, 150e3), (2.0,))
    assert (found.arc.entry_tension, found.arc.exit_tension) == (75e3, 150e3)
    assert found.exit_creep < 0.0


def test_creep_follows_the_closed_form_of_constant_friction() -> None:
    """u = (R/EA') [theta_s T1 - (T1 - T2)/mu], theta_s = ln(T1/T2)/mu, rigid lagging."""
    base = arc()
    plain = WrapArc(
        law=Constant(friction_coefficient=0.4), entry_tension=150e3, exit_tension=60e3,
        diameter=0.8, wrap_angle=math.pi, width=1.2, overrun=0.0,
        axial_stiffness=base.axial_stiffness,
        recovery=False,
    )  # fmt: skip
    for ratio, found in zip((1.5, 2.0, 3.0), tension_ratio_family(plain, (1.5, 2.0, 3.0)),
                            strict=True):  # fmt: skip
        slipping, low = math.log(ratio) / 0.4, 150e3 / ratio
        creep = 0.4 / plain.axial_stiffness * (slipping * 150e3 - (150e3 - low) / 0.4)
        assert found.exit_creep == pytest.approx(creep, rel=1e-6)


def test_a_larger_ratio_creeps_more_everywhere() -> None:
    """The paper's Figure 1: the curves lie above one another and the largest slips all along."""
    results = tension_ratio_family(arc(), (1.2, 1.6, 2.0, 3.0))
    at = np.linspace(0.05, math.pi, 50)
    curves = [np.interp(at, r.profile.position, r.profile.creep) for r in results]
    assert all((high > low).all() for low, high in pairwise(curves))
    assert curves[-1][0] > 0.0


def test_the_picture_has_a_curve_for_each_ratio() -> None:
    results = tension_ratio_family(arc(), (1.5, 2.0, 60.0))
    assert [r.status.solved for r in results] == [True, True, False]
    (ax,) = plot_family(results).figure.axes
    lines = {str(line.get_label()): line for line in ax.get_lines()}
    for r, name in zip(results, ("T1/T2 = 1.5", "T1/T2 = 2"), strict=False):
        assert np.asarray(lines[name].get_ydata()) == pytest.approx(1e3 * r.profile.creep)
    assert "T1/T2 = 60" not in lines
    legend = ax.get_legend()
    assert legend is not None
    assert legend.get_title().get_text() == "gross slip at T1/T2 = 60"


def test_the_command_prints_draws_and_writes(tmp_path: Path) -> None:
    picture, data = tmp_path / "f.svg", tmp_path / "f.json"
    ran = wraparc("family", DRIVE, "--ratios", "1.5, 2,3", "--plot", picture, "--json", data)
    assert ran.code == 0
    assert "T1/T2 = 1.5" in ran.out
    assert "T1 constant at 150 kN" in ran.out
    text = "Creep 9.17 mm exceeds the 6.35 mm limit at T1/T2 = 3 (head, design)."
    assert f"ATTENTION {text}" in ran.words
    assert "T1/T2 = 3" in picture.read_text("utf-8")
    told = json.loads(data.read_text("utf-8"))
    assert [r["ratio"] for r in told["results"]] == pytest.approx([1.5, 2.0, 3.0])
    ends = [r["creep"][-1] for r in told["results"]]
    assert [r["exit_creep"] for r in told["results"]] == pytest.approx(ends, rel=1e-12)


def test_a_ratio_that_cannot_be_carried_is_told_by_the_exit_code() -> None:
    ran = wraparc("family", DRIVE, "--ratios", "2,60")
    assert ran.code == 1
    assert "FAILS Gross slip: safety " in ran.words
    assert " is below 1 at T1/T2 = 60 (head, design)." in ran.words


def test_a_family_that_passes_says_up_to_which_ratio() -> None:
    ran = wraparc("family", DRIVE, "--ratios", "1.8,1.5")
    assert ran.code == 0
    assert "OK Creep passes up to T1/T2 = 1.8 (head, design)." in ran.words


def test_a_family_names_the_first_ratio_that_misses_the_worst_check() -> None:
    ran = wraparc("family", DRIVE, "--ratios", "3.3,3,3.1,1.5")
    assert " exceeds the 6.35 mm limit at T1/T2 = 3 (head, design)." in ran.words


@pytest.mark.parametrize(
    ("ratios", "sentence"),
    [("1", "must be more than 1"), ("two", "--ratios"), (",", "needs at least one"),
     ("0.5,2,nan", "ratios")],
)  # fmt: skip
def test_bad_ratios_are_refused(ratios: str, sentence: str) -> None:
    ran = wraparc("family", DRIVE, "--ratios", ratios)
    assert ran.code == 2
    assert sentence in ran.err
    assert "Traceback" not in ran.err


def test_every_bad_ratio_is_named() -> None:
    with pytest.raises(InputError) as caught:
        tension_ratio_family(arc(), (0.5, 2.0, 2000.0))
    assert [p.value for p in caught.value.problems] == ["0.5", "2000"]


@pytest.mark.parametrize(
    "asked", [("family", "--ratios", "1.2"), ("what-if", "--thickness", "18 mm")]
)
def test_a_pulley_is_asked_about_where_the_take_up_stands_at_another(
    asked: tuple[str, ...], tmp_path: Path
) -> None:
    """Expected: the answer without the take-up, but for the least tension, which it holds."""
    text = (EXAMPLES / "tandem-fabric.toml").read_text("utf-8")
    path, (command, *more) = tmp_path / "drive.toml", asked
    told = []
    for take_up in ("", '[take_up]\nkind = "gravity"\nafter = "first"\n'):
        path.write_text(text + take_up, "utf-8")
        words = wraparc(command, path, "--pulley", "second", *more).words
        told.append(words.partition("Minimum")[0])
    assert "creep" in told[0]
    assert told[0] == told[1]
