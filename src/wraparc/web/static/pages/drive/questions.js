// What can be asked beside the answer: each question fetched when it is asked first.
import { redraw } from "../../base/design.js";
import { act, part } from "../../base/server.js";
import { seeking } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";

/** @import { Children } from "../../types.d.ts" */
/** @typedef {{open: (at?: any) => any, panel: () => Children}} Question */

/** Questions that the server answers, by their buttons. @type {Record<string, any>} */
const QUESTIONS = {
  "Which input gives …?": () => import("./seek.js"),
  "What if … wet, worn, bare?": () => import("./what_if.js"),
  "Which design costs least?": () => import("./choosing.js"),
  "On site: what to measure, when to alarm": () => import("./site.js"),
  "A measured drive": () => import("./measured.js"),
};
/** @type {Question[]} */
const asked = [];
/** @param {string} name @param {any} [at] */
async function ask(name, at) {
  const found = /** @type {Question} */ (await part(QUESTIONS[name]));
  if (!asked.includes(found)) asked.push(found);
  await found.open(at);
  redraw();
}
const [SEEK] = Object.keys(QUESTIONS);
seeking.open = (path) => ask(SEEK, path);

/** The buttons, and what was asked. */
export const questions = () => [
  h(
    "p",
    { class: "inline", key: "questions" },
    Object.keys(QUESTIONS).map((name) =>
      h("button", { type: "button", key: name, onClick: act(() => ask(name)) }, name),
    ),
  ),
  ...asked.map((question) => question.panel()),
];
