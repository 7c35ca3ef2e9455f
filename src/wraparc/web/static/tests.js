// Shear tests: machine files to a lagging file.
import { app, h, $, put, on, tell, ask, act, show, unit, shown, digits, save, change, note } from "./core.js";
import { words, table } from "./drive.js";
import { Chart } from "./plots.js";

const COLOURS = ["blue", "orange", "green", "purple", "sky", "black"];
const ROLES = [["travel", "Travel"], ["force", "Pulling force"], ["normal_force", "Normal force"], ["time", "Time"]];
const FORM = {
  lagging: [["name", "Name", "my-lagging", "Name that drive files ask for it by."], ["title", "Title", ""], ["surface", "Surface", "rubber", "", ["", "bare", "rubber", "polyurethane", "ceramic"]], ["thickness", "Thickness", "12 mm"], ["shear_modulus", "Shear modulus G", "2.3 MPa"], ["compression_modulus", "Compression modulus E_c", "10 MPa"], ["roughness", "Roughness", "", "Of lagging and belt together, for the saturation estimate."]],
  rig: [["sample_area", "Area of one face", "0.04 m2"], ["faces", "Faces that slide", "2", "", ["2", "1"]], ["compliance", "Compliance of the rig", "", "The rig's own travel for a force, such as 0.02 mm/kN."]],
  fit: [["pieces", "Pieces over pressure", "", "", ["", "1", "2"]], ["transition_pressure", "Transition pressure", "", "Estimated if left empty."], ["remove_shear", "Take off the sample's own shear", "", "", ["", "true", "false"]]],
};
let ui, session = null, files = [], result = null, chosen = null, charts = {};

export function mount(box) {
  const input = h("input", { type: "file", multiple: true, id: "test-files", class: "away", tabindex: -1, "aria-label": "Files of the testing machine", onchange: act(() => send(input.files)) });
  const drop = h("div", { class: "drop" }, h("p", {}, "Drop the files of the testing machine here: text or Excel, one test a file."), input,
    h("p", { class: "inline drop-buttons" }, h("button", { type: "button", class: "main", onclick: () => input.click() }, "Choose files …"), h("button", { type: "button", onclick: act(example) }, "Try it with made-up tests")));
  for (const [e, over] of [["dragover", true], ["dragleave", false], ["drop", false]]) drop.addEventListener(e, (x) => { x.preventDefault(); drop.classList.toggle("over", over); if (e === "drop") act(() => send(x.dataTransfer.files))(x); });
  const part = (name, title) => h("fieldset", {}, h("legend", {}, title), FORM[name].map(([key, label, value, help, list]) => {
    const id = `t-${name}-${key}`, e = list ? h("select", { id }, list.map((x) => h("option", { value: x, selected: x === value }, x === "" ? "as found best" : { true: "yes", false: "no" }[x] || x))) : h("input", { id, type: "text", value, autocomplete: "off" });
    return h("div", { class: "field" }, h("label", { for: id }, label), h("span"), h("span", { class: "box" }, e), help && h("p", { class: "help" }, help), h("p", { class: "error", id: `${id}-e` }));
  }));
  ui = { list: h("div"), one: h("div"), problems: h("div", { role: "alert" }), out: h("div") };
  ui.fit = h("button", { type: "button", class: "main", onclick: act(fit) }, "Fit the lagging");
  box.append(h("div", { class: "two" }, h("form", { class: "inputs", "aria-label": "Lagging and rig", onsubmit: (e) => e.preventDefault() }, part("lagging", "Lagging"), part("rig", "Rig"), part("fit", "Fit")),
    h("div", { class: "results" }, drop, ui.list, ui.one, h("p", { class: "bar" }, ui.fit), ui.problems, ui.out)));
  list();
}
export function update() {}
on("units", () => { if (ui) { list(); if (result) draw(); } });

async function begin() {
  if (!session) session = (await ask("tests", {})).session;
  return session;
}
/** Ask within the session; a session that ran out begins anew, the files are then gone. */
async function within(path, ...more) {
  try { return await ask(`tests/${await begin()}/${path}`, ...more); }
  catch (x) {
    if (x.status !== 404) throw x;
    session = null;
    files = [];
    list();
    throw new Error("The tests were kept for half an hour after the last use and are gone: drop the files again.");
  }
}
async function send(chosenFiles) {
  if (!chosenFiles.length) return;
  const data = new FormData();
  for (const f of chosenFiles) data.append("files", f, f.name);
  take((await within("files", data)).files);
}
const example = async () => take((await within("example", {})).files);
async function take(list_) {
  for (const f of list_) {
    const i = files.findIndex((x) => x.id === f.id);
    if (i < 0) files.push(f); else files[i] = f;
  }
  for (const f of list_) if (f.read && !f.pressure && f.pressure_guess) await say(f, { pressure: f.pressure_guess });
  list();
}
async function say(f, more) {
  const body = { pressure: f.pressure || null, normal_force: f.normal_force || null, condition: f.condition || "dry", repeat: f.repeat || "", sample: f.sample || "", choices: f.choices || {}, ...more };
  try {
    const now = await within(`files/${f.id}`, body, { method: "PUT" });
    files[files.findIndex((x) => x.id === f.id)] = { ...f, refused: null, ...now };
  } catch (x) {
    if (!x.problems) throw x;
    Object.assign(f, more, { refused: x.problems });
  }
}
function list() {
  ui.fit.disabled = !files.some((f) => f.read);
  if (!files.length) return put(ui.list), put(ui.one), ui.list;
  const field = (f, key, label, size) => h("input", { type: "text", size, value: f[key] || "", "aria-label": `${label} of ${f.name}`, "aria-invalid": String(!!f.refused?.some((p) => p.path.includes(key))), onchange: act(async (e) => { await say(f, { [key]: e.target.value.trim() || (key === "condition" ? "dry" : null) }); list(); }) });
  put(ui.list, h("section", { class: "card", "aria-label": "Tests" }, h("h2", {}, `${files.length} ${files.length === 1 ? "test" : "tests"}`), h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Files of tests" },
    h("table", { class: "grid-table" }, h("thead", {}, h("tr", {}, ["File", "Read as", "Set pressure", "Condition", ""].map((t) => (t ? h("th", { scope: "col" }, t) : h("td"))))),
      h("tbody", {}, files.map((f) => h("tr", { class: chosen === f.id ? "pinned" : "" },
        h("th", { scope: "row" }, h("button", { type: "button", "aria-expanded": String(chosen === f.id), onclick: () => { chosen = chosen === f.id ? null : f.id; list(); } }, f.name)),
        h("td", { class: f.read ? "" : "bad" }, f.read ? (f.columns || []).filter((c) => c.role).map((c) => `${c.role.replace("_", " ")}: ${c.name}${c.unit ? ` [${c.unit}]` : ""}`).join(", ") : h("b", {}, "not understood yet"),
          [...(f.problems || []), ...(f.refused || [])].map((p) => h("p", { class: "error" }, p.sentence || p.message))),
        h("td", { class: f.refused ? "wrong" : "" }, field(f, "pressure", "Set pressure", 9)), h("td", {}, field(f, "condition", "Condition", 7)),
        h("td", {}, h("button", { type: "button", "aria-label": `Remove ${f.name}`, onclick: act(async () => { await within(`files/${f.id}`, undefined, { method: "DELETE" }); files = files.filter((x) => x !== f); list(); }) }, "✕")))))))));
  const f = files.find((x) => x.id === chosen) || files.find((x) => !x.read);
  if (!f) return put(ui.one);
  const names = [["", "as found"], ...(f.columns || []).map((c) => [c.name, c.name])], c = f.choices || {}, set = (key) => act(async (e) => { await say(f, { choices: { ...c, [key]: e.target.value || null } }); list(); });
  const box = h("figure");
  put(ui.one, h("section", { class: "card", "aria-label": f.name }, h("h2", {}, f.name), h("div", { class: "cols" },
    h("div", {}, f.preview && box, h("div", { class: "bar" }, ROLES.map(([key, label]) => h("label", {}, label, h("select", { onchange: set(key) }, names.map(([v, t]) => h("option", { value: v, selected: v === (c[key] || "") }, t))))),
      (f.columns || []).filter((x) => !x.unit || (c.units || {})[x.name]).map((x) => h("label", {}, `Unit of ${x.name}`, h("input", { type: "text", size: 6, value: (c.units || {})[x.name] || "", onchange: act(async (e) => { await say(f, { choices: { ...c, units: { ...c.units, [x.name]: e.target.value.trim() } } }); list(); }) })))),
      (f.notes || []).length > 0 && h("ul", { class: "help" }, f.notes.map((t) => h("li", {}, words(t) || t)))),
    h("div", {}, (f.tables || []).map((t) => table(t))))));
  if (f.preview) {
    const [lu, lf] = unit("length"), [fu, ff] = unit("force");
    new Chart(box, { title: "As read", height: 190, xlabel: `Travel [${lu}]` }).draw({ x: f.preview.travel.map((v) => v / lf), lines: [{ y: f.preview.force.map((v) => v / ff), cls: "blue", label: "force" }], ylabel: `F [${fu}]`, zero: true });
  }
}
const typedIn = (part) => Object.fromEntries(FORM[part].map(([key]) => [key, $(`t-${part}-${key}`).value.trim()]).filter(([, v]) => v).map(([k, v]) => [k, k === "faces" || k === "pieces" ? +v : v === "true" ? true : v === "false" ? false : v]));
async function fit() {
  document.querySelectorAll("#tests .field").forEach((e) => { e.classList.remove("wrong"); const x = e.querySelector(".error"); if (x) x.textContent = ""; });
  put(ui.problems, h("p", { class: "help" }, "Fitting …"));
  try {
    result = await within("fit", { lagging: typedIn("lagging"), rig: typedIn("rig"), fit: typedIn("fit") });
    put(ui.problems);
    draw();
    ui.out.scrollIntoView({ block: "start" });
  } catch (x) {
    if (!x.problems) throw x;
    const rest = x.problems.filter((p) => {
      const e = $(`t-${(p.path || "").replace(".", "-")}`);
      if (e) { e.closest(".field").classList.add("wrong"); e.setAttribute("aria-invalid", "true"); $(`${e.id}-e`).textContent = p.sentence || p.message; }
      return !e;
    });
    put(ui.problems, h("div", { class: "verdict bad" }, h("p", { class: "headline" }, "The tests could not be fitted."), h("ul", {}, (rest.length ? rest : x.problems).map((p) => h("li", {}, p.sentence || p.message)))));
  }
}
function use() {
  const pulley = app.doc.pulley.map((p, i) => (i === app.pulley ? { ...p, lagging: result.name } : p));
  change({ ...app.doc, lagging: { ...app.doc.lagging, [result.name]: result.lagging }, pulley });
  note(`The lagging ${result.name} is on pulley ${pulley[app.pulley].name} now.`);
  tell("go", "drive");
}
function draw() {
  const figures = result.conditions.map(() => [h("figure"), h("figure"), h("figure")]);
  put(ui.out, h("section", { class: "card", "aria-label": "Fitted lagging" }, h("h2", {}, result.sheet?.title || result.name), h("p", {}, words(result.sheet?.subtitle)),
    h("p", { class: "bar" }, h("button", { type: "button", class: "main", onclick: use }, "Use it in the drive at once"), h("button", { type: "button", onclick: () => save(`${result.name}.toml`, result.toml, "application/toml") }, "Download the lagging file")),
    result.left_out?.length > 0 && h("div", { class: "verdict warn" }, h("p", { class: "headline" }, "Left out"), h("ul", {}, result.left_out.map((p) => h("li", {}, p.sentence || p.message))))),
    result.conditions.map((c, i) => h("section", { class: "card", "aria-label": `Condition ${c.condition}` }, h("h2", {}, `Condition: ${c.condition}`, c.form && h("small", { class: "help" }, ` ${c.form}`)),
      [...(c.misfit || []), ...(c.remarks || [])].length > 0 && h("ul", { class: "help" }, [...(c.misfit || []), ...(c.remarks || [])].map((t) => h("li", {}, words(t) || t))),
      figures[i][0], h("div", { class: "plots" }, figures[i].slice(1)))),
        h("div", { class: "tables" }, (result.sheet?.tables || []).map((t) => table(t))));
  const [lu, lf] = unit("length"), [pu, pf] = unit("pressure");
  result.conditions.forEach((c, i) => {
    const pressures = [...new Set(c.curves.map((v) => Math.round(v.pressure / 1e3)))].sort((a, b) => a - b), seen = new Set();
    const cls = (v) => { const k = pressures.indexOf(Math.round(v.pressure / 1e3)); return COLOURS[k % COLOURS.length]; };
    const x1 = Math.max(...c.curves.map((v) => Math.max(...v.slip))) / lf;
    new Chart(figures[i][0], { title: "Friction curves (thin: measured, thick: fitted)", height: 300, xlabel: `Slip [${lu}]` }).draw({ x: [0, x1], xs: [0, x1], zero: true, ylabel: "friction [-]",
      lines: [...c.curves].sort((a, b) => a.pressure - b.pressure).flatMap((v) => {
        const first = !seen.has(Math.round(v.pressure / 1e3));
        seen.add(Math.round(v.pressure / 1e3));
        return [{ x: v.slip.map((s) => s / lf), y: v.friction, cls: `${cls(v)} thin`, free: true }, { x: v.slip.map((s) => s / lf), y: v.fitted, cls: cls(v), label: first ? shown("wrap_pressure", v.pressure, 3) : "" }];
      }) });
    const f = c.pressure_functions, P = (a) => a.map((v) => v / pf);
    const xs = [0, Math.max(...f.pressure) / pf];
    [["peak_friction", "mu_pk [-]", 1], ["peak_slip", `x_pk [${lu}]`, lf]].forEach(([k, ylabel, s], j) => new Chart(figures[i][1 + j], { title: j ? "Slip at the peak" : "Peak friction", height: 210, xlabel: `Pressure [${pu}]` }).draw({ x: P(f.pressure), xs, zero: true, ylabel,
      lines: [{ y: f[k].map((v) => v / s), cls: "blue", label: "fitted over pressure" }, ...(c.transition ? [{ x: [c.transition.pressure / pf, c.transition.pressure / pf], y: [0, Math.max(...f[k]) / s], cls: "black thin", label: `transition ${show(c.transition.pressure, "pressure", 3)}`, free: true }] : [])], points: f.points.map((q) => [q.pressure / pf, q[k] / s]), pointLabel: "single tests" }));
  });
}
