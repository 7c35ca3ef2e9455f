// The load cases of a drive, and the load of the one that is shown.
import { app, caseNames, change, edit, look, set } from "../../base/design.js";
import { freeName, nameCheck, renameCase } from "../../base/names.js";
import { field, spec } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";
import { held } from "./condition.js";
import { group, isCase, loadRows, ownLoad } from "./inputs.js";
import { caseAt, follows, givenInCase, keysOf, takenOver } from "./load.js";

/** @import { Children, Design } from "../../types.d.ts" */

/** Which load case of the file a pulley is shown in; -1 for that of the pulleys themselves.
 * @param {number} i */
export function shownCase(i) {
  const { base } = held(i);
  return app.case ? (app.doc.load_case ?? []).findIndex((c) => c.name === base) : -1;
}
/** The load of a pulley in the load case that is shown. @param {number} i */
export function loadInCase(i) {
  const k = shownCase(i);
  if (k < 0) return ownLoad(i);
  const { doc } = app;
  const at = caseAt(doc, i, k);
  const keys = keysOf(doc, i, k);
  const over = (/** @type {string} */ key) => takenOver(doc, i, k, key);
  const give = (/** @type {string[]} */ pair) => change(givenInCase(app.doc, i, k, pair));
  const taken = keys.some(over);
  const from = isCase() ? 'the load case "design"' : "the pulley";
  const empty = follows(doc, i, k)
    ? `The other tension follows from ${from}: the take-up holds the sum of both.`
    : `What is left empty is that of ${from}.`;
  return group(
    `Load: ${doc.load_case?.[k].name}`,
    [...loadRows(at, keys, give, over), taken && h("p", { class: "help", key: "taken" }, empty)],
    "Load",
  );
}

/** One load case more, which is shown then. */
export function add() {
  const { load_case = [], train, pulley } = app.doc;
  const name = freeName("case", ["design", ...load_case.map((c) => c.name)]);
  const pulleys = train ? { train: {} } : { pulley: { [pulley[app.pulley].name || ""]: {} } };
  const doc = set(app.doc, ["load_case"], [...load_case, { name, ...pulleys }]);
  if (!train) app.case = first(doc, name);
  change(doc);
}
/** Back to what the load cases share, where that makes no load case. */
export const shared = () =>
  app.case && app.doc.load_case && !app.doc.train && !isCase()
    ? showing("Show the load that all share", "")
    : null;
/** A load case in the first condition that it is solved in.
 * @param {Design} doc @param {string} name */
const first = (doc, name) => caseNames(doc).find((x) => `${x}, `.startsWith(`${name}, `)) ?? "";
/** @param {string} text @param {string} name */
const showing = (text, name) =>
  h("button", { type: "button", key: "show", onClick: () => look({ case: name }) }, text);
/** What a load case is called and means. @param {number} k @returns {Children[]} */
export function inCase(k) {
  const { load_case = [], train } = app.doc;
  const others = ["design", ...load_case.filter((_, j) => j !== k).map((c) => c.name)];
  const remove = () => {
    edit(["load_case"], load_case.length > 1 ? load_case.filter((_, j) => j !== k) : undefined);
    document.getElementById("add-case")?.focus();
  };
  return [
    field({
      spec: spec("load_case", "name"),
      path: ["load_case", k, "name"],
      put: (to) => renameCase(k, to),
      check: nameCheck("load case", others),
    }),
    field({ spec: spec("load_case", "description"), path: ["load_case", k, "description"] }),
    !train && showing("Show and change its load", first(app.doc, load_case[k].name ?? "")),
    h("button", { type: "button", key: "remove", onClick: remove }, "Remove this case"),
  ];
}
