// Designs kept in the database: names, notes, versions, who and when.

import { turnTo } from "../base/address.js";
import { app, look, redraw } from "../base/design.js";
import { open } from "../base/drafts.js";
import { Advice, act, ask, complain, later, note, onReturn, Refused } from "../base/server.js";
import { timeOf } from "../base/units.js";
import { scroll } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { differences, differenceTable } from "./saved/differences.js";

/** @import { Difference } from "./saved/differences.js" */
/**
 * @typedef {{version: number, created: string, who: string, note: string}} Version
 * @typedef {{id: string, name: string, kind: string, versions: number, changed: string,
 *   who: string, note: string}} Entry
 * @typedef {Version & {id: string, found: Difference[]}} Conflict
 */

const state = {
  name: "",
  note: "",
  who: "",
  find: "",
  bin: false,
  designs: /** @type {Entry[] | null} */ (null),
  open: /** @type {{id: string, versions: Version[]} | null} */ (null),
  /** What differs between two versions of the design that is open in the list. */
  changes: /** @type {{of: number, found: Difference[], names: [string, string]} | null} */ (null),
  /** What somebody else has saved since the design was opened, and how it differs. */
  conflict: /** @type {Conflict | null} */ (null),
  /** Which design the name in the box is of. */
  of: /** @type {string | undefined} */ (undefined),
};
try {
  state.who = localStorage.getItem("who") || "";
} catch {
  /* a browser that keeps nothing: the name is typed each time */
}

let listed = false;
export function update() {
  const of = `${app.design?.id ?? app.opened}`;
  if (state.of !== of || !state.name) {
    state.of = of;
    state.name = app.design?.name || app.doc.title || app.name || "";
  }
  if (!listed) load();
  listed = true;
}
onReturn(() => {
  listed = false; // it may not have come, or be another by now
});
let asked = 0;
async function load() {
  const turn = ++asked;
  try {
    const query = encodeURIComponent(state.find);
    const { designs } = await ask(`designs?query=${query}&limit=200&bin=${state.bin}`);
    if (turn !== asked) return; // the list that was asked for last is shown
    state.designs = designs;
    redraw();
  } catch (x) {
    complain(x);
  }
}
const find = later(200, load);
/** @param {{id: string, version: number}} d @param {string} name */
async function saved(d, name) {
  const design = { id: d.id, version: d.version, name, saved: JSON.stringify(app.doc) };
  Object.assign(state, { note: "", of: d.id, name, conflict: null });
  try {
    localStorage.setItem("who", state.who);
  } catch {
    /* as above */
  }
  look({ design });
  const without = app.source?.toml.includes("#") ? " The comments of its file are not saved." : "";
  note(`Saved as version ${d.version} of “${name}”.${without}`);
  await load();
}
const body = () => ({ document: app.doc, note: state.note.trim(), who: state.who.trim() });
async function saveNew() {
  const name = state.name.trim();
  if (!name) {
    document.getElementById("design-name")?.focus();
    throw new Advice("The design needs a name.");
  }
  await saved(await ask("designs", { name, ...body() }), name);
}
/** @param {number} [base] the version that this one is made from */
async function saveVersion(base) {
  if (!app.design) return;
  const { id, version, name } = app.design;
  const now = state.name.trim() || name;
  try {
    // in one request: a version that is refused renames nothing
    const asked = { ...body(), name: now, base: base ?? version };
    await saved(await ask(`designs/${id}/versions`, asked), now);
  } catch (x) {
    if (!(x instanceof Refused) || x.status !== CONFLICT) throw x;
    await conflicts(id);
  }
}
const CONFLICT = 409;
/** Who has saved meanwhile, and in what both differ. @param {string} id */
async function conflicts(id) {
  const { versions } = await ask(`designs/${id}`);
  const newest = /** @type {Version} */ (versions.at(-1));
  const { document } = await ask(`designs/${id}/versions/${newest.version}`);
  state.conflict = { ...newest, id, found: differences(document, app.doc) };
  redraw();
  focusConflict();
}
const focusConflict = () =>
  requestAnimationFrame(() => document.getElementById("conflict")?.focus());
/** The second of two who save: both are shown, and both are saved. */
function conflict() {
  const c = state.conflict;
  if (!c || app.design?.id !== c.id) return null;
  const press = (/** @type {string} */ text, /** @type {() => any} */ f, cls = "") =>
    h("button", { type: "button", class: cls, key: text, onClick: act(f) }, text);
  const [mine, theirs] = [`Save mine as version ${c.version + 1}`, `Open version ${c.version}`];
  const others = { id: c.id, name: app.design.name };
  return h(
    "section",
    { class: "card", id: "conflict", tabIndex: -1, role: "alert", key: "conflict" },
    h("h2", {}, `${c.who || "Somebody"} saved version ${c.version} meanwhile`),
    h(
      "p",
      {},
      `${timeOf(c.created)}${c.note ? `: ${c.note}` : ""}. Yours began from version `,
      `${app.design.version}. Both are saved as versions.`,
    ),
    differenceTable(c.found, `version ${c.version}`, "yours"),
    h(
      "p",
      { class: "bar" },
      press(mine, () => saveVersion(c.version), "main"),
      press("Save as a new design", saveNew),
      press(theirs, () => reopen(/** @type {Entry} */ (others), c.version)),
    ),
  );
}
/** @param {Entry} d @param {number} version */
async function reopen(d, version) {
  const v = await ask(`designs/${d.id}/versions/${version}`);
  const design = { id: d.id, version: v.version, name: d.name, saved: JSON.stringify(v.document) };
  state.conflict = null;
  open(v.document, { name: v.name || d.name, design });
  note(`Opened version ${v.version} of “${d.name}”.`);
  turnTo("drive");
  redraw();
}
/** @param {Entry} d */
async function versions(d) {
  const shut = state.open?.id === d.id;
  state.changes = null;
  state.open = shut ? null : { id: d.id, versions: (await ask(`designs/${d.id}`)).versions };
  redraw();
}
/** What a version changed, or what was changed since the newest one and is not saved.
 * @param {Entry} d @param {number} version 0 for what is not saved */
async function changes(d, version) {
  const shut = state.changes?.of === version;
  state.changes = null;
  if (!shut) {
    const of = (/** @type {number} */ n) => ask(`designs/${d.id}/versions/${n}`);
    const from = version ? version - 1 : (app.design?.version ?? 1);
    const [before, after] = await Promise.all([of(from), version ? of(version) : null]);
    state.changes = {
      of: version,
      found: differences(before.document, after?.document ?? app.doc),
      names: [`version ${from}`, version ? `version ${version}` : "the present design"],
    };
  }
  redraw();
}
/** @param {Entry} d */
async function throwAway(d) {
  await ask(`designs/${d.id}`, undefined, { method: "DELETE" });
  if (app.design?.id === d.id) look({ design: null });
  note(`“${d.name}” is in the bin.`);
  await load();
  document.getElementById("find-design")?.focus();
}
/** @param {Entry} d */
async function takeBack(d) {
  await ask(`designs/${d.id}/restore`, undefined, { method: "POST" });
  note(`“${d.name}” is back.`);
  await load();
}
/** @param {Entry} d */
async function remove(d) {
  const all = `${d.versions} version${d.versions > 1 ? "s" : ""}`;
  if (!confirm(`Delete “${d.name}” with its ${all}? This cannot be undone.`)) return;
  await ask(`designs/${d.id}?final=true`, undefined, { method: "DELETE" });
  await load();
}

export const Page = () => [form(), conflict(), designs()];
function form() {
  const button = (/** @type {string} */ text, /** @type {() => any} */ f, main = false) =>
    h("button", { type: "button", class: main ? "main" : "", key: text, onClick: act(f) }, text);
  return h(
    "form",
    {
      class: "card",
      "aria-label": "Save the present design",
      onSubmit: (e) => e.preventDefault(),
      key: "form",
    },
    h("h2", {}, "Save the present design"),
    h(
      "div",
      { class: "bar" },
      input("Name", "name", { id: "design-name", maxLength: 120, required: true, size: 28 }),
      input("Note on this version", "note", { maxLength: 1000, size: 34 }),
      input("Who", "who", { maxLength: 80, size: 14 }),
      app.design && button("Save a new version", () => saveVersion(), true),
      button("Save as a new design", saveNew, !app.design),
    ),
    h("p", { class: "help", role: "status" }, stateText()),
  );
}
function stateText() {
  const d = app.design;
  if (!d) return "Not saved in the database yet.";
  const changed = d.saved && d.saved !== JSON.stringify(app.doc) ? ", changed since" : "";
  return `This is version ${d.version} of “${d.name}”${changed}.`;
}
/** @param {string} text @param {"name" | "note" | "who"} key @param {Record<string, any>} more */
const input = (text, key, more) =>
  h(
    "label",
    { key },
    text,
    h("input", {
      type: "text",
      value: state[key],
      ...more,
      onInput: (e) => {
        state[key] = e.currentTarget.value;
      },
    }),
  );
function designs() {
  const search = {
    type: "search",
    id: "find-design",
    value: state.find,
    onInput: (/** @type {any} */ e) => {
      state.find = e.currentTarget.value;
      find();
    },
  };
  const bin = {
    type: "checkbox",
    checked: state.bin,
    onChange: act((/** @type {any} */ e) => {
      state.bin = e.target.checked;
      return load();
    }),
  };
  return h(
    "section",
    { class: "card", "aria-label": "Saved designs", key: "designs" },
    h(
      "div",
      { class: "bar" },
      h("h2", {}, "Saved designs"),
      h("label", {}, "Find", h("input", search)),
      h("label", {}, h("input", bin), " Bin"),
    ),
    scroll("List of saved designs", state.designs && listing(state.designs)),
  );
}
/** @param {Entry[]} designs */
function listing(designs) {
  if (!designs.length)
    return h(
      "p",
      { class: "help" },
      state.find
        ? "No saved design has this in its name."
        : state.bin
          ? "The bin is empty."
          : "Nothing saved yet.",
    );
  const heads = ["Name", "Kind", "Versions", "Changed", "By", "Newest note"];
  return h(
    "table",
    { class: "grid-table" },
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        heads.map((t) => h("th", { scope: "col", key: t }, t)),
        h("td", {}),
      ),
    ),
    h(
      "tbody",
      {},
      designs.flatMap((d) => [entry(d), state.open?.id === d.id && versionRow(d)]),
    ),
  );
}
/** @param {Entry} d */
function entry(d) {
  const press = (
    /** @type {string} */ word,
    /** @type {string} */ name,
    /** @type {() => any} */ f,
  ) =>
    h(
      "button",
      { type: "button", "aria-label": `${name} ${d.name}`, onClick: act(f), key: word },
      word,
    );
  return h(
    "tr",
    { key: d.id },
    h("th", { scope: "row" }, d.name),
    h("td", {}, d.kind),
    h("td", {}, String(d.versions)),
    h("td", {}, timeOf(d.changed)),
    h("td", {}, d.who || "–"),
    h("td", { class: "remark" }, d.note || ""),
    h(
      "td",
      { class: "inline" },
      ...(state.bin
        ? [
            press("Restore", "Restore", () => takeBack(d)),
            press("Delete", "Delete for good", () => remove(d)),
          ]
        : [
            press("Open", "Open", () => reopen(d, d.versions)),
            press("Versions", "Versions of", () => versions(d)),
            press("Delete", "Delete", () => throwAway(d)),
          ]),
    ),
  );
}
/** @param {Entry} d */
function versionRow(d) {
  const press = (/** @type {string} */ word, /** @type {string} */ name, /** @type {any} */ f) =>
    h("button", { type: "button", "aria-label": name, onClick: act(f), key: word }, word);
  /** @param {number} version @param {string} name */
  const changed = (version, name) => [
    press("Changes", `Changes of ${name} of ${d.name}`, () => changes(d, version)),
    state.changes?.of === version && differenceTable(state.changes.found, ...state.changes.names),
  ];
  const items = [...(state.open?.versions || [])].reverse().map((v) => {
    const by = `${v.who ? `, ${v.who}` : ""}${v.note ? `: ${v.note}` : ""} `;
    const name = `version ${v.version}`;
    return h(
      "li",
      { key: v.version },
      `Version ${v.version}, ${timeOf(v.created)}${by}`,
      press("Open", `Open ${name} of ${d.name}`, () => reopen(d, v.version)),
      " ",
      v.version > 1 && changed(v.version, name),
    );
  });
  const unsaved = app.design?.id === d.id && app.design.saved !== JSON.stringify(app.doc);
  return h(
    "tr",
    { class: "versions", key: `${d.id}-versions` },
    h(
      "td",
      { colSpan: 7 },
      h(
        "ul",
        {},
        unsaved &&
          h("li", { key: 0 }, "The present design, not saved ", changed(0, "the present design")),
        items,
      ),
    ),
  );
}
