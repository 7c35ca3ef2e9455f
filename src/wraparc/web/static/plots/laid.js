// Pulleys as the belt runs over them: one behind the other, in alternate senses; y goes down.

/** @typedef {[number, number]} Point */
/** @template M @typedef {{m: M, centre: Point, from: number, sense: number, wrap: number,
 *   start: Point, end: Point, leaving: number}} Laid from: angle of the entry nip about the
 *   centre */

const { PI, cos, sin } = Math;
/** Radius of a pulley, in pixels where it is shown as large as it may be, by how many there are. */
const RADII = [100, 100, 100, 76, 60];

/** @param {Point} p @param {number} angle @param {number} by @returns {Point} */
export const along = ([x, y], angle, by) => [x + by * cos(angle), y + by * sin(angle)];
/** @param {Point} p */
export const placed = ([x, y]) => `${Math.round(10 * x) / 10} ${Math.round(10 * y) / 10}`;

/** The pulleys, their radius, where the belt comes from and goes to, and what all of it covers.
 * @template {{wrap_angle?: number | null}} M @param {M[]} drives */
export function laid(drives) {
  const r = RADII[drives.length] ?? 50;
  /** How long a span may be at a wrap, so that it does not cross the span before.
   * @param {number} wrap */
  const room = (wrap) => (wrap > PI ? (0.55 * r) / Math.tan((wrap - PI) / 2) : 2.2 * r);
  /** @type {Point} */
  let start = [0, 0];
  let heading = 0;
  const drums = drives.map((m, i) => {
    const wrap = m.wrap_angle ?? PI;
    const sense = i % 2 ? -1 : 1;
    const inward = heading + (sense * PI) / 2;
    const centre = along(start, inward, r);
    const from = inward + PI;
    const end = along(centre, from + sense * wrap, r);
    const leaving = heading + sense * wrap;
    const drum = { m, centre, from, sense, wrap, start, end, leaving };
    const next = drives[i + 1]?.wrap_angle ?? PI;
    heading = leaving;
    start = along(end, heading, Math.max(0.8 * r, Math.min(2.2 * r, room(wrap), room(next))));
    return /** @type {Laid<M>} */ (drum);
  });
  const last = drums[drums.length - 1];
  const left = Math.min(...drums.map((d) => d.centre[0] - r), -1.9 * r) - 8;
  /** @type {Point} */
  const come = [left, 0];
  const gone = along(last.end, last.leaving, 1.9 * r);
  const box = around([
    ...drums.flatMap(
      ({ centre: [x, y] }) =>
        /** @type {Point[]} */ ([
          [x - r, y - r],
          [x + r, y + r],
        ]),
    ),
    come,
    along(gone, cos(last.leaving) > 0 ? 0 : PI, 84),
  ]);
  return { r, drums, come, gone, box };
}
/** @param {Point[]} points */
function around(points) {
  const [xs, ys] = [points.map((p) => p[0]), points.map((p) => p[1])];
  const [x, y] = [Math.min(...xs) - 10, Math.min(...ys) - 28];
  return { x, y, w: Math.max(...xs) + 14 - x, h: Math.max(...ys) + 24 - y };
}
/** A piece of a wrap, as the commands of a path. @template M @param {Laid<M>} d
 * @param {number} r @param {number} a share of the wrap where it begins
 * @param {number} b and ends */
export function arcOf({ centre, from, sense, wrap }, r, a, b) {
  const [p, q] = [a, b].map((t) => placed(along(centre, from + sense * wrap * t, r)));
  const large = wrap * (b - a) > PI ? 1 : 0;
  return `M${p}A${r} ${r} 0 ${large} ${sense > 0 ? 1 : 0} ${q}`;
}
