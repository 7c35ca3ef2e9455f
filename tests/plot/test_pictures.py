"""Pictures: what is drawn is the result, in the units asked for; files are whole and the same."""

import math
import re
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.patches import Rectangle

from answer.drives import STICKY, drive, marched, solved, sticking
from wraparc import (
    DriveResult,
    InputError,
    MissingExtraError,
    load_lagging,
    solve,
    solve_train,
)
from wraparc.checks import Level
from wraparc.plot import Picture, plot, plot_arc, plot_drive, plot_lagging
from wraparc.plot.picture import BEYOND, RAMP, ramp
from wraparc.plot.profiles import most_friction, outside_spans
from wraparc.plot.pulley import _TURN, _places
from wraparc.plot.reserve import Bars, plot_reserve
from wraparc.plot.train import plot_train
from wraparc.reserve import Flip, Input, Uncertainty
from wraparc.train.file import load_train
from wraparc.units import System, unit_factor

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.lines import Line2D

EXAMPLES = Path(__file__).parents[2] / "examples"
UNITS: dict[System, dict[str, str]] = {
    "si": {"length": "mm", "force": "kN", "pressure": "kPa"},
    "us": {"length": "in", "force": "lbf", "pressure": "psi"},
}


def axes(picture: Picture) -> "dict[str, Axes]":
    """Axes by title; a colour bar by its label."""
    found = {}
    for ax in picture.figure.axes:
        name = ax.get_title(loc="left") or ax.get_title() or ax.get_xlabel()
        found[name.partition("\n")[0]] = ax
    return found


def lines(ax: "Axes") -> "dict[str, Line2D]":
    return {str(line.get_label()): line for line in ax.get_lines()}


def drawn(line: "Line2D") -> np.ndarray:
    return np.asarray(line.get_ydata(), float)


@pytest.mark.parametrize("system", ["si", "us"])
def test_the_profiles_are_those_of_the_result(system: System) -> None:
    shown, profile = axes(plot_drive([solved()], system)), solved().arc("head").profile
    length, force, pressure = (
        unit_factor(UNITS[system][d], d) for d in ("length", "force", "pressure")
    )
    creep = lines(shown["Creep and slip"])
    assert drawn(creep["creep"]) * length == pytest.approx(profile.creep)
    assert drawn(creep["slip"]) * length == pytest.approx(profile.slip)
    assert drawn(creep["limit"])[0] * length == pytest.approx(6.35e-3)
    tension = shown["Belt tension"].get_lines()[0]
    assert drawn(tension) * force == pytest.approx(profile.tension)
    assert np.asarray(tension.get_xdata()) == pytest.approx(np.degrees(profile.position))
    friction = lines(shown["Friction"])
    assert drawn(friction["available"]) == pytest.approx(profile.friction)
    assert drawn(friction["used"]) == pytest.approx(profile.friction_used)
    shear = shown["Lagging shear"].get_lines()
    assert drawn(shear[0]) * pressure == pytest.approx(profile.shear_stress)
    assert f"[{UNITS[system]['pressure']}]" in shown["Lagging shear"].get_ylabel()


def test_both_sides_of_the_tension_axis_agree() -> None:
    """p = 2 T/(B D): 150 kN on 1.2 m and 0.8 m are 312.5 kPa."""
    shown = plot_drive([solved()])
    ax = axes(shown)["Belt tension"]
    (right,) = ax.child_axes
    shown.to_bytes("svg")  # puts the scales in place
    top = ax.get_ylim()[1]
    assert right.get_ylim()[1] == pytest.approx(2.0 * top / (1.2 * 0.8))
    assert right.get_ylabel() == "Wrap pressure [kPa]"


def test_the_pulley_is_coloured_by_the_quantity_asked_for() -> None:
    from matplotlib.collections import PolyCollection

    result = solved().arc("head")
    for quantity in ("shear_stress", "creep", "friction_used"):
        ax = plot_arc([result], quantity=quantity).figure.axes[0]
        (cells,) = (c for c in ax.collections if isinstance(c, PolyCollection))
        values = np.asarray(cells.get_array())
        profile = getattr(result.profile, quantity)
        scale = {"shear_stress": 1e3, "creep": 1e-3, "friction_used": 1.0}[quantity]
        assert len(values) == 180
        assert values.max() * scale == pytest.approx(np.abs(profile).max(), rel=2e-2)
        assert cells.get_clim()[0] == 0.0


def test_an_unknown_quantity_is_refused_with_the_known_ones() -> None:
    with pytest.raises(InputError, match=r'quantity: .*only position, tension.*, got "shear"'):
        solved().plot(quantity="shear")


def test_the_belt_comes_in_at_the_top_and_leaves_at_the_bottom() -> None:
    result = solved().arc("head")
    places = _places(result, np.array([0.0, 90.0, 180.0]), 1.0)
    assert places == pytest.approx(np.array([[0.0, 1.0], [1.0, 0.0], [0.0, -1.0]]), abs=1e-12)


def test_tensions_duty_and_nips_are_written() -> None:
    def words(result: DriveResult) -> set[str]:
        return {text.get_text() for text in plot_drive([result]).figure.axes[0].texts}

    assert words(solved()) >= {"T1 = 150 kN", "T2 = 60 kN", "driving", "entry nip", "exit nip"}
    assert "braking" in words(solved(60e3, 80e3))


def test_the_second_method_is_drawn_over_the_first() -> None:
    shown = axes(plot_drive([solved(), marched()]))
    for title in ("Belt tension", "Friction", "Creep and slip", "Lagging shear"):
        assert "paper's integration" in lines(shown[title])
    other = lines(shown["Creep and slip"])["paper's integration"]
    assert drawn(other)[-1] == pytest.approx(1e3 * marched().arc("head").exit_creep)
    labels = [label.get_text() for label in shown["Creep by source"].get_yticklabels()]
    assert labels == ["distributed", "paper's integration"]


def test_the_creep_budget_is_drawn_to_scale() -> None:
    result = solved().arc("head")
    bars = axes(plot_drive([solved()]))["Creep by source"].patches
    parts = (result.creep_shrinkage, result.creep_compression, result.creep_global)
    widths = [bar.get_width() for bar in bars]  # type: ignore[attr-defined]
    assert widths == pytest.approx([1e3 * part for part in parts])
    ends = [bar.get_x() + bar.get_width() for bar in bars]  # type: ignore[attr-defined]
    assert ends[-1] == pytest.approx(1e3 * result.exit_creep)


def test_zones_at_rest_and_outside_the_tested_range_are_hatched() -> None:
    result = sticking().arc("head")
    spans = outside_spans(result)
    share = sum(stop - start for start, stop in spans) / 180.0
    assert share == pytest.approx(result.outside_tested_share, abs=0.02)
    shown = axes(plot_drive([sticking()]))
    ax = shown["Belt tension"]
    hatched = [patch for patch in ax.patches if patch.get_hatch()]
    assert len(hatched) == 1 + len(spans)
    legend = ax.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == [
        "belt at rest", "outside the tested range"
    ]  # fmt: skip
    clean = axes(plot_drive([solved()]))["Belt tension"]
    assert [patch for patch in clean.patches if patch.get_hatch()] == []


def test_the_largest_tested_friction_is_that_of_the_law() -> None:
    result = solved().arc("head")
    most = most_friction(result)
    assert most is not None
    law, pressure = result.arc.law, result.profile.wrap_pressure
    assert law.tested is not None
    # diamond rubber has no peak within its tested slip
    assert most == pytest.approx(law.friction(law.tested.slip_max, pressure))
    untested = replace(STICKY, law=replace(STICKY.law, tested=None))  # type: ignore[call-arg]
    assert most_friction(solve(drive(lagging=untested, overrun=0.0)).arc("head")) is None


def test_title_answer_and_remarks_are_written() -> None:
    texts = [text.get_text() for text in plot_drive([solved()]).figure.texts]
    assert texts[0] == "Test drive - pulley head, load case full"
    assert texts[1].startswith("Creep at exit 7.49 mm, more than the limit of 6.35 mm;")
    assert "The friction of diamond-rubber is illustrative" in texts[2]
    broken = [text.get_text() for text in plot_drive([solved(150e3, 2e3)]).figure.texts]
    assert "Gross slip: friction cannot transmit this load, T1/T2 = 75." in broken
    assert any(text.startswith("The whole wrap slips:") for text in broken)
    assert list(axes(plot_drive([solved(150e3, 2e3)]))) == [""]  # the pulley alone


def test_a_wrap_beyond_one_turn_is_a_spiral() -> None:
    """One turn on, a point stands in the same direction, the belt's thickness further out."""
    arc = solve(drive(wrap_angle=math.radians(420.0)), raise_on_failure=False).arcs[0]
    (x, y), (there_x, there_y) = _places(arc, np.array([30.0, 390.0]), 1.0)
    assert math.atan2(there_y, there_x) == pytest.approx(math.atan2(y, x), abs=1e-12)
    assert math.hypot(there_x, there_y) - math.hypot(x, y) == pytest.approx(_TURN, rel=1e-9)
    assert _TURN > 0.0
    (first, last) = _places(solved().arcs[0], np.array([0.0, 180.0]), 1.0)
    assert math.hypot(*first) == pytest.approx(math.hypot(*last), rel=1e-12)


@pytest.mark.parametrize("wrap", [15.0, 240.0, 720.0])
def test_any_wrap_can_be_drawn(wrap: float) -> None:
    turned = drive(100e3, 97e3, wrap_angle=math.radians(wrap))
    picture = plot_drive([solve(turned)])
    ticks = axes(picture)["Lagging shear"].get_xticks()
    assert 2 <= len(ticks) <= 11
    assert picture.to_bytes("svg")


# ---- laggings ----


@pytest.mark.parametrize("system", ["si", "us"])
def test_a_lagging_is_drawn_over_slip_and_pressure(system: System) -> None:
    lagging = load_lagging("medium-ceramic")
    shown = axes(plot_lagging(lagging, system))
    length, pressure = (unit_factor(UNITS[system][d], d) for d in ("length", "pressure"))
    curves = shown["Friction over slip, at wrap pressures"].get_lines()
    assert len(curves) == 6
    slip = np.asarray(curves[0].get_xdata(), float) * length
    assert drawn(curves[0]) == pytest.approx(lagging.law.friction(slip, 34e3))
    traction = shown["Traction over pressure, at slips"].get_lines()[-1]
    at = np.asarray(traction.get_xdata(), float) * pressure
    expected = lagging.law.friction(15e-3, at) * at
    assert drawn(traction) * pressure == pytest.approx(expected)
    unit = UNITS[system]["length"]
    assert f"A and b of mu = A x ln(x) - b x, x in [{unit}]" in shown
    peak = shown["Peak of the curves over pressure"].get_lines()[0]
    assert drawn(peak).max() * length == pytest.approx(23e-3)


def test_a_law_without_coefficients_has_half_the_panels() -> None:
    assert len(plot_lagging(STICKY).figure.axes) == 2
    untested = replace(STICKY, law=replace(STICKY.law, tested=None))  # type: ignore[call-arg]
    assert len(plot_lagging(untested).figure.axes) == 2


def test_an_illustrative_lagging_says_so_in_its_picture() -> None:
    texts = [t.get_text() for t in plot_lagging(load_lagging("full-ceramic")).figure.texts]
    assert "Illustrative: it describes no real product." in texts[-1]


# ---- showing and saving ----


def test_results_and_laggings_draw_themselves() -> None:
    for thing in (solved(), solved().arc("head"), load_lagging("full-ceramic")):
        assert thing.plot(units="us")._repr_svg_().lstrip().startswith("<?xml")
    with pytest.raises(TypeError, match="no picture of Drive; solve it first"):
        drive().plot()


@pytest.mark.parametrize(
    ("suffix", "begins"),
    [(".svg", b"<?xml"), (".png", b"\x89PNG"), (".PDF", b"%PDF")],
)
def test_files_by_their_ending_are_the_same_every_time(
    tmp_path: Path, suffix: str, begins: bytes
) -> None:
    files = [tmp_path / f"{i}{suffix}" for i in range(2)]
    for file in files:
        plot(solved()).save(file)
    first, second = (file.read_bytes() for file in files)
    assert first.startswith(begins)
    assert first == second
    assert len(list(tmp_path.iterdir())) == 2


def test_other_endings_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"must end in \.svg or \.png or \.pdf"):
        plot(solved()).save(tmp_path / "a.jpg")
    assert list(tmp_path.iterdir()) == []


def test_the_settings_of_the_reader_are_neither_used_nor_changed() -> None:
    import matplotlib as mpl

    before = dict(mpl.rcParams)
    plain = plot(solved()).to_bytes("svg")
    assert dict(mpl.rcParams) == before
    with mpl.rc_context({"font.size": 30.0, "lines.linewidth": 9.0}):
        assert plot(solved()).to_bytes("svg") == plain


@pytest.mark.parametrize("draw", [plot_drive, plot_arc, plot_lagging])
def test_without_matplotlib_the_extra_is_named(
    monkeypatch: pytest.MonkeyPatch, draw: Callable[..., Picture]
) -> None:
    things = {
        plot_drive: [solved()], plot_arc: [solved().arc("head")],
        plot_lagging: load_lagging("full-ceramic"),
    }  # fmt: skip
    for name in ("matplotlib", "matplotlib.figure"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(MissingExtraError, match=r"pip install 'wraparc\[plot\]'"):
        draw(things[draw])


def test_a_train_whose_drive_slips_through_is_drawn_without_it() -> None:
    """What is drawn is the drum that carries; the other is named."""
    train = load_train(EXAMPLES / "tandem-fabric.toml")
    slack = replace(train, cases=tuple(replace(c, exit_tension=300.0) for c in train.cases))
    result = solve_train(slack, raise_on_failure=False)
    assert not result.solved
    picture = plot_train(result)
    along = picture.figure.axes[1]
    lengths = [np.size(line.get_xdata()) for line in along.get_lines()][:2]
    assert lengths[0] > 100
    assert lengths[1] == 0
    words = [text.get_text() for ax in picture.figure.axes for text in ax.texts]
    assert "slips as a whole" in words
    assert any(text.endswith("gross slip") for text in words)
    assert picture.to_bytes("svg")


def test_all_that_is_drawn_is_on_the_picture() -> None:
    """An axis of five digits beyond the left edge of its figure: the picture is as much wider."""
    from matplotlib.figure import Figure

    def width(left: float) -> float:
        figure = Figure(figsize=(4.0, 3.0))
        axes = figure.add_axes((left, 0.2, 0.6, 0.6))
        axes.plot([0.0, 1.0], [0.0, 20000.0])
        axes.set_ylabel("Belt tension [lbf]")
        found = re.search(r'width="([\d.]+)pt"', Picture(figure).to_bytes("svg").decode())
        assert found is not None
        return float(found[1])

    assert width(0.3) == pytest.approx(4.0 * 72.0)
    # 5 more digits and a label stand left of the axis, 0.55 in or more
    assert 4.35 * 72.0 < width(0.02) < 5.0 * 72.0


def test_the_bars_of_a_reserve_end_where_the_verdict_changes() -> None:
    """Expected: changes and uncertainties of two made-up inputs, in per cent."""
    own = Uncertainty(0.3, lower=0.1)
    pull = (
        Flip(Input("effective_tension"), 0.2, Level.FAILS, "start", own),
        Flip(Input("effective_tension"), -0.45, Level.OK, "start", own),
    )
    wrap = (Flip(Input("wrap_angle"), -0.25, Level.FAILS, "start", Uncertainty(0.02)),)
    picture = plot_reserve([Bars("Te", pull), Bars("wrap", wrap)])
    (ax,) = picture.figure.axes
    bars = [(bar.get_x(), bar.get_width()) for bar in ax.patches if isinstance(bar, Rectangle)]
    expected = [(-10.0, 40.0), (0.0, 20.0), (0.0, -45.0), (-2.0, 4.0), (0.0, -25.0)]
    assert np.array(bars) == pytest.approx(np.array(expected))
    assert [label.get_text() for label in ax.get_yticklabels()] == ["Te", "wrap"]
    assert ax.get_legend() is not None
    assert ax.get_xlim() == pytest.approx((-50.0, 100.0))
    assert b"FAILS at its end" in picture.to_bytes("svg")


def test_one_ramp_of_quantities_on_the_page_and_in_pictures() -> None:
    # expected: the colours that the light page names
    style = (EXAMPLES.parent / "src/wraparc/web/static/style/frame.css").read_text("utf-8")
    light = style.partition("@media")[0]
    named = tuple(re.findall(r"--q\d: (#\w+);", light))
    assert named == RAMP
    assert re.findall(r"--warn-fill: (#\w+);", light) == [BEYOND]
    ends = [to_hex(ramp()(part)) for part in (0.0, 1.0, 1.1)]
    assert ends == [RAMP[0], RAMP[-1], BEYOND]
