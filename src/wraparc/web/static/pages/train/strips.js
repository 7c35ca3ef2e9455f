// How the load of a train is divided, and the trim of one of its drives: a bar with a divider
// between neighbours, whose parts always sum to the whole, and a strip with the limits of the trim.
import { app, change, edit, grasp, gripped, release, set } from "../../base/design.js";
import { percent, shown, split } from "../../base/units.js";
import { h } from "../../vendor/preact.js";

/** @import { Path } from "../../types.d.ts" */

const FINE = 0.001; // of the load
/** Part of the load that a text gives; nan for a power. @param {any} text */
function partOf(text) {
  const read = split(text);
  if (!read) return Number.NaN;
  return read.unit === "%" ? read.number / 100 : read.unit ? Number.NaN : read.number;
}
/** Shares as the design gives them; none where it gives powers, speeds or motors.
 * @returns {number[]} */
function given() {
  /** @type {number[]} */
  const parts = (app.doc.train?.share ?? []).map(partOf);
  return parts.length === app.doc.pulley.length && parts.every((v) => v >= 0) ? parts : [];
}
/** Move the divider behind a drive: what it gives, its neighbour takes.
 * @param {number[]} parts @param {number} i @param {number} to sum of the parts up to it */
function divide(parts, i, to) {
  const sum = (/** @type {number} */ n) => parts.slice(0, n).reduce((a, v) => a + v, 0);
  const [low, high] = [sum(i), sum(i + 2)];
  const at = Math.min(high, Math.max(low, Math.round(to / FINE) * FINE));
  const next = parts.map((v, k) => (k === i ? at - low : k === i + 1 ? high - at : v));
  const texts = next.map((v) => `${+(100 * v).toFixed(3)} %`);
  change(set(app.doc, ["train", "share"], texts), "share");
}
/** Type the share of a drive: its neighbour takes the rest, where there is one.
 * @param {number} i @param {any} text */
export function typeShare(i, text) {
  /** @type {any[]} */
  const next = Array.from(app.doc.train?.share ?? []);
  const k = i + 1 < next.length ? i + 1 : i - 1;
  next[i] = text;
  const others = next.map((v, j) => (j === k ? 0 : partOf(v)));
  const rest = 1 - others.reduce((a, v) => a + v, 0);
  if (rest >= 0 && rest <= 1) next[k] = `${+(100 * rest).toFixed(3)} %`;
  change(set(app.doc, ["train", "share"], next), `share,${i}`);
}
/** Keys of a slider, as of the handles of the first screen. @param {number} step
 * @param {(by: number) => void} by */
const keys = (step, by) => (/** @type {KeyboardEvent} */ e) => {
  const sign = {
    ArrowRight: 1,
    ArrowUp: 1,
    PageUp: 10,
    ArrowLeft: -1,
    ArrowDown: -1,
    PageDown: -10,
  };
  const steps = sign[/** @type {keyof typeof sign} */ (e.key)];
  if (!steps) return;
  e.preventDefault();
  by(steps * step * (e.shiftKey ? 0.1 : 1));
};
/** A handle on a strip. @param {string} label @param {string} text @param {number} place [0, 1]
 * @param {[number, number, number]} range least, now, most @param {number} step
 * @param {(v: number) => void} put */
function knob(label, text, place, [least, now, most], step, put) {
  const at = (/** @type {PointerEvent} */ e) => {
    const track = /** @type {HTMLElement} */ (e.currentTarget).parentElement;
    const { left, width } = /** @type {HTMLElement} */ (track).getBoundingClientRect();
    put(least + ((most - least) * (e.clientX - left)) / width);
  };
  return h("span", {
    ...{ class: "knob", role: "slider", tabIndex: 0, key: label, style: { left: pct(place) } },
    ...{ "aria-label": label, "aria-valuemin": least, "aria-valuemax": most },
    ...{ "aria-valuenow": now, "aria-valuetext": text },
    onKeyDown: keys(step, (by) => put(now + by)),
    onPointerDown: (/** @type {any} */ e) => {
      e.currentTarget.setPointerCapture(e.pointerId);
      grasp();
    },
    onPointerMove: (/** @type {any} */ e) =>
      gripped() && e.currentTarget.hasPointerCapture(e.pointerId) && at(e),
    onPointerUp: () => release(),
  });
}
/** @param {number} v */
const pct = (v) => `${100 * Math.min(1, Math.max(0, v))}%`;

/** The load, a part for each drive. @param {any} c the load case */
export function shareBar(c) {
  const own = given();
  const parts = own.length ? own : c.drives.map((/** @type {any} */ m) => Math.max(0, m.share));
  const whole = parts.reduce((/** @type {number} */ a, /** @type {number} */ v) => a + v, 0) || 1;
  let end = 0;
  const ends = parts.map((/** @type {number} */ v) => (end += v / whole));
  const name = (/** @type {number} */ i) => c.drives[i]?.pulley ?? "";
  const told = parts.map(
    (/** @type {number} */ v, /** @type {number} */ i) => `${name(i)} ${percent(v)}`,
  );
  const handles = own.slice(1).map((_, i) => {
    const range = /** @type {[number, number, number]} */ ([0, ends[i], 1]);
    const put = (/** @type {number} */ v) => divide(given(), i, v);
    return knob(
      `Load of ${name(i)} and ${name(i + 1)}`,
      told.join(", "),
      ends[i],
      range,
      0.01,
      put,
    );
  });
  return h(
    "div",
    { class: "strip", key: "share" },
    h("span", { class: "strip-name" }, "Load"),
    h(
      "div",
      { class: "strip-track parts" },
      parts.map((/** @type {number} */ v, /** @type {number} */ i) =>
        h("i", { key: name(i), style: { width: pct(v / whole) } }, told[i]),
      ),
      handles,
    ),
  );
}

const ROOM = 2e-4; // of trim beyond what is marked
const NEAR = 0.05; // of the load: how far a share may be off
/** The trim that the design gives a drive, or that its share comes to; and how it is given.
 * @param {any} m @param {number} i
 * @returns {[number, ((v: number) => void) | null]} */
function trimOf(m, i) {
  const speeds = app.doc.train?.speeds;
  if (Array.isArray(speeds)) {
    const [own, first] = [partOf(speeds[i]), partOf(speeds[0])];
    /** @type {Path} */
    const path = ["train", "speeds", i];
    if (own > 0 && first > 0)
      return [own / first, (v) => edit(path, `${(100 * v * first).toFixed(3)} %`)];
  }
  const parts = given();
  const by = 1e3 * m.share_sensitivity;
  if (parts.length !== 2 || !by) return [m.speed_trim, null];
  const trim = m.speed_trim + (parts[1] - m.share) / by; // to first order
  return [trim, (v) => divide(parts, 0, parts[0] - by * (v - trim))];
}
/**
 * The trim of a drive: where all drives keep their creep limits, where its share is kept.
 * @param {any} c the load case @param {number} i drive
 * @param {number[] | null} keeps trims between which all keep them, where they are found
 * @param {{pressed: boolean, put: () => void} | null} chooser of the drive that is explained
 */
export function trimStrip(c, i, keeps, chooser) {
  const m = c.drives[i];
  if (!i || !(m.speed_trim > 0)) return null;
  const half = m.share_sensitivity ? (NEAR * 1e-3) / Math.abs(m.share_sensitivity) : 0;
  const ends = [m.speed_trim - 2 * half, m.speed_trim + 2 * half, 1, ...(keeps ?? [])];
  const [least, most] = [Math.min(...ends) - ROOM, Math.max(...ends) + ROOM];
  const [trim, put] = trimOf(m, i);
  const at = (/** @type {number} */ v) => (v - least) / (most - least);
  const span = (/** @type {string} */ cls, /** @type {number[]} */ [a, b]) =>
    h("u", { class: cls, key: cls, style: { left: pct(at(a)), width: pct(at(b) - at(a)) } });
  const text = percent(trim, 5);
  const kept = half ? ` (± ${percent(half, 2)} for a share within ${percent(NEAR)})` : "";
  const label = `Trim of ${m.pulley}`;
  const range = /** @type {[number, number, number]} */ ([least, trim, most]);
  const pick = chooser && {
    ...{ type: "button", class: "link", "aria-pressed": chooser.pressed, onClick: chooser.put },
  };
  return h(
    "div",
    { class: "strip", key: label },
    h("span", { class: "strip-name" }, pick ? h("button", pick, label) : label),
    h(
      "div",
      { class: "strip-track" },
      keeps && span("keeps", keeps),
      half > 0 && span("near", [m.speed_trim - half, m.speed_trim + half]),
      h(
        "s",
        { class: at(1) > 0.5 ? "left" : "", style: { left: pct(at(1)) } },
        h("small", {}, "equal speeds"),
      ),
      put
        ? knob(label, text, at(trim), range, 1e-4, put)
        : h("b", { class: "now", style: { left: pct(at(trim)) } }),
    ),
    h("output", {}, h("b", {}, text), kept),
  );
}
/** Why a drive turns as it does, to first order. @param {any} m @returns {[string, string][]} */
export const reasons = (m) =>
  /** @type {[string, number][]} */ ([
    ["belt contracts before it", m.contraction_term],
    ["creep", m.creep_term],
    ["lagging is compressed", m.compression_term],
    ["thickness of the belt", m.thickness_term],
  ])
    .filter(([, v]) => v)
    .map(([name, v]) => [name, `${v > 0 ? "+" : "−"}${percent(Math.abs(v), 3)}`]);
/** What a change does. @param {any} m @returns {[string, string][]} */
export const changes = (m) => {
  const by = Math.abs(m.share_sensitivity ?? 0);
  if (!by) return [];
  return [
    ["0.1 % of trim moves", `${percent(by, 2)} of the load`],
    [`Trim for a share within ${percent(NEAR)}`, `± ${percent((NEAR * 1e-3) / by, 2)}`],
    ["Power lost, all drives", shown("power_loss", m.power_loss, 3)],
  ];
};
