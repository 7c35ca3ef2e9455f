// Designs kept in the database: names, notes, versions, who and when.
import { app, h, put, on, tell, ask, act, later, note } from "./core.js";

let ui, list = null;
const when = (t) => new Date(t).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });
const who = (v) => { try { return v === undefined ? localStorage.getItem("who") || "" : localStorage.setItem("who", v); } catch { return ""; } };

export function mount(box) {
  const input = (label, at, more = {}) => h("label", {}, label, (ui[at] = h("input", { type: "text", ...more })));
  ui = {};
  box.append(
    h("form", { class: "card", "aria-label": "Save the present design", onsubmit: (e) => { e.preventDefault(); } },
      h("h2", {}, "Save the present design"),
      h("div", { class: "bar" }, input("Name", "name", { maxlength: 120, required: true, size: 28 }), input("Note on this version", "note", { maxlength: 1000, size: 34 }), input("Who", "who", { maxlength: 80, size: 14, value: who() }),
        (ui.version = h("button", { type: "button", class: "main", onclick: act(saveVersion) }, "Save a new version")),
        (ui.fresh = h("button", { type: "button", onclick: act(saveNew) }, "Save as a new design"))),
      (ui.state = h("p", { class: "help", role: "status" }))),
    h("section", { class: "card", "aria-label": "Saved designs" }, h("div", { class: "bar" }, h("h2", {}, "Saved designs"), h("label", {}, "Find", (ui.find = h("input", { type: "search", oninput: later(200, () => load()) })))),
      (ui.list = h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "List of saved designs" }))));
  load();
}
export function update() {
  if (ui.named !== app.design?.id || !ui.name.value) { ui.name.value = app.design?.name || app.doc.title || app.name || ""; ui.named = app.design?.id; }
  ui.version.hidden = !app.design;
  ui.fresh.className = app.design ? "" : "main";
  ui.state.textContent = app.design ? `This is version ${app.design.version} of “${app.design.name}”${app.design.saved && app.design.saved !== JSON.stringify(app.doc) ? ", changed since" : ""}.` : "Not saved in the database yet.";
}
const saved = (d, name) => {
  app.design = { id: d.id, version: d.version, name, saved: JSON.stringify(app.doc) };
  ui.note.value = "";
  who(ui.who.value);
  note(`Saved as version ${d.version} of “${name}”.`);
  tell("view");
  return load();
};
const body = () => ({ document: app.doc, note: ui.note.value.trim(), who: ui.who.value.trim() });
async function saveNew() {
  const name = ui.name.value.trim();
  if (!name) { ui.name.focus(); throw new Error("The design needs a name."); }
  await saved(await ask("designs", { name, ...body() }), name);
}
async function saveVersion() {
  const { id, version, name } = app.design, now = ui.name.value.trim() || name;
  if (now !== name) await ask(`designs/${id}`, { name: now }, { method: "PATCH" });
  await saved(await ask(`designs/${id}/versions`, { ...body(), base: version }), now);
}
const load = act(async () => {
  const a = await ask(`designs?query=${encodeURIComponent(ui.find.value)}&limit=200`);
  list = a.designs;
  put(ui.list, list.length ? h("table", { class: "grid-table" }, h("thead", {}, h("tr", {}, ["Name", "Kind", "Versions", "Changed", "By", "Newest note"].map((t) => h("th", { scope: "col" }, t)), h("td"))),
    h("tbody", {}, list.map((d) => h("tr", {}, h("th", { scope: "row" }, d.name), h("td", {}, d.kind), h("td", {}, String(d.versions)), h("td", {}, when(d.changed)), h("td", {}, d.who || "–"), h("td", { class: "remark" }, d.note || ""),
      h("td", { class: "inline" }, h("button", { type: "button", "aria-label": `Open ${d.name}`, onclick: act(() => reopen(d, d.versions)) }, "Open"),
        h("button", { type: "button", "aria-label": `Versions of ${d.name}`, onclick: act((e) => versions(d, e.currentTarget)) }, "Versions"),
        h("button", { type: "button", "aria-label": `Delete ${d.name}`, onclick: act(() => remove(d)) }, "Delete")))))) : h("p", { class: "help" }, ui.find.value ? "No saved design has this in its name." : "Nothing saved yet."));
});
async function reopen(d, version) {
  const v = await ask(`designs/${d.id}/versions/${version}`);
  tell("take", v.document, { name: v.name || d.name, design: { id: d.id, version: v.version, name: d.name, saved: JSON.stringify(v.document) } });
  note(`Opened version ${v.version} of “${d.name}”.`);
  tell("go", "drive");
}
async function versions(d, button) {
  const row = button.closest("tr"), after = row.nextSibling;
  if (after?.className === "versions") return after.remove();
  const full = await ask(`designs/${d.id}`);
  row.after(h("tr", { class: "versions" }, h("td", { colspan: 7 }, h("ul", {}, [...full.versions].reverse().map((v) => h("li", {}, `Version ${v.version}, ${when(v.created)}${v.who ? `, ${v.who}` : ""}${v.note ? `: ${v.note}` : ""} `, h("button", { type: "button", "aria-label": `Open version ${v.version} of ${d.name}`, onclick: act(() => reopen(d, v.version)) }, "Open")))))));
}
async function remove(d) {
  if (!confirm(`Delete “${d.name}” with its ${d.versions} version${d.versions > 1 ? "s" : ""}? This cannot be undone.`)) return;
  await ask(`designs/${d.id}`, undefined, { method: "DELETE" });
  if (app.design?.id === d.id) app.design = null;
  update();
  await load();
}
