// Answers about a train as the server gives them, on the pages Drive and Train.
import { Refused } from "../static/base/server.js";
import { beside } from "../static/pages/drive/beside.js";
import { arcsOf, judged as judgedAs } from "../static/pages/drive/judge.js";
import { shownOf } from "../static/pages/drive/own.js";
import { firstAnswer, wholeOf } from "../static/pages/drive/whole.js";
import { remarksOf, tableOf, verdictOf } from "../static/pages/drive/words.js";
import {
  CaseResult,
  MemberResult,
  resultOf as resultOfArc,
  TrainResult,
} from "../static/reader.js";
import * as K from "./train_kernel.js";
import { trainOf } from "./trains.js";

/** @import { Design } from "../static/types.d.ts" */

const UNSOLVED = "No result in this page; wraparc solve gives the reason.";
const SOLVED = "The drives transmit the load.";
/** The train that was asked about last: both pages ask for the same. */
let last = { doc: "", found: /** @type {any} */ (null) };

/** A train judged. @param {Design} doc @param {any} data */
async function judgedTrain(doc, data) {
  const key = JSON.stringify(doc);
  if (last.doc === key) return last.found;
  const { problems, train, judging, cases } = trainOf(doc, data.book);
  if (!judging || !cases) throw new Refused(problems, 422);
  const all = await beside(arcsOf(judging));
  if (!all) throw new Refused([{ path: "", message: UNSOLVED, sentence: UNSOLVED }], 422);
  const quicks = cases.flatMap((c) => c.quicks);
  all.forEach((numbers, i) => {
    const { solved, summary } = quicks[i];
    if (numbers.solved && !solved) Object.assign(numbers, { solved, summary });
  });
  const per = train.pulleys.length;
  const results = cases.map((c, i) => resultOf(c, all.slice(i * per, (i + 1) * per)));
  const judged = judgedAs(judging, doc, all, trainResult(train, cases, judging.arcs, all));
  last = { doc: key, found: { judging, cases, judged, results } };
  return last.found;
}
/** An object of a class. @param {any} kind @param {object} of */
const inClass = (kind, of) => Object.assign(Object.create(kind.prototype), of);
/** A train as the checks take it. @param {any} train as read @param {any[]} cases @param {any[]} arcs
 * @param {any[]} numbers */
function trainResult(train, cases, arcs, numbers) {
  const results = arcs.map((arc, i) => resultOfArc(arc, numbers[i]));
  const per = train.pulleys.length;
  const of = (/** @type {any} */ { given, told }, /** @type {number} */ k) => {
    const members = results
      .slice(k * per, (k + 1) * per)
      .map((arc, i) => inClass(MemberResult, { arc, motor: told.points[i] }));
    const { status, reason, tension_error, speed_error } = told;
    return inClass(CaseResult, {
      case: given,
      status,
      reason,
      members,
      tension_error,
      speed_error,
    });
  };
  return inClass(TrainResult, { train, cases: cases.map(of) });
}
/** A case as the words of Python read one. @param {any} one @param {any[]} numbers */
function resultOf({ c, system, told, own, quicks, divided }, numbers) {
  const members = own.arcs.map((/** @type {any} */ of, /** @type {number} */ i) => {
    const { pulley, side_of_belt, pitch_offset, creep_limit: limit, wrap_angle, diameter } = of;
    const { summary, solved } = quicks[i];
    const { compliance } = system.members[i];
    const { entry_tension, exit_tension, effective_tension } = summary;
    const { exit_creep, entry_creep_ratio } = summary;
    const arc = {
      ...{ entry_tension, exit_tension, effective_tension, exit_creep, entry_creep_ratio },
      share_of_limit: Math.abs(exit_creep) / limit,
      within_creep_limit: solved && Math.abs(exit_creep) <= limit,
      arc: {
        ...{ pulley, creep_limit: limit, compliance, wrap_angle, entry_tension, exit_tension },
        ...{ diameter, pitch_offset, side_of_belt },
      },
      status: solved ? "solved" : "breakaway",
      energy: { power_loss: summary.power_loss },
      figures: { ...summary, ...numbers[i].capacities },
    };
    const fields = { ...told.turnings[i], arc, motor: told.points[i] };
    return Object.assign(Object.create(K.MemberResult.prototype), fields);
  });
  const { parts, motors } = c.division;
  const runs = c.runs.slice(0, -1);
  const of = {
    ...{ name: c.name, pulls_given: Boolean(parts), on_motors: Boolean(motors) },
    runs: runs.some((/** @type {number} */ v) => v !== 0) ? runs : [],
  };
  const { status, reason, sensitivity, other_splits, tension_error, speed_error } = told;
  return Object.assign(Object.create(K.CaseResult.prototype), {
    ...{ case: of, status, reason, members, sensitivity, other_splits },
    ...{ tension_error, speed_error, belt_speed: divided.belt_speeds[0] },
  });
}
/** The case nearest to its limits, or furthest beyond. @param {any[]} results */
function governingOf(results) {
  const severity = (/** @type {any} */ r) => [
    r.status === SOLVED ? 0 : 1,
    Math.max(
      ...r.members.map((/** @type {any} */ m) => {
        const part = m.arc.share_of_limit;
        return Number.isFinite(part) ? part : 0;
      }),
    ),
  ];
  return results.reduce((a, b) => {
    const [one, other] = [severity(a), severity(b)];
    return other[0] > one[0] || (other[0] === one[0] && other[1] > one[1]) ? b : a;
  });
}
/** @param {any} found @returns {any} */
function wholeTrain({ judged, results }) {
  const whole = wholeOf(judged);
  const worst = governingOf(results);
  const others = results.filter((/** @type {any} */ r) => r !== worst);
  whole.verdict.sentences.push(
    ...K.train_words__case_sentences(worst, results),
    ...others.flatMap((/** @type {any} */ r) => [...K.train_words__short_sentences(r)]),
  );
  return { ...whole, kind: "train" };
}
/** Everything there is to say of every pulley. @param {Design} doc @param {any} data */
export async function solveTrain(doc, data) {
  const found = await judgedTrain(doc, data);
  return wholeTrain(found);
}
/** How the drives share the load. @param {Design} doc @param {any} data */
export async function trainAnswer(doc, data) {
  const found = await judgedTrain(doc, data);
  const { results } = found;
  const { verdict, remarks, checks, least_tension, summary } = wholeTrain(found);
  const least = least_tension ? [least_tension.table] : [];
  const own = results.map((/** @type {any} */ r) => K.train_sheet__case_table(r));
  const tables = [
    checks,
    ...least,
    ...own.map((/** @type {any} */ t, /** @type {number} */ i) => tableOf(t, `table${i}`)),
    ...(summary ? [summary] : []),
  ];
  const told = { verdict, remarks, tables };
  const each = results.map((/** @type {any} */ r) => verdictOf(found.judged, r.case.name));
  const solved = results.every((/** @type {any} */ r) => r.status === SOLVED);
  const load_cases = results.map(caseData);
  return { ...told, solved, load_cases, judged: each, sources: [], matching: null };
}
/** @param {any} r */
const caseData = (r) => ({
  load_case: r.case.name,
  reason: r.reason,
  drives: r.members.map((/** @type {any} */ { arc, motor, ...turning }) => ({
    pulley: arc.arc.pulley,
    status: arc.status,
    side: arc.arc.side_of_belt,
    wrap_angle: arc.arc.wrap_angle,
    ...finite({ ...turning, entry_tension: arc.entry_tension, exit_tension: arc.exit_tension }),
    ...finite({ exit_creep: arc.exit_creep }),
  })),
});
/** @param {Record<string, any>} of */
const finite = (of) =>
  Object.fromEntries(Object.entries(of).map(([k, v]) => [k, Number.isFinite(v) ? v : null]));

/** The arcs of a train, solved. @param {Design} doc @param {any} data */
export async function trainArcs(doc, data) {
  const { cases } = await judgedTrain(doc, data);
  return cases.flatMap((/** @type {any} */ { c, own, quicks }) =>
    own.arcs.map((/** @type {any} */ a, /** @type {number} */ i) => ({
      ...{ load_case: c.name, pulley: a.pulley, found: quicks[i] },
    })),
  );
}
/** One arc of a train. @param {any} asked @param {any} data */
export async function quickTrain({ document: doc, pulley, load_case, sequence }, data) {
  const { judging, cases, judged } = await judgedTrain(doc, data);
  const name = load_case ?? judging.meant;
  const one = cases.find((/** @type {any} */ x) => x.c.name === name) ?? cases[0];
  const names = one.own.arcs.map((/** @type {any} */ a) => a.pulley);
  const i = Math.max(names.indexOf(pulley), 0);
  const { level, levels } = verdictOf(judged, one.c.name, names[i]);
  const remarks = remarksOf(judged);
  const first = { ...firstAnswer(one.own.cases[i]), ...shownOf(one.quicks[i]), sequence };
  return { ...first, kind: "train", level, levels, remarks };
}
