"""What a drive that is opened shows first."""

from pathlib import Path

from playwright.sync_api import expect

from web.browser import Visitor

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_several_pulleys_open_on_tandem_and_events_are_offered(visitor: Visitor) -> None:
    page = visitor.open("drive", unfold=False)
    visitor.anew(lambda: visitor.load(EXAMPLES / "tandem-fabric.toml"))
    expect(page.locator("#train .parts i")).to_have_count(2)
    expect(page.locator("#nav-train")).to_have_attribute("aria-current", "page")
    said = page.locator("#toast")
    expect(said).to_contain_text("Opened tandem-fabric.toml. It has events.")
    said.get_by_role("button", name="In time").click()
    expect(page.locator("#events form")).to_be_visible()
    page.locator("#nav-train").click()
    # one pulley by itself; without events nothing is offered
    visitor.anew(lambda: visitor.load(EXAMPLES / "head-drive-fabric.toml"))
    expect(page.locator("#nav-drive")).to_have_attribute("aria-current", "page")
    expect(said).to_have_text("Opened head-drive-fabric.toml.")
    visitor.example("Tandem head drive, fabric belt")
    expect(page.locator("#nav-train")).to_have_attribute("aria-current", "page")
    expect(said.get_by_role("button", name="In time")).to_be_visible()
