// Opening a file: what a TOML file is, and where it belongs. Fetched when the first is opened.
import { turnTo } from "../base/address.js";
import { app, isDrive, redraw, set } from "../base/design.js";
import { open } from "../base/drafts.js";
import { noteUndo, putLagging } from "../base/removed.js";
import { Advice, ask, note, part } from "../base/server.js";
import { showFirst } from "./opened.js";

const MOST = 2e6;
/** Kinds of TOML files by a key that only they have. @type {[string, string][]} */
const KINDS = [
  ["axis", "study"],
  ["candidates", "choose"],
  ["rig", "plan"],
  ["test", "plan"],
  ["record", "calibrate"],
  ["number", "calibrate"],
  ["law", "lagging"],
];
/** @param {any} doc */
const kindOf = (doc) =>
  isDrive(doc)
    ? "drive"
    : KINDS.find(([key]) => key in doc)?.[1] || (doc.condition ? "lagging" : "");

/** @param {File} file */
export async function openFile(file) {
  const { name } = file;
  if (file.size > MOST) throw new Advice(`${name} is larger than 2 MB: no drive file.`);
  const text = await file.text();
  if (!text.trim()) throw new Advice(`${name} is empty.`);
  const { document } = await ask("toml/read", { toml: text, name });
  const open = OPEN[kindOf(document)];
  if (!open)
    throw new Advice(
      `${name} is no drive file: it has no belt and no pulley. A drive file has a [belt] table ` +
        "and a [[pulley]] table for each pulley; File, Download shows one.",
    );
  await open(document, name, text);
  redraw();
}
/** @type {Record<string, (doc: any, name: string, text: string) => any>} */
const OPEN = {
  drive(doc, name, toml) {
    open(doc, { name: stem(name), source: { toml, document: doc } });
    showFirst(doc, `Opened ${name}.`);
  },
  async lagging(_, __, text) {
    const { name, lagging } = await ask("lagging/read", { toml: text });
    const before = app.doc.lagging?.[name] ? ` It replaces the lagging ${name} of the design.` : "";
    putLagging(app.pulley, name, set(app.doc, ["lagging", name], lagging));
    noteUndo(`The lagging ${name} is on the pulley now.${before} `);
  },
  async study(doc, name) {
    const { openStudy } = await part(() => import("../pages/study.js"));
    if (!Array.isArray(doc.axis)) throw new Advice(`${name} is a study, but its axis is no list.`);
    openStudy(doc);
    turnTo("study");
    const drive = typeof doc.drive === "string" ? ` of ${doc.drive}` : "";
    note(`${name} is a study${drive}. Its plan is on this page, for the drive that is open here.`);
  },
  async plan(doc, name) {
    const { openPlan } = await part(() => import("../pages/tests.js"));
    openPlan(doc);
    turnTo("tests");
    note(
      `${name} is a plan of shear tests: lagging, rig and fit are filled in. ` +
        "Drop the files of the tests.",
    );
  },
  choose(_, name) {
    throw new Advice(
      `${name} asks which lagging to buy. The command runs it, wraparc choose ${name}; here ` +
        "the question Which design has the lowest cost? applies it to the open drive.",
    );
  },
  calibrate(_, name) {
    throw new Advice(
      `${name} is a record of a measured drive. The command fits it, wraparc calibrate ` +
        `${name}; here the question A measured drive takes it for the drive that is open.`,
    );
  },
};
/** @param {string} name */
const stem = (name) => name.replace(/\.[^.]*$/, "");
