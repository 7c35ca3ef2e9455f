// The plan of a study: what is varied, about the values of the drive, and its file.
import { app } from "../../base/design.js";
import { split, trim, words } from "../../base/units.js";

/** @typedef {Record<string, string> & {field: string}} Axis */
/** Where an axis of a file came from. @type {WeakMap<Axis, any>} */
const origins = new WeakMap();

/** @type {Record<string, string>} */
export const KINDS = {
  grid: "Grid: every value with every other",
  montecarlo: "Monte Carlo: what tolerances do together",
  sensitivity: "Sensitivity: which input matters",
};
/** @type {Record<string, string[]>} */
export const DISTRIBUTIONS = {
  uniform: ["from", "to"],
  normal: ["mean", "standard_deviation"],
  lognormal: ["median", "geometric_standard_deviation"],
  triangular: ["from", "mode", "to"],
};
const OUTPUTS = ["exit_creep", "creep_limit_margin", "peak_shear_stress"];
const GIVEN = ["entry_tension", "exit_tension", "effective_tension", "power", "torque"];

export const plan = {
  kind: "montecarlo",
  title: "",
  cases: "",
  setting: "engineering",
  samples: "1024",
  seed: "1",
  axes: /** @type {Axis[] | null} */ (null),
  /** What a study file says beside it. @type {Record<string, any>} */
  more: {},
};
const pulley = () => app.doc.pulley[app.pulley];
/** What can be varied, with the value it has now. @returns {Record<string, string>} */
export function fields() {
  const p = pulley();
  const at = `pulley.${p.name}`;
  const name = p.lagging?.preset || p.lagging;
  const lagging = app.catalogue.laggings.find((x) => x.name === name);
  const belt = app.catalogue.belts.find((x) => x.name === app.doc.belt.preset);
  const given = GIVEN.filter((k) => p[k]).map((k) => [`${at}.${k}`, p[k]]);
  const of = (/** @type {string} */ k) => p.lagging?.[k] || words(lagging?.[k]);
  return Object.fromEntries([
    ...given,
    [`${at}.lagging.friction_factor`, "1"],
    [`${at}.lagging.slip_factor`, "1"],
    ["belt.modulus", app.doc.belt.modulus || words(belt?.modulus)],
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
export const scaled = (text, f) => {
  const q = split(text);
  return q ? `${trim(q.number * f, 4)} ${q.unit}`.trim() : "";
};
/** An axis about the present value: an honest first guess to be changed. @param {string} field
 * @returns {Axis} */
export function axis(field) {
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

/** What the plan was made for: another drive, or another pulley, begins anew. */
let made = "";
const about = () => JSON.stringify([pulley().name, app.opened, app.pulley]);
/** Make a plan of the drive, if there is none of it. */
export function freshPlan() {
  const now = about();
  if (now !== made) {
    if (made || !plan.axes)
      Object.assign(plan, {
        axes: null,
        more: {},
        title: `Study of ${app.doc.title || "the drive"}`,
      });
    made = now;
  }
  plan.axes ||= firstAxes();
}
/** Take the plan of a study file in. @param {any} file */
export function openStudy(file) {
  const kind = file.sensitivity ? "sensitivity" : file.sampling ? "montecarlo" : "grid";
  const text = (/** @type {any} */ v) => (Array.isArray(v) ? v.join(", ") : String(v));
  const axes = file.axis.map((/** @type {any} */ { provenance, ...a }) => {
    const made = Object.fromEntries(Object.entries(a).map(([k, v]) => [k, text(v)]));
    if (provenance) origins.set(/** @type {Axis} */ (made), provenance);
    return made;
  });
  const { format, title, setting, sampling, axis, load_cases, drive, pulley, ...more } = file;
  const { method, samples, seed } = sampling ?? {};
  const all = load_cases === "all" || load_cases === undefined;
  Object.assign(plan, {
    kind,
    axes,
    title: String(title || ""),
    cases: load_cases ? "all" : "",
    setting: setting === "precise" ? "precise" : "engineering",
    more: { ...more, ...(!all && { load_cases }), ...(method && { method }) },
    ...(samples && { samples: String(samples) }),
    ...(seed !== undefined && { seed: String(seed) }),
  });
  made = about();
}

/** @param {string} text */
const value = (text) => (split(text) && !split(text)?.unit ? +text : text);
/** An axis as its file says it. @param {Axis} axis */
function axisOf(axis) {
  const { field, ...a } = axis;
  const provenance = origins.get(axis);
  const from = provenance && { provenance };
  if (a.values != null) {
    const values = a.values.split(",").map((v) => value(v.trim()));
    return { field, values: values.filter((v) => v !== ""), ...from };
  }
  const { distribution, ...rest } = a;
  const known = distribution && DISTRIBUTIONS[distribution];
  const cut = ["least", "most"].filter((k) => rest[k]);
  const keys = known ? [...known, ...cut] : Object.keys(rest);
  const numbers = Object.fromEntries(keys.map((k) => [k, value(rest[k] ?? "")]));
  return { field, ...(distribution && { distribution }), ...numbers, ...from };
}
/** The study as its file says it. */
export function asFile() {
  const drawn = plan.kind !== "grid";
  const { load_cases, method: given, sensitivity, ...more } = plan.more;
  const method = given ?? (plan.kind === "montecarlo" && "latin-hypercube");
  const draws = { ...(method && { method }), samples: value(plan.samples), seed: value(plan.seed) };
  return {
    format: 1,
    title: plan.title,
    ...more,
    setting: plan.setting,
    ...(app.pulley && { pulley: pulley().name }),
    ...(plan.cases && { load_cases: load_cases ?? "all" }),
    ...(drawn && { sampling: draws }),
    ...(plan.kind === "sensitivity" && { sensitivity: sensitivity ?? { outputs: OUTPUTS } }),
    axis: (plan.axes || []).map(axisOf),
  };
}
