// State of the page, words with the server, units, and the making of elements.

const SVG = "http://www.w3.org/2000/svg";
const fill = (e, attrs, kids) => {
  for (const [k, v] of Object.entries(attrs || {})) {
    if (v === false || v == null) continue;
    if (k.startsWith("on")) e.addEventListener(k.slice(2), v);
    else if (typeof v === "boolean" && k in e && !(e instanceof SVGElement)) e[k] = v;
    else e.setAttribute(k, v === true ? "" : v);
  }
  e.append(...kids.flat(9).filter((k) => k != null && k !== false));
  return e;
};
export const h = (tag, attrs, ...kids) => fill(document.createElement(tag), attrs, kids);
export const s = (tag, attrs, ...kids) => fill(document.createElementNS(SVG, tag), attrs, kids);
export const $ = (id) => document.getElementById(id);
export const put = (e, ...kids) => (e.replaceChildren(...kids.flat(9).filter((k) => k != null && k !== false)), e);
export const later = (wait, f) => {
  let t;
  return (...a) => (clearTimeout(t), (t = setTimeout(f, wait, ...a)));
};

// --- the design: one document, the parsed drive file; every change makes a new one
export const app = { doc: null, units: "si", form: null, pulley: 0, case: "", design: null };
const past = [], future = [], heard = {};
let lastKey = "", lastTime = 0;
export const on = (what, f) => (heard[what] ||= []).push(f);
export const tell = (what, ...a) => (heard[what] || []).forEach((f) => f(...a));

export const get = (o, path) => path.reduce((v, k) => v?.[k], o);
export const set = (o, [key, ...rest], value) => {
  const c = Array.isArray(o) ? [...o] : { ...o };
  if (rest.length) c[key] = set(c[key] ?? (typeof rest[0] === "number" ? [] : {}), rest, value);
  else if (value !== undefined) c[key] = value;
  else if (Array.isArray(c)) c.splice(key, 1);
  else delete c[key];
  return c;
};
/** Put a document in the place of the present one; changes of one field within a second undo as one. */
export function change(doc, key = "") {
  const now = performance.now();
  if (app.doc && !(key && key === lastKey && now - lastTime < 1000)) past.push(app.doc);
  if (past.length > 300) past.shift();
  [lastKey, lastTime] = [key, now];
  future.length = 0;
  app.doc = doc;
  tell("doc");
}
export const edit = (path, value) => change(set(app.doc, path, value), path.join());
const step = (from, to) => {
  if (!from.length) return;
  to.push(app.doc);
  app.doc = from.pop();
  lastKey = "";
  tell("doc");
};
export const undo = () => step(past, future);
export const redo = () => step(future, past);
export const can = () => [past.length > 0, future.length > 0];

// --- words with the server
export class Refused extends Error {
  constructor(problems, status) {
    super(problems.map((p) => p.sentence || p.message).join("\n"));
    Object.assign(this, { problems, status });
  }
}
export async function ask(path, body, { method, signal, as = "json" } = {}) {
  const form = body instanceof FormData, text = typeof body === "string";
  const type = text ? "text/plain" : "application/json";
  let r;
  try {
    r = await fetch(`/api/v1/${path}`, {
      method: method || (body === undefined ? "GET" : "POST"),
      headers: body === undefined || form ? {} : { "Content-Type": type },
      body: form || text || body === undefined ? body : JSON.stringify(body),
      signal,
    });
  } catch (e) {
    if (e.name === "AbortError") throw e;
    throw new Refused([{ message: "The calculator does not answer: is `wraparc serve` still running?" }], 0);
  }
  if (r.ok) return as === "blob" ? r : r.status === 204 ? null : r[as]();
  let said = {};
  try { said = await r.json(); } catch { /* no JSON: the status must do */ }
  throw new Refused(said.problems || [{ message: said.detail || `The server answered ${r.status}.` }], r.status);
}
export function save(name, data, type = "text/plain") {
  const url = URL.createObjectURL(data instanceof Blob ? data : new Blob([data], { type }));
  h("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 9000);
}
export const note = (text, bad) => {
  const box = $("toast");
  box.className = bad ? "bad" : "";
  put(box, text);
  clearTimeout(note.timer);
  note.timer = setTimeout(() => put(box), bad ? 12000 : 5000);
};
/** Do something on a press; what goes wrong is told in words. */
export const act = (f) => async (e) => {
  const b = e?.currentTarget;
  b?.setAttribute?.("aria-busy", "true");
  try { await f(e); } catch (x) { if (x.name !== "AbortError") note(x.message, true); if (!(x instanceof Refused)) console.error(x); }
  b?.removeAttribute?.("aria-busy");
};

// --- numbers and units
/** A number with so many significant digits, plain where it fits; as the command line prints it. */
export function digits(v, n = 4) {
  if (v == null || Number.isNaN(v)) return "–";
  if (!Number.isFinite(v)) return "unbounded";
  if (v === 0) return "0";
  const r = +v.toExponential(n - 1), e = Math.floor(Math.log10(Math.abs(r)));
  if (e < -4 || e >= 12) return v.toExponential(n - 1);
  return (e < n ? r : v).toFixed(Math.max(0, n - 1 - e));
}
/** Unit of a dimension and its SI value, in the units shown. */
export const unit = (dim, system = app.units) => {
  const u = app.form.units[dim]?.[system];
  return u ? [u.unit, u.factor] : ["", 1];
};
export const factor = (name, dimension) => (app.form.units[dimension]?.factors || {})[name];
export const dim = (name) => app.form.glossary[name]?.dimension || "number";
export const title = (name) => app.form.glossary[name]?.title || name;
export const symbol = (name) => sign(app.form.glossary[name]?.symbol);
const GREEK = { phi: "φ", theta: "θ", tau: "τ", gamma: "γ", mu: "μ", eta: "η", omega: "ω" };
/** A symbol as equations print it: Greek letters, what follows an underscore set low. */
export function sign(text) {
  const [first, ...low] = (text || "").replace(/(phi|theta|tau|gamma|mu|omega|eta)(?![a-z])/g, (g) => GREEK[g]).split("_");
  return low.length ? [first, h("sub", {}, low.join(" "))] : [first];
}
// From which size on a larger unit reads better, as on the command line.
const LARGER = { si: { length: [10, "m"], pressure: [1e7, "MPa"] }, us: { length: [10.16, "ft"], force: [44482.2, "klbf"], pressure: [6.8948e7, "ksi"] } };
/** Value [SI] with the unit that people read it in. */
export function show(v, dimension, n = 4) {
  let [u, f] = unit(dimension);
  const big = LARGER[app.units][dimension];
  if (big && Math.abs(v) >= big[0] && factor(big[1], dimension)) [u, f] = [big[1], factor(big[1], dimension)];
  return v == null ? "–" : `${digits(v / f, n)} ${Number.isFinite(v) ? u : ""}`.trim();
}
export const shown = (name, v, n) => show(v, dim(name), n);
export const percent = (v, n = 3) => (v == null ? "–" : `${digits(100 * v, n)} %`);
const NUMBER = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(\S.*)?$/i;
/** Text of a quantity into its number and its unit, or null where it is none. */
export const split = (text) => {
  const m = NUMBER.exec(text ?? "");
  return m && { number: +m[1], written: m[1], unit: (m[2] || "").trim() };
};
export function si(text, dimension) {
  const q = split(text), f = q && factor(q.unit, dimension);
  return f == null ? NaN : q.number * f;
}
export const trim = (v, n = 6) => String(+(+v).toPrecision(n));
/** Value [SI] as a text for the drive file. */
export const written = (v, dimension, n = 6) => {
  const [u, f] = unit(dimension);
  return `${trim(v / f, n)} ${u}`.trim();
};
/** The document with every quantity that was typed in the units asked for; going back restores what was typed. */
const typed = new Map();
export function converted(node, system, key) {
  if (Array.isArray(node)) return node.map((n) => converted(n, system, key));
  if (node && typeof node === "object")
    return Object.fromEntries(Object.entries(node).map(([k, v]) => [k, k === "lagging" && !key ? v : converted(v, system, k)]));
  const d = app.dimensions[key], q = typeof node === "string" && d && split(node), value = q && si(node, d), [u, f] = unit(d, system);
  if (!q || !u || q.unit === u || Number.isNaN(value)) return node;
  const before = typed.get(node);
  if (before && split(before).unit === u) return before;
  const text = `${trim(value / f)} ${u}`;
  typed.set(text, node);
  return text;
}

// --- the design in the address
const b64 = (bytes) => btoa(Array.from(bytes, (b) => String.fromCharCode(b)).join("")).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
const through = async (bytes, stream) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
export const packed = async (value) =>
  b64(await through(new TextEncoder().encode(JSON.stringify(value)), new CompressionStream("deflate-raw")));
export async function unpacked(text) {
  const raw = Uint8Array.from(atob(text.replace(/-/g, "+").replace(/_/g, "/")), (c) => c.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await through(raw, new DecompressionStream("deflate-raw"))));
}
