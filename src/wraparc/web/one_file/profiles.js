// The profiles of all arcs as the table that `wraparc solve --csv` writes.
import { dimensionOf, unit } from "../static/base/units.js";

/** @import { Units } from "../static/types.d.ts" */
/** @typedef {{load_case: string, pulley: string, found: any}} Solved */

const PLACE = ["load_case", "pulley", "method"];
const METHOD = "distributed";
/** A name that no spreadsheet takes for a formula, quoted where it must be. @param {string} text */
function cell(text) {
  const plain = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return /[",\r\n]/.test(plain) ? `"${plain.replaceAll('"', '""')}"` : plain;
}
/** @param {Solved[]} all @param {Units} system */
export function profilesOf(all, system) {
  const names = Object.keys(all[0].found.profile);
  const units = names.map((name) => unit(dimensionOf(name), system));
  const lines = [[...PLACE, ...names.map((n, k) => (units[k][0] ? `${n} [${units[k][0]}]` : n))]];
  for (const { load_case, pulley, found } of all) {
    const { profile, solved } = found;
    const columns = names.map((name) => profile[name]);
    for (let i = 0; solved && i < columns[0].length; i++) {
      const numbers = columns.map((of, k) => String(+(+of[i] / units[k][1]).toPrecision(10)));
      lines.push([cell(load_case), cell(pulley), METHOD, ...numbers]);
    }
  }
  return `\ufeff${lines.map((line) => `${line.join(",")}\r\n`).join("")}`;
}
