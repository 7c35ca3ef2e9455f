// Effect of changes: other laggings, wraps and tensions, each solved beside the page.
import { app, gripped, redraw, set } from "../../base/design.js";
import { show, unit, written } from "../../base/units.js";
import { beside } from "./beside.js";
import { shownCase } from "./condition.js";
import { arcsOf, judge } from "./judge.js";
import { together } from "./judging.js";
import { movedTo } from "./load.js";
import { leastWrap } from "./ranges.js";
import { rank } from "./screen.js";
import { answer, whole, wholeArc } from "./solving.js";
import { verdictOf } from "./words.js";

/** @import { Design, Level } from "../../types.d.ts" */
/** @typedef {{title: string, does: string, doc: Design, creep: number, level: Level,
 *   helps: boolean}} Way
 *   creep [m], infinite where it slips; the level is that of the whole drive, and it helps if that
 *   is better than now, or less is missed and nothing new */

const DEG = Math.PI / 180;
/** Wraps that the least one is found between [deg], and that are offered. */
const WRAPS = [150, 165, 180, 195, 210, 225, 240];
const OFFERED = [210, 240, 270];
/** Of the slack side: how much more of it is tried, if the standard asks for no more. */
const MORE = 1.35;

/** What was found last, and of which arc. */
const last = { of: /** @type {unknown[]} */ ([]), all: /** @type {Way[]} */ ([]) };
const now = () => [app.doc, app.pulley, app.units, answer.quick?.load_case];
const same = (/** @type {unknown[]} */ of) => now().every((v, i) => v === of[i]);
/** Those of now; while a hand moves something, those of before. */
export const ways = () => (same(last.of) || gripped() ? last.all : []);

/** Find them for what is looked at, once. */
export async function find() {
  const of = now();
  const { quick } = answer;
  const judged = whole() || answer.judgedDoc === app.doc;
  if (same(last.of) || gripped() || !quick || answer.quickDoc !== app.doc || !judged) return;
  Object.assign(last, { of, all: [] });
  leastWrap.wrap = null;
  if (app.doc.pulley.length > 1 || !(quick.numbers.effective_tension > 0)) return;
  const found = [];
  const before = await solved(app.doc, String(quick.load_case));
  for (const [title, does, doc] of changes(quick.numbers)) {
    const told = await solved(doc, String(quick.load_case));
    if (!same(of)) return;
    const helps = Boolean(told && before && better(told, before));
    if (told) found.push({ title, does, doc, helps, ...told });
  }
  await seekWrap(of, String(quick.load_case), quick.creep_limit);
  if (!same(of)) return;
  last.all = found; // at once: a list that grows moves what is below it
  redraw();
}
/** @param {Record<string, number>} n @returns {[string, string, Design][]} */
function changes(n) {
  const { doc, pulley: i } = app;
  const name = doc.pulley[i].lagging?.preset ?? doc.pulley[i].lagging;
  const others = app.catalogue.laggings.filter((l) => l.name !== name);
  const wraps = OFFERED.filter((w) => w * DEG > n.wrap_angle * 1.02 || !n.wrap_angle).slice(0, 2);
  const [, kn] = unit("force");
  const least = wholeArc()?.bars.find((b) => b.name === "design_standard" && b.share < 1);
  const size = Math.max(n.exit_tension * MORE, least ? (1.01 * least.value) / least.share : 0);
  const more = kn * +(size / kn).toPrecision(2);
  const lift = more - n.exit_tension;
  const ends = [n.entry_tension + lift, more];
  return [
    ...others.map(({ name, title }) => {
      const of = set(
        set(doc, ["pulley", i, "lagging"], name),
        ["pulley", i, "condition"],
        undefined,
      );
      const short = title.replace(/[,(].*/, "").trim();
      return /** @type {[string, string, Design]} */ ([short, `Use ${short.toLowerCase()}`, of]);
    }),
    ...wraps.map((w) => {
      const of = set(doc, ["pulley", i, "wrap_angle"], `${w} deg`);
      return /** @type {[string, string, Design]} */ ([`Wrap ${w}°`, `Wrap ${w}°`, of]);
    }),
    [
      `T2 ${show(more, "force", 3)}, same Te`,
      `Raise T2 to ${show(more, "force", 3)}`,
      movedTo(doc, i, shownCase(i), ends, 9),
    ],
  ];
}
/** Whether the verdict is better, or less is missed, nothing that was not, and nothing fails.
 * @typedef {{level: Level, levels: Record<string, Level>}} Judged @param {Judged} after
 * @param {Judged} before */
function better(after, before) {
  const now = (/** @type {string} */ name) => rank({ level: before.levels[name] ?? "OK" });
  const all = Object.entries(after.levels).map(([name, level]) => rank({ level }) - now(name));
  const less = all.every((d) => d <= 0) && all.some((d) => d < 0);
  return rank(after) < rank(before) || (less && after.level === "ATTENTION");
}
/** An arc of another drive, and the verdict on that, or on one load case of it alone.
 * @param {Design} doc @param {string} load_case @param {string} [only] */
async function solved(doc, load_case, only) {
  const judging = await together(doc, only);
  const at = judging?.cases.findIndex((c) => c.load_case === load_case) ?? -1;
  const numbers = judging && at >= 0 && (await beside(arcsOf(judging)));
  if (!numbers) return null;
  const { level, levels } = verdictOf(judge(judging, doc, numbers));
  const { solved: rests, summary } = numbers[at];
  return { creep: rests ? Math.abs(summary.exit_creep) : Number.POSITIVE_INFINITY, level, levels };
}
/** The least wrap that keeps the limit, between those that are tried. @param {unknown[]} of
 * @param {string} name @param {number} limit */
async function seekWrap(of, name, limit) {
  const creeps = [];
  for (const w of WRAPS) {
    const doc = set(app.doc, ["pulley", app.pulley, "wrap_angle"], written(w * DEG, "angle", 9));
    const told = await solved(doc, name, name);
    if (!same(of)) return;
    creeps.push(told ? Math.min(told.creep, 1) : Number.NaN);
  }
  const k = creeps.findIndex((c) => c <= limit);
  if (k < 1) return;
  const [a, b] = [Math.log(creeps[k - 1]), Math.log(creeps[k])];
  const f = (a - Math.log(limit)) / (a - b);
  leastWrap.wrap = DEG * (WRAPS[k - 1] + f * (WRAPS[k] - WRAPS[k - 1]));
}
