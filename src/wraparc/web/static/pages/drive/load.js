// The same load given by two other numbers, found from those of the drive file alone.
import { set } from "../../base/design.js";
import { note } from "../../base/server.js";
import { si, written } from "../../base/units.js";
import {
  tension_rules__ends_of as endsOf,
  tension_rules__overdetermined as overdetermined,
  tension_rules__overridden as overridden,
  tension_rules__pull_given as pullOf,
} from "../../kernel.js";
import { spec } from "../../parts/field.js";
import { NO_RUNS, orNull, TENSIONS, tensionsBy } from "../../parts/problems.js";

/** @import { Design, Path } from "../../types.d.ts" */
/** @import { Drum, Tensions } from "../../parts/problems.js" */
/** @typedef {Record<string, number>} Load quantities by their keys [SI], nan where not given */

const DIGITS = 9;
const SAME = 1e-6; // of the tensions: what so many digits leave
/** @param {string} key */
const dimension = (key) => spec("tensions", key).dimension || "force";
/** @param {string} key @param {number} value */
const text = (key, value) => written(value, dimension(key), DIGITS);
/** @param {any} table */
const pullsIn = (table) => tensionsBy((key) => si(table?.[key], dimension(key)));
/** @param {Design} doc @param {number} i @returns {Drum} */
const drumOf = (doc, i) => ({
  diameter: orNull(si(doc.pulley[i].diameter, "length")),
  speed: orNull(si(doc.belt.speed, "speed")),
});

/** Every quantity of the load that a table of tensions gives, nan where it does not say.
 * @param {Design} doc @param {number} i
 * @returns {(of: Tensions) => Load} */
function loadOn(doc, i) {
  const drum = drumOf(doc, i);
  return (of) => {
    const { entry, exit } = endsOf(of, drum);
    const pull = entry === null || exit === null ? pullOf(of, drum) : entry - exit;
    return {
      entry_tension: entry ?? none,
      exit_tension: exit ?? none,
      effective_tension: pull ?? none,
      power: (pull ?? none) * (drum.speed ?? none),
      torque: ((pull ?? none) * (drum.diameter ?? none)) / 2,
    };
  };
}
const none = Number.NaN;
const NONE = Object.fromEntries(TENSIONS.map((key) => [key, none]));
/** What a load case makes of the tensions of its pulley: nothing, where with them too much is
 * given. @param {Design} doc @param {number} i
 * @returns {(of: Tensions, over: Tensions) => Load} */
function caseOn(doc, i) {
  const drum = drumOf(doc, i);
  const all = loadOn(doc, i);
  const fixed = doc.take_up?.kind === "fixed";
  return (of, over) => {
    const found = overridden(of, over, fixed, drum, NO_RUNS);
    return overdetermined(found) ? NONE : all(found);
  };
}
/** The tensions that a load case gives at a pulley, and what they come to with those of the pulley.
 * @param {Design} doc @param {number} i @param {number} k */
function caseOf(doc, i, k) {
  const inCase = caseOn(doc, i);
  const base = pullsIn(doc.pulley[i]);
  const own = doc.load_case?.[k].pulley?.[doc.pulley[i].name ?? ""] ?? {};
  return { own, now: inCase(base, pullsIn(own)), fixed: doc.take_up?.kind === "fixed" };
}
/** Where the tensions of a pulley in a load case stand. @param {Design} doc @param {number} i
 * @param {number} k @returns {Path} */
export const caseAt = (doc, i, k) => ["load_case", k, "pulley", doc.pulley[i].name ?? ""];
const isPull = (/** @type {string} */ key) => !ENDS.includes(key);
/** Whether a load case gives its pull alone, and a fixed take-up the tensions for it.
 * @param {Design} doc @param {number} i @param {number} k */
export function follows(doc, i, k) {
  const { own, fixed } = caseOf(doc, i, k);
  const given = TENSIONS.filter((key) => own[key] != null);
  return fixed && given.length === 1 && isPull(given[0]);
}
/** The quantities that the load of a case follows from: its own, and those taken over.
 * @param {Design} doc @param {number} i @param {number} k */
export function keysOf(doc, i, k) {
  const { own } = caseOf(doc, i, k);
  const given = TENSIONS.filter((key) => own[key] != null);
  if (given.length > 1) return given;
  const pull = given.some(isPull);
  const taken = TENSIONS.filter((key) => doc.pulley[i][key] != null && !(pull && isPull(key)));
  const kept = follows(doc, i, k) ? taken.slice(0, 1) : taken; // one tension tells the other
  return TENSIONS.filter((key) => given.includes(key) || kept.includes(key));
}
/** What a quantity is that a load case takes over, as a text; none where it gives its own.
 * @param {Design} doc @param {number} i @param {number} k @param {string} key */
export function takenOver(doc, i, k, key) {
  const { own, now } = caseOf(doc, i, k);
  return own[key] == null && Number.isFinite(now[key]) ? written(now[key], dimension(key)) : "";
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
  const both = Object.fromEntries(known.map((key) => [key, own[key] ?? text(key, now[key])]));
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
    if (next[key] == null && Number.isFinite(now[key])) next[key] = text(key, now[key]);
  if (Number.isFinite(now.effective_tension) && lacks(next, keys)) return doc;
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
