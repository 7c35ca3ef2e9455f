// Parts of a document that another lacks.

/** @param {any} v */
const holds = (v) => typeof v === "object" && v !== null;
/** Rows of tables by their names, others by number. @param {any} of @returns {[string, any][]} */
const parts = (of) =>
  Array.isArray(of)
    ? of.map((v, i) => [String((holds(v) && v.name) || i + 1), v])
    : Object.entries(of);

/**
 * Names of the parts of a document that another lacks, the topmost of each: "load case start".
 * @param {any} from @param {any} to @param {string[]} [moved] keys that are not looked at; a table
 *   that is gone is named by what else it held
 * @param {string} [at] @returns {string[]}
 */
export function lostParts(from, to, moved = [], at = "") {
  const there = new Map(holds(to) ? parts(to) : []);
  return parts(from).flatMap(([key, value]) => {
    const now = there.get(key);
    if (moved.includes(key) || empty(value)) return [];
    const name = `${at} ${key.replaceAll("_", " ")}`.trim();
    if (now == null && !(holds(value) && has(value, moved))) return [name];
    return holds(value) ? lostParts(value, now ?? {}, moved, name) : [];
  });
}
/** @param {any} v @returns {boolean} */
const empty = (v) => v == null || (holds(v) && parts(v).every(([, part]) => empty(part)));
/** Whether a table holds one of some keys, however deep. @param {any} of @param {string[]} keys
 * @returns {boolean} */
const has = (of, keys) =>
  parts(of).some(([key, v]) => keys.includes(key) || (holds(v) && has(v, keys)));
