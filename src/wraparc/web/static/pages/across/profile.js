// Profiles over the width as they stand in the drive file: rows, or a table of rows and a crown.
import { app, change, set } from "../../base/design.js";
import { si, trim, unit } from "../../base/units.js";

/** @typedef {[string, string][]} Rows position across the belt and value there */
/** @typedef {{key: string, title: string, what: string, brief: string, dimension: string,
 *   sign: string}} Kind title: of the switch; brief: of a column */

/** The profiles that can be drawn. @type {Kind[]} */
export const KINDS = [
  {
    key: "worn_depth",
    title: "Worn",
    what: "Depth worn off",
    brief: "worn",
    dimension: "length",
    sign: "down",
  },
  {
    key: "build_up",
    title: "Build-up",
    what: "Build-up",
    brief: "built up",
    dimension: "length",
    sign: "up",
  },
  {
    key: "shell_profile",
    title: "Shell",
    what: "Radius",
    brief: "radius",
    dimension: "length",
    sign: "up",
  },
  {
    key: "entry_profile",
    title: "Tension",
    what: "Tension",
    brief: "tension",
    dimension: "force_per_width",
    sign: "up",
  },
];

/** @param {number} i @returns {Record<string, any>} */
export const acrossOf = (i) => app.doc.pulley[i].across || {};
/** @param {any} p @returns {Rows} */
export const rowsOf = (p) => (Array.isArray(p) ? p : p?.rows) || [];
/** A profile with other rows, undefined where nothing is left. @param {any} p @param {Rows} rows */
export function withRows(p, rows) {
  if (!p || Array.isArray(p)) return rows.length ? rows : undefined;
  const { rows: _, ...rest } = p;
  if (rows.length) return { ...rest, rows };
  return rest.crown === undefined ? undefined : rest;
}
/** @param {any} p @param {any} crown */
export function withCrown(p, crown) {
  const rows = rowsOf(p);
  const { crown: _, ...rest } = Array.isArray(p) || !p ? { rows } : p;
  if (crown !== undefined) return { crown, ...rest, ...(rows.length ? {} : { rows: undefined }) };
  return rows.length ? (Object.keys(rest).length === 1 ? rows : rest) : undefined;
}
/**
 * Put one key of [pulley.across]; the table goes with its last key.
 * @param {number} i @param {string} key @param {any} value
 */
export function putAcross(i, key, value) {
  const next = { ...acrossOf(i) };
  if (value === undefined) delete next[key];
  else next[key] = JSON.parse(JSON.stringify(value));
  const whole = Object.keys(next).length ? next : undefined;
  change(set(app.doc, ["pulley", i, "across"], whole), `across,${i},${key}`);
}
/** Width of the belt [m]; that of a usual one while it cannot be read. */
export function beltWidth() {
  const width = si(app.doc.belt.width, "length");
  return width > 0 ? width : 1.2;
}

/** Finest steps of a value and of a position in the units looked at: [unit, SI, step]. */
const STEPS = /** @type {Record<string, Record<string, number>>} */ ({
  length: { si: 0.05, us: 0.002 },
  force_per_width: { si: 0.1, us: 1 },
});
/** @param {number} v @param {string} dimension [SI] */
export function valueText(v, dimension) {
  const [u, f] = unit(dimension);
  const step = STEPS[dimension][app.units];
  return `${trim(Math.round(v / f / step) * step)} ${u}`;
}
/** @param {number} y [m] */
export function placeText(y) {
  const [u, f] = unit("length");
  const step = app.units === "us" ? 0.1 : 1;
  return `${trim(Math.round(y / f / step) * step)} ${u}`;
}
/** Size of the finest step of a value [SI]. @param {string} dimension */
export const stepOf = (dimension) => STEPS[dimension][app.units] * unit(dimension)[1];

/** Shapes to begin with: parts of the width from -1 to 1, and of the height. */
export const SHAPES = /** @type {[string, string, [number, number][]][]} */ ([
  [
    "side",
    "on one side",
    [
      [-1, 0],
      [0.35, 0],
      [0.6, 1],
      [1, 1],
    ],
  ],
  [
    "edges",
    "at both edges",
    [
      [-1, 1],
      [-0.6, 0.1],
      [0, 0],
      [0.6, 0.1],
      [1, 1],
    ],
  ],
  [
    "middle",
    "in the middle",
    [
      [-1, 0],
      [-0.6, 0.25],
      [0, 1],
      [0.6, 0.25],
      [1, 0],
    ],
  ],
  [
    "slope",
    "from edge to edge",
    [
      [-1, 0],
      [1, 1],
    ],
  ],
]);
/** Rows of a shape of a height [SI]. @param {string} name @param {number} height
 * @param {string} dimension @returns {Rows} */
export function shaped(name, height, dimension) {
  const half = 0.5 * beltWidth();
  const shape = SHAPES.find(([key]) => key === name)?.[2] || [];
  return shape.map(([y, v]) => [edgeText(y * half), valueText(v * height, dimension)]);
}
/** A position that does not lie beyond the belt when it is rounded. @param {number} y [m] */
export function edgeText(y) {
  const half = 0.5 * beltWidth();
  const text = placeText(y);
  if (Math.abs(si(text, "length")) <= half) return text;
  const [u, f] = unit("length");
  return `${trim(Math.sign(y) * Math.floor((half / f) * 1e4) * 1e-4)} ${u}`;
}
