"""The solver of the page: the plain functions of Python, translated.

``python tools/page_kernel.py`` writes `web/static/kernel.js` anew, and the page of one file that it
is bundled into; with ``--check`` it only says whether the file is what the source gives.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from api_types import types_of_api
from javascript import whole
from javascript.translate import Module, translated
from wraparc import catalogue, errors
from wraparc.answer import (
    checks_table,
    drive_sheet,
    sources,
    train_sheet,
    train_words,
    wear_table,
    words,
)
from wraparc.answer import least_tension as leasts
from wraparc.answer.key_figures import KeyFigure, figure_of
from wraparc.answer.sheet import term
from wraparc.arc import Status, answer, capacity, grip, profile
from wraparc.catalogue.catalogue_belt import CatalogueBelt
from wraparc.checks import of_arc
from wraparc.checks.check import Level
from wraparc.checks.judge import _across, judge
from wraparc.checks.least_tension import (
    least_by_interval,
    least_tension,
    least_when_covered,
    least_when_wet,
    least_with_slip,
)
from wraparc.drive import compression, tension_rules
from wraparc.files import drive_file
from wraparc.friction import MeasuredTable
from wraparc.provenance import Provenance
from wraparc.saving import save_file
from wraparc.schema import limits, source, tables
from wraparc.train import (
    CaseResult,
    FluidCoupling,
    Induction,
    MemberResult,
    TrainResult,
    TrainStatus,
    VariableSpeed,
    turning,
)
from wraparc.train import file as train_file
from wraparc.train.system import System
from wraparc.units import Cell, digits, display, fixed, percent, quantity
from wraparc.units.cell import cell_text
from wraparc.units.display import unit_row
from wraparc.web import in_page, in_page_checks, in_page_train

ROOT = Path(__file__).parents[1]
FILE = ROOT / "src" / "wraparc" / "web" / "static" / "kernel.js"
TYPES_FILE = FILE.with_name("api.d.ts")
BUNDLE = ROOT / "tools" / "page_bundle.mjs"
BIOME = ROOT / "node_modules" / ".bin" / "biome"
#: What the page calls; whatever these call comes along.
ENTRIES: tuple[Callable[..., object], ...] = (
    in_page.quick,
    in_page.judged,
    tension_rules.overridden,
    tension_rules.fault_of,
    tension_rules.overdetermined,
    tension_rules.speed_missing,
    tension_rules.too_few,
    tension_rules.ends_of,
    tension_rules.pull_given,
    tension_rules.families,
    tension_rules.less_runs,
    tension_rules.behind_take_up,
    compression.block_modulus,
    answer.operating_point,
    capacity.find_capacities,
    profile.read,
    profile.records,
)
#: The same of the train page, which is in the file of one page alone.
TRAIN_FILE = FILE.parents[1] / "one_file" / "train_kernel.js"
TRAIN_ENTRIES: tuple[Callable[..., object], ...] = (
    in_page_train.fallen_of,
    in_page_train.total_of,
    in_page_train.parts_of,
    in_page_train.miss_of,
    in_page_train.trimmed,
    in_page_train.shared,
    in_page_train.least_of,
    in_page_train.member_of,
    in_page_train.turned,
    turning.driven,
    turning.surface_of_first,
    in_page_train.belt_of,
    in_page_train.system_of,
    in_page_train.divided,
    in_page_train.told,
    train_words.case_sentences,
    train_words.short_sentences,
    train_sheet.case_table,
    KeyFigure,
    CaseResult,
    MemberResult,
    System,
    VariableSpeed,
    Induction,
    FluidCoupling,
)
#: How numbers are shown.
CELLS_FILE = FILE.with_name("cells.js")
CELLS_ENTRIES: tuple[Callable[..., object], ...] = (
    display,
    digits.safe,
    cell_text,
    quantity,
    percent,
    fixed,
)
#: Functions of Python that are others there: those of `static/base/digits.js` by name.
OF_DIGITS: dict[Any, Any] = {
    unit_row: "unitRow",
    digits.read: "Number",
    digits.scientific: "scientific",
    digits.exponent_of: "exponentOf",
    digits.fixed: "decimal",
    digits.trimmed: "trimmed",
    digits.grouped: "grouped",
    Cell: "cellOf",
}
#: What reads documents in the page.
PYTHON = FILE.with_name("python.js")
READER_FILE = FILE.with_name("reader.js")
READER: dict[str, Any] = {
    "readDrive": drive_file.drive_from_document,
    "readTrain": train_file.train_from_document,
    "InputError": errors.InputError,
    "CatalogueBelt": CatalogueBelt,
    "Provenance": Provenance,
    "syntaxProblem": source.syntax_problem,
    "arcsOf": in_page_checks.arcs_of,
    "givenOf": in_page_checks.given_of,
    "criteriaOf": in_page_checks.criteria_of,
    "resultsOf": in_page_checks.results_of,
    "resultOf": in_page_checks.result_of,
    "trainDrive": in_page_checks.train_drive,
    "runningAt": in_page_checks.running_at,
    "TrainResult": TrainResult,
    "CaseResult": CaseResult,
    "MemberResult": MemberResult,
    "alone": in_page_checks.alone,
    "remarksOf": in_page_checks.remarks_of,
    "weakKinds": in_page_checks.weak_kinds,
    "idleIn": in_page_checks.idle_in,
    "judge": judge,
    "leastTension": least_tension,
    "leastSentence": leasts.least_sentence,
    "leastTable": leasts.least_table,
    "shownLeast": leasts.shown_least,
    "checkTable": checks_table.check_table,
    "short": words.short,
    "orderIn": words.order_in,
    "summaryTable": drive_sheet.summary_table,
    "arcTables": drive_sheet.arc_tables,
    "Sources": sources.Sources,
    "aloneOf": words.alone_of,
}
#: Functions of the page in the place of those that solve, and of those that form texts.
OF_CHECKS: dict[Any, Any] = {
    grip.sliding: in_page_checks.sliding,
    grip.lift: in_page_checks.lift,
    grip.wet: in_page_checks.wet,
    least_with_slip: in_page_checks.least_with_slip,
    least_when_covered: in_page_checks.least_when_covered,
    least_when_wet: in_page_checks.least_when_wet,
    least_by_interval: in_page_checks.least_by_interval,
    of_arc.largest_slip: in_page_checks.largest_slip,
    of_arc.slip_speed: in_page_checks.slip_speed,
    of_arc.creep_interval: in_page_checks.creep_interval,
    _across: in_page_checks.across,
    leasts.margins_table: in_page_checks.no_table,
    wear_table.wear_table: in_page_checks.no_table,
}
#: What the page reads of verdict, checks and least tension.
READ = {
    "text", "also", "label", "level", "listed", "data", "at", "within", "governing", "place",
    "kind_in_doubt", "share", "missed", "texts", "tension", "raise_to", "drive_result", "wet_text",
    "remarks", "full", "action_text", "name",
}  # fmt: skip
#: What `static/documents.js` has in the place of functions that look into files.
OF_FILES: dict[Any, str] = {
    catalogue.belts: "belts",
    catalogue.lagging_names: "laggingNames",
    catalogue.lagging_text: "laggingText",
    source.parse: "parsed",
    source.read_text: "readText",
    os.path.join: "readText",
    drive_file.overridden: "overridden",
    limits.is_number: "isNumber",
    errors.shown: "$shown",
    term: "term",
    figure_of: "figureOf",
}
#: Methods of what is read that nothing asks for there, or that ask for arrays.
UNREAD = ("written", "schema", "rows", (MeasuredTable, "compact"))
#: Words for forms and documents.
UNASKED = ((tables.Entry, "meaning"), (tables.Entry, "title"), (tables.Table, "title"))
HEAD = """\
// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
"""


def _kernel() -> Module:
    return translated(ENTRIES, "wraparc")


def module() -> str:
    """Return the module as it must stand in the file."""
    return formatted(HEAD + _kernel().text())


def train_module() -> str:
    """Return the module of the train page as it must stand in its file."""
    kernel = _kernel()
    kernel.text()
    natives = (display, fixed, percent, quantity, term, figure_of)
    instead: dict[Any, Any] = {of: of.__name__ for of in natives}
    found = translated(TRAIN_ENTRIES, "wraparc", instead, kernel.exports)
    text = found.text()
    taken = f'import {{ {", ".join(sorted(found.taken))} }} from "../static/{FILE.name}";\n'
    native = f'import {{ {", ".join(sorted(found.natives))} }} from "./told.js";\n'
    return formatted(HEAD + taken + native + text)


def cells_module() -> str:
    """Return the module that shows numbers as it must stand in its file."""
    found = translated(CELLS_ENTRIES, "wraparc", OF_DIGITS)
    text = found.text()
    native = sorted(found.natives - {"Number"})
    return formatted(f'{HEAD}import {{ {", ".join(native)} }} from "./base/digits.js";\n{text}')


def reader_module() -> str:
    """Return the module that reads and judges documents as it must stand in its file."""
    kernel = _kernel()
    kernel.text()
    cells = {f"cell__{of.__name__}": of for of in (quantity, percent, fixed)}
    module = whole.Module(
        "wraparc",
        {**OF_FILES, **OF_CHECKS, Cell: "cellOf"},
        frozen=[catalogue.design_friction, catalogue.lagging_costs],
        without=UNREAD,
        unasked=UNASKED,
        elsewhere={**kernel.exports, **cells},
        enums=(Level, Status, TrainStatus),
    )
    module.reached |= READ
    for name, value in READER.items():
        module.export(name, value)
    text = module.text()
    known = set(re.findall(r"^export (?:const|class|function) (\$\w+)", PYTHON.read_text(), re.M))
    parts = {
        FILE.name: module.taken - cells.keys(),
        CELLS_FILE.name: module.taken & cells.keys(),
        "base/digits.js": module.natives & {"cellOf"},
        "documents.js": module.natives - known - {"cellOf"},
        PYTHON.name: known & set(re.findall(r"\$\w+", text)),
    }
    head = "".join(
        f'import {{ {", ".join(sorted(names))} }} from "./{file}";\n'
        for file, names in parts.items()
    )
    return HEAD + head + text


def formatted(text: str, file: Path = FILE) -> str:
    """Return JavaScript as the formatter of the page lays it out."""
    command = [str(BIOME), "format", f"--stdin-file-path={file.relative_to(ROOT).as_posix()}"]
    done = subprocess.run(
        command, input=text, capture_output=True, text=True, encoding="utf-8", cwd=ROOT, check=False
    )
    if done.returncode:
        raise RuntimeError(done.stderr)
    return done.stdout


def types_module() -> str:
    """Return the types of what the page asks and is answered."""
    return formatted(types_of_api(), TYPES_FILE)


#: Every file that is made, and what makes its text.
MADE: dict[Path, Callable[[], str]] = {
    FILE: module,
    TRAIN_FILE: train_module,
    READER_FILE: reader_module,
    CELLS_FILE: cells_module,
    TYPES_FILE: types_module,
}


def main() -> int:
    """Write the files, or compare them."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--check", action="store_true", help="only say whether it is up to date")
    texts = {file: make() for file, make in MADE.items()}
    if not parser.parse_args().check:
        for file, text in texts.items():
            save_file(str(file), text)
        # the page of one file carries it
        return subprocess.run(["node", str(BUNDLE)], cwd=ROOT, check=False).returncode
    stale = [f for f, text in texts.items() if not f.is_file() or f.read_text("utf-8") != text]
    for file in stale:
        sys.stderr.write(f"{file.relative_to(ROOT)} is not what its source gives: make kernel\n")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
