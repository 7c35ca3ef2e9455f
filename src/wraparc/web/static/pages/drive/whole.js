// A judged drive as an answer of the server tells one, for what the page has put together itself.
import { arcTables, Sources, summaryTable } from "../../reader.js";
import { leastAlone, leastTold } from "./least.js";
import { barsOf, checkTable, driveIn, remarksOf, resultsIn, tableOf, verdictOf } from "./words.js";
import { worstOf } from "./worst.js";

/** @import { Assembled, FullAnswer, FullArc, QuickAnswer } from "../../types.d.ts" */
/** @import { Judged } from "./judge.js" */

/**
 * The answer of a drive that the page has put together.
 * @param {Judged} judged @returns {FullAnswer}
 */
export function wholeOf(judged) {
  const least_tension = leastTold(judged);
  const verdict = verdictOf(judged);
  if (least_tension) verdict.sentences.unshift(least_tension.sentence);
  const arcs = judged.arcs.map((_, i) => arcOf(judged, i));
  const worst = worstOf(arcs);
  return {
    verdict,
    governing: { pulley: worst.pulley, load_case: worst.load_case },
    arcs,
    conditions: null,
    checks: checkTable(judged),
    least_tension,
    // as the tables of an arc, not made while a slider moves
    get summary() {
      return arcs.length > 1
        ? tableOf(summaryTable([driveIn(judged.result)], judged.result), "summary")
        : null;
    },
    sources: judged.of.kinds.map((kind) => ({ kind })),
    remarks: remarksOf(judged),
    judging: null,
    unsearched: true,
  };
}
/** @param {Judged} judged @param {number} i @returns {FullArc} */
function arcOf(judged, i) {
  const { load_case, pulley, solved, numbers } = judged.arcs[i];
  const { level, levels, short, order } = verdictOf(judged, load_case, pulley);
  const c = judged.of.cases[i];
  /** @type {Pick<FullArc, "tables" | "table_sources"> | null} */
  let made = null;
  const told = () => {
    made ??= tablesOf(judged, i);
    return made;
  };
  return {
    pulley,
    load_case,
    status: solved ? "solved" : "breakaway",
    status_text: "",
    raise_to: leastAlone(judged, i)?.raise_to ?? null,
    ...{ level, levels, short, order, numbers: finite(numbers) },
    bars: barsOf(judged, load_case, pulley),
    creep_limit: +c.prepared.given.creep_limit,
    profile: {},
    tested: c.tested,
    outside: [],
    // while a slider moves nobody reads them
    get tables() {
      return told().tables;
    },
    get table_sources() {
      return told().table_sources;
    },
    paper: null,
  };
}
/** The tables of an arc, and their sources. @param {Judged} judged @param {number} i */
function tablesOf({ result }, i) {
  const of = new Sources();
  const made = [...arcTables(driveIn(result), [resultsIn(result)[i]], of)];
  return { tables: made.map(([key, t]) => tableOf(t, key)), table_sources: [...of.listed()] };
}
/** Numbers as JSON has them: none for what there is none of or has no bound.
 * @param {Record<string, number>} of @returns {Record<string, any>} */
const finite = (of) =>
  Object.fromEntries(Object.entries(of).map(([k, v]) => [k, Number.isFinite(v) ? v : null]));
/** The first answer to an arc that nothing was solved of.
 * @param {Assembled["cases"][number]} c @returns {QuickAnswer} */
export const firstAnswer = (c) => ({
  sequence: 0,
  pulley: c.pulley,
  load_case: c.load_case,
  status: "solved",
  level: /** @type {any} */ (""),
  levels: {},
  creep_limit: +c.prepared.given.creep_limit,
  numbers: {},
  profile: {},
  tested: c.tested,
  outside: [],
  remarks: [],
  prepared: null,
});
