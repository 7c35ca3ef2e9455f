// The head of the page: pages, units, undo, the menus File and Report.
import { copyLink, turnTo } from "../base/address.js";
import { app, history, look, redo, redraw, undo } from "../base/design.js";
import { drafts, draftTitle, forgetDraft, otherDrafts } from "../base/drafts.js";
import { act, note } from "../base/server.js";
import { h } from "../vendor/preact.js";
import { download, newDrive, openExample, report } from "./files.js";
import { openDraft, PAGES } from "./pages.js";

/** @import { Children, Units } from "../types.d.ts" */

const head = { project: "", number: "", revision: "", author: "", paper: "a4" };

export const Header = () => [
  h(
    "div",
    { class: "brand", key: "brand" },
    h("img", { src: "/static/icon.svg", alt: "", width: 26, height: 26 }),
    " ",
    h("b", {}, "wraparc"),
  ),
  h("nav", { "aria-label": "Pages", id: "nav", key: "nav" }, Object.keys(PAGES).map(link)),
  h(
    "div",
    { class: "tools", role: "group", "aria-label": "Design", key: "tools" },
    unitSwitch(),
    step("undo", "↶", "Undo (Ctrl+Z)", undo, history.back()),
    step("redo", "↷", "Redo (Ctrl+Y)", redo, history.forth()),
    menu("file", "File", fileMenu()),
    menu("report", "Report", reportMenu()),
  ),
];
/** @param {string} name */
const link = (name) =>
  h(
    "a",
    {
      id: `nav-${name}`,
      key: name,
      href: `#/${name}`,
      "aria-current": app.page === name ? "page" : undefined,
      onClick: (e) => {
        if (e.ctrlKey || e.metaKey || e.shiftKey) return;
        e.preventDefault();
        turnTo(name);
        redraw();
      },
    },
    PAGES[name].title,
  );
function unitSwitch() {
  const units = /** @type {Units[]} */ (["si", "us"]);
  return h(
    "fieldset",
    { class: "switch" },
    h("legend", { class: "away" }, "Units"),
    units.map((u) =>
      h(
        "label",
        { key: u },
        h("input", {
          type: "radio",
          name: "units",
          value: u,
          checked: app.units === u,
          onChange: () => look({ units: u }),
        }),
        h("span", {}, u.toUpperCase()),
      ),
    ),
  );
}
/** @param {string} id @param {string} sign @param {string} title @param {() => void} f
 * @param {boolean} can */
const step = (id, sign, title, f, can) =>
  h(
    "button",
    { type: "button", id, "aria-label": title.split(" ")[0], title, disabled: !can, onClick: f },
    sign,
  );
/** @param {string} id @param {string} title @param {Children} items */
const menu = (id, title, items) =>
  h(
    "details",
    { class: "menu", id, key: id },
    h("summary", {}, title),
    h("div", { id: `${id}-menu` }, items),
  );
/** @param {string} text @param {() => any} f */
const item = (text, f) =>
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
      if (file) await (await import("./opening.js")).openFile(file);
    }),
  );
  input.click();
}
async function link_() {
  const left = await copyLink();
  if (!left) return note("The link is on the clipboard; it holds the whole design.");
  const mark = (/** @type {any} */ e) => e.currentTarget.select();
  const box = {
    type: "text",
    readOnly: true,
    value: left,
    "aria-label": "Link",
    onFocus: mark,
    id: "link",
  };
  note([
    "This browser lets a page use the clipboard only over HTTPS. ",
    "The link, to be copied with Ctrl+C: ",
    h("input", box),
  ]);
  requestAnimationFrame(() => document.getElementById("link")?.focus());
}
function fileMenu() {
  const kept = otherDrafts();
  return [
    item("New drive", newDrive),
    item("Open a drive or lagging file …", choose),
    item("Download the drive file", download),
    item("Save in the database …", () => {
      turnTo("saved");
      redraw();
    }),
    item("Copy a link to this design", link_),
    item("Print", () => print()),
    h("p", { class: "help", key: "examples" }, "Examples"),
    app.catalogue.examples.map((x) => item(x.title, () => openExample(x.name))),
    kept.length > 0 && h("p", { class: "help", key: "drafts" }, "Drafts kept in this browser"),
    kept.map((d) => item(draftTitle(d), () => openDraft(d))),
    drafts().length > 0 &&
      item("Forget all drafts", () => {
        for (const d of drafts()) forgetDraft(d);
        redraw();
      }),
  ];
}
/** @type {[keyof typeof head, string][]} */
const HEADS = [
  ["project", "Project"],
  ["number", "Number"],
  ["revision", "Revision"],
  ["author", "Author"],
];
function reportMenu() {
  const put = (/** @type {keyof typeof head} */ k) => (/** @type {any} */ e) => {
    head[k] = e.currentTarget.value;
  };
  const papers = [
    ["a4", "A4"],
    ["us-letter", "US Letter"],
  ];
  const box = (/** @type {keyof typeof head} */ k) =>
    h("input", {
      type: "text",
      id: `head-${k}`,
      maxLength: 120,
      autocomplete: "off",
      onInput: put(k),
      value: head[k],
    });
  const make = (/** @type {string} */ kind) => () => {
    const filled = Object.entries(head).map(([k, v]) => [k, v.trim()]);
    return report(kind, Object.fromEntries(filled.filter(([, v]) => v)));
  };
  return [
    h(
      "div",
      { class: "stack pad", key: "head" },
      HEADS.map(([k, label]) => h("label", { key: k }, label, box(k))),
      h(
        "label",
        {},
        "Paper",
        h(
          "select",
          { id: "head-paper", value: head.paper, onChange: put("paper") },
          papers.map(([v, t]) => h("option", { value: v, key: v }, t)),
        ),
      ),
    ),
    item("Calculation note (PDF)", make("pdf")),
    item("Workbook (Excel)", make("xlsx")),
    item("Text (Markdown)", make("md")),
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
