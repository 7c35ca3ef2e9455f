// Plots of shear tests: one test as read, friction curves, functions of pressure.
import { app } from "../../base/design.js";
import { show, shown, si, trim, unit } from "../../base/units.js";
import { Plot } from "../../parts/plot.js";
import { ZoomPlot } from "../../parts/zoom_plot.js";
import { colour } from "../../plots/ramp.js";
import { put, s } from "../../plots/svg.js";
import { h } from "../../vendor/preact.js";

/** @import { ChartData } from "../../types.d.ts" */

const COLOURS = ["blue", "orange", "green", "purple", "sky", "black"];
/** Pressures [Pa] at the ends of the ramp. */
const [LIGHT, DARK] = [20e3, 700e3];
/** The colour of a pressure on the ramp of the drawing: light is little.
 * @param {number | string | null | undefined} pressure */
export function shade(pressure) {
  const pa = typeof pressure === "number" ? pressure : si(pressure ?? "", "pressure");
  if (!(pa > 0)) return "var(--track)";
  const part = Math.log(pa / LIGHT) / Math.log(DARK / LIGHT);
  return colour(part);
}

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

/** @param {{travel: number[], force: number[]}} preview @param {string} name of its file */
export function asRead(preview, name) {
  const [[lu, lf], [fu, ff]] = [unit("length"), unit("force")];
  const data = once(preview, "", () => ({
    x: preview.travel.map((v) => v / lf),
    lines: [{ y: preview.force.map((v) => v / ff), cls: "blue", label: "force" }],
    ylabel: `F [${fu}]`,
    zero: true,
  }));
  const title = `As read: ${name}`;
  return h(Plot, { title, height: 300, xlabel: `Travel [${lu}]`, data, key: name + app.units });
}
/** A curve from where it slips. @param {Curve} v @param {number[]} y */
function sliding(v, y) {
  const [, lf] = unit("length");
  const from = v.slip.findIndex((x) => x >= 0);
  return { x: v.slip.slice(from).map((x) => x / lf), y: y.slice(from) };
}
/** Friction over slip of every test of a condition, coloured by pressure; the one that is chosen
 * dark, with what was fitted. @param {any} c @param {string | null} chosen the file */
export function overSlipOf(c, chosen) {
  const [lu, lf] = unit("length");
  const [pu, pf] = unit("pressure");
  const data = once(c, `slip ${chosen}`, () => {
    const own = c.curves.find((/** @type {any} */ v) => v.file === chosen);
    const sorted = [...c.curves].sort((a, b) => a.pressure - b.pressure);
    const lines = sorted.map((v) => ({
      ...sliding(v, v.friction),
      cls: own && v !== own ? "thin faint" : "thin",
      colour: shade(v.pressure),
      pressure: v.pressure / pf,
      free: true,
    }));
    const fitted = own && {
      ...sliding(own, own.fitted),
      cls: "black thin",
      label: "fitted",
      free: true,
    };
    const most = Math.max(...sorted.map((v) => Math.max(...v.slip))) / lf;
    const top = Math.max(...sorted.map((v) => Math.max(...v.friction)));
    const scale = { x: [0, most], y: [0, top], cls: "unseen" }; // noise is not to be under zero
    return {
      x: [0, most],
      xs: [0, most],
      zero: true,
      ylabel: "friction [-]",
      lines: [...lines, ...(fitted ? [fitted] : []), scale],
      told: `friction over slip of ${sorted.length} tests`,
    };
  });
  const title = `Friction over slip, ${c.condition} (${pu})`;
  return h(Tests, {
    title,
    height: 330,
    xlabel: `Slip [${lu}]`,
    data,
    key: `s${c.condition}${app.units}`,
  });
}
/** The law over pressure at two slips, with its band; dots are the tests. @param {any} c */
export function overPressureOf(c) {
  const [pu, pf] = unit("pressure");
  const data = once(c, "law", () => ({
    x: c.at_slips[0].pressure.map((/** @type {number} */ p) => p / pf),
    xs: [0, (1.02 * Math.max(...c.at_slips[0].pressure)) / pf],
    zero: true,
    ylabel: "friction [-]",
    lines: c.at_slips.flatMap((/** @type {any} */ s, /** @type {number} */ i) => {
      const edge = (/** @type {number} */ sign) => ({
        y: s.friction.map(
          (/** @type {number} */ v, /** @type {number} */ k) => v + sign * s.band[k],
        ),
        cls: `${AT_SLIP[i]} hair`,
      });
      return [
        { y: s.friction, cls: AT_SLIP[i], label: `at ${shown("slip", s.slip, 3)}` },
        ...(s.band.some(Boolean) ? [edge(1), edge(-1)] : []),
      ];
    }),
    points: c.at_slips.flatMap((/** @type {any} */ s, /** @type {number} */ i) =>
      s.points.map((/** @type {number[]} */ q) => [q[0] / pf, q[1], AT_SLIP[i]]),
    ),
    pointLabel: "tests; thin: 95 %",
  }));
  const title = `Law over pressure, ${c.condition}`;
  return h(Plot, {
    title,
    height: 250,
    xlabel: `Pressure [${pu}]`,
    data,
    key: `p${c.condition}${app.units}`,
  });
}
/** Pressures nearer to each other than this are set as one. */
const SAME = 0.02;
const AT_SLIP = ["ramp-1", "ramp-3"];
/** A chart of tests: each line in the colour of its pressure, which stands at its end. */
class Tests extends Plot {
  componentDidMount() {
    super.componentDidMount();
    if (this.chart) this.chart.named = ends;
    this.chart?.draw(this.props.data);
  }
}
/** @param {import("../../plots/chart.js").Chart} chart @param {any} data */
function ends(chart, data) {
  chart.paths.forEach((path, i) => {
    path.style.stroke = data.lines[i]?.colour ?? "";
  });
  let free = Number.NEGATIVE_INFINITY;
  const all = data.lines
    .filter((/** @type {any} */ l) => l.pressure)
    .map((/** @type {any} */ l) => ({ y: chart.Y(l.y.at(-1)), of: l.pressure }))
    .sort((/** @type {any} */ a, /** @type {any} */ b) => a.y - b.y);
  /** @type {number[]} */
  const named = [];
  const marks = all.flatMap((/** @type {{y: number, of: number}} */ e) => {
    if (named.some((p) => Math.abs(e.of / p - 1) < SAME)) return [];
    named.push(e.of);
    free = Math.max(e.y + 4, free + 13);
    return [
      s(
        "text",
        { x: chart.wide - 2, y: free, class: "tr", "text-anchor": "end" },
        trim(+e.of.toPrecision(3)),
      ),
    ];
  });
  put(chart.names, marks);
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
    ylabel: slip ? `slip at the peak [${lu}]` : "peak friction [-]",
    lines,
    points: f.points.map((/** @type {any} */ q) => [q.pressure / pf, q[key] / scale]),
    pointLabel: "single tests",
  };
}
