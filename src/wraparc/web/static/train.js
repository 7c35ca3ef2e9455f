// Several drives on one belt: shares, speeds, and how exactly they must be matched.
import { app, h, s, put, on, ask, act, later, show, shown, unit, percent, digits, edit, change, title, split } from "./core.js";
import { make as field_, mark, field, forget, refresh } from "./form.js";
import { words, table, verdict, badge } from "./drive.js";
import { Chart, warm } from "./plots.js";

const COLOURS = ["blue", "orange", "green", "purple", "sky", "black"];
const AXES = { speed_trim: "Speed trim of the drive [%]", diameter_ratio: "Diameter over nominal diameter [%]", load_ratio: "Load over that of the load case [%]" };
let ui, answer = null, matched = null, done = null, built = "", stop = null;

const make = (spec, path, more) => field_(spec, path, { page: "t", ...more });
export function mount(box) {
  ui = { form: h("form", { class: "inputs", "aria-label": "Train", onsubmit: (e) => e.preventDefault() }), out: h("div"), problems: h("div", { role: "alert" }), match: h("div"),
    button: h("button", { type: "button", class: "main", onclick: act(match) }, "Work out how exactly they must be matched"), drive: h("select", { id: "train-drive" }), map: h("input", { type: "checkbox", id: "train-map" }) };
  box.append(h("div", { class: "two" }, ui.form, h("div", { class: "results" }, ui.problems, ui.out,
    h("section", { class: "card", "aria-label": "Matching" }, h("h2", {}, "Matching the drives"), h("div", { class: "bar" }, h("label", {}, "Drive that is trimmed", ui.drive), h("label", { class: "inline" }, ui.map, "map of trim and load too"), ui.button)), ui.match)));
}
on("units", () => { built = ""; done = null; });
const several = () => (app.doc.pulley?.length || 0) > 1;
export function update() {
  form();
  const names = app.doc.pulley.map((p) => p.name || "");
  if (ui.names !== names.join()) { ui.names = names.join(); put(ui.drive, names.map((n, i) => h("option", { selected: i === 1 }, n))); }
  ui.button.disabled = !several();
  if (done !== app.doc) { if (several()) solve(); else { put(ui.problems); put(ui.match); put(ui.out, h("p", { class: "verdict" }, "This drive has one pulley. Add a second one on the left, or open a tandem from the menu File.")); } }
  else draw();
}
const solve = later(200, act(async () => {
  const doc = app.doc;
  stop?.abort();
  stop = new AbortController();
  try {
    const a = await ask("train", { document: doc, load_case: null, match: false }, { signal: stop.signal });
    if (doc !== app.doc) return;
    answer = a; done = doc; matched = null;
    mark([]);
    put(ui.problems); put(ui.match);
    draw();
  } catch (x) {
    if (!x.problems) throw x;
    const rest = mark(x.problems);
    put(ui.problems, h("div", { class: "verdict bad" }, h("ul", {}, (rest.length ? rest : x.problems).map((p) => h("li", {}, p.sentence || p.message)))));
  }
}));
async function match() {
  const doc = app.doc;
  put(ui.match, h("p", { class: "help", role: "status" }, "Solving the train some hundred times; this takes some seconds, with the map up to half a minute …"));
  try {
    const a = await ask("train", { document: doc, load_case: null, drive: ui.drive.value || null, match: true, map: ui.map.checked, points: 41 });
    if (doc !== app.doc) return put(ui.match);
    matched = a.matching;
    drawMatch();
  } catch (x) { put(ui.match); throw x; }
}

function addPulley() {
  const d = app.doc, last = d.pulley[d.pulley.length - 1], { entry_tension, exit_tension, effective_tension, power, torque, ...rest } = last;
  const names = d.pulley.map((p) => p.name);
  let name = ["second", "third", "fourth", "fifth"].find((x) => !names.includes(x)) || `drive ${names.length + 1}`;
  const pulley = [...d.pulley.map(({ entry_tension: a, exit_tension: b, effective_tension: c, power: e, torque: f, ...p }) => p), { ...rest, name }];
  const train = d.train || Object.fromEntries(Object.entries({ entry_tension, exit_tension, effective_tension, power }).filter(([, v]) => v !== undefined).slice(0, 2));
  const share = train.share && [...train.share, "0 %"];
  // cases of a single pulley say nothing of a train
  const load_case = d.train ? d.load_case : undefined, next = { ...d, pulley, train: { ...train, share: share || (train.speeds ? undefined : pulley.map(() => `${+(100 / pulley.length).toFixed(4)} %`)) } };
  if (load_case) next.load_case = load_case; else delete next.load_case;
  if (!share && pulley.length === 3) next.train.share = ["34 %", "33 %", "33 %"];
  change(next);
}
function removePulley(i) {
  const d = app.doc, pulley = d.pulley.filter((_, k) => k !== i), next = { ...d, pulley };
  if (pulley.length === 1) {
    const t = d.train || {};
    next.pulley = [{ ...pulley[0], ...Object.fromEntries(["entry_tension", "exit_tension", "effective_tension", "power"].filter((k) => t[k] != null).map((k) => [k, t[k]])) }];
    delete next.train;
    delete next.load_case;
  } else if (d.train?.share) next.train = { ...d.train, share: d.train.share.filter((_, k) => k !== i) };
  change(next);
}
function form() {
  const d = app.doc, t = d.train, now = JSON.stringify([app.units, d.pulley.map((p) => p.name), t && Object.keys(t), Array.isArray(t?.speeds)]);
  if (now === built) return refresh();
  built = now;
  forget(ui.form);
  const lags = [...Object.keys(d.lagging || {}), ...app.catalogue.laggings.map((l) => l.name)];
  const quantity = ["entry_tension", "exit_tension", "effective_tension", "power"];
  const list = (key, i, spec) => make(spec, ["train", key, i], { label: d.pulley[i].name, slider: false });
  const mode = t?.share ? "share" : Array.isArray(t?.speeds) ? "speeds" : t?.speeds ? "equal" : t?.motor ? "motor" : "";
  const setMode = (m) => {
    const { share, speeds, motor, ...rest } = t;
    const n = d.pulley.length;
    edit(["train"], m === "share" ? { ...rest, share: d.pulley.map(() => (n === 2 ? "50 %" : `${+(100 / n).toFixed(4)} %`)) } : m === "equal" ? { ...rest, speeds: "equal" } : { ...rest, speeds: d.pulley.map((_, i) => { const v = answer?.load_cases?.[0]?.drives?.[i]?.speed_trim; return v ? `${(100 * v).toFixed(3)} %` : "100 %"; }) });
  };
  put(ui.form,
    t && h("fieldset", {}, h("legend", {}, "Train"), quantity.map((k) => make(field("train", k), ["train", k])),
      h("div", { class: "field" }, h("label", { for: "train-mode" }, "Given"), h("span"), h("span", { class: "box" }, h("select", { id: "train-mode", onchange: (e) => setMode(e.target.value) },
        [["share", "shares"], ["speeds", "speed trims"], ["equal", "equal drum speeds"], ...(mode === "motor" ? [["motor", "motors (in the file)"]] : [])].map(([v, text]) => h("option", { value: v, selected: v === mode }, text))))),
      mode === "share" && [h("p", { class: "help" }, "Part of the load of each drive: the speeds are computed."), d.pulley.map((_, i) => list("share", i, { key: "share", kind: "number", help: "Such as 50 %, or a power such as 300 kW." }))],
      mode === "speeds" && [h("p", { class: "help" }, "Speed of each drive to the first: the shares are computed."), d.pulley.map((_, i) => list("speeds", i, { key: "speeds", kind: "number", help: "Such as 99.7 %, or 71.6 rpm." }))],
      d.pulley.slice(1).map((p) => make({ key: "run", title: `Run before ${p.name}`, kind: "quantity", dimension: "force", allowed: null, help: "Rise of tension over the run from the pulley before; 0 if left empty." }, ["train", "run", p.name], { slider: false }))),
    d.pulley.map((p, i) => h("fieldset", {}, h("legend", {}, `Drive ${i + 1}`), [make(field("pulley", "name"), ["pulley", i, "name"]), ["diameter", "wrap_angle"].map((k) => make(field("pulley", k), ["pulley", i, k], { slider: false })), make(field("pulley", "lagging"), ["pulley", i, "lagging"], { options: [...new Set([typeof p.lagging === "string" ? p.lagging : "", ...lags])].map((n) => [n, n || "table in the file"]) })],
      d.pulley.length > 1 && h("button", { type: "button", onclick: () => removePulley(i) }, "Remove this drive"))),
    h("button", { type: "button", onclick: addPulley, disabled: d.pulley.length >= 10 }, "Add a drive behind"));
}
/** The drums in a row with their part of the load, the tensions of the belt between them. */
function chain(c) {
  const n = c.drives.length, gap = 190, w = gap * n + 60;
  const parts = c.drives.map((m, i) => {
    const x = 110 + gap * i, f = Math.max(-1, Math.min(1, m.share ?? 0)), a = 2 * Math.PI * Math.abs(f), big = a > Math.PI ? 1 : 0;
    const pie = Math.abs(f) > 0.9999 ? s("circle", { cx: x, cy: 70, r: 42, class: "f-blue" }) : s("path", { class: f < 0 ? "f-orange" : "f-blue", d: `M${x} 70V28A42 42 0 ${big} 1 ${x + 42 * Math.sin(a)} ${70 - 42 * Math.cos(a)}z` });
    return [s("circle", { cx: x, cy: 70, r: 48, class: "shell" }), s("circle", { cx: x, cy: 70, r: 42, class: "shell in" }), pie, s("circle", { cx: x, cy: 70, r: 23, fill: "#fff", stroke: "#777" }),
      s("text", { x, y: 74, class: "t1" }, percent(m.share, 3)), s("text", { x, y: 136, class: "al" }, `${m.pulley}${f < 0 ? " (brakes)" : ""}`), s("text", { x, y: 151, class: "tx" }, `trim ${percent(m.speed_trim, 6)}`), s("text", { x, y: 166, class: "tx" }, `creep ${shown("exit_creep", m.exit_creep, 3)}`),
      s("text", { x: x - gap / 2 + (i ? 0 : 30), y: 14, class: "tx" }, show(m.entry_tension, "force", 4))];
  });
  return s("svg", { viewBox: `0 0 ${w} 172`, width: w, height: 172, class: "chart", role: "img", "aria-label": c.drives.map((m) => `${m.pulley}: share ${percent(m.share)}`).join(", ") }, s("path", { d: `M4 20H${w - 4}`, class: "belt-line" }), parts, s("text", { x: w - 34, y: 14, class: "tx" }, show(c.drives[n - 1].exit_tension, "force", 4)));
}
function draw() {
  put(ui.out, verdict(answer.verdict), h("ul", { class: "help" }, (answer.remarks || []).map((r) => h("li", {}, words(r)))),
    answer.load_cases.map((c) => h("section", { class: "card", "aria-label": `Load case ${c.load_case}` }, h("h2", {}, `Load case ${c.load_case}`), c.reason && h("p", { class: "error" }, c.reason), h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": `Drives in load case ${c.load_case}` }, chain(c)))),
    h("div", { class: "tables" }, (answer.tables || []).map((t) => table(t, /^(Drives|All)/.test(t.title)))));
  if (matched) drawMatch();
}
function drawMatch() {
  const figures = matched.curves.map(() => [h("figure", { class: "card" }), h("figure", { class: "card" })]), map = h("figure", { class: "card" });
  put(ui.match, verdict(matched.verdict), h("div", { class: "plots" }, figures), matched.map && map, h("div", { class: "tables" }, (matched.tables || []).map((t) => table(t, !/^Drives/.test(t.title)))));
  matched.curves.forEach((c, i) => {
    const x = c.values.map((v) => 100 * v), xlabel = AXES[c.axis] || c.axis, [u, f] = unit("length");
    const lines = (set, k) => Object.entries(set).map(([name, y], j) => ({ y: y.map((v) => (v == null ? null : v * k)), cls: COLOURS[j % COLOURS.length], label: name }));
    const marks = (c.marks || []).map((m) => ({ x: [100 * m.at, 100 * m.at], y: [-1e9, 1e9], free: true, cls: "black thin", label: `${m.pulley} ${m.what.replace(/_/g, " ")}` }));
    new Chart(figures[i][0], { title: `Shares [%]`, height: 210, xlabel }).draw({ x, lines: [...lines(c.shares, 100), ...marks], ylabel: "share [%]", zero: true });
    new Chart(figures[i][1], { title: "Creep at exit", height: 210, xlabel }).draw({ x, lines: lines(c.exit_creep, 1 / f), ylabel: `u [${u}]`, zero: true });
  });
  if (matched.map) drawMap(map, matched.map);
}
/** Share of the trimmed drive over trim and load: numbers in the cells, so that colour is not all. */
function drawMap(box, m) {
  const name = Object.keys(m.shares).find((k) => k === matched.drive) || Object.keys(m.shares)[0], grid = m.shares[name], pick = (list, most) => list.map((_, i) => i).filter((i) => i % Math.ceil(list.length / most) === 0);
  const cols = pick(m.x, 12), rows = pick(m.y, 9), all = grid.flat().filter((v) => v != null), lo = Math.min(...all), hi = Math.max(...all), cw = 58, ch = 26;
  const dark = (v) => (v - lo) / (hi - lo || 1) > 0.72;
  put(box, h("figcaption", {}, h("strong", {}, `Share of ${name} [%] over trim and load`)), h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Map of trim and load" }, s("svg", { width: 70 + cw * cols.length, height: 50 + ch * rows.length, role: "img", "aria-label": `Share of ${name}, from ${percent(lo)} to ${percent(hi)}` },
    rows.flatMap((r, j) => [s("text", { x: 62, y: 17 + ch * j, class: "ty" }, percent(m.y[r], 3)), cols.map((k, i) => { const v = grid[r][k]; return [s("rect", { x: 68 + cw * i, y: ch * j, width: cw - 1, height: ch - 1, fill: v == null ? "#ddd" : warm(0.92 * ((v - lo) / (hi - lo || 1))) }), s("text", { x: 68 + cw * (i + 0.5), y: 17 + ch * j, class: v != null && dark(v) ? "tx light" : "tx" }, v == null ? "–" : digits(100 * v, 3))]; })]),
    cols.map((k, i) => s("text", { x: 68 + cw * (i + 0.5), y: ch * rows.length + 16, class: "tx" }, percent(m.x[k], 5))), s("text", { x: 68 + (cw * cols.length) / 2, y: ch * rows.length + 38, class: "al" }, "trim across, load down"))));
}
