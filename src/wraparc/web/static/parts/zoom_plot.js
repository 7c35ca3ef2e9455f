// A chart of which a part can be looked at closely: a range drawn with the pointer, or by keys.
import { Chart } from "../plots/chart.js";
import { attr, s } from "../plots/svg.js";
import { Component, createRef, h } from "../vendor/preact.js";

/** @import { ChartData, ChartLook, Line } from "../types.d.ts" */
/** @typedef {[number, number]} Span */

/** Narrowest range, as a part of the whole; a drag shorter than that is a click. */
const LEAST = 0.01;
const HELP = "Draw a range to see it closely; double click to go back. Keys: + − ← → and Esc.";

/** The part of a line inside a range. @param {Line} line @param {number[]} common
 * @param {Span} span @returns {Line} */
function cut(line, common, [from, to]) {
  const xs = line.x || common;
  const inside = xs.map((x, i) => (x >= from && x <= to ? i : -1)).filter((i) => i >= 0);
  return { ...line, x: inside.map((i) => xs[i]), y: inside.map((i) => line.y[i]) };
}
/**
 * What of a chart lies in a range.
 * @param {ChartData} data @param {Span} span @returns {ChartData}
 */
const within = (data, span) => ({
  ...data,
  xs: span,
  lines: data.lines.map((line) => cut(line, data.x, span)),
});

/**
 * @typedef {ChartLook & {data: ChartData}} PlotProps
 * @extends {Component<PlotProps>}
 */
export class ZoomPlot extends Component {
  box = createRef();
  /** @type {Span | null} */
  span = null;
  /** Where the pointer went down, as a part of the range shown. @type {number | null} */
  from = null;
  componentDidMount() {
    const chart = new Chart(this.box.current, this.props);
    this.chart = chart;
    this.shade = s("rect", { class: "selection", y: 0, height: 0, width: 0, x: 0 });
    chart.svg.append(this.shade);
    attr(chart.svg, { tabindex: 0 });
    chart.svg.addEventListener("pointerdown", (e) => this.down(e));
    chart.svg.addEventListener("pointermove", (e) => this.over(e));
    chart.svg.addEventListener("pointerup", (e) => this.up(e));
    chart.svg.addEventListener("pointercancel", () => this.over(null));
    chart.svg.addEventListener("dblclick", () => this.show(null));
    chart.svg.addEventListener("keydown", (e) => this.key(e));
    this.show(null);
  }
  /** @param {PlotProps} next */
  shouldComponentUpdate(next) {
    if (next.data === this.props.data) return false;
    this.span = null;
    this.chart?.draw(next.data);
    return false;
  }
  componentWillUnmount() {
    this.chart?.sized.disconnect();
  }
  /** @returns {Span} */
  whole() {
    const { x, xs } = this.props.data;
    return xs || [x[0], x[x.length - 1]];
  }
  /** Show a range, all of it if there is none. @param {Span | null} span */
  show(span) {
    const [first, last] = this.whole();
    const narrow = span && span[1] - span[0] < 0.999 * (last - first);
    this.span = narrow ? span : null;
    this.chart?.draw(this.span ? within(this.props.data, this.span) : this.props.data);
    this.box.current.dataset.zoomed = String(Boolean(narrow));
  }
  /** Part of the range shown that the pointer is at. @param {PointerEvent} e */
  part(e) {
    const chart = /** @type {Chart} */ (this.chart);
    const from = chart.svg.getBoundingClientRect().left + chart.left;
    const part = (e.clientX - from) / (chart.wide - chart.left - chart.right);
    return Math.max(0, Math.min(1, part));
  }
  /** @param {PointerEvent} e */
  down(e) {
    if (e.button !== 0) return;
    this.from = this.part(e);
    this.chart?.svg.setPointerCapture(e.pointerId);
  }
  /** @param {PointerEvent | null} e */
  over(e) {
    const chart = this.chart;
    if (!chart || !this.shade) return;
    if (!e) this.from = null;
    const ends = e && this.from !== null ? [this.from, this.part(e)].sort((a, b) => a - b) : [0, 0];
    const wide = chart.wide - chart.left - chart.right;
    const [x, width] = [chart.left + ends[0] * wide, (ends[1] - ends[0]) * wide];
    attr(this.shade, { x, width, y: 8, height: chart.floor - 8 });
  }
  /** @param {PointerEvent} e */
  up(e) {
    if (this.from === null) return;
    const ends = [this.from, this.part(e)].sort((a, b) => a - b);
    this.over(null);
    const [a, b] = this.span || this.whole();
    if (ends[1] - ends[0] >= LEAST) this.show([a + ends[0] * (b - a), a + ends[1] * (b - a)]);
  }
  /** @param {KeyboardEvent} e */
  key(e) {
    const [first, last] = this.whole();
    const [a, b] = this.span || [first, last];
    const half = (b - a) / 2;
    /** A range of half a width about a middle, pushed inside the whole.
     * @param {number} middle @param {number} width @returns {Span} */
    const about = (middle, width) => {
      const from = Math.max(first, Math.min(last - 2 * width, middle - width));
      return [from, Math.min(last, from + 2 * width)];
    };
    const middle = a + half;
    const least = (LEAST * (last - first)) / 2;
    /** @type {Record<string, () => Span | null>} */
    const does = {
      "+": () => about(middle, Math.max(half / 2, least)),
      "=": () => about(middle, Math.max(half / 2, least)),
      "-": () => about(middle, Math.min(half * 2, (last - first) / 2)),
      ArrowLeft: () => about(middle - half / 2, half),
      ArrowRight: () => about(middle + half / 2, half),
      Escape: () => null,
    };
    if (!does[e.key] || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    this.show(does[e.key]());
  }
  render() {
    return h(
      "div",
      { class: "zoom" },
      h("figure", { ref: this.box }),
      h("p", { class: "help" }, HELP),
    );
  }
}
