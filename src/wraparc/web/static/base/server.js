// Words with the server, and what is said of them on the page.
import { app, redraw } from "./design.js";

/** @import { Problem, Children } from "../types.d.ts" */

/** What the server refuses, in its own sentences; status 0 means that it did not answer. */
export class Refused extends Error {
  /** @param {Problem[]} problems @param {number} status */
  constructor(problems, status) {
    super(problems.map(sentence).join("\n"));
    this.problems = problems;
    this.status = status;
  }
}
/** @param {{sentence?: string, message: string}} p */
export const sentence = (p) => p.sentence || p.message;
/** Problems of something thrown; what is no refusal is thrown on. @param {unknown} x */
export function refusal(x) {
  if (!(x instanceof Refused) || x.status === 0) throw x;
  return x.problems;
}
/** Whether the server did not answer. @param {unknown} x */
export const unanswered = (x) => x instanceof Refused && x.status === 0;
/** @param {unknown} x */
export const aborted = (x) => x instanceof Error && x.name === "AbortError";
export const GONE = "The calculator does not answer: is `wraparc serve` still running?";

/**
 * @typedef {{method?: string, signal?: AbortSignal}} Asked
 * @param {string} path @param {any} [body] @param {Asked} [how]
 */
async function fetched(path, body, { method, signal } = {}) {
  const form = body instanceof FormData;
  const empty = body === undefined;
  try {
    const response = await fetch(`/api/v1/${path}`, {
      method: method || (empty ? "GET" : "POST"),
      headers: empty || form ? {} : { "Content-Type": "application/json" },
      body: form || empty ? body : JSON.stringify(body),
      signal,
    });
    if (app.gone) back();
    return response;
  } catch (x) {
    return dropped(x);
  }
}
/** No answer came, or half of one. @param {unknown} x @returns {never} */
function dropped(x) {
  if (aborted(x)) throw x;
  lost();
  throw new Refused([{ path: "", message: GONE }], 0);
}
/** @param {Response} response */
async function good(response) {
  if (response.ok) return response;
  /** @type {any} */
  let said = {};
  try {
    said = await response.json();
  } catch (x) {
    if (response.status === 500) dropped(x); // a server at its end: its own faults are JSON
  }
  const message = said.detail || `The server answered ${response.status}.`;
  throw new Refused(said.problems || [{ path: "", message }], response.status);
}
/**
 * Ask the server; JSON goes and comes.
 * @param {string} path @param {any} [body] @param {Asked} [how] @returns {Promise<any>}
 */
export async function ask(path, body, how) {
  const response = await good(await fetched(path, body, how));
  return response.status === 204 ? null : response.json().catch(dropped);
}
/** Ask for a file. @param {string} path @param {any} [body] @returns {Promise<[Blob, string]>} */
export async function askFile(path, body) {
  const response = await good(await fetched(path, body));
  const said = /filename="?([^";]+)/.exec(response.headers.get("Content-Disposition") || "");
  return [await response.blob(), said?.[1] || ""];
}

/** @type {Set<() => void>} */
const returns = new Set();
/** Be told when the server answers again. @param {() => void} f */
export const onReturn = (f) => returns.add(f);
function back() {
  app.gone = false;
  note("The calculator answers again.");
  redraw();
  for (const f of returns) f();
}
let looking = 0;
function lost() {
  if (!app.gone) {
    app.gone = true;
    redraw();
  }
  clearTimeout(looking);
  looking = setTimeout(() => ask("about").catch(() => {}), 1000);
}

/** @param {string} name @param {Blob | string} data @param {string} [type] */
export function save(name, data, type = "text/plain") {
  const url = URL.createObjectURL(data instanceof Blob ? data : new Blob([data], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 9000);
}

/** What is told in the corner of the page for a while. */
export const told = { text: /** @type {Children} */ (""), bad: false };
let hiding = 0;
/** @param {Children} text @param {boolean} [bad] */
export function note(text, bad = false) {
  Object.assign(told, { text, bad });
  clearTimeout(hiding);
  hiding = setTimeout(() => note(""), bad ? 12000 : 6000);
  redraw();
}
/**
 * Do something on a press; what goes wrong is told in words.
 * @template {Event} E @param {(e: E) => any} f @returns {(e: E) => Promise<void>}
 */
export const act = (f) => async (e) => {
  const button = e?.currentTarget instanceof Element ? e.currentTarget : null;
  button?.setAttribute("aria-busy", "true");
  try {
    await f(e);
  } catch (x) {
    complain(x);
  }
  button?.removeAttribute("aria-busy");
};
/** @param {unknown} x */
export function complain(x) {
  if (aborted(x)) return;
  note(x instanceof Error ? x.message : String(x), true);
  if (!(x instanceof Refused) && !(x instanceof Advice)) console.error(x);
}
/** Something the user can put right, in words. */
export class Advice extends Error {}
/** @template {any[]} A @param {number} wait @param {(...a: A) => any} f */
export const later = (wait, f) => {
  let timer = 0;
  return (/** @type {A} */ ...a) => {
    clearTimeout(timer);
    timer = setTimeout(() => f(...a), wait);
  };
};
