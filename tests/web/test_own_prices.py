"""Laggings of one's own in Compare: a price stands in its currency, and none is converted."""

from pathlib import Path

import pytest
from playwright.sync_api import expect

import wraparc
from web.browser import Calculator, Visitor
from web.calculators import serving

DATA = Path(wraparc.__file__).parent / "catalogue" / "data" / "laggings"
#: Prices of the lagging of one's own: 3000 and 4000 on 6 m2, a life of two years.
COST = """
[cost]
material = 3000
installation = 4000
currency = "EUR"
area = "6 m2"
life_years = [2, 2]
"""


def test_prices_of_two_currencies_are_never_set_side_by_side(
    calculator: Calculator, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # expected: by the currency that a file or the catalogue states; there is no rate of exchange
    folder = tmp_path / "catalogue"
    (folder / "laggings").mkdir(parents=True)
    text = (DATA / "diamond-rubber.toml").read_text("utf-8")
    own = text.replace('"diamond-rubber"', '"own-rubber"', 1).replace(
        "Diamond rubber (illustrative)", "Own rubber", 1
    )
    (folder / "laggings" / "own-rubber.toml").write_text(own + COST, "utf-8")
    monkeypatch.setenv("WRAPARC_CATALOGUE", str(folder))
    place = str(tmp_path / "designs.sqlite")
    with serving("--no-open", "--workers", "0", "--database", place) as server:
        visitor = Visitor(calculator[0], server.address)
        page = visitor.open("compare")
        status = page.locator("#compare [role=status]").first
        own_row = page.locator("#compare tbody tr", has_text="Own rubber")
        other = page.locator("#compare tbody tr", has_text="Diamond rubber")
        remarks = page.locator("#compare ul.help")
        # those of the catalogue are in Australian dollars, and so the answer is at first
        expect(status).to_contain_text("in AUD")
        expect(remarks).to_contain_text("no price in AUD is known")
        dollars = page.locator("#compare thead th", has_text="Cost over the years")
        at = page.locator("#compare thead th").all_inner_texts().index(dollars.inner_text())
        cell = f"> :nth-child({at + 1})"
        expect(own_row.locator(cell)).to_have_text("-")
        expect(other.locator(cell)).not_to_have_text("-")
        page.get_by_label("Currency").fill("EUR")
        page.get_by_label("Currency").press("Tab")
        expect(status).to_contain_text("in EUR")
        expect(remarks).to_contain_text("no price in EUR is known")
        expect(own_row.locator(cell)).not_to_have_text("-")
        expect(other.locator(cell)).to_have_text("-")
        # ranked by cost, what has no price in that currency stands behind
        page.locator("#compare thead").get_by_role("button", name="Cost over the years").click()
        expect(page.locator("#compare tbody tr").first).to_contain_text("Own rubber")
        visitor.close()
        assert visitor.wrong == []
