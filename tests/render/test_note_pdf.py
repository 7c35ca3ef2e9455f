"""The note as PDF: kept for long, readable aloud, safe against what users type."""

import json
import re
import subprocess
import sys
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest
import typst
from matplotlib import image

from answer.drives import drive, marched, solved, sticking
from render.cases import EXAMPLES, train
from render.reading import (
    RARE,
    media_box,
    metadata,
    objects,
    pages,
    structure,
    without_system_fonts,
)
from wraparc import DriveResult, InputError, load_drive, solve
from wraparc.render import NoteHead, pdf
from wraparc.render.equations import equations
from wraparc.render.note import make_note
from wraparc.render.note_pdf import note_pages
from wraparc.units import in_units

pytestmark = pytest.mark.usefixtures("solved_once")

HEAD = NoteHead(
    project="Overland", number="CN-1", revision="B", author="A. Smith", date="2026-11-21",
    file="drive.toml",
)  # fmt: skip
BOTH = [solved(), marched()]


@pytest.fixture(scope="module")
def note() -> bytes:
    return pdf(BOTH, HEAD)


def test_it_says_that_it_is_pdf_a_and_accessible(note: bytes) -> None:
    """Marks of ISO 19005-2, level A, and ISO 14289-1 in the XMP packet."""
    told = metadata(note)
    assert "<pdfaid:part>2</pdfaid:part>" in told
    assert "<pdfaid:conformance>A</pdfaid:conformance>" in told
    assert "<pdfuaid:part>1</pdfuaid:part>" in told
    assert "<rdf:li>A. Smith</rdf:li>" in told
    assert "Test drive" in told
    raw = objects(note)
    assert b"/MarkInfo" in raw
    assert b"/Marked true" in raw
    assert b"/Lang(en" in raw


def test_every_picture_and_equation_is_told_in_words(note: bytes) -> None:
    figures, formulas = structure(note, "Figure"), structure(note, "Formula")
    assert len(figures) == 4  # the reserve, pulley, budget, profiles
    typeset = equations(solved().arcs, paper=True, train=False, design=True)
    assert len(formulas) == len(typeset) >= 9
    assert all(b"/Alt" in element for element in (*figures, *formulas))
    assert any(b"Pulley head, driving" in element for element in figures)


def test_it_has_two_to_five_pages(note: bytes) -> None:
    """Four of answers, wear and sources; the box to sign may need a fifth."""
    assert 2 <= pages(note) <= 5
    three = load_drive(EXAMPLES / "head-drive-fabric.toml")
    assert pages(pdf([solve(three, raise_on_failure=False)])) <= 5


def test_the_same_note_gives_the_same_bytes(note: bytes) -> None:
    assert pdf(BOTH, HEAD) == note
    assert pdf(BOTH, replace(HEAD, date="2026-11-21T10:00:00.5+02:00")) != note


def test_the_paper_is_the_one_asked_for(note: bytes) -> None:
    assert media_box(note) == pytest.approx([0, 0, 595.28, 841.89], abs=0.01)
    letter = pdf(BOTH, replace(HEAD, paper="us-letter"), system="us")
    assert media_box(letter) == pytest.approx([0, 0, 612, 792])
    # letter is 18 mm shorter than A4: the last sources and the box to sign go over to a fifth page
    assert 2 <= pages(letter) <= 5


HOSTILE = [
    '#panic("no") $x^2$ *bold* _it_ `raw` @ref <label> #import "@preview/x:1.0.0": *',
    '") #panic() #(" <script>alert(1)</script> & "quotes" \'too\' #read("/etc/passwd") \\ // /* [',
]


@pytest.mark.parametrize(("text", "date"), [(HOSTILE[0], "21 November 2026"), (HOSTILE[1], "")])
def test_what_users_type_is_text_and_never_markup(text: str, date: str) -> None:
    """Each of these would stop the typesetter or change the page if it were taken for markup.

    Names of pulleys and cases reach the pictures as well, as SVG.
    """
    named, base = '</text><script>#panic()"&', drive()
    tensions = {named: next(iter(base.load_cases[0].tensions.values()))}
    hostile = replace(
        base, title=text, description=text, belt=replace(base.belt, name=text[:60]),
        pulleys=(replace(base.pulleys[0], name=named),),
        load_cases=(replace(base.load_cases[0], name=named, tensions=tensions),),
    )  # fmt: skip
    head = NoteHead(
        title=text, project=text, number=text, revision=text, author=text, file=text, date=date
    )
    data = pdf([solve(hostile, raise_on_failure=False)], head)
    escaped = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    quoted = escaped.replace('"', "&quot;").replace("'", "&apos;")
    assert any(form in metadata(data) for form in (escaped, quoted, quoted.replace("&apos;", "'")))


@pytest.mark.parametrize(
    ("field", "value"),
    [("title", "x" * 121), ("author", "two\nlines"), ("project", "bell\x07"), ("date", "\u202e")],
)
def test_a_text_that_cannot_be_printed_is_refused(field: str, value: str) -> None:
    with pytest.raises(InputError, match="printable text of at most 120 characters") as caught:
        NoteHead(**{field: value})  # type: ignore[arg-type]
    assert caught.value.problems[0].key == field


#: "Head drive" in scripts that the typesetter's own fonts lack or have, and one of no font at all.
SCRIPTS = {
    "Chinese": "头部驱动", "Japanese": "ヘッド駆動", "Korean": "헤드 드라이브", "Thai": "หัวขับ",
    "Arabic": "محرك الرأس", "Hebrew": "הנעת ראש", "Devanagari": "हेड ड्राइव", "none": f"drive {RARE}",
}  # fmt: skip


@pytest.mark.parametrize("script", SCRIPTS)
def test_there_is_a_pdf_in_every_script_with_and_without_its_font(
    monkeypatch: pytest.MonkeyPatch, script: str
) -> None:
    text = SCRIPTS[script]
    named, base = text, drive()
    tensions = {named: next(iter(base.load_cases[0].tensions.values()))}
    of_script = replace(
        base, pulleys=(replace(base.pulleys[0], name=named),),
        load_cases=(replace(base.load_cases[0], name=named, tensions=tensions),),
    )  # fmt: skip
    results = [solve(of_script)]
    for alone in (False, True):
        if alone:
            without_system_fonts(monkeypatch)
        data = pdf(results, NoteHead(title=text, author=text, date="2026-11-21"))
        assert data.startswith(b"%PDF")
        assert text in metadata(data)  # as it was typed, without codes


def test_letters_that_no_font_has_are_boxes_and_a_line(monkeypatch: pytest.MonkeyPatch) -> None:
    # what the typesetter is handed last; it refuses a page with a letter that it cannot show
    without_system_fonts(monkeypatch)
    given: list[Any] = []
    compile_files = typst.compile

    def seen(parts: Any, **settings: Any) -> Any:
        given.append(json.loads(parts["data.json"]))
        return compile_files(parts, **settings)

    monkeypatch.setattr(typst, "compile", seen)
    pdf(BOTH, NoteHead(title="Ä δ 头部 หัว", date="2026-11-21"))
    assert given[0]["letters"] == ""
    codes = "".join(f"\ue000{ord(c):04X}\ue001" for c in "头部")
    marks = "".join(f"\ue000{ord(c):04X}\ue001" for c in "หัว")
    assert given[-1]["title"] == f"Ä δ {codes} {marks}"
    assert given[-1]["letters"].startswith("No installed font has these letters, shown as boxes")
    assert "U+0E27, U+0E2B, U+0E31, U+5934, U+90E8." in given[-1]["letters"]
    assert given[-1]["file"]["title"] == "Ä δ 头部 หัว"


def test_a_breakaway_is_reported_as_such() -> None:
    broken = solve(drive(180e3, 1e3), raise_on_failure=False)
    assert not broken.solved
    note = make_note([broken], NoteHead())
    assert note.told.level == "FAILS"
    sentence = in_units(note.told.text)
    assert re.fullmatch(r"Gross slip: safety 0\.\d+ is below 1 \(head, full\)\.", sentence)
    assert note.sections[0].sentences[0] == "4 of 7 checks pass."
    assert pages(pdf([broken])) <= 4


def test_several_pulleys_have_a_picture_each() -> None:
    whole, results = train("triple-steel-cord")
    data = pdf(results, HEAD, train=whole)
    names = [pulley.name for pulley in results[0].drive.pulleys]
    figures = structure(data, "Figure")
    assert len(figures) == len(names) + 3  # the reserve, budget, profiles
    for pulley in names:
        told = f"Pulley {pulley}, ".encode()
        assert sum(told in element for element in figures) == 1
    assert all(b"/Alt" in element for element in structure(data, "Formula"))


def test_a_belt_at_rest_and_a_range_left_are_drawn_and_warned_of() -> None:
    note = make_note([sticking()], NoteHead())
    warnings = next(s for s in note.sections if s.title == "Warnings").sentences
    assert any("outside the tested range" in sentence for sentence in warnings)
    assert pdf([sticking()]).startswith(b"%PDF-")


def test_sections_come_in_the_order_of_a_note() -> None:
    titles = [section.title for section in make_note(BOTH, HEAD).sections]
    assert titles == [
        "Checks against limits", "Results by load case",
        "Governing arc: pulley head, load case full",
        "Governing arc in detail: pulley head, load case full", "Inputs and where they came from",
        "Assumptions", "Equations", "Warnings", "Sources",
    ]  # fmt: skip


def test_illustrative_data_is_warned_of() -> None:
    note = make_note(BOTH, HEAD)
    warnings = next(s for s in note.sections if s.title == "Warnings").sentences
    told = "The friction of diamond-rubber is illustrative: it describes no real product."
    assert any(told in sentence for sentence in warnings)


def test_it_imports_no_more_than_it_needs() -> None:
    script = (
        "import sys; sys.path.insert(0, 'tests'); from answer.drives import solved\n"
        "from wraparc.render import pdf, workbook, markdown\n"
        "workbook([solved()]); markdown([solved()])\n"
        "assert 'matplotlib' not in sys.modules\n"
        "pdf([solved()])\n"
        "assert not {'scipy', 'pandas'} & set(sys.modules)"
    )
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", script], cwd=root, capture_output=True, check=False
    )
    assert done.returncode == 0, done.stderr.decode()


def test_results_of_one_method_alone_make_a_note() -> None:
    alone: list[DriveResult] = [solved()]
    text = "".join(t for s in make_note(alone, HEAD).sections for t in s.sentences)
    assert "march" not in text


def test_pages_can_be_looked_at(note: bytes) -> None:
    """As many as the PDF has, A4 at 72 points to the inch, something printed on each."""
    pictures = note_pages(make_note(BOTH, HEAD), ppi=72.0)
    assert len(pictures) == pages(note)
    for picture in pictures:
        assert picture.startswith(b"\x89PNG")
        assert int.from_bytes(picture[16:20], "big") == pytest.approx(595, abs=1)
        assert int.from_bytes(picture[20:24], "big") == pytest.approx(842, abs=1)
        assert len(picture) > 5000


def test_a_long_title_stays_on_the_paper(monkeypatch: pytest.MonkeyPatch) -> None:
    # as long as a drive file may have it, without a blank: the margins of 18 mm stay white
    images: list[bytes] = []
    compile_files: Any = typst.compile

    def drawn(parts: object, **_: Any) -> bytes:
        images.extend(compile_files(parts, format="png", ppi=50.8))  # 2 pixels a millimetre
        return b""

    monkeypatch.setattr(typst, "compile", drawn)
    for title in ("W" * 200, "W" * 20):
        long = replace(drive(), title=title)
        images.clear()
        pdf([replace(found, drive=long) for found in BOTH], HEAD)
        first = image.imread(BytesIO(images[0]))
        assert first.shape[1] == 420
        margin = first[:, -34:]
        assert margin.min() == 1.0
