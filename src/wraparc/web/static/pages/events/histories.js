// Histories of a run: speed, tensions, torque, shares and creep over time.
import { app } from "../../base/design.js";
import { digits, title, unit } from "../../base/units.js";

/** @import { ChartData, Line } from "../../types.d.ts" */
/** @import { Drum, Played } from "./course.js" */

const COLOURS = ["blue", "orange", "green", "purple", "sky", "black"];

/** @type {{of: any, units: string, drawn: {title: string, data: ChartData}[]}} */
let kept = { of: null, units: "", drawn: [] };
/** The charts of a run, made anew only for another run or other units. @param {Played} run
 * @param {number} rating of the belt for a moment [N]; 0 for none */
export function histories(run, rating) {
  if (kept.of !== run || kept.units !== app.units)
    kept = { of: run, units: app.units, drawn: made(run, rating) };
  return kept.drawn;
}
/** @param {Played} run @param {number} rating */
function made(run, rating) {
  const x = run.time;
  const [[fu, ff], [vu, vf], [xu, xf]] = [unit("force"), unit("speed"), unit("length")];
  const [mu, mf] = unit("torque");
  /** @param {(d: Drum) => (number | null)[]} of @param {number} f @returns {Line[]} */
  const each = (of, f, label = "") =>
    run.drums.map((d, i) => ({
      y: scaled(of(d), f),
      cls: COLOURS[i % COLOURS.length],
      label: `${label}${d.name}`,
    }));
  const first = run.drums[0];
  const ahead = { y: scaled(first.entry_tension, ff), cls: "line grey", label: `T1 ${first.name}` };
  const limit = Math.min(...run.drums.map((d) => d.creep_limit)) / xf;
  const belt = { y: scaled(run.belt_speed, vf), cls: "grey", label: "belt" };
  const speeds = each((d) => d.speed.map((w) => (w * d.diameter) / 2), vf, "surface of ");
  return [
    {
      title: "Speed",
      data: { x, lines: [belt, ...speeds], ylabel: `v [${vu}]`, zero: true },
    },
    {
      title: "Tension",
      data: {
        x,
        lines: [{ ...ahead, cls: "grey" }, ...each((d) => d.exit_tension, ff, "T2 ")],
        ylabel: `T [${fu}]`,
        zero: true,
        limit: rating
          ? { y: rating / ff, label: `rating ${digits(rating / ff)} ${fu}` }
          : undefined,
      },
    },
    {
      title: "Torque",
      data: { x, lines: each((d) => d.torque, mf), ylabel: `M [${mu}]`, zero: true },
    },
    {
      title: "Share",
      data: { x, lines: each((d) => inside(d.share), 0.01), ylabel: "share [%]", zero: true },
    },
    {
      title: "Creep",
      data: {
        x,
        lines: each((d) => d.exit_creep, xf),
        ylabel: `u [${xu}]`,
        zero: true,
        limit: { y: limit, label: title("creep_limit").toLowerCase() },
      },
    },
    {
      title: "Shear",
      data: {
        x,
        lines: each((d) => d.peak_shear, unit("pressure")[1]),
        ylabel: `τ [${unit("pressure")[0]}]`,
        zero: true,
      },
    },
  ];
}
/** @param {(number | null)[]} values @param {number} f */
const scaled = (values, f) => values.map((v) => (v == null ? null : v / f));
/** Shares while the drums hardly pull are no shares. @param {(number | null)[]} shares */
const inside = (shares) => shares.map((v) => (v != null && Math.abs(v) <= 2 ? v : null));
