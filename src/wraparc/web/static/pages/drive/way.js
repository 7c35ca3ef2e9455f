// The first way of a verdict, applied with one press.
import { app, change, get, gripped, set } from "../../base/design.js";
import { noteUndo } from "../../base/removed.js";
import { words, written } from "../../base/units.js";
import { spec } from "../../parts/field.js";
import { place, TENSIONS } from "../../parts/problems.js";
import { h } from "../../vendor/preact.js";
import { whole } from "./solving.js";

/** @import { Children, Design } from "../../types.d.ts" */
/** @import { Way } from "../../api.d.ts" */

/** The design with all changes of a way. @param {Pick<Way, "changes">} way @returns {Design} */
export function changed({ changes }) {
  let doc = app.doc;
  for (const { key, to, unit } of changes) {
    const path = place(key);
    const name = String(path.at(-1));
    const { dimension } = spec(TENSIONS.includes(name) ? "tensions" : String(path[0]), name);
    const number = typeof to === "number" && unit !== null;
    const of = get(doc, path.slice(0, -1)); // a lagging by its name gets a number of its own
    if (typeof of === "string") doc = set(doc, path.slice(0, -1), { preset: of });
    doc = set(doc, path, number ? (dimension ? written(to, dimension, 9) : `${to} ${unit}`) : to);
  }
  return doc;
}
/** Take a design in, with a way back. @param {Design} doc @param {string} text */
export function take(doc, text) {
  change(doc);
  noteUndo(`${text} `);
}
/** @param {string} text @param {() => Design} doc */
export const button = (text, doc) =>
  h(
    "button",
    {
      type: "button",
      class: "main advice",
      key: "advice",
      disabled: gripped(),
      onClick: () => take(doc(), text),
    },
    text,
  );
/** A button that makes all changes of the first way of the verdict; none where it has no way.
 * @returns {Children} */
export function offered() {
  const way = whole()?.verdict.action?.ways[0];
  return way ? button(words(way.text), () => changed(way)) : null;
}
