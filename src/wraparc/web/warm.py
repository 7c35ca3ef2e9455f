"""What a worker does before its first answer: import and solve once, so that nobody waits."""

import os

from wraparc.web.answers import solving
from wraparc.web.asked import FastRequest, SolveRequest
from wraparc.web.examples import examples


def warm(*, compiled: bool = False) -> None:
    """Solve an example, by compiled code if it is there."""
    from wraparc.web.answers.drives import solve_all, solve_fast

    if compiled:
        solving.use_compiled()
    for example in examples()[:1]:
        solve_fast(FastRequest(document=example.document, points=60))
        solve_all(SolveRequest(document=example.document, points=60))


def compile_kernel() -> bool:
    """Compile, so that others find it on the disk; False where nothing can be compiled."""
    if hasattr(os, "nice"):
        os.nice(10)
    return solving.use_compiled()
