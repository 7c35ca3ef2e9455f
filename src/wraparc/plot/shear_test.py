"""Pictures of a fitted test plan: curves, residuals, derivative check, pressure dependence."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.plot.picture import BLUE, GREY, ORANGE, RED, Picture, ramp, styled
from wraparc.shear_test.analysis import ConditionResult, TestResult
from wraparc.shear_test.curve_fit import Z95
from wraparc.shear_test.derivative import derivative_check

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

_REPEATS = (BLUE, ORANGE, "#009e73", "#cc79a7", GREY)
_MOST_PANELS = 12
_MOST_DOTS = 125
_COLUMNS = 4
_Band = tuple[Array, list[tuple[Array, Array]]]
_LOG_TICKS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)
_MM, _KPA = 1e-3, 1e3
# Where titles stand, said: to find it out takes a tenth of the drawing.
_ABOVE = 1.0


def curves_picture(condition: ConditionResult) -> Picture:
    """Every curve with its fit and the law, a panel for each pressure."""
    with styled():
        figure, panels = _panels(condition)
        for ax, level, tests in panels:
            top = 0.0
            for k, test in enumerate(tests):
                colour = _REPEATS[k % len(_REPEATS)]
                x, y = _readings(test)
                ax.plot(x / _MM, y, ".", ms=3.2, mew=0, color=colour, alpha=0.6)
                keep = _thin(test, 90)
                x = np.maximum(test.fit.slip, 0.0)[keep]
                ax.plot(x / _MM, test.fit.fitted[keep], color=colour, lw=0.8)
                top = max(top, float(test.fit.fitted.max()))
            pressure = condition.found.level_pressures()[level]
            slip = np.linspace(0.0, max(test.fit.slip_max for test in tests), 120)
            law = condition.tested_law.friction(slip, pressure)
            ax.plot(slip / _MM, law, color="black", lw=1.2, ls=(0, (4, 2)))
            ax.set_ylim(0.0, 1.12 * max(top, float(law.max())))
            ax.set_xlim(left=-0.02 * slip[-1] / _MM)
        _legend(
            figure,
            ["readings (dots), each test with its fit (line)", "law of all tests (dashed)"],
            [BLUE, "black"],
        )
        return Picture(figure)


def checks_picture(condition: ConditionResult) -> Picture:
    """What the fits leave over, and the paper's check by the derivative, all curves together.

    Left: measured less fitted friction, averaged over thirtieths of the slip, in units of the
    noise of one reading. Right: five-point derivative (dots) and A ln x + (A - b) (lines).
    """
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(10.5, 3.9))
        left, right = figure.subplots(
            1, 2, gridspec_kw={"left": 0.06, "right": 0.985, "top": 0.92, "bottom": 0.24}
        )
        _draw_residuals(left, condition)
        _draw_derivatives(right, condition)
        lines = _pressure_lines(condition)
        figure.legend(handles=lines, loc="lower left", ncols=8, bbox_to_anchor=(0.05, 0.0))
        return Picture(figure)


def _draw_residuals(ax: "Axes", condition: ConditionResult) -> None:
    ax.axhspan(-1.0, 1.0, color="#e4e4e4", lw=0)
    ax.axhline(0.0, color="#444444", lw=0.6)
    reach = 1.5
    for level, test in zip(condition.found.levels, condition.tests, strict=True):
        x, y = _averaged(test, 30)
        y = y / max(test.curve.noise, 1e-12)
        reach = max(reach, 1.1 * float(np.abs(y).max()))
        ax.plot(x / _MM, y, color=_shade(condition, int(level)), lw=0.9)
    ax.set_ylim(-reach, reach)
    ax.set_xlabel("slip [mm]")
    ax.set_ylabel("measured - fitted [noise of a reading]")
    ax.set_title("What the fits leave over", y=_ABOVE)


def _draw_derivatives(ax: "Axes", condition: ConditionResult) -> None:
    for level, test in zip(condition.found.levels, condition.tests, strict=True):
        check = derivative_check(test.fit)
        if check is None:
            continue
        colour = _shade(condition, int(level))
        ax.plot(check.slip / _MM, check.slope * _MM, ".", ms=3.4, mew=0, color=colour, alpha=0.8)
        ax.plot(check.slip / _MM, check.law * _MM, color=colour, lw=0.9)
    ax.set_xscale("log")
    low, high = ax.get_xlim()
    ticks = [t for t in _LOG_TICKS if low <= t <= high]
    ax.set_xticks(ticks, [f"{t:g}" for t in ticks])
    ax.set_xticks([], minor=True)
    ax.set_xlabel("slip [mm]")
    ax.set_ylabel("d friction / d slip [1/mm]")
    ax.set_title("Derivative (dots) and A ln x + (A - b) (lines)", y=_ABOVE)


def _shade(condition: ConditionResult, level: int) -> tuple[float, float, float, float]:
    count = max(int(condition.found.levels.max()), 1)
    red, green, blue, opacity = ramp()(0.25 + 0.75 * level / count)
    return red, green, blue, opacity


def _pressure_lines(condition: ConditionResult) -> list["Line2D"]:
    from matplotlib.lines import Line2D

    pressures = condition.found.level_pressures()
    return [
        Line2D([], [], color=_shade(condition, k), lw=2, label=f"{pressures[k] / _KPA:.4g} kPa")
        for k in _chosen_levels(condition)
    ]


def pressure_picture(condition: ConditionResult, saturation: float | None) -> Picture:
    """Peak slip, peak friction, A and b over pressure with 95 % bands, and the predictions."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(10.5, 5.7))
        grid = figure.add_gridspec(
            2, 3, left=0.07, right=0.98, top=0.94, bottom=0.13, hspace=0.42, wspace=0.34
        )
        band = _band(condition)
        places = [grid[0, 0], grid[0, 1], grid[1, 0], grid[1, 1]]
        titles = ("Peak slip [mm]", "Peak friction", "A [1/mm]", "b [1/mm]")
        for ax_place, title, column in zip(places, titles, range(4), strict=True):
            ax = figure.add_subplot(ax_place)
            _draw_quantity(ax, condition, band, column)
            ax.set_title(title, y=_ABOVE)
            ax.set_xlabel("pressure [kPa]")
            _draw_transitions(ax, condition, saturation, label=column == 0)
        ax = figure.add_subplot(grid[:, 2])
        _draw_predictions(ax, condition)
        handles, labels = figure.axes[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="lower left", bbox_to_anchor=(0.06, 0.0), ncols=4)
        return Picture(figure)


def _draw_quantity(ax: "Axes", condition: ConditionResult, band: "_Band", column: int) -> None:
    own = np.array([_own(test)[column] for test in condition.tests])
    at = np.array([test.curve.pressure for test in condition.tests]) / _KPA
    off = condition.found.flagged
    label = "tests, each by itself"
    for mask, mark, text in ((~off, "o", label), (off, "x", "disagrees with its repeats")):
        if mask.any():
            ax.errorbar(
                at[mask], own[mask, 0], yerr=own[mask, 1], fmt=mark, ms=3.5, color=BLUE, lw=0.9,
                label=text,
            )  # fmt: skip
    p, columns = band
    if columns:
        centre, half = columns[column]
        ax.fill_between(p / _KPA, centre - half, centre + half, color=ORANGE, alpha=0.3, lw=0)
        ax.plot(p / _KPA, centre, color=ORANGE, label="law, 95 % band")


def _band(condition: ConditionResult) -> "_Band":
    """Pressures, and the four quantities there with half their 95 % band."""
    if condition.fit is None:
        return np.empty(0), []
    p = np.geomspace(*condition.fit.ends, 160)
    slip, friction, half = condition.peaks_at(p)
    return p, _as_columns(slip, friction, _errors(condition, p, half))


def _errors(condition: ConditionResult, p: Array, half: Array) -> Array:
    """Half intervals of (ln x_pk, ln mu_pk, ln -A, b/A) at pressures, shape (n, 4)."""
    assert condition.fit is not None  # noqa: S101 - asked only where there is one
    covariance = condition.fit.own_covariance(p)
    scale = half[:, :1] / np.maximum(np.sqrt(covariance[:, :1, 0]), 1e-300)
    by_a = np.array([-1.0, 1.0])
    error_a = np.sqrt(np.einsum("i,nij,j->n", by_a, covariance, by_a))[:, None] * scale
    ln_x = condition.fit.peaks(p)[:, 0] - np.log(_MM)
    # b = A (1 + ln x): d ln|b| = d ln(-A) + d ln x / (1 + ln x).
    by_b = np.stack([-1.0 + 1.0 / (1.0 + ln_x), np.ones_like(ln_x)], axis=-1)
    error_b = np.sqrt(np.einsum("ni,nij,nj->n", by_b, covariance, by_b))[:, None] * scale
    return np.hstack([half, error_a, error_b])


def _as_columns(slip: Array, friction: Array, half: Array) -> list[tuple[Array, Array]]:
    a = -friction / (slip / _MM)
    b = a * (1.0 + np.log(slip / _MM))
    values = (slip / _MM, friction, a, b)
    return [(value, np.abs(value) * half[:, k]) for k, value in enumerate(values)]


def _own(test: TestResult) -> list[tuple[float, float]]:
    q, fit = test.fit.parameters, test.fit
    a, b = fit.coefficients()
    by_a, by_b = fit.coefficient_errors()
    x = q.peak_slip / _MM
    return [
        (x, Z95 * min(fit.error("ln_peak_slip"), 1.0) * x),
        (q.peak_friction, Z95 * min(fit.error("ln_peak_friction"), 1.0) * q.peak_friction),
        (a, Z95 * min(by_a, abs(a))),
        (b, Z95 * min(by_b, abs(b))),
    ]


def _draw_transitions(
    ax: "Axes", condition: ConditionResult, saturation: float | None, *, label: bool
) -> None:
    transition = condition.found.transition
    if transition is not None:
        text = f"transition {transition.pressure / _KPA:.0f} kPa" if label else None
        ax.axvline(transition.pressure / _KPA, color=GREY, lw=0.9, label=text)
    if saturation is not None:
        text = f"saturation estimate {saturation / _KPA:.0f} kPa" if label else None
        ax.axvline(saturation / _KPA, color=RED, lw=0.9, ls=(0, (1, 1.5)), label=text)


def _draw_predictions(ax: "Axes", condition: ConditionResult) -> None:
    ax.set_title("Pressures left out in turn", y=_ABOVE)
    if not condition.found.left_out:
        ax.text(0.5, 0.5, "too few pressures", ha="center", transform=ax.transAxes)
        return
    items = condition.found.left_out
    for inside, colour, text in ((True, BLUE, "inside"), (False, "#bbbbbb", "extrapolated")):
        rows = [k for k, item in enumerate(items) if item.inside is inside]
        ax.barh(rows, [items[k].noise_levels for k in rows], color=colour, label=text)
    ax.axvline(2.0, color=RED, lw=0.9, ls=(0, (1, 1.5)), label="2 noise levels")
    ax.set_yticks(range(len(items)), [f"{item.pressure / _KPA:.4g} kPa" for item in items])
    ax.set_xlabel("prediction error [noise levels of a reading]")
    ax.grid(axis="y", visible=False)
    ax.set_ylim(-0.6, len(items) + 0.5)
    ax.legend(loc="upper left", ncols=2, fontsize="x-small")


def _panels(
    condition: ConditionResult,
) -> tuple["Figure", list[tuple["Axes", int, list[TestResult]]]]:
    """Return a figure with axes for each pressure, and the tests that belong there."""
    from matplotlib.figure import Figure

    chosen = _chosen_levels(condition)
    columns = min(_COLUMNS, len(chosen))
    rows = -(-len(chosen) // columns)
    figure = Figure(figsize=(2.75 * columns + 0.4, 2.2 * rows + 0.75))
    height = 2.2 * rows + 0.75
    grid = figure.add_gridspec(
        rows, columns, left=0.07, right=0.985, top=1 - 0.28 / height, bottom=0.78 / height,
        hspace=0.5, wspace=0.28,
    )  # fmt: skip
    found = []
    for k, level in enumerate(chosen):
        ax = figure.add_subplot(grid[k // columns, k % columns])
        tests = [
            t
            for t, own in zip(condition.tests, condition.found.levels, strict=True)
            if own == level
        ]
        ax.set_title(f"{condition.found.level_pressures()[level] / _KPA:.4g} kPa", y=_ABOVE)
        if k >= len(chosen) - columns:
            ax.set_xlabel("slip [mm]")
        if k % columns == 0:
            ax.set_ylabel("friction")
        found.append((ax, level, tests))
    return figure, found


def _chosen_levels(condition: ConditionResult) -> list[int]:
    levels = np.unique(condition.found.levels)
    if len(levels) > _MOST_PANELS:
        picked = np.unique(np.linspace(0, len(levels) - 1, _MOST_PANELS).round().astype(int))
        levels = levels[picked]
    return [int(level) for level in levels]


def _readings(test: TestResult) -> tuple[Array, Array]:
    """Slip and friction of single readings, thinned, zero and lash taken off."""
    fit, q = test.fit, test.fit.parameters
    step = max(1, len(test.curve.travel) // _MOST_DOTS)
    friction = test.curve.friction[::step] - q.zero
    return test.curve.travel[::step] - q.lash - fit.bending * friction, friction


def _thin(test: TestResult, count: int) -> Integers:
    """Bins about equally far apart in slip."""
    slip = test.fit.slip
    wanted = np.linspace(float(slip[0]), float(slip[-1]), count)
    order = np.argsort(slip)
    near = np.clip(np.searchsorted(slip[order], wanted), 0, len(slip) - 1)
    return np.unique(order[near])


def _averaged(test: TestResult, count: int) -> tuple[Array, Array]:
    fit = test.fit
    place = np.clip((fit.slip / fit.slip_max * count).astype(int), 0, count - 1)
    weight = np.bincount(place, weights=fit.weights**2, minlength=count)
    off = np.bincount(place, weights=fit.weights**2 * (fit.friction - fit.fitted), minlength=count)
    filled = weight > 0
    return ((np.arange(count) + 0.5) / count * fit.slip_max)[filled], off[filled] / weight[filled]


def _legend(figure: "Figure", texts: list[str], colours: list[str]) -> None:
    from matplotlib.lines import Line2D

    lines = [Line2D([], [], color=c, lw=2, label=t) for c, t in zip(colours, texts, strict=True)]
    figure.legend(handles=lines, loc="lower left", ncols=3, bbox_to_anchor=(0.05, 0.0))


def condition_pictures(
    condition: ConditionResult, saturation: float | None
) -> dict[str, tuple[str, Callable[[], Picture]]]:
    """Return what there is to draw of a condition: by name, caption and what draws it."""
    return {
        "curves": (
            "Every curve with its fit, and the law of all tests.",
            lambda: curves_picture(condition),
        ),
        "pressure": (
            "Peak slip, peak friction, A and b over pressure with 95 % bands (crosses: tests that "
            "disagree with their repeats), and the error of predicting each pressure from the "
            "others.",
            lambda: pressure_picture(condition, saturation),
        ),
        "checks": (
            "Left: residuals of the fits, averaged over thirtieths of the slip, in units of "
            "the noise of one reading. Right: the check that the law is based on, the five-point "
            "derivative of each curve against A ln x + (A - b), a straight line over the logarithm "
            "of slip.",
            lambda: checks_picture(condition),
        ),
    }
