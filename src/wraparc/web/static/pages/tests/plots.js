// Plots of shear tests: one test as read, friction curves, functions of pressure.
import { app } from "../../base/design.js";
import { show, shown, unit } from "../../base/units.js";
import { Plot } from "../../parts/plot.js";
import { ZoomPlot } from "../../parts/zoom_plot.js";
import { h } from "../../vendor/preact.js";

/** @import { ChartData } from "../../types.d.ts" */

const COLOURS = ["blue", "orange", "green", "purple", "sky", "black"];

/** Data of plots, kept as long as what they show and the units are the same. */
const kept = /** @type {WeakMap<object, Map<string, ChartData>>} */ (new WeakMap());
/** @param {object} of @param {string} name @param {() => ChartData} make */
function once(of, name, make) {
  const all = kept.get(of) || new Map();
  kept.set(of, all);
  const key = `${name} ${app.units}`;
  if (!all.has(key)) all.set(key, make());
  return /** @type {ChartData} */ (all.get(key));
}

/** @param {{travel: number[], force: number[]}} preview */
export function asRead(preview) {
  const [[lu, lf], [fu, ff]] = [unit("length"), unit("force")];
  const data = once(preview, "", () => ({
    x: preview.travel.map((v) => v / lf),
    lines: [{ y: preview.force.map((v) => v / ff), cls: "blue", label: "force" }],
    ylabel: `F [${fu}]`,
    zero: true,
  }));
  return h(Plot, { title: "As read", height: 190, xlabel: `Travel [${lu}]`, data, key: app.units });
}
/** @param {any} c a fitted condition */
export function conditionPlots(c) {
  const [[lu], [pu]] = [unit("length"), unit("pressure")];
  const curves = once(c, "curves", () => frictionCurves(c));
  const title = "Friction curves (thin: measured, thick: fitted)";
  const over = (/** @type {string} */ name, /** @type {string} */ key) =>
    h(Plot, {
      title: name,
      height: 210,
      xlabel: `Pressure [${pu}]`,
      key: key + app.units,
      data: once(c, key, () => overPressure(c, key)),
    });
  return [
    h(ZoomPlot, { title, height: 300, xlabel: `Slip [${lu}]`, data: curves, key: app.units }),
    h(ZoomPlot, {
      title: "What the fits leave over (measured less fitted)",
      height: 240,
      xlabel: `Slip [${lu}]`,
      data: once(c, "left over", () => leftOver(c)),
      key: `left${app.units}`,
    }),
    h(
      "div",
      { class: "plots", key: "over" },
      over("Peak friction", "peak_friction"),
      over("Slip at the peak", "peak_slip"),
    ),
  ];
}
/**
 * @typedef {{pressure: number, slip: number[], friction: number[], fitted: number[]}} Curve
 * @typedef {{of: Curve, x: number[], cls: string, label: string}} Drawn
 */
/** The curves with their slip, a colour for each pressure. @param {any} c @returns {Drawn[]} */
function drawn(c) {
  const [, lf] = unit("length");
  /** @type {Curve[]} */
  const curves = [...c.curves].sort((a, b) => a.pressure - b.pressure);
  const group = (/** @type {number} */ p) => Math.round(p / 1e3);
  const pressures = [...new Set(curves.map((v) => group(v.pressure)))];
  const seen = new Set();
  return curves.map((of) => {
    const first = !seen.has(group(of.pressure));
    seen.add(group(of.pressure));
    const cls = COLOURS[pressures.indexOf(group(of.pressure)) % COLOURS.length];
    const label = first ? shown("wrap_pressure", of.pressure, 3) : "";
    return { of, x: of.slip.map((s) => s / lf), cls, label };
  });
}
/** @param {Drawn[]} curves @param {string} ylabel @param {any[]} lines @returns {ChartData} */
function overSlip(curves, ylabel, lines) {
  const most = Math.max(...curves.map((v) => Math.max(...v.x)));
  return { x: [0, most], xs: [0, most], zero: true, ylabel, lines };
}
/** @param {any} c @returns {ChartData} */
function frictionCurves(c) {
  const curves = drawn(c);
  const lines = curves.flatMap(({ of, x, cls, label }) => [
    { x, y: of.friction, cls: `${cls} thin`, free: true },
    { x, y: of.fitted, cls, label },
  ]);
  return overSlip(curves, "friction [-]", lines);
}
/** @param {any} c @returns {ChartData} */
function leftOver(c) {
  const curves = drawn(c);
  const lines = curves.map(({ of, x, cls, label }) => ({
    x,
    y: of.friction.map((v, i) => v - of.fitted[i]),
    cls: `${cls} thin`,
    label,
  }));
  return overSlip(curves, "friction left over [-]", lines);
}
/**
 * Peak friction or its slip over pressure.
 * @param {any} c @param {string} key @returns {ChartData}
 */
function overPressure(c, key) {
  const [[lu, lf], [, pf]] = [unit("length"), unit("pressure")];
  const f = c.pressure_functions;
  const slip = key === "peak_slip";
  const scale = slip ? lf : 1;
  const y = f[key].map((/** @type {number} */ v) => v / scale);
  const lines = [{ y, cls: "blue", label: "fitted over pressure" }];
  if (c.transition) {
    const at = c.transition.pressure;
    const label = `transition ${show(at, "pressure", 3)}`;
    const line = { x: [at / pf, at / pf], y: [0, Math.max(...y)], free: true };
    lines.push({ ...line, cls: "black thin", label });
  }
  return {
    x: f.pressure.map((/** @type {number} */ v) => v / pf),
    xs: [0, Math.max(...f.pressure) / pf],
    zero: true,
    ylabel: slip ? `x_pk [${lu}]` : "mu_pk [-]",
    lines,
    points: f.points.map((/** @type {any} */ q) => [q.pressure / pf, q[key] / scale]),
    pointLabel: "single tests",
  };
}
