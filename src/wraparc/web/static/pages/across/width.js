// What is shown over the width: quantities, their limits, the strip that is looked at.
import { dimensionOf, digits, show, unit } from "../../base/units.js";

/** @import { Bar } from "../../types.d.ts" */
/** @typedef {{values: number[], cls: string, label: string}} Course */
/** Left and right of the belt in both pictures [px]: one scale of the width. */
export const SIDES = { left: 52, right: 26 };

/** What can be shown; the name of each in the answer. @type {[string, string][]} */
export const QUANTITIES = [
  ["tension", "Tension"],
  ["creep", "Creep"],
  ["shear_stress", "Shear"],
  ["wrap_pressure", "Pressure"],
  ["frictional_energy", "Energy"],
  ["lagging", "Lagging"],
];
/** What the face is coloured by. @param {string} q */
export const faceOf = (q) => (q === "tension" || q === "lagging" ? "creep" : q);
/** @type {Record<string, string>} */
const TITLES = {
  creep: "Creep",
  shear_stress: "Shear stress",
  wrap_pressure: "Wrap pressure",
  frictional_energy: "Frictional energy",
};
/** @param {string} name */
export const titleOf = (name) => TITLES[name];
/** Checks whose limit a quantity has, the strictest first. @type {Record<string, string[]>} */
const CHECKS = {
  creep: ["uneven_creep", "creep"],
  wrap_pressure: ["uneven_pressure", "tested_pressure_max"],
};
/** The limit of a quantity [SI], as its check states it; 0 for none.
 * @param {any} a the answer @param {string} name */
export function limitOf(a, name) {
  const bar = (CHECKS[name] ?? [])
    .map((check) => a.bars.find((/** @type {Bar} */ b) => b.name === check))
    .find(Boolean);
  return bar?.at_most && bar.share ? bar.value / bar.share : 0;
}
/** The largest of each strip along the wrap. @param {any} a @param {string} name
 * @returns {number[]} */
const largestOf = (a, name) =>
  a.map.position.map((/** @type {number} */ _, /** @type {number} */ j) =>
    Math.max(...a.map[name].map((/** @type {number[]} */ row) => row[j])),
  );
/** Ends of the belt [m]. @param {number[]} strips */
export const halfOf = (strips) => (strips[strips.length - 1] * strips.length) / (strips.length - 1);
/** The strip that comes off worst. @param {any} a @param {string} q */
export function worst(a, q) {
  const values = largestOf(a, faceOf(q));
  return values.indexOf(Math.max(...values));
}
/** The strip at a place on the belt. @param {any} a @param {number} y [m] */
export function stripAt(a, y) {
  const { position } = a.map;
  const half = halfOf(position);
  const k = Math.floor(((y + half) / (2 * half)) * position.length);
  return Math.min(position.length - 1, Math.max(0, k));
}
/** Courses over the width, their unit and limit in it.
 * @param {any} a @param {string} q
 * @returns {{courses: Course[], u: string, limit?: {at: number, label: string}}} */
export function coursesOf(a, q) {
  if (q === "tension") {
    const { entry_tension: entry, exit_tension: leaving, static_tension: still } = a.profiles;
    const [u, f] = unit("force_per_width");
    const scaled = (/** @type {number[]} */ values) => values.map((v) => v / f);
    const courses = [
      { values: scaled(entry), cls: "most", label: "entry" },
      { values: scaled(leaving), cls: "least", label: "exit" },
      ...(still ? [{ values: scaled(still), cls: "dotted", label: "standstill" }] : []),
    ];
    const at = (1.15 * (a.rating ?? 0)) / f;
    return {
      courses,
      u,
      limit: at ? { at, label: `${digits(at, 3)} ${u}, 115 % rating` } : undefined,
    };
  }
  if (q === "lagging") {
    const { radius_deviation: radius, thickness } = a.profiles;
    const [u, f] = unit("length");
    const below = (/** @type {number[]} */ of) => of.map((v) => (v - Math.max(...of)) / f);
    const courses = [
      { values: below(radius), cls: "most", label: "radius, from the maximum" },
      { values: below(thickness), cls: "dotted", label: "lagging, from the maximum" },
    ];
    return { courses, u };
  }
  const [u, f] = unit(dimensionOf(q));
  const values = largestOf(a, q).map((v) => v / f);
  const at = limitOf(a, q) / f;
  const label = q === "wrap_pressure" ? "maximum along the wrap" : "at the exit";
  return {
    courses: [
      { values, cls: "most", label: q === "shear_stress" ? "maximum along the wrap" : label },
    ],
    u,
    limit: at ? { at, label: `limit ${digits(at)} ${u}` } : undefined,
  };
}
/** Three digits. @param {number} v */
export const short = (v) => +v.toPrecision(3);
/** What is said of a strip: its place, and what it shows. @param {any} a @param {number} j
 * @param {string} name */
export function stripWords(a, j, name) {
  const { position } = a.map;
  const p = a.profiles;
  const value = show(short(largestOf(a, name)[j]), dimensionOf(name));
  const [fu, ff] = unit("force_per_width");
  const tensions = [p.entry_tension[j], p.exit_tension[j]].map((v) => digits(v / ff, 3));
  const lagging = show(p.thickness[j], "length", 3);
  const beside = `T1 ${tensions[0]}, T2 ${tensions[1]} ${fu}, lagging ${lagging}`;
  return { place: show(position[j], "length", 3), value, beside };
}
