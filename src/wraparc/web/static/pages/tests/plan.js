// The form of a test plan: lagging, rig and fit.
import { redraw } from "../../base/design.js";
import { oneOf } from "../../parts/choose.js";
import { h } from "../../vendor/preact.js";

/** @typedef {{key: string, label: string, value?: string, help?: string, list?: string[],
 *   none?: string, of?: string}} Row `none` is what "" says; `of` which curves it is */
/** @type {Record<string, Row[]>} */
const ROWS = {
  lagging: [
    {
      key: "name",
      label: "Name",
      value: "my-lagging",
      help: "Name of the lagging in drive files.",
    },
    { key: "title", label: "Title" },
    {
      key: "surface",
      label: "Surface",
      value: "rubber",
      list: ["", "bare", "rubber", "polyurethane", "ceramic"],
      none: "not said",
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
  digitised: [
    { key: "source", label: "Source", help: "Who published it: author, title, year." },
    { key: "figure", label: "Figure", help: "Which one, such as Figures 3 to 5." },
    {
      key: "quantity",
      label: "It shows",
      value: "friction",
      list: ["friction", "coefficients"],
    },
    { key: "slip_unit", label: "Unit of slip", list: ["", "mm", "in", "cm", "m"], none: "choose" },
    {
      key: "pressure_unit",
      label: "Unit of pressure",
      value: "kPa",
      list: ["kPa", "MPa", "psi", "bar"],
      of: "coefficients",
    },
    {
      key: "slip_max",
      label: "Slip of the tests",
      help: "Slip up to which A and b are valid; the peak if left empty.",
      of: "coefficients",
    },
    {
      key: "error",
      label: "Error of a point",
      value: "1 %",
      help: "A share of full scale: how well the curves can be read.",
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
  digitised: "Figure",
  rig: "Rig",
  fit: "Fit",
  fixed: "Fixed in every curve, not fitted",
};
/** @type {Record<string, string>} */
const LIST_WORDS = {
  "": "best fit",
  true: "yes",
  false: "no",
  friction: "friction over slip",
  coefficients: "A and b over pressure",
};
/** What is fitted: the files of a machine, or curves read off a figure. */
let from = "tests";
export const isFigure = () => from === "figure";
export function useFigure() {
  from = "figure";
}
/** What a figure shows. @returns {"friction" | "coefficients"} */
export const figured = () => /** @type {any} */ (typed.digitised.quantity);

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
  const { format, lagging, rig, digitised, fit, test, ...tables } = plan;
  const { fixed, ...fits } = fit ?? {};
  const parts = /** @type {Record<string, any>} */ ({ lagging, rig, fit: fits, fixed });
  from = digitised ? "figure" : "tests";
  if (digitised) parts.digitised = { quantity: "friction", slip_unit: "mm", ...digitised };
  Object.assign(kept, { parts: {}, tables });
  for (const part of Object.keys(ROWS)) {
    const rows = ROWS[part].map((r) => r.key);
    for (const key of rows) typed[part][key] = String(parts[part]?.[key] ?? "");
    const others = Object.entries(parts[part] ?? {}).filter(([key]) => !rows.includes(key));
    kept.parts[part] = Object.fromEntries(others);
  }
}

/** Rows of a part that what is fitted has. @param {string} part */
const shown = (part) => ROWS[part].filter((r) => !r.of || r.of === figured());
/** What is typed of a part of the plan; numbers and truth values as such. @param {string} part */
function said(part) {
  const rows = shown(part).map((r) => r.key);
  const given = Object.entries(typed[part]).filter(([key, v]) => rows.includes(key) && v.trim());
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
  const digitised = isFigure() && { digitised: said("digitised") };
  const rig = isFigure() ? {} : said("rig");
  return { lagging: said("lagging"), rig, fit, more: { ...kept.tables, ...digitised } };
}
/** What a figure does not show and only its reader can say, by part and key. */
export function unsaid() {
  const found = /** @type {Record<string, string>} */ ({});
  if (!isFigure()) return found;
  const { digitised, lagging, fit } = typed;
  if (!digitised.source.trim()) found["digitised.source"] = "Say who published the figure.";
  if (!digitised.slip_unit) found["digitised.slip_unit"] = "Choose the unit of slip in the figure.";
  if (lagging.thickness.trim() && lagging.shear_modulus.trim() && !fit.remove_shear)
    found["fit.remove_shear"] =
      "Does the slip of the figure include the sample's own shear? Yes takes it off.";
  return found;
}
/** @param {string} path */
export function rowOf(path) {
  const [part, key] = typedAt(path).split(".");
  return ROWS[part]?.some((r) => r.key === key);
}
/** Where something is typed that stands at a place of the plan. @param {string} path */
export const typedAt = (path) => (path || "").replace(/^fit\.fixed\./, "fixed.");
/** Rows of each part that are seen at once; the others are folded away. */
const FIRST = ["name", "thickness", "shear_modulus", "sample_area", "faces", "remove_shear"].concat(
  ["source", "figure", "quantity", "slip_unit", "pressure_unit", "slip_max"],
);
/** A few words for what a part says, where it is folded away. @param {string} part */
function summary(part) {
  const of = typed[part];
  if (part === "lagging")
    return [of.thickness, of.shear_modulus && `G ${of.shear_modulus}`].filter(Boolean).join(", ");
  if (part === "rig") return `${of.sample_area || "no area"}, ${of.faces || 2} faces`;
  if (part === "digitised") return LIST_WORDS[of.quantity];
  const set = [...Object.values(typed.fit), ...Object.values(typed.fixed)].filter(Boolean).length;
  return set ? `${set} set` : "best fit";
}
/** Parts that the user has folded or unfolded. */
const open = /** @type {Record<string, boolean>} */ ({});
/** The form: whole, or folded where the tests have its place.
 * @param {Record<string, string>} marks what is wrong with a row, by part and key
 * @param {boolean} folded */
export function planForm(marks, folded) {
  const parts = ["lagging", isFigure() ? "digitised" : "rig", "fit"];
  return h(
    "form",
    {
      class: `plan${folded ? " folded" : ""}`,
      "aria-label": "Lagging and rig",
      key: "plan",
      onSubmit: (/** @type {Event} */ e) => e.preventDefault(),
    },
    parts.map((part) => (folded ? foldedPart(part, marks) : wholePart(part, marks))),
  );
}
/** What is fitted. */
export const fromWhat = () =>
  oneOf(
    "t-from",
    "What is fitted",
    from,
    [
      ["tests", "Tests"],
      ["figure", "A published figure"],
    ],
    (value) => {
      from = value;
      redraw();
    },
  );
/** @param {string} part @param {Record<string, string>} marks */
function rowsOf(part, marks) {
  const make = (/** @type {string} */ of) => (/** @type {Row} */ r) =>
    row(of, r, marks[`${of}.${r.key}`]);
  const first = shown(part).filter((r) => FIRST.includes(r.key));
  const rest = shown(part).filter((r) => !first.includes(r));
  const fixed = part === "fit" ? shown("fixed") : [];
  const wrong = [...rest.map((r) => `${part}.${r.key}`), ...fixed.map((r) => `fixed.${r.key}`)];
  return [
    first.map(make(part)),
    rest.length + fixed.length > 0 &&
      h(
        "details",
        { class: "more", key: "more", open: wrong.some((key) => marks[key]) || undefined },
        h("summary", {}, "More"),
        rest.map(make(part)),
        fixed.length > 0 && h("p", { class: "help" }, TITLES.fixed),
        fixed.map(make("fixed")),
      ),
  ];
}
/** @param {string} part @param {Record<string, string>} marks */
const wholePart = (part, marks) =>
  h("fieldset", { key: part }, h("legend", {}, titleOf(part)), rowsOf(part, marks));
/** @param {string} part @param {Record<string, string>} marks */
function foldedPart(part, marks) {
  const wrong = Object.keys(marks).some(
    (key) => key.startsWith(part) || (part === "fit" && key.startsWith("fixed")),
  );
  return h(
    "details",
    {
      key: part,
      open: open[part] || wrong,
      onToggle: (/** @type {Event & {currentTarget: HTMLDetailsElement}} */ e) => {
        open[part] = e.currentTarget.open;
      },
    },
    h("summary", {}, h("b", {}, titleOf(part)), h("span", {}, summary(part))),
    rowsOf(part, marks),
  );
}
const titleOf = (/** @type {string} */ part) => TITLES[/** @type {"rig"} */ (part)];
/** @param {string} part @param {Row} r @param {string | undefined} problem */
function row(part, r, problem) {
  const id = `t-${part}-${r.key}`;
  const common = {
    id,
    value: typed[part][r.key],
    "aria-invalid": Boolean(problem),
    "aria-describedby": r.help ? `${id}-h ${id}-e` : `${id}-e`,
    title: r.help,
    onInput: (/** @type {any} */ e) => {
      typed[part][r.key] = e.currentTarget.value;
      redraw();
    },
  };
  const options = r.list?.map((x) =>
    h("option", { value: x, key: x }, (!x && r.none) || (LIST_WORDS[x] ?? x)),
  );
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
    r.help && h("span", { class: "away", id: `${id}-h` }, r.help),
    h("p", { class: "error", id: `${id}-e` }, problem),
  );
}
