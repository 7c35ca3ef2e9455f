"""Belts by their standard names: what ``EP 1000/4 6+3 Y``, ``ST 2000`` or ``330 PIW 3 ply`` say.

ISO 14890 and DIN 22102 name a textile belt by its carcass, its breaking strength [N/mm], the
number of plies, its covers [mm], that of the load first, and their grade; ISO 15236 and DIN 22131 a
belt of steel cords by ``ST`` and its strength. American names state the rated tension in PIW.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from wraparc.errors import InputError, Problem, did_you_mean, near, shown
from wraparc.units import parse_quantity, unit_factor

STEEL, PIW = "ST", "PIW"
#: Carcasses of textile belts by their letters, warp first: E polyester, P and N polyamide.
TEXTILES = ("EP", "PN", "EE", "NN", "P", "PP")
#: Those whose letters mean polyamide in Europe and polyester elsewhere: DIN 22102 has P for
#: polyamide, America PP for polyester, and sheets of EP belts P alone.
AMBIGUOUS = {"P": ("EP", "NN"), "PP": ("EE", "NN")}
#: Strengths that textile belts have, of all plies and of one [N/mm] (ISO 14890; makers' lists).
STRENGTHS = (160, 200, 250, 315, 400, 500, 630, 800, 1000, 1250, 1600, 2000, 2500, 3150)
PLY_STRENGTHS = (
    80, 100, 125, 150, 160, 200, 250, 300, 315, 350, 400, 450, 500, 600, 630, 800,
)  # fmt: skip
#: Strongest and weakest ply that is woven [N/mm].
PLY = (62.0, 1250.0)
MOST_PLIES = 8
#: Types of belts of steel cords: their strength [N/mm] (ISO 15236, DIN 22131; makers' lists).
STEEL_TYPES = (
    500, 630, 800, 1000, 1120, 1250, 1400, 1600, 1800, 2000, 2240, 2250, 2500, 2800, 3150, 3500,
    4000, 4500, 5000, 5400, 6000, 6300, 6500, 7000, 7500, 8000, 8500, 9000, 9500, 10000,
)  # fmt: skip
#: Thickest cover that a name states [m].
THICKEST = 0.035
#: Strength over rated tension that PIW belts have: a tenth is their rated tension [-].
PIW_SAFETY = 10.0

_NUMBER = r"\d+(?:[.,]\d+)?"
_INCHES = r"\d+/\d+"
_COVERS = (
    rf"(?P<carry>{_NUMBER})\s*(?:MM)?\s*[TS]?\s*[-+/:X]\s*(?P<pulley>{_NUMBER})\s*(?:MM)?"
    rf'|(?P<top>{_INCHES})\s*(?:IN\b|")?\s*[-+:X]\s*(?P<bottom>{_INCHES})\s*(?:IN\b|")?'
)
#: Standards, makers' letters and widths that stand before a name: ``DIN 22102 AB 1000``.
_BEFORE = r"(?:(?:DIN|ISO|EN|AS|IS|GB/T|JIS)\s*(?:EN\s*)?[A-Z]?\s*\d+\S*\s+(?:[A-Z]{1,4}\s+)?)?"
_WIDTH = r"(?:B?\s*\d{3,4}\s*(?:MM)?\s+)?"
#: Grades of covers, standards and widths behind it: ``DIN Y``, ``ISO 14890 H``, ``M24``.
_GRADE = (
    r"(?P<grade>(?:\s*[-,]?\s*[A-Z][A-Z0-9]{0,6}"
    r"(?:(?:\s+|\s*[-,]\s*)(?:[A-Z][A-Z0-9]{0,6}|\d{2,5}(?:\s?MM)?)){0,4})?"
    r"(?:\s+B?\d{3,4}\s?MM)?)"
)
_BEHIND = rf"(?:\s*[-,]?\s*(?:{_COVERS}))?{_GRADE}\s*"
_TEXTILE = re.compile(
    rf"{_BEFORE}{_WIDTH}(?P<carcass>EP|PN|EE|NN|PP|P)\s*-?\s*(?P<strength>\d{{2,5}})"
    rf"\s*(?P<sign>[-/:X])\s*(?P<plies>\d+)(?:\s*PLY|\s*PLIES)?(?![\d.,])(?P<piw>\s*PIW\b)?{_BEHIND}"
)
_CORDS = re.compile(rf"{_BEFORE}{_WIDTH}ST\s*-?\s*/?(?P<strength>\d{{2,6}})(?![\d]){_BEHIND}")
_RATED = (
    re.compile(
        rf"(?P<strength>\d{{2,4}})\s*(?:PIW|PLI)\b(?:\s*[-/,]?\s*(?P<plies>\d)(?:[\s-]*PLY|"
        rf"[\s-]*PLIES|\b(?![/.,\d])))?{_BEHIND}"
    ),
    re.compile(
        rf"(?P<plies>\d)(?:[\s-]*PLY|[\s-]*PLIES|\s*[-/])\s*(?P<strength>\d{{2,4}})\s*"
        rf"(?:PIW|PLI)\b{_BEHIND}"
    ),
    re.compile(
        rf"(?:PIW|PLI)\s*(?P<strength>\d{{2,4}})\s*(?:/\s*(?P<plies>\d)(?![\d/]))?{_BEHIND}"
    ),
)
#: What looks like such a name, whatever is wrong with it.
_LOOKS = re.compile(r"(?:[A-Z]{1,3}\s*-?\s*)?[\dOIL]{2,6}\s*[-/:X]\s*[\dOIL]{1,2}\b.*|ST\W*\w{2,6}")


class BeltName(NamedTuple):
    """What a standard name says of a belt."""

    carcass: str
    #: Breaking strength per width [N/m]; nan where the name states a rated tension.
    strength: float
    #: Rated tension per width [N/m], nan where the name states the strength.
    rating: float
    #: Number of plies, 0 where it is not told or there are cords.
    plies: int
    #: Covers on the side of the load and of the pulley [m], nan where they are not told.
    carry_cover: float
    pulley_cover: float
    #: Grade of the covers, as written.
    grade: str

    @property
    def is_steel(self) -> bool:
        """Whether its tension member is of steel cords."""
        return self.carcass == STEEL

    @property
    def standard(self) -> str:
        """The standards that such a name is of."""
        if self.is_steel:
            return "ISO 15236, DIN 22131"
        return "rated tension in PIW" if self.carcass == PIW else "ISO 14890, DIN 22102"


def parse_belt_name(name: str) -> BeltName | None:
    """Return what a standard name says; None of any other name.

    Raises
    ------
    InputError
        Of one that looks like a standard name and has no strength, plies or type that belts have:
        with the nearest names.
    """
    text = " ".join(name.translate(_ALIKE).upper().split())
    found = _TEXTILE.fullmatch(text)
    if found is not None:
        return _textile(found, name)
    found = _CORDS.fullmatch(text)
    if found is not None:
        return _cords(found, name)
    for pattern in _RATED:
        found = pattern.fullmatch(text)
        if found is not None:
            return _rated(found, name)
    if _LOOKS.fullmatch(text) and near_names(text):
        raise _asked(name, "is no standard name of a belt", text)
    return None


_NAN = float("nan")
#: Letters of other alphabets and signs that are taken for each other.
_ALIKE = str.maketrans(
    {"–": "-", "×": "x", "−": "-", "\N{NO-BREAK SPACE}": " ", "″": '"', "”": '"'}
    | {"Е": "E", "Р": "P", "Ø": "0", "*": "x"}  # noqa: RUF001
)


def _textile(found: re.Match[str], name: str) -> BeltName:
    """Return what the name of a textile belt says."""
    strength, plies = float(found["strength"]), int(found["plies"])
    if found["piw"]:
        return _rated(found, name)
    carcass, by_ply = found["carcass"], []
    if strength in PLY_STRENGTHS and 1 <= plies <= MOST_PLIES:  # EP 200 x 4: fabrics of 200 N/mm
        by_ply = [f"{carcass} {strength * plies:g}/{plies}"]
    if not _is_woven(strength, plies):
        wrong = f"no belt has {strength:g} N/mm in {plies} {'ply' if plies == 1 else 'plies'}"
        raise _asked(name, wrong, f"{carcass} {strength:g}/{plies}", by_ply)
    if found["sign"] == "X" and by_ply:
        wrong = f"{strength:g} N/mm may be that of a ply or of all"
        raise _asked(name, wrong, "", [*by_ply, f"{carcass} {strength:g}/{plies}"])
    return BeltName(found["carcass"], 1e3 * strength, _NAN, plies, *_covers(found, name))


def _is_woven(strength: float, plies: int) -> bool:
    """Return whether belts of a strength [N/mm] have so many plies."""
    known = strength in STRENGTHS or any(strength == plies * ply for ply in PLY_STRENGTHS)
    return known and 1 <= plies <= MOST_PLIES and PLY[0] <= strength / plies <= PLY[1]


def _cords(found: re.Match[str], name: str) -> BeltName:
    strength = float(found["strength"])
    if strength not in STEEL_TYPES:
        raise _asked(name, f"no type ST {strength:g} is listed", f"ST {strength:g}")
    return BeltName(STEEL, 1e3 * strength, _NAN, 0, *_covers(found, name))


def _rated(found: re.Match[str], name: str) -> BeltName:
    rating, plies = float(found["strength"]), int(found["plies"] or 0)
    if plies > MOST_PLIES:
        raise _asked(name, f"no belt has {plies} plies", f"{rating:g} PIW")
    tension = rating * unit_factor("PIW", "force_per_width")
    return BeltName(PIW, _NAN, tension, plies, *_covers(found, name))


def _covers(found: re.Match[str], name: str) -> tuple[float, float, str]:
    """Return both covers that a name states [m], and their grade."""
    covers = (_NAN, _NAN)
    if found["carry"] is not None:
        carry, pulley = (f"{found[key].replace(',', '.')} mm" for key in ("carry", "pulley"))
        covers = (parse_quantity(carry, "length"), parse_quantity(pulley, "length"))
    elif found["top"] is not None:
        inch = unit_factor("in", "length")
        parts = [found[key].split("/") for key in ("top", "bottom")]
        covers = (
            inch * float(parts[0][0]) / float(parts[0][1]),
            inch * float(parts[1][0]) / float(parts[1][1]),
        )
    if covers[0] > THICKEST or covers[1] > THICKEST:
        message = f"no cover is thicker than {1e3 * THICKEST:g} mm"
        raise InputError(
            Problem(message=message, remedy='Write covers as "6+3", in mm.', value=shown(name))
        )
    return covers[0], covers[1], (found["grade"] or "").strip(" -,")


def near_names(text: str) -> list[str]:
    """Return the standard names that are nearest to a text, the nearest first."""
    plain = _plain(text)
    names = {_plain(known): known for known in _standard_names()}
    return [names[key] for key in near(plain, names)]


#: Letters that are typed for digits.
_DIGITS = str.maketrans({"O": "0", "I": "1", "L": "1"})
_NO_SIGNS = re.compile(r"[^A-Z0-9]")


def _plain(text: str) -> str:
    return _NO_SIGNS.sub("", text.upper().translate(_DIGITS))


def _standard_names() -> list[str]:
    """Return the names that a typing slip may have been."""
    textile = [
        f"{carcass} {strength}/{plies}"
        for carcass in ("EP", "PN", "EE", "NN")
        for strength in STRENGTHS
        for plies in range(2, 7)
        if PLY_STRENGTHS[0] <= strength / plies <= PLY_STRENGTHS[-1]
    ]
    return textile + [f"ST {strength}" for strength in STEEL_TYPES]


def _asked(name: str, message: str, text: str, first: list[str] | None = None) -> InputError:
    names = [*(first or []), *(near_names(text) if text else [])]
    meant = [shown(known) for known in dict.fromkeys(names[:3])]
    remedy = did_you_mean(meant) or 'Write for example "EP 630/3".'
    return InputError(Problem(message=message, remedy=remedy, value=shown(name)))
