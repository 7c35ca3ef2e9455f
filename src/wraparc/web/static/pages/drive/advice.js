// What to do about a verdict, applied with one press.
import { app, caseNames, change, gripped, set } from "../../base/design.js";
import { noteUndo } from "../../base/removed.js";
import { trim, unit, words, written } from "../../base/units.js";
import { spec } from "../../parts/field.js";
import { place, TENSIONS } from "../../parts/problems.js";
import { h } from "../../vendor/preact.js";
import { raised } from "./load.js";
import { known, whole } from "./solving.js";

/** @import { Children, Design, FullArc } from "../../types.d.ts" */
/** @import { Way } from "../../api.d.ts" */

/** The design with all changes of a way. @param {Way} way @returns {Design} */
function changed({ changes }) {
  let doc = app.doc;
  for (const { key, to, unit } of changes) {
    const path = place(key);
    const name = String(path.at(-1));
    const { dimension } = spec(TENSIONS.includes(name) ? "tensions" : String(path[0]), name);
    const number = typeof to === "number" && unit !== null;
    doc = set(doc, path, number ? (dimension ? written(to, dimension, 9) : `${to} ${unit}`) : to);
  }
  return doc;
}
/** A button that makes all changes of the first way of the verdict; none where it has no way.
 * @returns {Children} */
export function offered() {
  const way = whole()?.verdict.action?.ways[0];
  if (!way) return null;
  const text = words(way.text);
  const apply = () => {
    change(changed(way));
    noteUndo(`${text} `, "");
  };
  const how = { type: "button", class: "main advice", key: "advice", disabled: gripped() };
  return h("button", { ...how, onClick: apply }, text);
}
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
const writable = () => {
  const { pulley, train, conveyor, take_up } = app.doc;
  if (conveyor || take_up?.kind === "fixed") return false;
  return train ? Array.isArray(train.share) && !take_up?.after : pulley.length === 1;
};
const ENDS = ["entry_tension", "exit_tension"];
/** @param {number} v */
const text = (v) => written(v, "force", 9);
/** Tensions before and behind all drives in every load case, by the answer. */
function endsOf() {
  const arcs = whole()?.arcs ?? [];
  return caseNames(app.doc).map((name) => {
    const here = arcs.filter((a) => a.load_case === name);
    return [here[0].numbers.entry_tension, here[here.length - 1].numbers.exit_tension];
  });
}
/** A train whose slack side is raised to at least a tension [N], each load case pulling as it does.
 * @param {Design} doc @param {number} least @returns {Design} */
function raisedTrain(doc, least) {
  const lifts = endsOf().map((ends) => Math.max(0, least - Math.min(...ends)));
  const lifted = endsOf().map((ends, k) => ends.map((v) => v + lifts[k]));
  /** @param {any} table @param {number[]} now */
  const put = (table, now) => ({
    ...table,
    ...Object.fromEntries(ENDS.flatMap((e, i) => (table[e] == null ? [] : [[e, text(now[i])]]))),
  });
  let next = set(doc, ["train"], put(doc.train, lifted[0]));
  (doc.load_case ?? []).forEach((/** @type {any} */ c, /** @type {number} */ k) => {
    const own = c.train ?? {};
    const apart = ENDS.some((e) => own[e] == null) && lifts[k + 1] !== lifts[0];
    const both = Object.fromEntries(ENDS.map((e, i) => [e, text(lifted[k + 1][i])]));
    const rest = Object.entries(own).filter(([key]) => !TENSIONS.includes(key));
    const table = apart ? { ...Object.fromEntries(rest), ...both } : put(own, lifted[k + 1]);
    if (Object.keys(table).length) next = set(next, ["load_case", k, "train"], table);
  });
  return next;
}
const DIVIDED_ANEW =
  "No button raises it: by speeds or motors the load divides anew with another tension, and that " +
  "number is of the load as it divides now. Give more of it on the page Train, and see.";
/** Which tension is that of the slack side, by the load cases that are to be raised.
 * @param {string} [only] */
function slackSide(only) {
  const arcs = known()?.arcs.filter((a) => only === undefined || a.load_case === only) ?? [];
  const first = arcs.map((a) => (a.numbers.effective_tension ?? 0) < 0);
  return first.every(Boolean) ? "T1" : first.some(Boolean) ? "the slack-side tension" : "T2";
}
/**
 * A button that raises the slack side to what the checks ask for; none where they give no number.
 * @param {number | null | undefined} tension @param {string} [only] the load case that it is for
 * @returns {Children}
 */
export function raise(tension, only) {
  if (tension == null) return null;
  if (app.doc.train && !Array.isArray(app.doc.train.share))
    return h("p", { class: "help", key: "advice" }, DIVIDED_ANEW);
  if (!writable()) return null;
  const train = Boolean(app.doc.train);
  if (train && !whole()) return null;
  const side = slackSide(only);
  const [least, shown] = enough(tension);
  const where = only === undefined ? "in every load case" : `in the load case ${only}`;
  const several = caseNames(app.doc).length > 1;
  const apply = () => {
    change(train ? raisedTrain(app.doc, least) : raised(app.doc, 0, least, only));
    noteUndo(
      `${side[0].toUpperCase()}${side.slice(1)} is now ${shown} or more ${where}; `,
      "Te is unchanged. ",
    );
  };
  const of = only === undefined && several ? " in every load case" : "";
  return h(
    "button",
    { type: "button", class: "main advice", key: "advice", onClick: apply, title: where },
    `Raise ${side} to ${shown}${of}`,
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
