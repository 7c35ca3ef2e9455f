"""No page, document or text of the source has a word of the list in `wording.words`.

The list is that of the style of wraparc: words that a reader must interpret, each with the term of
the trade that replaces it. What answers say is read in `golden.test_golden`, which has them all.
"""

from collections.abc import Callable, Iterator

import pytest

from wording import texts
from wording.texts import Text
from wording.words import INSTEAD, avoidable, in_context

ROOMS: dict[str, Callable[[], Iterator[Text]]] = {
    "documents": texts.documents,
    "examples and catalogue": texts.data_files,
    "help": texts.help_texts,
    "glossary": texts.quantities,
    "form": texts.form_texts,
    "page": texts.page_texts,
    "source": texts.source_texts,
}


@pytest.mark.parametrize("room", ROOMS)
def test_no_text_has_a_word_of_the_list(room: str) -> None:
    every = list(ROOMS[room]())
    assert len(every) > 50  # it reads something
    assert [(place, *found) for place, text in every for found in in_context(text)] == []


@pytest.mark.parametrize("word", INSTEAD)
def test_every_word_is_seen_in_a_sentence(word: str) -> None:
    assert avoidable(f"The belt {word} there.") == [word]
    assert avoidable(f"{word.upper()}: 3 kN") == [word.upper()]


@pytest.mark.parametrize(
    "text", ["pull-out torque", "least squares", "take_up.held", "`kept`", 'slack = "least"',
             "holding brake", "run.found", "told=3", "12 March 2026"],
)  # fmt: skip
def test_names_and_terms_are_no_words_of_the_list(text: str) -> None:
    assert avoidable(text) == []
