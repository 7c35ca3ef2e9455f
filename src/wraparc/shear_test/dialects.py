"""Virtual tests written as machines write them, for examples and for tests of the reader.

Each dialect has the quirks of the exports it is modelled on: headers, languages, units,
decimal signs, encodings, marks at the end. The text is our own.
"""

import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import MissingExtraError
from wraparc.shear_test.virtual_rig import VirtualTest

_LBF = 4.4482216152605
_INCH = 0.0254
_MADE = datetime(2026, 1, 1, tzinfo=UTC)


@dataclass(frozen=True)
class Dialect:
    """A way to write a test.

    Parameters
    ----------
    name
        To choose it by.
    suffix
        Of its files.
    write
        Test to bytes of a file.
    units
        What a reader must be told, for a dialect that does not state its units.
    """

    name: str
    suffix: str
    write: Callable[[VirtualTest], bytes]
    units: tuple[tuple[str, str], ...] = ()


def _lines(header: Sequence[str], rows: Sequence[str], end: str) -> str:
    return end.join([*header, *rows]) + end


def _grouped(values: Array, digits: int) -> list[str]:
    return [f"{value:,.{digits}f}" for value in values]


def _bluehill(test: VirtualTest) -> bytes:
    header = [
        'Specimen properties : Specimen label,"virtual"',
        'Normal pressure,"' + f"{test.pressure / 1e3:.1f}" + '",kPa',
        "",
        "Time,Extension,Load,Normal force",
        "(s),(mm),(N),(N)",
    ]
    columns = zip(
        _grouped(test.time, 5),
        _grouped(test.travel * 1e3, 5),
        _grouped(test.force, 5),
        _grouped(test.normal_force, 3),
        strict=True,
    )
    rows = [",".join(f'"{cell}"' for cell in row) for row in columns]
    return _lines(header, rows, "\r\n").encode("utf-8")


def _bluehill_inch(test: VirtualTest) -> bytes:
    header = ["Results Table 1;;;;", ";;;;", ";Time;Displacement;Force;Normal force"]
    header.append(";(s);(in);(lbf);(lbf)")
    columns = zip(
        test.time, test.travel / _INCH, test.force / _LBF, test.normal_force / _LBF, strict=True
    )
    rows = [f";{t:.4f};{x:.6f};{f:.5f};{n:.4f}" for t, x, f, n in columns]
    return _lines(header, rows, "\r\n").encode("ascii")


def _testxpert(test: VirtualTest) -> bytes:
    header = [
        '"Prüfer";"virtuell"',
        '"Prüfgeschwindigkeit";10;"mm/min"',
        '"Prüfzeit";"Standardweg";"Traverse absolut";"Standardkraft";"Normalkraft"',
        '"s";"mm";"mm";"N";"kN"',
    ]
    columns = zip(test.time, test.travel * 1e3, test.force, test.normal_force / 1e3, strict=True)
    rows = [
        f"{t:.4f};{x:.6g};{x - 794.8:.3f};{f:.6g};{n:.5f}".replace(".", ",")
        for t, x, f, n in columns
    ]
    return _lines(header, rows, "\n").encode("latin-1")


def _trapezium(test: VirtualTest) -> bytes:
    header = ['"1 _ 1"', '"Time","Force","Stroke","Normal load"', '"sec","N","mm","N"']
    columns = zip(test.time, test.force, test.travel * 1e3, test.normal_force, strict=True)
    rows = [f"{t:.3f},{f:.5f},{x:.6f},{n:.2f}" for t, f, x, n in columns]
    return _lines(header, rows, "\r\n").encode("utf-8-sig")


def _testsuite(test: VirtualTest) -> bytes:
    header = [
        "Station Name:\tvirtual rig",
        "Data Acquisition: Timed Data",
        "Running Time\tCrosshead\tLoad\tClamp force",
        "Sec\tmm\tkN\tkN",
    ]
    columns = zip(
        test.time, test.travel * 1e3, test.force / 1e3, test.normal_force / 1e3, strict=True
    )
    rows = [f"{t:.5f}\t{x:.7f}\t{f:.8f}\t{n:.6f}" for t, x, f, n in columns]
    peaks = ["", "Data Acquisition: Peak", "Running Time\tCrosshead\tLoad\tClamp force"]
    peaks += ["Sec\tmm\tkN\tkN", rows[len(rows) // 2], rows[-1]]
    return _lines(header, [*rows, *peaks], "\n").encode("utf-16")


def _pointed(number: str) -> str:
    """Drop the zero before a leading point, as BASIC programs do."""
    return number.replace("0.", ".", 1) if number.lstrip("-").startswith("0.") else number


def _microtest(test: VirtualTest) -> bytes:
    header = [
        '"Sample : Default"',
        '"Span : 10,0"',
        '"Max extension : ' + f"{test.travel.max() * 1e3:.3f}".replace(".", ",") + 'mm"',
        '"Point","Elongation","Force","Code","Motorspeed"',
    ]
    points = enumerate(zip(test.travel * 1e3, test.force, strict=True), start=1)
    rows = [
        f'{_pointed(f"{k / 10:g}")},{_pointed(f"{x:.5g}")},{_pointed(f"{f:.6g}")},0,"10 mm/min"'
        for k, (x, f) in points
    ]
    rows.append(f'{(len(rows) + 1) / 10:g},0,0,1,"10 mm/min"')
    return _lines(header, rows, "\r\n").encode("ascii")


def _logger(test: VirtualTest) -> bytes:
    header = ["# virtual rig", "Time_s   Displacement_mm   Force_N   F_n_N"]
    columns = zip(test.time, test.travel * 1e3, test.force, test.normal_force, strict=True)
    rows = [f"{t:10.3f} {x:16.6f} {f:10.4f} {n:10.2f}" for t, x, f, n in columns]
    return _lines(header, rows, "\n").encode("ascii")


def _polish(test: VirtualTest) -> bytes:
    header = ["Czas [s];Przemieszczenie [mm];Siła [N];Siła normalna [N]"]
    columns = zip(test.time, test.travel * 1e3, test.force, test.normal_force, strict=True)
    rows = [f"{t:.3f};{x:.6f};{f:.4f};{n:.2f}".replace(".", ",") for t, x, f, n in columns]
    return _lines(header, rows, "\r\n").encode("cp1250")


def _excel(test: VirtualTest) -> bytes:
    try:
        import xlsxwriter
    except ImportError:
        raise MissingExtraError("xlsxwriter", "report") from None
    stream = io.BytesIO()
    book = xlsxwriter.Workbook(stream, {"in_memory": True})
    book.set_properties({"created": _MADE})  # else the same test gives other bytes each time
    cover = book.add_worksheet("Summary")
    cover.write_row(0, 0, ["Operator", "virtual"])
    cover.write_row(1, 0, ["Pressure", test.pressure / 1e3, "kPa"])
    sheet = book.add_worksheet("Raw data")
    sheet.write_row(2, 1, ["Time", "Stroke", "Load", "Normal load"])
    sheet.write_row(3, 1, ["s", "mm", "N", "N"])
    columns = (test.time, test.travel * 1e3, test.force, test.normal_force)
    for place, values in enumerate(columns, start=1):
        sheet.write_column(4, place, np.round(values, 6).tolist())
    book.close()
    return stream.getvalue()


#: Dialects by name.
DIALECTS: dict[str, Dialect] = {
    dialect.name: dialect
    for dialect in (
        Dialect("bluehill", ".csv", _bluehill),
        Dialect("bluehill-inch", ".csv", _bluehill_inch),
        Dialect("testxpert", ".TRA", _testxpert),
        Dialect("trapezium", ".csv", _trapezium),
        Dialect("testsuite", ".txt", _testsuite),
        Dialect("microtest", ".MTR", _microtest, (("Elongation", "mm"), ("Force", "N"))),
        Dialect("logger", ".dat", _logger),
        Dialect("polish", ".csv", _polish),
        Dialect("excel", ".xlsx", _excel),
    )
}
