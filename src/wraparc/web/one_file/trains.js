// Several drives on one belt: read, solved and judged by the functions of wraparc solve.
import { meant } from "../static/documents.js";
import { in_page__quick as quick } from "../static/kernel.js";
import {
  beyond,
  caseOf,
  judgingOf,
  lawOf,
  left,
  NOT_HERE,
  oddOf,
  readIn,
  saidOf,
  unjudgedOf,
  unknownLaw,
} from "../static/pages/drive/assemble.js";
import { numbersOf } from "../static/pages/drive/own.js";
import { dataWords, general, named, put } from "../static/pages/drive/wording.js";
import * as K from "./train_kernel.js";

/** @import { Book, Design, Judging, Problem } from "../static/types.d.ts" */

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

/** A load case solved; null where an arc is for the program.
 * @param {ReturnType<typeof caseAs>} c @param {{saids: any[], names: string[], nominal: number[], speed: number}} train
 * @param {any[]} laws @param {Book} book */
function solved(c, { saids, names, nominal, speed }, laws, book) {
  const start = laws.map((law, i) => caseOf(saids[i], c, law, book));
  const givens = start.map(({ prepared }) => numbersOf(prepared.given));
  const members = start.map(({ prepared }, i) =>
    K.in_page_train__member_of(prepared.law, givens[i]),
  );
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
  const belt = K.in_page_train__belt_of(givens[0], c.entry, c.exit);
  const system = K.in_page_train__system_of(members, lines, belt, c.runs);
  const pulls = parts ? K.in_page_train__shared(parts, system.pull) : [];
  const softening = laws.some((law) => law.steepest_fall < 0);
  const divided = K.in_page_train__divided(
    ...[system, names, softening, pulls, speed, reference, belt],
  );
  const arcs = divided.pairs.map((/** @type {any} */ { entry, exit }, /** @type {number} */ i) => {
    const made = caseOf(saids[i], { ...c, entry, exit }, laws[i], book);
    const given = { ...made.prepared.given, belt_speed: divided.belt_speeds[i] };
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
 * @param {Design} design @param {Book} book @param {Record<string, any[]>} words
 * @returns {{problems: Problem[], judging?: Judging, cases?: any[], checks?: any[]}}
 */
export function trainOf(design, book, words) {
  const { found, problems } = readIn(design, book);
  if (problems.length) return { problems };
  const not = beyond(found);
  if (not) return { problems: [left(not)] };
  const odd = oddOf(found, book);
  if (odd) return { problems: [odd] };
  /** @type {string[]} */
  const names = found.pulleys.map((/** @type {any} */ p) => p.name);
  const saids = names.map((_, i) => saidOf(found, i, design, book));
  const diameters = found.pulleys.map((/** @type {any} */ p) => p.diameter);
  const nominal = found.nominal_diameters.length ? found.nominal_diameters : diameters;
  const { speed } = saids[0].belt;
  const train = { saids, names, nominal, speed };
  const after = names.indexOf(found.criteria.take_up.after);
  const fixed = found.criteria.take_up.kind === "fixed";
  const cases = [];
  for (const given of found.cases) {
    const c = caseAs(given, names);
    const laws = saids.map((said) => lawOf(said, c.condition));
    const missing = laws.indexOf(undefined);
    if (missing >= 0) return { problems: [unknownLaw(saids[missing])] };
    const one = solved(c, train, laws, book);
    const why = kept(one, speed);
    if (why) return { problems: [left(`Load case ${c.name}: ${why}.`)] };
    const { system, divided, quicks, motors } = one;
    const told = K.in_page_train__told(system, names, divided, quicks, nominal, motors);
    const adrift = told.status.startsWith("Breakaway") && !c.division.parts;
    const unknown = (/** @type {number} */ i) =>
      put(words["gross_slip:adrift"][0], { kind: c.kind, pulley: names[i], case: c.name });
    const sags = c.entry >= c.exit ? names.length - 1 : 0;
    const arcs = one.arcs.map((/** @type {any} */ arc, /** @type {number} */ i) => ({
      ...arc,
      pulley: names[i],
      side: found.pulleys[i].side,
      offset: saids[i].thick(c.condition).get("pitch_offset"),
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
  const [{ motors }] = cases;
  const rated = motors.reduce((sum, m) => sum + (m ? m.count * m.rated_power : 0), 0);
  const most = Math.max(...cases.map(({ c }) => Math.abs(c.entry - c.exit)));
  if (rated && K.in_page_train__oversized(rated, most, speed))
    return { problems: [left(`Motors: ${NOT_HERE[3]}.`)] };
  const usual = saids.map((said) => lawOf(said));
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
    meant: meant(found.cases),
    anew: cases.some((x) => !x.c.division.parts),
    adrift: cases.some((x) => x.adrift),
    checks: [...of("pulley_diameter"), { ...of("usual_sizes")[0], pulley: "" }, ...of("data")],
    qualifier: Object.values(book.grounds).find((g) => data.some((d) => d.short === g)) ?? "",
    kinds: [...new Set(data.flatMap((d) => d.kinds))],
  };
  return { problems: [], judging, cases };
}
