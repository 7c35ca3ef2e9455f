// A pulley in motion, as the first screen draws one: marks on the belt, a spoke of the drum, stress
// or creep with its sign.
import { digits } from "../base/units.js";
import { shade } from "./ramp.js";
import { PLACE, Stage } from "./stage.js";
import { attr, fixed, put, s, say } from "./svg.js";

/** @import { StageData } from "./stage.js" */

const { x: CX, y: CY, r: R, cells: CELLS } = PLACE;
const MARKS = 150;
const OUT = 400; // of a strand beyond the picture

/** A colour from pale to dark grey: what brakes. @param {number} t */
export const grey = (t) =>
  `color-mix(in srgb, var(--ink) ${Math.round(85 * Math.max(0, Math.min(1, t)))}%, var(--track))`;

export class MovingStage extends Stage {
  dashes = s("path", { class: "belt-marks", "stroke-dasharray": `16 ${MARKS - 16}` });
  spoke = s("path", { class: "spoke", d: `M${CX} ${CY - 128}V${CY - R + 20}` });

  /** @param {HTMLElement} box @param {number} radius of the drum [m] */
  constructor(box, radius) {
    super(
      box,
      () => {},
      () => {},
    );
    this.scale = R / radius;
    attr(this.svg, { role: "img" });
    for (const knob of Object.values(this.knobs)) knob.remove(); // nothing is dragged here
    this.svg.append(this.spoke, this.dashes);
  }
  /** @param {StageData} d */
  draw(d) {
    super.draw(d);
    const top = CY - R - this.thick(d.t1) / 2;
    const middle = R + this.thick((d.t1 + d.t2) / 2) / 2;
    const arc = Array.from({ length: 41 }, (_, k) => {
      const a = (k / 40) * d.phi;
      return `${fixed(CX + middle * Math.sin(a))} ${fixed(CY - middle * Math.cos(a))}`;
    });
    const { x, y, dx, dy, straight } = this.exit();
    const ends = straight ? [x + dx * straight, y + dy * straight] : [-OUT, y];
    const run = `M${-OUT} ${fixed(top)}L${arc.join("L")}L${ends.map(fixed).join(" ")}`;
    attr(this.dashes, { d: run });
  }
  /** What acts the other way is grey. @param {StageData} d */
  ring(d) {
    super.ring(d);
    const n = d.values.length - 1;
    for (let i = 0; i < CELLS; i++) {
      const value = d.values[Math.round(((i + 0.5) / CELLS) * n)];
      if (value < 0) attr(this.cells[i], { stroke: grey(-value / (d.most || 1)) });
    }
  }
  /** Move belt and drum. @param {number} travel [m] @param {number} angle [rad] */
  turn(travel, angle) {
    attr(this.dashes, { "stroke-dashoffset": fixed(-((travel * this.scale) % MARKS)) });
    const degrees = fixed(((angle * 180) / Math.PI) % 360);
    attr(this.spoke, { transform: `rotate(${degrees} ${CX} ${CY})` });
  }
}

/**
 * The colour scale of the pulleys; it ends at the limit, if there is one.
 * @param {HTMLElement} box @param {string} label @param {number} most @param {number} limit
 */
export function colourScale(box, label, most, limit) {
  if (!box.firstChild) put(box, emptyScale());
  const svg = /** @type {SVGElement} */ (box.firstChild);
  svg.querySelectorAll("rect").forEach((cell, i) => {
    attr(cell, { fill: shade(((i + 0.5) / SHADES) * most, most, limit) });
  });
  const texts = svg.querySelectorAll("text");
  const middle = limit > 0 && limit < most ? limit : most / 2;
  [0, middle, most].forEach((v, i) => {
    say(texts[i], v ? digits(v, 3) : "0");
  });
  // not on the words at either end
  attr(texts[1], { x: Math.min(206, Math.max(44, 4 + (252 * middle) / (most || 1))) });
  say(texts[3], label);
}
const SHADES = 52;
function emptyScale() {
  const wide = 260;
  const cells = Array.from({ length: SHADES }, (_, i) =>
    s("rect", { x: 4 + i * 4.85, y: 1, width: 5, height: 10 }),
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
