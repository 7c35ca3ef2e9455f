// The checks of a drive while a slider moves: numbers and levels by the functions of the server,
// translated; its words, with those numbers in them.
import { words } from "../../base/units.js";
import {
  numbers__beyond as beyond,
  numbers__held_alike as heldAlike,
  numbers__kept as kept,
  numbers__margin_of as marginOf,
  numbers__order_of as orderOf,
} from "../../kernel.js";
import { leastOf } from "./least.js";
import { moved, numbersOf } from "./own.js";
import { put } from "./wording.js";
import { headline, listed } from "./words.js";

/** @import { Asked } from "./numbers.js" */
/** @import { Ask, Design, FullAnswer, FullArc } from "../../types.d.ts" */
/** @import { Judging, Level, Miss, Words } from "../../types.d.ts" */

/**
 * @typedef {Words & {value: number, limit: number, margin: number, order: number, rank: number,
 *   missed: boolean, below: boolean, load_case: string,
 *   more: Record<string, [number, string]>}} Check
 * @typedef {{load_case: string, pulley?: string, solved: boolean,
 *   numbers: Record<string, number>, asks: Ask[], asked: Record<string, number>}} JudgedArc
 * @typedef {{doc: Design, checks: Check[], arcs: JudgedArc[], of: Judging,
 *   wet: number, over: boolean}} Judged
 */

/** Checks that more tension on the slack side helps against, and those that less does. */
const RAISING = [
  ...["gross_slip", "design_standard", "creep", "creep_interval", "tested_slip"],
  ...["tested_pressure_min", "sag"],
];
const LOWERING = [
  ...["belt_tension", "momentary_tension", "belt_safety"],
  ...["face_pressure", "tested_pressure_max"],
];
/** Relative difference that counts as none. */
const SAME = 1e-7;

/**
 * The arcs of a drive that differs from a solved one by moved numbers alone; null where it is for
 * the server.
 * @param {Design} before @param {FullAnswer} answer @param {Design} doc @returns {Asked[] | null}
 */
export function asked(before, { judging }, doc) {
  const found = (judging?.cases ?? []).flatMap((of) => {
    const given = moved(before, of.prepared, doc, of.elsewhere);
    return given ? [arcOf(of, given)] : [];
  });
  return judging && found.length === judging.cases.length ? found : null;
}
/** @param {Judging["cases"][number]} of @param {Record<string, number>} given @returns {Asked} */
const arcOf = ({ prepared, tested, criteria, cover, among }, given) => ({
  law: prepared.law,
  given,
  tested,
  criteria: numbersOf(criteria),
  cover,
  among,
});
/** The arcs of a drive as it is prepared. @param {Judging} judging */
export const arcsOf = ({ cases }) => cases.map((of) => arcOf(of, numbersOf(of.prepared.given)));
/**
 * Every check of a drive by the numbers of its arcs; null where it is for the server.
 * @param {Judging} judging @param {Design} doc @param {any[]} all @returns {Judged | null}
 */
export function judge(judging, doc, all) {
  const found = judging.cases.map((of, i) => ({ of, numbers: all[i] }));
  const held = found.map((f) => f.numbers.held);
  const odd = judging.take_up && !heldAlike(Math.min(...held), Math.max(...held));
  if (odd && !judging.odd) return null;
  const checks = found.flatMap(({ of, numbers }) => {
    const end = numbers.solved ? "solved" : "breakaway";
    const turn = numbers.summary.effective_tension < 0 ? "brakes" : "";
    const ends = ["", end, `${end}:${numbers.cause}`, `${end}:${numbers.covered}`, turn];
    const made = of.checks.filter((w) => ends.includes(w.when));
    return made.map((w) => check(w, numbers, of.load_case, judging.levels));
  });
  if (odd) checks.push(contradicts(judging, held));
  checks.push(...judging.checks.map((w) => check(w, found[0].numbers, "", judging.levels)));
  const arcs = found.map(({ of, numbers: n }) => {
    const numbers = { ...n.summary, ...n.capacities, ...n.loads };
    const { load_case, pulley, asks } = of;
    return { load_case, pulley, solved: n.solved, numbers, asks, asked: n.asked };
  });
  const wets = all.map((n) => n.wet);
  const dry = !wets.some((v) => v < 0);
  const wet = dry ? Math.max(...wets) : -1;
  const over = dry && all.some((n) => n.wet >= 0 && !kept(n.wet, n.limits.creep, true));
  const judged = { doc, checks, arcs, of: judging, wet, over };
  return { ...judged, checks: sound(checks, leastOf(judged)) };
}
/** Checks that advise no tension which does not help, or works against another check.
 * @param {Check[]} checks @param {ReturnType<typeof leastOf>} least */
function sound(checks, least) {
  const names = checks.filter((c) => c.missed).map((c) => c.name);
  const both = [RAISING, LOWERING].every((some) => names.some((name) => some.includes(name)));
  /** @param {Check} check */
  const helps = ({ name }) => {
    if (!least) return !both;
    const own = least.all.find((f) => f.name === name);
    const { highest: top, tension } = least;
    return Number.isFinite(tension) && !(own?.at_least && top && own.tension > top.tension);
  };
  return checks.map((c) =>
    c.missed && c.otherwise && !helps(c) ? { ...c, remedy: c.otherwise } : c,
  );
}
/** That the take-up cannot hold what load cases give. @param {Judging} judging
 * @param {number[]} held */
function contradicts({ odd, cases, levels, names }, held) {
  const [least, most] = [Math.min(...held), Math.max(...held)];
  const at = (/** @type {number} */ v) => cases[held.indexOf(v)].load_case;
  const words = put(/** @type {Words} */ (odd), { ...names, least: at(least), most: at(most) });
  words.more = { least: [least, "force"], most: [most, "force"] };
  return check(words, { values: {}, limits: {} }, "", levels);
}
/** What a check says that is not kept: it fails far beyond its limit, and says why; near to it
 * more may be allowed.
 * @param {Miss} miss @param {number} value @param {boolean} at_most */
function told(miss, value, at_most) {
  if (!beyond(value, +miss.fails_beyond, at_most))
    return value <= +miss.tolerates
      ? { ...miss, says: `${miss.says} ${miss.allows}`.trimEnd() }
      : miss;
  return { ...miss, level: /** @type {Level} */ ("FAILS"), says: `${miss.says} ${miss.because}` };
}
/** @param {Words} w @param {any} numbers @param {string} load_case @param {Level[]} levels
 * @returns {Check} */
export function check(w, { values, limits }, load_case, levels) {
  const { miss } = w;
  /** @param {Record<string, number>} from @param {string | number} known */
  const now = (from, known) =>
    miss || !Number.isNaN(+known) ? (from[w.name] ?? +known) : Number.NaN;
  const [value, limit] = [now(values, w.value), now(limits, w.limit)];
  const ok = { level: /** @type {Level} */ ("OK"), short: "", says: "", remedy: "", otherwise: "" };
  const said = miss ? (kept(value, limit, w.at_most) ? ok : told(miss, value, w.at_most)) : w;
  const { level, short, says, remedy, otherwise } = said;
  const rank = levels.indexOf(level);
  const missed = rank >= levels.indexOf("ATTENTION");
  const below = w.numerical && level === "OK"; // what rounding leaves
  const margin = below ? 1 : marginOf(value, limit, w.at_most);
  const leads = w.leads && level === "FAILS";
  const order = orderOf(margin, missed, w.binding, w.advises, leads);
  const more = Object.fromEntries(
    Object.entries(w.more).map(([name, [v, d]]) => [name, [values[name] ?? +v, d]]),
  );
  const found = {
    level,
    short,
    says,
    remedy,
    otherwise,
    value,
    limit,
    margin,
    order,
    rank,
    missed,
    below,
  };
  return /** @type {Check} */ ({ ...w, ...found, load_case, more });
}

/** In what a judgement of the page and the server's are not one.
 * @param {Judged} own @param {FullAnswer} found */
export function misses(own, { verdict, checks, arcs }) {
  const said = words(headline(own.checks, own.wet, own.over)) === words(verdict.headline);
  const ours = listed(own.checks).filter((c) => c.rank > 0 && !["data", "sense"].includes(c.name));
  const rows = checks.rows.map((r) => r.level).join() === ours.map((c) => c.level).join();
  const far = own.arcs.flatMap((a) => differing(a, arcs));
  return [...(said ? [] : ["verdict"]), ...(rows ? [] : ["checks"]), ...far];
}
/** @param {JudgedArc} a @param {FullArc[]} arcs */
function differing(a, arcs) {
  const there = arcs.find((b) => b.load_case === a.load_case)?.numbers ?? {};
  return Object.keys(a.numbers).filter((name) => {
    const [x, y] = [a.numbers[name], there[name]];
    if (y == null || name === "identity_error") return false; // without bound, or not found
    return !(Math.abs(x - y) <= SAME * Math.max(Math.abs(x), Math.abs(y)));
  });
}
