// Numbers as the answers of Python print them, for what is translated of these.
import { app } from "../static/base/design.js";
import { quantity } from "../static/pages/drive/words.js";

const GIVEN = 4;
/** In the units looked at: a table is made once in each system.
 * @param {number} value @param {string} dimension @param {string} _system @param {number} [digits]
 */
export const display = (value, dimension, _system, digits = GIVEN) =>
  quantity(value, dimension, digits);
/** What the glossary has of a quantity. @param {string} name */
export const term = (name) => app.form.glossary[name];
