// A link that holds the whole design. Fetched when the first is asked for.
import { packed } from "../base/address.js";
import { app } from "../base/design.js";
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
  if (!left) return note("The link is on the clipboard; it holds the whole design.");
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
