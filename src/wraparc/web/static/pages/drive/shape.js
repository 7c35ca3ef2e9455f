// The tables of a drive file and their keys, as the form has them: what stands elsewhere is told.
import { get } from "../../base/design.js";
import { section } from "../../parts/field.js";

/** @import { Path } from "../../types.d.ts" */
/** @import { Reader } from "./reading.js" */

const CRITERIA = ["take_up", "design_standard", "safety_factor", "sag"];
const TOP = [
  ...["format", "title", "description", "creep_limit", "condition", "belt", "pulley", "lagging"],
  ...["load_case", "motion", ...CRITERIA],
];
const CASE = ["name", "description", "kind", "condition", "pulley"];
/** What is never on the form. */
const ORIGINS = ["sources", "provenance"];
/** @param {any} v */
const isTable = (v) => typeof v === "object" && v !== null && !Array.isArray(v);

/** Tell of tables that are none, and of keys that nobody reads. @param {Reader} r */
export function checkShape(r) {
  const { doc } = r;
  if (doc.format !== 1) r.wrong(["format"], "must be 1, the format that this page reads");
  known(r, [], TOP);
  known(r, ["belt"], [...keysOf("belt"), ...ORIGINS]);
  known(r, ["pulley", 0], [...keysOf("pulley"), ...keysOf("tensions"), ...ORIGINS]);
  for (const key of CRITERIA) known(r, [key], keysOf(key));
  conditions(r, ["condition"], true);
  conditions(r, ["pulley", 0, "condition"]);
  const cases = doc.load_case;
  if (cases !== undefined && !cases.length) r.wrong(["load_case"], "must have at least one entry");
  for (const i of (cases ?? []).keys()) {
    known(r, ["load_case", i], CASE);
    conditions(r, ["load_case", i, "condition"]);
    const pulley = /** @type {Path} */ (["load_case", i, "pulley"]);
    if (table(r, pulley))
      for (const name of Object.keys(get(doc, pulley) ?? {}))
        known(r, [...pulley, name], keysOf("tensions"));
  }
}
/** @param {string} name */
const keysOf = (name) => section(name).map((s) => s.key);
/** Whether a table is one, or not there. @param {Reader} r @param {Path} path */
function table(r, path) {
  const value = get(r.doc, path);
  if (value == null || isTable(value)) return true;
  r.wrong(path, "must be a table");
  return false;
}
/** @param {Reader} r @param {Path} path @param {string[]} keys */
function known(r, path, keys) {
  if (!table(r, path)) return;
  const other = Object.keys(get(r.doc, path) ?? {}).find((key) => !keys.includes(key));
  if (other !== undefined) r.wrong([...path, other], "unknown key");
}
/** @param {Reader} r @param {Path} path @param {boolean} [several] */
function conditions(r, path, several) {
  const value = get(r.doc, path);
  if (value == null) return;
  const rows = several && Array.isArray(value) ? value : [value];
  const fine = (/** @type {any} */ c) => (isTable(c) ? c.name : typeof c === "string" && c);
  if (rows.length < 1 || rows.length > 8 || !rows.every(fine))
    r.wrong(path, "must be a condition by name, or some of them");
}
