// The belt as it runs over the drums of a train: true wrap angles, the tension of every span
// written at it and shown by the width of the line, the shear on the lagging, the drum that slips.
import { percent, show, shown } from "../../base/units.js";
import { levelClass } from "../../parts/answers.js";
import { colour } from "../../plots/ramp.js";
import { along, arcOf, laid, placed as at } from "../../plots/laid.js";
import { follow } from "../../plots/stage.js";
import { fresh } from "../../plots/svg.js";
import { h } from "../../vendor/preact.js";

/** @import { Laid, Point } from "../../plots/laid.js" */
/** @typedef {Laid<any>} Drum */

let R = 0;
const PIECES = 24; // of a wrap, each as wide as its tension
const { PI, cos, sin } = Math;
const LINE = { stroke: "var(--belt)", fill: "none" };

/**
 * What is known of an arc: the limit of its creep and how it is kept, its shear along the wrap.
 * @typedef {{limit: number, level: any, position?: number[], shear?: number[]}} Arc
 */
/** @param {any} c a load case @param {Map<string, Arc>} arcs by pulley
 * @param {number} most of the shear */
export function chain(c, arcs, most) {
  const { r, drums, come, gone, box } = laid(/** @type {any[]} */ (c.drives));
  R = r;
  const [first, last] = [drums[0], drums[drums.length - 1]];
  const all = c.drives.flatMap((/** @type {any} */ m) => [m.entry_tension, m.exit_tension]);
  const full = Math.max(...all.filter(Number.isFinite), 1);
  const wide = (/** @type {number} */ t) => (Number.isFinite(t) ? 3 + (9 * t) / full : 3);
  const id = fresh("belt");
  const runs = drums.some((d, i) => drums[i + 1] && changes(d.m, drums[i + 1].m));
  const both = new Set(drums.map((d) => d.m.side)).size > 1; // sides of the belt
  const told = drums
    .map((d) => `${d.m.pulley}: ${words(d.m)}${both ? sideOf(d.m) : ""}`)
    .join("; ");
  return h(
    "svg",
    {
      ...size(box),
      class: `chart chain ${drums.length > 2 ? "many" : ""}`,
      role: "img",
      "aria-label": `The belt over its pulleys. ${told}`,
    },
    hatch(id),
    drums.map((d) => shell(d, id, arcs.get(d.m.pulley), most)),
    span(come, first.start, wide(first.m.entry_tension), false),
    drums.map((d) => wrapped(d, wide)),
    drums.slice(1).map((d, i) => between(drums[i], d, wide)),
    span(last.end, gone, wide(last.m.exit_tension), false),
    text([come[0], -15], "tr", `${runs ? "" : "carrying strand "}${force(first.m.entry_tension)}`),
    label(gone, last, [...(runs ? [] : ["return strand"]), force(last.m.exit_tension)]),
    drums.map((d) => named(d, both, arcs.get(d.m.pulley))),
  );
}
/** @param {number} t */
const force = (t) => show(t, "force");
/** @param {any} m */
const slips = (m) => m.status === "breakaway";
/** Whether the tension changes from a drum to the next, over a run of the conveyor.
 * @param {any} a @param {any} b */
const changes = (a, b) => Math.abs(b.entry_tension - a.exit_tension) > 1e-3 * b.entry_tension;
/** @param {any} m */
function words(m) {
  if (slips(m)) return "slips on its whole wrap";
  const creep = shown("exit_creep", m.exit_creep);
  return `share ${percent(m.share)}${m.share < 0 ? ", brakes" : ""}, creep ${creep}`;
}
/** @param {any} m */
const sideOf = (m) => `, ${m.side} side of the belt`;
/** @param {{x: number, y: number, w: number, h: number}} box */
const size = ({ x, y, w, h: tall }) => ({
  viewBox: [x, y, w, tall].map(Math.round).join(" "),
  width: Math.round(w),
  height: Math.round(tall),
});
/** @param {string} id */
const hatch = (id) =>
  h(
    "defs",
    {},
    h(
      "pattern",
      { id, width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
      h("path", { d: "M0 0V6", class: "hatch-red" }),
    ),
  );
/** A drum, the lagging under the belt coloured by its shear, hatched where it slips.
 * @param {Drum} d @param {string} id @param {Arc | undefined} arc @param {number} most */
function shell(d, id, arc, most) {
  const { m, centre } = d;
  const [x, y] = centre;
  const [r, thick] = [R - 7, 12];
  const shear = arc?.position && arc.shear && follow(arc.position, arc.shear);
  return h(
    "g",
    { key: `shell ${m.pulley}` },
    h("circle", { cx: x, cy: y, r, class: "steel shell-ring" }),
    slips(m)
      ? h("circle", { cx: x, cy: y, r: R, fill: `url(#${id})` })
      : Array.from({ length: PIECES }, (_, k) =>
          h("path", {
            d: arcOf(d, r, k / PIECES, Math.min(k + 1.05, PIECES) / PIECES),
            class: `wrapped ${m.share < 0 ? "brakes" : ""}`,
            "stroke-width": thick,
            stroke: shear ? colour(Math.abs(shear((k + 0.5) / PIECES)) / (most || 1)) : "var(--q2)",
            key: k,
          }),
        ),
  );
}
/** Belt on a drum, as wide as its tension, from entry to exit. @param {Drum} d
 * @param {(t: number) => number} wide */
function wrapped(d, wide) {
  const { m } = d;
  const [a, b] = [wide(m.entry_tension), wide(m.exit_tension)];
  return Array.from({ length: PIECES }, (_, k) =>
    h("path", {
      ...{ d: arcOf(d, R, k / PIECES, Math.min(k + 1.05, PIECES) / PIECES), ...LINE },
      "stroke-width": (a * (b / a) ** ((k + 0.5) / PIECES)).toFixed(1),
      key: `${m.pulley} ${k}`,
    }),
  );
}
/** A straight piece of belt with an arrow; broken where a run of the conveyor is left out.
 * @param {Point} a @param {Point} b @param {number} width @param {boolean} broken */
function span(a, b, width, broken) {
  const angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
  const long = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const tip = along(a, angle, (broken ? 0.85 : 0.6) * long);
  const wing = (/** @type {number} */ by) => along(tip, angle + by, 8 + width);
  const gap = [0.42, 0.5].map((part) => along(a, angle, part * long));
  return h(
    "g",
    {},
    h("path", { d: `M${at(a)}L${at(b)}`, ...LINE, "stroke-width": width.toFixed(1) }),
    broken &&
      h("path", { d: `M${at(gap[0])}L${at(gap[1])}`, stroke: "var(--paper)", "stroke-width": 14 }),
    broken &&
      gap.map((p) => {
        const ends = [along(p, angle + 1.9, 9), along(p, angle - 1.25, 9)];
        return h("path", { d: `M${at(ends[0])}L${at(ends[1])}`, ...LINE, "stroke-width": 1.5 });
      }),
    h("path", { d: `M${at(wing(2.65))}L${at(tip)}L${at(wing(-2.65))}z`, fill: "var(--belt)" }),
  );
}
/** The belt from a drum to the next, its tension beside it, away from the drums.
 * @param {Drum} a @param {Drum} b @param {(t: number) => number} wide */
function between(a, b, wide) {
  const broken = changes(a.m, b.m);
  const off = b.from; // from the centre of the next drum outwards
  const told = broken
    ? `${force(a.m.exit_tension)} → ${force(b.m.entry_tension)}`
    : force(b.m.entry_tension);
  const width = (wide(a.m.exit_tension) + wide(b.m.entry_tension)) / 2;
  const place = along(along(b.start, a.leaving, 2), off, 10 + width);
  return [span(a.end, b.start, width, broken), beside(place, off, told)];
}
/** Words that begin or end at a place, on the side that an angle points to. @param {Point} p
 * @param {number} angle @param {string} told */
const beside = ([x, y], angle, told) => {
  const c = cos(angle);
  const cls = c > 0.35 ? "tr" : c < -0.35 ? "ty" : "tx";
  const low = sin(angle) > 0.35 ? 9 : sin(angle) < -0.35 ? 0 : 4;
  const halo = { stroke: "var(--paper)", "stroke-width": 3, "paint-order": "stroke" };
  return h("text", { x, y: y + low, class: cls, ...halo }, told);
};
/** What leaves, beyond the tip of its arrow. @param {Point} tip @param {Drum} last
 * @param {string[]} lines */
function label([x, y], { leaving }, lines) {
  const right = cos(leaving) > 0;
  const cls = right ? "tr" : "ty";
  return lines.map((told, k) => text([x + (right ? 8 : -8), y + 4 + 16 * k], cls, told));
}
/** Name, share, creep and wrap angle in a drum, and the side of the belt where they differ.
 * @param {Drum} d @param {boolean} both @param {Arc | undefined} kept */
function named({ m, centre: [x, y] }, both, kept) {
  const name = m.pulley.length > 10 ? `${m.pulley.slice(0, 9)}…` : m.pulley;
  const said = slips(m) ? "slips" : percent(m.share, 3);
  const wrap = m.wrap_angle == null ? "" : `${Math.round((180 * m.wrap_angle) / PI)}°`;
  const does = m.share < 0 && !slips(m) ? "brakes" : "wrap";
  const creep = slips(m) ? "" : shown("exit_creep", Math.abs(m.exit_creep), 3);
  const [head, share, low] = [y - 0.14 * R - 22, y + 0.06 * R - 12, y + 0.39 * R - 13];
  const gap = 0.11 * R + 7;
  return h(
    "g",
    { key: `named ${m.pulley}` },
    h("title", {}, `${m.pulley}: ${words(m)}${both ? sideOf(m) : ""}`),
    both && text([x, head - 14], "tn", `${m.side} side`),
    text([x, head], "tx", name),
    h("text", { x, y: share, class: "t1", style: { fontSize: `${12 + 0.16 * R}px` } }, said),
    h(
      "text",
      { x, y: low, class: `creep ${levelClass(kept?.level || null)}` },
      creep && [h("tspan", {}, "creep "), creep],
    ),
    kept && text([x, low + gap], "tn low", `limit ${show(kept.limit, "length")}`),
    text([x, low + 2 * gap - 2], "tn low", `${wrap} ${does}`),
  );
}
/** @param {Point} p @param {string} cls @param {string} words */
const text = ([x, y], cls, words) => h("text", { x, y, class: cls }, words);
