"""What a window showed comes back: after a reload however soon, in another window, by its draft."""

from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, expect

from web.browser import Calculator, Visitor, show_case, turn
from web.calculators import TOKEN

EXAMPLES = Path(__file__).parents[2] / "examples"
T2 = "#f-pulley-0-exit_tension"
#: Packing a design for the address never ends: as far as the address goes, the reload is too soon.
#: What comes from the server has a URL, and arrives.
NEVER_PACKED = """const usual = Response.prototype.arrayBuffer;
Response.prototype.arrayBuffer = function () {
  return this.url ? usual.call(this) : new Promise(() => {});
};"""


def offer(page: Page, words: str) -> None:
    page.get_by_role("note").get_by_role("button", name=words).click()


@pytest.fixture
def other(tmp_path: Path) -> Path:
    """Return a drive file that is no example."""
    text = (EXAMPLES / "head-drive-fabric.toml").read_text("utf-8")
    file = tmp_path / "other.toml"
    file.write_text(text.replace('"60 kN"   ', '"64 kN"   ', 1).replace("ROM", "Coal"), "utf-8")
    return file


def test_reload_and_another_window_bring_back_what_was_typed(visitor: Visitor) -> None:
    page = visitor.open("drive")
    page.fill(T2, "72.5")
    page.reload()
    expect(page.locator(T2)).to_have_value("72.5")
    beside = visitor.context.new_page()
    beside.goto(f"{visitor.address}?token={TOKEN}")  # each window has its own token
    offer(beside, "Open it")
    expect(beside.locator(T2)).to_have_value("72.5")
    beside.close()
    # so does the same window that comes back; it was kept, not offered, lost with the next letter
    page.goto("about:blank")
    page.goto(visitor.address)
    visitor.solved()
    show_case(page)
    expect(page.locator(T2)).to_have_value("60")
    page.fill(T2, "61")
    offer(page, "Open it")
    expect(page.locator(T2)).to_have_value("72.5")


def test_a_reload_before_the_address_is_written_loses_nothing(
    visitor: Visitor, other: Path
) -> None:
    # it showed the drive that the calculator begins with, and offered nothing
    visitor.page.add_init_script(NEVER_PACKED)
    page = visitor.open("drive")
    page.fill(T2, "72.5")
    page.reload()
    expect(page.locator(T2)).to_have_value("72.5")
    visitor.anew(lambda: visitor.load(other))
    expect(page.locator(T2)).to_have_value("64")
    page.reload()
    expect(page.locator(T2)).to_have_value("64")
    expect(page).to_have_title("Head drive, Coal conveyor – Drive – wraparc")
    page.fill(T2, "65")
    page.reload()
    expect(page.locator(T2)).to_have_value("65")


@pytest.mark.parametrize("hash_of", ["this window", "another"])
def test_a_reload_that_the_browser_forgot_the_state_of(
    calculator: Calculator, visitor: Visitor, hash_of: str
) -> None:
    # as Chromium does it where a reload follows at once on a change of the address: it loads the
    # address before, with no state. A link that came from elsewhere is read all the same.
    page = visitor.open("drive")
    written = "() => location.hash.split('/').length === 3"
    page.wait_for_function(written)
    before = page.evaluate("location.hash")
    page.fill(T2, "72.5")
    page.wait_for_function("before => location.hash !== before", arg=before)
    if hash_of == "another":
        beside = Visitor(calculator[0], visitor.address)
        beside.open("drive").fill(T2, "71")
        beside.page.wait_for_function(
            f"before => ({written})() && location.hash !== before", arg=before
        )
        before = beside.page.evaluate("location.hash")
        beside.close()
    page.evaluate(
        """before => {
          history.replaceState(null, '', before);
          // an answer that comes now writes no address, and does not take this one for written
          const { prototype } = Storage;
          history.replaceState = prototype.removeItem = prototype.setItem = () => {};
        }""",
        before,
    )
    page.reload()
    expect(page.locator(T2)).to_have_value("72.5" if hash_of == "this window" else "71")


def test_opening_another_keeps_the_draft_until_it_is_forgotten(
    visitor: Visitor, other: Path
) -> None:
    # expected: what was only opened is no draft; the typed one stands in the menu and is offered
    page = visitor.open("drive")
    page.fill(T2, "72.5")
    visitor.anew(lambda: visitor.load(other))
    expect(page.locator(T2)).to_have_value("64")
    page.reload()
    visitor.solved()
    show_case(page)
    expect(page.locator(T2)).to_have_value("64")
    expect(page.get_by_role("note")).to_contain_text("Head drive, ROM conveyor")
    page.fill(T2, "65")
    page.click("#file > summary")
    kept = page.locator("#file button", has_text=", ROM conveyor, ")
    kept.click()
    expect(page.locator(T2)).to_have_value("72.5")
    page.click("#file > summary")
    page.get_by_role("button", name="Delete all drafts").click()
    turn(page, "compare")
    turn(page, "drive")
    page.click("#file > summary")
    expect(page.get_by_role("button", name="Delete all drafts")).to_have_count(0)
    expect(page.locator(T2)).to_have_value("72.5")
    assert page.evaluate("localStorage.getItem('wraparc.drafts')") == "[]"


def test_a_reload_reads_the_drive_to_begin_with_anew(visitor: Visitor) -> None:
    # its file may have been changed, and the server started again with another
    page = visitor.open("drive")

    def another(route: Route) -> None:
        answer = route.fetch()
        text = answer.text().replace("ROM conveyor", "another file")
        route.fulfill(response=answer, body=text)

    page.route("**/api/v1/start", another)
    page.reload()
    expect(page).to_have_title("Head drive, another file – Drive – wraparc")
