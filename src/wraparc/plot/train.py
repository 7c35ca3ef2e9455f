"""Pictures of trains: the drives one after the other, and the curves of their matching."""

from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.arrays import Array
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import BLUE, GREEN, GREY, ORANGE, RED, Picture, styled
from wraparc.plot.profiles import angles, column, heading
from wraparc.train import Axis, CaseResult, MarkKind, Matching, ShareCurve, ShareMap, TrainResult
from wraparc.units import RESULT_DIGITS, System, display
from wraparc.version import __version__

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_COLOURS = (BLUE, ORANGE, GREEN, "#cc79a7", "#56b4e9", "#000000", "#e69f00", "#882255")
_DASHES: tuple[Any, ...] = ("-", (0, (6, 2)), (0, (1.5, 1.5)), (0, (6, 2, 1.5, 2)))
_GAP = 25.0  # between two pulleys along the belt [deg]


def _style(index: int) -> dict[str, Any]:
    """Colour and dashes of a drive."""
    return {
        "color": _COLOURS[index % len(_COLOURS)],
        "linestyle": _DASHES[index % len(_DASHES)],
    }


def plot_train(result: TrainResult, case: str = "", units: System = "si") -> Picture:
    """Return the picture of a train in one load case: drives, tension and creep along the belt.

    Parameters
    ----------
    result
        The solved train.
    case
        The load case; the governing one without a name.
    units
        Units to show.
    """
    solved = result[case] if case else result.governing
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(max(8.0, 2.6 * len(solved.members) + 3.0), 7.6))
        rows = figure.add_gridspec(
            3, 1, height_ratios=(1.25, 1, 1), hspace=0.3, left=0.09, right=0.97, top=0.9,
            bottom=0.1,
        )  # fmt: skip
        _draw_chain(figure.add_subplot(rows[0]), solved, units)
        top, low = figure.add_subplot(rows[1]), figure.add_subplot(rows[2])
        _draw_along(top, solved, "tension", units)
        _draw_along(low, solved, "creep", units)
        _mark_limits(low, solved, units)
        low.set_xlabel("Wrap angle from the entry nip of each pulley [deg]")
        figure.align_ylabels([top, low])
        title = f"{result.train.title or 'Train'} - load case {solved.case.name}"
        figure.text(0.02, 0.955, title, fontsize=13, weight="bold")
        foot = solved.reason or f"wraparc {__version__}."
        figure.text(0.02, 0.018, foot, fontsize=7.5, color="#444444")
        return Picture(figure)


def _draw_chain(ax: "Axes", case: CaseResult, units: System) -> None:
    """Drums in a row, the tensions of the belt between them."""
    from matplotlib.patches import Circle, Wedge

    ax.set_aspect("equal")
    ax.axis("off")
    wrapped_both_ways = len({m.arc.arc.side_of_belt for m in case.members}) > 1
    for i, m in enumerate(case.members):
        x = 4.2 * i
        colour = _style(i)["color"]
        ax.add_patch(Circle((x, 0.0), 1.0, facecolor="#f2f2f2", edgecolor="#777777"))
        part = 0.0 if np.isnan(m.share) else min(abs(m.share), 1.0)
        pull = m.arc.effective_tension
        hatch = "////" if pull < 0.0 else ""  # braking shows in print too
        start = 90.0 - 360.0 * part
        wedge = Wedge((x, 0.0), 1.0, start, 90.0, facecolor=colour, alpha=0.35, hatch=hatch)
        ax.add_patch(wedge)
        share = "-" if np.isnan(m.share) else f"{100.0 * m.share:.1f} %"
        ax.text(x, 0.0, share, ha="center", va="center", fontsize=11, weight="bold")
        ax.text(x, 1.2, m.name, ha="center", va="bottom", fontsize=10, color=colour, weight="bold")
        if wrapped_both_ways:
            side = f"{m.arc.arc.side_of_belt} side\nof the belt"
            ax.text(x, -0.5, side, ha="center", va="center", fontsize=7.5)
        trim = "" if np.isnan(m.speed_trim) else f"trim {100.0 * m.speed_trim:.3f} %"
        creep = f"creep {display(m.arc.exit_creep, 'length', units, digits=3)}"
        if not m.arc.status.solved:
            creep = "gross slip"
        force = display(abs(pull), "force", units, RESULT_DIGITS)
        does = f"{'brakes' if pull < 0.0 else 'pulls'} {force}"
        text = "\n".join(part for part in (does, trim, creep) if part)
        ax.text(x, -1.2, text, ha="center", va="top", fontsize=8.5)
        _arrow(ax, x - 2.9, x - 1.15, display(m.arc.entry_tension, "force", units, RESULT_DIGITS))
    last = case.members[-1].arc.exit_tension
    end = 4.2 * (len(case.members) - 1)
    _arrow(ax, end + 1.15, end + 2.9, display(last, "force", units, RESULT_DIGITS))
    ax.set_xlim(-3.1, end + 3.1)
    ax.set_ylim(-2.6, 1.8)


def _arrow(ax: "Axes", start: float, tip: float, text: str) -> None:
    arrow = {"arrowstyle": "-|>", "color": "#222222", "lw": 1.6, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", xy=(tip, 0.0), xytext=(start, 0.0), arrowprops=arrow)
    ax.text(0.5 * (start + tip), 0.18, text, ha="center", va="bottom", fontsize=9)


def _draw_along(ax: "Axes", case: CaseResult, name: str, units: System) -> None:
    """One quantity along all wraps, one after the other."""
    start, ticks, labels = 0.0, [], []
    for i, m in enumerate(case.members):
        end = np.degrees(m.arc.arc.wrap_angle)
        ax.plot(start + angles(m.arc), column(m.arc, name, units), color=_style(i)["color"])
        if not m.arc.status.solved:
            ax.text(
                start + 0.5 * end, 0.5, "slips as a whole", ha="center", va="center", fontsize=9,
                transform=ax.get_xaxis_transform(),
            )  # fmt: skip
        ticks += [start, start + end]
        labels += ["0", f"{end:.0f}"]
        if i + 1 < len(case.members):
            x = start + end + 0.5 * _GAP
            ax.axvspan(x - 0.5 * _GAP, x + 0.5 * _GAP, color="#eeeeee", linewidth=0.0)
        start += end + _GAP
    ax.set_xticks(ticks, labels)
    ax.set_xlim(0.0, start - _GAP)
    ax.axhline(0.0, color="#444444", linewidth=0.6)
    ax.grid(axis="x", visible=False)
    ax.set_ylabel(heading(name, units))


def _mark_limits(ax: "Axes", case: CaseResult, units: System) -> None:
    from wraparc.units import display_unit

    start, size = 0.0, display_unit("length", units)[1]
    for m in case.members:
        end = np.degrees(m.arc.arc.wrap_angle)
        limit = m.arc.arc.side * m.arc.arc.creep_limit / size
        ax.plot([start, start + end], [limit, limit], color=RED, linewidth=1.2, linestyle=":")
        ax.text(start, limit, " limit", color=RED, fontsize=8, va="bottom")
        start += end + _GAP


def plot_matching(
    matching: Matching, over_load: ShareMap | None = None, *, title: str = ""
) -> Picture:
    """Return the picture of how exactly the drives must be matched.

    Shares against speed trim, diameter and load, creep against trim, each with its limits marked;
    and a map of the share over trim and load, if there is one.

    Parameters
    ----------
    matching
        The curves.
    over_load
        The map, or None.
    title
        Heading.
    """
    with styled():
        from matplotlib.figure import Figure

        tall = over_load is not None
        height = 12.4 if tall else 8.4
        figure = Figure(figsize=(11.0, height))
        grid = figure.add_gridspec(
            3 if tall else 2, 2, height_ratios=(1, 1, 1.25) if tall else (1, 1),
            left=0.07, right=0.96, top=1.0 - 0.95 / height, bottom=0.72 / height, hspace=0.4,
            wspace=0.3,
        )  # fmt: skip
        _draw_shares(figure.add_subplot(grid[0, 0]), matching.trim)
        _draw_shares(figure.add_subplot(grid[0, 1]), matching.diameter)
        _draw_creeps(figure.add_subplot(grid[1, 0]), matching)
        _draw_shares(figure.add_subplot(grid[1, 1]), matching.load)
        if over_load is not None:
            _draw_map(figure.add_subplot(grid[2, :]), over_load)
        case = matching.case.case.name
        head = " - ".join(part for part in (title, f"load case {case}") if part)
        figure.text(0.02, 1.0 - 0.38 / height, head, fontsize=13, weight="bold")
        grey = (
            " Grey: the belt between the pulleys would be too slack or too tight." if tall else ""
        )
        note = (
            "All other pulleys turn as in the load case, at constant take-up tension."
            f"{grey} wraparc {__version__}."
        )
        figure.text(0.02, 0.1 / height, note, fontsize=7.5, color="#444444")
        return Picture(figure)


_SHORT = {
    "speed_trim": "trim",
    "speed_setting": "setting",
    "diameter_ratio": "diameter",
    "load_ratio": "load",
}


def _percent(values: Array) -> Array:
    return 100.0 * values


def _draw_shares(ax: "Axes", curve: ShareCurve) -> None:
    x = _percent(curve.values)
    names = [m.name for m in curve.case.members]
    for i, name in enumerate(names):
        ax.plot(x, _percent(curve.shares[:, i]), label=name, **_style(i))
    _mark_braking(ax, curve)
    _mark_places(ax, curve)
    ax.axhline(0.0, color="#444444", linewidth=0.6)
    ax.set_xlim(float(x[0]), float(x[-1]))
    shown = curve.shares[np.isfinite(curve.shares)]
    if curve.axis is Axis.LOAD:  # shares of next to nothing run away
        shown = np.clip(shown, -0.6, 1.6)
    margin = 8.0
    ax.set_ylim(100.0 * shown.min() - margin, 100.0 * shown.max() + margin)
    of = "" if curve.axis is Axis.LOAD else f" of {names[curve.drive]}"
    ax.set_xlabel(f"{GLOSSARY[curve.quantity].title}{of} [%]")
    ax.set_ylabel("Share of the load [%]")
    _head(ax, f"Shares against {_SHORT[curve.quantity]}", *ax.get_legend_handles_labels())
    ax.ticklabel_format(axis="x", useOffset=False)


def _head(ax: "Axes", title: str, handles: list[Any], labels: list[str]) -> None:
    """Put a title above the legend, the legend above the axes."""
    columns = 4
    rows = -(-len(handles) // columns)
    ax.set_title(title, pad=8.0 + 13.0 * rows)
    ax.legend(
        handles, labels, loc="lower left", bbox_to_anchor=(-0.02, 0.965), ncols=columns,
    )  # fmt: skip


def _mark_braking(ax: "Axes", curve: ShareCurve) -> None:
    """Shade where a drive brakes against the others."""
    braking = np.any(curve.shares < 0.0, axis=1)
    edges = np.flatnonzero(np.diff(np.r_[False, braking, False].astype(int)))
    idle = [100.0 * v for v in curve.at(MarkKind.UNLOADED)]
    x = _percent(curve.values)
    for start, stop in edges.reshape(-1, 2).tolist():
        low, high = float(x[start]), float(x[stop - 1])
        low = min((v for v in idle if v <= low), default=low, key=lambda v: low - v)
        high = min((v for v in idle if v >= high), default=high, key=lambda v: v - high)
        ax.axvspan(low, high, color="#f4e3d7", linewidth=0.0)
        ax.text(
            0.5 * (low + high), 0.02, "drives oppose", transform=ax.get_xaxis_transform(),
            ha="center", va="bottom", fontsize=8, color="#8a4b1c", zorder=4,
            bbox={"facecolor": "#f4e3d7", "edgecolor": "none", "pad": 1.0},
        )  # fmt: skip


_PLACES: dict[MarkKind, tuple[str, str]] = {
    MarkKind.OPERATING: ("#222222", "now"),
    MarkKind.CREEP_LIMIT: (RED, GLOSSARY["creep_limit"].title.lower()),
    MarkKind.BREAKAWAY: (RED, "gross slip"),
}


def _mark_places(ax: "Axes", curve: ShareCurve) -> None:
    """Vertical lines at the operating point and at the limits of the drives."""
    names = [m.name for m in curve.case.members]
    now = next(iter(curve.at(MarkKind.OPERATING)), 1.0)
    for mark in curve.marks:
        if mark.kind not in _PLACES:
            continue
        colour, words = _PLACES[mark.kind]
        dashes = "-" if mark.kind is MarkKind.OPERATING else (0, (1, 1.5))
        at = 100.0 * mark.value
        ax.axvline(at, color=colour, linewidth=1.1, linestyle=dashes)
        # each label on the side away from the operating point, whose own stands at the bottom
        outside = "left" if mark.value > now else "right"
        is_now = mark.kind is MarkKind.OPERATING
        text = words if is_now else f"{names[mark.drive]}: {words}"
        ax.text(
            at, 0.02 if is_now else 0.98, f" {text} ", transform=ax.get_xaxis_transform(),
            rotation=90, ha=outside, va="bottom" if is_now else "top", fontsize=7.5, color=colour,
        )  # fmt: skip
    for mark in curve.marks:
        if mark.kind is MarkKind.EQUAL:
            share = 100.0 * mark.shares[mark.drive]
            ax.plot(100.0 * mark.value, share, "o", color=GREY, markersize=5, zorder=3)


def _draw_creeps(ax: "Axes", matching: Matching) -> None:
    """Creep over its limit, and the loss, against trim."""
    curve = matching.trim
    x = _percent(curve.values)
    for i, m in enumerate(curve.case.members):
        part = np.abs(curve.creeps[:, i]) / m.arc.arc.creep_limit
        ax.plot(x, _percent(part), label=f"creep of {m.name}", **_style(i))
    ax.axhline(100.0, color=RED, linewidth=1.1, linestyle=(0, (1, 1.5)))
    for now in curve.at(MarkKind.OPERATING):
        ax.axvline(100.0 * now, color="#222222", linewidth=1.1)
    ax.set_xlim(float(x[0]), float(x[-1]))
    ax.set_ylim(bottom=0.0)
    ax.set_ylabel(f"{GLOSSARY['exit_creep'].title}, part of its limit [%]")
    name = curve.case.members[curve.drive].name
    ax.set_xlabel(f"{GLOSSARY[curve.quantity].title} of {name} [%]")
    right = ax.twinx()
    right.plot(x, _percent(curve.loss_ratio), color=GREY, linewidth=1.2, label="loss (right)")
    right.set_ylabel("Loss over power [%]")
    right.set_ylim(bottom=0.0)
    right.grid(visible=False)
    right.spines["right"].set_visible(True)
    handles = [line for a in (ax, right) for line in a.get_legend_handles_labels()[0]]
    _head(ax, "Creep and loss", handles, [str(line.get_label()) for line in handles])
    ax.ticklabel_format(axis="x", useOffset=False)


def _draw_map(ax: "Axes", over: ShareMap) -> None:
    """Share of the varied drive over trim and load."""
    from matplotlib import colormaps

    x, y = _percent(over.x), _percent(over.y)
    shares = _percent(over.shares[:, :, over.drive])
    levels = np.arange(-50.0, 151.0, 10.0)
    drawn = ax.contourf(
        x, y, shares, levels, cmap=colormaps["RdBu"], extend="both", vmin=-60, vmax=160
    )
    lines = ax.contour(
        x, y, shares, [0.0, 25.0, 50.0, 75.0, 100.0], colors="#222222", linewidths=0.9
    )
    ax.clabel(lines, fmt="%d %%", fontsize=8)
    for i, m in enumerate(over.case.members):
        part = np.abs(over.creeps[:, :, i]) / m.arc.arc.creep_limit
        dashes = ("dashed", "dotted", "dashdot", "solid")[i % 4]
        if np.nanmin(part) < 1.0 < np.nanmax(part):
            ax.contour(x, y, part, [1.0], colors=RED, linewidths=1.4, linestyles=dashes)
            ax.plot(
                [],
                [],
                color=RED,
                linestyle=dashes,
                label=f"{GLOSSARY['creep_limit'].title.lower()} of {m.name}",
            )
    here = over.case.members[over.drive]
    ax.plot(
        100.0 * here.speed_trim, 100.0, "o", color="white", markeredgecolor="#222222", label="now"
    )
    figure = ax.get_figure()
    if figure is not None:
        bar = figure.colorbar(drawn, ax=ax, pad=0.015, fraction=0.035)
        bar.set_label(f"Share of {here.name} [%]")
    ax.set_xlabel(f"{GLOSSARY[over.across.value].title} of {here.name} [%]")
    ax.set_ylabel(f"{GLOSSARY[over.down.value].title} [%]")
    ax.set_title(f"Share of {here.name} over trim and load", pad=18)
    ax.set_facecolor("#dddddd")  # where the belt would be slacker or tighter than is tabulated
    ax.legend(loc="lower left", bbox_to_anchor=(-0.01, 0.99), ncols=5)
    ax.grid(visible=False)
    ax.ticklabel_format(axis="x", useOffset=False)
