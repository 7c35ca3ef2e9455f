// Lines over a common axis, with hatched zones, a limit, points, a second scale and a cursor.
import { trim } from "../base/units.js";
import { attr, each, fixed, fresh, hatches, put, roundStep, s, ticks } from "./svg.js";

/** @import { named } from "./named.js" */
/** @import { ChartData, ChartLook, Line } from "../types.d.ts" */

const RIGHT = 14;
const RIGHT_WITH_SCALE = 50;
const TOP = 8;
/** Left margin of charts that stand under each other. */
const LEFT = 62;

/** @param {number} span @param {number} most */
const angleStep = (span, most) =>
  [5, 10, 15, 30, 45, 60, 90, 180].find((v) => span / v <= most) || 180;

/** Least and largest value to show, on whole steps. @param {ChartData} data @param {number} tall */
function range(data, tall) {
  let lo = data.zero ? 0 : Number.POSITIVE_INFINITY;
  let hi = data.zero ? 0 : Number.NEGATIVE_INFINITY;
  for (const line of data.lines)
    if (!line.free)
      for (const y of line.y) {
        if (y == null) continue;
        if (y < lo) lo = y;
        if (y > hi) hi = y;
      }
  const limit = data.limit?.y;
  if (limit !== undefined && Math.abs(limit) < 2.2 * Math.max(Math.abs(lo), Math.abs(hi))) {
    lo = Math.min(lo, limit);
    hi = Math.max(hi, limit);
  }
  if (!(hi > lo)) {
    hi = (Number.isFinite(hi) ? hi : 0) + 1e-3;
    lo = (Number.isFinite(lo) ? lo : 0) - (data.zero ? 0 : 1e-3);
  }
  const step = roundStep(hi - lo, tall < 150 ? 4 : 5);
  return {
    lo: Math.floor(lo / step + 1e-9) * step,
    hi: Math.ceil(hi / step - 1e-9) * step,
    step,
  };
}

export class Chart {
  back = s("g");
  zones = s("g");
  marks = s("g");
  bound = s("path", { class: "limit" });
  layer = s("g");
  names = s("g");
  /** What puts names at the lines, where a legend does not. @type {typeof named | null} */
  named = null;
  cursor = s("path", { class: "cursor" });
  legend = document.createElement("figcaption");
  id = fresh("c");
  /** @type {SVGElement[]} */
  paths = [];
  /** @type {ChartData | null} */
  data = null;
  wide = 0;
  left = 0;
  right = RIGHT;
  floor = 0;
  x0 = 0;
  x1 = 1;
  lo = 0;
  hi = 1;
  key = "";
  words = "";

  /** @param {HTMLElement} box @param {ChartLook} look */
  constructor(box, { title, height = 190, xlabel = "", onpick, stacked, numbered = true }) {
    this.box = box;
    this.title = title;
    this.height = height;
    this.xlabel = xlabel;
    this.stacked = stacked;
    this.numbered = numbered;
    this.svg = s(
      "svg",
      { class: "chart", role: "img", "aria-label": title },
      hatches(this.id),
      this.back,
      this.zones,
      this.layer,
      this.bound,
      this.marks,
      this.names,
      this.cursor,
    );
    put(box, this.legend, this.svg);
    // drawing must not ask for the width: that would lay out the page at every step
    this.sized = new ResizeObserver(([e]) => {
      const wide = Math.floor(e.contentRect.width);
      if (!wide || wide === this.wide) return;
      this.wide = wide;
      if (this.data) this.draw(this.data);
    });
    this.sized.observe(box);
    if (onpick)
      for (const kind of ["pointerdown", "pointermove"])
        this.svg.addEventListener(kind, (e) =>
          this.picked(/** @type {PointerEvent} */ (e), onpick),
        );
  }
  /** @param {PointerEvent} e @param {NonNullable<ChartLook["onpick"]>} onpick */
  picked(e, onpick) {
    const from = this.svg.getBoundingClientRect().left + this.left;
    const part = (e.clientX - from) / (this.wide - this.left - this.right);
    onpick(Math.max(0, Math.min(1, part)), e);
  }
  /** @param {number} v */
  X(v) {
    return this.left + ((v - this.x0) / (this.x1 - this.x0)) * (this.wide - this.left - this.right);
  }
  /** @param {number} v */
  Y(v) {
    return TOP + ((this.hi - v) / (this.hi - this.lo)) * (this.floor - TOP);
  }
  /** @param {ChartData} data */
  draw(data) {
    this.data = data;
    this.wide ||= this.box.clientWidth || 480;
    this.right = data.other || this.stacked ? RIGHT_WITH_SCALE : RIGHT;
    this.floor = this.height - (this.numbered ? (this.xlabel ? 36 : 22) : 6);
    [this.x0, this.x1] = data.xs || [data.x[0], data.x[data.x.length - 1]];
    const { lo, hi, step } = range(data, this.height);
    const longest = Math.max(trim(lo).length, trim(hi).length, trim(hi - step).length);
    Object.assign(this, { lo, hi, left: this.stacked ? LEFT : 26 + 6.8 * longest });
    const scale = [data.ylabel, data.other?.label, data.other?.key.toPrecision(4)];
    const key = [this.wide, lo, hi, this.x0, this.x1, ...scale].join();
    if (key !== this.key) this.axes(data, step);
    this.key = key;
    this.lines(data);
    this.signs(data);
    this.caption(data);
  }
  /** @param {ChartData} data */
  lines(data) {
    while (this.paths.length < data.lines.length) {
      const path = s("path");
      this.paths.push(path);
      this.layer.append(path);
    }
    this.paths.forEach((path, i) => {
      const line = data.lines[i];
      if (line) attr(path, { d: this.course(line, data.x), class: `line ${line.cls}` });
      else path.setAttribute("d", "");
    });
  }
  /** @param {Line} line @param {number[]} common */
  course(line, common) {
    const xs = line.x || common;
    let d = "";
    for (let j = 0; j < xs.length; j++) {
      const y = line.y[j];
      if (y == null) continue;
      const inside = Math.max(TOP, Math.min(this.floor, this.Y(y)));
      const joined = d && line.y[j - 1] != null;
      d += `${joined ? "L" : "M"}${fixed(this.X(xs[j]))} ${fixed(inside)}`;
    }
    return d;
  }
  /** Zones, the limit and points. @param {ChartData} data */
  signs({ zones = [], limit, points = [] }) {
    const tall = this.floor - TOP;
    each(
      this.zones,
      "rect",
      zones.map(([a, b, kind]) => {
        const width = Math.max(0.5, this.X(b) - this.X(a));
        const fill = `url(#${this.id}${kind})`;
        return { x: this.X(a), width, y: TOP, height: tall, fill };
      }),
    );
    const line = limit && this.sees(limit.y);
    const d = line ? `M${this.left} ${fixed(this.Y(limit.y))}H${this.wide - this.right}` : "";
    attr(this.bound, { d });
    each(
      this.marks,
      "circle",
      points.map(([x, y, cls = ""]) => {
        const [cx, cy] = [this.X(x), this.Y(y)].map(fixed);
        return { cx, cy, r: 3.5, class: `pt ${cls}` };
      }),
    );
  }
  /** @param {number} y */
  sees(y) {
    return y >= this.lo && y <= this.hi;
  }
  /** @param {ChartData} data */
  caption(data) {
    this.named?.(this, data);
    const words = data.lines.filter((l) => l.label).map((l) => [`line ${l.cls}`, l.label || ""]);
    if (data.limit && this.sees(data.limit.y)) words.push(["limit", data.limit.label]);
    if (data.pointLabel) words.push(["pt", data.pointLabel]);
    const key = this.stacked ? this.title : JSON.stringify(words);
    if (key !== this.words) {
      this.words = key;
      const strong = document.createElement("strong");
      strong.textContent = this.title;
      put(this.legend, strong, this.stacked ? [] : words.map(([cls, text]) => legendOf(cls, text)));
    }
    const told = data.told || words.map((v) => v[1]).join(", ");
    attr(this.svg, { "aria-label": `${this.title}: ${told}` });
  }
  /** @param {ChartData} data @param {number} step */
  axes(data, step) {
    const { left, right, floor, wide, height } = this;
    attr(this.svg, { width: wide, height, viewBox: `0 0 ${wide} ${height}` });
    const room = Math.max(3, Math.floor((wide - left - right) / 46));
    const span = this.x1 - this.x0;
    const xstep = data.angles ? angleStep(span, room) : roundStep(span, Math.min(8, room));
    const ys = ticks(this.lo, this.hi, step);
    const xs = ticks(this.x0, this.x1, xstep);
    const middle = (TOP + floor) / 2;
    /** @param {number} x @param {string} text */
    const upright = (x, text) =>
      s("text", { x, y: middle, class: "al", transform: `rotate(-90 ${x} ${middle})` }, text);
    put(
      this.back,
      ys.map((v) =>
        s("path", { d: `M${left} ${this.Y(v)}H${wide - right}`, class: v === 0 ? "zero" : "grid" }),
      ),
      xs.map((v) => s("path", { d: `M${this.X(v)} ${TOP}V${floor}`, class: "grid" })),
      ys.map((v) => s("text", { x: left - 5, y: this.Y(v) + 3.5, class: "ty" }, trim(v))),
      this.numbered &&
        xs.map((v) => s("text", { x: this.X(v), y: floor + 14, class: "tx" }, trim(v))),
      this.second(data),
      upright(11, data.ylabel),
      data.other && upright(wide - 6, data.other.label),
      this.xlabel &&
        s("text", { x: (left + wide - right) / 2, y: height - 5, class: "al" }, this.xlabel),
    );
  }
  /** Numbers of the second scale. @param {ChartData} data */
  second({ other }) {
    if (!other) return [];
    const [a, b] = [other.to(this.lo), other.to(this.hi)];
    return ticks(a, b, roundStep(b - a, 5)).map((v) => {
      const y = this.Y(other.from(v)) + 3.5;
      return s("text", { x: this.wide - this.right + 5, y, class: "tr" }, trim(v));
    });
  }
  /** Show the cursor at a part of the axis. @param {number} part */
  at(part) {
    if (!this.data) return;
    const x = this.X(this.x0 + part * (this.x1 - this.x0));
    attr(this.cursor, { d: `M${fixed(x)} ${TOP}V${this.floor}` });
  }
}

/** @param {string} cls @param {string} text */
function legendOf(cls, text) {
  const e = document.createElement("span");
  const sample =
    cls === "pt"
      ? s("circle", { cx: 13, cy: 5, r: 3.5, class: "pt" })
      : s("path", { d: "M1 5H25", class: cls });
  e.append(s("svg", { width: 26, height: 10, "aria-hidden": "true" }, sample), text);
  return e;
}
