// A profile drawn by hand: points dragged or moved by keys, and the same numbers in a table.
import { grasp, gripped, wrong } from "../../base/design.js";
import { noteUndo } from "../../base/removed.js";
import { si, trim, unit } from "../../base/units.js";
import { field, shownFields } from "../../parts/field.js";
import { roundStep, ticks } from "../../plots/svg.js";
import { Component, createRef, h } from "../../vendor/preact.js";
import {
  acrossOf,
  beltWidth,
  edgeText,
  putAcross,
  rowsOf,
  stepOf,
  valueText,
  withRows,
} from "./profile.js";

/** @import { Kind, Rows } from "./profile.js" */
/** @typedef {{pulley: number, kind: Kind}} EditorProps */
/** @typedef {{least: number, most: number}} Ends */

const TALL = 210;
const EDGE = { left: 46, right: 12, top: 12, floor: 176 };
/** Largest value that is shown where nothing is drawn yet [SI]. */
const USUAL = /** @type {Record<string, number>} */ ({ length: 3e-3, force_per_width: 2e4 });

/** @extends {Component<EditorProps>} */
export class Editor extends Component {
  box = createRef();
  svg = createRef();
  wide = 480;
  /** The scale stays while a point is held. @type {Ends | null} */
  held = null;
  dragged = -1;
  /** @type {ResizeObserver | null} */
  sized = null;
  componentDidMount() {
    this.sized = new ResizeObserver(([e]) => {
      const wide = Math.floor(e.contentRect.width);
      if (!wide || wide === this.wide) return;
      this.wide = wide;
      this.forceUpdate();
    });
    this.sized.observe(this.box.current);
    this.known(1);
  }
  componentWillUnmount() {
    this.sized?.disconnect();
    this.known(-1);
  }
  /** What is wrong with the whole profile stands here. @param {number} by */
  known(by) {
    for (const key of this.keys())
      if (by > 0) shownFields.set(key, [this.props.kind.title]);
      else shownFields.delete(key);
  }
  keys() {
    const at = ["pulley", this.props.pulley, "across", this.props.kind.key].join();
    return [at, `${at},rows`];
  }
  get profile() {
    return acrossOf(this.props.pulley)[this.props.kind.key];
  }
  get rows() {
    return rowsOf(this.profile);
  }
  /** @param {Rows} rows */
  put(rows) {
    const { pulley, kind } = this.props;
    putAcross(pulley, kind.key, withRows(this.profile, rows));
  }
  points() {
    const { dimension } = this.props.kind;
    return this.rows.map(([y, v]) => [si(y, "length"), si(v, dimension)]);
  }
  /** @returns {Ends} */
  ends() {
    const { dimension } = this.props.kind;
    const values = this.points()
      .map((p) => p[1])
      .filter(Number.isFinite);
    const most = Math.max(USUAL[dimension], ...values.map((v) => 1.25 * v));
    const least = Math.min(0, ...values.map((v) => 1.25 * v));
    return { least, most };
  }
  /** What lies far beside the belt stands just outside the picture. @param {number} y [m] */
  X(y) {
    const half = 0.5 * beltWidth();
    const near = Math.min(Math.max(y, -2 * half), 2 * half);
    return EDGE.left + ((near + half) / (2 * half)) * (this.wide - EDGE.left - EDGE.right);
  }
  /** @param {number} v */
  Y(v) {
    const { least, most } = this.held || this.ends();
    const part = (v - least) / (most - least);
    const down = this.props.kind.sign === "down" ? part : 1 - part;
    return EDGE.top + down * (EDGE.floor - EDGE.top);
  }
  /** Position and value under the pointer [SI]. @param {PointerEvent | MouseEvent} e */
  under(e) {
    const box = this.svg.current.getBoundingClientRect();
    const { least, most } = this.held || this.ends();
    const half = 0.5 * beltWidth();
    const x = (e.clientX - box.left) * (this.wide / box.width);
    const down = (e.clientY - box.top) * (TALL / box.height);
    const part = (down - EDGE.top) / (EDGE.floor - EDGE.top);
    const up = this.props.kind.sign === "down" ? part : 1 - part;
    const y = ((x - EDGE.left) / (this.wide - EDGE.left - EDGE.right)) * 2 * half - half;
    return [y, least + up * (most - least)];
  }
  /** Move a point, between its neighbours and on the belt. @param {number} k
   * @param {number} y @param {number} v */
  move(k, y, v) {
    const { key, dimension } = this.props.kind;
    const points = this.points();
    const half = 0.5 * beltWidth();
    const room = 0.004 * beltWidth();
    const from = k ? points[k - 1][0] + room : -half;
    const to = k < points.length - 1 ? points[k + 1][0] - room : half;
    const place = Math.min(Math.max(y, from), to);
    const value = key === "worn_depth" || key === "build_up" ? Math.max(v, 0) : v;
    const rows = /** @type {Rows} */ ([...this.rows]);
    rows[k] = [edgeText(place), valueText(value, dimension)];
    this.put(rows);
  }
  /** @param {number} y @param {number} v */
  add(y, v) {
    const { dimension } = this.props.kind;
    const after = this.points().filter((p) => p[0] < y).length;
    const rows = /** @type {Rows} */ ([...this.rows]);
    rows.splice(after, 0, [edgeText(y), valueText(v, dimension)]);
    this.put(rows);
    return after;
  }
  /** Add a point in the widest gap, on the line. */
  addBetween() {
    const half = 0.5 * beltWidth();
    const points = this.points();
    if (!points.length)
      return this.put([
        [edgeText(-half), this.zero()],
        [edgeText(half), this.zero()],
      ]);
    const ends = [[-half, points[0][1]], ...points, [half, points[points.length - 1][1]]];
    let widest = 0;
    for (let k = 1; k < ends.length - 1; k++)
      if (ends[k + 1][0] - ends[k][0] > ends[widest + 1][0] - ends[widest][0]) widest = k;
    const [a, b] = [ends[widest], ends[widest + 1]];
    this.add(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
  }
  zero() {
    return valueText(0, this.props.kind.dimension);
  }
  clear = () => {
    this.put([]);
    noteUndo("All points are removed. ");
  };
  /** A profile has two rows or none. @param {number} k */
  remove(k) {
    const rows = this.rows.filter((_, j) => j !== k);
    this.put(rows.length > 1 ? rows : []);
    if (rows.length === 1) noteUndo("A profile has two points or none: both are removed. ");
  }
  /** @param {number} k @param {KeyboardEvent} e */
  key(k, e) {
    const [y, v] = this.points()[k];
    const up = stepOf(this.props.kind.dimension) * (e.shiftKey ? 10 : 2);
    const along = beltWidth() * (e.shiftKey ? 0.1 : 0.01);
    const higher = this.props.kind.sign === "down" ? -1 : 1;
    /** @type {Record<string, () => void>} */
    const does = {
      ArrowUp: () => this.move(k, y, v + higher * up),
      ArrowDown: () => this.move(k, y, v - higher * up),
      ArrowLeft: () => this.move(k, y - along, v),
      ArrowRight: () => this.move(k, y + along, v),
      Delete: () => this.remove(k),
      Backspace: () => this.remove(k),
    };
    if (!does[e.key]) return;
    e.preventDefault();
    does[e.key]();
  }
  render() {
    const problem = this.keys()
      .map((key) => wrong.at.get(key))
      .find(Boolean);
    return h(
      "div",
      { ref: this.box, class: `editor${problem ? " wrong" : ""}` },
      this.picture(),
      h(
        "p",
        { class: "help" },
        "Drag points, or move the one you are on with the arrow keys; Delete takes it away, a " +
          "double click adds one.",
      ),
      problem && h("p", { class: "error", key: "error" }, problem),
      this.table(),
    );
  }
  picture() {
    const { kind } = this.props;
    const points = this.points().filter((p) => p.every(Number.isFinite));
    const half = 0.5 * beltWidth();
    const line = points.length
      ? [[-half, points[0][1]], ...points, [half, points[points.length - 1][1]]]
      : [
          [-half, 0],
          [half, 0],
        ];
    const d = line.map(
      ([y, v], k) => `${k ? "L" : "M"}${this.X(y).toFixed(1)} ${this.Y(v).toFixed(1)}`,
    );
    const doubled = (/** @type {MouseEvent} */ e) => {
      const [y, v] = this.under(e);
      if (Math.abs(y) > half) return;
      if (!points.length)
        this.put([
          [edgeText(-half), this.zero()],
          [edgeText(half), this.zero()],
        ]);
      this.add(y, v);
    };
    return h(
      "svg",
      {
        class: "chart draw",
        ref: this.svg,
        width: this.wide,
        height: TALL,
        viewBox: `0 0 ${this.wide} ${TALL}`,
        role: "group",
        "aria-label": `${kind.what} over the width, ${points.length} points`,
        onDblClick: doubled,
      },
      this.axes(),
      h("path", { d: d.join(""), class: "line blue" }),
      this.points().map(([y, v], k) => Number.isFinite(y + v) && this.point(y, v, k)),
    );
  }
  axes() {
    const { kind } = this.props;
    const { least, most } = this.held || this.ends();
    const [u, f] = unit(kind.dimension);
    const [lu, lf] = unit("length");
    const half = (0.5 * beltWidth()) / lf;
    const ys = ticks(least / f, most / f, roundStep((most - least) / f, 4));
    const xs = ticks(-half, half, roundStep(2 * half, Math.min(8, this.wide / 70)));
    const middle = (EDGE.top + EDGE.floor) / 2;
    const right = this.wide - EDGE.right;
    return [
      ys.map((v) =>
        h("path", {
          d: `M${EDGE.left} ${this.Y(v * f)}H${right}`,
          class: v === 0 ? "zero" : "grid",
          key: `y${v}`,
        }),
      ),
      xs.map((v) =>
        h("path", {
          d: `M${this.X(v * lf)} ${EDGE.top}V${EDGE.floor}`,
          class: "grid",
          key: `x${v}`,
        }),
      ),
      ys.map((v) =>
        h(
          "text",
          { x: EDGE.left - 5, y: this.Y(v * f) + 3.5, class: "ty", key: `ty${v}` },
          trim(v),
        ),
      ),
      xs.map((v) =>
        h("text", { x: this.X(v * lf), y: EDGE.floor + 14, class: "tx", key: `tx${v}` }, trim(v)),
      ),
      h(
        "text",
        { x: 11, y: middle, class: "al", transform: `rotate(-90 11 ${middle})`, key: "al" },
        `${kind.what} [${u}]`,
      ),
      h(
        "text",
        { x: (EDGE.left + right) / 2, y: TALL - 4, class: "al", key: "ax" },
        `Across the belt, from its middle [${lu}]`,
      ),
    ];
  }
  /** @param {number} y @param {number} v @param {number} k */
  point(y, v, k) {
    const { kind } = this.props;
    const [place, value] = this.rows[k];
    const begin = (/** @type {PointerEvent} */ e) => {
      grasp();
      this.held = this.ends();
      this.dragged = k;
      /** @type {Element} */ (e.currentTarget).setPointerCapture(e.pointerId);
    };
    const drag = (/** @type {PointerEvent} */ e) => {
      if (this.dragged !== k || !gripped()) return;
      const [at, to] = this.under(e);
      this.move(k, at, to);
    };
    const drop = () => {
      this.held = null;
      this.dragged = -1;
      this.forceUpdate();
    };
    return h("circle", {
      key: `p${k}`,
      cx: this.X(y),
      cy: this.Y(v),
      r: 6.5,
      class: "pt grip",
      tabindex: 0, // of SVG, where attributes have small letters
      role: "slider",
      "aria-orientation": "vertical",
      "aria-label": `Point ${k + 1} at ${place}`,
      "aria-valuenow": +(v / unit(kind.dimension)[1]).toPrecision(4),
      "aria-valuetext": value,
      onPointerDown: begin,
      onPointerMove: drag,
      onPointerUp: drop,
      onPointerCancel: drop,
      onKeyDown: (/** @type {KeyboardEvent} */ e) => this.key(k, e),
    });
  }
  table() {
    const rows = this.rows;
    return h(
      "div",
      { class: "rows", role: "group", "aria-label": "Points in numbers" },
      rows.map((_, k) => this.row(k)),
      h(
        "p",
        { class: "inline" },
        h(
          "button",
          { type: "button", id: "add-point", onClick: () => this.addBetween() },
          "Add a point",
        ),
        rows.length > 0 &&
          h("button", { type: "button", id: "clear-points", onClick: this.clear }, "Clear"),
      ),
    );
  }
  /** @param {number} k */
  row(k) {
    const { pulley, kind } = this.props;
    const at = ["pulley", pulley, "across", kind.key];
    if (!Array.isArray(this.profile)) at.push("rows");
    const cell = (
      /** @type {number} */ j,
      /** @type {string} */ title,
      /** @type {string} */ dimension,
    ) =>
      field({
        spec: { key: title, title: `${title} ${k + 1}`, kind: "quantity", dimension },
        path: [...at, k, j],
        page: "x",
        slider: false,
        put: (value) => {
          const rows = /** @type {Rows} */ (this.rows.map((r) => [...r]));
          rows[k][j] = value ?? "";
          this.put(rows);
        },
      });
    return h(
      "div",
      { class: "row", key: `r${k}` },
      cell(0, "Position", "length"),
      cell(1, kind.what, kind.dimension),
      h(
        "button",
        { type: "button", "aria-label": `Remove point ${k + 1}`, onClick: () => this.remove(k) },
        "✕",
      ),
    );
  }
}
