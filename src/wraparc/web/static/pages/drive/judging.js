// When the page judges itself: after the frame that shows the moved drive is painted.
import { app } from "../../base/design.js";

export { confirmed, ownAnswer } from "./own.js";

import { judge, misses } from "./judge.js";
import { leastTold } from "./least.js";
import { answer } from "./solving.js";
import { checkTable, verdictOf } from "./words.js";

/** @import { FullAnswer } from "../../types.d.ts" */

const FOLLOWS = "The other tables follow once the hand rests.";
/** What the page has found last. @type {import("./judge.js").Judged | null} */
let found = null;

/** Judge what is shown, once that is painted, and show it. @param {() => void} show */
export const judgeAfter = (show) =>
  requestAnimationFrame(() =>
    setTimeout(() => {
      const { full, fullDoc, quickDoc, quick } = answer;
      const { doc } = app;
      if (!full || !fullDoc || !quick?.own || answer.judgedDoc === doc || quickDoc !== doc) return;
      found = judge(fullDoc, full, doc);
      if (!found) return;
      answer.judged = told(found, full);
      answer.judgedDoc = doc;
      const arc = answer.judged.arcs.find((a) => a.load_case === quick.load_case);
      const { level, levels } = arc || quick;
      Object.assign(quick, { level, levels, verdict: verdictOf(found, quick.load_case) });
      show();
    }),
  );
/** A judgement as the server tells one. @param {import("./judge.js").Judged} of
 * @param {FullAnswer} full @returns {FullAnswer} */
function told(of, full) {
  const verdict = verdictOf(of);
  const least_tension = leastTold(of, full.least_tension);
  if (least_tension) verdict.sentences.unshift(least_tension.sentence);
  verdict.sentences.push(FOLLOWS);
  const arcs = of.arcs.map((a) => {
    const before = full.arcs.find((b) => b.load_case === a.load_case);
    const { level, levels, short } = verdictOf(of, a.load_case);
    return { .../** @type {any} */ (before), level, levels, short, numbers: a.numbers };
  });
  const checks = checkTable(of, full.checks);
  return { ...full, verdict, checks, arcs, least_tension };
}
/** The page's judgement and the server's are one. @param {FullAnswer} full */
export function compare(full) {
  const ours = found?.doc === app.doc ? misses(found, full) : [];
  if (ours.length) console.error(`The page and the server differ in ${ours.join(", ")}.`);
}
