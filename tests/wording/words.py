"""Words that no output, page or document of wraparc uses, with what is written instead.

Whole words in texts of ours; keys, names of users, code and titles of sources are excepted.
"""

import re

#: Every form of a word, and what says it in the terms of the trade.
INSTEAD = {
    "hold": "fix, contain, be constant", "holds": "fixes, contains, is constant",
    "held": "constant, fixed",
    "drum": "pulley", "drums": "pulleys",
    "pull": "effective tension, Te", "pulls": "Te, drives", "pulled": "under tension",
    "given": "input, now, stated",
    "least": "minimum", "largest": "maximum, peak",
    "carry": "transmit, take, pass", "carries": "transmits, takes, passes",
    "carried": "transmitted",
    "keep": "pass, retain, save", "keeps": "passes, retains, saves", "kept": "passed, saved",
    "beyond": "exceeds, outside, past",
    "tell": "report, state", "tells": "reports, states", "told": "reported, stated",
    "stand": "be", "stands": "is, is based on",
    "break away": "slip", "breaks away": "gross slip",
    "ask for": "require", "asks for": "requires", "asked for": "required",
    "as it is": "now, unchanged",
    "slack side": "T2, slack-side tension",
    "march": "integration",
    "found": "value, result",
    "pulsate": "oscillate", "pulsates": "oscillates", "pulsation": "oscillation",
    "swing": "ripple", "swings": "ripple",
    "usual size": "plausible", "usual sizes": "plausible",
    "without bound": "infinite, none",
    "nobody": "not published",
    "fight": "oppose", "fights": "opposes",
    "mend": "repair, repeat", "mended": "repaired, repeated",
    "comes off worst": "governs",
    "dearer": "more expensive",
    "calmest": "smallest ripple",
    "e-fold": "decay time constant", "e-folds": "decay time constants",
    "squeeze": "compression", "squeezed": "compressed",
    "tires": "fatigue",
    "for want of data": "data missing",
    "a turn": "per revolution",
    "off its law": "deviates",
    "is it": "an imperative",
    "yes, it": "Unstable", "no, it": "Stable",
}  # fmt: skip

#: Terms of mathematics and of other trades that have one of the words in them.
TERMS = ("least squares", "least-squares")

#: Whole words: none that a name, a key, a path or a compound has, and none in quotation marks.
WORD = re.compile(
    rf"(?<![\w`'\"./\[{{-])(?:{'|'.join(sorted(INSTEAD, key=len, reverse=True))})"
    r"(?![\w`'\"_=/({-]|\.\w)",
    re.IGNORECASE,
)


def avoidable(text: str) -> list[str]:
    """Return the words of the list in a text."""
    return [word for word, _ in in_context(text)]


def in_context(text: str) -> list[tuple[str, str]]:
    """Return the words of the list in a text, each with what is around it."""
    for term in TERMS:
        text = re.sub(rf"\b{term}\b", "", text, flags=re.IGNORECASE)
    found = [m for m in WORD.finditer(text) if m[0] != "March"]  # the month
    return [(m[0], text[max(0, m.start() - 60) : m.end() + 40]) for m in found]
