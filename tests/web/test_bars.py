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
    found = page.locator(".checks li").evaluate_all(
        "(all) => all.map((e) => [e.querySelector('.n').firstChild.textContent,"
        "e.querySelector('.v').textContent, parseFloat(e.querySelector('.use u').style.width)])"
    )
    return {title: (words, length) for title, words, length in found}


def expected(*settings: str) -> dict[str, float]:
    """Return value over limit of the checks of ``wraparc solve --json``, the worst of each."""
    _, out, _ = wraparc("solve", HEAD, "--json", "-", *settings)
    found: dict[str, tuple[float, float]] = {}
    for arc in json.loads(out)["arcs"]:
        for check in arc["checks"]:
            if check["limit"] and check["value"] is not None and check["name"] != "balance":
                share = check["value"] / check["limit"]
                worse = check["margin"]
                if check["title"] not in found or worse < found[check["title"]][0]:
                    found[check["title"]] = worse, share
    return {title: share for title, (_, share) in found.items()}


def assert_lengths(page: Page, shares: dict[str, float]) -> None:
    seen = bars(page)
    assert len(seen) >= 8
    for title, (_, length) in seen.items():
        if title in shares:  # some are of the whole drive
            assert length == pytest.approx(min(100.0, 50.0 * shares[title]), abs=1e-3), title
    assert len(shares.keys() & seen.keys()) >= 6


def test_bars_are_the_checks_of_the_command_line(visitor: Visitor) -> None:
    # expected: value over limit of `wraparc solve --json`; the limit stands at half of the bar
    page = visitor.open("drive")
    visitor.solved()
    page.wait_for_selector(".checks li")
    assert_lengths(page, expected())
    assert bars(page)["Creep at exit"][0] == "11.3 mm, at most 6.35 mm"
    page.get_by_label("US", exact=True).check(force=True)
    expect(page.locator(".checks")).to_contain_text("0.444 in, at most 0.25 in")


def test_bars_follow_the_slider_without_the_server(visitor: Visitor) -> None:
    page = visitor.open("drive")
    visitor.solved()
    visitor.alone()
    page.wait_for_selector(".checks li")
    held: list[Route] = []
    page.route("**/api/v1/solve**", lambda route: held.append(route))  # noqa: PLW0108
    before = bars(page)["Creep at exit"]
    page.get_by_label("Wrap angle, slider").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function(
        "(was) => ![...document.querySelectorAll('.checks small')].some((e) =>"
        " e.textContent === was)",
        arg=before[0],
    )
    wrap = page.input_value("#f-pulley-0-wrap_angle")
    assert_lengths(page, expected("--set", f"pulley.head.wrap_angle={wrap} deg"))
