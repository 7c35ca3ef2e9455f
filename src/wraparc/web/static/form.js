// Fields, made from the schema of the drive file.
import { app, h, $, put, get, edit, change, set, on, split, si, unit, factor, trim, written, sign } from "./core.js";

const all = new Set(); // fields on the pages; several may show one place of the document
let typing = null;
const TENSIONS = ["entry_tension", "exit_tension", "effective_tension", "power", "torque"];
const PAIRS = [[0, 1], [0, 2], [1, 2], [0, 3], [1, 3], [0, 4], [1, 4]];
const id = (path, page) => `${page}-` + path.join("-").replace(/[^\w-]/g, "_");
export const section = (key) => app.form.sections.find((x) => x.key === key) || { fields: [] };
export const field = (sectionKey, key) => section(sectionKey).fields.find((f) => f.key === key);

/** Forget the fields inside an element, before it is filled anew. */
export const forget = (box) => all.forEach((f) => box.contains(f.row) && all.delete(f));

/** A slider of 400 places between two values, even or in equal ratios; numbers come out round. */
function places(range, f, now) {
  const lo = Math.min(range.least / f, now), hi = Math.max(range.most / f, now), log = range.log && lo > 0;
  const p = 10 ** Math.floor(Math.log10((hi - lo) / 400)), step = [1, 2, 5, 10].map((m) => m * p).find((v) => v >= ((hi - lo) / 400) * 0.999);
  return log
    ? { at: (v) => (400 * Math.log(v / lo)) / Math.log(hi / lo), value: (k) => trim(lo * (hi / lo) ** (k / 400), 3), most: 400 }
    : { at: (v) => v / step, value: (k) => trim(k * step, 6), least: Math.floor(lo / step), most: Math.ceil(hi / step) };
}

class Field {
  constructor(spec, path, { label, options, placeholder, slider, page = "f" } = {}) {
    Object.assign(this, { spec, path, key: path.join(), placeholder, unit: "" });
    const at = (this.id = id(path, page)), name = label || spec.title;
    const described = `${at}-h ${at}-e`;
    if (spec.kind === "flag") {
      this.input = h("select", { id: at, "aria-describedby": described }, h("option", { value: "" }, "as by default"), h("option", { value: "true" }, "yes"), h("option", { value: "false" }, "no"));
    } else if (options || spec.options?.length) {
      this.input = h("select", { id: at, "aria-describedby": described });
      this.fill(options || [["", ""], ...spec.options.map((o) => [o, o])]);
    } else if (/description/.test(spec.key)) this.input = h("textarea", { id: at, rows: 2, "aria-describedby": described });
    else {
      const measured = spec.kind === "quantity" || spec.kind === "number";
      this.input = h("input", { id: at, type: "text", autocomplete: "off", spellcheck: false, inputmode: measured && !spec.word ? "decimal" : "text", "aria-describedby": described, "aria-required": spec.required ? "true" : null });
    }
    this.suffix = h("span", { class: "unit", id: `${at}-u` });
    this.help = h("p", { class: "help", id: `${at}-h`, hidden: true }, [spec.help, this.allowed(), spec.word && `Or the word "${spec.word}".`, spec.default && `${spec.default} if left empty.`].filter(Boolean).join(" "));
    this.error = h("p", { class: "error", id: `${at}-e` });
    const q = h("button", { type: "button", class: "q", "aria-label": `Help: ${name}`, "aria-expanded": "false", "aria-controls": `${at}-h`, onclick: () => { this.help.hidden = !this.help.hidden; q.setAttribute("aria-expanded", String(!this.help.hidden)); } }, "?");
    this.row = h("div", { class: `field${options && !spec.dimension ? " wide" : /description/.test(spec.key) ? " tall" : ""}` },
      h("label", { for: at }, name, spec.symbol && h("span", { class: "sym" }, " ", sign(spec.symbol))), q,
      h("span", { class: "box" }, this.input, this.suffix));
    if (spec.slider && slider !== false) this.row.append((this.slider = h("input", { type: "range", "aria-label": `${name}, slider`, tabindex: 0 })));
    this.row.append(this.help, this.error);
    this.input.addEventListener("input", () => { typing = this.input; this.take(this.input.value); });
    const done = () => { if (typing === this.input) typing = null; this.show(); };
    this.input.addEventListener("change", done);
    this.input.addEventListener("blur", done);
    this.slider?.addEventListener("input", () => { typing = this.slider; this.put(`${this.scale.value(+this.slider.value)} ${this.sliderUnit}`.trim()); });
    this.slider?.addEventListener("change", () => { typing = null; this.show(); });
    all.add(this);
    this.show();
  }
  fill(options) { put(this.input, options.map(([value, text, group]) => h("option", { value }, text || value || "–"))); }
  allowed() {
    const { spec } = this;
    if (!spec.dimension || spec.allowed == null) return "";
    const [u, f] = unit(spec.dimension), end = (v) => `${trim(v / f, 4)} ${u}`.trim();
    const both = [spec.least != null && spec.least > 0 && `from ${end(spec.least)}`, spec.most != null && `to ${end(spec.most)}`].filter(Boolean).join(" ");
    return both && app.units === "us" ? `Allowed: ${both}.` : `Allowed: ${spec.allowed}.`;
  }
  value() { return get(app.doc, this.path); }
  put(value) { edit(this.path, value); }
  take(text) {
    const { spec } = this, t = text.trim();
    if (spec.kind === "flag") return this.put(t === "" ? undefined : t === "true");
    if (t === "") return this.put(undefined);
    if (spec.kind !== "quantity" || !spec.dimension || spec.dimension === "number") return this.put(spec.kind === "number" && split(t) && !split(t).unit ? +t : text);
    const bare = !/[a-z%°"'µ]/i.test(t.replace(/\de[-+]?\d+/i, "0"));
    this.put(bare ? `${t} ${this.unit || unit(spec.dimension)[0]}`.trim() : t);
  }
  /** Put the document's value on the page, unless somebody is just typing there. */
  show() {
    const { spec } = this, value = (this.seen = this.value());
    if (spec.kind === "flag") { this.input.value = value == null ? "" : String(value); return; }
    let text = value == null ? "" : String(value), u = spec.dimension ? unit(spec.dimension)[0] : "";
    if (spec.dimension && text) {
      const q = split(text), known = this.unit && text.endsWith(` ${this.unit}`);
      if (q && factor(q.unit, spec.dimension) != null) [text, u] = [q.written, q.unit];
      else if (known) [text, u] = [text.slice(0, -this.unit.length - 1), this.unit];
      else u = "";
    }
    if (typing !== this.input) {
      this.unit = u;
      if (this.input.value !== text) this.input.value = text;
      this.suffix.textContent = u;
      this.input.placeholder !== undefined && (this.input.placeholder = this.empty().replace(` ${u}`, ""));
    }
    if (this.slider && typing !== this.slider) this.slide(value);
  }
  /** What holds while the field is empty. */
  empty() { return this.placeholder?.() || this.spec.word || this.spec.default || ""; }
  slide(value) {
    const { spec, slider } = this;
    value ??= this.empty();
    const v = si(value, spec.dimension);
    slider.disabled = Number.isNaN(v);
    if (slider.disabled) return;
    const q = split(value);
    this.scale = places(spec.slider, factor(q.unit, spec.dimension), q.number);
    [slider.min, slider.max, slider.step] = [this.scale.least || 0, this.scale.most, 1];
    slider.value = Math.round(this.scale.at(q.number));
    this.sliderUnit = q.unit;
    slider.setAttribute("aria-valuetext", value);
  }
  mark(problem) {
    if (!problem && !this.wrong) return;
    this.wrong = problem;
    this.row.classList.toggle("wrong", !!problem);
    this.input.setAttribute("aria-invalid", problem ? "true" : "false");
    this.error.textContent = problem ? problem.sentence || problem.message : "";
    if (problem) for (let e = this.row.parentElement; e; e = e.parentElement) if (e.tagName === "DETAILS") e.open = true;
  }
}

/** Path as the server tells it, to the place in the document. */
export function place(text) {
  const keys = [];
  let node = app.doc;
  for (const m of (text || "").matchAll(/"((?:[^"\\]|\\.)*)"|\[(\d+)\]|([^.[\]"]+)/g)) {
    let key = m[2] ? +m[2] - 1 : m[1] ?? m[3];
    if (Array.isArray(node) && typeof key === "string") key = Math.max(0, node.findIndex((n) => n?.name === key));
    keys.push(key);
    node = node?.[key];
  }
  return keys;
}
/** Mark the fields that problems name; what has no field is returned. */
export function mark(problems) {
  const found = new Map(), rest = [], has = (k) => [...all].some((f) => f.key === k);
  for (const p of problems) {
    const keys = place(p.path);
    let k = keys.join();
    if (!has(k) && keys[0] === "pulley" && keys.length === 2) { // tensions that contradict each other
      const said = TENSIONS.filter((t) => get(app.doc, [...keys, t]) != null);
      if (said.length) k = [...keys, said[said.length - 1]].join();
    }
    if (has(k)) found.set(k, p); else rest.push(p);
  }
  all.forEach((f) => f.mark(found.get(f.key)));
  return rest;
}
export const refresh = () => all.forEach((f) => f.value() !== f.seen && f.show());
export const release = () => (typing = null);
export const make = (spec, path, more) => new Field(spec, path, more).row;

const more = (name, rows, open) => rows.length > 0 && h("details", { class: "more", open }, h("summary", {}, name), rows);
const presetValue = (key) => () => {
  const b = app.catalogue.belts.find((x) => x.name === app.doc.belt?.preset);
  return b?.[key]?.[app.units] || "";
};

function belt() {
  const fields = section("belt").fields.filter((f) => !["preset", "table"].includes(f.key) && f.kind !== "table" && f.kind !== "belt");
  const kinds = [...new Set(app.catalogue.belts.map((b) => b.kind))];
  const spec = field("belt", "preset");
  const preset = new Field(spec, ["belt", "preset"], { label: "Belt", options: [["", "own values"]] });
  put(preset.input, h("option", { value: "" }, "own values"), kinds.map((k) => h("optgroup", { label: k || "other" }, app.catalogue.belts.filter((b) => b.kind === k).map((b) => h("option", { value: b.name }, b.name)))));
  preset.put = (name) => {
    // a preset brings its own numbers: those typed over the last one would silently stay
    const { modulus, rating, least_pulley_diameter, name: n, kind, sources, provenance, ...kept } = app.doc.belt || {};
    const own = app.catalogue.belts.find((b) => b.name === app.doc.belt?.preset);
    change(set(app.doc, ["belt"], name ? { preset: name, ...kept, preset: name } : { ...kept, preset: undefined, modulus: modulus || own?.modulus?.[app.units] || "" }));
  };
  preset.show();
  const row = (f) => make(f, ["belt", f.key], { placeholder: presetValue(f.key) });
  const main = fields.filter((f) => ["width", "speed", "modulus"].includes(f.key));
  return h("fieldset", {}, h("legend", {}, "Belt"), preset.row, main.map(row), more("More of the belt", fields.filter((f) => !main.includes(f)).map(row)));
}

export const laggingName = (l) => (typeof l === "object" && l ? l.preset || l.name || "" : l || "");
function lagging(i) {
  const at = ["pulley", i, "lagging"], spec = field("pulley", "lagging");
  const own = Object.keys(app.doc.lagging || {});
  const f = new Field(spec, at, { label: "Lagging", options: [["", "choose"]] });
  const list = app.catalogue.laggings.map((l) => h("option", { value: l.name }, `${l.title || l.name}`));
  const now = laggingName(get(app.doc, at));
  const known = own.includes(now) || app.catalogue.laggings.some((l) => l.name === now);
  put(f.input, !known && h("option", { value: now }, now || "choose"), own.length > 0 && h("optgroup", { label: "of this design" }, own.map((n) => h("option", { value: n }, app.doc.lagging[n].title || n))), h("optgroup", { label: "catalogue" }, list));
  f.value = () => laggingName(get(app.doc, at));
  f.put = (name) => change(set(set(app.doc, at, name), ["pulley", i, "condition"], undefined));
  f.show();
  const l = app.catalogue.laggings.find((x) => x.name === now);
  const part = (key) => section("lagging").fields.find((x) => x.key === key);
  const rows = ["thickness", "shear_modulus", "compression_modulus"].filter(part).map((key) => {
    const g = new Field(part(key), [...at, key], { slider: key === "thickness" ? undefined : false, placeholder: () => l?.[key]?.[app.units] || "" });
    g.value = () => { const v = get(app.doc, at); return typeof v === "object" && v ? v[key] : undefined; };
    g.put = (value) => {
      const v = get(app.doc, at), next = { ...(typeof v === "object" && v ? v : { preset: v }), [key]: value };
      if (value === undefined) delete next[key];
      edit(at, Object.keys(next).join() === "preset" ? next.preset : next);
    };
    g.show();
    return g.row;
  });
  const conditions = l?.conditions || [...new Set(Object.keys(app.doc.lagging?.[now]?.condition || {}))];
  if (conditions.length > 1) rows.unshift(make(field("pulley", "condition"), ["pulley", i, "condition"], { options: [["", conditions[0]], ...conditions.slice(1).map((c) => [c, c])] }));
  const kind = l ? l.kind : "";
  return [f.row, kind && h("p", { class: "origin" }, h("span", { class: `mark ${kind}` }, kind), ` ${l.source || ""}`), more("Lagging in detail", rows, typeof get(app.doc, at) === "object")];
}

/** Which two of tension, pull, power and torque are given. */
function tensions(i) {
  const p = app.doc.pulley[i] || {}, given = TENSIONS.filter((t) => p[t] !== undefined);
  if (app.doc.train && !given.length) return h("p", { class: "help" }, "The train gives the tensions: see the page Train.");
  let pair = PAIRS.find((x) => given.length === 2 && x.every((k) => given.includes(TENSIONS[k])));
  const spec = (k) => field("tensions", TENSIONS[k]) || field("pulley", TENSIONS[k]);
  const shownKeys = pair || [...new Set([0, 1, ...given.map((g) => TENSIONS.indexOf(g))])];
  pair ||= [0, 1];
  const pick = h("select", { id: `pair-${i}`, onchange: () => {
    const want = PAIRS[+pick.value].map((k) => TENSIONS[k]), n = tensions.now?.(i) || {}, next = { ...p };
    for (const t of TENSIONS) if (!want.includes(t)) delete next[t];
    for (const t of want) if (next[t] == null) next[t] = n[t] == null || Number.isNaN(n[t]) ? "" : written(n[t], spec(TENSIONS.indexOf(t)).dimension, 5);
    change(set(app.doc, ["pulley", i], next));
  } }, PAIRS.map((x, k) => h("option", { value: k, selected: x === pair }, x.map((j) => spec(j).symbol || spec(j).title).join(" and "))));
  return [h("div", { class: "field" }, h("label", { for: `pair-${i}` }, "Load given by"), h("span"), h("span", { class: "box" }, pick)), shownKeys.map((k) => make(spec(k), ["pulley", i, TENSIONS[k]]))];
}
/** Numbers of the last solve, to change what is given without changing the load. */
export const knowNow = (f) => (tensions.now = f);

function pulley(i) {
  const skip = ["lagging", "condition", ...TENSIONS], fields = section("pulley").fields.filter((f) => !skip.includes(f.key) && f.kind !== "table");
  const row = (f) => make(f, ["pulley", i, f.key]);
  const main = fields.filter((f) => ["diameter", "wrap_angle"].includes(f.key)), name = app.doc.pulley[i]?.name;
  return h("fieldset", {}, h("legend", {}, `Pulley ${name || i + 1}`), main.map(row), lagging(i), tensions(i), more("More of the pulley", fields.filter((f) => !main.includes(f)).map(row)));
}

function cases() {
  const list = app.doc.load_case || [], p = app.doc.pulley[app.pulley], names = section("load_case").fields.filter((f) => ["name", "description"].includes(f.key));
  const path = (i) => ["load_case", i, "pulley", p?.name];
  return h("fieldset", {}, h("legend", {}, "Load cases"),
    h("p", { class: "help" }, 'The tensions above are the case "design". Others replace what they name.'),
    list.map((c, i) => more(c.name || `case ${i + 1}`, [
      names.map((f) => make(f, ["load_case", i, f.key])),
      !app.doc.train && TENSIONS.map((t) => make(field("tensions", t), [...path(i), t], { slider: false, placeholder: () => "" })),
      h("button", { type: "button", onclick: () => edit(["load_case"], list.length > 1 ? list.filter((_, k) => k !== i) : undefined) }, "Remove this case")])),
    h("button", { type: "button", onclick: () => edit(["load_case"], [...list, { name: `case ${list.length + 2}`, ...(app.doc.train ? { train: {} } : { pulley: { [p.name]: {} } }) }]) }, "Add a load case"));
}

let built = "";
/** The form of the drive page; built anew only when its structure changed. */
export function form(box, force) {
  const d = app.doc, keys = (o) => Object.keys(o || {}).filter((k) => TENSIONS.includes(k)).join();
  const now = JSON.stringify([app.units, app.pulley, d.belt?.preset, d.pulley?.map((p) => [p.name, keys(p), laggingName(p.lagging), typeof p.lagging]), d.load_case?.map((c) => c.name), Object.keys(d.lagging || {}), !!d.train]);
  if (now === built && !force) return refresh();
  const active = document.activeElement?.id, open = [...box.querySelectorAll("details[open] > summary")].map((x) => x.textContent);
  const cursor = active && $(active)?.selectionStart;
  built = now;
  if (typing && box.contains(typing) && typing.tagName !== "SELECT" && d.pulley?.[app.pulley] && box.dataset.names === "typing") return refresh();
  forget(box);
  const i = Math.min(app.pulley, (d.pulley?.length || 1) - 1), drive = section("drive").fields.filter((f) => ["title", "description", "creep_limit"].includes(f.key));
  put(box, belt(), pulley(i), cases(), h("fieldset", {}, h("legend", {}, "Drive"), drive.map((f) => make(f, [f.key]))));
  box.querySelectorAll("details").forEach((x) => { if (open.includes(x.firstChild.textContent)) x.open = true; });
  const back = active && $(active);
  if (back && document.activeElement !== back) { back.focus({ preventScroll: true }); if (cursor != null && back.setSelectionRange && back.type === "text") back.setSelectionRange(cursor, cursor); }
}
on("units", () => (built = ""));
