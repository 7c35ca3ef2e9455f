// A measured drive: what the record of an instrumented pulley says of the friction.
import { app, caseNames, redraw, set } from "../../base/design.js";
import { noteUndo, putLagging } from "../../base/removed.js";
import { save } from "../../base/save.js";
import { choose } from "../../parts/choose.js";
import { Question } from "../../parts/question.js";
import { h } from "../../vendor/preact.js";

/** @typedef {{name: string, data: string}} Sent */
const PARAMETERS = /** @type {const} */ ({
  "": "nothing, only compare",
  friction: "friction",
  "friction,peak_slip": "friction and slip at its peak",
  "friction,shear_modulus": "friction and shear modulus",
});
const said = {
  files: /** @type {Sent[]} */ ([]),
  parameters: "friction",
  load_case: "",
};
const question = new Question("measured", "A measured drive", "measured", () => ({
  pulley: app.doc.pulley[app.pulley].name ?? null,
  load_case: caseNames(app.doc).includes(said.load_case) ? said.load_case : "",
  parameters: said.parameters.split(",").filter(Boolean),
  files: said.files,
}));
/** Nothing is asked before there are files. */
export function open() {
  question.shown = true;
  redraw();
}
/** @param {File} file @returns {Promise<Sent>} */
const sent = (file) =>
  new Promise((done, failed) => {
    const reader = new FileReader();
    reader.onload = () => done({ name: file.name, data: String(reader.result).split(",")[1] });
    reader.onerror = () => failed(new Error(`${file.name} cannot be read.`));
    reader.readAsDataURL(file);
  });
/** @param {any} e */
async function take(e) {
  said.files = await Promise.all([...e.currentTarget.files].map(sent));
  redraw();
}
/** Put the calibrated lagging into the drive. @param {any} lagging */
function use(lagging) {
  const { name, ...table } = lagging;
  putLagging(app.pulley, name, set(app.doc, ["lagging", name], table));
  noteUndo(`${name} is in the drive now. `);
}
/** @param {any} found */
function more({ picture, lagging, file }) {
  const image = {
    class: "overlay",
    src: `data:image/svg+xml;charset=utf-8,${encodeURIComponent(picture)}`,
    alt: "What was measured along the arc over the prediction of both methods; numbers above.",
  };
  return [
    picture && h("img", { ...image, key: "picture" }),
    picture &&
      h("p", { class: "help", key: "of" }, "Predicted for the drive as it was, not calibrated."),
    lagging &&
      h(
        "p",
        { class: "inline", key: "lagging" },
        h(
          "button",
          { type: "button", class: "main", onClick: () => use(lagging) },
          "Use the calibrated lagging",
        ),
        h(
          "button",
          { type: "button", onClick: () => save(`${lagging.name}.toml`, file) },
          "Download its file",
        ),
      ),
  ];
}
question.more = more;
export function panel() {
  const cases = caseNames(app.doc);
  const plan = said.files.some((f) => f.name.toLowerCase().endsWith(".toml"));
  const files = {
    type: "file",
    multiple: true,
    accept: ".csv,.txt,.tsv,.toml",
    onChange: (/** @type {Event} */ e) => take(e),
  };
  const pick = (/** @type {"parameters" | "load_case"} */ key, /** @type {any[]} */ choices) =>
    choose(said[key], choices, (v) => {
      said[key] = v;
      redraw();
    });
  return question.panel([
    h("label", { key: "files" }, "Records, or a calibrate file with them", h("input", files)),
    !plan && h("label", { key: "find" }, "Find", pick("parameters", Object.entries(PARAMETERS))),
    !plan &&
      cases.length > 1 &&
      h(
        "label",
        { key: "case" },
        "Load case",
        pick(
          "load_case",
          cases.map((c) => [c, c]),
        ),
      ),
  ]);
}
