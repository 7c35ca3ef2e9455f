// Numbers as the answers of Python print them, for what is translated of these: in the units looked
// at, in which the page makes its tables.
import { app } from "../static/base/design.js";
import { quantity as shown } from "../static/pages/drive/words.js";

const [DIGITS, NONE] = [3, "-"];
/** @param {number} value @param {string} dimension @param {number} [digits] */
export const quantity = (value, dimension, digits = DIGITS) =>
  Number.isNaN(value) ? NONE : shown(value, dimension, digits);
/** @param {number} share @param {number} [digits] */
export const percent = (share, digits = DIGITS) =>
  Number.isNaN(share) ? NONE : `${shown(100 * share, "number", digits)} %`;
/** What the glossary has of a quantity. @param {string} name */
export const term = (name) => app.form.glossary[name];
/** In the units looked at: what is told so has the same ones in both systems.
 * @param {number} value @param {string} dimension @param {string} _system @param {number} digits
 */
export const display = (value, dimension, _system, digits) => shown(value, dimension, digits);
