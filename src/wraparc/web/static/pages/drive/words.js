// What the checks of the page come to, as the server tells it, and numbers in its digits.
import { app } from "../../base/design.js";
import { factor, LARGER_SI, LARGER_US, unit } from "../../base/units.js";
import { remarksOf as remarksOn, short, checkTable as tableOfChecks } from "../../reader.js";

/** @import { Bar, Level, Table, Units, Verdict } from "../../types.d.ts" */
/** @import { Judged } from "./judge.js" */

const NOT_CHECKED = "NOT CHECKED";
/** Units of speeds of slip. @type {Record<Units, [string, number]>} */
const SLIPS = { si: ["mm/s", 1e-3], us: ["in/s", 0.0254] };
const DIGITS = 3;

/** A number as the server prints it. @param {number} v @param {number} n */
export function printed(v, n) {
  if (Math.abs(v) < 1e-9) return "0"; // what is left of a difference of equal numbers
  const given = v.toExponential(3);
  const [, power] = given.split("e");
  const plain = (/** @type {number} */ e) => e >= -4 && e < 12;
  const whole = n <= 4 && Math.abs(+given - v) <= 1e-9 * Math.abs(v);
  if (whole && plain(+power)) return String(+given);
  const r = v.toExponential(n - 1);
  const e = +r.split("e")[1];
  if (!plain(e)) return r.replace(/e([+-])(\d)$/, "e$10$2");
  return (+r).toFixed(Math.max(0, n - 1 - e));
}
/** The value that shows as a result does, rounded to the safe side: upwards, or down.
 * @param {number} v @param {string} dimension @param {boolean} up */
export function onSafeSide(v, dimension, up) {
  const size = unit(dimension)[1];
  const number = v / size;
  if (!Number.isFinite(number) || Math.abs(number) < 1e-9) return v;
  const r = +printed(number, DIGITS);
  if (Math.abs(r - number) <= 1e-9 * Math.max(Math.abs(r), Math.abs(number))) return v;
  const step = 10 ** (+r.toExponential(3).split("e")[1] - DIGITS + 1);
  return size * (r < number === up ? r + (up ? step : -step) : r);
}
/** @param {number} v @param {string} dimension */
export function quantity(v, dimension, n = DIGITS) {
  if (Number.isNaN(v)) return "";
  if (!Number.isFinite(v)) return "without bound";
  if (dimension === "speed" && Math.abs(v) < 0.1) {
    const [name, size] = SLIPS[app.units];
    return `${printed(v / size, n)} ${name}`;
  }
  let [name, size] = unit(dimension);
  const big = (app.units === "us" ? LARGER_US : LARGER_SI)[dimension];
  if (big && Math.abs(+printed(v / size, n)) * size >= big[0])
    [name, size] = [big[1], factor(big[1], dimension) ?? 1];
  return `${printed(v / size, n)} ${name}`.trim();
}
/** @param {Judged} judged @param {string} [load_case] @param {string} [pulley] */
const verdictAt = ({ verdict, arcs }, load_case, pulley = arcs[0].pulley) =>
  load_case === undefined ? verdict : verdict.at(pulley, load_case);

/** The verdict on a drive, or on one of its load cases and pulleys. @param {Judged} judged
 * @param {string} [load_case] @param {string} [pulley]
 * @returns {Verdict & {levels: Record<string, Level>, short: string}} */
export function verdictOf(judged, load_case, pulley) {
  const verdict = verdictAt(judged, load_case, pulley);
  const { level, word, lead, others, listed } = verdict;
  const levels = listed
    .filter((/** @type {any} */ c) => c.level !== NOT_CHECKED)
    .map((/** @type {any} */ c) => [c.name, c.level]);
  return {
    level,
    told: word,
    headline: lead,
    sentences: [...others],
    short: shortOf(judged, verdict, load_case, pulley),
    levels: Object.fromEntries(levels),
  };
}
/** The answer in a few words; of a whole drive that of the arc that governs.
 * @param {Judged} judged @param {any} verdict @param {string} [load_case] @param {string} [pulley] */
function shortOf({ result, arcs }, verdict, load_case, pulley) {
  const place = load_case === undefined ? verdict.governing?.place : { load_case, pulley };
  const all = arcs.map((a, i) => ({ ...a, i }));
  const slips = load_case === undefined && all.find((a) => !a.solved);
  const one =
    slips ||
    all.find(
      (a) =>
        (!place?.load_case || place.load_case === a.load_case) &&
        (!place?.pulley || place.pulley === a.pulley),
    ) ||
    all[0];
  return short(result, resultsIn(result)[one.i]);
}
/** The arcs of a drive or a train as results. @param {any} result @returns {any[]} */
export const resultsIn = (result) => [...(result.arcs ?? result.drive_result().arcs)];

/** On what data an answer stands. @param {Judged} judged @returns {string[]} */
export const remarksOf = ({ of, verdict }) => remarksOn(of.drive, verdict);

/** The checks of one arc that have a value and a limit, as bars. @param {Judged} judged
 * @param {string} load_case @param {string} [pulley] @returns {Bar[]} */
export const barsOf = (judged, load_case, pulley) =>
  verdictAt(judged, load_case, pulley)
    .listed.filter((/** @type {any} */ c) => !Number.isNaN(c.share))
    .map((/** @type {any} */ c) => {
      const { title, level, at_most, share, reason } = c;
      const [found] = c.texts();
      const place = c.place.__str__();
      return {
        title,
        level,
        place,
        at_most,
        share,
        found,
        limit: c.bound(),
        says: reason,
        source: "",
      };
    });
/** The checks as a table. @param {Judged} judged */
export const checkTable = ({ verdict }) => tableOf(tableOfChecks(verdict), "checks");
/** A table of Python as the page shows one, in the units looked at.
 * @param {any} of @param {string} key @returns {Table} */
export function tableOf({ title, heads, note, rows }, key) {
  const both = (/** @type {any} */ v) => ({ si: v, us: v });
  const made = rows.map((/** @type {any} */ r) => ({ ...r, values: both([...r.values]) }));
  return { key, title, heads: both(heads), note, rows: made };
}
