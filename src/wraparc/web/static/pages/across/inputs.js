// What is uneven across the width: crown, profiles drawn or measured, skew, spans, stiffness.
import { app, redraw, set } from "../../base/design.js";
import { changeNaming, noteUndo } from "../../base/removed.js";
import { act, ask, note } from "../../base/server.js";
import { si, words } from "../../base/units.js";
import { choose, valueIn } from "../../parts/choose.js";
import { field, more, spec } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";
import { Editor } from "./editor.js";
import {
  acrossOf,
  KINDS,
  putAcross,
  rowsOf,
  SHAPES,
  shaped,
  withCrown,
  withRows,
} from "./profile.js";

/** @import { Children, Spec } from "../../types.d.ts" */
/** @import { Kind } from "./profile.js" */

export const drawn = { key: "worn_depth", height: "2 mm", unit: "", fresh: "" };
const PAGE = "x";

/** @param {string} title @param {Children[]} rows */
const group = (title, rows) => h("fieldset", { key: title }, h("legend", {}, title), rows);
/** A single number of [pulley.across]. @param {number} i @param {Spec} s @param {any} [more] */
const one = (i, s, more) =>
  field({
    spec: s,
    path: ["pulley", i, "across", s.key],
    page: PAGE,
    slider: false,
    put: (value) => putAcross(i, s.key, value),
    ...more,
  });

/** The form of the page. */
export function acrossInputs() {
  const i = app.pulley;
  return h(
    "form",
    {
      class: "inputs rail card",
      "aria-label": "Across the width",
      onSubmit: (e) => e.preventDefault(),
    },
    h("div", { class: "profile", key: "profile" }, profile(i)),
    group("Pulley", defects(i)),
    group("Belt before and after", [
      ...spans(i),
      field({
        spec: { ...spec("belt", "in_plane_shear_stiffness"), title: "In-plane stiffness" },
        path: ["belt", "in_plane_shear_stiffness"],
        page: PAGE,
        slider: false,
        placeholder: "estimated",
      }),
    ]),
  );
}
/** The kind of profile that is drawn. */
export const kindDrawn = () => KINDS.find((k) => k.key === drawn.key) || KINDS[0];
/** @param {number} i @returns {Children[]} */
function profile(i) {
  const kind = kindDrawn();
  // the mark has its place before it is seen: nothing moves by it
  const given = (/** @type {string} */ key) =>
    acrossOf(i)[key] === undefined ? { visibility: "hidden" } : {};
  return [
    h(
      "div",
      { class: "tabs", role: "group", "aria-label": "Which profile", key: "which" },
      KINDS.map((k) =>
        h(
          "button",
          {
            type: "button",
            key: k.key,
            "aria-pressed": k.key === kind.key,
            onClick: () => {
              turnTo(k);
              redraw();
            },
          },
          k.title,
          h("span", { class: "mark", style: given(k.key), role: "img", "aria-label": "given" }),
        ),
      ),
    ),
    h(Editor, { pulley: i, kind, key: `${kind.key}${i}${app.opened}` }),
    shapes(i, kind),
    measured(i),
  ];
}
/** @param {Kind} kind */
function turnTo({ key, dimension }) {
  drawn.key = key;
  drawn.height = dimension === "length" ? usual() : "5 kN/m";
}
/** Show a profile that is given, if any is. @param {number} i */
export function drawGiven(i) {
  const kind = KINDS.find((k) => acrossOf(i)[k.key] !== undefined);
  if (kind) turnTo(kind);
}
const usual = () => (app.units === "us" ? "0.08 in" : "2 mm");
/** Shapes to begin with. @param {number} i @param {Kind} kind */
function shapes(i, kind) {
  const height = si(drawn.height, kind.dimension);
  const draw = (/** @type {string} */ name) => () => {
    if (!Number.isFinite(height))
      return note(`Give a height with its unit, such as ${usual()}.`, true);
    const rows = shaped(name, height, kind.dimension);
    const before = rowsOf(acrossOf(i)[kind.key]).length > 0;
    putAcross(i, kind.key, withRows(acrossOf(i)[kind.key], rows));
    if (before) noteUndo("The shape replaces the profile before. ");
  };
  return h(
    "div",
    { class: "inline shapes", role: "group", "aria-label": "Begin with a shape", key: "shapes" },
    h(
      "label",
      {},
      h("span", { class: "away" }, "Draw "),
      h("input", {
        type: "text",
        id: "shape-height",
        size: 7,
        value: drawn.height,
        "aria-label": "Height of the shape",
        onInput: (e) => {
          drawn.height = valueIn(e);
          redraw();
        },
      }),
    ),
    SHAPES.map(([name, text, course]) =>
      h(
        "button",
        {
          ...{ type: "button", key: name, id: `shape-${name}`, onClick: draw(name) },
          ...{ title: text, "aria-label": `Draw ${text}` },
        },
        shapeOf(course, kind),
      ),
    ),
  );
}
/** A shape as it would be drawn. @param {[number, number][]} course @param {Kind} kind */
function shapeOf(course, { sign }) {
  const points = course.map(([y, v]) => {
    const low = sign === "down" ? 3 + 10 * v : 13 - 10 * v;
    return `${(12 + 10 * y).toFixed(1)} ${low.toFixed(1)}`;
  });
  return h(
    "svg",
    { viewBox: "0 0 24 16", width: 24, height: 16, "aria-hidden": "true" },
    h("path", { d: `M${points.join("L")}`, class: "shape-line" }),
  );
}
/** A file of readings over the face. @param {number} i */
function measured(i) {
  const read = act(async (e) => {
    const box = /** @type {HTMLInputElement} */ (e.currentTarget);
    const file = box.files?.[0];
    box.value = "";
    if (!file) return;
    const data = new FormData();
    data.append("file", file, file.name);
    data.append("width", String(app.doc.belt.width ?? ""));
    data.append("unit", drawn.unit);
    data.append("new", drawn.fresh);
    const answer = await ask("across/profile", data);
    drawn.key = answer.key;
    putAcross(i, answer.key, answer.profile);
    noteUndo(answer.told.map(words).join(" "), " ");
  });
  const open = () => document.getElementById("profile-file")?.click();
  const units = /** @type {[string, string][]} */ ([
    ["", "units as in the file"],
    ["mm", "all in mm"],
    ["in", "all in inches"],
  ]);
  const put = (/** @type {string} */ u) => {
    drawn.unit = u;
    redraw();
  };
  return h(
    "div",
    { class: "inline measured", key: "measured" },
    h("input", {
      type: "file",
      id: "profile-file",
      class: "away",
      tabIndex: -1,
      accept: ".csv,.txt,.tsv,.xlsx,.xls",
      "aria-label": "File of readings over the face",
      onChange: read,
    }),
    h("button", { type: "button", id: "load-profile", onClick: open }, "Load readings …"),
    more(
      "More: units, new lagging",
      [
        h(
          "label",
          { key: "unit" },
          h("span", { class: "away" }, "Units of the readings"),
          choose(drawn.unit, units, put, "profile-unit"),
        ),
        h(
          "label",
          { key: "new" },
          "new lagging ",
          h("input", {
            type: "text",
            id: "profile-new",
            size: 7,
            value: drawn.fresh,
            placeholder: "thickest",
            onInput: (e) => {
              drawn.fresh = valueIn(e);
            },
          }),
        ),
        h(
          "p",
          { class: "help", key: "help" },
          "A table of positions and depths, thicknesses, diameters or radii: text or Excel.",
        ),
      ],
      false,
      "readings",
    ),
  );
}

/** @type {Spec} */
const CROWN = {
  key: "crown",
  title: "Crown, on radius",
  kind: "quantity",
  dimension: "length",
  help: "Height of the middle of the shell over its edges, half of that on diameter.",
};
/** @type {Spec} */
const SKEW = {
  key: "misalignment",
  title: "Misalignment",
  kind: "number",
  dimension: "number",
  help:
    "Skew of the pulley in the plane of the bisector of its wrap, in mm per m of width: " +
    "2 is read as 2 mm/m.",
};
/** @param {number} i @returns {Children[]} */
function defects(i) {
  const shell = acrossOf(i).shell_profile;
  return [
    field({
      spec: CROWN,
      path: ["pulley", i, "across", "shell_profile", "crown"],
      page: PAGE,
      slider: false,
      placeholder: "0 mm",
      read: () => (Array.isArray(shell) ? undefined : shell?.crown),
      put: (value) => putAcross(i, "shell_profile", withCrown(shell, value)),
    }),
    one(i, SKEW, {
      placeholder: "0 mm/m",
      put: (/** @type {any} */ value) =>
        putAcross(i, "misalignment", typeof value === "number" ? `${value} mm/m` : value),
    }),
    one(i, { ...spec("across", "deflection"), title: "Shaft deflection" }, { placeholder: "0 mm" }),
  ];
}

const ENDS = /** @type {[string, string][]} */ ([
  ["far", "far away"],
  ["pulley", "another pulley"],
  ["transition", "trough transition"],
]);
/** @param {number} i @returns {Children[]} */
function spans(i) {
  return [...end(i, "before", "Before", ENDS), ...end(i, "after", "After", ENDS.slice(0, 2))];
}
/** @param {number} i @param {string} key @param {string} title @param {[string, string][]} ends
 * @returns {Children[]} */
function end(i, key, title, ends) {
  const now = acrossOf(i)[key];
  const kind = now && typeof now === "object" ? now.kind : "far";
  const put = (/** @type {string} */ to) => {
    const angle = to === "transition" ? { trough_angle: "35 deg" } : {};
    const next = { ...acrossOf(i), [key]: to === "far" ? undefined : { kind: to, ...angle } };
    if (to === "far") delete next[key];
    const left = Object.keys(next).length ? next : undefined;
    changeNaming(set(app.doc, ["pulley", i, "across"], left), ["kind"]);
  };
  const fields = kind === "transition" ? "transition" : kind === "pulley" ? "gripping" : "";
  /** @type {Record<string, string[]>} */
  const keys = {
    transition: ["length", "trough_angle", "centre_roll", "depth"],
    gripping: ["distance"],
  };
  return [
    h(
      "div",
      { class: "field wide", key },
      h("label", { for: `across-${key}` }, title),
      h("span", {}),
      h("span", { class: "box" }, choose(kind, ends, put, `across-${key}`)),
    ),
    ...(keys[fields] || []).map((k) =>
      field({
        spec: spec(fields, k),
        path: ["pulley", i, "across", key, k],
        page: PAGE,
        slider: false,
        put: (value) => {
          const next = { ...now, [k]: value };
          if (value === undefined) delete next[k];
          putAcross(i, key, next);
        },
      }),
    ),
  ];
}
