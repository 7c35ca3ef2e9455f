// The least slack-side tension, as the server tells it.
import { aloneOf, leastSentence, leastTable, leastTension, shownLeast } from "../../reader.js";
import { resultsIn, tableOf } from "./words.js";

/** @import { Judged } from "./judge.js" */

/** @param {Judged} judged */
export function leastTold({ result }) {
  const found = leastTension(result);
  if (!found) return null;
  const { tension, raise_to, level } = found;
  const table = tableOf(leastTable(result), "least");
  return {
    tension,
    raise_to,
    shown: shownLeast(result),
    sentence: leastSentence(result),
    level,
    table,
  };
}
/** What a load case of a single pulley asks for by itself. @param {Judged} judged
 * @param {number} i which of the arcs */
export function leastAlone({ result, arcs }, i) {
  if (arcs.some((a) => a.pulley !== arcs[0].pulley)) return null;
  return leastTension(aloneOf(result, resultsIn(result)[i]));
}
