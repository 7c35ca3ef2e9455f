// Curves clicked on the picture of a figure. The picture stays in the browser; its points go.
import { redraw } from "../../base/design.js";
import { save } from "../../base/save.js";
import { act } from "../../base/server.js";
import { trim } from "../../base/units.js";
import { choose, valueIn } from "../../parts/choose.js";
import { scroll } from "../../parts/tables.js";
import { Component, createRef, h } from "../../vendor/preact.js";
import { figured } from "./plan.js";

/**
 * @typedef {[number, number]} Place in pixels of the picture
 * @typedef {{at: Place | null, value: string}} Mark a point of an axis and what it stands for
 * @typedef {{name: string, unit: string, points: Place[]}} Curve
 */

/** Most pixels and bytes of a picture; axis points nearer than this [px] tell no scale. */
const MOST = { pixels: 40e6, bytes: 30e6 };
const NEAR = 20;
/** Fewest points of a curve, as the server asks for; of A and b. */
const FEWEST = { friction: 10, coefficients: 3 };
/** As far as this outside the points of an axis, a part of their distance, clicks tell nothing. */
const OUTSIDE = 0.5;
/** Below 0 by more than this part is no error of a click. */
const BELOW = 0.02;
const UNITS = /** @type {Record<string, number>} */ ({
  kPa: 1e3,
  MPa: 1e6,
  psi: 6894.757,
  bar: 1e5,
});
const MARKS = [
  "x axis, first point",
  "x axis, second point",
  "y axis, first point",
  "y axis, second point",
];
const KEYS =
  "Keys in the picture: arrows move the chosen point, or the cross, by a pixel (Shift 0.1, Ctrl " +
  "20); Enter puts a point at the cross; Page Up and Down choose a point, Esc none; Delete takes " +
  "it out, Ctrl+Z takes a step back.";

/** @returns {Curve} */
const empty = () => ({ name: "", unit: "kPa", points: [] });
const begun = () => ({
  marks: /** @type {Mark[]} */ (MARKS.map(() => ({ at: null, value: "" }))),
  log: [false, false],
  curves: [empty()],
  /** What is clicked: a mark of an axis, or after the four a curve. */
  target: 0,
  /** The chosen point of a curve. */
  chosen: -1,
});
/** @type {{picture: {url: string, name: string, width: number, height: number} | null,
 *   wrong: string, zoom: number, tried: boolean, past: ReturnType<typeof shot>[]}
 *   & ReturnType<typeof begun>} */
const state = { picture: null, wrong: "", zoom: 1, tried: false, past: [], ...begun() };

export const hasFigure = () => Boolean(state.picture);
/** @param {string} wrong */
function refuse(wrong) {
  state.wrong = wrong;
  redraw();
}
/** Take a picture; its name stands for the file of its points. @param {File} file
 * @param {(name: string) => boolean} taken whether a file of points has that name */
export async function openPicture(file, taken) {
  if (!file.type.startsWith("image/"))
    return refuse(`${file.name} is no picture. Choose PNG, JPEG, WebP, GIF or SVG.`);
  if (file.size > MOST.bytes)
    return refuse(
      `${file.name} has ${trim(file.size / 1e6, 3)} MB, at most 30 are taken. Crop it.`,
    );
  const url = URL.createObjectURL(file);
  const image = new Image(); // never inline: what a picture carries does not run
  const loaded = new Promise((done) => {
    image.onload = () => done(true);
    image.onerror = () => done(false);
  });
  image.src = url;
  const { naturalWidth: width, naturalHeight: height } = (await loaded) ? image : new Image();
  const millions = (width * height) / 1e6;
  let wrong = "";
  if (!width || !height) wrong = `${file.name} cannot be shown. Save it again as PNG.`;
  else if (width * height > MOST.pixels)
    wrong = `${file.name} has ${trim(millions, 3)} million pixels, at most 40 are taken. Crop it.`;
  if (wrong) {
    URL.revokeObjectURL(url);
    return refuse(wrong);
  }
  if (state.picture) URL.revokeObjectURL(state.picture.url);
  const stem = file.name.replace(/\.[^.]*$/, "") || "figure";
  let name = stem;
  for (let n = 2; taken(`${name}.json`); n++) name = `${stem}-${n}`;
  Object.assign(state, begun(), { wrong: "", zoom: 1, tried: false, past: [] });
  state.picture = { url, name, width, height };
  redraw();
}

// What the clicks mean.

/** @param {string} text */
const number = (text) => (text.trim() ? Number(text) : Number.NaN);
/** @param {Place} a @param {Place} b @returns {Place} */
const less = (a, b) => [a[0] - b[0], a[1] - b[1]];
/** @param {Place} a @param {Place} b */
const cross = (a, b) => a[0] * b[1] - a[1] * b[0];
/** The two axes as vectors in the picture; null until all four are clicked. */
function vectors() {
  const at = state.marks.map((m) => m.at);
  if (!at[0] || !at[1] || !at[2] || !at[3]) return null;
  return { x: less(at[1], at[0]), y: less(at[3], at[2]), from: [at[0], at[2]] };
}
/** Angle between the axes [degrees]. */
function angle() {
  const v = vectors();
  if (!v) return 90;
  return (
    (Math.asin(Math.min(1, Math.abs(cross(v.x, v.y)) / size(v.x) / size(v.y))) * 180) / Math.PI
  );
}
/** @param {Place} v */
const size = (v) => Math.hypot(v[0], v[1]);
/** How far along each axis a place is, as a part of what was clicked: the axes may be turned and
 * need not be square. @param {Place} p @returns {Place | null} */
function parts(p) {
  const v = vectors();
  const det = v && cross(v.x, v.y);
  if (!v || !det) return null;
  return [cross(less(p, v.from[0]), v.y) / det, cross(v.x, less(p, v.from[1])) / det];
}
/** Values of a place. @param {Place} p @returns {Place | null} */
function valuesAt(p) {
  const along = parts(p);
  if (!along) return null;
  const of = (/** @type {number} */ axis) => {
    const [a, b] = [0, 1].map((k) => number(state.marks[2 * axis + k].value));
    const part = along[axis];
    return state.log[axis] ? a * (b / a) ** part : a + part * (b - a);
  };
  const found = /** @type {Place} */ ([of(0), of(1)]);
  return found.every(Number.isFinite) ? found : null;
}
/** @param {number} v */
const digits = (v) => trim(v, 4);
/** @param {Curve} c */
const pressure = (c) => number(c.name) * UNITS[c.unit];
/** @param {Curve} c */
const nameOf = (c) => (figured() === "friction" ? `${c.name.trim()} ${c.unit}` : c.name);

/** All that is wrong, by its field: marks `m0` ..., curves `c0` ..., their points `p0` ... */
function faults() {
  const found = /** @type {Record<string, string>} */ ({});
  const quantity = figured();
  state.marks.forEach((m, k) => {
    if (!m.at) found[`m${k}`] = "Click this point in the picture.";
    else if (!m.value.trim()) found[`m${k}`] = "Type what the axis says there, such as 12.";
    else if (!Number.isFinite(number(m.value)))
      found[`m${k}`] = `${m.value} is no number. Type one such as 0.5.`;
    else if (state.log[k >> 1] && number(m.value) <= 0)
      found[`m${k}`] = `${m.value} is on no logarithmic axis. Type a value above 0.`;
  });
  for (const axis of [0, 1]) {
    const [a, b] = [state.marks[2 * axis], state.marks[2 * axis + 1]];
    const key = `m${2 * axis + 1}`;
    if (found[key] || found[`m${2 * axis}`] || !a.at || !b.at) continue;
    const apart = size(less(a.at, b.at));
    if (apart < NEAR)
      found[key] = `It is ${trim(apart, 3)} pixels from the first point. Click them farther apart.`;
    else if (number(a.value) === number(b.value))
      found[key] = `Both points are at ${b.value}. Type what the axis says at each.`;
  }
  if (!found.m1 && !found.m3 && angle() < 45)
    found.m3 = `The axes cross at ${trim(angle(), 3)} degrees. Click two points along each axis.`;
  const clear = !Object.keys(found).length;
  state.curves.forEach((c, k) => {
    const twin = state.curves.slice(0, k).find((x) => same(x, c));
    if (quantity === "friction" && !(pressure(c) > 0 && Number.isFinite(pressure(c))))
      found[`c${k}`] = "Type the pressure of this curve, such as 138.";
    else if (quantity === "coefficients" && !["A", "b"].includes(c.name))
      found[`c${k}`] = "Say whether it is A or b.";
    else if (twin)
      found[`c${k}`] = `${nameOf(twin)} and ${nameOf(c)} are one. Correct it, or delete one curve.`;
    const fewest = FEWEST[quantity];
    if (c.points.length < fewest)
      found[`p${k}`] = `${c.points.length} points. Click ${fewest} or more, most where it bends.`;
    else if (clear) {
      const i = c.points.findIndex((p) => outside(p));
      if (i >= 0) found[`p${k}`] = `Point ${i + 1} ${outside(c.points[i])}`;
    }
  });
  if (quantity === "coefficients" && state.curves.length < 2)
    found.curves = "Add the other curve: both A and b are needed.";
  return found;
}
/** @param {Curve} a @param {Curve} b */
function same(a, b) {
  if (figured() === "coefficients") return a.name === b.name;
  return Math.abs(pressure(a) / pressure(b) - 1) < 0.005;
}
/** Why a point cannot be of its curve, if it cannot. @param {Place} p */
function outside(p) {
  const along = /** @type {Place} */ (parts(p));
  const [x, y] = /** @type {Place} */ (valuesAt(p));
  const at = `is at ${digits(x)}, ${digits(y)}`;
  if (along.some((v) => v < -OUTSIDE || v > 1 + OUTSIDE))
    return `${at}, far outside the points of the axes. Delete it, or click these farther apart.`;
  const span = [0, 1].map((k) =>
    Math.max(...state.marks.slice(2 * k, 2 * k + 2).map((m) => Math.abs(number(m.value)))),
  );
  const signed = figured() === "coefficients"; // A is below 0
  if (x < -BELOW * span[0] || (!signed && y < -BELOW * span[1]))
    return `${at}, below 0. Move or delete it, or see the values of the axes.`;
  return "";
}
/** Whether anything was clicked along a curve. */
const any = () => state.curves.some((c) => c.points.length > 0);
/** The points as the file that `wraparc fit` reads; "" where something is wrong, which is told.
 * @returns {{name: string, text: string} | "" | null} null where there is nothing */
export function figureFile() {
  if (!state.picture) return null;
  state.tried = true;
  redraw();
  if (Object.keys(faults()).length) return "";
  const datasetColl = state.curves.map((c) => ({
    name: nameOf(c),
    data: c.points.map((p) => ({ x: p[0], y: p[1], value: valuesAt(p) })),
  }));
  return { name: `${state.picture.name}.json`, text: JSON.stringify({ datasetColl }) };
}
/** Whether the points of the present picture would be lost with it. */
export const unfinished = () => Boolean(state.picture) && any() && !figureFile();
/** @param {string} wrong */
export const refusePicture = refuse;
function download() {
  const file = figureFile();
  if (file) save(file.name, file.text, "application/json");
}

// What is done with them.

/** Where everything is; what is typed of it stays as it is. */
const shot = () => ({
  at: state.marks.map((m) => m.at),
  log: [...state.log],
  curves: state.curves.map((curve) => ({ curve, points: [...curve.points] })),
});
/** Change something that can be taken back. @param {() => void} f */
function step(f) {
  state.past.push(shot());
  if (state.past.length > 300) state.past.shift();
  f();
  redraw();
}
function undo() {
  const before = state.past.pop();
  if (!before) return;
  before.at.forEach((at, k) => {
    state.marks[k].at = at;
  });
  for (const { curve, points } of before.curves) curve.points = points;
  const curves = before.curves.map((c) => c.curve);
  const target = Math.min(state.target, 3 + curves.length);
  Object.assign(state, { log: before.log, curves, target, chosen: -1 });
  redraw();
}
/** The curve that is clicked along. @returns {Curve | undefined} */
const current = () => state.curves[state.target - 4];
/** The places that can be moved now. @returns {Place[]} */
const places = () =>
  current()?.points ?? state.marks.flatMap((m, k) => (m.at && k === state.target ? [m.at] : []));
/** @param {Place} p */
function add(p) {
  step(() => {
    const curve = current();
    if (curve) state.chosen = curve.points.push(p) - 1;
    else {
      state.marks[state.target].at = p;
      const next = state.marks.findIndex((m) => !m.at);
      state.target = next < 0 ? 4 : next;
      state.chosen = -1;
    }
  });
}
/** Move the chosen place, without a step of its own. @param {Place} p */
function put(p) {
  const curve = current();
  if (curve) curve.points[state.chosen] = p;
  else state.marks[state.target].at = p;
}
function takeOut() {
  const curve = current();
  if (!curve || state.chosen < 0) return;
  step(() => {
    curve.points.splice(state.chosen, 1);
    state.chosen = Math.min(state.chosen, curve.points.length - 1);
  });
}
/** @param {number} target */
function aim(target) {
  Object.assign(state, { target, chosen: target < 4 && state.marks[target].at ? 0 : -1 });
  redraw();
}

/** The picture with its points, and a lens over the place in hand. @extends {Component<{}>} */
class View extends Component {
  svg = createRef();
  /** @type {Place} */
  at = [0, 0];
  dragged = false;
  /** @type {Place | null} */
  from = null;
  /** @param {{clientX: number, clientY: number}} e @returns {Place} */
  place(e) {
    const { x, y } = new DOMPoint(e.clientX, e.clientY).matrixTransform(
      this.svg.current.getScreenCTM().inverse(),
    );
    return [x, y];
  }
  /** Number of the place under the pointer, -1 for none. @param {any} e @param {number} within */
  near(e, within) {
    const scale = this.svg.current.getScreenCTM().a;
    const off = places().map((p) => size(less(p, this.place(e))) * scale);
    const least = Math.min(...off);
    return least <= within ? off.indexOf(least) : -1;
  }
  /** @param {PointerEvent} e */
  down(e) {
    if (e.button !== 0) return;
    const hit = this.near(e, e.pointerType === "touch" ? 18 : 5);
    this.at = this.place(e);
    this.from = [e.clientX, e.clientY];
    this.dragged = hit >= 0;
    if (hit < 0) return;
    state.chosen = hit;
    state.past.push(shot());
    this.svg.current.setPointerCapture(e.pointerId);
    redraw();
  }
  /** @param {PointerEvent} e */
  over(e) {
    this.at = this.place(e);
    if (this.from && this.dragged && this.moved(e)) put(this.at);
    this.forceUpdate();
  }
  /** @param {PointerEvent} e */
  moved(e) {
    return this.from !== null && size(less([e.clientX, e.clientY], this.from)) > 2;
  }
  /** @param {PointerEvent} e */
  up(e) {
    const moved = this.moved(e);
    if (this.dragged && !moved) state.past.pop(); // chosen only
    if (this.from && !this.dragged && !moved) add(this.place(e));
    this.cancel();
    redraw();
  }
  cancel() {
    this.from = null;
    this.dragged = false;
  }
  /** @param {KeyboardEvent} e */
  key(e) {
    const ways = /** @type {Record<string, Place>} */ ({
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, -1],
      ArrowDown: [0, 1],
    });
    const chosen = places()[state.chosen];
    const by = e.shiftKey ? 0.1 : e.ctrlKey ? 20 : 1;
    const choose = (/** @type {number} */ n) => {
      state.chosen = Math.max(0, Math.min(places().length - 1, state.chosen + n));
      redraw();
    };
    /** @type {Record<string, () => void>} */
    const does = {
      Enter: () => add([...(chosen ?? this.at)]),
      Delete: takeOut,
      Backspace: takeOut,
      PageUp: () => choose(-1),
      PageDown: () => choose(1),
      Escape: () => {
        if (chosen) this.at = chosen;
        state.chosen = -1;
        redraw();
      },
    };
    if (e.ctrlKey && e.key === "z") undo();
    else if (ways[e.key]) {
      const way = ways[e.key];
      const to = /** @type {Place} */ ((chosen ?? this.at).map((v, k) => v + by * way[k]));
      if (chosen) step(() => put(to));
      this.at = to;
      this.forceUpdate();
    } else if (does[e.key]) does[e.key]();
    else return;
    e.preventDefault();
    e.stopPropagation(); // the page undoes changes of the design by the same keys
  }
  render() {
    const { url, width, height } = /** @type {NonNullable<typeof state.picture>} */ (state.picture);
    const [x, y] = places()[state.chosen] ?? this.at;
    const image = h("image", { href: url, width, height, preserveAspectRatio: "none" });
    const dots = [
      state.marks.map((m, k) => m.at && dot(m.at, `mark${k === state.target ? " now" : ""}`)),
      state.curves.map((c, k) =>
        c.points.map((p, i) =>
          dot(p, k + 4 !== state.target ? "" : i === state.chosen ? "now chosen" : "now"),
        ),
      ),
    ];
    const lines = h("path", {
      class: "cross",
      d: `M${x - 15} ${y}h30M${x} ${y - 15}v30`,
    });
    return h(
      "div",
      { class: "figured" },
      h(
        "div",
        { class: "figure-view" },
        h(
          "svg",
          {
            ref: this.svg,
            viewBox: `0 0 ${width} ${height}`,
            style: { width: `${100 * state.zoom}%` },
            tabindex: 0,
            role: "application",
            "aria-label": "Picture of the figure",
            "aria-describedby": "figure-keys",
            onPointerDown: (/** @type {PointerEvent} */ e) => this.down(e),
            onPointerMove: (/** @type {PointerEvent} */ e) => this.over(e),
            onPointerUp: (/** @type {PointerEvent} */ e) => this.up(e),
            onPointerCancel: () => this.cancel(),
            onTouchStart: (/** @type {TouchEvent} */ e) =>
              this.near(e.touches[0], 18) >= 0 && e.preventDefault(),
            onKeyDown: (/** @type {KeyboardEvent} */ e) => this.key(e),
          },
          image,
          dots,
          lines,
        ),
      ),
      h(
        "svg",
        { class: "lens", viewBox: `${x - 12} ${y - 12} 24 24`, "aria-hidden": true },
        image,
        dots,
        lines,
      ),
    );
  }
}
/** A point of the same size however near it is looked at. @param {Place} p @param {string} cls */
const dot = ([x, y], cls) => [
  h("path", { class: "halo", d: `M${x} ${y}h0` }),
  h("path", { class: `dot ${cls}`, d: `M${x} ${y}h0` }),
];

// The card.

/** @param {string} id @param {string | undefined} text */
const error = (id, text) => text && h("p", { class: "error", id }, text);
/** @param {string} text @param {(e: any) => void} onClick @param {any} [more] */
const button = (text, onClick, more) => h("button", { type: "button", onClick, ...more }, text);
/** @param {(file: File) => any} take what to do with a picture that is chosen */
export function figureCard(take) {
  const input = {
    type: "file",
    id: "figure-file",
    class: "away",
    tabIndex: -1,
    accept: "image/*",
    "aria-label": "Picture of the figure, a file",
    onChange: act((e) => {
      const own = /** @type {HTMLInputElement} */ (e.currentTarget);
      const file = own.files?.[0];
      own.value = "";
      return file && take(file);
    }),
  };
  const open = () => document.getElementById("figure-file")?.click();
  return h(
    "section",
    { class: "card", "aria-label": "Figure", key: "figure" },
    h("h2", {}, state.picture ? `Curves of ${state.picture.name}` : "Curves of a figure"),
    h("input", input),
    h(
      "p",
      { class: "bar" },
      button(state.picture ? "Next picture …" : "Choose a picture …", open, {
        id: "figure-choose",
      }),
      h(
        "span",
        { class: "help" },
        "Or paste or drop it. It stays in this browser: points are sent.",
      ),
    ),
    h("div", { role: "alert" }, error("figure-e", state.wrong)),
    state.picture && tool(),
  );
}
function tool() {
  const found = faults();
  // what is only not there yet is told when it is asked for
  const told = (/** @type {string} */ key, /** @type {boolean} */ begun) =>
    state.tried || begun ? found[key] : undefined;
  const [p, i] = [places(), state.chosen];
  const value = p[i] && valuesAt(p[i]);
  const skew = angle();
  const zoom = (/** @type {number} */ by) => () => {
    state.zoom = Math.max(1, Math.min(16, state.zoom * by));
    redraw();
  };
  return [
    h(
      "p",
      { class: "bar", key: "bar" },
      h("strong", {}, `Click: ${aimed()}`),
      button("−", zoom(0.5), { "aria-label": "Smaller picture", disabled: state.zoom <= 1 }),
      button("+", zoom(2), { "aria-label": "Larger picture", disabled: state.zoom >= 16 }),
      button("Undo step", undo, { disabled: !state.past.length }),
      button("Delete point", takeOut, { disabled: !current() || i < 0 }),
      h("span", { role: "status" }, value && `Point ${i + 1}: ${value.map(digits).join(", ")}`),
    ),
    h(View, { key: state.picture?.url }),
    h("p", { class: "help", id: "figure-keys", key: "keys" }, KEYS),
    h(
      "div",
      { class: "cols", key: "cols" },
      h(
        "div",
        {},
        state.marks.map((m, k) => markRow(m, k, told(`m${k}`, Boolean(m.at && m.value.trim())))),
        [0, 1].map((axis) =>
          h(
            "label",
            { class: "check", key: axis },
            h("input", {
              type: "checkbox",
              checked: state.log[axis],
              onChange: () => step(() => (state.log[axis] = !state.log[axis])),
            }),
            `${"xy"[axis]} axis is logarithmic`,
          ),
        ),
        vectors() &&
          skew < 89 &&
          h("p", { class: "help" }, `The axes cross at ${trim(skew, 3)} degrees: read along each.`),
      ),
      h(
        "div",
        {},
        state.curves.map((c, k) => curveRow(c, k, told, found)),
        error("figure-curves", told("curves", false)),
        h(
          "p",
          { class: "bar" },
          button("Add a curve", () =>
            step(() => {
              const unit = state.curves.at(-1)?.unit ?? "kPa";
              aim(3 + state.curves.push({ ...empty(), unit }));
            }),
          ),
          button("Save the points", download),
        ),
      ),
    ),
    current() && pointTable(/** @type {Curve} */ (current())),
  ];
}
const aimed = () => {
  const c = current();
  if (!c) return MARKS[state.target];
  return c.name ? `along ${nameOf(c)}` : `along curve ${state.target - 3}`;
};
/** @param {Mark} m @param {number} k @param {string | undefined} wrong */
function markRow(m, k, wrong) {
  const id = `figure-m${k}`;
  return h(
    "div",
    { class: `field${wrong ? " wrong" : ""}`, key: id },
    h("label", { for: id }, MARKS[k]),
    button(m.at ? "✓" : "•", () => aim(k), {
      "aria-pressed": state.target === k,
      "aria-label": `Click ${MARKS[k]}`,
    }),
    h(
      "span",
      { class: "box" },
      h("input", {
        id,
        type: "text",
        inputMode: "decimal",
        autocomplete: "off",
        value: m.value,
        "aria-invalid": Boolean(wrong),
        "aria-describedby": `${id}-e`,
        onInput: (/** @type {Event} */ e) => {
          m.value = valueIn(e);
          redraw();
        },
      }),
    ),
    h("p", { class: "error", id: `${id}-e` }, wrong),
  );
}
/** @param {Curve} c @param {number} k @param {(key: string, begun: boolean) => string | undefined}
 * told @param {Record<string, string>} found */
function curveRow(c, k, told, found) {
  const id = `figure-c${k}`;
  const wrong = told(`c${k}`, Boolean(c.name.trim()));
  const points = told(`p${k}`, c.points.length >= FEWEST[figured()]);
  const change = (/** @type {Partial<Curve>} */ more) => {
    Object.assign(c, more);
    redraw();
  };
  const said = { "aria-invalid": Boolean(wrong), "aria-describedby": `${id}-e` };
  const name =
    figured() === "friction"
      ? [
          h("input", {
            id,
            type: "text",
            size: 6,
            inputMode: "decimal",
            autocomplete: "off",
            value: c.name,
            ...said,
            onInput: (/** @type {Event} */ e) => change({ name: valueIn(e) }),
          }),
          h(
            "select",
            {
              value: c.unit,
              "aria-label": `Unit of pressure ${k + 1}`,
              onChange: (/** @type {Event} */ e) => change({ unit: valueIn(e) }),
            },
            Object.keys(UNITS).map((u) => h("option", { value: u, key: u }, u)),
          ),
        ]
      : choose(
          c.name,
          [
            ["", "A or b"],
            ["A", "A"],
            ["b", "b"],
          ],
          (value) => change({ name: value }),
          id,
        );
  const remove = () =>
    step(() => {
      state.curves.splice(k, 1);
      if (!state.curves.length) state.curves.push(empty());
      aim(Math.min(state.target, 3 + state.curves.length));
    });
  return h(
    "div",
    { class: `field${wrong || points ? " wrong" : ""}`, key: id },
    h(
      "label",
      { for: id },
      figured() === "friction" ? `Pressure of curve ${k + 1}` : `Curve ${k + 1}`,
      h("small", { class: "help" }, ` ${c.points.length} points`),
    ),
    button(found[`c${k}`] || found[`p${k}`] ? "•" : "✓", () => aim(k + 4), {
      "aria-pressed": state.target === k + 4,
      "aria-label": `Click along curve ${k + 1}`,
    }),
    h(
      "span",
      { class: "box" },
      name,
      button("✕", remove, { "aria-label": `Delete curve ${k + 1}` }),
    ),
    h("p", { class: "error", id: `${id}-e` }, [wrong, points].filter(Boolean).join(" ")),
  );
}
/** @param {Curve} c */
function pointTable(c) {
  if (!c.points.length) return null;
  const row = (/** @type {Place} */ p, /** @type {number} */ i) => {
    const value = valuesAt(p);
    const pick = () => {
      state.chosen = i;
      redraw();
    };
    return h(
      "tr",
      { key: i, class: i === state.chosen ? "pinned" : "" },
      h("th", { scope: "row" }, button(`Point ${i + 1}`, pick)),
      [0, 1].map((k) => h("td", { key: k }, value ? digits(value[k]) : "")),
      [0, 1].map((k) => h("td", { key: `p${k}` }, p[k].toFixed(1))),
    );
  };
  const heads = ["Point", "x", "y", "x [pixels]", "y [pixels]"];
  return h(
    "details",
    { key: "points" },
    h("summary", {}, `Points of ${aimed().replace("along ", "")}`),
    scroll(
      "Points of the curve",
      h(
        "table",
        { class: "grid-table" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            heads.map((t) => h("th", { scope: "col", key: t }, t)),
          ),
        ),
        h("tbody", {}, c.points.map(row)),
      ),
    ),
  );
}
