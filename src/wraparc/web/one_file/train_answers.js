// Answers about a train as the server gives them, on the pages Drive and Train.
import { Refused } from "../static/base/server.js";
import { beside } from "../static/pages/drive/beside.js";
import { arcsOf, check, judge } from "../static/pages/drive/judge.js";
import { shownOf } from "../static/pages/drive/own.js";
import { firstAnswer, inBoth } from "../static/pages/drive/whole.js";
import { put } from "../static/pages/drive/wording.js";
import { verdictOf } from "../static/pages/drive/words.js";
import * as K from "./train_kernel.js";
import { trainOf } from "./trains.js";
import { tableOf, wholeAnswer } from "./whole_tables.js";

/** @import { Design, Words } from "../static/types.d.ts" */

const UNSOLVED = "The solver of this page found no answer here; wraparc solve says why.";
const SOLVED = "The drives carry the load.";
const POINT = "operating_point";
const LEAST_SHIFT = 1e-4; // of a trim that is told
/** The train that was asked about last: both pages ask for the same. */
let last = { doc: "", found: /** @type {any} */ (null) };

/** A train judged. @param {Design} doc @param {any} data */
async function judgedTrain(doc, data) {
  const key = JSON.stringify(doc);
  if (last.doc === key) return last.found;
  const { problems, judging, cases } = trainOf(doc, data.book, data.trains.words);
  if (!judging || !cases) throw new Refused(problems, 422);
  const all = await beside(arcsOf(judging));
  const quicks = cases.flatMap((c) => c.quicks);
  all?.forEach((numbers, i) => {
    const { solved, summary } = quicks[i];
    if (numbers.solved && !solved) Object.assign(numbers, { solved, summary });
  });
  const judged = all && judge(judging, doc, all);
  if (!judged) throw new Refused([{ path: "", message: UNSOLVED, sentence: UNSOLVED }], 422);
  judged.checks.unshift(...cases.flatMap((c) => ofTrain(c, data.trains.words, judging.levels)));
  const results = cases.map((c, i) => resultOf(c, all.slice(i * c.arcs.length)));
  last = { doc: key, found: { judging, cases, judged, results } };
  return last.found;
}
/** What only several drives can miss. @param {any} one @param {Record<string, Words[]>} words
 * @param {any} levels */
function ofTrain({ c, told, divided, adrift, motors, arcs }, words, levels) {
  /** @param {string} key @param {any} numbers @param {string} [pulley] */
  const made = (key, numbers, pulley = "") => {
    const names = { case: c.name, reason: told.reason, pulley };
    const [w] = words[key].map((word) => put(word, names));
    const checked = check({ ...w, ...numbers.more }, numbers, c.name, levels);
    return pulley ? { ...checked, pulley } : checked;
  };
  const momentary = c.kind !== "running";
  const key = momentary ? "momentary_load" : "motor_load";
  const loaded = (/** @type {any} */ motor, /** @type {number} */ i) => {
    const [load, most] = [
      Math.abs(told.points[i].motor_load),
      K.in_page_train__borne(motor, momentary),
    ];
    const values = { [key]: load, percent: 100 * load, most: 100 * most };
    return made(key, { values, limits: { [key]: most } }, arcs[i].pulley);
  };
  const none = { values: {}, limits: {} };
  if (told.status !== SOLVED) {
    const beyond = told.status.startsWith("No operating point") ? [made(POINT, none)] : [];
    const point = adrift ? [made(`${POINT}:adrift`, none)] : beyond;
    return [...point, ...["fight", "train_balance"].map((name) => made(`${name}:none`, none))];
  }
  const [first] = arcs;
  /** The trim of a drum of another diameter or on the other side of the belt, whose thickness is
   * not known. @param {any} arc */
  const unknownTrim = (arc) => {
    const opposite = arc.side !== first.side;
    const shift = K.numbers__trim_shift(
      ...[first, arc].map(({ prepared }) => +prepared.given.diameter),
      opposite,
    );
    const known = [first, arc].every(({ offset }) => offset !== null);
    if (known || !(shift > LEAST_SHIFT)) return [];
    const names = { case: c.name, pulley: arc.pulley, first: first.pulley };
    const key = `belt_thickness${opposite ? ":opposite" : ""}`;
    const [w] = words[key].map((word) => put(word, names));
    const values = { shift: 100 * shift };
    return [{ ...check({ ...w }, { ...none, values }, c.name, levels), pulley: arc.pulley }];
  };
  const pulls = divided.pairs.map((/** @type {any} */ p) => p.entry - p.exit);
  const lost = K.numbers__pull_against(pulls);
  const error = Math.max(told.tension_error, told.speed_error);
  return [
    made(lost > 0 ? "fight:fights" : "fight", { ...none, values: { lost } }),
    ...arcs.slice(1).flatMap(unknownTrim),
    made("train_balance", { ...none, values: { train_balance: error } }),
    ...(c.division.motors ? motors : []).map((/** @type {any} */ m, /** @type {number} */ i) =>
      m ? loaded(m, i) : made(`${key}:none`, none, arcs[i].pulley),
    ),
  ];
}
/** A case as the words of Python read one. @param {any} one @param {any[]} numbers */
function resultOf({ c, system, told, arcs, quicks, divided }, numbers) {
  const members = arcs.map(
    (/** @type {any} */ { pulley, side, prepared, offset }, /** @type {number} */ i) => {
      const { summary, solved } = quicks[i];
      const limit = +prepared.given.creep_limit;
      const wrap_angle = +prepared.given.wrap_angle;
      const { compliance } = system.members[i];
      const { entry_tension, exit_tension, effective_tension } = summary;
      const { exit_creep, entry_creep_ratio } = summary;
      const arc = {
        ...{ entry_tension, exit_tension, effective_tension, exit_creep, entry_creep_ratio },
        within_creep_limit: solved && Math.abs(exit_creep) <= limit,
        arc: {
          ...{ pulley, creep_limit: limit, compliance, wrap_angle, entry_tension, exit_tension },
          ...{ diameter: +prepared.given.diameter, pitch_offset: offset, side_of_belt: side },
        },
        status: solved ? "solved" : "breakaway",
        energy: { power_loss: summary.power_loss },
        capacities: { creep_limit_margin: numbers[i].capacities.creep_limit_margin },
      };
      const fields = { ...told.turnings[i], arc, motor: told.points[i] };
      return Object.assign(Object.create(K.MemberResult.prototype), fields);
    },
  );
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
        const part = Math.abs(m.arc.exit_creep) / m.arc.arc.creep_limit;
        return Number.isFinite(part) ? part : 0;
      }),
    ),
  ];
  return results.reduce((a, b) => {
    const [one, other] = [severity(a), severity(b)];
    return other[0] > one[0] || (other[0] === one[0] && other[1] > one[1]) ? b : a;
  });
}
/** @param {any} found @param {any} book @returns {any} */
function wholeTrain({ judged, judging, results }, book) {
  const whole = wholeAnswer(judged, judging, book);
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
  return inBoth(() => wholeTrain(found, data.book));
}
/** How the drives share the load. @param {Design} doc @param {any} data */
export async function trainAnswer(doc, data) {
  const found = await judgedTrain(doc, data);
  const { results } = found;
  const told = inBoth(() => {
    const { verdict, remarks, checks, least_tension, summary } = wholeTrain(found, data.book);
    const least = least_tension ? [least_tension.table] : [];
    const own = results.map((/** @type {any} */ r) => K.train_sheet__case_table(r));
    const tables = [
      checks,
      ...least,
      ...own.map((/** @type {any} */ t, /** @type {number} */ i) => tableOf(t, `table${i}`)),
      ...(summary ? [summary] : []),
    ];
    return { verdict, remarks, tables };
  });
  const solved = results.every((/** @type {any} */ r) => r.status === SOLVED);
  return { ...told, solved, load_cases: results.map(caseData), sources: [], matching: null };
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
  return cases.flatMap((/** @type {any} */ { c, arcs, quicks }) =>
    arcs.map((/** @type {any} */ a, /** @type {number} */ i) => ({
      ...{ load_case: c.name, pulley: a.pulley, found: quicks[i] },
    })),
  );
}
/** One arc of a train. @param {any} asked @param {any} data */
export async function quickTrain({ document: doc, pulley, load_case, sequence }, data) {
  const { judging, cases, judged } = await judgedTrain(doc, data);
  const one =
    cases.find((/** @type {any} */ x) => x.c.name === (load_case ?? judging.meant)) ?? cases[0];
  const names = one.arcs.map((/** @type {any} */ a) => a.pulley);
  const i = Math.max(names.indexOf(pulley), 0);
  const told = inBoth(() => verdictOf(judged, one.c.name, names[i]));
  const { level, levels, ...verdict } = told;
  const first = { ...firstAnswer(judging, one.arcs[i]), ...shownOf(one.quicks[i]), sequence };
  return { ...first, kind: "train", level, levels, verdict: { ...verdict, level } };
}
