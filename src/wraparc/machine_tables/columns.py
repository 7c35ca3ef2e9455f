"""Names and units of columns, as machines spell them.

A unit is never inferred from a name or from the size of the numbers.
"""

import re
import unicodedata
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

from wraparc.units import Dimension, dimension_of, unit_factor

# Spellings of machines that the unit table does not have: the unit meant, and how many.
_SPELLINGS: dict[str, tuple[str, float]] = {
    **dict.fromkeys(("newton", "newtons", "牛", "н"), ("N", 1.0)),
    **dict.fromkeys(("kilonewton", "kilonewtons", "千牛", "кн"), ("kN", 1.0)),
    "cN": ("N", 0.01),
    **dict.fromkeys(
        ("sec", "secs", "sec.", "second", "seconds", "sek", "sek.", "сек", "秒"), ("s", 1.0)
    ),
    **dict.fromkeys(("in", "in.", "inch", "inches", '"', "''", "zoll", "pouce"), ("in", 1.0)),
    **dict.fromkeys(
        ("millimeter", "millimeters", "millimetre", "millimetres", "мм", "毫米"), ("mm", 1.0)
    ),
    "\u0441": ("s", 1.0),  # Cyrillic
    **dict.fromkeys(("кгс", "kgf", "kgf.", "kp", "公斤"), ("kgf", 1.0)),
    **dict.fromkeys(("тс",), ("tf", 1.0)),
    **dict.fromkeys(("микрон", "мкм", "micron", "microns", "微米"), ("um", 1.0)),
    **dict.fromkeys(("см", "厘米"), ("cm", 1.0)),
    **dict.fromkeys(("뉴턴", "ニュートン"), ("N", 1.0)),
    **dict.fromkeys(("초",), ("s", 1.0)),
    **dict.fromkeys(("mil", "mils"), ("thou", 1.0)),
    **dict.fromkeys(("MM", "Mm"), ("mm", 1.0)),
    **dict.fromkeys(("CM",), ("cm", 1.0)),
    **dict.fromkeys(("S", "SEC"), ("s", 1.0)),
    **dict.fromkeys(("MS",), ("ms", 1.0)),
    **dict.fromkeys(("KN", "kn", "Kn"), ("kN", 1.0)),
    **dict.fromkeys(("mpa", "MPA", "Mpa"), ("MPa", 1.0)),
    **dict.fromkeys(("kpa", "KPA", "Kpa"), ("kPa", 1.0)),
    **dict.fromkeys(("PSI", "Psi"), ("psi", 1.0)),
    **dict.fromkeys(("lbf", "lbs", "lb", "lbs.", "lb.", "pound-force", "pounds"), ("lbf", 1.0)),
}
# As the unit of a force column these can only be meant as the weight of the mass.
_MASS_AS_FORCE = {"kg": "kgf", "g": "gf", "t": "tf", "lbm": "lbf", "gr": "gf"}
_NO_UNITS_HERE = {"-", "--", "1", "none", "n/a"}
_OTHER_UNITS = re.compile(
    r"%|mm/mm|in/in|m/m|\W*[°º\u00c2]*\s*[CFK]|[mµu]?V|V/V|[mµ]?A|Hz|kHz|1/s|cycles?|"
    r"(?:N|kN|MPa|mm|in|lbf|mm2)(?:/|\*|·)\w+|MPa|GPa|kPa|Pa|psi|N/mm.?|mm.|deg|°|rad|J|Nm|N·m"
)
_BRACKETED = re.compile(r"^(?P<name>.*?)\s*[\[(<]\s*(?P<unit>[^\[\]()<>]*?)\s*[\])>]\s*$")
_SLASHED = re.compile(
    r"^(?P<name>.+?)(?:\s*/\s*|\s+in\s+|\s*,\s*|(?P<blank>\s+)|_)(?P<unit>[^\s/_,]+)$"
)
_FACTOR = re.compile(r"(?:[x×*·/÷]\s*10+(?:(?:\^|\*\*|e)-?\d+)?|\b10\^-?\d+)\)?$")
# Brackets and signs of East Asian keyboards.
_FULL_WIDTH = str.maketrans(
    "\uff08\uff09\uff3b\uff3d\u3010\u3011\u3014\u3015\uff0f\uff0c\uff1a\uff05\u3000\uff1c\uff1e",
    "()[][][]/,:% <>",
)
# A line of units that names itself, as of LabVIEW: one a channel behind the x.
_UNIT_LABEL = re.compile(r"(?:[xy] )?units?(?: label)?s?|einheit(?:en)?|unites?|unidad(?:es)?")
# Names of columns that rows often leave empty, the delimiter before them too.
_COMMENT = re.compile(
    r"(comment|komment|koment|coment|comment|note|remark|bemerk|poznam|uwag|osserv|event|marker)"
)


@dataclass(frozen=True)
class ColumnUnit:
    """A unit as a machine wrote it.

    Parameters
    ----------
    text
        As written.
    dimension
        What it measures.
    factor
        SI value of one.
    note
        A sentence where a spelling had to be taken in its only possible sense.
    """

    text: str
    dimension: Dimension
    factor: float
    note: str = ""


def read_unit(text: str, dimension: Dimension | None = None) -> ColumnUnit | None:
    """Return what the unit `text` is, or None if it is none of length, force, time or pressure.

    Of a column that measures a force, the unit of a mass can only be meant as its weight.
    """
    plain = text.strip().strip("[]()<>").strip().replace("μ", "µ")
    if not plain or plain in _NO_UNITS_HERE:
        return None
    if dimension == "force" and plain in _MASS_AS_FORCE:
        unit = _MASS_AS_FORCE[plain]
        note = f"{plain!r} as the unit of a force was read as {unit}"
        return ColumnUnit(plain, "force", unit_factor(unit, "force"), note)
    for spelling in (plain, plain.casefold()):
        if spelling in _SPELLINGS:
            unit, count = _SPELLINGS[spelling]
            measured = dimension_of(unit)
            assert measured is not None  # noqa: S101 - own table
            return ColumnUnit(plain, measured, count * unit_factor(unit, measured))
    measured = dimension_of(plain)
    if measured in {"length", "force", "time", "pressure"}:
        return ColumnUnit(plain, measured, unit_factor(plain, measured))
    return None


def is_unit_text(text: str) -> bool:
    """Whether `text` reads as the unit of something, of whatever dimension."""
    plain = text.strip().strip("[]()<>").strip()
    if not plain:
        return False
    known = read_unit(plain) is not None or dimension_of(plain) is not None
    return known or plain in _NO_UNITS_HERE or _OTHER_UNITS.fullmatch(plain) is not None


def split_name(cell: str) -> tuple[str, str]:
    """Split ``"Load (kN)"``, ``"Weg / mm"``, ``"Kraft in N"``, ``"Force_N"`` into name and unit."""
    text = " ".join(cell.translate(_FULL_WIDTH).split())
    match = _BRACKETED.match(text)
    if match and is_unit_text(match["unit"]):
        return match["name"].strip(" ,;_-/"), match["unit"].strip()
    match = _SLASHED.match(text)
    unit = read_unit(match["unit"]) if match else None
    # Behind a blank, a bar or a Pa may as well be a word.
    if match and unit and (unit.dimension != "pressure" or match["blank"] is None):
        return match["name"].strip(" ,;_-/[("), match["unit"]
    return text, ""


@lru_cache(maxsize=4096)
def plain_name(name: str) -> str:
    """Return `name` in lower case without accents and signs, for comparison."""
    decomposed = unicodedata.normalize("NFKD", name.casefold().replace("ł", "l").replace("ø", "o"))
    letters = "".join(c for c in decomposed if not unicodedata.combining(c))
    return " ".join(re.sub(r"[^\w]+", " ", letters.replace("_", " ")).split())


@dataclass(frozen=True)
class NamedColumn:
    """A column of a table: its place, counted from 0, its name and its unit as written."""

    index: int
    name: str
    unit: str = ""

    @property
    def label(self) -> str:
        """Name to show and to choose by."""
        return self.name or f"column {self.index + 1}"


def name_columns(
    header: Sequence[Sequence[str]],
    width: int,
    known: Callable[[str], object],
    *,
    last_empty: bool = False,
) -> tuple[list[NamedColumn], str]:
    """Find names and units in the lines above a table.

    Parameters
    ----------
    header
        Lines above the table, as cells; the nearest is the last.
    width
        Number of columns.
    known
        Whether a text is the name of a column that is looked for.
    last_empty
        Whether the last column is empty, as behind a delimiter at the end of each row.

    Returns
    -------
    columns
        One a column; names are empty where none was found.
    complaint
        A sentence if names stand there that do not fit the columns one by one.
    """
    units = _labelled_units(header, width)
    names: Sequence[str] = ()
    misfit = ""
    for row in reversed(header[-3:]):
        cells = _fitted(row, width, last_empty)
        if cells is None:
            if sum(bool(known(cell)) for cell in row) >= 2:
                misfit = f"{_filled(row)} names stand above {width} columns"
            continue
        if not any(units) and _is_unit_row(cells):
            units = [cell.strip("[]()<> ") for cell in cells]
        elif not names and _may_be_names(cells):
            names = cells
            if any(units) or any(split_name(cell)[1] for cell in cells):
                break
    if not names:
        return [NamedColumn(k, "", units[k]) for k in range(width)], misfit
    split = [split_name(cell) for cell in names]
    return [
        NamedColumn(k, name or cell, _one_unit(name, unit, units[k]))
        for k, ((name, unit), cell) in enumerate(zip(split, names, strict=True))
    ], ""


def _labelled_units(header: Sequence[Sequence[str]], width: int) -> list[str]:
    """Units of a line further above that names itself; empty where there is none."""
    for row in reversed(header[:-1]):
        cells = [cell.strip() for cell in row]
        own = cells[1:width]
        named = bool(cells) and _UNIT_LABEL.fullmatch(plain_name(cells[0])) is not None
        if named and any(own) and all(is_unit_text(cell) for cell in own if cell):
            return ["", *own, *[""] * (width - 1 - len(own))]
    return [""] * width


def _one_unit(name: str, own: str, below: str) -> str:
    """The unit behind a name or in the line below; with what makes it none that is known.

    The two contradict each other, or a factor stands at the end of the name: Force/1000.
    """
    first, second = read_unit(own), read_unit(below)
    factor = _FACTOR.search(name)
    if factor and (own or below):
        return f"{factor[0]} {below or own}".replace(")", "")
    if first and second and (first.dimension, first.factor) != (second.dimension, second.factor):
        return f"{own} or {below}"
    return below or own


def _may_be_names(cells: Sequence[str]) -> bool:
    """Whether cells can be names: words, more than a title; or the numbers of the columns."""
    words = any(map(_is_text, cells)) and (len(cells) < 2 or _filled(cells) > 1)
    return words or are_numbers_of_columns(cells)


def _fitted(row: Sequence[str], width: int, last_empty: bool) -> list[str] | None:
    """Fit a header line to the columns, or refuse it.

    One name too few is what decimal commas between delimiting commas look like: names must
    be as many as columns, empty ones at the end and one of comments that no row has apart.
    """
    cells = [cell.strip() for cell in row]
    while len(cells) > width and not cells[-1]:
        cells.pop()
    if len(cells) == width + 1 and _COMMENT.match(plain_name(cells[-1])):
        cells.pop()
    if len(cells) == width - 1 and last_empty:
        cells.append("")
    return cells if len(cells) == width else None


def _filled(row: Sequence[str]) -> int:
    return sum(bool(cell.strip()) for cell in row)


def _is_unit_row(cells: Sequence[str]) -> bool:
    filled = [cell for cell in cells if cell]
    return bool(filled) and sum(map(is_unit_text, filled)) >= max(1, 0.6 * len(filled))


def _is_text(cell: str) -> bool:
    return any(c.isalpha() for c in cell)


def are_numbers_of_columns(cells: Sequence[str]) -> bool:
    """Whether cells are 1, 2, 3 ... or 0, 1, 2 ..."""
    texts = [cell.strip() for cell in cells]
    return len(texts) > 1 and any(
        texts == [str(k) for k in range(first, first + len(texts))] for first in (0, 1)
    )


def find_column(named: Sequence[NamedColumn], wanted: str | int) -> NamedColumn | None:
    """Find the column of a name as written (or but for case and accents), or of a number from 1."""
    for column in named:
        if wanted == column.label:
            return column
    plain = plain_name(wanted) if isinstance(wanted, str) else ""
    alike = [c for c in named if plain and plain_name(c.label) == plain]
    # As the file writes it, with its unit.
    alike = alike or [c for c in named if plain and plain_name(f"{c.label} {c.unit}") == plain]
    if len(alike) == 1:
        return alike[0]
    text = str(wanted)
    if text.isascii() and text.isdecimal() and len(text) < 6:
        return next((c for c in named if c.index + 1 == int(text)), None)
    return None


def listed(named: Sequence[NamedColumn]) -> str:
    """Return the columns as a sentence lists them, with numbers and units."""
    shown_columns = [
        f"{c.index + 1} {c.label!r}" + (f" [{c.unit}]" if c.unit else "") for c in named[:20]
    ]
    return ", ".join(shown_columns) + (" ..." if len(named) > 20 else "")
