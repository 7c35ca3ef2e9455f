// A profile over the width: its points, moved by hand or by keys, and the same numbers in a table.
import { wrong } from "../../base/design.js";
import { noteUndo } from "../../base/removed.js";
import { si, unit } from "../../base/units.js";
import { field, shownFields } from "../../parts/field.js";
import { Component, h } from "../../vendor/preact.js";
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

/** Largest value that is shown where nothing is drawn yet [SI]. */
const USUAL = /** @type {Record<string, number>} */ ({ length: 3e-3, force_per_width: 2e4 });

/** The points of a profile of a pulley. */
export class Points {
  /** @param {number} pulley @param {Kind} kind */
  constructor(pulley, kind) {
    this.props = { pulley, kind };
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
}

/** The table of a profile. @extends {Component<EditorProps>} */
export class Editor extends Component {
  get of() {
    return new Points(this.props.pulley, this.props.kind);
  }
  componentDidMount() {
    this.known(1);
  }
  componentWillUnmount() {
    this.known(-1);
  }
  /** What is wrong with the whole profile stands here. @param {number} by */
  known(by) {
    for (const key of this.of.keys())
      if (by > 0) shownFields.set(key, [this.props.kind.title]);
      else shownFields.delete(key);
  }
  render() {
    const { kind } = this.props;
    const problem = this.of
      .keys()
      .map((key) => wrong.at.get(key))
      .find(Boolean);
    return h(
      "div",
      { class: `editor${problem ? " wrong" : ""}` },
      h(
        "p",
        { class: "heads", "aria-hidden": "true" },
        h("span", {}, `position ${unit("length")[0]}`),
        h("span", {}, `${kind.brief} ${unit(kind.dimension)[0]}`),
      ),
      problem && h("p", { class: "error", key: "error" }, problem),
      this.table(),
    );
  }
  table() {
    const rows = this.of.rows;
    return h(
      "div",
      { class: "rows", role: "group", "aria-label": "Points in numbers" },
      rows.map((_, k) => this.row(k)),
      h(
        "p",
        { class: "inline" },
        h(
          "button",
          { type: "button", id: "add-point", onClick: () => this.of.addBetween() },
          "+ Point",
        ),
        rows.length > 0 &&
          h("button", { type: "button", id: "clear-points", onClick: this.of.clear }, "Clear"),
      ),
    );
  }
  /** @param {number} k */
  row(k) {
    const { pulley, kind } = this.props;
    const at = ["pulley", pulley, "across", kind.key];
    if (!Array.isArray(this.of.profile)) at.push("rows");
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
          const rows = /** @type {Rows} */ (this.of.rows.map((r) => [...r]));
          rows[k][j] = value ?? "";
          this.of.put(rows);
        },
      });
    return h(
      "div",
      { class: "row", key: `r${k}` },
      cell(0, "Position", "length"),
      cell(1, kind.what, kind.dimension),
      h(
        "button",
        { type: "button", "aria-label": `Remove point ${k + 1}`, onClick: () => this.of.remove(k) },
        "✕",
      ),
    );
  }
}
