// When the page judges itself: after the frame that shows the moved drive is painted.
import { app } from "../../base/design.js";

export { confirmed, ownAnswer } from "./own.js";

import { asked, judge, misses } from "./judge.js";
import { leastTold } from "./least.js";
import { answer } from "./solving.js";
import { checkTable, verdictOf } from "./words.js";

/** @import { Design, FullAnswer } from "../../types.d.ts" */

const FOLLOWS = "The other tables follow once the hand rests.";
/** What the page has found last. @type {import("./judge.js").Judged | null} */
let found = null;
/** What is being judged, and whether more has changed since.
 * @type {{doc: Design, full: FullAnswer} | null} */
let busy = null;
let again = false;
let show = () => {};
const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
worker.onmessage = (e) => {
  if (busy) take(busy.doc, busy.full, e.data);
  busy = null;
  if (again) begin();
};

/** What the server has judged stands until a moved number is judged. */
const begun = () => {
  answer.judged = answer.full?.judging ? answer.full : null;
};
begun();
document.addEventListener("complete", begun);

/** Judge what is shown, once that is painted, and show it. @param {() => void} then */
export function judgeAfter(then) {
  show = then;
  requestAnimationFrame(() => setTimeout(begin));
}
function begin() {
  const { full, fullDoc, quickDoc, quick } = answer;
  const { doc } = app;
  again = busy !== null;
  if (again || !full || !fullDoc || !quick?.own || quickDoc !== doc) return;
  const arcs = asked(fullDoc, full, doc);
  if (!arcs) return take(doc, full, null);
  busy = { doc, full };
  worker.postMessage(arcs);
}
/** @param {Design} doc @param {FullAnswer} full @param {any[] | null} numbers */
function take(doc, full, numbers) {
  const { quick } = answer;
  if (full !== answer.full || !quick?.own) return; // the server was first
  found = numbers && full.judging && judge(full.judging, doc, numbers);
  answer.judged = found && told(found, full);
  answer.judgedDoc = doc;
  const arc = answer.judged?.arcs.find((a) => a.load_case === quick.load_case);
  const none = { level: /** @type {any} */ (""), levels: {} };
  const { level, levels } = arc || none;
  Object.assign(quick, { level, levels });
  if (found) quick.verdict = verdictOf(found, quick.load_case);
  show();
}
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
