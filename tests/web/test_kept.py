"""Answers that were given already are given again, from a bounded store."""

from typing import Any

from web.calculators import API, client, document
from wraparc.web.kept import Kept


def test_an_answer_is_found_again() -> None:
    kept = Kept()
    assert kept.find(b"q") is None
    kept.keep(b"q", b"answer")
    assert kept.find(b"q") == b"answer"


def test_what_nobody_asked_for_the_longest_goes_first() -> None:
    kept = Kept(most=40)
    for name in (b"a", b"b", b"c", b"d"):
        kept.keep(name, bytes(9))  # ten bytes with its question
    assert kept.find(b"a") is not None
    kept.keep(b"e", bytes(9))
    assert [kept.find(name) is not None for name in (b"a", b"b", b"c", b"d", b"e")] == [
        True, False, True, True, True,
    ]  # fmt: skip


def test_one_large_answer_does_not_push_out_all_others() -> None:
    kept = Kept(most=40)
    kept.keep(b"a", bytes(9))
    kept.keep(b"large", bytes(11))
    assert kept.find(b"large") is None
    assert kept.find(b"a") is not None


def test_the_same_request_is_not_solved_again_and_another_is() -> None:
    with client() as api:
        workers: Any = api.app.state.wraparc.workers  # type: ignore[attr-defined]
        plain, asked = workers.short, list[Any]()

        def counted(*question: Any, **more: Any) -> Any:
            asked.append(question)
            return plain(*question, **more)

        workers.short = counted
        body = {"document": document()}
        first = api.post(f"{API}/check", json=body)
        again = api.post(f"{API}/check", json=body)
        assert (first.status_code, again.content, len(asked)) == (200, first.content, 1)
        body["document"]["belt"]["width"] = "1190 mm"
        assert api.post(f"{API}/check", json=body).status_code == 200
        assert len(asked) == 2
        wrong: Any = {"document": {}}  # what is refused is asked again
        for _ in range(2):
            assert api.post(f"{API}/check", json=wrong).status_code == 422
        assert len(asked) == 4
