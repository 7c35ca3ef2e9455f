// What Python writes of numbers and JavaScript otherwise, for what is translated (cells.js).
import { app } from "./design.js";

/** What values of a dimension are shown in. @param {string} dimension @param {string} system */
export const unitRow = (dimension, system) => app.form.units[dimension][system];
/** The slot of a number in a text. @param {number} value @param {string} dimension
 * @param {number} [digits] @param {string} [form] @param {number} [other] @param {string} [name] */
export const cellOf = (value, dimension, digits = 3, form = "", other = Number.NaN, name = "") =>
  `\x02${[dimension, digits, form, value, other, name].join("|")}\x03`;
/** A tie goes to the even digit; one is written in no more digits than it needs.
 * @param {number} x @param {number} digits */
export function scientific(x, digits) {
  let [text, power] = x.toExponential(digits).split("e");
  const [least] = Math.abs(x).toExponential().split("e");
  if (least.length === digits + 3 && least.endsWith("5")) {
    const all = x.toExponential(100);
    const at = all.indexOf(".") + 1 + digits;
    if (/^50*e/.test(all.slice(at)) && +all[at - 1] % 2 === 0) text = all.slice(0, at);
  }
  return `${text}e${power.replace(/^(.)(.)$/, "$10$2")}`;
}
/** @param {string} text */
export const exponentOf = (text) => +text.split("e")[1];
/** @param {number} x @param {number} digits */
export const decimal = (x, digits) => x.toFixed(digits);
/** @param {string} text */
export const trimmed = (text) => text.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
/** Whole digits in groups of three. @param {string} text */
export const grouped = (text) => text.replace(/\B(?=(\d{3})+$)/g, ",");
