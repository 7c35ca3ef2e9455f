// What can be asked beside the answer: each question fetched when it is asked first.
import { painted, redraw } from "../../base/design.js";
import { act, part } from "../../base/server.js";
import { seeking } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";

/** @import { Children } from "../../types.d.ts" */
/** @typedef {{open: (at?: any) => any, panel: () => Children}} Question */

/** Questions that the server answers, by their buttons. @type {Record<string, any>} */
const QUESTIONS = {
  "Which input gives …?": () => import("./seek.js"),
  "What if … wet, worn, bare?": () => import("./what_if.js"),
  "Which design has the lowest cost?": () => import("./choosing.js"),
  "On site: what to measure, when to alarm": () => import("./site.js"),
  "A measured drive": () => import("./measured.js"),
};
/** The one that is open. */
const one = { name: "", question: /** @type {Question | null} */ (null) };
/** @param {string} name @param {any} [at] */
async function ask(name, at) {
  const question = /** @type {Question} */ (await part(QUESTIONS[name]));
  Object.assign(one, { name, question });
  const found = question.open(at);
  redraw();
  await painted();
  document.getElementById("question")?.scrollIntoView({ block: "nearest" });
  await found;
  redraw();
}
const [SEEK] = Object.keys(QUESTIONS);
seeking.open = (path) => ask(SEEK, path);

/** The buttons, and what is asked: one at a time, shut by the press that opened it. */
export function questions() {
  const panel = one.question?.panel();
  const shut = () => {
    one.question = null;
    redraw();
  };
  const press = (/** @type {string} */ name) => {
    const open = Boolean(panel) && one.name === name;
    const onClick = open ? shut : act(() => ask(name));
    return h("button", { type: "button", key: name, "aria-expanded": open, onClick }, name);
  };
  return [
    h("p", { class: "inline", key: "questions" }, Object.keys(QUESTIONS).map(press)),
    panel && h("div", { id: "question", key: "question" }, panel),
  ];
}
