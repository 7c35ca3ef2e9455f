"""What a worker does before its first answer: import and solve once, so that nobody waits."""

from typing import Any

from wraparc.web.answers import solving
from wraparc.web.examples import examples


def warm(*, compiled: bool = False) -> None:
    """Solve an example, by compiled code if it is there."""
    from wraparc.web.answers.drives import solve_all, solve_fast

    if compiled:
        solving.use_compiled()
    for example in examples()[:1]:
        request: dict[str, Any] = {"document": example.document, "pulley": None}
        request |= {"load_case": None, "points": 60, "sequence": 0, "tables": False}
        solve_fast(request)
        solve_all(request)


def compile_kernel(_: object) -> bool:
    """Compile, so that others find it on the disk; False where nothing can be compiled."""
    import os

    if hasattr(os, "nice"):
        os.nice(10)
    return solving.use_compiled()
