// The tabs of the page, and what stands side by side under one.
import { turnTo } from "../base/address.js";
import { app, redraw } from "../base/design.js";
import { h } from "../vendor/preact.js";
import { PAGES } from "./registry.js";

/** @type {[string, string][]} */
const TABS = [
  ["drive", "Drive"],
  ["choose", "Choose"],
  ["measure", "Measure"],
  ["report", "Report"],
];
/** Pages of a tab. @param {string} tab */
const under = (tab) => Object.keys(PAGES).filter((name) => PAGES[name].tab === tab);
/** What was looked at last of each tab. @type {Record<string, string>} */
const last = {};

/** @param {string} id @param {string} name of a page @param {string} text @param {boolean} now */
const link = (id, name, text, now) =>
  h(
    "a",
    {
      id,
      key: id,
      href: `#/${name}`,
      "aria-current": now ? "page" : undefined,
      onClick: (e) => {
        if (e.ctrlKey || e.metaKey || e.shiftKey) return;
        e.preventDefault();
        turnTo(name);
        redraw();
      },
    },
    text,
  );
export function tabs() {
  last[PAGES[app.page].tab] = app.page;
  return TABS.filter(([tab]) => under(tab).length).map(([tab, text]) =>
    link(`tab-${tab}`, last[tab] ?? under(tab)[0], text, PAGES[app.page].tab === tab),
  );
}
/** The pages of the tab that is looked at, where there are several. */
export function views() {
  const all = under(PAGES[app.page].tab);
  if (all.length < 2 || !PAGES[app.page].tab) return null;
  return h(
    "nav",
    { class: "views", "aria-label": "Views", key: "views" },
    all.map((name) => link(`nav-${name}`, name, PAGES[name].as, app.page === name)),
  );
}
