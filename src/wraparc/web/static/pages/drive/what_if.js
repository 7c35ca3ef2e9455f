// What if: wet, worn, bare, another lagging or belt, each beside the drive as it is.
import { app, redraw } from "../../base/design.js";
import { viewed, words } from "../../base/units.js";
import { choose, valueIn } from "../../parts/choose.js";
import { Question } from "../../parts/question.js";
import { h } from "../../vendor/preact.js";
import { askedCase } from "./cases.js";
import { laggingName } from "./inputs.js";

/** What is typed; empty where a change is not asked for, null where it is to be proposed. */
const said = {
  wet: "DIN 22101",
  worn: /** @type {string | null} */ (null),
  bare: "CEMA",
  thickness: "",
  lagging: "",
  belt: "",
  other_carcass: false,
};
const pulley = () => app.doc.pulley[app.pulley];
/** Half of the thickness there is. */
function half() {
  const { lagging } = pulley();
  const known = app.catalogue.laggings.find((l) => l.name === laggingName(lagging));
  const text = lagging?.thickness ?? words(known?.thickness);
  const [number, unit] = viewed(text, "length");
  return unit ? `${+number / 2} ${unit}` : "";
}
const some = (/** @type {string} */ text) => (text.trim() ? [text.trim()] : []);
const question = new Question("what-if", "What if …?", "what-if", () => ({
  pulley: pulley().name ?? null,
  load_case: askedCase(),
  wet: said.wet.trim(),
  worn: some(said.worn ?? half()),
  bare: said.bare,
  thicknesses: some(said.thickness),
  laggings: some(said.lagging),
  belts: some(said.belt),
  other_carcass: said.other_carcass,
}));
export const { open } = question;

/** @param {"wet" | "worn" | "thickness"} key @param {string} label @param {string} help */
const box = (key, label, help) =>
  h(
    "label",
    { key, title: help },
    label,
    h("input", {
      type: "text",
      size: 9,
      value: key === "worn" ? (said.worn ?? half()) : said[key],
      onInput: (/** @type {Event} */ e) => {
        said[key] = valueIn(e);
        redraw();
      },
    }),
  );
/** @param {"bare" | "lagging" | "belt"} key @param {string} label
 * @param {[string, string][]} choices */
const pick = (key, label, choices) =>
  h(
    "label",
    { key },
    label,
    choose(said[key], [["", "–"], ...choices], (v) => {
      said[key] = v;
      redraw();
    }),
  );
export function panel() {
  const { belts, laggings } = app.catalogue;
  const carcass = {
    type: "checkbox",
    checked: said.other_carcass,
    onChange: (/** @type {any} */ e) => {
      said.other_carcass = e.currentTarget.checked;
      redraw();
    },
  };
  return question.panel([
    box("wet", "Wet", "Friction when wet over dry, or DIN 22101 for its ratio; empty: not asked."),
    box("worn", "Worn to", "Thickness of the lagging that is left."),
    pick("bare", "Bare, by", [
      ["CEMA", "CEMA"],
      ["DIN 22101", "DIN 22101"],
    ]),
    box("thickness", "Thickness", "Lagging of this thickness, the diameter over it unchanged."),
    pick(
      "lagging",
      "Lagging",
      laggings.map((l) => [l.name, l.title || l.name]),
    ),
    pick(
      "belt",
      "Belt",
      belts.map((b) => [b.name, b.name]),
    ),
    h("label", { key: "carcass" }, "Other carcass", h("input", carcass)),
  ]);
}
