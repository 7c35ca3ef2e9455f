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

const DIGITS = 9;
const SAME = 1e-6; // of the tensions: what so many digits leave
/** @param {string} key */
const dimension = (key) => spec("tensions", key).dimension || "force";
/** @param {string} key @param {number} value */
const text = (key, value) => written(value, dimension(key), DIGITS);
/** @param {any} table @returns {Record<string, number>} */
const pullsIn = (table) =>
  Object.fromEntries(TENSIONS.map((key) => [key, si(table?.[key], dimension(key))]));

/**
 * A drive whose pulley `i` has its load by the quantities `keys`, as it was. A load case that takes
 * one of them over from the pulley gets both of its tensions, where it would change.
 * @param {Design} doc @param {number} i @param {string[]} keys @returns {Design}
 */
export function givenBy(doc, i, keys) {
  const pulley = doc.pulley[i];
  const diameter = si(pulley.diameter, "length");
  const speed = si(doc.belt.speed, "speed");
  const fixed = doc.take_up?.kind === "fixed";
  /** @param {any} of @returns {Record<string, number>} */
  const all = (of) => {
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
    const was = all(overridden(before, over, fixed, diameter, speed));
    const is = all(overridden(pullsIn(next), over, fixed, diameter, speed));
    const ends = ["entry_tension", "exit_tension"];
    const size = Math.max(...ends.map((key) => Math.abs(was[key])));
    if (!Number.isFinite(size) || ends.every((key) => Math.abs(is[key] - was[key]) <= SAME * size))
      return;
    const both = Object.fromEntries(ends.map((key) => [key, own[key] ?? text(key, was[key])]));
    const rest = Object.fromEntries(Object.entries(own).filter(([key]) => !TENSIONS.includes(key)));
    changed = set(changed, ["load_case", k, "pulley", name], { ...rest, ...both });
  });
  return changed;
}
