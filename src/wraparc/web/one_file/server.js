// What the server answers, answered in the file: by the same modules and from the same data.
import { Advice, Refused } from "../static/base/server.js";
import { textOf } from "../static/base/toml.js";
import { in_page__quick as quick } from "../static/kernel.js";
import { assemble, inCase } from "../static/pages/drive/assemble.js";
import { beside } from "../static/pages/drive/beside.js";
import { arcsOf, judge } from "../static/pages/drive/judge.js";
import { numbersOfAll } from "../static/pages/drive/numbers.js";
import { shownOf } from "../static/pages/drive/own.js";
import { firstAnswer, wholeOf } from "../static/pages/drive/whole.js";
import { remarksOf, verdictOf } from "../static/pages/drive/words.js";
import { compared } from "./comparing.js";
import { profilesOf } from "./profiles.js";
import { documentOf } from "./texts.js";
import { quickTrain, solveTrain, trainAnswer, trainArcs } from "./train_answers.js";
import { isTrain } from "./trains.js";
import { unpacked } from "./unpacked.js";

export * from "../static/base/server.js";
/** Every part of the page is here, and its style. @template T @param {() => Promise<T>} load */
export const part = (load) => load();

/** @import { Assembled, Design } from "../static/types.d.ts" */

/** What the file knows, unpacked. @type {any} */
let data = null;
const ready = unpacked("data").then((text) => {
  data = JSON.parse(text);
});

/** @param {Design} doc @returns {Assembled} */
function prepared(doc) {
  const { judging, problems } = assemble(doc, data.book);
  if (!judging) throw new Refused(problems, 422);
  return judging;
}
/** @param {string} message */
const refused = (message) => new Refused([{ path: "", message, sentence: message }], 422);
/** Points of a profile, as of wraparc solve. */
const POINTS = 180;
const OF_ONE =
  "Laggings and belts are compared in this page for a drive of one pulley; of several drives " +
  "wraparc what-if calculates changes.";
const UNSOLVED = "No result in this page; wraparc solve gives the reason.";

/** @type {Record<string, (asked: any) => any>} */
const ANSWERS = {
  schema: () => data.form,
  catalogue: () => data.catalogue,
  about: () => data.about,
  book: () => data.book,
  start: () => data.start,
  "start/solved": () => null,
  async "solve/fast"({ governing, ...of }) {
    const asked = governing ? { ...of, ...(await ANSWERS.solve(of)).governing } : of;
    const { document, load_case, points, sequence } = asked;
    if (isTrain(document)) return quickTrain(asked, data);
    const judging = inCase(prepared(document), load_case);
    const [one] = arcsOf(judging);
    const found = quick(one.law, one.given, one.tested, points);
    const numbers = found && numbersOfAll([one]);
    if (!numbers) throw refused(UNSOLVED);
    const judged = judge(judging, document, numbers);
    const [arc] = judging.cases;
    const { level, levels } = verdictOf(judged, arc.load_case);
    const remarks = remarksOf(judged);
    const first = { ...firstAnswer(arc), ...shownOf(found), sequence };
    return { ...first, level, levels, remarks };
  },
  async solve({ document }) {
    if (isTrain(document)) return solveTrain(document, data);
    const judging = prepared(document);
    const numbers = await beside(arcsOf(judging));
    if (!numbers) throw refused(UNSOLVED);
    const judged = judge(judging, document, numbers);
    return wholeOf(judged);
  },
  train({ document, match }) {
    if (match) throw new Advice("wraparc trim calculates speed tolerances.");
    return trainAnswer(document, data);
  },
  compare(asked) {
    if (isTrain(asked.document)) throw refused(OF_ONE);
    return compared(asked, data);
  },
  "toml/read": ({ toml, name }) => ({ document: documentOf(toml, name) }),
  "toml/write": ({ document }) => ({ name: "", toml: textOf(document) }),
};
/** As of the server. @param {string} path @param {any} [asked] @param {any} [_how]
 * @returns {Promise<any>} */
export async function ask(path, asked, _how) {
  await ready;
  const [first, name] = path.split("/");
  if (first === "examples") return structuredClone(data.examples[name]);
  if (!ANSWERS[path]) throw new Advice("This needs the calculator of wraparc serve.");
  return structuredClone(await ANSWERS[path](asked));
}
/** Profiles; results and reports are left to the program. @param {string} path @param {any} asked
 * @returns {Promise<[Blob, string]>} */
export async function askFile(path, asked) {
  await ready;
  if (path !== "results/csv")
    throw new Advice("Reports are made by wraparc report, or in wraparc serve.");
  const { document, units, name } = asked;
  const all = isTrain(document) ? await trainArcs(document, data) : driveArcs(document);
  return [new Blob([profilesOf(all, units)], { type: "text/csv" }), `${name}.csv`];
}
/** @param {Design} document */
function driveArcs(document) {
  const judging = prepared(document);
  return arcsOf(judging).map((one, i) => {
    const { load_case } = judging.cases[i];
    const found = quick(one.law, one.given, one.tested, POINTS);
    if (!found) throw refused(UNSOLVED);
    return { load_case, pulley: document.pulley[0].name ?? "", found };
  });
}
