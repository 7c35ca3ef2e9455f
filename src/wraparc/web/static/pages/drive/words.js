// What the checks of the page come to, in the words and digits of the server.
import { app } from "../../base/design.js";
import { factor, LARGER_SI, LARGER_US, unit } from "../../base/units.js";
import { numbers__times_of as timesOf } from "../../kernel.js";

/** @import { Level, Table, TableRow, Units, Verdict } from "../../types.d.ts" */
/** @import { Check, Judged } from "./judge.js" */

const [NOT_CHECKED, NONE] = ["NOT CHECKED", "-"];
/** Units of speeds of slip. @type {Record<Units, [string, number]>} */
const SLIPS = { si: ["mm/s", 1e-3], us: ["in/s", 0.0254] };
const [DIGITS, MOST] = [3, 9];

/** A number as the server prints it. @param {number} v @param {number} n */
export function printed(v, n) {
  if (Math.abs(v) < 1e-9) return "0"; // what is left of a difference of equal numbers
  const given = v.toExponential(3);
  const [, power] = given.split("e");
  const plain = (/** @type {number} */ e) => e >= -4 && e < 12;
  const whole = n <= 4 && Math.abs(+given - v) <= 1e-9 * Math.abs(v);
  if (whole && plain(+power)) return String(+given);
  const r = v.toExponential(n - 1);
  const e = +r.split("e")[1];
  if (!plain(e)) return r.replace(/e([+-])(\d)$/, "e$10$2");
  return (+r).toFixed(Math.max(0, n - 1 - e));
}
/** The value that shows as a result does, rounded to the safe side: upwards, or down.
 * @param {number} v @param {string} dimension @param {boolean} up */
export function onSafeSide(v, dimension, up) {
  const size = unit(dimension)[1];
  const number = v / size;
  if (!Number.isFinite(number) || Math.abs(number) < 1e-9) return v;
  const r = +printed(number, DIGITS);
  if (Math.abs(r - number) <= 1e-9 * Math.max(Math.abs(r), Math.abs(number))) return v;
  const step = 10 ** (+r.toExponential(3).split("e")[1] - DIGITS + 1);
  return size * (r < number === up ? r + (up ? step : -step) : r);
}
/** @param {number} v @param {string} dimension */
export function quantity(v, dimension, n = DIGITS) {
  if (Number.isNaN(v)) return "";
  if (!Number.isFinite(v)) return "without bound";
  if (dimension === "speed" && Math.abs(v) < 0.1) {
    const [name, size] = SLIPS[app.units];
    return `${printed(v / size, n)} ${name}`;
  }
  let [name, size] = unit(dimension);
  const big = (app.units === "us" ? LARGER_US : LARGER_SI)[dimension];
  if (big && Math.abs(+printed(v / size, n)) * size >= big[0])
    [name, size] = [big[1], factor(big[1], dimension) ?? 1];
  return `${printed(v / size, n)} ${name}`.trim();
}
/** Value and limit in as many digits as tell them apart. @param {Check} c */
function texts(c) {
  if (c.below) {
    const limit = quantity(c.limit, c.dimension);
    return [`below ${limit}`, limit];
  }
  for (let n = DIGITS; ; n++) {
    const found = [quantity(c.value, c.dimension, n), quantity(c.limit, c.dimension, n)];
    if (found[0] !== found[1] || !c.missed || n === MOST) return found;
  }
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
  const more = Object.entries(c.more).map(([name, [v, d]]) => [name, quantity(v, d)]);
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
  const creeps = `it creeps ${quantity(wet, "length", DIGITS + +over)}`;
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
    told,
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
  return { name, title, symbol: "", values: { si: cells, us: cells }, note: place, level };
}
/** The checks of one arc that have a value and a limit, as bars. @param {Judged} judged
 * @param {string} load_case @param {string} [pulley]
 * @returns {import("../../types.d.ts").Bar[]} */
export const barsOf = ({ checks }, load_case, pulley) =>
  listed(checks.filter((c) => isOf(c, load_case, pulley)))
    .filter((c) => c.level !== NOT_CHECKED && !c.numerical)
    .filter((c) => Number.isFinite(c.value / c.limit))
    .map((c) => {
      const { title, level, place, at_most } = c;
      const [found, limit] = [texts(c)[0], bound(c)];
      const says = c.missed ? sentence({ ...c, remedy: "" }) : "";
      const share = c.value / c.limit;
      return { title, level, place, at_most, share, found, limit, says, source: "" };
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
  const note = typeof before.note === "string" ? before.note : (before.note?.[app.units] ?? "");
  const known = note.split(" Not checked: ")[0];
  const more = left.length ? ` Not checked: ${left.join("; ")}.` : "";
  return {
    ...before,
    rows,
    note: known + more,
  };
}
