// Drive files as text: read and written by a library, changed in place so that comments stay.
import { parse, stringify, TomlDate } from "../vendor/smol-toml.js";
import { get } from "./design.js";

/** @import { Path } from "../types.d.ts" */

/** A document as JSON has it, dates as text. @param {any} value @returns {any} */
export function plain(value) {
  if (value instanceof TomlDate) return value.toISOString();
  if (typeof value === "bigint" || (typeof value === "number" && !Number.isFinite(value)))
    return String(value);
  if (Array.isArray(value)) return value.map(plain);
  if (typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, plain(item)]));
}
/** @param {any} doc */
export const textOf = (doc) => stringify({ format: 1, ...bare(doc) });
/** A document without keys that hold nothing. @param {any} value @returns {any} */
function bare(value) {
  if (Array.isArray(value)) return value.filter((v) => v != null).map(bare);
  if (typeof value !== "object" || value === null) return value;
  const kept = Object.entries(value).filter(([, v]) => v != null);
  return Object.fromEntries(kept.map(([key, v]) => [key, bare(v)]));
}

/**
 * A text with what has changed in its document; null where that cannot be done in place.
 * @param {string} text @param {any} before @param {any} after @returns {string | null}
 */
export function rewritten(text, before, after) {
  const wanted = bare(after);
  if (same(before, wanted)) return text;
  try {
    const found = edited(text, [...changes(before, wanted)], wanted);
    return same(plain(parse(found)), wanted) ? found : null;
  } catch {
    return null;
  }
}
/** Keys in any order. @param {any} a @param {any} b @returns {boolean} */
function same(a, b) {
  if (!isHolder(a) || !isHolder(b) || Array.isArray(a) !== Array.isArray(b)) return a === b;
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every((k) => k in b && same(a[k], b[k]));
}
/** @param {any} v */
const isHolder = (v) => typeof v === "object" && v !== null;
/** @typedef {{path: Path, value: any, old: any}} Change */

/** Where two documents differ. @param {any} a @param {any} b @param {Path} [at]
 * @returns {Generator<Change>} */
function* changes(a, b, at = []) {
  if (same(a, b)) return;
  const alike = isHolder(a) && isHolder(b) && Array.isArray(a) === Array.isArray(b);
  const rows = alike && Array.isArray(a) && !(a.every(isHolder) && b.every(isHolder));
  if (!alike || rows) return yield { path: at, value: b, old: a };
  const keys = [...new Set([...Object.keys(a), ...Object.keys(b)])];
  for (const key of keys) yield* changes(a[key], b[key], [...at, Array.isArray(a) ? +key : key]);
}

/**
 * Places of a text: every key with the span of its line and of its value, and where tables end.
 * @typedef {{path: Path, line: [number, number], value: [number, number]}} Place
 * @typedef {{path: Path, end: number}} Section
 */
const HEADER = /^[ \t]*(\[\[?)([^\]\n]*)\]\]?[ \t]*(?:#[^\n]*)?\n?/;
const NAME = String.raw`(?:"(?:[^"\\\n]|\\.)*"|'[^'\n]*'|[\w-]+)`;
const KEY = new RegExp(String.raw`^[ \t]*(${NAME}(?:[ \t]*\.[ \t]*${NAME})*)[ \t]*=[ \t]*`);
const PART = /"((?:[^"\\]|\\.)*)"|'([^']*)'|([\w-]+)/g;
/** @param {string} text */
const keysOf = (text) =>
  [...text.matchAll(PART)].map((m) =>
    m[1] !== undefined ? JSON.parse(`"${m[1]}"`) : (m[2] ?? m[3]),
  );

/** @param {string} text */
function placesOf(text) {
  /** @type {Place[]} */
  const places = [];
  /** @type {Section[]} */
  const sections = [{ path: [], end: 0 }];
  /** @type {Map<string, number>} */
  const rows = new Map();
  let at = 0;
  while (at < text.length) {
    const rest = text.slice(at);
    const header = HEADER.exec(rest);
    const key = header ? null : KEY.exec(rest);
    if (header) {
      at += header[0].length;
      sections.push({ path: pathOf(keysOf(header[2]), rows, header[1] === "[["), end: at });
    } else if (key) {
      const start = at + key[0].length;
      const end = endOfValue(text, start);
      const stop = text.indexOf("\n", end);
      const next = stop < 0 ? text.length : stop + 1;
      const section = sections[sections.length - 1];
      places.push({
        path: [...section.path, ...keysOf(key[1])],
        line: [at, next],
        value: [start, end],
      });
      section.end = next;
      at = next;
    } else {
      const stop = text.indexOf("\n", at);
      at = stop < 0 ? text.length : stop + 1;
    }
  }
  return { places, sections };
}
/** Path of a header; rows of tables by number. @param {string[]} keys
 * @param {Map<string, number>} rows @param {boolean} row @returns {Path} */
function pathOf(keys, rows, row) {
  /** @type {Path} */
  const path = [];
  keys.forEach((key, i) => {
    path.push(key);
    const name = JSON.stringify(path);
    if (row && i === keys.length - 1) rows.set(name, (rows.get(name) ?? -1) + 1);
    const number = rows.get(name);
    if (number !== undefined) path.push(number);
  });
  return path;
}
/** Where a value ends that begins at a place. @param {string} text @param {number} from */
function endOfValue(text, from) {
  let depth = 0;
  let at = from;
  let last = from;
  while (at < text.length) {
    const quote = /^("""|'''|"|')/.exec(text.slice(at, at + 3))?.[1];
    if (quote) {
      at = endOfString(text, at + quote.length, quote);
      last = at;
      continue;
    }
    const c = text[at];
    if (c === "#") {
      if (depth === 0) break;
      while (at < text.length && text[at] !== "\n") at++;
      continue;
    }
    if (c === "\n" && depth === 0) break;
    if ("[{".includes(c)) depth++;
    if ("]}".includes(c)) depth--;
    at++;
    if (!/\s/.test(c)) last = at;
  }
  return last;
}
/** @param {string} text @param {number} from @param {string} quote */
function endOfString(text, from, quote) {
  let at = from;
  while (at < text.length && !text.startsWith(quote, at))
    at += quote[0] === '"' && text[at] === "\\" ? 2 : 1;
  return at + quote.length;
}

/** @param {string} text @param {Change[]} all @param {any} wanted */
function edited(text, all, wanted) {
  let now = text.endsWith("\n") || !text ? text : `${text}\n`;
  for (const change of all) now = once(now, change, wanted);
  return now;
}
/** @param {Path} a @param {Path} b */
const leads = (a, b) => a.length <= b.length && a.every((key, i) => key === b[i]);
/** @param {string} text @param {Change} change @param {any} wanted */
function once(text, { path, value }, wanted) {
  const { places, sections } = placesOf(text);
  const place = places.find((p) => leads(p.path, path));
  if (place && place.path.length < path.length) {
    const whole = inline(get(wanted, place.path)); // the value that it is a part of
    return text.slice(0, place.value[0]) + whole + text.slice(place.value[1]);
  }
  if (place && value !== undefined)
    return text.slice(0, place.value[0]) + inline(value) + text.slice(place.value[1]);
  if (value === undefined) {
    const parts = places.filter((p) => leads(path, p.path));
    if (!parts.length || sections.some((s) => leads(path, s.path)))
      throw new Error("a table with a heading of its own goes");
    const left = emptied(path, sections, wanted);
    return parts.reduceRight(
      (now, p, i) => now.slice(0, p.line[0]) + (i ? "" : left) + now.slice(p.line[1]),
      text,
    );
  }
  const last = path[path.length - 1];
  const table = isHolder(value) && !Array.isArray(value);
  if (typeof last === "number")
    return `${text}\n[[${path.slice(0, -1).map(key).join(".")}]]\n${lines(value)}`;
  const within =
    places.some((p) => leads(path, p.path)) || sections.some((s) => same(s.path, path));
  if (within) throw new Error("a table that is there in parts");
  if (table && path.length === 1) return `${text}\n[${key(last)}]\n${lines(value)}`;
  if (Array.isArray(value) && value.every(isHolder))
    return [text, ...value.map((row) => `[[${path.map(key).join(".")}]]\n${lines(row)}`)].join(
      "\n",
    );
  const section = sectionOf(path, sections);
  const rest = path.slice(section.path.length);
  if (rest.some((k) => typeof k === "number")) throw new Error("in a row that has no table");
  const line = `${rest.map(key).join(".")} = ${inline(value)}\n`;
  return text.slice(0, section.end) + line + text.slice(section.end);
}
/** What stays of a table that loses its last key. @param {Path} path @param {Section[]} sections
 * @param {any} wanted */
function emptied(path, sections, wanted) {
  const parent = path.slice(0, -1);
  const left = get(wanted, parent);
  if (!isHolder(left) || Object.keys(left).length || sections.some((s) => same(s.path, parent)))
    return "";
  return `${parent.slice(sectionOf(parent, sections).path.length).map(key).join(".")} = {}\n`;
}
/** The section that a key belongs to. @param {Path} path @param {Section[]} sections */
const sectionOf = (path, sections) =>
  sections
    .filter((s) => leads(s.path, path))
    .reduce((a, b) => (b.path.length >= a.path.length ? b : a));
/** @param {string | number} k */
const key = (k) => (/^[\w-]+$/.test(String(k)) ? String(k) : JSON.stringify(String(k)));
/** @param {any} value @returns {string} */
function inline(value) {
  if (Array.isArray(value)) return `[${value.map(inline).join(", ")}]`;
  if (!isHolder(value)) return JSON.stringify(value);
  const parts = Object.entries(value).map(([k, v]) => `${key(k)} = ${inline(v)}`);
  return `{ ${parts.join(", ")} }`;
}
/** @param {any} table */
const lines = (table) =>
  Object.entries(table)
    .map(([k, v]) => `${key(k)} = ${inline(v)}\n`)
    .join("");
