// A drive of one pulley put together in the page: what the server prepares of it, `judging` in
// web/answers, from the parts of the book that the server hands out, and by its functions.
import { isDrive } from "../../base/design.js";
import {
  compression__block_modulus as blockModulus,
  in_page__described as described,
  tension_rules__ends_of as endsOf,
  tension_rules__fault_of as faultOf,
  tension_rules__overridden as overridden,
  tension_rules__speed_missing as speedMissing,
  tension_rules__too_few as tooFew,
  in_page__unjudged as unjudged,
} from "../../kernel.js";
import { NO_RUNS, orNull, TENSIONS, tensionsBy } from "../../parts/problems.js";
import { numbersOf } from "./own.js";
import { Reader } from "./reading.js";
import { checkShape } from "./shape.js";
import { standardOf } from "./standard.js";
import { dataWords, filled, general, named, wordsOf } from "./wording.js";
import { quantity } from "./words.js";

/** @import { Book, BookLagging, BookLaw, Design, Judging } from "../../types.d.ts" */
/** @import { Path, Problem } from "../../types.d.ts" */
/** @import { Drum, Tensions } from "../../parts/problems.js" */

/**
 * What a document says, as numbers [SI] and choices.
 * @typedef {ReturnType<typeof read>} Said
 * @typedef {{name: string, kind: string, pulls: Tensions, condition: any}} Case
 */

const none = Number.NaN;
const HERE = "wraparc solve and wraparc serve do";
/** What a document has that only the program itself solves; empty for a drive of the page.
 * @param {Design} doc */
export function beyond(doc) {
  if (!isDrive(doc)) return "This is no drive: a belt and a pulley are needed.";
  if (doc.train || doc.pulley.length > 1)
    return `Pulleys that each give their tensions, without [train], are not solved here; ${HERE}.`;
  if (doc.conveyor)
    return `Tensions from the resistances of a conveyor are not found in this page; ${HERE}.`;
  const [pulley] = doc.pulley;
  if (pulley.across) return acrossOf(pulley);
  if (thickOf(doc)) return thickOf(doc);
  if (pulley.belt_path) return `A wrap angle from a belt path is not found in this page; ${HERE}.`;
  return "";
}

const THICK = [
  "pulley_cover",
  "carry_cover",
  "carcass",
  "thickness",
  "cover_shear_modulus",
  "mass",
];
/** What is said of a belt whose layers or mass are given; empty for none. @param {any} doc */
export const thickOf = ({ belt, pulley }) =>
  THICK.some((key) => belt?.[key] != null && belt[key] !== "") ||
  pulley.some((/** @type {any} */ p) => p.side != null && p.side !== "pulley")
    ? `Thickness, covers and mass of the belt are not counted in this page; ${HERE}.`
    : "";

/** What is said of a pulley whose load is uneven across the width. @param {any} pulley */
export const acrossOf = ({ name }) =>
  `The load across the width of pulley ${name} is not solved in this page, and there is no ` +
  "verdict without it. On the command line: wraparc solve FILE.";

/** @param {Design} doc @param {Book} book @param {Case[]} [known] cases that stand elsewhere */
export function read(doc, book, known) {
  const r = new Reader(doc);
  /** @param {string} section @param {Path} at @param {string[]} keys */
  const numbers = (section, at, ...keys) =>
    Object.fromEntries(keys.map((key) => [key, r.number(section, [...at, key])]));
  const pulley = numbers(
    "pulley",
    ["pulley", 0],
    "diameter",
    "wrap_angle",
    "overrun",
    "creep_limit",
    "mass",
  );
  const belt = beltOf(r, book);
  const lagging = laggingOf(r, book);
  const takeUp = {
    kind: r.choice("take_up", ["take_up", "kind"]),
    after: r.text(["take_up", "after"]),
    ratio: r.number("take_up", ["take_up", "sheave_ratio"]),
  };
  const name = r.text(["pulley", 0, "name"], true);
  if (doc.take_up?.after === "") r.wrong(["take_up", "after"], "must not be empty");
  if (takeUp.after && takeUp.after !== name)
    r.wrong(["take_up", "after"], `no such pulley; the pulley is "${name}"`);
  if (takeUp.after && takeUp.kind === "fixed")
    r.wrong(
      ["take_up", "after"],
      "a fixed take-up holds the sum of both tensions wherever it stands",
    );
  const standard = {
    name: r.choice("design_standard", ["design_standard", "name"]),
    condition: r.choice("design_standard", ["design_standard", "condition"]),
    friction: r.number("design_standard", ["design_standard", "friction"]),
    start: r.number("design_standard", ["design_standard", "start_factor"]),
    binding: r.flag(["design_standard", "binding"]) ?? false,
  };
  if ((standard.name === "own") === Number.isNaN(standard.friction))
    r.wrong(["design_standard", "friction"], ...OWN[+(standard.name === "own")]);
  if (standard.name === "none" && standard.binding)
    r.wrong(["design_standard", "binding"], "no standard was chosen that could bind");
  const safety = numbers("safety_factor", ["safety_factor"], "running", "starting", "braking");
  const sag = doc.sag && numbers("sag", ["sag"], "idler_spacing", "line_mass", "share");
  const limit = r.number("drive", ["creep_limit"]);
  const recovery = r.flag(["pulley", 0, "recovery"]) ?? true;
  const fixed = takeUp.kind === "fixed";
  const cases = known ?? casesOf(r, book, belt.speed, pulley.diameter, fixed);
  return { r, name, pulley, belt, lagging, takeUp, standard, safety, sag, limit, recovery, cases };
}
/** @type {[string, string][]} */
const OWN = [
  ["only a standard of your own has one", 'Write name = "own".'],
  ["missing, where the standard is your own", "Write friction = 0.30 beside it."],
];

/** @param {Reader} r @param {Book} book */
function beltOf(r, book) {
  const { belt } = r.doc;
  const number = (/** @type {string} */ key) => r.number("belt", ["belt", key]);
  const preset = belt.preset ? book.belts[belt.preset] : undefined;
  if (belt.preset && !preset)
    r.wrong(["belt", "preset"], "no such belt in the catalogue of this page");
  /** @param {string} key @param {number | string | undefined} known */
  const over = (key, known) => (belt[key] == null ? +(known ?? none) : number(key));
  const modulus = over("modulus", preset?.modulus);
  if (Number.isNaN(modulus) && belt.modulus == null && !belt.preset)
    r.wrong(["belt", "modulus"], "missing");
  number("in_plane_shear_stiffness"); // of no number here, and refused where it is none
  return {
    width: number("width"),
    speed: number("speed"),
    modulus,
    rating: over("rating", preset?.rating),
    strength: number("strength"),
    least: over("least_pulley_diameter", preset?.least_pulley_diameter),
    factor: number("momentary_factor"),
    pressure: number("largest_wrap_pressure"),
    kind: r.text(["belt", "kind"]) || preset?.kind || "",
    name: r.text(["belt", "name"]) || belt.preset || "belt",
    weak: preset ? preset.weak : weaknesses(belt.provenance),
  };
}
/** Breaking strength that the name of a steel-cord belt tells. @param {string} name */
export const strengthIn = (name) =>
  1e3 * +(/ST[ -]?(\d{3,5})\b/.exec(name.toUpperCase())?.[1] ?? none);
/** In what ways a number from a source is weak. @param {any} source @returns {string[]} */
export const weaknesses = (source) => [
  ...(String(source?.note ?? "").startsWith("estimated") ? ["estimated"] : []),
  ...(["illustrative", "calibrated"].includes(source?.kind) ? [source.kind] : []),
];

/** @type {Path} */
const AT = ["pulley", 0, "lagging"];
/** Numbers that a design may give in the place of those of a lagging. */
const PARTS = ["thickness", "shear_modulus", "compression_modulus"];
/** @param {Reader} r @param {Book} book */
function laggingOf(r, book) {
  const given = r.doc.pulley[0].lagging;
  const table = typeof given === "object" && given !== null ? given : { preset: given };
  const name = table.preset;
  const entry = book.laggings[name];
  const other = Object.keys(table).filter((key) => key !== "preset" && !PARTS.includes(key));
  if (name == null || name === "") r.wrong(AT, "missing");
  else if (!entry) r.wrong(AT, "no such lagging in this page", OTHERS);
  else if (other.length) r.wrong([...AT, other[0]], "not read in this page", OTHERS);
  const own = r.doc.lagging?.[name];
  if (own && JSON.stringify(own) !== JSON.stringify(book.own?.[name]))
    r.wrong(["lagging", name], "a lagging that this page was not made with", OTHERS);
  const over = PARTS.filter((key) => table[key] != null);
  const typed = Object.fromEntries(over.map((key) => [key, r.number("lagging", [...AT, key])]));
  const found = { ...sizes(entry), ...typed };
  const { block } = entry ?? {};
  if (block && over.includes("thickness") && !over.includes("compression_modulus"))
    found.compression_modulus = blockModulus(
      ...[block.elastic_modulus, block.square].map(Number),
      +block.width,
      Number.isNaN(+block.height) ? found.thickness : +block.height,
      +block.stiffening,
      +block.contact_fraction,
    );
  return { ...found, entry, over };
}
export const OTHERS =
  "Make the page anew with it, `wraparc page FILE`, or solve with `wraparc solve`.";
/** @param {BookLagging | undefined} entry */
const sizes = (entry) => ({
  thickness: +(entry?.thickness ?? none),
  shear_modulus: +(entry?.shear_modulus ?? none),
  compression_modulus: +(entry?.compression_modulus ?? none),
  wear_coefficient: +(entry?.wear_coefficient ?? none),
});

/** Load cases as they are solved. @param {Reader} r @param {Book} book @param {number} speed
 * @param {number} diameter @param {boolean} fixed @returns {Case[]} */
function casesOf(r, book, speed, diameter, fixed) {
  const { doc } = r;
  const drum = { diameter: orNull(diameter), speed: orNull(speed) };
  /** @param {Path} at */
  const pullsAt = (at) => tensionsBy((key) => r.number("tensions", [...at, key]));
  const base = pullsAt(["pulley", 0]);
  const sure = !r.problems.some((p) => /speed$/.test(p.path)); // else nothing is called missing
  const list = doc.load_case ?? [];
  /** @type {Case[]} */
  const found = [];
  if (!list.length || whole(base, drum)) {
    if (sure || list.length === 0) tell(r, ["pulley", 0], base, drum);
    found.push({ name: book.design, kind: "running", pulls: base, condition: undefined });
  }
  list.forEach((/** @type {any} */ c, /** @type {number} */ i) => {
    const at = ["load_case", i];
    const name = r.text([...at, "name"], true);
    const pulley = doc.pulley[0].name;
    const others = Object.keys(c.pulley ?? {}).filter((n) => n !== pulley);
    if (others.length) r.wrong([...at, "pulley", others[0]], "no such pulley");
    const over = pullsAt([...at, "pulley", pulley]);
    const pulls = overridden(base, over, fixed, drum, NO_RUNS);
    if (sure) tell(r, [...at, "pulley", pulley], pulls, drum, over);
    found.push({ name, kind: c.kind ?? "running", pulls, condition: c.condition });
    if (!["running", "starting", "braking"].includes(c.kind ?? "running"))
      r.wrong([...at, "kind"], "must be one of running, starting, braking");
  });
  const names = found.map((c) => c.name);
  const twice = names.find((n, i) => names.indexOf(n) < i);
  if (twice !== undefined) r.wrong(["load_case"], `"${twice}" names two load cases`);
  return inConditions(found, doc.condition);
}
/** Cases that name no condition stand once for each of several of the drive.
 * @param {Case[]} cases @param {any} conditions */
export function inConditions(cases, conditions) {
  if (!Array.isArray(conditions) || conditions.length < 2) return cases;
  return cases.flatMap((c) =>
    c.condition
      ? c
      : conditions.map((w) => ({ ...c, name: `${c.name}, ${w?.name ?? w}`, condition: w })),
  );
}
/** Whether the tensions follow from what is given. @param {Tensions} of @param {Drum} drum */
export function whole(of, drum) {
  const { entry, exit } = endsOf(of, drum);
  return entry !== null && exit !== null;
}
const force = (/** @type {number} */ v) => quantity(v, "force", 4);
/** @param {Reader} r @param {Path} at @param {Tensions} of @param {Drum} drum
 * @param {Tensions} [own] what the load case gives itself, where it takes over the rest */
export function tell(r, at, of, drum, own = of) {
  if (r.problems.some((p) => /_tension|torque|power/.test(p.path))) return;
  const inherited = TENSIONS.some((key) => of[key] !== null && own[key] === null);
  const lacking = () => speedMissing(of, drum) ?? (whole(of, drum) ? null : tooFew(of));
  const fault = faultOf(of, inherited, drum, force) ?? lacking();
  if (!fault) return;
  // what is missing has a field
  const missing = fault.lacks && ["entry_tension", "exit_tension"].find((key) => of[key] === null);
  r.wrong(missing ? [...at, missing] : at, fault.message, fault.remedy);
}

/** The law of a lagging in a condition. @param {Reader} r @param {BookLagging | undefined} entry
 * @param {any} condition @param {Path} at @returns {BookLaw | undefined} */
export function lawOf(r, entry, condition, at) {
  if (!entry) return undefined;
  if (condition == null) return entry.laws[entry.first];
  const key = typeof condition === "string" ? condition : JSON.stringify(condition);
  const law = entry.laws[key];
  if (!law) r.wrong(at, `friction of ${entry.name} in this condition is not known here`, OTHERS);
  return law;
}

/**
 * What a drive is judged by; or what is wrong with its document.
 * @param {Design} doc @param {Book} book
 * @returns {{judging: Judging | null, problems: Problem[]}}
 */
export function assemble(doc, book) {
  const not = beyond(doc);
  if (not)
    return { judging: null, problems: [{ path: "", message: not, sentence: not, beyond: true }] };
  const shape = new Reader(doc);
  checkShape(shape);
  if (shape.problems.length) return { judging: null, problems: shape.problems };
  const said = read(doc, book);
  const { r, lagging, cases } = said;
  const main = Array.isArray(doc.condition) ? doc.condition[0] : doc.condition;
  const usual = lawOf(r, lagging.entry, doc.pulley[0].condition ?? main, ["condition"]);
  const laws = cases.map((c) =>
    c.condition == null ? usual : lawOf(r, lagging.entry, c.condition, ["condition"]),
  );
  const made = r.problems.length ? [] : cases.map((c, i) => caseOf(said, c, laws[i], book));
  const steep = made.findIndex((m) => unjudgedOf(m));
  if (r.unusual && !r.problems.length) {
    r.wrong(r.unusual, NOT_HERE[3]);
    r.problems[0].beyond = true;
  } else if (steep >= 0) {
    const why = unjudgedOf(made[steep]);
    r.wrong(steepPath(doc, cases[steep]), NOT_HERE[why]);
    r.problems[r.problems.length - 1].beyond = why > 1;
  }
  if (r.problems.length || !usual) return { judging: null, problems: r.problems };
  return { judging: judgingOf(said, usual, made, book), problems: [] };
}
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
/** @param {Design} doc @param {Case} c @returns {Path} */
const steepPath = (doc, c) => {
  const i = (doc.load_case ?? []).findIndex((x) => x.name === c.name);
  return i < 0 ? ["pulley", 0] : ["load_case", i];
};

/** @param {Said} said @param {Case} c @param {any} bookLaw @param {Book} book */
export function caseOf(said, c, bookLaw, book) {
  const { pulley, belt, lagging, takeUp, safety, sag, recovery } = said;
  const usual = book.usual;
  const limit = limitOf(said, book);
  const given = {
    ...Object.fromEntries(TENSIONS.map((key) => [key, c.pulls[key] ?? none])),
    ...{ diameter: pulley.diameter, wrap_angle: pulley.wrap_angle, overrun: pulley.overrun },
    ...{ recovery: +recovery, width: belt.width, modulus: belt.modulus, speed: belt.speed },
    thickness: lagging.thickness,
    shear_modulus: lagging.shear_modulus,
    compression_modulus: lagging.compression_modulus,
    wear_coefficient: lagging.wear_coefficient,
    creep_limit: limit,
    steepest_fall: bookLaw.steepest_fall,
    slip_with_shear: +bookLaw.slip_with_shear,
    ...{ pitch_offset: 0, cover_compliance: 0, mass: none }, // see `thickOf`
  };
  const tested = bookLaw.tested;
  const standard = standardOf(said, bookLaw, book);
  const running = c.kind === "running";
  const share = Number.isNaN(sag?.share ?? none) ? usual.share : sag?.share;
  const factor = running || Number.isNaN(belt.factor) ? 1 : belt.factor;
  const criteria = {
    safety: orUsual(safety[c.kind], usual[c.kind]),
    standard: standard.friction,
    factor: standard.factor,
    start: running ? orUsual(said.standard.start, usual.start_factor) : 1,
    belt_tension: factor * belt.rating,
    rating: belt.rating,
    strength: orUsual(belt.strength, strengthIn(belt.name)),
    face_pressure: belt.pressure,
    bond_strength: +(lagging.entry?.bond_strength ?? none),
    fatigue_limit: +(lagging.entry?.fatigue_limit ?? none),
    slip_speed: tested ? +tested.slip_speed : none,
    balance: usual.balance,
    sag: sag ? (sag.line_mass * usual.gravity * sag.idler_spacing) / (8 * share) : none,
    pulley_diameter: belt.least,
    fixed: +(takeUp.kind === "fixed"),
    behind: +Boolean(takeUp.after),
    alone: 1,
    printed: +(
      ["", "CEMA"].includes(said.standard.name) &&
      ["bare", "rubber"].includes(lagging.entry?.surface ?? "")
    ),
    customary: +(limit === usual.creep_limit),
    wrap_angle: Number.isNaN(standard.factor) ? none : pulley.wrap_angle,
    pulley_mass: pulley.mass,
    wet: bookLaw.condition === lagging.entry?.first ? +(lagging.entry?.wet ?? none) : 0,
  };
  const of = { said, c, law: bookLaw, standard, criteria, share, book };
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
