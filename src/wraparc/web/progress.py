"""How far a long task is: its process tells whoever follows it."""

from collections.abc import Callable

Tell = Callable[[int, int, str], None]


def unheard(done: int, total: int, message: str) -> None:
    """Progress that nobody asks for."""


_tellers: list[Tell] = [unheard]


def tell(done: int, total: int, message: str) -> None:
    """Tell how many are done, of how many, and what is being done."""
    _tellers[-1](done, total, message)


def tell_to(teller: Tell) -> None:
    """Let a function hear of the progress of this process from now on."""
    _tellers.append(teller)
