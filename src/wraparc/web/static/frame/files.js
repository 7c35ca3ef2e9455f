// Drives from elsewhere, and to keep: new ones, examples, downloads.
import { turnTo } from "../base/address.js";
import { app, blank, redraw, take } from "../base/design.js";
import { opened } from "../base/drafts.js";
import { ask, save } from "../base/server.js";

export function newDrive() {
  const doc = blank();
  opened(doc);
  take(doc, { units: app.units });
  turnTo("drive");
  redraw();
  document.getElementById("f-pulley-0-entry_tension")?.focus();
}
/** @param {string} name */
export async function openExample(name) {
  const { document } = await ask(`examples/${name}`);
  opened(document);
  take(document, { name, origin: { title: document.title || name, document } });
}
/** Name of a file of this design, without its ending. */
export const fileName = () =>
  (app.doc.title || app.name || "drive")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "") || "drive";
export async function download() {
  const { name, toml } = await ask("toml/write", { document: app.doc });
  save(name || `${fileName()}.toml`, toml, "application/toml");
}
