// Judgements of the page itself on moved numbers: cases as JSON come in, verdicts go out.
import { readFileSync } from "node:fs";
import { app } from "../../src/wraparc/web/static/base/design.js";
import { words } from "../../src/wraparc/web/static/base/units.js";
import { assemble } from "../../src/wraparc/web/static/pages/drive/assemble.js";
import { arcsOf, asked, judge } from "../../src/wraparc/web/static/pages/drive/judge.js";
import { leastTold } from "../../src/wraparc/web/static/pages/drive/least.js";
import { numbersOfAll } from "../../src/wraparc/web/static/pages/drive/numbers.js";
import { wholeOf } from "../../src/wraparc/web/static/pages/drive/whole.js";
import { linesOf } from "../../src/wraparc/web/static/parts/answers.js";
import { checkTable, verdictOf } from "../../src/wraparc/web/static/pages/drive/words.js";

const { form, book, cases } = JSON.parse(readFileSync(0, "utf-8"));
app.form = form;
/** What is made of texts, in the units looked at. */
const shown = (of) => {
  if (typeof of === "string" || of?.cells) return words(of);
  if (Array.isArray(of)) return of.map(shown);
  if (typeof of !== "object" || of === null) return of;
  return Object.fromEntries(Object.entries(of).map(([key, value]) => [key, shown(value)]));
};
const all = cases.map(({ doc, answer, changed }) => {
  const served = answer && asked(doc, answer, changed);
  if (answer && !served) return null;
  const { judging, problems } = assemble(changed, book, served ?? []);
  if (!judging) return { problems };
  const numbers = numbersOfAll(arcsOf(judging));
  if (!numbers) return { problems: ["no answer"] };
  app.units = "si";
  const found = judge(judging, changed, numbers);
  const told = found.arcs.map((arc) => ({ ...arc, verdict: shown(verdictOf(found, arc.load_case)) }));
  const texts = (units) => {
    app.units = units;
    const { rows, note } = checkTable(found);
    const cells = rows.map((r) => [r.title, ...r.values, r.note, r.level]);
    const { arcs, summary } = wholeOf(found);
    const tables = [...arcs.flatMap((a) => a.tables), ...(summary ? [summary] : [])].map((t) => [
      ...[t.key, t.title, t.note, ...t.heads],
      ...t.rows.map((r) => [r.title, r.symbol, ...r.values, r.note, r.level]),
    ]);
    const sources = arcs.map((a) => a.table_sources);
    const least = leastTold(found);
    const verdict = verdictOf(found);
    verdict.lines = linesOf(verdict).map(([label, text]) => [label, text]);
    return shown({ verdict, rows: cells, note, least, tables, sources });
  };
  return { problems, arcs: told, si: texts("si"), us: texts("us") };
});
const plain = (_, v) => (typeof v === "number" && !Number.isFinite(v) ? String(v) : v);
process.stdout.write(JSON.stringify(all, plain));
