// What a check advises with a number, to be applied with one press.
import { app, change, undo } from "../../base/design.js";
import { note, told } from "../../base/server.js";
import { trim, unit } from "../../base/units.js";
import { h } from "../../vendor/preact.js";
import { raised } from "./load.js";
import { answer } from "./solving.js";

/** @import { Children, FullArc } from "../../types.d.ts" */

const DIGITS = 3;
/** A tension rounded up in the units looked at, so that what asks for it is kept: SI and text.
 * @param {number} v @returns {[number, string]} */
function enough(v) {
  const [u, f] = unit("force");
  const step = 10 ** (Math.floor(Math.log10(v / f)) + 1 - DIGITS);
  const up = Math.ceil(((v / f) * (1 + 1e-7)) / step) * step;
  return [up * f, `${trim(up)} ${u}`];
}
/** A tension on the slack side that the page knows how to write. */
const known = () => {
  const { pulley, train, conveyor, take_up } = app.doc;
  return pulley.length === 1 && !train && !conveyor && take_up?.kind !== "fixed";
};
/**
 * A button that raises the slack side to what the checks ask for; none where they give no number.
 * @param {number | null | undefined} tension @param {string} [only] the load case that it is for
 * @returns {Children}
 */
export function raise(tension, only) {
  if (tension == null || !known()) return null;
  const side = (answer.quick?.numbers.effective_tension ?? 0) < 0 ? "T1" : "T2";
  const [least, text] = enough(tension);
  const where = only === undefined ? "in every load case" : `in the load case ${only}`;
  const apply = () => {
    change(raised(app.doc, 0, least, only));
    const back = () => {
      undo();
      told.text = "";
    };
    note([
      `${side} is at least ${text} now ${where}; the pull is as it was. `,
      h("button", { type: "button", onClick: back }, "Undo"),
    ]);
  };
  const words = `Raise ${side} to ${text}${only === undefined ? "" : ` in ${only} alone`}`;
  return h(
    "button",
    { type: "button", class: "main advice", key: "advice", onClick: apply },
    words,
  );
}
/**
 * The same for one load case, where all together ask for what no tension keeps, and nothing holds
 * them to one tension.
 * @param {FullArc | undefined} arc @returns {Children}
 */
export function raiseAlone(arc) {
  const { take_up, load_case, condition } = app.doc;
  const apart = load_case?.length && !take_up && !Array.isArray(condition);
  return apart && arc ? raise(arc.raise_to, arc.load_case) : null;
}
