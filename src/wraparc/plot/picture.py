"""A finished picture: shown in a notebook, saved by the ending of its name."""

import io
import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wraparc.errors import InputError, MissingExtraError
from wraparc.saving import save_file, saving_problems

if TYPE_CHECKING:
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure
    from matplotlib.transforms import Bbox

SUFFIXES = (".svg", ".png", ".pdf")
_DPI = 150
_EDGE = 0.03  # around what is drawn beyond the figure [in]

# Lines that are told apart by colour and by dashes; the colours are those of Okabe and Ito,
# which also the colour-blind tell apart, and differ in lightness when printed grey.
BLUE, ORANGE, GREEN, RED, GREY = "#0072b2", "#d55e00", "#009e73", "#a50f15", "#666666"
#: The one ramp of quantities, light for little, as the page has it (`style/frame.css`), and what
#: exceeds a limit that it ends at.
RAMP, BEYOND = ("#cfe1f0", "#69a9d8", "#1f66b0", "#47137f"), "#c4680f"
LINES = ((BLUE, "-"), (ORANGE, "--"), (GREEN, "-."), (RED, ":"), (GREY, "-"))
_STYLE: dict[str, Any] = {
    "font.family": ["DejaVu Sans", "sans-serif"],
    "font.size": 9.0,
    "axes.titlesize": 10.0,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.labelsize": 9.0,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#444444",
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.8,
    "legend.frameon": False,
    "legend.fontsize": 8.0,
    "legend.handlelength": 2.6,
    "hatch.linewidth": 0.5,
    "figure.facecolor": "white",
    "svg.fonttype": "none",  # letters stay letters: searched, copied, read aloud
    "svg.hashsalt": "wraparc",
    "pdf.fonttype": 42,
}


def ramp() -> "Colormap":
    """Return the ramp of quantities as a colour map; over its end lies what exceeds a limit."""
    from matplotlib.colors import LinearSegmentedColormap

    found = LinearSegmentedColormap.from_list("wraparc", list(RAMP))
    return found.with_extremes(over=BEYOND)


def require_matplotlib() -> None:
    """Raise `MissingExtraError` unless matplotlib is there."""
    try:
        import matplotlib.figure  # noqa: F401
    except ImportError as error:
        raise MissingExtraError("matplotlib", "plot") from error


def picture_fonts() -> tuple[Path, ...]:
    """Return the files of the faces that the letters of a picture are drawn in.

    Raises
    ------
    MissingExtraError
        Without matplotlib.
    """
    require_matplotlib()
    from matplotlib import get_data_path

    folder = Path(get_data_path()) / "fonts" / "ttf"
    return tuple(folder / f"DejaVuSans{face}.ttf" for face in ("", "-Bold"))


@contextmanager
def styled() -> Iterator[None]:
    """Draw in the style of these pictures, whatever the reader's own settings."""
    require_matplotlib()
    import matplotlib as mpl

    with mpl.rc_context():
        mpl.rcdefaults()
        settings: Any = mpl.rcParams
        settings.update(_STYLE)
        yield


@dataclass(frozen=True)
class Picture:
    """A picture, ready to be shown or saved.

    Attributes
    ----------
    figure
        The matplotlib figure, for changes of one's own.
    """

    figure: "Figure"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Save as SVG, PNG or PDF, by the ending of the name; whole or not at all.

        The same picture gives the same bytes.

        Raises
        ------
        InputError
            If the ending is another or the file cannot be written.
        """
        problems = saving_problems(path, suffixes=SUFFIXES)
        if problems:
            raise InputError(problems)
        save_file(path, self.to_bytes(os.path.splitext(path)[1].lower().lstrip(".")))

    def to_bytes(self, kind: str) -> bytes:
        """Return the picture as a file of a kind: ``svg``, ``png`` or ``pdf``."""
        stamps = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}
        data = io.BytesIO()
        with styled():
            bounds = _whole(self.figure)
            self.figure.savefig(
                data, format=kind, dpi=_DPI, metadata=stamps.get(kind), bbox_inches=bounds
            )
        return data.getvalue()

    def _repr_svg_(self) -> str:
        return self.to_bytes("svg").decode("utf-8")


def _whole(figure: "Figure") -> "Bbox | None":
    """Return bounds that hold all that is drawn [in]; None where the figure itself does."""
    from matplotlib.transforms import Bbox

    figure.draw_without_rendering()  # lays it out
    page, drawn = figure.bbox_inches, figure.get_tightbbox()
    whole = Bbox.union([page, drawn])
    grown = max(whole.width - page.width, whole.height - page.height)
    return Bbox.union([page, drawn.padded(_EDGE)]) if grown > 0.0 else None
