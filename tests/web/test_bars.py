"""The checks as bars against their limits: of the server, and of the page while a slider moves."""

import json
from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, expect

from cli.running import wraparc
from web.browser import Visitor

HEAD = str(Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml")


def bars(page: Page) -> dict[str, tuple[str, float]]:
    """Return words and length [% of the bar] of every check by its title."""
    found = page.locator(".list li").evaluate_all(
        "(all) => all.map((e) => [e.querySelector('.n').firstChild.textContent,"
        "e.querySelector('.v').textContent, parseFloat(e.querySelector('.use u').style.width)])"
    )
    return {title: (words, length) for title, words, length in found}


def expected(*settings: str) -> dict[str, float]:
    """Return the use of the limits in the design case, as ``wraparc solve --json`` has it."""
    _, out, _ = wraparc("solve", HEAD, "--load-case", "design", "--json", "-", *settings)
    (arc,) = json.loads(out)["arcs"]
    return {
        check["title"]: (share if check["at_most"] else 1 / share)
        for check in arc["checks"]
        if check["limit"] and check["value"] is not None and check["name"] != "balance"
        for share in [check["value"] / check["limit"]]
    }


def assert_lengths(page: Page, uses: dict[str, float]) -> None:
    seen = bars(page)
    assert len(seen) >= 7
    for title, (_, length) in seen.items():
        if title in uses:  # some are of the whole drive
            assert length == pytest.approx(min(100.0, 50.0 * uses[title]), abs=1e-3), title
    assert len(uses.keys() & seen.keys()) >= 6


def test_bars_are_the_checks_of_the_command_line(visitor: Visitor) -> None:
    # expected: value over limit of `wraparc solve --json`, or limit over value where that is the
    # least allowed; the limit stands at half of the bar
    page = visitor.open("drive")
    visitor.solved()
    page.wait_for_selector(".list li")
    assert_lengths(page, expected())
    assert bars(page)["Creep"][0] == "7.49 mm ≤ 6.35"
    page.get_by_label("US", exact=True).check(force=True)
    expect(page.locator(".checks")).to_contain_text("0.295 in ≤ 0.25")


def test_bars_follow_the_slider_without_the_server(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.solved()
    visitor.alone()
    page.wait_for_selector(".list li")
    held: list[Route] = []
    page.route("**/api/v1/solve**", lambda route: held.append(route))  # noqa: PLW0108
    before = bars(page)["Creep"]
    page.get_by_label("Wrap angle, slider").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function(
        "(was) => ![...document.querySelectorAll('.list .v')].some((e) => e.textContent === was)",
        arg=before[0],
    )
    wrap = page.input_value("#f-pulley-0-wrap_angle")
    assert_lengths(page, expected("--set", f"pulley.head.wrap_angle={wrap} deg"))
