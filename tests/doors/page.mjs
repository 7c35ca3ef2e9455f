// Drive files asked of the page: what it judges itself, and what the calculator of one file answers.
import { readFileSync } from "node:fs";

/** Elements of the file by their names; the worker beside the page works in this thread. */
const elements = {};
globalThis.document = { getElementById: (id) => elements[id] ?? null };
globalThis.Worker = class {
  async postMessage(arcs) {
    const { numbersOfAll } = await import("../../src/wraparc/web/static/pages/drive/numbers.js");
    this.onmessage({ data: numbersOfAll(arcs) });
  }
};
const { app } = await import("../../src/wraparc/web/static/base/design.js");
const { words } = await import("../../src/wraparc/web/static/base/units.js");
const drive = "../../src/wraparc/web/static/pages/drive";
const { assemble } = await import(`${drive}/assemble.js`);
const { arcsOf, judge } = await import(`${drive}/judge.js`);
const { numbersOfAll } = await import(`${drive}/numbers.js`);
const { verdictOf } = await import(`${drive}/words.js`);

const { form, kernel, files } = JSON.parse(readFileSync(0, "utf-8"));
app.units = "si";

/** What the page finds itself. */
function judged({ document: doc, book }) {
  app.form = form;
  const { judging, problems } = assemble(doc, book);
  if (!judging) return { problems };
  const numbers = numbersOfAll(arcsOf(judging));
  if (!numbers) return { problems: [{ sentence: "no answer", beyond: true }] };
  const found = judge(judging, doc, numbers);
  const { verdict } = found;
  const { level, headline } = verdictOf(found);
  const worst = verdict.governing;
  const of = worst && {
    name: worst.name,
    pulley: worst.place.pulley,
    load_case: worst.place.load_case,
    value: worst.value,
    limit: worst.limit,
  };
  const arcs = found.arcs.map(({ load_case, pulley, numbers: own }) => {
    const here = verdict.at(pulley, load_case);
    return { load_case, pulley, level: here.level, name: here.governing?.name ?? "", numbers: own };
  });
  return { verdict: { level, text: words(headline), ...of }, arcs };
}
/** What the file answers; it is opened anew for each drive. */
async function answered({ document: doc, data }, number) {
  elements.data = { textContent: data };
  const { ask } = await import(`../../src/wraparc/web/one_file/server.js?${number}`);
  try {
    app.form = await ask("schema");
    app.catalogue = await ask("catalogue");
    const { verdict, arcs } = await ask("solve", { document: doc });
    return {
      verdict: { level: verdict.level, text: words(verdict.headline) },
      arcs: arcs.map(({ load_case, pulley, level, numbers }) => ({
        ...{ load_case, pulley, level, name: null, numbers },
      })),
    };
  } catch (error) {
    if (!error.problems) throw error;
    return { problems: error.problems };
  }
}
const answers = [];
for (const [number, one] of files.entries()) answers.push(await answered(one, number));
const plain = (_, v) => (typeof v === "number" && !Number.isFinite(v) ? String(v) : v);
process.stdout.write(JSON.stringify({ kernel: kernel.map(judged), files: answers }, plain));
