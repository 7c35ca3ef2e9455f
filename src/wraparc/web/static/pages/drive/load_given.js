// The same load given by two other numbers.
import { set } from "../../base/design.js";
import { note } from "../../base/server.js";
import { TENSIONS } from "../../parts/problems.js";
import {
  alike,
  caseAt,
  caseOf,
  caseOn,
  ENDS,
  loadOn,
  pullsIn,
  tensionText,
  without,
} from "./load.js";

/** @import { Design } from "../../types.d.ts" */

/** Whether a table cannot give what it is to; says what that takes.
 * @param {any} table @param {string[]} keys */
function lacks(table, keys) {
  const lacking = keys.some((key) => table[key] == null);
  if (lacking)
    note(`It takes ${keys.includes("power") ? "the belt speed" : "the diameter"} to say so.`);
  return lacking;
}
/** A drive with one load case given by two quantities, its load as it was.
 * @param {Design} doc @param {number} i @param {number} k @param {string[]} keys
 * @returns {Design} */
export function givenInCase(doc, i, k, keys) {
  const { own, now } = caseOf(doc, i, k);
  const known = keys.filter((key) => own[key] != null || Number.isFinite(now[key]));
  const both = Object.fromEntries(
    known.map((key) => [key, own[key] ?? tensionText(key, now[key])]),
  );
  return Number.isFinite(now.effective_tension) && lacks(both, keys)
    ? doc
    : set(doc, caseAt(doc, i, k), { ...without(own), ...both });
}

/**
 * A drive whose pulley `i` has its load by the quantities `keys`, as it was. A load case that takes
 * one of them over from the pulley gets both of its tensions, where it would change.
 * @param {Design} doc @param {number} i @param {string[]} keys @returns {Design}
 */
export function givenBy(doc, i, keys) {
  const all = loadOn(doc, i);
  const inCase = caseOn(doc, i);
  const pulley = doc.pulley[i];
  const before = pullsIn(pulley);
  const now = all(before);
  const next = { ...pulley };
  for (const key of TENSIONS) if (!keys.includes(key)) delete next[key];
  for (const key of keys)
    if (next[key] == null && Number.isFinite(now[key])) next[key] = tensionText(key, now[key]);
  if (Number.isFinite(now.effective_tension) && lacks(next, keys)) return doc;
  let changed = set(doc, ["pulley", i], next);
  const name = pulley.name ?? "";
  (doc.load_case ?? []).forEach((/** @type {any} */ c, /** @type {number} */ k) => {
    const own = c.pulley?.[name];
    if (!TENSIONS.some((key) => own?.[key] != null)) return;
    const over = pullsIn(own);
    const was = inCase(before, over);
    if (alike(was, inCase(pullsIn(next), over))) return;
    const both = Object.fromEntries(
      ENDS.map((key) => [key, own[key] ?? tensionText(key, was[key])]),
    );
    changed = set(changed, ["load_case", k, "pulley", name], { ...without(own), ...both });
  });
  return changed;
}
