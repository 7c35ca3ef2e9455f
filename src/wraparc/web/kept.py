"""Answers that were given already: a page opened again, or a change undone, is not solved anew."""

from collections import OrderedDict

#: Most memory for answers [bytes]; one larger than a quarter of it is not kept.
MOST = 32 * 1024**2


class Kept:
    """The answers asked for last, by their questions.

    Parameters
    ----------
    most
        Memory for them [bytes].
    """

    def __init__(self, most: int = MOST) -> None:
        self._most, self._size = most, 0
        self._answers: OrderedDict[bytes, bytes] = OrderedDict()

    def find(self, question: bytes) -> bytes | None:
        """Return the answer to a question, or None if it is not kept."""
        found = self._answers.get(question)
        if found is not None:
            self._answers.move_to_end(question)
        return found

    def keep(self, question: bytes, answer: bytes) -> None:
        """Keep an answer, and let go of those that nobody has asked for the longest."""
        if question in self._answers or len(answer) > self._most // 4:
            return
        self._answers[question] = answer
        self._size += len(question) + len(answer)
        while self._size > self._most:
            gone, forgotten = self._answers.popitem(last=False)
            self._size -= len(gone) + len(forgotten)
