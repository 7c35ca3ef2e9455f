// The frame of the calculator: pages, file, undo, the address.
import { app, h, $, put, on, tell, ask, act, note, change, undo, redo, can, converted, packed, unpacked, save, later } from "./core.js";
import { release, knowNow } from "./form.js";
import * as drive from "./drive.js";

const PAGES = { drive: "Drive", compare: "Compare", tests: "Tests", train: "Train", study: "Study", saved: "Saved" };
const modules = { drive }, places = {};
let page = "drive", link = "";

async function open(name) {
  page = PAGES[name] ? name : "drive";
  for (const a of $("nav").children) a.toggleAttribute("aria-current", false);
  $(`nav-${page}`).setAttribute("aria-current", "page");
  document.title = `${PAGES[page]} – wraparc`;
  for (const [k, e] of Object.entries(places)) e.hidden = k !== page;
  if (!modules[page]) modules[page] = await import(`./${page}.js`);
  if (!places[page].firstChild) { put(places[page], h("h1", {}, PAGES[page])); modules[page].mount(places[page]); }
  modules[page].update();
}
const address = later(250, async () => {
  const view = { d: app.doc, u: app.units, p: app.pulley, c: app.case, s: app.design && { ...app.design, saved: undefined } };
  link = `#/${page}/${await packed(view)}`;
  history.replaceState(null, "", link);
});
async function arrive() {
  const [, name, state] = location.hash.split("/");
  if (state && location.hash !== link) {
    try {
      const view = await unpacked(state);
      if (!view.d || typeof view.d !== "object") throw new Error();
      Object.assign(app, { units: view.u === "us" ? "us" : "si", pulley: view.p | 0, case: String(view.c || ""), design: view.s || null });
      switchTo(app.units);
      change(view.d);
    } catch { note("The link holds no design that can be read: it may have been cut short.", true); }
  }
  if (app.doc) { await open(name || "drive"); address(); }
}
function switchTo(units) {
  document.querySelector(`input[name=units][value=${units}]`).checked = true;
  document.documentElement.dataset.units = units;
}
/** Take a design in, whole. */
export function take(doc, { name = "", design = null } = {}) {
  Object.assign(app, { pulley: 0, case: "", name, design, units: /(in|ft)$/.test(doc.belt?.width || "") ? "us" : "si" });
  switchTo(app.units);
  tell("units");
  release();
  change(doc);
}
on("go", (name) => { location.hash = `#/${name}`; });
on("take", take);

const choose = (accept, f) => {
  const i = h("input", { type: "file", accept });
  i.addEventListener("change", act(async () => i.files[0] && f(i.files[0])));
  i.click();
};
async function openFile(file) {
  const text = await file.text(), stem = file.name.replace(/\.[^.]*$/, "");
  if (file.size > 2e6) throw new Error(`${file.name} is larger than 2 MB: no drive file.`);
  if (/^\s*\[?law\b|^\s*\[law/m.test(text) && !/^\s*\[belt/m.test(text)) {
    const { name, lagging } = await ask("lagging/read", { toml: text });
    const pulley = app.doc.pulley.map((p, i) => (i === app.pulley ? { ...p, lagging: name } : p));
    change({ ...app.doc, lagging: { ...app.doc.lagging, [name]: lagging }, pulley });
    return note(`The lagging ${name} is on the pulley now.`);
  }
  const r = await ask("toml/read", { toml: text, name: file.name });
  take(r.document, { name: stem });
  note(`Opened ${file.name}.`);
}
const fileName = () => (app.doc.title || app.name || "drive").toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "") || "drive";
async function download() {
  const r = await ask("toml/write", { document: app.doc });
  save(r.name || `${fileName()}.toml`, r.toml, "application/toml");
}
const HEAD = { project: "Project", number: "Number", revision: "Revision", author: "Author" };
async function report(kind) {
  const head = Object.fromEntries(Object.keys(HEAD).map((k) => [k, $(`head-${k}`).value.trim()]).filter(([, v]) => v));
  const r = await ask(`report/${kind}`, { document: app.doc, units: app.units, name: fileName(), head: { ...head, paper: $("head-paper").value } }, { as: "blob" });
  const said = /filename="?([^";]+)/.exec(r.headers.get("Content-Disposition") || "");
  save(said?.[1] || `${fileName()}.${kind}`, await r.blob());
}
function menus() {
  const item = (text, f) => h("button", { type: "button", onclick: (e) => { e.currentTarget.closest("details").open = false; act(f)(e); } }, text);
  put($("file-menu"),
    item("Open a drive or lagging file …", () => choose(".toml", openFile)),
    item("Download the drive file", download),
    item("Save in the database …", () => tell("go", "saved")),
    item("Copy a link to this design", async () => { await navigator.clipboard.writeText(location.href); note("The link is on the clipboard; it holds the whole design."); }),
    item("Print", () => window.print()),
    h("p", { class: "help" }, "Examples"),
    app.catalogue.examples.map((x) => item(x.title, async () => take((await ask(`examples/${x.name}`)).document, { name: x.name }))));
  put($("report-menu"), h("div", { class: "stack pad" }, Object.entries(HEAD).map(([k, label]) => h("label", {}, label, h("input", { type: "text", id: `head-${k}`, maxlength: 120, autocomplete: "off" }))),
    h("label", {}, "Paper", h("select", { id: "head-paper" }, h("option", { value: "a4" }, "A4"), h("option", { value: "us-letter" }, "US Letter")))), [["pdf", "Calculation note (PDF)"], ["xlsx", "Workbook (Excel)"], ["md", "Text (Markdown)"]].map(([k, t]) => item(t, () => report(k))));
  document.addEventListener("click", (e) => document.querySelectorAll(".menu[open]").forEach((m) => { if (!m.contains(e.target)) m.open = false; }));
}
function keys(e) {
  if (e.key === "Escape") document.querySelectorAll(".menu[open]").forEach((m) => { m.open = false; m.firstElementChild.focus(); });
  if (!(e.ctrlKey || e.metaKey) || e.altKey) return;
  const k = e.key.toLowerCase();
  if (k === "s") { e.preventDefault(); act(download)(e); }
  if (e.target.closest?.("#saved, #tests, #study, #compare, .menu") && e.target.matches("input, textarea")) return; // its own undo
  if (k === "z" || k === "y") { e.preventDefault(); release(); (k === "y" || e.shiftKey ? redo : undo)(); }
}
async function start() {
  const [form, catalogue, first, about] = await Promise.all(["schema", "catalogue", "start", "about"].map((p) => ask(p)));
  Object.assign(app, { form, catalogue, about, dimensions: {}, name: first.name });
  for (const u of Object.values(form.units)) u.factors ||= { [u.si.unit]: u.si.factor, [u.us.unit]: u.us.factor };
  for (const part of form.sections) for (const f of part.fields) if (f.dimension) app.dimensions[f.key] ||= f.dimension;
  for (const [name, title] of Object.entries(PAGES)) {
    $("nav").append(h("a", { id: `nav-${name}`, href: `#/${name}` }, title));
    $("main").append((places[name] = h("section", { id: name, hidden: true, "aria-label": title })));
  }
  $("wait").remove();
  put($("about"), `wraparc ${about.version}. Illustrative laggings describe no real product.`);
  menus();
  $("undo").onclick = () => { release(); undo(); };
  $("redo").onclick = () => { release(); redo(); };
  document.addEventListener("keydown", keys);
  document.querySelectorAll("input[name=units]").forEach((i) => i.addEventListener("change", () => {
    app.units = i.value;
    switchTo(i.value);
    tell("units");
    release();
    change(converted(app.doc, app.units), "units");
  }));
  on("doc", () => {
    const [u, r] = can();
    $("undo").disabled = !u; $("redo").disabled = !r;
    if (app.pulley >= (app.doc.pulley?.length || 1)) app.pulley = 0;
    modules[page]?.update && places[page].firstChild && modules[page].update();
    address();
  });
  on("view", () => { modules[page].update(); address(); });
  addEventListener("beforeprint", () => document.querySelectorAll("main details.table:not([open])").forEach((d) => { d.open = true; d.dataset.shut = ""; }));
  addEventListener("afterprint", () => document.querySelectorAll("[data-shut]").forEach((d) => { d.open = false; delete d.dataset.shut; }));
  knowNow(drive.now);
  window.addEventListener("hashchange", arrive);
  if (!location.hash.split("/")[2]) take(first.document, { name: first.name });
  await arrive();
  if (!app.doc) { take(first.document, { name: first.name }); await open("drive"); }
  [$("undo").disabled, $("redo").disabled] = can().map((v) => !v);
}
start().catch((e) => {
  console.error(e);
  put($("main"), h("p", { class: "verdict bad", role: "alert" }, e.status === 401 ? "This calculator asks for a token: open it with the link that the server printed (…/?token=…)." : e.message));
});
