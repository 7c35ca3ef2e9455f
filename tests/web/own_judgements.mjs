// Judgements of the page itself on moved numbers: cases as JSON come in, verdicts go out.
import { readFileSync } from "node:fs";
import { app } from "../../src/wraparc/web/static/base/design.js";
import { words } from "../../src/wraparc/web/static/base/units.js";
import { asked, judge } from "../../src/wraparc/web/static/pages/drive/judge.js";
import { leastTold } from "../../src/wraparc/web/static/pages/drive/least.js";
import { numbersOfAll } from "../../src/wraparc/web/static/pages/drive/numbers.js";
import { checkTable, verdictOf } from "../../src/wraparc/web/static/pages/drive/words.js";

const { form, cases } = JSON.parse(readFileSync(0, "utf-8"));
app.form = form;
/** What is made of texts, in the units looked at. */
const shown = (of) => {
  if (typeof of === "string" || of?.text) return words(of);
  if (Array.isArray(of)) return of.map(shown);
  if (typeof of !== "object" || of === null) return of;
  return Object.fromEntries(Object.entries(of).map(([key, value]) => [key, shown(value)]));
};
const all = cases.map(({ doc, answer, changed }) => {
  const arcs = asked(doc, answer, changed);
  const numbers = arcs && numbersOfAll(arcs);
  const found = numbers && judge(answer.judging, changed, numbers);
  if (!found) return null;
  app.units = "si";
  const told = found.arcs.map((arc) => ({
    ...arc,
    verdict: shown(verdictOf(found, arc.load_case)),
  }));
  const texts = (units) => {
    app.units = units;
    const { rows, note } = checkTable(found, answer.checks);
    const cells = rows.map((r) => [r.title, ...r.values, r.note, r.level]);
    const least = leastTold(found, answer.least_tension);
    return shown({ verdict: verdictOf(found), rows: cells, note, least });
  };
  return { arcs: told, si: texts("si"), us: texts("us") };
});
const plain = (_, v) => (typeof v === "number" && !Number.isFinite(v) ? String(v) : v);
process.stdout.write(JSON.stringify(all, plain));
