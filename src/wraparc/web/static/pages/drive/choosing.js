// Which design keeps every limit and costs least: the candidates and what they cost.
import { app, caseNames, redraw } from "../../base/design.js";
import { valueIn } from "../../parts/choose.js";
import { numberOf, Question } from "../../parts/question.js";
import { h } from "../../vendor/preact.js";
import { laggingName } from "./inputs.js";

const said = {
  laggings: /** @type {Set<string> | null} */ (null),
  belts: /** @type {string[]} */ ([]),
  thicknesses: "",
  diameters: "",
  wrap_angles: "",
  slack_tensions: "least",
  currency: "AUD",
  years: "10",
  tariff: "",
  hours: /** @type {Record<string, string>} */ ({}),
};
/** Quantities of a list, "10; 12; 15 mm": one without a unit has that of the last.
 * @param {string} text */
function quantities(text) {
  const parts = text.split(/\s*;\s*|,\s+/).filter(Boolean);
  const unit = parts.at(-1)?.replace(/^[-+\d.,eE\s]+/, "") ?? "";
  return parts.map((part) => (/[a-z°'"]/i.test(part) || !unit ? part : `${part} ${unit}`));
}
const laggings = () => said.laggings ?? new Set(app.catalogue.laggings.map((l) => l.name));
function hours() {
  const given = caseNames(app.doc).filter((name) => said.hours[name]?.trim());
  return Object.fromEntries(given.map((name) => [name, numberOf(said.hours[name])]));
}
const question = new Question("choosing", "Which design has the lowest cost?", "choose", () => {
  const slack = said.slack_tensions.trim();
  const least = slack === "least";
  return {
    pulley: app.doc.pulley[app.pulley].name ?? null,
    laggings: [...laggings()],
    belts: said.belts,
    thicknesses: quantities(said.thicknesses),
    diameters: quantities(said.diameters),
    wrap_angles: quantities(said.wrap_angles),
    slack_tensions: least ? [] : quantities(slack),
    least_slack: least,
    currency: said.currency.trim(),
    years: numberOf(said.years),
    tariff: said.tariff.trim() ? numberOf(said.tariff) : null,
    hours: said.tariff.trim() ? hours() : {},
  };
});
/** Nothing is searched before the candidates are named. */
export function open() {
  question.shown = true;
  redraw();
}
/** @param {string} label @param {string} value @param {(v: string) => void} put
 * @param {string} [hint] @param {number} [size] */
const box = (label, value, put, hint, size = 14) =>
  h(
    "label",
    { key: label },
    label,
    h("input", {
      type: "text",
      size,
      value,
      placeholder: hint,
      onInput: (/** @type {Event} */ e) => {
        put(valueIn(e));
        redraw();
      },
    }),
  );
/** @param {"thicknesses" | "diameters" | "wrap_angles" | "slack_tensions" | "currency" | "years" |
 *   "tariff"} key
 * @param {string} label @param {string} [hint] @param {number} [size] */
const text = (key, label, hint, size) =>
  box(
    label,
    said[key],
    (v) => {
      said[key] = v;
    },
    hint,
    size,
  );
function candidates() {
  const chosen = laggings();
  const now = laggingName(app.doc.pulley[app.pulley].lagging);
  return h(
    "fieldset",
    { class: "ticks", key: "laggings" },
    h("legend", {}, "Laggings"),
    app.catalogue.laggings.map(({ name, title }) => {
      const tick = {
        type: "checkbox",
        checked: chosen.has(name),
        onChange: () => {
          said.laggings = new Set(chosen);
          if (!said.laggings.delete(name)) said.laggings.add(name);
          redraw();
        },
      };
      return h("label", { key: name }, h("input", tick), ` ${title}`, name === now && " (present)");
    }),
  );
}
function belts() {
  const list = {
    multiple: true,
    size: 4,
    onChange: (/** @type {any} */ e) => {
      said.belts = [...e.currentTarget.selectedOptions].map((o) => o.value);
      redraw();
    },
  };
  const options = app.catalogue.belts.map(({ name }) =>
    h("option", { value: name, key: name, selected: said.belts.includes(name) }, name),
  );
  return h("label", { key: "belts" }, "Belts, the present one if none", h("select", list, options));
}
export const panel = () =>
  question.panel([
    candidates(),
    belts(),
    text("thicknesses", "Thicknesses", "10; 12; 15 mm"),
    text("diameters", "Diameters", "800; 1000 mm"),
    text("wrap_angles", "Wrap angles", "180; 210 deg"),
    text("slack_tensions", "Slack-side tensions", "minimum, or 60; 80 kN"),
    text("currency", "Currency", "", 5),
    text("years", "Years", "", 4),
    text("tariff", "Price of a kWh", "energy left out", 12),
    ...(said.tariff.trim()
      ? caseNames(app.doc).map((name) =>
          box(
            `Hours a year, ${name}`,
            said.hours[name] ?? "",
            (v) => {
              said.hours[name] = v;
            },
            "0",
            6,
          ),
        )
      : []),
  ]);
