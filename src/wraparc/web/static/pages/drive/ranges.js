// How far the sliders and handles of a drive go, and where its limits are on them.
import { app, gripped } from "../../base/design.js";
import { si, words } from "../../base/units.js";
import { answer, wholeArc } from "./solving.js";

/** @import { Scale } from "../../parts/field.js" */

const DEG = Math.PI / 180;
const [LEAST_WRAP, MOST_WRAP, MOST_WRAP_OF_SEVERAL] = [150 * DEG, 240 * DEG, 260 * DEG];
/** Of the rating; of the tight side. */
const [BEYOND, LEAST_SLACK, MOST_SLACK] = [1.15, 0.03, 0.95];
/** Standard sizes, and how many each way a slider reaches. */
const REACH = 2;
const IN = 0.0254;
/** @type {Record<string, Record<string, number[]>>} */
const SIZES = {
  diameter: {
    si: [200, 250, 315, 400, 500, 630, 800, 1000, 1250, 1400, 1600, 1800, 2000].map((v) => v / 1e3),
    us: [8, 10, 12, 16, 20, 24, 30, 36, 42, 48, 54, 60, 72].map((v) => v * IN),
  },
  width: {
    si: [300, 400, 500, 650, 800, 1000, 1200, 1400, 1600, 1800, 2000, 2200, 2400, 2600, 2800, 3000]
      .concat([3200])
      .map((v) => v / 1e3),
    us: [18, 24, 30, 36, 42, 48, 54, 60, 72, 84, 96, 108, 120].map((v) => v * IN),
  },
};

/** Rating of the belt [N]; nan if it is not known. */
function rating() {
  const { belt } = app.doc;
  const of = app.catalogue.belts.find((b) => b.name === belt.preset)?.rating;
  return si(belt.rating ?? words(of), "force_per_width") * si(belt.width, "length");
}
/** Tension [N] at the far end of a strand: it stays while a hand moves something. */
let full = 1;
/** @param {number} t1 @param {number} t2 */
export function fullTension(t1, t2) {
  if (gripped()) return full;
  const most = rating() * BEYOND;
  const now = Math.max(t1, t2);
  full = Math.max(Number.isFinite(most) ? most : 1.5 * now, now);
  return full;
}
/** What else is known of limits: the least wrap that keeps that of creep [rad].
 * @type {{wrap: number | null}} */
export const leastWrap = { wrap: null };

/** Limits of the arc that is looked at, by its answer [SI]; null where there is none. */
export function limits() {
  const { quick } = answer;
  const arc = answer.quickDoc === app.doc ? wholeArc() : undefined;
  const n = quick?.numbers;
  if (!arc || !n) return { t1: null, t2: null, wrap: null };
  const { creep_limit_margin: margin, least_exit_tension: least } = arc.numbers;
  const pull = n.effective_tension;
  const drives = pull > 0 && arc.status === "solved";
  return {
    t1: drives && margin > 0 ? n.exit_tension + margin * pull : null,
    t2: drives && Number.isFinite(arc.raise_to ?? least) ? (arc.raise_to ?? least) : null,
    wrap: leastWrap.wrap,
  };
}
/** @param {string} key of a field @returns {Scale | null} */
export function scaleOf(key) {
  if (SIZES[key]) return stepped(key);
  const { quick } = answer;
  const n = quick?.numbers;
  const [t1, t2] = [n?.entry_tension ?? 0, n?.exit_tension ?? 0];
  const of = limits();
  const all = fullTension(t1, t2);
  const keeps = quick?.levels?.creep === "OK";
  /** @param {number} least @param {number} most @param {number | null} mark @param {boolean} up
   * @returns {Scale} */
  const scale = (least, most, mark, up) => ({
    least,
    most,
    mark,
    good: mark !== null ? (up ? [mark, most] : [least, mark]) : keeps ? [least, most] : null,
  });
  if (key === "wrap_angle") {
    const most = app.doc.pulley.length > 1 ? MOST_WRAP_OF_SEVERAL : MOST_WRAP;
    return scale(LEAST_WRAP, most, of.wrap, true);
  }
  if (!t1 || !t2) return null;
  if (key === "entry_tension") return scale(Math.min(t1, t2), all, of.t1, false);
  if (key === "exit_tension")
    return scale(LEAST_SLACK * t1, Math.max(t2, MOST_SLACK * t1), of.t2, true);
  const pull = { effective_tension: 1, power: speed(), torque: radius() }[key];
  if (!pull) return null;
  const mark = of.t1 === null ? null : pull * (of.t1 - t2);
  return scale(0.05 * pull * Math.abs(t1 - t2), pull * (all - t2), mark, false);
}
const speed = () => si(app.doc.belt.speed, "speed");
const radius = () => si(app.doc.pulley[app.pulley].diameter, "length") / 2;
/** @param {string} key */
function stepped(key) {
  const at = key === "width" ? app.doc.belt.width : app.doc.pulley[app.pulley].diameter;
  const now = si(at, "length");
  if (!Number.isFinite(now)) return null;
  const all = SIZES[key][app.units];
  const i = all.filter((v) => v < now * (1 - 1e-6)).length;
  const here = Math.abs((all[i] ?? 0) / now - 1) < 1e-6 ? 1 : 0;
  const stops = all.slice(Math.max(0, i - REACH), i + REACH + here);
  return { least: Math.min(now, ...stops), most: Math.max(now, ...stops), stops };
}
