// A pinned design beside the present one, in numbers. Fetched when the first is pinned.
import { keyFigures, shown, title } from "../../base/units.js";
import { scroll } from "../../parts/tables.js";
import { h } from "../../vendor/preact.js";

/** @import { QuickAnswer } from "../../types.d.ts" */
/** @import { Pinned } from "./pictures.js" */

/** @param {number | null | undefined} now @param {number | null | undefined} then
 * @param {string} name */
function difference(now, then, name) {
  if (now == null || then == null) return "–";
  const sign = now > then ? "+" : "";
  return now === then ? "–" : `${sign}${shown(name, now - then, 3)}`;
}
/** @param {QuickAnswer} arc @param {Pinned} pinned */
export function differences({ numbers: now }, { name, numbers: then }) {
  const row = (/** @type {string} */ key) =>
    h(
      "tr",
      { key },
      h("th", { scope: "row" }, title(key)),
      [shown(key, then[key], 3), shown(key, now[key], 3), difference(now[key], then[key], key)].map(
        (text, i) => h("td", { class: "num", key: i }, text),
      ),
    );
  const known = (/** @type {string} */ key) => now[key] != null || then[key] != null;
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
      h("tbody", {}, keyFigures("pins").filter(known).map(row)),
    ),
  );
}
