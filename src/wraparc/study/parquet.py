"""Results of a study as Parquet: parts that stand for themselves, and the file made of them.

pyarrow is imported where it is used; it comes with the extra ``study``.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arrays import Array
from wraparc.checks.of_rows import NOT_CHECKED
from wraparc.errors import MissingExtraError, input_error, shown
from wraparc.glossary import GLOSSARY
from wraparc.study.histogram import limit_column
from wraparc.study.parameter_study import (
    CONDITION,
    DESIGN,
    FRICTION_FACTOR,
    JUDGED,
    LOAD_CASE,
    STATUS,
    STATUS_WORDS,
    WITHIN,
    Study,
)
from wraparc.units import DIMENSION_TEXT
from wraparc.version import __version__

METADATA = b"wraparc.study"
_COMPRESSION = "zstd"


def require_pyarrow() -> Any:
    """Return pyarrow, or say how to get it."""
    try:
        import pyarrow as pa
        import pyarrow.parquet
    except ImportError as error:
        raise MissingExtraError("pyarrow", "study") from error
    return pa


def words_of(study: Study) -> dict[str, tuple[str, ...]]:
    """Columns that hold words, and the words by their places."""
    words = {LOAD_CASE: study.load_cases, STATUS: STATUS_WORDS, **JUDGED}
    if study.conditions:
        words[CONDITION] = tuple(c.name for c in study.conditions)
    for axis in study.plan.levels:
        if not axis.numeric:
            words[axis.field] = tuple(str(value) for value in axis.values)
    return words


def units_of(study: Study) -> dict[str, str]:
    """SI unit of every column of numbers, in the order of the columns after the first ones."""
    units: dict[str, str] = {}
    for axis in study.plan.levels:
        if axis.dimension is not None:
            units[axis.field] = DIMENSION_TEXT[axis.dimension].si_unit
    for drawn in study.plan.drawn:
        for name, dimension in drawn.columns.items():
            if not name.startswith("condition."):
                units[name] = DIMENSION_TEXT[dimension].si_unit
    if study.conditions:
        units[FRICTION_FACTOR] = ""
    for name in study.outputs:
        units[name] = DIMENSION_TEXT[GLOSSARY[name].dimension].si_unit
    for name in study.limited:
        units[limit_column(name)] = DIMENSION_TEXT[GLOSSARY[name].dimension].si_unit
    return units


def schema_of(study: Study) -> Any:
    """Arrow schema of the results, the study itself in its metadata."""
    pa = require_pyarrow()
    word = pa.dictionary(pa.int32(), pa.string())
    levels = [axis.field for axis in study.plan.levels]
    words, units = words_of(study), units_of(study)
    results = [*study.outputs, *map(limit_column, study.limited)]
    axes = list(dict.fromkeys([*levels, *(n for n in units if n not in results)]))
    first = [DESIGN, LOAD_CASE, *([CONDITION] if study.conditions else []), *axes]
    fields = []
    for name in (*first, STATUS, WITHIN, *JUDGED, *results):
        if name in words:
            fields.append(pa.field(name, word))
        elif name == DESIGN:
            fields.append(pa.field(name, pa.int64()))
        elif name == WITHIN:
            fields.append(pa.field(name, pa.bool_()))
        else:
            fields.append(pa.field(name, pa.float64(), metadata={"unit": units[name]}))
    return pa.schema(fields, metadata={METADATA: json.dumps(study_data(study))})


def study_data(study: Study) -> dict[str, Any]:
    """What a reader of the results must know of the study, as plain data."""
    plan = study.plan
    return {
        "program": f"wraparc {__version__}",
        "fingerprint": study.fingerprint,
        "title": study.title,
        "designs": len(plan),
        "rows": study.rows,
        "plan": type(plan).__name__.lower(),
        "levels": {axis.field: list(axis.values) for axis in plan.levels},
        "drawn": [name for axis in plan.drawn for name in axis.columns],
        "sampling": plan.sampling.name if plan.drawn else "",
        "samples": plan.samples,
        "seed": plan.seed,
        "load_cases": list(study.load_cases),
        "conditions": {c.name: c.share for c in study.conditions},
        "setting": study.setting.value,
        "outputs": list(study.outputs),
        "limited": list(study.limited),
        "ground": study.ground,
        "data_line": study.data_line,
        "not_checked": list(NOT_CHECKED),
        "input": study.description,
    }


def table_of(study: Study, columns: Mapping[str, Array]) -> Any:
    """Arrow table of columns as `Study.solve` returns them."""
    pa = require_pyarrow()
    words, schema = words_of(study), schema_of(study)
    arrays = []
    for name in schema.names:
        column = columns[name]
        if name in words:
            codes = _bare(column.astype(np.int32), pa.int32())
            arrays.append(pa.DictionaryArray.from_arrays(codes, _texts(words[name])))
        elif name == WITHIN:
            bits = np.packbits(column.astype(bool), bitorder="little")
            arrays.append(_bare(bits, pa.bool_(), len(column)))
        else:
            arrays.append(_bare(column, schema.field(name).type))
    return pa.Table.from_arrays(arrays, schema=schema)


def _texts(words: tuple[str, ...]) -> Any:
    import pyarrow as pa

    data = [word.encode("utf-8") for word in words]
    ends = np.cumsum([0, *map(len, data)], dtype=np.int32)
    buffers = [None, pa.py_buffer(ends), pa.py_buffer(b"".join(data))]
    return pa.Array.from_buffers(pa.string(), len(words), buffers)


def _bare(column: NDArray[Any], kind: Any, size: int | None = None) -> Any:
    """Arrow array on the memory of an array; `pyarrow.array` would import pandas first."""
    import pyarrow as pa

    whole = np.ascontiguousarray(column)
    rows = len(whole) if size is None else size
    return pa.Array.from_buffers(kind, rows, [None, pa.py_buffer(whole)])


def solve_part(study: Study, start: int, stop: int, progress: Any = None) -> bytes:
    """Solve the designs `start` to `stop`; return them as a Parquet file.

    All that a worker of a cluster is asked: it depends on nothing but its arguments, and doing it
    twice does no harm.
    """
    pa = require_pyarrow()
    sink = pa.BufferOutputStream()
    table = table_of(study, study.solve(start, stop, progress=progress))
    with _writer(sink, table.schema) as writer:
        writer.write_table(table)
    return bytes(sink.getvalue())


def _writer(where: Any, schema: Any) -> Any:
    import pyarrow as pa
    import pyarrow.parquet as pq

    words = [f.name for f in schema if pa.types.is_dictionary(f.type)]
    numbers = {f.name: "BYTE_STREAM_SPLIT" for f in schema if pa.types.is_floating(f.type)}
    encodings = {DESIGN: "DELTA_BINARY_PACKED", **numbers}
    return pq.ParquetWriter(
        where,
        schema,
        compression=_COMPRESSION,
        compression_level=1,
        use_dictionary=words,
        column_encoding=encodings,
    )


def rows_of(path: Path, fingerprint: str) -> int:
    """Rows of a part; -1 if it is no whole part of that study."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        found = pq.read_metadata(path)
        told = json.loads((found.metadata or {}).get(METADATA, b"{}"))
    except (OSError, ValueError, pa.ArrowException):
        return -1
    return int(found.num_rows) if told.get("fingerprint") == fingerprint else -1


def merge(parts: Iterable[Path], schema: Any, target: Path) -> None:
    """Write parts into one file, a row group a part."""
    import pyarrow.parquet as pq

    with _writer(str(target), schema) as writer:
        for part in parts:
            with pq.ParquetFile(part) as file:
                table = file.read()
                if table.schema != schema:  # a cast imports twice what a part takes
                    table = table.cast(schema)
                writer.write_table(table.replace_schema_metadata(schema.metadata))


def read_data(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return what the results say of their study.

    Raises
    ------
    InputError
        If the file is no results of a study.
    """
    pa = require_pyarrow()
    import pyarrow.parquet as pq

    try:
        found = pq.read_metadata(path).metadata or {}
        data: dict[str, Any] = json.loads(found[METADATA])
    except (OSError, KeyError, ValueError, pa.ArrowException):
        name = shown(os.fspath(path))
        message = "is no file of results of a study"
        raise input_error(value=name, message=message) from None
    return data


def batches(path: str | os.PathLike[str], columns: Iterable[str]) -> Iterator[dict[str, Any]]:
    """Yield some columns of results, a row group at a time; words as their places."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    with pq.ParquetFile(path) as file:
        for group in range(file.num_row_groups):
            table = file.read_row_group(group, columns=list(columns)).combine_chunks()
            found: dict[str, Any] = {}
            for name in table.column_names:
                column = table.column(name).chunk(0)
                if pa.types.is_dictionary(column.type):
                    found[name] = _numbers(column.indices), column.dictionary.to_pylist()
                else:
                    found[name] = _numbers(column)
            yield found


def _numbers(array: Any) -> NDArray[Any]:
    """The memory of an Arrow array without nulls; its own `to_numpy` would import pandas first."""
    import pyarrow as pa

    data = array.buffers()[1]
    begin, end = array.offset, array.offset + len(array)
    if pa.types.is_boolean(array.type):
        bits = np.unpackbits(np.frombuffer(data, np.uint8), count=end, bitorder="little")
        return bits[begin:].astype(bool)
    kinds = {"double": np.float64, "int64": np.int64, "int32": np.int32}
    numbers: NDArray[Any] = np.frombuffer(data, kinds[str(array.type)], count=end)
    return numbers[begin:]
