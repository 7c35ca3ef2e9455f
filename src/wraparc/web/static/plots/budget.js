// Creep by source: a bar for each method.
import { trim } from "../base/units.js";
import { fresh, hatches, put, roundStep, s, ticks } from "./svg.js";

const ROW = 34;
/** @typedef {{label: string, parts: number[]}} Bar parts: shrinkage, compression, global creep */

/** @param {Bar[]} bars @param {number} limit */
function ends(bars, limit) {
  /** @param {number} sign */
  const sums = (sign) =>
    bars.map((b) => b.parts.filter((v) => v * sign > 0).reduce((a, v) => a + v, 0));
  let lo = Math.min(0, ...sums(-1));
  let hi = Math.max(0, ...sums(1));
  const near = Math.abs(limit) < 2.5 * Math.max(hi, -lo);
  if (near) {
    lo = Math.min(lo, limit * 1.04);
    hi = Math.max(hi, limit * 1.04);
  }
  return { lo, hi: hi === lo ? lo + 1e-3 : hi, near };
}

/**
 * @param {HTMLElement} box @param {number} wide @param {Bar[]} bars @param {number} limit
 * @param {string} unit @param {string} told
 */
export function drawBudget(box, wide, bars, limit, unit, told) {
  const [left, right] = [bars.length > 1 ? 96 : 12, 14];
  const base = 8 + ROW * bars.length;
  const tall = base + 38;
  const id = fresh("b");
  const { lo, hi, near } = ends(bars, limit);
  const X = (/** @type {number} */ v) => left + ((v - lo) / (hi - lo)) * (wide - left - right);
  const grid = ticks(lo, hi, roundStep(hi - lo, wide < 420 ? 5 : 8)).map((v) => [
    s("path", { d: `M${X(v)} 4V${base}`, class: v ? "grid" : "zero" }),
    s("text", { x: X(v), y: base + 14, class: "tx" }, trim(v)),
  ]);
  const rows = bars.map((b, i) => {
    let [up, down] = [0, 0];
    const parts = b.parts.map((v, k) => {
      if (v < 0) down += v;
      const from = v < 0 ? down : up;
      if (v > 0) up += v;
      const width = Math.max(0, X(from + Math.abs(v)) - X(from));
      return s("rect", { x: X(from), y: 11 + ROW * i, width, height: ROW - 8, ...looks(id, k) });
    });
    const at = { x: left - 6, y: 8 + ROW * i + ROW / 2 + 3, class: "ty" };
    return [bars.length > 1 && s("text", at, b.label), parts];
  });
  const axis = `Creep at exit [${unit}]${near ? "; dotted: the creep limit" : ""}`;
  const size = { width: wide, height: tall, viewBox: `0 0 ${wide} ${tall}` };
  put(
    box,
    s(
      "svg",
      { class: "chart", ...size, role: "img", "aria-label": told },
      hatches(id),
      grid,
      rows,
      near && s("path", { d: `M${X(limit)} 2V${base}`, class: "limit" }),
      s("text", { x: (left + wide - right) / 2, y: tall - 5, class: "al" }, axis),
    ),
  );
}
/** @param {string} id @param {number} k */
const looks = (id, k) => ({
  class: k ? "part" : "part f-blue",
  ...(k && { fill: `url(#${id}${k === 1 ? "x" : "d"})` }),
});
/** A small sample of a part, for the legend. @param {number} k */
export function swatch(k) {
  const id = fresh("s");
  const rect = s("rect", { width: 18, height: 12, ...looks(id, k) });
  return s("svg", { width: 18, height: 12, "aria-hidden": "true" }, hatches(id), rect);
}
