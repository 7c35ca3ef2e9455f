// The frame of the first screen for the other views of a drive: inputs, what is said and drawn,
// checks; the rest of the answer below, folded away.
import { app, redraw, wrong } from "../base/design.js";
import { GONE, sentence } from "../base/server.js";
import { words } from "../base/units.js";
import { checkOf, fold, foot, missing, reasonOf, said, worstFirst } from "../pages/drive/screen.js";
import { answer } from "../pages/drive/solving.js";
import { cloneElement, h } from "../vendor/preact.js";
import { BELOW, lined, linesOf, list } from "./answers.js";
import { idOf } from "./field.js";
import { mark } from "./problems.js";

/** @import { Bar, Children, Problem, Verdict } from "../types.d.ts" */
/** @import { Checked } from "../pages/drive/screen.js" */
/** @import { Standing } from "./answers.js" */

/**
 * The three regions, and what is below; `hero` where drawing and curve are one component. A tall
 * frame has more room under the drawing; `how` where there is an answer.
 * @typedef {{of: string, form: Children, say: Children, drawing?: Children, curve?: Children,
 *   hero?: Children, side: Children, how?: Standing, tall?: boolean}} Frame
 * @param {Frame} frame @param {...Children} below
 */
export const framed = ({ of, form, say, drawing, curve, hero, side, how, tall }, ...below) =>
  h(
    "div",
    { class: "screen other", "data-stands": how },
    h(
      "div",
      { class: "frame" },
      form,
      h(
        "section",
        { class: `hero card ${tall ? "tall" : ""}`, "aria-label": "Answer" },
        cloneElement(/** @type {any} */ (say), { id: `${of}-verdict` }),
        hero ?? [
          h("div", { class: "stage-box", key: "drawing" }, drawing),
          h("div", { class: "curve", key: "curve" }, curve),
        ],
      ),
      h("aside", { class: "checks card", "aria-label": "Checks against their limits" }, side),
    ),
    foot(answer.foreign ? null : answer.quick),
    fold(`${of}-details`, undefined, h("div", { class: "details" }, ...below)),
  );

/** What a page keeps of a drive, begun anew where another was opened; whether it was.
 * @param {{opened: number}} state @param {object} fresh */
export function renewed(state, fresh) {
  const { opened } = app;
  const other = state.opened !== opened;
  if (other) Object.assign(state, fresh, { opened });
  return other;
}
/** Nothing is answered yet. @param {string} text @param {Children} [more]
 * @param {Children} [action] */
export const silent = (text, more, action) => said("", text, more ?? "", action, null, null);
/** A verdict with its lines; of a design before it only what becomes of it.
 * @param {Standing} how @param {Verdict} v @param {Children} [more] a line before its own
 * @param {Children} [action] @param {Refused} [refused] */
export function saying(how, v, more, action, refused = []) {
  if (how === "refused") return notComputed("Not computed.", refused);
  if (how !== "fresh") return silent(app.gone ? GONE : "Solving …", BELOW, action);
  const lines = [more, lined(linesOf(v))];
  return said(v.level, words(v.text), lines, action, null, null, v.label);
}
/** @param {string} key of a field: whether it is in view */
const inView = (key) =>
  [...document.querySelectorAll(`[id$="${idOf(key.split(","), "")}"]`)].some((e) =>
    e.checkVisibility(),
  );
/** What is refused: fields in view have their reasons under them, and are only named here.
 * @typedef {Problem[] | string} Refused
 * @param {Problem[]} problems @returns {Refused} */
export function marked(problems) {
  const rest = mark(problems);
  if (rest.length) return rest;
  return [...wrong.at.keys()].every(inView) ? missing() : problems;
}
/** What is wrong with what is asked. @param {string} head @param {Refused} refused
 * @param {Children} [action] */
export const notComputed = (head, refused, action) =>
  typeof refused === "string"
    ? silent(refused, "", action)
    : said(
        "",
        "",
        "",
        null,
        [h("p", {}, head, " ", action), list(refused.map(sentence), "reasons")],
        null,
      );

const chosen = { check: "" };
/** Checks, each once at the place that uses most of its limit.
 * @param {string} page @param {Checked[] | undefined} found none where nothing is judged */
export function checked(page, found) {
  if (!found)
    return [
      h("h2", { key: "head" }, "Checks", h("span", {}, "not run")),
      h("p", { class: "why", key: "none" }, "No result yet."),
    ];
  const titles = new Set();
  const bars = /** @type {Checked[]} */ (worstFirst(found)).filter(
    (b) => !titles.has(b.title) && titles.add(b.title),
  );
  const one = bars.find((b) => b.title === chosen.check) ?? bars[0];
  const worst = bars.some((b) => b.pulley) ? " · worst drive" : "";
  const put = (/** @type {Bar} */ b) => () => {
    chosen.check = b.title;
    redraw();
  };
  return [
    h("h2", { key: "head" }, "Checks", bars.length > 0 && h("span", {}, "bar: % of limit", worst)),
    h(
      "ul",
      { class: "list", key: "list" },
      bars.map((b) => checkOf(b, b === one, put(b), `why-${page}`)),
    ),
    one && reasonOf(one, undefined, `why-${page}`),
  ];
}
/** Names and values, in a part of its own.
 * @param {string} title @param {[string, string][]} rows */
export const facts = (title, rows) =>
  rows.length > 0 &&
  h(
    "div",
    { class: "facts", key: title },
    h("h2", {}, title),
    h(
      "dl",
      { class: "kv" },
      rows.map(([name, value]) =>
        h("div", { key: name }, h("dt", {}, name), h("dd", {}, h("b", {}, value))),
      ),
    ),
  );
