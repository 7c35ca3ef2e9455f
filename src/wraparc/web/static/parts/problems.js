// Which field a problem of the server belongs to.

import { app, get, wrong } from "../base/design.js";
import { sentence } from "../base/server.js";
import { NEEDED, shownFields, spec } from "./field.js";

/** @import { Path, Problem } from "../types.d.ts" */

export const TENSIONS = ["entry_tension", "exit_tension", "effective_tension", "power", "torque"];
/** @typedef {Record<string, number | null>} Tensions what is given of them [SI] */
/** @typedef {{diameter: number | null, speed: number | null}} Drum */
/** A number, or null where it is none. @param {number} v */
export const orNull = (v) => (Number.isNaN(v) ? null : v);
/** What is given of the tensions of a pulley. @param {(key: string) => number} read
 * @returns {Tensions} */
export const tensionsBy = (read) =>
  /** @type {Tensions} */ (Object.fromEntries(TENSIONS.map((key) => [key, orNull(read(key))])));
export const NO_RUNS = { base: 0, case: 0 };

/**
 * Path as the server tells it, to the place in the document.
 * @param {string} text @returns {Path}
 */
export function place(text) {
  const keys = [];
  /** @type {any} */
  let node = app.doc;
  for (const m of (text || "").matchAll(/"((?:[^"\\]|\\.)*)"|\[(\d+)\]|([^.[\]"]+)/g)) {
    /** @type {string | number} */
    let key = m[2] ? +m[2] - 1 : (m[1] ?? m[3]);
    if (Array.isArray(node) && typeof key === "string") {
      const name = key;
      if (name === "rows") continue; // of a profile that is nothing but rows
      // of a row of a profile: its position, its value
      const part = ["position", "value"].indexOf(name);
      const found = node.findIndex((n) => n?.name === name);
      key = found < 0 && part >= 0 ? part : Math.max(0, found);
    }
    keys.push(key);
    node = node?.[key];
  }
  return keys;
}
/**
 * Mark the fields that problems name; what has no field is returned.
 * @param {Problem[]} problems
 */
export function mark(problems) {
  wrong.at = new Map();
  return problems.filter((p) => {
    const needed = lacking(p);
    for (const key of needed) wrong.at.set(key, NEEDED);
    if (needed.length) return false;
    const keys = place(p.path);
    let key = keys.join();
    // tensions that contradict each other: the last of them carries the sentence
    if (!shownFields.has(key))
      key = [...keys, TENSIONS.findLast((t) => get(app.doc, [...keys, t]) != null)].join();
    if (!shownFields.has(key)) return true;
    // the label says of what, and a form has no words of a file
    const ownWords = sentence(p)
      .replace(p.path, "")
      .replace(/^ ?[=:] /, "");
    wrong.at.set(
      key,
      ownWords.replace(/\w+_\w+/g, (of) => spec("tensions", of).title),
    );
    return false;
  });
}
/** The fields to fill in, where that is all that is wrong.
 * @param {Problem} p @returns {string[]} */
function lacking({ path, code }) {
  const keys = place(path);
  const at = TENSIONS.includes(String(keys[keys.length - 1])) ? keys.slice(0, -1) : keys;
  const few = TENSIONS.map((t) => [...at, t]).filter((key) => get(app.doc, key) == null);
  const needed = code === "few_tensions" ? few : code === "missing" ? [keys] : [];
  return needed.map((key) => key.join()).filter((key) => shownFields.has(key));
}
