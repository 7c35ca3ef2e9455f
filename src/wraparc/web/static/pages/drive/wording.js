// The words of the checks of an assembled drive: those of the book, with what it left open.
import { orUsual, strengthIn } from "./assemble.js";

/** @import { Ask, Book, BookLaw, Words } from "../../types.d.ts" */
/** @import { Case, Said } from "./assemble.js" */

const OPEN = /⟦(\w+)⟧/g;
/** A text with what was left open. @param {string} text @param {Record<string, string>} names */
export const filled = (text, names) => text.replace(OPEN, (all, name) => names[name] ?? all);
/** What stands for itself where braces hold places. @param {string} text */
const escaped = (text) => text.replace(/[{}]/g, (brace) => brace + brace);
/** @param {Record<string, string>} names */
const escapedAll = (names) =>
  Object.fromEntries(Object.entries(names).map(([key, text]) => [key, escaped(text)]));
/** @param {Words} w @param {Record<string, string>} names @returns {Words} */
export function put(w, names) {
  const safe = escapedAll(names);
  const says = (/** @type {any} */ of) => ({
    says: filled(of.says, safe),
    remedy: filled(of.remedy, safe),
    otherwise: filled(of.otherwise, safe),
    short: filled(of.short, names),
  });
  const [title, place] = [filled(w.title, names), filled(w.place, names)];
  return { ...w, title, place, ...says(w), miss: w.miss && { ...w.miss, ...says(w.miss) } };
}
/** As `%g` prints a number. @param {number} v */
const plain = (v) => String(+v.toPrecision(6));

/** @param {Said} said @returns {Record<string, string>} */
export const named = ({ name, lagging, belt }) => ({
  pulley: name,
  lagging: lagging.name,
  belt: belt.name,
});

/** Whether a belt may creep more than the customary limit: the key of the words that say so.
 * @param {Said["belt"]} belt @param {Book} book */
function quality({ kind, rating, name, strength }, book) {
  const least = +book.more_creep[kind];
  const steel = kind === "steel cord";
  if (Number.isNaN(least) || (Number.isNaN(rating) && !steel)) return "unknown";
  const strong = orUsual(orUsual(strength, strengthIn(name)), 0);
  const over = steel ? strong > least : rating > least * (1 + 1e-9);
  if (over) return "more";
  return steel && !strong ? "nameless" : "less";
}
/** What asks for a safety factor of the belt. @param {Said["belt"]} belt
 * @param {Record<string, number>} criteria */
const asked = ({ rating }, { strength, belt_safety }) =>
  Number.isNaN(strength)
    ? "none"
    : Number.isNaN(belt_safety)
      ? "unknown"
      : Number.isNaN(rating)
        ? "customary"
        : "rated";
/** @param {number} v */
const given = (v) => (Number.isNaN(v) ? "none" : "given");

/**
 * Checks and questions of one load case, in the order they are told.
 * @param {{said: Said, c: Case, law: BookLaw, standard: import("./standard.js").Asked,
 *   criteria: Record<string, number>, share: number, cover: number, book: Book}} of
 */
export function wordsOf({ said, c, law, standard, criteria, share, cover, book }) {
  const { belt, takeUp } = said;
  const names = {
    ...named(said),
    case: c.name,
    kind: c.kind,
    rule: standard.rule,
    why: standard.why,
    start: plain(criteria.start),
    factor: plain(belt.factor),
    share: plain(100 * share),
    safety: plain(criteria.safety),
  };
  const held = takeUp.kind === "fixed" ? "fixed" : takeUp.after ? "behind" : "slack";
  Object.assign(names, { take_up: filled(book.held[held], names) });
  const moving = Number.isNaN(belt.speed) ? "still" : "moving";
  const limit = criteria.customary ? quality(belt, book) : "given";
  const factor = Number.isNaN(belt.factor) ? "ungiven" : belt.factor === 1 ? "one" : "factor";
  const rated = Number.isNaN(belt.rating) ? "none" : c.kind === "running" ? "one" : factor;
  const keys = [
    "gross_slip",
    ...(standard.rule ? [standardKey(said, standard, c, criteria)] : []),
    `creep:${limit}`,
    ...(cover > 0 ? ["cover_creep"] : []),
    `belt_tension:${c.kind === "running" ? "running" : "starting"}:${rated}`,
    `belt_safety:${c.kind === "running" ? "running" : "starting"}:${asked(belt, criteria)}`,
    `face_pressure:${given(belt.pressure)}`,
    `bond_stress:${given(criteria.bond_strength)}`,
    `fatigue_stress:${given(criteria.fatigue_limit)}:${moving}`,
    `tested_pressure:${law.tested ? "given" : "none"}`,
  ];
  const after = [
    ...(law.tested
      ? ["tested_slip", `tested_slip_speed:${given(+law.tested.slip_speed)}:${moving}`]
      : []),
    "balance",
    `sag:${given(criteria.sag)}`,
    "sense",
  ];
  const words = (/** @type {string} */ key) => book.words[key];
  const all = [...keys.flatMap(words), ...law.checks, ...after.flatMap(words)];
  const checks = all.map((w) => put(w, names));
  return { checks, asks: asksOf(standard, said, criteria, names, book, law) };
}
/** @param {Said} said @param {import("./standard.js").Asked} asked @param {Case} c
 * @param {Record<string, number>} criteria */
function standardKey({ standard }, asked, c, criteria) {
  const started = criteria.start !== 1 && c.kind === "running";
  const silent = Boolean(asked.why);
  const binding = standard.binding && !(silent && !standard.name);
  return [
    "design_standard",
    standard.name && "named",
    binding && "binding",
    silent ? "silent" : started && "started",
  ]
    .filter(Boolean)
    .join(":");
}
/** What the checks ask of the take-up. @param {import("./standard.js").Asked} standard
 * @param {Said} said @param {Record<string, number>} criteria @param {Record<string, string>} names
 * @param {Book} book @param {BookLaw} law @returns {Ask[]} */
function asksOf(standard, { belt, standard: chosen }, criteria, names, book, law) {
  const has = {
    design_standard: standard.rule && (!standard.why || (chosen.binding && chosen.name)),
    tested_pressure_min: law.tested !== null,
    tested_pressure_max: law.tested !== null,
    face_pressure: !Number.isNaN(belt.pressure),
    belt_tension: !Number.isNaN(belt.rating),
    sag: !Number.isNaN(criteria.sag),
  };
  return Object.values(book.asks)
    .filter(({ name }) => has[/** @type {keyof typeof has} */ (name)] ?? true)
    .map((ask) => ({
      ...ask,
      title: filled(ask.title, names),
      place: filled(ask.place, names),
      binding: ask.name === "design_standard" ? chosen.binding : ask.binding,
    }));
}

/** On what data the answer stands. @param {Said} said @param {BookLaw} law @param {Book} book
 * @returns {{short: string, says: string, kinds: string[]}} */
export function dataWords({ weak }, law, book) {
  const whats = (/** @type {string} */ kind) =>
    weak.filter(([k]) => k === kind).map(([, of]) => of);
  const kinds = book.weak_kinds.filter((kind) => whats(kind).length);
  const told = kinds.map(
    (kind) => `${kind[0].toUpperCase()}${kind.slice(1)}: ${[...new Set(whats(kind))].join(", ")}.`,
  );
  const grounds = [...law.grounds, ...kinds];
  const short = Object.entries(book.grounds).find(([kind]) => grounds.includes(kind))?.[1] ?? "";
  return { short, says: escaped([...law.told, ...told].join(" ")), kinds: grounds };
}
/** Checks of the drive as a whole. @param {Said} said @param {{short: string, says: string}} data
 * @param {Book} book @returns {Words[]} */
export function general(said, { short, says }, book) {
  const keys = [`pulley_diameter:${given(said.belt.least)}`, "usual_sizes", "data"];
  const found = keys.flatMap((key) => book.words[key]).map((w) => put(w, named(said)));
  return found.map((w) => (w.name === "data" ? { ...w, short, says } : w));
}
