// What the checks of the page come to, as the server tells it: texts with slots for their numbers.
import {
  orderIn,
  remarksOf as remarksOn,
  short,
  checkTable as tableOfChecks,
} from "../../reader.js";

/** @import { Bar, Level, Table, Verdict } from "../../types.d.ts" */
/** @import { Judged } from "./judge.js" */

const NOT_CHECKED = "NOT CHECKED";
/** @param {Judged} judged @param {string} [load_case] @param {string} [pulley] */
const verdictAt = ({ verdict }, load_case, pulley) =>
  load_case === undefined
    ? verdict
    : pulley === undefined
      ? verdict.within(load_case)
      : verdict.at(pulley, load_case);

/** The verdict on a drive, or on one of its load cases, and pulleys. @param {Judged} judged
 * @param {string} [load_case] @param {string} [pulley]
 * @returns {Verdict & {levels: Record<string, Level>, short: string, order: number,
 *   cause: Cause}}
 * @typedef {{name: string, label: string, load_case: string, found: string}} Cause what governs,
 *   and what it comes to */
export function verdictOf(judged, load_case, pulley) {
  const verdict = verdictAt(judged, load_case, pulley);
  const { level, label, text, wet_text, data, listed } = verdict;
  const worst = verdict.governing;
  const action = (verdict.kind_in_doubt ?? worst)?.action_text;
  const levels = listed
    .filter((/** @type {any} */ c) => c.level !== NOT_CHECKED)
    .map((/** @type {any} */ c) => [c.name, c.level]);
  return {
    level,
    label,
    text,
    action: action ? { text: action, ways: [] } : null,
    also: [...verdict.also].map(alsoOf),
    wet: wet_text ? { text: wet_text } : null,
    data: { text: data.text },
    sentences: [...verdict.full],
    short: shortOf(judged, verdict, load_case, pulley),
    order: orderIn(verdict),
    cause: causeOf(worst),
    levels: Object.fromEntries(levels),
  };
}
/** @param {any} check @returns {Cause} */
const causeOf = (check) => ({
  name: check?.name ?? "",
  label: check?.label ?? "",
  load_case: check?.place.load_case ?? "",
  found: check && !Number.isNaN(check.share) ? check.texts()[0] : "",
});
/** A further check that is missed, without what else it is. @param {any} check */
const alsoOf = ({ level, name, text }) => ({ level, name, text });
/** The answer in a few words; of a whole drive that of the arc that governs.
 * @param {Judged} judged @param {any} verdict @param {string} [load_case]
 * @param {string} [pulley] */
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
export const resultsIn = (result) => [...driveIn(result).arcs];
/** @param {any} result of a drive, or of a train */
export const driveIn = (result) => (result.arcs ? result : result.drive_result());

/** On what data an answer stands. @param {Judged} judged @returns {string[]} */
export const remarksOf = ({ of, verdict }) => remarksOn(of.drive, verdict);

/** The checks of one arc that have a value and a limit, as bars. @param {Judged} judged
 * @param {string} load_case @param {string} [pulley] @returns {Bar[]} */
export const barsOf = (judged, load_case, pulley) =>
  verdictAt(judged, load_case, pulley)
    .listed.filter((/** @type {any} */ c) => !Number.isNaN(c.share))
    .map((/** @type {any} */ c) => {
      const { name, value, title, level, at_most, share, missed, text } = c;
      const [found, limit] = c.texts();
      const place = c.place.__str__();
      return {
        name,
        value,
        title,
        level,
        place,
        at_most,
        share,
        ...{ found, limit },
        says: missed ? text : "",
        source: "",
      };
    });
/** The checks as a table. @param {Judged} judged */
export const checkTable = ({ verdict }) => tableOf(tableOfChecks(verdict), "checks");
/** A table of Python as the page shows one.
 * @param {any} of @param {string} key @returns {Table} */
export const tableOf = ({ name, title, heads, note, rows }, key) => ({
  ...{ key, name, title, heads, note, rows },
});
