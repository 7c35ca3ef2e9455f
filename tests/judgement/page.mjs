// What the page itself says first: documents as JSON come in, words of the verdict go out.
import { readFileSync } from "node:fs";
import { app } from "../../src/wraparc/web/static/base/design.js";
import { words } from "../../src/wraparc/web/static/base/units.js";
import { assemble } from "../../src/wraparc/web/static/pages/drive/assemble.js";
import { arcsOf, judge } from "../../src/wraparc/web/static/pages/drive/judge.js";
import { leastTold } from "../../src/wraparc/web/static/pages/drive/least.js";
import { numbersOfAll } from "../../src/wraparc/web/static/pages/drive/numbers.js";
import { verdictOf } from "../../src/wraparc/web/static/pages/drive/words.js";


const { form, book, documents } = JSON.parse(readFileSync(0, "utf-8"));
app.form = form;
app.units = "si";
const told = documents.map((doc) => {
  app.doc = doc;
  const { judging, problems } = assemble(doc, book);
  if (!judging) return { first: problems.map((p) => p.message).join(" "), least: null };
  const numbers = numbersOfAll(arcsOf(judging));
  if (!numbers) return { first: "no answer", least: null };
  const judged = judge(judging, doc, numbers);
  const verdict = verdictOf(judged);
  const least = leastTold(judged)?.sentence;
  const also = verdict.also.map((/** @type {any} */ a) => words(a.text));
  const texts = [words(verdict.text), words(verdict.action?.text ?? ""), ...also];
  return { first: [verdict.label, ...texts].join(" "), least: words(least) };
});
process.stdout.write(JSON.stringify(told));
