"""Drives made from the examples that fail, and what pressing the button of the verdict leads to."""

import random
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from playwright.sync_api import Page

from web.browser import Visitor
from web.test_standing import take
from wraparc.errors import InputError
from wraparc.schema.source import Document
from wraparc.units import Dimension, parse_quantity
from wraparc.web.answers.documents import json_like
from wraparc.web.answers.drives import solve_all
from wraparc.web.asked import SolveRequest
from wraparc.web.opening import opened

EXAMPLES = Path(__file__).parents[2] / "examples"
NAMES = ("head-drive-fabric", "steel-cord-drive", "uphill-conveyor", "downhill-braking",
         "test-pulley-calibrated", "tandem-fabric")  # fmt: skip
LAGGINGS = ("diamond-rubber", "medium-ceramic", "full-ceramic")
#: What an action says where nothing that is tried betters the verdict.
NONE_PASSES = re.compile(r"^No T2, wrap|passes: Te is|^No (T2|wrap|change)")
#: What an action says where a limit is the end of tests, or a key is missing.
DATA_MISSING = re.compile(r"^(Test|Give|Check|Repeat|Solve|Set) ")
MOST_PRESSES = 2


def scaled(table: dict[str, Any], key: str, dimension: Dimension, by: float) -> None:
    """Multiply a number of a document, if it is there [SI]."""
    if isinstance(table.get(key), str):
        unit = {"force": "N", "angle": "rad"}.get(dimension, "m")
        table[key] = f"{parse_quantity(table[key], dimension) * by:.6g} {unit}"


def drawn(seed: int) -> Document:
    """Return an example with other tensions, wrap, lagging, width and load cases."""
    draw = random.Random(seed)  # noqa: S311 - no secret
    document: dict[str, Any] = json_like(opened(str(EXAMPLES / f"{draw.choice(NAMES)}.toml")))
    up = draw.uniform(0.8, 1.4)
    for pulley in document["pulley"]:
        scaled(pulley, "entry_tension", "force", up)
        scaled(pulley, "effective_tension", "force", up)
        scaled(pulley, "exit_tension", "force", draw.uniform(0.5, 1.3))
        scaled(pulley, "wrap_angle", "angle", draw.uniform(0.85, 1.15))
        if draw.random() < 0.5:
            pulley["lagging"] = draw.choice(LAGGINGS)
            pulley.pop("condition", None)
    scaled(document["belt"], "width", "length", draw.uniform(0.75, 1.2))
    cases = document.get("load_case", [])
    if cases and draw.random() < 0.4:
        cases.pop(draw.randrange(len(cases)))
    if draw.random() < 0.3:
        document["covered"] = not isinstance(document.get("condition"), list)
    return document


def failing(count: int, seed: int = 60) -> Iterator[tuple[int, Document]]:
    """Yield drives that the program solves and does not find in order, with their seeds."""
    found = 0
    while found < count:
        seed += 1
        document = drawn(seed)
        try:
            level = solve_all(SolveRequest(document=document, search=False)).verdict.level
        except InputError:
            continue  # no drive at all
        if level != "OK":
            found += 1
            yield seed, document


def pressed(visitor: Visitor, page: Page, document: Document) -> tuple[str, list[str], str]:
    """Return how pressing what is offered ends, what was pressed, and what is said at last."""
    take(page, document)
    visitor.solved()
    pressed: list[str] = []
    button = page.locator("#verdict .advice")
    while True:
        said = _text(page, "#verdict p")
        if said.startswith("OK"):
            return "OK", pressed, said
        lines = page.locator("#verdict .line").filter(has_text=re.compile("^Action"))
        action = " ".join(lines.first.inner_text().split()) if lines.count() else ""
        told = f"{said} {action}"
        if not button.count():
            return _end(action.removeprefix("Action ")), pressed, told
        if len(pressed) == MOST_PRESSES:
            return "more presses", pressed, told
        pressed.append(_text(page, "#verdict .advice"))
        button.click()
        visitor.solved()


def _text(page: Page, selector: str) -> str:
    return " ".join(page.locator(selector).first.inner_text().split())


def _end(action: str) -> str:
    """How it ends where nothing is offered: nothing passes, or data are missing."""
    if NONE_PASSES.search(action):
        return "none passes"
    return "data missing" if DATA_MISSING.search(action) else "no way"
