"""Linear equations of a train, some few: plain numbers, so that the page solves them too."""

from __future__ import annotations

from collections.abc import Sequence

Row = list[float]
Matrix = list[list[float]]


def solution(matrix: Sequence[Sequence[float]], right: Sequence[float]) -> list[float] | None:
    """Solve linear equations by elimination, the largest of each column for pivot.

    Returns
    -------
    None where the matrix is singular or not finite.
    """
    count = len(right)
    rows = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    for k in range(count):
        best = k
        for i in range(k + 1, count):
            if abs(rows[i][k]) > abs(rows[best][k]):
                best = i
        pivot = rows[best]
        rows[best] = rows[k]
        rows[k] = pivot
        if not abs(pivot[k]) > 0.0:
            return None
        for i in range(k + 1, count):
            factor = rows[i][k] / pivot[k]
            for j in range(k + 1, count + 1):
                rows[i][j] -= factor * pivot[j]
    found = [0.0] * count
    for k in range(count - 1, -1, -1):
        rest = rows[k][count]
        for j in range(k + 1, count):
            rest -= rows[k][j] * found[j]
        found[k] = rest / rows[k][k]
    return found
