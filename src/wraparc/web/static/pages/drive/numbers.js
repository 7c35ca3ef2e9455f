// The numbers of the checks of some arcs, by the functions of the server, translated.
import { in_page__judged as judged } from "../../kernel.js";

/** @import { Arc } from "../../types.d.ts" */
/** @typedef {{law: any, given: Record<string, number>, tested: Arc["tested"],
 *   criteria: Record<string, number>}} Asked */

const POINTS = 180;

/** Numbers of every arc; null where one is for the server. @param {Asked[]} asked
 * @returns {any[] | null} */
export function numbersOfAll(asked) {
  const found = [];
  for (const { law, given, tested, criteria } of asked) {
    const numbers = judged(law, given, tested, criteria, POINTS);
    if (!numbers) return null;
    found.push(numbers);
  }
  return found;
}
