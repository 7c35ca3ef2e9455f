// One quantity over the width, on the scale of the face above it.
import { digits, trim, unit } from "../../base/units.js";
import { Sized } from "../../plots/sized.js";
import { fixed, roundStep, ticks } from "../../plots/svg.js";
import { h } from "../../vendor/preact.js";
import { coursesOf, halfOf, SIDES, stripAt } from "./width.js";

/** @typedef {{answer: any, quantity: string, strip: number,
 *   point: (strip: number | null) => void}} OverProps */

const [TOP, FOOT] = [12, 22];

/** @extends {Sized<OverProps>} */
export class OverWidth extends Sized {
  high = 140;
  render() {
    return h("div", { class: "over-width", ref: this.box }, this.picture());
  }
  picture() {
    const { answer: a, quantity, strip, point } = this.props;
    const { position } = a.map;
    const half = halfOf(position);
    const { courses, u, limit } = coursesOf(a, quantity);
    const all = courses.flatMap((c) => c.values);
    const seen = limit && limit.at < 1.6 * Math.max(...all) ? limit : undefined;
    const ends = [Math.min(0, ...all), Math.max(0, ...all, seen?.at ?? 0)];
    const step = roundStep(ends[1] - ends[0] || 1, 3);
    const [lo, hi] = [
      Math.floor(ends[0] / step + 1e-9) * step,
      Math.ceil(ends[1] / step - 1e-9) * step || step,
    ];
    const { left, right } = SIDES;
    const [end, floor] = [this.wide - right, this.high - FOOT];
    const X = (/** @type {number} */ y) => fixed(left + ((y + half) / (2 * half)) * (end - left));
    const Y = (/** @type {number} */ v) => fixed(floor - ((v - lo) / (hi - lo)) * (floor - TOP));
    const course = (/** @type {number[]} */ values) =>
      `M${values.map((v, j) => `${X(position[j])} ${Y(v)}`).join("L")}`;
    const [lu, lf] = unit("length");
    const xs = ticks(-half / lf, half / lf, roundStep((2 * half) / lf, this.wide < 480 ? 4 : 6));
    const told = courses.map((c) => {
      const ends = [Math.min(...c.values), Math.max(...c.values)].map((v) => digits(v, 3));
      return `${c.label} ${ends.join(" to ")} ${u}`;
    });
    const area = `${course(courses[0].values)}V${Y(Math.max(lo, 0))}H${X(position[0])}Z`;
    return h(
      "svg",
      {
        ...{ class: "chart widths", viewBox: `0 0 ${this.wide} ${this.high}`, role: "img" },
        "aria-label": `Over the width: ${told.join(", ")}`,
        onPointerMove: (/** @type {PointerEvent} */ e) => {
          const { left: from } = this.box.current.getBoundingClientRect();
          const part = (e.clientX - from - left) / (end - left);
          point(stripAt(a, (2 * part - 1) * half));
        },
        onPointerLeave: () => point(null),
      },
      ticks(lo, hi, step).map((v) => [
        h("path", { d: `M${left} ${Y(v)}H${end}`, class: v ? "grid" : "zero", key: `g${v}` }),
        h("text", { x: left - 6, y: Y(v) + 4, class: "ty", key: v }, trim(v)),
      ]),
      xs.map((x, k) =>
        h(
          "text",
          {
            x: X(x * lf),
            y: this.high - 4,
            class: k === xs.length - 1 && x * lf > 0.95 * half ? "ty" : "tx",
            key: `x${x}`,
          },
          `${trim(x)}${k === xs.length - 1 ? ` ${lu}` : ""}`,
        ),
      ),
      h("path", { d: area, class: "band" }),
      courses.map((c) =>
        h("path", { d: course(c.values), class: `course ${c.cls}`, key: c.label }),
      ),
      seen && [
        h("path", { d: `M${left} ${Y(seen.at)}H${end}`, class: "band-limit", key: "limit" }),
        h("text", { x: end, y: Y(seen.at) + 14, class: "ty halo", key: "lt" }, seen.label),
      ],
      h("path", {
        d: `M${X(position[strip])} ${TOP}V${floor}`,
        class: "strip-hand",
      }),
      courses.map((c) =>
        h("circle", {
          ...{ cx: X(position[strip]), cy: Y(c.values[strip]), r: 4, class: `course ${c.cls}` },
          key: `dot ${c.label}`,
        }),
      ),
    );
  }
}
/** What the courses are at a strip. @param {any} a @param {string} quantity @param {number} j */
export function readingOf(a, quantity, j) {
  const { courses, u } = coursesOf(a, quantity);
  return [
    courses.map((c) => /** @type {[string, string]} */ ([c.label, digits(c.values[j], 3)])),
    u,
  ];
}
