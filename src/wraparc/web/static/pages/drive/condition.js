// The condition that the shown load case is solved in: where the file says it, and another.

import { app, besides, caseNames, get, look, set } from "../../base/design.js";
import { changeNaming } from "../../base/removed.js";
import { choose } from "../../parts/choose.js";
import { h } from "../../vendor/preact.js";
import { answer } from "./solving.js";

/** @import { Design, Path } from "../../types.d.ts" */

/** Name of a condition, whether it stands as a name or as a table. @param {any} c
 * @returns {string} */
export const called = (c) => c?.name ?? c;

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
export function go(doc, name) {
  app.case = caseNames(doc).includes(name) ? name : "";
  changeNaming(doc, ["name"]);
}
/** @param {number} i @param {string} name */
function put(i, name) {
  const { at, all, base } = held(i);
  if (!all.length) return changeNaming(set(app.doc, at, name), ["name"]);
  const shown = `${base}, ${name}`;
  if (all.some((c) => called(c) === name)) look({ case: shown });
  else go(set(app.doc, at, [...all, name]), shown);
}
/** The choice beside the lagging. @param {number} i */
export function switched(i) {
  const { row, all } = held(i);
  const usual = known(app.doc.pulley[i].lagging);
  const now = row == null ? usual[0] : called(row);
  const names = [...new Set([...usual, ...all.map(called), now])];
  if (names.length < 2) return null;
  const pick = choose(
    now,
    names.map((name) => [name, name]),
    (name) => put(i, name),
    "lagging-condition",
  );
  const label = h("label", { for: "lagging-condition", class: "away" }, "Condition of the lagging");
  return h("span", { class: "condition", key: "condition" }, label, pick);
}
/** Which load case of the file a pulley is shown in; -1 for that of the pulleys themselves.
 * @param {number} i */
export const shownCase = (i) => {
  const { base } = held(i);
  return (app.doc.load_case ?? []).findIndex((c) => c.name === base);
};
