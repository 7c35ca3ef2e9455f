"""What a column of a shear test is for, by its name in many languages.

Names only rank the columns of one dimension and say which is meant by default.
"""

import re
import unicodedata
from collections.abc import Iterable
from enum import StrEnum
from functools import lru_cache

from wraparc.machine_tables import plain_name
from wraparc.units import Dimension


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
        "|normalova sila|normaalkracht|clamp load|нормальная сила|法向力|垂直荷重|fn|f_n|f n|fz|f_z"
    ),
    Role.TIME: (
        "time zeit prufzeit temps tiempo tempo czas cas tijd tid zaman elapsed время 時間 时间 t"
    ),
}
# What was asked for, not what was measured: a set-point is never taken for a reading.
_DEMANDED = (
    r"\bsoll|set ?point|setpunkt|set value|\btarget|\bdemand|\bcommand|\bcmd\b|\bnominal|\bdesired"
    r"|\brequested|\bprescribed|\bprogrammed|\breference\b|\bref\b|\bsp\b"
    r"|\bvorgabe|\bvorgegeben|fuhrungsgrosse|stellgrosse|\bnenn"  # German
    r"|consigne|\bcible|\bcommande|\bvisee?\b"  # French
    r"|consigna|\bobjetivo|\bdesead|\bmando\b|\breferencia"  # Spanish
    r"|\bdesejad|\balvo\b|ponto de ajuste"  # Portuguese
    r"|riferimento|impostat|\bobiettivo|\brichiest|\bcomando"  # Italian
    r"|zadan|nastaw|docelow|pozadan"  # Polish
    r"|nastaven|pozadovan|\bcilov"  # Czech
    r"|gewenst|ingesteld|streefwaarde|instelwaarde|stuurwaarde"  # Dutch
    r"|borvarde|borlast|borkraft|referensvarde|installd"  # Swedish
    r"|ayar degeri|ayarlanan|\bhedef|istenen|referans"  # Turkish
    r"|заданн|задание|уставк|целев|требуем"  # Russian
    r"|設定|目標|指令|指示値"  # Japanese
    r"|设定|目标|给定|期望"  # Chinese
)
# A name with one of these measures something else, whatever stems it has.
_MEASURES_OTHER = (
    r"strain|stress|dehnung|stauchung|spannung|contrainte|deformation|deformacion|\btension\b"
    r"|tensao|sforzo|naprezenie|odksztalcenie|napeti|spanning|rate|speed|geschwindigkeit"
    r"|vitesse|velocidad|velocita|predkosc|modulus|modul|energy|energie|work|power|cycle"
    r"|count|index|nummer|number|temp(erature|eratur)?\b|ひずみ|応力|应变|应力"
)
_STRESSES = (
    r"stress|spannung|contrainte|tensao|sforzo|\btension\b|naprezenie|napeti|spanning|応力|应力"
)


def _for_plain_names(pattern: str) -> re.Pattern[str]:
    """Accents are taken off names, those of Japanese too."""
    decomposed = unicodedata.normalize("NFKD", pattern)
    return re.compile("".join(c for c in decomposed if not unicodedata.combining(c)))


_DEMAND, _STRESS = _for_plain_names(_DEMANDED), _for_plain_names(_STRESSES)
_OTHER = _for_plain_names(f"{_MEASURES_OTHER}|{_DEMANDED}")
_ACROSS = re.compile(
    r"^[yz]\b|\b[yz]$|depth|height|wear|thick|\bgap\b|tiefe|hohe|dicke|spalt|verschleiss"
    r"|epaisseur|profond|hauteur|usure|espesor|altura|grosor|desgaste|grubosc|zuzycie"
)
# Words of a travel column that also stand in names of others: Machine_Load.
_WEAK = {"machine", "maschine", "position"}
# Of several travel columns the one that starts near 0 is meant, not the absolute place.
_ABSOLUTE = re.compile(r"absol|position|corrected|extensomet|clip|lvdt|\bext\b")


@lru_cache(maxsize=4096)
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
    if stem in _WEAK and any(_has_stem(plain, _STEMS[r].split()) for r in (Role.FORCE, Role.TIME)):
        return 0.0
    score = 2.0 + (plain.startswith(stem) and role is not Role.TIME)
    if role is Role.TRAVEL and _ABSOLUTE.search(plain):
        score -= 1.5
    return score


def is_demand(text: str) -> bool:
    """Whether a text names what was asked for: a set-point."""
    return bool(_DEMAND.search(plain_name(text)))


def is_across(name: str) -> bool:
    """Whether `name` names a length across the sliding: Z of a tribometer, wear, a depth."""
    return bool(_ACROSS.search(plain_name(name)))


def is_stress(name: str) -> bool:
    """Whether `name` names a measured stress."""
    plain = plain_name(name)
    return bool(_STRESS.search(plain)) and not _DEMAND.search(plain)


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


def is_known(name: str) -> bool:
    """Whether `name` names a column of any role."""
    return any(suitability(name, role) for role in Role)
