// Studies: many variants of the drive, started, followed, ended, looked at.
import { app, h, put, on, ask, act, save, split, trim } from "./core.js";
import { table, verdict, words } from "./drive.js";

const KINDS = { grid: "Grid: every value with every other", montecarlo: "Monte Carlo: what tolerances do together", sensitivity: "Sensitivity: which input matters" };
const DISTRIBUTIONS = { uniform: ["from", "to"], normal: ["mean", "standard_deviation"], lognormal: ["median", "geometric_standard_deviation"], triangular: ["from", "mode", "to"] };
const OUTPUTS = ["exit_creep", "creep_limit_margin", "peak_shear_stress"];
const STATES = { queued: "waiting", running: "running", done: "done", failed: "failed", cancelled: "cancelled" };
let ui, kind = "montecarlo", axes = null, of = null, timer = 0, jobs = [], opened = {};

const pulley = () => app.doc.pulley[app.pulley];
/** What can be varied, with the value it has now. */
function fields() {
  const p = pulley(), at = `pulley.${p.name}`, l = app.catalogue.laggings.find((x) => x.name === (p.lagging?.preset || p.lagging)), b = app.catalogue.belts.find((x) => x.name === app.doc.belt?.preset);
  const given = ["entry_tension", "exit_tension", "effective_tension", "power", "torque"].filter((k) => p[k]);
  const list = [...given.map((k) => [`${at}.${k}`, p[k]]), [`${at}.lagging.friction_factor`, "1"], [`${at}.lagging.slip_factor`, "1"], ["belt.modulus", app.doc.belt?.modulus || b?.modulus[app.units]], ["belt.width", app.doc.belt?.width],
    [`${at}.diameter`, p.diameter], [`${at}.wrap_angle`, p.wrap_angle], [`${at}.lagging.thickness`, p.lagging?.thickness || l?.thickness[app.units]], [`${at}.lagging.shear_modulus`, p.lagging?.shear_modulus || l?.shear_modulus[app.units]]];
  return Object.fromEntries([...list, [`${at}.lagging`, ""], ["belt.preset", ""]]);
}
const scaled = (text, f) => { const q = split(text); return q ? `${trim(q.number * f, 4)} ${q.unit}`.trim() : ""; };
/** An axis about the present value: an honest first guess to be changed. */
function axis(field) {
  const now = fields()[field] || "";
  if (field.endsWith(".lagging")) return { field, values: app.catalogue.laggings.map((l) => l.name).join(", ") };
  if (field === "belt.preset") return { field, values: app.doc.belt?.preset || "" };
  if (kind === "grid") return { field, from: scaled(now, 0.8), to: scaled(now, 1.2), count: "9" };
  return kind === "sensitivity" ? { field, distribution: "uniform", from: scaled(now, 0.9), to: scaled(now, 1.1) } : { field, distribution: "normal", mean: scaled(now, 1), standard_deviation: scaled(now, 0.05) };
}
const start = () => {
  const names = Object.keys(fields()), tension = names.find((n) => n.endsWith("exit_tension")) || names[1];
  axes = (kind === "grid" ? [tension, `pulley.${pulley().name}.lagging`] : [tension, `pulley.${pulley().name}.lagging.friction_factor`, "belt.modulus"]).map(axis);
};
const label = (text, e) => h("label", {}, text, e);
const input = (value, f, size = 10) => h("input", { type: "text", value: value ?? "", size, onchange: (e) => f(e.target.value.trim()) });

export function mount(box) {
  ui = { form: h("form", { class: "card", "aria-label": "Study", onsubmit: (e) => e.preventDefault() }), problems: h("div", { role: "alert" }), jobs: h("div") };
  Object.assign(ui, { samples: input("1024", () => {}, 7), seed: input("1", () => {}, 5), setting: h("select", {}, h("option", { value: "engineering" }, "engineering (fast)"), h("option", { value: "precise" }, "precise, as the command solve")), cases: h("select", {}, h("option", { value: "" }, "the first"), h("option", { value: "all" }, "all")), title: input("", () => {}, 34) });
  box.append(h("p", { class: "help" }, "Many variants of the drive of the first page. What runs here goes on when the page is closed."), ui.form, ui.problems, ui.jobs);
  follow();
}
export function update() {
  const now = JSON.stringify([pulley()?.name, app.doc.title, app.pulley]);
  if (now !== of) { of = now; axes = null; ui.title.value = `Study of ${app.doc.title || "the drive"}`; }
  if (!axes) start();
  draw();
  clearTimeout(timer);
  follow();
}
on("units", () => { if (ui) { axes = null; } });
function draw() {
  if (app.doc.train || app.doc.pulley.length > 1) return put(ui.form, h("p", {}, "A study varies the pulley of a single drive. This design is a train: its trims and loads are varied on the page Train."));
  const names = Object.keys(fields()), drawn = kind !== "grid";
  put(ui.form, h("div", { class: "bar" }, label("What", h("select", { id: "study-kind", onchange: (e) => { kind = e.target.value; axes = null; update(); } }, Object.entries(KINDS).map(([k, t]) => h("option", { value: k, selected: k === kind }, t)))),
    label("Title", ui.title), label("Load cases", ui.cases), label("Accuracy", ui.setting), drawn && [label("Samples", ui.samples), label("Seed", ui.seed)]),
    h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "What is varied" }, h("table", {}, h("tbody", {}, axes.map((a, i) => {
      const numbers = a.values != null ? [["values", "Values, with commas between", 44]] : drawn ? DISTRIBUTIONS[a.distribution].map((k) => [k, k.replace(/_/g, " "), 10]) : [["from", "from", 10], ["to", "to", 10], ["count", "values", 4]];
      return h("tr", {}, h("td", {}, label("What is varied", h("select", { onchange: (e) => { axes[i] = axis(e.target.value); draw(); } }, [...new Set([a.field, ...names])].filter((n) => !drawn || !/lagging$|preset$/.test(n)).map((n) => h("option", { selected: n === a.field }, n))))),
        drawn && h("td", {}, label("Distribution", h("select", { onchange: (e) => { const now = fields()[a.field] || ""; const d = e.target.value; axes[i] = { field: a.field, distribution: d, from: scaled(now, 0.9), to: scaled(now, 1.1), mean: now, standard_deviation: scaled(now, 0.05), median: now, geometric_standard_deviation: "1.05", mode: now }; draw(); } }, Object.keys(DISTRIBUTIONS).map((d) => h("option", { selected: d === a.distribution }, d))))),
        h("td", {}, h("span", { class: "inline" }, numbers.map(([k, text, size]) => label(text, input(a[k], (v) => (a[k] = v), size))))),
        h("td", {}, h("button", { type: "button", "aria-label": `Take out ${a.field}`, onclick: () => { axes.splice(i, 1); draw(); } }, "✕")));
    })))),
    h("p", { class: "bar" }, h("button", { type: "button", onclick: () => { const used = axes.map((a) => a.field); axes.push(axis(names.find((n) => !used.includes(n)) || names[0])); draw(); } }, "Vary one more"), h("button", { type: "button", class: "main", onclick: act(begin) }, "Start the study")));
}
const value = (text) => (split(text) && !split(text).unit ? +text : text);
function plan() {
  const drawn = kind !== "grid";
  const axis_ = axes.map((a) => {
    if (a.values != null) return { field: a.field, values: a.values.split(",").map((v) => value(v.trim())).filter((v) => v !== "") };
    const keys = drawn ? ["distribution", ...DISTRIBUTIONS[a.distribution]] : ["from", "to", "count"];
    return { field: a.field, ...Object.fromEntries(keys.map((k) => [k, k === "distribution" ? a[k] : value(a[k])])) };
  });
  return { format: 1, title: ui.title.value.trim(), setting: ui.setting.value, ...(app.pulley ? { pulley: pulley().name } : {}), ...(ui.cases.value ? { load_cases: "all" } : {}),
    ...(drawn ? { sampling: { ...(kind === "montecarlo" ? { method: "latin-hypercube" } : {}), samples: value(ui.samples.value.trim()), seed: value(ui.seed.value.trim()) } } : {}), ...(kind === "sensitivity" ? { sensitivity: { outputs: OUTPUTS } } : {}), axis: axis_ };
}
async function begin() {
  put(ui.problems);
  try {
    const job = await ask("studies", { study: plan(), document: app.doc });
    opened[job.id] = true;
    await follow();
  } catch (x) {
    if (!x.problems) throw x;
    put(ui.problems, h("div", { class: "verdict bad" }, h("p", { class: "headline" }, "The study cannot be run."), h("ul", {}, x.problems.map((p) => h("li", {}, p.sentence || p.message)))));
  }
}
/** Look after the jobs as long as one of them is at work and the page is open. */
const follow = act(async () => {
  clearTimeout(timer);
  jobs = (await ask("studies")).jobs;
  for (const j of jobs) if (opened[j.id] && j.state === "done" && opened[j.id] === true) opened[j.id] = await ask(`studies/${j.id}`);
  list();
  if (jobs.some((j) => j.state === "queued" || j.state === "running")) timer = setTimeout(() => !ui.form.closest("section").hidden && follow(), 400);
});
function list() {
  put(ui.jobs, jobs.map((j) => {
    const busy = j.state === "queued" || j.state === "running", full = typeof opened[j.id] === "object" ? opened[j.id] : j;
    return h("section", { class: "card job", "aria-label": j.title || `Study ${j.id}`, "data-state": j.state }, h("h2", {}, j.title || "Study", " ", h("span", { class: "mark" }, STATES[j.state] || j.state)),
      h("div", { class: "inline" }, busy && h("progress", { max: j.total || 1, value: j.done || 0, "aria-label": "Progress" }), h("span", { role: busy ? "status" : null }, busy && j.total ? `${j.done} of ${j.total} designs` : "", j.message ? ` ${words(j.message) || j.message}` : ""),
        h("button", { type: "button", onclick: act(async () => { await ask(`studies/${j.id}`, undefined, { method: "DELETE" }); if (!busy) delete opened[j.id]; await follow(); }) }, busy ? "Cancel" : "Forget"),
        !busy && j.state === "done" && h("button", { type: "button", "aria-expanded": String(!!opened[j.id]), onclick: act(async () => { opened[j.id] = opened[j.id] ? null : await ask(`studies/${j.id}`); list(); }) }, opened[j.id] ? "Hide" : "Show")),
      (j.problems || []).length > 0 && h("ul", { class: "error" }, j.problems.map((p) => h("li", {}, p.sentence || p.message))),
      opened[j.id] && j.state === "done" && [full.verdict && verdict(full.verdict), (full.remarks || []).length > 0 && h("ul", { class: "help" }, full.remarks.map((r) => h("li", {}, words(r)))), h("div", { class: "tables" }, (full.tables || []).map((t) => table(t))), h("p", { class: "inline" }, (full.files || []).map((n) => h("button", { type: "button", onclick: act(async () => save(n, await (await ask(`studies/${j.id}/files/${n}`, undefined, { as: "blob" })).blob())) }, `Download ${n}`))),
        h("div", { class: "pictures" }, (full.pictures || []).map((n) => h("img", { src: `/api/v1/studies/${j.id}/pictures/${n}`, alt: `${n.replace(/\.\w+$/, "").replace(/[-_]/g, " ")} of ${j.title || "the study"}; its numbers stand in the tables` })))]);
  }));
}
