"""What `make audit` says of answers, of none, and of libraries that no database knows."""

import json
import re
from pathlib import Path

import pytest

import audit

ROOT = Path(__file__).parents[1]
HOLE = {"id": "CVE-2026-1", "fix_versions": ["2.0"]}
CLEAN = {"dependencies": [{"name": "numpy", "version": "2.4", "vulns": []}]}
HOLED = {"dependencies": [{"name": "a", "version": "1.0", "vulns": [HOLE]}]}
SKIPPED = {"dependencies": [{"name": "numpy", "skip_reason": "not on PyPI"}]}
PAGE: dict[str, object] = {"vulnerabilities": {}}


@pytest.mark.parametrize(
    ("python", "page", "code", "told"),
    [
        (CLEAN, PAGE, 0, "no known hole in uv.lock and package-lock.json"),
        (HOLED, PAGE, 1, "hole: a 1.0: CVE-2026-1, repaired in 2.0"),
        (SKIPPED, PAGE, 1, "NOT CHECKED, no database of advisories answered: numpy"),
        (CLEAN, {"vulnerabilities": {"b": {"severity": "high"}}}, 1, "hole: b: high"),
        (CLEAN, {"message": "405 Method Not Allowed"}, 1, "package-lock.json (405 Method"),
        ("Failed to resolve", PAGE, 1, "all of uv.lock (Failed to resolve)"),
        ("", PAGE, 1, "all of uv.lock (no answer)"),
    ],
)
def test_only_an_answer_about_all_is_good(
    capsys: pytest.CaptureFixture[str], python: object, page: object, code: int, told: str
) -> None:
    def ask(command: list[str]) -> str:
        found = page if command[0] == "npm" else python
        return found if isinstance(found, str) else json.dumps(found)

    assert audit.main("uv", ask) == code
    assert told in capsys.readouterr().out


def test_the_container_has_the_locked_libraries_by_the_uv_of_the_makefile() -> None:
    container = (ROOT / "Containerfile").read_text("utf-8")
    (version,) = re.findall(r"uv==([\d.]+)", container)
    assert f"UV_VERSION := {version}\n" in (ROOT / "Makefile").read_text("utf-8")
    assert "--frozen" in container
    assert "!uv.lock" in (ROOT / ".dockerignore").read_text("utf-8").splitlines()
    assert re.findall(r"^FROM (\S+)", container, re.MULTILINE) == ["${BASE}", "${BASE}"]
