"""The plots along the wrap stand on one axis, named at their lines; a press writes little."""

import re

from playwright.sync_api import expect

from web.browser import DESKTOP, PHONE, Calculator, Visitor

#: Boxes of the grid, numbers below the axis, names and points of the courses of every plot.
_PLOTS = """() => [...document.querySelectorAll("#drive .plots svg.chart")].map((svg) => {
  const box = (e) => { const b = e.getBBox(); return [b.x, b.y, b.x + b.width, b.y + b.height]; };
  const names = [...svg.querySelectorAll("g:not(:first-of-type) > text")]
    .filter((e) => e.textContent && !e.getAttribute("class"));
  const lines = [...svg.querySelectorAll("path.line")].filter((e) => e.getAttribute("d"));
  return {
    ends: box(lines[0]).filter((_, i) => i % 2 === 0),
    numbers: [...svg.querySelectorAll("text.tx")].map((e) => e.textContent),
    names: names.map((e) => [e.textContent, ...box(e)]),
    points: lines.flatMap((e) => {
      const n = e.getTotalLength();
      return Array.from({ length: 400 }, (_, i) => {
        const { x, y } = e.getPointAtLength((i / 399) * n);
        return [x, y];
      });
    }),
  };
})"""
#: Writes of what stood there already, and children put anew in axes and pulley, at one press.
_WATCH = """() => {
  window.idle = [];
  window.anew = [];
  const all = { subtree: true, attributes: true, attributeOldValue: true, characterData: true,
    characterDataOldValue: true, childList: true };
  const seen = new MutationObserver((found) => {
    for (const { type, target, attributeName: name, oldValue, addedNodes } of found) {
      const now = type === "attributes" ? target.getAttribute(name) : target.data;
      if (type !== "childList" && now === oldValue) idle.push(`${target.nodeName} ${name ?? ""}`);
      else if ([...addedNodes].some((e) => e.nodeType === 1)) anew.push(target.nodeName);
    }
  });
  for (const picture of document.querySelectorAll("svg.stage, .curve-svg, .details svg"))
    seen.observe(picture, all);
}"""
Box = tuple[float, float, float, float]


def _apart(a: Box, b: Box) -> bool:
    return a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def test_plots_stand_on_one_axis_with_names_that_cover_nothing(calculator: Calculator) -> None:
    # expected: the same ends of every course, numbers below the lowest plot alone; boxes of the
    # letters as the browser measures them, less its room above and below them
    for size in (DESKTOP, PHONE):
        visitor = Visitor(calculator[0], calculator[1].address, size)
        page = visitor.open("drive")
        visitor.solved()
        expect(page.locator("#drive .plots text", has_text="belt tension")).to_have_count(1)
        plots = page.evaluate(_PLOTS)
        assert len(plots) == 4
        for plot in plots:
            assert abs(plot["ends"][0] - plots[0]["ends"][0]) < 0.2
            assert abs(plot["ends"][1] - plots[0]["ends"][1]) < 0.2
        assert [bool(plot["numbers"]) for plot in plots] == [False, False, False, True]
        named = [name[0] for plot in plots for name in plot["names"]]
        assert named[:5] == ["belt tension", "available", "used", "creep", "slip"]
        assert len(named) == 8  # the limit, the shear stress and its peak
        for plot in plots:
            boxes = [(x, top + 3, x2, foot - 3) for _, x, top, x2, foot in plot["names"]]
            for i, a in enumerate(boxes):
                assert all(_apart(a, b) for b in boxes[:i])
                assert not any(a[0] < x < a[2] and a[1] < y < a[3] for x, y in plot["points"])
        visitor.close()


def test_one_place_is_read_in_all_plots_by_key_and_pointer(calculator: Calculator) -> None:
    visitor = Visitor(calculator[0], calculator[1].address)
    page = visitor.open("drive")
    visitor.solved()
    angle = page.locator("#drive .reading dd").first
    expect(angle).to_have_text(re.compile(r"^90(\.0)? deg$"))  # to rounding it is 90
    page.get_by_label("Place on the arc").focus()
    page.keyboard.press("ArrowRight")
    expect(angle).to_have_text("90.9 deg")
    plot = page.locator("#drive .plots svg.chart").nth(1)
    plot.scroll_into_view_if_needed()
    plot.hover(position={"x": 58.0, "y": 40.0})  # left of the axis: its beginning
    expect(angle).to_have_text("0 deg")
    courses = page.locator("#drive .plots .cursor").evaluate_all(
        "(all) => all.map((e) => /^M([0-9.]+) /.exec(e.getAttribute('d'))[1])"
    )
    assert courses == ["62"] * 4
    visitor.close()


def test_a_press_writes_only_what_is_another(calculator: Calculator) -> None:
    # expected: in the pictures nothing is written that stood there, no element is made anew while
    # their scales stay (the wrap angle adds up with other last digits at every step)
    visitor = Visitor(calculator[0], calculator[1].address)
    page = visitor.open("drive")
    visitor.alone()
    page.get_by_label("Entry tension, slider").focus()
    figures = page.locator("#details .figures")  # drawn with the pictures below the first screen

    def press() -> None:
        before = figures.text_content() or ""
        page.keyboard.press("ArrowLeft")
        expect(figures).not_to_have_text(before)
        visitor.painted()

    press()
    page.evaluate(_WATCH)
    press()
    assert page.evaluate("idle") == []
    assert page.evaluate("anew") == []
    visitor.close()
