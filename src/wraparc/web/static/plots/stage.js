// One pulley as it runs: the belt as thick as its tension, its lagging coloured by a quantity, and
// handles that move the tensions and the wrap.
import { grasp } from "../base/design.js";
import { shade } from "./ramp.js";
import { attr, each, fixed, put, s, say } from "./svg.js";

/** @typedef {[number, number]} Point */
/**
 * @typedef {"t1" | "t2" | "wrap"} Handle
 * @typedef {{label: string, now: number, least: number, most: number, text: string,
 *   unit: number, step: number}} Held a handle: its value and range [SI], as text, its unit, and
 *   how far a key moves it
 * @typedef {{phi: number, t1: number, t2: number, full: number, position: number[],
 *   tension: number[], values: number[], most: number, limit: number, level: string,
 *   solved: boolean, hub: string[], figures: [string, string][], legend: string, told: string,
 *   texts: Record<Handle, string>, handles: Partial<Record<Handle, Held>>,
 *   marks: Partial<Record<Handle, [number, string]>>}} StageData
 *   full: the tension [N] at the far end of a strand
 */

const [CX, CY, R] = [490, 250, 164];
const [LAG, BAND] = [13, 54];
const CELLS = 72;
/** Where the pulley is in the picture, and of how many parts its lagging. */
export const PLACE = { x: CX, y: CY, r: R, cells: CELLS };
/** How far a handle is from the pulley at no tension, and how much farther at the full one; on a
 * narrow screen. */
const [NEAR, FAR, CLOSE] = [44, 360, 190];
const NARROW = 520; // [px]
/** A strand that bends off behind the pulley. */
const STRAIGHT = 66;
const FLAT = 0.07; // [rad] from half a turn
const STEPS = /** @type {Record<string, number>} */ ({
  ArrowLeft: -1,
  ArrowDown: -1,
  ArrowRight: 1,
  ArrowUp: 1,
  PageUp: 10,
  PageDown: -10,
});

/** @param {number} r @param {number} a @returns {Point} */
const at = (r, a) => [CX + r * Math.sin(a), CY - r * Math.cos(a)];
/** @param {Point[]} points */
const line = (points) => `M${points.map(([x, y]) => `${fixed(x)} ${fixed(y)}`).join("L")}`;
/** @param {number} v @param {number} lo @param {number} hi */
const cut = (v, lo, hi) => Math.min(hi, Math.max(lo, v));
/** What follows a course at a share of it. @param {number[]} x @param {number[]} y */
export function follow(x, y) {
  const end = x[x.length - 1] || 1;
  let j = 0;
  return (/** @type {number} */ part) => {
    const v = part * end;
    if (x[j] > v) j = 0;
    while (j < x.length - 2 && x[j + 1] < v) j++;
    return y[j] + ((y[j + 1] - y[j]) * (v - x[j])) / (x[j + 1] - x[j] || 1);
  };
}

export class Stage {
  band = s("path", { class: "band" });
  edge = s("path", { class: "band-edge" });
  over = s("path", { class: "band-over" });
  limit = s("path", { class: "band-limit" });
  cells = Array.from({ length: CELLS }, () => s("path", { "stroke-width": LAG, fill: "none" }));
  strands = [s("path", { class: "strand" }), s("path", { class: "strand" })];
  belt = s("path", { class: "belt" });
  runs = s("path", { class: "run" });
  snub = s("circle", { r: 20, class: "steel" });
  ways = [s("path", { class: "way" }), s("path", { class: "way" })];
  gauge = s("path", { class: "gauge-line" });
  ends = [s("text", { class: "small" }), s("text", { class: "small" })];
  marks = Object.fromEntries(
    ["t1", "t2", "wrap"].map((k) => [k, [s("path", { class: "mark-line" }), s("text", {})]]),
  );
  texts = Object.fromEntries(["t1", "t2", "wrap"].map((k) => [k, s("text", { class: "value" })]));
  hub = ["head", "of", "share"].map((c) => s("text", { class: `hub-${c}` }));
  number = s(
    "text",
    { class: "hub-number", x: CX, y: CY + 14 },
    s("tspan", {}),
    s("tspan", { class: "hub-unit", dx: 6 }),
  );
  figures = s("g", { class: "figures-in" });
  legend = s("text", { class: "legend", x: 764, y: 492 });
  hand = s("path", { class: "pointed" });
  /** @type {Partial<Record<Handle, SVGElement>>} */
  knobs = {};
  /** @type {StageData | null} */
  data = null;
  /** @type {Handle | null} */
  grip = null;
  far = FAR;
  left = 0;

  /**
   * @param {HTMLElement} box
   * @param {(handle: Handle, value: number) => void} move
   * @param {(part: number | null) => void} point
   */
  constructor(box, move, point) {
    this.move = move;
    this.svg = s(
      "svg",
      { class: "stage", viewBox: "0 0 780 505", role: "group" },
      [this.band, this.edge, this.over, this.limit, this.snub],
      s("circle", { cx: CX, cy: CY, r: R - LAG / 2, class: "steel shell-ring" }),
      [this.cells, this.strands, this.belt, this.runs, this.ways, this.gauge, this.ends],
      [this.figures, this.legend, this.hub, this.number, this.hand],
      [Object.values(this.marks), Object.values(this.texts)],
      ["t1", "t2", "wrap"].map((k) => this.knob(/** @type {Handle} */ (k))),
    );
    put(box, this.svg);
    new ResizeObserver(([e]) => {
      const narrow = e.contentRect.width < NARROW;
      attr(this.svg, { viewBox: narrow ? "228 4 500 496" : "0 0 780 505" });
      [this.far, this.left] = narrow ? [CLOSE, 228] : [FAR, 0];
      if (this.data) this.draw(this.data);
    }).observe(box);
    this.svg.addEventListener("pointermove", (e) => this.pointed(e, point));
    this.svg.addEventListener("pointerleave", () => this.grip || point(null));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      this.svg.addEventListener(end, () => {
        this.grip = null;
      });
  }
  /** @param {Handle} key */
  knob(key) {
    const found = s(
      "g",
      { class: "h", tabindex: 0, role: "slider" },
      s("circle", { r: 22, class: "hit" }),
      s("circle", { r: 11, class: "ring" }),
      s("path", { d: "M-2.5-3.5-6 0l3.5 3.5M2.5-3.5 6 0 2.5 3.5", class: "chevrons" }),
    );
    found.addEventListener("pointerdown", (e) => {
      if (/** @type {PointerEvent} */ (e).button) return;
      grasp();
      this.grip = key;
      found.setPointerCapture(/** @type {PointerEvent} */ (e).pointerId);
      found.focus({ preventScroll: true });
      e.preventDefault();
    });
    found.addEventListener("keydown", (e) => this.pressed(key, e));
    this.knobs[key] = found;
    return found;
  }
  /** @param {Handle} key @param {KeyboardEvent} e */
  pressed(key, e) {
    const step = STEPS[e.key];
    const held = this.data?.handles[key];
    if (!step || !held || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    const size = held.step * (e.shiftKey ? 0.1 : 1);
    this.put(key, held.now + step * size, 0.1 * held.step);
  }
  /** @param {Handle} key @param {number} v @param {number} [part] that it is a multiple of */
  put(key, v, part) {
    const held = this.data?.handles[key];
    if (!held) return;
    const ends = [Math.min(held.least, held.now), Math.max(held.most, held.now)];
    const size = part ?? held.step;
    this.move(key, cut(size * Math.round(v / size), ends[0], ends[1]));
  }
  /** @param {PointerEvent} e @param {(part: number | null) => void} point */
  pointed(e, point) {
    const { data: d, grip } = this;
    const turn = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (this.svg)).getScreenCTM();
    if (!d || !turn) return;
    const { x, y } = new DOMPoint(e.clientX, e.clientY).matrixTransform(turn.inverse());
    const angle = (Math.atan2(x - CX, CY - y) + 2 * Math.PI) % (2 * Math.PI);
    if (grip === "wrap") return this.put("wrap", angle);
    if (grip) return this.put(grip, this.tension(grip, x, y));
    const r = Math.hypot(x - CX, y - CY);
    point(d.solved && r > 70 && r < R + 90 && angle <= d.phi ? angle / d.phi : null);
  }
  /** Thickness of the belt at a tension. @param {number} t */
  thick(t) {
    return 3 + 14 * cut(t / (this.data?.full || 1), 0, 1.2);
  }
  /** The slack strand: where it leaves the pulley, its direction, how far it runs straight. */
  exit() {
    const { phi = Math.PI, t2 = 0 } = this.data ?? {};
    const flat = Math.abs(phi - Math.PI) < FLAT;
    const out = phi < 1.7 || phi > 4.6;
    const [x, y] = at(R + this.thick(t2) / 2, phi);
    const [dx, dy] = flat ? [-1, 0] : [Math.cos(phi), Math.sin(phi)];
    return { x, y, dx, dy, straight: out ? 400 : flat ? 0 : STRAIGHT, out };
  }
  /** Where a tension is on its strand. @param {Handle} key @param {number} t @returns {Point} */
  along(key, t) {
    const d = NEAR + (this.far * t) / (this.data?.full || 1);
    if (key === "t1") return [CX - d, CY - R - this.thick(this.data?.t1 ?? 0) / 2];
    const { x, y, dx, dy, straight } = this.exit();
    if (d < straight || !straight) return [x + dx * d, straight ? y + dy * d : y];
    return [x + dx * straight - (d - straight), y + dy * straight];
  }
  /** The tension of a place beside its strand. @param {Handle} key @param {number} x
   * @param {number} y */
  tension(key, x, y) {
    const full = this.data?.full || 1;
    if (key === "t1") return (full * (CX - NEAR - x)) / this.far;
    const e = this.exit();
    const bent = e.x + e.dx * e.straight;
    const d = e.out ? (x - e.x) * e.dx + (y - e.y) * e.dy : bent - x + e.straight;
    return (full * (d - NEAR)) / this.far;
  }
  /** @param {StageData} d */
  draw(d) {
    this.data = d;
    attr(this.svg, { class: `stage ${d.level}${d.solved ? "" : " moves"}`, "aria-label": d.told });
    this.ring(d);
    this.strand(d);
    this.words(d);
    for (const key of /** @type {Handle[]} */ (["t1", "t2", "wrap"])) this.handle(d, key);
  }
  /** Lagging, band and belt on the arc. @param {StageData} d */
  ring(d) {
    const value = follow(d.position, d.values);
    const tension = follow(d.position, d.tension);
    const places = Array.from({ length: CELLS + 1 }, (_, i) => i / CELLS);
    const base = R + this.thick(d.full) + 3;
    const high = (/** @type {number} */ v) => base + (BAND * Math.abs(v)) / (d.most || 1);
    const foot = places.map((p) => at(base, p * d.phi)).reverse();
    const top = d.solved ? places.map((p) => at(high(value(p)), p * d.phi)) : [];
    attr(this.band, { d: d.solved ? `${line([...top, ...foot])}Z` : "" });
    attr(this.edge, { d: d.solved ? line(top) : "" });
    const beyond = places.filter((p) => d.limit && d.solved && Math.abs(value(p)) >= d.limit);
    const over = beyond.map((p) => at(high(value(p)), p * d.phi));
    const under = beyond.map((p) => at(high(d.limit), p * d.phi)).reverse();
    attr(this.over, { d: beyond.length > 1 ? `${line([...over, ...under])}Z` : "" });
    const limit = places.map((p) => at(high(d.limit), p * d.phi));
    attr(this.limit, { d: d.limit && d.solved ? line(limit) : "" });
    this.cells.forEach((cell, i) => {
      const [a, b] = [(i / CELLS) * d.phi, Math.min(d.phi, ((i + 1.12) / CELLS) * d.phi)];
      const r = R - LAG / 2;
      attr(cell, { d: line([at(r, a), at(r, (a + b) / 2), at(r, b)]) });
      const v = d.solved ? Math.abs(value((i + 0.5) / CELLS)) : 0;
      if (d.solved) attr(cell, { stroke: shade(v, d.most, d.limit) });
      else cell.removeAttribute("stroke");
    });
    const outer = places.map((p) => at(R + this.thick(tension(p)), p * d.phi));
    const inner = places.map((p) => at(R, p * d.phi)).reverse();
    attr(this.belt, { d: `${line([...outer, ...inner])}Z` });
    const run = places.map((p) => at(R + 30, p * d.phi));
    attr(this.runs, { d: d.level === "bad" && !d.solved ? line(run) : "" });
  }
  /** The belt beside the pulley. @param {StageData} d */
  strand(d) {
    const y1 = CY - R - this.thick(d.t1) / 2;
    attr(this.strands[0], {
      d: `M-400 ${fixed(y1)}H${CX + 0.5}`,
      "stroke-width": this.thick(d.t1),
    });
    const { x, y, dx, dy, straight, out } = this.exit();
    const [bx, by] = [x + dx * straight, y + dy * straight];
    const tail = out ? "" : "H-400";
    const path = `M${fixed(x)} ${fixed(y)}L${fixed(bx)} ${fixed(by)}${tail}`;
    attr(this.strands[1], { d: path, "stroke-width": this.thick(d.t2) });
    const bent = straight && !out;
    const side = (dy < 0 ? 1 : -1) * (20 + this.thick(d.t2) / 2);
    attr(this.snub, bent ? { cx: fixed(bx), cy: fixed(by + side), r: 20 } : { r: 0 });
    attr(this.ways[0], { d: `M${this.left + 15} ${y1 - 4}l8 4l-8 4z` });
    attr(this.ways[1], { d: out ? "" : `M${this.left + 25} ${fixed(by) - 4}l-8 4l8 4z` });
    const ra = R - 26;
    const far = d.phi > Math.PI ? 1 : 0;
    const arc = d.phi < 6.2 ? `${at(ra, 0)}A${ra} ${ra} 0 ${far} 1 ${at(ra, d.phi)}` : at(ra, 0);
    attr(this.gauge, { d: `M${arc}M${at(R - 16, 0)}L${at(ra - 6, 0)}` });
    attr(this.ends[0], { x: CX + 10, y: fixed(CY - R - this.thick(d.full) - 6) });
    attr(this.ends[1], { x: CX + 12, y: CY + R + 32 });
    say(this.ends[0], d.solved ? "entry" : "");
    say(this.ends[1], d.solved && !straight ? "exit" : "");
  }
  /** @param {StageData} d */
  words(d) {
    const [head, number, unit, of, share] = d.hub;
    const places = [-34, 40, 60];
    [head, of, share].forEach((text, i) => {
      attr(this.hub[i], { x: CX, y: CY + places[i] });
      say(this.hub[i], text);
    });
    say(this.number.children[0], number);
    say(this.number.children[1], unit);
    const rows = d.figures.flatMap((_, i) => [
      { x: 24, y: 162 + 24 * i, class: "small" },
      { x: 232, y: 162 + 24 * i, class: "figure" },
    ]);
    each(this.figures, "text", rows);
    d.figures.flat().forEach((text, i) => {
      say(this.figures.children[i], text);
    });
    say(this.legend, d.legend);
  }
  /** A handle, the value at it, and the mark of its limit. @param {StageData} d
   * @param {Handle} key */
  handle(d, key) {
    const held = d.handles[key];
    const knob = /** @type {SVGElement} */ (this.knobs[key]);
    const now = key === "wrap" ? d.phi : d[key];
    const place = key === "wrap" ? at(R - 26, d.phi) : this.along(key, now);
    const [x, y] = place.map(fixed);
    if (knob.hasAttribute("hidden") === Boolean(held)) knob.toggleAttribute("hidden", !held);
    if (held) {
      const turn = key === "wrap" ? (d.phi * 180) / Math.PI - 180 : 0;
      attr(knob, {
        transform: `translate(${x} ${y})`,
        "aria-label": held.label,
        "aria-valuemin": +(held.least / held.unit).toPrecision(4),
        "aria-valuemax": +(held.most / held.unit).toPrecision(4),
        "aria-valuenow": +(held.now / held.unit).toPrecision(6),
        "aria-valuetext": held.text,
      });
      attr(/** @type {Element} */ (knob.lastChild), { transform: `rotate(${fixed(turn)})` });
    }
    const label = this.texts[key];
    if (key === "wrap") {
      const [lx, ly] = at(R - 50, d.phi);
      attr(label, { x: fixed(lx), y: fixed(ly + 5) });
    } else {
      const beside = key === "t1" ? -24 : 36;
      attr(label, { x: cut(x, this.left + 62, 700), y: fixed(y + beside) });
    }
    say(label, d.texts[key]);
    this.mark(d, key);
  }
  /** @param {StageData} d @param {Handle} key */
  mark(d, key) {
    const [tick, text] = this.marks[key];
    const of = d.marks[key];
    if (!of) {
      attr(tick, { d: "" });
      return say(text, "");
    }
    if (key === "wrap")
      return attr(tick, { d: `M${at(R - 17, of[0]).map(fixed)}L${at(R - 34, of[0]).map(fixed)}` });
    const [x, y] = this.along(key, of[0]).map(fixed);
    attr(tick, { d: `M${x} ${y - 15}V${y + 15}` });
    const inside = cut(x, this.left + 68, CX - 76); // the words: not cut, not on the handle
    attr(text, { x: inside, y: key === "t1" ? y + 34 : y - 24, class: "mark-text" });
    say(text, of[1]);
  }
  /** Show the place that is pointed at. @param {number | null} part */
  at(part) {
    const { data: d } = this;
    const seen = d?.solved && part !== null;
    const a = seen ? part * d.phi : 0;
    attr(this.hand, { d: seen ? line([at(R - 18, a), at(R + 80, a)]) : "" });
  }
}
