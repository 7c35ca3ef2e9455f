// Several drives on one belt: read here, solved and judged by the functions of wraparc solve.
import { si } from "../static/base/units.js";
import { in_page__quick as quick } from "../static/kernel.js";
import {
  acrossOf,
  caseOf,
  judgingOf,
  lawOf,
  NOT_HERE,
  read,
  thickOf,
  unjudgedOf,
} from "../static/pages/drive/assemble.js";
import { numbersOf } from "../static/pages/drive/own.js";
import { Reader } from "../static/pages/drive/reading.js";
import { checkShape } from "../static/pages/drive/shape.js";
import { dataWords, general, named, put } from "../static/pages/drive/wording.js";
import { TENSIONS } from "../static/parts/problems.js";
import { plainDrive } from "./plain_drive.js";
import * as K from "./train_kernel.js";
import { TrainReader } from "./train_reading.js";

/** @import { Book, Design, Judging, Problem } from "../static/types.d.ts" */
/** @import { TrainCase } from "./train_reading.js" */

const none = Number.NaN;
const POINTS = 180;
/** Whether a document is a train of this page. @param {Design} doc */
export const isTrain = (doc) => Boolean(doc.train) && doc.pulley.length > 1;

/** One of the pulleys as a drive of its own. @param {any} doc @param {number} i */
function alone({ train, load_case, ...doc }, i) {
  const pulley = { ...doc.pulley[i] };
  if (Array.isArray(train.diameters)) pulley.diameter = train.diameters[i];
  const names = doc.pulley.map((/** @type {any} */ p) => p.name);
  const takeUp = doc.take_up;
  const after = names.includes(takeUp?.after) ? pulley.name : takeUp?.after;
  return { ...doc, pulley: [pulley], ...(takeUp && { take_up: { ...takeUp, after } }) };
}
/** What of a train is left to the program; empty for nothing. @param {any} doc */
export function beyondTrain(doc) {
  const uneven = doc.pulley.find((/** @type {any} */ p) => p.across);
  return uneven ? acrossOf(uneven) : thickOf(doc);
}
/** @param {Problem[][]} all each once */
function once(all) {
  const found = all.flat();
  return found.filter((p, i) => found.findIndex((q) => q.sentence === p.sentence) === i);
}
/** @param {string} sentence @param {boolean} [beyond] @returns {{problems: Problem[]}} */
const refusing = (sentence, beyond = false) => ({
  problems: [{ path: "", message: sentence, sentence, beyond }],
});

/** A train read: its pulleys, its cases, or what is wrong. @param {Design} doc @param {Book} book
 * @param {any[]} motors */
function readTrain(doc, book, motors) {
  const alones = doc.pulley.map((_, i) => alone(doc, i));
  const shapes = alones.map((one) => {
    const shape = new Reader(one);
    checkShape(shape);
    return shape.problems;
  });
  if (shapes.flat().length) return { problems: once(shapes), saids: [], cases: [] };
  const saids = alones.map((one) => read(/** @type {any} */ (one), book, []));
  const names = doc.pulley.map((p) => p.name ?? "");
  const twice = names.find((n, i) => names.indexOf(n) < i);
  if (twice !== undefined) saids[0].r.wrong(["pulley"], `"${twice}" names two pulleys`);
  const speed = saids[0].belt.speed;
  const nominal = doc.pulley.map((p) => si(p.diameter, "length"));
  const takeUp = { ...saids[0].takeUp, after: doc.take_up?.after };
  const reader = new TrainReader(doc, motors, speed, nominal, takeUp, book.design);
  const cases = reader.cases();
  const problems = once([...saids.map((s) => s.r.problems), reader.r.problems]);
  return { problems, saids, cases, nominal, speed, takeUp, names };
}

/** A law for each pulley in a case. @param {any[]} saids @param {any} doc @param {any} condition */
function lawsIn(saids, doc, condition) {
  const main = Array.isArray(doc.condition) ? doc.condition[0] : doc.condition;
  return saids.map(({ r, lagging }, i) =>
    lawOf(r, lagging.entry, condition ?? doc.pulley[i].condition ?? main, ["condition"]),
  );
}
/** @param {number} entry @param {number} exit */
const pullsOf = (entry, exit) => ({
  ...Object.fromEntries(TENSIONS.map((key) => [key, none])),
  ...{ entry_tension: entry, exit_tension: exit },
});
/** @param {any} motor */
const motorOf = ({ kind, fields }) =>
  Object.assign(
    Object.create(/** @type {any} */ (K)[kind].prototype),
    Object.fromEntries(
      Object.entries(fields).map(([name, v]) => [name, typeof v === "string" ? +v : v]),
    ),
  );

/** A load case solved; null where an arc is for the program.
 * @param {TrainCase} c @param {any} train as read @param {any[]} laws @param {Book} book */
function solved(c, { saids, names, nominal, speed }, laws, book) {
  const start = laws.map((law, i) =>
    caseOf(saids[i], { ...c, pulls: pullsOf(c.entry, c.exit) }, law, book),
  );
  const givens = start.map(({ prepared }) => numbersOf(prepared.given));
  const members = start.map(({ prepared }, i) =>
    K.in_page_train__member_of(prepared.law, givens[i]),
  );
  const { parts, speeds, absolute, motors: found } = c.division;
  const radii = members.map((m) => m.radius);
  const motors = (found ?? names).map((/** @type {any} */ m) => (m.fields ? motorOf(m) : null));
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
  const system = new K.System(members, lines, c.entry, c.exit, c.runs);
  const pulls = parts ? K.in_page_train__shared(parts, system.pull) : [];
  const softening = laws.some((law) => law.steepest_fall < 0);
  const divided = K.in_page_train__divided(system, names, softening, pulls, speed, reference);
  const arcs = divided.pairs.map((/** @type {any} */ { entry, exit }, /** @type {number} */ i) => {
    const made = caseOf(saids[i], { ...c, pulls: pullsOf(entry, exit) }, laws[i], book);
    const given = { ...made.prepared.given, speed: divided.belt_speeds[i] };
    const criteria = { ...made.criteria, alone: 0 };
    return { ...made, criteria, prepared: { ...made.prepared, given } };
  });
  const quicks = arcs.map((/** @type {any} */ { prepared, tested }) =>
    quick(prepared.law, numbersOf(prepared.given), tested, POINTS),
  );
  const fallen = K.in_page_train__fallen_of(divided);
  for (const i of fallen) if (quicks[i]?.solved) quicks[i] = stateless(quicks[i]);
  return { c, system, divided, arcs, quicks, motors, nominal };
}

/** @param {any} w */
const isGrip = (w) => w.name === "gross_slip";
const ENDS = ["entry_tension", "exit_tension", "effective_tension", "tension_ratio"];
/** An arc as one that slides has it: tensions, and no state at rest. @param {any} found */
function stateless(found) {
  const { summary } = found;
  const numbers = Object.keys(summary).map((k) => [k, ENDS.includes(k) ? summary[k] : none]);
  return { ...found, solved: false, summary: Object.fromEntries(numbers) };
}
/** What keeps the page from a case that is solved; empty for nothing. @param {any} one
 * @param {number} speed of the belt, as given */
function kept({ arcs, quicks, divided, motors }, speed) {
  if (!(K.in_page_train__least_of(divided.pairs) > 0))
    return (
      "leaves no tension in the belt, and a belt cannot push; give other shares, or more tension " +
      "on the slack side"
    );
  for (const [i, arc] of arcs.entries()) {
    const radius = 0.5 * arc.prepared.given.diameter;
    if (motors[i] && !K.in_page_train__fits(motors[i], radius, speed)) return NOT_HERE[3];
    const why = unjudgedOf(arc);
    if (why) return NOT_HERE[why];
    if (!quicks[i]) return "the solver of this page found no answer here; wraparc solve says why";
  }
  return "";
}

/**
 * A train solved, and what it is judged by; or what is wrong with its document.
 * @param {Design} design @param {Book} book @param {{motors: any[], words: any}} known
 * @returns {{problems: Problem[], judging?: Judging, cases?: any[], checks?: any[]}}
 */
export function trainOf(design, book, known) {
  const not = beyondTrain(design);
  if (not) return refusing(not, true);
  const { doc, problems } = plainDrive(design);
  if (problems.length) return { problems };
  const train = readTrain(doc, book, known.motors);
  if (train.problems.length) return { problems: train.problems };
  const { saids, names = [], takeUp } = train;
  const odd = saids.find((s) => s.r.unusual);
  if (odd) return refusing(`${odd.r.unusual?.join(".")}: ${NOT_HERE[3]}.`, true);
  const after = names.indexOf(takeUp?.after ?? "");
  const fixed = takeUp?.kind === "fixed";
  const cases = [];
  for (const c of train.cases) {
    const laws = lawsIn(saids, doc, c.condition);
    if (laws.some((law) => !law)) return { problems: once(saids.map((s) => s.r.problems)) };
    const one = solved(c, train, laws, book);
    const why = kept(one, train.speed ?? none);
    if (why) return refusing(`Load case ${c.name}: ${why}.`, true);
    const { system, divided, quicks, motors, nominal } = one;
    const told = K.in_page_train__told(system, names, divided, quicks, nominal ?? [], motors);
    const adrift = told.status.startsWith("Breakaway") && !c.division.parts;
    const unknown = (/** @type {number} */ i) =>
      put(known.words["gross_slip:adrift"][0], { kind: c.kind, pulley: names[i], case: c.name });
    const sags = c.entry >= c.exit ? names.length - 1 : 0;
    const arcs = one.arcs.map((/** @type {any} */ arc, /** @type {number} */ i) => ({
      ...arc,
      pulley: names[i],
      names: named(saids[i]),
      among: K.in_page_train__among(divided.pairs, i, fixed, after),
      checks: arc.checks
        .filter((/** @type {any} */ w) => w.name !== "sag" || i === sags)
        .filter((/** @type {any} */ w) => !(adrift && isGrip(w) && w.when !== "breakaway:0"))
        .map((/** @type {any} */ w) => (adrift && isGrip(w) ? unknown(i) : w))
        .map((/** @type {any} */ w) => ({ ...w, pulley: names[i] })),
    }));
    cases.push({ ...one, told, arcs, adrift });
  }
  const usual = lawsIn(saids, doc, undefined);
  const at = Math.max(after, 0);
  const data = saids.map((said, i) => dataWords(said, /** @type {any} */ (usual[i]), book));
  const all = saids.map((said, i) =>
    general(said, data[i], book).map((w) => ({ ...w, pulley: names[i] })),
  );
  const of = (/** @type {string} */ name) => all.flatMap((g) => g.filter((w) => w.name === name));
  const judging = {
    ...judgingOf(
      saids[at],
      /** @type {any} */ (usual[at]),
      cases.flatMap((x) => x.arcs),
      book,
    ),
    anew: cases.some((x) => !x.c.division.parts),
    adrift: cases.some((x) => x.adrift),
    checks: [...of("pulley_diameter"), { ...of("usual_sizes")[0], pulley: "" }, ...of("data")],
    qualifier: Object.values(book.grounds).find((g) => data.some((d) => d.short === g)) ?? "",
    kinds: [...new Set(data.flatMap((d) => d.kinds))],
  };
  return { problems: [], judging, cases };
}
