"""The solver of the page: the plain functions of Python, translated.

``python tools/page_kernel.py`` writes `web/static/kernel.js` anew, and the page of one file that it
is bundled into; with ``--check`` it only says whether the file is what the source gives.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path
from types import FunctionType
from typing import cast

from javascript.translate import translate
from wraparc.arc import profile
from wraparc.arc.kernel import answer
from wraparc.checks import numbers
from wraparc.drive import compression
from wraparc.saving import save_file
from wraparc.web import in_page, pulls

ROOT = Path(__file__).parents[1]
FILE = ROOT / "src" / "wraparc" / "web" / "static" / "kernel.js"
BUNDLE = ROOT / "tools" / "page_bundle.mjs"
BIOME = ROOT / "node_modules" / ".bin" / "biome"
#: What the page calls; whatever these call comes along.
ENTRIES = (
    in_page.quick,
    in_page.judged,
    pulls.overridden,
    pulls.fault_of,
    in_page.described,
    in_page.unjudged,
    compression.block_modulus,
    numbers.held_alike,
    numbers.kept,
    numbers.margin_of,
    numbers.order_of,
    answer.answer,
    answer.profile_of,
    answer.profile_size,
    answer.find_capacities,
    profile.peak_stress,
    profile.active_length,
    profile.share_outside,
)
HEAD = """\
// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
"""


def module() -> str:
    """Return the module as it must stand in the file."""
    entries = cast("tuple[FunctionType, ...]", ENTRIES)
    return formatted(HEAD + translate(entries, package="wraparc"))


def formatted(text: str) -> str:
    """Return JavaScript as the formatter of the page lays it out."""
    command = [str(BIOME), "format", f"--stdin-file-path={FILE.relative_to(ROOT).as_posix()}"]
    done = subprocess.run(  # noqa: S603 - the project's own tool
        command, input=text, capture_output=True, text=True, encoding="utf-8", cwd=ROOT, check=False
    )
    if done.returncode:
        raise RuntimeError(done.stderr)
    return done.stdout


def main() -> int:
    """Write the file, or compare it."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--check", action="store_true", help="only say whether it is up to date")
    text = module()
    if not parser.parse_args().check:
        save_file(str(FILE), text)
        # the page of one file carries it
        return subprocess.run(["node", str(BUNDLE)], cwd=ROOT, check=False).returncode  # noqa: S603, S607
    same = FILE.is_file() and FILE.read_text("utf-8") == text
    if not same:
        sys.stderr.write(f"{FILE.relative_to(ROOT)} is not what its source gives: make kernel\n")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
