"""The calculator and the examples of a static site.

``python tools/site_pages.py FOLDER`` writes ``calculator/index.html`` and ``examples`` into the
folder that the documentation was built into. ``make site`` does both.
"""

from __future__ import annotations

import argparse
import html
import sys
from pathlib import Path

from wraparc.errors import InputError
from wraparc.saving import save_file
from wraparc.web.examples import Example, examples
from wraparc.web.page_file import first_example, page_file

_FRAME = """\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; base-uri 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Examples – wraparc</title>
</head>
<body>
<h1>Examples</h1>
<p>Drive files for the command line, and those of one pulley as pages that compute by themselves.
<a href="../index.html">Documentation</a>, <a href="../calculator/index.html">calculator</a>.</p>
<ul>
{rows}
</ul>
</body>
</html>
"""


def write(folder: Path) -> None:
    """Write the pages into a folder."""
    made = {"calculator/index.html": page_file(*first_example())}
    rows = []
    for example in examples():
        made[f"examples/{example.name}.toml"] = example.text
        page = _page(example)
        title = html.escape(str(example.document.get("title", example.name)))
        links = [f'<a href="{example.name}.toml">drive file</a>']
        if page:
            made[f"examples/{example.name}.html"] = page
            links.append(f'<a href="{example.name}.html">calculator</a>')
        rows.append(f"<li>{title}: {', '.join(links)}</li>")
    made["examples/index.html"] = _FRAME.format(rows="\n".join(rows))
    for name, text in made.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        save_file(str(file), text)


def _page(example: Example) -> str:
    """Return the page of an example; nothing where it needs the program itself."""
    try:
        return page_file(example.document, example.name, example.text)
    except InputError:
        return ""


def main() -> int:
    """Write the pages into the folder that is named."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("folder", type=Path)
    write(parser.parse_args().folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
