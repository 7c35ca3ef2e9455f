"""What a worker does before its first answer: import and solve once, so that nobody waits."""

from wraparc.web.asked import FastRequest, SolveRequest
from wraparc.web.examples import examples


def warm() -> None:
    """Solve an example."""
    from wraparc.web.answers.drives import solve_all, solve_fast

    for example in examples()[:1]:
        solve_fast(FastRequest(document=example.document, points=60))
        solve_all(SolveRequest(document=example.document, points=60))
