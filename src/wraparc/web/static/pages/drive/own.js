// What the page answers itself while a slider moves: the server has prepared the numbers of the
// drive, those that are moved take their place. It shows numbers only; checks are the server's.
import { si } from "../../base/units.js";
import { in_page__quick as quick } from "../../kernel.js";

/** @import { Design, Input, Path, QuickAnswer } from "../../types.d.ts" */

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

/** The numbers of the drive with those that were moved; null where more has changed.
 * @param {Solved} base @param {Design} doc @returns {Record<string, number> | null} */
function moved({ doc: before, answer: { prepared } }, doc) {
  if (!prepared) return null;
  const given = Object.fromEntries(Object.entries(prepared.given).map(([n, v]) => [n, +v]));
  for (const [path, text] of changes(before, doc)) {
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
 * The answer for a document that differs from a solved one by moved numbers alone; null where it is
 * for the server.
 * @param {Solved} base @param {Design} doc @param {number} points @returns {QuickAnswer | null}
 */
export function ownAnswer(base, doc, points) {
  const before = base.answer;
  const given = moved(base, doc);
  const start = performance.now();
  const found = given && quick(before.prepared?.law, given, before.tested, points);
  performance.measure("own answer", { start });
  if (!found) return null;
  const { summary, profile, outside, stretches } = found;
  const names = Object.keys(before.numbers);
  return {
    ...before,
    own: true,
    status: found.solved ? "solved" : "breakaway",
    level: /** @type {any} */ (""),
    levels: {},
    creep_limit: given.creep_limit,
    numbers: Object.fromEntries(names.map((name) => [name, finite(summary[name])])),
    profile: Object.fromEntries(Object.keys(profile).map((name) => [name, [...profile[name]]])),
    outside: Array.from({ length: stretches }, (_, i) => [outside[2 * i], outside[2 * i + 1]]),
  };
}

/** Largest relative difference that counts as none; the balance is what rounding leaves. */
const SAME = 1e-9;
const REST = new Set(["identity_error"]);
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
