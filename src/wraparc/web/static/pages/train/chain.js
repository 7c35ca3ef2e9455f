// The belt as it runs over the drums of a train: true wrap angles, the tension of every span
// written at it and shown by the width of the line, the shear on the lagging, the drum that slips.
import { percent, show, shown } from "../../base/units.js";
import { levelClass } from "../../parts/answers.js";
import { colour } from "../../plots/ramp.js";
import { follow } from "../../plots/stage.js";
import { fresh } from "../../plots/svg.js";
import { h } from "../../vendor/preact.js";

/** @typedef {[number, number]} Point */
/** @typedef {{m: any, centre: Point, from: number, sense: number, start: Point, end: Point,
 *   leaving: number}} Drum from: angle of the entry nip about the centre */

/** Radius of a drum, in pixels where it is shown as large as it may be, by how many there are. */
const RADII = [100, 100, 100, 76, 60];
let R = RADII[0];
const PIECES = 24; // of a wrap, each as wide as its tension
const { PI, cos, sin } = Math;
const LINE = { stroke: "var(--ink)", fill: "none" };

/** @param {Point} p @param {number} angle @param {number} by @returns {Point} */
const along = ([x, y], angle, by) => [x + by * cos(angle), y + by * sin(angle)];
/** @param {Point} p */
const at = ([x, y]) => `${Math.round(10 * x) / 10} ${Math.round(10 * y) / 10}`;
/** How long a span may be at a wrap, so that it does not cross the span before.
 * @param {number} wrap */
const room = (wrap) => (wrap > PI ? (0.55 * R) / Math.tan((wrap - PI) / 2) : 2.2 * R);

/** Drums one after the other, turned in alternate senses; y goes down. @param {any[]} drives
 * @returns {Drum[]} */
function layOut(drives) {
  /** @type {Point} */
  let start = [0, 0];
  let heading = 0;
  return drives.map((m, i) => {
    const wrap = m.wrap_angle ?? PI;
    const sense = i % 2 ? -1 : 1;
    const inward = heading + (sense * PI) / 2;
    const centre = along(start, inward, R);
    const from = inward + PI;
    const end = along(centre, from + sense * wrap, R);
    const drum = { m, centre, from, sense, start, end, leaving: heading + sense * wrap };
    const next = drives[i + 1]?.wrap_angle ?? PI;
    heading = drum.leaving;
    start = along(end, heading, Math.max(0.8 * R, Math.min(2.2 * R, room(wrap), room(next))));
    return drum;
  });
}
/**
 * What is known of an arc: the limit of its creep and how it is kept, its shear along the wrap.
 * @typedef {{limit: number, level: any, position?: number[], shear?: number[]}} Arc
 */
/** @param {any} c a load case @param {Map<string, Arc>} arcs by pulley
 * @param {number} most of the shear */
export function chain(c, arcs, most) {
  R = RADII[c.drives.length] ?? 50;
  const drums = layOut(c.drives);
  const [first, last] = [drums[0], drums[drums.length - 1]];
  const all = c.drives.flatMap((/** @type {any} */ m) => [m.entry_tension, m.exit_tension]);
  const full = Math.max(...all.filter(Number.isFinite), 1);
  const wide = (/** @type {number} */ t) => (Number.isFinite(t) ? 3 + (9 * t) / full : 3);
  const left = Math.min(...drums.map((d) => d.centre[0] - R), -1.9 * R) - 8;
  /** @type {Point} */
  const come = [left, 0];
  const gone = along(last.end, last.leaving, 1.9 * R);
  const box = around([
    ...drums.flatMap(corners),
    come,
    along(gone, cos(last.leaving) > 0 ? 0 : PI, 84),
  ]);
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
    text([left, -15], "tr", `${runs ? "" : "carrying strand "}${force(first.m.entry_tension)}`),
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
/** @param {Drum} d @returns {Point[]} */
const corners = ({ centre: [x, y] }) => [
  [x - R, y - R],
  [x + R, y + R],
];
/** @param {Point[]} points */
function around(points) {
  const [xs, ys] = [points.map((p) => p[0]), points.map((p) => p[1])];
  const [x, y] = [Math.min(...xs) - 10, Math.min(...ys) - 28];
  return { x, y, w: Math.max(...xs) + 14 - x, h: Math.max(...ys) + 24 - y };
}
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
function shell({ m, centre, from, sense }, id, arc, most) {
  const [x, y] = centre;
  const [r, thick] = [R - 7, 12];
  const wrap = m.wrap_angle ?? PI;
  const shear = arc?.position && arc.shear && follow(arc.position, arc.shear);
  return h(
    "g",
    { key: `shell ${m.pulley}` },
    h("circle", { cx: x, cy: y, r: r - 1, class: "steel" }),
    slips(m)
      ? h("circle", { cx: x, cy: y, r: R, fill: `url(#${id})` })
      : Array.from({ length: PIECES }, (_, k) => {
          const ends = [k, Math.min(k + 1.05, PIECES)].map((n) =>
            at(along(centre, from + (sense * wrap * n) / PIECES, r)),
          );
          return h("path", {
            d: `M${ends[0]}A${r} ${r} 0 0 ${sense > 0 ? 1 : 0} ${ends[1]}`,
            class: `wrapped ${m.share < 0 ? "brakes" : ""}`,
            "stroke-width": thick,
            stroke: shear ? colour(Math.abs(shear((k + 0.5) / PIECES)) / (most || 1)) : "var(--q2)",
            key: k,
          });
        }),
  );
}
/** Belt on a drum, as wide as its tension, from entry to exit. @param {Drum} d
 * @param {(t: number) => number} wide */
function wrapped({ m, centre, from, sense }, wide) {
  const wrap = m.wrap_angle ?? PI;
  const [a, b] = [wide(m.entry_tension), wide(m.exit_tension)];
  return Array.from({ length: PIECES }, (_, k) => {
    const ends = [k, k + 1.05].map((n) =>
      along(centre, from + (sense * wrap * Math.min(n, PIECES)) / PIECES, R),
    );
    const part = (k + 0.5) / PIECES;
    return h("path", {
      ...{ d: `M${at(ends[0])}A${R} ${R} 0 0 ${sense > 0 ? 1 : 0} ${at(ends[1])}`, ...LINE },
      "stroke-width": (a * (b / a) ** part).toFixed(1),
      key: `${m.pulley} ${k}`,
    });
  });
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
    h("path", { d: `M${at(wing(2.65))}L${at(tip)}L${at(wing(-2.65))}z`, fill: "var(--ink)" }),
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
