// Drives from elsewhere: new ones, examples, and in which view one is looked at first.
import { turnTo } from "../base/address.js";
import { app, blank, redraw } from "../base/design.js";
import { open } from "../base/drafts.js";
import { act, ask, note } from "../base/server.js";
import { h } from "../vendor/preact.js";
import { PAGES } from "./registry.js";

/** @import { Design } from "../types.d.ts" */

export function newDrive() {
  const doc = blank(app.units);
  open(doc, { units: app.units, begun: true });
  turnTo("drive");
  redraw();
}
/** @param {string} name */
export async function openExample(name) {
  const source = await ask(`examples/${name}`);
  const { document } = source;
  open(document, { name, source });
  showFirst(document);
}
/** Turn to the view in which a drive is looked at first: several pulleys as a train.
 * What happens to it in time is offered.
 * @param {Design} doc @param {string} [text] what was done */
export function showFirst(doc, text = "") {
  if (["drive", "train"].includes(app.page)) turnTo(doc.pulley.length > 1 ? "train" : "drive");
  const go = act(() => {
    turnTo("events");
    note("");
  });
  const offer = doc.motion &&
    PAGES.events && [" It has events. ", h("button", { type: "button", onClick: go }, "In time")];
  if (text || offer) note([text, offer]);
  redraw();
}
