// Across the width: an uneven pulley, what it does to the belt, and what comes of it.
import { app, gripped, redraw } from "../base/design.js";
import { aborted, ask, later, onReturn, refusal } from "../base/server.js";
import { words } from "../base/units.js";
import { list, standing } from "../parts/answers.js";
import { oneOf } from "../parts/choose.js";
import { checked, framed, marked, renewed, saying, silent } from "../parts/framed.js";
import { mark } from "../parts/problems.js";
import { judgedIf, stands, table, verdict } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { Face } from "./across/face.js";
import { acrossInputs, drawGiven, kindDrawn } from "./across/inputs.js";
import { OverWidth, readingOf } from "./across/over_width.js";
import { questions } from "./across/questions.js";
import { faceOf, QUANTITIES, stripWords, worst } from "./across/width.js";
import { askedCase } from "./drive/cases.js";
import { picks as casePicks } from "./drive/screen.js";
import { answer, known } from "./drive/solving.js";

/** @import { Refused } from "../parts/framed.js" */
/** @import { Design, Table } from "../types.d.ts" */

const state = {
  answer: /** @type {any} */ (null),
  of: /** @type {Design | null} */ (null),
  where: "",
  opened: -1,
  /** What the answer is of. */
  now: /** @type {unknown[]} */ ([]),
  problems: /** @type {Refused} */ ([]),
  quantity: "tension",
  /** The strip that is pointed at; none for the worst. @type {number | null} */
  strip: null,
  waiting: false,
};
export function update() {
  if (renewed(state, { answer: null, problems: [] })) drawGiven(app.pulley);
  const where = `${app.pulley} ${app.case}`;
  if ((state.of === app.doc && state.where === where) || gripped()) return;
  Object.assign(state, { of: app.doc, where, waiting: true });
  solve(app.doc, where);
}
onReturn(() => {
  state.of = null;
});
/** @type {AbortController | null} */
let stop = null;
const solve = later(250, async (/** @type {Design} */ doc, /** @type {string} */ where) => {
  stop?.abort();
  stop = new AbortController();
  const asked = {
    document: doc,
    pulley: doc.pulley[app.pulley]?.name || null,
    load_case: askedCase(),
  };
  try {
    const answer = await ask("across", asked, { signal: stop.signal });
    if (doc !== app.doc || where !== state.where) return;
    Object.assign(state, { answer, now: [doc, where], problems: [], waiting: false });
    mark([]);
  } catch (x) {
    if (aborted(x) || app.gone || doc !== app.doc) return;
    Object.assign(state, { problems: marked(refusal(x)), waiting: false });
  }
  redraw();
});

const now = () =>
  standing(state.now[0] === app.doc && state.now[1] === state.where, state.problems);
/** How the verdict on the whole drive stands. */
const told = () => (now() === "fresh" ? standing(Boolean(known()), answer.problems) : now());

export const picks = () => casePicks("-across");
export const Page = () => {
  const a = state.answer;
  return framed(
    {
      of: "across",
      how: now(),
      form: acrossInputs(),
      say:
        a?.even && now() === "fresh"
          ? silent("Draw the wear, or load readings.")
          : saying(told(), /** @type {any} */ (known()?.verdict), undefined, null, state.problems),
      drawing: drawing(a),
      curve: a?.map && curve(a),
      side: a && checked("across", a.bars),
    },
    a && stands(now(), result(a), questions(), tables(a)),
  );
};
/** What an answer says; where that of the whole drive says the same, with what was tried for it.
 * @param {any} a */
function saidOf(a) {
  const whole = told() === "fresh" ? known()?.verdict : null;
  const same = JSON.stringify(whole?.text) === JSON.stringify(a.verdict.text);
  return whole && same ? { ...whole, sentences: a.verdict.sentences } : a.verdict;
}
/** @param {any} a */
function result(a) {
  return h(
    "div",
    { key: "result", id: "across-result", "data-settled": String(!state.waiting) },
    verdict(judgedIf(now(), saidOf(a))),
    !a.solved && h("p", { class: "verdict bad", key: "failed" }, words(a.status_text)),
    list(a.remarks, "help"),
  );
}
/** @param {number | null} strip */
function point(strip) {
  if (state.strip === strip) return;
  state.strip = strip;
  redraw();
}
/** @param {any} a */
const stripOf = (a) =>
  state.strip != null && state.strip < a.map.position.length
    ? state.strip
    : worst(a, state.quantity);
/** @param {any} a */
function drawing(a) {
  const kind = kindDrawn();
  const { quantity } = state;
  const strip = a?.map ? stripOf(a) : 0;
  const words = a?.map && stripWords(a, strip, faceOf(quantity));
  const name = QUANTITIES.find(([key]) => key === faceOf(quantity))?.[1].toLowerCase();
  return [
    h(
      "p",
      { class: "face-head", key: "head" },
      words
        ? [h("b", {}, `Strip ${words.place}: ${name} ${words.value}`), h("span", {}, words.beside)]
        : h("b", {}, "Not solved."),
    ),
    h(Face, {
      ...{ pulley: app.pulley, kind, answer: a, quantity, strip, point },
      key: `${kind.key}${app.pulley}${app.opened}`,
    }),
  ];
}
/** @param {any} a */
function curve(a) {
  const { quantity } = state;
  const strip = stripOf(a);
  const [values, u] = readingOf(a, quantity, strip);
  const put = (/** @type {string} */ q) => {
    state.quantity = q;
    redraw();
  };
  return [
    h(
      "div",
      { class: "curve-head", key: "head" },
      oneOf("across-quantity", "Quantity over the width", quantity, QUANTITIES, put),
      h(
        "output",
        {},
        /** @type {[string, string][]} */ (values).map(([label, v], k) => [
          k ? ", " : "",
          `${label} `,
          h("b", {}, v),
        ]),
        ` ${u}`,
      ),
    ),
    h(OverWidth, { answer: a, quantity, strip, point, key: "over" }),
  ];
}
/** @param {any} a */
const tables = (a) =>
  h(
    "div",
    { class: "tables one", key: "tables" },
    a.checks && table({ ...a.checks, title: "Checks across the width" }),
    a.tables.map((/** @type {Table} */ t) => table(t, t.key !== "profile")),
  );
