// Key figures of the arc on the screen, and the reading at one place of it.
import {
  digits,
  dimensionOf,
  keyFigures,
  percent,
  show,
  shown,
  symbol,
  title,
  words,
} from "../../base/units.js";
import { levelClass } from "../../parts/answers.js";
import { h } from "../../vendor/preact.js";
import { known, wholeArc } from "./solving.js";

/** @import { Children, Level, QuickAnswer } from "../../types.d.ts" */
/** @typedef {{name: string, value: string, small: string, level?: Level, late?: boolean}} Figure */

/** Figures of an arc that are more than a title and a number, by their names.
 * @type {Record<string, (n: Record<string, number | null>) => Partial<Figure>>} */
const MORE = {
  peak_shear_angle: (n) => ({
    small:
      `${shown("peak_shear_stress", n.peak_shear_stress)} at ` +
      shown("peak_shear_position", n.peak_shear_position),
  }),
  tension_ratio: (n) => ({
    name: "Tension ratio T1/T2",
    small: `Te ${shown("effective_tension", n.effective_tension)}`,
  }),
  mean_friction: () => ({ small: "over the whole wrap" }),
  exit_slip: (n) => ({
    small:
      (n.stuck_arc ?? 0) > 1e-9
        ? `at rest over ${shown("stuck_arc", n.stuck_arc, 3)}`
        : "slides all along",
  }),
  power_loss: (n) =>
    n.power_loss == null
      ? {
          name: "Energy per pass",
          value: shown("frictional_energy", n.frictional_energy, 3),
          small: "power needs the belt speed",
        }
      : {
          name: "Power lost to creep",
          value: shown("power_loss", n.power_loss, 3),
          small: n.efficiency == null ? "" : `efficiency ${percent(n.efficiency)}`,
        },
  creep_limit_margin: ({ creep_limit_capacity: ratio }) => ({
    small: ratio == null || Number.isNaN(ratio) ? "" : `transmits a ratio of ${digits(ratio)}`,
  }),
  equivalent_friction: () => ({ small: "at the creep limit, beside CEMA, DIN" }),
};
/** Figures that only the whole solve has. */
const LATE = ["creep_limit_margin", "equivalent_friction"];
/** The key figures of an arc but for its creep, and what stands with them.
 * @param {QuickAnswer} arc @param {boolean} solved @returns {Figure[]} */
function arcFigures(arc, solved) {
  const quick = Object.entries(arc.numbers).filter(([, value]) => value != null);
  /** @type {Record<string, number | null>} */
  const n = { ...wholeArc()?.numbers, ...Object.fromEntries(quick) };
  const of = (/** @type {string} */ name) => {
    const value = dimensionOf(name) === "number" ? digits(n[name]) : shown(name, n[name]);
    const late = LATE.includes(name) || arc.numbers[name] == null;
    return { name: title(name), value, small: "", late, ...MORE[name]?.(n) };
  };
  const names = keyFigures("tiles").filter((k) => k !== "exit_creep");
  const own = names.filter((k) => solved || LATE.includes(k)).map(of);
  return [...own, ...(solved ? [pressureFigure(arc)] : []), leastFigure(arc)];
}
/** The pressure at both ends. @param {QuickAnswer} arc @returns {Figure} */
function pressureFigure({ profile: { wrap_pressure: p } }) {
  return {
    name: "Wrap pressure",
    value: shown("wrap_pressure", p[0], 3),
    small: `to ${shown("wrap_pressure", p[p.length - 1], 3)}`,
  };
}
/** The minimum T2 of all checks. @param {QuickAnswer} arc @returns {Figure} */
function leastFigure(arc) {
  const idle = arc.numbers.effective_tension === 0;
  const found = known()?.least_tension;
  const least = found
    ? {
        value: words(found.shown),
        small:
          words(found.shown) === "none"
            ? "no T2 passes every check"
            : "every check that T2 helps passes",
        level: found.level,
      }
    : { value: "–", small: idle ? "Te is zero" : "" };
  return { name: "Minimum T2", ...least, late: true };
}
/** The interval of the creep by its fitted law. @param {Record<string, number | null>} n */
function interval(n) {
  const [low, high] = [n.exit_creep_low, n.exit_creep_high];
  if (low == null && high == null) return "";
  const text = (/** @type {number | null} */ v) =>
    v == null ? "gross slip" : shown("exit_creep", v);
  return `; 95 % by the law: ${text(low)} to ${text(high)}`;
}
/** @param {QuickAnswer} arc */
export function figures(arc) {
  const { numbers: n, creep_limit: limit } = arc;
  const solved = arc.status === "solved";
  const share = Math.abs(n.exit_creep) / limit;
  const creep = {
    name: title("exit_creep"),
    value: solved ? shown("exit_creep", n.exit_creep) : "–",
    small: solved
      ? `${percent(share)} of the limit ${show(limit, "length")}${interval(n)}`
      : `gross slip; the limit is ${show(limit, "length")}`,
    level: arc.levels.creep || arc.level,
  };
  const rows = [creep, ...arcFigures(arc, solved)];
  const gauge = h(
    "i",
    { class: "gauge" },
    h("i", { style: { width: `${Math.min(100, share * 50)}%` } }),
  );
  return h(
    "dl",
    { class: "figures" },
    rows.map((r, i) => figure(r, i === 0 && solved && gauge)),
  );
}
/** @param {Figure} f @param {Children} gauge */
const figure = (f, gauge) =>
  h(
    "div",
    { class: `${levelClass(f.level)} ${f.late && !known() ? "late" : ""}`.trim(), key: f.name },
    h("dt", {}, f.name),
    h("dd", {}, h("b", {}, f.value), h("small", {}, f.small), gauge),
  );

const READ = [
  "position",
  "tension",
  "wrap_pressure",
  "friction",
  "friction_used",
  "creep",
  "slip",
].concat(["shear_stress", "shear_angle"]);
/** Every quantity at a place of the arc. @param {QuickAnswer} arc @param {number} part */
export function reading(arc, part) {
  const p = arc.profile;
  const at = part * p.position[p.position.length - 1];
  let j = 0;
  while (j < p.position.length - 2 && p.position[j + 1] < at) j++;
  const f = (at - p.position[j]) / (p.position[j + 1] - p.position[j] || 1);
  /** What is next to nothing beside the largest of its course is what the arithmetic leaves.
   * @param {string} k */
  const value = (k) => {
    const v = p[k][j] + f * (p[k][j + 1] - p[k][j]);
    return Math.abs(v) > 1e-5 * Math.max(...p[k].map(Math.abs)) ? v : 0;
  };
  const rows = READ.map((k) =>
    readOf(k, symbol(k), shown(k, k === "position" ? at : value(k)), title(k)),
  );
  return h(
    "dl",
    { class: "reading" },
    rows,
    readOf("belt", "belt", p.sliding[j] ? "slides" : "at rest", "Sliding or at rest"),
  );
}
/** @param {string} key @param {Children} sign @param {string} text @param {string} meaning */
const readOf = (key, sign, text, meaning) =>
  h("div", { title: meaning, key }, h("dt", {}, sign), h("dd", {}, text));
/** @param {QuickAnswer} arc @param {number} part */
export const placeText = (arc, part) =>
  shown("position", part * arc.profile.position[arc.profile.position.length - 1]);
