"""Small drawings as SVG, written without a plotting library: a note must be made in no time."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from html import escape

#: The face that the typesetter brings with it; elsewhere any serif will do.
FONT = "Libertinus Serif, Times New Roman, serif"
INK, GRID = "#222222", "#d5d5d5"
#: Told apart by colour and by dashes, and by lightness in grey print (Okabe and Ito).
BLUE, ORANGE, GREEN, RED, GREY = "#0072b2", "#d55e00", "#009e73", "#a50f15", "#666666"
DASHED, DOTTED = "4.5 2.5", "1.2 2"

Point = tuple[float, float]


@dataclass(frozen=True)
class Drawing:
    """A finished drawing.

    Attributes
    ----------
    name
        Name of its file, without the ending.
    svg
        The drawing.
    width, height
        Size [pt].
    alt
        What it shows, in words, for who cannot see it.
    caption
        What stands below it.
    """

    name: str
    svg: str
    width: float
    height: float
    alt: str
    caption: str


@dataclass
class Canvas:
    """A sheet to draw on; y runs downwards, lengths are points.

    Attributes
    ----------
    width, height
        Size [pt].
    """

    width: float
    height: float
    _parts: list[str] = field(default_factory=list)

    def line(self, points: Iterable[Point], colour: str, width: float, dash: str = "") -> None:
        """Draw a line through points."""
        self._shape("polyline", points, fill="none", stroke=colour, width=width, dash=dash)

    def area(
        self, points: Iterable[Point], fill: str, *, opacity: float = 1.0, edge: str = ""
    ) -> None:
        """Fill a polygon; an edge of the same colour closes the seams between neighbours."""
        self._shape("polygon", points, fill=fill, stroke=edge, width=0.3, opacity=opacity)

    def circle(self, centre: Point, radius: float, fill: str, edge: str, width: float) -> None:
        """Draw a disc."""
        x, y = centre
        self._parts.append(
            f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{radius:.2f}" fill="{fill}" stroke="{edge}" '
            f'stroke-width="{width:g}"/>'
        )

    def arrow(self, start: Point, tip: Point, width: float, colour: str = INK) -> None:
        """Draw an arrow, its head at the tip."""
        length = math.dist(start, tip) or 1.0
        ux, uy = (tip[0] - start[0]) / length, (tip[1] - start[1]) / length
        head = min(2.2 + 2.4 * width, length)
        back = (tip[0] - head * ux, tip[1] - head * uy)
        side = 0.38 * head
        self.line([start, back], colour, width)
        corners = [(back[0] - s * side * uy, back[1] + s * side * ux) for s in (1.0, -1.0)]
        self.area([tip, *corners], colour)

    def text(
        self,
        at: Point,
        words: str,
        size: float = 7.5,
        *,
        anchor: str = "start",
        turn: float = 0.0,
        colour: str = INK,
        bold: bool = False,
    ) -> None:
        """Write words; ``turn`` is clockwise [deg]."""
        x, y = at
        turned = f' transform="rotate({turn:.2f} {x:.2f} {y:.2f})"' if turn else ""
        weight = ' font-weight="bold"' if bold else ""
        self._parts.append(
            f'<text x="{x:.2f}" y="{y:.2f}" font-size="{size:g}" text-anchor="{anchor}" '
            f'fill="{colour}"{weight}{turned}>{escape(words)}</text>'
        )

    def hatched(self, points: Sequence[Point], colour: str, step: float = 4.0) -> None:
        """Hatch a convex or ring-shaped polygon by lines rising to the right."""
        low, high = min(x + y for x, y in points), max(x + y for x, y in points)
        c = math.ceil(low / step) * step
        while c < high:
            cuts = sorted(_cuts(points, c))
            for start, stop in zip(cuts[::2], cuts[1::2], strict=False):
                self.line([(start, c - start), (stop, c - stop)], colour, 0.5)
            c += step

    def finished(self, alt: str) -> str:
        """Return the drawing as SVG."""
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width:g}" '
            f'height="{self.height:g}" viewBox="0 0 {self.width:g} {self.height:g}" role="img" '
            f'aria-label="{escape(alt)}" font-family="{FONT}">{"".join(self._parts)}'
            "</svg>"
        )

    def _shape(
        self,
        kind: str,
        points: Iterable[Point],
        *,
        fill: str,
        stroke: str = "",
        width: float = 0.0,
        dash: str = "",
        opacity: float = 1.0,
    ) -> None:
        at = " ".join(f"{x:.2f},{y:.2f}" for x, y in points)
        line = f' stroke="{stroke}" stroke-width="{width:g}"' if stroke else ""
        line += f' stroke-dasharray="{dash}"' if dash else ""
        faint = f' fill-opacity="{opacity:g}"' if opacity < 1.0 else ""
        self._parts.append(f'<{kind} points="{at}" fill="{fill}"{line}{faint}/>')


def _cuts(points: Sequence[Point], c: float) -> Iterable[float]:
    """Yield x where the line x + y = c crosses the edges of a polygon."""
    for (x1, y1), (x2, y2) in zip(points, (*points[1:], points[0]), strict=True):
        a, b = x1 + y1 - c, x2 + y2 - c
        if (a < 0.0) != (b < 0.0):
            yield x1 + (x2 - x1) * a / (a - b)


def nice_ticks(low: float, high: float, most: int) -> list[float]:
    """Return round numbers from low to high, steps of 1, 2 or 5 times a power of ten."""
    span = max(high - low, 1e-12)
    raw = span / most
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(s * power for s in (1.0, 2.0, 5.0, 10.0) if s * power >= raw * (1.0 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]
