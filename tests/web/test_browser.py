"""No call into the browser waits for ever."""

import pytest
from playwright.sync_api import Browser

from web import browser


@pytest.mark.parametrize(
    "never",
    [
        "new Promise(() => {})",
        "window.requestAnimationFrame = () => 0, (" + browser.PAINTED + ")()",
        "{ for (;;); }",
    ],
    ids=["promise", "frame", "loop"],
)
def test_what_never_answers_is_an_error_and_the_browser_goes_on(
    never: str, chrome: Browser, monkeypatch: pytest.MonkeyPatch
) -> None:
    context = chrome.new_context()
    page = context.new_page()
    with monkeypatch.context() as patch:
        patch.setattr(browser, "LIMIT", 0.2)
        with pytest.raises(AssertionError, match=r"gave no answer within 0.2 s \(Page\)"):
            page.evaluate(never)
    context.close()
    context = chrome.new_context()
    assert context.new_page().evaluate("1 + 1") == 2
    context.close()
