// A judged drive as an answer of the server tells one, for what the page has put together itself.
import { app } from "../../base/design.js";
import { cellOf } from "../../base/digits.js";
import { cell__percent as percent, cell__quantity as quantity } from "../../cells.js";
import { leastAlone, leastTold } from "./least.js";
import { barsOf, checkTable, remarksOf, verdictOf } from "./words.js";

/** @import { Assembled, FullAnswer, FullArc, QuickAnswer } from "../../types.d.ts" */
/** @import { Table, TableRow } from "../../types.d.ts" */
/** @import { Judged } from "./judge.js" */

/** Numbers of an arc that stand in tables, by the table. @type {[string, string, string[]][]} */
const TABLES = [
  [
    "capacity",
    "Capacity",
    [
      ...["creep_limit_capacity", "creep_limit_margin", "equivalent_friction"],
      ...["tested_slip_capacity", "tested_slip_margin", "gross_slip_capacity"],
      ...["gross_slip_margin", "least_exit_tension", "largest_effective_tension"],
    ],
  ],
  [
    "answer",
    "Result",
    [
      ...["exit_creep", "creep_shrinkage", "creep_compression", "creep_global", "exit_slip"],
      ...["peak_shear_angle", "peak_shear_stress", "mean_friction", "active_arc", "k_factor"],
      ...["entry_tension", "exit_tension", "effective_tension", "tension_ratio"],
      ...["resultant_force", "resultant_angle", "belt_safety"],
      ...["most_shaft_load", "least_shaft_load"],
    ],
  ],
  [
    "energy",
    "Energy",
    [
      ...["transmitted_power", "sliding_power", "shear_loss", "power_loss", "efficiency"],
      ...["frictional_energy", "wear_rate"],
    ],
  ],
];
/** A value with its unit; what has no bound or is none is said. @param {string} name
 * @param {number} v */
function told(name, v) {
  const { dimension } = app.form.glossary[name];
  if (name === "efficiency") return percent(v, 4);
  return quantity(v, dimension);
}
/** @param {Record<string, number>} numbers @returns {Table[]} */
const tablesOf = (numbers) =>
  TABLES.map(([key, title, names]) => {
    const known = names.filter(
      (n) => app.form.glossary[n] && !Number.isNaN(numbers[n] ?? Number.NaN),
    );
    const rows = known.map((name) => {
      const { title, symbol } = app.form.glossary[name];
      return row(name, title, symbol, [told(name, numbers[name])]);
    });
    return { key, name: "", title, heads: [""], note: "", rows };
  });
/** @param {string} name @param {string} title @param {string} symbol @param {string[]} cells
 * @param {any} [note] @param {any} [level] @returns {TableRow} */
const row = (name, title, symbol, cells, note = "", level = null) => ({
  ...{ name, title, symbol, note, level },
  values: cells,
});

/** Numbers that an arc was found from, by their names in the glossary. */
const GIVEN = {
  belt_width: "width",
  belt_modulus: "modulus",
  belt_speed: "speed",
  diameter: "diameter",
  wrap_angle: "wrap_angle",
  lagging_thickness: "thickness",
  shear_modulus: "shear_modulus",
  compression_modulus: "compression_modulus",
  creep_limit: "creep_limit",
};
/** What an arc was found from: a sheet of paper has no form.
 * @param {Assembled["cases"][number]} c @returns {Table} */
function inputsOf({ prepared: { given }, condition, lagging: of, belt }) {
  const numbers = Object.entries(GIVEN).map(
    ([name, key]) => /** @type {const} */ ([name, +given[key]]),
  );
  const lagging = `${of} (${condition})`;
  const rows = numbers
    .filter(([name, v]) => !Number.isNaN(v) && app.form.glossary[name])
    .map(([name, v]) => {
      const { title, symbol } = app.form.glossary[name];
      return row(name, title, symbol, [Number.isFinite(v) ? told(name, v) : "rigid"]);
    });
  const words = [row("", "Belt", "", [belt]), row("", "Lagging", "", [lagging])];
  const shown = [...words, ...rows];
  return { key: "inputs", name: "", title: "Inputs", heads: [""], note: "", rows: shown };
}

/** All load cases side by side, and all pulleys. @param {Judged} judged
 * @returns {Table | null} */
function summaryOf(judged) {
  const { arcs } = judged;
  if (arcs.length < 2) return null;
  const several = arcs.some((a) => a.pulley !== arcs[0].pulley);
  const rows = arcs.map((arc, i) => {
    const { load_case, pulley, solved, numbers: n } = arc;
    const { level, short } = verdictOf(judged, load_case, pulley);
    const limit = +judged.of.cases[i].prepared.given.creep_limit;
    const part = Math.abs(n.exit_creep) / limit;
    const creep = solved ? [bare(n.exit_creep, "length"), percent(part)] : ["-", "-"];
    const cells = [
      ...[bare(n.entry_tension, "force"), bare(n.exit_tension, "force"), bare(n.tension_ratio)],
      ...[...creep, several ? "-" : leastIn(judged, i), short],
    ];
    return row("", several ? `${load_case}: ${pulley}` : load_case, "", cells, "", level);
  });
  const [force, length] = ["force", "length"].map((of) => cellOf(0, of, undefined, "unit"));
  const heads = [
    ...[`T1 [${force}]`, `T2 [${force}]`, "T1/T2", `creep [${length}]`],
    ...["of limit", `least T2 [${force}]`, ""],
  ];
  return {
    key: "summary",
    name: "cases",
    title: several ? "All load cases and pulleys" : "All load cases",
    heads,
    note: "",
    rows,
  };
}
/** Least slack-side tension of one arc alone. @param {Judged} judged @param {number} i */
function leastIn(judged, i) {
  const found = leastAlone(judged, i);
  if (!found) return "-";
  if (!Number.isFinite(found.tension)) return "none";
  return cellOf(found.tension, "force", undefined, "bare up");
}
/** A value in the unit of its table. @param {number} v @param {string} [dimension] */
const bare = (v, dimension = "number") =>
  Number.isFinite(v) ? cellOf(v, dimension, undefined, "bare") : quantity(v, dimension);

/**
 * The answer of a drive that the page has put together.
 * @param {Judged} judged @returns {FullAnswer}
 */
export function wholeOf(judged) {
  const least_tension = leastTold(judged);
  const verdict = verdictOf(judged);
  if (least_tension) verdict.sentences.unshift(least_tension.sentence);
  const arcs = judged.arcs.map((_, i) => arcOf(judged, i));
  const worst = arcs.find((a) => a.level === verdict.level) ?? arcs[0];
  return {
    verdict,
    governing: { pulley: worst.pulley, load_case: worst.load_case },
    arcs,
    conditions: null,
    checks: checkTable(judged),
    least_tension,
    summary: summaryOf(judged),
    sources: judged.of.kinds.map((kind) => ({ kind })),
    remarks: remarksOf(judged),
    judging: null,
  };
}
/** @param {Judged} judged @param {number} i @returns {FullArc} */
function arcOf(judged, i) {
  const { load_case, pulley, solved, numbers } = judged.arcs[i];
  const { level, levels, short } = verdictOf(judged, load_case, pulley);
  const c = judged.of.cases[i];
  // in gross slip there is no state at rest to tell of
  const told = tablesOf(numbers).filter((t) => solved || t.key === "capacity");
  return {
    pulley,
    load_case,
    status: solved ? "solved" : "breakaway",
    status_text: "",
    raise_to: leastAlone(judged, i)?.raise_to ?? null,
    ...{ level, levels, short, numbers: finite(numbers) },
    bars: barsOf(judged, load_case, pulley),
    creep_limit: +c.prepared.given.creep_limit,
    profile: {},
    tested: c.tested,
    outside: [],
    tables: [...told.filter((t) => t.rows.length > 0), inputsOf(c)],
    table_sources: [],
    paper: null,
  };
}
/** Numbers as JSON has them: none for what there is none of or has no bound.
 * @param {Record<string, number>} of @returns {Record<string, any>} */
const finite = (of) =>
  Object.fromEntries(Object.entries(of).map(([k, v]) => [k, Number.isFinite(v) ? v : null]));
/** The first answer to an arc that nothing was solved of.
 * @param {Assembled["cases"][number]} c @returns {QuickAnswer} */
export const firstAnswer = (c) => ({
  sequence: 0,
  pulley: c.pulley,
  load_case: c.load_case,
  status: "solved",
  level: /** @type {any} */ (""),
  levels: {},
  creep_limit: +c.prepared.given.creep_limit,
  numbers: {},
  profile: {},
  tested: c.tested,
  outside: [],
  verdict: { level: /** @type {any} */ (""), headline: "", sentences: [] },
  remarks: [],
  prepared: null,
});
