// The drive page: inputs on the left, the answer moving as they change.
import { app, h, $, put, on, tell, ask, later, show, shown, unit, digits, percent, title, symbol, sign, dim, si } from "./core.js";
import { form, mark } from "./form.js";
import { Chart, Pulley, budget, swatch, scale } from "./plots.js";

const LEVELS = { OK: ["good", "✓"], ATTENTION: ["warn", "▲"], FAILS: ["bad", "✕"] };
const QUANTITIES = ["shear_stress", "friction_used", "wrap_pressure", "slip", "creep"];
const PARTS = ["creep_shrinkage", "creep_compression", "creep_global"];
let ui, charts, pulley, quickDoc = null, fullDoc = null, quickBusy = false, wanted = false, sequence = 0, stop = null;
let arc = null, full = null, cursor = 0.5, scaleKey = "", wide = 0, picked = "";

export const words = (b) => (b && typeof b === "object" ? b[app.units] : b) || "";
export const badge = (level) => (level ? h("span", { class: `badge ${LEVELS[level]?.[0]}` }, h("span", { "aria-hidden": "true" }, LEVELS[level]?.[1] + " "), level) : "");

/** A table as the server tells it. */
export function table(t, open = true) {
  const heads = t.heads[app.units], head = heads.some(Boolean), symbols = t.rows.some((r) => r.symbol), notes = t.rows.some((r) => words(r.note) || r.level);
  return h("details", { class: `table t-${t.key}`, open }, h("summary", {}, t.title), h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": t.title },
    h("table", {},
      head && h("thead", {}, h("tr", {}, h("td"), symbols && h("td"), heads.map((x) => (x ? h("th", { scope: "col", class: "num" }, x) : h("td"))), notes && h("td"))),
      h("tbody", {}, t.rows.map((r) => h("tr", { class: LEVELS[r.level]?.[0] }, h("th", { scope: "row", title: app.form.glossary[r.name]?.meaning }, r.title), symbols && h("td", { class: "sym" }, sign(r.symbol)), r.values[app.units].map((v) => h("td", { class: "num" }, v)), notes && h("td", { class: "remark" }, badge(r.level), " ", words(r.note))))))),
    words(t.note) && h("p", { class: "help" }, words(t.note)));
}
export const verdict = (v, extra = []) => h("div", { class: `verdict ${LEVELS[v.level]?.[0] || ""}` },
  h("p", { class: "headline" }, badge(v.level), " ", words(v.headline)), v.sentences.length + extra.length > 0 && h("ul", {}, [...v.sentences, ...extra].map((x) => h("li", {}, words(x)))));

export function mount(place) {
  const e = (tag, attrs, ...k) => h(tag, attrs, ...k);
  ui = {
    title: e("h2"), wait: e("span", { role: "status" }), choose: e("span", { class: "inline" }), form: e("form", { class: "inputs", "aria-label": "Drive", onsubmit: (x) => x.preventDefault(), novalidate: true }),
    verdict: e("div", { id: "verdict" }), spoken: e("p", { class: "away", role: "status", "aria-live": "polite" }), problems: e("div", { role: "alert" }),
    pulley: e("div"), scale: e("div", { class: "scale" }), quantity: e("select", { id: "quantity" }), figures: e("dl", { class: "figures" }), chips: e("p", { class: "chips" }),
    plots: e("div", { class: "plots" }), cursor: e("input", { type: "range", id: "cursor", min: 0, max: 1000, value: 500, step: 5 }), read: e("dl", { class: "reading" }),
    peek: e("p", { class: "peek", "aria-hidden": "true" }), budget: e("figure", { class: "card" }), summary: e("div"), tables: e("div", { class: "tables" }), result: null,
  };
  put(ui.quantity, QUANTITIES.map((q) => h("option", { value: q }, title(q))));
  ui.quantity.onchange = () => arc && paint();
  ui.cursor.oninput = () => point(ui.cursor.value / 1000);
  const figures = ["Belt tension", "Friction", "Creep and slip", "Lagging shear"].map((t, i) => [t, h("figure", {})]);
  put(ui.plots, figures.map((f) => f[1]));
  ui.result = e("div", { class: "results", id: "results" }, e("div", { class: "pick" }, ui.title, ui.wait, ui.choose), ui.problems, ui.verdict, ui.chips, ui.spoken,
    e("div", { class: "pair" },
      e("figure", { class: "card" }, ui.pulley, e("figcaption", {}, e("label", { for: "quantity" }, "Colour and inner ring: "), ui.quantity, ui.scale)),
      e("section", { class: "card", "aria-label": "Key figures" }, e("h2", {}, "Key figures"), ui.figures)),
    e("section", { class: "card", "aria-label": "Along the wrap" }, e("h2", {}, "Along the wrap"), ui.plots,
      e("div", { class: "along" }, e("label", { for: "cursor" }, "Place on the arc"), ui.cursor, ui.read)),
    ui.budget, ui.summary, ui.tables);
  place.append(h("div", { class: "two" }, ui.form, ui.result), ui.peek);
  charts = figures.map(([t, f], i) => new Chart(f, { title: t, height: 170, xlabel: i > 1 ? "Angle from the entry nip [deg]" : "", onpick: point }));
  pulley = new Pulley(ui.pulley);
  new ResizeObserver(([x]) => { const w = Math.floor(x.contentRect.width); if (w && w !== wide) { wide = w; if (arc) budgets(); } }).observe(ui.budget);
}

export function update() {
  // the request leaves first, the form follows while it is on its way
  const known = quickDoc === app.doc && arc && !update.view;
  update.view = false;
  if (!known) {
    quickDoc = null;
    quick();
    document.documentElement.classList.add("stale");
  }
  form(ui.form);
  ui.title.textContent = app.doc.title || "Drive";
  if (Array.isArray(app.doc.pulley)) picks();
  if (known) redraw();
  else complete();
}
on("view", () => (update.view = true));
on("units", () => { update.view = true; scaleKey = ""; if (arc) redraw(); });
const redraw = () => { paint(); if (full) fill(); };

/** One arc at once; while it is on its way only the newest change waits. */
async function quick() {
  if (quickBusy) return void (wanted = true);
  quickBusy = true;
  do {
    wanted = false;
    const doc = app.doc, name = doc.pulley?.[app.pulley]?.name;
    // an answer that is long in coming must not stand under another drive's name
    const slow = setTimeout(() => { ui.result.classList.add("waiting"); ui.wait.textContent = "Solving …"; }, 250);
    try {
      const a = await ask("solve/fast", { document: doc, pulley: name ?? null, load_case: app.case || null, points: 120, sequence: ++sequence, tables: false });
      if (doc === app.doc) { mark([]); put(ui.problems); }
      arc = a; quickDoc = wanted ? null : doc;
      settle();
      ui.result.classList.remove("refused");
      paint();
      if (a.sequence === 1) performance.mark("answered");
      document.dispatchEvent(new CustomEvent("painted", { detail: a.sequence }));
    } catch (x) {
      if (!x.problems) { quickBusy = false; throw x; }
      if (doc === app.doc) refused(x.problems);
    }
    clearTimeout(slow);
    if (!wanted && ui.wait.textContent) { ui.result.classList.remove("waiting"); ui.wait.textContent = ""; }
  } while (wanted);
  quickBusy = false;
}
/** Both answers are of the design on the page. */
function settle() {
  if (quickDoc === app.doc && fullDoc === app.doc) document.documentElement.classList.remove("stale");
}
function refused(problems) {
  if (app.case && problems.some((p) => p.path === "load_case")) { app.case = ""; return tell("view"); }
  const rest = mark(problems), n = problems.length;
  ui.result.classList.add("refused");
  put(ui.problems, h("div", { class: "verdict bad" }, h("p", { class: "headline" }, badge("FAILS"), ` ${n === 1 ? "One value" : `${n} values`} cannot be used; the answer below is of the last drive that could.`), h("ul", {}, (rest.length ? rest : problems).map((p) => h("li", {}, p.sentence || p.message)))));
}
/** Everything there is to say, once the hand rests. */
const complete = later(250, async () => {
  stop?.abort();
  stop = new AbortController();
  const doc = app.doc;
  try {
    const a = await ask("solve", { document: doc, points: 180, sequence: ++sequence }, { signal: stop.signal });
    if (doc !== app.doc) return;
    full = a; fullDoc = doc;
    settle();
    fill();
    ui.spoken.textContent = words(a.verdict.headline);
    document.dispatchEvent(new CustomEvent("complete"));
  } catch (x) { if (!x.problems && x.name !== "AbortError") throw x; }
});
const here = () => full?.arcs.find((a) => a.pulley === arc?.pulley && a.load_case === arc?.load_case);
/** Numbers of a pulley by the last solve, if they are of the present document. */
export const now = (i) => {
  if (quickDoc !== app.doc || arc?.pulley !== app.doc.pulley[i]?.name) return null;
  const n = arc.numbers, pull = n.effective_tension, D = si(app.doc.pulley[i].diameter, "length");
  return { entry_tension: n.entry_tension, exit_tension: n.exit_tension, effective_tension: pull, power: n.transmitted_power, torque: (pull * D) / 2 };
};

const rad = (v) => (v * 180) / Math.PI;
function paint() {
  const p = arc.profile, n = arc.numbers, deg = p.position.map(rad), [fu, ff] = unit("force"), [pu, pf] = unit("pressure"), [lu, lf] = unit("length");
  const of = (name, f = 1, abs) => p[name].map((v) => (v == null ? null : (abs ? Math.abs(v) : v) / f));
  const paper = fullDoc === app.doc && here()?.paper, pp = paper?.status === "solved" ? paper.profile : null;
  const other = (name, f, abs) => pp ? [{ x: pp.position.map(rad), y: pp[name].map((v) => (abs ? Math.abs(v) : v) / f), cls: "paper", label: "paper's march" }] : [];
  const zones = [...arc.outside.map(([a, b]) => [rad(a), rad(b), "out"]), ...(n.stuck_arc > 0 ? [[0, rad(n.stuck_arc), "rest"]] : [])];
  const common = { x: deg, zones, angles: true, xs: [0, deg[deg.length - 1]] };
  const perForce = (p.wrap_pressure[0] / p.tension[0]) * (ff / pf);
  charts[0].draw({ ...common, zero: true, ylabel: `T [${fu}]`, told: `from ${shown("tension", n.entry_tension)} to ${shown("tension", n.exit_tension)}`,
    lines: [{ y: of("tension", ff), cls: "blue", label: "belt tension" }, ...other("tension", ff)], other: { label: `p [${pu}]`, key: perForce, to: (v) => v * perForce, from: (v) => v / perForce } });
  charts[1].draw({ ...common, zero: true, ylabel: "friction [-]",
    lines: [{ y: of("friction", 1, true), cls: "blue", label: "available" }, { y: of("friction_used", 1, true), cls: "orange", label: "used" }, ...other("friction_used", 1, true)] });
  const side = n.entry_tension >= n.exit_tension ? 1 : -1;
  charts[2].draw({ ...common, ylabel: `u, x [${lu}]`, limit: { y: (side * arc.creep_limit) / lf, label: `limit ${show(arc.creep_limit, "length")}` }, zero: true,
    lines: [{ y: of("creep", lf), cls: "blue", label: "creep" }, { y: of("slip", lf), cls: "orange", label: "slip" }, ...other("creep", lf)] });
  const k = p.shear_stress.reduce((m, v, i) => (Math.abs(v) > Math.abs(p.shear_stress[m]) ? i : m), 0), G = p.shear_stress[k] / Math.tan(p.shear_angle[k]) / pf;
  charts[3].draw({ ...common, zero: true, ylabel: `τ [${pu}]`, points: [[rad(n.peak_shear_position), (side * n.peak_shear_stress) / pf]], pointLabel: `peak ${shown("peak_shear_stress", n.peak_shear_stress, 3)}`,
    lines: [{ y: of("shear_stress", pf), cls: "blue", label: "shear stress" }, ...other("shear_stress", pf)],
    ...(Number.isFinite(G) && G > 0 ? { other: { label: "γ [deg]", key: G, to: (v) => rad(Math.atan(v / G)), from: (v) => G * Math.tan(v / 57.29577951) } } : {}) });
  const q = ui.quantity.value, most = Math.max(...p[q].map(Math.abs)), pull = n.effective_tension;
  pulley.draw({ phi: p.position[p.position.length - 1], position: p.position, values: p[q], most, t1: n.entry_tension, t2: n.exit_tension,
    text1: `T1 = ${show(n.entry_tension, "force", 3)}`, text2: `T2 = ${show(n.exit_tension, "force", 3)}`, duty: pull > 0 ? "driving" : pull < 0 ? "braking" : "idling",
    outside: arc.outside, stuck: n.stuck_arc, peak: n.peak_shear_position, told: `Pulley with its wrapped arc, coloured by ${title(q)}, largest ${shown(q, most, 3)}` });
  const [qu, qf] = unit(dim(q)), key = q + app.units + digits(most / qf, 3);
  if (key !== scaleKey) { scaleKey = key; scale(ui.scale, `${title(q)}${qu ? ` [${qu}]` : ""}; dot: peak shear stress`, most / qf); }
  point(cursor);
  figures();
  head();
  // what does not move with the hand comes a frame later
  cancelAnimationFrame(paint.after);
  paint.after = requestAnimationFrame(() => setTimeout(() => { chips(); budgets(); }));
}
function point(part) {
  cursor = part;
  if (document.activeElement !== ui.cursor) ui.cursor.value = part * 1000;
  const p = arc.profile, at = part * p.position[p.position.length - 1];
  let j = 0;
  while (j < p.position.length - 2 && p.position[j + 1] < at) j++;
  const f = (at - p.position[j]) / (p.position[j + 1] - p.position[j] || 1), v = (name) => p[name][j] + f * (p[name][j + 1] - p[name][j]);
  charts.forEach((c) => c.at(part));
  pulley.at(at);
  const text = ["position", "tension", "wrap_pressure", "friction", "friction_used", "creep", "slip", "shear_stress", "shear_angle"].map((k) => [symbol(k), shown(k, k === "position" ? at : v(k)), title(k)]);
  text.push([[""], p.sliding[j] ? "slides" : "at rest", "Sliding or at rest"]);
  if (ui.read.children.length === text.length) text.forEach((t, i) => (ui.read.children[i].lastChild.textContent = t[1]));
  else put(ui.read, text.map(([k, t, name]) => h("div", { title: name }, h("dt", {}, k[0] ? k : "belt"), h("dd", {}, t))));
  ui.cursor.setAttribute("aria-valuetext", shown("position", at));
}
/** Key figures: those of the quick solve first, the others when everything is solved. */
function figures() {
  const n = arc.numbers, a = fullDoc === app.doc && here(), m = (a || here())?.numbers || {}, limit = arc.creep_limit;
  const share = Math.abs(n.exit_creep) / limit, solved = arc.status === "solved";
  const rows = [
    ["Creep at exit", shown("exit_creep", n.exit_creep), solved ? `${percent(share)} of the limit ${show(limit, "length")}` : `at the largest ratio that friction can carry; the limit is ${show(limit, "length")}`, solved ? (share <= 1 ? "good" : "warn") : "bad", 0],
    ["Peak shear angle", shown("peak_shear_angle", n.peak_shear_angle), `${shown("peak_shear_stress", n.peak_shear_stress)} at ${shown("peak_shear_position", n.peak_shear_position)}`],
    ["Tension ratio T1/T2", digits(n.tension_ratio), `pull ${shown("effective_tension", n.effective_tension)}`],
    ["Mean friction", digits(n.mean_friction), "over the whole wrap"],
    ["Margin to the creep limit", digits(m.creep_limit_margin), m.creep_limit_capacity == null ? "" : `carries a ratio of ${digits(m.creep_limit_capacity)}`, m.creep_limit_margin == null ? "" : m.creep_limit_margin >= 1 ? "good" : "warn", 1],
    ["Least slack-side tension", m.least_exit_tension == null ? (m.gross_slip_capacity == null ? "–" : "none") : shown("least_exit_tension", m.least_exit_tension), m.least_exit_tension == null && m.largest_effective_tension ? `largest pull ${shown("largest_effective_tension", m.largest_effective_tension)}` : "for this pull within the limit", m.creep_limit_margin != null && m.least_exit_tension == null ? "warn" : "", 1],
    ["Equivalent friction", digits(m.equivalent_friction), "at the creep limit, beside CEMA, DIN", "", 1],
    ["Wrap pressure", shown("wrap_pressure", arc.profile.wrap_pressure[0], 3), `to ${shown("wrap_pressure", arc.profile.wrap_pressure[arc.profile.wrap_pressure.length - 1], 3)}`],
    ["Slip at exit", shown("exit_slip", n.exit_slip), n.stuck_arc > 0 ? `at rest over ${shown("stuck_arc", n.stuck_arc, 3)}` : "slides all along"],
    n.power_loss == null ? ["Energy per pass", shown("frictional_energy", n.frictional_energy, 3), solved ? "power needs the belt speed" : "at the largest ratio"] : ["Power lost to creep", shown("power_loss", n.power_loss, 3), `efficiency ${percent(n.efficiency, 4)}`],
  ];
  if (ui.figures.children.length !== rows.length) put(ui.figures, rows.map(() => h("div", {}, h("dt"), h("dd", {}, h("b"), h("small"), h("i", { class: "gauge" }, h("i"))))));
  rows.forEach(([name, value, small, level, late], i) => {
    const e = ui.figures.children[i], [b, sm, g] = e.lastChild.children, cls = `${level || ""} ${late ? "late" : ""}`.trim();
    if (e.className !== cls) e.className = cls;
    if (e.firstChild.textContent !== name) e.firstChild.textContent = name;
    if (b.textContent !== value) b.textContent = value;
    if (sm.textContent !== small) sm.textContent = small;
    g.hidden = i > 0;
    if (!i) g.firstChild.style.width = `${Math.min(100, share * 50)}%`;
  });
}
function head() {
  // the quick answer has fewer sentences: the box keeps its height, so that nothing below jumps
  const whole = fullDoc === app.doc && full.arcs.length ? full : null;
  if (!whole && ui.verdict.firstChild && !ui.verdict.style.minHeight) ui.verdict.style.minHeight = `${ui.verdict.offsetHeight}px`;
  const told = whole && whole.arcs.length === 1 ? whole.verdict : arc.verdict, key = JSON.stringify([told, app.units]);
  if (key !== head.key) put(ui.verdict, verdict(told));
  head.key = key;
  if (whole) ui.verdict.style.minHeight = "";
  put(ui.peek, badge(arc.level), ` creep ${shown("exit_creep", arc.numbers.exit_creep)}, ${percent(Math.abs(arc.numbers.exit_creep) / arc.creep_limit)} of the limit`);
}
function chips() {
  const kinds = [...new Set((full?.sources || []).map((x) => x.kind))].filter((k) => ["illustrative", "calibrated"].includes(k)), out = arc.numbers.outside_tested_share;
  put(ui.chips, kinds.map((k) => h("span", { class: `mark ${k}` }, k === "illustrative" ? "illustrative data: no real product" : "calibrated data")),
    out > 0 ? h("span", { class: "mark outside" }, `outside the tested range on ${percent(out)} of the wrap`) : arc.tested && h("span", { class: "mark inside" }, `within the tested range (p ${show(arc.tested.pressure_min, "pressure", 3)} to ${show(arc.tested.pressure_max, "pressure", 3)}, slip to ${show(arc.tested.slip_max, "length", 3)})`),
    (arc.remarks || []).map((r) => h("span", { class: "remark" }, words(r))));
}
function budgets() {
  const [u, f] = unit("length"), a = fullDoc === app.doc && here(), list = [{ label: "distributed", n: arc.numbers }];
  if (a?.paper?.status === "solved") list.push({ label: "paper's march", n: a.paper.numbers });
  wide ||= ui.budget.clientWidth - 28 || 480;
  const box = ui.budget.lastElementChild?.className === "bars" ? ui.budget.lastElementChild : h("div", { class: "bars" });
  const n = arc.numbers, side = n.effective_tension < 0 ? -1 : 1;
  if (box.parentElement !== ui.budget) put(ui.budget, h("figcaption", {}), box);
  put(ui.budget.firstChild, h("strong", {}, "Creep by source"), PARTS.map((k, i) => h("span", {}, swatch(i), `${["belt shrinkage", "lagging compression", "global creep"][i]} ${shown(k, n[k], 3)}${n.exit_creep ? ` (${percent(n[k] / n.exit_creep, 2)})` : ""}`)));
  budget(box, wide, list.map((x) => ({ label: x.label, parts: PARTS.map((k) => x.n[k] / f) })), (side * arc.creep_limit) / f, u, `Creep by source: ${PARTS.map((k) => `${title(k)} ${shown(k, n[k], 3)}`).join(", ")}`);
}
/** What only the whole solve knows. */
function fill() {
  picks();
  const a = here();
  if (!a) return;
  paint();
  put(ui.summary, full.summary && table(full.summary));
  const first = ["answer", "comparison"];
  put(ui.tables, a.tables.filter((t) => t.key !== "creep").sort((x, y) => first.includes(y.key) - first.includes(x.key)).map((t) => table(t, t.key !== "inputs")),
    a.table_sources.length > 0 && h("section", { class: "sources", "aria-label": "Sources" }, h("h2", {}, "Sources"), h("ol", {}, a.table_sources.map((x) => h("li", {}, x)))));
}
function picks() {
  const sure = fullDoc === app.doc, names = app.doc.pulley.map((p) => p.name), known = sure ? [...new Set(full.arcs.map((a) => a.load_case))] : ["design", ...(app.doc.load_case || []).map((c) => c.name)];
  const pick = (id, label, list, at, f) => list.length > 1 && h("span", {}, h("label", { for: id }, label), h("select", { id, onchange: (e) => { f(e.target.selectedIndex); tell("view"); } }, list.map((x, i) => h("option", { selected: i === at }, x))));
  const short = (c) => (sure ? `: ${full.arcs.find((a) => a.load_case === c && a.pulley === names[app.pulley])?.short || ""}` : "");
  const key = JSON.stringify([names, known.map((c) => c + short(c)), app.pulley, app.case]);
  if (key === picked) return;
  picked = key;
  const active = document.activeElement?.id;
  put(ui.choose, pick("pick-pulley", "Pulley ", names, app.pulley, (i) => (app.pulley = i)), pick("pick-case", "Load case ", known.map((c) => c + short(c)), Math.max(0, known.indexOf(app.case || known[0])), (i) => (app.case = i ? known[i] : "")));
  if (active?.startsWith("pick-")) $(active)?.focus();
}
