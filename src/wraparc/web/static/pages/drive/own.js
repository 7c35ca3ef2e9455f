// What the page answers itself while a slider moves: the server has prepared the numbers of the
// drive, those that are moved take their place.
import { si } from "../../base/units.js";
import { in_page__quick as quick } from "../../kernel.js";

/** @import { Assembled, Design, Input, Path, Prepared, QuickAnswer } from "../../types.d.ts" */

/** A document and what the server answered to it.
 * @typedef {{doc: Design, answer: QuickAnswer}} Solved */

/** @param {any} v */
const holds = (v) => typeof v === "object" && v !== null;
/** Where two documents differ, and what stands there in the second.
 * @param {any} from @param {any} to @param {Path} [at] @returns {Generator<[Path, any]>} */
function* changes(from, to, at = []) {
  if (from === to) return;
  const alike = holds(from) && holds(to) && Array.isArray(from) === Array.isArray(to);
  if (!alike) return yield [at, to];
  for (const key of new Set([...Object.keys(from), ...Object.keys(to)]))
    yield* changes(from[key], to[key], [...at, key]);
}
/** @param {number} value @param {Input} of */
const allowed = (value, { least, most, open }) =>
  (open ? value > +least : value >= +least) && value <= +most;

/** Numbers, where those that JSON has none for are words.
 * @param {Record<string, number | string>} of @returns {Record<string, number>} */
export const numbersOf = (of) => Object.fromEntries(Object.entries(of).map(([n, v]) => [n, +v]));
/** The numbers of an arc with those that were moved; null where more has changed.
 * @param {Design} before @param {Prepared | null} prepared @param {Design} doc
 * @param {Path[]} [elsewhere] what the arc has nothing from
 * @returns {Record<string, number> | null} */
export function moved(before, prepared, doc, elsewhere = []) {
  if (!prepared) return null;
  const given = numbersOf(prepared.given);
  for (const [path, text] of changes(before, doc)) {
    if (elsewhere.some((p) => p.join() === path.join())) continue;
    const input = prepared.inputs.find((i) => i.path.join() === path.join());
    const value = input && typeof text === "string" ? si(text, input.dimension) : Number.NaN;
    if (!input || !allowed(value, input)) return null;
    given[input.name] = value;
  }
  return given;
}
/** @param {number | undefined} v */
const finite = (v) => (Number.isFinite(v) ? v : null);

/**
 * The answer for a document that differs from a solved one by moved numbers alone, or that the page
 * has put together itself; null where it is for the server.
 * @param {Solved} base @param {Design} doc @param {number} points
 * @param {QuickAnswer | null} [judged] whose verdict stands until this one is judged
 * @param {Assembled["cases"][number] | null} [assembled] the arc as put together
 * @returns {QuickAnswer | null}
 */
export function ownAnswer(base, doc, points, judged, assembled) {
  const prepared = assembled?.prepared ?? base.answer.prepared;
  const given = assembled ? numbersOf(prepared?.given ?? {}) : moved(base.doc, prepared, doc);
  const { tested } = assembled ?? base.answer;
  const start = performance.now();
  const found = given && quick(prepared?.law, given, tested, points);
  performance.measure("own answer", { start });
  // without a pull all that is left is noise
  if (!given || !found?.summary.effective_tension) return null;
  const other = assembled && { load_case: assembled.load_case, pulley: doc.pulley[0].name, tested };
  return {
    ...base.answer,
    ...other,
    own: true,
    level: judged?.level ?? /** @type {any} */ (""),
    levels: judged?.levels ?? {},
    ...shownOf(found, Object.keys(base.answer.numbers)),
    creep_limit: given.creep_limit,
  };
}
/** What the page shows of a solved arc. @param {any} found @param {string[]} [names] of numbers */
export function shownOf({ solved, summary, profile, outside, stretches }, names) {
  const listed = names ?? Object.keys(summary);
  return {
    status: solved ? "solved" : "breakaway",
    numbers: Object.fromEntries(listed.map((name) => [name, finite(summary[name])])),
    profile: Object.fromEntries(Object.keys(profile).map((name) => [name, [...profile[name]]])),
    outside: Array.from(
      { length: stretches },
      (_, i) => /** @type {[number, number]} */ ([outside[2 * i], outside[2 * i + 1]]),
    ),
  };
}

/** Largest relative difference that counts as none; the balance is what rounding leaves. */
const SAME = 1e-9;
const REST = new Set(["identity_error"]);
/** Take the server's word on an answer of the page; false where that has other numbers.
 * @param {QuickAnswer} own @param {QuickAnswer} found */
export function confirmed(own, found) {
  const other = differences(own, found);
  const { profile, outside, ...rest } = found;
  if (!other.length) Object.assign(own, rest, { own: false });
  else console.error(`The page and the server differ in ${other.join(", ")}.`);
  return !other.length;
}
/** Numbers of an answer of the page that the server has found to be others.
 * @param {QuickAnswer} own @param {QuickAnswer} found */
export function differences(own, found) {
  if (own.status !== found.status) return ["status"];
  return Object.keys(own.numbers).filter((name) => {
    const [a, b] = [own.numbers[name], found.numbers[name]];
    if (a === null || REST.has(name)) return false; // what only the server finds
    return !(Math.abs(a - b) <= SAME * Math.max(Math.abs(a), Math.abs(b)));
  });
}
