// The numbers of the checks of some arcs, by the functions of the server, translated.
import { in_page__covered_creep as coveredCreep, in_page__judged as judged } from "../../kernel.js";

/** @import { Arc } from "../../types.d.ts" */
/** @typedef {{law: any, given: Record<string, number>, tested: Arc["tested"],
 *   criteria: Record<string, number>, cover?: number, among?: Record<string, number>}} Asked */

const POINTS = 180;

/** Numbers of every arc; null where one is for the server. @param {Asked[]} asked
 * @returns {any[] | null} */
export function numbersOfAll(asked) {
  const found = [];
  for (const { law, given, tested, criteria, cover, among } of asked) {
    /** @type {any} */
    const numbers = judged(law, given, tested, criteria, POINTS, /** @type {any} */ (among));
    if (!numbers) return null;
    if (cover) {
      const cover_creep = coveredCreep(law, given, cover);
      numbers.covered = Number.isFinite(cover_creep) ? "carried" : "through";
      numbers.values = { ...numbers.values, cover_creep };
      numbers.limits = { ...numbers.limits, cover_creep: given.creep_limit };
    }
    found.push(numbers);
  }
  return found;
}
