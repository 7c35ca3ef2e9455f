// The frame that holds the pages.
import { app, redraw } from "../base/design.js";
import { draftTitle, forgetDraft, offered, openDraft } from "../base/drafts.js";
import { ask, note, onReturn } from "../base/server.js";
import { Component, h } from "../vendor/preact.js";
import { PAGES } from "./registry.js";

/** @import { Draft } from "../base/drafts.js" */
/** The page that is looked at; undefined while it is on its way. */
export function present() {
  const page = PAGES[app.page];
  if (!page.view && page.load) {
    const { load } = page;
    page.load = undefined;
    load()
      .then((view) => {
        page.view = view;
        redraw();
      })
      .catch(() => {
        // no browser asks for a script anew that did not come: the window begins again, as it is
        onReturn(() => location.reload());
        ask("about").then(
          () => note("This page did not come: reload the window, what you typed is kept.", true),
          () => {},
        );
      });
  }
  return page.view;
}
const visited = new Set();

/** One page: drawn only while it is looked at, kept when it is left.
 * @extends {Component<{name: string}>} */
class Place extends Component {
  seen = false;
  shouldComponentUpdate() {
    const shown = app.page === this.props.name;
    return shown || this.seen;
  }
  render() {
    const { name } = this.props;
    const { title, view } = PAGES[name];
    this.seen = app.page === name;
    return h(
      "section",
      { id: name, hidden: !this.seen, "aria-label": title },
      h("h1", { tabIndex: -1, id: `${name}-title` }, title),
      view ? view.Page() : h("p", { class: "help" }, "Loading …"),
    );
  }
}
export function Main() {
  visited.add(app.page);
  return [
    bars(),
    Object.keys(PAGES).map((name) => visited.has(name) && h(Place, { name, key: name })),
  ];
}
/** What concerns every page: a server that is gone, a draft from before. */
function bars() {
  const gone = h(
    "div",
    { class: "verdict bad gone", role: "alert", key: "gone" },
    h(
      "p",
      { class: "headline" },
      "The calculator does not answer: is `wraparc serve` still running?",
    ),
    h(
      "p",
      {},
      "Nothing is lost: what you type is kept in this browser. It is asked again every second.",
    ),
  );
  return [app.gone && gone, offered.draft && offer(offered.draft)];
}
/** @param {Draft} draft */
function offer(draft) {
  const close = () => {
    offered.draft = null;
    redraw();
  };
  const forget = () => {
    forgetDraft(draft);
    close();
  };
  return h(
    "div",
    { class: "card aside", role: "note", key: "draft" },
    h("p", {}, `A draft is kept in this browser: ${draftTitle(draft)}.`),
    h(
      "p",
      { class: "inline" },
      h("button", { type: "button", class: "main", onClick: () => openDraft(draft) }, "Open it"),
      h("button", { type: "button", onClick: close }, "Not now"),
      h("button", { type: "button", onClick: forget }, "Forget it"),
    ),
  );
}
