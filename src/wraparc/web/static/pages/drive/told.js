// Numbers as the answers of Python print them, for what is translated of these: in the units looked
// at, in which the page makes its tables.
import { app } from "../../base/design.js";
import { $sig } from "../../python.js";
import { onSafeSide, quantity as shown } from "./words.js";

const [DIGITS, MOST, NONE] = [3, 9, "-"];
/** @param {number} value @param {string} dimension @param {number} [digits] */
export const quantity = (value, dimension, digits = DIGITS) =>
  Number.isNaN(+value) ? NONE : shown(+value, dimension, digits);
/** As the class of this name, but that the text is made at once.
 * @param {number} value @param {string} dimension @param {number} [digits] @param {string} [form] */
export function cell(value, dimension, digits = DIGITS, form = "") {
  const safe = form === "up" || form === "down";
  return shown(safe ? onSafeSide(value, dimension, form === "up") : value, dimension, digits);
}
$sig(cell, ["value", "dimension", "digits", "form", "other", "name"]);
/** In as many digits as tell a value from another one, if that is given.
 * @param {number} value @param {string} dimension @param {number} [against] */
export function quantityText(value, dimension, against = Number.NaN) {
  if (Number.isNaN(+value)) return "";
  for (let n = DIGITS; ; n++) {
    const found = shown(+value, dimension, n);
    const apart = Number.isNaN(+against) || found !== shown(+against, dimension, n);
    if (apart || n === MOST) return found;
  }
}
/** @param {number} share @param {number} [digits] */
export const percent = (share, digits = DIGITS) =>
  Number.isNaN(share) ? NONE : `${shown(100 * share, "number", digits)} %`;
/** What the glossary has of a quantity. @param {string} name */
export const term = (name) => app.form.glossary[name];
/** In the units looked at: what is told so has the same ones in both systems.
 * @param {number} value @param {string} dimension @param {string} _system @param {number} digits
 */
export const display = (value, dimension, _system, digits) => shown(value, dimension, digits);
