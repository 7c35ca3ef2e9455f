"""The main solver of this process: compiled where that is ready, else interpreted."""

from wraparc.arc import Distributed, Method

_state = {"compiled": False}


def use_compiled() -> bool:
    """Load compiled code, or make it, and use it from now on; False where there is none."""
    from wraparc.checks import compiled as checks
    from wraparc.train import compiled as train

    _state["compiled"] = checks.prepare() and train.prepare()
    return _state["compiled"]


def main_solver(points: int = 180, *, capacities: bool = True) -> Method:
    """Return the main solver; both give the same numbers but for the last digits of a float."""
    if _state["compiled"]:
        from wraparc.batch.compiled import Compiled

        return Compiled(points=points, capacities=capacities)
    return Distributed(points=points, capacities=capacities)
