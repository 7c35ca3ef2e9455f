"""Load cases out of tables that other programs print: heads, units, kinds, what is asked.

The numbers are made up; heads and layouts are those of programs and offices in six languages.
"""

from pathlib import Path
from typing import Any

import pytest
import xlsxwriter

from cli.running import DRIVE, drive_file, wraparc
from wraparc import InputError
from wraparc.drive.case_names import named_kinds
from wraparc.files.print_out import read_print_out
from wraparc.train.file import load_drive

KIP, LBF = 4448.2216152605, 4.4482216152605
Cases = dict[str, tuple[str, dict[str, dict[str, str]]]]


def read(folder: Path, text: str, **more: Any) -> Cases:
    path = folder / "table.csv"
    path.write_text(text, "utf-8")
    return {
        case["name"]: (case.get("kind", "running"), case["pulley"])
        for case in read_print_out(path, **more).cases
    }


def pair(entry: str, leaving: str) -> dict[str, str]:
    return {"entry_tension": entry, "exit_tension": leaving}


PLAIN = "Load case;T1 [lbf];T2 [lbf]\nfull running;46850;17200\nfull start;60900;17200\n"


def test_a_row_a_load_case(tmp_path: Path) -> None:
    assert read(tmp_path, f"C-101 overland\n{PLAIN}e-stop;25600;19400\n") == {
        "full running": ("running", {"drive": pair("46850 lbf", "17200 lbf")}),
        "full start": ("starting", {"drive": pair("60900 lbf", "17200 lbf")}),
        "e-stop": ("braking", {"drive": pair("25600 lbf", "19400 lbf")}),
    }


def test_a_row_a_load_case_and_pulley(tmp_path: Path) -> None:
    text = (
        "Case,Pulley,T1 (kip),Te (kip)\nfull,head,46.85,29.65\nfull,tail,22.1,5.2\n"
        '"inclines full, declines empty",head,52.3,35.3\n'
        '"inclines full, declines empty",tail,20.1,3.3\n'
    )
    found = read(tmp_path, text)
    assert list(found) == ["full", "inclines full, declines empty"]
    head = {"entry_tension": "46.85 kip", "effective_tension": "29.65 kip"}
    assert found["full"][1]["head"] == head
    assert list(found["full"][1]) == ["head", "tail"]


def test_pulleys_in_the_heads_and_decimal_commas(tmp_path: Path) -> None:
    text = (
        "Lastfall;Antrieb 1 T1 (kN);Antrieb 1 T2 (kN);T1 Antrieb 2 (kN);T2 Antrieb 2 (kN)\n"
        "Betrieb voll;210,5;120,1;120,1;60,2\nAnlauf;280,5;150,1;150,1;60,2\n"
    )
    assert read(tmp_path, text)["Anlauf"] == (
        "starting",
        {"Antrieb 1": pair("280.5 kN", "150.1 kN"), "Antrieb 2": pair("150.1 kN", "60.2 kN")},
    )


@pytest.mark.parametrize(
    "heads",
    [
        "Load case;Tight side tension;Slack side tension;Effective tension",
        "Lastfall;Auflaufende Kraft;Ablaufende Kraft;Umfangskraft",
        "Caso de carga;Tensión de entrada;Tensión de salida;Tensión efectiva",
        "Cas de charge;Tension d'entrée;Tension de sortie;Effort tangentiel",
        "Condição;Tensão de entrada;Tensão de saída;Tensão efetiva",
        "Caso di carico;Tensione in entrata;Tensione in uscita;Forza periferica",
        "Case;T1;T2;Te",
    ],
)
@pytest.mark.parametrize(
    ("unit", "written"), [("kN", "kN"), ("lbf", "lbf"), ("kip", "kip"), ("kgf", "kgf")]
)
def test_heads_in_six_languages(heads: str, unit: str, written: str, tmp_path: Path) -> None:
    """Te beside both is their difference, and left out."""
    first, *others = heads.split(";")
    text = ";".join([first, *(f"{head} [{unit}]" for head in others)])
    found = read(tmp_path, f"{text}\nvoll;50;20;30\nleer;30;20;10\n")
    assert found["voll"] == ("running", {"drive": pair(f"50 {written}", f"20 {written}")})
    bare = read(tmp_path, f"{heads}\nvoll;50;20;30\nleer;30;20;10\n", unit=unit)
    assert bare == found


def test_a_mass_as_unit_of_a_tension_is_its_weight(tmp_path: Path) -> None:
    found = read(tmp_path, "Case;T1 (kg);T2 (kg)\nfull;5000;2000\nempty;3000;2000\n")
    assert found["full"][1]["drive"]["entry_tension"] == "49.03325 kN"


@pytest.mark.parametrize(
    ("name", "kinds"),
    [
        ("full start", ["starting"]), ("E-Stop 2", ["braking"]), ("Anlauf beladen", ["starting"]),
        ("Bremsung", ["braking"]), ("Not-Aus", ["braking"]), ("arranque cargado", ["starting"]),
        ("frenado de emergencia", ["braking"]), ("démarrage à vide", ["starting"]),
        ("arrêt d'urgence", ["braking"]), ("partida", ["starting"]), ("frenagem", ["braking"]),
        ("avviamento", ["starting"]), ("arresto", ["braking"]), ("running full", []),
        ("standstill", []), ("after stop", []), ("nach Anlauf", []), ("Aceleração", ["starting"]),
        ("aborted start, stop", ["starting", "braking"]),
    ],
)  # fmt: skip
def test_kinds_by_the_names_of_load_cases(name: str, kinds: list[str]) -> None:
    assert named_kinds(name) == kinds


def refusal(folder: Path, text: str, **more: Any) -> str:
    with pytest.raises(InputError) as caught:
        read(folder, text, **more)
    return str(caught.value).replace(str(folder / "table.csv"), "table.csv")


def test_what_is_in_doubt_is_asked(tmp_path: Path) -> None:
    both = "Case;T1 (kN);T2 (kN)\nfull;50;20\nstart and stop;60;20\n"
    assert refusal(tmp_path, both) == (
        'table.csv: load case "start and stop" may be starting or braking. Add --kind '
        '"start and stop=running", starting or braking.'
    )
    told = read(tmp_path, both, kinds={"start and stop": "braking", "full": "starting"})
    assert [kind for kind, _ in told.values()] == ["starting", "braking"]
    thousands = 'Case,T1 (lbf),T2 (lbf)\nfull,"46,850","17,200"\nempty,"22,100","16,900"\n'
    assert "46,850 may be 46.850 or 46850" in refusal(tmp_path, thousands)
    assert 'Add --decimal "."' in refusal(tmp_path, thousands)
    full = read(tmp_path, thousands, decimal=".")["full"][1]["drive"]
    assert full == pair("46850 lbf", "17200 lbf")


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("Case;T1;T2\nfull;50;20\nempty;3;2\n",
         'column "T1" has no unit. Add --unit kN, lbf or kip.'),
        ("Case;T1 (mm);T2 (mm)\nfull;50;20\nempty;3;2\n", 'column "T1" has the unit "mm". Add'),
        ("Case;speed;lift\nfull;50;20\nempty;3;2\n", "contains no table of T1, T2 or Te"),
        ("T1 (kN);T2 (kN)\n50;20\n30;20\n", "has no column of load cases"),
        ("Case;T1 (kN);T2 (kN);Te (kN)\nfull;50;20;47\nempty;30;20;10\n",
         'full: drive: T1 - T2 is not Te, got "47 kN"'),
        ("Case;T1 (kN);T2 (kN)\nfull;50;20\nfull;30;20\n",
         "full: drive: entry_tension: is there twice"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_told(text: str, sentence: str, tmp_path: Path) -> None:
    assert sentence.replace('got "47 kN"', "got 47 kN") in refusal(tmp_path, text)


def test_the_command_writes_a_drive_file_that_is_solved(tmp_path: Path) -> None:
    table, drive, made = tmp_path / "table.csv", drive_file(tmp_path), tmp_path / "made.toml"
    table.write_text(PLAIN, "utf-8")
    ran = wraparc("import", table, "--drive", drive, "-o", made)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == f"Wrote {made}: 2 load cases of head.\n"
    cases = {case.name: case for case in load_drive(made).load_cases}
    assert list(cases) == ["full running", "full start"]
    assert cases["full start"].kind == "starting"
    assert cases["full start"].tensions["head"].entry == pytest.approx(60900 * LBF)
    assert wraparc("check", made).code in (0, 1)
    printed = wraparc("import", table)
    assert '[[load_case]]\nname = "full start"\nkind = "starting"\n' in printed.out


def test_a_workbook_is_read_as_its_text(tmp_path: Path) -> None:
    rows = (["Case", "T1 (kip)", "T2 (kip)"], ["full", 46.85, 17.2], ["stop", 25.6, 19.4])
    with xlsxwriter.Workbook(tmp_path / "table.xlsx") as book:
        sheet = book.add_worksheet()
        for place, row in enumerate(rows):
            sheet.write_row(place, 0, row)
    cases = read_print_out(tmp_path / "table.xlsx").cases
    assert [case.get("kind", "running") for case in cases] == ["running", "braking"]
    assert cases[0]["pulley"]["drive"] == pair("46.85 kip", "17.2 kip")


def test_a_drive_of_other_pulleys_or_of_resistances_is_refused(tmp_path: Path) -> None:
    table, drive = tmp_path / "table.csv", drive_file(tmp_path)
    table.write_text("Case;tail T1 (kN);tail T2 (kN)\nfull;50;20\nempty;30;20\n", "utf-8")
    out = ("-o", tmp_path / "made.toml")
    ran = wraparc("import", table, "--drive", drive, *out)
    assert ran.err == (
        f'Error: {drive}: pulley: no such pulley: "tail". Name the pulleys of the table "head".\n'
    )
    assert not (tmp_path / "made.toml").exists()
    conveyor = drive_file(tmp_path, f"{DRIVE}[conveyor]\nlength = '10 m'\n", "conveyor.toml")
    ran = wraparc("import", table, "--drive", conveyor, *out)
    assert "[conveyor] gives the load cases of this file already. Remove [conveyor]." in ran.err
    assert wraparc("import", table, *out).err == "Error: --drive: missing. Give both, or neither.\n"
    wrong = wraparc("import", table, "--kind", "none=starting").err
    assert '--kind none=starting: no such load case. Write one of "full", "empty".' in wrong
