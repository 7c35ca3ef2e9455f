// The wrap unrolled, over the width of the belt and the wrap angle; its upper edge is the profile,
// whose points are dragged.
import { grasp, gripped } from "../../base/design.js";
import { digits, dimensionOf, trim, unit } from "../../base/units.js";
import { colour, shade } from "../../plots/ramp.js";
import { Sized } from "../../plots/sized.js";
import { fixed, fresh, roundStep, ticks } from "../../plots/svg.js";
import { createRef, h } from "../../vendor/preact.js";
import { Points } from "./editor.js";
import { beltWidth, edgeText } from "./profile.js";
import { faceOf, limitOf, SIDES, short, stripAt, titleOf } from "./width.js";

/** @import { Children } from "../../types.d.ts" */
/** @import { Ends } from "./editor.js" */
/** @import { Kind } from "./profile.js" */
/** @typedef {{pulley: number, kind: Kind, answer: any, quantity: string, strip: number,
 *   point: (strip: number | null) => void}} FaceProps answer: none before the first */

const TOP = 26;
const ZONE = 74; // of the profile
const FOOT = 34;
const SHADES = 28;

/** @extends {Sized<FaceProps>} */
export class Face extends Sized {
  svg = createRef();
  clip = fresh("face");
  /** The scale stays while a point is held. @type {Ends | null} */
  held = null;
  dragged = -1;
  /** @type {{of: any[], drawn: Children}} */
  kept = { of: [], drawn: null };
  get of() {
    return new Points(this.props.pulley, this.props.kind);
  }
  get floor() {
    return Math.max(this.high - FOOT, TOP + ZONE + 60);
  }
  get half() {
    return 0.5 * beltWidth();
  }
  /** What lies far beside the belt stands just outside the picture. @param {number} y [m] */
  X(y) {
    const { half } = this;
    const near = Math.min(Math.max(y, -2 * half), 2 * half);
    const { left, right } = SIDES;
    return left + ((near + half) / (2 * half)) * (this.wide - left - right);
  }
  /** @param {number} v */
  Y(v) {
    const { least, most } = this.held || this.of.ends();
    const part = (v - least) / (most - least);
    return TOP + (this.props.kind.sign === "down" ? part : 1 - part) * ZONE;
  }
  /** Position and value under the pointer [SI]. @param {PointerEvent | MouseEvent} e */
  under(e) {
    const box = this.svg.current.getBoundingClientRect();
    const { least, most } = this.held || this.of.ends();
    const x = (e.clientX - box.left) * (this.wide / box.width);
    const part = ((e.clientY - box.top) * (this.high / box.height) - TOP) / ZONE;
    const up = this.props.kind.sign === "down" ? part : 1 - part;
    const { left, right } = SIDES;
    const y = ((x - left) / (this.wide - left - right)) * 2 * this.half - this.half;
    return [y, least + up * (most - least)];
  }
  render() {
    return h("div", { class: "face", ref: this.box }, this.picture());
  }
  picture() {
    const { kind, answer: a, quantity, strip, point } = this.props;
    const { of, half } = this;
    const all = of.points();
    const points = all.filter((p) => p.every(Number.isFinite));
    const line = points.length
      ? [[-half, points[0][1]], ...points, [half, points[points.length - 1][1]]]
      : [
          [-half, 0],
          [half, 0],
        ];
    const edge = line.map(([y, v]) => `${fixed(this.X(y))} ${fixed(this.Y(v))}`).join("L");
    const name = faceOf(quantity);
    const over = (/** @type {PointerEvent} */ e) => {
      if (a?.map && !gripped()) point(stripAt(a, this.under(e)[0]));
    };
    return h(
      "svg",
      {
        class: `chart unrolled${a?.map ? " map" : ""}`,
        ref: this.svg,
        viewBox: `0 0 ${this.wide} ${this.high}`,
        role: "group",
        "aria-label": `${kind.what} over the width, ${all.length} points${this.told(name)}`,
        onDblClick: (/** @type {MouseEvent} */ e) => this.doubled(e),
        onPointerMove: over,
        onPointerLeave: () => point(null),
      },
      h(
        "clipPath",
        { id: this.clip },
        h("path", { d: `M${edge}L${this.X(half)} ${this.floor}H${this.X(-half)}Z` }),
      ),
      h(
        "g",
        { "clip-path": `url(#${this.clip})`, class: "cells" },
        h("rect", {
          ...{ x: this.X(-half), y: TOP, width: this.X(half) - this.X(-half) },
          ...{ height: this.floor - TOP, class: "bare" },
        }),
        a?.map && this.cells(name),
      ),
      this.axes(),
      h("path", { d: `M${this.X(-half)} ${this.Y(0)}H${this.X(half)}`, class: "new-edge" }),
      h("path", { d: `M${edge}`, class: "line edge" }),
      a?.map && this.frame(strip),
      all.map(([y, v], k) => Number.isFinite(y + v) && this.handle(y, v, k)),
      a?.map && this.scale(name),
    );
  }
  /** @param {MouseEvent} e */
  doubled(e) {
    const { of, half } = this;
    const [y, v] = this.under(e);
    if (Math.abs(y) > half) return;
    if (!of.rows.length)
      of.put([
        [edgeText(-half), of.zero()],
        [edgeText(half), of.zero()],
      ]);
    const { least, most } = of.ends();
    of.add(y, Math.min(most, Math.max(least, v)));
  }
  /** The colours of the face, made anew only for another answer, quantity or size.
   * @param {string} name */
  cells(name) {
    const { answer: a } = this.props;
    const of = [a, name, this.wide, this.high, this.half];
    if (of.every((v, k) => v === this.kept.of[k])) return this.kept.drawn;
    const { angle, position, [name]: rows } = a.map;
    const limit = limitOf(a, name);
    const most = Math.max(...rows.flat());
    const end = angle[angle.length - 1];
    const from = TOP + ZONE;
    const down = (/** @type {number} */ i) => from + (Math.max(0, i) / end) * (this.floor - from);
    const wide = (this.X(this.half) - this.X(-this.half)) / position.length;
    /** @type {Children[]} */
    const drawn = [];
    for (let i = 0; i < angle.length; i += 2) {
      const top = i ? down(angle[i - 1]) : TOP;
      const low = down(Math.min(end, angle[Math.min(i + 1, angle.length - 1)]));
      position.forEach((/** @type {number} */ y, /** @type {number} */ j) => {
        drawn.push(
          h("rect", {
            x: fixed(this.X(y) - wide / 2),
            y: fixed(top),
            width: fixed(wide + 0.5),
            height: fixed(low - top + 0.5),
            fill: shade(rows[i][j], most, limit),
          }),
        );
      });
    }
    this.kept = { of, drawn: h("g", { key: "cells" }, drawn) };
    return this.kept.drawn;
  }
  /** The strip that is looked at. @param {number} j */
  frame(j) {
    const { position } = this.props.answer.map;
    const wide = (this.X(this.half) - this.X(-this.half)) / position.length;
    return h("rect", {
      ...{ class: "strip-frame", x: this.X(position[j]) - wide / 2, y: TOP },
      ...{ width: wide, height: this.floor - TOP },
    });
  }
  axes() {
    const { kind, answer: a } = this.props;
    const { least, most } = this.held || this.of.ends();
    const [u, f] = unit(kind.dimension);
    const { left, right } = SIDES;
    const ys = ticks(least / f, most / f, roundStep((most - least) / f, 2));
    const angle = a?.map?.angle;
    const degrees = angle ? (180 / Math.PI) * angle[angle.length - 1] : 0;
    const from = TOP + ZONE;
    const at = (/** @type {number} */ d) => from + (d / degrees) * (this.floor - from);
    const marks = degrees ? ticks(45, degrees, 45) : [];
    const end = this.wide - right;
    const head = kind.key === "worn_depth" ? "new lagging, entry" : "entry";
    const how = `${kind.brief} [${u}]`;
    return [
      h("text", { x: left, y: 14, class: "tr", key: "head" }, head),
      h("text", { x: end, y: 14, class: "ty", key: "how" }, how),
      ys.map((v) =>
        h("text", { x: left - 6, y: this.Y(v * f) + 4, class: "ty", key: `y${v}` }, trim(v)),
      ),
      marks.map((d) =>
        h("text", { x: left - 6, y: at(d) + 4, class: "ty", key: `d${d}` }, `${d}°`),
      ),
      h("path", { d: `M${left} ${this.floor}H${end}`, class: "exit-edge", key: "exit" }),
      h("text", { x: left, y: this.floor + 16, class: "tr", key: "out" }, "exit"),
    ];
  }
  /** The scale of colours, which ends at the limit, if there is one. @param {string} name */
  scale(name) {
    const { answer: a } = this.props;
    const [u, f] = unit(dimensionOf(name));
    const limit = limitOf(a, name);
    const most = Math.max(...a.map[name].flat());
    const to = this.wide - SIDES.right - 82;
    const from = to - Math.min(150, 0.28 * this.wide);
    const y = this.floor + 8;
    const part = (/** @type {number} */ v) => from + ((to - from) * v) / most;
    const wide = (to - from) / SHADES;
    return h(
      "g",
      { key: "scale", "aria-hidden": "true" },
      Array.from({ length: SHADES }, (_, k) =>
        h("rect", {
          ...{ key: k, x: from + k * wide, y, width: wide + 0.5, height: 7 },
          fill: limit ? shade(((k + 0.5) / SHADES) * most, most, limit) : colour(k / (SHADES - 1)),
        }),
      ),
      h("text", { x: from - 6, y: y + 8, class: "ty" }, `${titleOf(name).toLowerCase()} 0`),
      h("text", { x: to + 6, y: y + 8, class: "tr" }, `${digits(short(most / f))} ${u}`),
      limit > 0 &&
        limit < 0.97 * most &&
        h("text", { x: part(limit), y: y + 20, class: "tx" }, digits(limit / f, 3)),
    );
  }
  /** What the colours show, in words. @param {string} name */
  told(name) {
    const { answer: a } = this.props;
    if (!a?.map) return "";
    const { angle, position, [name]: rows } = a.map;
    const flat = rows.flat();
    const [lo, hi] = [Math.min(...flat), Math.max(...flat)];
    const most = flat.indexOf(hi);
    const [u, f] = unit(dimensionOf(name));
    const [lu, lf] = unit("length");
    const degrees = (180 / Math.PI) * angle[Math.floor(most / position.length)];
    const ends = `${digits(lo / f)} to ${digits(hi / f)} ${u}`;
    return (
      `. ${titleOf(name)} over wrap angle and width: ${ends}, ` +
      `most at ${digits(degrees, 3)} deg and ${digits(position[most % position.length] / lf, 3)} ` +
      `${lu} from the middle`
    );
  }
  /** @param {number} y @param {number} v @param {number} k */
  handle(y, v, k) {
    const { kind, answer: a, point } = this.props;
    const { of } = this;
    const [place, value] = of.rows[k];
    const begin = (/** @type {PointerEvent} */ e) => {
      grasp();
      this.held = of.ends();
      this.dragged = k;
      /** @type {Element} */ (e.currentTarget).setPointerCapture(e.pointerId);
    };
    const drag = (/** @type {PointerEvent} */ e) => {
      if (this.dragged !== k || !gripped()) return;
      const [at, to] = this.under(e);
      of.move(k, at, to);
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
      r: 8,
      class: "grip",
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
      onFocus: () => a?.map && point(stripAt(a, y)),
      onKeyDown: (/** @type {KeyboardEvent} */ e) => of.key(k, e),
    });
  }
}
