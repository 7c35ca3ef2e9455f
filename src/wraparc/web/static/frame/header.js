// The head of the page: tabs, units, undo, the menu File.
import { app, history, look, redo, redraw, undo } from "../base/design.js";
import { act, part } from "../base/server.js";
import { oneOf } from "../parts/choose.js";
import { h } from "../vendor/preact.js";
import { download } from "./files.js";
import { tabs } from "./tabs.js";

/** @import { Children } from "../types.d.ts" */

const icon = /** @type {HTMLLinkElement} */ (document.querySelector("link[rel=icon]"));
/** What comes behind the first answer. */
let late = /** @type {typeof import("./behind.js") | null} */ (null);
export const behind = () => late;

export const fetchLate = act(async () => {
  if (late) return;
  late = await part(() => import("./behind.js"));
  redraw();
});
document.addEventListener("complete", fetchLate);

export const Header = () => [
  h(
    "div",
    { class: "brand", key: "brand" },
    h("img", { src: icon.href, alt: "", width: 26, height: 26 }),
    " ",
    h("b", {}, "wraparc"),
  ),
  h("nav", { "aria-label": "Pages", id: "nav", key: "nav" }, tabs()),
  h(
    "div",
    { class: "tools", role: "group", "aria-label": "Design", key: "tools" },
    h("b", { class: "title", id: "title" }, app.doc.title || "Drive without a title"),
    unitSwitch(),
    step("undo", "↶", "Undo (Ctrl+Z)", undo, history.back()),
    step("redo", "↷", "Redo (Ctrl+Y)", redo, history.forth()),
    menu("file", "File", late?.fileMenu(), fetchLate),
  ),
];
/** @type {[string, string][]} */
const UNITS = [
  ["si", "SI"],
  ["us", "US"],
];
const unitSwitch = () => oneOf("units", "Units", app.units, UNITS, (units) => look({ units }));
/** @param {string} id @param {string} sign @param {string} title @param {() => void} f
 * @param {boolean} can */
const step = (id, sign, title, f, can) =>
  h(
    "button",
    { type: "button", id, "aria-label": title.split(" ")[0], title, disabled: !can, onClick: f },
    sign,
  );
/** @param {string} id @param {string} title @param {Children} items
 * @param {(e: Event) => any} onToggle */
const menu = (id, title, items, onToggle) =>
  h(
    "details",
    { class: "menu", id, key: id, onToggle },
    h("summary", {}, title),
    h("div", { id: `${id}-menu` }, items),
  );
/** @param {string} text @param {() => any} f */
export const item = (text, f) =>
  h(
    "button",
    {
      type: "button",
      key: text,
      onClick: act((e) => {
        shut(/** @type {Element} */ (e.currentTarget).closest("details"));
        return f();
      }),
    },
    text,
  );
/** @param {Element | null} details */
function shut(details) {
  if (!details) return;
  details.removeAttribute("open");
  /** @type {HTMLElement | null} */ (details.querySelector("summary"))?.focus();
}
/** Menus shut at a press elsewhere and at Escape; keys for undo, redo and download. */
export function listen() {
  const open = () => document.querySelectorAll(".menu[open]");
  document.addEventListener("click", (e) => {
    for (const m of open())
      if (!m.contains(/** @type {Node} */ (e.target))) m.removeAttribute("open");
  });
  document.addEventListener("keydown", (e) => {
    if (e.key === "Escape") for (const m of open()) shut(m);
    if (!(e.ctrlKey || e.metaKey) || e.altKey) return;
    const key = e.key.toLowerCase();
    if (key === "s") {
      e.preventDefault();
      act(download)(e);
    }
    if ((key !== "z" && key !== "y") || ownUndo(e.target)) return;
    e.preventDefault();
    if (key === "y" || e.shiftKey) redo();
    else undo();
  });
}
/** Boxes that are no part of the design undo their own typing. @param {EventTarget | null} e */
const ownUndo = (e) =>
  e instanceof Element &&
  e.matches("input[type=text], input[type=search], textarea") &&
  e.closest("#saved, #tests, #study, #compare, .menu") !== null;
