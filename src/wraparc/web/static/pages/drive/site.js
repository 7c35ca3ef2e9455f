// On site: speeds to measure, alarm and trip levels, how long the lagging lasts.
import { app, caseNames, redraw } from "../../base/design.js";
import { valueIn } from "../../parts/choose.js";
import { numberOf, Question } from "../../parts/question.js";
import { h } from "../../vendor/preact.js";

const said = {
  hours: /** @type {Record<string, string>} */ ({}),
  wear_hours: /** @type {Record<string, string>} */ ({}),
  wear_coefficient: "",
  measured_wear: "",
  depth: "",
};
/** @param {Record<string, string>} texts */
const numbers = (texts) =>
  Object.fromEntries(
    Object.entries(texts)
      .filter(([name, text]) => text.trim() && caseNames(app.doc).includes(name))
      .map(([name, text]) => [name, numberOf(text)]),
  );
const question = new Question("site", "What to expect on site", "field", () => ({
  pulley: app.doc.pulley[app.pulley].name ?? null,
  hours: numbers(said.hours),
  ...(said.measured_wear.trim() && {
    measured_wear: said.measured_wear.trim(),
    wear_hours: numbers(said.wear_hours),
  }),
  wear_coefficient: said.wear_coefficient.trim(),
  depth: said.depth.trim(),
}));
export const { open } = question;

/** @param {string} label @param {string} value @param {(v: string) => void} put
 * @param {string} [hint] */
const box = (label, value, put, hint) =>
  h(
    "label",
    { key: label },
    label,
    h("input", {
      type: "text",
      size: 10,
      value,
      placeholder: hint,
      onInput: (/** @type {Event} */ e) => {
        put(valueIn(e));
        redraw();
      },
    }),
  );
/** @param {"wear_coefficient" | "measured_wear" | "depth"} key @param {string} label
 * @param {string} hint */
const text = (key, label, hint) =>
  box(
    label,
    said[key],
    (v) => {
      said[key] = v;
    },
    hint,
  );
export function panel() {
  const cases = caseNames(app.doc);
  /** @param {"hours" | "wear_hours"} key @param {string} words */
  const hours = (key, words) =>
    cases.map((name) =>
      box(`${words}, ${name}`, said[key][name] ?? "", (v) => {
        said[key][name] = v;
      }),
    );
  return question.panel([
    ...hours("hours", "Hours a year"),
    text("wear_coefficient", "Wear coefficient", "of the lagging"),
    text("depth", "Depth to wear off", "half of it"),
    text("measured_wear", "Measured wear", "such as 1 mm"),
    ...(said.measured_wear.trim() ? hours("wear_hours", "Hours that it took") : []),
  ]);
}
