// Drives from elsewhere, and to keep: new ones, examples, downloads.
import { turnTo } from "../base/address.js";
import { app, blank, redraw } from "../base/design.js";
import { open } from "../base/drafts.js";
import { ask, part } from "../base/server.js";

export function newDrive() {
  const doc = blank(app.units);
  open(doc, { units: app.units });
  turnTo("drive");
  redraw();
}
/** @param {string} name */
export async function openExample(name) {
  const source = await ask(`examples/${name}`);
  const { document } = source;
  open(document, { name, origin: { title: document.title || name, document }, source });
}
/** Name of a file of this design, without its ending. */
export const fileName = () =>
  (app.doc.title || app.name || "drive")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "") || "drive";
export const download = async () => (await part(() => import("./download.js"))).download();
