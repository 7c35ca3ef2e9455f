// The same drive with every lagging, or with several belts.
import { app, h, put, on, tell, ask, act, later, change, set, note } from "./core.js";
import { place } from "./form.js";
import { words, badge } from "./drive.js";

let ui, answer = null, done = null, sort = ["", 1];
const pinned = new Set(), open = { what: "laggings", years: 10, hours: 6000, tariff: "", currency: "" };

export function mount(box) {
  const number = (id, label, width = 6) => h("label", {}, label, h("input", { type: "text", inputmode: "decimal", size: width, value: String(open[id]), onchange: (e) => { open[id] = e.target.value; load(true); } }));
  const what = h("fieldset", { class: "switch" }, h("legend", { class: "away" }, "What to compare"), ["laggings", "belts"].map((w) => h("label", {}, h("input", { type: "radio", name: "what", value: w, checked: w === open.what, onchange: () => { open.what = w; sort = ["", 1]; pinned.clear(); load(true); } }), h("span", {}, w === "laggings" ? "Laggings" : "Belts"))));
  ui = { said: h("p", { class: "help", role: "status" }), table: h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Comparison" }), remarks: h("ul", { class: "help" }), pick: h("span", { class: "inline" }) };
  box.append(h("p", { class: "help" }, "The drive of the first page, everything else unchanged. Press a heading to sort, a pin to keep a row on top."),
    h("div", { class: "bar" }, what, ui.pick, number("years", "Years", 3), number("hours", "Hours a year"), number("tariff", "Price of a kWh"), number("currency", "Currency", 5)),
    ui.said, h("div", { class: "card" }, ui.table), ui.remarks);
}
export const update = () => load();
on("units", () => answer && ui && draw());
const load = later(150, act(async (force) => {
  if (!force && done === app.doc) return;
  const doc = app.doc, n = (v) => (v === "" || v == null ? undefined : Number.isFinite(+v) ? +v : v);
  ui.said.textContent = "Solving …";
  try {
    const a = await ask("compare", { document: doc, pulley: doc.pulley?.[app.pulley]?.name ?? null, load_case: app.case || null, what: open.what, years: n(open.years), hours: n(open.hours), tariff: n(open.tariff), currency: open.currency || undefined });
    if (doc !== app.doc) return load(true);
    answer = a; done = doc;
    ui.said.textContent = `Pulley ${a.pulley}, load case ${a.load_case}; ${a.rows.length} ${open.what}. Costs over ${a.years} years${a.currency ? ` in ${a.currency}` : ""}.`;
    draw();
  } catch (x) { ui.said.textContent = ""; put(ui.table, h("ul", { class: "verdict bad" }, (x.problems || [x]).map((p) => h("li", {}, p.sentence || p.message)))); }
}));
const label = (r) => (open.what === "belts" ? `${r.name}${r.title ? `, ${r.title}` : ""}` : r.title || r.name);
function use(row) {
  let doc = app.doc;
  for (const c of row.change) doc = set(doc, place(c.path), c.value ?? undefined);
  change(doc);
  note(`${label(row)} is in the drive now; Undo takes it out again.`);
}
function draw() {
  const { rows } = answer, [key, way] = sort, columns = answer.columns.filter((c) => c.key !== "outside" && rows.some((r) => r.cells[c.key]?.value != null));
  const value = (r, k) => (k === "name" ? label(r) : r.cells[k]?.value);
  const ordered = [...rows].sort((a, b) => {
    const pin = pinned.has(b.name) - pinned.has(a.name);
    if (pin || !key) return pin;
    const [x, y] = [value(a, key), value(b, key)];
    return x == null ? 1 : y == null ? -1 : (typeof x === "string" ? x.localeCompare(y) : x - y) * way;
  });
  const best = Object.fromEntries(columns.map((c) => {
    const all = rows.map((r) => r.cells[c.key]?.value).filter((v) => v != null);
    return [c.key, c.better && all.length > 1 ? (c.better === "low" ? Math.min(...all) : Math.max(...all)) : NaN];
  }));
  const head = (k, text, cls) => h("th", { scope: "col", class: cls, "aria-sort": key === k ? (way > 0 ? "ascending" : "descending") : "none" }, h("button", { type: "button", id: `sort-${k}`, onclick: () => { sort = [k, key === k ? -way : 1]; draw(); document.getElementById(`sort-${k}`).focus(); } }, text, key === k ? (way > 0 ? " ▲" : " ▼") : ""));
  put(ui.table, h("table", { class: "grid-table" }, h("thead", {}, h("tr", {}, h("td"), head("name", open.what === "belts" ? "Belt" : "Lagging"), h("th", { scope: "col" }, "Answer"), columns.map((c) => head(c.key, c.title, "num")), h("th", { scope: "col" }, "Data"), h("td"))),
    h("tbody", {}, ordered.map((r) => h("tr", { class: `${pinned.has(r.name) ? "pinned" : ""} ${r.present ? "present" : ""}` },
      h("td", {}, h("button", { type: "button", "aria-pressed": String(pinned.has(r.name)), "aria-label": `Pin ${label(r)}`, onclick: () => { pinned.has(r.name) ? pinned.delete(r.name) : pinned.add(r.name); draw(); } }, pinned.has(r.name) ? "★" : "☆")),
      h("th", { scope: "row" }, label(r), r.condition && r.condition !== "dry" ? `, ${r.condition}` : "", r.present && " (present)"),
      h("td", {}, badge(r.level), " ", r.short),
      columns.map((c) => h("td", { class: "num" }, r.cells[c.key]?.value != null && r.cells[c.key].value === best[c.key] ? h("strong", {}, words(r.cells[c.key]), h("span", { class: "away" }, " (best)")) : words(r.cells[c.key]) || "–")),
      h("td", {}, r.kind && h("span", { class: `mark ${r.kind}`, title: r.source }, r.kind), r.cells.outside?.value > 0 && h("span", { class: "mark outside" }, `outside tested range ${words(r.cells.outside)}`)),
      h("td", {}, !r.present && r.change && h("button", { type: "button", "aria-label": `Use ${label(r)}`, onclick: () => use(r) }, "Use")))))));
  put(ui.remarks, (answer.remarks || []).map((r) => h("li", {}, words(r))), [...new Set(rows.map((r) => words(r.cost_note)).filter(Boolean))].map((t) => h("li", {}, t)),
    (answer.not_possible || []).map((r) => h("li", {}, `${r.name}: ${r.problems.map((p) => p.sentence || p.message).join(" ")}`)));
}
