// Several drives on one belt: read, solved and judged by the functions of wraparc solve.

import { told as problemOf } from "../static/documents.js";
import { in_page__quick as quick } from "../static/kernel.js";
import {
  assembled,
  beyond,
  lacking,
  left,
  NO_PULL,
  readIn,
} from "../static/pages/drive/assemble.js";
import { arcsOf, InputError, idleIn, runningAt, trainDrive } from "../static/reader.js";
import * as K from "./train_kernel.js";

/** @import { Assembled, Book, Design, Problem } from "../static/types.d.ts" */

const none = Number.NaN;
const POINTS = 180;
/** Whether a document is a train of this page. @param {Design} doc */
export const isTrain = (doc) => doc.train != null;

/**
 * What divides the load: parts of it, or what turns the drums.
 * @typedef {{parts?: number[], speeds?: number[], absolute?: boolean, motors?: any[]}} Division
 */
/** A load case in numbers. @param {any} c as read @param {string[]} names */
function caseAs(c, names) {
  const { fractions, rotation_speeds: speeds, absolute, motors } = c.division;
  const division = /** @type {Division} */ ({ parts: fractions, speeds, absolute, motors });
  const runs = names.map((_, i) => c.runs[i] ?? 0);
  const { name, kind, condition, entry_tension: entry, exit_tension: exit } = c;
  return { name, kind, condition, entry, exit, runs, division };
}
/** A motor of the train as the solver has it. @param {any} motor as read */
function motorOf(motor) {
  if (motor.master) return null;
  const kind =
    ("coupling_load" in motor && K.FluidCoupling) ||
    ("synchronous_speed" in motor && K.Induction) ||
    K.VariableSpeed;
  return Object.assign(Object.create(/** @type {any} */ (kind).prototype), motor);
}

/** A load case solved: its arcs as drives have them, and how the load divides.
 * @param {any} train as read @param {any} given the case as read @param {string[]} names
 * @param {number[]} nominal */
function solved(train, given, names, nominal) {
  const c = caseAs(given, names);
  const ends = { entry: c.entry, exit: c.exit };
  const drive = trainDrive(
    train,
    given,
    names.map(() => ends),
  );
  const start = assembled(drive, arcsOf(drive)).cases.map(({ prepared }) => prepared);
  const members = start.map(({ law, given: of }) => K.in_page_train__member_of(law, of));
  const { parts, speeds, absolute, motors: found } = c.division;
  const radii = members.map((m) => m.radius);
  const motors = names.map((_, i) => (found ? motorOf(found[i]) : null));
  let lines = members.map(() => new K.Line());
  let reference = none;
  if (speeds) {
    lines = K.in_page_train__turned(speeds, radii);
    if (absolute) reference = K.turning__surface_of_first(speeds, radii);
  } else if (found) {
    const masters = found.map((m) => (m.master ? names.indexOf(m.master) : -1));
    const ratios = found.map((m) => m.ratio ?? 1);
    const driven = K.turning__driven(motors, masters, ratios, radii);
    lines = driven.lines;
    reference = driven.reference;
  }
  const belt = K.in_page_train__belt_of(start[0].given, c.entry, c.exit);
  const system = K.in_page_train__system_of(members, lines, belt, c.runs);
  const pulls = parts ? K.in_page_train__shared(parts, system.pull) : [];
  const softening = start.some(({ given: of }) => of.steepest_fall < 0);
  const speed = start[0].given.speed;
  const divided = K.in_page_train__divided(
    ...[system, names, softening, pulls, speed, reference, belt],
  );
  if (!(K.in_page_train__least_of(divided.pairs) > 0)) return { why: NO_TENSION };
  const whole = trainDrive(train, given, divided.pairs);
  const own = assembled(whole, runningAt(arcsOf(whole), divided.belt_speeds));
  const quicks = own.cases.map(({ prepared, tested }) =>
    quick(prepared.law, prepared.given, tested, POINTS),
  );
  if (idleIn(whole)) return { why: NO_PULL };
  if (quicks.includes(null)) return { why: UNSOLVED };
  for (const i of K.in_page_train__fallen_of(divided))
    if (quicks[i]?.solved) quicks[i] = stateless(quicks[i]);
  const told = K.in_page_train__told(system, names, divided, quicks, nominal, motors);
  return { why: "", c, given, system, divided, own, quicks, motors, told };
}
const NO_TENSION = "leaves no tension in the belt; give other shares, or a higher " + "T2";
const UNSOLVED = "no result in this page; wraparc solve gives the reason";

const ENDS = ["entry_tension", "exit_tension", "effective_tension", "tension_ratio"];
/** An arc as one that slides has it: tensions, and no state at rest. @param {any} found */
function stateless(found) {
  const { summary } = found;
  const numbers = Object.keys(summary).map((k) => [k, ENDS.includes(k) ? summary[k] : none]);
  return { ...found, solved: false, summary: Object.fromEntries(numbers) };
}

/**
 * A train solved, case by case; or what is wrong with its document.
 * @param {Design} design @param {Book} book
 * @returns {{problems: Problem[], train?: any, cases?: any[], judging?: Assembled}}
 */
export function trainOf(design, book) {
  const { found: train, problems } = readIn(design, book);
  if (problems.length) return { problems };
  const not = beyond(train);
  if (not) return { problems: [left(not)] };
  const unknown = lacking(train, design, book);
  if (unknown) return { problems: [unknown] };
  /** @type {string[]} */
  const names = train.pulleys.map((/** @type {any} */ p) => p.name);
  const diameters = train.pulleys.map((/** @type {any} */ p) => p.diameter);
  const nominal = train.nominal_diameters.length ? train.nominal_diameters : diameters;
  const cases = /** @type {any[]} */ ([]);
  for (const given of train.cases) {
    try {
      const { why, ...one } = solved(train, given, names, nominal);
      if (why) return { problems: [left(`Load case ${given.name}: ${why}.`)] };
      cases.push(/** @type {any} */ (one));
    } catch (error) {
      if (!(error instanceof InputError)) throw error;
      return { problems: /** @type {any} */ (error).problems.map(problemOf) };
    }
  }
  const [{ own }] = cases;
  const all = (/** @type {"arcs" | "cases"} */ key) => cases.flatMap((one) => one.own[key]);
  const { drive, kinds } = own;
  const meant = train.case().name;
  const judging = { drive, kinds, arcs: all("arcs"), cases: all("cases"), meant };
  return { problems: [], train, cases, judging };
}
