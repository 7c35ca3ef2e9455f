// Answers: one arc while the hand moves, by the page itself where it can; all once it rests.
import { app, caseNames, gripped, painted, redraw, wrong } from "../../base/design.js";
import { aborted, ask, later, onReturn, part, refusal } from "../../base/server.js";
import { mark } from "../../parts/problems.js";
import { askedCase, lacking } from "./cases.js";

/** @import { Design, FullAnswer, FullArc, Problem, QuickAnswer } from "../../types.d.ts" */

/** The last answers, and the documents they are of. */
export const answer = {
  quick: /** @type {QuickAnswer | null} */ (null),
  quickDoc: /** @type {Design | null} */ (null),
  full: /** @type {FullAnswer | null} */ (null),
  fullDoc: /** @type {Design | null} */ (null),
  /** What is wrong with the present document; the answers are then of an earlier one. */
  problems: /** @type {Problem[]} */ ([]),
  /** Those of the problems that no field shows. */
  unplaced: /** @type {Problem[]} */ ([]),
  /** Long in coming: the last answer must not stand under another drive's name. */
  slow: false,
  /** Whether the answers are of a design that was there before the present one was opened. */
  foreign: true,
  /** Whether the whole of a design just opened is waited for, so that nothing jumps. */
  awaited: true,
  /** The whole as the page itself judges it. */
  judged: /** @type {FullAnswer | null} */ (null),
  judgedDoc: /** @type {Design | null} */ (null),
  /** The course of a design that was pinned. @type {Record<string, number[]> | null} */
  pinned: null,
};
/** Whether everything is solved of the present document. */
export const whole = () => (answer.fullDoc === app.doc ? answer.full : null);
/** The present document as a whole, by the server or by the page. */
export const known = () =>
  whole() || (answer.quick?.own || answer.judgedDoc === app.doc ? answer.judged : null);
/** The arc on the screen in the whole. @returns {FullArc | undefined} */
export const wholeArc = () =>
  (known() || answer.full)?.arcs.find(
    (a) => a.pulley === answer.quick?.pulley && a.load_case === answer.quick?.load_case,
  );
/** @param {string} name */
export const placeOf = (name) =>
  Math.max(
    0,
    app.doc.pulley.findIndex((p) => p.name === name),
  );
/**
 * Tensions of a pulley by the last answer, if that is of the present document and of a state that
 * is.
 * @param {number} i
 */
export function nowOf(i) {
  const { quick, quickDoc } = answer;
  const { name } = app.doc.pulley[i];
  if (!quick || quickDoc !== app.doc || quick.pulley !== name) return null;
  return quick.status === "solved" ? quick.numbers : null;
}

/** @type {() => void} */
let show = redraw;
/** Be told when the answers have changed. @param {() => void} f */
export const onAnswer = (f) => {
  show = f;
};
/** Answers that came with a design.
 * @type {WeakMap<Design, {quick: QuickAnswer, whole: FullAnswer}>} */
export const came = new WeakMap();
let openedAs = 0;
/** A design as it was opened, where no load case was chosen: the governing one is shown. */
let openedDoc = /** @type {Design | null} */ (null);
/** @type {unknown[]} */
let asked = [];
let sequence = 0;
let busy = false;
let wanted = false;

const POINTS = 120;
/** Most arcs whose whole answer comes close enough behind the first to be waited for. */
const FEW = 9;
/** Most arcs that are solved for the first answer, which tells of the one that governs. */
const BRIEF = 6;
/** What the server solved last: the page moves numbers from there.
 * @type {{doc: Design, answer: QuickAnswer, pulley: number, case: string} | null} */
let base = null;
/** The solver of the page, fetched last.
 * @type {typeof import("./judging.js") | null} */
let own = null;
document.addEventListener("complete", async () => {
  if (own) return;
  await painted();
  own = await part(() => import("./judging.js")).catch(() => null);
  if (!own) return;
  performance.mark("own");
  show();
});
/** The solver of the page, once it is there. */
export const solver = () => own;
/** What was marked of what was asked before: what another page has marked since stays.
 * @type {unknown} */
let before;
/** Ask for what the present document lacks; called after every change. */
export function solve() {
  // what is changed before an answer says what governs is of the case whose fields stand there
  const documentChanged = asked[0] !== app.doc;
  if (asked[0] && documentChanged && app.opened === openedAs && !app.case)
    app.case = caseNames(app.doc)[0] ?? "";
  const key = [app.doc, app.pulley, app.case];
  if (key.every((k, i) => k === asked[i])) return rest();
  before = wrong.at;
  asked = key;
  answer.quickDoc = null;
  if (app.opened !== openedAs) {
    openedAs = app.opened;
    // nothing of the drive before stands under the name of this one
    const arcs = app.doc.pulley.length * caseNames(app.doc).length;
    const awaited = arcs <= FEW;
    openedDoc = arcs > BRIEF || app.case || app.pulley ? null : app.doc;
    Object.assign(answer, { foreign: true, full: null, fullDoc: null, judged: null, awaited });
  }
  const found =
    base && !answer.foreign && own?.ownAnswer(base, POINTS, answer.judged && answer.quick);
  if (found) {
    Object.assign(answer, { quick: found, quickDoc: app.doc, foreign: false, slow: false });
    told([]);
    own?.judgeAfter(show);
    confirmed();
  } else quick();
  if (documentChanged) {
    document.documentElement.classList.add("stale");
    if (answer.awaited) complete();
    else completeLater();
  }
}
/** Whether something waits for the hand to let go: nothing is asked of the server while it moves
 * what the page solves itself, or what only the other views show. */
let waits = false;
const moving = () => {
  waits = gripped() && (waits || app.page !== "drive" || Boolean(answer.quick?.own));
  return waits;
};
function rest() {
  if (!waits || gripped()) return;
  waits = false;
  confirmed();
  completeLater();
}
/** The server's word on what the page answered itself or left alone, once the hand rests. */
const confirmed = later(150, () => (answer.quick?.own || answer.quickDoc !== app.doc) && quick());
onReturn(() => {
  asked = [];
  solve();
});

/** One arc; while it is on its way, or a hand moves, only the newest change waits. */
async function quick() {
  wanted = true;
  if (busy) return;
  busy = true;
  while (wanted && !moving()) {
    wanted = false;
    const slow = setTimeout(() => {
      answer.slow = answer.quickDoc !== app.doc; // the page may have answered itself
      show();
    }, 250);
    try {
      await quickOnce(app.doc);
    } catch (x) {
      if (!app.gone) throw x; // the bar on top says that the server is gone
    } finally {
      clearTimeout(slow);
      answer.slow &&= wanted;
    }
    show();
  }
  busy = false;
}
/** @param {Design} doc */
async function quickOnce(doc) {
  const of = { doc, pulley: app.pulley, case: app.case };
  const { opened } = app;
  const governing = doc === openedDoc && !of.pulley && !of.case;
  const arc = governing
    ? { governing }
    : { pulley: doc.pulley[of.pulley]?.name ?? null, load_case: askedCase() };
  const how = { points: POINTS, sequence: ++sequence, tables: false, prepared: true };
  /** @type {Problem[]} */
  let problems = [];
  try {
    const given = !of.pulley && !of.case && came.get(doc)?.quick;
    const found = given || (await ask("solve/fast", { document: doc, ...arc, ...how }));
    if (opened !== app.opened) return; // of the drive that was open before
    // of another load case than the one that lacks a tension: the last answer stays
    if (lacking()) return told([]);
    base = { ...of, answer: found };
    const looked = of.pulley === app.pulley && of.case === app.case;
    take(found, doc === app.doc && looked && !wanted ? doc : null);
    if (!app.case && looked && doc === app.doc) {
      // the one that is meant where none is named stays the one looked at
      asked[2] = base.case = app.case = found.load_case;
      if (given || governing) asked[1] = base.pulley = app.pulley = placeOf(found.pulley);
      if (app.pulley || found.load_case !== caseNames(doc)[0]) redraw();
    }
    settle();
  } catch (x) {
    problems = refusal(x);
  }
  if (doc === app.doc) told(problems);
}
/** Take an answer of the server in: of what the page shows already it is the judgement.
 * @param {QuickAnswer} found @param {Design | null} doc if it is the present one */
function take(found, doc) {
  const shown = answer.quick;
  if (own && shown?.own && answer.quickDoc === app.doc)
    if (!doc || own.confirmed(shown, found)) return; // the page is ahead, or right
  Object.assign(answer, { quick: found, quickDoc: doc, foreign: false });
}
/** Both answers are of the design on the page. */
function settle() {
  if (answer.quickDoc === app.doc && answer.fullDoc === app.doc && !answer.quick?.own)
    document.documentElement.classList.remove("stale");
}
/** @param {Problem[]} problems */
function told(problems) {
  answer.problems = problems;
  if (!problems.length && wrong.at !== before) return;
  answer.unplaced = mark(problems);
  redraw();
}

/** @type {AbortController | null} */
let stop = null;
async function complete() {
  stop?.abort();
  stop = new AbortController();
  const doc = app.doc;
  if (answer.fullDoc === doc) return settle();
  try {
    const asked = { document: doc, points: 180, sequence: ++sequence, prepared: true };
    const given = came.get(doc)?.whole;
    const found = given || (await ask("solve", asked, { signal: stop.signal }));
    if (doc !== app.doc) return;
    own?.compare(found);
    Object.assign(answer, { full: found, fullDoc: doc, awaited: false });
    settle();
    redraw();
    document.dispatchEvent(new CustomEvent("complete"));
  } catch (x) {
    if (aborted(x)) return;
    answer.awaited = false;
    redraw();
    if (!app.gone) refusal(x);
  }
}
const completeLater = later(250, () => !moving() && complete());
