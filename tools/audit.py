"""Known holes in the locked libraries: of Python by pip-audit, of the page's tools by npm audit.

``python tools/audit.py UV`` (``make audit``) asks the databases of advisories, which needs a
network. A library of which no database was asked, as without one, is reported as not checked: only
an answer about all of them, without a hole, ends with 0.
"""

import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PIP_AUDIT = "pip-audit@2.10.1"
MOST = 8
Run = Callable[[list[str]], str]


def run(command: list[str]) -> str:
    """Return what a command prints; it ends with more than 0 where it has found something."""
    found = subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, timeout=600, check=False
    )
    return found.stdout or found.stderr


def python_holes(uv: str, ask: Run = run) -> tuple[list[str], list[str]]:
    """Return the holes in the libraries of uv.lock, and which libraries were not checked."""
    with tempfile.TemporaryDirectory() as folder:
        file = str(Path(folder) / "requirements.txt")
        export = [uv, "export", "--quiet", "--frozen", "--no-emit-project", "--all-extras"]
        ask([*export, "--all-groups", "--output-file", file])
        audit = [uv, "tool", "run", "--quiet", PIP_AUDIT, "--disable-pip", "--require-hashes"]
        told = ask([*audit, "--progress-spinner", "off", "--format", "json", "-r", file])
    found = _json(told)
    if found is None:
        return [], [f"all of uv.lock ({_last(told)})"]
    holes, unchecked = list[str](), list[str]()
    for one in found["dependencies"]:
        if "skip_reason" in one:
            unchecked.append(one["name"])
        for hole in one.get("vulns", ()):
            fixed = ", ".join(hole["fix_versions"]) or "none yet"
            holes.append(f"{one['name']} {one['version']}: {hole['id']}, repaired in {fixed}")
    return holes, unchecked


def page_holes(ask: Run = run) -> tuple[list[str], list[str]]:
    """Return the holes in the tools of package-lock.json, and which were not checked."""
    told = ask(["npm", "audit", "--package-lock-only", "--json"])
    found = _json(told)
    if found is None or "vulnerabilities" not in found:
        reason = found.get("message") if found else None
        return [], [f"all of package-lock.json ({reason or _last(told)})"]
    holes = [f"{name}: {one['severity']}" for name, one in found["vulnerabilities"].items()]
    return holes, []


def _json(text: str) -> dict[str, Any] | None:
    try:
        found = json.loads(text)
    except ValueError:
        return None
    return found if isinstance(found, dict) else None


def _last(text: str) -> str:
    return next((line.strip() for line in reversed(text.splitlines()) if line.strip()), "no answer")


def main(uv: str, ask: Run = run) -> int:
    """Report holes, and what was not checked."""
    python, page = python_holes(uv, ask), page_holes(ask)
    holes, unchecked = python[0] + page[0], python[1] + page[1]
    for hole in holes:
        print(f"hole: {hole}")
    if unchecked:
        more = f" and {len(unchecked) - MOST} more" if len(unchecked) > MOST else ""
        listed = ", ".join(unchecked[:MOST])
        print(f"NOT CHECKED, no database of advisories answered: {listed}{more}")
    if not holes and not unchecked:
        print("no known hole in uv.lock and package-lock.json")
    return 1 if holes or unchecked else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
