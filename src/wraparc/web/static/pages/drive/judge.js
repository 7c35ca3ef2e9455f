// The checks of a drive that the page has solved: those of the program, translated.
import { words } from "../../base/units.js";
import { resultsOf, judge as verdictOn } from "../../reader.js";
import { moved } from "./own.js";
import { checkTable, verdictOf } from "./words.js";

/** @import { Asked } from "./numbers.js" */
/** @import { Assembled, Design, FullAnswer, FullArc, Judging } from "../../types.d.ts" */

/**
 * A judged drive: `result` and `verdict` are those of the program.
 * @typedef {{load_case: string, pulley: string, solved: boolean,
 *   numbers: Record<string, number>}} JudgedArc
 * @typedef {{doc: Design, result: any, verdict: any, arcs: JudgedArc[], of: Assembled}} Judged
 */

/** Relative difference that counts as none. */
const SAME = 1e-7;

/**
 * The cases of a solved drive, if another one differs from it by moved numbers alone; else null.
 * @param {Design} before @param {FullAnswer} answer @param {Design} doc
 * @returns {Judging["cases"] | null}
 */
export function asked(before, { judging }, doc) {
  const cases = judging?.cases ?? [];
  const all = cases.every((of) => moved(before, of.prepared, doc, of.elsewhere));
  return cases.length && all ? cases : null;
}
/** The arcs of a drive, for the solver. @param {Assembled} of @returns {Asked[]} */
export const arcsOf = ({ cases }) =>
  cases.map(({ prepared, tested, criteria }) => ({ ...prepared, tested, criteria }));
/**
 * Every check of a drive by the numbers of its arcs.
 * @param {Assembled} of @param {Design} doc @param {any[]} all @returns {Judged}
 */
export const judge = (of, doc, all) => judged(of, doc, all, resultsOf(of.drive, of.arcs, all));
/** @param {Assembled} of @param {Design} doc @param {any[]} all @param {any} result
 * @returns {Judged} */
export function judged(of, doc, all, result) {
  const arcs = of.cases.map(({ load_case, pulley }, i) => {
    const { solved, summary, capacities, loads } = all[i];
    return { load_case, pulley, solved, numbers: { ...summary, ...capacities, ...loads } };
  });
  return { doc, result, verdict: verdictOn(result), arcs, of };
}

/** In what a judgement of the page and the server's are not one.
 * @param {Judged} own @param {FullAnswer} found */
export function misses(own, { verdict, checks, arcs }) {
  const said = words(verdictOf(own).text) === words(verdict.text);
  const levels = (/** @type {any} */ of) => of.rows.map((/** @type {any} */ r) => r.level).join();
  const rows = levels(checks) === levels(checkTable(own));
  const far = own.arcs.flatMap((a) => differing(a, arcs));
  return [...(said ? [] : ["verdict"]), ...(rows ? [] : ["checks"]), ...far];
}
/** @param {JudgedArc} a @param {FullArc[]} arcs */
function differing(a, arcs) {
  const there = arcs.find((b) => b.load_case === a.load_case)?.numbers ?? {};
  return Object.keys(a.numbers).filter((name) => {
    const [x, y] = [a.numbers[name], there[name]];
    if (y == null || name === "identity_error") return false; // without bound, or not found
    return !(Math.abs(x - y) <= SAME * Math.max(Math.abs(x), Math.abs(y)));
  });
}
