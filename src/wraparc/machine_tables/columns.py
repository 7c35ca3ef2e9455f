"""What a column measures: names in many languages, and units as machines spell them.

Names only rank the columns of one dimension and say which is meant by default; a unit is
never inferred from a name or from the size of the numbers.
"""

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache

from wraparc.units import Dimension, dimension_of, unit_factor


class Role(StrEnum):
    """What a column is for."""

    TRAVEL = "travel"
    FORCE = "force"
    NORMAL_FORCE = "normal_force"
    TIME = "time"


ROLE_DIMENSION: dict[Role, Dimension] = {
    Role.TRAVEL: "length",
    Role.FORCE: "force",
    Role.NORMAL_FORCE: "force",
    Role.TIME: "time",
}

# Stems of names, accents and case taken off; the longest that fits counts. English, German,
# French, Spanish, Portuguese, Italian, Polish, Czech, Dutch, Swedish, Turkish, Russian,
# Japanese, Chinese.
_STEMS: dict[Role, str] = {
    Role.TRAVEL: (
        "extension displacement stroke travel crosshead crshd xhead elongation actuator lvdt"
        " weg standardweg traversenweg verfahrweg kolbenweg maschinenweg maschine traverse"
        " wegaufnehmer verschiebung verlangerung course deplacement allongement"
        " desplazamiento carrera recorrido alargamiento deslocamento curso alongamento"
        " spostamento corsa allungamento przemieszczenie droga wydluzenie draha posun posuv"
        " prodlouzeni verplaatsing slag forlangning forskjutning traversposition"
        " yer degistirme uzama перемещение ход удлинение 変位 ストローク 位移 行程 伸び"
        " position machine disp ext"
    ),
    Role.FORCE: (
        "force load kraft standardkraft prufkraft zugkraft last charge effort fuerza carga"
        " forca forza carico sila obciazenie zatizeni kracht belasting belastning kuvvet yuk"
        " сила усилие нагрузка 荷重 試験力 力 载荷 负荷 fx f_x f"
    ),
    Role.NORMAL_FORCE: (
        "normal force|normal load|normalkraft|clamp force|clamping force|klemmkraft|anpresskraft"
        "|force normale|force de serrage|fuerza normal|forca normal|forza normale|sila normalna"
        "|normalova sila|normaalkracht|clamp load|нормальная сила|法向力|垂直荷重|fn|f_n|f n"
    ),
    Role.TIME: (
        "time zeit prufzeit temps tiempo tempo czas cas tijd tid zaman elapsed время 時間 时间 t"
    ),
}
# A name with one of these measures something else, whatever stems it has.
_OTHER = re.compile(
    r"strain|stress|dehnung|stauchung|spannung|contrainte|deformation|deformacion|\btension\b"
    r"|tensao|sforzo|naprezenie|odksztalcenie|napeti|spanning|rate|speed|geschwindigkeit"
    r"|vitesse|velocidad|velocita|predkosc|modulus|modul|energy|energie|work|power|cycle"
    r"|count|index|nummer|number|temp(erature|eratur)?\b|ひずみ|応力|应变|应力"
)
# Of several travel columns the one that starts near 0 is meant, not the absolute place.
_ABSOLUTE = re.compile(r"absol|position|corrected|extensomet|clip|lvdt|\bext\b")

# Spellings of machines that the unit table does not have: the unit meant, and how many.
_SPELLINGS: dict[str, tuple[str, float]] = {
    **dict.fromkeys(("newton", "newtons", "牛"), ("N", 1.0)),
    **dict.fromkeys(("kilonewton", "kilonewtons", "千牛"), ("kN", 1.0)),
    "cN": ("N", 0.01),
    **dict.fromkeys(("sec", "secs", "sec.", "second", "seconds", "sek", "sek."), ("s", 1.0)),
    **dict.fromkeys(("in", "in.", "inch", "inches", '"', "''", "zoll", "pouce"), ("in", 1.0)),
    **dict.fromkeys(("millimeter", "millimeters", "millimetre", "millimetres"), ("mm", 1.0)),
    **dict.fromkeys(("mil", "mils"), ("thou", 1.0)),
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
_SLASHED = re.compile(r"^(?P<name>.+?)(?:\s*/\s*|\s+in\s+|\s*,\s*|\s+|_)(?P<unit>[^\s/_,]+)$")


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


def read_unit(text: str, role: Role | None = None) -> ColumnUnit | None:
    """Return what the unit `text` is, or None if it is no unit of length, force or time."""
    plain = text.strip().strip("[]()<>").strip().replace("μ", "µ")
    if not plain or plain in _NO_UNITS_HERE:
        return None
    if role in {Role.FORCE, Role.NORMAL_FORCE} and plain in _MASS_AS_FORCE:
        unit = _MASS_AS_FORCE[plain]
        note = f"{plain!r} as the unit of a force was read as {unit}"
        return ColumnUnit(plain, "force", unit_factor(unit, "force"), note)
    for spelling in (plain, plain.casefold()):
        if spelling in _SPELLINGS:
            unit, count = _SPELLINGS[spelling]
            dimension = dimension_of(unit)
            assert dimension is not None  # noqa: S101 - own table
            return ColumnUnit(plain, dimension, count * unit_factor(unit, dimension))
    dimension = dimension_of(plain)
    if dimension in {"length", "force", "time"}:
        return ColumnUnit(plain, dimension, unit_factor(plain, dimension))
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
    text = " ".join(cell.split())
    match = _BRACKETED.match(text)
    if match and is_unit_text(match["unit"]):
        return match["name"].strip(" ,;_-/"), match["unit"].strip()
    match = _SLASHED.match(text)
    if match and read_unit(match["unit"]):
        return match["name"].strip(" ,;_-/[("), match["unit"]
    return text, ""


@lru_cache(maxsize=4096)
def plain_name(name: str) -> str:
    """Return `name` in lower case without accents and signs, for comparison."""
    decomposed = unicodedata.normalize("NFKD", name.casefold().replace("ł", "l").replace("ø", "o"))
    letters = "".join(c for c in decomposed if not unicodedata.combining(c))
    return " ".join(re.sub(r"[^\w]+", " ", letters.replace("_", " ")).split())


def suitability(name: str, role: Role) -> float:
    """How well `name` names a column of `role`: 0 not at all, more is better."""
    plain = plain_name(name)
    if not plain or _OTHER.search(plain):
        return 0.0
    if role is Role.NORMAL_FORCE:
        return 3.0 if _has_stem(plain, _STEMS[role].split("|")) else 0.0
    if role is Role.FORCE and _has_stem(plain, _STEMS[Role.NORMAL_FORCE].split("|")):
        return 0.0
    stem = _longest_stem(plain, _STEMS[role].split())
    if not stem:
        return 0.0
    score = 2.0 + (plain.startswith(stem) and role is not Role.TIME)
    if role is Role.TRAVEL and _ABSOLUTE.search(plain):
        score -= 1.5
    return score


def _has_stem(plain: str, stems: Iterable[str]) -> bool:
    return bool(_longest_stem(plain, stems))


def _longest_stem(plain: str, stems: Iterable[str]) -> str:
    """The longest stem that a word of `plain` starts with; short ones must be the whole word."""
    found = ""
    for stem in stems:
        key = plain_name(stem)
        ascii_short = key.isascii() and len(key) <= 4
        pattern = rf"\b{re.escape(key)}\b" if ascii_short else re.escape(key)
        if len(key) > len(found) and re.search(pattern, plain):
            found = key
    return found


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
    header: Sequence[Sequence[str]], width: int, *, last_empty: bool = False
) -> tuple[list[NamedColumn], str]:
    """Find names and units in the lines above a table.

    Parameters
    ----------
    header
        Lines above the table, as cells; the nearest is the last.
    width
        Number of columns.
    last_empty
        Whether the last column is empty, as behind a delimiter at the end of each row.

    Returns
    -------
    columns
        One a column; names are empty where none was found.
    complaint
        A sentence if names stand there that do not fit the columns one by one.
    """
    units = [""] * width
    names: Sequence[str] = ()
    misfit = ""
    for row in reversed(header[-3:]):
        cells = _fitted(row, width, last_empty)
        if cells is None:
            if sum(any(suitability(c, role) for role in Role) for c in row) >= 2:
                misfit = f"{_filled(row)} names stand above {width} columns"
            continue
        if not any(units) and _is_unit_row(cells):
            units = [cell.strip("[]()<> ") for cell in cells]
        elif sum(_is_text(cell) for cell in cells) >= 1 and not names:
            names = cells
            if any(units) or any(split_name(cell)[1] for cell in cells):
                break
    if not names:
        return [NamedColumn(k, "", units[k]) for k in range(width)], misfit
    split = [split_name(cell) for cell in names]
    return [
        NamedColumn(k, name or cell, units[k] or unit)
        for k, ((name, unit), cell) in enumerate(zip(split, names, strict=True))
    ], ""


def _fitted(row: Sequence[str], width: int, last_empty: bool) -> list[str] | None:
    """Fit a header line to the columns, or refuse it.

    One name too few is what decimal commas between delimiting commas look like: names must
    be as many as columns, empty ones at the end apart.
    """
    cells = [cell.strip() for cell in row]
    while len(cells) > width and not cells[-1]:
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
