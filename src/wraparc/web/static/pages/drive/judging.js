// When the page judges itself: after the frame that shows the moved drive is painted.
import { app } from "../../base/design.js";
import { ask } from "../../base/server.js";
import { assemble } from "./assemble.js";
import { beside } from "./beside.js";
import { arcsOf, asked, judge, misses } from "./judge.js";
import { leastTold, raiseTo } from "./least.js";
import * as own from "./own.js";
import { answer } from "./solving.js";
import { firstAnswer, wholeOf } from "./whole.js";
import { barsOf, checkTable, verdictOf } from "./words.js";

export { confirmed } from "./own.js";
export { find, ways } from "./ways.js";

/** @import { Book, Design, FullAnswer, Judging, QuickAnswer } from "../../types.d.ts" */

const FOLLOWS = "The other tables follow once the hand rests.";
/** What drives are put together from. @type {Book | null} */
let book = null;
export const ready = ask("book").then(
  (/** @type {Book} */ found) => {
    book = found;
  },
  () => {}, // the server answers what is no moved number, as before
);
/** The drive that was put together last. */
let last = {
  doc: /** @type {Design | null} */ (null),
  judging: /** @type {Judging | null} */ (null),
};
/** A drive as the page puts it together; null where that is for the server. @param {Design} doc */
function assembled(doc) {
  if (!book) return null;
  if (last.doc !== doc) last = { doc, judging: assemble(doc, book).judging };
  return last.judging;
}

/** What a drive is judged by in one load case, put together in the page; null where that is for the
 * server. @param {Design} doc @param {string} name */
export async function alone(doc, name) {
  await ready;
  const judging = book && assemble(doc, book).judging;
  const cases = judging?.cases.filter((c) => c.load_case === name) ?? [];
  return judging && cases.length ? { ...judging, cases } : null;
}
/** The answer of the page itself to the arc that is looked at; null where it is for the server.
 * @param {{doc: Design, answer: QuickAnswer, pulley: number, case: string}} base
 * @param {number} points @param {QuickAnswer | null} judged */
export function ownAnswer(base, points, judged) {
  const { doc, pulley, case: name } = app;
  const same = base.pulley === pulley && base.case === name;
  const found = same ? own.ownAnswer(base, doc, points, judged) : null;
  if (found) return found;
  const judging = assembled(doc);
  const arc = judging?.cases.find((c) => !name || c.load_case === name);
  if (!judging || !arc) return null;
  const before = {
    ...base,
    answer: { ...base.answer, ...remarksAlone(firstAnswer(judging, arc)) },
  };
  return own.ownAnswer(before, doc, points, judged, arc);
}
/** @param {QuickAnswer} of */
const remarksAlone = ({ remarks, pulley, load_case }) => ({ remarks, pulley, load_case });

/** What the page has found last. @type {import("./judge.js").Judged | null} */
let found = null;
/** What is being judged, and whether more has changed since. */
let busy = false;
let again = false;
let show = () => {};

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
async function begin() {
  const { full, fullDoc, quickDoc, quick } = answer;
  const { doc } = app;
  again = busy;
  if (again || !full || !fullDoc || !quick?.own || quickDoc !== doc) return;
  const moved = asked(fullDoc, full, doc);
  const other = moved ? null : assembled(doc);
  const arcs = moved ?? (other && arcsOf(other));
  if (!arcs) return take(doc, full, full.judging, null);
  busy = true;
  take(doc, full, other ?? full.judging, await beside(arcs));
  busy = false;
  if (again) begin();
}
/** @param {Design} doc @param {FullAnswer} full @param {Judging | null} judging
 * @param {any[] | null} numbers */
function take(doc, full, judging, numbers) {
  const { quick } = answer;
  if (full !== answer.full || !quick?.own) return; // the server was first
  found = numbers && judging && judge(judging, doc, numbers);
  answer.judged = found && judging && told(found, full, judging);
  answer.judgedDoc = doc;
  const arc = answer.judged?.arcs.find((a) => a.load_case === quick.load_case);
  const none = { level: /** @type {any} */ (""), levels: {} };
  const { level, levels } = arc || none;
  Object.assign(quick, { level, levels });
  if (found) quick.verdict = verdictOf(found, quick.load_case);
  show();
}
/** A judgement as the server tells one. @param {import("./judge.js").Judged} of
 * @param {FullAnswer} full @param {Judging} judging @returns {FullAnswer} */
function told(of, full, judging) {
  if (judging !== full.judging && book) {
    const whole = wholeOf(of, judging, book);
    whole.verdict.sentences.push(FOLLOWS);
    return whole;
  }
  const verdict = verdictOf(of);
  const least_tension = leastTold(of, full.least_tension);
  if (least_tension) verdict.sentences.unshift(least_tension.sentence);
  verdict.sentences.push(FOLLOWS);
  const arcs = of.arcs.map((a) => {
    const before = full.arcs.find((b) => b.load_case === a.load_case);
    const { level, levels, short } = verdictOf(of, a.load_case);
    const raise_to = raiseTo(of, [a]);
    const bars = barsOf(of, a.load_case);
    const told = { level, levels, short, raise_to, bars, numbers: a.numbers };
    return { .../** @type {any} */ (before), ...told };
  });
  const checks = checkTable(of, full.checks);
  return { ...full, verdict, checks, arcs, least_tension };
}
/** The page's judgement and the server's are one. @param {FullAnswer} full */
export function compare(full) {
  const ours = found?.doc === app.doc ? misses(found, full) : [];
  if (ours.length) console.error(`The page and the server differ in ${ours.join(", ")}.`);
}
