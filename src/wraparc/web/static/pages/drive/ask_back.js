// What is asked where something is missing or of another unit. Fetched behind the first answer.
import { app } from "../../base/design.js";
import { factor, split, trim } from "../../base/units.js";
import { lined, linesOf } from "../../parts/answers.js";
import { idOf, seeking, spec } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";
import { said } from "./screen.js";
import { whole } from "./solving.js";
import { rank } from "./worst.js";

/** @import { Spec } from "../../types.d.ts" */

/** @param {string} text @param {() => void} onClick @param {string} cls */
const press = (text, onClick, cls) => h("button", { type: "button", class: cls, onClick }, text);
/** The load case that is looked at lacks tensions; the others are judged. @param {string[]} keys */
export function caseLacks([key = "entry_tension"]) {
  const { title, symbol } = spec("tensions", key);
  const others = whole()?.verdict;
  const missed = others && rank(others) > 0 ? [others, ...(others.also ?? [])] : [];
  const also = linesOf({ level: "OK", text: "", sentences: [], also: /** @type {any} */ (missed) });
  const at = idOf(["pulley", app.pulley, key]);
  const enter = () => document.getElementById(at)?.focus();
  const where = [app.doc.pulley[1] && app.doc.pulley[app.pulley].name, app.case].filter(Boolean);
  return said(
    "",
    `Missing: ${title} (${where.join(", ")}).`,
    lined([...also, ["Drawing", "Previous results."]]),
    press(`Enter ${symbol}`, enter, "main advice"),
  );
}
/** What may be meant by a number far from its usual size: the same number of another unit.
 * @param {Spec} of @param {string} text with its unit @returns {string | null} */
function meantBy({ dimension, usual }, text) {
  const found = usual && dimension ? split(text) : null;
  const own = found && dimension && factor(found.unit ?? "", dimension);
  if (!found || !own || !usual || !dimension) return null;
  const fits = (/** @type {number} */ f) =>
    found.number * f >= usual[0] && found.number * f <= usual[1];
  const { choices } = app.form.units[dimension];
  const all = choices.map((/** @type {string} */ c) => factor(c, dimension) ?? 0);
  const other = fits(own) ? null : all.find(fits);
  return other ? `${trim((found.number * other) / own)} ${found.unit}` : null;
}
seeking.hint = (of) => {
  const value = meantBy(of.props.spec, of.text().join(" "));
  const take = () => {
    of.setState({ draft: null });
    of.put(value);
  };
  return value && press(`${value}?`, take, "link");
};
