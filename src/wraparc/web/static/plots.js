// Pictures, drawn as SVG and changed in place: a slider step only rewrites paths.
import { s, put, digits, trim } from "./core.js";

const attr = (e, a) => { for (const k in a) e.setAttribute(k, a[k]); return e; };
const fixed = (v) => Math.round(v * 10) / 10;
const nice = (span, most) => {
  const raw = span / most, p = 10 ** Math.floor(Math.log10(raw || 1));
  return [1, 2, 2.5, 5, 10].map((m) => m * p).find((v) => v >= raw * 0.9999);
};
const ticksOf = (lo, hi, step) => {
  const out = [];
  for (let i = Math.ceil(lo / step - 1e-9); i * step <= hi + 1e-5 * step; i++) out.push(+(i * step).toPrecision(12));
  return out;
};
const angleStep = (end, room) => [5, 10, 15, 30, 45, 60, 90, 180].find((v) => end / v <= room) || 180;
let ids = 0;

/** Hatches, so that nothing is told by colour alone. */
const hatches = (id) => s("defs", {},
  s("pattern", { id: `${id}out`, width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" }, s("path", { d: "M0 0V6", class: "hatch-red" })),
  s("pattern", { id: `${id}rest`, width: 5, height: 5, patternUnits: "userSpaceOnUse" }, s("circle", { cx: 2.5, cy: 2.5, r: 0.9, class: "dot" })),
  s("pattern", { id: `${id}x`, width: 6, height: 6, patternUnits: "userSpaceOnUse" }, s("rect", { width: 6, height: 6, class: "f-green" }), s("path", { d: "M0 0L6 6M6 0L0 6", class: "hatch-white" })),
  s("pattern", { id: `${id}d`, width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" }, s("rect", { width: 6, height: 6, class: "f-orange" }), s("path", { d: "M0 0V6", class: "hatch-white" })));

/** Lines over a common axis, with hatched zones, a limit, a point, a second scale and a cursor. */
export class Chart {
  constructor(box, { title, height = 190, xlabel = "", onpick }) {
    Object.assign(this, { box, title, height, xlabel, id: `c${++ids}` });
    this.back = s("g"); this.zones = s("g"); this.marks = s("g"); this.lines = [];
    this.layer = s("g"); this.cursor = s("path", { class: "cursor" });
    this.svg = s("svg", { class: "chart", role: "img" }, hatches(this.id), this.back, this.zones, this.layer, this.marks, this.cursor);
    this.legend = document.createElement("figcaption");
    put(box, this.legend, this.svg);
    new ResizeObserver(([e]) => { // drawing must not ask for the width: that would lay out the page at every step
      const wide = Math.floor(e.contentRect.width);
      if (wide && wide !== this.wide) { this.wide = wide; if (this.data) this.draw(this.data); }
    }).observe(box);
    if (onpick) this.svg.addEventListener("pointermove", (e) => {
      const x = (e.clientX - this.svg.getBoundingClientRect().left - this.left) / (this.w - this.left - this.right);
      if (x >= 0 && x <= 1) onpick(x);
    });
  }
  /** data: {x, lines: [{y, cls, label}], zones: [[from, to, kind]], limit: {y, label}, point: [x, y, label], ylabel, zero, other: {label, to, from}, xs: [lo, hi], angles} */
  draw(data) {
    this.data = data;
    const w = (this.w = this.wide ||= this.box.clientWidth || 480), ht = this.height;
    const right = (this.right = data.other ? 50 : 14), top = 8, bottom = this.xlabel ? 36 : 22;
    const [x0, x1] = data.xs || [data.x[0], data.x[data.x.length - 1]];
    let lo = data.zero ? 0 : Infinity, hi = data.zero ? 0 : -Infinity;
    for (const l of data.lines) if (!l.free) for (const y of l.y) { if (y < lo) lo = y; if (y > hi) hi = y; }
    const L = data.limit;
    if (L && Math.abs(L.y) < 2.2 * Math.max(Math.abs(lo), Math.abs(hi))) { lo = Math.min(lo, L.y); hi = Math.max(hi, L.y); }
    if (!(hi > lo)) { hi = (Number.isFinite(hi) ? hi : 0) + 1e-3; lo = (Number.isFinite(lo) ? lo : 0) - (data.zero ? 0 : 1e-3); }
    const step = nice(hi - lo, ht < 150 ? 4 : 5);
    lo = Math.floor(lo / step + 1e-9) * step; hi = Math.ceil(hi / step - 1e-9) * step;
    const left = (this.left = 26 + 6.8 * Math.max(trim(lo).length, trim(hi).length, trim(hi - step).length));
    const X = (v) => left + ((v - x0) / (x1 - x0)) * (w - left - right);
    const Y = (v) => top + ((hi - v) / (hi - lo)) * (ht - top - bottom);
    Object.assign(this, { X, Y, x0, x1, top, floor: ht - bottom });
    const key = [w, lo, hi, x0, x1, data.ylabel, data.other?.label, data.other?.key?.toPrecision(4)].join();
    if (key !== this.key) { this.key = key; this.axes(data, lo, hi, step, w, ht, left, right, top, bottom); }
    while (this.lines.length < data.lines.length) { const p = s("path"); this.lines.push(p); this.layer.append(p); }
    this.lines.forEach((p, i) => {
      const l = data.lines[i];
      if (!l) return p.setAttribute("d", "");
      const xs = l.x || data.x;
      let d = "";
      for (let j = 0; j < xs.length; j++) if (l.y[j] != null) d += `${d && l.y[j - 1] != null ? "L" : "M"}${fixed(X(xs[j]))} ${fixed(Math.max(top, Math.min(ht - bottom, Y(l.y[j]))))}`;
      attr(p, { d, class: `line ${l.cls}` });
    });
    put(this.zones, (data.zones || []).map(([a, b, kind]) => s("rect", { x: X(a), width: Math.max(0.5, X(b) - X(a)), y: top, height: ht - top - bottom, fill: `url(#${this.id}${kind})` })));
    put(this.marks,
      L && L.y >= lo && L.y <= hi && s("path", { d: `M${left} ${Y(L.y)}H${w - right}`, class: "limit" }),
      (data.points || []).map(([x, y, cls]) => s(cls === "sq" ? "rect" : "circle", cls === "sq" ? { x: X(x) - 3, y: Y(y) - 3, width: 6, height: 6, class: "pt" } : { cx: X(x), cy: Y(y), r: 3.5, class: `pt ${cls || ""}` })));
    const words = data.lines.filter((l) => l.label).map((l) => [l.cls, l.label]);
    if (L && L.y >= lo && L.y <= hi) words.push(["limit", L.label]);
    if (data.pointLabel) words.push(["pt", data.pointLabel]);
    const legendKey = JSON.stringify(words) + this.title;
    if (legendKey !== this.legendKey) {
      this.legendKey = legendKey;
      const strong = document.createElement("strong");
      strong.textContent = this.title;
      put(this.legend, strong, words.map(([cls, text]) => {
        const e = document.createElement("span");
        e.append(s("svg", { width: 26, height: 10, "aria-hidden": "true" }, cls === "pt" ? s("circle", { cx: 13, cy: 5, r: 3.5, class: "pt" }) : s("path", { d: "M1 5H25", class: cls === "limit" ? "limit" : `line ${cls}` })), text);
        return e;
      }));
    }
    this.svg.setAttribute("aria-label", `${this.title}: ${data.told || words.map((v) => v[1]).join(", ")}`);
  }
  axes(data, lo, hi, step, w, ht, left, right, top, bottom) {
    attr(this.svg, { width: w, height: ht, viewBox: `0 0 ${w} ${ht}` });
    const { X, Y } = this, room = Math.max(3, Math.floor((w - left - right) / 46));
    const xstep = data.angles ? angleStep(this.x1 - this.x0, room) : nice(this.x1 - this.x0, Math.min(8, room));
    const ys = ticksOf(lo, hi, step), xs = ticksOf(this.x0, this.x1, xstep);
    const other = [];
    if (data.other) {
      const a = data.other.to(lo), b = data.other.to(hi), st = nice(b - a, 5);
      for (const v of ticksOf(a, b, st)) other.push([Y(data.other.from(v)), v]);
    }
    put(this.back,
      ys.map((v) => s("path", { d: `M${left} ${Y(v)}H${w - right}`, class: v === 0 ? "zero" : "grid" })),
      xs.map((v) => s("path", { d: `M${X(v)} ${top}V${ht - bottom}`, class: "grid" })),
      ys.map((v) => s("text", { x: left - 5, y: Y(v) + 3.5, class: "ty" }, trim(v))),
      xs.map((v) => s("text", { x: X(v), y: ht - bottom + 14, class: "tx" }, trim(v))),
      other.map(([y, v]) => s("text", { x: w - right + 5, y: y + 3.5, class: "tr" }, trim(v))),
      s("text", { x: 11, y: (top + ht - bottom) / 2, class: "al", transform: `rotate(-90 11 ${(top + ht - bottom) / 2})` }, data.ylabel),
      data.other && s("text", { x: w - 6, y: (top + ht - bottom) / 2, class: "al", transform: `rotate(-90 ${w - 6} ${(top + ht - bottom) / 2})` }, data.other.label),
      this.xlabel && s("text", { x: (left + w - right) / 2, y: ht - 5, class: "al" }, this.xlabel));
  }
  at(part) {
    if (!this.X) return;
    const x = this.X(this.x0 + part * (this.x1 - this.x0));
    this.cursor.setAttribute("d", part == null ? "" : `M${fixed(x)} ${this.top}V${this.floor}`);
  }
}

// --- the pulley
const WARM = [[255, 255, 204], [255, 237, 160], [254, 217, 118], [254, 178, 76], [253, 141, 60], [252, 78, 42], [227, 26, 28], [189, 0, 38]];
export function warm(t) {
  const v = Math.max(0, Math.min(1, t)) * (WARM.length - 1), i = Math.min(WARM.length - 2, Math.floor(v)), f = v - i;
  return `rgb(${WARM[i].map((c, k) => Math.round(c + f * (WARM[i + 1][k] - c))).join()})`;
}
const CELLS = 90, SHELL = 80, LAG = 100, BELT = 105;

/** The pulley with its arc: coloured, and with the same quantity as height of a second ring. */
export class Pulley {
  constructor(box) {
    this.id = `p${++ids}`;
    this.cells = Array.from({ length: CELLS }, () => s("path"));
    const p = () => s("path"), t = (cls) => s("text", { class: cls });
    this.belt = attr(p(), { class: "belt" }); this.height = attr(p(), { class: "height" }); this.zones = s("g");
    this.nips = attr(p(), { class: "nip" }); this.pulls = [attr(p(), { class: "pull" }), attr(p(), { class: "pull" })];
    this.ways = [attr(p(), { class: "way" }), attr(p(), { class: "way" })];
    this.texts = [t("t1"), t("t1")]; this.nipText = [t("tn"), t("tn")]; this.duty = attr(t("duty"), { x: 0, y: 22 });
    this.peak = s("circle", { r: 3.2, class: "peak" }); this.hand = attr(p(), { class: "cursor" });
    this.turn = s("path", { d: "M-18.8 -10.8A22 22 0 0 1 18 -12.6", class: "turn", "marker-end": `url(#${this.id}a)` });
    this.bar = s("g");
    this.svg = s("svg", { class: "pulley", role: "img" },
      hatches(this.id),
      s("defs", {}, s("marker", { id: `${this.id}a`, viewBox: "0 0 10 10", refX: 8, refY: 5, markerWidth: 6, markerHeight: 6, orient: "auto" }, s("path", { d: "M0 0L10 5L0 10z", class: "head" }))),
      s("circle", { r: LAG, class: "shell" }), s("circle", { r: SHELL, class: "shell in" }),
      this.cells, this.zones, this.height, this.belt, this.nips, this.nipText, s("circle", { r: 8, class: "shell" }), this.turn, this.duty,
      this.peak, this.hand, this.pulls, this.ways, this.texts);
    this.pulls.forEach((e) => e.setAttribute("marker-end", `url(#${this.id}a)`));
    this.ways.forEach((e) => e.setAttribute("marker-end", `url(#${this.id}a)`));
    put(box, this.svg);
  }
  place(theta, r) {
    const a = this.half - theta, out = r + (this.phi > 2 * Math.PI ? (16 * theta) / (2 * Math.PI) : 0);
    return [out * Math.cos(a), -out * Math.sin(a)];
  }
  arc(from, to, r, n = 60) {
    const out = [];
    for (let i = 0; i <= n; i++) out.push(this.place(from + ((to - from) * i) / n, r));
    return out;
  }
  ring(from, to, a, b, n = 40) { return poly([...this.arc(from, to, a, n), ...this.arc(from, to, b, n).reverse()]) + "z"; }
  /** data: {phi, position, values, most, t1, t2, text1, text2, duty, outside, stuck, peak, told} */
  draw(d) {
    this.data = d;
    if (this.phi !== d.phi) this.frame(d.phi);
    const n = d.position.length;
    let j = 0;
    const inner = [];
    for (let i = 0; i < CELLS; i++) {
      const mid = ((i + 0.5) / CELLS) * d.phi;
      while (j < n - 2 && d.position[j + 1] < mid) j++;
      const f = (mid - d.position[j]) / (d.position[j + 1] - d.position[j] || 1);
      const v = Math.abs(d.values[j] + f * (d.values[j + 1] - d.values[j])) / (d.most || 1);
      this.cells[i].setAttribute("fill", warm(0.92 * v));
      inner.push(this.place(mid, SHELL - 4 - 26 * v));
    }
    this.height.setAttribute("d", poly([...this.arc(0, d.phi, SHELL - 4), ...inner.reverse()]) + "z");
    put(this.zones,
      d.outside.map(([a, b]) => s("path", { d: this.ring(a, b, SHELL, LAG), fill: `url(#${this.id}out)` })),
      d.stuck > 0 && s("path", { d: this.ring(0, d.stuck, SHELL, LAG), fill: `url(#${this.id}rest)` }));
    const [px, py] = this.place(d.peak, (SHELL + LAG) / 2);
    attr(this.peak, { cx: px, cy: py });
    const most = Math.max(d.t1, d.t2);
    [[d.t1, d.text1], [d.t2, d.text2]].forEach(([t, text], i) => {
      const { start, out, middle } = this.strands[i], tip = add(start, out, 25 + 75 * (t / most));
      this.pulls[i].setAttribute("d", `M${start}L${tip}`);
      this.texts[i].textContent = text;
    });
    this.duty.textContent = d.duty;
    this.svg.setAttribute("aria-label", d.told);
  }
  frame(phi) {
    this.phi = phi; this.half = phi / 2;
    for (let i = 0; i < CELLS; i++) this.cells[i].setAttribute("d", this.ring((i / CELLS) * phi, ((i + 1) / CELLS) * phi + (i < CELLS - 1 ? 0.004 : 0), SHELL, LAG, 2));
    const way = (entry) => { const a = entry ? this.half : -this.half, t = [Math.sin(a), Math.cos(a)]; return entry ? [-t[0], -t[1]] : t; };
    const outs = [way(true), way(false)];
    const far = (i, r) => add(this.place(i ? phi : 0, r), outs[i], 150);
    this.belt.setAttribute("d", poly([far(0, LAG), ...this.arc(0, phi, LAG), far(1, LAG), far(1, BELT), ...this.arc(0, phi, BELT).reverse(), far(0, BELT)]) + "z");
    const ends = [0, phi].map((t) => this.place(t, 1));
    this.nips.setAttribute("d", ends.map(([x, y]) => `M${x * SHELL} ${y * SHELL}L${x * LAG} ${y * LAG}`).join(""));
    let box = [-LAG - 6, -LAG - 6, LAG + 6, LAG + 6];
    const grow = ([x, y]) => (box = [Math.min(box[0], x), Math.min(box[1], y), Math.max(box[2], x), Math.max(box[3], y)]);
    this.strands = outs.map((out, i) => {
      const nip = this.place(i ? phi : 0, BELT), f = far(i, BELT);
      let aside = [out[1], -out[0]];
      if (aside[0] * nip[0] + aside[1] * nip[1] < 0) aside = [-aside[0], -aside[1]];
      const start = add(add(nip, out, 14), aside, 10), middle = add(add(nip, out, 80), aside, -14), run = i ? out : [-out[0], -out[1]];
      this.ways[i].setAttribute("d", `M${add(middle, run, -9)}L${add(middle, run, 9)}`);
      const [tx, ty] = add(add(start, out, 55), aside, 13), angle = (Math.atan2(out[1], out[0]) * 180) / Math.PI, turn = ((((angle + 90) % 180) + 180) % 180) - 90;
      attr(this.texts[i], { x: tx, y: ty, transform: `rotate(${turn} ${tx} ${ty})` });
      [f, add(start, out, 105), add(add(start, out, 55), aside, 22)].forEach(grow);
      const [nx, ny] = this.place(i ? phi : 0, 44);
      attr(this.nipText[i], { x: nx, y: ny + 3 });
      this.nipText[i].textContent = i ? "exit nip" : "entry nip";
      return { start, out, middle };
    });
    const pad = 4, tall = box[3] - box[1], wide = Math.max(box[2] - box[0], 260);
    this.svg.setAttribute("viewBox", [box[0] - pad - (wide - box[2] + box[0]) / 2, box[1] - pad, wide + 2 * pad, tall + 2 * pad].map(fixed).join(" "));
  }
  at(theta) {
    const [a, b] = [this.place(theta, SHELL - 34), this.place(theta, BELT + 6)];
    this.hand.setAttribute("d", `M${a}L${b}`);
  }
}
const add = ([x, y], [u, v], f) => [fixed(x + f * u), fixed(y + f * v)];
const poly = (points) => "M" + points.map(([x, y]) => `${fixed(x)} ${fixed(y)}`).join("L");

/** The colour scale of the pulley: made once, then only its words change. */
export function scale(box, label, most) {
  const w = 260;
  if (!box.firstChild) put(box, s("svg", { viewBox: `0 0 ${w} 40`, width: w, height: 40, "aria-hidden": "true" },
    Array.from({ length: 52 }, (_, i) => s("rect", { x: 4 + i * 4.85, y: 1, width: 5, height: 10, fill: warm((0.92 * (i + 0.5)) / 52) })),
    [0, 0.5, 1].map((f) => s("text", { x: 4 + f * 252, y: 22, class: f ? (f === 1 ? "ty" : "tx") : "tr" })), s("text", { x: w / 2, y: 36, class: "al" })));
  [digits(0), digits(most / 2, 3), digits(most, 3), label].forEach((text, i) => (box.firstChild.children[52 + i].textContent = text));
}

/** Creep by source, a bar for each method. bars: [{label, parts: [shrinkage, compression, global]}] */
export function budget(box, w, bars, limit, unitText, told) {
  const left = bars.length > 1 ? 96 : 12, right = 14, row = 34, ht = 8 + row * bars.length + 38, id = `b${++ids}`;
  const ends = bars.map((b) => [b.parts.filter((v) => v < 0).reduce((a, v) => a + v, 0), b.parts.filter((v) => v > 0).reduce((a, v) => a + v, 0)]);
  let lo = Math.min(0, ...ends.map((e) => e[0])), hi = Math.max(0, ...ends.map((e) => e[1]));
  const near = Math.abs(limit) < 2.5 * Math.max(hi, -lo);
  if (near) { lo = Math.min(lo, limit * 1.04); hi = Math.max(hi, limit * 1.04); }
  if (hi === lo) hi = 1e-3;
  const X = (v) => left + ((v - lo) / (hi - lo)) * (w - left - right), step = nice(hi - lo, w < 420 ? 5 : 8);
  const fills = ["", `url(#${id}x)`, `url(#${id}d)`];
  const base = 8 + row * bars.length;
  put(box, s("svg", { class: "chart", width: w, height: ht, viewBox: `0 0 ${w} ${ht}`, role: "img", "aria-label": told },
    hatches(id),
    ticksOf(lo, hi, step).flatMap((v) => [s("path", { d: `M${X(v)} 4V${base}`, class: v ? "grid" : "zero" }), s("text", { x: X(v), y: base + 14, class: "tx" }, trim(v))]),
    bars.flatMap((b, i) => {
      let up = 0, down = 0;
      return [bars.length > 1 && s("text", { x: left - 6, y: 8 + row * i + row / 2 + 3, class: "ty" }, b.label),
        b.parts.map((v, k) => {
          const a = v < 0 ? (down += v) : up;
          if (v > 0) up += v;
          return s("rect", { x: X(a), y: 11 + row * i, width: Math.max(0, X(a + Math.abs(v)) - X(a)), height: row - 8, class: `part ${k ? "" : "f-blue"}`, ...(k ? { fill: fills[k] } : {}) });
        })];
    }),
    near && s("path", { d: `M${X(limit)} 2V${base}`, class: "limit" }),
    s("text", { x: (left + w - right) / 2, y: ht - 5, class: "al" }, `Creep at exit [${unitText}]${near ? "; dotted: the creep limit" : ""}`)));
}
/** A small sample of a budget part, for its legend. */
export const swatch = (k) => {
  const id = `s${++ids}`;
  return s("svg", { width: 18, height: 12, "aria-hidden": "true" }, hatches(id), s("rect", { width: 18, height: 12, class: k ? "" : "f-blue", fill: ["", `url(#${id}x)`, `url(#${id}d)`][k] }));
};
