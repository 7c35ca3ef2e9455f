// The checks as bars against their limits: the limit stands in the middle of each.
import { words } from "../../base/units.js";
import { badge, levelClass } from "../../parts/answers.js";
import { h } from "../../vendor/preact.js";

/** @import { Bar } from "../../types.d.ts" */

/** Places of the limit and of what is beyond twice the limit [% of the bar]. */
const [LIMIT, MOST] = [50, 100];

/** @param {Bar[] | undefined} all */
export const bars = (all) =>
  all &&
  all.length > 0 &&
  h(
    "section",
    { class: "card checks", "aria-label": "Checks against their limits", key: "bars" },
    h("ul", {}, all.map(bar)),
  );
/** @param {Bar} b */
const bar = (b) =>
  h(
    "li",
    { key: b.title, class: levelClass(b.level), title: b.place },
    h("span", {}, badge(b.level, b.title)),
    h("small", {}, `${words(b.found)}, ${words(b.limit)}`),
    h(
      "i",
      { class: `gauge${b.at_most ? "" : " least"}`, "aria-hidden": "true" },
      h("i", { style: { width: `${Math.max(0, Math.min(MOST, b.share * LIMIT))}%` } }),
    ),
  );
