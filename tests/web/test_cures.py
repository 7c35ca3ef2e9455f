"""What the page offers to a drive that is not in order: pressing it leads to an end."""

from web.browser import Visitor
from web.cures import failing, pressed


def test_pressing_what_is_offered_ends_in_order_or_in_honest_words(long_visit: Visitor) -> None:
    # expected: two presses at most, then every check passes by the server, or the page says that
    # nothing tried does, or which data are missing; benchmarks/cures.py does the same with 60
    page = long_visit.page
    ends = {}
    for seed, document in failing(4):
        end, presses, said = pressed(long_visit, page, document)
        ends[seed] = end
        assert end in ("OK", "none passes", "data missing"), (seed, presses, said)
    assert "OK" in ends.values()
