// Numbers of a drive file as the page reads them: by the keys, limits and units of the form.
import { get } from "../../base/design.js";
import { si } from "../../base/units.js";
import { spec } from "../../parts/field.js";

/** @import { Path, Problem } from "../../types.d.ts" */

const none = Number.NaN;

/** Reads the values of a document and gathers what is wrong with them. */
export class Reader {
  /** @param {any} doc */
  constructor(doc) {
    this.doc = doc;
    this.problems = /** @type {Problem[]} */ ([]);
    /** Where a size stands that conveyors do not have. @type {Path | undefined} */
    this.unusual = undefined;
  }
  /** @param {Path} path @param {string} message @param {string} [remedy] */
  wrong(path, message, remedy) {
    const [first, , ...rest] = path;
    const names = Array.isArray(this.doc[first]) ? [first, this.named(path), ...rest] : path;
    const value = get(this.doc, path);
    const place = names.map(quotedKey).join(".");
    const given = value == null || typeof value === "object" ? "" : ` = ${quoted(value)}`;
    const text = [`${place}${given}: ${message}.`, remedy].filter(Boolean).join(" ");
    this.problems.push({ path: place, message, sentence: text });
    return none;
  }
  /** @param {Path} path */
  named([first, i]) {
    return get(this.doc, [first, i, "name"]) ?? String(/** @type {number} */ (i) + 1);
  }
  /**
   * A number in SI; nan where none is given.
   * @param {string} section @param {Path} path
   */
  number(section, path) {
    const key = String(path[path.length - 1]);
    const of = spec(section, key);
    const value = get(this.doc, path);
    if (value == null) {
      if (of.required) this.wrong(path, "missing");
      return none;
    }
    if (of.word && value === of.word) return of.word === "rigid" ? Number.POSITIVE_INFINITY : none;
    const number = of.dimension === "number" && typeof value === "number";
    const read = number ? value : typeof value === "string" ? si(value, of.dimension ?? "") : none;
    if (!Number.isFinite(read)) return this.wrong(path, ...unreadable(of));
    const open = of.allowed?.startsWith("more than");
    const least = of.least ?? Number.NEGATIVE_INFINITY;
    if (open ? read > least : read >= least) {
      if (read <= (of.most ?? Number.POSITIVE_INFINITY)) {
        const [low, high] = of.usual ?? [read, read];
        if (read && (read < low || read > high)) this.unusual ??= path;
        return read;
      }
    }
    return this.wrong(path, `must be ${of.allowed}`);
  }
  /** One of some words. @param {string} section @param {Path} path @returns {string} */
  choice(section, path) {
    const of = spec(section, String(path[path.length - 1]));
    const value = get(this.doc, path);
    if (value == null) return "";
    if (of.options?.includes(value)) return value;
    this.wrong(path, `must be one of ${of.options?.join(", ")}`);
    return "";
  }
  /** @param {Path} path @returns {boolean | undefined} */
  flag(path) {
    const value = get(this.doc, path);
    if (value !== undefined && typeof value !== "boolean")
      this.wrong(path, "must be true or false");
    return value;
  }
  /** @param {Path} path @param {boolean} [needed] @returns {string} */
  text(path, needed) {
    const value = get(this.doc, path);
    if (value == null || value === "") {
      if (needed) this.wrong(path, "missing");
      return "";
    }
    if (typeof value !== "string") this.wrong(path, "must be text");
    return String(value);
  }
}
/** @param {import("../../types.d.ts").Spec} of @returns {[string, string]} */
const unreadable = ({ dimension }) => [
  "cannot be read here as a number with its unit",
  dimension === "number"
    ? "Write a number."
    : `Write a number and one of the units that the field offers, as in the help of it.`,
];
/** @param {any} value */
const quoted = (value) => (typeof value === "string" ? `"${value.slice(0, 80)}"` : String(value));
/** @param {string | number} key */
const quotedKey = (key) => (/^[\w-]+$/.test(String(key)) ? key : JSON.stringify(String(key)));
