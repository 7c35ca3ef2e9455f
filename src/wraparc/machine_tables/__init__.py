"""Tables out of the files of machines: numbers, columns, units, spreadsheets."""

from wraparc.machine_tables.columns import (
    ColumnUnit,
    NamedColumn,
    find_column,
    listed,
    plain_name,
    read_unit,
)
from wraparc.machine_tables.limits import refused
from wraparc.machine_tables.lines import DELIMITER_NAMES
from wraparc.machine_tables.log_rows import LogFile, LogTag, read_log, refuse_no_log
from wraparc.machine_tables.numerals import NumeralStyle, looks_numeric
from wraparc.machine_tables.read import TableFile, column_words, find_tables, read_bytes
from wraparc.machine_tables.tables import Cells, RawTable

__all__ = [
    "DELIMITER_NAMES",
    "Cells",
    "ColumnUnit",
    "LogFile",
    "LogTag",
    "NamedColumn",
    "NumeralStyle",
    "RawTable",
    "TableFile",
    "column_words",
    "find_column",
    "find_tables",
    "listed",
    "looks_numeric",
    "plain_name",
    "read_bytes",
    "read_log",
    "read_unit",
    "refuse_no_log",
    "refused",
]
