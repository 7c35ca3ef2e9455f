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
/** A table in which masters of followers and pulleys of what happens have another name.
 * @param {any} of @param {string} from @param {string} to @returns {any} */
function referring(of, from, to) {
  if (Array.isArray(of)) return of.map((v) => referring(v, from, to));
  if (!of || typeof of !== "object") return of;
  const known = (/** @type {string} */ k, /** @type {any} */ v) =>
    ["master", "pulley"].includes(k) && v === from ? to : referring(v, from, to);
  return Object.fromEntries(Object.entries(of).map(([k, v]) => [k, known(k, v)]));
}
/** @param {number} i @param {string} name */
export function renamePulley(i, name) {
  const from = app.doc.pulley[i].name;
  let doc = set(app.doc, ["pulley", i, "name"], name);
  if (from) {
    for (const at of [
      ["train", "run"],
      ["train", "motor"],
      ["motion", "drum"],
    ])
      doc = renamed(doc, at, from, name);
    for (const key of ["train", "motion"])
      if (doc[key]) doc = { ...doc, [key]: referring(doc[key], from, name) };
    const places = doc.conveyor?.drive?.map?.((/** @type {any} */ d) =>
      d?.pulley === from ? { ...d, pulley: name } : d,
    );
    if (places) doc = set(doc, ["conveyor", "drive"], places);
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
  const from = app.doc.load_case?.[i]?.name;
  if (app.case === from) app.case = name;
  change(doc.motion?.load_case === from ? set(doc, ["motion", "load_case"], name) : doc);
}
/**
 * What speaks against a name, in a sentence.
 * @param {string} what @param {(string | undefined)[]} others
 */
export const nameCheck = (what, others) => (/** @type {string} */ name) => {
  if (!name) return `A ${what} needs a name.`;
  return others.includes(name) ? `Another ${what} has the name "${name}".` : "";
};
