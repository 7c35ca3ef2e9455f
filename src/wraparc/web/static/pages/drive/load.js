// The same load given by two other numbers, found from those of the drive file alone.
import { set } from "../../base/design.js";
import { note } from "../../base/server.js";
import { si, written } from "../../base/units.js";
import {
  pulls__both_tensions as bothOf,
  pulls__overridden as overridden,
  pulls__pull_given as pullOf,
} from "../../kernel.js";
import { spec } from "../../parts/field.js";
import { TENSIONS } from "../../parts/problems.js";

/** @import { Design } from "../../types.d.ts" */
/** @typedef {Record<string, number>} Load quantities by their keys [SI], nan where not given */

const DIGITS = 9;
const SAME = 1e-6; // of the tensions: what so many digits leave
/** @param {string} key */
const dimension = (key) => spec("tensions", key).dimension || "force";
/** @param {string} key @param {number} value */
const text = (key, value) => written(value, dimension(key), DIGITS);
/** @param {any} table @returns {Record<string, number>} */
const pullsIn = (table) =>
  Object.fromEntries(TENSIONS.map((key) => [key, si(table?.[key], dimension(key))]));

/** Every quantity of the load that a table of tensions gives, nan where it does not say.
 * @param {Design} doc @param {number} i
 * @returns {(of: Load) => Load} */
function loadOn(doc, i) {
  const diameter = si(doc.pulley[i].diameter, "length");
  const speed = si(doc.belt.speed, "speed");
  return (of) => {
    const ends = of.entry_tension - of.exit_tension;
    const pull = Number.isNaN(ends) ? pullOf(of, diameter, speed) : ends;
    const both = bothOf(of, diameter, speed);
    return {
      entry_tension: (both + pull) / 2,
      exit_tension: (both - pull) / 2,
      effective_tension: pull,
      power: pull * speed,
      torque: (pull * diameter) / 2,
    };
  };
}
/** What a load case makes of the tensions of its pulley. @param {Design} doc @param {number} i
 * @returns {(of: Load, over: Load) => Load} */
function caseOn(doc, i) {
  const diameter = si(doc.pulley[i].diameter, "length");
  const speed = si(doc.belt.speed, "speed");
  const all = loadOn(doc, i);
  const fixed = doc.take_up?.kind === "fixed";
  return (of, over) => all(overridden(of, over, fixed, diameter, speed));
}
const ENDS = ["entry_tension", "exit_tension"];
/** Whether two loads have the same tensions. @param {Load} a
 * @param {Load} b */
function alike(a, b) {
  const size = Math.max(...ENDS.map((key) => Math.abs(a[key])));
  return !Number.isFinite(size) || ENDS.every((key) => Math.abs(b[key] - a[key]) <= SAME * size);
}
/** A table of tensions without those that are given. @param {any} table */
const without = (table) =>
  Object.fromEntries(Object.entries(table).filter(([key]) => !TENSIONS.includes(key)));

/**
 * A drive whose slack side is raised to at least a tension [N], in every load case or in one alone,
 * each pulling as it does.
 * @param {Design} doc @param {number} i @param {number} least
 * @param {string} [only] the load case, by its name @returns {Design}
 */
export function raised(doc, i, least, only) {
  const all = loadOn(doc, i);
  const inCase = caseOn(doc, i);
  /** @param {Load} load @param {string} name */
  const lifted = (load, name) => {
    const slack = Math.min(...ENDS.map((key) => load[key]));
    const lift = only === undefined || only === name ? Math.max(0, least - slack) : 0;
    return Object.fromEntries(ENDS.map((key) => [key, load[key] + lift]));
  };
  /** Those tensions that a table gives, at what they are now. @param {any} table
   * @param {Load} now */
  const put = (table, now) => {
    const given = ENDS.filter((key) => table[key] != null);
    return { ...table, ...Object.fromEntries(given.map((key) => [key, text(key, now[key])])) };
  };
  const pulley = doc.pulley[i];
  const before = pullsIn(pulley);
  const next = put(pulley, lifted(all(before), "design"));
  let changed = set(doc, ["pulley", i], next);
  const name = pulley.name ?? "";
  (doc.load_case ?? []).forEach((/** @type {any} */ c, /** @type {number} */ k) => {
    const own = c.pulley?.[name] ?? {};
    const now = lifted(inCase(before, pullsIn(own)), c.name);
    const short = put(own, now);
    const same = alike(now, inCase(pullsIn(next), pullsIn(short)));
    const both = Object.fromEntries(ENDS.map((key) => [key, text(key, now[key])]));
    const table = same ? short : { ...without(own), ...both };
    if (Object.keys(table).length) changed = set(changed, ["load_case", k, "pulley", name], table);
  });
  return changed;
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
    if (next[key] == null && Number.isFinite(now[key])) next[key] = text(key, now[key]);
  if (Number.isFinite(now.effective_tension) && keys.some((key) => next[key] == null)) {
    note(`It takes ${keys.includes("power") ? "the belt speed" : "the diameter"} to say so.`);
    return doc;
  }
  let changed = set(doc, ["pulley", i], next);
  const name = pulley.name ?? "";
  (doc.load_case ?? []).forEach((/** @type {any} */ c, /** @type {number} */ k) => {
    const own = c.pulley?.[name];
    if (!TENSIONS.some((key) => own?.[key] != null)) return;
    const over = pullsIn(own);
    const was = inCase(before, over);
    if (alike(was, inCase(pullsIn(next), over))) return;
    const both = Object.fromEntries(ENDS.map((key) => [key, own[key] ?? text(key, was[key])]));
    changed = set(changed, ["load_case", k, "pulley", name], { ...without(own), ...both });
  });
  return changed;
}
