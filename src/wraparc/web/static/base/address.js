// The address holds page and design; a link opens the design, Back only turns the page.
import { app, change, isDrive } from "./design.js";
import { later, note } from "./server.js";

/** @param {Uint8Array} bytes */
const base64 = (bytes) =>
  btoa(Array.from(bytes, (b) => String.fromCharCode(b)).join(""))
    .replace(/\+/g, "-")
    .replace(/\//g, "_")
    .replace(/=+$/, "");
/** @param {any} bytes @param {any} stream */
const through = async (bytes, stream) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
/** @param {any} value */
export const packed = async (value) => {
  const bytes = new TextEncoder().encode(JSON.stringify(value));
  return base64(await through(bytes, new CompressionStream("deflate-raw")));
};
/** @param {string} text */
async function unpacked(text) {
  const plain = atob(text.replace(/-/g, "+").replace(/_/g, "/"));
  const raw = Uint8Array.from(plain, (c) => c.charCodeAt(0));
  const bytes = await through(raw, new DecompressionStream("deflate-raw"));
  return JSON.parse(new TextDecoder().decode(bytes));
}

/** Entries of the history that this page wrote are its own: their design is not read again. */
export const mine = () => history.state?.mine === true;
/** Keep page and design in the address, once the hand rests. */
export const keepAddress = later(250, async () => {
  const { doc: d, units: u, pulley: p, case: c, design, page } = app;
  const view = { d, u, p, c, s: design && { ...design, saved: undefined } };
  const text = await packed(view);
  // the address may have turned meanwhile: its entry of the history belongs to another page
  if (pageOfAddress() === page) history.replaceState({ mine: true }, "", `#/${page}/${text}`);
});
/** @param {string} page */
export function turnTo(page) {
  history.pushState({ mine: true }, "", `#/${page}`);
  app.page = page;
}
export const pageOfAddress = () => location.hash.split("/")[1] || "drive";
/** Whether the address brings a design that this page did not write there. */
export const brought = () => !mine() && Boolean(location.hash.split("/")[2]);

/** Open the design of a link. */
export async function openLink() {
  try {
    const view = await unpacked(location.hash.split("/")[2]);
    if (!isDrive(view.d)) throw new Error();
    const had = Boolean(app.doc);
    app.units = view.u === "us" ? "us" : "si";
    app.design = view.s || null;
    app.origin = null;
    change(view.d);
    app.pulley = view.d.pulley[view.p | 0] ? view.p | 0 : 0;
    app.case = String(view.c || "");
    if (had) note("The design of the link is open; Undo brings back the one before.");
    return true;
  } catch {
    note("The link holds no design that can be read: it may have been cut short.", true);
    return false;
  }
}
