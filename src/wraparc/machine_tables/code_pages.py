"""Code pages that no mark tells: by the words that heads of machine files have in them.

Bytes of a double-byte page are valid in pages of one byte too, and read as nonsense there. Which
page is meant is told by words; where none is found and the letters are no words, it is asked.
"""

import re

# Words that stand in heads, by page. A sign alone counts half: other pages have its bytes too.
_WORDS = {
    "gbk": "时间 位移 载荷 试验 行程 负荷 应力 压力 速度 温度 伸长 变形 摩擦 拉力 单位 力",
    "big5": "時間 位移 荷重 試驗 行程 負荷 應力 壓力 速度 溫度 伸長 變形 摩擦 拉力 單位 力",
    "cp949": "시간 변위 하중 시험 이동 스트로크 압력 속도 온도 마찰 신율 단위 번호 힘",
    "cp932": "時間 変位 荷重 試験 ストローク 移動 圧力 速度 温度 摩擦 伸び 単位 番号 力",
    "koi8-r": "время сила усилие нагрузка перемещение смещение путь ход удлинение давление "
    "скорость температура трение",
    "cp1251": "время сила усилие нагрузка перемещение смещение путь ход удлинение давление "
    "скорость температура трение",
    "cp866": "время сила усилие нагрузка перемещение смещение удлинение давление скорость",
    "cp1254": "değiştirme sıcaklık basınç hız süre yük sürtünme gerçek ağırlık",  # noqa: RUF001
    "cp1253": "χρόνος δύναμη μετατόπιση φορτίο πίεση ταχύτητα θερμοκρασία",
}
#: Pages that may be meant where no word tells.
ASKED = "gbk, big5, cp949, shift_jis or koi8-r"
_LOOKED_AT = 65536
# Escape sequences of terminals; controls; marks of direction and of no width.
_UNPRINTABLE = re.compile(
    r"\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)?|\x1b\[[0-?]*[ -/]*[@-~]|\x1b."
    r"|[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\u061c\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]"
)


def printable(text: str) -> str:
    """Return a text without what steers a terminal or the direction of its writing."""
    return _UNPRINTABLE.sub("", text)


def page_of(data: bytes) -> str | None:
    """Return the page by which the head of a file has words; None where it has none in any.

    Parameters
    ----------
    data
        A file that is no UTF-8 and no UTF-16.
    """
    head = data[:_LOOKED_AT]
    found: dict[str, float] = {}
    for name, words in _WORDS.items():
        try:
            text = head.decode(name)
        except UnicodeDecodeError as error:
            if error.start < len(head) - 3:
                continue
            text = head[: error.start].decode(name)
        folded = text.casefold()
        found[name] = sum(
            0.5 if len(word) == 1 else 1.0
            for word in words.split()
            if word in folded and not word.isascii()
        )
    best = max(found, key=lambda name: found[name], default="")
    if not best or found[best] < 1.0:
        return None
    # what Western pages read alike is theirs
    if best == "cp1254" and all(c in "çöüÇÖÜ" for c in head.decode(best) if ord(c) > 127):
        return None
    return best
