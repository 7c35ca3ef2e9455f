// The same drive with every lagging, or with several belts.
import { app, change, redraw, set } from "../base/design.js";
import { noteUndo } from "../base/removed.js";
import { act, ask, later, onReturn, refusal } from "../base/server.js";
import { words } from "../base/units.js";
import { PAGES } from "../frame/registry.js";
import { list, standing } from "../parts/answers.js";
import { Box } from "../parts/box.js";
import { oneOf } from "../parts/choose.js";
import { renewed } from "../parts/framed.js";
import { place } from "../parts/problems.js";
import { numberOf } from "../parts/question.js";
import { badge, refused, scroll, stands } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { Dots } from "./compare/dots.js";
import { askedCase } from "./drive/cases.js";

/** @import { Level, Problem, Text } from "../types.d.ts" */
/**
 * @typedef {{value: number | null, text: Text}} Cell
 * @typedef {{name: string, title: string, condition: string, level: Level, label: string,
 *   short: string, cells: Record<string, Cell>, cost_note: Text, kind: string, source: string,
 *   present: boolean, change: {path: string, value: any}[]}} Row
 * @typedef {{key: string, title: string, better: "low" | "high"}} Column
 * @typedef {{pulley: string, load_case: string, load_cases: number, years: number,
 *   currency: string, columns: Column[], rows: Row[], remarks: Text[],
 *   not_possible: {name: string, problems: Problem[]}[]}} Comparison
 */

const asked = { what: "laggings", years: "10", hours: "6000", tariff: "", currency: "" };
const state = {
  answer: /** @type {Comparison | null} */ (null),
  of: /** @type {unknown[]} */ ([]),
  problems: /** @type {Problem[]} */ ([]),
  sort: "",
  way: 1,
  busy: false,
  /** What the answer is of, as `of` says what is asked. */
  now: /** @type {unknown[]} */ ([]),
  opened: -1,
};
const pinned = new Set();

/** Ask anew where the drive, or what is asked of it, is another. */
export function update() {
  renewed(state, { answer: null, problems: [] });
  const key = [app.doc, app.pulley, app.case, JSON.stringify(asked)];
  if (key.every((k, i) => k === state.of[i])) return;
  state.of = key;
  state.busy = true;
  load(app.doc);
}
/** @param {string} text */
const number = (text) => (text === "" ? undefined : numberOf(text));
const load = later(
  150,
  act(async (/** @type {any} */ doc) => {
    const { of } = state;
    const { what, years, hours, tariff, currency } = asked;
    const costs = { years: number(years), hours: number(hours), tariff: number(tariff) };
    try {
      const found = await ask("compare", {
        document: doc,
        pulley: doc.pulley[app.pulley]?.name ?? null,
        load_case: askedCase(),
        what,
        ...costs,
        currency: currency || undefined,
      });
      if (of !== state.of) return; // something else has been asked since
      Object.assign(state, { answer: found, now: of, problems: [], busy: false });
    } catch (x) {
      if (of !== state.of) return;
      state.busy = false;
      Object.assign(state, { problems: refusal(x) });
    }
    redraw();
  }),
);
onReturn(() => {
  state.of = [];
});

export const Page = () => [
  h(
    "p",
    { class: "help", key: "help" },
    "The drive of the first page, everything else unchanged. ",
    "Press a heading to sort, a star to fix a row on top; " +
      "bold is best among the rows that are OK.",
  ),
  bar(),
  h("p", { class: "help", role: "status", key: "said" }, said()),
  state.problems.length > 0 && refused("", state.problems),
  state.answer &&
    !state.problems.length &&
    stands(standing(state.now === state.of, state.problems, state.busy), result(state.answer)),
];
function said() {
  const a = state.answer;
  if (state.busy) return "Solving …";
  if (!a || state.problems.length) return "";
  const money = a.currency ? ` in ${a.currency}` : "";
  const what = `${a.rows.length} ${asked.what}`;
  const all = a.load_cases > 1 ? `, answers of all ${a.load_cases} load cases` : "";
  const where = `Pulley ${a.pulley}, numbers of load case ${a.load_case}${all}`;
  return `${where}; ${what}.${a.years ? ` Costs over ${a.years} years${money}.` : ""}`;
}
const WHAT = /** @type {[string, string][]} */ ([
  ["laggings", "Laggings"],
  ["belts", "Belts"],
]);
function bar() {
  const put = (/** @type {string} */ what) => {
    Object.assign(state, { sort: "", way: 1 });
    pinned.clear();
    ask_({ what });
  };
  return h(
    "div",
    { class: "bar", key: "bar" },
    oneOf("what", "What to compare", asked.what, WHAT, put),
    ...(PAGES.saved // who asks a server is told what it costs
      ? [
          amount("years", "Years", 3),
          amount("hours", "Hours a year", 6),
          amount("tariff", "Price of a kWh", 6),
          amount("currency", "Currency", 5),
        ]
      : []),
  );
}
/** @param {Partial<typeof asked>} more */
function ask_(more) {
  Object.assign(asked, more);
  redraw();
}
/** @param {keyof typeof asked} key @param {string} label @param {number} size */
const amount = (key, label, size) =>
  h(
    "label",
    { key },
    label,
    h(Box, {
      size,
      value: asked[key],
      put: (/** @type {string} */ v) => ask_({ [key]: v }),
    }),
  );

/** @param {Row} r */
const label = (r) =>
  asked.what === "belts" ? `${r.name}${r.title ? `, ${r.title}` : ""}` : r.title || r.name;
/** @param {Row} row */
function use(row) {
  let doc = app.doc;
  for (const c of row.change) doc = set(doc, place(c.path), c.value ?? undefined);
  change(doc);
  noteUndo(`${label(row)} is in the drive now. `);
}
/** @param {Comparison} a */
function result(a) {
  const columns = a.columns.filter(
    (c) => c.key !== "outside" && a.rows.some((r) => r.cells[c.key]?.value != null),
  );
  const best = Object.fromEntries(columns.map((c) => [c.key, bestOf(a.rows, c)]));
  const costs = [...new Set(a.rows.map((r) => words(r.cost_note)).filter(Boolean))];
  const impossible = a.not_possible.map(
    (r) => `${r.name}: ${r.problems.map((p) => p.sentence || p.message).join(" ")}`,
  );
  return [
    h(
      "div",
      { class: "card", key: "table" },
      scroll(
        "Comparison",
        h(
          "table",
          { class: "grid-table" },
          head(columns),
          h(
            "tbody",
            {},
            ordered(a.rows).map((r) => row(r, columns, best)),
          ),
        ),
      ),
    ),
    dots(a),
    h("div", { key: "remarks" }, list([...a.remarks, ...costs, ...impossible], "help")),
  ];
}
/** Creep against cost, where rows have both and do not all cost the same. @param {Comparison} a */
function dots(a) {
  const found = a.rows.flatMap((r) => {
    const { exit_creep: creep, cost_total, of_limit } = r.cells;
    if (creep?.value == null || !cost_total?.value || !of_limit?.value) return [];
    const [name, limit] = [label(r), Math.abs(creep.value) / of_limit.value];
    const told = `${name} ${words(creep.text)}, ${words(cost_total.text)}`;
    return [{ name, cost: cost_total.value, creep: creep.value, limit, level: r.level, told }];
  });
  const money = a.currency ? ` [${a.currency}]` : "";
  return new Set(found.map((d) => d.cost)).size > 1 && h(Dots, { dots: found, money, key: "dots" });
}
/** The best value among the rows that pass everything they are held against.
 * @param {Row[]} rows @param {Column} c */
function bestOf(rows, c) {
  const passing = rows.filter((r) => r.level === "OK");
  const all = passing.map((r) => r.cells[c.key]?.value).filter((v) => v != null);
  if (!c.better || new Set(all).size < 2) return Number.NaN;
  return c.better === "low" ? Math.min(...all) : Math.max(...all);
}
/** @param {Row[]} rows */
function ordered(rows) {
  const { sort, way } = state;
  const value = (/** @type {Row} */ r) => (sort === "name" ? label(r) : r.cells[sort]?.value);
  return [...rows].sort((a, b) => {
    const pin = +pinned.has(b.name) - +pinned.has(a.name);
    if (pin || !sort) return pin;
    const [x, y] = [value(a), value(b)];
    if (x == null || y == null) return x == null ? 1 : -1;
    return (typeof x === "string" ? x.localeCompare(String(y)) : x - +y) * way;
  });
}
/** @param {Column[]} columns */
const head = (columns) =>
  h(
    "thead",
    {},
    h(
      "tr",
      {},
      h("td", {}),
      heading("name", asked.what === "belts" ? "Belt" : "Lagging"),
      h("th", { scope: "col" }, "Answer"),
      columns.map((c) => heading(c.key, c.title, "num")),
      h("th", { scope: "col" }, "Data"),
      h("td", {}),
    ),
  );
/** @param {string} key @param {string} text @param {string} [cls] */
function heading(key, text, cls) {
  const on = state.sort === key;
  const press = () => {
    Object.assign(state, { sort: key, way: on ? -state.way : 1 });
    redraw();
  };
  const order = state.way > 0 ? "ascending" : "descending";
  const arrow = on && (state.way > 0 ? " ▲" : " ▼");
  return h(
    "th",
    { scope: "col", class: cls, "aria-sort": on ? order : "none", key },
    h("button", { type: "button", id: `sort-${key}`, onClick: press }, text, arrow),
  );
}
/** @param {Row} r @param {Column[]} columns @param {Record<string, number>} best */
function row(r, columns, best) {
  const pin = pinned.has(r.name);
  const press = () => {
    if (pin) pinned.delete(r.name);
    else pinned.add(r.name);
    redraw();
  };
  const condition = r.condition && r.condition !== "dry" ? `, ${r.condition}` : "";
  const outside = r.cells.outside?.value ? words(r.cells.outside.text) : "";
  return h(
    "tr",
    { class: `${pin ? "pinned" : ""} ${r.present ? "present" : ""}`, key: r.name },
    h(
      "td",
      {},
      h(
        "button",
        { type: "button", "aria-pressed": pin, "aria-label": `Pin ${label(r)}`, onClick: press },
        pin ? "★" : "☆",
      ),
    ),
    h("th", { scope: "row" }, label(r), condition, r.present && " (present)"),
    h("td", {}, badge(r.level, r.label), " ", r.short),
    columns.map((c) => cell(r, c.key, best[c.key])),
    h(
      "td",
      {},
      r.kind && h("span", { class: `mark ${r.kind}`, title: r.source }, r.kind),
      outside && h("span", { class: "mark outside" }, `outside tested range ${outside}`),
    ),
    h(
      "td",
      {},
      !r.present &&
        r.change &&
        h(
          "button",
          { type: "button", "aria-label": `Use ${label(r)}`, onClick: () => use(r) },
          "Use",
        ),
    ),
  );
}
/** @param {Row} r @param {string} key @param {number} best */
function cell(r, key, best) {
  const c = r.cells[key];
  const text = words(c?.text) || "–";
  const first = r.level === "OK" && c?.value != null && c.value === best;
  const bold = h("strong", {}, text, h("span", { class: "away" }, " (best)"));
  return h("td", { class: "num", key }, first ? bold : text);
}
