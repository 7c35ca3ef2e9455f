// Names at the lines of a chart, where they cover neither a line nor each other.
import { each, fixed, say } from "./svg.js";

/** @import { Chart } from "./chart.js" */
/** @import { ChartData } from "../types.d.ts" */
/**
 * A name with the places it may stand at: left, middle or right of them, above or below.
 * @typedef {{text: string, at: [number, number][]}} Named
 * @typedef {{x: number, y: number, wide: number}} Box its left end, the foot of the letters, width
 */

/** Of a letter; letters above their foot; what stays free around [px]. */
const [WIDE, TALL, FREE] = [6, 9, 3];
/** Where along a line a name is tried, the best first. */
const PARTS = [0.72, 0.5, 0.3, 0.86, 0.15, 0.6, 0.4];

/** Put the names of lines, limit and points into a chart.
 * @param {Chart} chart @param {ChartData} data */
export function named(chart, data) {
  const { wide, left, right, floor } = chart;
  const courses = data.lines.map(({ x = data.x, y }) =>
    y.flatMap((v, i) =>
      v == null ? [] : [/** @type {[number, number]} */ ([chart.X(x[i]), chart.Y(v)])],
    ),
  );
  /** @type {Named[]} */
  const all = data.lines.map(({ label = "" }, i) => ({ text: label, at: places(courses[i]) }));
  if (data.limit && chart.sees(data.limit.y)) {
    const y = chart.Y(data.limit.y);
    const course = PARTS.map(
      (p) => /** @type {[number, number]} */ ([left + p * (wide - right - left), y]),
    );
    courses.push(between([left, y], [wide - right, y]));
    all.push({ text: data.limit.label, at: course });
  }
  for (const [x, y] of data.points ?? []) {
    courses.push([[chart.X(x), chart.Y(y)]]);
    all.push({ text: data.pointLabel ?? "", at: [[chart.X(x), chart.Y(y)]] });
  }
  /** @type {Box[]} */
  const put = [];
  const room = { from: left + FREE, to: wide - right - FREE, top: 2, floor: floor - FREE };
  for (const { text, at } of all)
    put.push(text && at.length ? placed(text, at, courses, put, room) : { x: 0, y: 0, wide: 0 });
  each(
    chart.names,
    "text",
    put.map(({ x, y }) => ({ x: fixed(x), y: fixed(y) })),
  );
  for (const [i, { text }] of all.entries()) say(chart.names.children[i], put[i].wide ? text : "");
}
/** @param {[number, number][]} course @returns {[number, number][]} */
const places = (course) =>
  course.length ? PARTS.map((p) => course[Math.round(p * (course.length - 1))]) : [];
/** Points of a straight line, close enough to be seen by a name.
 * @param {[number, number]} a @param {[number, number]} b @returns {[number, number][]} */
const between = (a, b) =>
  Array.from({ length: 120 }, (_, i) => [a[0] + ((b[0] - a[0]) * i) / 119, a[1]]);

/**
 * The first place that is free, else the one that covers least.
 * @param {string} text @param {[number, number][]} at @param {[number, number][][]} courses
 * @param {Box[]} before @param {{from: number, to: number, top: number, floor: number}} room
 * @returns {Box}
 */
function placed(text, at, courses, before, room) {
  const wide = WIDE * text.length;
  let [best, least] = [{ x: room.from, y: TALL + room.top, wide }, Number.POSITIVE_INFINITY];
  for (const [x0, y0] of at)
    for (const [dx, dy] of SIDES) {
      const x = Math.max(room.from, Math.min(room.to - wide, x0 - wide / 2 + dx * (wide / 2 + 4)));
      const y = y0 + dy;
      if (y - TALL < room.top || y > room.floor) continue;
      const covers = covered({ x, y, wide }, courses, before);
      if (covers < least) [best, least] = [{ x, y, wide }, covers];
      if (!covers) return best;
    }
  return best;
}
/** Beside a place: to the left or right in widths, and up or down [px]. */
const SIDES = [
  [0, -5],
  [0, 14],
  [-1, -5],
  [1, 14],
  [-1, -16],
  [1, 25],
];
/** What a name would cover: points of lines, and other names far more.
 * @param {Box} box @param {[number, number][][]} courses @param {Box[]} before */
function covered({ x, y, wide }, courses, before) {
  let n = 0;
  for (const course of courses)
    for (const [u, v] of course)
      if (u > x - 2 && u < x + wide + 2 && v > y - TALL - 2 && v < y + FREE) n++;
  for (const b of before)
    if (b.wide && Math.abs(b.y - y) < TALL + 3 && b.x < x + wide + 4 && x < b.x + b.wide + 4)
      n += 1000;
  return n;
}
