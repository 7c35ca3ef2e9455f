// What the server answers, as it is shown: badges, verdicts, tables, problems.

import { app } from "../base/design.js";
import { sentence } from "../base/server.js";
import { sign, words } from "../base/units.js";
import { Component, h } from "../vendor/preact.js";

/** @import { Children, Level, Problem, Table, TableRow, Text, Verdict } from "../types.d.ts" */

export const BELOW = "Inputs changed.";
/** Class and sign of each level. @type {Record<string, [string, string]>} */
const LEVELS = {
  "NOT CHECKED": ["", "–"],
  OK: ["good", "✓"],
  ATTENTION: ["warn", "▲"],
  FAILS: ["bad", "✕"],
  "INTERNAL ERROR": ["bad", "✕"],
};
/** @param {Level | null | undefined} level */
export const levelClass = (level) => (level ? LEVELS[level]?.[0] || "" : "");
/** @param {Level | null | undefined} level @param {string} [told] words in its place */
export const badge = (level, told) =>
  level
    ? h(
        "span",
        { class: `badge ${levelClass(level)}${told ? "" : " word"}` },
        h("span", { "aria-hidden": "true" }, `${LEVELS[level]?.[1]} `),
        told || level,
      )
    : null;
/** A box of words that scrolls sideways where the page is narrow.
 * @param {string} label @param {...Children} children */
export const scroll = (label, ...children) =>
  h("div", { class: "scroll", tabIndex: 0, role: "region", "aria-label": label }, ...children);

/**
 * How an answer stands to what is asked now.
 * @typedef {"fresh" | "computing" | "stale" | "refused" | "gone"} Standing
 */
/** @param {boolean} now whether it is of what is asked now @param {{length: number}} problems
 * @param {boolean} [busy] whether a newer one is on its way @returns {Standing} */
export const standing = (now, problems, busy = true) =>
  now ? "fresh" : problems.length ? "refused" : app.gone ? "gone" : busy ? "computing" : "stale";
/** A verdict, judged only where it is of what is asked now.
 * @param {Standing} how @param {Verdict} v @returns {Verdict} */
export const judgedIf = (how, v) =>
  how === "fresh" ? v : { ...v, level: /** @type {any} */ ("") };
/** An answer, or what is left of one that is of before.
 * @param {Standing} how @param {...Children} children */
export const stands = (how, ...children) =>
  h(
    "div",
    { "data-stands": how, key: "stands" },
    how !== "fresh" &&
      h("p", { class: "help", role: "status" }, how === "computing" && "Solving … ", BELOW),
    ...children,
  );

/** How many further checks a verdict names. */
const MOST_ALSO = 2;
/** @typedef {[label: string, text: string, on?: boolean]} Line whether on the line before */
/** Each line below the sentence of a verdict. @param {Verdict} v @returns {Line[]} */
export function linesOf({ level, action, changes = [], also = [], wet, reserve = [], data }) {
  const more = also.length - MOST_ALSO;
  const further = also
    .slice(0, MOST_ALSO)
    .map((a) => (a.level === level ? words(a.text) : `${a.level}: ${words(a.text)}`));
  const lines = /** @type {Line[]} */ ([
    ["Action", words(action?.text)],
    ...changes.map((text) => ["Change", words(text)]),
    ...further.map((text) => ["Also", text]),
    ["Also", more > 0 ? `${more} more.` : "", true],
    ["Wet", words(wet?.text)],
    ...reserve.map((text) => ["Reserve", words(text)]),
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
/** @param {Verdict} v @param {Children} [before] @param {Children} [after] what to do about it */
export const verdict = (v, before, after) =>
  h(
    "div",
    { class: `verdict ${levelClass(v.level)}` },
    before,
    h("p", { class: "headline" }, badge(v.level, v.label), " ", words(v.text)),
    h("p", { class: "lines" }, lined(linesOf(v))),
    after,
    list(v.sentences),
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
/** @param {string} headline @param {Problem[]} problems */
export const refused = (headline, problems) =>
  h(
    "div",
    { class: "verdict bad" },
    headline && h("p", { class: "headline" }, badge("FAILS"), ` ${headline}`),
    list(problems.map(sentence)),
  );

/**
 * A table, drawn anew when it is another one.
 * @typedef {{of: Table, open: boolean, units: string}} TableProps
 * @extends {Component<TableProps>}
 */
class Tabled extends Component {
  /** @param {TableProps} next */
  shouldComponentUpdate({ of, open, units }) {
    const now = this.props;
    return of !== now.of || open !== now.open || units !== now.units;
  }
  render() {
    const { of: t, open } = this.props;
    return h(
      "details",
      { class: `table t-${t.key}`, open },
      h("summary", {}, words(t.title)),
      scroll(
        words(t.title),
        h(
          "table",
          {},
          tableHead(t),
          h(
            "tbody",
            {},
            t.rows.map((r) => tableRow(t, r)),
          ),
        ),
      ),
      words(t.note) && h("p", { class: "help" }, words(t.note)),
    );
  }
}
/** @param {Table} t */
export const table = (t, open = true) =>
  h(Tabled, { of: t, open, units: app.units, key: t.key + words(t.title) });
/** @param {Table} t */
const columns = (t) => ({
  symbols: t.rows.some((r) => r.symbol),
  notes: t.rows.some((r) => words(r.note) || r.level),
});
/** @param {Table} t */
function tableHead(t) {
  const heads = t.heads.map(words);
  if (!heads.some(Boolean)) return null;
  const { symbols, notes } = columns(t);
  const cells = heads.map((x) => (x ? h("th", { scope: "col", class: "num" }, x) : h("td", {})));
  return h(
    "thead",
    {},
    h("tr", {}, h("td", {}), symbols && h("td", {}), cells, notes && h("td", {})),
  );
}
/** @param {Table} t @param {TableRow} r */
function tableRow(t, r) {
  const { symbols, notes } = columns(t);
  const said = r.values.some((v) => tells(words(v), r));
  return h(
    "tr",
    { class: levelClass(r.level) },
    h("th", { scope: "row", title: app.form.glossary[r.name]?.meaning ?? r.name }, words(r.title)),
    symbols && h("td", { class: "sym" }, sign(r.symbol)),
    r.values.map((v) =>
      h("td", { class: "num" }, tells(words(v), r) ? mark(words(v), r) : words(v)),
    ),
    notes && h("td", { class: "remark" }, said ? null : badge(r.level), " ", words(r.note)),
  );
}
/** Whether a value is the level of its row. @param {string} text @param {TableRow} r */
const tells = (text, r) => Boolean(r.level) && (text === r.level || text.startsWith(`${r.level} `));
/** @param {string} text @param {TableRow} r */
const mark = (text, r) => badge(r.level, text === r.level ? undefined : text);
