"""Equations drawn when the pages are built, by KaTeX: pages need neither a network nor a script."""

import json
import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.math import get_node_equation_number

HERE = Path(__file__).parent
KATEX = HERE.parents[1] / "node_modules" / "katex" / "dist"


@cache
def _drawer() -> "subprocess.Popen[str]":
    pipe = subprocess.PIPE
    command = ["node", str(HERE / "equations.mjs")]
    return subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True, encoding="utf-8")


@cache
def drawn(latex: str, display: bool = False) -> str:
    """Return an equation as HTML, with MathML in it for screen readers.

    Raises
    ------
    ExtensionError
        If KaTeX does not understand it.
    """
    drawer = _drawer()
    assert drawer.stdin is not None
    assert drawer.stdout is not None
    drawer.stdin.write(json.dumps({"latex": latex, "display": display}) + "\n")
    drawer.stdin.flush()
    answer = json.loads(drawer.stdout.readline() or '{"fault": "node has ended"}')
    if "fault" in answer:
        raise ExtensionError(f"equation {latex!r}: {answer['fault']}")
    return str(answer["html"])


def _inline(writer: Any, node: nodes.math) -> None:
    writer.body.append(drawn(node.astext()))
    raise nodes.SkipNode


def _block(writer: Any, node: nodes.math_block) -> None:
    number = get_node_equation_number(writer, node) if node.get("number") else ""
    writer.body.append(writer.starttag(node, "div", CLASS="math notranslate"))
    writer.body.append(f'<span class="eqno">({number})</span>' if number else "")
    writer.body.append(drawn(node.astext(), display=True) + "</div>\n")
    raise nodes.SkipNode


def _finish(app: Sphinx, error: Exception | None) -> None:
    if _drawer.cache_info().currsize:
        _drawer().communicate()
        _drawer.cache_clear()
    if error is None and app.builder.format == "html":
        into = Path(app.outdir) / "_static" / "katex"
        (into / "fonts").mkdir(parents=True, exist_ok=True)
        shutil.copy(KATEX / "katex.min.css", into)
        for font in (KATEX / "fonts").glob("*.woff2"):
            shutil.copy(font, into / "fonts")


def setup(app: Sphinx) -> dict[str, Any]:
    """Add the drawing of equations to Sphinx."""
    app.add_html_math_renderer("katex", (_inline, None), (_block, None))
    app.add_css_file("katex/katex.min.css")
    app.connect("build-finished", _finish)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
