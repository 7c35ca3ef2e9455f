// What a comparison comes to in one picture: creep against cost, a dot for each row.
import { title, trim, unit } from "../../base/units.js";
import { put, roundStep, s, ticks } from "../../plots/svg.js";
import { Component, createRef, h } from "../../vendor/preact.js";

/** @import { Level } from "../../types.d.ts" */
/** @typedef {{name: string, cost: number, creep: number, limit: number, level: Level,
 *   told: string}} Dot */

const [LEFT, RIGHT, TOP, FLOOR, TALL] = [52, 16, 14, 218, 262];
/** Shapes of levels: nothing is told by colour alone. @type {Record<string, string>} */
const SHAPES = {
  OK: "M0 -5A5 5 0 1 1 0 5A5 5 0 1 1 0 -5z",
  ATTENTION: "M0 -6L6 5H-6z",
  FAILS: "M-5 -5L5 5M5 -5L-5 5",
};

/** @type {Record<string, string>} */
const COLOURS = { OK: "f-green", ATTENTION: "pt", FAILS: "hatch-red" };

/** @extends {Component<{dots: Dot[], money: string}>} */
export class Dots extends Component {
  box = createRef();
  wide = 0;
  componentDidMount() {
    this.sized = new ResizeObserver(([e]) => {
      const wide = Math.floor(e.contentRect.width);
      if (!wide || wide === this.wide) return;
      this.wide = wide;
      this.draw();
    });
    this.sized.observe(this.box.current);
  }
  componentDidUpdate() {
    this.draw();
  }
  componentWillUnmount() {
    this.sized?.disconnect();
  }
  draw() {
    if (this.wide) put(this.box.current, ...picture(this.props.dots, this.props.money, this.wide));
  }
  render() {
    return h(
      "figure",
      { class: "card", key: "dots" },
      h("figcaption", {}, h("strong", {}, "Creep against cost")),
      h("div", { ref: this.box }),
    );
  }
}
/** @param {Dot[]} dots @param {string} money @param {number} wide */
function picture(dots, money, wide) {
  const [u, f] = unit("length");
  const limit = dots[0].limit / f;
  const most = 1.12 * Math.max(...dots.map((d) => d.cost));
  const top = 1.12 * Math.max(limit, ...dots.map((d) => Math.abs(d.creep) / f));
  const X = (/** @type {number} */ v) => LEFT + (v / most) * (wide - LEFT - RIGHT);
  const Y = (/** @type {number} */ v) => FLOOR - (v / top) * (FLOOR - TOP);
  const xs = ticks(0, most, roundStep(most, wide < 500 ? 4 : 8));
  const ys = ticks(0, top, roundStep(top, 5));
  const middle = (TOP + FLOOR) / 2;
  const upright = { x: 12, y: middle, class: "al", transform: `rotate(-90 12 ${middle})` };
  const right = wide - RIGHT;
  const told = dots.map((d) => d.told).join("; ");
  const size = { width: wide, height: TALL, viewBox: `0 0 ${wide} ${TALL}` };
  return [
    s(
      "svg",
      { class: "chart", ...size, role: "img", "aria-label": `Creep against cost: ${told}` },
      xs.map((v) => [
        s("path", { d: `M${X(v)} ${TOP}V${FLOOR}`, class: v ? "grid" : "zero" }),
        s("text", { x: X(v), y: FLOOR + 15, class: "tx" }, v.toLocaleString("en")),
      ]),
      ys.map((v) => [
        s("path", { d: `M${LEFT} ${Y(v)}H${right}`, class: v ? "grid" : "zero" }),
        s("text", { x: LEFT - 5, y: Y(v) + 4, class: "ty" }, trim(v)),
      ]),
      s("path", { d: `M${LEFT} ${Y(limit)}H${right}`, class: "limit" }),
      s(
        "text",
        { x: right, y: Y(limit) - 4, class: "ty" },
        `${title("creep_limit").toLowerCase()} ${trim(limit, 3)} ${u}`,
      ),
      dots.map((d) => dot(d, X(d.cost), Y(Math.abs(d.creep) / f), right)),
      s("text", { x: (LEFT + right) / 2, y: TALL - 8, class: "al" }, `Cost over the years${money}`),
      s("text", upright, `${title("exit_creep")} [${u}]`),
    ),
  ];
}
/** @param {Dot} d @param {number} x @param {number} y @param {number} right */
function dot(d, x, y, right) {
  const before = x > right - 150;
  const at = { x: before ? x - 10 : x + 10, y: y + 4, class: before ? "ty" : "tr" };
  const shape = SHAPES[d.level] ?? SHAPES.OK;
  return [
    s("path", { d: shape, class: COLOURS[d.level] ?? "pt", transform: `translate(${x} ${y})` }),
    s("text", at, d.name),
  ];
}
