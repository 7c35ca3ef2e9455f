// The form of a study: what is varied, how it is drawn, and how accurately it is solved.
import { app, redraw } from "../../base/design.js";
import { save } from "../../base/save.js";
import { act, ask, note } from "../../base/server.js";
import { Box } from "../../parts/box.js";
import { choose } from "../../parts/choose.js";
import { spec } from "../../parts/field.js";
import { scroll } from "../../parts/tables.js";
import { h } from "../../vendor/preact.js";
import { asFile, axis, DISTRIBUTIONS, fields, KINDS, plan, scaled } from "./plan.js";

/** @import { Children } from "../../types.d.ts" */
/** @import { Axis } from "./plan.js" */

/** @param {string} text @param {Children} e */
const label = (text, e) => h("label", { key: text }, text, e);
/** @param {string | undefined} text @param {(v: string) => void} put @param {number} size */
const input = (text, put, size) =>
  h(Box, {
    value: text ?? "",
    size,
    put: (/** @type {string} */ v) => {
      put(v);
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
async function download() {
  const { toml, name } = await ask("studies/toml", { study: asFile(), document: app.doc });
  save(name, toml, "application/toml");
  note(`${name} names its drive file: File, Download puts that beside it for wraparc study.`);
}
/** @param {() => Promise<void>} begin starts the study */
export function form(begin) {
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
    Object.assign(plan, { kind: v, axes: null, more: {} });
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
      "Variables",
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
      h("button", { type: "button", onClick: act(download) }, "Download the study file"),
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
/** Words of fields that no form has. @type {Record<string, string>} */
const WORDS = {
  friction_factor: "Friction factor of the lagging",
  slip_factor: "Slip factor of the lagging",
  "belt.preset": "Belt of the catalogue",
};
/** A field in words; its path where there are none. @param {string} field */
function fieldName(field) {
  const [first, name, ...rest] = field.split(".");
  const key = rest[rest.length - 1] ?? name;
  if (WORDS[field] || WORDS[key]) return WORDS[field] || WORDS[key];
  const sections = first === "belt" ? ["belt"] : ["lagging", "tensions", "pulley"];
  const known = first === "belt" || first === "pulley";
  const found = known && sections.map((s) => spec(s, key)).find((s) => s.title !== key);
  return found ? `${found.title}${app.doc.pulley.length > 1 ? `, ${name}` : ""}` : field;
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
        "Variables",
        pick(
          a.field,
          possible.map((n) => [n, fieldName(n)]),
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
      h(
        "button",
        { type: "button", "aria-label": `Take out ${fieldName(a.field)}`, onClick: remove },
        "✕",
      ),
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
