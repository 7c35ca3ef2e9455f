// Documents read as wraparc reads them: by its own functions, translated (reader.js).
import { app } from "./base/design.js";
import { CatalogueBelt, InputError, Provenance, readDrive, readTrain } from "./reader.js";

/** What is known of the catalogue: belts and laggings, by name. */
let catalogue = {
  from: /** @type {any} */ (null),
  belts: /** @type {any[]} */ ([]),
  laggings: new Map(),
};

/** Say what the catalogue has. @param {any} from as the book has it */
export function known(from) {
  if (catalogue.from === from) return;
  const laggings = new Map(Object.entries(from.laggings).map(([k, v]) => [k, inPython(v)]));
  catalogue = { from, belts: from.belts.map(beltOf), laggings };
}
/** @param {any} of */
const beltOf = ({ provenance, sources, ...of }) =>
  Object.assign(Object.create(CatalogueBelt.prototype), of, {
    provenance: sourceOf(provenance),
    sources: new Map(Object.entries(sources).map(([key, source]) => [key, sourceOf(source)])),
  });
/** @param {any} of */
const sourceOf = ({ kind, source, date, note }) =>
  new /** @type {any} */ (Provenance)(kind, source, date, note);
/** A document as Python has it, without what holds nothing. @param {any} value @returns {any} */
export function inPython(value) {
  if (Array.isArray(value)) return value.filter((v) => v != null).map(inPython);
  if (typeof value !== "object" || value === null || value instanceof Number) return value;
  const kept = Object.entries(value).filter(([, v]) => v != null);
  return new Map(kept.map(([key, v]) => [key, inPython(v)]));
}
/**
 * The drive or train of a document, or what is wrong with it.
 * @param {any} document @returns {{found: any, problems: any[]}}
 */
export function read(document) {
  const given = inPython(document);
  try {
    return { found: (given.has("train") ? readTrain : readDrive)(given), problems: [] };
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    return { found: null, problems: /** @type {any} */ (error).problems.map(told) };
  }
}
/** A problem as the server tells one. @param {any} problem */
export const told = (problem) => {
  const { key, message, value, remedy, line, code } = problem;
  return { path: key, message, value, remedy, line, code, sentence: problem.__str__() };
};

// What the functions take from files and options, taken here from what is known.

export function belts() {
  return catalogue.belts;
}
export function laggingNames() {
  return [...catalogue.laggings.keys()];
}
/** @param {string} name */
export function laggingText(name) {
  return catalogue.laggings.get(name);
}
/** @param {any} document */
export function parsed(document) {
  return document;
}
/** Nothing is put over a document here. @param {any} document */
export function overridden(document) {
  return document;
}
/** @returns {string} */
export function readText() {
  throw new Error("no file is read here");
}
/** @param {any} x */
export function isNumber(x) {
  return typeof x === "number" || x instanceof Number;
}
/** What the glossary has of a quantity. @param {string} name */
export const term = (name) => app.form.glossary[name];

/** A key figure of an arc, NaN where the page has none of this name.
 * @param {any} arc @param {string} name @returns {number} */
export const figureOf = (arc, name) =>
  arc[name] ?? arc.capacities[name] ?? arc.energy[name] ?? Number.NaN;
