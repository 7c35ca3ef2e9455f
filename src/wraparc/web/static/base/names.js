// Names of pulleys and load cases: what refers to them goes along when they change.
import { app, change, set } from "./design.js";

/**
 * A table with one key renamed, in its place.
 * @param {any} table @param {string} from @param {string} to
 */
function keyed(table, from, to) {
  if (!table || typeof table !== "object" || !(from in table)) return table;
  return Object.fromEntries(Object.entries(table).map(([k, v]) => [k === from ? to : k, v]));
}
/** A document with the tables of one place renamed.
 * @param {any} of @param {string[]} path @returns {any} */
function renamed(of, [key, ...rest], from = "", to = "") {
  if (!of || typeof of !== "object" || !(key in of)) return of;
  const value = rest.length ? renamed(of[key], rest, from, to) : keyed(of[key], from, to);
  return { ...of, [key]: value };
}
/** @param {number} i @param {string} name */
export function renamePulley(i, name) {
  const from = app.doc.pulley[i].name;
  let doc = set(app.doc, ["pulley", i, "name"], name);
  if (from) {
    doc = renamed(doc, ["train", "run"], from, name);
    if (doc.take_up?.after === from) doc = set(doc, ["take_up", "after"], name);
    const cases = doc.load_case?.map((c) =>
      renamed(renamed(c, ["pulley"], from, name), ["train", "run"], from, name),
    );
    if (cases) doc = { ...doc, load_case: cases };
  }
  change(doc);
}
/** @param {number} i @param {string} name */
export function renameCase(i, name) {
  const doc = set(app.doc, ["load_case", i, "name"], name);
  if (app.case === app.doc.load_case?.[i]?.name) app.case = name;
  change(doc);
}
/**
 * What speaks against a name, in a sentence.
 * @param {string} what @param {(string | undefined)[]} others
 */
export const nameCheck = (what, others) => (/** @type {string} */ name) => {
  if (!name) return `A ${what} needs a name.`;
  return others.includes(name) ? `Another ${what} has the name "${name}".` : "";
};
