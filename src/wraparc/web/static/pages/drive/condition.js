// The condition that the shown load case is solved in: where the file says it, and another.

import { app, besides, caseNames, change, get, look, set } from "../../base/design.js";
import { choose, oneOf } from "../../parts/choose.js";
import { h } from "../../vendor/preact.js";
import { answer } from "./solving.js";

/** @import { Design, Path } from "../../types.d.ts" */

/** Name of a condition, whether it stands as a name or as a table. @param {any} c
 * @returns {string} */
const called = (c) => c?.name ?? c;

/** What the shown load case of a pulley is solved in, and the key that says so; a load case goes
 * before the conditions side by side, they before a pulley, that before the drive.
 * @param {number} i */
export function held(i) {
  const { doc } = app;
  const names = caseNames(doc);
  const last = answer.quick?.load_case ?? "";
  const shown = app.case || (names.includes(last) ? last : names[0]);
  const k = doc.load_case?.findIndex((c) => c.condition && c.name === shown) ?? -1;
  const all = k < 0 ? besides(doc) : [];
  const own = doc.pulley[i].condition && !all.length;
  /** @type {Path} */
  const at = [...(k < 0 ? (own ? ["pulley", i] : []) : ["load_case", k]), "condition"];
  const row = all.find((c) => shown.endsWith(`, ${called(c)}`)) ?? [get(doc, at)].flat()[0];
  const end = all.length ? `, ${called(row)}` : "";
  return { at, row, all, shown, base: shown.slice(0, shown.length - end.length) };
}
/** Conditions that the friction of a lagging is known in, that of its first law first.
 * @param {any} of name or table @returns {string[]} */
function known(of) {
  const { laggings, published } = app.catalogue;
  const table = typeof of === "object" ? of : app.doc.lagging?.[of];
  const preset = laggings.find((l) => l.name === (table ? table.preset : of));
  const names = (/** @type {any} */ rows) =>
    [rows ?? []].flat().map((/** @type {any} */ r) => r?.condition ?? "dry");
  const tested = table?.law ? names(table.law) : (preset?.conditions ?? []);
  const there = published[table?.surface ?? preset?.surface] ?? [];
  const base = tested.includes("dry") ? "dry" : tested[0];
  const scaled = there.includes(base) ? there : [];
  return [...new Set([...tested, ...names(table?.condition_factor), ...scaled])];
}
/** Take a document in and look at a load case of it. @param {Design} doc @param {string} name */
function go(doc, name) {
  app.case = caseNames(doc).indexOf(name) > 0 ? name : "";
  change(doc);
}
/** @param {number} i @param {string} name */
function put(i, name) {
  const { at, all, base } = held(i);
  if (!all.length) return change(set(app.doc, at, name));
  const shown = `${base}, ${name}`;
  if (all.some((c) => called(c) === name)) look({ case: shown });
  else go(set(app.doc, at, [...all, name]), shown);
}
/** The switch beside the lagging. @param {number} i */
export function switched(i) {
  const { at, row, all, shown } = held(i);
  const usual = known(app.doc.pulley[i].lagging);
  const now = row == null ? usual[0] : called(row);
  const names = [...new Set([...usual, ...all.map(called), now])];
  if (names.length < 2) return null;
  const alone = { pulley: "this pulley", load_case: `load case ${shown}` }[at[0]];
  const several = app.doc.pulley.length > 1 && "Of all pulleys.";
  const beside = all.length && `Every load case in ${all.map(called).join(" and ")}; shown is one.`;
  const note = alone ? `Of ${alone} alone.` : beside || several;
  return h(
    "div",
    { class: "field wide", key: "condition" },
    h("span", {}, "Condition"),
    oneOf(
      "lagging-condition",
      "Condition of the lagging",
      now,
      names.map((name) => [name, name]),
      (name) => put(i, name),
      "switch box",
    ),
    note && h("p", { class: "help" }, note),
    alone &&
      h(
        "button",
        { type: "button", onClick: () => change(set(app.doc, at, undefined)) },
        "Take that of the drive",
      ),
  );
}

/** Conditions that published values cover, side by side. */
const SEVERAL = [
  ["dry", "wet"],
  ["dry", "wet", "wet and dirty"],
];
/** Whether every load case is solved in one condition, or in several. @param {number} i */
export function sideBySide(i) {
  const { row, base, at } = held(i);
  const now = besides(app.doc);
  const known = SEVERAL.findIndex((names) => JSON.stringify(names) === JSON.stringify(now));
  const put = (/** @type {string} */ k) => {
    const names = SEVERAL[+k - 1];
    const main = at.length > 1 ? now[0] : row;
    const seen = names?.includes(called(row)) ? called(row) : names?.[0];
    go(
      set(app.doc, ["condition"], names ?? main),
      at[0] === "load_case" || !names ? base : `${base}, ${seen}`,
    );
  };
  return h(
    "div",
    { class: "field", key: "condition" },
    h("label", { for: "condition" }, "Solved in"),
    h("span", {}),
    h(
      "span",
      { class: "box" },
      choose(
        now.length ? known + 1 || "own" : 0,
        [
          [0, "the condition of the lagging"],
          ...SEVERAL.map((c, k) => /** @type {[number, string]} */ ([k + 1, c.join(" | ")])),
          ...(now.length && known < 0
            ? [/** @type {[string, string]} */ (["own", "as in the file"])]
            : []),
        ],
        put,
        "condition",
      ),
    ),
  );
}
