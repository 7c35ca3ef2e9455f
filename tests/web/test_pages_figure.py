"""Curves clicked on the picture of a figure. Expected values: the law that was drawn."""

import base64
import io
import json
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image
from playwright.sync_api import Page, expect

from web.browser import PHONE, Calculator, Visitor
from web.test_pages_looks import violations
from wraparc.files import load_lagging
from wraparc.files.write import lagging_text
from wraparc.friction import ab_from_peak
from wraparc.shear_test import fit_plan
from wraparc.shear_test.plan_file import load_plan

PRESSURES = np.array([34.0, 138.0, 690.0])  # kPa
ENDS = np.array([12.0, 1.4])  # slip [mm] and friction at the ends of the axes
USE = "Apply to drive"
SOURCE = "A. Author, A paper, 2020"


#: Keeps the bodies of all that is sent, files within them too.
LISTEN = """() => {
  window.bodies = [];
  const usual = window.fetch;
  window.fetch = (url, how) => {
    if ((how?.method ?? "GET") !== "GET") bodies.push(new Response(how.body).text());
    return usual(url, how);
  };
}"""


def drawn(x: Any, p: Any) -> Any:
    """Friction of the law at a slip [mm]."""
    r = np.minimum(x / (9.0 * (p / 34.0) ** 0.15), 1.0)
    return 1.25 * (p / 34.0) ** -0.3 * np.where(r > 0.0, r * (1.0 - np.log(np.maximum(r, 1e-9))), 0)


class Drawn:
    """A picture of the law, and where in it values are [pixels].

    Parameters
    ----------
    log
        Whether its x axis is logarithmic, from 0.1 to 12 mm.
    turned
        By which the scan is turned [degrees], and leans.
    """

    def __init__(self, *, log: bool = False, turned: float = 0.0) -> None:
        figure = Figure(figsize=(6.0, 4.0), dpi=150, layout="tight")
        FigureCanvasAgg(figure)
        axes = figure.add_subplot()
        x = np.linspace(0.1 if log else 0.0, ENDS[0], 400)
        for p in PRESSURES:
            axes.plot(x, drawn(x, p), label=f"{p:g} kPa")
        axes.set(xlim=(x[0], ENDS[0]), ylim=(0.0, ENDS[1]), xscale="log" if log else "linear")
        drawing = io.BytesIO()
        figure.savefig(drawing, format="png")
        image = Image.open(drawing).convert("RGB")
        self.height, self.axes = image.height, axes
        slope = np.tan(np.radians(turned))
        # x' = x + s y, y' = y + 2 s x: a scan that is turned and leans
        self.way = np.array([[1.0, slope], [2.0 * slope, 1.0]])
        if turned:
            back = np.linalg.inv(self.way)
            wide, tall = (int(v) for v in self.way @ image.size)
            rows = (*back[0], 0.0, *back[1], 0.0)
            image = image.transform((wide, tall), Image.Transform.AFFINE, rows, fillcolor="white")
        picture = io.BytesIO()
        image.save(picture, "png")
        self.png = picture.getvalue()

    def place(self, x: float, y: float) -> tuple[float, float]:
        """Where a value is, to the pixel."""
        across, up = self.axes.transData.transform((x, y))
        at = np.round(self.way @ np.array([across, self.height - up]))
        return float(at[0]), float(at[1])


@pytest.fixture
def page(visitor: Visitor) -> Page:
    page = visitor.open("tests")
    page.get_by_text("A published figure", exact=True).click()
    return page


def picture(page: Page, of: bytes, name: str = "fig3.png", kind: str = "image/png") -> None:
    page.set_input_files("#figure-file", {"name": name, "mimeType": kind, "buffer": of})


def click(page: Page, at: tuple[float, float]) -> None:
    """Click at a place of the picture [pixels of it]."""
    where = page.evaluate(
        """([x, y]) => {
          const svg = document.querySelector(".figure-view > svg");
          const view = svg.parentElement;
          const m = () => new DOMPoint(x, y).matrixTransform(svg.getScreenCTM());
          view.scrollIntoView({ block: "center" });
          const [p, v] = [m(), view.getBoundingClientRect()];
          view.scrollBy(p.x - v.left - v.width / 2, p.y - v.top - v.height / 2);
          const q = m();
          return [q.x, q.y];
        }""",
        list(at),
    )
    page.mouse.click(*where)


def axes(page: Page, of: Drawn, first: float = 0.0) -> None:
    """Click and type the four points of the axes: their ends."""
    page.wait_for_selector(".figure-view image")
    x, y = ENDS
    for at in ((first, 0.0), (x, 0.0), (first, 0.0), (first, y)):
        click(page, of.place(*at))
    for k, value in enumerate((first, x, 0.0, y)):
        page.fill(f"#figure-m{k}", f"{value:g}")


def curve(page: Page, of: Drawn, k: int, pressure: float, first: float = 0.15) -> None:
    """Click 14 points along a curve, and name it."""
    if k:
        page.get_by_role("button", name="Add a curve").click()
    for x in np.geomspace(first, 11.8, 14):
        click(page, of.place(x, float(drawn(x, pressure))))
    page.fill(f"#figure-c{k}", f"{pressure:g}")


def say(page: Page) -> None:
    """Say of the figure what it does not show."""
    page.fill("#t-digitised-source", SOURCE)
    page.select_option("#t-digitised-slip_unit", "mm")
    page.select_option("#t-fit-remove_shear", "false")


def fit(page: Page) -> None:
    page.get_by_role("button", name="Fit the lagging").click()


def saved(page: Page, button: str, to: Path) -> Path:
    with page.expect_download() as arriving:
        page.get_by_role("button", name=button).click()
    file = to / arriving.value.suggested_filename
    arriving.value.save_as(file)
    return file


@pytest.mark.parametrize(("log", "turned"), [(True, 0.0), (False, 3.0)])
def test_clicked_points_give_the_friction_back_and_the_command_the_same_law(
    page: Page, tmp_path: Path, log: bool, turned: float
) -> None:
    of = Drawn(log=log, turned=turned)
    page.evaluate(LISTEN)
    sent: list[str] = []
    page.on("request", lambda r: sent.append(r.method))
    picture(page, of.png)
    axes(page, of, 0.1 if log else 0.0)
    if log:
        page.get_by_role("checkbox", name="x axis is logarithmic").check()
    crossing = page.get_by_text("The axes cross at")
    expect(crossing).to_have_count(1 if turned else 0)
    for k, p in enumerate(PRESSURES):
        curve(page, of, k, p)
    say(page)
    fit(page)
    page.get_by_role("button", name=USE).wait_for()
    expect(page.locator("#fitted")).to_contain_text(f"digitised from {SOURCE}")
    lagging = load_lagging(saved(page, "Download the lagging file", tmp_path))
    for p in PRESSURES:
        for x in (0.5, 2.0, 8.0):
            found = float(lagging.law.friction(x * 1e-3, p * 1e3))
            assert found == pytest.approx(float(drawn(x, p)), rel=0.02)
    # the picture stayed in the browser
    bodies = page.evaluate("Promise.all(bodies)")
    assert len(bodies) == len([method for method in sent if method != "GET"])
    assert any("datasetColl" in body for body in bodies)
    assert not any("PNG" in body or "fig3.png" in body for body in bodies)
    # the points as saved, with the plan as saved, are the same law for the command
    saved(page, "Save the points", tmp_path)
    plan = load_plan(saved(page, "Download the test plan", tmp_path))
    by_command = lagging_text(fit_plan(plan).laggings)
    law = tomllib.loads(by_command)["law"]
    assert law == tomllib.loads((tmp_path / "my-lagging.toml").read_text())["law"]


def test_points_are_moved_deleted_and_taken_back_by_mouse_and_keys(page: Page) -> None:
    of = Drawn()
    picture(page, of.png)
    axes(page, of)
    told = page.get_by_role("status").filter(has_text="Point")
    click(page, of.place(6.0, 0.7))
    expect(told).to_have_text("Point 1: 6, 0.7", use_inner_text=True)
    click(page, of.place(9.0, 0.7))
    # a pixel to the right, 25 of 12 mm/x: by the picture's own scale
    wide = of.place(12.0, 0.0)[0] - of.place(0.0, 0.0)[0]
    page.locator(".figure-view > svg").focus()
    page.keyboard.press("ArrowRight")
    moved = float((told.inner_text()).split()[2].strip(","))
    assert moved == pytest.approx(9.0 + 12.0 / wide, abs=0.02)
    page.keyboard.press("Control+z")
    page.keyboard.press("PageDown")
    page.keyboard.press("PageDown")
    expect(told).to_contain_text("Point 2: 9")
    page.keyboard.press("Delete")
    expect(told).to_have_text("Point 1: 6, 0.7", use_inner_text=True)
    page.get_by_role("button", name="Undo step").click()
    expect(page.locator("#figure-c0 >> xpath=../..")).to_contain_text("2 points")
    # larger, a click is finer than a pixel; dragged, a point goes where it is let go
    for _ in range(2):
        page.get_by_role("button", name="Larger picture").click()
    click(page, of.place(6.0, 0.7))
    box = page.locator(".figure-view").bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 40, y, steps=4)
    page.mouse.up()
    scale = page.evaluate("document.querySelector('.figure-view > svg').getScreenCTM().a")
    there = float((told.inner_text()).split()[2].strip(","))
    assert there == pytest.approx(6.0 + 40 / scale * 12.0 / wide, abs=0.05)
    expect(page.locator("#figure-c0 >> xpath=../..")).to_contain_text("2 points")
    # by keys alone: a cross is moved, and leaves a point
    page.locator(".figure-view > svg").focus()
    page.keyboard.press("Escape")
    page.keyboard.press("Control+ArrowDown")
    page.keyboard.press("Enter")
    expect(page.locator("#figure-c0 >> xpath=../..")).to_contain_text("3 points")


def wrong(page: Page, field: str, text: str) -> None:
    expect(page.locator(f"#figure-{field}-e")).to_contain_text(text)


def test_what_cannot_be_read_is_refused_under_its_field(page: Page) -> None:
    of = Drawn()
    picture(page, of.png)
    fit(page)
    wrong(page, "m0", "Click this point in the picture.")
    expect(page.locator("#t-digitised-slip_unit-e")).to_contain_text(
        "Choose the unit of slip in the figure."
    )
    axes(page, of)
    page.fill("#figure-m1", "zwölf")
    wrong(page, "m1", "zwölf is no number. Type one such as 0.5.")
    page.fill("#figure-m1", "0")
    wrong(page, "m1", "Both points are at 0.")
    page.fill("#figure-m1", "12")
    page.get_by_role("checkbox", name="x axis is logarithmic").check()
    wrong(page, "m0", "0 is on no logarithmic axis. Type a value above 0.")
    page.get_by_role("checkbox", name="x axis is logarithmic").uncheck()
    # both points of the x axis at one place, then both along the y axis
    page.get_by_role("button", name="Click x axis, second point").click()
    click(page, tuple(np.add(of.place(0.0, 0.0), (9.0, 0.0))))
    wrong(page, "m1", "It is 9 pixels from the first point. Click them farther apart.")
    page.get_by_role("button", name="Click x axis, second point").click()
    click(page, of.place(0.5, 1.0))
    wrong(page, "m3", "degrees. Click two points along each axis.")
    page.get_by_role("button", name="Click x axis, second point").click()
    click(page, of.place(12.0, 0.0))
    expect(page.locator(".field.wrong #figure-m1")).to_have_count(0)
    # a curve too short, without a pressure, twice, and far off
    click(page, of.place(1.0, 0.5))
    wrong(page, "c0", "Type the pressure of this curve, such as 138. 1 points. Click 10 or more")
    curve(page, of, 0, 34.0, 1.5)
    expect(page.locator("#figure-c0-e")).to_be_empty()
    curve(page, of, 1, 690.0)
    page.fill("#figure-c1", "4.93")
    page.get_by_label("Unit of pressure 2").select_option("psi")
    wrong(page, "c1", "34 kPa and 4.93 psi are one. Correct it, or delete one curve.")
    page.fill("#figure-m1", "2")  # the axis ends far before the points
    page.get_by_role("button", name="Click x axis, second point").click()
    click(page, of.place(2.0, 0.0))
    wrong(page, "c1", "far outside the points of the axes")
    page.fill("#figure-c1", "1e999")
    wrong(page, "c1", "Type the pressure of this curve")
    page.evaluate("document.querySelectorAll('#main details').forEach((d) => { d.open = true; })")
    assert violations(page) == []


#: Files that are no picture: type, content, what is told.
NO_PICTURES = {
    "notes.txt": ("text/plain", b"x,y", "notes.txt is no picture. Choose PNG"),
    "torn.png": ("image/png", b"\x89PNG\r\n\x1a\n torn", "torn.png cannot be shown"),
    "wide.svg": (
        "image/svg+xml",
        b"<svg xmlns='http://www.w3.org/2000/svg' width='9000' height='9000'/>",
        "wide.svg has 81 million pixels, at most 40 are taken. Crop it.",
    ),
}


def test_what_is_no_picture_is_refused(page: Page) -> None:
    for name, (kind, data, text) in NO_PICTURES.items():
        picture(page, data, name, kind)
        expect(page.get_by_label("Figure", exact=True).get_by_role("alert")).to_contain_text(text)
        expect(page.locator(".figure-view")).to_have_count(0)


def test_a_picture_with_a_script_is_shown_and_runs_nothing(page: Page) -> None:
    """Neither its own script nor what it asks for elsewhere (which the visitor would report)."""
    svg = (
        b"<svg xmlns='http://www.w3.org/2000/svg' width='400' height='300' "
        b"onload='window.ran = 1'><script>window.ran = 1; document.title = 'ran'</script>"
        b"<image href='http://127.0.0.9/x.png' width='9' height='9'/>"
        b"<rect width='400' height='300' fill='red'/></svg>"
    )
    picture(page, svg, "figure.svg", "image/svg+xml")
    page.wait_for_selector(".figure-view image")
    assert page.evaluate("window.ran === undefined && document.title !== 'ran'")
    assert page.evaluate("document.querySelectorAll('.figure-view script').length") == 0


def test_a_picture_is_dropped_or_pasted(visitor: Visitor) -> None:
    page = visitor.open("tests")
    for way in ("drop", "paste"):
        page.evaluate(
            """([way, text]) => {
              const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
              const data = new DataTransfer();
              data.items.add(new File([bytes], `${way}.png`, { type: "image/png" }));
              const how = { bubbles: true, cancelable: true };
              if (way === "paste")
                document.body.dispatchEvent(
                  new ClipboardEvent("paste", { clipboardData: data, ...how }));
              else
                document.querySelector("#tests .drop").dispatchEvent(
                  new DragEvent("drop", { dataTransfer: data, ...how }));
            }""",
            [way, base64.b64encode(Drawn().png).decode()],
        )
        expect(page.get_by_role("heading", name=f"Curves of {way}")).to_be_visible()
        page.wait_for_selector(".figure-view image")


def points(p: float, n: int = 14) -> list[list[float]]:
    return [[float(x), float(drawn(x, p))] for x in np.linspace(0.1, 11.9, n)]


def test_the_file_of_a_digitiser_is_dropped_named_and_fitted(page: Page, tmp_path: Path) -> None:
    """Two curves that their names do not tell the pressure of."""
    page.locator("#tests > .sub").get_by_text("Tests", exact=True).click()
    sets = [
        {"name": n, "data": points(p)}
        for n, p in zip(("Curve1", "Curve2", "690 kPa"), PRESSURES, strict=True)
    ]
    file = {"name": "wpd.json", "mimeType": "application/json",
            "buffer": json.dumps({"datasetColl": sets}).encode()}  # fmt: skip
    page.set_input_files("#test-files", file)  # type: ignore[arg-type]
    expect(page.get_by_role("heading", name="1 file of points")).to_be_visible()
    say(page)
    fit(page)
    expect(page.get_by_role("alert")).to_contain_text(
        ["the pressure of this curve is not known"] * 1
    )
    for name, p in zip(("Curve1", "Curve2"), ("34 kPa", "20 psi"), strict=True):
        field = page.get_by_role("textbox", name=f"Pressure of {name} of wpd.json")
        field.fill(p)
        field.press("Tab")
    fit(page)
    page.get_by_role("button", name=USE).wait_for()
    lagging = load_lagging(saved(page, "Download the lagging file", tmp_path))
    found = float(lagging.law.friction(4e-3, 138e3))
    assert found == pytest.approx(float(drawn(4.0, 138.0)), rel=0.02)


@pytest.mark.parametrize(
    ("head", "figure"), [("x,34 kPa,138 kPa", True), ("way,pull a,pull b", False)]
)
def test_a_file_of_a_digitiser_is_told_from_one_of_a_machine(
    page: Page, head: str, figure: bool
) -> None:
    page.locator("#tests > .sub").get_by_text("Tests", exact=True).click()
    rows = "\n".join(f"{a},{b},{b / 2}" for a, b in points(34.0))
    file = {"name": "p.csv", "mimeType": "text/csv", "buffer": f"{head}\n{rows}".encode()}
    page.set_input_files("#test-files", file)  # type: ignore[arg-type]
    expect(
        page.get_by_role("heading", name="1 file of points" if figure else "1 test")
    ).to_be_visible()


def test_a_and_b_are_clicked_over_pressure(page: Page, tmp_path: Path) -> None:
    """On a plain picture of 800 x 600: 0 to 800 kPa, and -1 to 1 of A and b."""
    blank = io.BytesIO()
    Image.new("RGB", (800, 600), "white").save(blank, "png")
    picture(page, blank.getvalue(), "fig7.png")
    page.select_option("#t-digitised-quantity", "coefficients")
    say(page)
    page.fill("#t-digitised-slip_max", "12 mm")
    for at in ((0, 300), (800, 300), (400, 599), (400, 1)):
        click(page, (min(at[0], 798), at[1]))
    for k, value in enumerate(("0", "798", "-299", "299")):
        page.fill(f"#figure-m{k}", value)
    pressures = np.array([34.0, 100.0, 200.0, 400.0, 690.0])
    peak = [(1.25 * (p / 34) ** -0.3, 9.0 * (p / 34) ** 0.15) for p in pressures]
    ab = np.array([ab_from_peak(*of) for of in peak])
    for k, name in enumerate("Ab"):
        if k:
            page.get_by_role("button", name="Add a curve").click()
        else:
            fit(page)
            expect(page.locator("#figure-curves")).to_contain_text("both A and b are needed")
            page.get_by_role("button", name="Click along curve 1").click()
        page.get_by_role("button", name="Larger picture").click()
        page.get_by_role("button", name="Larger picture").click()
        for p, value in zip(pressures, ab[:, k], strict=True):
            click(page, (float(p), 300 - 299 * float(value)))
        page.select_option(f"#figure-c{k}", name)
    for k, value in ((2, "-1"), (3, "1")):
        page.fill(f"#figure-m{k}", value)
    fit(page)
    page.get_by_role("button", name=USE).wait_for()
    lagging = load_lagging(saved(page, "Download the lagging file", tmp_path))
    for p, (mu, x) in zip(pressures, peak, strict=True):
        assert float(lagging.law.friction(x * 1e-3, p * 1e3)) == pytest.approx(mu, rel=0.02)


def test_the_next_picture_keeps_the_points_of_the_last(page: Page) -> None:
    of = Drawn()
    picture(page, of.png)
    axes(page, of)
    click(page, of.place(1.0, float(drawn(1.0, 34.0))))
    picture(page, of.png, "fig4.png")
    expect(page.get_by_label("Figure", exact=True).get_by_role("alert")).to_contain_text(
        "Finish or delete the curves of this picture before the next."
    )
    curve(page, of, 0, 34.0, 1.5)
    picture(page, of.png, "fig3.png")
    expect(page.get_by_role("heading", name="1 file of points")).to_be_visible()
    expect(page.get_by_role("heading", name="Curves of fig3-2")).to_be_visible()
    axes(page, of)
    curve(page, of, 0, 138.0)
    curve(page, of, 1, 690.0)
    fit(page)
    for field, text in (
        ("digitised-source", "Say who published the figure."),
        ("fit-remove_shear", "Does the slip of the figure include the sample's own shear?"),
    ):
        expect(page.locator(f"#t-{field}-e")).to_contain_text(text)
    say(page)
    fit(page)
    page.get_by_role("button", name=USE).wait_for()
    rows = page.locator("#tests .rows-of .name")
    assert {"fig3.json", "fig3-2.json"} <= set(rows.all_inner_texts())


def test_on_a_phone_the_picture_fits_and_a_tap_sets_a_point(calculator: Calculator) -> None:
    browser, server = calculator
    visit = Visitor(browser, server.address, PHONE, has_touch=True, is_mobile=True)
    page = visit.open("tests")
    page.get_by_text("A published figure", exact=True).tap()
    picture(page, Drawn().png)
    page.locator(".figure-view > svg").tap(position={"x": 60, "y": 60})
    expect(page.get_by_role("button", name="Click x axis, second point")).to_have_attribute(
        "aria-pressed", "true"
    )
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    visit.close()
    assert visit.wrong == []
