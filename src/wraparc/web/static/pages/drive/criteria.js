// What a drive is held against: take-up, design standard, safety factors, sag.

import { app, edit } from "../../base/design.js";
import { field, more } from "../../parts/field.js";

/** @import { Children, Spec } from "../../types.d.ts" */
/** @import { Choice } from "../../parts/field.js" */

/** @returns {Children[]} */
export const criteria = () =>
  app.form.sections
    .filter(({ key }) => app.form.criteria.includes(key))
    .map(({ key, title, fields }) =>
      more(
        title,
        fields
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
      choices: [{ choices: [["", "at T2 of the last drive"], ...names] }],
    }),
    put: (value) => {
      const next = { ...app.doc[table], [s.key]: value };
      if (value === undefined || value === "") delete next[s.key];
      // an empty table would ask for what it needs
      edit([table], Object.keys(next).length ? next : undefined);
    },
  });
}
