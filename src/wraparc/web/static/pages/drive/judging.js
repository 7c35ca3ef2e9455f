// When the page judges itself: after the frame that shows the moved drive is painted.
import { app } from "../../base/design.js";
import { ask } from "../../base/server.js";
import { assemble, inCase } from "./assemble.js";
import { beside } from "./beside.js";
import { arcsOf, asked, judge, misses } from "./judge.js";
import * as own from "./own.js";
import { answer } from "./solving.js";
import { wholeOf } from "./whole.js";
import { remarksOf } from "./words.js";

export { cure, find, hopeless, pane } from "./effects.js";
export { confirmed } from "./own.js";

/** @import { Assembled, Book, Design, FullAnswer, QuickAnswer } from "../../types.d.ts" */

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
  judging: /** @type {Assembled | null} */ (null),
};
/** A drive as the page puts it together; null where that is for the server. @param {Design} doc
 * @param {import("./assemble.js").Served} [served] */
function assembled(doc, served) {
  if (!book) return null;
  if (last.doc !== doc || !last.judging)
    last = { doc, judging: assemble(doc, book, served).judging };
  return last.judging;
}

/** What a drive is judged by, or in one load case, put together in the page; null where that is for
 * the server. @param {Design} doc @param {string} [name] */
export async function together(doc, name) {
  await ready;
  const judging = book && assemble(doc, book).judging;
  return judging && name ? inCase(judging, name) : judging;
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
  const arc = judging?.cases.find((c) => c.load_case === (name || judging.meant));
  if (!judging || !arc) return null;
  const before = {
    ...base,
    answer: { ...base.answer, pulley: arc.pulley, load_case: arc.load_case },
  };
  return own.ownAnswer(before, doc, points, judged, arc);
}
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
  const judging = assembled(doc, moved ?? undefined);
  if (!judging) return take(doc, full, null, null, false);
  busy = true;
  take(doc, full, judging, await beside(arcsOf(judging)), Boolean(moved));
  busy = false;
  if (again) begin();
}
/** @param {Design} doc @param {FullAnswer} full @param {Assembled | null} judging
 * @param {any[] | null} numbers @param {boolean} moved */
function take(doc, full, judging, numbers, moved) {
  const { quick } = answer;
  if (full !== answer.full || !quick?.own) return; // the server was first
  found = numbers && judging && judge(judging, doc, numbers);
  answer.judged = found && told(found, moved ? full : null);
  answer.judgedDoc = doc;
  const arc = answer.judged?.arcs.find((a) => a.load_case === quick.load_case);
  const none = { level: /** @type {any} */ (""), levels: {} };
  const { level, levels } = arc || none;
  Object.assign(quick, { level, levels });
  if (found) quick.remarks = remarksOf(found);
  show();
}
/** A judgement as the server tells one; of a drive whose numbers alone have moved with what it
 * told before. @param {import("./judge.js").Judged} of @param {FullAnswer | null} full
 * @returns {FullAnswer} */
function told(of, full) {
  const whole = wholeOf(of);
  whole.verdict.sentences.push(FOLLOWS);
  if (!full) return whole;
  const { verdict, checks, least_tension } = whole;
  const arcs = whole.arcs.map((arc) => {
    const before = full.arcs.find((b) => b.load_case === arc.load_case);
    const { level, levels, short, raise_to, bars, numbers } = arc;
    return { .../** @type {any} */ (before), level, levels, short, raise_to, bars, numbers };
  });
  return { ...full, verdict, checks, arcs, least_tension };
}
/** The page's judgement and the server's are one. @param {FullAnswer} full */
export function compare(full) {
  const ours = found?.doc === app.doc ? misses(found, full) : [];
  if (ours.length) console.error(`The page and the server differ in ${ours.join(", ")}.`);
}
