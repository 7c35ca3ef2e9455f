// The form of a test plan: lagging, rig and fit.
import { redraw } from "../../base/design.js";
import { h } from "../../vendor/preact.js";

/** @typedef {{key: string, label: string, value?: string, help?: string, list?: string[]}} Row */
/** @type {Record<string, Row[]>} */
const ROWS = {
  lagging: [
    {
      key: "name",
      label: "Name",
      value: "my-lagging",
      help: "Name that drive files ask for it by.",
    },
    { key: "title", label: "Title" },
    {
      key: "surface",
      label: "Surface",
      value: "rubber",
      list: ["", "bare", "rubber", "polyurethane", "ceramic"],
    },
    { key: "thickness", label: "Thickness", value: "12 mm" },
    { key: "shear_modulus", label: "Shear modulus G", value: "2.3 MPa" },
    { key: "compression_modulus", label: "Compression modulus E_c", value: "10 MPa" },
    {
      key: "roughness",
      label: "Roughness",
      help: "Of lagging and belt together, for the saturation estimate.",
    },
  ],
  rig: [
    { key: "sample_area", label: "Area of one face", value: "0.04 m2" },
    { key: "faces", label: "Faces that slide", value: "2", list: ["2", "1"] },
    {
      key: "compliance",
      label: "Compliance of the rig",
      help: "The rig's own travel for a force, such as 0.02 mm/kN.",
    },
  ],
  fit: [
    { key: "pieces", label: "Pieces over pressure", list: ["", "1", "2"] },
    { key: "transition_pressure", label: "Transition pressure", help: "Estimated if left empty." },
    { key: "remove_shear", label: "Take off the sample's own shear", list: ["", "true", "false"] },
  ],
  fixed: [
    { key: "peak_slip", label: "Peak slip", help: "Fitted if left empty; so are the others." },
    { key: "peak_friction", label: "Peak friction" },
    { key: "lash", label: "Lash" },
  ],
};
const TITLES = {
  lagging: "Lagging",
  rig: "Rig",
  fit: "Fit",
  fixed: "Held in every curve, not fitted",
};
/** @type {Record<string, string>} */
const LIST_WORDS = { "": "as found best", true: "yes", false: "no" };

/** What is typed, by part and key. */
const typed = /** @type {Record<string, Record<string, string>>} */ (
  Object.fromEntries(
    Object.entries(ROWS).map(([part, rows]) => [
      part,
      Object.fromEntries(rows.map((r) => [r.key, r.value || ""])),
    ]),
  )
);
/** What a plan says beside the rows of the form: within its parts, and as tables of its own.
 * @type {{parts: Record<string, any>, tables: Record<string, any>}} */
const kept = { parts: {}, tables: {} };
/** Take a test plan into the form. @param {any} plan */
export function openPlan(plan) {
  const { format, lagging, rig, fit, test, ...tables } = plan;
  const { fixed, ...fits } = fit ?? {};
  const parts = /** @type {Record<string, any>} */ ({ lagging, rig, fit: fits, fixed });
  Object.assign(kept, { parts: {}, tables });
  for (const part of Object.keys(ROWS)) {
    const rows = ROWS[part].map((r) => r.key);
    for (const key of rows) typed[part][key] = String(parts[part]?.[key] ?? "");
    const others = Object.entries(parts[part] ?? {}).filter(([key]) => !rows.includes(key));
    kept.parts[part] = Object.fromEntries(others);
  }
}

/** What is typed of a part of the plan; numbers and truth values as such. @param {string} part */
function said(part) {
  const given = Object.entries(typed[part]).filter(([, v]) => v.trim());
  const numbers = ["faces", "pieces"];
  const read = given.map(([k, v]) => [
    k,
    numbers.includes(k) ? +v : v === "true" || v === "false" ? v === "true" : v.trim(),
  ]);
  return { ...Object.fromEntries(read), ...kept.parts[part] };
}
/** The plan without its files, as the server asks for it. */
export function asked() {
  const fixed = said("fixed");
  const fit = { ...said("fit"), ...(Object.keys(fixed).length && { fixed }) };
  return { lagging: said("lagging"), rig: said("rig"), fit, more: kept.tables };
}
/** @param {string} path */
export function rowOf(path) {
  const [part, key] = typedAt(path).split(".");
  return ROWS[part]?.some((r) => r.key === key);
}
/** Where something is typed that stands at a place of the plan. @param {string} path */
export const typedAt = (path) => (path || "").replace(/^fit\.fixed\./, "fixed.");
/** The form. @param {Record<string, string>} marks what is wrong with a row, by part and key */
export const planForm = (marks) =>
  h(
    "form",
    {
      class: "inputs",
      "aria-label": "Lagging and rig",
      onSubmit: (/** @type {Event} */ e) => e.preventDefault(),
    },
    Object.entries(TITLES).map(([part, title]) =>
      h(
        "fieldset",
        { key: part },
        h("legend", {}, title),
        ROWS[part].map((r) => row(part, r, marks[`${part}.${r.key}`])),
      ),
    ),
  );
/** @param {string} part @param {Row} r @param {string | undefined} problem */
function row(part, r, problem) {
  const id = `t-${part}-${r.key}`;
  const common = {
    id,
    value: typed[part][r.key],
    "aria-invalid": Boolean(problem),
    "aria-describedby": `${id}-e`,
    onInput: (/** @type {any} */ e) => {
      typed[part][r.key] = e.currentTarget.value;
      redraw();
    },
  };
  const options = r.list?.map((x) => h("option", { value: x, key: x }, LIST_WORDS[x] ?? x));
  return h(
    "div",
    { class: `field${problem ? " wrong" : ""}`, key: r.key },
    h("label", { for: id }, r.label),
    h("span", {}),
    h(
      "span",
      { class: "box" },
      options
        ? h("select", common, options)
        : h("input", { ...common, type: "text", autocomplete: "off" }),
    ),
    r.help && h("p", { class: "help" }, r.help),
    h("p", { class: "error", id: `${id}-e` }, problem),
  );
}
