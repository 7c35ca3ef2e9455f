"""What the page does not use is not in it: classes of its style, names that its modules give."""

import re
from pathlib import Path

STATIC = Path("src/wraparc/web/static")
ONE_FILE = STATIC.parent / "one_file"
#: Made by `make kernel`, or of others.
MADE = {"built", "vendor", "kernel.js", "reader.js", "cells.js", "train_kernel.js"}
#: Given to what is not a module of the page: to a file of the tests, or to every page by its name.
GIVEN = {"OTHERS", "inPython"}


def sources() -> dict[Path, str]:
    """Return the modules of the page and of the page of one file that are written by hand."""
    files = [f for room in (STATIC, ONE_FILE) for f in sorted(room.rglob("*.js"))]
    return {f: f.read_text("utf-8") for f in files if not MADE & set(f.parts)}


def selectors(style: str) -> list[str]:
    bare = re.sub(r"/\*.*?\*/", "", style, flags=re.DOTALL)
    return [s.strip() for s in re.findall(r"([^{}]+)\{", bare) if not s.strip().startswith("@")]


def classes(selector: str) -> set[str]:
    return set(re.findall(r"\.([a-zA-Z][\w-]*)", re.sub(r'"[^"]*"', "", selector)))


def test_every_class_of_the_style_is_in_a_string_of_the_page() -> None:
    html = [f.read_text("utf-8") for f in (STATIC / "index.html", *ONE_FILE.glob("*.html"))]
    strings = re.findall(r'"[^"\n]*"|`[^`]*`', "\n".join([*sources().values(), *html]))
    words = set(re.findall(r"[a-zA-Z][\w-]*", " ".join(strings)))
    # what ends in a value: `t-${name}`, `hub-${part}`, `ramp-${k}`
    begun = tuple(re.findall(r"([a-zA-Z][\w-]*-)\$\{", "\n".join(sources().values())))
    dead = [
        f"{file.name}: {selector}"
        for file in sorted(STATIC.glob("style/*.css"))
        for selector in selectors(file.read_text("utf-8"))
        for name in sorted(classes(selector))
        if name not in words and not name.startswith(begun)
    ]
    assert dead == []


def test_every_svg_of_a_class_is_drawn() -> None:
    # a class may be a word of something else: what is said of a tag and a class needs both
    code = "\n".join(sources().values())
    drawn = set(re.findall(r'class: [^\n]*?["`]([\w -]+)', code))
    words = {word for names in drawn for word in names.split()}
    dead = [
        f"{file.name}: {selector}"
        for file in sorted(STATIC.glob("style/*.css"))
        for selector in selectors(file.read_text("utf-8"))
        for name in re.findall(r"\bsvg\.([\w-]+)", selector)
        if name not in words
    ]
    assert dead == []


def test_every_name_that_a_module_gives_is_taken() -> None:
    found = sources()
    made = [STATIC / name for name in ("kernel.js", "reader.js", "cells.js")]
    takers = {**found, **{f: f.read_text("utf-8") for f in made}}
    words = {f: set(re.findall(r"\w+", text)) for f, text in takers.items()}
    export = re.compile(r"^export (?:async )?(?:const|function\*?|class|let) (\w+)", re.MULTILINE)
    dead = [
        f"{file.relative_to(STATIC)}: {name}"
        for file, text in found.items()
        if file.is_relative_to(STATIC)
        for name in export.findall(text)
        if name not in GIVEN and not any(name in w for f, w in words.items() if f != file)
    ]
    assert dead == []
