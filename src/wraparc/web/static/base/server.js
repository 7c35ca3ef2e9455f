// Words with the server, and what is said of them on the page.
import { app, redraw } from "./design.js";
import { proof, subtle, token } from "./proof.js";

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
export const GONE = "The server does not answer.";
/** A server that is as long silent [ms] is asked whether it is there at all. */
const SILENT = 10_000;
/** Pauses between questions whether it is there again [ms]: each twice the one before. */
const FIRST = 1000;
const LAST = 5000;
export const AGAIN = "Asked again every 5 s.";

/**
 * @typedef {{method?: string, signal?: AbortSignal}} Asked
 * What waits for an answer, and since when [ms]; all is given up when the server is gone.
 * @type {Map<AbortController, number>}
 */
const waiting = new Map();
const SECOND = 1000;
/** Seconds that the oldest question waits for its answer. */
export const waited = () =>
  Math.floor((performance.now() - Math.min(...waiting.values())) / SECOND) || 0;
/** Give up what waits: the server ends what it does for it. */
export function cancel() {
  for (const one of waiting.keys()) one.abort(CANCELLED);
}
const CANCELLED = "Cancelled.";
/**
 * Ask the server, and read its answer; no answer, half of one and a server at its end are one.
 * @template T @param {string} path @param {any} body @param {Asked} how
 * @param {(response: Response) => Promise<T>} read @returns {Promise<T>}
 */
async function answered(path, body, { method, signal }, read) {
  const form = body instanceof FormData;
  const empty = body === undefined;
  const own = new AbortController();
  const stop = () => own.abort();
  signal?.addEventListener("abort", stop);
  waiting.set(own, performance.now());
  const told = setInterval(redraw, SECOND);
  const silent = setInterval(askAgain, SILENT);
  try {
    signal?.throwIfAborted();
    await proved();
    const response = await fetch(`/api/v1/${path}`, {
      method: method || (empty ? "GET" : "POST"),
      headers: {
        ...(token() && { Authorization: `Bearer ${token()}` }),
        ...(!empty && !form && { "Content-Type": "application/json" }),
      },
      body: form || empty ? body : JSON.stringify(body),
      signal: own.signal,
    });
    const found = await (response.ok ? read(response) : refused(response));
    back(response);
    return found;
  } catch (x) {
    if (x instanceof Refused || signal?.aborted) throw x;
    if (own.signal.reason === CANCELLED) throw new Refused([{ path: "", message: CANCELLED }], 499);
    lost();
    throw new Refused([{ path: "", message: GONE }], 0);
  } finally {
    clearInterval(told);
    clearInterval(silent);
    waiting.delete(own);
    if (!waiting.size) redraw();
    signal?.removeEventListener("abort", stop);
  }
}
let proving = /** @type {Promise<any> | null} */ (null);
/** Be sure that the server is that of this window, before it is sent anything. */
function proved() {
  if (!token() || !subtle) return null;
  const stop = new AbortController();
  if (!proving) waiting.set(stop, performance.now());
  proving ??= same(stop.signal).finally(() => {
    proving = null;
    waiting.delete(stop);
  });
  return proving;
}
/** @param {AbortSignal} signal */
async function same(signal) {
  const [is, response] = await proof(token(), signal);
  app.stranger = !is;
  if (is) return response;
  redraw();
  throw new Error();
}
/** What a server refuses is JSON, also its own faults; anything else is no answer.
 * @param {Response} response @returns {Promise<never>} */
async function refused(response) {
  const { detail, problems } = await response.json();
  const message = detail || `The server answered ${response.status}.`;
  back(response);
  throw new Refused(problems || [{ path: "", message }], response.status);
}
/**
 * Ask the server; JSON goes and comes.
 * @param {string} path @param {any} [body] @param {Asked} [how] @returns {Promise<any>}
 */
export const ask = (path, body, how = {}) =>
  answered(path, body, how, (r) => (r.status === 204 ? Promise.resolve(null) : r.json()));
/** Ask for a file. @param {string} path @param {any} [body] @returns {Promise<[Blob, string]>} */
export const askFile = (path, body) =>
  answered(path, body, {}, async (r) => {
    const said = /filename="?([^";]+)/.exec(r.headers.get("Content-Disposition") || "");
    return [await r.blob(), said?.[1] || ""];
  });
/** The style of all but the first screen, once it is wanted; without it the page does as well. */
let styled = /** @type {Promise<void> | null} */ (null);
const style = () =>
  new Promise((/** @type {(v: void) => void} */ done) => {
    const link = document.createElement("link");
    Object.assign(link, { rel: "stylesheet", href: LATE, onload: done, onerror: done });
    document.querySelector("link[rel=stylesheet]")?.before(link); // the first has the last word
  });
const LATE = "/static/late.css";
/**
 * A part of the page that is fetched when it is wanted first. No browser asks anew for a script
 * that did not come: once the server is there the window begins again, as it is.
 * @template T @param {() => Promise<T>} load @returns {Promise<T>}
 */
export async function part(load) {
  const silent = setInterval(askAgain, SILENT);
  try {
    await proved();
    styled ??= style();
    const [found] = await Promise.all([load(), styled]);
    return found;
  } catch {
    app.lacks = true;
    askAgain();
    throw new Refused([{ path: "", message: GONE }], 0);
  } finally {
    clearInterval(silent);
  }
}

/** @type {Set<() => void>} */
const returns = new Set();
/** Be told when the server answers again. @param {() => void} f */
export const onReturn = (f) => returns.add(f);
/** @param {Response} response */
function back({ headers, status }) {
  app.stranger = status === 401;
  const version = headers.get("wraparc-version") || "";
  const { gone, newer, about } = app;
  if (version && about) app.newer = version !== about.version;
  app.gone = false;
  if (gone) {
    clearTimeout(looking);
    looking = 0;
    pause = FIRST;
    if (app.lacks && !app.newer) location.reload();
    for (const f of returns) f();
    note("The server answers again.");
  } else if (newer !== app.newer) redraw();
}
let looking = 0;
let pause = FIRST;
let asking = false;
/** Whether the server is there. */
export async function askAgain() {
  if (asking) return;
  asking = true;
  clearTimeout(looking);
  looking = 0;
  const stop = new AbortController();
  const late = setTimeout(() => stop.abort(), SILENT);
  try {
    back(await same(stop.signal));
    if (app.lacks) redraw();
  } catch {
    lost();
  }
  clearTimeout(late);
  asking = false;
}
function lost() {
  for (const one of waiting.keys()) one.abort();
  if (!looking) {
    looking = setTimeout(askAgain, pause);
    pause = Math.min(2 * pause, LAST);
  }
  if (!app.gone) {
    app.gone = true;
    redraw();
  }
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
 * @template E @param {(e: E) => any} f @returns {(e: E) => Promise<void>}
 */
export const act = (f) => async (e) => {
  const { currentTarget } = /** @type {any} */ (e ?? {});
  const button = currentTarget instanceof Element ? currentTarget : null;
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
  if (aborted(x) || unanswered(x)) return; // the bar on top says it
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
