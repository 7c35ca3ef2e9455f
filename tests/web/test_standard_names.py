"""A belt by its standard name on the drive page: typed, judged, asked about, taken back.

Expected values: the document that a drive file of this belt is, and the name that is meant.
"""

import re

from playwright.sync_api import expect

from web.browser import Calculator, Visitor, evaluated

NAME = "EP 1250/4 6+3"


def test_a_standard_name_is_a_belt_of_the_page(calculator: Calculator) -> None:
    browser, server = calculator
    visitor = Visitor(browser, server.address)
    page = visitor.open("drive")
    page.get_by_label("Belt", exact=True).first.wait_for()
    typed = page.get_by_label("Standard name", exact=True)
    typed.evaluate("(e) => { for (; e; e = e.parentElement) if (e.open === false) e.open = true; }")
    typed.fill(NAME)
    typed.press("Tab")
    expect(page.get_by_label("Belt", exact=True).first).to_have_value(NAME)
    document = evaluated(page, "import('/static/main.js').then((m) => m.app.doc)")
    assert document["belt"]["preset"] == NAME
    expect(page.locator("form.inputs .error").filter(has_text="belt")).to_have_count(0)
    typed.fill("EP 12500/4")
    typed.press("Tab")
    expect(page.locator(".error").filter(has_text=re.compile("EP 1250/4"))).not_to_have_count(0)
    page.get_by_label("Belt", exact=True).first.select_option("Plylon Plus 1000/4")
    expect(typed).to_have_value("")
    visitor.close()
    assert visitor.wrong == []
