// Numbers and units: texts of the drive file in the units looked at, and answers as texts.
import { cell__cell_text as cellText, display__display as display } from "../cells.js";
import { h } from "../vendor/preact.js";
import { app } from "./design.js";

/** @import { Children, Text, Units } from "../types.d.ts" */

/** A number as the command line prints it. @param {number | null | undefined} v */
export const digits = (v, n = 3) => shownOr(v, () => display(v, "number", "si", n));
/** @param {number | null | undefined} v @param {() => string} text */
const shownOr = (v, text) =>
  v == null || Number.isNaN(v) ? "–" : Number.isFinite(v) ? text() : "unbounded";
/**
 * Unit of a dimension and its SI value, in the units looked at.
 * @param {string} dimension @param {Units} [system] @returns {[string, number]}
 */
export const unit = (dimension, system = app.units) => {
  const u = app.form.units[dimension]?.[system];
  return u ? [u.unit, u.factor] : ["", 1];
};
/** @param {string} name @param {string} dimension @returns {number | undefined} */
export const factor = (name, dimension) => app.form.units[dimension]?.factors?.[name];
/** @param {string} name @returns {string} */
export const dimensionOf = (name) => app.form.glossary[name]?.dimension || "number";
/** @param {string} name @returns {string} */
export const title = (name) => app.form.glossary[name]?.title || name;
/** Names of the key figures that have a place of their own there, in their order.
 * @param {string} place @returns {string[]} */
export const keyFigures = (place) =>
  app.form.key_figures
    .filter(({ elsewhere }) => !elsewhere.includes(place))
    .map(({ name }) => name);
/** @param {string} name */
export const symbol = (name) => sign(app.form.glossary[name]?.symbol);

/** @type {Record<string, string>} */
const GREEK = { phi: "φ", theta: "θ", tau: "τ", gamma: "γ", mu: "μ", eta: "η", omega: "ω" };
/**
 * A symbol as equations print it: Greek letters, what follows an underscore set low.
 * @param {string | undefined} text @returns {Children}
 */
export function sign(text) {
  const greek = /(phi|theta|tau|gamma|mu|omega|eta)(?![a-z])/g;
  const [first, ...low] = (text || "").replace(greek, (g) => GREEK[g]).split("_");
  return low.length ? [first, h("sub", {}, low.join(" "))] : first;
}

/**
 * Value [SI] with the unit that people read it in.
 * @param {number | null | undefined} v @param {string} dimension
 */
export const show = (v, dimension, n = 3) => shownOr(v, () => display(v, dimension, app.units, n));
/** @param {string} name @param {number | null | undefined} v @param {number} [n] */
export const shown = (name, v, n) => show(v, dimensionOf(name), n);
/** @param {number | null | undefined} v */
export const percent = (v, n = 3) => (v == null ? "–" : `${digits(100 * v, n)} %`);
/** A text in the units looked at: of the server, or with slots for its numbers.
 * @param {Text} text @returns {string} */
export function words(text) {
  if (!text || typeof text === "string")
    return (text || "").replace(SLOT, (slot, of, n, form, value, other) =>
      app.form.units[of] ? cellText(+value, of, +n, form, +other, app.units) : slot.slice(1, -1),
    );
  if (app.units === "si" || text.us) return (app.units === "us" && text.us) || text.text;
  if (!text.cells) return inUnits(text);
  const all = [...text.text];
  const parts = text.cells.map((cell, i) => {
    const from = text.cells[i - 1]?.at[1] ?? 0;
    return all.slice(from, cell.at[0]).join("") + inUnits(cell);
  });
  return parts.join("") + all.slice(text.cells.at(-1)?.at[1]).join("");
}
/** A number beside another: without its unit, where that has the same.
 * @param {Text} text @param {Text} other */
export function besideUnit(text, other) {
  const shown = words(text);
  const at = shown.indexOf(" ");
  return at > 0 && words(other).endsWith(shown.slice(at)) ? shown.slice(0, at) : shown;
}
const SLOT =
  // biome-ignore lint/suspicious/noControlCharactersInRegex: what no other text holds
  /\x02([a-z_]+)\|([1-9]\d?|0(?=\|[^|]*(?:fix|sign)ed\|))\|([a-z -]*)\|([^|]+)\|([^|]+)\|\w*\x03/g;
/** @param {import("../types.d.ts").Cell} cell */
const inUnits = ({ value, name = "", dimension, digits = 3, form = "", from, apart, error }) =>
  cellText(
    ...[value, dimension ?? dimensionOf(name), digits, form, from ?? apart ?? error ?? Number.NaN],
    app.units,
  );

const NUMBER = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(\S.*)?$/i;
/** Text of a quantity into its number and its unit, or null where it is none. @param {any} text */
export const split = (text) => {
  const m = NUMBER.exec(text ?? "");
  return m && { number: +m[1], written: m[1], unit: (m[2] || "").trim() };
};
/** @param {any} text @param {string} dimension */
export function si(text, dimension) {
  const q = split(text);
  const f = q ? factor(q.unit, dimension) : undefined;
  return !q || f === undefined ? Number.NaN : times(q.written, f);
}
/** A number as written, times a factor; a power of ten only moves the point.
 * @param {string} written @param {number} f */
function times(written, f) {
  const [digits, power = "0"] = written.toLowerCase().split("e");
  const ten = Math.round(Math.log10(f));
  return +`1e${ten}` === f ? +`${digits}e${+power + ten}` : +written * f;
}
/** @param {number} v */
export const trim = (v, n = 6) => String(+(+v).toPrecision(n));
/** Value [SI] as a text for the drive file. @param {number} v @param {string} dimension */
export const written = (v, dimension, n = 6) => {
  const [u, f] = unit(dimension);
  return `${trim(v / f, n)} ${u}`.trim();
};

const OF_US = new Set(
  ["in", "ft", "lbf", "klbf", "PIW", "psi", "ksi", "fpm", "fps", "hp"].concat([
    "lbf ft",
    "in2",
    "ft2",
    "lbm",
    "degF",
  ]),
);
const OF_BOTH = new Set(["", "%", "deg", "rad", "rpm", "rad/s"]);
/** Whether a unit belongs to the other system than the one looked at. @param {string} name */
const foreign = (name) => !OF_BOTH.has(name) && OF_US.has(name) !== (app.units === "us");
/**
 * A text of the drive file in the units looked at: number and unit. The file keeps what was typed.
 * @param {any} text @param {string} dimension @returns {[string, string]}
 */
export function viewed(text, dimension) {
  const q = split(text);
  const f = q ? factor(q.unit, dimension) : undefined;
  if (!q || f === undefined) return [String(text ?? ""), ""];
  if (!foreign(q.unit)) return [q.written, q.unit];
  const [u, k] = unit(dimension);
  return [trim((q.number * f) / k), u];
}
/** @param {string | number} time */
export const timeOf = (time) =>
  new Date(time).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });
