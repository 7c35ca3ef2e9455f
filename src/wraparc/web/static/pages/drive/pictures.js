// The pictures of one arc: four plots along the wrap.
import { show, shown, unit } from "../../base/units.js";
import { Chart } from "../../plots/chart.js";
import { named } from "../../plots/named.js";
import { whole, wholeArc } from "./solving.js";

/** @import { ChartData, Line, QuickAnswer } from "../../types.d.ts" */

const TITLES = ["Belt tension", "Friction", "Creep and slip", "Lagging shear"];
/** The wrap angle; as the march adds it up it differs in the last digits from step to step.
 * @param {QuickAnswer["profile"]} profile */
const wrapOf = ({ position }) => +position[position.length - 1].toPrecision(10);
const TALL = 128; // of one plot [px]
/** @param {number} v */
const degrees = (v) => (v * 180) / Math.PI;

/**
 * What is drawn beside the arc: the paper's integration if it is chosen, and a pinned arc.
 * @typedef {{name: string, numbers: QuickAnswer["numbers"],
 *   profile: QuickAnswer["profile"]}} Pinned
 */
export const alongside = { march: false, pinned: /** @type {Pinned | null} */ (null), turn: 0 };

/** What the plots of one arc need: the answer, its lines in the units looked at. */
class Scene {
  /** @param {QuickAnswer} arc */
  constructor(arc) {
    this.arc = arc;
    this.n = arc.numbers;
    this.p = arc.profile;
    this.x = this.p.position.map(degrees);
    const march = marched();
    /** @type {[Record<string, any>, string, string][]} */
    this.others = march ? [[march.profile, "paper", "paper's integration"]] : [];
    if (alongside.pinned) this.others.push([alongside.pinned.profile, "ghost", "pinned"]);
    this.side = this.n.entry_tension >= this.n.exit_tension ? 1 : -1;
  }
  /** @param {string} name @param {string} cls @param {string} label @param {number} [f]
   * @param {boolean} [size] @returns {Line} */
  line(name, cls, label, f = 1, size) {
    return { y: scaled(this.p[name], f, size), cls, label };
  }
  /** What stands beside it. @param {string} name @param {number} [f]
   * @param {boolean} [size] @returns {Line[]} */
  beside(name, f = 1, size) {
    return this.others.map(([profile, cls, label]) => {
      const y = scaled(profile[name], f, size);
      return { x: profile.position.map(degrees), y, cls, label };
    });
  }
  /** @returns {Omit<ChartData, "lines" | "ylabel">} */
  common() {
    /** @type {[number, number, string][]} */
    const zones = this.arc.outside.map(([a, b]) => [degrees(a), degrees(b), "out"]);
    if (this.n.stuck_arc > 1e-9) zones.push([0, degrees(this.n.stuck_arc), "rest"]);
    return { x: this.x, zones, angles: true, xs: [0, degrees(wrapOf(this.p))], zero: true };
  }
}
/** The paper's integration, once it is asked for and solved. */
export function marched() {
  const march = alongside.march && whole() ? wholeArc()?.paper : null;
  return march?.status === "solved" ? march : null;
}
/** @param {(number | null)[]} values @param {number} f @param {boolean} [size] */
const scaled = (values, f, size) =>
  values.map((v) => (v == null ? null : (size ? Math.abs(v) : v) / f));

/** @param {Scene} scene @returns {ChartData} */
function tension(scene) {
  const { n, p } = scene;
  const [[fu, ff], [pu, pf]] = [unit("force"), unit("pressure")];
  const key = (p.wrap_pressure[0] / p.tension[0]) * (ff / pf);
  const range = `from ${shown("tension", n.entry_tension)} to ${shown("tension", n.exit_tension)}`;
  return {
    ...scene.common(),
    ylabel: `T [${fu}]`,
    told: range,
    lines: [scene.line("tension", "blue", "belt tension", ff), ...scene.beside("tension", ff)],
    other: { label: `p [${pu}]`, key, to: (v) => v * key, from: (v) => v / key },
  };
}
/** @param {Scene} scene @returns {ChartData} */
const friction = (scene) => ({
  ...scene.common(),
  ylabel: "friction [-]",
  lines: [
    scene.line("friction", "blue", "available", 1, true),
    scene.line("friction_used", "orange", "used", 1, true),
    ...scene.beside("friction_used", 1, true),
  ],
});
/** @param {Scene} scene @returns {ChartData} */
function creep(scene) {
  const [u, f] = unit("length");
  const limit = scene.arc.creep_limit;
  return {
    ...scene.common(),
    ylabel: `u, x [${u}]`,
    limit: { y: (scene.side * limit) / f, label: `limit ${show(limit, "length")}` },
    lines: [
      scene.line("creep", "blue", "creep", f),
      scene.line("slip", "orange", "slip", f),
      ...scene.beside("creep", f),
    ],
  };
}
/** @param {Scene} scene @returns {ChartData} */
function shear(scene) {
  const { n, p, side } = scene;
  const [u, f] = unit("pressure");
  const stress = p.shear_stress.map(Math.abs);
  const k = stress.indexOf(Math.max(...stress));
  const G = p.shear_stress[k] / Math.tan(p.shear_angle[k]) / f;
  const angle = {
    label: "γ [deg]",
    key: G,
    to: (/** @type {number} */ v) => degrees(Math.atan(v / G)),
    from: (/** @type {number} */ v) => G * Math.tan((v * Math.PI) / 180),
  };
  return {
    ...scene.common(),
    ylabel: `τ [${u}]`,
    points: [[degrees(n.peak_shear_position), (side * n.peak_shear_stress) / f]],
    pointLabel: `peak ${shown("peak_shear_stress", n.peak_shear_stress, 3)}`,
    lines: [
      scene.line("shear_stress", "blue", "shear stress", f),
      ...scene.beside("shear_stress", f),
    ],
    ...(Number.isFinite(G) && G > 0 ? { other: angle } : {}),
  };
}

/** The pictures in their boxes; drawn anew with every answer. */
export class Pictures {
  /** @param {HTMLElement} plots @param {(part: number) => void} onpick */
  constructor(plots, onpick) {
    this.charts = TITLES.map((name, i) => {
      const box = document.createElement("figure");
      plots.append(box);
      const numbered = i === TITLES.length - 1; // one axis for all
      const xlabel = numbered ? "Angle from the entry nip [deg]" : "";
      const height = numbered ? TALL + 30 : TALL;
      const how = { title: name, height, xlabel, onpick, stacked: true, numbered };
      return Object.assign(new Chart(box, how), { named });
    });
  }
  /** @param {QuickAnswer} arc */
  draw(arc) {
    const scene = new Scene(arc);
    // all asked for before any is drawn: the page is laid out once for it
    for (const chart of this.charts) chart.wide ||= chart.box.clientWidth;
    for (const [i, of] of [tension, friction, creep, shear].entries())
      this.charts[i].draw(of(scene));
  }
  /** Show the cursor. @param {number} part of the arc */
  at(part) {
    for (const chart of this.charts) chart.at(part);
  }
}
