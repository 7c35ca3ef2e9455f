"""What was read from a machine file: the choices a user may make, and the record."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.shear_test.stated import Stated


@dataclass(frozen=True, kw_only=True)
class Choices:
    """What the user says about a file; everything left out is found in the file or asked for.

    Parameters
    ----------
    travel, force, normal_force, time
        Column by its name as written, or by its number counted from 1.
    units
        Unit by column name or number, where the file has none, such as
        ``{"Elongation": "mm"}``. It must not contradict the file.
    decimal
        ``"."`` or ``","``.
    delimiter
        ``"tab"``, ``"semicolon"``, ``"comma"``, ``"blanks"``, ``"bar"``.
    encoding
        Python's name of it.
    sheet
        Sheet of a workbook.
    table
        Number of the table in the file, counted from 1.
    block
        Which of several tests that stand in the table, side by side or under each other,
        counted from 1.
    stress_area
        Area that the machine divided the force by, where the force column is a stress [m2].
    in_plan
        Whether a plan says this, where what is missing is to be written.
    """

    travel: str | int | None = None
    force: str | int | None = None
    normal_force: str | int | None = None
    time: str | int | None = None
    units: Mapping[str, str] = field(default_factory=dict)
    decimal: str | None = None
    delimiter: str | None = None
    encoding: str | None = None
    sheet: str | None = None
    table: int | None = None
    block: int | None = None
    stress_area: float | None = None
    in_plan: bool = False


@dataclass(frozen=True, kw_only=True)
class ColumnInfo:
    """One column of the table that was read.

    Parameters
    ----------
    name, unit
        As written; the unit is empty where there is none.
    role
        ``"travel"``, ``"force"``, ``"normal_force"``, ``"time"``; empty if not used.
    low, high
        Smallest and largest number in the column, in its own unit; NaN if it has none.
    """

    name: str
    unit: str
    role: str = ""
    low: float = np.nan
    high: float = np.nan


@dataclass(frozen=True, kw_only=True)
class Dropped:
    """Rows that were left out: why, how many, and the line of the first."""

    reason: str
    count: int
    line: int


@dataclass(frozen=True, kw_only=True, eq=False)
class MachineRecord:
    """One test as the machine wrote it, in SI units, nothing reduced.

    Parameters
    ----------
    file
        Name as the user gave it.
    place
        The table that was read, for example ``"lines 13 to 2196"``.
    encoding, delimiter, decimal
        How it is written; the encoding is ``"workbook"`` for Excel.
    columns
        All columns of the table.
    travel
        Travel as written, sign and zero untouched [m], shape (n,).
    force
        Force as written [N], shape (n,).
    normal_force
        Measured normal force [N], shape (n,), if the file has it.
    time
        Time [s], shape (n,), if the file has it.
    lines
        Line (sheet row) of each row kept, shape (n,).
    rows
        Rows of numbers that stood in the table, kept and dropped.
    dropped
        What was left out.
    notes
        Every choice that was made, and other things worth knowing, as sentences.
    header
        Lines above the table, cells joined.
    digest
        SHA-256 of the file, by which duplicates are recognised.
    block, blocks
        Which test of those in the table this is, side by side or under each other, and how many
        there are.
    part
        What the file calls this test of those under each other, such as ``"test_id T1"``.
    stated
        What the file says of the test beside its readings.
    passed_over
        Columns that might have been taken as well, and were not.
    unread
        Further tables of the file with the same columns that were not read.
    """

    file: str
    place: str
    encoding: str
    delimiter: str
    decimal: str
    columns: tuple[ColumnInfo, ...]
    travel: Array
    force: Array
    normal_force: Array | None
    time: Array | None
    lines: Integers
    rows: int
    dropped: tuple[Dropped, ...]
    notes: tuple[str, ...]
    header: tuple[str, ...]
    digest: str
    block: int = 1
    blocks: int = 1
    part: str = ""
    stated: tuple[Stated, ...] = ()
    passed_over: tuple[str, ...] = ()
    unread: int = 0

    def unit_of(self, role: str) -> str:
        """Unit of the column of a role as written; empty where it is not known."""
        return next((column.unit for column in self.columns if column.role == role), "")
