// Which pulley and load case govern.

/** @import { FullArc, Level } from "../../types.d.ts" */

const LEVELS = ["OK", "ATTENTION", "FAILS", "INTERNAL ERROR"];
export const rank = (/** @type {{level: Level}} */ a) => LEVELS.indexOf(a.level);
/** Which comes off worse, as the program has it. @param {FullArc} a @param {FullArc} b */
export const worseThan = (a, b) => rank(b) - rank(a) || a.order - b.order;
/** The pulley and load case that govern. @param {FullArc[]} arcs */
export const worstOf = (arcs) => [...arcs].sort(worseThan)[0];
