// Tables of an arc that come from Python, in the place of plain lists of numbers.
import { wholeOf } from "../static/pages/drive/whole.js";
import * as K from "./train_kernel.js";

/** @import { Book, Judging, Table, TableRow } from "../static/types.d.ts" */
/** @import { Judged } from "../static/pages/drive/judge.js" */

/** Kind of a law whose friction is limited, see CompactLaw. */
const LIMIT = 0;
/** Rows of the page that the table of Python leaves to others. */
const MORE = ["least_exit_tension", "largest_effective_tension"];

/** A table of Python as the page shows one.
 * @param {any} of @param {string} key @returns {Table} */
export function tableOf({ name, title, heads, note, rows }, key) {
  return { key, name, title, heads, note, rows };
}
/** As `wholeOf`, its capacities with notes. @param {Judged} judged @param {Judging} judging
 * @param {Book} book */
export function wholeAnswer(judged, judging, book) {
  const whole = wholeOf(judged, judging, book);
  const arcs = whole.arcs.map((arc, i) => {
    const { numbers } = judged.arcs[i];
    const { law } = judging.cases[i].prepared;
    const of = new K.Carrying(
      numbers.entry_tension,
      numbers.exit_tension,
      numbers.entry_tension >= numbers.exit_tension,
      judging.cases[i].tested?.slip_max ?? Number.NaN,
      law.kind === LIMIT && law.onset_compliance === 0,
    );
    const known = tableOf(K.arc_tables__capacity_rows(numbers, of), "capacity");
    const tables = arc.tables.map((t) =>
      t.key === "capacity" ? { ...known, rows: [...known.rows, ...rest(t)] } : t,
    );
    return { ...arc, tables };
  });
  return { ...whole, arcs };
}
/** @param {Table} table @returns {TableRow[]} */
const rest = ({ rows }) => rows.filter((r) => MORE.includes(r.name));
