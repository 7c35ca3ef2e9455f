"""Drive files that the page of one file changes: read alike by Python, comments kept."""

import json
import random
import subprocess
from copy import deepcopy
from pathlib import Path
from typing import Any

from wraparc.schema.source import parse
from wraparc.web.answers.documents import json_like

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.toml"))
Data = dict[str, Any]
VALUES = ["12 kN", 'a "quoted" \\ name', "größer", 3, 0.25, True, "# no comment", "a\nb"]


def rewritten(cases: list[Data]) -> list[Data]:
    done = subprocess.run(
        ["node", str(Path(__file__).with_name("own_texts.mjs"))], input=json.dumps(cases),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: list[Data] = json.loads(done.stdout)
    return found


def tables(value: Any) -> list[Data]:
    """Return every table within a document, itself first."""
    if isinstance(value, list):
        return [table for item in value for table in tables(item)]
    if not isinstance(value, dict):
        return []
    return [value, *(table for item in value.values() for table in tables(item))]


def changed(document: Data, pick: random.Random) -> Data:
    """Return a document with some values changed, added or taken away."""
    after = deepcopy(document)
    for _ in range(pick.choice([1, 2, 4])):
        table = pick.choice(tables(after))
        plain = [k for k, v in table.items() if not isinstance(v, dict | list)]
        what = pick.random()
        if what < 0.6 and plain:
            table[pick.choice(plain)] = pick.choice(VALUES)
        elif what < 0.8:
            table[pick.choice(["new", "new key", "other"])] = pick.choice(VALUES)
        elif plain:
            del table[pick.choice(plain)]
    return after


def test_what_is_saved_reads_as_the_document() -> None:
    # expected: the document, by Python's own reader; in place wherever that can be
    pick = random.Random(5)  # noqa: S311 - documents to try, no secrets
    cases: list[Data] = []
    for path in EXAMPLES:
        text = path.read_text("utf-8")
        document = json_like(parse(text))
        cases += [{"text": text, "after": changed(document, pick)} for _ in range(12)]
        cases.append({"text": text, "after": document})
    kept = 0
    for case, found in zip(cases, rewritten(cases), strict=True):
        assert parse(found["anew"]) == {"format": 1, **case["after"]}
        if found["kept"] is None:
            continue
        kept += 1
        assert parse(found["kept"]) == case["after"]
        before = json_like(parse(case["text"]))
        if has_all(case["after"], before):
            assert comments(case["text"]) <= comments(found["kept"])
        if before == case["after"]:
            assert found["kept"] == case["text"]
    assert kept > 0.9 * len(cases)


def comments(text: str) -> set[str]:
    """Return the comments that stand alone or behind a value."""
    return {line.rpartition(" # ")[2] for line in text.splitlines() if " # " in f" {line}"}


def has_all(after: Any, before: Any) -> bool:
    """Whether no key was taken away."""
    if isinstance(before, list):
        return all(map(has_all, after, before)) if isinstance(after, list) else True
    if not isinstance(before, dict):
        return True
    return before.keys() <= after.keys() and all(has_all(after[k], before[k]) for k in before)
