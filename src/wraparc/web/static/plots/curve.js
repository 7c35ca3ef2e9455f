// One quantity along the wrap, with its limit and what is beyond it.
import { digits } from "../base/units.js";
import { follow } from "./stage.js";
import { attr, each, fixed, put, roundStep, s, say, ticks } from "./svg.js";

/** @typedef {[number, number]} Point */
/**
 * @typedef {{wrap: number, position: number[], values: number[], limit: number,
 *   limitText: string, beside: number[] | null, bars: [string, number, string][],
 *   note: string, told: string}} CurveData wrap [deg]; beside: a second line, thin; bars: in the
 *   place of a course, what is asked for and what is carried
 */

const [LEFT, RIGHT, TOP, BOTTOM] = [44, 12, 8, 20];

export class Curve {
  grid = s("g");
  names = s("g");
  area = s("path", { class: "band" });
  line = s("path", { class: "course" });
  thin = s("path", { class: "course thin" });
  over = s("path", { class: "band-over" });
  limit = s("path", { class: "band-limit" });
  limitText = s("text", { class: "small" });
  bars = s("g", { class: "two-bars" });
  barTexts = s("g");
  note = s("text", { class: "note" });
  hand = s("path", { class: "pointed" });
  dot = s("circle", { r: 4.5, class: "pointed-dot" });
  /** @type {CurveData | null} */
  data = null;
  wide = 0;
  high = 0;
  scale = 1;

  /** @param {HTMLElement} box @param {(part: number | null) => void} point */
  constructor(box, point) {
    this.svg = s(
      "svg",
      { class: "curve-svg", role: "img" },
      [this.grid, this.names, this.area, this.line, this.thin, this.over, this.limit],
      [this.limitText, this.bars, this.barTexts, this.note, this.hand, this.dot],
    );
    put(box, this.svg);
    this.svg.addEventListener("pointermove", (e) => {
      const x = e.clientX - this.svg.getBoundingClientRect().left;
      point(Math.min(1, Math.max(0, (x - LEFT) / (this.wide - LEFT - RIGHT))));
    });
    this.svg.addEventListener("pointerleave", () => point(null));
    new ResizeObserver(([e]) => {
      [this.wide, this.high] = [Math.floor(e.contentRect.width), Math.floor(e.contentRect.height)];
      attr(this.svg, { viewBox: `0 0 ${this.wide} ${this.high}` });
      if (this.data) this.draw(this.data);
    }).observe(box);
  }
  /** @param {number} part */
  x(part) {
    return fixed(LEFT + part * (this.wide - LEFT - RIGHT));
  }
  /** @param {number} v */
  y(v) {
    return fixed(this.high - BOTTOM - (v / this.scale) * (this.high - BOTTOM - TOP));
  }
  /** @param {CurveData} d */
  draw(d) {
    this.data = d;
    if (this.wide < 80) return;
    attr(this.svg, { "aria-label": d.told });
    const { values, position, limit } = d;
    const seen = values.length > 0;
    const all = [...values.map(Math.abs), ...(d.beside ?? []).map(Math.abs), limit];
    const most = Math.max(...all, 1e-9);
    const step = roundStep(most * 1.02, 2);
    this.scale = step * Math.ceil((most * 1.02) / step - 1e-9);
    this.axes(d, seen ? ticks(0, this.scale, step) : []);
    const end = position[position.length - 1] || 1;
    /** @param {number[]} of @returns {Point[]} */
    const points = (of) => of.map((v, i) => [this.x(position[i] / end), this.y(Math.abs(v))]);
    const path = (/** @type {Point[]} */ of) => (of.length ? `M${of.join("L")}` : "");
    const course = points(values);
    const ground = `L${this.x(1)} ${this.y(0)}H${this.x(0)}Z`;
    attr(this.area, { d: seen ? path(course) + ground : "" });
    attr(this.line, { d: path(course) });
    attr(this.thin, { d: d.beside ? path(points(d.beside)) : "" });
    const at = follow(position, values);
    const parts = Array.from({ length: 121 }, (_, i) => i / 120);
    const beyond = parts.filter((p) => seen && limit && Math.abs(at(p)) >= limit);
    const top = beyond.map((p) => `${this.x(p)} ${this.y(Math.abs(at(p)))}`);
    const foot = beyond.map((p) => `${this.x(p)} ${this.y(limit)}`).reverse();
    attr(this.over, { d: beyond.length > 1 ? `M${[...top, ...foot].join("L")}Z` : "" });
    const shown = seen && limit > 0;
    attr(this.limit, { d: shown ? `M${this.x(0)} ${this.y(limit)}H${this.x(1)}` : "" });
    attr(this.limitText, { x: LEFT + 8, y: this.y(limit || 0) - 5 });
    say(this.limitText, shown ? d.limitText : "");
    this.instead(d);
  }
  /** @param {CurveData} d @param {number[]} levels */
  axes(d, levels) {
    const every = this.wide < 420 ? 60 : 30;
    const angles = d.bars.length ? [] : ticks(0, d.wrap, every * Math.ceil(d.wrap / 361));
    const rows = levels.map((v) => ({ d: `M${LEFT} ${this.y(v)}H${this.wide - RIGHT}` }));
    const foot = this.high - BOTTOM;
    const feet = angles.map((a) => ({ d: `M${this.x(a / d.wrap)} ${foot}v4` }));
    each(this.grid, "path", [...rows, ...feet]);
    const low = this.high - 4;
    each(this.names, "text", [
      ...levels.map((v) => ({ x: LEFT - 6, y: this.y(v) + 4, class: "ty" })),
      ...angles.map((a, i) => {
        const end = a > d.wrap - 1 ? "ty" : "tx";
        return { x: this.x(a / d.wrap), y: low, class: i ? end : "" };
      }),
    ]);
    const names = [...levels.map((v) => digits(v)), ...angles.map((a, i) => degrees(a, i))];
    names.forEach((text, i) => {
      say(this.names.children[i], text);
    });
  }
  /** What stands where there is no course. @param {CurveData} d */
  instead({ bars, note }) {
    const left = 130;
    const most = Math.max(...bars.map(([, v]) => v), 1e-9);
    const wide = this.wide - left - 100;
    const long = bars.map(([, v]) => Math.max(2, (wide * v) / most));
    each(
      this.bars,
      "rect",
      long.map((width, i) => ({ x: left, y: 8 + 36 * i, width: fixed(width), height: 24, rx: 4 })),
    );
    each(
      this.barTexts,
      "text",
      bars.flatMap((_, i) => [
        { x: left - 12, y: 25 + 36 * i, class: "ty" },
        { x: fixed(left + long[i] + 10), y: 25 + 36 * i, class: "figure-left" },
      ]),
    );
    bars
      .flatMap(([name, , text]) => [name, text])
      .forEach((text, i) => {
        say(this.barTexts.children[i], text);
      });
    attr(this.note, { x: this.wide / 2, y: bars.length ? this.high - 6 : this.high / 2 });
    say(this.note, note);
  }
  /** @param {number | null} part */
  at(part) {
    const { data: d } = this;
    const seen = d && part !== null && d.values.length > 0 && this.wide > 80;
    attr(this.hand, { d: seen ? `M${this.x(part)} ${TOP}V${this.high - BOTTOM}` : "" });
    const y = seen ? this.y(Math.abs(follow(d.position, d.values)(part))) : 0;
    attr(this.dot, seen ? { cx: this.x(part), cy: y, r: 4.5 } : { r: 0 });
  }
}
/** @param {number} a @param {number} i */
const degrees = (a, i) => `${a}°${i ? "" : " entry"}`;
