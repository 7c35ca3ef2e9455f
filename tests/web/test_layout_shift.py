"""What is read does not jump: load shift of the first page, as the browser counts it (CLS)."""

import pytest
from playwright.sync_api import Route, ViewportSize, expect

from web.browser import DESKTOP, PHONE, Calculator, Visitor, evaluated
from web.calculators import API, TOKEN, document, wait_for

#: Sum of all shifts that no input explains; the script runs before the page.
_COUNT = """() => {
  window.shift = 0;
  new PerformanceObserver((seen) => {
    for (const e of seen.getEntries()) if (!e.hadRecentInput) window.shift += e.value;
  }).observe({ type: "layout-shift", buffered: true });
}"""
#: Largest sum that users do not notice by far: https://web.dev/articles/cls says 0.1.
MOST = 0.02


@pytest.mark.parametrize(
    ("first", "size"),
    [
        *(("start/solved", size) for size in (DESKTOP, {"width": 1024, "height": 768}, PHONE)),
        *(("solve", size) for size in (DESKTOP, PHONE)),
        *(("solve/fast", size) for size in (DESKTOP, PHONE)),
    ],
)
def test_nothing_jumps_while_the_first_page_loads(
    calculator: Calculator, size: ViewportSize, first: str
) -> None:
    # solved before the page came, or asked for: then whichever of both answers comes first, the
    # other one is held until that one is there
    browser, server = calculator
    visitor = Visitor(browser, server.address, size)
    page = visitor.page
    page.add_init_script(f"({_COUNT})()")
    asked: list[str] = []
    held: list[Route] = []
    page.on("request", lambda r: asked.append(r.url.partition(f"{API}/")[2]))
    if first == "start/solved":
        wait_for(lambda: server.ask(f"{API}/{first}").status == 200)
    else:
        page.route(f"**{API}/start/solved", lambda route: route.fulfill(status=204))
        other = "solve" if first == "solve/fast" else "solve/fast"
        page.route(f"**{API}/{other}", lambda route: held.append(route))  # noqa: PLW0108
    with page.expect_response(f"**{API}/{first}"):
        page.goto(f"{server.address}?token={TOKEN}")
    if first == "start/solved":
        visitor.solved()
        visitor.painted()
        assert not {"solve", "solve/fast"} & set(asked)
    else:
        visitor.painted()
        wait_for(lambda: page.evaluate("true") and held)
        held[0].continue_()
        visitor.solved()
        visitor.painted()
    assert page.evaluate("shift") < MOST
    visitor.close()


def test_many_load_cases_are_not_waited_for(calculator: Calculator) -> None:
    # the first arc stands there while the whole is on its way, however many load cases there are
    visitor = Visitor(calculator[0], calculator[1].address)
    page = visitor.open("drive")
    visitor.solved()
    page.route(f"**{API}/solve", lambda route: None)
    doc = document()
    doc["pulley"][0]["name"] = "drum"
    case = {"pulley": {"drum": {"entry_tension": "100 kN"}}}
    doc["load_case"] = [{"name": f"case {i}", **case} for i in range(9)]
    evaluated(page, "(doc) => import('/static/main.js').then((m) => m.take(doc))", doc)
    # the first arc has come, and the verdict on the drive before does not stand beside it
    expect(page.locator(".hub-number")).not_to_have_text("– mm")
    expect(page.locator(".governing")).to_have_count(0)
    expect(page.locator(".list li")).to_have_count(0)
    page.unroute_all(behavior="ignoreErrors")
    visitor.close()
