// A drive put together in the page: what the server prepares of it, `judging` in web/answers, from
// the parts of the book that the server hands out, and by its functions.
import { known, meant, read } from "../../documents.js";
import { in_page__described as described, in_page__unjudged as unjudged } from "../../kernel.js";
import { TENSIONS } from "../../parts/problems.js";
import { ofBelt, weakSources } from "../../reader.js";
import { numbersOf } from "./own.js";
import { standardOf } from "./standard.js";
import { dataWords, filled, general, named, wordsOf } from "./wording.js";

/** @import { Book, BookLagging, BookLaw, Design, Judging, Problem } from "../../types.d.ts" */

/**
 * What a document says of a pulley and all that goes with it, as numbers [SI] and choices.
 * @typedef {ReturnType<typeof saidOf>} Said
 * @typedef {{name: string, kind: string, condition: string, entry: number, exit: number}} Case
 * @typedef {{judging: Judging | null, problems: Problem[]}} Assembled
 */

const none = Number.NaN;
const HERE = "wraparc solve and wraparc serve do";
/** What a drive has that only the program itself solves; empty for a drive of the page.
 * @param {any} drive as read */
export function beyond(drive) {
  const uneven = drive.pulleys.find((/** @type {any} */ p) => p.across);
  if (uneven) return acrossOf(uneven);
  if (!drive.cases && drive.pulleys.length > 1)
    return `Pulleys that each give their tensions, without [train], are not solved here; ${HERE}.`;
  return "";
}
/** What is said of a pulley whose load is uneven across the width. @param {any} pulley */
const acrossOf = ({ name }) =>
  `The load across the width of pulley ${name} is not solved in this page, and there is no ` +
  "verdict without it. On the command line: wraparc solve FILE.";
/** A problem of what the page leaves to the program. @param {string} message @param {string} [at]
 * @returns {Problem} */
export const left = (message, at = "") => ({
  path: at,
  message,
  sentence: at ? `${at}: ${message}.` : message,
  beyond: true,
});
/** A document read by the functions of the program, or what is wrong with it, as it says so.
 * @param {any} doc @param {Book} book @returns {{found: any, problems: Problem[]}} */
export function readIn(doc, book) {
  known(book.catalogue);
  return read(doc);
}

const orNone = (/** @type {number | null} */ v) => v ?? none;
/** What a drive or train says of one of its pulleys. @param {any} drive as read @param {number} i
 * @param {any} doc @param {Book} book */
export function saidOf(drive, i, doc, book) {
  const pulley = drive.pulleys[i];
  const { belt, criteria } = drive;
  const { lagging } = pulley;
  const { take_up, standard, safety, sag } = criteria;
  return {
    name: /** @type {string} */ (pulley.name),
    pulley: {
      diameter: pulley.diameter,
      wrap_angle: pulley.wrap_angle,
      overrun: orNone(pulley.overrun),
      creep_limit: orNone(pulley.creep_limit),
      mass: orNone(pulley.mass),
    },
    belt: {
      width: belt.width,
      speed: orNone(belt.speed),
      modulus: belt.modulus,
      rating: orNone(belt.rating),
      strength: orNone(belt.strength),
      least: orNone(belt.least_pulley_diameter),
      factor: orNone(belt.momentary_factor),
      pressure: orNone(belt.largest_wrap_pressure),
      mass: orNone(belt.mass),
      kind: belt.kind,
      name: /** @type {string} */ (belt.name),
    },
    lagging: {
      thickness: lagging.thickness,
      shear_modulus: lagging.shear_modulus,
      compression_modulus: lagging.compression_modulus,
      wear_coefficient: orNone(lagging.wear_coefficient),
      bond_strength: orNone(lagging.bond_strength),
      fatigue_limit: orNone(lagging.fatigue_limit),
      name: lagging.name,
      surface: lagging.surface,
      entry: entryOf(doc, i, book),
    },
    takeUp: { kind: take_up.kind, after: take_up.after, ratio: take_up.sheave_ratio },
    standard: {
      name: standard.name,
      condition: standard.condition,
      friction: orNone(standard.friction),
      start: standard.start_factor,
      binding: standard.binding,
    },
    safety,
    sag: sag && { idler_spacing: sag.spacing, line_mass: sag.line_mass, share: sag.share },
    limit: drive.creep_limit,
    recovery: pulley.recovery,
    usual: lagging.condition,
    weak: /** @type {[string, string][]} */ ([...weakSources(drive, pulley)]),
    /** What the belt adds to the arc in a condition. @param {string} condition */
    thick(condition) {
      const in_ = pulley.conditions.find((/** @type {any} */ l) => l.condition === condition);
      return ofBelt(belt, pulley.side, (in_ ?? lagging).law);
    },
    asked: [doc.condition, doc.pulley[i].condition, ...casesOf(doc)].flat(),
  };
}
/** @param {any} doc @returns {any[]} */
const casesOf = (doc) => (doc.load_case ?? []).map((/** @type {any} */ c) => c.condition);
/** Keys of a lagging that make its law another one. */
const LAW = ["law", "condition_factor", "slip_speed", "temperature"];
/** What the book has of the lagging of a pulley. @param {any} doc @param {number} i
 * @param {Book} book @returns {BookLagging | undefined} */
function entryOf(doc, i, book) {
  const given = doc.pulley[i].lagging;
  const name = given.preset ?? given;
  const own = doc.lagging?.[name];
  const other = own && JSON.stringify(own) !== JSON.stringify(book.own?.[name]);
  const law = LAW.some((key) => given[key] != null);
  return other || law ? undefined : book.laggings[name];
}
/** Breaking strength that the name of a steel-cord belt tells. @param {string} name */
export const strengthIn = (name) =>
  1e3 * +(/ST[ -]?(\d{3,5})\b/.exec(name.toUpperCase())?.[1] ?? none);
export const OTHERS =
  "Make the page anew with it, `wraparc page FILE`, or solve with `wraparc solve`";
/** The law of a pulley in a condition, that of its own for none. @param {Said} said
 * @param {string} [condition] @returns {BookLaw | undefined} */
export function lawOf({ lagging: { entry }, usual, asked }, condition) {
  const name = condition || usual;
  const given = asked.find((c) => c === name || c?.name === name);
  const key = given?.name ? JSON.stringify(given) : name;
  return entry?.laws[key] ?? Object.values(entry?.laws ?? {}).find((l) => l.condition === name);
}
/** What is said of a law that the book does not have. @param {Said} said @returns {Problem} */
export const unknownLaw = ({ name, lagging }) =>
  left(
    `this page was not made with lagging ${lagging.name} as it is here. ${OTHERS}`,
    placeOf(name),
  );
/** @param {string} pulley */
const placeOf = (pulley) =>
  `pulley.${/^[\w-]+$/.test(pulley) ? pulley : JSON.stringify(pulley)}.lagging`;

/**
 * What a drive is judged by; or what is wrong with its document.
 * @param {Design} doc @param {Book} book @returns {Assembled}
 */
export function assemble(doc, book) {
  const { found, problems } = readIn(doc, book);
  return problems.length ? { judging: null, problems } : assembled(found, doc, book);
}
/** The same of a drive as it was read. @param {any} drive @param {Design} doc @param {Book} book
 * @returns {Assembled} */
export function assembled(drive, doc, book) {
  const refused = (/** @type {Problem} */ problem) => ({ judging: null, problems: [problem] });
  const not = drive.cases ? "A train is not solved here." : beyond(drive);
  if (not) return refused(left(not));
  const odd = oddOf(drive, book);
  if (odd) return refused(odd);
  const said = saidOf(drive, 0, doc, book);
  const cases = drive.load_cases.map((/** @type {any} */ c) => caseAs(c, said.name));
  const usual = lawOf(said);
  const laws = cases.map((/** @type {Case} */ c) => lawOf(said, c.condition));
  if (!usual || laws.includes(undefined)) return refused(unknownLaw(said));
  const made = cases.map((/** @type {Case} */ c, /** @type {number} */ i) =>
    caseOf(said, c, laws[i], book),
  );
  const steep = made.findIndex((/** @type {any} */ m) => unjudgedOf(m));
  if (steep >= 0) {
    const why = unjudgedOf(made[steep]);
    const at = cases[steep].name === book.design ? "pulley" : "load_case";
    return refused({ ...left(NOT_HERE[why], at), beyond: why > 1 });
  }
  const judging = { ...judgingOf(said, usual, made, book), meant: meant(drive.load_cases) };
  // what a take-up holds follows from the conveyor in every load case
  if (drive.conveyor) Object.assign(judging, { take_up: false, held_at: drive.conveyor.take_up });
  return { judging, problems: [] };
}
/** A size beside those of the arcs that conveyors do not have; nothing where all are usual.
 * @param {any} drive as read @param {Book} book */
export function oddOf({ belt, criteria, conveyor, pulleys }, book) {
  const { take_up, standard, safety, sag } = criteria;
  const parts = { Belt: belt, TakeUp: take_up, DesignStandard: standard, SafetyFactors: safety };
  const laggings = pulleys.flatMap((/** @type {any} */ { lagging }) => [
    ["Lagging", lagging],
    ["Block", lagging.block],
  ]);
  const all = [...Object.entries(parts), ["Sag", sag], ["Conveyor", conveyor], ...laggings];
  for (const [name, of] of all)
    for (const [key, [low, high]] of Object.entries(book.sizes[name])) {
      const over = name === "Conveyor" && /^(belt|.*idler)_mass/.test(key) ? belt.width : 1;
      const v = of?.[key] / over;
      if (v && (v < low || (v > high && v < Number.POSITIVE_INFINITY)))
        return left(NOT_HERE[3], key);
    }
  if (!conveyor) return undefined;
  const [least, most] = book.load.map((/** @type {number} */ v) => v * belt.width ** 2);
  const heaped = conveyor.material < least || conveyor.material > most;
  const steep = Math.abs(conveyor.lift) > book.steepest * conveyor.length;
  return heaped || steep ? left(NOT_HERE[3], heaped ? "capacity" : "lift") : undefined;
}
/** @param {any} c as read @param {string} pulley @returns {Case} */
const caseAs = (c, pulley) => ({ ...c, ...pairOf(c.tensions.get(pulley)) });
/** @param {any} tensions */
const pairOf = ({ entry, exit }) => ({ entry, exit });
/** Why the page cannot judge an arc; 0 where it can. @param {any} made */
export const unjudgedOf = ({ prepared: { law, given }, criteria }) =>
  unjudged(law, numbersOf(given), numbersOf(criteria));
export const NOT_HERE = [
  "",
  "no belt carries these tensions, or friction falls too steeply for one answer; " +
    "wraparc solve says more",
  "no pull to carry, both tensions are equal; this page judges drives that pull, " +
    "wraparc solve does others",
  "a size or a tension that conveyor drives do not have: check the units; wraparc solve takes it",
];
/** @param {Said} said @param {Case} c @param {any} bookLaw @param {Book} book */
export function caseOf(said, c, bookLaw, book) {
  const { pulley, belt, lagging, takeUp, safety, sag, recovery } = said;
  const usual = book.usual;
  const limit = limitOf(said, book);
  const thick = said.thick(c.condition);
  const given = {
    ...Object.fromEntries(TENSIONS.map((key) => [key, none])),
    ...{ entry_tension: c.entry, exit_tension: c.exit },
    ...{ diameter: pulley.diameter, wrap_angle: pulley.wrap_angle, overrun: pulley.overrun },
    ...{ recovery: +recovery, width: belt.width, modulus: belt.modulus, speed: belt.speed },
    thickness: lagging.thickness,
    shear_modulus: lagging.shear_modulus,
    compression_modulus: lagging.compression_modulus,
    wear_coefficient: lagging.wear_coefficient,
    creep_limit: limit,
    steepest_fall: bookLaw.steepest_fall,
    slip_with_shear: +bookLaw.slip_with_shear,
    pitch_offset: thick.get("pitch_offset") ?? 0,
    cover_compliance: thick.get("cover_compliance"),
    mass: belt.mass,
    belt_speed: none,
  };
  const tested = bookLaw.tested;
  const standard = standardOf(said, bookLaw, book);
  const running = c.kind === "running";
  const share = Number.isNaN(sag?.share ?? none) ? usual.share : sag?.share;
  const factor = running || Number.isNaN(belt.factor) ? 1 : belt.factor;
  const strength = orUsual(belt.strength, strengthIn(belt.name));
  const customary = +(book.customary_safety[belt.kind] ?? none);
  const criteria = {
    safety: orUsual(safety[c.kind], usual[c.kind]),
    standard: standard.friction,
    factor: standard.factor,
    start: running ? orUsual(said.standard.start, usual.start_factor) : 1,
    belt_tension: factor * belt.rating,
    rating: belt.rating,
    strength,
    belt_safety: (strength && orUsual(strength / belt.rating, customary)) / factor,
    face_pressure: belt.pressure,
    bond_strength: lagging.bond_strength,
    fatigue_limit: lagging.fatigue_limit,
    slip_speed: tested ? +tested.slip_speed : none,
    balance: usual.balance,
    sag: sag ? (sag.line_mass * usual.gravity * sag.idler_spacing) / (8 * share) : none,
    pulley_diameter: belt.least,
    fixed: +(takeUp.kind === "fixed"),
    behind: +Boolean(takeUp.after),
    alone: 1,
    printed: +(
      ["", "CEMA"].includes(said.standard.name) && ["bare", "rubber"].includes(lagging.surface)
    ),
    customary: +(limit === usual.creep_limit),
    wrap_angle: Number.isNaN(standard.factor) ? none : pulley.wrap_angle,
    pulley_mass: pulley.mass,
    wet: bookLaw.condition === lagging.entry?.first ? +(lagging.entry?.wet ?? none) : 0,
  };
  const cover = thick.get("cover_left_out");
  const of = { said, c, law: bookLaw, standard, criteria, share, cover, book };
  const { checks, asks } = wordsOf(of);
  return {
    load_case: c.name,
    condition: bookLaw.condition,
    prepared: { law: bookLaw.law, given, inputs: [] },
    elsewhere: [],
    tested: tested && {
      pressure_min: +tested.pressure_min,
      pressure_max: +tested.pressure_max,
      slip_max: +tested.slip_max,
    },
    criteria,
    cover,
    checks,
    asks,
    tensions: described(given),
  };
}
/** @param {number} v @param {number} usual */
export const orUsual = (v, usual) => (Number.isNaN(v) ? usual : v);
/** @param {Said} said @param {Book} book */
const limitOf = ({ pulley, limit }, book) =>
  orUsual(pulley.creep_limit, orUsual(limit, book.usual.creep_limit));

/** @param {Said} said @param {BookLaw} law @param {any[]} cases @param {Book} book
 * @returns {Judging} */
export function judgingOf(said, law, cases, book) {
  const { takeUp } = said;
  const held = takeUp.kind === "fixed" ? "fixed" : takeUp.after ? "behind" : "slack";
  const data = dataWords(said, law, book);
  const checks = general(said, data, book);
  const names = named(said);
  return {
    levels: book.levels,
    qualifier: data.short,
    take_up: Boolean(takeUp.kind),
    least_name: filled(book.least_names[held], names),
    counterweight: orUsual(takeUp.ratio, book.usual.sheave_ratio) / book.usual.gravity,
    held_at: Number.NaN,
    checks,
    cases,
    odd: takeUp.kind
      ? book.words[`take_up:${takeUp.kind}${takeUp.after ? ":behind" : ""}`][0]
      : null,
    held,
    names,
    kinds: data.kinds,
  };
}
