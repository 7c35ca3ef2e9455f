"""The picture of a family of tension ratios: creep over wrap angle, a curve for each."""

import math
from collections.abc import Sequence
from itertools import cycle

from wraparc.arc import ArcResult
from wraparc.glossary import GLOSSARY
from wraparc.plot.lagging import DASHES, shades
from wraparc.plot.picture import RED, Picture, styled
from wraparc.plot.profiles import angle_ticks, angles, column, heading
from wraparc.units import System, display, display_unit
from wraparc.version import __version__


def plot_family(results: Sequence[ArcResult], system: System = "si", *, title: str = "") -> Picture:
    """Return creep over wrap angle for results of one arc at several tension ratios.

    Parameters
    ----------
    results
        From `tension_ratio_family`; what breaks away is named and not drawn.
    system
        Units of the axes.
    title
        Heading.
    """
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(8.2, 5.0), layout="constrained")
        ax = figure.subplots()
        solved = [r for r in results if r.status.solved]
        for result, shade, dash in zip(solved, shades(len(solved)), cycle(DASHES), strict=False):
            style = {"color": shade, "dashes": dash} if dash else {"color": shade}
            ratio = _ratio(result)
            ax.plot(angles(result), column(result, "creep", system), label=ratio, **style)
        arc = results[0].arc
        limit = arc.side * arc.creep_limit / display_unit("length", system)[1]
        said = display(arc.creep_limit, "length", system, digits=3)
        text = f"{GLOSSARY['creep_limit'].title.lower()}, {said}"
        ax.axhline(limit, color=RED, linewidth=1.2, linestyle=(0, (1, 1.5)), label=text)
        ax.axhline(0.0, color="#444444", linewidth=0.6)
        end = math.degrees(arc.wrap_angle)
        ax.set_xlim(0.0, end)
        ax.set_xticks(angle_ticks(end))
        ax.set_xlabel("Wrap angle from the entry nip [deg]")
        ax.set_ylabel(heading("creep", system))
        ax.set_title(title or "Creep along the wrap by tension ratio")
        away = [_ratio(r) for r in results if not r.status.solved]
        name = f"gross slip at {', '.join(away)}" if away else ""
        ax.legend(loc="upper left", title=name, alignment="left")
        figure.supxlabel(f"wraparc {__version__}", x=0.995, ha="right", fontsize=6.5)
        return Picture(figure)


def _ratio(result: ArcResult) -> str:
    arc = result.arc
    tight, slack = ("T1", "T2") if arc.side > 0.0 else ("T2", "T1")
    ratio = max(arc.entry_tension, arc.exit_tension) / min(arc.entry_tension, arc.exit_tension)
    return f"{tight}/{slack} = {ratio:.4g}"
