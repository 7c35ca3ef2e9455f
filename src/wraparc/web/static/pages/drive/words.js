// What the checks of the page come to, in the words and digits of the server.
import { cellOf } from "../../base/digits.js";
import { words as shown } from "../../base/units.js";
import { cell__quantity as quantity } from "../../cells.js";
import { numbers__times_of as timesOf } from "../../kernel.js";

/** @import { Level, Table, TableRow, Verdict } from "../../types.d.ts" */
/** @import { Check, Judged } from "./judge.js" */

const [NOT_CHECKED, NONE] = ["NOT CHECKED", "-"];
/** As a check shows one, in as many digits as tell it from another. @param {number} v
 * @param {string} dimension @param {number} [against] */
const quantityText = (v, dimension, against = Number.NaN) =>
  Number.isFinite(v)
    ? cellOf(v, dimension, undefined, Number.isNaN(against) ? "slip" : "slip apart", against)
    : Number.isNaN(v)
      ? ""
      : quantity(v, dimension);
/** Value and limit. @param {Check} c */
function texts(c) {
  const { value, limit, dimension } = c;
  if (c.below) return [`below ${quantityText(limit, dimension)}`, quantityText(limit, dimension)];
  const apart = c.missed ? [limit, value] : [];
  return [quantityText(value, dimension, apart[0]), quantityText(limit, dimension, apart[1])];
}
/** @param {Check} c */
const bound = (c) =>
  Number.isNaN(c.limit) ? "" : `${c.at_most ? "at most" : "at least"} ${texts(c)[1]}`;

/** @param {string} text @param {Record<string, string>} names */
const filled = (text, names) =>
  text.replace(/\{\{|\}\}|\{(\w+)\}/g, (all, name) => (name ? names[name] : all[0]));

/** @param {Check} c */
function sentence(c) {
  const [value, limit] = texts(c);
  if (!c.says) {
    const most = bound(c);
    return value ? `${c.title}: ${value}${most && `, ${most}`}.` : `${c.title}.`;
  }
  const more = Object.entries(c.more).map(([name, [v, d]]) => [name, quantityText(v, d)]);
  const names = { ...Object.fromEntries(more), value, limit };
  return [c.says, c.remedy]
    .filter(Boolean)
    .map((t) => filled(t, names))
    .join(" ");
}
/** @param {string} t */
const capital = (t) => t.slice(0, 1).toUpperCase() + t.slice(1);
/** @param {string} t */
const small = (t) => t.slice(0, 1).toLowerCase() + t.slice(1);
/** @param {Check} c */
function placed(c) {
  const [where, said] = [capital(c.place), sentence(c)];
  return !where || said.startsWith(where) ? said : `${where}: ${said}`;
}

/** What could not be checked at one place stands before what is kept at another.
 * @param {Check} c */
const badness = (c) => (c.level === NOT_CHECKED ? 1.5 : c.rank);
/** The worse of two first. @param {Check} a @param {Check} b */
const byBadness = (a, b) =>
  badness(b) - badness(a) || (a.order < b.order ? -1 : +(a.order > b.order));
/** @param {Check[]} checks */
export const worstOf = (checks) =>
  checks.filter((c) => c.level !== NOT_CHECKED).sort(byBadness)[0] ?? null;
/** Each check once, where it comes off worst. @param {Check[]} checks */
export function listed(checks) {
  /** @type {Map<string, Check>} */
  const worst = new Map();
  for (const c of checks) {
    const held = worst.get(c.name);
    if (!held || byBadness(c, held) < 0) worst.set(c.name, c);
  }
  return [...worst.values()];
}
/** That checks are kept; of a drive computed dry only, what wet would give.
 * @param {number} count @param {number} wet @param {boolean} over */
function keeping(count, wet, over) {
  if (!(wet >= 0)) return `All ${count} checks are kept${wet < 0 ? "" : ", dry only"}`;
  const finite = Number.isFinite(wet);
  const creeps = `it creeps ${quantity(wet, "length", 3 + +over)}`;
  const told = `et ${finite ? creeps : "it slips through"}`;
  if (!over) return `All ${count} checks are kept, dry only (w${told})`;
  return `W${told}${finite ? ", beyond its limit" : ""}: all ${count} checks are kept dry only`;
}
/** @param {Check[]} checks @param {number} wet @param {boolean} over */
export function headline(checks, wet, over) {
  const worst = worstOf(checks);
  if (!worst) return "Nothing could be checked.";
  if (worst.missed) return placed(worst) + sense(checks);
  const text = keeping(listed(checks).filter(compares).length, wet, over);
  if (!Number.isFinite(worst.margin)) return `${text}.${sense(checks)}`;
  const where = worst.place ? ` (${worst.place})` : "";
  const near = `${small(worst.title)}, ${texts(worst)[0]}, ${bound(worst)}${where}`;
  return `${text}; nearest to its limit is ${near}.${sense(checks)}`;
}
/** Whether it is a row of the table of checks, and counted. @param {Check} c */
const compares = ({ name, level }) => !["data", "sense"].includes(name) && level !== NOT_CHECKED;
/** Which pulleys brake, and in how many of the load cases if not in all. @param {Check[]} checks */
function sense(checks) {
  const every = new Set(checks.map((c) => c.load_case).filter(Boolean)).size;
  const braking = checks.filter((c) => c.name === "sense").map((c) => c.title);
  return [...new Set(braking)]
    .map((title) => {
      const here = braking.filter((t) => t === title).length;
      return here < every ? ` ${title} in ${here} of ${every} load cases.` : ` ${title}.`;
    })
    .join("");
}

/** Whether a check is of an arc, or of the drive as a whole. @param {Check} c
 * @param {string} load_case @param {string} [pulley] */
const isOf = (c, load_case, pulley) =>
  (!c.load_case || c.load_case === load_case) && (!c.pulley || c.pulley === pulley);

/** The verdict on a drive, or on one of its load cases and pulleys. @param {Judged} judged
 * @param {string} [load_case] @param {string} [pulley]
 * @returns {Verdict & {levels: Record<string, Level>, short: string}} */
export function verdictOf({ checks: all, of, wet, over }, load_case, pulley) {
  const checks = load_case === undefined ? all : all.filter((c) => isOf(c, load_case, pulley));
  const worst = worstOf(checks);
  const level = worst?.level ?? "OK";
  const others = listed(checks).filter((c) => c.missed && c.name !== worst?.name);
  const sentences = others.sort(byBadness).map((c) => `${c.level}: ${placed(c)}`);
  if (worst?.missed && of.qualifier) sentences.push(`All of this stands ${of.qualifier}.`);
  const whole = checks.length === all.length;
  const ok = whole && !(wet < 0) ? "OK dry only" : "OK";
  const told = level !== "OK" ? level : of.qualifier ? `${ok}, ${of.qualifier}` : ok;
  const levels = listed(checks)
    .filter((c) => c.level !== NOT_CHECKED)
    .map((c) => [c.name, c.level]);
  const slips = checks.some((c) => c.when.startsWith("breakaway"));
  const short = slips ? "breaks away" : worst?.missed ? worst.short : "carries";
  const words = {
    level,
    word: told,
    action: "",
    headline: headline(checks, whole ? wet : -1, over),
    sentences,
    short,
  };
  return { ...words, levels: Object.fromEntries(levels) };
}

/** @param {Check} c */
function marginText({ margin: m, value, limit, below }) {
  if (below) return NONE;
  const times = timesOf(value, limit);
  if (!Number.isNaN(times)) return `${quantity(times, "number")} times the limit`;
  if (!Number.isFinite(m)) return NONE;
  if (m >= 0.9995 && m < 1 - 1e-9) return "> +99.9 %";
  if (Math.abs(m) < 1e-9) return "0 %";
  const r = (100 * m).toExponential(2);
  const [size, e] = r.split("e");
  const plain = +e >= -4 && +e < 3;
  const text = plain ? String(+r) : `${+size}e${e[0]}${e.slice(1).padStart(2, "0")}`;
  return `${m < 0 ? "" : "+"}${text} %`;
}
/** @param {Check} c @returns {TableRow} */
function row(c) {
  const cells = [texts(c)[0] || NONE, bound(c) || NONE, marginText(c)];
  const { name, title, place, level } = c;
  return { name, title, symbol: "", values: cells, note: place, level };
}
/** The checks of one arc that have a value and a limit, as bars. @param {Judged} judged
 * @param {string} load_case @param {string} [pulley]
 * @returns {import("../../types.d.ts").Bar[]} */
export const barsOf = ({ checks }, load_case, pulley) =>
  listed(checks.filter((c) => isOf(c, load_case, pulley)))
    .filter((c) => c.level !== NOT_CHECKED && !c.numerical)
    .filter((c) => Number.isFinite(c.value / c.limit))
    .map((c) => {
      const { name, title, level, place, at_most, value } = c;
      const [found, limit] = [texts(c)[0], bound(c)];
      const says = c.missed ? sentence({ ...c, remedy: "" }) : "";
      const share = value / c.limit;
      return { name, value, title, level, place, at_most, share, found, limit, says, source: "" };
    });
/** The checks as a table, in the place of one of the server.
 * @param {Judged} judged @param {Table} before @returns {Table} */
export function checkTable({ checks }, before) {
  const all = listed(checks);
  const rows = all.filter(compares).map(row);
  const left = all
    .filter((c) => c.level === NOT_CHECKED)
    .map((c) => {
      const found = texts(c)[0];
      return `${small(c.title)} (${found ? `${c.short}; here it is ${found}` : c.short})`;
    });
  const known = shown(before.note).split(" Not checked: ")[0];
  const more = left.length ? ` Not checked: ${left.join("; ")}.` : "";
  return {
    ...before,
    rows,
    note: known + more,
  };
}
