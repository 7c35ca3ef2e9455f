// Answers below the first screen: badges, verdicts with their reasons, tables.
import { app } from "../base/design.js";
import { act, note, sentence } from "../base/server.js";
import { sign, words } from "../base/units.js";
import { Component, h } from "../vendor/preact.js";
import { BELOW, levelClass, lined, linesOf, list } from "./answers.js";

/** @import { Children, Level, Problem, Table, TableRow, Verdict } from "../types.d.ts" */
/** @import { Standing } from "./answers.js" */

/** Sign of each level. @type {Record<string, string>} */
const SIGNS = { "NOT CHECKED": "–", OK: "✓", ATTENTION: "▲", FAILS: "✕", "INTERNAL ERROR": "✕" };
/** @param {Level | null | undefined} level @param {string} [told] words in its place */
export const badge = (level, told) =>
  level
    ? h(
        "span",
        { class: `badge ${levelClass(level)}${told ? "" : " word"}` },
        h("span", { "aria-hidden": "true" }, `${SIGNS[level]} `),
        told || level,
      )
    : null;
/** A box of words that scrolls sideways where the page is narrow.
 * @param {string} label @param {...Children} children */
export const scroll = (label, ...children) =>
  h("div", { class: "scroll", tabIndex: 0, role: "region", "aria-label": label }, ...children);

/** A verdict, judged only where it is of what is asked now; nor has it a reserve then.
 * @param {Standing} how @param {Verdict} v @returns {Verdict} */
export const judgedIf = (how, v) =>
  how === "fresh" ? v : { ...v, level: /** @type {any} */ (""), reserve_text: null };
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
      copyButton(t),
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
/** A table as text with tabs between its cells, as a sheet takes it. @param {Table} t */
function tabbed(t) {
  const { symbols, notes } = columns(t);
  const cell = (/** @type {string} */ text) => text.replace(/\s+/g, " ").trim();
  const heads = t.heads.map(words);
  const head = ["", ...(symbols ? [""] : []), ...heads, ...(notes ? [""] : [])];
  const rows = t.rows.map((r) => [
    words(r.title),
    ...(symbols ? [r.symbol ?? ""] : []),
    ...r.values.map(words),
    ...(notes ? [[r.level, words(r.note)].filter(Boolean).join(" ")] : []),
  ]);
  const all = heads.some(Boolean) ? [head, ...rows] : rows;
  return all.map((row) => row.map(cell).join("\t")).join("\n");
}
/** @param {Table} t */
const copyButton = (t) =>
  navigator.clipboard &&
  h(
    "p",
    { class: "copy" },
    h(
      "button",
      {
        type: "button",
        class: "link",
        "aria-label": `Copy the table ${words(t.title)}`,
        onClick: act(async () => {
          await navigator.clipboard.writeText(tabbed(t));
          note(`${words(t.title)}: copied, a tab between cells.`);
        }),
      },
      "Copy",
    ),
  );
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
