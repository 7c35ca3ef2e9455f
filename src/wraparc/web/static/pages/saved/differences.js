// What differs between two versions of a design, value by value as it was typed.
import { scroll } from "../../parts/tables.js";
import { h } from "../../vendor/preact.js";

/** @import { Design } from "../../types.d.ts" */
/** @typedef {{place: string, before: string, after: string}} Difference */

/** @param {any} v */
const isTable = (v) => v !== null && typeof v === "object" && !Array.isArray(v);

/** Every value of a document with its place, as the command line names it.
 * @param {any} value @param {string} at @returns {Generator<[string, string]>} */
function* values(value, at = "") {
  const inside = (/** @type {string} */ key) => (at ? `${at}.${key}` : key);
  if (isTable(value)) for (const key of Object.keys(value)) yield* values(value[key], inside(key));
  else if (Array.isArray(value) && value.length > 0 && value.every(isTable))
    for (const [i, v] of value.entries()) yield* values(v, inside(`${v.name ?? i + 1}`));
  else yield [at, typeof value === "string" ? value : JSON.stringify(value)];
}

/** What differs, in the order of the later document, then what is gone from it.
 * @param {Design} before @param {Design} after @returns {Difference[]} */
export function differences(before, after) {
  const [was, is] = [new Map(values(before)), new Map(values(after))];
  const places = [...is.keys(), ...[...was.keys()].filter((place) => !is.has(place))];
  return places
    .map((place) => ({ place, before: was.get(place) ?? "", after: is.get(place) ?? "" }))
    .filter((d) => d.before !== d.after);
}

/** @param {Difference[]} found @param {string} before @param {string} after */
export const differenceTable = (found, before, after) =>
  found.length === 0
    ? h("p", { class: "help" }, `${before} and ${after} have the same values.`)
    : scroll(
        `Changes from ${before} to ${after}`,
        h(
          "table",
          { class: "grid-table" },
          h(
            "thead",
            {},
            h(
              "tr",
              {},
              ["Value", before, after].map((t) => h("th", { scope: "col", key: t }, t)),
            ),
          ),
          h(
            "tbody",
            {},
            found.map((d) =>
              h(
                "tr",
                { key: d.place },
                h("th", { scope: "row" }, d.place),
                h("td", {}, d.before || "–"),
                h("td", {}, d.after || "–"),
              ),
            ),
          ),
        ),
      );
