"""Which value of an input gives a wanted result, as ``wraparc seek`` finds it."""

from wraparc.answer.seek_sheet import seek_document, sentence, value_text
from wraparc.checks import Level, judge
from wraparc.study.seek import Goal, Sought, seek
from wraparc.train.whole import Whole
from wraparc.web.answers.documents import read, without_none
from wraparc.web.answers.shown import Answer, Numbers, Text, rounded, worded
from wraparc.web.asked import SeekRequest


class FoundValue(Answer):
    """A value of the input [SI], and what the whole drive is like with it."""

    value: float
    shown: Text
    level: Level
    label: str
    text: Text


class SeekAnswer(Answer):
    """What was found, in a sentence; and the result over the range that was tried [SI]."""

    sentence: Text
    found: list[FoundValue]
    tried: Numbers
    results: Numbers


def seek_value(asked: SeekRequest) -> SeekAnswer:
    """Every value of an input in a range that gives a wanted result."""
    document = without_none(asked.document)
    read(document)
    found = seek(document, Goal(**asked.model_dump(exclude={"document"})))
    data = seek_document(found)
    return SeekAnswer(
        sentence=worded(sentence(found)),
        found=[_value(found, *pair) for pair in zip(found.values, found.wholes, strict=True)],
        tried=rounded(data["tried"]["value"]),
        results=rounded(data["tried"]["result"]),
    )


def _value(found: Sought, value: float, whole: Whole) -> FoundValue:
    return FoundValue(
        value=value,
        shown=worded(value_text(found, value)),
        level=judge(whole).level,
        label=judge(whole).label,
        text=worded(judge(whole).text),
    )
