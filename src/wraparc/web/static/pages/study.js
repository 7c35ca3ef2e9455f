// Studies: many variants of the drive, started, followed, ended, looked at.
import { app, redraw } from "../base/design.js";
import { act, ask, askFile, complain, onReturn, refusal, save, sentence } from "../base/server.js";
import { split, trim, words } from "../base/units.js";
import { list, refused, scroll, table, verdict } from "../parts/answers.js";
import { choose } from "../parts/choose.js";
import { h } from "../vendor/preact.js";

/** @import { Children, Problem } from "../types.d.ts" */
/** @typedef {Record<string, string> & {field: string}} Axis */
/** @typedef {{id: string, title: string, state: string, done: number, total: number, message: any,
 *   problems: Problem[], [key: string]: any}} Job */

/** @type {Record<string, string>} */
const KINDS = {
  grid: "Grid: every value with every other",
  montecarlo: "Monte Carlo: what tolerances do together",
  sensitivity: "Sensitivity: which input matters",
};
/** @type {Record<string, string[]>} */
const DISTRIBUTIONS = {
  uniform: ["from", "to"],
  normal: ["mean", "standard_deviation"],
  lognormal: ["median", "geometric_standard_deviation"],
  triangular: ["from", "mode", "to"],
};
const OUTPUTS = ["exit_creep", "creep_limit_margin", "peak_shear_stress"];
const GIVEN = ["entry_tension", "exit_tension", "effective_tension", "power", "torque"];

const plan = {
  kind: "montecarlo",
  title: "",
  cases: "",
  setting: "engineering",
  samples: "1024",
  seed: "1",
  axes: /** @type {Axis[] | null} */ (null),
};
const state = {
  of: "",
  problems: /** @type {Problem[]} */ ([]),
  jobs: /** @type {Job[]} */ ([]),
  /** Answers of the studies that are unfolded; true while they are awaited. */
  opened: /** @type {Record<string, any>} */ ({}),
  timer: 0,
};

const pulley = () => app.doc.pulley[app.pulley];
/** What can be varied, with the value it has now. @returns {Record<string, string>} */
function fields() {
  const p = pulley();
  const at = `pulley.${p.name}`;
  const name = p.lagging?.preset || p.lagging;
  const lagging = app.catalogue.laggings.find((x) => x.name === name);
  const belt = app.catalogue.belts.find((x) => x.name === app.doc.belt.preset);
  const given = GIVEN.filter((k) => p[k]).map((k) => [`${at}.${k}`, p[k]]);
  const of = (/** @type {string} */ k) => p.lagging?.[k] || lagging?.[k]?.[app.units];
  return Object.fromEntries([
    ...given,
    [`${at}.lagging.friction_factor`, "1"],
    [`${at}.lagging.slip_factor`, "1"],
    ["belt.modulus", app.doc.belt.modulus || belt?.modulus[app.units]],
    ["belt.width", app.doc.belt.width],
    [`${at}.diameter`, p.diameter],
    [`${at}.wrap_angle`, p.wrap_angle],
    [`${at}.lagging.thickness`, of("thickness")],
    [`${at}.lagging.shear_modulus`, of("shear_modulus")],
    [`${at}.lagging`, ""],
    ["belt.preset", ""],
  ]);
}
/** @param {string} text @param {number} f */
const scaled = (text, f) => {
  const q = split(text);
  return q ? `${trim(q.number * f, 4)} ${q.unit}`.trim() : "";
};
/** An axis about the present value: an honest first guess to be changed. @param {string} field
 * @returns {Axis} */
function axis(field) {
  const now = fields()[field] || "";
  if (field.endsWith(".lagging"))
    return { field, values: app.catalogue.laggings.map((l) => l.name).join(", ") };
  if (field === "belt.preset") return { field, values: app.doc.belt.preset || "" };
  const span = { from: scaled(now, 0.8), to: scaled(now, 1.2) };
  if (plan.kind === "grid") return { field, ...span, count: "9" };
  if (plan.kind === "sensitivity")
    return { field, distribution: "uniform", from: scaled(now, 0.9), to: scaled(now, 1.1) };
  return {
    field,
    distribution: "normal",
    mean: scaled(now, 1),
    standard_deviation: scaled(now, 0.05),
  };
}
function firstAxes() {
  const names = Object.keys(fields());
  const tension = names.find((n) => n.endsWith("exit_tension")) || names[1];
  const lagging = `pulley.${pulley().name}.lagging`;
  const drawn = [tension, `${lagging}.friction_factor`, "belt.modulus"];
  return (plan.kind === "grid" ? [tension, lagging] : drawn).map(axis);
}

let visited = false;
export function update() {
  const now = JSON.stringify([pulley().name, app.opened, app.pulley]);
  if (now !== state.of) {
    if (state.of || !plan.axes)
      Object.assign(plan, { axes: null, title: `Study of ${app.doc.title || "the drive"}` });
    state.of = now;
  }
  plan.axes ||= firstAxes();
  if (!visited) follow();
  visited = true;
}
onReturn(() => visited && follow());
/** Take the plan of a study file in. @param {any} file */
export function openStudy(file) {
  const kind = file.sensitivity ? "sensitivity" : file.sampling ? "montecarlo" : "grid";
  const text = (/** @type {any} */ v) => (Array.isArray(v) ? v.join(", ") : String(v));
  const axes = file.axis.map((/** @type {any} */ a) =>
    Object.fromEntries(
      Object.entries(a)
        .filter(([, v]) => typeof v !== "object" || Array.isArray(v))
        .map(([k, v]) => [k, text(v)]),
    ),
  );
  Object.assign(plan, {
    kind,
    axes,
    title: String(file.title || ""),
    cases: file.load_cases ? "all" : "",
    setting: file.setting === "precise" ? "precise" : "engineering",
    ...(file.sampling?.samples && { samples: String(file.sampling.samples) }),
    ...(file.sampling?.seed !== undefined && { seed: String(file.sampling.seed) }),
  });
  state.of = JSON.stringify([pulley().name, app.opened, app.pulley]);
}

/** @param {string} text */
const value = (text) => (split(text) && !split(text)?.unit ? +text : text);
/** The study as its file says it. */
function asFile() {
  const drawn = plan.kind !== "grid";
  const axes = (plan.axes || []).map(({ field, ...a }) => {
    if (a.values != null) {
      const values = a.values.split(",").map((v) => value(v.trim()));
      return { field, values: values.filter((v) => v !== "") };
    }
    const { distribution, ...rest } = a;
    const keys = distribution
      ? DISTRIBUTIONS[distribution] || Object.keys(rest)
      : Object.keys(rest);
    const numbers = Object.fromEntries(keys.map((k) => [k, value(rest[k] ?? "")]));
    return { field, ...(distribution && { distribution }), ...numbers };
  });
  const method = plan.kind === "montecarlo" ? { method: "latin-hypercube" } : {};
  const draws = { ...method, samples: value(plan.samples), seed: value(plan.seed) };
  return {
    format: 1,
    title: plan.title,
    setting: plan.setting,
    ...(app.pulley && { pulley: pulley().name }),
    ...(plan.cases && { load_cases: "all" }),
    ...(drawn && { sampling: draws }),
    ...(plan.kind === "sensitivity" && { sensitivity: { outputs: OUTPUTS } }),
    axis: axes,
  };
}
async function begin() {
  state.problems = [];
  try {
    const job = await ask("studies", { study: asFile(), document: app.doc });
    state.opened[job.id] = true;
    await follow();
  } catch (x) {
    state.problems = refusal(x);
  }
  redraw();
}
/** Look after the jobs as long as one of them is at work and the page is open. */
async function follow() {
  clearTimeout(state.timer);
  try {
    state.jobs = (await ask("studies")).jobs;
    for (const j of state.jobs)
      if (state.opened[j.id] === true && j.state === "done")
        state.opened[j.id] = await ask(`studies/${j.id}`);
  } catch (x) {
    if (!app.gone) complain(x);
    return;
  }
  redraw();
  if (state.jobs.some(busy)) state.timer = setTimeout(() => app.page === "study" && follow(), 400);
  else visited = app.page === "study";
}
/** @param {Job} j */
const busy = (j) => j.state === "queued" || j.state === "running";

export const Page = () => [
  h(
    "p",
    { class: "help", key: "help" },
    "Many variants of the drive of the first page. What runs here goes on when the page is closed.",
  ),
  h(
    "form",
    { class: "card", "aria-label": "Study", onSubmit: (e) => e.preventDefault(), key: "form" },
    form(),
  ),
  h(
    "div",
    { role: "alert", key: "problems" },
    state.problems.length > 0 && refused("The study cannot be run.", state.problems),
  ),
  h("div", { key: "jobs", id: "jobs", tabIndex: -1 }, state.jobs.map(job)),
];
/** @param {string} text @param {Children} e */
const label = (text, e) => h("label", { key: text }, text, e);
/** @param {string | undefined} text @param {(v: string) => void} put @param {number} size */
const input = (text, put, size) =>
  h("input", {
    type: "text",
    value: text ?? "",
    size,
    onChange: (e) => {
      put(e.currentTarget.value.trim());
      redraw();
    },
  });
/** A choice that draws the page anew. @param {string} now @param {[string, string][]} choices
 * @param {(v: string) => void} put @param {string} [id] */
const pick = (now, choices, put, id) =>
  choose(
    now,
    choices,
    (v) => {
      put(v);
      redraw();
    },
    id,
  );
/** @param {"title" | "samples" | "seed" | "cases" | "setting" | "kind"} key */
const into = (key) => (/** @type {string} */ v) => {
  plan[key] = v;
};
function form() {
  if (app.doc.train || app.doc.pulley.length > 1)
    return h(
      "p",
      {},
      "A study varies the pulley of a single drive. This design is a train: its trims and loads ",
      "are varied on the page Train.",
    );
  const names = Object.keys(fields());
  const axes = plan.axes || [];
  const drawn = plan.kind !== "grid";
  const kind = (/** @type {string} */ v) => {
    plan.kind = v;
    plan.axes = null;
  };
  const add = () => {
    const used = axes.map((a) => a.field);
    axes.push(axis(names.find((n) => !used.includes(n)) || names[0]));
    redraw();
  };
  return [
    h(
      "div",
      { class: "bar", key: "bar" },
      label("What", pick(plan.kind, Object.entries(KINDS), kind, "study-kind")),
      label("Title", input(plan.title, into("title"), 34)),
      label(
        "Load cases",
        pick(
          plan.cases,
          [
            ["", "the first"],
            ["all", "all"],
          ],
          into("cases"),
        ),
      ),
      label("Accuracy", pick(plan.setting, SETTINGS, into("setting"))),
      drawn && label("Samples", input(plan.samples, into("samples"), 7)),
      drawn && label("Seed", input(plan.seed, into("seed"), 5)),
    ),
    scroll(
      "What is varied",
      h(
        "table",
        {},
        h(
          "tbody",
          {},
          axes.map((a, i) => axisRow(a, i, names)),
        ),
      ),
    ),
    h(
      "p",
      { class: "bar", key: "buttons" },
      h("button", { type: "button", onClick: add }, "Vary one more"),
      h("button", { type: "button", class: "main", onClick: act(begin) }, "Start the study"),
    ),
  ];
}
/** @type {[string, string][]} */
const SETTINGS = [
  ["engineering", "engineering (fast)"],
  ["precise", "precise, as the command solve"],
];
/**
 * The numbers of an axis: key, label, size.
 * @param {Axis} a @returns {[string, string, number][]}
 */
function numbersOf(a) {
  if (a.values != null) return [["values", "Values, with commas between", 44]];
  if (a.distribution)
    return (DISTRIBUTIONS[a.distribution] || []).map((k) => [k, k.replace(/_/g, " "), 10]);
  return [
    ["from", "from", 10],
    ["to", "to", 10],
    ["count", "values", 4],
  ];
}
/** @param {Axis} a @param {number} i @param {string[]} names */
function axisRow(a, i, names) {
  const axes = plan.axes || [];
  const drawn = plan.kind !== "grid";
  const possible = [...new Set([a.field, ...names])].filter(
    (n) => !drawn || !/lagging$|preset$/.test(n),
  );
  const vary = (/** @type {string} */ v) => {
    axes[i] = axis(v);
  };
  const remove = () => {
    axes.splice(i, 1);
    redraw();
  };
  return h(
    "tr",
    { key: i },
    h(
      "td",
      {},
      label(
        "What is varied",
        pick(
          a.field,
          possible.map((n) => [n, n]),
          vary,
        ),
      ),
    ),
    drawn && h("td", {}, label("Distribution", distribution(a, i))),
    h(
      "td",
      {},
      h(
        "span",
        { class: "inline" },
        numbersOf(a).map(([k, text, size]) =>
          label(
            text,
            input(
              a[k],
              (v) => {
                /** @type {Record<string, string>} */ (a)[k] = v;
              },
              size,
            ),
          ),
        ),
      ),
    ),
    h(
      "td",
      {},
      h("button", { type: "button", "aria-label": `Take out ${a.field}`, onClick: remove }, "✕"),
    ),
  );
}
/** @param {Axis} a @param {number} i */
function distribution(a, i) {
  const now = fields()[a.field] || "";
  const put = (/** @type {string} */ v) => {
    const ends = { from: scaled(now, 0.9), to: scaled(now, 1.1), mode: now };
    const middle = { mean: now, standard_deviation: scaled(now, 0.05), median: now };
    const spread = { geometric_standard_deviation: "1.05" };
    (plan.axes || [])[i] = { field: a.field, distribution: v, ...ends, ...middle, ...spread };
  };
  return pick(
    a.distribution || "",
    Object.keys(DISTRIBUTIONS).map((d) => [d, d]),
    put,
  );
}
/** @type {Record<string, string>} */
const STATES = { queued: "waiting" };
/** @param {Job} j */
function job(j) {
  const at = busy(j);
  const answer = state.opened[j.id];
  const end = async () => {
    await ask(`studies/${j.id}`, undefined, { method: "DELETE" });
    if (!at) delete state.opened[j.id];
    await follow();
    if (!at) document.getElementById("jobs")?.focus();
  };
  const unfold = async () => {
    state.opened[j.id] = answer ? null : await ask(`studies/${j.id}`);
    redraw();
  };
  const message = j.message ? ` ${words(j.message)}` : "";
  const count = at && j.total ? `${j.done} of ${j.total} designs` : "";
  return h(
    "section",
    {
      class: "card job",
      "aria-label": j.title || `Study ${j.id}`,
      "data-state": j.state,
      key: j.id,
    },
    h("h2", {}, j.title || "Study", " ", h("span", { class: "mark" }, STATES[j.state] || j.state)),
    h(
      "div",
      { class: "inline" },
      at &&
        h("progress", {
          max: j.total || 1,
          value: j.done || 0,
          "aria-label": "Progress",
          key: "bar",
        }),
      h("span", { role: at ? "status" : undefined, key: "said" }, count, message),
      h("button", { type: "button", onClick: act(end), key: "end" }, at ? "Cancel" : "Forget"),
      j.state === "done" &&
        h(
          "button",
          { type: "button", "aria-expanded": Boolean(answer), onClick: act(unfold), key: "show" },
          answer ? "Hide" : "Show",
        ),
    ),
    (j.problems || []).length > 0 && list(j.problems.map(sentence), "error"),
    answer && typeof answer === "object" && result(j, answer),
  );
}
/** @param {Job} j @param {any} full */
function result(j, full) {
  const download = (/** @type {string} */ name) =>
    act(async () => save(name, (await askFile(`studies/${j.id}/files/${name}`))[0]));
  const picture = (/** @type {string} */ name) => {
    const what = name.replace(/\.\w+$/, "").replace(/[-_]/g, " ");
    const alt = `${what} of ${j.title || "the study"}; its numbers stand in the tables`;
    return h("img", { src: `/api/v1/studies/${j.id}/pictures/${name}`, alt, key: name });
  };
  return [
    full.verdict && verdict(full.verdict),
    list(full.remarks, "help"),
    h(
      "div",
      { class: "tables", key: "tables" },
      (full.tables || []).map((/** @type {any} */ t) => table(t)),
    ),
    h(
      "p",
      { class: "inline", key: "files" },
      (full.files || []).map((/** @type {string} */ n) =>
        h("button", { type: "button", onClick: download(n), key: n }, `Download ${n}`),
      ),
    ),
    h("div", { class: "pictures", key: "pictures" }, (full.pictures || []).map(picture)),
  ];
}
