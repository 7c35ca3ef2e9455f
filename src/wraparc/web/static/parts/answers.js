// What the server answers, as it is shown: levels, the lines of a verdict.

import { app } from "../base/design.js";
import { words } from "../base/units.js";
import { h } from "../vendor/preact.js";

/** @import { Children, Level, Text, Verdict } from "../types.d.ts" */

export const BELOW = "Inputs changed.";
/** Class of each level. @type {Record<string, string>} */
const CLASSES = { OK: "good", ATTENTION: "warn", FAILS: "bad", "INTERNAL ERROR": "bad" };
/** @param {Level | null | undefined} level */
export const levelClass = (level) => (level && CLASSES[level]) || "";
/**
 * How an answer stands to what is asked now.
 * @typedef {"fresh" | "computing" | "stale" | "refused" | "gone"} Standing
 */
/** @param {boolean} now whether it is of what is asked now @param {{length: number}} problems
 * @param {boolean} [busy] whether a newer one is on its way @returns {Standing} */
export const standing = (now, problems, busy = true) =>
  now ? "fresh" : problems.length ? "refused" : app.gone ? "gone" : busy ? "computing" : "stale";
/** How many further checks a verdict names. */
const MOST_ALSO = 2;
/** @typedef {[label: string, text: string, on?: boolean]} Line whether on the line before */
/** Each line below the sentence of a verdict. @param {Verdict} v
 * @param {number} [most] further checks that are named @returns {Line[]} */
export function linesOf(
  { level, action, changes = [], also = [], wet, reserve_text, probability, data },
  most = MOST_ALSO,
) {
  const more = also.length - most;
  const further = also
    .slice(0, most)
    .map((a) => (a.level === level ? words(a.text) : `${a.level}: ${words(a.text)}`));
  const lines = /** @type {Line[]} */ ([
    ["Action", words(action?.text)],
    ...changes.map((text) => ["Change", words(text)]),
    ...further.map((text) => ["Also", text]),
    ["Also", more > 0 ? `${more} more.` : "", true],
    ["Wet", words(wet?.text)],
    ["Reserve", words(reserve_text)],
    ["Probability", words(probability?.text)],
    ["Data", words(data?.text)],
  ]);
  return lines.filter(([, text]) => text);
}
/** @param {Line[]} lines @returns {Children} */
export const lined = (lines) =>
  lines.map(([label, text, on], i) =>
    on
      ? null
      : h(
          "span",
          { class: "line", key: label + text },
          h("b", {}, label),
          " ",
          text,
          lines[i + 1]?.[2] && ` ${lines[i + 1][1]}`,
        ),
  );
/** @param {Text[] | undefined} texts @param {string} [cls] */
export const list = (texts, cls) =>
  texts && texts.length > 0
    ? h(
        "ul",
        { class: cls },
        texts.map((t, i) => h("li", { key: i }, words(t))),
      )
    : null;
