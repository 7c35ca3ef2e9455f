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
# Japanese, Chinese, Korean; of time Finnish, Hungarian, Romanian, Greek and Ukrainian too.
_STEMS: dict[Role, str] = {
    Role.TRAVEL: (
        "extension displacement stroke travel crosshead crshd xhead elongation actuator lvdt"
        " weg -weg maschine traverse slip slide sliding schlupf displ pos"
        " wegaufnehmer verschiebung verlangerung course deplacement glissement allongement"
        " desplazamiento deslizamiento carrera recorrido alargamiento deslocamento deslizamento"
        " curso alongamento extensao spostamento scorrimento"
        " corsa allungamento przemieszczenie poslizg skok droga wydluzenie draha posun posuv"
        " prodlouzeni verplaatsing slag forlangning forskjutning traversposition"
        " yer degistirme uzama перемещение смещение путь ход удлинение"
        " 変位 ストローク 移動量 すべり 位移 行程 滑移 伸び 변위 이동 스트로크 신율"
        " position machine disp ext"
    ),
    Role.FORCE: (
        "force load kraft last -last charge effort fuerza carga"
        " forca esforco forza carico sila obciazenie zatizeni kracht belasting belastning kuvvet"
        " yuk сила усилие нагрузка 荷重 試験力 力 载荷 负荷 載荷 負荷 하중 시험력 힘"
        " fx f_x ff f_f fr f_r ft f_t f"
    ),
    Role.NORMAL_FORCE: ("fn f_n fz f_z"),
    Role.TIME: (
        "time zeit prufzeit temps tiempo tempo czas cas tijd tid zaman sure elapsed время 時間 时间"
        " 시간 aika ido timp χρονος час laufzeit duree uhrzeit hora ora heure 時刻 时刻 시각 t"
    ),
}
# What was asked for, not what was measured: a set-point is never taken for a reading.
_DEMANDED = (
    r"\bsoll|soll\b|sollwert|set ?point|setpunkt|\bset\b|\bsetting|\bsetforce|\btarget|\bdemand"
    r"|\bcommand|\bcmd\b|\bnominal|\bdesired|\brequested|\bprescribed|\breference\b|\bref\b|\bsp\b"
    r"|\bprogram|theor|\bexpected|\bideal\b|\binput\b"
    r"|vorgabe|\bvorgegeben|fuhrungsgrosse|stellgrosse|\bnenn|\bbezug|\bziel"  # German
    r"|\bwunsch|\bsteuer"
    r"|consigne|\bcible|\bcommande|\bvisee?\b|\bimpose|souhait"  # French
    r"|consigna|\bobjetivo|\bdesead|\bmando\b|\breferencia|\bteoric|prescrit|\bajust"  # Spanish
    r"|\bdesejad|\balvo\b|ponto de ajuste|\bcomandad"  # Portuguese
    r"|riferimento|impostat|\bobiettivo|\brichiest|\bcomando|\bteoric|\bdesiderat"  # Italian
    r"|zadan|nastaw|docelow|pozadan|wymagan"  # Polish
    r"|nastaven|pozadovan|\bcilov"  # Czech
    r"|gewenst|ingesteld|streefwaarde|instelwaarde|stuurwaarde"  # Dutch
    r"|borvarde|borlast|borkraft|referensvarde|installd"  # Swedish
    r"|ayar degeri|ayarlanan|\bhedef|istenen|referans"  # Turkish
    r"|заданн|задани|уставк|целев|требуем|программн|командн|опорн"  # Russian
    r"|設定|目標|指令|指示値|理論"  # Japanese
    r"|设定|目标|给定|期望|命令|理论|控制力"  # Chinese
)
# A name with one of these measures something else, whatever stems it has.
_MEASURES_OTHER = (
    r"strain|stress|dehnung|stauchung|spannung|contrainte|deformation|deformacion|\btension\b"
    r"|tensao|sforzo|naprezenie|odksztalcenie|napeti|spanning|rate|speed|geschwindigkeit"
    r"|vitesse|velocidad|velocita|predkosc|modulus|modul|energy|energie|work|power|cycle"
    r"|count|index|nummer|number|temp(erature|eratur)?\b|ひずみ|応力|应变|应力"
    r"|velocity|скорость|速度|\bper\b|\bje\b"
    # one value of a whole test, or a difference from what was asked for
    r"|\bpeak\b|\blimit|\berror\b|grenz|abweichung|fehler|erreur|\bmax|maxim|massim|maksym|максим|最大"
)
# A force that presses sample and belt together, a travel in its direction.
_NORMAL = (
    r"normal(?!i[sz])|normaal|verti[ck]|\bclamp|compres|\bkontakt|\bcontact|dead ?weight"
    r"|\bdown ?force"
    r"|pre ?load|\bweight|anpress|andruck|auflage|zuspann|\bspannkraft|druckkraft|klem|gewicht"
    r"|auflast|serrage|presseur|\bappui|apriete|\bpeso\b|\baperto|serraggio|docisk|nacisk|pionow|svisl"
    r"|pritlac|прижа|прижим|давлен|вертик|нормал|法向|法線|正压力?|垂直|竖向|鉛直|压紧|夹紧|押付|締付"
)
# A force or a travel along the sliding, by name: it is meant where there are others.
_ALONG = (
    r"friction|tangen|\bshear|horizont|orizzont|\bpull|traction|\bdrag|\breib|\bscher|\bschub|zug"
    r"|frott|cisaill|tranchant|rozam|fricc|corte\b|traccion|atrito|cisalh|tracao|attrito|taglio"
    r"|trazione|tarci|scinaj|styczn|poziom|rozciag|трени|сдвиг|касател|горизонт|тягов"
    r"|摩擦|せん断|水平|引張|剪切|切向|拉|\bslip|\bslid|gleit|schlupf|gliss|desliz|scorrim|posliz|滑|すべり"
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
_COEFFICIENT = _for_plain_names(
    r"\bco?f\b|\bco?ef|\bmu\b|μ|reib(ungs)?(zahl|wert|koeff)|wspolczynnik|коэфф|摩擦係数|摩擦系数"
)
_PRESSES, _SLIDES = _for_plain_names(_NORMAL), _for_plain_names(_ALONG)
_ACROSS = _for_plain_names(
    r"^[yz]\b|\b[yz]$|\b(?:pos|posn|axis|achse|disp|stage|motor|probe|weg|ch\d*)z\b|depth|height|wear|thick|\bgap\b|tiefe|hohe|dicke|spalt|verschleiss"
    r"|epaisseur|profond|hauteur|usure|espesor|altura|grosor|desgaste|grubosc|zuzycie"
    r"|^z\b|dilat|sink|settle|setzung|einfeder|tassement|enfonc|asentam|recalque|cediment"
    rf"|износ|осадк|磨损|摩耗|沈下|{_NORMAL}"
)
# Words of a travel column that also stand in names of others: Machine_Load.
_WEAK = {"machine", "maschine", "position"}
# Of several travel columns the one that starts near 0 is meant, not the absolute place.
_ABSOLUTE = _for_plain_names(
    r"absol|position|corrected|extensom|estensim|ekstensom|экстензом|clip|lvdt|\bext\b|aufnehmer|伸び計|変位計|引伸"
)


@lru_cache(maxsize=4096)
def suitability(name: str, role: Role) -> float:
    """How well `name` names a column of `role`: 0 not at all, more is better."""
    plain = plain_name(name)
    if not plain or _OTHER.search(plain):
        return 0.0
    if role is Role.NORMAL_FORCE:
        return 3.0 if _is_normal_force(plain) else 0.0
    if role is Role.FORCE and _is_normal_force(plain):
        return 0.0
    if role is Role.TRAVEL and _ACROSS.search(plain):
        return 0.0
    stem = _longest_stem(plain, _STEMS[role].split())
    if not stem:
        return 0.0
    if stem in _WEAK and any(_has_stem(plain, _STEMS[r].split()) for r in (Role.FORCE, Role.TIME)):
        return 0.0
    score = 2.0 + (plain.startswith(stem) and role is not Role.TIME)
    if role is Role.TRAVEL and _ABSOLUTE.search(plain):
        score -= 1.5
    return score + 3.0 * (role is not Role.TIME and _SLIDES.search(plain) is not None)


def _is_normal_force(plain: str) -> bool:
    if _PRESSES.fullmatch(plain) or _has_stem(plain, _STEMS[Role.NORMAL_FORCE].split()):
        return True
    return bool(_PRESSES.search(plain)) and _has_stem(plain, _STEMS[Role.FORCE].split())


def is_other(name: str) -> bool:
    """Whether `name` names something else than a reading of travel, force or time."""
    return bool(_OTHER.search(plain_name(name)))


def is_demand(text: str) -> bool:
    """Whether a text names what was asked for: a set-point."""
    return bool(_DEMAND.search(plain_name(text)))


def is_coefficient(name: str) -> bool:
    """Whether `name` names a coefficient of friction."""
    return bool(_COEFFICIENT.search(plain_name(name)))


def is_across(name: str) -> bool:
    """Whether `name` names a length across the sliding: Z of a tribometer, wear, a depth."""
    return bool(_ACROSS.search(plain_name(name)))


def is_stress(name: str) -> bool:
    """Whether `name` names a measured stress along the sliding."""
    plain = plain_name(name)
    return bool(_STRESS.search(plain)) and not (_DEMAND.search(plain) or _PRESSES.search(plain))


def _has_stem(plain: str, stems: Iterable[str]) -> bool:
    return bool(_longest_stem(plain, stems))


def _longest_stem(plain: str, stems: Iterable[str]) -> str:
    """The longest stem in `plain`; a short one must be a word, or with a hyphen the end of one."""
    found = ""
    for stem in stems:
        key = plain_name(stem)
        short = key.isascii() and len(key) <= 4
        begin = "" if stem.startswith("-") else r"\b"
        pattern = rf"{begin}{re.escape(key)}\b" if short else re.escape(key)
        if len(key) > len(found) and re.search(pattern, plain):
            found = key
    return found


def is_known(name: str) -> bool:
    """Whether `name` names a column of any role."""
    return any(suitability(name, role) for role in Role)
