// Pictures of matched trains: shares over trim, diameter and load, and their map.
import { app } from "../../base/design.js";
import { digits, percent, title, unit } from "../../base/units.js";
import { Plot } from "../../parts/plot.js";
import { scroll } from "../../parts/tables.js";
import { colour } from "../../plots/ramp.js";
import { h } from "../../vendor/preact.js";

/** @import { ChartData } from "../../types.d.ts" */

const COLOURS = ["blue", "orange", "green", "purple", "sky", "black"];
/** @type {Record<string, string>} */
const AXES = {
  speed_trim: "Speed trim of the drive [%]",
  diameter_ratio: "Diameter over nominal diameter [%]",
  load_ratio: "Load over that of the load case [%]",
};
/** What is marked on a curve: its line and its words. @type {Record<string, [string, string?]>} */
const MARKS = {
  operating: ["black", "now"],
  equal: ["green", "equal share"],
  creep_limit: ["purple"],
  unloaded: ["sky", "a drive without load"],
};
/** @param {number} x @param {number} y @param {string} cls @param {string} words */
const text = (x, y, cls, words) => h("text", { x, y, class: cls }, words);

/** @type {{of: any, units: string, data: ChartData[][]}} */
let kept = { of: null, units: "", data: [] };
/** @param {any} m the matching of a train */
export function matchingPlots(m) {
  if (kept.of !== m || kept.units !== app.units)
    kept = { of: m, units: app.units, data: m.curves.map(curveData) };
  const titles = ["Shares [%]", title("exit_creep")];
  const plots = m.curves.flatMap((/** @type {any} */ c, /** @type {number} */ i) =>
    titles.map((name, k) =>
      h(Plot, {
        title: name,
        height: 210,
        xlabel: AXES[c.axis] || c.axis,
        class: "card",
        data: kept.data[i][k],
        key: `${i} ${k}`,
      }),
    ),
  );
  return [h("div", { class: "plots", key: "plots" }, plots), m.map && map(m)];
}
/** @param {any} c @returns {ChartData[]} */
function curveData(c) {
  const x = c.values.map((/** @type {number} */ v) => 100 * v);
  const [u, f] = unit("length");
  /** @param {Record<string, (number | null)[]>} set @param {number} k */
  const lines = (set, k) =>
    Object.entries(set).map(([name, y], j) => ({
      y: y.map((v) => (v == null ? null : v * k)),
      cls: COLOURS[j % COLOURS.length],
      label: name,
    }));
  const seen = new Set();
  const marks = (c.marks || []).map((/** @type {any} */ m) => {
    const [cls, name = m.what.replace(/_/g, " ")] = MARKS[m.what] ?? ["black"];
    const label = seen.has(name) ? "" : name; // one entry of the legend for alike lines
    seen.add(name);
    const at = [100 * m.at, 100 * m.at];
    return { x: at, y: [-1e9, 1e9], free: true, cls: `${cls} thin`, label };
  });
  return [
    { x, lines: [...lines(c.shares, 100), ...marks], ylabel: "share [%]", zero: true },
    { x, lines: lines(c.exit_creep, 1 / f), ylabel: `u [${u}]`, zero: true },
  ];
}
/** So many places of a list, evenly taken. @param {any[]} of @param {number} most */
const some = (of, most) => of.map((_, i) => i).filter((i) => i % Math.ceil(of.length / most) === 0);
const CELL = { wide: 58, tall: 26 };
/** Share of the trimmed drive over trim and load: numbers in the cells, so that colour is not all.
 * @param {any} m */
function map(m) {
  const { x, y, shares } = m.map;
  const name = m.drive in shares ? m.drive : Object.keys(shares)[0];
  /** @type {(number | null)[][]} */
  const grid = shares[name];
  const all = grid.flat().filter((v) => v != null);
  const [lo, hi] = [Math.min(...all), Math.max(...all)];
  const cols = some(x, 12);
  const { wide, tall } = CELL;
  const rows = some(y, 9).map((r, j) => [
    text(62, 17 + tall * j, "ty", percent(y[r], 3)),
    cols.map((k, i) => cell(grid[r][k], i, j, lo, hi)),
  ]);
  const base = tall * rows.length;
  const size = { width: 70 + wide * cols.length, height: 50 + base };
  const told = `Share of ${name}, from ${percent(lo)} to ${percent(hi)}`;
  const picture = h(
    "svg",
    { ...size, role: "img", "aria-label": told },
    rows,
    cols.map((k, i) => text(68 + wide * (i + 0.5), base + 16, "tx", percent(x[k], 5))),
    text(68 + (wide * cols.length) / 2, base + 38, "al", "trim across, load down"),
  );
  return h(
    "figure",
    { class: "card", key: "map" },
    h("figcaption", {}, h("strong", {}, `Share of ${name} [%] over trim and load`)),
    scroll("Map of trim and load", picture),
  );
}
/**
 * @param {number | null} v @param {number} i @param {number} j
 * @param {number} lo @param {number} hi
 */
function cell(v, i, j, lo, hi) {
  const { wide, tall } = CELL;
  const part = v == null ? 0 : (v - lo) / (hi - lo || 1);
  const fill = v == null ? "#ddd" : colour(part);
  return [
    h("rect", { x: 68 + wide * i, y: tall * j, width: wide - 1, height: tall - 1, fill }),
    text(
      68 + wide * (i + 0.5),
      17 + tall * j,
      part > 0.5 ? "tx light" : "tx cell",
      v == null ? "–" : digits(100 * v, 3),
    ),
  ];
}
