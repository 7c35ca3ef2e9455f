// Several pulleys on one belt in motion: the belt as it runs over them, as thick as its tension.
import { along, arcOf, laid, placed } from "./laid.js";
import { grey } from "./moving.js";
import { shade } from "./ramp.js";
import { attr, fixed, put, s, say } from "./svg.js";

/** @import { Laid, Point } from "./laid.js" */
/**
 * A pulley at an instant: what the lagging shows along its wrap, and the words in its hub.
 * @typedef {{t1: number, t2: number, values: number[], level: string, hub: string[],
 *   now: string, unit: string}} Instant
 */

const CELLS = 48; // of a wrap
const LAG = 12;
const MARKS = 90;

export class MovingTrain {
  /** @param {HTMLElement} box @param {{wrap_angle: number, diameter: number}[]} drums */
  constructor(box, drums) {
    const found = laid(drums);
    this.drums = found.drums;
    this.r = found.r;
    this.ends = [found.come, found.gone];
    this.scale = found.r / Math.max(...drums.map((d) => d.diameter / 2));
    const { x, y, w, h } = found.box;
    this.parts = found.drums.map((d) => this.pulley(d));
    this.spans = Array.from({ length: drums.length + 1 }, () => s("path", { class: "strand" }));
    this.tensions = this.spans.map(() => s("text", { class: "value" }));
    this.rating = s("path", { class: "rated" });
    this.dashes = s("path", { class: "belt-marks", "stroke-dasharray": `12 ${MARKS - 12}` });
    this.svg = s(
      "svg",
      {
        class: `stage linked${drums.length > 2 ? " many" : ""}`,
        viewBox: [x, y, w, h].map(Math.round).join(" "),
        role: "img",
      },
      this.parts.map((p) => p.whole),
      [this.spans, this.rating, this.dashes, this.tensions],
    );
    put(box, this.svg);
  }
  /** @param {Laid<any>} d */
  pulley(d) {
    const [cx, cy] = d.centre;
    const r = this.r - LAG / 2 - 1;
    const cells = Array.from({ length: CELLS }, (_, k) =>
      s("path", {
        ...{ d: arcOf(d, r, k / CELLS, Math.min(k + 1.1, CELLS) / CELLS), fill: "none" },
        "stroke-width": LAG,
      }),
    );
    const belt = Array.from({ length: CELLS }, (_, k) =>
      s("path", {
        d: arcOf(d, this.r, k / CELLS, Math.min(k + 1.1, CELLS) / CELLS),
        class: "strand",
      }),
    );
    const rows = [-0.34, 0.34, 0.54].map((part, k) =>
      s("text", { class: k === 1 ? "hub-share" : "hub-of", x: cx, y: fixed(cy + part * this.r) }),
    );
    const unit = s("tspan", { class: "hub-unit", dx: 4 });
    const number = s(
      "text",
      { class: "hub-number", x: cx, y: fixed(cy + 0.08 * this.r) },
      s("tspan", {}),
      unit,
    );
    const spoke = s("path", {
      class: "spoke",
      d: `M${fixed(cx)} ${fixed(cy - 0.72 * this.r)}v${fixed(-0.12 * this.r)}`,
    });
    const whole = s(
      "g",
      {},
      s("circle", { cx, cy, r, class: "steel shell-ring", "stroke-width": LAG }),
      [spoke, cells, belt, rows, number],
    );
    return { whole, cells, belt, rows, number, spoke };
  }
  /** The middle of the belt from where it comes to where it goes. @param {number[]} thick of the
   * spans */
  course(thick) {
    const arcs = this.drums.map((d, i) =>
      arcOf(d, this.r + (thick[i] + thick[i + 1]) / 4, 0, 1).replace("M", "L"),
    );
    const [come, gone] = [this.between(0, thick)[0], this.between(arcs.length, thick)[1]];
    return `M${placed(come)}${arcs.join("")}L${placed(gone)}`;
  }
  /** @param {Instant[]} instants @param {{full: number, most: number, limit: number,
   *   rating: number, force: (t: number) => string, told: string}} of */
  draw(instants, { full, most, limit, rating, force, told }) {
    const thick = (/** @type {number} */ t) => 2 + (13 * Math.max(0, t)) / (full || 1);
    const tensions = [instants[0].t1, ...instants.map((d) => d.t2)];
    const wide = tensions.map(thick);
    attr(this.svg, { "aria-label": told });
    this.parts.forEach((p, i) => {
      const { t1, t2, values, level, hub, now, unit } = instants[i];
      const n = values.length - 1;
      p.cells.forEach((cell, k) => {
        const v = values[Math.round(((k + 0.5) / CELLS) * n)];
        attr(cell, { stroke: v < 0 ? grey(-v / (most || 1)) : shade(v, most, limit) });
      });
      p.belt.forEach((piece, k) => {
        const w = thick(t1 + ((t2 - t1) * (k + 0.5)) / CELLS);
        const d = arcOf(this.drums[i], this.r + w / 2, k / CELLS, Math.min(k + 1.1, CELLS) / CELLS);
        attr(piece, { d, "stroke-width": fixed(w) });
      });
      attr(p.whole, { class: level });
      p.rows.forEach((row, k) => {
        say(row, hub[k] ?? "");
      });
      say(/** @type {Node} */ (p.number.firstChild), now);
      say(/** @type {Node} */ (p.number.lastChild), unit);
    });
    this.spans.forEach((span, i) => {
      const [a, b] = this.between(i, wide);
      const t = tensions[i];
      const over = rating && t > rating;
      attr(span, {
        d: `M${placed(a)}L${placed(b)}`,
        class: `strand${over ? " over-rating" : ""}`,
        "stroke-width": fixed(wide[i]),
      });
      this.written(i, a, b, t, wide[i], force, Boolean(over));
    });
    attr(this.dashes, { d: this.course(wide) });
    const [[x], [to]] = this.between(0, wide);
    const line = `M${fixed(x)} ${fixed(-thick(rating))}H${fixed(to)}`;
    attr(this.rating, { d: rating ? line : "" });
  }
  /** A span of belt: before the first pulley, between two, behind the last. @param {number} i
   * @param {number[]} thick of the spans @returns {[Point, Point]} */
  between(i, thick) {
    const out = this.r + thick[i] / 2;
    const [a, b] = [this.drums[i - 1], this.drums[i]];
    const start = b && along(b.centre, b.from, out);
    const end = a && along(a.centre, a.from + a.sense * a.wrap, out);
    const [[left], gone] = this.ends;
    if (!end) return [[left, start[1]], start];
    const [dx, dy] = start ? [0, 0] : [end[0] - a.end[0], end[1] - a.end[1]];
    return [end, start ?? [gone[0] + dx, gone[1] + dy]];
  }
  /** @param {number} i @param {Point} a @param {Point} b @param {number} t
   * @param {number} thick @param {(t: number) => string} force @param {boolean} over */
  written(i, a, b, t, thick, force, over) {
    const text = this.tensions[i];
    const last = i === this.spans.length - 1;
    const [x, y] = last ? b : [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    const name = i ? (last ? "T2 " : "") : "T1 ";
    const right = b[0] > a[0];
    const beside = last ? { x: fixed(x + (right ? 8 : -8)), y: fixed(y + 5) } : null;
    attr(text, {
      ...(beside ?? { x: fixed(x), y: fixed(y - thick / 2 - 8) }),
      class: `value${over ? " over-rating" : ""}${last ? (right ? " begins" : " ends") : ""}`,
    });
    say(text, `${name}${force(t)}`);
  }
  /** Move belt and drums. @param {number} travel [m] @param {number[]} angles [rad] */
  turn(travel, angles) {
    attr(this.dashes, { "stroke-dashoffset": fixed(-((travel * this.scale) % MARKS)) });
    this.parts.forEach(({ spoke }, i) => {
      const { centre, sense } = this.drums[i];
      const degrees = fixed(((sense * angles[i] * 180) / Math.PI) % 360);
      attr(spoke, { transform: `rotate(${degrees} ${centre.map(fixed).join(" ")})` });
    });
  }
}
