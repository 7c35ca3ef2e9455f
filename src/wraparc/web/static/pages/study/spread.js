// How a result is spread over the draws of a study: bars, and its limit as a labelled line.
import { dimensionOf, title, trim, unit, words } from "../../base/units.js";
import { choose } from "../../parts/choose.js";
import { fresh, hatches, put, roundStep, s, ticks } from "../../plots/svg.js";
import { Component, createRef, h } from "../../vendor/preact.js";

/** @import { Text } from "../../types.d.ts" */
/** @typedef {{result: string, where: Text, edges: number[], counts: number[],
 *   limit: number | null, limit_told: Text, at_most: boolean, beyond: number, without: number,
 *   told: Text}} Spread */

const WITHIN = { fill: "var(--sky)", stroke: "var(--blue)" };
const BEYOND = { fill: "none", stroke: "var(--red)" };
const [LEFT, RIGHT, TOP, FLOOR, TALL] = [52, 14, 26, 200, 240];

/** @extends {Component<{spreads: Spread[]}>} */
export class Spreads extends Component {
  box = createRef();
  wide = 0;
  place = 0;
  result = this.props.spreads[0].result;
  id = fresh("s");
  componentDidMount() {
    this.sized = new ResizeObserver(([e]) => {
      const wide = Math.floor(e.contentRect.width);
      if (!wide || wide === this.wide) return;
      this.wide = wide;
      this.draw();
    });
    this.sized.observe(this.box.current);
    if (this.props.spreads.some((one) => one.result === "exit_creep")) this.result = "exit_creep";
    this.forceUpdate();
  }
  componentDidUpdate() {
    this.draw();
  }
  componentWillUnmount() {
    this.sized?.disconnect();
  }
  places() {
    return [...new Set(this.props.spreads.map((one) => words(one.where)))];
  }
  now() {
    const there = this.props.spreads.filter(
      (one) => words(one.where) === this.places()[this.place],
    );
    return there.find((one) => one.result === this.result) ?? there[0];
  }
  draw() {
    if (this.wide) put(this.box.current, picture(this.now(), this.wide, this.id));
  }
  render() {
    const now = this.now();
    const results = [...new Set(this.props.spreads.map((one) => one.result))];
    const places = this.places();
    const pick = (/** @type {string} */ v) => {
      this.result = v;
      this.forceUpdate();
    };
    const go = (/** @type {string} */ v) => {
      this.place = +v;
      this.forceUpdate();
    };
    return h(
      "figure",
      { class: "card spread" },
      h("figcaption", {}, h("strong", {}, "How the draws are spread")),
      h(
        "p",
        { class: "bar" },
        h(
          "label",
          {},
          "Result",
          choose(
            now.result,
            results.map((n) => [n, title(n)]),
            pick,
          ),
        ),
        places.length > 1 &&
          h(
            "label",
            {},
            "Draws",
            choose(
              `${this.place}`,
              places.map((p, i) => [`${i}`, p]),
              go,
            ),
          ),
      ),
      h("p", { class: "told", role: "status" }, words(now.told)),
      h("div", { ref: this.box }),
    );
  }
}

/** @param {Spread} of @param {number} wide @param {string} id */
function picture(of, wide, id) {
  const [u, f] = unit(dimensionOf(of.result));
  const edges = of.edges.map((v) => v / f);
  const [first, last] = [edges[0], edges[edges.length - 1]];
  const marks = limits(of, f).filter((v) => near(v, first, last));
  const lo = Math.min(first, ...marks);
  const hi = Math.max(last, ...marks);
  const pad = 0.03 * (hi - lo);
  const tail = of.without ? 54 : 0; // the bar of draws without a number
  const right = wide - RIGHT - tail;
  const most = Math.max(...of.counts, of.without);
  const X = (/** @type {number} */ v) =>
    LEFT + ((v - lo + pad) / (hi - lo + 2 * pad)) * (right - LEFT);
  const Y = (/** @type {number} */ n) => FLOOR - (n / most) * (FLOOR - TOP);
  const xs = ticks(lo - pad, hi + pad, roundStep(hi - lo, wide < 500 ? 4 : 8));
  const ys = ticks(0, most, Math.max(1, roundStep(most, 4)));
  const bar = (/** @type {number} */ n, /** @type {number} */ i) => {
    const [a, b] = [X(edges[i]), X(edges[i + 1])];
    const out = beyond(of, (of.edges[i] + of.edges[i + 1]) / 2);
    return column(a, b - a, Y(n), out, id);
  };
  const middle = (TOP + FLOOR) / 2;
  const size = { width: wide, height: TALL, viewBox: `0 0 ${wide} ${TALL}` };
  return s(
    "svg",
    {
      class: "chart",
      ...size,
      role: "img",
      "aria-label": `${title(of.result)}: ${words(of.told)}`,
    },
    hatches(id),
    ys.map((v) => [
      s("path", { d: `M${LEFT} ${Y(v)}H${wide - RIGHT}`, class: v ? "grid" : "zero" }),
      s("text", { x: LEFT - 5, y: Y(v) + 4, class: "ty" }, v.toLocaleString("en")),
    ]),
    xs.map((v) => s("text", { x: X(v), y: FLOOR + 15, class: "tx" }, trim(v))),
    of.counts.map(bar),
    of.without > 0 && [
      column(wide - RIGHT - 40, 34, Y(of.without), true, id),
      s("text", { x: wide - RIGHT - 23, y: Y(of.without) - 4, class: "tx" }, `${of.without}`),
      s("text", { x: wide - RIGHT - 23, y: FLOOR + 15, class: "tx" }, "no value"),
    ],
    marks.map((v, i) => mark(of, X(v), (LEFT + right) / 2, i > 0)),
    s("text", { x: (LEFT + right) / 2, y: TALL - 6, class: "al" }, axis(of, u)),
    s("text", { x: 12, y: middle, class: "al", transform: `rotate(-90 12 ${middle})` }, "Draws"),
  );
}
/** @param {Spread} of @param {string} u */
const axis = (of, u) => `${title(of.result)}${u ? ` [${u}]` : ""}`;
/** Limits to draw: an upper one holds for either sense. @param {Spread} of @param {number} f */
function limits(of, f) {
  if (of.limit == null) return [];
  const v = of.limit / f;
  const [first, last] = [of.edges[0], of.edges[of.edges.length - 1]];
  if (!of.at_most || first >= 0) return [v];
  return last > 0 ? [v, -v] : [-v];
}
/** Whether a limit is worth the room that it takes. @param {number} v @param {number} first
 * @param {number} last */
const near = (v, first, last) => v > first - (last - first) && v < last + (last - first);
/** @param {Spread} of @param {number} v */
const beyond = (of, v) => of.limit != null && (of.at_most ? Math.abs(v) > of.limit : v < of.limit);
/** @param {number} x @param {number} width @param {number} y @param {boolean} out
 * @param {string} id */
function column(x, width, y, out, id) {
  const at = { x, width: Math.max(1, width), y, height: FLOOR - y };
  return [
    s("rect", { ...at, ...(out ? BEYOND : WITHIN) }),
    out && s("rect", { ...at, fill: `url(#${id}out)` }),
  ];
}
/** The line of a limit with its words. @param {Spread} of @param {number} x
 * @param {number} middle @param {boolean} again */
function mark(of, x, middle, again) {
  const before = x > middle;
  const at = { x: before ? x - 5 : x + 5, y: TOP - 12, class: before ? "ty" : "tr" };
  return [
    s("path", { d: `M${x} ${TOP - 20}V${FLOOR}`, class: "limit" }),
    !again && s("text", at, words(of.limit_told)),
  ];
}
