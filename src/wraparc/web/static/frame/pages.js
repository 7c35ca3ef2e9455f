// The frame that holds the pages.
import { app, redraw } from "../base/design.js";
import { offered } from "../base/drafts.js";
import { AGAIN, askAgain, GONE, part } from "../base/server.js";
import { Component, h } from "../vendor/preact.js";
import { behind } from "./header.js";
import { PAGES } from "./registry.js";
import { views } from "./tabs.js";

/** The page that is looked at; undefined while it is on its way. */
export function present() {
  const page = PAGES[app.page];
  if (!page.view && page.load) {
    const { load } = page;
    page.load = undefined;
    part(load).then(
      (view) => {
        page.view = view;
        redraw();
      },
      () => {},
    );
  }
  return page.view;
}
/** Tabs whose pages have the frame of the first screen. */
const FRAMED = ["drive", "measure"];
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
    const { title, view, tab } = PAGES[name];
    this.seen = app.page === name;
    return h(
      "section",
      {
        id: name,
        hidden: !this.seen,
        "aria-label": title,
        class: FRAMED.includes(tab) && "framed",
      },
      name !== "drive" && this.seen && h("div", { class: "sub" }, views(), view?.picks?.()),
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
/** What concerns every page: a server that is gone or another, a draft from before. */
function bars() {
  const bar = app.gone ? app.page !== "drive" && GONE_BAR : app.newer ? NEWER : app.lacks && LACKS;
  return [
    app.stranger ? behind()?.entry() : bar && told(...bar),
    offered.draft && behind()?.offer(offered.draft),
  ];
}
const KEPT = " The drive is saved in this browser as typed.";
/** @typedef {[string, string, string, () => void]} Bar */
/** @type {Bar} */
const GONE_BAR = [GONE, AGAIN, "Calculate", askAgain];
const reload = () => location.reload();
/** @type {Bar} */
const NEWER = ["The calculator is of another version now.", "", "Reload", reload];
/** @type {Bar} */
const LACKS = ["A part of this page did not come.", "", "Reload", reload];
/** @param {Bar} bar */
const told = (...[headline, text, name, onClick]) =>
  h(
    "div",
    { class: "verdict bad gone", role: "alert", key: "gone" },
    h("p", { class: "headline" }, headline),
    h("p", {}, text, KEPT, " ", h("button", { type: "button", onClick }, name)),
  );
