// One load case more. Fetched when it is asked for, or with what is turned less.
import { app, caseNames, change, set } from "../../base/design.js";

/** @import { Design } from "../../types.d.ts" */

/** One load case more, which is shown then. */
export function addCase() {
  const { load_case = [], train, pulley } = app.doc;
  const taken = ["design", ...load_case.map((c) => c.name)];
  let n = taken.length + 1;
  while (taken.includes(`case ${n}`)) n++;
  const name = `case ${n}`;
  const pulleys = train ? { train: {} } : { pulley: { [pulley[app.pulley].name || ""]: {} } };
  const doc = set(app.doc, ["load_case"], [...load_case, { name, ...pulleys }]);
  if (!train) app.case = firstOf(doc, name);
  change(doc);
}
/** A load case in the first condition that it is solved in.
 * @param {Design} doc @param {string} name */
export const firstOf = (doc, name) =>
  caseNames(doc).find((x) => `${x}, `.startsWith(`${name}, `)) ?? "";
