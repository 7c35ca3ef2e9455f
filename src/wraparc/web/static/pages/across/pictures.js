// The wrap unrolled: a map over angle and width, with the lagging and the tension beside it.
import { app } from "../../base/design.js";
import { digits, dimensionOf, trim, unit } from "../../base/units.js";
import { colour } from "../../plots/ramp.js";
import { roundStep, ticks } from "../../plots/svg.js";
import { h } from "../../vendor/preact.js";

/** @import { Children } from "../../types.d.ts" */

/** What a map can show. @type {[string, string][]} */
export const QUANTITIES = [
  ["shear_stress", "Shear stress"],
  ["creep", "Creep"],
  ["wrap_pressure", "Wrap pressure"],
  ["frictional_energy", "Frictional energy"],
];
const TALL = 300;
const FRAME = { left: 52, top: 14, floor: 236 };

/** @type {{of: any, key: string, drawn: Children}} */
let kept = { of: null, key: "", drawn: null };
/** @param {any} answer @param {string} quantity @returns {Children} */
export function widthPicture(answer, quantity) {
  const key = `${quantity} ${app.units}`;
  if (kept.of === answer && kept.key === key) return kept.drawn;
  const drawn = h(
    "div",
    { class: "unrolled", key: "unrolled" },
    map(answer, quantity),
    lagging(answer),
    tension(answer),
  );
  kept = { of: answer, key, drawn };
  return drawn;
}

/** Ends of the belt [m]. @param {number[]} strips */
const halfOf = (strips) => (strips[strips.length - 1] * strips.length) / (strips.length - 1);
/** @param {number} y @param {number} half */
const down = (y, half) => FRAME.top + ((half - y) / (2 * half)) * (FRAME.floor - FRAME.top);
/** Scale of the width at the left. @param {number} half @param {number} right */
function widthAxis(half, right) {
  const [u, f] = unit("length");
  const values = ticks(-half / f, half / f, roundStep((2 * half) / f, 6));
  const middle = (FRAME.top + FRAME.floor) / 2;
  return [
    values.map((v) =>
      h("path", { d: `M${FRAME.left} ${down(v * f, half)}H${right}`, class: "grid", key: `g${v}` }),
    ),
    values.map((v) =>
      h("text", { x: FRAME.left - 5, y: down(v * f, half) + 3.5, class: "ty", key: v }, trim(v)),
    ),
    h(
      "text",
      { x: 11, y: middle, class: "al", transform: `rotate(-90 11 ${middle})`, key: "label" },
      `Across the belt [${u}]`,
    ),
  ];
}
/** @param {any} answer @param {string} name */
function map(answer, name) {
  const { angle, position, [name]: rows } = answer.map;
  const [u, f] = unit(dimensionOf(name));
  const half = halfOf(position);
  const wide = 420;
  const right = wide - 12;
  const end = angle[angle.length - 1];
  const X = (/** @type {number} */ a) => FRAME.left + (a / end) * (right - FRAME.left);
  const flat = rows.flat();
  const [lo, hi] = [Math.min(...flat), Math.max(...flat)];
  const part = (/** @type {number} */ v) => (hi > lo ? (v - lo) / (hi - lo) : 0);
  const tall = (FRAME.floor - FRAME.top) / position.length;
  const cells = angle.flatMap((/** @type {number} */ a, /** @type {number} */ i) => {
    const from = i ? 0.5 * (a + angle[i - 1]) : 0;
    const to = i < angle.length - 1 ? 0.5 * (a + angle[i + 1]) : end;
    return position.map((/** @type {number} */ y, /** @type {number} */ j) =>
      h("rect", {
        x: X(from),
        y: down(y, half) - tall / 2,
        width: X(to) - X(from) + 0.4,
        height: tall + 0.4,
        fill: colour(part(rows[i][j])),
      }),
    );
  });
  const degrees = (180 / Math.PI) * end;
  const title = QUANTITIES.find(([key]) => key === name)?.[1] || name;
  const worst = flat.indexOf(hi);
  const place = position[worst % position.length];
  const told =
    `${title} over wrap angle and width: ${digits(lo / f)} to ${digits(hi / f)} ${u}, most at ` +
    `${digits((180 / Math.PI) * angle[Math.floor(worst / position.length)], 3)} deg and ` +
    `${digits(place / unit("length")[1], 3)} ${unit("length")[0]} from the middle`;
  return h(
    "svg",
    { class: "chart map", viewBox: `0 0 ${wide} ${TALL}`, role: "img", "aria-label": told },
    h("g", { key: "cells" }, cells),
    widthAxis(half, FRAME.left),
    ticks(0, degrees, degrees > 200 ? 60 : 30).map((v) =>
      h(
        "text",
        { x: X((v * Math.PI) / 180), y: FRAME.floor + 14, class: "tx", key: `a${v}` },
        trim(v),
      ),
    ),
    h(
      "text",
      { x: (FRAME.left + right) / 2, y: FRAME.floor + 29, class: "al", key: "x" },
      "Wrap angle from the entry [deg]",
    ),
    bar(title, u, lo / f, hi / f, right),
  );
}
/** The scale of colours. @param {string} title @param {string} u @param {number} lo
 * @param {number} hi @param {number} right */
function bar(title, u, lo, hi, right) {
  const y = TALL - 20;
  const from = FRAME.left + 66;
  const to = right - 66;
  const n = 40;
  return h(
    "g",
    { key: "bar" },
    Array.from({ length: n }, (_, k) =>
      h("rect", {
        key: k,
        x: from + ((to - from) * k) / n,
        y: y - 8,
        width: (to - from) / n + 0.5,
        height: 8,
        fill: colour(k / (n - 1)),
      }),
    ),
    h("text", { x: from - 5, y, class: "ty" }, digits(lo, 3)),
    h("text", { x: to + 5, y, class: "tr" }, digits(hi, 3)),
    h("text", { x: (from + to) / 2, y: TALL - 4, class: "al" }, u ? `${title} [${u}]` : title),
  );
}

/** @typedef {{values: number[], cls: string, label: string}} Curve */
/** Curves over the width, values to the right.
 * @param {string} title @param {number[]} position @param {Curve[]} curves @param {string} xlabel
 * @param {{at: number, label: string}} [limit] @param {boolean} [zero] */
function panel(title, position, curves, xlabel, limit, zero) {
  const wide = 250;
  const right = wide - 14;
  const half = halfOf(position);
  const all = curves.flatMap((c) => c.values);
  let lo = Math.min(...all, ...(zero ? [0] : []));
  let hi = Math.max(...all, ...(zero ? [0] : []));
  if (limit && limit.at < 1.6 * hi) hi = Math.max(hi, limit.at);
  if (!(hi > lo + 1e-12)) [lo, hi] = [lo - 1, hi + 1];
  const step = roundStep(hi - lo, 4);
  lo = Math.floor(lo / step + 1e-9) * step;
  hi = Math.ceil(hi / step - 1e-9) * step;
  const X = (/** @type {number} */ v) => FRAME.left + ((v - lo) / (hi - lo)) * (right - FRAME.left);
  const course = (/** @type {number[]} */ values) =>
    values
      .map((v, j) => `${j ? "L" : "M"}${X(v).toFixed(1)} ${down(position[j], half).toFixed(1)}`)
      .join("");
  const seen = limit && limit.at <= hi ? limit : undefined;
  const legend = [
    ...curves.map((c) => [`line ${c.cls}`, c.label]),
    ...(seen ? [["limit", seen.label]] : []),
  ];
  const ends = (/** @type {(typeof curves)[number]} */ c) =>
    `${c.label} ${digits(Math.min(...c.values), 3)} to ${digits(Math.max(...c.values), 3)}`;
  return h(
    "svg",
    {
      class: "chart beside",
      viewBox: `0 0 ${wide} ${TALL}`,
      role: "img",
      "aria-label": `${title}: ${curves.map(ends).join(", ")}, ${xlabel}`,
    },
    widthAxis(half, right),
    ticks(lo, hi, step).map((v) => [
      h("path", {
        d: `M${X(v)} ${FRAME.top}V${FRAME.floor}`,
        class: v === 0 ? "zero" : "grid",
        key: `g${v}`,
      }),
      h("text", { x: X(v), y: FRAME.floor + 14, class: "tx", key: v }, trim(v)),
    ]),
    curves.map((c) => h("path", { d: course(c.values), class: `line ${c.cls}`, key: c.label })),
    seen &&
      h("path", { d: `M${X(seen.at)} ${FRAME.top}V${FRAME.floor}`, class: "limit", key: "limit" }),
    h("text", { x: (FRAME.left + right) / 2, y: FRAME.floor + 29, class: "al", key: "x" }, xlabel),
    legend.map(([cls, text], k) => [
      h("path", {
        d: `M${k % 2 ? 136 : 14} ${TALL - (k < 2 ? 20 : 6)}h24`,
        class: cls,
        key: `l${text}`,
      }),
      h("text", { x: k % 2 ? 164 : 42, y: TALL - (k < 2 ? 16 : 2), class: "tr", key: text }, text),
    ]),
  );
}
/** @param {any} answer */
function lagging(answer) {
  const { radius_deviation: radius, thickness } = answer.profiles;
  const [u, f] = unit("length");
  const most = Math.max(...radius);
  const least = Math.max(...thickness);
  const curves = [
    {
      values: radius.map((/** @type {number} */ r) => (r - most) / f),
      cls: "blue",
      label: "radius",
    },
    {
      values: thickness.map((/** @type {number} */ t) => (t - least) / f),
      cls: "orange",
      label: "lagging",
    },
  ];
  return panel(
    "Pulley",
    answer.map.position,
    curves,
    `Difference from the maximum [${u}]`,
    undefined,
    true,
  );
}
/** @param {any} answer */
function tension(answer) {
  const { entry_tension: entry, exit_tension: leaving, static_tension: still } = answer.profiles;
  const [u, f] = unit("force_per_width");
  const scaled = (/** @type {number[]} */ values) => values.map((v) => v / f);
  const curves = [
    { values: scaled(entry), cls: "blue", label: "entry" },
    { values: scaled(leaving), cls: "orange", label: "exit" },
    ...(still ? [{ values: scaled(still), cls: "green", label: "standstill" }] : []),
  ];
  const limit = answer.rating
    ? { at: (1.15 * answer.rating) / f, label: "115 % rating" }
    : undefined;
  return panel("Belt tension", answer.map.position, curves, `Tension [${u}]`, limit, true);
}
