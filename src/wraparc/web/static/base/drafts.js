// Designs are opened and kept in this browser: what a window shows, and drafts of what was typed.
import { again, keep, kept } from "./address.js";
import { app, isDrive, recall, redraw, remembered, take } from "./design.js";

/** @import { Design, Saved, Source, Units } from "../types.d.ts" */
/**
 * @typedef {{window: string, when: number, doc: Design, units: Units, name: string,
 *   design: Saved | null, source: Source | null, pulley: number,
 *   case: string, begun?: boolean}} Draft
 */

const KEY = "wraparc.drafts";
const MOST = 6;
/** The name of the draft of this window, which a reload keeps. */
let own = "";
/** @param {boolean} [same] */
function nameDraft(same) {
  own = (same && kept("window")) || crypto.getRandomValues(new Uint32Array(2)).join("-");
  keep("window", own);
}
nameDraft(again);
/** What was read last: asked for with every drawing. */
let read = { text: "[]", list: /** @type {Draft[]} */ ([]) };
/** @returns {Draft[]} */
export function drafts() {
  try {
    const text = localStorage.getItem(KEY) || "[]";
    if (text !== read.text) {
      const all = JSON.parse(text);
      read = { text, list: Array.isArray(all) ? all.filter((d) => isDrive(d?.doc)) : [] };
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
/** @type {Design | null} */
let begun = null;
/**
 * Open a design: what is not changed from now on is no draft, and the draft before stays.
 * @param {Design} doc @param {Parameters<typeof take>[1]} [more]
 */
export function open(doc, more) {
  untouched = doc;
  nameDraft();
  take(doc, more);
}
/** Open the design to begin with, which a reload asks for anew: its file may be another by then.
 * @param {Design} doc @param {Parameters<typeof take>[1]} more */
export function beginWith(doc, more) {
  begun = doc;
  open(doc, more);
}
/** @type {Draft | null} */
let pending = null;
let waiting = 0;
document.addEventListener("visibilitychange", keepNow);
/** Keep the design; while a slider moves, once the hand rests. */
export function keepDraft() {
  const { doc, units, name, design, source, pulley, begun } = app;
  const of = { window: own, when: Date.now(), case: app.case };
  pending = { ...of, doc, units, name, design, source, pulley, begun };
  if (document.activeElement?.matches("[type=range], [role=slider]"))
    waiting ||= setTimeout(keepNow, 200);
  else keepNow();
}
function keepNow() {
  clearTimeout(waiting);
  waiting = 0;
  if (!pending) return;
  const { doc } = pending;
  const changed = doc !== untouched;
  keep("shown", doc === begun ? null : { ...pending, changed });
  keep("past", remembered());
  if (changed) store([pending, ...drafts().filter((d) => d.window !== own)]);
  pending = null;
}
/** Open what this window showed before it was loaded again; false if there is nothing. */
export function openShown() {
  const d = kept("shown");
  if (!isDrive(d?.doc)) return false;
  if (!d.changed) untouched = d.doc;
  recall(kept("past"));
  openDraft(d);
  return true;
}
/** A draft of a window that was shut or crashed, offered once. */
export const offered = { draft: /** @type {Draft | null} */ (null) };
/** @param {Draft} d */
export function openDraft(d) {
  offered.draft = null;
  const { name, design, source, units, begun } = d;
  take(d.doc, { name, design, source, units, begun });
  app.pulley = d.doc.pulley[d.pulley] ? d.pulley : 0;
  app.case = d.case;
  redraw();
}
/** Offer the newest draft beside a design that is only opened, if it is another. */
export function offerDraft() {
  const [draft] = drafts();
  const other = draft && JSON.stringify(draft.doc) !== JSON.stringify(app.doc);
  if (other && app.doc === untouched) offered.draft = draft;
}
/** Drafts of windows before this one, the newest first. */
export const otherDrafts = () => drafts().filter((d) => d.window !== own);
/** Delete some drafts, or all; what is returned brings them back. @param {Draft} [one] */
export function forgetDrafts(one) {
  const before = drafts();
  const own = untouched;
  store(one ? before.filter((d) => d.window !== one.window) : []);
  if (!one) untouched = app.doc;
  return () => {
    store(before);
    untouched = own;
    redraw();
  };
}
