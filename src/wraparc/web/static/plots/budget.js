// Creep by source: a bar for each method.
import { title, trim } from "../base/units.js";
import { attr, each, fixed, fresh, hatches, put, roundStep, s, say, ticks } from "./svg.js";

const ROW = 34;
const RIGHT = 14;
/** @typedef {{label: string, parts: number[]}} Bar parts: shrinkage, compression, global creep */

/** Least and largest value to show, on whole steps. @param {Bar[]} bars @param {number} limit
 * @param {number} most steps */
function ends(bars, limit, most) {
  /** @param {number} sign */
  const sums = (sign) =>
    bars.map((b) => b.parts.filter((v) => v * sign > 0).reduce((a, v) => a + v, 0));
  let lo = Math.min(0, ...sums(-1));
  let hi = Math.max(0, ...sums(1));
  const near = Math.abs(limit) < 2.5 * Math.max(hi, -lo);
  if (near) {
    lo = Math.min(lo, limit);
    hi = Math.max(hi, limit);
  }
  if (hi === lo) hi = lo + 1e-3;
  const step = roundStep(hi - lo, most);
  const half = step / 2;
  lo = Math.floor(lo / half - 1e-9) * half;
  return { lo, hi: Math.ceil(hi / half + 1e-9) * half, step, near };
}

/** The picture in its figure: caption and bars, changed in place. */
export class Budget {
  id = fresh("b");
  grid = s("g");
  rows = s("g");
  names = s("g");
  limit = s("path", { class: "limit" });
  axis = s("text", { class: "al" });
  svg = s("svg", { class: "chart", role: "img" }, hatches(this.id), this.grid, this.names);
  key = "";

  /** @param {HTMLElement} caption @param {HTMLElement} box @param {string} title */
  constructor(caption, box, title) {
    this.svg.append(this.rows, this.limit, this.axis);
    put(box, this.svg);
    const head = document.createElement("strong");
    head.textContent = title;
    this.words = [0, 1, 2].map(() => new Text());
    put(caption, head, ...this.words.map(entry));
  }
  /**
   * @param {number} wide @param {Bar[]} bars @param {number} limit @param {string} unit
   * @param {string} told @param {string[]} words of each part
   */
  draw(wide, bars, limit, unit, told, words) {
    words.forEach((text, i) => {
      say(this.words[i], text);
    });
    const left = bars.length > 1 ? 96 : 12;
    const base = 8 + ROW * bars.length;
    const { lo, hi, step, near } = ends(bars, limit, wide < 420 ? 5 : 8);
    const X = (/** @type {number} */ v) =>
      fixed(left + ((v - lo) / (hi - lo)) * (wide - left - RIGHT));
    const key = [wide, bars.length, lo, hi, unit].join();
    if (key !== this.key) this.scale(X, ticks(lo, hi, step), wide, base);
    this.key = key;
    const middle = (left + wide - RIGHT) / 2;
    attr(this.axis, { x: middle, y: base + 33 });
    say(this.axis, `${title("exit_creep")} [${unit}]${near ? "; dotted: the creep limit" : ""}`);
    attr(this.limit, { d: near ? `M${X(limit)} 2V${base}` : "" });
    const parts = bars.flatMap((b, i) => {
      let [up, down] = [0, 0];
      return b.parts.map((v, k) => {
        if (v < 0) down += v;
        const from = v < 0 ? down : up;
        if (v > 0) up += v;
        const width = Math.max(0, fixed(X(from + Math.abs(v)) - X(from)));
        return { x: X(from), y: 11 + ROW * i, width, height: ROW - 8, ...looks(this.id, k) };
      });
    });
    each(this.rows, "rect", parts);
    const named = bars.length > 1 ? bars : [];
    each(
      this.names,
      "text",
      named.map((_, i) => ({ x: left - 6, y: 8 + ROW * i + ROW / 2 + 3, class: "ty" })),
    );
    named.forEach((b, i) => {
      say(this.names.children[i], b.label);
    });
    attr(this.svg, { "aria-label": told });
  }
  /** @param {(v: number) => number} X @param {number[]} at @param {number} wide
   * @param {number} base */
  scale(X, at, wide, base) {
    const height = base + 38;
    attr(this.svg, { width: wide, height, viewBox: `0 0 ${wide} ${height}` });
    put(
      this.grid,
      at.map((v) => [
        s("path", { d: `M${X(v)} 4V${base}`, class: v ? "grid" : "zero" }),
        s("text", { x: X(v), y: base + 14, class: "tx" }, trim(v)),
      ]),
    );
  }
}
/** @param {string} id @param {number} k */
const looks = (id, k) => ({
  class: k ? "part" : "part f-blue",
  ...(k && { fill: `url(#${id}${k === 1 ? "x" : "d"})` }),
});
/** What the legend says of a part. @param {Text} text @param {number} k */
function entry(text, k) {
  const e = document.createElement("span");
  e.append(swatch(k), text);
  return e;
}
/** A small sample of a part, for the legend. @param {number} k */
function swatch(k) {
  const id = fresh("s");
  const rect = s("rect", { width: 18, height: 12, ...looks(id, k) });
  return s("svg", { width: 18, height: 12, "aria-hidden": "true" }, hatches(id), rect);
}
