// The same drive with every lagging of the catalogue, or with belts of neighbouring rating.
import { app, set } from "../static/base/design.js";
import { dimensionOf } from "../static/base/units.js";
import { cell__percent as percent, cell__quantity as quantity } from "../static/cells.js";
import { assemble } from "../static/pages/drive/assemble.js";
import { beside } from "../static/pages/drive/beside.js";
import { arcsOf, judge } from "../static/pages/drive/judge.js";
import { verdictOf } from "../static/pages/drive/words.js";
import { leastTension } from "../static/reader.js";

/** @import { Design } from "../static/types.d.ts" */
/** @typedef {{path: string, value: any}[]} Change */

/** What a belt of the catalogue brings itself. */
const OF_BELT = ["name", "kind", "modulus", "rating", "least_pulley_diameter"];
const OWN = ["sources", "provenance"];

/**
 * As the server compares, but for what it costs.
 * @param {{document: Design, load_case: string | null, what: string}} asked
 * @param {any} data of the file
 */
export async function compared({ document: doc, load_case, what }, data) {
  const rows = [];
  const not_possible = [];
  const arcs = [];
  for (const { name, changed, change } of what === "belts" ? belts(doc, data) : laggings(doc)) {
    const { judging, problems } = assemble(changed, data.book);
    if (judging) arcs.push({ name, changed, change, judging });
    else not_possible.push({ name, problems });
  }
  const cases = arcs[0]?.judging.cases.map((c) => c.load_case) ?? [];
  const shown = Math.max(cases.indexOf(load_case ?? arcs[0]?.judging.meant ?? ""), 0);
  for (const { name, changed, change, judging } of arcs) {
    const numbers = await beside(arcsOf(judging));
    const judged = numbers && judge(judging, changed, numbers);
    if (judged) rows.push(rowOf(name, what, judged, shown, change, doc, data.compare.columns));
    else not_possible.push({ name, problems: [{ path: "", message: "no result" }] });
  }
  const { columns, remarks } = data.compare;
  return {
    pulley: doc.pulley[0].name,
    load_case: cases[shown] ?? "",
    load_cases: cases.length,
    ...{ columns, rows, not_possible, remarks: remarks[what] },
  };
}
/** @param {Design} doc */
const nameOf = (doc) => doc.pulley[0].lagging?.preset ?? doc.pulley[0].lagging;
/** @param {Design} doc */
function* laggings(doc) {
  const own = nameOf(doc);
  const names = app.catalogue.laggings.map((l) => l.name);
  if (!names.includes(own)) yield { name: own, changed: doc, change: [] };
  for (const name of names) {
    const path = `pulley.${JSON.stringify(doc.pulley[0].name)}.lagging`;
    const changed = name === own ? doc : set(doc, ["pulley", 0, "lagging"], name);
    yield { name, changed, change: name === own ? [] : [{ path, value: name }] };
  }
}
/** @param {Design} doc @param {any} data */
function* belts(doc, data) {
  const own = doc.belt.preset ?? doc.belt.name ?? "belt";
  const names = neighbours(doc, data);
  if (!names.includes(own)) yield { name: own, changed: doc, change: [] };
  for (const name of names) {
    const kept = Object.entries(doc.belt).filter(([k]) => ![...OF_BELT, ...OWN].includes(k));
    const changed = { ...doc, belt: { ...Object.fromEntries(kept), preset: name } };
    const gone = [...OF_BELT, ...OWN].map((k) => ({ path: `belt.${k}`, value: null }));
    const change = [{ path: "belt.preset", value: name }, ...gone];
    yield name === own ? { name, changed: doc, change: [] } : { name, changed, change };
  }
}
/** Belts of each carcass whose rating is nearest, in the order of rating. @param {Design} doc
 * @param {any} data @returns {string[]} */
function neighbours(doc, data) {
  const { judging } = assemble(doc, data.book);
  if (!judging) return [];
  const { belt } = judging.drive;
  const tight = judging.arcs.map((a) => Math.max(a.entry_tension, a.exit_tension));
  const rating = +belt.rating || Math.max(...tight) / belt.width;
  const belts = /** @type {any[]} */ (data.book.catalogue.belts);
  const all = belts.map((b) => /** @type {[string, any]} */ ([b.name, b]));
  return [...new Set(all.map(([, b]) => b.kind))].flatMap((kind) => {
    const near = all.filter(([, b]) => b.kind === kind);
    near.sort(([, a], [, b]) => far(a, rating) - far(b, rating));
    const found = near.slice(0, data.compare.neighbours);
    found.sort(([m, a], [n, b]) => a.rating - b.rating || (m < n ? -1 : 1));
    return found.map(([name]) => name);
  });
}
/** @param {{rating: number}} belt @param {number} rating */
const far = (belt, rating) => Math.abs(Math.log(belt.rating / rating));

/** @param {string} name @param {string} what @param {import("../static/pages/drive/judge.js").Judged} judged
 * @param {number} shown load case whose numbers these are
 * @param {Change} change @param {Design} doc @param {{key: string}[]} columns */
function rowOf(name, what, judged, shown, change, doc, columns) {
  const { solved, numbers: n, load_case } = judged.arcs[shown];
  const { level, label, short: words } = verdictOf(judged);
  const { governing: worst } = judged.verdict;
  const elsewhere = worst?.missed && worst.place.load_case;
  const short = elsewhere && elsewhere !== load_case ? `${words}, ${elsewhere}` : words;
  const lagging = app.catalogue.laggings.find((l) => l.name === name);
  const belt = app.catalogue.belts.find((b) => b.name === name);
  const of = solved
    ? Math.abs(n.exit_creep) / +judged.of.cases[shown].prepared.given.creep_limit
    : none;
  const known = (/** @type {number} */ v) => (solved ? v : none);
  /** @type {Record<string, any>} */
  const further = {
    exit_creep: cell("exit_creep", known(Math.abs(n.exit_creep))),
    of_limit: share(of),
    creep_limit_margin: cell("creep_limit_margin", n.creep_limit_margin),
    least_slack: cell("least_exit_tension", leastTension(judged.result)?.tension ?? none),
    outside: share(known(n.outside_tested_share)),
  };
  return {
    ...{ name, level, label, short, change, condition: conditionOf(doc), cost_note: "" },
    title: (what === "belts" ? belt?.kind : lagging?.title) ?? "",
    kind: what === "belts" ? "" : (lagging?.kind ?? ""),
    source: (what === "belts" ? belt : lagging)?.source ?? "",
    present: change.length === 0,
    cells: Object.fromEntries(
      columns.map(({ key }) => [key, further[key] ?? cell(key, known(n[key] ?? none))]),
    ),
  };
}
const none = Number.NaN;
/** @param {Design} doc */
const conditionOf = (doc) => (typeof doc.condition === "string" ? doc.condition : "");
/** @param {string} name @param {number} v */
function cell(name, v) {
  const none = v === Number.POSITIVE_INFINITY;
  return valued(v, none ? "none" : quantity(v, dimensionOf(name)));
}
/** @param {number} v */
const share = (v) => valued(v, percent(v));
/** @param {number} v @param {string} text */
const valued = (v, text) => ({ value: Number.isFinite(v) ? v : null, text });
