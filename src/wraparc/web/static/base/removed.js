// What a press takes out of the design is named, and Undo brings it back.
import { h } from "../vendor/preact.js";
import { app, change, set, undo } from "./design.js";
import { lostParts } from "./lost_parts.js";
import { act, note, told } from "./server.js";

/** @import { Children, Design } from "../types.d.ts" */

/** Say what was done, with a button that undoes it. @param {() => any} back
 * @param {Children[]} text */
export function noteBack(back, ...text) {
  const press = act(() => {
    told.text = "";
    return back();
  });
  note([...text, h("button", { type: "button", onClick: press }, "Undo")]);
}
/** The same of the last change of the design. @param {Children[]} text */
export const noteUndo = (...text) => noteBack(undo, ...text);
/**
 * Put a document in the place of the present one, and name what it no longer has.
 * @param {Design} doc @param {string[]} [moved] keys whose values stand elsewhere in it
 */
export function changeNaming(doc, moved = []) {
  const lost = lostParts(app.doc, doc, moved);
  change(doc);
  if (lost.length) noteUndo(`Removed: ${lost.join(", ")}. `);
}
/** Another lagging on a pulley: a condition of the one before means nothing for it.
 * @param {number} i @param {string} name @param {Design} [doc] that has it */
export const putLagging = (i, name, doc = app.doc) =>
  changeNaming(
    set(
      set(doc, ["pulley", i, "lagging"], name || undefined),
      ["pulley", i, "condition"],
      undefined,
    ),
    ["preset"],
  );
