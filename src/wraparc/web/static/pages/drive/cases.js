// Load cases: which is looked at.
import { app } from "../../base/design.js";

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
