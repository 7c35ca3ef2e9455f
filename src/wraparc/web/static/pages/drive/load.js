// The same load given by two other numbers, found from those of the drive file alone.
import { set } from "../../base/design.js";
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
export const dimension = (key) => spec("tensions", key).dimension || "force";
/** @param {string} key @param {number} value */
export const tensionText = (key, value) => written(value, dimension(key), DIGITS);
/** @param {any} table */
export const pullsIn = (table) => tensionsBy((key) => si(table?.[key], dimension(key)));
/** @param {Design} doc @param {number} i @returns {Drum} */
const drumOf = (doc, i) => ({
  diameter: orNull(si(doc.pulley[i].diameter, "length")),
  speed: orNull(si(doc.belt.speed, "speed")),
});

/** Every quantity of the load that a table of tensions gives, nan where it does not say.
 * @param {Design} doc @param {number} i
 * @returns {(of: Tensions) => Load} */
export function loadOn(doc, i) {
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
export function caseOn(doc, i) {
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
export function caseOf(doc, i, k) {
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
export const ENDS = ["entry_tension", "exit_tension"];
/** Whether two loads have the same tensions. @param {Load} a
 * @param {Load} b */
export function alike(a, b) {
  const size = Math.max(...ENDS.map((key) => Math.abs(a[key])));
  return !Number.isFinite(size) || ENDS.every((key) => Math.abs(b[key] - a[key]) <= SAME * size);
}
/** A table of tensions without those that are given. @param {any} table */
export const without = (table) =>
  Object.fromEntries(Object.entries(table).filter(([key]) => !TENSIONS.includes(key)));

/**
 * A drive whose slack side is raised to at least a tension [N] in every load case, Te unchanged.
 * @param {Design} doc @param {number} i @param {number} least @returns {Design}
 */
export function raised(doc, i, least) {
  const all = loadOn(doc, i);
  const inCase = caseOn(doc, i);
  /** @param {Load} load */
  const lifted = (load) => {
    const lift = Math.max(0, least - Math.min(...ENDS.map((key) => load[key])));
    return Object.fromEntries(ENDS.map((key) => [key, load[key] + lift]));
  };
  /** Those tensions that a table gives, at what they are now. @param {any} table
   * @param {Load} now */
  const put = (table, now) => {
    const given = ENDS.filter((key) => table[key] != null);
    return {
      ...table,
      ...Object.fromEntries(given.map((key) => [key, tensionText(key, now[key])])),
    };
  };
  const pulley = doc.pulley[i];
  const before = pullsIn(pulley);
  const next = put(pulley, lifted(all(before)));
  let changed = set(doc, ["pulley", i], next);
  const name = pulley.name ?? "";
  (doc.load_case ?? []).forEach((/** @type {any} */ c, /** @type {number} */ k) => {
    const own = c.pulley?.[name] ?? {};
    const now = lifted(inCase(before, pullsIn(own)));
    const short = put(own, now);
    const same = alike(now, inCase(pullsIn(next), pullsIn(short)));
    const both = Object.fromEntries(ENDS.map((key) => [key, tensionText(key, now[key])]));
    const table = same ? short : { ...without(own), ...both };
    if (Object.keys(table).length) changed = set(changed, ["load_case", k, "pulley", name], table);
  });
  return changed;
}

/**
 * A drive with other tensions on pulley `i`, by the quantities that give its load: those of the
 * load case `k`, or of the pulley itself.
 * @param {Design} doc @param {number} i @param {number} k @param {number[]} ends [N]
 * @param {number} n digits @returns {Design}
 */
export function movedTo(doc, i, k, [entry, exit], n) {
  const { belt, pulley } = doc;
  const pull = entry - exit;
  const now = /** @type {Load} */ ({
    entry_tension: entry,
    exit_tension: exit,
    effective_tension: pull,
    power: pull * si(belt.speed, "speed"),
    torque: (pull * si(pulley[i].diameter, "length")) / 2,
  });
  const own = k < 0 ? pulley[i] : caseOf(doc, i, k).own;
  const before = k < 0 ? loadOn(doc, i)(pullsIn(own)) : caseOf(doc, i, k).now;
  const given = TENSIONS.filter((key) => own[key] != null);
  const moved = TENSIONS.filter(
    (key) => Math.abs(before[key] - now[key]) > SAME * Math.abs(now[key]),
  );
  const both = [...new Set([...given, ...ENDS.filter((key) => moved.includes(key))])];
  const keys = given.length > 1 ? given : both.length > 2 ? ENDS : both;
  const kept = keys.every((key) => key in own || moved.includes(key)) ? own : without(own);
  const told = (/** @type {string} */ key) => written(now[key], dimension(key), n);
  const changed = keys.filter((key) => kept[key] == null || moved.includes(key));
  const rest = keys === ENDS ? without(kept) : kept;
  const table = { ...rest, ...Object.fromEntries(changed.map((key) => [key, told(key)])) };
  return set(doc, k < 0 ? ["pulley", i] : caseAt(doc, i, k), table);
}
