// The address holds page and design; a link opens the design, Back only turns the page.
import { app } from "./design.js";
import { later } from "./server.js";

/** @param {Uint8Array} bytes */
const base64 = (bytes) =>
  btoa(Array.from(bytes, (b) => String.fromCharCode(b)).join(""))
    .replace(/\+/g, "-")
    .replace(/\//g, "_")
    .replace(/=+$/, "");
/** @param {any} bytes @param {any} stream */
export const through = async (bytes, stream) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
/** @param {any} value */
export const packed = async (value) => {
  const bytes = new TextEncoder().encode(JSON.stringify(value));
  return base64(await through(bytes, new CompressionStream("deflate-raw")));
};
/** Entries of the history that this page wrote are its own: their design is not read again. */
const mine = () => history.state?.mine === true;
/** One window may show several pages of one file each. @param {string} key */
const here = (key) => `wraparc.${key} ${location.pathname}`;
/** What this window keeps over a reload; null if there is nothing. @param {string} key */
export function kept(key) {
  try {
    return JSON.parse(sessionStorage.getItem(here(key)) || "null");
  } catch {
    return null;
  }
}
/** @param {string} key @param {any} value */
export function keep(key, value) {
  try {
    sessionStorage.removeItem(here(key));
    sessionStorage.setItem(here(key), JSON.stringify(value));
  } catch {
    /* no room: a reload begins anew */
  }
}
/** Addresses that this window wrote last. @returns {string[]} */
const written = () => kept("addresses") || [];
const [load] = /** @type {PerformanceNavigationTiming[]} */ (
  performance.getEntriesByType("navigation")
);
/** Whether this window shows the page once more. A reload just as the address is written brings the
 * address before, without the state of its entry. */
export const again = mine() || (load?.type === "reload" && written().includes(location.hash));
/** @param {string} [to] */
function write(to) {
  history.replaceState({ mine: true }, "", to);
  keep("addresses", [location.hash, ...written()].slice(0, 4));
}
/** What the address holds was read. */
export const keepMine = () => write();
/** Keep page and design in the address, once the hand rests. */
export const keepAddress = later(250, async () => {
  const { doc: d, units: u, pulley: p, case: c, design, page } = app;
  const view = { d, u, p, c, s: design && { ...design, saved: undefined } };
  const text = await packed(view);
  // the address may have turned meanwhile: its entry of the history belongs to another page
  if (pageOfAddress() === page) write(`#/${page}/${text}`);
});
/** The page that is shown is not turned to once more: Back would stay on it.
 * @param {string} page */
export function turnTo(page) {
  if (page === app.page) return;
  history.pushState({ mine: true }, "", `#/${page}`);
  app.page = page;
}
export const pageOfAddress = () => location.hash.split("/")[1] || "drive";
/** Whether the address brings a design that this page did not write there. */
export const brought = () => !mine() && Boolean(location.hash.split("/")[2]);
