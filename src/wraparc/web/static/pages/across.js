// Across the width: an uneven pulley, what it does to the belt, and what comes of it.
import { app, gripped, redraw } from "../base/design.js";
import { aborted, ask, later, onReturn, refusal } from "../base/server.js";
import { words } from "../base/units.js";
import { list, standing } from "../parts/answers.js";
import { choose } from "../parts/choose.js";
import { checked, framed, marked, renewed, saying, silent } from "../parts/framed.js";
import { mark } from "../parts/problems.js";
import { judgedIf, stands, table, verdict } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { acrossInputs, drawGiven, drawingOf } from "./across/inputs.js";
import { QUANTITIES, widthPicture } from "./across/pictures.js";
import { questions } from "./across/questions.js";
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
  quantity: "frictional_energy",
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
      tall: true,
      form: acrossInputs(),
      say:
        a?.even && now() === "fresh"
          ? silent("Draw the wear, or load readings.")
          : saying(told(), /** @type {any} */ (known()?.verdict), undefined, null, state.problems),
      drawing: drawingOf(app.pulley),
      curve: a?.map && picture(a),
      side: a && checked("across", a.bars),
    },
    a && stands(now(), result(a), questions(), tables(a)),
  );
};
/** @param {any} a */
function result(a) {
  return h(
    "div",
    { key: "result", id: "across-result", "data-settled": String(!state.waiting) },
    verdict(judgedIf(now(), a.verdict)),
    !a.solved && h("p", { class: "verdict bad", key: "failed" }, words(a.status_text)),
    list(a.remarks, "help"),
  );
}
/** @param {any} a */
const picture = (a) =>
  h(
    "section",
    { "aria-label": "Belt unrolled over wrap angle and width", key: "picture" },
    h(
      "div",
      { class: "bar" },
      h(
        "label",
        {},
        "Map of",
        choose(
          state.quantity,
          QUANTITIES,
          (q) => {
            state.quantity = q;
            redraw();
          },
          "across-quantity",
        ),
      ),
    ),
    widthPicture(a, state.quantity),
  );
/** @param {any} a */
const tables = (a) =>
  h(
    "div",
    { class: "tables one", key: "tables" },
    a.checks && table({ ...a.checks, title: "Checks across the width" }),
    a.tables.map((/** @type {Table} */ t) => table(t, t.key !== "profile")),
  );
