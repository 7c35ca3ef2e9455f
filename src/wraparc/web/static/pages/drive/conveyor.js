// The conveyor in the place of tensions: its resistances give the pull of every load case.

import { app, change, set } from "../../base/design.js";
import { written } from "../../base/units.js";
import { field, more, section } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";

/** @import { Children } from "../../types.d.ts" */
/** @import { Now } from "./inputs.js" */

/** Fields that are seen at once; the others are folded away. */
const FIRST = [
  "length",
  "lift",
  "capacity",
  "belt_mass",
  "carry_idler_mass",
  "return_idler_mass",
  "take_up_tension",
  "counterweight",
  "start_factor",
  "stop_time",
];

/** @param {string[]} tensions keys of a pulley that give its load @param {Now} now
 * @returns {Children[]} */
export function conveyor(tensions, now) {
  if (app.doc.conveyor) return given(now);
  if (app.doc.train || app.doc.pulley.length > 1) return [];
  const describe = () => {
    const pulley = Object.fromEntries(
      Object.entries(app.doc.pulley[0]).filter(([key]) => !tensions.includes(key)),
    );
    const { load_case: _, ...rest } = app.doc;
    change({ ...rest, conveyor: { lift: "0 m" }, pulley: [pulley] });
    requestAnimationFrame(() => document.getElementById("f-conveyor-length")?.focus());
  };
  return [
    h(
      "button",
      { type: "button", id: "describe-conveyor", key: "describe", onClick: describe },
      "Tensions from the conveyor",
    ),
  ];
}
/** @param {Now} now @returns {Children[]} */
function given(now) {
  const fields = section("conveyor");
  const row = (/** @type {any} */ s) =>
    field({ spec: s, path: ["conveyor", s.key], slider: false, placeholder: "" });
  const remove = () => {
    const { conveyor: _, ...rest } = app.doc;
    const numbers = now();
    let doc = /** @type {typeof app.doc} */ (rest);
    for (const key of ["entry_tension", "exit_tension"])
      if (numbers) doc = set(doc, ["pulley", 0, key], written(numbers[key], "force", 5));
    change(doc);
    requestAnimationFrame(() => document.getElementById("describe-conveyor")?.focus());
  };
  return [
    h(
      "p",
      { class: "help", key: "help" },
      "By DIN 22101 and ISO 5048; the load cases full, empty, start and stop follow from it.",
    ),
    ...FIRST.map((key) => fields.find((f) => f.key === key)).map((f) => f && row(f)),
    more(
      "More of the conveyor",
      fields.filter((f) => !FIRST.includes(f.key)).map(row),
      undefined,
      "conveyor",
    ),
    h("button", { type: "button", key: "remove", onClick: remove }, "Give the tensions themselves"),
  ];
}
