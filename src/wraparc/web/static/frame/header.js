// The head of the page: tabs, units, undo, the menus Report and File.
import { turnTo } from "../base/address.js";
import { app, history, look, redo, redraw, undo } from "../base/design.js";
import { drafts, draftTitle, forgetDrafts, openDraft, otherDrafts } from "../base/drafts.js";
import { act, part } from "../base/server.js";
import { oneOf } from "../parts/choose.js";
import { h } from "../vendor/preact.js";
import { download, newDrive, openExample } from "./files.js";
import { PAGES } from "./registry.js";
import { tabs } from "./tabs.js";

/** @import { Children } from "../types.d.ts" */

const icon = /** @type {HTMLLinkElement} */ (document.querySelector("link[rel=icon]"));
/** What is behind Export, fetched when that is opened first. */
let exporting = /** @type {typeof import("./exporting.js") | null} */ (null);

const fetchExporting = act(async () => {
  exporting ??= await part(() => import("./exporting.js"));
  redraw();
});

export const Header = () => [
  h(
    "div",
    { class: "brand", key: "brand" },
    h("img", { src: icon.href, alt: "", width: 26, height: 26 }),
    " ",
    h("b", {}, "wraparc"),
  ),
  h(
    "nav",
    { "aria-label": "Pages", id: "nav", key: "nav" },
    tabs(),
    menu("export", "Report", exporting?.exportMenu(), fetchExporting),
  ),
  h(
    "div",
    { class: "tools", role: "group", "aria-label": "Design", key: "tools" },
    h("b", { class: "title", id: "title" }, app.doc.title || "Drive without a title"),
    unitSwitch(),
    step("undo", "↶", "Undo (Ctrl+Z)", undo, history.back()),
    step("redo", "↷", "Redo (Ctrl+Y)", redo, history.forth()),
    menu("file", "File", fileMenu()),
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
 * @param {(e: Event) => any} [onToggle] */
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
function choose() {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".toml";
  input.addEventListener(
    "change",
    act(async () => {
      const file = input.files?.[0];
      if (file) await (await part(() => import("./opening.js"))).openFile(file);
    }),
  );
  input.click();
}
function fileMenu() {
  const kept = otherDrafts();
  return [
    item("New drive", newDrive),
    item(PAGES.saved ? "Open a drive or lagging file …" : "Open a drive file …", choose),
    item("Download the drive file", download),
    PAGES.saved &&
      item("Save, and saved designs …", () => {
        turnTo("saved");
        redraw();
      }),
    PAGES.saved &&
      item("Copy a link to this design", async () =>
        (await part(() => import("./link.js"))).copied(),
      ),
    item("Print", () => print()),
    h("p", { class: "help", key: "examples" }, "Examples"),
    app.catalogue.examples.map((x) => item(x.title, () => openExample(x.name))),
    kept.length > 0 && h("p", { class: "help", key: "drafts" }, "Drafts kept in this browser"),
    kept.map((d) => item(draftTitle(d), () => openDraft(d))),
    drafts().length > 0 &&
      item("Forget all drafts", () => {
        forgetDrafts();
        redraw();
      }),
  ];
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
