// Opening a file: drives alone. What else wraparc reads is named, with the command that does.
import { isDrive, redraw } from "../static/base/design.js";
import { open } from "../static/base/drafts.js";
import { Advice, ask, note } from "../static/base/server.js";

const MOST = 2e6;
/** Kinds of TOML files by a key that only they have. @type {[string, string, string][]} */
const KINDS = [
  ["axis", "a study", "study"],
  ["candidates", "a choice of laggings", "choose"],
  ["rig", "a plan of shear tests", "fit"],
  ["test", "a plan of shear tests", "fit"],
  ["record", "a record of a measured drive", "calibrate"],
  ["number", "a record of a measured drive", "calibrate"],
];

/** @param {File} file */
export async function openFile(file) {
  const { name } = file;
  if (file.size > MOST) throw new Advice(`${name} is larger than 2 MB: no drive file.`);
  const text = await file.text();
  if (!text.trim()) throw new Advice(`${name} is empty.`);
  const { document } = await ask("toml/read", { toml: text, name });
  if (!isDrive(document)) throw new Advice(`${name} ${whatIs(document)}`);
  const source = { toml: text, document };
  open(document, { name: name.replace(/\.[^.]*$/, ""), source });
  note(`Opened ${name}.`);
  redraw();
}
/** @param {any} doc */
function whatIs(doc) {
  const [, what, command] = KINDS.find(([key]) => key in doc) ?? [];
  if (what) return `is ${what}: the command line runs it, wraparc ${command}.`;
  if (doc.law || doc.condition)
    return (
      "is a lagging: name it in a drive file and make this page anew with it, " +
      "wraparc page FILE."
    );
  return (
    "is no drive file: it has no belt and no pulley. A drive file has a [belt] table and a " +
    "[[pulley]] table; File, Download shows one."
  );
}
