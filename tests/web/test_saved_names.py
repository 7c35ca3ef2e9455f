"""Names of saved designs on the page."""

import json

from playwright.sync_api import expect

from web.browser import Calculator, Visitor
from web.calculators import API, document


def test_a_version_that_is_refused_renames_nothing(calculator: Calculator) -> None:
    # another window has saved a version meanwhile: the answer is 409, and the name as it was
    browser, server = calculator
    visitor = Visitor(browser, server.address)
    page = visitor.open("saved")
    page.fill("#design-name", "as it was called")
    page.get_by_role("button", name="Save as a new design").click()
    expect(page.locator("#toast")).to_contain_text("Saved as version 1")
    listed = server.ask(f"{API}/designs?query=as%20it%20was%20called").json()["designs"]
    (design,) = listed
    version = {"document": document(), "note": "", "who": "theirs", "base": 1}
    path = f"{API}/designs/{design['id']}/versions"
    assert server.ask(path, {**version, "name": "as it was called"}).status == 201
    page.fill("#design-name", "a new name")
    page.get_by_role("button", name="Save a new version").click()
    expect(page.locator("#conflict")).to_contain_text("saved version 2 meanwhile")
    expect(page.locator("#saved")).to_contain_text("This is version 1 of “as it was called”")
    page.reload()
    rows = page.locator("#saved .scroll")
    expect(rows).to_contain_text("as it was called")
    expect(rows).not_to_contain_text("a new name")
    found = server.ask(f"{API}/designs/{design['id']}").json()
    assert (found["name"], len(found["versions"])) == ("as it was called", 2), json.dumps(found)
    visitor.close()
    assert visitor.wrong == []
