"""Several tests side by side in one table: the same columns again and again."""

import re
from collections.abc import Mapping, Sequence

from wraparc.machine_tables import NamedColumn, plain_name
from wraparc.shear_test.roles import Role, suitability

_NUMBER = re.compile(r"\d+")


def side_by_side(named: Sequence[NamedColumn]) -> list[list[NamedColumn]]:
    """Return the columns of each test; one list of all if there is one test only.

    Tests stand side by side where every travel and every force column comes as often as any
    other of them, but for numbers in the names. A column that comes once belongs to all.
    """
    groups: dict[str, list[NamedColumn]] = {}
    for column in named:
        groups.setdefault(_NUMBER.sub("", plain_name(column.name)).strip(), []).append(column)
    travels, forces = (_counts(groups, role) for role in (Role.TRAVEL, Role.FORCE))
    number = max(travels, default=1)
    if number < 2 or not travels == forces == {number}:
        return [list(named)]
    blocks: list[list[NamedColumn]] = [[] for _ in range(number)]
    for name, columns in groups.items():
        if name and len(columns) == number:
            for block, column in zip(blocks, columns, strict=True):
                block.append(column)
        elif name and len(columns) == 1:
            for block in blocks:
                block.append(columns[0])
    return [sorted(block, key=lambda column: column.index) for block in blocks]


def _counts(groups: Mapping[str, Sequence[NamedColumn]], role: Role) -> set[int]:
    """How often each column of a role comes."""
    return {len(own) for own in groups.values() if suitability(own[0].name, role) > 0.0}
