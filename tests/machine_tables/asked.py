"""A small table as text, and what is asked of a file that does not say everything."""

import pytest

from wraparc.errors import InputError
from wraparc.shear_test import Choices, read_machine_bytes


def rows(count: int = 12) -> str:
    return "\n".join(f"{0.1 * k:.1f},{0.25 * k:.2f},{10.5 * k:.1f}" for k in range(count))


def problems(data: bytes, choices: Choices | None = None) -> str:
    with pytest.raises(InputError) as caught:
        read_machine_bytes(data, "test.csv", choices)
    assert all(problem.remedy for problem in caught.value.problems)
    return str(caught.value)
