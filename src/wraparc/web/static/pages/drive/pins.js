// What stands beside the arc in the plots: the paper's march, and a design that was pinned.
import { app, redraw } from "../../base/design.js";
import { shown, title } from "../../base/units.js";
import { scroll } from "../../parts/answers.js";
import { h } from "../../vendor/preact.js";
import { alongside } from "./pictures.js";

/** @import { QuickAnswer } from "../../types.d.ts" */

/** Numbers that are set beside those of the pinned design. */
const NAMES = [
  "entry_tension",
  "exit_tension",
  "exit_creep",
  "exit_slip",
  "peak_shear_stress",
  "peak_shear_angle",
  "power_loss",
];
/** @param {Partial<typeof alongside>} what */
function put(what) {
  Object.assign(alongside, what, { turn: alongside.turn + 1 });
  redraw();
}
/** @param {QuickAnswer} arc */
function pin({ numbers, profile, load_case }) {
  const name = `${app.doc.title || app.name || "this drive"}, load case ${load_case}`;
  put({ pinned: { name, numbers, profile } });
}
/** @param {number | null | undefined} now @param {number | null | undefined} then
 * @param {string} name */
function difference(now, then, name) {
  if (now == null || then == null) return "–";
  const sign = now > then ? "+" : "";
  return now === then ? "–" : `${sign}${shown(name, now - then, 3)}`;
}
/** @param {QuickAnswer} arc */
export function pins(arc) {
  const { pinned, march } = alongside;
  const tick = {
    type: "checkbox",
    id: "march",
    checked: march,
    onChange: () => put({ march: !march }),
  };
  const button = (/** @type {string} */ text, /** @type {() => void} */ f) =>
    h("button", { type: "button", onClick: f, key: text }, text);
  return [
    h(
      "p",
      { class: "inline", key: "controls" },
      h("label", { class: "inline" }, h("input", tick), "Paper's march beside it"),
      button(pinned ? "Pin this design instead" : "Pin this design", () => pin(arc)),
      pinned && button("Take the pin out", () => put({ pinned: null })),
    ),
    pinned && differences(arc, pinned),
  ];
}
/** @param {QuickAnswer} arc @param {NonNullable<typeof alongside.pinned>} pinned */
function differences({ numbers: now }, { name, numbers: then }) {
  const row = (/** @type {string} */ key) =>
    h(
      "tr",
      { key },
      h("th", { scope: "row" }, title(key)),
      [shown(key, then[key], 3), shown(key, now[key], 3), difference(now[key], then[key], key)].map(
        (text, i) => h("td", { class: "num", key: i }, text),
      ),
    );
  const heads = ["Pinned", "Now", "Difference"];
  return scroll(
    `Differences from the pinned design, ${name}`,
    h(
      "table",
      { class: "grid-table pinned-table", key: "differences" },
      h("caption", {}, `Pinned: ${name}`),
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("td", {}),
          heads.map((t) => h("th", { scope: "col", class: "num", key: t }, t)),
        ),
      ),
      h("tbody", {}, NAMES.map(row)),
    ),
  );
}
