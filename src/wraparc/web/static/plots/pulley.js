// The pulley with its arc: coloured, and with the same quantity as height of a second ring.
import { digits } from "../base/units.js";
import { attr, each, fixed, fresh, hatches, put, s, say, warm } from "./svg.js";

/** @typedef {[number, number]} Point */
/**
 * @typedef {{phi: number, position: number[], values: number[], most: number, t1: number,
 *   t2: number, text1: string, text2: string, duty: string, outside: [number, number][],
 *   stuck: number, peak: number, told: string}} PulleyData
 * @typedef {{start: Point, out: Point}} Strand
 */

const CELLS = 90;
const SHELL = 80;
const LAG = 100;

/** @param {Point} a @param {Point} b @param {number} f @returns {Point} */
const add = ([x, y], [u, v], f) => [fixed(x + f * u), fixed(y + f * v)];
/** @param {Point[]} points */
const poly = (points) => `M${points.map(([x, y]) => `${fixed(x)} ${fixed(y)}`).join("L")}`;

export class Pulley {
  id = fresh("p");
  cells = Array.from({ length: CELLS }, () => s("path"));
  belt = s("path", { class: "belt" });
  height = s("path", { class: "height" });
  zones = s("g");
  nips = s("path", { class: "nip" });
  pulls = [s("path", { class: "pull" }), s("path", { class: "pull" })];
  ways = [s("path", { class: "way" }), s("path", { class: "way" })];
  texts = [s("text", { class: "t1" }), s("text", { class: "t1" })];
  nipTexts = [s("text", { class: "tn" }), s("text", { class: "tn" })];
  duty = s("text", { class: "duty", x: 0, y: 22 });
  peak = s("circle", { r: 3.2, class: "peak" });
  hand = s("path", { class: "cursor" });
  phi = 0;
  half = 0;
  belted = 105; // outside of the belt
  /** @type {Strand[]} */
  strands = [];

  /** @param {HTMLElement} box */
  constructor(box) {
    const end = `url(#${this.id}a)`;
    const turn = "M-18.8 -10.8A22 22 0 0 1 18 -12.6";
    this.svg = s(
      "svg",
      { class: "pulley", role: "img" },
      hatches(this.id),
      arrowHead(`${this.id}a`),
      s("circle", { r: LAG, class: "shell" }),
      s("circle", { r: SHELL, class: "shell in" }),
      [...this.cells, this.zones, this.height, this.belt, this.nips, this.nipTexts],
      s("circle", { r: 8, class: "shell" }),
      s("path", { d: turn, class: "turn", "marker-end": end }),
      [this.duty, this.peak, this.hand, ...this.pulls, ...this.ways, ...this.texts],
    );
    for (const e of [...this.pulls, ...this.ways]) e.setAttribute("marker-end", end);
    put(box, this.svg);
  }
  /** A place at an angle from the entry nip; beyond one turn the arc spirals outwards.
   * @param {number} theta @param {number} r @returns {Point} */
  place(theta, r) {
    const a = this.half - theta;
    const out = r + (this.phi > 2 * Math.PI ? (16 * theta) / (2 * Math.PI) : 0);
    return [out * Math.cos(a), -out * Math.sin(a)];
  }
  /** @param {number} from @param {number} to @param {number} r */
  arc(from, to, r, n = 60) {
    return Array.from({ length: n + 1 }, (_, i) => this.place(from + ((to - from) * i) / n, r));
  }
  /** @param {number} from @param {number} to @param {number} a @param {number} b */
  ring(from, to, a, b, n = 40) {
    return `${poly([...this.arc(from, to, a, n), ...this.arc(from, to, b, n).reverse()])}z`;
  }
  /** @param {PulleyData} d */
  draw(d) {
    if (this.phi !== d.phi) this.frame(d.phi);
    this.colour(d);
    const hatch = (/** @type {string} */ kind) => `url(#${this.id}${kind})`;
    /** @type {[number, number, string][]} */
    const zones = d.outside.map(([a, b]) => [a, b, "out"]);
    if (d.stuck > 0) zones.push([0, d.stuck, "rest"]);
    each(
      this.zones,
      "path",
      zones.map(([a, b, kind]) => ({ d: this.ring(a, b, SHELL, LAG), fill: hatch(kind) })),
    );
    const [cx, cy] = this.place(d.peak, (SHELL + LAG) / 2);
    attr(this.peak, { cx, cy });
    const most = Math.max(d.t1, d.t2);
    [d.t1, d.t2].forEach((t, i) => {
      const { start, out } = this.strands[i];
      attr(this.pulls[i], { d: `M${start}L${add(start, out, 25 + 75 * (t / most))}` });
      say(this.texts[i], [d.text1, d.text2][i]);
    });
    say(this.duty, d.duty);
    attr(this.svg, { "aria-label": d.told });
  }
  /** Colours of the cells and the ring of heights. @param {PulleyData} d */
  colour(d) {
    const n = d.position.length;
    /** @type {Point[]} */
    const inner = [];
    let j = 0;
    for (let i = 0; i < CELLS; i++) {
      const mid = ((i + 0.5) / CELLS) * d.phi;
      while (j < n - 2 && d.position[j + 1] < mid) j++;
      const f = (mid - d.position[j]) / (d.position[j + 1] - d.position[j] || 1);
      const value = d.values[j] + f * (d.values[j + 1] - d.values[j]);
      const v = Math.abs(value) / (d.most || 1);
      attr(this.cells[i], { fill: warm(Math.round(92 * v) / 100) });
      inner.push(this.place(mid, SHELL - 4 - 26 * v));
    }
    this.height.setAttribute(
      "d",
      `${poly([...this.arc(0, d.phi, SHELL - 4), ...inner.reverse()])}z`,
    );
  }
  /** What depends on the wrap angle alone. @param {number} phi */
  frame(phi) {
    this.phi = phi;
    this.half = phi / 2;
    this.cells.forEach((cell, i) => {
      const over = i < CELLS - 1 ? 0.004 : 0; // no seam between cells
      const [a, b] = [(i / CELLS) * phi, ((i + 1) / CELLS) * phi + over];
      cell.setAttribute("d", this.ring(a, b, SHELL, LAG, 2));
    });
    const t = [Math.sin(this.half), Math.cos(this.half)];
    /** @type {Point[]} */
    const outs = [
      [-t[0], -t[1]],
      [-t[0], t[1]],
    ];
    /** @param {number} i @param {number} r */
    const far = (i, r) => add(this.place(i ? phi : 0, r), outs[i], 150);
    const edge = [far(0, LAG), ...this.arc(0, phi, LAG), far(1, LAG)];
    const back = [
      far(1, this.belted),
      ...this.arc(0, phi, this.belted).reverse(),
      far(0, this.belted),
    ];
    this.belt.setAttribute("d", `${poly([...edge, ...back])}z`);
    const ends = [0, phi].map((v) => this.place(v, 1));
    const nips = ends.map(([x, y]) => `M${x * SHELL} ${y * SHELL}L${x * LAG} ${y * LAG}`);
    this.nips.setAttribute("d", nips.join(""));
    /** @type {Point[]} */
    const seen = [
      [-LAG - 6, -LAG - 6],
      [LAG + 6, LAG + 6],
    ];
    this.strands = outs.map((out, i) => this.strand(out, i, seen, far(i, this.belted)));
    this.look(seen);
  }
  /** Arrow and words of one strand of the belt.
   * @param {Point} out @param {number} i @param {Point[]} seen @param {Point} far
   * @returns {Strand} */
  strand(out, i, seen, far) {
    const nip = this.place(i ? this.phi : 0, this.belted);
    /** @type {Point} */
    let aside = [out[1], -out[0]];
    if (aside[0] * nip[0] + aside[1] * nip[1] < 0) aside = [-aside[0], -aside[1]];
    const start = add(add(nip, out, 14), aside, 10);
    const middle = add(add(nip, out, 80), aside, -14);
    /** @type {Point} */
    const run = i ? out : [-out[0], -out[1]];
    this.ways[i].setAttribute("d", `M${add(middle, run, -9)}L${add(middle, run, 9)}`);
    const [x, y] = add(add(start, out, 55), aside, 13);
    const angle = (Math.atan2(out[1], out[0]) * 180) / Math.PI;
    const turn = ((((angle + 90) % 180) + 180) % 180) - 90;
    attr(this.texts[i], { x, y, transform: `rotate(${turn} ${x} ${y})` });
    seen.push(far, add(start, out, 105), add(add(start, out, 55), aside, 22));
    const [nx, ny] = this.place(i ? this.phi : 0, 44);
    attr(this.nipTexts[i], { x: nx, y: ny + 3 });
    this.nipTexts[i].textContent = i ? "exit nip" : "entry nip";
    return { start, out };
  }
  /** @param {Point[]} seen */
  look(seen) {
    const [xs, ys] = [seen.map((v) => v[0]), seen.map((v) => v[1])];
    const [left, top] = [Math.min(...xs), Math.min(...ys)];
    const right = Math.max(...xs);
    const wide = Math.max(right - left, 260);
    const tall = Math.max(...ys) - top;
    const box = [left - 4 - (wide - right + left) / 2, top - 4, wide + 8, tall + 8];
    this.svg.setAttribute("viewBox", box.map(fixed).join(" "));
  }
  /** Show the cursor at an angle from the entry nip. @param {number} theta */
  at(theta) {
    const [a, b] = [this.place(theta, SHELL - 34), this.place(theta, this.belted + 6)];
    attr(this.hand, { d: `M${a}L${b}` });
  }
}

/** @param {string} id */
const arrowHead = (id) => {
  const size = { refX: 8, refY: 5, markerWidth: 6, markerHeight: 6, orient: "auto" };
  const head = s("path", { d: "M0 0L10 5L0 10z", class: "head" });
  return s("defs", {}, s("marker", { id, viewBox: "0 0 10 10", ...size }, head));
};

/**
 * The colour scale of the pulley.
 * @param {HTMLElement} box @param {string} label @param {number} most
 */
export function colourScale(box, label, most) {
  if (!box.firstChild) put(box, emptyScale());
  const texts = box.querySelectorAll("text");
  [0, most / 2, most].forEach((v, i) => {
    say(texts[i], v ? digits(v, 3) : "0");
  });
  say(texts[3], label);
}
function emptyScale() {
  const wide = 260;
  const cells = Array.from({ length: 52 }, (_, i) =>
    s("rect", { x: 4 + i * 4.85, y: 1, width: 5, height: 10, fill: warm((0.92 * (i + 0.5)) / 52) }),
  );
  const texts = [0, 0.5, 1].map((f, i) =>
    s("text", { x: 4 + f * 252, y: 22, class: ["tr", "tx", "ty"][i] }),
  );
  return s(
    "svg",
    { viewBox: `0 0 ${wide} 40`, width: wide, height: 40, "aria-hidden": "true" },
    cells,
    texts,
    s("text", { x: wide / 2, y: 36, class: "al" }),
  );
}
