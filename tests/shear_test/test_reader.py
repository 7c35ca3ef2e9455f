"""Machine exports of every dialect, and the questions asked where a file does not say.

Expected values: what the virtual rig recorded before a dialect wrote it down; the small
hand-written files carry their numbers in the test.
"""

from pathlib import Path

import numpy as np
import pytest

from machine_tables.asked import problems, rows
from shear_test.virtual import rubber
from wraparc.errors import InputError
from wraparc.shear_test import (
    DIALECTS,
    Choices,
    VirtualRig,
    read_machine_bytes,
    read_machine_file,
    read_machine_tests,
    run_virtual_test,
)
from wraparc.shear_test.roles import Role, suitability

TEST = run_virtual_test(VirtualRig(law=rubber(), points=300, wander=0.01), 207e3, 1)
SHORT = run_virtual_test(VirtualRig(law=rubber(), points=60, wander=0.01), 207e3, 1)


@pytest.mark.parametrize("name", DIALECTS)
def test_every_dialect_gives_back_what_was_recorded(name: str) -> None:
    dialect = DIALECTS[name]
    record = read_machine_bytes(dialect.write(TEST), "x", Choices(units=dict(dialect.units)))
    np.testing.assert_allclose(record.travel, TEST.travel, atol=6e-7)  # five digits at the least
    np.testing.assert_allclose(record.force, TEST.force, atol=0.06)
    if record.normal_force is not None:
        np.testing.assert_allclose(record.normal_force, TEST.normal_force, atol=0.01)
    assert (record.normal_force is None) == (name == "microtest")
    assert len(record.lines) == len(TEST.travel)


@pytest.mark.parametrize("name", [name for name in DIALECTS if name != "excel"])
def test_a_file_cut_anywhere_has_no_wrong_number(name: str) -> None:
    dialect = DIALECTS[name]
    data, choices = dialect.write(SHORT), Choices(units=dict(dialect.units))
    whole = read_machine_bytes(data, "x", choices)
    for cut in range(len(data) // 2, len(data), 37):
        try:
            part = read_machine_bytes(data[:cut], "x", choices)
        except InputError:
            continue
        count = len(part.travel)
        np.testing.assert_array_equal(part.travel, whole.travel[:count])
        np.testing.assert_array_equal(part.force, whole.force[:count])


def test_units_are_asked_for_not_guessed() -> None:
    text = problems(b"Time,Extension,Load\n" + rows().encode())
    assert "column Extension has no unit" in text
    assert "column Load has no unit" in text
    assert "Add --unit 'Load=?'." in text
    told = Choices(units={"Extension": "in", "Load": "lbf"})
    record = read_machine_bytes(b"Time,Extension,Load\n" + rows().encode(), "x", told)
    np.testing.assert_allclose(record.travel, 0.25 * 0.0254 * np.arange(12))
    np.testing.assert_allclose(record.force, 10.5 * 4.4482216152605 * np.arange(12))


@pytest.mark.parametrize(
    ("unit", "newtons"),
    [("N", 1.0), ("kN", 1e3), ("mN", 1e-3), ("lbf", 4.4482216152605), ("kgf", 9.80665),
     ("gf", 9.80665e-3), ("cN", 0.01), ("lb", 4.4482216152605), ("kg", 9.80665)],
)  # fmt: skip
def test_units_of_force(unit: str, newtons: float) -> None:
    # NIST SP 811 (2008), appendix B: pound-force, kilogram-force.
    data = f"Time,Extension,Load\n(s),(mm),({unit})\n{rows()}\n".encode()
    record = read_machine_bytes(data, "x")
    np.testing.assert_allclose(record.force, 10.5 * newtons * np.arange(12), rtol=1e-12)
    assert ("kgf" in " ".join(record.notes)) == (unit == "kg")


@pytest.mark.parametrize(
    ("unit", "metres"), [("mm", 1e-3), ("cm", 1e-2), ("m", 1.0), ("in", 0.0254), ('"', 0.0254)]
)
def test_units_of_travel(unit: str, metres: float) -> None:
    data = f"Time [s];Weg [{unit}];Kraft [N]\n{rows().replace(',', ';')}\n".encode()
    record = read_machine_bytes(data, "x")
    np.testing.assert_allclose(record.travel, 0.25 * metres * np.arange(12), rtol=1e-12)


@pytest.mark.parametrize(
    "header",
    ["Weg / mm;Kraft / N", "Weg in mm;Kraft in N", "Weg_mm;Kraft_N", "Weg [mm];Kraft [N]",
     "Weg;Kraft\nmm;N", "Weg;Kraft\n[mm];[N]"],
)  # fmt: skip
def test_units_wherever_they_stand(header: str) -> None:
    table = "\n".join(f"{k / 8:.3f};{k:.2f}".replace(".", ",") for k in range(12))
    record = read_machine_bytes(f"{header}\n{table}\n".encode(), "x")
    np.testing.assert_allclose(record.travel, 0.125e-3 * np.arange(12))
    assert record.decimal == ","


@pytest.mark.parametrize(
    ("travel", "force"),
    [("Extension", "Load"), ("Standardweg", "Prüfkraft"), ("Déplacement", "Charge"),
     ("Desplazamiento", "Fuerza"), ("Deslocamento", "Força"), ("Spostamento", "Forza"),
     ("Przemieszczenie", "Siła"), ("Dráha", "Síla"), ("Verplaatsing", "Kracht"),
     ("Перемещение", "Сила"), ("ストローク", "試験力"), ("位移", "力")],
)  # fmt: skip
def test_names_in_many_languages(travel: str, force: str) -> None:
    # The force stands first: position must not decide.
    table = "\n".join(f"{10.5 * k};{0.25 * k}" for k in range(12))
    record = read_machine_bytes(f"{force};{travel}\nN;mm\n{table}\n".encode(), "x")
    np.testing.assert_allclose(record.travel, 0.25e-3 * np.arange(12))
    np.testing.assert_allclose(record.force, 10.5 * np.arange(12))


@pytest.mark.parametrize(
    ("demanded", "measured"),
    [("Kraft Sollwert", "Kraft"), ("Load setpoint", "Load"), ("Command force", "Force"),
     ("Target load", "Load cell"), ("Consigne force", "Force"), ("Fuerza consigna", "Fuerza"),
     ("Siła zadana", "Siła"), ("設定荷重", "荷重"), ("Sollkraft", "Istkraft"),
     ("Kraft Vorgabe", "Kraft"), ("Kraft Setpunkt", "Kraft"), ("Führungsgröße Kraft", "Kraft"),
     ("Nennkraft", "Kraft"), ("Force demandée", "Force"), ("Force cible", "Force"),
     ("Valor nominal de fuerza", "Fuerza"), ("Fuerza objetivo", "Fuerza"),
     ("Força desejada", "Força"), ("Valor de referência da força", "Força"),
     ("Forza impostata", "Forza"), ("Forza richiesta", "Forza"), ("Żądana siła", "Siła"),
     ("Siła docelowa", "Siła"), ("Žádaná síla", "Síla"), ("Požadovaná síla", "Síla"),
     ("Gewenste kracht", "Kracht"), ("Ingestelde kracht", "Kracht"),
     ("Börvärde kraft", "Kraft"), ("Hedef kuvvet", "Kuvvet"), ("Kuvvet ayar değeri", "Kuvvet"),
     ("Заданная сила", "Сила"), ("Уставка силы", "Сила"), ("目標荷重", "荷重"),
     ("荷重指令", "荷重"), ("目标力", "力"), ("给定载荷", "载荷"), ("Force command", "Force"),
     ("Force demand", "Force"), ("Load_SP", "Load"), ("Reference load", "Load"),
     ("Nominal force", "Force"), ("Kraftsollwert", "Kraft"), ("Kraftvorgabe", "Kraft"),
     ("Kraftsoll", "Kraft"), ("F_set", "F_act"), ("Load setting", "Load"), ("Zielkraft", "Kraft"),
     ("Force programmée", "Force"), ("Force imposée", "Force"), ("Fuerza teórica", "Fuerza"),
     ("Força comandada", "Força"), ("Siła wymagana", "Siła"), ("Программная нагрузка", "Нагрузка"),
     ("命令力", "力"), ("Peak force", "Force"), ("Regelabweichung Kraft", "Kraft"),
     ("Bezugskraft", "Kraft")],
)  # fmt: skip
def test_what_was_demanded_or_is_an_extreme_is_never_taken_for_what_was_measured(
    demanded: str, measured: str
) -> None:
    table = "\n".join(f"{99 + k};{10.5 * k};{0.25 * k}" for k in range(12))
    head = f"{demanded};{measured};Travel\nN;N;mm\n"
    record = read_machine_bytes((head + table).encode(), "x")
    np.testing.assert_allclose(record.force, 10.5 * np.arange(12))
    # alone, it is asked for
    table = "\n".join(f"{99 + k};{0.25 * k}" for k in range(12))
    with pytest.raises(InputError, match="force"):
        read_machine_bytes(f"{demanded};Travel\nN;mm\n{table}\n".encode(), "x")


def test_a_strain_in_japanese_is_no_travel_and_a_normalized_force_presses_nothing() -> None:
    """Its voiced sounds are taken off as accents are, off the words looked for too."""
    assert suitability("ひずみ 変位", Role.TRAVEL) == 0.0
    assert suitability("変位", Role.TRAVEL) > 0.0
    assert suitability("Normalized force", Role.NORMAL_FORCE) == 0.0


def test_machine_is_no_travel_where_the_name_says_force() -> None:
    table = "\n".join(f"{10.5 * k};{0.25 * k};{k}" for k in range(12))
    data = f"Machine_Load;Machine_Displacement;Machine_Time\n{table}\n".encode()
    text = problems(data)
    assert "column Machine_Displacement has no unit" in text
    assert "column Machine_Load has no unit" in text
    told = Choices(units={"Machine_Load": "N", "Machine_Displacement": "mm"})
    np.testing.assert_allclose(read_machine_bytes(data, "x", told).force, 10.5 * np.arange(12))


def test_a_stress_is_a_force_over_the_area_that_is_given() -> None:
    """Closed form: 0.3 MPa over 400 cm2 are 12 kN."""
    table = "\n".join(f"{0.25 * k};{0.1 * k};20" for k in range(12))
    data = f"Travel;Shear stress;Normal stress\nmm;MPa;MPa\n{table}\n".encode()
    text = problems(data)
    assert "force column unclear" in text
    assert 'Add --force, or --stress-area for "Shear stress".' in text
    text = problems(data, Choices(force="Shear stress"))
    assert "column Shear stress holds a stress [MPa], not a force" in text
    assert "Add --stress-area, or export the force." in text
    record = read_machine_bytes(data, "x", Choices(stress_area=0.04))
    assert record.force[3] == pytest.approx(12e3)
    assert "the force is 'Shear stress' [MPa] times 400 cm2" in record.notes[-1]
    # a force is taken where there is one, whatever area is given
    both = data.replace(b"Normal stress", b"Load").replace(b"MPa;MPa", b"MPa;N")
    assert (
        read_machine_bytes(both.replace(b";20", b";2.5", 1), "x", Choices(stress_area=1.0)).force[3]
        == 20.0
    )


@pytest.mark.parametrize(
    ("names", "columns"),
    [
        ("Travel 1;Load 1;Travel 2;Load 2", (0, 1, 2, 3)),
        ("Travel;Load;Travel;Load", (0, 1, 2, 3)),
        ("Travel A1;Travel A2;Load A1;Load A2", (0, 2, 1, 3)),
    ],
)  # fmt: skip
def test_tests_side_by_side_are_read_by_number(
    names: str, columns: tuple[int, int, int, int], tmp_path: Path
) -> None:
    cells = np.zeros((15, 4))
    for place, slope in zip(columns, (0.25, 10.5, 0.5, 4.0), strict=True):
        cells[:, place] = slope * np.arange(15)
    rows = [";".join(map(str, row)) for row in cells]
    units = ";".join("mm" if "Travel" in name else "N" for name in names.split(";"))
    data = "\n".join([names, units, *rows, ""]).encode()
    text = problems(data)
    assert "contains 2 tests side by side. Write block = 1 for the first" in text
    assert "block = 1" in text
    for block, (travel, force) in enumerate([(0.25e-3, 10.5), (0.5e-3, 4.0)], start=1):
        record = read_machine_bytes(data, "x", Choices(block=block))
        np.testing.assert_allclose(record.travel, travel * np.arange(15))
        np.testing.assert_allclose(record.force, force * np.arange(15))
        assert (record.block, record.blocks) == (block, 2)
    assert "block: contains 2 tests side by side, got 3" in problems(data, Choices(block=3))
    named = Choices(travel=columns[2] + 1, force=columns[3] + 1)
    assert read_machine_bytes(data, "x", named).force[1] == 4.0
    (tmp_path / "x.csv").write_bytes(data)
    assert [r.block for r in read_machine_tests(tmp_path / "x.csv")] == [1, 2]


def test_a_block_of_a_file_with_one_test_is_refused() -> None:
    data = f"Time,Extension (mm),Load (N)\n{rows()}\n".encode()
    assert "block: contains one test only, got 2" in problems(data, Choices(block=2))


def test_axes_of_a_tribometer() -> None:
    """Fz presses, Fx is friction; Z is the depth of wear, not the travel."""
    table = "\n".join(f"{0.01 * k};800;{10.5 * k};{0.25 * k}" for k in range(12))
    record = read_machine_bytes(
        f"Z;Fz;Fx;X\nmm;N;N;mm\n{table}\n".encode(), "x", Choices(travel="X")
    )
    assert record.normal_force is not None
    np.testing.assert_allclose(record.normal_force, 800.0)
    np.testing.assert_allclose(record.force, 10.5 * np.arange(12))


def test_several_travel_columns_are_named() -> None:
    table = "\n".join(f"{k - 794.8},{k},{10 * k}" for k in range(12))
    data = f"Traverse absolue,Course standard,Force standard\nmm,mm,N\n{table}\n".encode()
    record = read_machine_bytes(data, "x")
    assert record.travel[1] == pytest.approx(1e-3)
    assert (
        "the travel is 'Course standard'; the file also has 'Traverse absolue'" in record.notes[0]
    )
    other = read_machine_bytes(data, "x", Choices(travel="Traverse absolue"))
    assert other.travel[1] == pytest.approx(-0.7938)
    assert read_machine_bytes(data, "x", Choices(travel=1)).travel[1] == other.travel[1]


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"", "test.csv: is empty"),
        (b" \r\n\r\n", "test.csv: is empty"),
        (bytes(range(256)) * 20, "test.csv: is binary, no text"),
        (b"%PDF-1.7 ...", "is a PDF document, no table"),
        (b"PK\x03\x04nothing", "cannot be opened as workbook"),
        (b"Dear all,\nplease find attached\n", "has no line with two numbers"),
        (b"Extension (mm),Load (N)\n", "has no line with two numbers"),
    ],
)
def test_files_that_are_no_tests(data: bytes, sentence: str) -> None:
    assert sentence in problems(data)


def test_unknown_columns_list_what_is_there() -> None:
    data = b"Extension (mm),Load (N)\n" + b"\n".join(b"%d,%d" % (k, k) for k in range(12))
    text = problems(data, Choices(force="Lod"))
    assert 'force: no such column, got "Lod". Did you mean "Load"?' in text
    text = problems(b"alpha,beta\n" + b"\n".join(b"%d,%d" % (k, k) for k in range(12)))
    assert "travel column unclear" in text


def test_a_unit_that_contradicts_the_file_is_refused() -> None:
    data = b"Extension (mm),Load (N)\n" + b"\n".join(b"%d,%d" % (k, k) for k in range(12))
    assert 'contradicts "N" in the file, got "kN"' in problems(data, Choices(units={"Load": "kN"}))
    assert "which is not a force" in problems(data, Choices(force=1, travel=2))


def test_files_that_cannot_be_opened(tmp_path) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(InputError, match="file not found"):
        read_machine_file(tmp_path / "missing.csv")
    with pytest.raises(InputError, match="is a folder"):
        read_machine_file(tmp_path)
    with pytest.raises(InputError):
        read_machine_file("a\0b")
