// Effect of changes: other laggings, wraps and a tension, each solved and judged beside the page;
// and beside it the reserve of the verdict, where a server finds it.
import { app, caseNames, gripped, redraw, set } from "../../base/design.js";
import { part } from "../../base/server.js";
import { shown, trim, unit, words, written } from "../../base/units.js";
import { levelClass } from "../../parts/answers.js";
import { oneOf } from "../../parts/choose.js";
import { h } from "../../vendor/preact.js";
import { beside } from "./beside.js";
import { arcsOf, judge } from "./judge.js";
import { together } from "./judging.js";
import { raised } from "./load.js";
import { leastWrap } from "./ranges.js";
import { bones, glyph } from "./screen.js";
import { answer, known, whole, wholeArc } from "./solving.js";
import { button, take } from "./way.js";
import { verdictOf } from "./words.js";
import { rank } from "./worst.js";

/** @import { Children, Design, Level } from "../../types.d.ts" */
/** @import { Cause } from "./words.js" */
/** @typedef {{title: string, does: string, doc: Design}} Change
 * @typedef {{creep: number, level: Level, cause: Cause, text: string}} Effect
 *   creep [m] in the load case looked at, infinite where it slips; level, cause and text are of the
 *   verdict on the whole drive
 * @typedef {Change & {effect?: Effect | null}} Tried effect: undefined while it is solved, null
 *   where the page cannot */

const DEG = Math.PI / 180;
/** Wraps that the least one is found between [deg], and that are offered. */
const WRAPS = [150, 165, 180, 195, 210, 225, 240];
const OFFERED = [210, 240];
const DIGITS = 3;

/** What was tried last, of which arc, and by which limit. */
const last = {
  of: /** @type {unknown[]} */ ([]),
  all: /** @type {Tried[]} */ ([]),
  done: false,
  load_case: "",
  creep_limit: 0,
};
const now = () => [app.doc, app.pulley, app.units, answer.quick?.load_case];
const same = (/** @type {unknown[]} */ of) => now().every((v, i) => v === of[i]);

/** What is looked at here, and what draws the reserve: null where there is no server. */
const seen = {
  at: "effects",
  reserve: /** @type {typeof import("./reserve.js") | null} */ (null),
};
/** Find what is shown here for what is looked at. */
export function find() {
  findEffects();
  if (seen.reserve) seen.reserve.find?.();
  else if (whole()) fetchReserve();
}
let fetched = false;
async function fetchReserve() {
  if (fetched) return;
  fetched = true;
  seen.reserve = await part(() => import("./reserve.js")).catch(() => null);
  redraw();
}
/** Find the effects for what is looked at, once. */
async function findEffects() {
  const of = now();
  const { quick } = answer;
  const judged = whole() || answer.judgedDoc === app.doc;
  if (same(last.of) || gripped() || !quick || answer.quickDoc !== app.doc || !judged) return;
  const { creep_limit } = quick;
  const name = String(quick.load_case);
  Object.assign(last, { of, all: [], done: false, load_case: name, creep_limit });
  leastWrap.wrap = null;
  if (app.doc.pulley.length > 1 || !(quick.numbers.effective_tension > 0)) return;
  last.all = changes(quick.numbers);
  redraw();
  const found = [];
  for (const one of last.all) {
    found.push({ ...one, effect: await solved(one.doc, name) });
    if (!same(of)) return abandon(of);
  }
  await seekWrap(of, name, creep_limit);
  if (!same(of)) return abandon(of);
  Object.assign(last, { all: found, done: true }); // at once: nothing flickers
  redraw();
}
/** Something else is looked at: should that be what was looked at before, it is found anew.
 * @param {unknown[]} of */
function abandon(of) {
  if (last.of !== of) return;
  last.of = [];
  redraw();
}
/** @param {Record<string, number>} n @returns {Tried[]} */
function changes(n) {
  const { doc, pulley: i } = app;
  const name = doc.pulley[i].lagging?.preset ?? doc.pulley[i].lagging;
  const others = app.catalogue.laggings.filter((l) => l.name !== name);
  const wraps = OFFERED.filter((w) => w * DEG > n.wrap_angle * 1.02 || !n.wrap_angle);
  return [
    ...others.map(({ name, title }) => {
      const of = set(
        set(doc, ["pulley", i, "lagging"], name),
        ["pulley", i, "condition"],
        undefined,
      );
      const short = title.replace(/[,(].*/, "").trim();
      return { title: short, does: `Use ${short.toLowerCase()}.`, doc: of };
    }),
    ...wraps.map((w) => {
      const of = set(doc, ["pulley", i, "wrap_angle"], `${w} deg`);
      return { title: `Wrap ${w}°`, does: `Increase wrap to ${w} deg.`, doc: of };
    }),
    ...tension(),
  ];
}
/** The slack side at its minimum, each load case pulling as it does; none where that is no key of
 * the pulleys, or changes nothing. @returns {Tried[]} */
function tension() {
  const { doc } = app;
  const least = known()?.least_tension?.raise_to ?? wholeArc()?.raise_to;
  if (least == null || doc.conveyor || doc.train || doc.take_up?.kind === "fixed") return [];
  const [u, f] = unit("force");
  const step = 10 ** (Math.floor(Math.log10(least / f)) + 1 - DIGITS);
  const up = Math.ceil(((least / f) * (1 + 1e-7)) / step) * step; // a minimum is rounded up
  const of = raised(doc, 0, up * f);
  const text = `${trim(up)} ${u}`;
  return of === doc ? [] : [{ title: `T2 ${text}`, does: `Raise T2 to ${text}.`, doc: of }];
}
/** An arc of another drive, and the verdict on all of that.
 * @param {Design} doc @param {string} load_case @param {string} [only] a load case alone
 * @returns {Promise<Effect | null>} */
async function solved(doc, load_case, only) {
  const judging = await together(doc, only);
  const at = judging?.cases.findIndex((c) => c.load_case === load_case) ?? -1;
  const numbers = judging && at >= 0 && (await beside(arcsOf(judging)));
  if (!numbers) return null;
  const { level, cause, text } = verdictOf(judge(judging, doc, numbers));
  const { solved: rests, summary } = numbers[at];
  const creep = rests ? Math.abs(summary.exit_creep) : Number.POSITIVE_INFINITY;
  return { creep, level, cause, text: words(text) };
}
/** The least wrap that keeps the limit, between those that are tried. @param {unknown[]} of
 * @param {string} name @param {number} limit */
async function seekWrap(of, name, limit) {
  const creeps = [];
  for (const w of WRAPS) {
    const doc = set(app.doc, ["pulley", app.pulley, "wrap_angle"], written(w * DEG, "angle", 9));
    const found = await solved(doc, name, name);
    if (!same(of)) return;
    creeps.push(found ? Math.min(found.creep, 1) : Number.NaN);
  }
  const k = creeps.findIndex((c) => c <= limit);
  if (k < 1) return;
  const [a, b] = [Math.log(creeps[k - 1]), Math.log(creeps[k])];
  const f = (a - Math.log(limit)) / (a - b);
  leastWrap.wrap = DEG * (WRAPS[k - 1] + f * (WRAPS[k] - WRAPS[k - 1]));
}

/** A change with which all checks of all load cases pass, where no server offers one.
 * @returns {Children} */
export function cure() {
  const found = same(last.of) ? last.all.find((c) => c.effect?.level === "OK") : null;
  return found ? button(found.does, () => found.doc) : null;
}
/** Whether all was tried without one that passes. */
export const hopeless = () => same(last.of) && (last.done || app.doc.pulley.length > 1) && !cure();

/** Whether changes are tried at all: of one pulley that pulls. */
const tries = () =>
  app.doc.pulley.length < 2 && !((answer.quick?.numbers.effective_tension ?? 0) < 0);
/** Effects and reserve, one of them at a time. @returns {Children} */
export function pane() {
  const own = seen.reserve?.reserve;
  if (!own && !tries()) return [];
  const both = own && tries();
  const at = both ? seen.at : own ? "reserve" : "effects";
  const put = (/** @type {string} */ to) => {
    seen.at = to;
    redraw();
  };
  return [
    h(
      "h2",
      { key: "head" },
      both
        ? [h("span", { class: "away" }, TITLES[at]), oneOf("below-checks", "Shown", at, VIEWS, put)]
        : TITLES[at],
      h("span", {}, at === "effects" ? ofEffects() : "level changes at"),
    ),
    (at === "effects" ? effects() : own?.()) ?? (app.gone ? null : bones()),
  ];
}
/** @type {[string, string][]} */
const VIEWS = [
  ["effects", "Changes"],
  ["reserve", "Reserve"],
];
/** @type {Record<string, string>} */
const TITLES = { effects: "Effect of changes on creep", reserve: "Reserve" };
/** Whether the list is of now; while a hand moves something, that of before is. */
const isShown = () => same(last.of) || gripped();
/** Of which load case the numbers are, and their limit. */
function ofEffects() {
  if (!isShown() || !last.all.length) return "";
  const [, several] = caseNames(app.doc);
  return `${several ? last.load_case : "creep"} ≤ ${shown("exit_creep", last.creep_limit)}`;
}
/** @returns {Children} */
function effects() {
  if (!isShown()) return null;
  return h(
    "ul",
    { class: "ways", key: "ways" },
    last.all.map((c) => h("li", { key: c.title }, row(c))),
  );
}
/** What governs the drive with a change, where the number beside it does not say so itself.
 * @param {Effect} effect */
function causeIn({ creep, level, cause }) {
  const { name, label, load_case, found } = cause;
  if (rank({ level }) < 1) return "";
  if (load_case === last.load_case || !load_case)
    return name === "creep" && creep > last.creep_limit ? "" : label;
  return `${load_case}: ${name === "creep" && found ? words(found) : label}`;
}
/** @param {Tried} c */
function row({ title, does, doc, effect }) {
  if (!effect)
    return h(
      "span",
      { class: "way", title: effect === null ? "Needs the server." : "Solving …" },
      glyph(null),
      h("span", {}, title),
      h("i", {}),
      effect === null ? h("b", {}, "–") : h("b", { class: "bone", "aria-hidden": "true" }),
    );
  const { creep, level, text } = effect;
  const to = Number.isFinite(creep) ? shown("exit_creep", creep, 3) : "slips";
  const own = creep <= last.creep_limit ? "OK" : Number.isFinite(creep) ? "ATTENTION" : "FAILS";
  const press = () => take(doc, does);
  return h(
    "button",
    {
      type: "button",
      class: "way",
      disabled: gripped(),
      onClick: press,
      title: `${level}: ${text}`,
    },
    glyph(level),
    h("span", {}, title, h("span", { class: "away" }, `, ${level}`)),
    h("i", { class: levelClass(level) }, causeIn(effect)),
    " ",
    h("b", { class: levelClass(own) }, to),
  );
}
