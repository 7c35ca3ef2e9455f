// A pulley in motion: marks on the belt, a spoke of the drum, stress or creep with its sign.
import { Pulley } from "./pulley.js";
import { attr, fixed, s, warm } from "./svg.js";

/** @import { Point, PulleyData } from "./pulley.js" */

const CELLS = 90;
const SHELL = 80;
const LAG = 100;
const MARKS = 150;

/** A colour from pale to dark blue: what brakes. @param {number} t */
export function cool(t) {
  const v = Math.max(0, Math.min(1, t));
  const [from, to] = [
    [226, 240, 250],
    [8, 48, 107],
  ];
  return `rgb(${from.map((c, k) => Math.round(c + v * (to[k] - c))).join()})`;
}

export class MovingPulley extends Pulley {
  marks = s("path", { class: "belt-marks", "stroke-dasharray": `16 ${MARKS - 16}` });
  spoke = s("path", { class: "spoke", d: `M0 -12V-${SHELL - 36}` });

  /** @param {HTMLElement} box @param {number} radius of the drum [m]
   * @param {number | null} thickness of the belt [m], drawn to scale where it is known */
  constructor(box, radius, thickness) {
    super(box);
    this.scale = LAG / radius;
    if (thickness) this.belted = LAG + this.scale * thickness;
    this.svg.append(this.spoke, this.marks);
    this.peak.remove();
  }
  /** @param {number} phi */
  frame(phi) {
    super.frame(phi);
    const middle = (LAG + this.belted) / 2;
    const [a, b] = [this.place(0, middle), this.place(phi, middle)];
    const way = [
      [-Math.sin(this.half), -Math.cos(this.half)],
      [-Math.sin(this.half), Math.cos(this.half)],
    ];
    const far = (/** @type {Point} */ [x, y], /** @type {number[]} */ [u, v]) =>
      `${fixed(x + 150 * u)} ${fixed(y + 150 * v)}`;
    const arc = this.arc(0, phi, middle).map(([x, y]) => `${fixed(x)} ${fixed(y)}`);
    this.marks.setAttribute("d", `M${far(a, way[0])}L${arc.join("L")}L${far(b, way[1])}`);
  }
  /** Colours of the cells and heights of the ring, by the sign of the values.
   * @param {PulleyData} d */
  colour(d) {
    super.colour(d);
    const n = d.values.length;
    for (let i = 0; i < CELLS; i++) {
      const value = d.values[Math.round(((i + 0.5) / CELLS) * (n - 1))];
      const v = Math.abs(value) / (d.most || 1);
      this.cells[i].setAttribute("fill", value < 0 ? cool(0.92 * v) : warm(0.92 * v));
    }
  }
  /** Move belt and drum. @param {number} travel [m] @param {number} angle [rad] */
  turn(travel, angle) {
    attr(this.marks, { "stroke-dashoffset": fixed(-((travel * this.scale) % MARKS)) });
    attr(this.spoke, { transform: `rotate(${fixed(((angle * 180) / Math.PI) % 360)})` });
  }
}
