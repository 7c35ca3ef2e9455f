// What a drive is held against: take-up, design standard, safety factors, sag.

import { app, edit } from "../../base/design.js";
import { field, more, section } from "../../parts/field.js";

/** @import { Children, Spec } from "../../types.d.ts" */
/** @import { Choice } from "../../parts/field.js" */

const TABLES = {
  take_up: "Take-up",
  design_standard: "Design standard",
  safety_factor: "Safety factors",
  sag: "Belt sag",
};

/** @returns {Children[]} */
export const criteria = () =>
  Object.entries(TABLES).map(([key, title]) =>
    more(
      title,
      section(key)
        .filter((s) => s.key !== "after" || app.doc.pulley.length > 1)
        .map((s) => row(key, s)),
      Boolean(app.doc[key]),
      key,
    ),
  );

/** @param {string} table @param {Spec} s */
function row(table, s) {
  const names = app.doc.pulley.map((p) => /** @type {Choice} */ ([p.name || "", p.name || ""]));
  return field({
    spec: s,
    path: [table, s.key],
    slider: false,
    placeholder: "",
    ...(s.key === "after" && {
      choices: [{ choices: [["", "on the slack side of all"], ...names] }],
    }),
    put: (value) => {
      const next = { ...app.doc[table], [s.key]: value };
      if (value === undefined || value === "") delete next[s.key];
      // an empty table would ask for what it needs
      edit([table], Object.keys(next).length ? next : undefined);
    },
  });
}
