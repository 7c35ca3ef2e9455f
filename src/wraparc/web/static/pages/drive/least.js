// The least slack-side tension while a slider moves: what the checks ask for, and its words.
import { cellOf } from "../../base/digits.js";
import { cell__quantity as quantity } from "../../cells.js";

/** @import { Ask, Level, Table, TableRow } from "../../types.d.ts" */
/** @import { Judged } from "./judge.js" */

/** @typedef {Ask & {tension: number, given: number}} Figure */

/** Whether a is more than b, and not by rounding. @param {number} a @param {number} b */
const more = (a, b) => a > b && !(Math.abs(a - b) <= 1e-9 * Math.min(Math.abs(a), 1e300));

/** What every check asks for, where it asks for most. @param {Judged} judged */
function figuresOf({ arcs }) {
  /** @type {Map<string, Figure>} */
  const worst = new Map();
  for (const { asks, asked } of arcs)
    for (const ask of asks) {
      const none = ask.name === "design_standard" && ask.binding; // a rule that cannot be applied
      const tension = none && Number.isNaN(asked[ask.name]) ? Infinity : asked[ask.name];
      const held = worst.get(ask.name);
      if (Number.isNaN(tension)) continue;
      const [high, low] = ask.at_least ? [tension, held?.tension] : [held?.tension, tension];
      if (held && !more(Number(high), Number(low))) continue;
      worst.set(ask.name, { ...ask, tension, given: asked.given });
    }
  return [...worst.values()];
}
/** @param {Figure[]} all */
const governingOf = (all) =>
  all.filter((f) => f.binding && f.at_least).reduce((a, b) => (more(b.tension, a.tension) ? b : a));

/**
 * The least slack-side tension of a judged drive; null where nothing is asked for.
 * @param {Judged} judged
 */
export function leastOf(judged) {
  const all = figuresOf(judged);
  if (judged.of.adrift || !all.some((f) => f.binding && f.at_least)) return null;
  const governing = governingOf(all);
  const above = all.filter((f) => !f.at_least);
  const highest = above.length
    ? above.reduce((a, b) => (more(a.tension, b.tension) ? b : a))
    : null;
  const none = highest && highest.tension < governing.tension * (1 - 1e-9);
  return { all, governing, highest, tension: none ? Number.POSITIVE_INFINITY : governing.tension };
}
/** @typedef {NonNullable<ReturnType<typeof leastOf>>} Least */

/** @param {number} v */
const force = (v) => quantity(v, "force");
/** What is recommended, rounded to the safe side: it holds as it is shown. @param {number} v */
const atLeast = (v, of = "force") => cellOf(v, of, undefined, "up");
/** @param {number} v */
const atMost = (v) => cellOf(v, "force", undefined, "down");
/** @param {Least} l @param {Judged} judged */
function sentence(l, { of }) {
  const { governing: g, highest } = l;
  const name = of.least_name;
  if (Number.isFinite(l.tension)) {
    const asNow = of.anew ? ", the load divided as it is," : "";
    const text =
      `The least ${name} with which every binding check is kept${asNow} is ` +
      `${atLeast(l.tension)}, set by ` +
      `${g.what} (${g.place}); given ${force(g.given)}`;
    const rule = l.all.find((f) => f.name === "design_standard");
    if (!rule || l.tension >= rule.tension * (1 - 1e-9)) return `${text}.`;
    return `${text}; that is below the ${atLeast(rule.tension)} that ${rule.title} asks for.`;
  }
  if (g.tension === Infinity && g.name === "design_standard")
    return `No ${name} keeps every binding check: ${g.title} cannot be applied (${g.place}).`;
  if (!Number.isFinite(g.tension) || !highest) {
    const range = "with wrap pressures in the tested range keeps";
    return `No ${name} ${range} ${g.what} (${g.place}).`;
  }
  return (
    `No ${name} keeps every binding check: ` +
    `${g.what} asks for ${atLeast(g.tension)} (${g.place}), ` +
    `and ${highest.what} allows ${atMost(highest.tension)} (${highest.place}).`
  );
}
/** @param {string} title @param {string} value @param {string} note @param {string} [symbol]
 * @returns {TableRow} */
const row = (title, value, note, symbol = "") => {
  return { name: "", title, symbol, values: [value], note, level: null };
};
/** Tension of the belt where the take-up stands. @param {Least} l @param {Judged["of"]} of */
const takeUpTension = ({ tension, governing }, { held_at }) =>
  Number.isNaN(+held_at) ? tension : +held_at + tension - governing.given;
/** @param {Least} l @param {Judged} judged @param {Table} before @returns {Table} */
function tableOf(l, { of }, before) {
  const { governing: g } = l;
  const head = [];
  if (Number.isFinite(l.tension)) {
    const symbol = of.least_name === "slack-side tension" ? "T2_min" : "";
    const given = `given ${force(g.given)}`;
    head.push(row(`Least ${of.least_name}`, atLeast(l.tension), given, symbol));
    const mass = of.counterweight * takeUpTension(l, of);
    const weight = atLeast(mass, "mass");
    head.push(row("Counterweight for it", weight, "if the take-up is a weight"));
  }
  const rows = [...l.all].sort((a, b) => +b.at_least - +a.at_least || b.tension - a.tension);
  const asked = rows.map((f) => {
    const note = f === g ? "governs" : f.binding ? "" : "not binding";
    const shown = f.at_least ? atLeast : atMost;
    const text = Number.isFinite(f.tension) ? shown(f.tension) : "none";
    const title = `${f.title}, ${f.at_least ? "at least" : "at most"}`;
    return row(title, text, [note, f.place].filter(Boolean).join(", "));
  });
  return { ...before, rows: [...head, ...asked] };
}
/** As the server tells it. @param {Judged} judged
 * @param {import("../../types.d.ts").FullAnswer["least_tension"]} before */
export function leastTold(judged, before) {
  const found = before && leastOf(judged);
  if (!found) return null;
  const { tension, governing } = found;
  const level = /** @type {Level} */ (tension <= governing.given ? "OK" : "ATTENTION");
  const shown = Number.isFinite(tension) ? atLeast(tension) : "none";
  const table = tableOf(found, judged, before.table);
  const raise_to = raiseTo(judged);
  return { tension, raise_to, shown, sentence: sentence(found, judged), level, table };
}
/** The slack-side tension to raise to; null where nothing is to be raised.
 * @param {Judged} judged @param {Judged["arcs"]} [arcs] of some load cases alone */
export function raiseTo(judged, arcs = judged.arcs) {
  const found = leastOf({ ...judged, arcs });
  return found && Number.isFinite(found.tension) && found.tension > found.governing.given
    ? found.tension
    : null;
}
