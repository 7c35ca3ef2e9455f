"""Creep against cost on the page Compare: a dot for every row, where its numbers say."""

import re

import pytest
from playwright.sync_api import Page, expect

from web.browser import Visitor
from web.calculators import API, client, document
from worded import worded


def dots(page: Page) -> dict[str, tuple[float, float]]:
    """Return the places of the dots by the names beside them."""
    found = page.locator("#compare figure svg").evaluate(
        "(svg) => [...svg.querySelectorAll('path[transform]')].map((e) =>"
        " [e.nextSibling.textContent, e.getAttribute('transform')])"
    )
    return {name: places(transform) for name, transform in found}


def places(transform: str) -> tuple[float, float]:
    x, y = re.findall(r"[-\d.]+", transform)
    return float(x), float(y)


def test_dots_stand_where_creep_and_cost_are(visitor: Visitor) -> None:
    # expected: the numbers of the answer, on axes that begin at zero
    with client() as api:
        answer = api.post(f"{API}/compare", json={"document": document()}).json()
    rows = {row["title"]: row["cells"] for row in answer["rows"]}
    page = visitor.open("compare")
    expect(page.locator("#compare figure svg")).to_be_visible()
    seen = dots(page)
    assert seen.keys() == rows.keys()
    left, floor = 52.0, 218.0
    across = {(seen[t][0] - left) / rows[t]["cost_total"]["value"] for t in rows}
    up = {(floor - seen[t][1]) / rows[t]["exit_creep"]["value"] for t in rows}
    assert max(across) == pytest.approx(min(across), rel=1e-9)
    assert max(up) == pytest.approx(min(up), rel=1e-9)
    (limit,) = page.locator("#compare .limit").evaluate_all(
        "(all) => all.map((e) => e.getAttribute('d'))"
    )
    height = float(re.findall(r"[-\d.]+", limit)[1])
    assert (floor - height) / max(up) == pytest.approx(6.35e-3, rel=1e-6)
    told = page.locator("#compare figure svg").get_attribute("aria-label") or ""
    assert all(worded(rows[t]["exit_creep"]["text"]) in told for t in rows)
    page.get_by_label("US", exact=True).check(force=True)
    expect(page.locator("#compare figure")).to_contain_text("creep limit 0.25 in")


def test_belts_whose_prices_nobody_knows_have_no_dots(visitor: Visitor) -> None:
    page = visitor.open("compare")
    page.get_by_label("Belts").check(force=True)
    expect(page.locator("#compare")).to_contain_text("Plylon Plus 900/2")
    expect(page.locator("#compare figure")).to_have_count(0)
