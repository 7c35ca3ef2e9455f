// Load cases: which is looked at, and one more.
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
/** Whether load cases give tensions beside those of the pulleys. */
export const byCase = () => app.doc.load_case && !app.doc.conveyor && !app.doc.train;
/** Whether the tensions of the pulleys make a load case, as they do where they are whole. */
export function isCase() {
  const { pulley, belt } = app.doc;
  const given = pulley.map((p) => [
    p.entry_tension != null,
    p.exit_tension != null,
    (p.effective_tension ?? p.torque ?? (belt.speed != null ? p.power : null)) != null,
  ]);
  for (const _ of [...given, ...given])
    given.forEach((g, i) => {
      g[0] ||= (g[1] && g[2]) || given[i - 1]?.[1];
      g[1] ||= (g[0] && g[2]) || given[i + 1]?.[0];
    });
  return given.every((g) => g[0] && g[1]);
}
/** Whether the load case that is looked at lacks a tension, others being there: it is left out. */
export const lacking = () => /^design(,|$)/.test(app.case) && byCase() && !isCase();
/** The load case to ask for; null where the server is to say which is meant. */
export const askedCase = () => (!lacking() && app.case) || null;
