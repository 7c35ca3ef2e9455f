// The frame of the first screen for the other views of a drive: inputs, what is said and drawn,
// checks; the rest of the answer below.
import { app, redraw } from "../base/design.js";
import { words } from "../base/units.js";
import { checkOf, opening, reasonOf, said, worstFirst } from "../pages/drive/screen.js";
import { answer, known } from "../pages/drive/solving.js";
import { h } from "../vendor/preact.js";
import { standing } from "./answers.js";

/** @import { Bar, Children, FullArc, Verdict } from "../types.d.ts" */
/** @import { Standing } from "./answers.js" */

/**
 * The three regions, and what is below. A tall frame has more room under the drawing.
 * @typedef {{form: Children, say: Children, drawing: Children, curve: Children, side: Children,
 *   how: Standing, tall?: boolean}} Frame
 * @param {Frame} of @param {...Children} below
 */
export const framed = ({ form, say, drawing, curve, side, how, tall }, ...below) =>
  h(
    "div",
    {
      class: "screen other",
      "data-stands": how === "fresh" ? standing(Boolean(known()), answer.problems) : how,
    },
    h(
      "div",
      { class: "frame" },
      form,
      h(
        "section",
        { class: `hero card ${tall ? "tall" : ""}`, "aria-label": "Answer" },
        say,
        h("div", { class: "stage-box", key: "drawing" }, drawing),
        h("div", { class: "curve", key: "curve" }, curve),
      ),
      h("aside", { class: "checks card", "aria-label": "Checks against their limits" }, side),
    ),
    h("div", { class: "results", key: "below" }, ...below),
  );

/** The first sentence of a verdict, judged only where it is of what is asked now.
 * @param {Standing} how @param {Verdict} v @param {Children} [more] @param {Children} [action] */
export function saying(how, v, more, action) {
  const place = { pulley: app.doc.pulley[app.pulley].name ?? "", load_case: app.case };
  const [one, rest] = opening(words(v.headline).replace(/^Event [^:]+: /, ""), place);
  return said(how === "fresh" ? v.level : "", one, more ?? rest, action, "", null, null);
}
/** Nothing is answered yet. @param {string} text @param {Children} [action] */
export const silent = (text, action) => said("", text, "", action, "", null, null);

const chosen = { check: "" };
/** Checks of all pulleys that are shown, each at the one that uses most of its limit.
 * @param {string} page @param {(a: FullArc) => boolean} which */
export function checked(page, which) {
  const arcs = ((known() ?? answer.full)?.arcs ?? []).filter(which);
  const several = arcs.length > 1;
  const all = /** @type {(Bar & {of: FullArc})[]} */ (
    worstFirst(
      arcs.flatMap((a) =>
        a.bars.map((b) => ({ ...b, of: a, title: several ? `${b.title}, ${a.pulley}` : b.title })),
      ),
    )
  );
  const titles = new Set();
  const bars = all.filter((b) => {
    const title = b.title.replace(`, ${b.of.pulley}`, "");
    return !titles.has(title) && titles.add(title);
  });
  const one = bars.find((b) => b.title === chosen.check) ?? bars[0];
  const missed = bars.filter((b) => b.level !== "OK").length;
  const kept = missed ? `${missed} of ${bars.length} not kept` : `all ${bars.length} kept`;
  const put = (/** @type {Bar} */ b) => () => {
    chosen.check = b.title;
    redraw();
  };
  return [
    h("h2", { key: "head" }, "Checks", bars.length > 0 && h("span", {}, kept)),
    h(
      "ul",
      { class: "list", key: "list" },
      bars.map((b) => checkOf(b, b === one, put(b), `why-${page}`)),
    ),
    one && reasonOf(one, one.of, `why-${page}`),
  ];
}
/** Names and values, in a part of its own.
 * @param {string} title @param {[string, string][]} rows */
export const facts = (title, rows) =>
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
