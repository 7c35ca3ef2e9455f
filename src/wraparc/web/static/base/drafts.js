// Drafts: the design is kept in this browser, one for each window.
import { app, isDrive } from "./design.js";
import { timeOf } from "./units.js";

/** @import { Design, Origin, Saved, Source, Units } from "../types.d.ts" */
/**
 * @typedef {{window: string, when: number, doc: Design, units: Units, name: string,
 *   design: Saved | null, origin: Origin | null, source: Source | null, pulley: number,
 *   case: string}} Draft
 */

const KEY = "wraparc.drafts";
const MOST = 6;
/** The name of this window, which a reload keeps. */
const own = (() => {
  try {
    const name =
      sessionStorage.getItem("wraparc.window") ||
      crypto.getRandomValues(new Uint32Array(2)).join("-");
    sessionStorage.setItem("wraparc.window", name);
    return name;
  } catch {
    return "";
  }
})();
/** What was read last: asked for with every drawing. */
let read = { text: "[]", list: /** @type {Draft[]} */ ([]) };
/** @returns {Draft[]} */
export function drafts() {
  try {
    const text = localStorage.getItem(KEY) || "[]";
    if (text !== read.text) {
      const kept = JSON.parse(text);
      read = { text, list: Array.isArray(kept) ? kept.filter((d) => isDrive(d?.doc)) : [] };
    }
    return read.list;
  } catch {
    return [];
  }
}
/** @param {Draft[]} list */
function store(list) {
  try {
    localStorage.setItem(KEY, JSON.stringify(list.slice(0, MOST)));
  } catch {
    /* no room: the page works without */
  }
}
/** @type {Design | null} */
let untouched = null;
/** What was not changed since it was opened is no draft. @param {Design} doc */
export const opened = (doc) => {
  untouched = doc;
};
/** @type {Draft | null} */
let pending = null;
let waiting = 0;
document.addEventListener("visibilitychange", () => keep());
/** Keep the design; while a slider moves, once the hand rests. */
export function keepDraft() {
  if (app.doc === untouched) return;
  const { doc, units, name, design, origin, source, pulley } = app;
  const when = Date.now();
  pending = { window: own, when, doc, units, name, design, origin, source, pulley, case: app.case };
  if (document.activeElement?.matches("[type=range]")) waiting ||= setTimeout(keep, 200);
  else keep();
}
function keep() {
  clearTimeout(waiting);
  waiting = 0;
  if (pending) store([pending, ...drafts().filter((d) => d.window !== own)]);
  pending = null;
}
export const ownDraft = () => drafts().find((d) => d.window === own);
/** Drafts of windows before this one, the newest first. */
export const otherDrafts = () => drafts().filter((d) => d.window !== own);
/** @param {Draft} draft */
export const forgetDraft = (draft) => store(drafts().filter((d) => d.window !== draft.window));
/** @param {Draft} d */
export const draftTitle = (d) =>
  `${d.doc.title || d.name || "Drive without a title"}, ${timeOf(d.when)}`;
