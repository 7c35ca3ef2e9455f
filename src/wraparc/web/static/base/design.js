// The design on the page: one document, the parsed drive file, and its history.
/** @import { App, Design, Path, Saved, Source, Units } from "../types.d.ts" */

/** State of the page; form, catalogue and document are there before anything is drawn. */
export const app = /** @type {App} */ ({
  units: "si",
  page: "drive",
  pulley: 0,
  case: "",
  name: "",
  design: null,
  source: null,
  gone: false,
  stranger: false,
  newer: false,
  begun: false,
  lacks: false,
  opened: 0,
});
/** Places of the fields that were touched since a new drive was begun. */
export const touched = /** @type {Set<string>} */ (new Set());
/** Problems of the last answer by the place of their field, for the fields to show. */
export const wrong = { at: /** @type {Map<string, string>} */ (new Map()) };

/** @type {Set<() => void>} */
const watchers = new Set();
/** Be told of every change of the design or of what is looked at. @param {() => void} f */
export const watch = (f) => watchers.add(f);
/** Draw anew what depends on the state. */
export const redraw = () => {
  for (const f of watchers) f();
};

/** Once the next frame is painted. @returns {Promise<void>} */
export const painted = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

/** @param {any} from @param {Path} path @returns {any} */
export const get = (from, path) => path.reduce((value, key) => value?.[key], from);
/**
 * A copy with one value changed; undefined takes the key away.
 * @template T @param {T} from @param {Path} path @param {any} value @returns {T}
 */
export function set(from, [key, ...rest], value) {
  const copy = /** @type {any} */ (Array.isArray(from) ? [...from] : { ...from });
  if (rest.length)
    copy[key] = set(copy[key] ?? (typeof rest[0] === "number" ? [] : {}), rest, value);
  else if (value !== undefined) copy[key] = value;
  else if (Array.isArray(copy)) copy.splice(/** @type {number} */ (key), 1);
  else delete copy[key];
  return copy;
}

/** @type {Design[]} */
const past = [];
/** @type {Design[]} */
const future = [];
let lastKey = "";
let lastTime = 0;
globalThis.addEventListener?.("focusout", () => (lastKey = ""));
/**
 * Put a document in the place of the present one; changes of one field within a second undo as one,
 * unless it was left between them.
 * @param {Design} doc @param {string} [key]
 */
export function change(doc, key = "") {
  const now = performance.now();
  const same = grip.from ? app.doc !== grip.from : key && key === lastKey && now - lastTime < 1000;
  if (app.doc && !same) past.push(app.doc);
  if (past.length > 300) past.shift();
  [lastKey, lastTime] = [key, now];
  future.length = 0;
  app.doc = doc;
  inRange();
  redraw();
}
/** A hand that holds a slider or a handle: all that it moves is one step of the history. */
const grip = { from: /** @type {Design | null} */ (null) };
export const gripped = () => grip.from !== null;
export function grasp() {
  grip.from ??= app.doc;
}
/** Let go; what was moved stays, or is given back. @param {boolean} [back] */
export function release(back) {
  const { from } = grip;
  if (!from) return;
  grip.from = null;
  lastKey = "";
  if (back && app.doc !== from) app.doc = past.pop() ?? from;
  inRange();
  redraw();
}
addKeys();
/** Escape gives back what is being moved. */
function addKeys() {
  globalThis.addEventListener?.("keydown", (e) => {
    if (e.key !== "Escape" || !gripped()) return;
    e.preventDefault();
    release(true);
  });
  for (const end of ["pointerup", "pointercancel", "blur"])
    globalThis.addEventListener?.(end, () => release());
}
/** @param {Path} path @param {any} value */
export const edit = (path, value) => change(set(app.doc, path, value), path.join());
/** @param {Partial<App>} seen */
export function look(seen) {
  Object.assign(app, seen);
  redraw();
}
/** @param {Design[]} from @param {Design[]} to */
function step(from, to) {
  const doc = from.pop();
  if (!doc) return;
  to.push(app.doc);
  app.doc = doc;
  lastKey = "";
  inRange();
  redraw();
}
/** Steps back that a reload keeps. */
const KEPT = 20;
export const remembered = () => past.slice(-KEPT);
/** @param {Design[] | null} steps */
export const recall = (steps) => past.splice(0, past.length, ...(steps ?? []));
export const undo = () => step(past, future);
export const redo = () => step(future, past);
export const history = { back: () => past.length > 0, forth: () => future.length > 0 };
function inRange() {
  if (app.pulley >= app.doc.pulley.length) app.pulley = 0;
  if (app.case && !caseNames(app.doc).includes(app.case)) app.case = "";
}
/** Names of the load cases, each in every condition that the drive is solved in.
 * @param {Design} doc @returns {string[]} */
export function caseNames(doc) {
  const named =
    doc.conveyor && !doc.load_case
      ? states(doc.conveyor)
      : ["design", ...(doc.load_case || []).map((c) => c.name || "")];
  const conditions = besides(doc);
  if (!conditions.length) return named;
  const own = doc.load_case?.filter((c) => c.condition).map((c) => c.name);
  return named.flatMap((name) =>
    own?.includes(name) ? name : conditions.map((c) => `${name}, ${c.name ?? c}`),
  );
}
/** Conditions that load cases are solved in side by side. @param {Design} doc @returns {any[]} */
export const besides = ({ condition: c }) => (Array.isArray(c) && c.length > 1 ? c : []);

/** Names of the load cases that a conveyor gives. @param {Record<string, any>} of */
function states(of) {
  const rises = rowsOf(of.flight).map((f) => Number.parseFloat(f?.lift ?? f?.slope ?? 0));
  const mixed = rises.some((r) => r < 0) && rises.some((r) => r > 0);
  return [
    "full",
    "empty",
    ...(mixed ? ["inclines", "declines"] : []),
    ...(of.start_factor != null || of.start_time != null ? ["start"] : []),
    ...(of.stop_time != null ? ["stop"] : []),
    ...rowsOf(of.load_case).map((c) => c?.name || ""),
  ];
}
/** @param {any} rows @returns {any[]} */
export const rowsOf = (rows) => (Array.isArray(rows) ? rows : []);

/** @param {Design} doc @returns {Units} */
const unitsOf = (doc) => (/(in|ft)$/.test(String(doc.belt.width ?? "")) ? "us" : "si");
/**
 * Take a design in, whole.
 * @param {Design} doc
 * @param {{name?: string, design?: Saved | null, source?: Source | null,
 *   units?: Units, begun?: boolean}} [more] begun: it has values that nobody typed
 */
export function take(doc, more = {}) {
  const { name = "", design = null, source = null, units, begun = false } = more;
  Object.assign(app, { pulley: 0, case: "", name, design, source, begun });
  app.opened += 1;
  touched.clear();
  app.units = units ?? unitsOf(doc);
  change(doc);
}

/** @param {any} v */
const isTable = (v) => v !== null && typeof v === "object" && !Array.isArray(v);
/** Whether the page can show a document as a drive, however wrong its values. @param {any} doc */
export const isDrive = (doc) =>
  isTable(doc) &&
  isTable(doc.belt) &&
  Array.isArray(doc.pulley) &&
  doc.pulley.length > 0 &&
  doc.pulley.every(isTable) &&
  (doc.load_case === undefined ||
    (Array.isArray(doc.load_case) && doc.load_case.every((/** @type {any} */ c) => isTable(c)))) &&
  ["lagging", "train", "conveyor"].every((key) => doc[key] === undefined || isTable(doc[key]));

/** The drive that a new design begins with: of usual size, its load to be filled in.
 * @param {Units} units @returns {Design} */
export const blank = (units) => ({
  format: 1,
  title: "",
  belt: { preset: "Plylon Plus 1000/4", width: units === "us" ? "48 in" : "1200 mm" },
  pulley: [
    {
      name: "head",
      diameter: units === "us" ? "32 in" : "800 mm",
      wrap_angle: "180 deg",
      lagging: "diamond-rubber",
    },
  ],
});
