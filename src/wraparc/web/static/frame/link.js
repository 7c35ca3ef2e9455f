// A link that holds the whole design. Fetched when the first is asked for or opened.
import { packed, through } from "../base/address.js";
import { app, isDrive } from "../base/design.js";
import { open } from "../base/drafts.js";
import { note } from "../base/server.js";
import { h } from "../vendor/preact.js";

/** Put the link on the clipboard; false where the browser allows it only over HTTPS. */
async function copyLink() {
  const { doc: d, units: u, pulley: p, case: c } = app;
  const link = `${location.origin}/#/drive/${await packed({ d, u, p, c })}`;
  try {
    await navigator.clipboard.writeText(link);
    return "";
  } catch {
    return link;
  }
}

/** Copy the link, or show it where the browser does not allow that. */
export async function copied() {
  const left = await copyLink();
  const without = app.source?.toml.includes("#") ? ", without the comments of its file" : "";
  if (!left) return note(`The link is on the clipboard; it contains the whole design${without}.`);
  const mark = (/** @type {any} */ e) => e.currentTarget.select();
  const box = {
    type: "text",
    readOnly: true,
    value: left,
    "aria-label": "Link",
    onFocus: mark,
    id: "link",
  };
  note([
    "This browser lets a page use the clipboard only over HTTPS. ",
    "The link, to be copied with Ctrl+C: ",
    h("input", box),
  ]);
  requestAnimationFrame(() => document.getElementById("link")?.focus());
}

/** @param {string} text */
async function unpacked(text) {
  const plain = atob(text.replace(/-/g, "+").replace(/_/g, "/"));
  const raw = Uint8Array.from(plain, (c) => c.charCodeAt(0));
  const bytes = await through(raw, new DecompressionStream("deflate-raw"));
  return JSON.parse(new TextDecoder().decode(bytes));
}
/** Open the design of a link; false if it holds none. */
export async function openLink() {
  try {
    const view = await unpacked(location.hash.split("/")[2]);
    if (!isDrive(view.d)) throw new Error();
    const had = Boolean(app.doc);
    open(view.d, { units: view.u === "us" ? "us" : "si", design: view.s });
    app.pulley = view.d.pulley[view.p | 0] ? view.p | 0 : 0;
    app.case = String(view.c || "");
    if (had) note("The design of the link is open; Undo brings back the one before.");
    return true;
  } catch {
    note("The link contains no readable design: it may have been cut short.", true);
    return false;
  }
}
